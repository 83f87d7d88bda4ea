// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/payloads.h"

#include "protocol/base/battery.h"
#include "protocol/base/checksum.h"

#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr int kFull = 511;  // of 10 bits with a sign
constexpr int kOldFull = 127;  // of 8 bits, generations A to C
constexpr std::uint64_t kArm = std::uint64_t(1) << 40;
constexpr std::uint64_t kSmoothing = std::uint64_t(1) << 44;

template <typename T> T big(ByteReader &reader)
{
    return qFromBigEndian(reader.read<T>());
}

float bigFloat(ByteReader &reader)
{
    return std::bit_cast<float>(big<std::uint32_t>(reader));
}

template <typename T> QByteArray bigBytes(T value)
{
    const T swapped = qToBigEndian(value);
    return {reinterpret_cast<const char *>(&swapped), sizeof swapped};
}

int counts(double share, int low, int full)
{
    return std::isnan(share) ? 0 : std::max(low, int(std::clamp(share, -1.0, 1.0) * full));
}

double shareOf(std::uint64_t field)
{
    const int value = int(field & 0x3FF);
    return double(value >= 512 ? value - 1024 : value) / kFull;
}

bool isOpen(FieldType type)
{
    return type == FieldType::Text || type == FieldType::Rest;
}

std::pair<double, double> rangeOf(const FieldSpec &field)
{
    if (field.min != 0 || field.max != 0)
        return {field.min, field.max};
    switch (field.type) {
    case FieldType::U8: return {0, 0xFF};
    case FieldType::S8: return {-0x80, 0x7F};
    case FieldType::U16:
    case FieldType::LeU16: return {0, 0xFFFF};
    case FieldType::U32: return {0, 0xFFFFFFFFU};
    case FieldType::S32: return {std::numeric_limits<qint32>::min(), std::numeric_limits<qint32>::max()};
    default: return {-std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    }
}

void writeNumber(QByteArray &bytes, FieldType type, double number)
{
    switch (type) {
    case FieldType::U8:
    case FieldType::S8: bytes.append(char(int(number))); break;
    case FieldType::U16: bytes.append(bigU16(std::uint16_t(number))); break;
    case FieldType::LeU16: bytes.append(ByteWriter().u16(int(number)).take()); break;
    case FieldType::U32: bytes.append(bigU32(std::uint32_t(number))); break;
    case FieldType::S32: bytes.append(bigU32(std::uint32_t(qint32(number)))); break;
    default: bytes.append(bigF32(float(number))); break;
    }
}

}  // namespace

QByteArray bigU32(std::uint32_t value)
{
    return bigBytes(value);
}

QByteArray bigU16(std::uint16_t value)
{
    return bigBytes(value);
}

QByteArray bigF32(float value)
{
    return bigBytes(std::bit_cast<std::uint32_t>(value));
}

std::vector<FieldValue> decodeFields(std::span<const FieldSpec> fields, Bytes payload, int stickBytes)
{
    std::vector<FieldValue> values;
    std::size_t at = 0;
    for (const FieldSpec &field : fields) {
        const auto size = payloadSize({&field, 1}, payload.subspan(at), stickBytes);
        const Bytes bytes = payload.subspan(at, size.value_or(payload.size() - at));
        if (!size && field.type != FieldType::Text)
            break;
        FieldValue value{&field};
        ByteReader reader(bytes);
        switch (field.type) {
        case FieldType::U8: value.number = reader.u8(); break;
        case FieldType::S8: value.number = reader.i8(); break;
        case FieldType::U16: value.number = big<std::uint16_t>(reader); break;
        case FieldType::LeU16: value.number = reader.u16(); break;
        case FieldType::U32: value.number = big<std::uint32_t>(reader); break;
        case FieldType::S32: value.number = qint32(big<std::uint32_t>(reader)); break;
        case FieldType::F32: value.number = double(bigFloat(reader)); break;
        case FieldType::Floats:
            for (std::uint32_t left = big<std::uint32_t>(reader); left > 0 && reader.ok(); --left)
                value.numbers.push_back(bigFloat(reader));
            break;
        case FieldType::Bins:
            reader.skip(2);
            while (reader.remaining() >= sizeof(float))
                value.numbers.push_back(reader.f32());
            break;
        case FieldType::Powers:
            for (int left = reader.u8(); left > 0 && reader.ok(); --left)
                value.numbers.push_back(float(reader.u8()));
            break;
        case FieldType::Text: value.bytes = toByteArray(bytes.first(bytes.size() - (size ? 1 : 0))); break;
        case FieldType::Sticks:
        case FieldType::Rest: value.bytes = toByteArray(bytes); break;
        }
        at += bytes.size();
        values.push_back(std::move(value));
    }
    return values;
}

Result<QByteArray> encodeFields(std::span<const FieldSpec> fields, const std::vector<double> &numbers,
                                QByteArrayView last)
{
    const bool hasOpen = !fields.empty() && isOpen(fields.back().type);
    if (numbers.size() + (hasOpen ? 1 : 0) != fields.size())
        return failure(ErrorCode::InvalidArgument,
                       u"%1 fields are needed, not %2"_s.arg(fields.size()).arg(numbers.size()));
    QByteArray bytes;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [low, high] = rangeOf(fields[i]);
        const QString name = QString::fromUtf8(fields[i].name);
        if (!std::isfinite(numbers[i]))
            return failure(ErrorCode::InvalidArgument, u"%1: %2 is no number"_s.arg(name).arg(numbers[i]));
        if (numbers[i] < low || numbers[i] > high)
            return failure(ErrorCode::OutOfRange,
                           u"%1 = %2, allowed %3..%4"_s.arg(name).arg(numbers[i]).arg(low).arg(high));
        writeNumber(bytes, fields[i].type, numbers[i]);
    }
    bytes.append(last);
    if (hasOpen && fields.back().type == FieldType::Text)
        bytes.append('\0');
    return bytes;
}

std::optional<Status> Status::decode(Bytes payload)
{
    ByteReader reader(payload);
    const auto bits = big<std::uint32_t>(reader);
    if (!reader.ok())
        return {};
    return Status{(bits & kArmed) != 0, (bits & kCalibrated) != 0, (bits & kCalibrating) != 0,
                  bits & ~(kArmed | kCalibrated | kCalibrating)};
}

std::uint32_t Status::bits() const
{
    return (armed ? kArmed : 0) | (calibrated ? kCalibrated : 0) | (calibrating ? kCalibrating : 0) | others;
}

int countedCells(double volts, double level)
{
    constexpr double kEmpty = 3.0;
    constexpr double kFull = 4.2;
    // Beyond a full cell it may be anything, and nobody flies with one below half of an empty one.
    if (!(volts > kNoBatteryVolts) || !(level >= -0.5 && level <= 1))
        return 0;
    return int(std::lround(volts / (kEmpty + (kFull - kEmpty) * level)));
}

int Controls::size(Generation generation)
{
    return generation == Generation::Unknown || generation >= Generation::D ? 6 : 5;
}

QByteArray Controls::encode(Generation generation) const
{
    if (size(generation) == 5)
        return ByteWriter()
            .i8(counts(thrust, 0, kOldFull))
            .i8(counts(roll, -kOldFull, kOldFull))
            .i8(counts(pitch, -kOldFull, kOldFull))
            .i8(counts(yaw, -kOldFull, kOldFull))
            .u8(arm ? 1 : 0)
            .take();
    const auto field = [](double share, int low, int shift) {
        return (std::uint64_t(counts(share, low, kFull)) & 0x3FF) << shift;
    };
    const std::uint64_t word = field(thrust, 0, 0) | field(roll, -kFull, 10) | field(pitch, -kFull, 20)
        | field(yaw, -kFull, 30) | (arm ? kArm : 0)
        | (smoothing && generation == Generation::G ? kSmoothing : 0);
    return ByteWriter().write(word).take().first(6);
}

std::optional<Controls> Controls::decode(Bytes payload, Generation generation)
{
    if (payload.size() < std::size_t(size(generation)))
        return {};
    if (size(generation) == 5) {
        ByteReader reader(payload);
        const auto share = [&reader] { return double(reader.i8()) / kOldFull; };
        Controls controls;
        controls.thrust = share();
        controls.roll = share();
        controls.pitch = share();
        controls.yaw = share();
        controls.arm = (reader.u8() & 1) != 0;
        return controls;
    }
    std::uint64_t word = 0;
    for (int i = 5; i >= 0; --i)
        word = word << 8 | std::to_integer<std::uint64_t>(payload[std::size_t(i)]);
    return Controls{shareOf(word),       shareOf(word >> 10), shareOf(word >> 20),
                    shareOf(word >> 30), (word & kArm) != 0,  (word & kSmoothing) != 0};
}

std::optional<Telemetry> Telemetry::decode(Bytes payload)
{
    ByteReader reader(payload);
    Telemetry telemetry;
    telemetry.voltage = reader.u16() / 100.0;
    telemetry.charge = reader.u16();
    telemetry.current = reader.u8() / 10.0;
    telemetry.level = reader.i8();
    telemetry.cpuLoad = reader.u8();
    telemetry.cpuTemperature = reader.u8();
    telemetry.receiveQuality = reader.i8();
    telemetry.receiveLevel = reader.i8();
    return reader.ok() ? std::optional(telemetry) : std::nullopt;
}

QByteArray Telemetry::encode() const
{
    return ByteWriter()
        .u16(int(voltage * 100))
        .u16(int(charge))
        .u8(int(current * 10))
        .i8(level)
        .u8(cpuLoad)
        .u8(cpuTemperature)
        .i8(receiveQuality)
        .i8(receiveLevel)
        .take();
}

std::vector<float> outputsIn(Bytes payload)
{
    const auto fields = decodeFields(*findMessage(Message::MotorsSpeed)->fromDrone, payload);
    return fields.empty() ? std::vector<float>() : fields.front().numbers;
}

bool areDriven(const std::vector<float> &outputs)
{
    return std::any_of(outputs.begin(), outputs.end(), [](float output) { return output > 0; });
}

QByteArray encodeChecked(QByteArrayView text)
{
    return bigU32(crc32c(asBytes(text))) + text.toByteArray() + '\0';
}

Result<QByteArray> decodeChecked(Bytes payload)
{
    ByteReader reader(payload);
    const auto crc = big<std::uint32_t>(reader);
    if (!reader.ok())
        return failure(ErrorCode::Damaged, u"the text has no checksum"_s);
    const Bytes rest = payload.subspan(4);
    const auto end = std::find(rest.begin(), rest.end(), std::byte(0));
    const Bytes text = rest.first(std::size_t(std::distance(rest.begin(), end)));
    if (crc32c(text) != crc)
        return failure(ErrorCode::Damaged,
                       u"the text of %1 bytes does not fit its checksum"_s.arg(text.size()));
    return toByteArray(text);
}

QByteArray encodeChunk(std::uint32_t offset, QByteArrayView data)
{
    const auto size = std::uint32_t(data.size());
    return bigU32(crc32c(asBytes(data))) + bigU32(offset) + bigU32(offset) + bigU32(size) + bigU32(size)
        + data.toByteArray();
}

}  // namespace bcflight
