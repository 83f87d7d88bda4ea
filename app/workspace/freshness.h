// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "widgets/views/stalecover.h"

#include <QTimer>

#include <functional>
#include <map>

/// Whether what is shown of the board is live. Data are stale after half a second or three periods without a
/// sample, whichever is longer; without a link as well, until another board is connected.
class Freshness final : public QObject
{
    Q_OBJECT
public:
    explicit Freshness(DeviceClient &client);

    /// When the newest sample of these channels came, or when the board was connected if none has come at all
    /// since; empty while they are live, and for recordings. @param channels none = all
    [[nodiscard]] std::optional<QDateTime> staleSince(const QList<int> &channels = {}) const;

    using Channels = std::function<QList<int>()>;
    /// Shows the cover while these channels are stale. Asked each time, because boards number them
    /// differently.
    void watch(StaleCover &cover, const Channels &channels = {});

private:
    void look();

    DeviceClient &m_client;
    std::map<StaleCover *, Channels> m_covers;
    QTimer m_timer;
};
