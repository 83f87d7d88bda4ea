// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class PanelArea;
class QStackedWidget;
class QWidget;

/// Sees to it that keys do what the operator expects. What had the keyboard and is hidden or disabled hands
/// it on to the page or panel it belongs to, never to a button that acts (mayTakeKeyboard()); Enter presses
/// the button that has it.
class FocusGuard final : public QObject
{
    Q_OBJECT
public:
    /// @param pages the page that is shown is its current widget
    FocusGuard(QWidget &window, QStackedWidget &pages, PanelArea &panels);
    ~FocusGuard() override;

    /// Leads into the page that is shown, unless a panel lies over it.
    void enterPage(Qt::FocusReason reason = Qt::OtherFocusReason);
    /// Leads into that page if nothing has the keyboard, or something in this part of the window.
    void leave(const QWidget &part);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow(QWidget *before, QWidget *now);
    /// @param inside where the keyboard was: only there it may be now
    void settle(bool inside);
    /// The newest panel, else the page.
    [[nodiscard]] QWidget *place() const;

    QWidget &m_window;
    QStackedWidget &m_pages;
    PanelArea &m_panels;
    QPointer<QObject> m_button;  // that has the keyboard; a QObject, as it may be half destroyed
    bool m_isLost = false;  // nobody has given the keyboard to anything since
};
