// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QTest>

#include <thread>

/// Time as the board's telemetry tells it: whoever waits until so much of it has come knows that what must
/// not happen had the time to, however slow the machine is.

/// When the newest sample of any channel came, in seconds of its store; 0 before the first.
inline double newestSample(const DeviceClient &client)
{
    const auto store = client.telemetry();
    double newest = 0.0;
    for (int channel = 0; store && channel < store->channelCount(); ++channel) {
        const auto tracks = store->tracks(channel);
        if (!tracks.empty() && tracks.back().end() > tracks.back().begin())
            newest = std::max(newest, tracks.back().time(tracks.back().end() - 1));
    }
    return newest;
}

/// Waits until so many more seconds of samples have come. False: they stay away.
inline bool boardGoesOn(const DeviceClient &client, double seconds)
{
    const double until = newestSample(client) + seconds;
    return QTest::qWaitFor([&] { return newestSample(client) >= until; }, int(seconds * 1000) + 15000);
}

/// The same while this thread, the screen's, hangs: no event is delivered.
inline bool boardGoesOnWhileBlocked(const DeviceClient &client, double seconds)
{
    const double until = newestSample(client) + seconds;
    const TimePoint deadline = Clock::now() + durationFromSeconds(seconds + 15.0);
    while (newestSample(client) < until && Clock::now() < deadline)
        std::this_thread::yield();
    return newestSample(client) >= until;
}
