// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/videotypes.h"

#include <QWidget>

#include <memory>

/// Shows the pictures of a camera as they come, in their shape, on black. What does not change with them, and
/// how old they are, is the business of who feeds it.
class VideoView final : public QWidget
{
    Q_OBJECT
public:
    explicit VideoView(QWidget *parent = nullptr);

    /// Null: there is none, and the note says why.
    void setPicture(const std::shared_ptr<const VideoPicture> &picture);
    [[nodiscard]] const std::shared_ptr<const VideoPicture> &picture() const { return m_picture; }
    /// What is said in place of a picture.
    void setNote(const QString &note);
    [[nodiscard]] const QString &note() const { return m_note; }
    /// Pixels of the screen that a picture can fill.
    [[nodiscard]] QSize pixels() const;
    [[nodiscard]] QSize sizeHint() const override { return {960, 540}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 135}; }

signals:
    /// A picture is on the screen for the first time.
    void painted(const std::shared_ptr<const VideoPicture> &picture);
    void pixelsChanged(const QSize &pixels);
    /// Double click.
    void activated();
    void escaped();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    [[nodiscard]] QRectF place() const;

    std::shared_ptr<const VideoPicture> m_picture;
    bool m_isNew = false;
    QString m_note;
};
