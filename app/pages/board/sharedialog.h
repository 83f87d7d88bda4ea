// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QDialog>
#include <QImage>

class QCheckBox;
class QLabel;

/// All values as one picture, to copy or to save.
class ShareDialog final : public QDialog
{
    Q_OBJECT
public:
    explicit ShareDialog(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] const QImage &image() const { return m_image; }
    /// Errors: BadFile.
    Result<void> save(const QString &path) const;

private:
    void draw();

    QImage m_image;
    Workspace &m_workspace;
    QCheckBox *m_edits;
    QLabel *m_picture;
};
