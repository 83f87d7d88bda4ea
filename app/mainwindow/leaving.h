// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QPointer>

#include <functional>

class QDialog;

/// What has to be settled before a link or the program ends: a write is waited for, a procedure is waited for
/// or cancelled, unsaved edits and values in use that are not stored are asked about, steering is
/// ended, motors that shall be off are proven to be, and others that run are asked about. One after the
/// other, each with a way to stay.
class Leaving final : public QObject
{
    Q_OBJECT
public:
    enum class Way { Quit, Disconnect };

    /// @param window holds the questions
    Leaving(Workspace &workspace, QWidget &window);

    /// True if nothing is in the way. Otherwise `go` is called once all is settled, and never if the operator
    /// stays; asked again meanwhile, it begins anew.
    [[nodiscard]] bool mayGo(Way way, const std::function<void()> &go);

private:
    enum class Wait { Nothing, Write, Work, Steering, MotorsOff };
    /// Waits, asks, or returns true.
    bool isClear();
    [[nodiscard]] bool isAtWork() const;
    void next();
    void later();
    void waitFor(Wait what, const QString &told);
    void stopWaiting();
    void ended(Wait what);
    void onceRead();
    /// True, and told or asked, while something that flies is armed.
    bool refusesToLeaveArmed();
    void tellStillFlying();
    void askAboutArmed();
    void askAboutWork();
    void askAboutEdits();
    void askAboutValues();
    void stopMotors();
    void askAboutRunning();
    void askAboutSteering();
    void askAboutMotors();
    [[nodiscard]] bool quits() const { return m_way == Way::Quit; }

    Workspace &m_workspace;
    QWidget &m_window;
    Way m_way = Way::Quit;
    std::function<void()> m_go;
    Wait m_wait = Wait::Nothing;
    bool m_editsAreSettled = false;
    bool m_valuesAreSettled = false;
    bool m_motorsAreSettled = false;
    bool m_steeringIsSettled = false;
    bool m_armedIsSettled = false;
    QPointer<QDialog> m_motorsQuestion;  // what to do without proof
};
