// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors that only some boards have: encoders at the motors, a second motion sensor at the frame, a
// magnetometer at the camera. What they do to the board is decided here; the documents tell only what they
// are.
#include "protocol/base/angles.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kEncoderUnit = 360.0 / 16384;  // degrees per count (errata 0)
constexpr int kEncoderType = 3;  // AS5048 PWM
// Where the magnets of the encoders are glued, and where the motors' field is against them, in counts: those
// of the errata's board for roll and pitch.
constexpr std::array<int, kAxisCount> kEncoderZero{-5889, -4985, 1716};
constexpr std::array<int, kAxisCount> kEncoderField{418, 677, -230};
constexpr int kEncodersAsNew = 2;  // the option: mounted, never calibrated
constexpr int kEncoderMissing = 29;  // cause of an emergency stop (errata 4.5)
constexpr int kFieldOfFailure
    = 455;  // counts: what is found at a motor that did not turn is off by ten degrees

constexpr double kEarthLevel = 200;  // counts of the magnetometer
constexpr double kEarthDown = 346;
constexpr std::array<double, 3> kMagBias{90, -60, 110};  // iron beside it: right, front, up
// Iron that the earth makes a magnet: it bends and stretches the field.
constexpr std::array<std::array<double, 3>, 3> kSoftIron{
    {{1.06, 0.02, 0}, {0.02, 0.95, 0.015}, {0, 0.015, 0.99}}};
constexpr double kMagNoise = 1.5;
constexpr double kMagPull = 0.004;  // per second and count of trust
constexpr double kMagTime = 20;  // seconds of a calibration
constexpr double kMagSpread = 250;  // counts on each axis that show that the camera was turned

double toHalfTurn(double degrees)
{
    return std::remainder(degrees, 360.0);
}

double angleBetween(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const double size = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
    return size > 0 ? degrees(std::acos(std::clamp(product / size, -1.0, 1.0))) : 0;
}

// The axis of a sensor that a parameter names: 1 to 3 and their opposites.
std::array<double, 3> sensorAxis(int named)
{
    std::array<double, 3> axis{};
    if (const int place = std::abs(named); place >= 1 && place <= 3)
        axis[std::size_t(place - 1)] = named > 0 ? 1 : -1;
    return axis;
}

std::array<double, 3> frontOf(const std::array<double, 3> &up, const std::array<double, 3> &right)
{
    return {up[1] * right[2] - up[2] * right[1], up[2] * right[0] - up[0] * right[2],
            up[0] * right[1] - up[1] * right[0]};
}

double dot(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The sensor's axes that point to the camera's right, front and top.
struct SensorSeat
{
    std::array<double, 3> right, front, up;
};

// As the fault "mount" counts them.
SensorSeat seatOf(int mount)
{
    constexpr std::array kUp{3, 1, 2, -3, -1, -2};
    const int up = kUp[std::size_t(mount / 4)];
    const int next = std::abs(up) % 3 + 1;
    const std::array rights{next, next % 3 + 1, -next, -(next % 3 + 1)};
    const auto top = sensorAxis(up);
    const auto right = sensorAxis(rights[std::size_t(mount % 4)]);
    return {right, frontOf(top, right), top};
}

}  // namespace

// As an owner gets them: encoders set up, unless they are new; the other sensors not calibrated.
void SimulatedBoard::fitSensors()
{
    m_frameImu.gyroBias = {-1.1, 1.8, 0.7};
    m_frameImu.accError = {-0.03, 0.045, 0.01};
    if (isFitted("fc") || isFitted("encoders"))
        m_ram = m_eeprom[std::size_t(m_active)];
    if (isFitted("fc")) {
        store(u"fc.map.roll"_s, 0, kFcRollPin);
        store(u"fc.map.pitch"_s, 0, kFcPitchPin);
    }
    if (!isFitted("encoders"))
        return;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const QString key = u"encoder.%1."_s.arg(QLatin1String(axisKey(kAxes[i])));
        store(key + u"type"_s, 0, kEncoderType);
        if (m_options.own.value(u"encoders"_s) == kEncodersAsNew)
            continue;
        store(key + u"offset"_s, 0, kEncoderZero[i]);
        store(key + u"field_offset"_s, 0, kEncoderField[i]);
    }
}

// An encoder that the parameters name and that is not there stops the board, unless it does not test it.
void SimulatedBoard::bootSensors()
{
    if (!isFitted("encoders"))
        return;
    for (const Axis axis : kAxes) {
        const bool isNamed = axisValue("encoder.%a.type", axis) != 0;
        if (isNamed && !isRead(axis) && axisValue("encoder.%a.skip_detection", axis) == 0) {
            m_emergency = true;
            m_emergencyCause = kEncoderMissing;
        }
    }
}

// The firmware takes the camera's sensor to sit as the parameters say; where they name no two axes, as it
// took it before.
void SimulatedBoard::believeAxes()
{
    const auto up = sensorAxis(int(value(u"imu.main.axis_top"_s)));
    const auto right = sensorAxis(int(value(u"imu.main.axis_right"_s)));
    const std::array<double, 3> front = frontOf(up, right);
    if (std::hypot(front[0], front[1], front[2]) < 0.5)
        return;
    const SensorSeat seat = seatOf(m_options.faults.mount);
    const auto row = [&seat](const std::array<double, 3> &own, int sign) {
        return std::array{sign * int(dot(own, seat.front)), -sign * int(dot(own, seat.right)),
                          sign * int(dot(own, seat.up))};
    };
    m_stabilizer.setBelievedAxes({row(front, 1), row(right, -1), row(up, 1)});
}

/// What the accelerometer measures along that axis of its own, in g.
double SimulatedBoard::ownAcc(std::size_t axis) const
{
    const SensorSeat seat = seatOf(m_options.faults.mount);
    return seat.right[axis] * m_stabilizer.calibratedAcc(0) + seat.front[axis] * m_stabilizer.calibratedAcc(1)
        + seat.up[axis] * m_stabilizer.calibratedAcc(2);
}

std::array<double, kAxisCount> SimulatedBoard::fromSensor(const std::array<double, kAxisCount> &own) const
{
    const SensorSeat seat = seatOf(m_options.faults.mount);
    return {dot(seat.right, own), dot(seat.front, own), dot(seat.up, own)};
}

bool SimulatedBoard::isRead(Axis axis) const
{
    return isFitted("encoders") && int(axisValue("encoder.%a.type", axis)) == kEncoderType;
}

// One of another type tells nothing but zeros. Without encoders the joint itself stands for them.
double SimulatedBoard::encoderReading(Axis axis) const
{
    if (!isFitted("encoders"))
        return m_stabilizer.jointAngle(axis);
    return isRead(axis)
        ? toHalfTurn(m_stabilizer.jointAngle(axis) + kEncoderZero[std::size_t(axis)] * kEncoderUnit)
        : 0;
}

// An axis without an encoder is known by other means, as on a board that has none.
double SimulatedBoard::motorAngle(Axis axis) const
{
    if (!isFitted("encoders") || axisValue("encoder.%a.type", axis) == 0)
        return m_stabilizer.jointAngle(axis);
    const double ratio
        = axisValue("encoder.%a.geared", axis) != 0 ? axisValue("encoder.%a.gear_ratio", axis) : 1;
    const double turned = toHalfTurn(encoderReading(axis) - axisValue("encoder.%a.offset", axis));
    return ratio > 0 ? turned / ratio : turned;
}

void SimulatedBoard::updateSensors()
{
    if (isFitted("encoders")) {
        // The board leads the field by what it takes for the angle between magnets and coils: off by a
        // quarter of a pole pair the motor is powerless, beyond that it runs away.
        for (const Axis axis : kAxes) {
            const double zero = kEncoderZero[std::size_t(axis)] * kEncoderUnit;
            const double field = kEncoderField[std::size_t(axis)] * kEncoderUnit;
            const double led = encoderReading(axis) - axisValue("encoder.%a.field_offset", axis);
            const double stands = m_stabilizer.jointAngle(axis) + zero - field;
            const int pairs = m_stabilizer.plant(axis).mechanics().poles / 2;
            const bool isLed = axisValue("encoder.%a.type", axis) != 0;
            m_stabilizer.setField(axis, isLed ? std::cos(radians((led - stands) * pairs)) : 1.0);
        }
    }
    if (isFitted("frame-imu"))
        updateFrameSensor();
    if (isFitted("magnetometer"))
        updateMagnetometer();
}

void SimulatedBoard::storeEncoders()
{
    const MotorCalibration &run = m_motorCalibration;
    const bool isField = run.command == CommandId::EncodersCalibFldOffset;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (!run.axes[i])
            continue;
        const QString key = u"encoder.%1."_s.arg(QLatin1String(axisKey(kAxes[i])));
        if (isField) {
            const bool hasTurned = run.turned[i] > std::abs(run.turn[i]) / 2;
            store(key + u"field_offset"_s, 0, kEncoderField[i] + (hasTurned ? 0 : kFieldOfFailure));
        } else if (run.samples > 0) {
            store(key + u"offset"_s, 0, int(std::lround(run.sums[i] / run.samples / kEncoderUnit)));
        }
    }
}

bool SimulatedBoard::isFrameSensor() const
{
    return isFitted("frame-imu") && m_hasFrameSensor;
}

void SimulatedBoard::updateFrameSensor()
{
    const double roll = radians(m_stabilizer.hand().angle(Axis::Roll));
    const double pitch = radians(m_stabilizer.hand().angle(Axis::Pitch));
    const std::array<double, kAxisCount> gravity{std::cos(pitch) * std::sin(roll), -std::sin(pitch),
                                                 std::cos(pitch) * std::cos(roll)};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        m_frameRawGyro[i] = m_stabilizer.hand().rate(kAxes[i]) + m_frameImu.gyroBias[i]
            + m_sensorNoise.gauss(m_frameImu.gyroNoise);
        m_frameRawAcc[i] = gravity[i] + m_frameImu.accError[i] + m_sensorNoise.gauss(m_frameImu.accNoise);
    }
}

/// What the board knows of the frame, by whoever tells it: zero if nobody does.
double SimulatedBoard::frameAngle(Axis axis) const
{
    const double angle = m_stabilizer.hand().angle(axis);
    if (m_now < m_frameToldUntil)
        return m_frameTold[std::size_t(axis)];
    if (isFrameSensor()) {
        if (axis == Axis::Yaw)
            return angle;
        // Gravity is measured as far off as the accelerometer is.
        const double right = m_frameImu.accError[0] - m_frameImu.accCorrection[0];
        const double front = m_frameImu.accError[1] - m_frameImu.accCorrection[1];
        return angle + degrees(axis == Axis::Roll ? right : -front);
    }
    if (!isFitted("fc") || axis == Axis::Yaw)
        return 0;
    // The gain is the angle of a full signal: an assumption, its unit is in no document.
    return signal(int(axisValue("fc.map.%a", axis))).value_or(0) * axisValue("fc.gain.%a", axis);
}

// The earth's field in the camera's axes right, front and up; no declination at this place.
std::array<double, 3> SimulatedBoard::earthField(double roll, double pitch, double yaw) const
{
    const double r = radians(roll), p = radians(pitch), y = radians(yaw);
    const double right = -kEarthLevel * std::sin(y);
    const double front = kEarthLevel * std::cos(y);
    const double up = -kEarthDown * std::cos(p) + front * std::sin(p);
    return {right * std::cos(r) + up * std::sin(r), front * std::cos(p) + kEarthDown * std::sin(p),
            up * std::cos(r) - right * std::sin(r)};
}

// Where it lies, north is along the next of its axes.
std::array<double, 3> SimulatedBoard::fieldAtCamera() const
{
    const int pose = m_stabilizer.pose();
    if (pose == 0)
        return earthField(m_stabilizer.trueAngle(Axis::Roll), m_stabilizer.trueAngle(Axis::Pitch),
                          m_stabilizer.trueAngle(Axis::Yaw));
    constexpr int kFaces = 6;
    if (pose > kFaces)
        return earthField(0, 45, 0);
    const auto &up = m_stabilizer.gravity();
    return {kEarthLevel * std::abs(up[2]) - kEarthDown * up[0],
            kEarthLevel * std::abs(up[0]) - kEarthDown * up[1],
            kEarthLevel * std::abs(up[1]) - kEarthDown * up[2]};
}

// Its heading holds the yaw angle, which nothing else corrects: towards where the iron beside it points as
// well, until a calibration has found that.
void SimulatedBoard::updateMagnetometer()
{
    const auto field = fieldAtCamera();
    std::array<double, 3> seen{};
    for (std::size_t i = 0; i < seen.size(); ++i) {
        m_magRaw[i] = dot(kSoftIron[i], field) + kMagBias[i] + m_sensorNoise.gauss(kMagNoise);
        seen[i] = (m_magRaw[i] - m_magZero[i]) * m_magScale[i];
    }
    updateMagCalibration();
    if (m_magCalibration.until > 0 || !m_stabilizer.imuPresent())
        return;
    const auto up = sensorAxis(int(value(u"imu.mag.axis_top"_s)));
    const auto right = sensorAxis(int(value(u"imu.mag.axis_right"_s)));
    const std::array<double, 3> front = frontOf(up, right);
    const auto along = [&seen](const std::array<double, 3> &axis) {
        return seen[0] * axis[0] + seen[1] * axis[1] + seen[2] * axis[2];
    };
    const std::array<double, 3> own{along(right), along(front), along(up)};
    const double r = radians(m_stabilizer.estimate(Axis::Roll));
    const double p = radians(m_stabilizer.estimate(Axis::Pitch));
    const double level = own[2] * std::cos(r) + own[0] * std::sin(r);
    const double across = own[0] * std::cos(r) - own[2] * std::sin(r);
    const double ahead = own[1] * std::cos(p) + level * std::sin(p);
    const double declination = value(u"imu.mag.declination"_s);
    const double heading = degrees(std::atan2(-across, ahead)) + declination;
    const double yaw = m_stabilizer.estimate(Axis::Yaw);
    m_headingError = angleBetween(
        own,
        earthField(m_stabilizer.estimate(Axis::Roll), m_stabilizer.estimate(Axis::Pitch), yaw - declination));
    const double pull = kMagPull * value(u"imu.mag.trust"_s) * Stabilizer::kCycle;
    m_stabilizer.setEstimate(Axis::Yaw, yaw + toHalfTurn(heading - yaw) * pull);
}

void SimulatedBoard::startMagCalibration(const Frame &frame)
{
    const bool isExtended = frame.payload.size() == 12;
    if (!isExtended && !hasSize(frame, 0))
        return;
    const int action = isExtended ? quint8(frame.payload[1]) : 1;
    if (action < 1 || action > 7 || (isExtended && quint8(frame.payload[0]) > kFrameImu)) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (isBusy()) {
        refuse(frame, kWrongState);
        return;
    }
    if (isExtended)
        confirm(frame);
    if (action == 2) {
        m_magZero = {};
        m_magScale = {1, 1, 1};
    }
    if (action == 2 || action == 4 || action == 5) {
        reply(frame, CommandId::Reset, {});
        restart(kResetNotice);
        return;
    }
    if (action != 1) {
        confirm(frame);
        return;
    }
    m_magCalibration = {m_now + kMagTime, frame.version, m_stabilizer.motorsOn(), m_magRaw, m_magRaw};
    m_stabilizer.setMotorsOn(false);
    m_stabilizer.setHeld(true);  // the operator takes the camera into his hand
}

// Unless he is told otherwise, the operator turns over and over what he is to turn.
Stabilizer::Hand SimulatedBoard::handOnCamera() const
{
    const Faults &faults = m_options.faults;
    const bool isAsked = m_magCalibration.until > 0 && faults.pose == 0 && faults.hand == 0;
    return isAsked ? Stabilizer::Hand::TurnsOver : Stabilizer::Hand(faults.hand);
}

// The zero is the middle of what was seen, and each
// axis is scaled to the same length: what iron bends askew is left.
void SimulatedBoard::updateMagCalibration()
{
    MagCalibration &run = m_magCalibration;
    if (run.until < 0)
        return;
    for (std::size_t i = 0; i < m_magRaw.size(); ++i) {
        run.low[i] = std::min(run.low[i], m_magRaw[i]);
        run.high[i] = std::max(run.high[i], m_magRaw[i]);
    }
    const double done = 1 - (run.until - m_now) / kMagTime;
    const bool isCutShort = m_options.faults.failWith != 0 && done > 0.5;
    if (m_now < run.until && !isCutShort)
        return;
    bool isSeen = true;
    for (std::size_t i = 0; i < m_magRaw.size(); ++i)
        isSeen &= run.high[i] - run.low[i] > kMagSpread;
    const double wide = (run.high[0] - run.low[0] + run.high[1] - run.low[1] + run.high[2] - run.low[2]) / 3;
    for (std::size_t i = 0; i < m_magRaw.size() && isSeen && !isCutShort; ++i) {
        m_magZero[i] = (run.high[i] + run.low[i]) / 2;
        m_magScale[i] = wide / (run.high[i] - run.low[i]);
    }
    for (const Axis axis : kAxes)
        m_stabilizer.plant(axis).setAngle(0.0);
    m_stabilizer.setHeld(false);
    m_stabilizer.resetEstimate();
    m_stabilizer.setMotorsOn(run.motorsWereOn && !m_emergency);
    sendEnd(CommandId::CalibMag, run.version,
            isCutShort    ? m_options.faults.failWith
                : !isSeen ? kOperationFailed
                          : 0);
    run = {};
}

}  // namespace simplebgc
