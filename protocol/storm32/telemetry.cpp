// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Telemetry of the board.
#include "protocol/session/channel.h"
#include "protocol/storm32/device.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr auto kPollInterval = 5ms;  // as often as the line allows, one after the other
constexpr double kSampleCycle = 0.01;  // seconds that a sample takes at least
constexpr double kAnswerSeconds = 0.003;  // seconds until the board answers

}  // namespace

ChannelTable Device::channels() const
{
    return channelTable();
}

Result<TelemetryPlan> Device::subscribe(Channel &, const Subscription &subscription,
                                        std::optional<LineSettings> line)
{
    if (!subscription.streams.isEmpty())
        return failure(ErrorCode::InvalidArgument,
                       u"this board has no streams; it is asked for each sample"_s);
    TelemetryPlan plan;
    plan.poll = simple(Simple::LiveData);
    plan.poll->retries = 0;
    plan.poll->repeated = true;
    plan.pollInterval = kPollInterval;
    // Each sample takes its request, the board's time to answer and its 67 bytes.
    const double wire
        = line ? line->secondsFor(plan.poll->replyBytes + qsizetype(plan.poll->bytes.size())) : 0.0;
    plan.rate = 1.0 / (std::max(kSampleCycle, wire) + kAnswerSeconds);
    if (wire > kSampleCycle)
        plan.fullRate = 1.0 / (kSampleCycle + kAnswerSeconds);
    plan.decoder = std::make_shared<Decoder>(m_firmware, m_history);
    return plan;
}

std::shared_ptr<TelemetryDecoder> Device::replayDecoder() const
{
    return std::make_shared<Decoder>(m_firmware);
}

std::vector<BoardFault> Device::faults(unsigned bits, unsigned detail) const
{
    return faultsOf(bits, detail);
}

std::vector<BoardFact> Device::facts(const std::function<double(int)> &latest) const
{
    const double status = latest(Status);
    const double status2 = latest(Status2);
    const double functions = latest(Functions);
    if (std::isnan(status) || std::isnan(status2) || std::isnan(functions))
        return {};
    return factsOf(unsigned(status), unsigned(status2), unsigned(functions));
}

QString Device::statusText(int state) const
{
    return stateName(state, m_firmware);
}

// Standby, start and levelling come before state 6, or have numbers of their own (errata 3.7).
bool Device::isStabilising(int state) const
{
    return state == 6;
}

bool Device::isStarting(int state) const
{
    return state >= 0 && state < 6;
}

// Levelling again begins at 5 (errata 3.7).
bool Device::isFreshlyStarted(int state) const
{
    return state == 0 || state == 1;
}

// Plain, or embedded in a message.
std::optional<milliseconds> Device::ordersReset(QByteArrayView sent) const
{
    Bytes content = asBytes(sent);
    QByteArray inner;
    if (const mavlink::Sighting seen = mavlink::sight(content); seen.look == mavlink::Look::Complete) {
        const mavlink::Message *message = mavlink::findMessage(seen.packet.id);
        if (!message || message->id != mavlink::MessageId::TargetSpecific)
            return {};
        const auto fields = mavlink::decodeFields(*message, seen.packet.payload);
        if (!fields)
            return {};
        inner = fields->value(u"specific_payload"_s).toByteArray();
        content = asBytes(inner);
    }
    const SimpleCommand *command = findSimple(content);
    const bool restarts = command
        && (command->id == Simple::Restart || command->id == Simple::HardReset
            || command->id == Simple::NormalMotors);
    return restarts ? std::optional(0ms) : std::nullopt;
}

QString Device::messageText(const FrameView &frame) const
{
    if (frame.id != FrameId::kMavlink + mavlink::number(mavlink::MessageId::StatusText))
        return {};
    const auto fields = mavlink::decodeFields(
        *mavlink::findMessage(mavlink::number(mavlink::MessageId::StatusText)), frame.payload);
    return fields ? fields->value(u"text"_s).toString().trimmed() : QString();
}

}  // namespace storm32
