// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/framer.h"
#include "protocol/storm32/commands.h"

#include <array>

namespace storm32 {

/// Finds the answers of a STorM32 board: single letters, the data of simple commands, frames of the RC set,
/// and MAVLink. The data of a simple command has no start mark of its own, so the framer takes notice of what
/// is asked (errata 3.1: count bytes, then check the closing letter and the checksum). An error letter
/// instead of data is recognised by the silence after it, or by a checked frame. Data that come later than
/// anybody waited are recognised by their checksum.
class Framer final : public ::Framer
{
public:
    void feed(Bytes bytes, const FrameSink &sink) override;
    void sent(Bytes bytes) override;
    void flush(const FrameSink &sink) override;
    [[nodiscard]] std::chrono::milliseconds gap() const override { return std::chrono::milliseconds(60); }
    [[nodiscard]] bool isWaiting() const override { return !m_buffer.isEmpty(); }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    /// What these bytes start with.
    struct Sighting
    {
        mavlink::Look look = mavlink::Look::No;
        std::size_t size = 0;
        FrameView frame{};
    };
    /// A command whose data may still come, from a board that is late.
    struct Earlier
    {
        const SimpleCommand *command = nullptr;
        int answersSince = 0;
    };
    [[nodiscard]] Sighting sight(Bytes bytes) const;
    [[nodiscard]] static Sighting sightLetter(Bytes bytes);
    [[nodiscard]] Sighting sightData(Bytes bytes) const;
    [[nodiscard]] static Sighting sightDataOf(const SimpleCommand &command, Bytes bytes);
    [[nodiscard]] bool awaitsData() const;
    void remember(const SimpleCommand *command);
    void forget(int frame);
    void answered();
    void scan(bool last, const FrameSink &sink);
    void skip(std::size_t count);

    QByteArray m_buffer;
    const SimpleCommand *m_asked = nullptr;  // the command whose data may arrive
    std::array<Earlier, 3> m_earlier;
    bool m_rcAsked = false;  // the most recent frame sent was one of the RC set
    FramerStatistics m_statistics;
};

}  // namespace storm32
