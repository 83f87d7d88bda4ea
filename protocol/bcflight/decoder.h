// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/messages.h"
#include "protocol/telemetry/streams.h"

#include <map>

namespace bcflight {

/// Turns what a drone streams and answers into rows (errata 8). Nothing carries a time stamp: rows have the
/// time at which they arrived.
class Decoder final : public TelemetryDecoder
{
public:
    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override;

private:
    bool isCurrentTold(double ampere);
    /// Numbers that are none, or beyond anything that can be measured, become gaps.
    void put(int first, std::vector<float> values, TimePoint at, TelemetryStore &store);
    void putCells(double volts, double level, TimePoint at, TelemetryStore &store);
    void putOutputs(Bytes payload, TimePoint at, TelemetryStore &store);
    void putRoundTrip(Bytes payload, TimePoint at, TelemetryStore &store);
    void putTelemetry(Bytes payload, TimePoint at, TelemetryStore &store);
    static void putSpectrum(Bytes payload, TimePoint at, TelemetryStore &store);

    std::map<std::pair<int, std::size_t>, std::shared_ptr<TelemetryGroup>>
        m_groups;  // by first channel and count
    std::shared_ptr<TelemetryGroup> m_outputs;
    std::size_t m_motors = 0;
    bool m_isBlind = true;  // its attitude unit is off, or nothing has told yet that it is on
    bool m_hasCurrent = false;  // something else than 0 was told of it
    double m_volts = 0;
    TimePoint m_streamedAt{};  // the battery, in the stream
};

}  // namespace bcflight
