// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/mavlink/frame.h"
#include "protocol/simulator/link/simulatedport.h"
#include "protocol/simulator/storm32/board.h"

using namespace Qt::StringLiterals;

inline int u16(const QByteArray &bytes, int at)
{
    return std::uint8_t(bytes[at]) | std::uint8_t(bytes[at + 1]) << 8;
}

inline int s16(const QByteArray &bytes, int at)
{
    return std::int16_t(u16(bytes, at));
}

/// A client that knows nothing but bytes: it writes, waits and reads.
struct ByteClient
{
    explicit ByteClient(int firmware = 96, bool uart = true, bool strict = false)
        : port(std::make_unique<storm32::SimulatedBoard>(options(firmware, uart, strict)),
               options(firmware, uart, strict),
               uart ? std::optional(LineSettings{115200, Parity::None}) : std::nullopt)
    {
    }
    static SimulatorOptions options(int firmware, bool uart, bool strict)
    {
        SimulatorOptions o;
        o.firmware = firmware;
        o.usb = !uart;
        o.own[u"strict"_s] = strict;
        return o;
    }
    storm32::SimulatedBoard &board() { return static_cast<storm32::SimulatedBoard &>(port.board()); }
    QByteArray wait(milliseconds time)
    {
        QByteArray heard;
        for (milliseconds passed{}; passed < time; passed += 1ms) {
            port.advance(1ms);
            heard += port.hostReads().join();
        }
        return heard;
    }
    QByteArray ask(const QByteArray &bytes, milliseconds time = 200ms)
    {
        port.hostWrites(asBytes(bytes));
        return wait(time);
    }
    QByteArray askRc(storm32::Rc id, const QByteArray &payload = {})
    {
        return ask(storm32::encodeRc(int(id), payload));
    }
    // The payload of the answer to a message, without the frame around it.
    QByteArray askMavlink(mavlink::MessageId id, const QVariantMap &values, int target = 71)
    {
        QVariantMap all = values;
        all.insert(u"target_system"_s, target);
        all.insert(u"target_component"_s, 67);
        return ask(mavlink::encode(
            id, *mavlink::encodeFields(*mavlink::findMessage(mavlink::number(id)), all), {82, 67}, 0));
    }
    SimulatedPort port;
};

inline QVariantMap fieldsOf(const QByteArray &frame)
{
    const auto seen = mavlink::sight(asBytes(frame));
    if (seen.look != mavlink::Look::Complete)
        return {};
    return mavlink::decodeFields(*mavlink::findMessage(seen.packet.id), seen.packet.payload)
        .value_or(QVariantMap());
}
