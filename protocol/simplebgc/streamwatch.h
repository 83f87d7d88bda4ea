// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace simplebgc {

/// Detects frames of one stream that never arrived, and tells them apart from late ones and from a board that
/// was silent.
class StreamWatch
{
public:
    struct Finding
    {
        int lost = 0;  ///< frames that were lost before this one
        double silence = 0;  ///< seconds before this frame in which nothing at all arrived
    };

    /// @param period seconds between frames
    explicit StreamWatch(double period)
        : m_period(period)
    {
    }

    /// The stamp leads too far away from the one before to be believed at once: it may be damaged, as eight
    /// bits of checksum let one of 256 frames pass. Believed is the frame that goes on from there.
    bool isDoubtful(double stamp);
    /// A frame with the board's own clock in milliseconds (it wraps at 65 536).
    /// @param silence seconds since anything at all came from the board
    Finding stamped(double stamp, double silence);
    /// A frame that arrived at that time (seconds); it carries no clock, so loss only shows over several
    /// frames.
    Finding unstamped(double arrival, double silence);

private:
    [[nodiscard]] Finding judge(int missing, double silence) const;

    double m_period;
    int m_seen = 0;
    // From the board's clock.
    double m_lastStamp = 0;
    std::optional<double> m_doubted;
    double m_board = 0;  // unwrapped stamps, milliseconds
    double m_counted = 0;  // frames times period, lost ones included
    double m_base = 0;  // lead of the stamps without any loss
    double m_mean = 0;
    // From arrival: the delay of the punctual frames shows what is missing.
    double m_first = 0;
    double m_expected = 0;  // frames times period since the first
    double m_minLate = 0;  // of this block
    double m_maxSilence = 0;
    double m_silenceBefore = 0;  // of the previous block: a silence shows in the block after it
    double m_blockEnds = 0;
    std::optional<double> m_expectedLate;
};

}  // namespace simplebgc
