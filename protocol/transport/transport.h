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

/// Moves bytes and records the time at which they arrived. Lives on the I/O thread and never blocks it.
class Transport : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Starts opening; opened() or closed() follows, possibly before this returns.
    virtual void open() = 0;
    virtual void close() = 0;
    /// Queues bytes and hands over as many as possible to the system at once.
    virtual void write(QByteArrayView bytes) = 0;
    /// Sets rate and parity on links that have them; true if the link has none.
    virtual bool setLine(const LineSettings &line);
    /// Settings that determine how long bytes take; empty for links without a line rate.
    [[nodiscard]] virtual std::optional<LineSettings> line() const { return {}; }
    /// The received bytes are whole packets: one signal each, and no frame spans two packets.
    [[nodiscard]] virtual bool isPacketBased() const { return false; }
    /// The recording behind this link; null for a live one.
    [[nodiscard]] virtual Replay *replay() { return nullptr; }

signals:
    void opened();
    /// The link is gone (or never opened); Error::detail has the system's own message.
    void closed(const Error &why);
    /// Bytes arrived at this time. The view is valid during the call only.
    void received(QByteArrayView bytes, TimePoint at);
    /// The system has taken this many of the written bytes.
    void bytesWritten(qint64 count);
    /// A recorded link: these bytes were sent by the host at that time.
    void replayed(QByteArrayView bytes, TimePoint at);

protected:
    static constexpr qsizetype kReadBuffer = 65536;  ///< bytes taken from the system at once
};

/// Makes the transport for an address; called on the I/O thread. Schemes are composed in app/.
using TransportFactory = std::function<Result<std::unique_ptr<Transport>>(const LinkAddress &)>;
