// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/telemetrysubscriptions.h"

#include "protocol/device/abilities.h"

#include <QSet>

#include <algorithm>

TelemetrySubscriptions::TelemetrySubscriptions(DeviceClient &client)
    : m_client(client)
{
    connect(&m_client, &DeviceClient::stateChanged, this, &TelemetrySubscriptions::onState);
}

void TelemetrySubscriptions::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected)
        return;
    if (!m_client.device()->streamControl())
        m_streams.clear();
    update();
}

void TelemetrySubscriptions::subscribe(const QObject *page, const Wanted &channels)
{
    if (!m_wanted.contains(page))
        connect(page, &QObject::destroyed, this, [this, page] { m_wanted.remove(page); });
    m_wanted.insert(page, channels);
    update();
}

void TelemetrySubscriptions::setStreams(const QList<StreamChoice> &streams)
{
    m_streams = streams;
    update();
}

void TelemetrySubscriptions::update()
{
    if (m_client.device())
        m_client.subscribe(with(m_streams));
}

Subscription TelemetrySubscriptions::with(const QList<StreamChoice> &streams) const
{
    const StreamControl *control = m_client.device()->streamControl();
    const QList<int> fast = control ? control->fastChannels() : QList<int>();
    QSet<int> wanted;
    for (const Wanted &channels : std::as_const(m_wanted)) {
        for (const int channel : channels()) {
            if (fast.contains(channel))
                wanted.insert(channel);
        }
    }
    Subscription subscription;
    subscription.channels = QList<int>(wanted.begin(), wanted.end());
    std::sort(subscription.channels.begin(), subscription.channels.end());
    subscription.streams = streams;
    // A stream of chosen channels carries what the pages want to see; without any it is not needed.
    const QList<StreamSpec> offered = control ? control->streams() : QList<StreamSpec>();
    for (const StreamSpec &spec : offered) {
        for (StreamChoice &stream : subscription.streams) {
            if (stream.key == spec.key && spec.choosesChannels)
                stream.channels = subscription.channels;
        }
        if (spec.choosesChannels && subscription.channels.isEmpty())
            subscription.streams.removeIf([&](const StreamChoice &stream) { return stream.key == spec.key; });
    }
    return subscription;
}
