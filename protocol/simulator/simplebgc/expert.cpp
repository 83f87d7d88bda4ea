// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What others tell the simulated board of its attitude, the buses behind it, and its boot loader (errata 3.20
// to 3.22).
#include "protocol/base/angles.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kMainSensor = 0x68 << 1;  // address byte: bit 0 is the bus
constexpr int kMemoryChip = 0x50 << 1 | 1;
constexpr int kWhoAmI = 0x75;
constexpr int kWideModeSince = 2695;
constexpr double kTrust = 0.05;  // of a reference, each time it is told
constexpr double kNoticeLeaves = 0.005;  // seconds
constexpr double kFrameHolds = 0.5;  // seconds for which what was told of the frame counts

}  // namespace

bool SimulatedBoard::handleExpert(const Frame &frame)
{
    ByteReader reader(frame.payload);
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::AhrsHelper: return takeAttitude(frame);
    case CommandId::GyroCorrection: correctGyro(frame); return true;
    case CommandId::HelperData:
        if (frame.payload.size() < 10) {
            refuse(frame, kWrongSize);
            return true;
        }
        reader.skip(6);
        m_frameTold = {reader.i16() * kDegreesPerCount, reader.i16() * kDegreesPerCount, 0.0};
        m_frameToldUntil = m_now + kFrameHolds;
        return true;
    case CommandId::I2cReadRegBuf: {
        const int address = reader.u8();
        const int reg = reader.u8();
        const int length = reader.u8();
        const auto bytes = reader.ok() && length >= 1 && length <= kMostI2c ? busBytes(address, reg, length)
                                                                            : std::nullopt;
        if (bytes)
            reply(frame, CommandId::I2cReadRegBuf, *bytes);
        else
            refuse(frame, kOperationFailed);
        return true;
    }
    case CommandId::I2cWriteRegBuf: {
        const int address = reader.u8();
        const int reg = reader.u8();
        const QByteArray bytes = toByteArray(reader.take(reader.remaining()));
        if (!reader.ok() || bytes.isEmpty() || !busBytes(address, reg, 1)) {
            refuse(frame, kOperationFailed);
            return true;
        }
        takeBusBytes(address, reg, bytes);
        confirm(frame);
        return true;
    }
    case CommandId::BootMode3: {
        double delay = 0;
        if (frame.payload.size() >= 3) {
            if (reader.u8() & 1)
                reply(frame, CommandId::Reset, {});
            delay = reader.u16() * 0.001;
        }
        m_bootLoaderAt = m_now + delay + kNoticeLeaves;
        return true;
    }
    default: return false;
    }
}

// Replaces or corrects what the main sensor believes; of the frame it is what counts for half a second.
bool SimulatedBoard::takeAttitude(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const int mode = reader.u8();
    if (!(mode & 1)) {
        reply(frame, CommandId::AhrsHelper, attitudeVectors(mode & 2 && isFrameSensor()));
        return true;
    }
    if (m_options.firmware >= kWideModeSince)
        reader.skip(1);
    std::array<double, 6> vectors{};
    for (double &each : vectors)
        each = std::clamp(double(reader.f32()), -1.0, 1.0);
    if (!reader.ok()) {
        refuse(frame, kWrongSize);
        return true;
    }
    const bool hasGravity = !(mode & 32);  // bits 4 and 5: one of the vectors alone
    const bool hasHeading = !(mode & 16);
    const std::array<double, kAxisCount> told{degrees(std::asin(vectors[0])), degrees(std::asin(-vectors[1])),
                                              degrees(std::atan2(vectors[3], vectors[4]))};
    if (mode & 2) {
        m_frameTold = told;
        m_frameToldUntil = m_now + kFrameHolds;
        return true;
    }
    for (const Axis axis : kAxes) {
        if (axis == Axis::Yaw ? !hasHeading : !hasGravity)
            continue;
        const double before = m_stabilizer.estimate(axis);
        const double share = mode & 4 ? kTrust : 1.0;
        m_stabilizer.setEstimate(axis, before + share * (told[std::size_t(axis)] - before));
    }
    return true;
}

// A zero offset on top of the calibration; the next one replaces it.
void SimulatedBoard::correctGyro(const Frame &frame)
{
    if (!hasSize(frame, 9) || quint8(frame.payload[0]) != 0)
        return;
    ByteReader reader(frame.payload);
    reader.skip(1);
    std::array<double, kAxisCount> zero{};
    for (double &each : zero)
        each = reader.i16() * 0.001 * kGyroUnit;
    zero[std::size_t(Axis::Yaw)] += reader.i16() * 0.001 * kGyroUnit;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_stabilizer.imu().gyroCorrection[i] += zero[i] - m_gyroTold[i];
    m_gyroTold = zero;
}

// The motion sensor on the bus of sensors, the memory chip on the inner one.
std::optional<QByteArray> SimulatedBoard::busBytes(int address, int reg, int length) const
{
    if (address == kMemoryChip)
        return memory().mid(reg, length);
    if (address != kMainSensor || !m_stabilizer.imuPresent())
        return {};
    QByteArray bytes;
    for (int at = reg; at < reg + length; ++at)
        bytes.append(char(m_sensorRegisters.value(at, at == kWhoAmI ? 0x68 : 0)));
    return bytes;
}

void SimulatedBoard::takeBusBytes(int address, int reg, const QByteArray &bytes)
{
    if (address == kMemoryChip) {
        QByteArray all = memory();
        all.replace(reg, bytes.size(), bytes);
        setMemory(all);
        return;
    }
    for (const char byte : bytes) {
        if (reg != kWhoAmI)
            m_sensorRegisters[reg] = quint8(byte);
        ++reg;
    }
}

}  // namespace simplebgc
