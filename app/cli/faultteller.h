// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"

#include <QSet>
#include <QTimer>

/// Tells which faults the board reports that keep it from working, each when it comes.
class FaultTeller final : public QObject
{
    Q_OBJECT
public:
    explicit FaultTeller(const DeviceClient &client, QObject *parent = nullptr);

signals:
    void told(const QString &line);

private:
    void look();

    const DeviceClient &m_client;
    QTimer m_timer;
    QSet<QString> m_present;
};
