// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"

#include <QObject>

class DeviceClient;

/// Tells when another program takes the board's answers: it sends them to whoever asked last.
class LinkHealth final : public QObject
{
    Q_OBJECT
public:
    LinkHealth(DeviceClient &client, Notifications &notifications);

private:
    void look();

    DeviceClient &m_client;
    Notifications &m_notifications;
    bool m_isShared = false;
};
