// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/angles.h"
#include "protocol/base/bytes.h"
#include "protocol/base/latestvalues.h"
#include "protocol/base/linkloss.h"
#include "protocol/session/carryout.h"
#include "protocol/session/controlstream.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <cmath>
#include <limits>
#include <utility>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kMotorsStart = 2s;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kFullRc = 500.0;  // of mode RC, in either direction from the middle
constexpr double kFullFineRc = 16384.0;
constexpr std::array kLabels{"Roll", "Pitch", "Yaw"};
constexpr std::array kVirtualChannels{std::pair("channel1", "Channel 1"), std::pair("channel2", "Channel 2"),
                                      std::pair("channel3", "Channel 3"), std::pair("channel4", "Channel 4"),
                                      std::pair("channel5", "Channel 5"), std::pair("channel6", "Channel 6"),
                                      std::pair("channel7", "Channel 7"), std::pair("channel8", "Channel 8")};
constexpr double kRcMiddle = 1500.0;  // as REALTIME_DATA reports the inputs

enum class Kind { Rate, Place, Signal, Channels };

struct ModeRow
{
    int id;
    const char *key;
    const char *label;
    Kind kind;
    double reach;  // in either direction from zero
    int since;
};
// Document CMD_CONTROL, errata 3.9.
// clang-format off
constexpr ModeRow kModes[] = {
    {Speed, "speed", "Speed", Kind::Rate, 4000, 0},
    {Angle, "angle", "Angle", Kind::Place, 720, 0},
    {SpeedAngle, "speed-angle", "Speed and angle", Kind::Place, 720, 0},
    {Rc, "rc", "As RC signal", Kind::Signal, kFullRc, 0},
    {AngleRelFrame, "angle-frame", "Angle relative to frame", Kind::Place, 720, 0},
    {RcHighRes, "rc-fine", "As RC signal, fine", Kind::Signal, kFullFineRc, 2662},
    {AngleShortest, "angle-shortest", "Angle, shortest way", Kind::Place, 720, 2707},
    {kVirtualChannelMode, "channels", "Virtual channels (1 roll, 2 pitch, 3 yaw)", Kind::Channels, 100, 0},
};
// clang-format on

SteeringMode modeOf(const ModeRow &row)
{
    SteeringMode mode{row.id, row.key, row.label, {}};
    if (row.kind == Kind::Channels) {
        for (std::size_t i = 0; i < kVirtualChannels.size(); ++i)
            mode.inputs.push_back({kVirtualChannels[i].first, kVirtualChannels[i].second,
                                   i < kAxes.size() ? kAxes[i] : Axis::None, "%", -row.reach, row.reach});
        return mode;
    }
    const bool rate = row.kind == Kind::Rate;
    const char *unit = rate ? "°/s" : row.kind == Kind::Place ? "°" : "";
    // The highest count of an angle is one short of two turns.
    const double max = row.kind == Kind::Place ? row.reach - 0.1 : row.reach;
    for (std::size_t i = 0; i < kAxes.size(); ++i)
        mode.inputs.push_back({axisKey(kAxes[i]), kLabels[i], kAxes[i], unit, -row.reach, max, 0.0, rate});
    if (row.kind == Kind::Place)
        mode.inputs.push_back({"speed", "Speed", Axis::None, "°/s", 0.0, 4000.0, 20.0, false});
    return mode;
}

// The value that keeps an axis where it is.
double holdingValue(int mode, std::size_t axis, const LatestValues &latest)
{
    const auto value = [&](int first) { return double(latest.latest(first + int(axis))); };
    switch (mode) {
    case Speed:
    case kVirtualChannelMode: return 0.0;
    case Rc:
    case RcHighRes: {
        const double signal = value(RcRoll) - kRcMiddle;  // far out of range without a receiver
        if (!(std::abs(signal) <= kFullRc))
            return kNothing;
        return mode == Rc ? signal : signal * kFullFineRc / kFullRc;
    }
    case AngleRelFrame: return value(RotorRoll);
    default: return std::isnan(value(TargetRoll)) ? value(ImuRoll) : value(TargetRoll);
    }
}

// In the mode SPEED an axis goes on turning until the next CONTROL, and its target with it: two answers with
// the same targets, and a camera that stands, prove that the stop has arrived. So do motors that are off.
constexpr double kStandstill = 1.5 * kDegreesPerCount;
constexpr double kCameraStands = 0.5;  // degrees between two answers, a tenth of a second apart: it is shaken
constexpr auto kStillTimeout = 1s;
constexpr int kCameraOffset = 32;  // of REALTIME_DATA_3
constexpr int kTargetOffset = 44;

using AxisPlaces = std::array<double, kAxisCount>;

AxisPlaces anglesAt(const Frame &frame, int offset)
{
    ByteReader reader(QByteArrayView(frame.payload).sliced(offset));
    AxisPlaces angles{};
    for (double &angle : angles)
        angle = reader.i16() * kDegreesPerCount;
    return angles;
}

std::function<Proof(const Frame &)> standstill(const Device::Control &steered)
{
    struct Place
    {
        AxisPlaces camera;
        AxisPlaces target;
    };
    return [steered, before = std::optional<Place>()](const Frame &frame) mutable {
        const auto running = Device::areMotorsRunning(frame);
        if (!running)
            return Proof::Nothing;
        if (!*running)
            return Proof::Proven;
        const Place now{anglesAt(frame, kCameraOffset), anglesAt(frame, kTargetOffset)};
        const auto last = std::exchange(before, now);
        if (!last)
            return Proof::Nothing;
        for (std::size_t axis = 0; axis < now.camera.size(); ++axis) {
            const bool isOurs = steered[axis].mode != NoControl && steered[axis].mode != Ignore;
            if (isOurs
                && (turnBetween(now.target[axis], last->target[axis]) > kStandstill
                    || turnBetween(now.camera[axis], last->camera[axis]) > kCameraStands))
                return Proof::Refuted;
        }
        return Proof::Proven;
    };
}

}  // namespace

std::vector<SteeringMode> steeringModes(int firmware)
{
    std::vector<SteeringMode> modes;
    for (const ModeRow &row : kModes) {
        if (firmware >= row.since)
            modes.push_back(modeOf(row));
    }
    return modes;
}

SteeringSetpoint Device::holdingSetpoint(int mode, const LatestValues &latest, SteeredBefore) const
{
    SteeringSetpoint setpoint{mode, {}, {}};
    const SteeringMode *known = steeringMode(mode);
    for (std::size_t i = 0; known && i < known->inputs.size(); ++i)
        setpoint.inputs.push_back(i < kAxes.size() ? holdingValue(mode, i, latest) : known->inputs[i].centre);
    return setpoint;
}

ControlCommand Device::encodeControl(const Control &control) const
{
    ControlCommand command;
    for (std::size_t axis = 0; axis < command.size(); ++axis) {
        const AxisControl &wanted = control[axis];
        const bool isRc = wanted.mode == Rc || wanted.mode == RcHighRes;
        command[axis].mode = wanted.mode;
        command[axis].angle = isRc ? toCount16(wanted.angle, 1.0) : angleToCount(wanted.angle);
        command[axis].speed = toCount16(wanted.speed, kControlSpeedUnit);
        // Extremely slow motion needs the fine unit (document: 2.59+).
        if (canStream() && wanted.speed != 0.0 && std::abs(wanted.speed) < 10.0 && !isRc) {
            command[axis].mode |= ControlHighResSpeed;
            command[axis].speed = toCount16(wanted.speed, kFineSpeedUnit);
        }
    }
    return command;
}

// What is not named goes on as before (errata 3.14).
QByteArray Device::encodeControlExt(const Control &control)
{
    constexpr double kTurn = 1 << 20;
    constexpr unsigned kSpeedBits = 1 | 8;  // there, and in 32 bits
    unsigned set = 0;
    ByteWriter axes;
    for (std::size_t axis = 0; axis < control.size(); ++axis) {
        const AxisControl &wanted = control[axis];
        if (wanted.mode == NoControl || wanted.mode == Ignore)
            continue;
        const bool isRc = wanted.mode == Rc || wanted.mode == RcHighRes;
        const unsigned angleBits = wanted.mode == Speed ? 0 : isRc ? 2 : 2 | 4;
        set |= ((isRc ? 0 : kSpeedBits) | angleBits) << (5 * axis);
        axes.u8(wanted.mode).u8(0);
        if (!isRc)
            axes.i32(qint32(std::lround(wanted.speed / kFineSpeedUnit)));
        if (isRc)
            axes.i16(toCount16(wanted.angle, 1.0));
        else if (angleBits)
            axes.i32(qint32(std::lround(wanted.angle / 360 * kTurn)));
    }
    return ByteWriter().u16(int(set)).bytes(axes.take()).take();
}

ControlFrames Device::controlFrames(const Control &control, bool isFine) const
{
    const auto frame = [this, isFine](const Control &wanted) {
        if (isFine)
            return encodeFrame(number(CommandId::ControlExt), encodeControlExt(wanted), kVersion);
        const ControlCommand command = encodeControl(wanted);
        return encodeFrame(number(CommandId::Control),
                           steersTogether() ? encodeControlShort(command) : simplebgc::encodeControl(command),
                           kVersion);
    };
    Control still = control;
    for (AxisControl &axis : still) {
        if (axis.mode != NoControl && axis.mode != Ignore)
            axis = {Speed, 0.0, 0.0};
    }
    ControlFrames frames;
    if (steersTogether() && std::any_of(control.begin(), control.end(), [&](const AxisControl &axis) {
            return axis.mode != control.front().mode;
        }))
        return frames;
    frames.setpoint = frame(control);
    frames.stop = frame(still);
    // Document, notes on CONTROL: mode NO_CONTROL with all data zero returns control to RC.
    frames.release = encodeFrame(number(CommandId::Control), QByteArray(13, '\0'), kVersion);
    frames.question = statusRequest();
    frames.question->timeout = kStillTimeout;
    frames.fromAnswer = standstill(control);
    return frames;
}

// At the end nobody gives them any more, which the board treats as signals that are lost. No answer tells
// that it did.
ControlFrames Device::channelFrames(const std::vector<double> &percents, bool isFine)
{
    const auto frame = [isFine](const std::vector<double> &given) {
        return encodeFrame(number(isFine ? CommandId::ApiVirtChHighRes : CommandId::ApiVirtChControl),
                           encodeChannels(given, isFine), kVersion);
    };
    ControlFrames frames;
    frames.setpoint = frame(percents);
    frames.stop = frames.release = frame({});
    return frames;
}

ControlFrames Device::controlFrames(const SteeringSetpoint &setpoint) const
{
    if (setpoint.mode == kVirtualChannelMode)
        return channelFrames(setpoint.inputs);
    Control control{};
    for (std::size_t axis = 0; axis < std::min(kAxes.size(), setpoint.inputs.size()); ++axis) {
        const double value = setpoint.inputs[axis];
        if (std::isnan(value))
            continue;  // it was not moved: the axis goes on as before
        const double speed = setpoint.inputs.size() > kAxes.size() ? setpoint.inputs[kAxes.size()] : 0.0;
        control[axis] = setpoint.mode == Speed ? AxisControl{Speed, value, 0.0}
                                               : AxisControl{setpoint.mode, speed, value};
    }
    return controlFrames(control);
}

Result<void> Device::switchMotorsOn(Channel &channel) const
{
    channel.allowMotors();
    const auto done = channel.transact(confirmRequest(CommandId::MotorsOn, {}, kVersion));
    if (!done && !isUntoldByAnswer(done.error()))
        return tl::unexpected(done.error());
    // Whatever was answered, or was not.
    const auto running = holdsWithin(channel, statusRequest(), kMotorsStart, [](const Frame &status) {
        return areMotorsRunning(status).value_or(false);
    });
    if (!running)
        return tl::unexpected(done ? running.error() : done.error());
    if (*running)
        return {};
    if (!done)
        return tl::unexpected(done.error());
    return failure(ErrorCode::NoEffect, u"the board reports that its motors are off"_s);
}

Result<bool> Device::areMotorsOn(Channel &channel) const
{
    const auto status = channel.transact(statusRequest());
    if (!status)
        return tl::unexpected(status.error());
    const auto running = areMotorsRunning(*status);
    return running ? Result<bool>(*running) : failure(ErrorCode::BadReply, u"REALTIME_DATA_3"_s);
}

}  // namespace simplebgc
