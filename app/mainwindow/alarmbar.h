// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QFrame>

#include <functional>

class Alarms;
class QLabel;
class QPushButton;
struct AlarmReport;

/// What cannot wait: over the whole width of the window's upper edge, above pages and panels. Pages make room
/// for it where there is height to spare and as soon as the pointer is neither on them nor on the bar, so
/// that nothing moves beneath it, nor beneath a bar that goes. Stays until the cause is gone, or until it is
/// acknowledged. Never takes the focus by itself.
class AlarmBar final : public QFrame
{
    Q_OBJECT
public:
    /// @param area its layout makes room for the bar at its upper edge
    /// @param smallest the height that is left to it at least
    /// @param belowHead where in the area the bar lies while there is no room: beside the navigation, beneath
    /// what disarms or stops on the page that is shown
    AlarmBar(Alarms &alarms, QWidget *area, int smallest, std::function<QPoint()> belowHead);

    /// Text of the alarm that is shown; empty without one.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QPushButton *remedyButton() const { return m_remedy; }
    [[nodiscard]] QPushButton *acknowledgeButton() const { return m_acknowledge; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void refresh();
    void place();
    void makeRoom();
    [[nodiscard]] int heightFor(int width) const;
    void shield(const QRect &place);
    /// A click that was meant for what lay there before must not do anything.
    [[nodiscard]] bool isTooSoon() const;

    Alarms &m_alarms;
    QWidget *m_area;
    int m_smallest;
    std::function<QPoint()> m_belowHead;
    QLabel *m_icon;
    QLabel *m_text;
    QLabel *m_more;
    QPushButton *m_remedy;
    QPushButton *m_acknowledge;
    int m_number = 0;
    QElapsedTimer m_shownAt;
};
