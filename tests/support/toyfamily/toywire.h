// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/framer.h"
#include "protocol/session/request.h"

#include <QDataStream>

/// A family that nobody makes, unlike all that the program knows: five motors and two axes behind a network,
/// asked for each sample, with floats and a text for its configuration. Frames are "TY", a number, the length
/// and the payload, all of it big-endian, and a CRC-16.
namespace toy {

/// Commands. The board answers with the same number and the highest bit set.
enum class Command : std::uint8_t {
    Heartbeat = 1,  ///< unanswered; without one for a second the board says nothing
    Identify,
    ReadBlock,
    WriteBlock,
    Telemetry,  ///< answered with the values; each tenth time a spectrum follows
    Spectrum,  ///< never asked for
    Control,  ///< unanswered: pan, tilt, throttle, arm
    Halt,  ///< unanswered: stand still
    Release,  ///< unanswered
    MotorsOff,
    Kill,  ///< motors off, whatever happens, until Unlock
    Unlock,
    Level,  ///< calibrates; the board is deaf meanwhile
    Blink,
};

constexpr int answerTo(Command command)
{
    return int(command) | 0x80;
}

[[nodiscard]] QByteArray encode(int id, const QByteArray &payload = {});
[[nodiscard]] inline QByteArray encode(Command command, const QByteArray &payload = {})
{
    return encode(int(command), payload);
}

/// Big-endian fields, floats of four bytes.
[[nodiscard]] QByteArray pack(const std::function<void(QDataStream &)> &fields);
/// False when the payload is too short.
bool unpack(const QByteArray &payload, const std::function<void(QDataStream &)> &fields);

/// A command that is answered, and may be repeated.
[[nodiscard]] Request request(Command command, const QByteArray &payload = {});

class ToyFramer final : public Framer
{
public:
    void feed(Bytes bytes, const FrameSink &sink) override;
    void flush(const FrameSink &sink) override;
    [[nodiscard]] bool isWaiting() const override { return !m_buffer.isEmpty(); }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    /// Length of the frame at the start of the buffer; 0: not complete, -1: none begins here.
    [[nodiscard]] qsizetype frameAtStart() const;

    QByteArray m_buffer;
    FramerStatistics m_statistics;
};

}  // namespace toy
