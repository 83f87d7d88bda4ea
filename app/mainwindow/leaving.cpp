// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/leaving.h"

#include "app/workspace/question.h"
#include "protocol/client/whendone.h"
#include "protocol/device/flight.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QDialog>

#include <utility>

Leaving::Leaving(Workspace &workspace, QWidget &window)
    : QObject(&window)
    , m_workspace(workspace)
    , m_window(window)
{
    connect(&workspace, &Workspace::writeFinished, this, [this] { ended(Wait::Write); });
    connect(&workspace, &Workspace::workEnded, this, [this] { ended(Wait::Work); });
    connect(&workspace.notches(), &NotchAdviser::changed, this, [this] {
        if (!isAtWork())
            ended(Wait::Work);
    });
    connect(&workspace.client(), &DeviceClient::steeringEnded, this, [this](bool confirmed) {
        if (m_wait != Wait::Steering)
            return;
        m_steeringIsSettled = true;
        stopWaiting();
        if (confirmed)
            later();
        else
            askAboutSteering();
    });
    connect(&workspace.client(), &DeviceClient::motorsOffFinished, this, [this](bool confirmed) {
        // Proven while it is asked what to do without proof.
        if (confirmed && m_motorsQuestion && m_motorsQuestion->isVisible()) {
            m_motorsAreSettled = true;
            m_motorsQuestion->reject();
            later();
            return;
        }
        if (m_wait != Wait::MotorsOff)
            return;
        m_motorsAreSettled = confirmed;
        if (confirmed) {
            ended(Wait::MotorsOff);
            return;
        }
        stopWaiting();
        askAboutMotors();
    });
}

bool Leaving::mayGo(Way way, const std::function<void()> &go)
{
    m_way = way;
    m_go = go;
    stopWaiting();
    m_editsAreSettled = false;
    m_valuesAreSettled = false;
    m_motorsAreSettled = false;
    m_steeringIsSettled = false;
    m_armedIsSettled = false;
    return isClear();
}

bool Leaving::isAtWork() const
{
    return m_workspace.isAtWork() || m_workspace.notches().isRunning();
}

bool Leaving::isClear()
{
    const DeviceClient &client = m_workspace.client();
    const bool isLinked = client.isConnected() && !client.address().isReplay();
    if (refusesToLeaveArmed())
        return false;
    if (isLinked && m_workspace.isWriting()) {
        waitFor(Wait::Write,
                quits() ? tr("A write is running: the program quits when it has ended.")
                        : tr("A write is running: the link ends when it has ended."));
        return false;
    }
    if (isLinked && isAtWork()) {
        askAboutWork();
        return false;
    }
    if (isLinked && !m_steeringIsSettled && client.isSteering()) {
        m_wait = Wait::Steering;
        m_workspace.releaseControl();
        return false;
    }
    if (isLinked && m_workspace.mayStillFly()) {
        tellStillFlying();
        return false;
    }
    if (quits() && !m_editsAreSettled && m_workspace.unsavedCount() > 0) {
        askAboutEdits();
        return false;
    }
    const bool isInUse = m_workspace.isUnstored() || m_workspace.live().changeCount() > 0;
    if (isLinked && isInUse && !m_valuesAreSettled && client.identity().writable) {
        askAboutValues();
        return false;
    }
    if (isLinked && quits() && !m_motorsAreSettled && m_workspace.settings().motorsOffOnQuit()
        && m_workspace.motorsRunning().value_or(true)) {
        stopMotors();
        return false;
    }
    const bool isRunning = m_workspace.motorsRunning().value_or(false) || m_workspace.isStarting();
    if (isLinked && !m_motorsAreSettled && isRunning && client.identity().writable
        && m_workspace.settings().askAboutMotors()) {
        askAboutRunning();
        return false;
    }
    return true;
}

// What flies goes on as it was told last, whatever becomes of this program.
bool Leaving::refusesToLeaveArmed()
{
    const DeviceClient &client = m_workspace.client();
    const bool flies = client.device() && client.device()->flight() && !client.address().isReplay();
    if (!flies || m_armedIsSettled)
        return false;
    if (client.isConnected() && m_workspace.isFlown()) {
        m_workspace.notifications().report(
            {tr("The drone is armed from here."),
             tr("It would go on with its last throttle, and nobody could stop it from here."),
             tr("Land it and disarm it first, on the page “Flight”."),
             {}},
            Concern::Steering);
        return true;
    }
    const auto store = client.telemetry();
    const int armed = client.roles().armed;
    if (client.state() != DeviceClient::State::Reconnecting || !store || armed < 0
        || store->latest(armed) != 1)
        return false;
    askAboutArmed();
    return true;
}

void Leaving::tellStillFlying()
{
    m_workspace.notifications().report(
        {tr("The drone does not say that it is disarmed and its motors stand."),
         tr("It was armed from here. Without this program nobody would go on stopping it."),
         tr("Stop the motors (F12). If it does not obey, take its battery away: then the link is lost, and "
            "the "
            "program can be closed."),
         {}},
        Concern::Steering);
}

void Leaving::askAboutArmed()
{
    const auto goOn = [this] {
        m_armedIsSettled = true;
        later();
    };
    askInPanel(
        {tr("The drone was armed when it was heard last"),
         tr("The link is lost. The drone does not notice that: it stays armed and goes on with its last "
            "throttle until somebody disarms it or its battery is empty. As long as this program runs "
            "it looks for the drone, and disarms it as soon as it is heard."),
         {{quits() ? tr("Quit all the same") : tr("Disconnect all the same"), goOn, true}},
         tr("Stay")},
        &m_window);
}

void Leaving::next()
{
    if (m_go && isClear())
        std::exchange(m_go, nullptr)();
}

void Leaving::waitFor(Wait what, const QString &told)
{
    m_wait = what;
    m_workspace.notifications().notify(told, Notice::Attention, Concern::Leaving);
}

// Whoever is asked next may stay: nothing is announced any more.
void Leaving::stopWaiting()
{
    m_wait = Wait::Nothing;
    m_workspace.notifications().settle(Concern::Leaving);
}

void Leaving::ended(Wait what)
{
    if (m_wait != what)
        return;
    stopWaiting();
    onceRead();
}

// After a write the board is read again: what it holds is known after that.
void Leaving::onceRead()
{
    whenDone(m_workspace.client().submit<void>([](Channel &, Device &) -> Result<void> { return {}; }), this,
             [this](const Result<void> &) { later(); });
}

// Whoever else waits for the same is told first, and a panel is gone before the next one opens.
void Leaving::later()
{
    QMetaObject::invokeMethod(this, &Leaving::next, Qt::QueuedConnection);
}

// Of what nobody can cancel, only waiting is offered; and nothing is asked any more once it is over.
void Leaving::askAboutWork()
{
    const auto wait = [this] {
        waitFor(Wait::Work,
                quits() ? tr("The program quits when the board has done its work.")
                        : tr("The link ends when the board has done its work."));
        if (!isAtWork())
            ended(Wait::Work);
    };
    const auto cancel = [this, wait] {
        wait();
        if (m_workspace.notches().isRunning()) {
            m_workspace.notches().stop();  // it takes its notch back
            return;
        }
        m_workspace.client().cancelMovingJobs();
        m_workspace.client().cancelJobs();
    };
    Question question{tr("The board is at work"),
                      tr("A calibration, a measurement or another procedure has not ended."),
                      {{quits() ? tr("Wait, then quit") : tr("Wait, then disconnect"), wait}},
                      tr("Stay")};
    if (const ActionSpec *action = m_workspace.unstoppable()) {
        question.title = tr("“%1” has not ended").arg(tableText(action->label));
        question.text = tableText(action->help) + u"\n\n"_s
            + tr("It cannot be cancelled from here, and goes on without this program: only taking its "
                 "battery "
                 "away ends it before.");
    } else {
        question.answers.append(
            {quits() ? tr("Cancel it and quit") : tr("Cancel it and disconnect"), cancel, true});
    }
    QDialog *panel = askInPanel(question, &m_window);
    connect(&m_workspace, &Workspace::workEnded, panel, &QDialog::reject);
    connect(&m_workspace.notches(), &NotchAdviser::changed, panel, [this, panel] {
        if (!isAtWork())
            panel->reject();
    });
}

void Leaving::askAboutEdits()
{
    const auto goOn = [this] {
        m_editsAreSettled = true;
        later();
    };
    const auto discard = [this, goOn] {
        m_workspace.discardUnsaved();
        goOn();
    };
    askInPanel({tr("Unwritten changes"),
                tr("%n change(s) are not on the board.", nullptr, m_workspace.unsavedCount()),
                {{tr("Quit and keep for next time"), goOn}, {tr("Discard and quit"), discard, true}},
                tr("Stay")},
               &m_window);
}

void Leaving::askAboutValues()
{
    const auto goOn = [this] {
        m_valuesAreSettled = true;
        later();
    };
    const auto store = [this] {
        whenDone(m_workspace.saveLive(m_window), this, [this](bool stored) {
            m_valuesAreSettled = stored;
            if (stored)
                onceRead();
        });
    };
    askInPanel({tr("Not stored"),
                tr("The board uses values that it has not stored. They are lost when it is switched off."),
                {{quits() ? tr("Store and quit") : tr("Store and disconnect"), store},
                 {quits() ? tr("Quit without storing") : tr("Disconnect without storing"), goOn, true}},
                tr("Stay")},
               &m_window);
}

void Leaving::stopMotors()
{
    waitFor(Wait::MotorsOff,
            quits() ? tr("The motors are switched off, then the program quits.")
                    : tr("The motors are switched off, then the link ends."));
    m_workspace.client().motorsOff();
}

void Leaving::askAboutRunning()
{
    const auto goOn = [this] {
        m_motorsAreSettled = true;
        later();
    };
    askInPanel(
        {tr("The motors are running"),
         tr("Without this program they go on running, and nothing watches them or can stop them from "
            "here."),
         {{quits() ? tr("Stop motors and quit") : tr("Stop motors and disconnect"), [this] { stopMotors(); }},
          {quits() ? tr("Quit and leave them running") : tr("Disconnect and leave them running"), goOn,
           true}},
         tr("Stay")},
        &m_window);
}

void Leaving::askAboutSteering()
{
    const Notifications &told = m_workspace.notifications();
    askInPanel(
        {told.flies() ? tr("The drone may be armed") : tr("The camera may go on moving"),
         told.flies() ? tr("It did not confirm that it is disarmed, and may go on with its last throttle.")
                 + u' ' + told.keepAwayText()
                      : tr("The board did not confirm that it has stopped turning the camera."),
         {{quits() ? tr("Quit all the same") : tr("Disconnect all the same"), [this] { later(); }, true}},
         tr("Stay")},
        &m_window);
}

void Leaving::askAboutMotors()
{
    const auto goOn = [this] {
        m_motorsAreSettled = true;
        later();
    };
    m_motorsQuestion
        = askInPanel({tr("The motors may be running"),
                      tr("The board did not confirm that the motors are off."),
                      {{quits() ? tr("Quit all the same") : tr("Disconnect all the same"), goOn, true}},
                      tr("Stay")},
                     &m_window);
}
