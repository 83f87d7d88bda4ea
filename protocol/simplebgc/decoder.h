// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/streamwatch.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/telemetry/pollcount.h"
#include "protocol/telemetry/streams.h"

namespace simplebgc {

/// Interval 1 of a stream: the firmware's control loop (errata 3.10).
inline constexpr double kCycle = 0.0008;

/// Requested time between the frames of a stream, in seconds.
[[nodiscard]] double streamPeriod(const DataStream &stream);

/// Turns real-time frames into rows. Must be told which streams were requested, because the frames do not
/// say; unannounced frames (answers to polling) are decoded where possible.
class Decoder final : public TelemetryDecoder
{
public:
    void expect(const DataStream &stream);
    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override;
    void sent(QByteArrayView bytes, TelemetryStore &store) override;

private:
    struct Flow
    {
        int id = 0;
        double period = 0;  // 0: irregular
        quint32 customFlags = 0;
        int payloadSize = 0;
        std::vector<WireField> fields;  // fields that no faster flow carries
        std::shared_ptr<TelemetryGroup> group;
        SampleClock clock{0};
        StreamWatch watch{0};
        double lastTime = 0;
        std::optional<TimePoint> heard;
        QByteArray payload;  // the newest one, of a stream with time stamps
        int repeats = 0;  // of it
    };
    void addFlow(int id, double period, quint32 customFlags);
    void shareFields();
    [[nodiscard]] bool isFrozen(Flow &flow, Bytes payload) const;
    void dropUnmeasured(const Flow &flow);
    void take(Flow &flow, const FrameView &frame, TimePoint at, TelemetryStore &store, double silence);

    std::vector<Flow> m_flows;  // fastest first
    std::vector<float> m_values;
    PollCount m_polls;
    bool m_isBlind = false;  // the board does not see its motion sensor
    bool m_hasFrameSensor = false;  // it has sent something else than zeros
    bool m_hasMagnetometer = false;
    std::optional<TimePoint> m_heard;  // any frame at all
    double m_silence = 0;  // length in seconds of the last time that nothing at all arrived
    TimePoint m_silenceEnd{};
};

}  // namespace simplebgc
