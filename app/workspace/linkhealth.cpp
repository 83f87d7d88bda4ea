// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/linkhealth.h"

#include "protocol/client/deviceclient.h"
#include "protocol/session/linkstatistics.h"

LinkHealth::LinkHealth(DeviceClient &client, Notifications &notifications)
    : m_client(client)
    , m_notifications(notifications)
{
    connect(&m_client, &DeviceClient::statisticsChanged, this, &LinkHealth::look);
    connect(&m_client, &DeviceClient::stateChanged, this, &LinkHealth::look);
}

void LinkHealth::look()
{
    const auto &quality = m_client.statistics().quality;
    const bool isShared = m_client.isConnected() && quality && quality->isShared;
    if (isShared == m_isShared)
        return;
    m_isShared = isShared;
    if (!isShared) {
        m_notifications.settle(Concern::OtherStation);
        return;
    }
    m_notifications.report(
        {tr("Another ground station talks to the same board."),
         tr("The board answers whoever sent last, so answers and live data are missing here, and both can "
            "command "
            "it."),
         tr("End the other program, or this link. Do not arm, write or calibrate meanwhile."),
         tr("answers to questions of somebody else: %1").arg(quality->foreign)},
        Concern::OtherStation);
}
