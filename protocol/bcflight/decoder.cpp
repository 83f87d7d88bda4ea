// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/decoder.h"

#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/bcflight/tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bcflight {

namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kAbsurd = 1e5F;
constexpr Duration kStreamed = 2s;

/// Where the fields of a streamed message go: channels in a row, and a factor.
struct Place
{
    Message id;
    int first;
    float factor = 1;
};
constexpr Place kPlaces[] = {
    {Message::RollPitchYaw, AttitudeRoll},
    {Message::Rates, RateRoll},
    {Message::Gyro, GyroX},
    {Message::Accel, AccelX},
    {Message::Magn, FieldX},
    {Message::GyroDterm, SlowRateRoll},
    {Message::CurrentAcceleration, AccelLength},
    {Message::Altitude, Height},
    {Message::SetThrust, Thrust},
    {Message::BatteryVoltage, BatteryVolts},
    {Message::TotalCurrent, BatteryCharge, 1000},  // Ah
    {Message::CurrentDraw, BatteryCurrent},
    {Message::BatteryLevel, BatteryShare, 100},
    {Message::CpuLoad, CpuLoad},
    {Message::CpuTemperature, CpuCelsius},
    {Message::ReceiveQuality, LinkQuality},
    {Message::ReceiveLevel, LinkLevel},
    {Message::StabilizerFrequency, Loops},
};

}  // namespace

void Decoder::decode(const FrameView &frame, TimePoint at, TelemetryStore &store)
{
    const auto id = Message(frame.id);
    if (frame.id == kDiscarded)
        return;
    if (id == Message::Status) {
        if (const auto status = Status::decode(frame.payload))
            put(State,
                {float(status->bits()), float(status->armed), float(status->calibrated),
                 float(status->calibrating)},
                at, store);
        return;
    }
    if (id == Message::Telemetry)
        return putTelemetry(frame.payload, at, store);
    if (id == Message::MotorsSpeed)
        return putOutputs(frame.payload, at, store);
    if (id == Message::RateSpectrum)
        return putSpectrum(frame.payload, at, store);
    const auto *place = std::find_if(std::begin(kPlaces), std::end(kPlaces),
                                     [id](const Place &each) { return each.id == id; });
    const MessageSpec *spec = place == std::end(kPlaces) ? nullptr : findMessage(id);
    if (!spec)
        return;
    if (id == Message::BatteryVoltage)
        m_streamedAt = at;
    std::vector<float> values;
    for (const FieldValue &field : decodeFields(*spec->fromDrone, frame.payload))
        values.push_back(float(field.number) * place->factor);
    // Before the first arming this is whatever the memory held (errata 6.4).
    if (id == Message::SetThrust && !(values.front() >= 0 && values.front() <= 1))
        values.front() = kNoNumber;
    put(place->first, std::move(values), at, store);
}

void Decoder::put(int first, std::vector<float> values, TimePoint at, TelemetryStore &store)
{
    for (float &value : values) {
        if (!(std::abs(value) < kAbsurd))
            value = kNoNumber;
    }
    auto &group = m_groups[{first, values.size()}];
    if (!group) {
        QList<int> channels(int(values.size()), 0);
        std::iota(channels.begin(), channels.end(), first);
        group = store.defineGroup(channels, 0);
    }
    store.append(*group, at, values);
}

// Shares of full output, nominal 0 to 1; they can exceed it (errata 6.3).
void Decoder::putOutputs(Bytes payload, TimePoint at, TelemetryStore &store)
{
    const auto fields = decodeFields(*findMessage(Message::MotorsSpeed)->fromDrone, payload);
    if (fields.empty())
        return;
    std::vector<float> values = fields.front().numbers;
    if (values.empty() || values.size() > kMostMotors)
        return;
    const bool isKnown
        = std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
    const bool isDriven = std::any_of(values.begin(), values.end(), [](float value) { return value > 0; });
    if (!m_outputs || m_motors != values.size()) {
        m_motors = values.size();
        QList<int> channels(int(m_motors), 0);
        std::iota(channels.begin(), channels.end(), int(Motor1));
        m_outputs = store.defineGroup(channels << int(Outputs), 0);
    }
    for (float &value : values)
        value *= 100;
    values.push_back(isKnown ? float(isDriven) : kNoNumber);
    store.append(*m_outputs, at, values);
}

// The same as in the stream, with fewer digits; it is what a drone that does not stream tells.
void Decoder::putTelemetry(Bytes payload, TimePoint at, TelemetryStore &store)
{
    const auto now = Telemetry::decode(payload);
    if (!now || (m_streamedAt != TimePoint{} && at - m_streamedAt < kStreamed))
        return;
    put(BatteryVolts,
        {float(now->voltage), float(now->charge), float(now->current), float(now->level), float(now->cpuLoad),
         float(now->cpuTemperature), float(now->receiveQuality), float(now->receiveLevel)},
        at, store);
}

void Decoder::putSpectrum(Bytes payload, TimePoint at, TelemetryStore &store)
{
    const auto fields = decodeFields(*findMessage(Message::RateSpectrum)->fromDrone, payload);
    if (fields.empty())
        return;
    const std::vector<float> &numbers = fields.front().numbers;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> bins;
        for (std::size_t i = std::size_t(axis); i < numbers.size(); i += 4)
            bins.push_back(std::isfinite(numbers[i]) ? numbers[i] : 0);
        store.appendArray(SpectrumRoll + axis, at, std::move(bins));
    }
}

}  // namespace bcflight
