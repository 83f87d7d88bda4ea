// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/clock.h"
#include "protocol/transport/linkaddress.h"
#include "protocol/transport/replay.h"

#include <QObject>

#include <functional>
#include <memory>

/// Moves bytes and stamps the time at which they arrived. Lives on the I/O thread and never blocks it.
class Transport : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Starts opening; opened() or closed() follows, possibly before this returns.
    virtual void open() = 0;
    virtual void close() = 0;
    /// Queues bytes and hands as many as possible to the system at once.
    virtual void write(QByteArrayView bytes) = 0;
    /// Rate and parity for links that have them; true where it makes no difference.
    virtual bool setLine(const LineSettings &line);
    /// Settings that decide how long bytes take; empty for links without a line rate.
    [[nodiscard]] virtual std::optional<LineSettings> line() const { return {}; }
    /// The received bytes are whole packets: one signal each, and nothing reaches from one into the next.
    [[nodiscard]] virtual bool isPacketBased() const { return false; }
    /// The recording behind this link; null for a living one.
    [[nodiscard]] virtual Replay *replay() { return nullptr; }

signals:
    void opened();
    /// The link is gone (or never came): why, in Error::detail the system's own words.
    void closed(const Error &why);
    /// Bytes arrived, at that time. The view is valid during the call only.
    void received(QByteArrayView bytes, TimePoint at);
    /// The system took so many of the written bytes.
    void bytesWritten(qint64 count);
    /// A recorded link: these bytes were sent by the host at that time.
    void replayed(QByteArrayView bytes, TimePoint at);
};

/// Makes the transport for an address; called on the I/O thread. Schemes are composed in app/.
using TransportFactory = std::function<Result<std::unique_ptr<Transport>>(const LinkAddress &)>;
