// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/storm32/board.h"

#include "protocol/storm32/orientations.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr double kNominalVoltage = 12.3;
constexpr int kNoImu3Word = 38;  // later Imu3 Configuration
constexpr int kNtLoggingWord = 77;
constexpr double kRunningFor = 60.0;  // the board has been running for a while when a client connects

// The firmware counts right roll, down and left as positive (errata 3.5); the plant left roll, down and
// right.
constexpr std::array<double, kAxisCount> kSign{-1.0, 1.0, -1.0};

int layoutOf(int firmware)
{
    return firmware >= 95 ? 95 : firmware >= 89 ? 89 : 78;
}

// When each state of the start ends, seconds after a reset (errata 3.7).
constexpr std::array<double, 6> kStart79{3.7, 7.5, 9.8, 10.9, 17.7, 18.8};
constexpr std::array<double, 6> kStart90{3.5, 6.5, 8.5, 9.5, 15.8, 16.7};

SimulatorOptions complete(SimulatorOptions options)
{
    if (options.firmware == 0)
        options.firmware = 96;
    return options;
}

}  // namespace

SimulatedBoard::SimulatedBoard(const SimulatorOptions &options)
    : m_options(complete(options))
    , m_layout(layoutOf(m_options.firmware))
    , m_words(wordsOf(m_layout))
    , m_parameters(parameterRows(), blocksOf(m_layout), m_layout, {})
    , m_stabilizer(options.seed)
    , m_name(QByteArray("OlliW 323BGC").leftJustified(16, '\0'))
    , m_latency(options.seed * 2 + 5)
    , m_frameNoise(options.seed * 3 + 7)
{
    m_ram = factoryStream();
    // A board that has already been set up: the motors are in use, their directions known.
    for (const Axis axis : kAxes) {
        const auto word = [this, axis](const char *pattern) {
            return m_parameters
                       .find(QString::fromLatin1(pattern).replace(u"%a"_s, QLatin1String(axisKey(axis))))
                       ->offset
                / 2;
        };
        set(word("motor.%a.usage"), 0);
        set(word("motor.%a.direction"), 0);
    }
    m_eeprom = m_ram;
    for (const std::size_t scale : {3U, 4U, 5U, 12U, 13U, 14U})
        m_calibration[scale] = int(oneG());
    restart(Memory::Reload);
    m_started = -kRunningFor;
}

SimulatedBoard::~SimulatedBoard() = default;

int SimulatedBoard::wordOf(const QByteArray &stream, int word)
{
    return std::uint8_t(stream[2 * word]) | std::uint8_t(stream[2 * word + 1]) << 8;
}

void SimulatedBoard::set(int word, int raw)
{
    if (m_layout == 78 && word == kNoImu3Word)
        raw = 0;  // acknowledged, and not taken (errata 13, row 16)
    m_ram[2 * word] = char(raw & 0xFF);
    m_ram[2 * word + 1] = char(raw >> 8 & 0xFF);
    applyParameters();
}

double SimulatedBoard::value(const QString &key) const
{
    const ParameterSpec *spec = m_parameters.find(key);
    return spec ? spec->toDisplay(spec->read(m_ram).value_or(0)) : 0.0;
}

double SimulatedBoard::axisValue(const char *pattern, Axis axis) const
{
    return value(QString::fromLatin1(pattern).replace(u"%a"_s, QLatin1String(axisKey(axis))));
}

// The data of a freshly erased board (errata 11, "fw").
QByteArray SimulatedBoard::factoryStream() const
{
    QByteArray stream(2 * m_words + kScriptArea, '\0');
    stream.replace(2 * m_words, kScriptArea, QByteArray(kScriptArea, char(0xFF)));
    for (const ParameterSpec &spec : m_parameters.all()) {
        double raw = spec.defaultRaw;
        // Errata 13, row 15.
        if (m_layout >= 89 && spec.key.startsWith(u"rc."_s) && spec.key.endsWith(u".mode"_s))
            raw = 2;
        if (m_layout == 89 && spec.offset == 2 * kNtLoggingWord)
            raw = 1;
        if (m_layout == 95 && spec.key == u"filter.imu2_lpf"_s)
            raw = 0;
        if (spec.key == u"beep"_s)
            raw = 1;
        spec.write(stream, raw);
    }
    stream[2 * 82] = 25;  // of unknown purpose; must survive
    return stream;
}

void SimulatedBoard::applyParameters()
{
    for (const Axis axis : kAxes) {
        AxisGains gains;
        gains.p = axisValue("pid.%a.p", axis) * kUnitP;
        gains.i = axisValue("pid.%a.i", axis) * kUnitI;
        gains.d = axisValue("pid.%a.d", axis) * kUnitD;
        gains.poles = int(axisValue("motor.%a.poles", axis));
        gains.inverted
            = axisValue("motor.%a.direction", axis) == 1.0;  // the simulated motors run the normal way
        gains.power = isUsed(axis) ? std::min(1.0, axisValue("motor.%a.vmax", axis) / 255.0) : 0.0;
        constexpr std::array<double, 7> kLowPassMs{0, 1.5, 3.0, 4.5, 6.0, 7.5, 9.0};
        const double ms = kLowPassMs[std::size_t(std::clamp(value(u"filter.gyro_lpf"_s), 0.0, 6.0))];
        gains.dLpfHz = ms > 0 ? 1000.0 / (2.0 * 3.14159265 * ms) : 0.0;
        m_stabilizer.setGains(axis, gains);
    }
    // The configured orientation of the sensor's axes, and the real one.
    const auto told
        = std::size_t(std::clamp(int(value(u"imu.orientation"_s)), 0, int(orientations().size()) - 1));
    const auto &believed = orientations()[told].axes;
    const auto &mounted = orientations()[std::size_t(m_options.faults.mount)].axes;
    Stabilizer::Rotation axes{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t own = 0; own < 3; ++own)
                axes[row][column] += believed[row][own] * mounted[column][own];
        }
    }
    m_stabilizer.setBelievedAxes(axes);
}

// Words of Cr: zeros and scales of the accelerometer, zeros of the gyroscope, in the sensor's axes forward,
// left, up.
void SimulatedBoard::applyCalibration()
{
    const double one = oneG();
    SimulatedImu &imu = m_stabilizer.imu();
    constexpr std::array<std::size_t, 3> kPlantAxis{1, 0, 2};  // forward, left, up among right, forward, up
    constexpr std::array<double, 3> kPlantSign{1.0, -1.0, 1.0};
    constexpr std::array<std::size_t, 3> kTurnAxis{
        0, 1, 2};  // about forward: roll; about left: pitch; about up: yaw
    const auto &mounted = orientations()[std::size_t(m_options.faults.mount)].axes;
    for (std::size_t i = 0; i < 3; ++i) {
        // Which of the sensor's axes points that way, and in which direction.
        std::size_t own = 0;
        while (mounted[i][own] == 0)
            ++own;
        const int end = mounted[i][own];
        imu.accCorrection[kPlantAxis[i]] = kPlantSign[i] * end * m_calibration[own] / one;
        imu.accScale[kPlantAxis[i]] = m_calibration[3 + own] != 0 ? m_calibration[3 + own] / one : 1.0;
        imu.gyroCorrection[kTurnAxis[i]] = imu.gyroBias[kTurnAxis[i]]
            + kSign[kTurnAxis[i]] * end * m_calibration[6 + own] / kCountsPerDegree;
    }
}

void SimulatedBoard::setFaults(const Faults &faults)
{
    m_options.faults = faults;
    applyCalibration();
    applyParameters();
}

// Restarts the program; the values in use are kept or loaded again.
void SimulatedBoard::restart(Memory memory)
{
    m_started = m_now;
    m_relevelUntil = 0;
    m_standby = false;
    m_setAngle = {};
    m_pulse = {};
    m_moved = {};
    m_pan = {};
    m_panMode.reset();
    m_scriptCase = {};
    m_scriptRuns = {};
    m_heardBeat = false;
    m_isBeating = false;  // who it is comes first again
    m_input.clear();
    if (memory == Memory::Reload)
        m_ram = m_eeprom;
    for (const Axis axis : kAxes)
        m_stabilizer.plant(axis).setAngle(0.0);
    m_stabilizer.resetEstimate();
    applyCalibration();
    applyParameters();
}

int SimulatedBoard::state() const
{
    if (m_standby)
        return m_options.firmware >= 95 ? 99 : 7;
    if (m_now < m_relevelUntil)
        return 5;
    const double since = m_now - m_started;
    if (m_options.faults.noImu)
        return since < 9.5 ? std::min(3, int(since / 3.2)) : 3;  // it waits there for one
    const auto &ends = m_options.firmware >= 90 ? kStart90 : kStart79;
    bool automatic = false;
    for (const Axis axis : kAxes)
        automatic |= axisValue("motor.%a.direction", axis) == 2.0;
    // Without directions to find, that state is skipped.
    const double skipped = automatic ? 0.0 : ends[4] - ends[3];
    for (int state = 0; state < int(ends.size()); ++state) {
        if (state == 4 && !automatic)
            continue;
        if (since < ends[std::size_t(state)] - (state > 4 ? skipped : 0.0))
            return state;
    }
    return 6;
}

double SimulatedBoard::volts() const
{
    return (m_options.faults.battery > 0 ? m_options.faults.battery : kNominalVoltage)
        - 0.04 * m_stabilizer.current();
}

bool SimulatedBoard::isPanning(Axis axis) const
{
    // Modes by axis: pitch, roll, yaw follow the handle (errata 11, PANM).
    static constexpr std::array<std::array<bool, 3>, 7> kModes{{
        {false, false, true},
        {false, false, false},
        {true, true, true},
        {true, false, false},
        {true, false, true},
        {false, true, true},
        {false, false, false},
    }};
    const int mode = m_panMode.value_or(int(value(u"pan.mode.default"_s)));
    if (mode < 0 || mode >= int(kModes.size()))
        return false;
    const std::array<std::size_t, 3> place{1, 0, 2};
    return kModes[std::size_t(mode)][place[std::size_t(axis)]];
}

bool SimulatedBoard::isUsed(Axis axis) const
{
    return axisValue("motor.%a.usage", axis) != 3.0 || m_options.faults.runsOn;
}

bool SimulatedBoard::isDriven(Axis axis) const
{
    return m_stabilizer.motorsOn() && isUsed(axis);
}

void SimulatedBoard::updateWorld()
{
    const Faults &faults = m_options.faults;
    if (!faults.frozen)
        m_frozen.reset();
    else if (!m_frozen)
        m_frozen = liveWords();
    if (faults.resetAfter >= 0 && m_now >= faults.resetAfter && m_resetDone != faults.resetAfter) {
        m_resetDone = faults.resetAfter;
        restart(Memory::Reload);
    }
    m_stabilizer.setImuPresent(!faults.noImu);
    // Poses by this family's axes, forward and left, converted to the plant's, right and forward.
    constexpr std::array<int, 8> kPlantPose{0, 1, 2, 5, 6, 4, 3, 7};
    m_stabilizer.setPose(kPlantPose[std::size_t(faults.pose)]);
    m_stabilizer.setSwappedMotors(faults.swappedAxes);
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_stabilizer.plant(kAxes[i]).setBlocked(faults.blocked == int(i) + 1);
    m_stabilizer.hand().setStrength(faults.shake);
    m_stabilizer.setVoltage(volts());
    // The motors turn from state 4 on (2 and 3 hold still for the sensors).
    const int now = state();
    m_stabilizer.setMotorsOn(!m_standby && (now >= 4 && now <= 6));
}

void SimulatedBoard::updateTargets()
{
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const Axis axis = kAxes[i];
        const double low = axisValue("rc.%a.min", axis);
        const double high = axisValue("rc.%a.max", axis);
        const double half = m_pulse[i] >= 0 ? high : -low;
        const double wanted = std::clamp(m_pulse[i] / 500.0 * half, std::min(low, high), std::max(low, high))
            + axisValue("rc.%a.offset", axis) + m_setAngle[i];
        const double limit = axisValue("rc.%a.speed_limit", axis);
        const double step = limit > 0 ? limit * Stabilizer::kCycle : 1e9;
        m_moved[i] += std::clamp(wanted - m_moved[i], -step, step);
        if (isPanning(axis)) {
            const double behind = kSign[i] * m_stabilizer.hand().angle(axis) - m_pan[i];
            m_pan[i] += behind * axisValue("pan.%a.speed", axis) * Stabilizer::kCycle;
        }
        m_stabilizer.setTarget(axis, kSign[i] * (m_moved[i] + m_pan[i]));
    }
}

void SimulatedBoard::receive(Bytes bytes)
{
    m_input.append(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()));
    m_lastByteAt = m_now;
}

void SimulatedBoard::cycle()
{
    m_now += Stabilizer::kCycle;
    updateWorld();
    runScripts();
    updateTargets();
    m_stabilizer.step();
    while (m_now >= m_busyUntil && serve()) { }
    beat();
    while (!m_replies.empty() && m_replies.front().at <= m_now) {
        m_output += m_replies.front().bytes;
        m_replies.pop_front();
    }
}

QByteArray SimulatedBoard::takeOutput(qsizetype max)
{
    const QByteArray out = m_output.left(max);
    m_output.remove(0, out.size());
    return out;
}

}  // namespace storm32
