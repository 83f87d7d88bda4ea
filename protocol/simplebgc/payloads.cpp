// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/payloads.h"

#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

tl::unexpected<Error> tooShort(const char *name, std::size_t size)
{
    return failure(ErrorCode::BadReply, u"%1 with %2 bytes"_s.arg(QLatin1String(name)).arg(size));
}

// The longest prefix of a text that fits without splitting a character.
QByteArray cutUtf8(const QString &text, qsizetype bytes)
{
    QByteArray utf8 = text.toUtf8();
    if (utf8.size() <= bytes)
        return utf8;
    while (bytes > 0 && (static_cast<unsigned char>(utf8[bytes]) & 0xC0) == 0x80)
        --bytes;
    return utf8.left(bytes);
}

}  // namespace

Result<BoardInfo> BoardInfo::decode(Bytes payload)
{
    ByteReader reader(payload);
    BoardInfo info;
    info.boardVersion = reader.u8();
    info.firmware = reader.u16();
    info.debugMode = reader.u8() & 1;
    info.features = reader.u16();
    info.usb = reader.u8() & 1;
    info.extraId = reader.u32();
    if (!reader.ok())
        return tooShort("BOARD_INFO", payload.size());
    if (reader.remaining() >= 7 && info.firmware >= 2600) {
        info.features |= static_cast<quint32>(reader.u16()) << 16;
        reader.skip(3);
        info.baseFirmware = reader.u16();
    }
    return info;
}

QByteArray BoardInfo::encode() const
{
    ByteWriter writer;
    writer.u8(boardVersion).u16(firmware).u8(debugMode).u16(int(features & 0xFFFF)).u8(usb).u32(extraId);
    if (firmware >= 2600)
        writer.u16(int(features >> 16)).zeros(3).u16(baseFirmware);
    else
        writer.zeros(7);
    return writer.take();
}

QString BoardInfo::modelText() const
{
    return u"SimpleBGC %1.%2"_s.arg(boardVersion / 10).arg(boardVersion % 10);
}

QString BoardInfo::firmwareText() const
{
    const QString text = u"%1.%2"_s.arg(firmware / 1000).arg(firmware % 1000 / 10, 2, 10, QChar(u'0'));
    if (firmware >= 2730)
        return text + u".%1"_s.arg(firmware % 10);
    return text + u"b%1"_s.arg(firmware % 10);
}

Result<BoardInfo3> BoardInfo3::decode(Bytes payload)
{
    ByteReader reader(payload);
    BoardInfo3 info;
    info.deviceId = toByteArray(reader.take(9));
    info.mcuId = toByteArray(reader.take(12));
    info.eepromSize = reader.u32();
    for (quint16 &size : info.scriptSizes)
        size = reader.u16();
    if (!reader.ok())
        return tooShort("BOARD_INFO_3", payload.size());
    return info;
}

QByteArray BoardInfo3::encode() const
{
    ByteWriter writer;
    writer.bytes(deviceId.leftJustified(9, '\0', true))
        .bytes(mcuId.leftJustified(12, '\0', true))
        .u32(eepromSize);
    for (const quint16 size : scriptSizes)
        writer.u16(size);
    return writer.zeros(34).take();
}

Result<QStringList> decodeProfileNames(Bytes payload)
{
    ByteReader reader(payload);
    QStringList names;
    for (int i = 0; i < kProfileCount; ++i) {
        const QByteArray name = toByteArray(reader.take(kProfileNameSize));
        names.append(
            QString::fromUtf8(name.constData(), qstrnlen(name.constData(), std::size_t(name.size()))));
    }
    if (!reader.ok())
        return tooShort("READ_PROFILE_NAMES", payload.size());
    return names;
}

QByteArray encodeProfileNames(const QStringList &names)
{
    QByteArray payload;
    for (int i = 0; i < kProfileCount; ++i)
        payload += cutUtf8(names.value(i), kProfileNameSize).leftJustified(kProfileNameSize, '\0');
    return payload;
}

Result<Angles> decodeAngles(Bytes payload)
{
    ByteReader reader(payload);
    Angles angles;
    for (AxisAngles &axis : angles) {
        axis.imu = reader.i16() * kDegreesPerCount;
        axis.target = reader.i16() * kDegreesPerCount;
        axis.targetSpeed = reader.i16() * kControlSpeedUnit;
    }
    if (!reader.ok())
        return tooShort("GET_ANGLES", payload.size());
    return angles;
}

Result<Angles> decodeAnglesExt(Bytes payload)
{
    ByteReader reader(payload);
    Angles angles;
    for (AxisAngles &axis : angles) {
        axis.imu = reader.i16() * kDegreesPerCount;
        axis.target = reader.i16() * kDegreesPerCount;
        axis.rotor = reader.i32() * kDegreesPerCount;
        reader.skip(10);
    }
    if (!reader.ok())
        return tooShort("GET_ANGLES_EXT", payload.size());
    return angles;
}

QByteArray encodeAngles(const Angles &angles)
{
    ByteWriter writer;
    for (const AxisAngles &axis : angles) {
        writer.i16(reportedAngle(axis.imu))
            .i16(reportedAngle(axis.target))
            .i16(toCount16(axis.targetSpeed, kControlSpeedUnit));
    }
    return writer.take();
}

QByteArray encodeAnglesExt(const Angles &angles)
{
    ByteWriter writer;
    for (const AxisAngles &axis : angles) {
        writer.i16(reportedAngle(axis.imu))
            .i16(reportedAngle(axis.target))
            .i32(static_cast<qint32>(std::lround(axis.rotor / kDegreesPerCount)))
            .zeros(10);
    }
    return writer.take();
}

Result<std::vector<AdjVar>> decodeAdjVars(Bytes payload)
{
    ByteReader reader(payload);
    const int count = reader.u8();
    std::vector<AdjVar> values;
    for (int i = 0; i < count && reader.ok(); ++i) {
        const int id = reader.u8();
        values.push_back({id, reader.i32()});
    }
    if (!reader.ok())
        return tooShort("SET_ADJ_VARS_VAL", payload.size());
    return values;
}

QByteArray encodeAdjVars(const std::vector<AdjVar> &values)
{
    ByteWriter writer;
    writer.u8(int(values.size()));
    for (const AdjVar &var : values)
        writer.u8(var.id).i32(var.value);
    return writer.take();
}

int DebugVar::size() const
{
    const int elements = std::max(count, 1);
    switch (type) {
    case U8:
    case I8: return elements;
    case U16:
    case I16: return 2 * elements;
    case U32:
    case I32:
    case F32: return 4 * elements;
    default: return 0;
    }
}

Result<DebugVarList> decodeDebugVarsInfo(Bytes payload)
{
    ByteReader reader(payload);
    DebugVarList list;
    list.total = reader.u8();
    if (!reader.ok())
        return tooShort("DEBUG_VARS_INFO_3", payload.size());
    while (reader.remaining() > 0 && int(list.vars.size()) < list.total) {
        DebugVar var;
        const int length = reader.u8();
        var.name = QString::fromLatin1(toByteArray(reader.take(std::size_t(length))));
        const int type = reader.u8();
        var.type = type & 0x0F;
        var.axis = (type >> 4) & 3;
        var.isAngle = type & 0x40;
        var.count = std::max<int>(reader.u16(), 1);
        if (!reader.ok())
            break;  // a declaration cut off at the end of the frame is repeated in the next part
        list.vars.push_back(var);
    }
    return list;
}

QByteArray encodeDebugVarsInfo(int total, std::span<const DebugVar> vars)
{
    ByteWriter writer;
    writer.u8(total);
    for (const DebugVar &var : vars) {
        const QByteArray name = var.name.toLatin1();
        writer.u8(int(name.size()))
            .bytes(name)
            .u8(var.type | var.axis << 4 | (var.isAngle ? 0x40 : 0))
            .u16(var.count);
    }
    return writer.take();
}

Result<std::vector<std::vector<double>>> decodeDebugVars(std::span<const DebugVar> vars, Bytes payload)
{
    ByteReader reader(payload);
    std::vector<std::vector<double>> values;
    for (const DebugVar &var : vars) {
        if (var.size() == 0)
            return failure(ErrorCode::BadReply,
                           u"debug variable %1 has the unknown type %2"_s.arg(var.name).arg(var.type));
        std::vector<double> elements;
        for (int i = 0; i < std::max(var.count, 1); ++i) {
            double value = 0;
            switch (var.type) {
            case DebugVar::U8: value = reader.u8(); break;
            case DebugVar::I8: value = reader.i8(); break;
            case DebugVar::U16: value = reader.u16(); break;
            case DebugVar::I16: value = reader.i16(); break;
            case DebugVar::U32: value = reader.u32(); break;
            case DebugVar::I32: value = reader.i32(); break;
            default: value = double(reader.f32()); break;
            }
            elements.push_back(var.isAngle ? value * kDegreesPerCount : value);
        }
        values.push_back(std::move(elements));
    }
    if (!reader.ok())
        return tooShort("DEBUG_VARS_3", payload.size());
    return values;
}

QByteArray encodeDebugVars(std::span<const DebugVar> vars, const std::vector<std::vector<double>> &values)
{
    ByteWriter writer;
    for (std::size_t v = 0; v < vars.size(); ++v) {
        const DebugVar &var = vars[v];
        for (int i = 0; i < std::max(var.count, 1); ++i) {
            double value
                = v < values.size() && std::size_t(i) < values[v].size() ? values[v][std::size_t(i)] : 0.0;
            if (var.isAngle)
                value /= kDegreesPerCount;
            const auto whole = static_cast<qint64>(std::llround(value));
            switch (var.type) {
            case DebugVar::U8:
            case DebugVar::I8: writer.u8(int(whole & 0xFF)); break;
            case DebugVar::U16:
            case DebugVar::I16: writer.u16(int(whole & 0xFFFF)); break;
            case DebugVar::U32:
            case DebugVar::I32: writer.u32(static_cast<quint32>(whole)); break;
            default: writer.f32(static_cast<float>(value)); break;
            }
        }
    }
    return writer.take();
}

Result<AutoPidProgress> AutoPidProgress::decode(Bytes payload)
{
    ByteReader reader(payload);
    AutoPidProgress progress;
    for (auto *gains : {&progress.p, &progress.i, &progress.d}) {
        for (int &gain : *gains)
            gain = reader.u8();
    }
    for (int &frequency : progress.lpf)
        frequency = reader.u16();
    progress.iteration = reader.u16();
    for (float &error : progress.trackingError) {
        error = reader.f32();
        reader.skip(6);
    }
    if (!reader.ok())
        return tooShort("AUTO_PID", payload.size());
    return progress;
}

QByteArray AutoPidProgress::encode() const
{
    ByteWriter writer;
    for (const auto *gains : {&p, &i, &d}) {
        for (const int gain : *gains)
            writer.u8(gain);
    }
    for (const int frequency : lpf)
        writer.u16(frequency);
    writer.u16(iteration);
    for (const float error : trackingError)
        writer.f32(error).zeros(6);
    return writer.zeros(10).take();
}

QByteArray encodeControlShort(const ControlCommand &command)
{
    ByteWriter writer;
    writer.u8(command[0].mode);
    for (const ControlAxis &axis : command)
        writer.i16(axis.speed).i16(axis.angle);
    return writer.take();
}

QByteArray encodeControl(const ControlCommand &command)
{
    ByteWriter writer;
    for (const ControlAxis &axis : command)
        writer.u8(axis.mode);
    for (const ControlAxis &axis : command)
        writer.i16(axis.speed).i16(axis.angle);
    return writer.take();
}

Result<ControlCommand> decodeControl(Bytes payload)
{
    if (payload.size() != 13 && payload.size() != 15)
        return tooShort("CONTROL", payload.size());
    ByteReader reader(payload);
    ControlCommand command;
    const int common = reader.u8();
    command[0].mode = common;
    for (int axis = 1; axis < 3; ++axis)
        command[std::size_t(axis)].mode = payload.size() == 15 ? reader.u8() : common;
    for (ControlAxis &axis : command) {
        axis.speed = reader.i16();
        axis.angle = reader.i16();
    }
    return command;
}

QByteArray DataStream::encode() const
{
    ByteWriter writer;
    writer.u8(command).u16(intervalMs).bytes(config.leftJustified(8, '\0', true)).zeros(10);
    return writer.take();
}

Result<DataStream> DataStream::decode(Bytes payload)
{
    if (payload.size() != 21 && payload.size() != 23)
        return tooShort("DATA_STREAM_INTERVAL", payload.size());
    ByteReader reader(payload);
    DataStream stream;
    stream.command = reader.u8();
    stream.intervalMs = reader.u16();
    stream.config = toByteArray(reader.take(8));
    return stream;
}

QByteArray encodeCalibration(int imu, int action)
{
    return ByteWriter().u8(imu).u8(action).zeros(10).take();
}

QByteArray encodeBeep(int mode, int noteLength, int decay, const QList<int> &notes)
{
    ByteWriter writer;
    writer.u16(mode).u8(noteLength).u8(decay).zeros(8);
    for (const int note : notes)
        writer.u16(note);
    return writer.take();
}

QByteArray encodeChannels(const std::vector<double> &percents, bool isFine)
{
    constexpr std::size_t kChannels = 31;
    const int nobody = isFine ? -32768 : -10000;
    const double full = isFine ? 16384 : 500;
    ByteWriter writer;
    for (std::size_t i = 0; i < kChannels; ++i) {
        const bool isGiven = i < percents.size() && !std::isnan(percents[i]);
        const double share = isGiven ? std::clamp(percents[i], -100.0, 100.0) / 100 : 0;
        writer.i16(isGiven ? int(std::lround(full * share)) : nobody);
    }
    return writer.take();
}

}  // namespace simplebgc
