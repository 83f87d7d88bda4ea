// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/tracesource.h"

#include <limits>

/// One trace cut into pixel columns. Column k always covers the seconds [k*s, (k+1)*s), so nothing shimmers
/// while the plot scrolls; finished columns are kept, only the newest one is worked on.
class TraceColumns
{
public:
    static constexpr qint64 kNoLimit = std::numeric_limits<qint64>::max();
    struct Span
    {
        float low = 0;
        float high = -1;  ///< low > high: nothing to draw
        [[nodiscard]] bool isEmpty() const { return low > high; }
    };

    /// @param width number of columns kept; @param pitch seconds per column; @param limit last column of
    /// interest
    void reset(int width, double pitch, qint64 firstColumn, qint64 limit = kNoLimit);
    /// Takes all rows that are new since the last call. Returns the first column that changed, or nothing.
    std::optional<qint64> update(std::vector<TraceSource> &sources);
    [[nodiscard]] Span span(qint64 column) const;
    [[nodiscard]] qint64 columnOf(double time) const;
    /// Lowest and highest value in these columns; empty span when there is none.
    [[nodiscard]] Span range(qint64 first, qint64 last) const;
    /// The same, but of the columns before `recent` the extremes that lasted less than a seventh of all
    /// columns do not count.
    [[nodiscard]] Span lastingRange(qint64 first, qint64 recent, qint64 last) const;

private:
    void add(double time, float value);
    bool addBlock(const TraceSource &source, std::size_t row);
    void extend(qint64 column, float value);
    [[nodiscard]] std::size_t slot(qint64 column) const;

    std::vector<Span> m_spans;
    double m_pitch = 0.01;
    qint64 m_limit = kNoLimit;  // columns after this one are of no interest
    qint64 m_first = 0;  // columns before this one are of no interest
    qint64 m_newest = -1;  // newest column with anything in it
    std::size_t m_track = 0;  // which of the tracks is being read
    std::size_t m_nextRow = 0;
    bool m_started = false;
    bool m_hasLast = false;
    double m_lastTime = 0;
    float m_lastValue = 0;
};
