// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/decoder.h"

#include "protocol/simplebgc/framer.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace simplebgc {

namespace {

// A stream with time stamps hardly ever has to resynchronize with arrival: its losses are known.
constexpr double kStampedResync = 2.0;
constexpr double kUnstampedResync = 0.25;
// A row that is later than expected by more than this is drawn with a gap before it.
constexpr double kGapRows = 3.0;
constexpr double kMinGap = 0.05;
constexpr double kQuiet = 0.05;  // seconds

// All of these fields have a known size.
bool isDocumented(quint32 flags)
{
    for (const CustomField &field : customFields())
        flags &= ~(1U << field.bit);
    return flags == 0;
}

// A stream as fast as the control loop sends several frames with the same millisecond.
constexpr double kSameStamp = 0.005;  // seconds
constexpr unsigned kNoSensor = 1;  // of SYSTEM_ERROR

bool isWithin(int channel, int first, int last)
{
    return channel >= first && channel <= last;
}

// What comes from the motion sensor.
bool isSensed(int channel)
{
    return isWithin(channel, ImuRoll, ImuYaw) || isWithin(channel, GyroRoll, AccZ)
        || isWithin(channel, GravityError, HeadingError) || isWithin(channel, Z1X, H1Z)
        || isWithin(channel, ImuRadRoll, Imu20Yaw) || isWithin(channel, ImuQuatW, ImuQuatZ)
        || channel == ImuTemperature;
}

// Milliseconds of the board's clock, at the beginning of each CUSTOM (errata 3.9).
double stampOf(const FrameView &frame)
{
    return ByteReader(frame.payload).u16();
}

bool isStatus(int id)
{
    return id == number(CommandId::RealtimeData3) || id == number(CommandId::RealtimeData4);
}

}  // namespace

double streamPeriod(const DataStream &stream)
{
    return stream.intervalMs <= 1 ? kCycle : stream.intervalMs / 1000.0;
}

void Decoder::expect(const DataStream &stream)
{
    std::erase_if(m_flows, [&](const Flow &flow) { return flow.id == stream.command; });
    if (stream.intervalMs > 0) {
        const bool custom = stream.command == number(CommandId::RealtimeDataCustom);
        addFlow(stream.command, streamPeriod(stream), custom ? ByteReader(stream.config).u32() : 0);
    }
    shareFields();
}

void Decoder::addFlow(int id, double period, quint32 customFlags)
{
    Flow flow;
    flow.id = id;
    flow.period = period;
    flow.customFlags = customFlags;
    m_flows.push_back(std::move(flow));
}

// A channel that is carried by two streams is taken from the faster one; the other would only draw a coarser
// trace over it.
void Decoder::shareFields()
{
    std::stable_sort(m_flows.begin(), m_flows.end(), [](const Flow &a, const Flow &b) {
        return (a.period > 0 ? a.period : 1e9) < (b.period > 0 ? b.period : 1e9);
    });
    QList<int> taken;
    for (Flow &flow : m_flows) {
        flow.payloadSize = 0;
        flow.fields.clear();
        for (const WireField &field : flowFields(flow.id, flow.customFlags)) {
            flow.payloadSize = std::max(flow.payloadSize, field.offset + fieldSize(field.type));
            if (!taken.contains(field.channel))
                flow.fields.push_back(field);
        }
        for (const WireField &field : flow.fields)
            taken.append(field.channel);
        // A new group: its rows have other columns, and their time starts anew.
        flow.group.reset();
        flow.clock = SampleClock(flow.period, flow.customFlags ? kStampedResync : kUnstampedResync);
        flow.watch = StreamWatch(flow.period);
    }
}

void Decoder::decode(const FrameView &frame, TimePoint at, TelemetryStore &store)
{
    if (const double silence = m_heard ? seconds(at - *m_heard) : 0.0; silence >= kQuiet) {
        m_silence = silence;
        m_silenceEnd = at;
    }
    m_heard = at;
    const auto find = [&] {
        return std::find_if(m_flows.begin(), m_flows.end(),
                            [&](const Flow &flow) { return flow.id == frame.id; });
    };
    auto flow = find();
    if (flow == m_flows.end() && isStatus(frame.id)) {  // an answer to polling
        addFlow(frame.id, 0.0, 0);
        shareFields();
        flow = find();
    }
    // A CUSTOM of another size has other fields: a stream that somebody else has ordered.
    const bool isOther = flow != m_flows.end() && flow->customFlags && isDocumented(flow->customFlags)
        && frame.payload.size() != std::size_t(customSize(flow->customFlags));
    if (flow != m_flows.end() && !isOther && !flow->fields.empty()
        && frame.payload.size() >= std::size_t(flow->payloadSize)) {
        if (flow->period == 0)
            m_polls.answered(store);
        if (flow->customFlags && flow->watch.isDoubtful(stampOf(frame)))
            return;
        if (isFrozen(*flow, frame.payload)) {
            store.noteRepeat(at);
            return;
        }
        // The first frame after a silence may have been one of another stream.
        const bool quiet = flow->heard && *flow->heard < m_silenceEnd;
        take(*flow, frame, at, store, quiet ? m_silence : 0.0);
        flow->heard = at;
    }
}

// A board that sends the same sample again has none.
bool Decoder::isFrozen(Flow &flow, Bytes payload) const
{
    if (!flow.customFlags)
        return false;
    const QByteArray now = toByteArray(payload);
    if (now != std::exchange(flow.payload, now)) {
        flow.repeats = 0;
        return false;
    }
    return ++flow.repeats * flow.period >= kSameStamp;
}

// Zeros of a sensor that is not there are no values.
void Decoder::dropUnmeasured(const Flow &flow)
{
    for (std::size_t i = 0; i < flow.fields.size(); ++i) {
        const int channel = flow.fields[i].channel;
        if (channel == SystemError)
            m_isBlind = unsigned(m_values[i]) & kNoSensor;
        m_hasFrameSensor |= isWithin(channel, FrameRoll, FrameYaw) && m_values[i] != 0.0F;
        m_hasMagnetometer |= isWithin(channel, MagRoll, MagYaw) && m_values[i] != 0.0F;
    }
    for (std::size_t i = 0; i < flow.fields.size(); ++i) {
        const int channel = flow.fields[i].channel;
        if ((m_isBlind && isSensed(channel)) || (!m_hasFrameSensor && isWithin(channel, FrameRoll, FrameYaw))
            || (!m_hasMagnetometer && isWithin(channel, MagRoll, MagYaw)))
            m_values[i] = std::numeric_limits<float>::quiet_NaN();
    }
}

void Decoder::take(Flow &flow, const FrameView &frame, TimePoint at, TelemetryStore &store, double silence)
{
    if (!flow.group) {
        QList<int> channels;
        for (const WireField &field : flow.fields)
            channels.append(field.channel);
        flow.group = store.defineGroup(channels, flow.period);
        flow.lastTime = store.secondsAt(at);
    }
    const double arrival = store.secondsAt(at);
    double time = arrival;
    if (flow.period > 0) {
        const StreamWatch::Finding found = flow.customFlags ? flow.watch.stamped(stampOf(frame), silence)
                                                            : flow.watch.unstamped(arrival, silence);
        // A stream without stamps only notices a silence after its clock has long followed the arrival times.
        const int missing
            = found.lost + (flow.customFlags ? int(std::lround(found.silence / flow.period)) : 0);
        time = flow.clock.next(arrival, missing);
        if (found.lost > 0)
            store.countLost(quint64(found.lost));
        if (found.silence > 0 && &flow == &m_flows.front())  // all streams were silent at once
            store.countSilence(found.silence);
        if (missing > 0 || time - flow.lastTime > std::max(kMinGap, kGapRows * flow.period))
            store.appendGap(*flow.group,
                            store.origin()
                                + durationFromSeconds(std::max(flow.lastTime, time - flow.period)));
    }
    flow.lastTime = time;
    if (flow.customFlags)
        store.noteStamp(at);
    m_values.resize(flow.fields.size());
    for (std::size_t i = 0; i < flow.fields.size(); ++i)
        m_values[i] = readField(flow.fields[i], frame.payload);
    dropUnmeasured(flow);
    store.append(*flow.group, store.origin() + durationFromSeconds(time), m_values);
}

void Decoder::sent(QByteArrayView bytes, TelemetryStore &store)
{
    Framer framer;
    framer.feed(asBytes(bytes), [this, &store](const FrameView &frame) {
        // Beside streams it is a question of its own, whose answer no view waits for.
        const bool isPolled = !m_flows.empty()
            && std::all_of(m_flows.begin(), m_flows.end(), [](const Flow &flow) { return flow.period == 0; });
        if (isPolled && isStatus(frame.id))
            m_polls.asked(store);
        if (frame.id != number(CommandId::DataStreamInterval))
            return;
        if (const auto stream = DataStream::decode(frame.payload))
            expect(*stream);
    });
}

}  // namespace simplebgc
