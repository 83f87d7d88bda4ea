// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/channel.h"
#include "protocol/simplebgc/decoder.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/leftoverstreams.h"
#include "protocol/simplebgc/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kCycleRate = 1.0 / kCycle;
constexpr double kStatusRate = 10;  // REALTIME_DATA_4 alongside a fast stream
constexpr double kStatusAloneRate = 25;
constexpr double kStatusShare = 1.0 / 3.0;  // of the line, where it cannot carry all
constexpr double kUsbBytes = 1e6;  // per second, USB CDC at full speed
constexpr auto kPollInterval = 20ms;
constexpr double kAnswerSeconds = 0.003;  // of the board, to a poll
constexpr int kFrameOverhead = 5;
const QString kCustomKey = u"custom"_s;
const QString kStatusKey = u"realtime4"_s;

struct StreamKind
{
    QString key;
    const char *label;
    CommandId command;
    int payload;  // bytes; 0: depends on the channels
};

// What can be streamed (errata 3.10). The frame IMU's helper data come with the same number as the main
// IMU's, so only one of the two is offered.
const std::array<StreamKind, 4> &streamKinds()
{
    // clang-format off
    static const std::array<StreamKind, 4> kinds{{
        {kCustomKey, "REALTIME_DATA_CUSTOM", CommandId::RealtimeDataCustom, 0},
        {kStatusKey, "REALTIME_DATA_4", CommandId::RealtimeData4, kRealtime4Size},
        {u"realtime3"_s, "REALTIME_DATA_3", CommandId::RealtimeData3, kRealtime3Size},
        {u"helper"_s, "AHRS_HELPER", CommandId::AhrsHelper, kHelperSize},
    }};
    // clang-format on
    return kinds;
}

const StreamKind *findKind(const QString &key)
{
    const auto it = std::find_if(streamKinds().begin(), streamKinds().end(),
                                 [&](const StreamKind &kind) { return kind.key == key; });
    return it == streamKinds().end() ? nullptr : it;
}

QList<int> channelsOf(const StreamKind &kind, quint32 customFlags)
{
    QList<int> channels;
    for (const WireField &field : flowFields(number(kind.command), customFlags))
        channels.append(field.channel);
    return channels;
}

// Interval 1 is each cycle; from 2 on it is milliseconds (errata 3.10).
int intervalFor(double rate)
{
    return rate >= kCycleRate ? 1 : std::clamp(int(std::ceil(1000.0 / rate - 1e-9)), 2, 65535);
}

double rateOf(int interval)
{
    return interval == 1 ? kCycleRate : 1000.0 / interval;
}

// @param known flags of CUSTOM that the board delivers
DataStream streamFor(const StreamUse &use, quint32 known)
{
    const StreamKind *kind = findKind(use.key);
    ByteWriter config;
    config.u32(use.key == kCustomKey ? customFlagsFor(use.channels) & known : 0).zeros(4);
    return {number(kind->command), intervalFor(use.rate), config.take()};
}

// Without a manual choice: the fast channels as fast as possible, with the status alongside.
QList<StreamChoice> arranged(const Subscription &subscription, quint32 known)
{
    if (!(customFlagsFor(subscription.channels) & known))
        return {{kStatusKey, kStatusAloneRate, {}}};
    return {{kStatusKey, kStatusRate, {}}, {kCustomKey, subscription.rate, subscription.channels}};
}

// What a slow line cannot carry comes less often, rather than not at all.
void thinOut(StreamBudget &budget)
{
    if (budget.fits())
        return;
    const auto limit = [](StreamUse &use, double bytes) {
        if (use.rate == 0 || use.bytesPerSecond() <= bytes)
            return;
        use.fullRate = use.rate;
        use.rate = rateOf(intervalFor(bytes / use.frameBytes));
    };
    double left = budget.capacity * StreamBudget::kShare;
    for (StreamUse &use : budget.streams) {
        const bool shares = use.key == kStatusKey && budget.streams.size() > 1;
        limit(use, shares ? left * kStatusShare : left);
        if (use.rate == 0)
            use.fullRate = kCycleRate;
        left -= use.bytesPerSecond();
    }
}

}  // namespace

ChannelTable Device::channels() const
{
    return channelTable(m_identity.firmwareNumber);
}

// What a killed program has ordered goes on, and could be taken for answers.
Result<void> Device::endLeftovers(Channel &channel)
{
    if (!canStream())
        return {};
    const auto left = stopLeftoverStreams(channel, {m_identity.firmwareNumber, kVersion});
    if (!left)
        return tl::unexpected(left.error());
    QStringList texts;
    for (const LeftoverStream &stream : *left)
        texts.append(u"%1 (%2 bytes, %3/s)"_s.arg(commandName(stream.command))
                         .arg(stream.size)
                         .arg(std::lround(stream.rate)));
    if (!texts.isEmpty())
        m_identity.extra.insert(u"streams.left"_s, texts.join(u", "_s));
    return {};
}

// Finds out which of the later fields of CUSTOM this firmware has. A field that it does not know adds nothing
// to the answer, and no document says which firmware introduced which field, so the board is asked: for
// several at once, and one by one if some are missing.
Result<void> Device::findCustomFields(Channel &channel)
{
    m_customFlags = kFirstCustomFlags;
    if (m_identity.firmwareNumber < kLaterCustomFirmware)
        return {};
    const auto has = [&](quint32 flags) -> Result<bool> {
        Request request = replyRequest(CommandId::RealtimeDataCustom, ByteWriter().u32(flags).zeros(6).take(),
                                       CommandId::RealtimeDataCustom, 2, kVersion);
        request.retries = 1;
        const auto reply = channel.transact(request);
        if (reply)
            return reply->payload.size() == customSize(flags);
        return tl::unexpected(reply.error());
    };
    std::vector<quint32> several{0};
    for (const CustomField &field : customFields()) {
        const quint32 flag = 1U << field.bit;
        if (flag & kFirstCustomFlags)
            continue;
        if (customSize(several.back() | flag) > kMaxPayload)
            several.push_back(0);
        several.back() |= flag;
    }
    for (const quint32 flags : several) {
        const auto all = has(flags);
        if (!all && (all.error().code == ErrorCode::Timeout || all.error().code == ErrorCode::BoardError))
            return {};  // a build without CUSTOM, or a recording made before this was asked
        if (!all)
            return tl::unexpected(all.error());
        if (*all) {
            m_customFlags |= flags;
            continue;
        }
        for (int bit = 0; bit < 32; ++bit) {
            const quint32 flag = 1U << bit;
            if (flags & flag && has(flag).value_or(false))
                m_customFlags |= flag;
        }
    }
    return {};
}

QList<int> Device::fastChannels() const
{
    QList<int> channels;
    if (!canStream())
        return channels;
    for (const WireField &field : customLayout(m_customFlags))
        channels.append(field.channel);
    return channels;
}

Result<void> Device::setStream(Channel &channel, const DataStream &stream)
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

// Firmware without streams: REALTIME_DATA_4 if it has that, otherwise its status, as often as the line
// allows.
Result<TelemetryPlan> Device::startPolling(Channel &channel, std::optional<LineSettings> line)
{
    const Request whole
        = replyRequest(CommandId::RealtimeData4, {}, CommandId::RealtimeData4, kRealtime4Size, kVersion);
    const auto extended = channel.transact(whole);
    if (!extended && extended.error().code != ErrorCode::Timeout
        && extended.error().code != ErrorCode::BoardError)
        return tl::unexpected(extended.error());
    TelemetryPlan plan;
    plan.poll = extended ? whole : statusRequest();
    plan.poll->retries = 0;
    plan.pollInterval = kPollInterval;
    plan.rate = 1000.0 / double(kPollInterval.count());
    // One after the other: the request, the board's time to answer, and the answer.
    const int bytes
        = int(plan.poll->bytes.size()) + kFrameOverhead + (extended ? kRealtime4Size : kRealtime3Size);
    const double each = (line && !m_identity.usb ? line->secondsFor(bytes) : 0.0) + kAnswerSeconds;
    if (1.0 / each < plan.rate)
        plan.fullRate = std::exchange(plan.rate, 1.0 / each);
    plan.decoder = std::make_shared<Decoder>();
    return plan;
}

QList<StreamSpec> Device::streams() const
{
    QList<StreamSpec> specs;
    if (!canStream())
        return specs;
    for (const StreamKind &kind : streamKinds()) {
        specs.append({kind.key, QString::fromLatin1(kind.label), kCycleRate, kind.payload == 0,
                      channelsOf(kind, m_customFlags)});
    }
    return specs;
}

QStringList Device::streamKeys()
{
    QStringList keys;
    for (const StreamKind &kind : streamKinds())
        keys.append(kind.key);
    return keys;
}

Result<StreamBudget> Device::streamBudget(const Subscription &subscription,
                                          std::optional<LineSettings> line) const
{
    StreamBudget budget;
    if (!canStream() && subscription.streams.isEmpty())
        return budget;  // polled: each sample is requested
    budget.capacity = m_identity.usb ? kUsbBytes : line ? 1.0 / line->secondsFor(1) : 0.0;
    const QList<StreamChoice> wanted
        = subscription.streams.isEmpty() ? arranged(subscription, m_customFlags) : subscription.streams;
    for (const StreamChoice &stream : wanted) {
        const StreamKind *kind = findKind(stream.key);
        if (!kind || !canStream())
            return failure(ErrorCode::InvalidArgument, u"no stream %1"_s.arg(stream.key));
        if (!(stream.rate >= 0 && stream.rate <= kCycleRate))
            return failure(ErrorCode::InvalidArgument,
                           u"%1 samples/s, 0 to %2 are possible"_s.arg(stream.rate).arg(kCycleRate));
        const quint32 flags = stream.key == kCustomKey ? customFlagsFor(stream.channels) & m_customFlags : 0;
        if (stream.key == kCustomKey && !flags)
            return failure(ErrorCode::InvalidArgument,
                           u"%1 without a channel that the board can send"_s.arg(stream.key));
        if (customSize(flags) > kMaxPayload) {
            return failure(ErrorCode::TooMuch,
                           u"%1 of %2 bytes, %3 fit into a frame"_s.arg(stream.key)
                               .arg(customSize(flags))
                               .arg(kMaxPayload));
        }
        const auto same = [&](const StreamUse &use) { return use.key == stream.key; };
        if (std::any_of(budget.streams.begin(), budget.streams.end(), same))
            return failure(ErrorCode::InvalidArgument, u"%1 twice"_s.arg(stream.key));
        StreamUse use{stream.key, QString::fromLatin1(kind->label), 0,
                      kFrameOverhead + (kind->payload ? kind->payload : customSize(flags)),
                      channelsOf(*kind, flags)};
        if (stream.rate > 0)
            use.rate = rateOf(intervalFor(stream.rate));
        budget.streams.push_back(std::move(use));
    }
    if (subscription.streams.isEmpty())
        thinOut(budget);
    // Streams without a fixed rate share what the others leave.
    const auto open = std::count_if(budget.streams.begin(), budget.streams.end(),
                                    [](const StreamUse &use) { return use.rate == 0; });
    const double left = (budget.capacity * StreamBudget::kShare - budget.bytesPerSecond())
        / double(std::max<qsizetype>(1, open));
    for (StreamUse &use : budget.streams) {
        if (use.rate == 0)
            use.rate = rateOf(
                intervalFor(budget.capacity > 0 ? std::max(1.0, left / use.frameBytes) : kCycleRate));
    }
    return budget;
}

Result<TelemetryPlan> Device::subscribe(Channel &channel, const Subscription &subscription,
                                        std::optional<LineSettings> line)
{
    if (!canStream()) {
        if (!subscription.streams.isEmpty())
            return failure(ErrorCode::InvalidArgument,
                           u"this firmware has no streams; it is asked for each sample"_s);
        return startPolling(channel, line);
    }
    auto budget = streamBudget(subscription, line);
    if (!budget)
        return tl::unexpected(budget.error());
    if (!budget->fits())
        return tl::unexpected(budget->refusal());
    stopStreams(channel);
    TelemetryPlan plan;
    plan.streaming = true;
    auto decoder = std::make_shared<Decoder>();
    for (const StreamUse &use : budget->streams) {
        const DataStream stream = streamFor(use, m_customFlags);
        const auto set = setStream(channel, stream);
        if (!set) {
            // All streams of the board may be in use by another client, or this build has none.
            const ErrorCode code = set.error().code;
            if (m_streams.empty() && subscription.streams.isEmpty()
                && (code == ErrorCode::BoardError || code == ErrorCode::Timeout))
                return startPolling(channel, line);
            stopStreams(channel);
            return tl::unexpected(set.error());
        }
        decoder->expect(stream);
        if (use.rate >= plan.rate) {
            plan.rate = use.rate;
            plan.fullRate = use.fullRate;
        }
    }
    plan.decoder = std::move(decoder);
    plan.budget = std::move(*budget);
    for (DataStream stream : m_streams) {
        stream.intervalMs = 0;
        plan.shutdownFrames += encodeFrame(number(CommandId::DataStreamInterval), stream.encode(), kVersion);
    }
    return plan;
}

std::shared_ptr<TelemetryDecoder> Device::replayDecoder() const
{
    return std::make_shared<Decoder>();
}

void Device::stopStreams(Channel &channel)
{
    for (DataStream stream : std::exchange(m_streams, {})) {
        stream.intervalMs = 0;
        Request request = confirmRequest(CommandId::DataStreamInterval, stream.encode(), kVersion);
        request.idempotent = true;
        request.retries = 1;
        channel.transact(request);
    }
}

}  // namespace simplebgc
