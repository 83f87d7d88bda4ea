// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"
#include "protocol/base/axis.h"
#include "protocol/client/deviceclient.h"

#include <QTimer>

#include <array>

/// A board that is steered by rate goes on turning when whoever steered it is gone: a program that crashed, a
/// cable that was pulled. When a link begins, and the target turns steadily although nobody steers here, the
/// operator is asked whether to end that. A remote control may be the reason, so nothing is ended unasked.
class LeftSteering final : public QObject
{
    Q_OBJECT
public:
    LeftSteering(DeviceClient &client, Notifications &notifications);

private:
    void onState();
    void look();
    /// How fast the target has turned since the last look, in deg/s.
    [[nodiscard]] double rateOf(std::size_t axis, double target, TimePoint at);
    void ask(Axis axis, double rate);
    void end();

    DeviceClient &m_client;
    Notifications &m_notifications;
    QTimer m_timer;
    int m_looks = 0;  // left on this link
    std::array<double, kAxisCount> m_before{};
    std::array<TimePoint, kAxisCount> m_at{};  // of that sample
    std::array<double, kAxisCount> m_rate{};  // at the last look
    std::array<int, kAxisCount> m_steady{};  // looks in a row at the same rate
};
