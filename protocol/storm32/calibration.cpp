// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration of the accelerometers (errata 9.2).
#include "protocol/base/linkloss.h"
#include "protocol/storm32/procedures.h"
#include "protocol/storm32/telemetrytables.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr int kReadings = 256;
constexpr int kBatch = 16;  // number of readings evaluated together while waiting
constexpr double kStillShare = 0.012;  // of 1 g: deviation of a sensor at rest, noise included
constexpr auto kPlaceLimit = 120s;  // for one face
constexpr double kMinVector = 100;  // counts; with less there is no sensor (errata 9.3)
constexpr int kStillLooks = 3;  // batches before what a sensor at rest says counts

}  // namespace

Error Procedures::notGravity(const AccReading &acc) const
{
    return {ErrorCode::NotSeen,
            u"the sensor measures %1 g instead of 1 g, which none at rest does: something moves it, or it is "
            "defective"_s.arg(std::hypot(acc[0], acc[1], acc[2]) / oneG(), 0, 'f', 2),
            0};
}

bool Procedures::Sensor::isPresent() const
{
    return std::hypot(acc[0], acc[1], acc[2]) >= kMinVector;
}

double Procedures::oneG() const
{
    return m_device.m_firmware >= 94 ? 8192.0 : 16384.0;  // errata 3.9
}

Result<Procedures::Sensors> Procedures::sensors()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::RawSensors));
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->payload.size() != 28)
        return failure(ErrorCode::BadReply, u"Cd: %1 bytes"_s.arg(reply->payload.size()));
    ByteReader reader(reply->payload);
    Sensors sensors;
    for (Sensor &sensor : sensors) {
        for (double &axis : sensor.acc)
            axis = reader.i16();
        for (int i = 0; i < 3; ++i)
            reader.i16();  // gyroscope
        sensor.temperature = reader.i16() / 340.0 + 36.53;  // errata 3.9
    }
    return sensors;
}

Result<Procedures::Sensor> Procedures::sensor(int imu)
{
    const auto both = sensors();
    if (!both)
        return tl::unexpected(both.error());
    const Sensor &sensor = (*both)[imu == 2 ? 1 : 0];
    if (!sensor.isPresent())
        return failure(ErrorCode::NotSeen, u"there is no sensor Imu%1"_s.arg(imu == 2 ? u"2"_s : QString()));
    return sensor;
}

Result<Procedures::Average> Procedures::average(int imu, int readings, Progress &progress)
{
    std::vector<Sensor> all;
    Average result;
    for (int i = 0; i < readings; ++i) {
        const auto one = sensor(imu);
        if (!one)
            return tl::unexpected(one.error());
        all.push_back(*one);
        result.temperature += one->temperature / readings;
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.acc[axis] += one->acc[axis] / readings;
        progress.values.insert(u"measured"_s, readings > kBatch ? double(i + 1) / readings : 0.0);
        if (i % kBatch == kBatch - 1)
            m_channel.progress(progress);
    }
    for (const Sensor &one : all) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.deviation += std::abs(one.acc[axis] - result.acc[axis]) / (3.0 * readings);
    }
    result.face = faceUp(result.acc, oneG());
    return result;
}

// Between two looks somebody else can have switched them on: a receiver, a button at the board.
Result<void> Procedures::keepMotorsOff()
{
    const auto now = status();
    if (now && now->motors == 0 && isStandby(now->state, m_device.m_firmware))
        return {};
    m_switchedOff = m_switchedOff || (now && now->motors != 0);
    return m_device.stopMotors(m_channel);
}

Result<Procedures::Average> Procedures::face(int imu, unsigned wanted, bool byHand, Progress &progress)
{
    const TimePoint until = m_channel.now() + kPlaceLimit;
    int still = 0;
    int impossible = 0;
    int last = -1;
    std::optional<Error> why;
    while (m_channel.now() < until) {
        if (const auto off = byHand ? keepMotorsOff() : Result<void>(); !off)
            return tl::unexpected(off.error());
        progress.step = u"place-sensor"_s;
        auto seen = average(imu, kBatch, progress);
        if (!seen)
            return seen;
        const bool moves = seen->deviation > kStillShare * oneG();
        const bool isPossible = isGravity(seen->acc, oneG());
        for (std::size_t axis = 0; axis < 3; ++axis)
            progress.values.insert(QLatin1String(kSensorAxes[axis]), seen->acc[axis] / oneG());
        progress.values.insert(u"deviation"_s, seen->deviation / oneG());
        progress.values.insert(u"temperature"_s, seen->temperature);
        progress.values.insert(u"face"_s, seen->face);
        progress.values.insert(u"moves"_s, moves);
        progress.values.insert(u"impossible"_s, !moves && !isPossible);
        m_channel.progress(progress);
        impossible = moves || isPossible ? 0 : impossible + 1;
        why = impossible > 0 ? std::optional(notGravity(seen->acc)) : std::nullopt;
        if (impossible > kStillLooks && !byHand)
            break;
        const bool good = isPossible && seen->face >= 0 && !moves && wanted >> seen->face & 1U;
        still = good && seen->face == last ? still + 1 : 0;
        last = good ? seen->face : -1;
        if (still < kStillLooks)
            continue;
        progress.step = u"calibrate"_s;
        auto measured = average(imu, kReadings, progress);
        if (!measured)
            return measured;
        if (measured->face == last && measured->deviation <= kStillShare * oneG()
            && isGravity(measured->acc, oneG()))
            return measured;
        still = 0;  // it was moved: start over
    }
    if (why)
        return tl::unexpected(*why);
    return failure(ErrorCode::NotSeen, u"no further face lay still for %1 s"_s.arg(seconds(kPlaceLimit)));
}

ActionReply Procedures::replyOf(const AccCalibration &calibration, double oneG, double temperature)
{
    ActionReply reply;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        reply.insert(u"zero.%1"_s.arg(QLatin1String(kSensorAxes[axis])), calibration.zero[axis]);
        reply.insert(u"scale.%1"_s.arg(QLatin1String(kSensorAxes[axis])), calibration.scale[axis]);
    }
    reply.insert(u"quality"_s, calibration.quality / oneG);
    reply.insert(u"plausible"_s, isPlausible(calibration, oneG));
    reply.insert(u"one_g"_s, oneG);
    reply.insert(u"temperature"_s, temperature);
    return reply;
}

Result<ActionReply> Procedures::averaged(int imu, int readings)
{
    Progress progress;
    progress.step = u"calibrate"_s;
    progress.total = 1;
    const auto result = average(imu, readings, progress);
    if (!result)
        return tl::unexpected(result.error());
    return ActionReply{{u"x"_s, result->acc[0]},
                       {u"y"_s, result->acc[1]},
                       {u"z"_s, result->acc[2]},
                       {u"deviation"_s, result->deviation},
                       {u"temperature"_s, result->temperature},
                       {u"one_g"_s, oneG()},
                       {u"face"_s, result->face}};
}

Result<ActionReply> Procedures::calibrate(int imu, bool six, bool store)
{
    Progress progress;
    progress.total = six ? kAccFaces : 1;
    std::array<AccReading, kAccFaces> readings{};
    unsigned missing = (1U << kAccFaces) - 1;
    AccCalibration calibration;
    double temperature = 0;
    // Before motors are stopped for it.
    if (const auto there = sensor(imu); !there)
        return tl::unexpected(there.error());
    while (progress.done < progress.total) {
        const auto measured = face(imu, missing, six, progress);
        if (!measured)
            return tl::unexpected(measured.error());
        readings[std::size_t(measured->face)] = measured->acc;
        missing &= ~(1U << measured->face);
        ++progress.done;
        progress.values.insert(u"missing"_s, missing);
        m_channel.progress(progress);
        temperature = measured->temperature;
        calibration = onePointCalibration(measured->acc, oneG());
    }
    if (six)
        calibration = sixPointCalibration(readings);
    ActionReply reply = replyOf(calibration, oneG(), temperature);
    if (m_switchedOff)
        reply.insert(u"motors_switched_off"_s, true);  // whoever holds the camera starts them again
    if (!store)
        return reply;
    if (const auto checked = checkPlausible(calibration); !checked)
        return tl::unexpected(checked.error());
    if (const auto written = writeCalibration(imu, calibration); !written)
        return tl::unexpected(written.error());
    reply.insert(u"stored"_s, true);
    return reply;
}

Result<void> Procedures::checkPlausible(const AccCalibration &calibration) const
{
    if (isPlausible(calibration, oneG()))
        return {};
    return failure(ErrorCode::OutOfRange,
                   u"no sensor is like that: zeros %1 %2 %3, scales %4 %5 %6"_s.arg(calibration.zero[0])
                       .arg(calibration.zero[1])
                       .arg(calibration.zero[2])
                       .arg(calibration.scale[0])
                       .arg(calibration.scale[1])
                       .arg(calibration.scale[2]));
}

// Writes only the words of this sensor, by its selector; reads back and compares.
Result<void> Procedures::writeCalibration(int imu, const AccCalibration &calibration)
{
    const int first = imu == 2 ? 9 : 0;
    ByteWriter writer;
    writer.u16(imu == 2 ? 3 : 1).zeros(2 * first);
    for (const auto *values : {&calibration.zero, &calibration.scale}) {
        for (const int value : *values)
            writer.i16(value);
    }
    writer.zeros(36 - 2 * first - 12);
    // Whatever was answered, what is stored then counts.
    const auto written = m_channel.transact(m_device.simple(Simple::WriteCalibration, writer.take()));
    if (!written && (isLinkLoss(written.error()) || written.error().code == ErrorCode::Cancelled))
        return tl::unexpected(written.error());
    const auto now = m_channel.transact(m_device.simple(Simple::ReadCalibration));
    if (!now)
        return tl::unexpected(written ? now.error() : written.error());
    ByteReader reader(QByteArrayView(now->payload).sliced(2 * first));
    for (const auto *values : {&calibration.zero, &calibration.scale}) {
        for (const int value : *values) {
            if (const int found = reader.i16(); found != value)
                return written
                    ? failure(ErrorCode::VerifyFailed, u"%1 was written, %2 read"_s.arg(value).arg(found))
                    : tl::unexpected(written.error());
        }
    }
    return {};
}

}  // namespace storm32
