// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated board does with what is mounted: motors that it measures, pins, what it counts (errata
// 3.19, 3.20 and 3.23).
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kMotorCalibrationTime = 8;  // seconds
constexpr double kPolesTime = 3;  // of each motor
constexpr double kTurn = 15;  // degrees to either side
constexpr double kTurnPeriod = 2;
constexpr int kInputPins = 5;  // the numbers of the pulse inputs are those of their pins
constexpr double kLinkPerTorque = 0.01;
constexpr double kFieldTurn = 40;  // degrees
constexpr double kFieldSpeed = 100 * kGyroUnit;
constexpr double kLongestTurn = 60;  // seconds
constexpr double kOffsetTime = 2.5;
constexpr double kGainTime = 5;
constexpr double kAtRest = 20;  // degrees that a hand may sway
constexpr double kTilted = 1;  // degrees, from one end to the other

}  // namespace

bool SimulatedBoard::handleMotors(const Frame &frame)
{
    ByteReader reader(frame.payload);
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::CalibMotorMagLink:
        if (m_options.firmware < kBlocks[ParamsExt2].since)
            return false;
        startMotorCalibration(frame, kMotorCalibrationTime);
        return true;
    case CommandId::CalibPoles: startPoleCalibration(frame); return true;
    case CommandId::EncodersCalibOffset:
    case CommandId::EncodersCalibFldOffset:
        // Firmware without encoders is another one, and does not know them.
        if (!isFitted("encoders") || m_options.firmware < kLater)
            return false;
        startEncoderCalibration(frame);
        return true;
    case CommandId::CalibExtGain: startGainCalibration(frame); return true;
    case CommandId::CalibCogging:
        if (m_options.firmware < kLater)
            return false;
        startRippleCalibration(frame);
        return true;
    case CommandId::CalibMag:
        if (isFitted("magnetometer"))
            startMagCalibration(frame);
        else
            refuse(frame, kNotSupported);
        return true;
    case CommandId::TriggerPin: {
        if (!hasSize(frame, 2))
            return true;
        const int pin = reader.u8();
        // Only if it really happened (document TRIGGER_PIN): an input is not set.
        for (const char *input : kSignalKeys) {
            if (pin <= kInputPins && int(value(QLatin1String(input))) == pin)
                return true;
        }
        confirm(frame);  // nothing is connected to it
        return true;
    }
    case CommandId::ReadStateVars: {
        if (m_options.firmware < kLater)
            return false;
        ByteWriter writer;
        writer.zeros(6)
            .u8(m_emergency ? m_emergencyCause : 0)
            .u8(16)
            .u32(quint32(m_now - m_countedFrom))
            .u16(m_starts);
        writer.u16(int(std::lround(1000 * m_mostCurrent)))
            .i8(20)
            .i8(celsius(31))
            .i8(20)
            .i8(celsius(31))
            .zeros(4);
        const double average = m_stabilizer.current();
        writer.u32(quint32(m_now)).f32(float(average * volts() * m_now / 3600));
        reply(frame, CommandId::ReadStateVars,
              writer.u32(quint32(m_now)).f32(float(average)).zeros(152).take());
        return true;
    }
    case CommandId::WriteStateVars:
        if (m_options.firmware < kLater)
            return false;
        if (hasSize(frame, 192)) {
            reader.skip(8);
            m_countedFrom = m_now - reader.u32();
            m_starts = reader.u16();
            m_mostCurrent = reader.u16() / 1000.0;
            confirm(frame);
        }
        return true;
    case CommandId::AdjVarsInfo: {
        if (m_options.firmware < 2700)
            return false;
        const auto all = adjustablesOf(m_options.firmware);
        ByteWriter writer;
        writer.u8(int(all.size()));
        for (std::size_t i = reader.remaining() > 0 ? reader.u8() : 0; i < all.size(); ++i) {
            const QByteArray name = QByteArray(all[i].key).toUpper().left(16);
            ByteWriter entry;
            entry.u8(all[i].id).u8(int(name.size())).bytes(name).i16(int(all[i].min)).i16(int(all[i].max));
            const QByteArray bytes = entry.i32(adjVar(all[i].id).value_or(0)).take();
            if (writer.size() + bytes.size() > 255)
                break;
            writer.bytes(bytes);
        }
        reply(frame, CommandId::AdjVarsInfo, writer.take());
        return true;
    }
    case CommandId::SetAdjVarsValF: {
        if (m_options.firmware < 2734)
            return false;
        const int count = reader.u8();
        bool isKnown = reader.remaining() == std::size_t(count) * 5;
        for (int i = 0; isKnown && i < count; ++i) {
            const int id = reader.u8();
            isKnown = setAdjVar(id, qint32(std::lround(reader.f32())));
        }
        applyParameters();
        if (isKnown)
            confirm(frame);
        else
            refuse(frame, kWrongParameters);
        return true;
    }
    case CommandId::GetAdjVarsValF: {
        if (m_options.firmware < 2734)
            return false;
        const int count = reader.u8();
        if (count < 1 || count > kAdjVarsPerCommand || reader.remaining() != std::size_t(count)) {
            refuse(frame, kWrongSize);
            return true;
        }
        ByteWriter writer;
        writer.u8(count);
        for (int i = 0; i < count; ++i) {
            const int id = reader.u8();
            writer.u8(id).f32(float(adjVar(id).value_or(0)));
        }
        reply(frame, CommandId::SetAdjVarsValF, writer.take());
        return true;
    }
    default: return false;
    }
}

bool SimulatedBoard::isBusy() const
{
    return m_calibration.left > 0 || m_autoPid || m_frequencyTest.axis >= 0 || m_motorCalibration.until > 0
        || m_magCalibration.until > 0 || m_modes.byHandUntil > 0 || m_modes.safeStopLeft > 0;
}

bool SimulatedBoard::isStepping() const
{
    return m_motorCalibration.until > 0 && m_motorCalibration.command != CommandId::EncodersCalibOffset
        && m_motorCalibration.command != CommandId::CalibExtGain;
}

// Confirmed at reception; the end is told by another confirmation.
bool SimulatedBoard::startMotorCalibration(const Frame &frame, double seconds)
{
    if (isBusy()) {
        refuse(frame, kWrongState);
        return false;
    }
    m_motorCalibration = {};
    m_motorCalibration.command = static_cast<CommandId>(frame.id);
    m_motorCalibration.until = m_now + seconds;
    m_motorCalibration.version = frame.version;
    m_motorCalibration.motorsWereOn = m_stabilizer.motorsOn();
    m_motorCalibration.seconds = seconds;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_motorCalibration.from[i] = m_stabilizer.plant(kAxes[i]).angle();
    if (isStepping())
        m_stabilizer.setMotorsOn(false);  // they are stepped, not controlled
    confirm(frame);
    return true;
}

// One motor after the other; an axis without an output is left out.
void SimulatedBoard::startPoleCalibration(const Frame &frame)
{
    const auto motors
        = std::ranges::count_if(kAxes, [this](Axis axis) { return axisValue("motor.%a.output", axis) != 0; });
    startMotorCalibration(frame, kPolesTime * double(std::max<std::ptrdiff_t>(1, motors)));
}

// What is held fast, or has too little power for its friction and what is out of balance, stays.
bool SimulatedBoard::turnsMotor(Axis axis)
{
    const Axis motor = m_stabilizer.motorOf(axis);
    const AxisPlant &plant = m_stabilizer.plant(motor);
    const AxisMechanics &mechanics = plant.mechanics();
    const double torque
        = mechanics.fullTorque * plant.motorStrength() * axisValue("motor.%a.power", axis) / 255;
    return m_options.faults.blocked != int(motor) + 1 && axisValue("motor.%a.output", axis) != 0
        && torque > mechanics.coulomb + mechanics.cogging
            + std::abs(m_options.faults.imbalance / 100 * mechanics.imbalance);
}

// Each in its turn to and fro, the others free.
void SimulatedBoard::turnForPoles()
{
    const double gone = m_motorCalibration.seconds - (m_motorCalibration.until - m_now);
    auto left = int(gone / kPolesTime);
    for (const Axis axis : kAxes) {
        if (axisValue("motor.%a.output", axis) == 0 || left-- != 0 || !turnsMotor(axis))
            continue;
        // Twice, from rest to rest.
        constexpr double kSpeed = 4 * std::numbers::pi / kPolesTime;
        m_stabilizer.plant(m_stabilizer.motorOf(axis))
            .setMotion(kTurn / 2 * (1 - std::cos(kSpeed * gone)),
                       kTurn / 2 * kSpeed * std::sin(kSpeed * gone));
    }
}

// Which axes, how far and how fast: what is not given is 40 degrees at 6 degrees per second (errata 3.19).
void SimulatedBoard::startEncoderCalibration(const Frame &frame)
{
    const bool isField = frame.id == number(CommandId::EncodersCalibFldOffset);
    const qsizetype size = frame.payload.size();
    const bool isKnown = isField ? size == 0 || size == 6 || size == 12 || size == 14 : size <= 1;
    if (!isKnown) {
        refuse(frame, kWrongSize);
        return;
    }
    ByteReader reader(frame.payload);
    const int wanted = !isField && size == 1 ? reader.u8() : kAllMotors;
    std::array<bool, kAxisCount> axes{};
    std::array<double, kAxisCount> turn{};
    std::array<double, kAxisCount> speed{};
    double longest = 0;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        turn[i] = isField && size >= 6 ? reader.i16() * kDegreesPerCount : 0;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        speed[i] = isField && size >= 12 ? std::abs(reader.i16()) * kGyroUnit : 0;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        axes[i] = (wanted == kAllMotors || wanted == int(i)) && axisValue("encoder.%a.type", kAxes[i]) != 0;
        turn[i] = turn[i] == 0 ? kFieldTurn : turn[i];
        speed[i] = speed[i] == 0 ? kFieldSpeed : speed[i];
        if (axes[i])
            longest = std::max(longest, 2 * std::abs(turn[i]) / speed[i]);
    }
    if ((wanted != kAllMotors && wanted >= int(kAxisCount)) || longest > kLongestTurn) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (std::none_of(axes.begin(), axes.end(), [](bool is) { return is; })) {
        refuse(frame, kWrongState);  // no axis has an encoder
        return;
    }
    if (!startMotorCalibration(frame, isField ? longest + 1 : kOffsetTime))
        return;
    m_motorCalibration.axes = axes;
    m_motorCalibration.turn = turn;
    constexpr int kTrustAnything = 3;  // neither the motion sensor nor the encoder has to see it turn
    m_motorCalibration.trustsAnything
        = isField && size == 14 && (reader.u16() & kTrustAnything) == kTrustAnything;
}

void SimulatedBoard::startGainCalibration(const Frame &frame)
{
    if (!hasSize(frame, 0))
        return;
    if (!signal(int(value(u"fc.map.roll"_s))) && !signal(int(value(u"fc.map.pitch"_s))))
        refuse(frame, kWrongState);  // no flight controller gives a signal
    else
        startMotorCalibration(frame, kGainTime);
}

int SimulatedBoard::calibrationMode() const
{
    if (m_calibration.left > 0 && m_calibration.command == CommandId::CalibAccExtRef)
        return 23;
    if (m_calibration.left > 0) {
        const bool isAcc = m_calibration.command == CommandId::CalibAcc;
        return m_calibration.action == 3 ? (isAcc ? 11 : 10) : isAcc ? 4 : 5;
    }
    if (m_modes.byHandUntil > 0)
        return m_modes.isByHandStored ? 2 : 13;
    if (m_modes.safeStopLeft > 0)
        return 24;
    if (m_autoPid)
        return 8;
    if (m_frequencyTest.axis >= 0)
        return 9;
    if (m_magCalibration.until > 0)
        return 12;
    if (m_motorCalibration.until <= 0)
        return 0;
    switch (m_motorCalibration.command) {
    case CommandId::CalibExtGain: return 1;
    case CommandId::CalibPoles: return 3;
    case CommandId::EncodersCalibOffset: return 6;
    case CommandId::EncodersCalibFldOffset: return 7;
    case CommandId::CalibCogging: return 22;
    default: return 15;
    }
}

// It turns the motors to and fro, or watches, and at the end knows what they are.
void SimulatedBoard::updateMotorCalibration()
{
    if (m_motorCalibration.until < 0)
        return;
    const bool isCutShort
        = m_options.faults.failWith != 0 && m_now > m_motorCalibration.until - m_motorCalibration.seconds / 2;
    if (m_now < m_motorCalibration.until && !isCutShort) {
        turnMotors();
        return;
    }
    const int refusal = isCutShort ? m_options.faults.failWith : finishMotorCalibration();
    if (isStepping()) {
        m_stabilizer.resetEstimate();
        m_stabilizer.setMotorsOn(m_motorCalibration.motorsWereOn && !m_emergency);
    }
    sendEnd(m_motorCalibration.command, m_motorCalibration.version, refusal);
    m_motorCalibration = {};
}

void SimulatedBoard::turnMotors()
{
    switch (m_motorCalibration.command) {
    case CommandId::EncodersCalibOffset: watchEncoders(); return;
    case CommandId::CalibExtGain: watchSignals(); return;
    case CommandId::EncodersCalibFldOffset: break;
    case CommandId::CalibPoles: turnForPoles(); return;
    default:
        const double phase = (m_motorCalibration.until - m_now) / kTurnPeriod * 2 * std::numbers::pi;
        for (const Axis axis : kAxes)
            m_stabilizer.plant(axis).setAngle(kTurn * std::sin(phase));
        return;
    }
    // There and back at one speed; what is held fast, or has no power, stays.
    const double done = 1 - (m_motorCalibration.until - m_now) / m_motorCalibration.seconds;
    const double share = 1 - std::abs(2 * done - 1);
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        AxisPlant &plant = m_stabilizer.plant(kAxes[i]);
        const bool turns = m_motorCalibration.axes[i] && m_options.faults.blocked != int(i) + 1
            && axisValue("motor.%a.power", kAxes[i]) > 0 && axisValue("motor.%a.output", kAxes[i]) != 0;
        const double angle = turns ? m_motorCalibration.turn[i] * share : 0;
        plant.setAngle(m_motorCalibration.from[i] + angle);
        m_motorCalibration.turned[i] = std::max(m_motorCalibration.turned[i], std::abs(angle));
    }
}

void SimulatedBoard::watchEncoders()
{
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const double reading = encoderReading(kAxes[i]);
        const bool isFirst = m_motorCalibration.samples == 0;
        m_motorCalibration.low[i] = isFirst ? reading : std::min(m_motorCalibration.low[i], reading);
        m_motorCalibration.high[i] = isFirst ? reading : std::max(m_motorCalibration.high[i], reading);
        m_motorCalibration.sums[i] += reading;
    }
    ++m_motorCalibration.samples;
}

// The frame is tilted by hand meanwhile: its angle over the signal is the gain.
void SimulatedBoard::watchSignals()
{
    for (std::size_t i = 0; i < 2; ++i) {
        const double told = signal(int(axisValue("fc.map.%a", kAxes[i]))).value_or(0);
        const double angle = m_stabilizer.hand().angle(kAxes[i]);
        m_motorCalibration.low[i] = std::min(m_motorCalibration.low[i], angle);
        m_motorCalibration.high[i] = std::max(m_motorCalibration.high[i], angle);
        m_motorCalibration.sums[2 * i] += told * told;
        m_motorCalibration.sums[2 * i + 1] += told * angle;
    }
}

/// The code with which it fails, 0 = none.
int SimulatedBoard::finishMotorCalibration()
{
    switch (m_motorCalibration.command) {
    case CommandId::CalibExtGain: return storeGains();
    case CommandId::EncodersCalibOffset:
    case CommandId::EncodersCalibFldOffset:
        if (const int code = encoderFailure(); code != 0)
            return code;
        storeEncoders();
        return 0;
    case CommandId::CalibPoles: return storePoles();
    case CommandId::CalibCogging: storeRipple(); return 0;
    default: storeMotors(); return 0;
    }
}

/// The code with which it fails, 0 = none: it knows those motors whose own axis turned.
int SimulatedBoard::storePoles()
{
    bool isFound = true;
    for (const Axis axis : kAxes) {
        if (axisValue("motor.%a.output", axis) == 0)
            continue;
        if (!turnsMotor(axis) || m_stabilizer.motorOf(axis) != axis) {
            isFound = false;
            continue;
        }
        const QString name = QLatin1String(axisKey(axis));
        store(u"motor.%1.poles"_s.arg(name), 0, m_stabilizer.plant(axis).mechanics().poles);
        store(u"motor.%1.invert"_s.arg(name), 0, 0);
    }
    return isFound ? 0 : kOperationFailed;
}

void SimulatedBoard::storeMotors()
{
    for (const Axis axis : kAxes) {
        const QString name = QLatin1String(axisKey(axis));
        if (const ParameterSpec *link = spec(u"motor.%1.magnetic_link"_s.arg(name))) {
            store(link->key, 0,
                  int(link->toRaw(kLinkPerTorque * m_stabilizer.plant(axis).mechanics().fullTorque)));
        }
    }
}

// An encoder of another type is not read; offsets need a camera at rest, and fields motors that turn as told.
int SimulatedBoard::encoderFailure() const
{
    const MotorCalibration &run = m_motorCalibration;
    const bool isField = run.command == CommandId::EncodersCalibFldOffset;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (!run.axes[i])
            continue;
        const bool hasTurned = run.turned[i] > std::abs(run.turn[i]) / 2
            && !(m_options.faults.swappedAxes && kAxes[i] != Axis::Yaw);
        if (!isRead(kAxes[i]) || (!isField && run.high[i] - run.low[i] > kAtRest)
            || (isField && !hasTurned && !run.trustsAnything))
            return kOperationFailed;
    }
    return 0;
}

/// The code with which it fails, 0 = none: only a frame that moves shows the gain.
int SimulatedBoard::storeGains()
{
    int found = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        if (m_motorCalibration.high[i] - m_motorCalibration.low[i] < kTilted
            || m_motorCalibration.sums[2 * i] <= 0)
            continue;
        const double gain = m_motorCalibration.sums[2 * i + 1] / m_motorCalibration.sums[2 * i];
        store(u"fc.gain.%1"_s.arg(QLatin1String(axisKey(kAxes[i]))), 0,
              int(std::clamp(std::round(gain), -127.0, 127.0)));
        ++found;
    }
    return found > 0 ? 0 : kOperationFailed;
}

}  // namespace simplebgc
