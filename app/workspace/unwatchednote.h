// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

#include <QLabel>
#include <QSet>

class DeviceClient;

/// Says what the supervisor cannot watch for on this board; hidden where there is nothing of the kind.
class UnwatchedNote final : public QLabel
{
    Q_OBJECT
public:
    /// @param kinds those that matter here
    UnwatchedNote(const DeviceClient &client, const QSet<AlarmKind> &kinds, QWidget *parent = nullptr);

private:
    void update();

    const DeviceClient &m_client;
    QSet<AlarmKind> m_kinds;
};
