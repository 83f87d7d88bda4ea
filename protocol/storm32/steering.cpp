// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/latestvalues.h"
#include "protocol/base/linkloss.h"
#include "protocol/session/carryout.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/stopplan.h"
#include "protocol/storm32/device.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr double kMaxAngle = 720.0;
constexpr int kLimitedMode = 1;
constexpr int kPulseMode = 3;  // microseconds from the middle
constexpr double kStickThrow = 800.0;
constexpr double kMiddlePulse = 1500.0;
constexpr auto kStarting = 20s;  // until motors turn, behind a restart
constexpr auto kLeaving = 3s;  // from standby until motors are active
constexpr std::array kLabels{"Roll", "Pitch", "Yaw"};

SteeringMode modeOf(int id, const char *key, const char *label, double reach, const char *unit,
                    double padReach = 0)
{
    SteeringMode mode{id, key, label, {}};
    for (std::size_t i = 0; i < kAxes.size(); ++i)
        mode.inputs.push_back(
            {axisKey(kAxes[i]), kLabels[i], kAxes[i], unit, -reach, reach, 0.0, false, padReach});
    return mode;
}

}  // namespace

std::span<const SteeringMode> Device::modes() const
{
    static const std::vector<SteeringMode> modes{
        modeOf(kLimitedMode, "angle", "Angle, within the limits of the sticks", 180.0, "°"),
        modeOf(2, "angle-unlimited", "Angle, without limits", kMaxAngle, "°"),
        modeOf(kPulseMode, "pulse", "Stick positions", kStickThrow, "µs", 500.0)};
    return modes;
}

// The board reports where the camera is and what its inputs are, but not its targets. An angle holds an axis
// only if nothing else contributes to its position. Angles and stick positions add up (errata 4), to the
// offset of the stick's middle; a panning axis counts from where the frame points, and one that is held again
// from where the frame pointed then. That may have happened before this link: through a cable that was pulled
// in between, by a remote control, by another program.
SteeringSetpoint Device::holdingSetpoint(int mode, const LatestValues &latest,
                                         SteeredBefore steeredBefore) const
{
    const double status2 = double(latest.latest(Status2));
    const bool knowsBoard
        = !std::isnan(status2) && (m_history->sawStart || steeredBefore == SteeredBefore::Never);
    const unsigned shifted = m_history->shifted | (knowsBoard ? unsigned(status2) : ~0U);
    SteeringSetpoint setpoint{mode, {}, {}};
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        const double stick = double(latest.latest(InputRoll + int(axis)));
        const bool isPlain = std::abs(stick) <= kStickRest && !(shifted & kPanBits[axis]);
        const double angle = isPlain ? double(latest.latest(AngleRoll + int(axis))) : std::nan("");
        setpoint.inputs.push_back(mode == kPulseMode ? stick : angle);
    }
    return setpoint;
}

void Device::learnShift(int word, int raw)
{
    // Pan modes in their order: hold hold pan, hold hold hold, pan pan pan, pan hold hold, pan hold pan, hold
    // pan pan, of pitch, roll and yaw (errata 11).
    constexpr auto kModes = std::to_array<unsigned>(
        {kPanBits[2], 0, kAllPanBits, kPanBits[1], kPanBits[1] | kPanBits[2], kPanBits[0] | kPanBits[2]});
    const auto found = std::find(m_shiftWords.begin(), m_shiftWords.end(), word);
    if (word < 0 || found == m_shiftWords.end())
        return;
    const auto at = std::size_t(found - m_shiftWords.begin());
    if (at < kPanBits.size())
        m_history->shifted |= raw != 0 ? kPanBits[at] : 0;
    else if (raw >= 0 && raw < int(kModes.size()))
        m_history->shifted |= kModes[std::size_t(raw)];
}

// Angles, or stick positions, of all axes are sent together. Ours have the signs that the board reports:
// down, right and left are positive.
ControlFrames Device::controlFrames(const SteeringSetpoint &setpoint) const
{
    constexpr std::array<std::size_t, 3> kPlace{1, 0, 2};  // pitch, roll, yaw
    const bool pulses = setpoint.mode == kPulseMode;
    ByteWriter writer;
    for (const std::size_t axis : kPlace) {
        const double value = axis < setpoint.inputs.size() ? setpoint.inputs[axis] : std::nan("");
        if (std::isnan(value))
            return {};  // no axis can be left out, and no value is known for it
        if (pulses)
            writer.u16(int(std::lround(kMiddlePulse + std::clamp(value, -kStickThrow, kStickThrow))));
        else
            writer.f32(float(std::clamp(value, -kMaxAngle, kMaxAngle)));
    }
    const int flags = setpoint.mode == kLimitedMode && !setpoint.holds ? 7 : 0;
    const Request request
        = pulses ? rc(Rc::SetPitchRollYaw, writer.take()) : rc(Rc::SetAngle, writer.u8(flags).u8(0).take());
    ControlFrames frames;
    frames.setpoint = request.bytes;
    frames.stop = request.bytes;  // an angle is held without further commands
    frames.release = request.bytes;  // moving it back would be an unexpected movement
    frames.answer = request.answer;  // errata 7: one command at a time
    frames.kind = request.kind;
    for (std::size_t axis = 0; !pulses && axis < kAxes.size(); ++axis) {
        if (!(m_history->shifted & kPanBits[axis]))  // otherwise it counts from where the frame points
            frames.angles[axis] = setpoint.inputs[axis];
    }
    return frames;
}

// Roll and pitch are level by gravity; yaw has no such angle.
std::array<double, kAxisCount> Device::levelAngles(const LatestValues &latest) const
{
    std::array<double, kAxisCount> angles = Steering::levelAngles(latest);
    const double status2 = double(latest.latest(Status2));
    for (const Axis axis : {Axis::Roll, Axis::Pitch}) {
        const auto i = std::size_t(axis);
        const double stick = double(latest.latest(InputRoll + int(i)));
        if (!std::isnan(status2) && std::abs(stick) <= kStickRest
            && !((m_history->shifted | unsigned(status2)) & kPanBits[i]))
            angles[i] = 0.0;
    }
    return angles;
}

Request Device::standbyRequest(bool standby) const
{
    return rc(Rc::SetStandby, QByteArray(1, standby ? '\1' : '\0'));
}

// An acknowledgement proves nothing: the status does (errata 13, row 1).
StopPlan Device::stopPlan() const
{
    StopPlan plan;
    const std::vector<Request> standby{standbyRequest(true), simple(Simple::Status)};
    plan.means.push_back({standby, 300ms, 2});
    plan.fromAnswer
        = [stop = m_stop, firmware = m_firmware](const Frame &frame) { return stop->learn(frame, firmware); };
    if (!isKnownLayout(m_identity.firmwareNumber))
        return plan;  // nobody knows what its words mean
    const auto make = [way = m_way.load()](int word, std::optional<int> value) {
        ByteWriter writer;
        writer.u16(word);
        return value ? rcAt(way, Rc::SetParameter, writer.u16(*value).take())
                     : rcAt(way, Rc::GetParameter, writer.take());
    };
    plan.means.front().more = [stop = m_stop, make] { return stop->ask(make); };
    plan.means.push_back({standby, 800ms, 5, [stop = m_stop, make] { return stop->disable(make); }});
    plan.restore = [stop = m_stop, make, standby](int) { return stop->restore(make, standby); };
    return plan;
}

Result<void> Device::stopMotors(Channel &channel)
{
    auto done = carryOut(channel, stopPlan());
    const std::vector<int> before = m_stop->replaced();
    if (done || before.empty())
        return done;
    QStringList values;
    for (const ParameterSpec &spec : m_parameters->all()) {
        const auto word = std::size_t(spec.offset / 2 - MotorStop::kFirstWord);
        if (spec.row->block == Parameters && word < before.size())
            values.append(u"%1=%2"_s.arg(spec.key, spec.format(before[word])));
    }
    addDetail(
        done.error().detail,
        u"the motors are disabled in volatile memory; in use before: %1. Restart the board, or set these "
        "again, to use the motors, and store nothing before"_s.arg(values.join(u' ')));
    return done;
}

Result<void> Device::checkNotStopping() const
{
    if (!m_stop->isActive())
        return {};
    return failure(ErrorCode::Disabled, u"the board is not in standby yet"_s);
}

Result<void> Device::switchMotorsOn(Channel &channel) const
{
    if (const auto free = checkNotStopping(); !free)
        return free;
    channel.allowMotors();
    const auto done = channel.transact(standbyRequest(false));
    if (!done && !isUntoldByAnswer(done.error()))
        return tl::unexpected(done.error());
    // Whatever was answered, or was not.
    const auto disabled = disabledMotors(channel);
    if (!disabled)
        return tl::unexpected(done ? disabled.error() : done.error());
    if (disabled->size() == MotorStop::kWords)
        return failure(ErrorCode::NoEffect, u"every motor is disabled: %1"_s.arg(disabled->join(u", "_s)));
    std::optional<int> state;
    for (const TimePoint until = channel.now() + kStarting; channel.now() < until;) {
        const auto active
            = holdsWithin(channel, simple(Simple::Status), kLeaving, [&state](const Frame &status) {
                  ByteReader reader(status.payload);
                  state = reader.u16();
                  reader.u16();
                  return (reader.u16() & kMotorBits) != 0;
              });
        if (!active)
            return tl::unexpected(done ? active.error() : done.error());
        if (*active)
            return {};
        if (state >= kMotorsTurn)
            break;
    }
    if (state < kMotorsTurn)
        return failure(ErrorCode::NotSeen, u"the board is starting; its motors start by themselves then"_s);
    if (!done)
        return tl::unexpected(done.error());
    return failure(ErrorCode::NoEffect,
                   disabled->isEmpty()
                       ? u"no motor became active, though none is disabled"_s
                       : u"no motor became active; disabled are %1"_s.arg(disabled->join(u", "_s)));
}

// While the board starts they do not run yet, but are about to, unless all of them are disabled.
Result<bool> Device::areMotorsOn(Channel &channel) const
{
    const auto status = channel.transact(simple(Simple::Status));
    if (!status)
        return tl::unexpected(status.error());
    ByteReader reader(status->payload);
    const int state = reader.u16();
    reader.u16();
    const bool areActive = (reader.u16() & kMotorBits) != 0;
    if (!reader.ok())
        return failure(ErrorCode::BadReply, u"s"_s);
    if (areActive || state >= kMotorsTurn)
        return areActive;
    const auto disabled = disabledMotors(channel);
    if (!disabled)
        return tl::unexpected(disabled.error());
    return disabled->size() < MotorStop::kWords;
}

bool Device::isSwitchedBy(const ParameterSpec &spec) const
{
    const int word = spec.offset / 2 - MotorStop::kFirstWord;
    return spec.row->block == Parameters && word >= 0 && word < MotorStop::kWords;
}

// "motor.pitch.usage=3"; nothing of a board whose words are not known.
Result<QStringList> Device::disabledMotors(Channel &channel) const
{
    QStringList disabled;
    if (!isKnownLayout(m_identity.firmwareNumber))
        return disabled;
    for (int word = MotorStop::kFirstWord; word < MotorStop::kFirstWord + MotorStop::kWords; ++word) {
        const auto reply = channel.transact(rc(Rc::GetParameter, ByteWriter().u16(word).take()));
        if (!reply)
            return tl::unexpected(reply.error());
        ByteReader reader(reply->payload);
        if (reader.u16() != word)
            return failure(ErrorCode::BadReply, u"another parameter than %1"_s.arg(word));
        const auto spec = std::find_if(m_parameters->all().begin(), m_parameters->all().end(),
                                       [word](const ParameterSpec &each) {
                                           return each.row->block == Parameters && each.offset == 2 * word;
                                       });
        if (reader.u16() == MotorStop::kDisabled && spec != m_parameters->all().end())
            disabled.append(u"%1=%2"_s.arg(spec->key, spec->format(MotorStop::kDisabled)));
    }
    return disabled;
}

}  // namespace storm32
