// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/board.h"

#include "protocol/base/filefault.h"
#include "protocol/bcflight/luacheck.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

// As the shipped ones are built (7.2), with values that fly the simulated quadcopter.
const QByteArray kShippedConfiguration = R"lua(-- BCFlight configuration of the simulated quadcopter

username = "simulated"

PID.pscale = 0.032029 * 0.0005
PID.iscale = 1.221905e-4
PID.dscale = 2.645e-7

gyro = ICM4xxxx{ bus = SPI( "/dev/spidev0.0", 2000000 ), axis_swap = Vector( 2, -1, 3 ) }

frame = Multicopter {
	motors = {
		DShot( 4 ),
		DShot( 5 ),
		DShot( 6 ),
		DShot( 7 ),
	},
	matrix = {
		Vector( 1.0, -1.0, -1.0, 1.0 ),
		Vector( -1.0, -1.0, 1.0, 1.0 ),
		Vector( 1.0, 1.0, 1.0, 1.0 ),
		Vector( -1.0, 1.0, -1.0, 1.0 ),
	}
}

stabilizer = Stabilizer {
	loop_time = 800,
	rate_speed = 300,
	horizon_angles = Vector( 40, 40, 0 ),
	pid_roll = PID( 90, 25, 80 ),
	pid_pitch = PID( 100, 25, 90 ),
	pid_yaw = PID( 180, 40, 0 ),
	pid_horizon = PID( 150, 0, 0 ),
}

controller = Controller {
	telemetry_rate = 100,
	full_telemetry = 1,
	link = Socket{ type = "UDP", port = 2020, read_timeout = 500 },
}
)lua";

// Faults::pose from 1 on: level, right side down, left side down, nose down, nose up, turned to the right and
// to the left.
constexpr std::array<Vector3, 7> kHands{
    {{0, 0, 0}, {30, 0, 0}, {-30, 0, 0}, {0, 30, 0}, {0, -30, 0}, {0, 0, -40}, {0, 0, 40}}};
constexpr double kStickRate = 300;  // °/s at full stick
constexpr double kStickAngle = 40;  // ° at full stick, mode 1
constexpr double kHorizonGain = 6;  // °/s per °; not on the wire
constexpr double kRateCutOff = 90;  // Hz
constexpr double kSlowCutOff = 45;
constexpr double kMostIntegral = 400;  // °
constexpr double kIdle = 0.02;  // thrust below which nothing is corrected
constexpr double kPullToGravity = 0.4;  // 1/s
constexpr double kFailsafe = 0.5;  // s, of the generations that have one
constexpr std::size_t kHistory = 512;

double lowPass(double cutOff)
{
    return 1 - std::exp(-2 * M_PI * cutOff * SimulatedBoard::kCycle);
}

// Where a name is set more than once the last one counts, as in any program.
Result<GainLiterals> lastGains(const QByteArray &text, const QString &name)
{
    const auto found = findGains(text, name);
    const qsizetype last = onlyCode(text).lastIndexOf(name.toLatin1());
    return found || last < 0 ? found : findGains(text.sliced(last), name);
}

}  // namespace

SimulatedBoard::SimulatedBoard(const SimulatorOptions &options)
    : m_options(options)
    , m_generation(Generation(options.own.value(QLatin1String(kGeneration), int(Generation::G))))
    , m_quadcopter(options.seed, findMotors(kShippedConfiguration))
    , m_noise(options.seed + 1)
    , m_configuration(kShippedConfiguration)
{
    if (!options.memoryFile.isEmpty())
        m_configuration = readWhole(options.memoryFile, FileKind::Other, kLargestText).value_or(QByteArray());
    if (options.own.value(QLatin1String(kNotch), 0))
        m_configuration.append("\nstabilizer.dynamic_notch = DynamicNotchFilter { min_freq = 100 }\n");
    m_quadcopter.setPlace(options.own.value(QLatin1String(kStand), 1) ? Quadcopter::Place::Stand
                                                                      : Quadcopter::Place::Ground);
    setFaults(options.faults);
    start();
}

QByteArray SimulatedBoard::shippedConfiguration()
{
    return kShippedConfiguration;
}

void SimulatedBoard::setFaults(const Faults &faults)
{
    m_options.faults = faults;
    m_quadcopter.setBattery(faults.battery);
    m_quadcopter.setBlocked(faults.blocked);
    m_quadcopter.setGusts(faults.shake);
    if (faults.pose <= 0)
        m_quadcopter.setHand({});
    else
        m_quadcopter.setHand(kHands[std::min(std::size_t(faults.pose), kHands.size()) - 1]);
}

Status SimulatedBoard::status() const
{
    return {m_armed, m_calibrated, m_calibratingUntil > 0};
}

// What the program takes from its configuration. A text that it cannot load ends it for good (7.3).
void SimulatedBoard::start()
{
    m_isConnected = m_armed = m_everArmed = m_calibrated = m_isHung = m_isStreamPaused = m_isBeeping = false;
    m_calibratingUntil = -1;
    m_busyUntil = 0;
    m_inbox.clear();
    m_outbox.clear();
    m_steps.clear();
    m_upload.clear();
    m_mode = 1;
    m_lastAck = 0x0600;  // the number 0 (5)
    m_iso = 0;
    m_isCalibrationOver = false;
    m_offset = {};
    m_sticks = {};
    m_pictureSteps = {};
    m_rate = m_slowRate = m_turning = m_attitude = m_integral = m_correction = Vector3();
    m_mix = findMotors(m_configuration);
    m_outputs.assign(m_mix.size(), 0.0);
    m_isDead = !checkSyntax(m_configuration) || m_mix.size() != m_quadcopter.speeds().size();
    const auto scales = findScales(m_configuration);
    const std::array names{u"pid_roll"_s, u"pid_pitch"_s, u"pid_yaw"_s};
    for (std::size_t axis = 0; axis < names.size() && scales; ++axis) {
        // What is computed there cannot be told here: it keeps what it had.
        const auto gains = lastGains(m_configuration, names[axis]);
        for (std::size_t term = 0; term < 3 && gains; ++term)
            m_gains[axis][term] = double(float((*gains)[term].value * (*scales)[term]));
    }
    const auto number = [this](const char *name, double otherwise) {
        const auto value = findScale(m_configuration, QString::fromLatin1(name));
        return value && m_configuration.contains(name) ? *value : otherwise;
    };
    m_streamRate = number("telemetry_rate", 0);
    m_isFull = number("full_telemetry", 0) != 0;
    m_nextStream = m_now;
    m_streamTick = 0;
}

void SimulatedBoard::cycle()
{
    m_now += kCycle;
    m_quadcopter.step(kCycle, m_outputs);
    if (const double at = m_options.faults.resetAfter; at > 0 && m_now >= at && m_resetDone != at) {
        m_resetDone = at;
        m_isDead = false;
        restart(kRestartTime);
    }
    if (m_isDead || m_now < m_awayUntil)
        return;
    control();
    serve();
    stream();
}

// After each connection it waits for a PING again (3).
void SimulatedBoard::clientCame()
{
    ++m_clients;
    m_hasClient = true;
    m_heardClient = m_now;
    m_isConnected = false;
}

// It calls itself disarmed, but nobody tells the motors: their outputs keep their last values (9.1).
void SimulatedBoard::clientWent()
{
    m_hasClient = m_isConnected = m_armed = false;
}

// From the second client on, one that pauses is dropped, and does not learn of it (2.6).
bool SimulatedBoard::hasDroppedClient() const
{
    return m_hasClient && m_clients > 1 && m_now - m_heardClient > kReadTimeout;
}

// It does not notice that nobody steers it any more (9.1).
bool SimulatedBoard::isOutOfReach() const
{
    return m_everArmed && m_now - m_armedAt < m_options.faults.silentArmed;
}

// As the original ground: CONTROLS a hundred times per second would disarm us; a PING says enough.
QByteArray SimulatedBoard::askedByOthers()
{
    return encode(Message::Ping, bigU16(std::uint16_t(0x7000 + m_askedByOthers++)) + bigU16(0), m_generation);
}

QByteArray SimulatedBoard::takeOutput(qsizetype)
{
    if (hasDroppedClient() || isOutOfReach())
        m_outbox.clear();
    if (m_outbox.empty())
        return {};
    QByteArray packet = std::move(m_outbox.front());
    m_outbox.pop_front();
    return packet;
}

void SimulatedBoard::stopOutputs()
{
    std::fill(m_outputs.begin(), m_outputs.end(), 0.0);
}

void SimulatedBoard::disarm()
{
    m_armed = false;
    m_integral = m_correction = Vector3();
    stopOutputs();
}

void SimulatedBoard::beCalibrated()
{
    m_zeroSum += m_quadcopter.gyro();
    ++m_zeroCount;
    if (m_now < m_calibratingUntil)
        return;
    m_zero = m_zeroSum / m_zeroCount;
    m_hasOffsets |= m_isFullCalibration;
    m_calibratingUntil = -1;
    m_isCalibrationOver = true;
}

void SimulatedBoard::estimate()
{
    const Vector3 gyro = m_quadcopter.gyro() - m_zero;
    m_rate += (gyro - m_rate) * lowPass(kRateCutOff);
    const Vector3 slower = m_slowRate;
    m_slowRate += (gyro - m_slowRate) * lowPass(kSlowCutOff);
    m_turning = (m_slowRate - slower) / kCycle;
    m_history.push_back(m_rate);
    if (m_history.size() > kHistory)
        m_history.pop_front();
    const Vector3 pull = m_quadcopter.acceleration();
    const double roll = std::atan2(pull.y, pull.z) * 180 / M_PI;
    const double pitch = std::atan2(-pull.x, std::hypot(pull.y, pull.z)) * 180 / M_PI;
    m_attitude += m_rate * kCycle;
    m_attitude.x += (roll - m_attitude.x) * kPullToGravity * kCycle;
    m_attitude.y += (pitch - m_attitude.y) * kPullToGravity * kCycle;
    m_attitude.z = std::remainder(m_attitude.z, 360.0);
}

void SimulatedBoard::control()
{
    m_calibrated |= std::exchange(m_isCalibrationOver, false);
    if (m_calibratingUntil > 0)
        beCalibrated();
    if (m_calibrated)
        estimate();
    while (!m_steps.empty() && m_steps.front().at <= m_now) {
        m_outputs = std::move(m_steps.front().outputs);
        m_steps.pop_front();
    }
    // Generations B to E notice that nobody steers any more; F and G do not (9.1).
    const bool notices = m_generation >= Generation::B && m_generation <= Generation::E;
    if (m_armed && notices && m_now - m_heardControls > kFailsafe)
        disarm();
    if (!m_armed || m_options.faults.runsOn)
        return;
    Vector3 wanted = Vector3{m_sticks.roll, m_sticks.pitch, m_sticks.yaw} * kStickRate;
    if (m_mode != 0) {
        wanted.x = kHorizonGain * (m_sticks.roll * kStickAngle + m_offset[0] - m_attitude.x);
        wanted.y = kHorizonGain * (m_sticks.pitch * kStickAngle + m_offset[1] - m_attitude.y);
    }
    const bool isIdle = m_sticks.thrust < kIdle;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &[p, i, d] = m_gains[axis];
        const double error = wanted[axis] - m_rate[axis];
        m_integral[axis]
            = isIdle ? 0 : std::clamp(m_integral[axis] + error * kCycle, -kMostIntegral, kMostIntegral);
        m_correction[axis] = isIdle ? 0 : p * error + i * m_integral[axis] - d * m_turning[axis];
    }
    for (std::size_t motor = 0; motor < m_outputs.size(); ++motor) {
        const auto &[roll, pitch, yaw, thrust] = m_mix[motor];
        m_outputs[motor] = std::max(0.0,
                                    m_sticks.thrust * thrust + m_correction.x * roll + m_correction.y * pitch
                                        + m_correction.z * yaw);
    }
}

}  // namespace bcflight
