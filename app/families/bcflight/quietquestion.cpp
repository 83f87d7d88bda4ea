// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/quietquestion.h"

#include "protocol/client/whendone.h"

QuietQuestion::QuietQuestion(Workspace &workspace, const QString &action, Told told, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_action(action)
    , m_told(std::move(told))
{
    connect(&workspace.live(), &LiveModel::heldChanged, this, &QuietQuestion::askIfDue);
    connect(&workspace.client(), &DeviceClient::statisticsChanged, this, &QuietQuestion::askIfDue);
}

void QuietQuestion::ask()
{
    m_isDue = true;
    askIfDue();
}

void QuietQuestion::askIfDue()
{
    if (m_workspace.isFlown() || m_workspace.live().isHeld() || !m_workspace.client().isConnected()
        || !std::exchange(m_isDue, false))
        return;
    whenDone(m_workspace.perform(m_action, {}, true), this,
             [this](const Result<ActionOutcome> &outcome) { m_told(outcome); });
}
