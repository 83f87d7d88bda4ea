// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/namedfields.h"

#include "protocol/base/hexbytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

QString nameOf(const NamedField &field)
{
    return QString::fromLatin1(field.name);
}

QVariant decodeField(const NamedField &field, Bytes bytes)
{
    ByteReader reader(bytes);
    switch (field.type) {
    case NamedField::U8: return int(reader.u8());
    case NamedField::I8: return int(reader.i8());
    case NamedField::U16: return int(reader.u16());
    case NamedField::I16: return int(reader.i16());
    case NamedField::U32: return reader.u32();
    case NamedField::I32: return reader.i32();
    case NamedField::F32: return reader.f32();
    case NamedField::Bytes: return toByteArray(reader.take(reader.remaining()));
    case NamedField::Text: break;
    }
    const QByteArray text = toByteArray(reader.take(std::size_t(field.size)));
    return QString::fromLatin1(text.constData(), qstrnlen(text.constData(), std::size_t(text.size())));
}

// Appends an integer if its type can hold the value.
template <typename T> Result<void> append(ByteWriter &writer, const NamedField &field, const QVariant &value)
{
    bool ok = true;
    const qlonglong number = value.isValid() ? value.toLongLong(&ok) : 0;
    if (!ok)
        return failure(ErrorCode::InvalidArgument,
                       u"%1: '%2' is not a whole number"_s.arg(nameOf(field), value.toString()));
    constexpr qlonglong min = std::numeric_limits<T>::min();
    constexpr qlonglong max = std::numeric_limits<T>::max();
    if (number < min || number > max)
        return failure(ErrorCode::OutOfRange,
                       u"%1: %2 is not within %3 .. %4"_s.arg(nameOf(field)).arg(number).arg(min).arg(max));
    writer.write(T(number));
    return {};
}

Result<void> appendReal(ByteWriter &writer, const NamedField &field, const QVariant &value)
{
    bool ok = true;
    const float number = value.isValid() ? value.toFloat(&ok) : 0.0F;
    // What is typed has to be finite; a field may carry other bits (MAVLink: an integer's, or "not used").
    if (!ok || (value.userType() == QMetaType::QString && !std::isfinite(number)))
        return failure(ErrorCode::InvalidArgument,
                       u"%1: '%2' is not a number"_s.arg(nameOf(field), value.toString()));
    writer.f32(number);
    return {};
}

Result<void> encodeField(ByteWriter &writer, const NamedField &field, const QVariant &value)
{
    switch (field.type) {
    case NamedField::U8: return append<std::uint8_t>(writer, field, value);
    case NamedField::I8: return append<std::int8_t>(writer, field, value);
    case NamedField::U16: return append<std::uint16_t>(writer, field, value);
    case NamedField::I16: return append<std::int16_t>(writer, field, value);
    case NamedField::U32: return append<std::uint32_t>(writer, field, value);
    case NamedField::I32: return append<std::int32_t>(writer, field, value);
    case NamedField::F32: return appendReal(writer, field, value);
    case NamedField::Text:
        writer.bytes(value.toString().toLatin1().leftJustified(field.size, '\0', true));
        return {};
    case NamedField::Bytes: break;
    }
    const auto bytes
        = value.userType() == QMetaType::QString ? bytesFromHex(value.toString()) : value.toByteArray();
    if (!bytes)
        return failure(ErrorCode::InvalidArgument,
                       u"%1: '%2' is not a series of bytes in hex"_s.arg(nameOf(field), value.toString()));
    writer.bytes(*bytes);
    return {};
}

}  // namespace

Result<QVariantMap> decodeFields(NamedFields fields, Bytes payload)
{
    QVariantMap values;
    for (const NamedField &field : fields) {
        if (payload.size() < std::size_t(field.offset + field.size))
            return failure(ErrorCode::BadReply, u"%1 bytes are too few"_s.arg(payload.size()));
        values.insert(nameOf(field), decodeField(field, payload.subspan(std::size_t(field.offset))));
    }
    return values;
}

Result<QByteArray> encodeFields(NamedFields fields, const QVariantMap &values, int size)
{
    for (auto it = values.begin(); it != values.end(); ++it) {
        if (std::none_of(fields.begin(), fields.end(),
                         [&it](const NamedField &field) { return nameOf(field) == it.key(); }))
            return failure(ErrorCode::InvalidArgument, u"there is no field '%1'"_s.arg(it.key()));
    }
    ByteWriter writer;
    for (const NamedField &field : fields) {
        writer.zeros(int(field.offset - writer.size()));
        if (const auto written = encodeField(writer, field, values.value(nameOf(field))); !written)
            return tl::unexpected(written.error());
    }
    writer.zeros(std::max(0, int(size - writer.size())));
    return writer.take();
}
