// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the board tells all the time, and what steers it.
#include "protocol/storm32/stormdevice.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

constexpr auto kPollInterval = 5ms;  // as often as the line allows, one after the other
constexpr double kMostAngle = 720.0;
constexpr int kPulseMode = 3;  // microseconds from the middle
constexpr double kMostPulse = 800.0;
constexpr double kMiddlePulse = 1500.0;

constexpr ControlMode kControlModes[] = {
    {1, "angle", "Angle, within the limits of the sticks", false, true, 0, -180, 180},
    {2, "angle-unlimited", "Angle, without limits", false, true, 0, -kMostAngle, kMostAngle},
    {kPulseMode, "pulse", "Stick positions", false, true, 0, -kMostPulse, kMostPulse, "µs", 500},
};

}  // namespace

ChannelTable StormDevice::channels() const
{
    return channelTable();
}

ChannelRoles StormDevice::roles() const
{
    return channelRoles();
}

Result<StreamBudget> StormDevice::streamBudget(const TelemetryWish &wish, std::optional<LineSettings>) const
{
    if (!wish.streams.isEmpty())
        return failure(ErrorCode::InvalidArgument,
                       u"this board has no streams; it is asked for each sample"_s);
    return StreamBudget();
}

Result<TelemetryPlan> StormDevice::startTelemetry(Channel &, const TelemetryWish &wish,
                                                  std::optional<LineSettings> line)
{
    if (const auto budget = streamBudget(wish, line); !budget)
        return tl::unexpected(budget.error());
    TelemetryPlan plan;
    plan.poll = simple(Simple::LiveData);
    plan.poll->retries = 0;
    plan.pollInterval = kPollInterval;
    // Each sample takes its question, the board's time to answer and its 67 bytes.
    const double wire
        = line ? line->secondsFor(plan.poll->replyBytes + qsizetype(plan.poll->bytes.size())) : 0.0;
    plan.rate = 1.0 / (std::max(0.01, wire) + 0.003);
    plan.decoder = std::make_shared<StormDecoder>(m_firmware);
    return plan;
}

std::shared_ptr<TelemetryDecoder> StormDevice::replayDecoder() const
{
    return std::make_shared<StormDecoder>(m_firmware);
}

std::vector<BoardFault> StormDevice::faults(unsigned bits, unsigned detail) const
{
    return faultsOf(bits, detail);
}

std::vector<BoardFact> StormDevice::facts(const std::function<double(int)> &latest) const
{
    const double status = latest(Status);
    const double status2 = latest(Status2);
    const double functions = latest(Functions);
    if (std::isnan(status) || std::isnan(status2) || std::isnan(functions))
        return {};
    return factsOf(unsigned(status), unsigned(status2), unsigned(functions));
}

QString StormDevice::stateText(int state) const
{
    return stateName(state, m_firmware);
}

QString StormDevice::spokenText(const FrameView &frame) const
{
    if (frame.id != FrameId::kMavlink + mavlink::number(mavlink::MessageId::StatusText))
        return {};
    const auto fields = mavlink::decodeFields(
        *mavlink::findMessage(mavlink::number(mavlink::MessageId::StatusText)), frame.payload);
    return fields ? fields->value(u"text"_s).toString().trimmed() : QString();
}

Request StormDevice::motorsOffRequest() const
{
    return rc(Rc::SetStandby, QByteArray(1, '\1'));
}

Request StormDevice::motorsOnRequest() const
{
    return rc(Rc::SetStandby, QByteArray(1, '\0'));
}

std::span<const ControlMode> StormDevice::controlModes() const
{
    return kControlModes;
}

// Angles, or stick positions, of all axes go together. Ours are as the board shows them: down, right and left
// are positive.
ControlFrames StormDevice::controlFrames(const ControlSetpoint &setpoint) const
{
    constexpr std::array<std::size_t, 3> kPlace{1, 0, 2};  // pitch, roll, yaw
    const bool pulses = std::any_of(setpoint.begin(), setpoint.end(),
                                    [](const AxisSetpoint &axis) { return axis.mode == kPulseMode; });
    std::array<double, 3> angles{};
    int flags = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const AxisSetpoint &axis = setpoint[kPlace[i]];
        angles[i] = axis.mode ? axis.angle : 0.0;
        flags |= axis.mode == 1 ? 1 << int(i) : 0;
    }
    ByteWriter writer;
    for (const double angle : angles) {
        if (pulses)
            writer.u16(int(std::lround(kMiddlePulse + std::clamp(angle, -kMostPulse, kMostPulse))));
        else
            writer.f32(float(std::clamp(angle, -kMostAngle, kMostAngle)));
    }
    const Request request
        = pulses ? rc(Rc::SetPitchRollYaw, writer.take()) : rc(Rc::SetAngle, writer.u8(flags).u8(0).take());
    ControlFrames frames;
    frames.setpoint = request.bytes;
    frames.stop = request.bytes;  // an angle is held by itself
    frames.release = request.bytes;  // bringing it back would be a movement that nobody asked for
    frames.answer = request.answer;  // errata 7: one command at a time
    return frames;
}
