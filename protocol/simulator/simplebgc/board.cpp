// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/simplebgc/board.h"

#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kAboveYaw = 2;  // where its frame sensor sits (errata 3.4, FRAME_IMU_POS)
constexpr double kBootTime = 1.2;  // seconds until the firmware listens again
constexpr qsizetype kInputBuffer = 256;  // errata 7: a whole message is lost when it is full
constexpr double kCommandTime = 0.0015;  // errata 7: 1-10 ms to an answer
constexpr double kNominalVoltage = 12.3;
constexpr double kStillEnough = 8.0;  // deg/s peak to peak that still counts as standing still
constexpr double kCalibrationBlocks = 0.5;  // seconds
constexpr double kLongestCalibration = 12.0;  // seconds, then it ends without having changed anything
constexpr double kMissedSteps = 30.0;  // degrees of error

SimulatorOptions complete(SimulatorOptions options)
{
    if (options.firmware == 0)
        options.firmware = 2590;
    return options;
}

Capabilities equipmentOf(const SimulatorOptions &options)
{
    Capabilities all{u"yaw-axis"_s, u"battery"_s, u"current"_s};
    if (options.own.value(u"encoders"_s) != 0)
        all.insert(u"encoders"_s);
    return all;
}

}  // namespace

SimulatedBoard::SimulatedBoard(const SimulatorOptions &options)
    : m_options(complete(options))
    , m_parameters(parameterRows(), kBlocks, m_options.firmware, equipmentOf(m_options))
    , m_stabilizer(options.seed)
    , m_names({u"Handheld"_s, u"Studio"_s, u"Vehicle"_s, QString(), QString()})
    , m_receiver(options.seed * 2 + 5)
    , m_sensorNoise(options.seed * 2 + 3)
{
    m_restOfMemory.fill('\xFF', kMemorySize);
    m_external.fill('\0', 128);
    for (int profile = 0; profile < kProfileCount; ++profile)
        loadDefaults(profile);
    // Different profiles, like those of a board in use.
    store(u"pid.roll.p"_s, 1, int(spec(u"pid.roll.p"_s)->toRaw(45)));
    store(u"pid.yaw.p"_s, 1, int(spec(u"pid.yaw.p"_s)->toRaw(50)));
    store(u"follow.yaw.speed"_s, 1, 25);
    store(u"imu.gyro_trust"_s, 2, 190);
    if (m_options.own.contains(u"condition"_s))
        unpack();
    fitSensors();
    boot();
}

SimulatedBoard::~SimulatedBoard() = default;

void SimulatedBoard::loadDefaults(int profile)
{
    Block &blocks = m_eeprom[std::size_t(profile)];
    for (const BlockSpec &block : kBlocks) {
        // Reserved bytes are not zero on a real board, and must survive a write.
        QByteArray bytes(block.size, '\0');
        for (int i = 0; i < block.size; ++i)
            bytes[i] = static_cast<char>((i * 7 + block.id) & 0x3F);
        if (block.id != AdjVarsCfg)
            bytes[0] = static_cast<char>(profile);
        blocks[block.id] = bytes;
    }
    for (const ParameterSpec &spec : m_parameters.all()) {
        if (!spec.row->state || spec.row->bitCount)
            spec.write(blocks[spec.row->block], spec.defaultRaw);
    }
    for (const auto block : {Params3, ParamsExt, ParamsExt2, ParamsExt3})
        blocks[block][0] = static_cast<char>(profile);
    // The simulated sensor is calibrated on command, not at every start.
    if (const ParameterSpec *skip = spec(u"imu.skip_gyro_calibration"_s))
        skip->write(blocks[Params3], 1);
    if (isFitted("frame-imu"))
        spec(u"imu.frame.position"_s)->write(blocks[Params3], kAboveYaw);
}

// As it comes out of its box: motors that nobody has told of, one of them the wrong way round, a sensor that
// is told to sit as on the manufacturer's own gimbal (errata 3.4), gains and powers that suit no camera in
// particular, thresholds of another battery, sticks that are swapped and one that is the wrong way round. The
// camera is large for its motors.
void SimulatedBoard::unpack()
{
    m_ram = m_eeprom[std::size_t(m_active)];
    for (int profile = 0; profile < kProfileCount; ++profile) {
        for (const Axis axis : kAxes) {
            const QString name = QLatin1String(axisKey(axis));
            for (const auto &[gain, value] : {std::pair(u"p"_s, 12.0), {u"i"_s, 0.05}, {u"d"_s, 12.0}}) {
                const ParameterSpec *parameter = spec(u"pid.%1.%2"_s.arg(name, gain));
                store(parameter->key, profile, int(parameter->clamped(parameter->toRaw(value))));
            }
        }
    }
    constexpr std::array kStrengths{0.25, 0.2, 0.25};
    constexpr std::array kPowers{20, 230, 150};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const QString name = QLatin1String(axisKey(kAxes[i]));
        m_stabilizer.plant(kAxes[i]).setMotorStrength(kStrengths[i]);
        store(u"motor.%1.poles"_s.arg(name), 0, 22);
        for (int profile = 0; profile < kProfileCount; ++profile)
            store(u"motor.%1.power"_s.arg(name), profile, kPowers[i]);
    }
    store(u"motor.pitch.invert"_s, 0, 1);
    store(u"imu.main.axis_top"_s, 0, -1);
    store(u"imu.main.axis_right"_s, 0, 3);
    store(u"rc.map.roll"_s, 0, 2);
    store(u"rc.map.pitch"_s, 0, 1);
    store(u"rc.yaw.inverted"_s, 0, 1);
    store(u"battery.alarm"_s, 0, 1400);
    store(u"battery.motors_off"_s, 0, -1200);
}

void SimulatedBoard::boot()
{
    m_imu = 1;
    m_streams.clear();
    m_commands.clear();
    m_replies.clear();
    m_queuedBytes = 0;
    m_calibration = {};
    m_autoPid.reset();
    m_emergency = false;
    m_emergencyCause = 9;
    m_magCalibration = {};
    m_initialized.clear();
    m_otherVars = {{37, 0}, {38, 0}};
    if (!spec(u"pid.roll.gain"_s))
        m_otherVars.insert({{42, 45}, {43, 45}, {44, 45}});
    loadProfile(m_active);
    m_stabilizer.imu().gyroNoise = 0.06;
    m_stabilizer.setHeld(false);
    for (const Axis axis : kAxes)
        m_stabilizer.plant(axis).setAngle(0.0);
    m_stabilizer.resetEstimate();
    m_control = {};
    m_modes = {};
    forget();
    m_signals = {};
    m_script = {};
    m_isWriteSet = false;
    m_writtenProfile.reset();
    m_menuVersion = 0;
    m_motorCalibration = {};
    m_bootLoaderAt = -1;
    m_frameToldUntil = -1;
    m_sensorRegisters.clear();
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_stabilizer.imu().gyroCorrection[i] -= std::exchange(m_gyroTold[i], 0.0);
    bootCalibrations();
    ++m_starts;
    for (const Axis axis : kAxes)
        m_stabilizer.setTarget(axis, 0.0);
    bootSensors();
    m_stabilizer.setMotorsOn(!m_emergency);
}

void SimulatedBoard::loadProfile(int profile)
{
    m_active = profile;
    m_ram = m_eeprom[std::size_t(profile)];
    applyParameters();
}

int SimulatedBoard::stored(const QString &key, int profile) const
{
    const ParameterSpec *parameter = spec(key);
    return int(parameter->read(m_eeprom[std::size_t(profile)][parameter->row->block]).value());
}

int SimulatedBoard::inUse(const QString &key) const
{
    const ParameterSpec *parameter = spec(key);
    return int(parameter->read(m_ram[parameter->row->block]).value());
}

void SimulatedBoard::store(const QString &key, int profile, int raw)
{
    const ParameterSpec *parameter = spec(key);
    for (int i = 0; i < kProfileCount; ++i) {
        if (i == profile || parameter->row->scope == Scope::Board)
            parameter->write(m_eeprom[std::size_t(i)][parameter->row->block], raw);
    }
    if (profile == m_active || parameter->row->scope == Scope::Board) {
        parameter->write(m_ram[parameter->row->block], raw);
        applyParameters();
    }
}

double SimulatedBoard::value(const QString &key) const
{
    const ParameterSpec *parameter = spec(key);
    return parameter ? parameter->toDisplay(parameter->read(m_ram[parameter->row->block]).value_or(0)) : 0.0;
}

double SimulatedBoard::axisValue(const char *pattern, Axis axis) const
{
    return value(QString::fromLatin1(pattern).replace(u"%a"_s, QLatin1String(axisKey(axis))));
}

void SimulatedBoard::applyParameters()
{
    m_hasFrameSensor = inUse(u"imu.frame.position"_s) != 0;
    for (const Axis axis : kAxes) {
        AxisGains gains;
        gains.p = axisValue("pid.%a.p", axis);
        // I is in hundredths on the linear scale, in the units of P on the logarithmic one.
        gains.i = axisValue("pid.%a.i", axis) * (m_options.firmware >= 2731 ? 1.0 : 100.0);
        gains.d = axisValue("pid.%a.d", axis);
        const QString gain = u"pid.%1.gain"_s.arg(QLatin1String(axisKey(axis)));
        gains.gain = spec(gain) ? value(gain) : 0.1 + 0.02 * m_otherVars.value(42 + int(axis), 45);
        gains.power = axisValue("motor.%a.power", axis) / 255.0;
        gains.inverted = axisValue("motor.%a.invert", axis) != 0.0;
        gains.poles = int(axisValue("motor.%a.poles", axis));
        const int output = int(axisValue("motor.%a.output", axis));
        if (output == 0)
            gains.power = 0.0;
        // Drivers on the bus beyond them are each axis' own.
        m_stabilizer.setOutput(
            axis, output >= 1 && output <= int(kAxisCount) ? kAxes[std::size_t(output - 1)] : axis);
        const int filters = int(axisValue("filter.%a.enabled", axis));
        gains.lpfHz = filters & 8 ? axisValue("filter.%a.lpf", axis) : 0.0;
        gains.dLpfHz = axisValue("filter.%a.d_lpf", axis);
        for (std::size_t n = 0; n < gains.notches.size(); ++n) {
            if (!(filters & (1 << n)))
                continue;
            const QByteArray prefix = "filter.%a.notch" + QByteArray::number(int(n) + 1);
            gains.notches[n] = {axisValue((prefix + ".frequency").constData(), axis),
                                axisValue((prefix + ".width").constData(), axis),
                                axisValue((prefix + ".gain").constData(), axis)};
        }
        m_stabilizer.setGains(axis, gains);
    }
    m_stabilizer.setGyroTrust(value(u"imu.gyro_trust"_s));
    believeAxes();
}

// Board-wide values apply to all profiles: writing one changes the others too.
void SimulatedBoard::shareBoardValues(int from)
{
    for (const ParameterSpec &parameter : m_parameters.all()) {
        if (parameter.row->scope != Scope::Board || parameter.row->state)
            continue;
        const auto raw = parameter.read(m_eeprom[std::size_t(from)][parameter.row->block]);
        for (Block &blocks : m_eeprom)
            parameter.write(blocks[parameter.row->block], raw.value_or(0));
    }
}

void SimulatedBoard::storeAll()
{
    m_eeprom[std::size_t(m_active)] = m_ram;
    shareBoardValues(m_active);
}

void SimulatedBoard::restart(double afterSeconds)
{
    m_restartAt = m_now + afterSeconds;
}

void SimulatedBoard::receive(Bytes bytes)
{
    if (!isRunning())
        return;
    m_framer.feed(bytes, [this](const FrameView &frame) {
        if (frame.version == 2 && m_options.firmware < 2680)
            return;  // '$' frames came with 2.68b0 (errata 1.3)
        if (m_queuedBytes + qsizetype(frame.payload.size()) + 5 > kInputBuffer)
            return;
        m_queuedBytes += qsizetype(frame.payload.size()) + 5;
        m_commands.push_back(Frame(frame));
    });
    m_serialErrors = m_framer.statistics().headerErrors + m_framer.statistics().bodyErrors;
}

void SimulatedBoard::cycle()
{
    m_now += Stabilizer::kCycle;
    if (m_bootLeft > 0) {
        m_bootLeft -= Stabilizer::kCycle;
        if (m_bootLeft <= 0)
            boot();
        return;
    }
    if (m_restartAt >= 0 && m_now >= m_restartAt) {
        m_restartAt = -1;
        m_isInBootLoader = false;
        m_bootLeft = kBootTime;
        m_output.clear();
        return;
    }
    updateFaults();
    if (m_bootLoaderAt >= 0 && m_now >= m_bootLoaderAt) {
        m_bootLoaderAt = -1;
        m_isInBootLoader = true;
        m_stabilizer.setMotorsOn(false);
        m_output.clear();
    }
    if (m_isInBootLoader) {
        m_stabilizer.step();
        return;
    }
    m_receiver.step(m_options.faults, Stabilizer::kCycle);
    updateSlots();
    updateTargets();
    updateModes();
    updateMotorCalibration();
    updateScript();
    updateAutoPid();
    updateFrequencyTest();
    m_stabilizer.step();
    updateSensors();
    updateCalibration();
    tellChanges();
    updateMenu();
    // For the first half second a calibration blocks everything else (errata 7).
    const double lateStreams = m_options.faults.lateStreams;
    const bool silent = m_calibration.left > 0
        && (lateStreams > 0 || m_calibration.total - m_calibration.left < kCalibrationBlocks);
    if (silent)
        m_streamsAt = m_now + lateStreams;
    if (!silent && !m_commands.empty() && m_now >= m_nextCommandAt) {
        const Frame frame = std::move(m_commands.front());
        m_commands.pop_front();
        m_queuedBytes -= frame.payload.size() + 5;
        m_nextCommandAt = m_now + kCommandTime;
        handle(frame);
    }
    while (!m_replies.empty() && m_replies.front().at <= m_now) {
        m_output += m_replies.front().frame;
        m_replies.pop_front();
    }
    if (!silent && m_now >= m_streamsAt)
        sendStreams();
}

QByteArray SimulatedBoard::takeOutput(qsizetype max)
{
    const QByteArray out = m_output.left(max);
    m_output.remove(0, out.size());
    return out;
}

void SimulatedBoard::updateFaults()
{
    const Faults &faults = m_options.faults;
    if (std::exchange(m_resetOnWrite, faults.resetOnWrite) != faults.resetOnWrite)
        m_writesSeen = 0;
    m_stabilizer.setImuPresent(!faults.noImu);
    m_stabilizer.setPose(faults.pose);
    m_stabilizer.setHandOnCamera(handOnCamera());
    m_stabilizer.setSwappedMotors(faults.swappedAxes);
    if (std::exchange(m_mount, faults.mount) != faults.mount)
        believeAxes();
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        m_stabilizer.plant(kAxes[i]).setBlocked(faults.blocked == int(i) + 1);
        m_stabilizer.plant(kAxes[i]).setImbalance(faults.imbalance / 100);
    }
    m_stabilizer.hand().setStrength(isCalibrating() && faults.shake <= 2.0 ? 0.0 : faults.shake);
    const double volts
        = (faults.battery > 0 ? faults.battery : kNominalVoltage) - 0.04 * m_stabilizer.current();
    m_stabilizer.setVoltage(volts * powerLeft());
    m_mostCurrent = std::max(m_mostCurrent, m_stabilizer.current());
    const double motorsOff = value(u"battery.motors_off"_s);
    if (motorsOff > 0 && volts < motorsOff)
        m_stabilizer.setMotorsOn(false);
    if (faults.resetAfter >= 0 && m_now >= faults.resetAfter && m_resetDone != faults.resetAfter) {
        m_resetDone = faults.resetAfter;
        restart(0.0);
    }
    if (faults.otherClient >= 0 && m_now >= faults.otherClient && !m_otherClientDone) {
        m_otherClientDone = true;
        store(u"pid.roll.p"_s, m_active, std::min(255, stored(u"pid.roll.p"_s, m_active) + 10));
    }
    // Emergency stop is an option of the board (GENERAL_FLAGS1 bit 4): an axis far off its target means that
    // its motor works against the controller.
    const bool guarded = int(value(u"board.flags1"_s)) & 16;
    if (guarded && m_stabilizer.motorsOn()) {
        for (const Axis axis : kAxes) {
            if (std::abs(m_stabilizer.target(axis) - m_stabilizer.estimate(axis)) > 3 * kMissedSteps)
                m_emergency = true;
        }
        if (m_emergency)
            m_stabilizer.setMotorsOn(false);
    }
}

void SimulatedBoard::updateTargets()
{
    updateSteering();
    bool arrived = true;
    const bool isByAttitude = m_attitude.mode != 0;
    const auto attitude = isByAttitude ? anglesOf(m_attitude.setpoint) : std::array<double, kAxisCount>{};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const Axis axis = kAxes[i];
        const int mode = m_control[i].mode & 0x0F;
        const double before = m_stabilizer.target(axis);
        double target = before;
        if (isByAttitude) {
            target += std::remainder(attitude[i] - before, 360.0);
        } else if (mode == Speed) {
            target = nextTarget(i, {});
        } else if (mode == Angle || mode == SpeedAngle || mode == AngleRelFrame || mode == Rc
                   || mode == AngleShortest || mode == RcHighRes) {
            const double goal
                = m_destination[i] + (mode == AngleRelFrame ? m_stabilizer.hand().angle(axis) : 0.0);
            target = nextTarget(i, goal);
            arrived &= std::abs(goal - m_stabilizer.estimate(axis)) < 1.0;
        } else if (const auto wanted = rcTarget(axis)) {
            target = *wanted;
        } else if (follows(axis)) {
            const double follow = value(u"follow.yaw.speed"_s) / 60.0;
            target += (m_stabilizer.hand().angle(axis) - target) * follow * Stabilizer::kCycle;
        }
        const bool isSteered = mode != NoControl || isByAttitude;
        m_targetSpeed[i] = isSteered ? (target - before) / Stabilizer::kCycle : 0.0;
        m_stabilizer.setTarget(axis, target);
    }
    if (m_taskRunning && arrived) {
        m_taskRunning = false;
        send(CommandId::Confirm, QByteArray("\x43\x01", 2), m_lastVersion);
    }
}

void SimulatedBoard::updateCalibration()
{
    Calibration &calibration = m_calibration;
    if (calibration.left <= 0)
        return;
    SimulatedImu &imu = m_stabilizer.imu();
    const bool gyro = calibration.command == CommandId::CalibGyro;
    const bool isFrame = calibration.imu == kFrameImu;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const double motion = isFrame ? m_frameRawGyro[i] : m_stabilizer.rawGyro(kAxes[i]);
        const double sample = gyro ? motion : isFrame ? m_frameRawAcc[i] : m_stabilizer.rawAcc(i);
        calibration.sum[i] += sample;
        calibration.low[i] = calibration.samples ? std::min(calibration.low[i], motion) : motion;
        calibration.high[i] = calibration.samples ? std::max(calibration.high[i], motion) : motion;
    }
    ++calibration.samples;
    calibration.left -= Stabilizer::kCycle;
    const bool fails = m_options.faults.failWith != 0 && calibration.total - calibration.left > 1.0;
    if (calibration.left > 0 && !fails)
        return;

    bool still = m_stabilizer.imuPresent();
    for (std::size_t i = 0; i < kAxisCount; ++i)
        still &= calibration.high[i] - calibration.low[i] < kStillEnough;
    if (!fails && !still && calibration.total < kLongestCalibration && m_stabilizer.imuPresent()) {
        // It moved: start over, as the firmware does, but not endlessly.
        calibration.left = 4.0;
        calibration.total += 4.0;
        calibration.sum = {};
        calibration.samples = 0;
        return;
    }
    if (still && !fails) {
        std::array<double, kAxisCount> mean{};
        for (std::size_t i = 0; i < kAxisCount; ++i)
            mean[i] = calibration.sum[i] / calibration.samples;
        if (calibration.action == 3)
            noteTemperatures(calibration.command, calibration.imu, calibration.action);
        if (calibration.command == CommandId::CalibAccExtRef)
            levelByReference(mean);
        else if (gyro)
            (isFrame ? m_frameImu : imu).gyroCorrection = mean;
        else if (isFrame)
            m_frameImu.accCorrection = {mean[0], mean[1], mean[2] - 1.0};
        else
            finishAccCalibration(mean);
        keepCalibration(isFrame ? kFrameImu : kMainImu);
    }
    if (!isFrame && calibration.command != CommandId::CalibAccExtRef) {
        m_stabilizer.setHeld(false);
        m_stabilizer.resetEstimate();
        m_stabilizer.setMotorsOn(calibration.motorsWereOn);
    }
    sendEnd(calibration.command, calibration.version, fails ? m_options.faults.failWith : 0);
    calibration.left = 0;
}

// One position levels the sensor; an axis that was measured pointing both up and down gets its true zero and
// scale.
void SimulatedBoard::finishAccCalibration(const std::array<double, kAxisCount> &mean)
{
    SimulatedImu &imu = m_stabilizer.imu();
    std::size_t up = 0;
    for (std::size_t i = 1; i < kAxisCount; ++i) {
        if (std::abs(mean[i]) > std::abs(mean[up]))
            up = i;
    }
    m_accLimits[up][mean[up] > 0] = mean[up];
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const auto &[low, high] = m_accLimits[i];
        if (low && high) {
            imu.accCorrection[i] = (*high + *low) / 2;
            imu.accScale[i] = (*high - *low) / 2;
        } else if (up == 2 && mean[up] > 0) {
            imu.accCorrection[i] = mean[i] - (i == up ? 1.0 : 0.0);
        }
    }
}

// What took long has come to its end, or is given up.
void SimulatedBoard::sendEnd(CommandId command, int version, int refusal)
{
    ByteWriter writer;
    writer.u8(number(command));
    if (refusal != 0)
        writer.u8(refusal).zeros(4);
    else if (command == CommandId::CalibCogging)
        writer.u8(255);  // its end, to tell it from its beginning
    send(refusal != 0 ? CommandId::Error : CommandId::Confirm, writer.take(), version);
}

}  // namespace simplebgc
