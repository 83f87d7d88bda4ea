// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

/// Gives a view the whole screen but for the bar on top, whose red button stays in reach, and puts it back.
class FullView final : public QObject
{
    Q_OBJECT
public:
    /// @param view lies in a box layout, where it comes back to
    explicit FullView(QWidget &view);
    ~FullView() override;

    [[nodiscard]] bool isOn() const { return m_cover != nullptr; }
    void setOn(bool on);

signals:
    void changed(bool on);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void enter();
    void leave();

    QWidget &m_view;
    QPointer<QWidget> m_place;  // where it comes from
    int m_index = -1;
    QPointer<QWidget> m_area;
    QPointer<QWidget> m_cover;
    Qt::WindowStates m_before;
};
