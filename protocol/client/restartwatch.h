// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <optional>

/// Notices that a board has restarted while the link stayed: its streams are gone after a silence, or it goes
/// through the states of its start again. Pure bookkeeping without a clock of its own.
class RestartWatch
{
public:
    enum class Step {
        Wait,
        Ask,  ///< whether the board is there; answered() follows
        StreamsEnded,  ///< the board has been there all the time, but streams no more
        Restarted,
    };

    /// A board is connected. @param isSame on the link that the one before was lost on
    void meet(bool isSame);
    /// Streams have been arranged. @param period seconds between two samples; 0: none come by themselves
    void begin(TimePoint now, double period);
    /// Nothing is watched until begin().
    void end();
    /// The board sent something. @param isStreamed it is a sample that nobody asked for
    void heard(TimePoint at, bool isStreamed);
    /// Its state. Returns whether it has started anew.
    [[nodiscard]] bool takeState(bool isFresh);
    /// What came of asking.
    void answered(bool isThere, TimePoint at);
    /// What is to be done now. @param silentUntil silence is expected until then
    [[nodiscard]] Step look(TimePoint now, TimePoint silentUntil = {});

    /// The board was told to restart.
    void order(TimePoint due) { m_due = due; }
    /// When a restart that was ordered and has not been noticed yet is due.
    [[nodiscard]] std::optional<TimePoint> takeOrder(TimePoint now);

private:
    [[nodiscard]] Duration periods(double count) const;

    double m_period = 0;
    TimePoint m_streamedAt{};
    TimePoint m_heardAt{};
    Duration m_silence{};  // the longest one since the last sample
    bool m_isAsking = false;
    bool m_wasAway = false;  // a question stayed without an answer
    std::optional<TimePoint> m_answeredAt;
    bool m_hasRun = false;
    std::optional<TimePoint> m_due;
};
