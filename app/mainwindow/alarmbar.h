// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <functional>
#include <optional>

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
    /// Where in the area the bar lies while there is no room: beside the navigation, where it hides neither
    /// what disarms or stops on the page that is shown nor its headings.
    using FreePlace = std::function<QPoint(const std::function<int(int width)> &heightFor)>;
    /// @param area its layout makes room for the bar at its upper edge
    /// @param smallest the height that is left to it at least
    AlarmBar(Alarms &alarms, QWidget *area, int smallest, FreePlace freePlace);

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

    Alarms &m_alarms;
    QWidget *m_area;
    int m_smallest;
    FreePlace m_freePlace;
    std::optional<QPoint> m_start;  // while it lies there
    QLabel *m_icon;
    QLabel *m_text;
    QLabel *m_more;
    QPushButton *m_remedy;
    QPushButton *m_acknowledge;
    int m_number = 0;
};
