// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/telemetry/streams.h"

#include <QHash>

#include <functional>

/// What the board is asked to send: the channels of all pages together, in streams arranged for them or
/// chosen by hand.
class TelemetrySubscriptions final : public QObject
{
    Q_OBJECT
public:
    explicit TelemetrySubscriptions(DeviceClient &client);

    using Wanted = std::function<QList<int>()>;
    /// Fast channels that a page wants to see, in place of its earlier ones. Asked again for each board that
    /// connects, because channels are numbered by the board.
    void subscribe(const QObject *page, const Wanted &channels);
    /// Streams that the operator chose by hand; none: they are arranged for what the pages want to see.
    void setStreams(const QList<StreamChoice> &streams);
    [[nodiscard]] const QList<StreamChoice> &streams() const { return m_streams; }
    /// What the connected board would be asked for with these streams.
    [[nodiscard]] Subscription with(const QList<StreamChoice> &streams) const;

private:
    void onState(DeviceClient::State state);
    void update();

    DeviceClient &m_client;
    QHash<const QObject *, Wanted> m_wanted;
    QList<StreamChoice> m_streams;
};
