// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/segments.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/transmitter.h"
#include "protocol/simulator/bcflight/board.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bcflight {

namespace {

constexpr int kTransform = 512;
constexpr double kCellEmpty = 3.0;
constexpr double kCellFull = 4.2;

constexpr int kPowers[] = {14, 20, 26};  // dBm

QByteArray vector(const Vector3 &value)
{
    return bigF32(float(value.x)) + bigF32(float(value.y)) + bigF32(float(value.z));
}

}  // namespace

// From the voltage alone: its current sensor is not read (4.2).
double SimulatedBoard::batteryLevel() const
{
    return (m_quadcopter.voltage() / Quadcopter::kCells - kCellEmpty) / (kCellFull - kCellEmpty);
}

Telemetry SimulatedBoard::telemetry() const
{
    Telemetry now;
    now.voltage = m_quadcopter.voltage();
    now.charge = int(m_storedCharge);
    now.level = int(batteryLevel() * 100);
    now.cpuLoad = 31;
    now.cpuTemperature = m_options.faults.heat > 0 ? int(m_options.faults.heat) : 47;
    now.receiveQuality = 100;
    now.receiveLevel = -48;
    return now;
}

// Errata 8.1.
void SimulatedBoard::stream()
{
    if (m_streamRate <= 0 || !m_isConnected || m_isStreamPaused || m_now < m_nextStream)
        return;
    m_nextStream = std::max(m_nextStream + 1 / m_streamRate, m_now - 1);
    const quint64 tick = m_streamTick++;
    QByteArray packet;
    const auto add = [&](Message id, const QByteArray &payload) { packet += message(id, payload); };
    const auto number = [](double value) { return bigF32(float(value)); };
    const auto count = [](double value) { return bigU32(std::uint32_t(std::int64_t(value))); };
    if (tick % 10 == 0) {
        add(Message::StabilizerFrequency, count(1 / kCycle));
        if (m_isFull) {
            QByteArray outputs = bigU32(std::uint32_t(m_outputs.size()));
            for (const double output : m_outputs)
                outputs += number(output);
            add(Message::MotorsSpeed, outputs);
        }
    }
    if (tick % 5 == 0) {
        const Telemetry now = telemetry();
        add(Message::BatteryVoltage, number(now.voltage));
        add(Message::TotalCurrent, number(m_storedCharge / 1000));
        add(Message::CurrentDraw, number(0));
        add(Message::BatteryLevel, number(batteryLevel()));
        add(Message::CpuLoad, count(now.cpuLoad));
        add(Message::CpuTemperature, count(now.cpuTemperature));
        add(Message::ReceiveQuality, count(now.receiveQuality));
        add(Message::ReceiveLevel, count(now.receiveLevel));
    }
    // Before 2023-07-18 the attitude came in either mode (1).
    if (m_isFull || m_generation == Generation::A) {
        // Before the first arming the memory holds anything (8.2).
        add(Message::SetThrust, m_everArmed ? number(m_sticks.thrust) : bigU32(0x7FC0BEEF));
        add(Message::RollPitchYaw, vector(m_attitude));
        add(Message::CurrentAcceleration, number(m_calibrated ? m_quadcopter.acceleration().norm() : 0));
        add(Message::Altitude, number(0));
        const Vector3 none = Vector3();
        if (m_generation >= Generation::D)
            add(Message::Rates, vector(m_rate));
        // Raw only since D (1).
        const Vector3 gyro = m_generation >= Generation::D ? m_quadcopter.gyro() - m_zero : m_rate;
        add(Message::Gyro, vector(m_calibrated ? gyro : none));
        add(Message::Accel, vector(m_calibrated ? m_quadcopter.acceleration() : none));
        add(Message::Magn, vector(m_calibrated ? m_quadcopter.field() : none));
        add(Message::GyroDterm, vector(m_slowRate));
        if (m_generation >= Generation::E && m_configuration.contains("dynamic_notch"))
            add(Message::RateSpectrum, spectrum());
    }
    if (packet.isEmpty())
        return;
    send(packet);
    ++m_streamed.sent;
}

// The absolute real part, not the modulus (8.3).
QByteArray SimulatedBoard::spectrum() const
{
    auto segments = Segments::make(kTransform, 1 / kCycle,
                                   {.length = kTransform, .overlap = 0, .window = WindowShape::Rectangular});
    std::array<std::vector<float>, 3> magnitudes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<float> samples(kTransform);
        const std::size_t missing = kTransform - std::min<std::size_t>(kTransform, m_history.size());
        for (std::size_t i = missing; i < kTransform; ++i)
            samples[i] = float(m_history[i - missing][axis]);
        for (const std::complex<double> &bin : segments->transform(samples, 0))
            magnitudes[axis].push_back(float(std::abs(bin.real()) / kTransform));
        // A transform for spectra leaves the mean out; the drone's does not.
        magnitudes[axis].front()
            = std::abs(std::accumulate(samples.begin(), samples.end(), 0.0F)) / kTransform;
    }
    ByteWriter writer;
    for (int bin = 0; bin <= kTransform / 2; ++bin) {
        for (const auto &axis : magnitudes)
            writer.f32(axis[std::size_t(bin)]);
        writer.f32(0);
    }
    const QByteArray bytes = writer.take();
    return bigU16(std::uint16_t(bytes.size())) + bytes;
}

QByteArray SimulatedBoard::transmitter() const
{
    if (!m_options.own.value(QLatin1String(kTransmitter), 1))
        return QByteArray(5, char(0xFF)) + '\0';
    const auto channel = std::size_t(m_vtxChannel - 1);
    QByteArray powers;
    for (const int dbm : kPowers)
        powers.append(char(dbm));
    return QByteArray(1, char(m_vtxChannel))
        + bigU16(std::uint16_t(kTransmitterBands[channel / kBandChannels].mhz[channel % kBandChannels]))
        + char(m_vtxPower) + char(kPowers[m_vtxPower]) + char(std::size(kPowers)) + powers;
}

QByteArray SimulatedBoard::userName() const
{
    const qsizetype at = onlyCode(m_configuration).indexOf("username");
    const auto parts
        = at < 0 ? QList<QByteArray>() : m_configuration.sliced(at).split('\n').front().split('"');
    return parts.size() < 3 ? QByteArray("[unknown]") : parts[1];
}

QByteArray SimulatedBoard::boardText() const
{
    if (m_generation == Generation::A)
        return "Type:simulated\nFirmware version:" + m_version + "\n";
    return "{\n    [\"Type\"] = \"simulated\",\n    [\"Firmware version\"] = \"" + m_version
        + "\",\n    [\"Model\"] = \"quadcopter\",\n    [\"CPU cores count\"] = \"4\",\n}\n";
}

QByteArray SimulatedBoard::sensorsText() const
{
    const QByteArray table
        = "{\n    Accelerometers = {\n        [\"ICM-42605\"] = {\n            bus = {\n                "
          "speed = 2000000,\n"
          "            },\n            axis_swap = \"2,-1,3\",\n        },\n    },\n    Altimeters = nil,\n"
          "    Gyroscopes = {\n        [\"ICM-42605\"] = {\n            sample_rate = 8000,\n        },\n    "
          "},\n"
          "    Magnetometers = {\n        LIS3MDL = {\n        },\n    },\n}\n";
    return (m_generation == Generation::A ? QByteArray("Sensors = ") : QByteArray()) + table;
}

QByteArray SimulatedBoard::camerasText() const
{
    const auto view = cameraView();
    if (!view)
        return "nil";
    return "{\n    [\"Camera 0\"] = {\n        Device = \"simulated\",\n        Resolution = \"1280x720\",\n"
           "        Framerate = "
        + QByteArray::number(view->frameRate) + ",\n        HDR = \"false\",\n    },\n}\n";
}

}  // namespace bcflight
