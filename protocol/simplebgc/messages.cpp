// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/messages.h"

#include "protocol/base/bytes.h"
#include "protocol/base/hexbytes.h"
#include "protocol/simplebgc/units.h"

#include <QHash>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr qsizetype kLargestPayload = 255;

int sizeOf(FieldType type)
{
    switch (type) {
    case FieldType::U8:
    case FieldType::S8:
    case FieldType::Sized: return 1;  // at least
    case FieldType::U16:
    case FieldType::S16: return 2;
    case FieldType::U24: return 3;
    case FieldType::U32:
    case FieldType::S32:
    case FieldType::F32: return 4;
    case FieldType::Bytes:
    case FieldType::Text:
    case FieldType::Group: break;
    }
    return 0;
}

bool isBytes(FieldType type)
{
    return type == FieldType::Bytes || type == FieldType::Text || type == FieldType::Sized;
}

double readNumber(FieldType type, ByteReader &reader)
{
    switch (type) {
    case FieldType::U8: return reader.u8();
    case FieldType::S8: return reader.i8();
    case FieldType::U16: return reader.u16();
    case FieldType::S16: return reader.i16();
    case FieldType::U24: {
        const int low = reader.u16();
        return low + reader.u8() * 65536;
    }
    case FieldType::U32: return reader.u32();
    case FieldType::S32: return reader.i32();
    case FieldType::F32: return double(reader.f32());
    default: return 0;
    }
}

std::pair<double, double> limits(FieldType type)
{
    switch (type) {
    case FieldType::U8: return {0, 255};
    case FieldType::S8: return {-128, 127};
    case FieldType::U16: return {0, 65535};
    case FieldType::S16: return {-32768, 32767};
    case FieldType::U24: return {0, 16777215};
    case FieldType::U32: return {0, 4294967295.0};
    case FieldType::S32: return {-2147483648.0, 2147483647.0};
    default: return {double(std::numeric_limits<float>::lowest()), double(std::numeric_limits<float>::max())};
    }
}

void writeNumber(FieldType type, double raw, ByteWriter &writer)
{
    switch (type) {
    case FieldType::U8:
    case FieldType::S8: writer.u8(int(raw)); return;
    case FieldType::U16:
    case FieldType::S16: writer.u16(int(raw)); return;
    case FieldType::U24: writer.u16(int(raw) & 0xFFFF).u8(int(raw) >> 16); return;
    case FieldType::U32: writer.u32(std::uint32_t(raw)); return;
    case FieldType::S32: writer.i32(std::int32_t(raw)); return;
    case FieldType::F32: writer.f32(float(raw)); return;
    default: return;
    }
}

// Of one element of a field or group; "speed", "speed.roll", "speed1"; of a group what stands in front of
// what is inside: "roll.", "trigger1.".
QString elementName(const FieldSpec &field, int element)
{
    const bool isGroup = field.type == FieldType::Group;
    QString name = QLatin1String(field.name);
    switch (field.elements) {
    case Elements::One: break;
    case Elements::Axes:
        name = isGroup ? axisName(std::size_t(element)) : name + u'.' + axisName(std::size_t(element));
        break;
    case Elements::Xyz: name += u'.' + QString(QChar(u'x' + element)); break;
    case Elements::Numbered: name += QString::number(element + 1); break;
    }
    return isGroup && !name.isEmpty() ? name + u'.' : name;
}

// Walks over the fields in the order of the wire, one element after the other, as long as the visitor wants.
class Walk
{
public:
    /// @param isOpen it is part of what repeats as often as there is room
    using Visitor = std::function<bool(const FieldSpec &, const QString &name, bool isOpen)>;

    /// @param once what repeats without end comes once
    explicit Walk(Visitor visitor, bool once = false)
        : m_visitor(std::move(visitor))
        , m_once(once)
    {
    }

    bool fields(Fields fields, const QString &prefix = {}, bool isOpen = false)
    {
        return std::all_of(fields.begin(), fields.end(),
                           [&](const FieldSpec &field) { return one(field, prefix, isOpen); });
    }

private:
    bool one(const FieldSpec &field, const QString &prefix, bool isOpen)
    {
        if (isBytes(field.type))
            return m_visitor(field, prefix + QLatin1String(field.name), isOpen);
        const bool isEndless = field.count == 0;
        for (int i = 0; isEndless ? !m_once || i == 0 : i < field.count; ++i) {
            const QString name = prefix + elementName(field, i);
            const bool goesOn = field.type == FieldType::Group
                ? fields(field.inner, name, isOpen || isEndless)
                : m_visitor(field, name, isOpen || isEndless);
            if (!goesOn)
                return false;
        }
        return true;
    }

    Visitor m_visitor;
    bool m_once;
};

Result<double> numberOf(const FieldSpec &field, const QString &name, const QString &text)
{
    const auto named = std::find_if(field.words.begin(), field.words.end(), [&text](const Choice &choice) {
        return text.compare(QLatin1String(choice.name), Qt::CaseInsensitive) == 0;
    });
    bool ok = false;
    double value = named != field.words.end() ? named->value : text.toDouble(&ok);
    if (named == field.words.end() && !ok)
        value = double(text.toLongLong(&ok, 0));  // 0x10
    if (named == field.words.end() && (!ok || !std::isfinite(value)))
        return failure(ErrorCode::InvalidArgument, u"%1: '%2' is not a number"_s.arg(name, text));
    const double raw = field.type == FieldType::F32 ? value / field.scale : std::round(value / field.scale);
    const auto [low, high] = limits(field.type);
    if (raw < low || raw > high)
        return failure(ErrorCode::OutOfRange,
                       u"%1: %2 is not within %3 .. %4"_s.arg(name, text)
                           .arg(low * field.scale, 0, 'g', 6)
                           .arg(high * field.scale, 0, 'g', 6));
    return raw;
}

Result<QByteArray> bytesOf(const FieldSpec &field, const QString &name, const QString &text)
{
    if (field.type != FieldType::Bytes) {
        const QByteArray bytes = text.toUtf8();
        const qsizetype room = field.type == FieldType::Sized ? kLargestPayload : field.count;
        if (bytes.size() > room)
            return failure(ErrorCode::OutOfRange, u"%1 has room for %2 bytes"_s.arg(name).arg(room));
        return field.type == FieldType::Sized ? QByteArray(1, char(bytes.size())) + bytes
                                              : bytes.leftJustified(field.count, '\0');
    }
    const auto bytes = bytesFromHex(text);
    if (!bytes)
        return failure(ErrorCode::InvalidArgument,
                       u"%1: '%2' is not a series of bytes in hex"_s.arg(name, text));
    if (field.count > 0 && bytes->size() > field.count)
        return failure(ErrorCode::OutOfRange, u"%1 has room for %2 bytes"_s.arg(name).arg(field.count));
    return field.count > 0 ? bytes->leftJustified(field.count, '\0') : *bytes;
}

}  // namespace

const MessageSpec *findMessage(int id)
{
    const auto all = messages();
    const auto it
        = std::find_if(all.begin(), all.end(), [id](const MessageSpec &message) { return message.id == id; });
    return it == all.end() ? nullptr : &*it;
}

const MessageSpec *findMessage(const QString &name)
{
    const auto all = messages();
    const auto it = std::find_if(all.begin(), all.end(), [&name](const MessageSpec &message) {
        return name == QLatin1String(message.name);
    });
    return it == all.end() ? nullptr : &*it;
}

bool FieldValue::isText() const
{
    return isBytes(spec->type);
}

QString FieldValue::text() const
{
    if (spec->type == FieldType::Bytes)
        return QString::fromLatin1(bytes.toHex(' '));
    if (isText())
        return QString::fromUtf8(bytes);
    // One digit more than the field resolves.
    const int decimals = spec->type == FieldType::F32 ? 4
        : spec->scale >= 1                            ? 0
                           : std::clamp(int(std::ceil(-std::log10(spec->scale))), 1, 6);
    QString shown = QString::number(number, 'f', decimals);
    if (*spec->unit) {
        const QString unit = QString::fromUtf8(spec->unit);
        shown += unit.startsWith(u'°') || unit == u"%"_s ? unit : u' ' + unit;
    }
    if (spec->isFlags) {
        QStringList set;
        for (const Choice &bit : spec->words) {
            if (quint32(number) >> bit.value & 1)
                set.append(QLatin1String(bit.name));
        }
        return set.isEmpty() ? shown : u"%1 (%2)"_s.arg(shown, set.join(u", "_s));
    }
    const auto word = std::find_if(spec->words.begin(), spec->words.end(), [this](const Choice &choice) {
        return choice.value == int(std::lround(number));
    });
    return word == spec->words.end() ? shown : u"%1 (%2)"_s.arg(shown, QLatin1String(word->name));
}

std::vector<FieldValue> decodeFields(Fields fields, Bytes payload)
{
    std::vector<FieldValue> values;
    ByteReader reader(payload);
    Walk walk([&](const FieldSpec &field, const QString &name, bool) {
        FieldValue value{name, &field};
        if (isBytes(field.type)) {
            const std::size_t size = field.type == FieldType::Sized ? reader.u8()
                : field.count > 0                                   ? std::size_t(field.count)
                                                                    : reader.remaining();
            if (!reader.ok() || reader.remaining() == 0 || (size > reader.remaining()))
                return false;
            value.bytes = toByteArray(reader.take(size));
            if (field.type == FieldType::Text)
                value.bytes.truncate(qstrnlen(value.bytes.constData(), std::size_t(value.bytes.size())));
            if (*field.name)
                values.push_back(value);
            return true;
        }
        if (reader.remaining() < std::size_t(sizeOf(field.type)))
            return false;
        value.number = readNumber(field.type, reader) * field.scale;
        values.push_back(value);
        return true;
    });
    walk.fields(fields);
    return values;
}

QStringList fieldNames(Fields fields)
{
    QStringList names;
    Walk walk(
        [&names](const FieldSpec &field, const QString &name, bool) {
            if (*field.name)
                names.append(name);
            return true;
        },
        true);
    walk.fields(fields);
    return names;
}

Result<QByteArray> encodeFields(Fields fields, const QStringList &words, int least)
{
    QHash<QString, QString> given;
    for (const QString &word : words) {
        const qsizetype equals = word.indexOf(u'=');
        const QString name = word.left(equals);
        if (equals < 1 || given.contains(name))
            return failure(ErrorCode::InvalidArgument,
                           equals < 1 ? u"'%1' is not name=value; the fields are %2"_s.arg(
                               word, fieldNames(fields).join(u", "_s))
                                      : u"%1 is given twice"_s.arg(name));
        given.insert(name, word.mid(equals + 1));
    }
    ByteWriter writer;
    std::optional<Error> error;
    Walk walk([&](const FieldSpec &field, const QString &name, bool isOpen) {
        if (given.isEmpty() && writer.size() == least)
            return false;  // the short form
        const auto text = given.constFind(name);
        const bool isGiven = text != given.constEnd();
        if (!isGiven && *field.name) {
            if (isOpen)
                return false;  // there are no more of them
            if (field.count == 0)
                return true;  // bytes that may be none
            error
                = Error{ErrorCode::InvalidArgument,
                        u"%1 is missing; the fields are %2"_s.arg(name, fieldNames(fields).join(u", "_s)), 0};
            return false;
        }
        if (isBytes(field.type)) {
            const auto bytes = bytesOf(field, name, isGiven ? *text : QString());
            if (!bytes) {
                error = bytes.error();
                return false;
            }
            writer.bytes(*bytes);
        } else {
            const auto raw = numberOf(field, name, *text);
            if (!raw) {
                error = raw.error();
                return false;
            }
            writeNumber(field.type, *raw, writer);
        }
        given.remove(name);
        return writer.size() <= kLargestPayload;
    });
    walk.fields(fields);
    if (error)
        return tl::unexpected(*error);
    if (!given.isEmpty())
        return failure(ErrorCode::InvalidArgument,
                       u"there is no field '%1' here; the fields are %2"_s.arg(
                           QStringList(given.keys()).join(u"', '"_s), fieldNames(fields).join(u", "_s)));
    if (writer.size() > kLargestPayload)
        return failure(ErrorCode::OutOfRange, u"a frame holds %1 payload bytes"_s.arg(kLargestPayload));
    return writer.take();
}

}  // namespace simplebgc
