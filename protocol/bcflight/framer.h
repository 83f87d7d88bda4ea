// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/messages.h"
#include "protocol/session/framer.h"

namespace bcflight {

/// FrameView::id of bytes that cannot be understood: an unknown message and all that follows it in its
/// packet (errata 2.5). Shown in the console, and no answer to anything.
inline constexpr int kDiscarded = 0x10000;

/// Finds what a drone sends: a packet is a list of messages without lengths or checksums (errata 2.2, 2.4).
/// FrameView::id is a Message, for an ACK with the number added to Message::Ack.
class Framer final : public ::Framer
{
public:
    /// Longest text that is waited for; the drone cuts it into datagrams of 65000 bytes (errata 2.1).
    static constexpr std::size_t kMaxText = 1 << 20;
    /// Bytes in a counted field, which the peer chooses.
    static constexpr std::size_t kMaxCounted = 1 << 16;

    void feed(Bytes bytes, const FrameSink &sink) override;
    void packetEnded(const FrameSink &sink) override;
    void flush(const FrameSink &sink) override;
    [[nodiscard]] bool isWaiting() const override { return !m_buffer.isEmpty(); }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    /// Takes messages from the front of the buffer. @param isWhole nothing follows
    void take(const FrameSink &sink, bool isWhole);
    void discard(const FrameSink &sink, qsizetype from);

    QByteArray m_buffer;
    bool m_isLost = false;  // where the next message begins is known again behind a gap
    FramerStatistics m_statistics;
};

}  // namespace bcflight
