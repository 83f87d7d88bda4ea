// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the menu, however they are given, and what goes on after them (errata 4.1). Where a document
// has no more than the name of a command, it does what the name says and no more.
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kMenuFlagsSince = 2738;  // of EXECUTE_MENU
constexpr int kMenuConfirms = 1;
constexpr int kMenuConfirmsEnd = 2;
constexpr int kButtonPressed = 22;
constexpr int kFrameInverted = 1 << 13;  // of board.flags1
constexpr double kSafeStopTime = 2.0;  // seconds
constexpr double kByHandTime = 3.0;
constexpr double kLookDown = 90.0;  // degrees
constexpr double kShakeUnit = 0.01;  // degrees; no document tells it
constexpr double kTrimPerSignal = 500.0;
constexpr int kTemperature = 3;  // action of CALIB_ACC and CALIB_GYRO

int axisBit(Axis axis)
{
    return 1 << static_cast<int>(axis);
}

constexpr int kRollAndPitch = 1 | 2;
constexpr int kAllAxes = 7;

}  // namespace

/// Some commands that follow each other; the argument grows with them.
struct SimulatedBoard::MenuEntry
{
    int first;
    int count;
    int (SimulatedBoard::*run)(int argument);
    int argument;
};

std::span<const SimulatedBoard::MenuEntry> SimulatedBoard::menuEntries()
{
    using B = SimulatedBoard;
    // clang-format off
    static constexpr MenuEntry kEntries[] = {
        {0, 1, &B::doNothing, 0},
        {1, 3, &B::useProfile, 0}, {14, 2, &B::useProfile, 3},
        {4, 1, &B::swapSticks, int(Axis::Pitch)}, {5, 1, &B::swapSticks, int(Axis::Yaw)},
        {54, 3, &B::invertStick, 0}, {74, 1, &B::trimSticks, 0},
        {6, 1, &B::calibrateSensor, 0}, {61, 1, &B::calibrateSensor, 0}, {9, 1, &B::calibrateSensor, 1},
        {21, 1, &B::calibrateSensor, 2}, {20, 1, &B::calibrateSensor, 3}, {33, 1, &B::calibrateNorth, 0},
        {62, 1, &B::resetEstimate, 0},
        {7, 1, &B::announceReset, 0},
        {8, 1, &B::takeAnglesByHand, 1}, {37, 1, &B::takeAnglesByHand, 0},
        {10, 1, &B::switchMotors, SwitchOver}, {11, 1, &B::switchMotors, SwitchOn},
        {12, 1, &B::switchMotors, SwitchOff}, {60, 1, &B::switchMotorsSafely, SwitchOff},
        {66, 1, &B::switchMotorsSafely, SwitchOver},
        {13, 1, &B::turnFrameOver, 0},
        {16, 1, &B::tuneAll, 0},
        {17, 1, &B::lookDown, 0}, {18, 1, &B::goHome, 0}, {38, 1, &B::goHome, 0}, {70, 1, &B::takeHome, 0},
        {34, 1, &B::level, kRollAndPitch}, {46, 1, &B::level, 1}, {65, 1, &B::level, 2},
        {35, 1, &B::centerMotors, 4}, {39, 1, &B::centerMotors, 4}, {75, 1, &B::centerMotors, kAllAxes},
        {36, 1, &B::untwist, 0}, {76, 1, &B::retract, 0},
        {40, 1, &B::turnYaw, 0}, {41, 1, &B::turnYaw, 1}, {42, 1, &B::switchYaw, 0}, {43, 1, &B::switchRoll, 0},
        {22, 1, &B::pressButton, 0}, {58, 2, &B::triggerCamera, 1},
        {23, 10, &B::startScript, 0}, {71, 1, &B::stopScript, 0},
        {48, 6, &B::loadProfileSet, 0},
        {63, 1, &B::forceFollow, 0}, {69, 1, &B::disableFollow, 0},
        {72, 1, &B::setTripod, SwitchOff}, {73, 1, &B::setTripod, SwitchOn},
        {77, 1, &B::setShake, SwitchOff}, {78, 1, &B::setShake, SwitchOn},
        {79, 1, &B::setServoMode, SwitchOn}, {80, 1, &B::setServoMode, SwitchOff},
        {81, 1, &B::setServoMode, SwitchOver},
    };
    // clang-format on
    return kEntries;
}

// Without flags it is confirmed, with flags as they say.
void SimulatedBoard::menu(const Frame &frame)
{
    const bool hasFlags = m_options.firmware >= kMenuFlagsSince && frame.payload.size() == 2;
    if (!hasFlags && !hasSize(frame, 1))
        return;
    const int flags = hasFlags ? quint8(frame.payload[1]) : kMenuConfirms;
    if (const int refusal = runMenu(quint8(frame.payload[0]))) {
        refuse(frame, refusal);
        return;
    }
    if (flags & kMenuConfirms)
        confirm(frame);
    if (flags & kMenuConfirmsEnd)
        m_menuVersion = frame.version;
}

void SimulatedBoard::updateMenu()
{
    if (m_menuVersion != 0 && !isBusy())
        sendEnd(CommandId::ExecuteMenu, std::exchange(m_menuVersion, 0), 0);
}

int SimulatedBoard::runMenu(int action)
{
    const bool isKnown
        = std::any_of(std::begin(kMenuActions), std::end(kMenuActions), [&](const Choice &choice) {
              return choice.value == action && m_options.firmware >= choice.since;
          });
    if (!isKnown)
        return kWrongParameters;
    for (const MenuEntry &entry : menuEntries()) {
        if (action >= entry.first && action < entry.first + entry.count)
            return (this->*entry.run)(entry.argument + action - entry.first);
    }
    return kNotSupported;
}

int SimulatedBoard::doNothing(int /*argument*/)
{
    return 0;
}

int SimulatedBoard::useProfile(int profile)
{
    loadProfile(profile);
    return 0;
}

int SimulatedBoard::swapSticks(int axis)
{
    const QString other = u"rc.map."_s + QLatin1String(axisKey(kAxes[std::size_t(axis)]));
    const int before = inUse(other);
    store(other, m_active, inUse(u"rc.map.roll"_s));
    store(u"rc.map.roll"_s, m_active, before);
    return 0;
}

int SimulatedBoard::invertStick(int axis)
{
    const QString key = u"rc.%1.inverted"_s.arg(QLatin1String(axisKey(kAxes[std::size_t(axis)])));
    store(key, m_active, !inUse(key));
    return 0;
}

// Where the sticks stand becomes their middle.
int SimulatedBoard::trimSticks(int /*argument*/)
{
    bool hasSignal = false;
    for (const Axis axis : kAxes) {
        const QString name = QLatin1String(axisKey(axis));
        const auto stick = rcInput(name);
        hasSignal |= stick.has_value();
        if (stick)
            store(u"rc.%1.trim"_s.arg(name), m_active,
                  std::clamp(-int(std::lround(*stick * kTrimPerSignal)), -127, 127));
    }
    return hasSignal ? 0 : kWrongState;
}

int SimulatedBoard::calibrateSensor(int which)
{
    if (isBusy() || (m_imu == kFrameImu && !isFrameSensor()))
        return kWrongState;
    beginCalibration(which & 1 ? CommandId::CalibGyro : CommandId::CalibAcc, m_imu,
                     which & 2 ? kTemperature : kOnce, m_lastVersion);
    return 0;
}

int SimulatedBoard::calibrateNorth(int /*argument*/)
{
    if (!isFitted("magnetometer"))
        return kNotSupported;
    if (isBusy())
        return kWrongState;
    startMagCalibration(Frame(number(CommandId::CalibMag), {}, m_lastVersion));
    return 0;
}

int SimulatedBoard::resetEstimate(int /*argument*/)
{
    m_stabilizer.resetEstimate();
    return 0;
}

int SimulatedBoard::announceReset(int /*argument*/)
{
    send(CommandId::Reset, {}, m_lastVersion);
    restart(kResetNotice);
    return 0;
}

int SimulatedBoard::takeAnglesByHand(int isStored)
{
    if (isBusy())
        return kWrongState;
    m_modes.byHandUntil = m_now + kByHandTime;
    m_modes.isByHandStored = isStored != 0;
    m_modes.motorsWereOn = m_stabilizer.motorsOn();
    stopMotors();
    return 0;
}

int SimulatedBoard::switchMotors(int how)
{
    if (how == SwitchOn || (how == SwitchOver && !m_stabilizer.motorsOn())) {
        m_modes.safeStopLeft = 0;
        m_stabilizer.setMotorsOn(!m_emergency);
        return 0;
    }
    stopMotors();
    return 0;
}

int SimulatedBoard::switchMotorsSafely(int how)
{
    if (how == SwitchOver && !m_stabilizer.motorsOn())
        return switchMotors(SwitchOn);
    m_autoPid.reset();
    stopSteering();
    if (m_frequencyTest.axis >= 0)
        endFrequencyTest(kWrongState);
    if (m_stabilizer.motorsOn())
        m_modes.safeStopLeft = kSafeStopTime;
    return 0;
}

void SimulatedBoard::stopMotors()
{
    m_modes.safeStopLeft = 0;
    m_stabilizer.setMotorsOn(m_options.faults.runsOn && m_stabilizer.motorsOn());
}

/// What a safe stop leaves of the motors' power: the camera sinks instead of falling.
double SimulatedBoard::powerLeft() const
{
    return m_modes.safeStopLeft > 0 ? m_modes.safeStopLeft / kSafeStopTime : 1.0;
}

int SimulatedBoard::turnFrameOver(int /*argument*/)
{
    store(u"board.flags1"_s, m_active, inUse(u"board.flags1"_s) ^ kFrameInverted);
    return 0;
}

int SimulatedBoard::tuneAll(int /*argument*/)
{
    if (isBusy())
        return kWrongState;
    startAutoPid(CommandId::AutoPid, kAllAxes | AutoPidKeepCurrent, 0,
                 {kMiddleStability, kMiddleStability, kMiddleStability});
    return 0;
}

int SimulatedBoard::lookDown(int /*argument*/)
{
    m_stabilizer.setTarget(Axis::Pitch, kLookDown);
    return 0;
}

int SimulatedBoard::goHome(int /*argument*/)
{
    m_modes.isRetracted = false;
    for (const Axis axis : kAxes)
        m_stabilizer.setTarget(axis, m_home[std::size_t(axis)]);
    return 0;
}

int SimulatedBoard::takeHome(int /*argument*/)
{
    for (const Axis axis : kAxes)
        m_home[std::size_t(axis)] = m_stabilizer.estimate(axis);
    return 0;
}

int SimulatedBoard::level(int axes)
{
    for (const Axis axis : kAxes) {
        if (axes & axisBit(axis))
            m_stabilizer.setTarget(axis, 0.0);
    }
    return 0;
}

int SimulatedBoard::centerMotors(int axes)
{
    m_modes.isRetracted = false;
    for (const Axis axis : kAxes) {
        if (axes & axisBit(axis))
            m_stabilizer.setTarget(axis, m_stabilizer.hand().angle(axis));
    }
    return 0;
}

int SimulatedBoard::untwist(int /*argument*/)
{
    const double target = m_stabilizer.target(Axis::Yaw);
    const double turns = std::round((target - m_stabilizer.hand().angle(Axis::Yaw)) / 360.0);
    m_stabilizer.setTarget(Axis::Yaw, target - 360.0 * turns);
    return 0;
}

int SimulatedBoard::retract(int /*argument*/)
{
    m_modes.isRetracted = true;
    for (const Axis axis : kAxes)
        m_stabilizer.setTarget(axis,
                               m_stabilizer.hand().angle(axis)
                                   + axisValue("motion.%a.retracted", axis) * kDegreesPerCount);
    return 0;
}

int SimulatedBoard::turnYaw(int isFromFrame)
{
    const double from = isFromFrame ? m_stabilizer.hand().angle(Axis::Yaw) : m_stabilizer.target(Axis::Yaw);
    m_stabilizer.setTarget(Axis::Yaw, from + 180.0);
    return 0;
}

// Forward and backward in turn.
int SimulatedBoard::switchYaw(int /*argument*/)
{
    const double forward = m_stabilizer.hand().angle(Axis::Yaw);
    const bool isForward = std::abs(m_stabilizer.target(Axis::Yaw) - forward) < 90.0;
    m_stabilizer.setTarget(Axis::Yaw, forward + (isForward ? 180.0 : 0.0));
    return 0;
}

int SimulatedBoard::switchRoll(int /*argument*/)
{
    m_stabilizer.setTarget(Axis::Roll, std::abs(m_stabilizer.target(Axis::Roll)) < 45.0 ? 90.0 : 0.0);
    return 0;
}

int SimulatedBoard::pressButton(int /*argument*/)
{
    tellEvent(MenuButtonEvent, EventOn);
    const int action = inUse(u"service.button.press1"_s);
    return action == kButtonPressed ? kWrongParameters : runMenu(action);
}

int SimulatedBoard::triggerCamera(int type)
{
    tellEvent(CameraEvent, type);
    return 0;
}

int SimulatedBoard::startScript(int slot)
{
    if (m_files.value(kScriptFile + (slot << 8)).isEmpty())
        return kWrongParameters;
    runScript(slot, false, m_lastVersion);
    return 0;
}

int SimulatedBoard::stopScript(int /*argument*/)
{
    m_script = {};
    return 0;
}

int SimulatedBoard::forceFollow(int /*argument*/)
{
    m_modes.follow = m_modes.follow == Follow::Forced ? Follow::AsSet : Follow::Forced;
    return 0;
}

int SimulatedBoard::disableFollow(int /*argument*/)
{
    m_modes.follow = m_modes.follow == Follow::Off ? Follow::AsSet : Follow::Off;
    return 0;
}

bool SimulatedBoard::follows(Axis axis) const
{
    return axis == Axis::Yaw && m_modes.follow != Follow::Off
        && (m_modes.follow == Follow::Forced || value(u"rc.yaw.follow"_s) != 0.0);
}

int SimulatedBoard::setTripod(int how)
{
    m_modes.isTripod = how == SwitchOn;
    return 0;
}

int SimulatedBoard::setShake(int how)
{
    m_modes.isShaking = how == SwitchOn;
    return 0;
}

int SimulatedBoard::setServoMode(int how)
{
    m_modes.isServo = how == SwitchOver ? !m_modes.isServo : how == SwitchOn;
    return 0;
}

/// SYSTEM_STATE_FLAGS (errata 4.4).
quint32 SimulatedBoard::systemState() const
{
    const auto bit = [](bool isSet, int place) { return isSet ? 1U << place : 0U; };
    return bit(inUse(u"board.flags1"_s) & kFrameInverted, 1) | bit(true, 4) | bit(m_modes.isShaking, 8)
        | bit(m_modes.isServo, 9) | bit(follows(Axis::Yaw), 12) | bit(m_modes.isTripod, 13)
        | bit(m_modes.isRetracted, 14);
}

void SimulatedBoard::updateModes()
{
    if (m_modes.safeStopLeft > 0) {
        m_modes.safeStopLeft -= Stabilizer::kCycle;
        if (m_modes.safeStopLeft <= 0)
            stopMotors();
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const Axis axis = kAxes[i];
        const double frame = m_stabilizer.hand().angle(axis);
        const double moved = frame - std::exchange(m_modes.frame[i], frame);
        const double phase = 2.0 * std::numbers::pi * m_now * value(u"shake.frequency"_s);
        const double shake
            = m_modes.isShaking ? kShakeUnit * axisValue("shake.%a.amplitude", axis) * std::sin(phase) : 0.0;
        const double shaken = shake - std::exchange(m_modes.shake[i], shake);
        m_stabilizer.setTarget(axis, m_stabilizer.target(axis) + shaken + (m_modes.isServo ? moved : 0.0));
    }
    if (m_modes.byHandUntil < 0 || m_now < m_modes.byHandUntil)
        return;
    m_modes.byHandUntil = -1;
    for (const Axis axis : kAxes) {
        const double angle = m_stabilizer.estimate(axis);
        m_stabilizer.setTarget(axis, angle);
        if (!m_modes.isByHandStored)
            continue;
        const QString key = u"rc.%1.memory"_s.arg(QLatin1String(axisKey(axis)));
        store(key, m_active, int(spec(key)->clamped(spec(key)->toRaw(angle))));
    }
    if (m_modes.motorsWereOn)
        switchMotors(SwitchOn);
}

/// Tells those who have asked for it: EVENT comes as a stream (errata 3.10 and 3.20).
void SimulatedBoard::tellEvent(Event event, int type)
{
    for (const Stream &stream : m_streams) {
        if (stream.request.command == number(CommandId::Event) && quint8(stream.request.config[0]) == event
            && quint8(stream.request.config[1]) & type)
            send(CommandId::Event, ByteWriter().u8(event).u8(type).zeros(2).take(), stream.version);
    }
}

void SimulatedBoard::tellChanges()
{
    const std::array<bool, 4> now{m_stabilizer.motorsOn(), m_emergency, m_script.slot >= 0,
                                  m_modes.isRetracted};
    constexpr std::array<Event, 4> kEvents{MotorEvent, EmergencyEvent, ScriptEvent, RetractedEvent};
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (std::exchange(m_told[i], now[i]) != now[i])
            tellEvent(kEvents[i], now[i] ? EventOn : EventOff);
    }
}

}  // namespace simplebgc
