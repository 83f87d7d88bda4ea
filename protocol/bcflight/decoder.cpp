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
constexpr std::size_t kPlausibleMotors = 32;
constexpr float kLevelUnknown = -200;
constexpr int kLevelUnknownByte = 56;  // the same, cut to a byte

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

// Neither none nor beyond anything that can be measured (errata 8.2).
bool isNumber(float value)
{
    return std::isfinite(value) && std::abs(value) <= kAbsurd;
}

// What the attitude unit measures or makes of it (errata 8.1).
bool isOfAttitude(Message id)
{
    static constexpr Message kItems[] = {Message::RollPitchYaw, Message::CurrentAcceleration,
                                         Message::Altitude,     Message::Rates,
                                         Message::Gyro,         Message::Accel,
                                         Message::Magn,         Message::GyroDterm};
    return std::ranges::find(kItems, id) != std::end(kItems);
}

}  // namespace

void Decoder::decode(const FrameView &frame, TimePoint at, TelemetryStore &store)
{
    const auto id = Message(frame.id);
    if (frame.id == kDiscarded)
        return;
    if (id == Message::Status) {
        if (const auto status = Status::decode(frame.payload)) {
            m_isBlind = !status->calibrated && !status->calibrating;
            put(State,
                {float(status->bits()), float(status->armed), float(status->calibrated),
                 float(status->calibrating)},
                at, store);
        }
        return;
    }
    if (id == Message::Ping)
        return putRoundTrip(frame.payload, at, store);
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
    // 0 for ever, or the last of what was (errata 8.2): a horizon that lies level would be believed.
    if (m_isBlind && isOfAttitude(id))
        std::ranges::fill(values, kNoNumber);
    // Before the first arming this is whatever the memory held (errata 6.4).
    if (id == Message::SetThrust && !(values.front() >= 0 && values.front() <= 1))
        values.front() = kNoNumber;
    if (id == Message::CurrentDraw && !isCurrentTold(values.front()))
        return;
    if (id == Message::ReceiveLevel && values.front() == kLevelUnknown)
        values.front() = kNoNumber;
    if (id == Message::BatteryVoltage)
        m_volts = double(values.front());
    const double level = double(values.front()) / 100;
    put(place->first, std::move(values), at, store);
    if (id == Message::BatteryLevel)
        putCells(m_volts, level, at, store);
}

// Its own number of cells is not on the wire.
void Decoder::putCells(double volts, double level, TimePoint at, TelemetryStore &store)
{
    if (const int cells = countedCells(volts, level); cells > 0)
        put(BatteryCells, {float(cells)}, at, store);
}

// A drone whose sensor is not read tells 0 for ever (errata 4.2). That is no value: what answers draws some.
bool Decoder::isCurrentTold(double ampere)
{
    m_hasCurrent |= ampere != 0;
    return m_hasCurrent;
}

void Decoder::put(int first, std::vector<float> values, TimePoint at, TelemetryStore &store)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (isNumber(values[i]))
            continue;
        values[i] = kNoNumber;
        store.countInvalid(first + int(i));
    }
    auto &group = m_groups[{first, values.size()}];
    if (!group) {
        QList<int> channels(int(values.size()), 0);
        std::iota(channels.begin(), channels.end(), first);
        group = store.defineGroup(channels, 0);
    }
    store.append(*group, at, values);
}

// Shares of full output, nominal 0 to 1; they can exceed it (errata 6.3). Of more motors than there are
// channels, all count for whether any is driven.
void Decoder::putOutputs(Bytes payload, TimePoint at, TelemetryStore &store)
{
    std::vector<float> values = outputsIn(payload);
    if (values.empty() || values.size() > kPlausibleMotors)
        return;
    const bool isKnown
        = std::all_of(values.begin(), values.end(), [](float value) { return isNumber(value); });
    const bool isDriven = areDriven(values);
    values.resize(std::min(values.size(), std::size_t(kMostMotors)));
    if (!m_outputs || m_motors != values.size()) {
        m_motors = values.size();
        QList<int> channels(int(m_motors), 0);
        std::iota(channels.begin(), channels.end(), int(Motor1));
        m_outputs = store.defineGroup(channels << int(Outputs), 0);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!isNumber(values[i]))
            store.countInvalid(Motor1 + int(i));
        values[i] = isNumber(values[i]) ? values[i] * 100 : kNoNumber;
    }
    values.push_back(isKnown ? float(isDriven) : kNoNumber);
    store.append(*m_outputs, at, values);
}

// The drone gives back what it was told of the round trip before (errata 3), so a recording has it as well.
void Decoder::putRoundTrip(Bytes payload, TimePoint at, TelemetryStore &store)
{
    const auto fields = decodeFields(*findMessage(Message::Ping)->fromDrone, payload);
    if (fields.size() == 2)
        put(RoundTrip, {float(fields[1].number)}, at, store);
}

// The same as in the stream, with fewer digits; it is what a drone that does not stream tells.
void Decoder::putTelemetry(Bytes payload, TimePoint at, TelemetryStore &store)
{
    const auto now = Telemetry::decode(payload);
    if (!now || (m_streamedAt != TimePoint{} && at - m_streamedAt < kStreamed))
        return;
    put(BatteryVolts, {float(now->voltage), float(now->charge)}, at, store);
    putCells(now->voltage, now->level / 100.0, at, store);
    if (isCurrentTold(now->current))
        put(BatteryCurrent, {float(now->current)}, at, store);
    put(BatteryShare,
        {float(now->level), float(now->cpuLoad), float(now->cpuTemperature), float(now->receiveQuality),
         now->receiveLevel == kLevelUnknownByte ? kNoNumber : float(now->receiveLevel)},
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
        for (std::size_t i = std::size_t(axis); i < numbers.size(); i += 4) {
            bins.push_back(isNumber(numbers[i]) ? numbers[i] : kNoNumber);
            if (!isNumber(numbers[i]))
                store.countInvalid(SpectrumRoll + axis);
        }
        store.appendArray(SpectrumRoll + axis, at, std::move(bins));
    }
}

}  // namespace bcflight
