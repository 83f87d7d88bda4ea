// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/sbgcdevice.h"
#include "protocol/simplebgc/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;
using namespace sbgc;

namespace {

constexpr double kCycle = 0.0008;            // seconds: the firmware's control loop, and interval 1 of a stream
constexpr double kLinkShare = 0.85;          // the rest of the line stays free for requests
constexpr int kStatusIntervalMs = 100;       // REALTIME_DATA_4 beside a fast stream
constexpr int kStatusAloneMs = 40;
constexpr auto kPollInterval = 20ms;
constexpr int kFrameOverhead = 5;
constexpr double kStampWrap = 65536.0;       // milliseconds
constexpr double kStampStep = 1.0;           // milliseconds
constexpr quint64 kLearning = 50;            // frames
constexpr double kMeanWeight = 0.06;

class SbgcDecoder final : public TelemetryDecoder
{
public:
    SbgcDecoder(quint32 customFlags, double customPeriod) : m_clock(customPeriod), m_values(64)
    {
        expectCustom(customFlags, customPeriod);
    }

    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override
    {
        if (frame.id == number(CommandId::RealtimeData3) || frame.id == number(CommandId::RealtimeData4))
            decodeStatus(frame, at, store);
        else if (frame.id == number(CommandId::RealtimeDataCustom) && m_customFlags)
            decodeCustom(frame, at, store);
    }

    void sent(QByteArrayView bytes) override
    {
        SbgcFramer framer;
        framer.feed(asBytes(bytes), [this](const FrameView &frame) {
            const auto stream = DataStream::decode(frame.payload);
            if (frame.id != number(CommandId::DataStreamInterval) || !stream
                || stream->command != number(CommandId::RealtimeDataCustom))
                return;
            const double period = stream->intervalMs <= 1 ? kCycle : stream->intervalMs / 1000.0;
            expectCustom(stream->intervalMs > 0 ? ByteReader(stream->config).u32() : 0, period);
        });
    }

private:
    void expectCustom(quint32 flags, double period)
    {
        m_customFlags = flags;
        m_customLayout = customLayout(flags);
        m_customPeriod = period;
        m_customChannels.clear();
        for (const WireField &field : m_customLayout)
            m_customChannels.append(field.channel);
        m_clock = SampleClock(period);
        m_custom.reset();
        m_status3.reset();   // which fields are left to the status streams depends on the custom one
        m_status4.reset();
        m_seen = 0;
        m_board = m_counted = m_base = m_mean = 0.0;
    }

    void decodeStatus(const FrameView &frame, TimePoint at, TelemetryStore &store)
    {
        const bool extended = frame.payload.size() >= kRealtime4Size;
        if (frame.payload.size() < kRealtime3Size)
            return;
        auto &group = extended ? m_status4 : m_status3;
        if (!group) {
            QList<int> channels;
            for (const WireField &field : realtimeFields()) {
                if (isStatusField(field, extended))
                    channels.append(field.channel);
            }
            group = store.defineGroup(channels, 0.0);
        }
        std::size_t count = 0;
        m_values.resize(realtimeFields().size());
        for (const WireField &field : realtimeFields()) {
            if (isStatusField(field, extended))
                m_values[count++] = readField(field, frame.payload);
        }
        store.append(*group, at, std::span(m_values).first(count));
    }

    // Fields that come faster in the custom stream would only draw a second, coarser trace.
    bool isStatusField(const WireField &field, bool extended) const
    {
        return (extended || field.offset < kRealtime3Size) && !m_customChannels.contains(field.channel);
    }

    void decodeCustom(const FrameView &frame, TimePoint at, TelemetryStore &store)
    {
        if (frame.payload.size() < std::size_t(customSize(m_customFlags)))
            return;
        if (!m_custom)
            m_custom = store.defineGroup(m_customChannels, m_customPeriod);
        ByteReader reader(frame.payload);
        const int missing = missingBefore(double(reader.u16()));
        const double time = m_clock.next(store.secondsAt(at), missing);
        const TimePoint sampleTime = store.origin() + durationFromSeconds(time);
        if (missing > 0) {
            store.countLost(quint64(missing));
            store.appendGap(*m_custom, sampleTime - durationFromSeconds(m_customPeriod));
        }
        m_values.resize(m_customLayout.size());
        for (std::size_t i = 0; i < m_customLayout.size(); ++i)
            m_values[i] = readField(m_customLayout[i], frame.payload);
        store.append(*m_custom, sampleTime, m_values);
    }

    // The board's millisecond stamp against the counted time: what it is ahead was lost on the way. A whole millisecond is
    // longer than the period, so a single lost frame shows only in the mean over some frames; a longer gap shows at once.
    int missingBefore(double stamp)
    {
        const double period = m_customPeriod * 1000.0;
        double step = m_seen == 0 ? 0.0 : stamp - m_lastStamp;
        if (step < -kStampWrap / 2)
            step += kStampWrap;
        m_lastStamp = stamp;
        m_board += step;
        m_counted += m_seen == 0 ? 0.0 : period;
        const double ahead = m_board - m_counted - m_base;
        ++m_seen;
        if (ahead < -50.0) {   // the board restarted its clock
            m_counted = m_board - m_base;
            m_mean = 0.0;
            return 0;
        }
        int missing = 0;
        if (ahead > kStampStep + 1.5 * period) {
            missing = int(std::lround(ahead / period));
        } else if (m_seen <= kLearning) {
            m_base += ahead / m_seen;   // the phase between stamps and frames
            return 0;
        } else {
            m_mean += kMeanWeight * (ahead - m_mean);
            if (m_mean > 0.6 * period)
                missing = 1;
            else if (m_mean < -0.6 * period)
                missing = -1;           // a frame was counted that never was
        }
        m_counted += missing * period;
        m_mean -= missing * period;
        if (missing > 1)
            m_mean = 0.0;
        return std::max(0, missing);
    }

    quint32 m_customFlags = 0;
    std::vector<WireField> m_customLayout;
    double m_customPeriod = 0.0;
    QList<int> m_customChannels;
    SampleClock m_clock;
    std::vector<float> m_values;
    std::shared_ptr<TelemetryGroup> m_status3;
    std::shared_ptr<TelemetryGroup> m_status4;
    std::shared_ptr<TelemetryGroup> m_custom;
    quint64 m_seen = 0;
    double m_lastStamp = 0;
    double m_board = 0;        // unwrapped stamps, milliseconds
    double m_counted = 0;      // frames times period, lost ones included
    double m_base = 0;         // what the stamps are ahead by without any loss
    double m_mean = 0;
};

QByteArray customConfig(quint32 flags)
{
    return ByteWriter().u32(flags).zeros(4).take();
}

} // namespace

ChannelTable SbgcDevice::channels() const
{
    return channelTable();
}

ChannelRoles SbgcDevice::roles() const
{
    ChannelRoles roles;
    roles.angle = {ImuRoll, ImuPitch, ImuYaw};
    roles.target = {TargetRoll, TargetPitch, TargetYaw};
    roles.gyro = {GyroRoll, GyroPitch, GyroYaw};
    roles.acc = {AccX, AccY, AccZ};
    roles.frameAngle = {FrameRoll, FramePitch, FrameYaw};
    roles.motorPower = {PowerRoll, PowerPitch, PowerYaw};
    roles.battery = Battery;
    roles.temperature = ImuTemperature;
    roles.current = m_identity.capabilities.contains(u"current"_s) ? int(Current) : -1;
    roles.motorsOn = MotorsRunning;
    roles.faults = SystemError;
    roles.faultDetail = SubError;
    roles.activeProfile = CurrentProfile;
    roles.cycleTime = CycleTime;
    roles.busErrors = I2cErrors;
    return roles;
}

QList<int> SbgcDevice::fastChannels() const
{
    QList<int> channels;
    if (!canStream())
        return channels;
    for (const CustomField &field : customFields()) {
        for (const WireField &wire : field.fields)
            channels.append(wire.channel);
    }
    return channels;
}

Result<void> SbgcDevice::setStream(Channel &channel, const DataStream &stream)
{
    Request request = confirmRequest(CommandId::DataStreamInterval, stream.encode(), kVersion);
    request.idempotent = true;
    request.retries = 2;
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    const auto same = [&stream](const DataStream &known) {
        return known.command == stream.command && known.config == stream.config;
    };
    std::erase_if(m_streams, same);
    if (stream.intervalMs > 0)
        m_streams.push_back(stream);
    return {};
}

// Firmware without streams: REALTIME_DATA_4 if it is known, else _3, as often as the line allows.
Result<TelemetryPlan> SbgcDevice::startPolling(Channel &channel)
{
    const auto extended = channel.transact(
        replyRequest(CommandId::RealtimeData4, {}, CommandId::RealtimeData4, kRealtime4Size, kVersion));
    if (!extended && extended.error().code != ErrorCode::Timeout && extended.error().code != ErrorCode::BoardError)
        return tl::unexpected(extended.error());
    const CommandId id = extended ? CommandId::RealtimeData4 : CommandId::RealtimeData3;
    TelemetryPlan plan;
    plan.poll = replyRequest(id, {}, id, extended ? kRealtime4Size : kRealtime3Size, kVersion);
    plan.poll->retries = 0;
    plan.pollInterval = kPollInterval;
    plan.rate = 1000.0 / double(kPollInterval.count());
    plan.decoder = std::make_shared<SbgcDecoder>(0, 0.0);
    return plan;
}

Result<TelemetryPlan> SbgcDevice::startTelemetry(Channel &channel, const TelemetryWish &wish,
                                                 std::optional<LineSettings> line)
{
    if (!canStream())
        return startPolling(channel);
    TelemetryPlan plan;
    stopTelemetry(channel);
    const quint32 flags = customFlagsFor(wish.channels);
    const bool unlimited = !line || m_identity.usb;
    const double cycleRate = 1.0 / kCycle;
    int interval = 0;
    if (flags) {
        double possible = cycleRate;
        if (!unlimited) {
            const double status = line->secondsFor(kRealtime4Size + kFrameOverhead) * 1000.0 / kStatusIntervalMs;
            possible = std::max(1.0, (kLinkShare - status) / line->secondsFor(customSize(flags) + kFrameOverhead));
        }
        possible = std::min(possible, cycleRate);
        const double wanted = wish.rate > 0 ? std::min(wish.rate, possible) : possible;
        // Interval 1 is each cycle; from 2 on it is milliseconds (errata 3.10).
        interval = wanted >= cycleRate ? 1 : std::clamp(int(std::ceil(1000.0 / wanted)), 2, 65535);
        plan.rate = interval == 1 ? cycleRate : 1000.0 / interval;
    }
    plan.streaming = true;
    plan.decoder = std::make_shared<SbgcDecoder>(flags, flags ? 1.0 / plan.rate : 0.0);
    if (const auto set = setStream(channel, {number(CommandId::RealtimeData4),
                                             flags ? kStatusIntervalMs : kStatusAloneMs, QByteArray(8, '\0')}); !set) {
        // All streams of the board may be taken by somebody else, or this build has none.
        const ErrorCode code = set.error().code;
        if (code == ErrorCode::BoardError || code == ErrorCode::Timeout)
            return startPolling(channel);
        return tl::unexpected(set.error());
    }
    if (flags) {
        if (const auto set = setStream(channel, {number(CommandId::RealtimeDataCustom), interval, customConfig(flags)});
            !set)
            return tl::unexpected(set.error());
    }
    for (DataStream stream : m_streams) {
        stream.intervalMs = 0;
        plan.farewell += encodeFrame(number(CommandId::DataStreamInterval), stream.encode(), kVersion);
    }
    return plan;
}

std::shared_ptr<TelemetryDecoder> SbgcDevice::replayDecoder() const
{
    return std::make_shared<SbgcDecoder>(0, 0.0);
}

void SbgcDevice::stopTelemetry(Channel &channel)
{
    for (DataStream stream : std::exchange(m_streams, {})) {
        stream.intervalMs = 0;
        Request request = confirmRequest(CommandId::DataStreamInterval, stream.encode(), kVersion);
        request.idempotent = true;
        request.retries = 1;
        channel.transact(request);
    }
}
