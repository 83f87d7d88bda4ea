// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/messages.h"

#include "protocol/base/bytes.h"
#include "protocol/base/hexbytes.h"
#include "protocol/simplebgc/units.h"

#include <QHash>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
    case FieldType::Quaternion: return 8;
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
    case Elements::Wxyz: name += u'.' + QString(QChar(u'w' + element)); break;
    case Elements::Numbered: name += QString::number(element + 1); break;
    }
    return isGroup && !name.isEmpty() ? name + u'.' : name;
}

// What fields have said that others depend on.
using Told = QHash<QString, std::uint32_t>;

/// Where a field stands.
struct Place
{
    QString name;
    bool isOpen = false;  ///< part of what repeats as often as there is room
    bool isChosen = false;  ///< it is there because another field says so
};

// Walks over the fields in the order of the wire, one element after the other, as long as the visitor wants.
class Walk
{
public:
    using Visitor = std::function<bool(const FieldSpec &, const Place &)>;

    /// @param told where the visitor notes what it finds; null: all fields that there can be, each once
    Walk(const Told *told, Visitor visitor)
        : m_told(told)
        , m_visitor(std::move(visitor))
    {
    }

    bool fields(Fields fields, const Place &place = {}, int element = 0)
    {
        return std::all_of(fields.begin(), fields.end(),
                           [&](const FieldSpec &field) { return one(field, place, element); });
    }

private:
    [[nodiscard]] bool isThere(const FieldSpec &field, const QString &prefix, int element) const
    {
        if (!field.when.isThere || !m_told)
            return true;
        const QString name = QLatin1String(field.when.field);
        const auto beside = m_told->constFind(prefix + name);
        const auto told = beside != m_told->constEnd() ? beside : m_told->constFind(name);
        return told != m_told->constEnd() && field.when.isThere(*told, element);
    }

    bool one(const FieldSpec &field, const Place &place, int element)
    {
        // Of a group that repeats each element is there by itself.
        const bool isSingle = field.count == 1 && field.elements == Elements::One;
        const bool isGroup = field.type == FieldType::Group;
        const bool isAskedEach = isGroup && !isSingle;
        if (!isAskedEach && !isThere(field, place.name, element))
            return true;
        const bool isChosen = place.isChosen || field.when.isThere != nullptr;
        if (isBytes(field.type) || field.type == FieldType::Quaternion)
            return visit(field, {place.name + QLatin1String(field.name), place.isOpen, isChosen});
        const bool isEndless = field.count == 0;
        for (int i = 0; isEndless ? m_told || i == 0 : i < field.count; ++i) {
            const Place inside{place.name + elementName(field, i), place.isOpen || isEndless, isChosen};
            const int before = m_visits;
            if (isAskedEach && !isThere(field, place.name, i) && !isEndless)
                continue;
            if (isGroup ? !fields(field.inner, inside, isSingle ? element : i) : !visit(field, inside))
                return false;
            if (isEndless && m_visits == before)
                break;  // nothing of it is there
        }
        return true;
    }

    bool visit(const FieldSpec &field, const Place &place)
    {
        ++m_visits;
        return m_visitor(field, place);
    }

    const Told *m_told;
    Visitor m_visitor;
    int m_visits = 0;
};

// What other fields may depend on; nothing depends on a float, which need not be a number.
std::uint32_t wholeOf(const FieldSpec &field, double raw)
{
    return field.type == FieldType::F32 ? 0 : std::uint32_t(std::int64_t(raw));
}

std::uint32_t maskOf(const BitsSpec &bits)
{
    return (1U << unsigned(bits.count)) - 1;
}

// Errata 3.24: the largest of w, x, y, z is left out, the others have 19 bits and a sign.
constexpr double kQuaternionScale = 741453.786;
constexpr std::uint64_t kQuaternionMask = (1U << 19U) - 1;
constexpr unsigned kQuaternionLargest = 60;
constexpr std::array<const char *, 4> kQuaternionParts{".w", ".x", ".y", ".z"};

std::array<double, 4> unpack(std::uint64_t word)
{
    std::array<double, 4> parts{};
    const std::size_t largest = word >> kQuaternionLargest & 3U;
    unsigned at = 0;
    double squares = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i == largest)
            continue;
        const double size = double(word >> at & kQuaternionMask) / kQuaternionScale;
        parts[i] = word >> (at + 19) & 1U ? -size : size;
        squares += size * size;
        at += 20;
    }
    parts[largest] = std::sqrt(std::max(0.0, 1 - squares)) * (word >> 62U & 1U ? -1 : 1);
    return parts;
}

std::uint64_t pack(const std::array<double, 4> &parts)
{
    const auto isSmaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto largest = std::size_t(std::max_element(parts.begin(), parts.end(), isSmaller) - parts.begin());
    std::uint64_t word = std::uint64_t(largest) << kQuaternionLargest;
    word |= std::uint64_t(std::signbit(parts[largest])) << 62U;
    unsigned at = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i == largest)
            continue;
        const auto size = std::uint64_t(std::llround(std::abs(parts[i]) * kQuaternionScale));
        word |= std::min(size, kQuaternionMask) << at;
        word |= std::uint64_t(std::signbit(parts[i])) << (at + 19);
        at += 20;
    }
    return word;
}

// A word of the list, or a number.
Result<double> valueOf(std::span<const Choice> words, const QString &name, const QString &text)
{
    for (const Choice &choice : words) {
        if (text.compare(QLatin1String(choice.name), Qt::CaseInsensitive) == 0)
            return choice.value;
    }
    bool ok = false;
    double value = text.toDouble(&ok);
    if (!ok)
        value = double(text.toLongLong(&ok, 0));  // 0x10
    if (!ok || !std::isfinite(value))
        return failure(ErrorCode::InvalidArgument, u"%1: '%2' is not a number"_s.arg(name, text));
    return value;
}

Result<double> numberOf(const FieldSpec &field, const QString &name, const QString &text)
{
    const auto read = valueOf(field.words, name, text);
    if (!read)
        return read;
    const double value = *read;
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
    const bool isReal = spec->type == FieldType::F32 || spec->type == FieldType::Quaternion;
    const int decimals = isReal ? 4
        : spec->scale >= 1      ? 0
                                : std::clamp(int(std::ceil(-std::log10(spec->scale))), 1, 6);
    QString shown = QString::number(number, 'f', decimals);
    if (*spec->unit) {
        const QString unit = QString::fromUtf8(spec->unit);
        shown += unit.startsWith(u'°') || unit == u"%"_s ? unit : u' ' + unit;
    }
    const std::span<const Choice> words = bits ? bits->words : spec->words;
    const auto word = std::find_if(words.begin(), words.end(), [this](const Choice &choice) {
        return choice.value == int(std::lround(number));
    });
    return word == words.end() ? shown : u"%1 (%2)"_s.arg(shown, QLatin1String(word->name));
}

std::vector<FieldValue> decodeFields(Fields fields, Bytes payload)
{
    std::vector<FieldValue> values;
    ByteReader reader(payload);
    Told told;
    Walk walk(&told, [&](const FieldSpec &field, const Place &place) {
        FieldValue value{place.name, &field};
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
        if (field.type == FieldType::Quaternion) {
            const std::uint64_t low = reader.u32();
            const auto parts = unpack(low | std::uint64_t(reader.u32()) << 32U);
            for (std::size_t i = 0; i < parts.size(); ++i)
                values.push_back({place.name + QLatin1String(kQuaternionParts[i]), &field, parts[i]});
            return true;
        }
        const double raw = readNumber(field.type, reader);
        const std::uint32_t whole = wholeOf(field, raw);
        told.insert(place.name, whole);
        for (const BitsSpec &bits : field.bits) {
            values.push_back({place.name + u'.' + QLatin1String(bits.name),
                              &field,
                              double(whole >> unsigned(bits.first) & maskOf(bits)),
                              {},
                              &bits});
        }
        value.number = raw * field.scale;
        if (field.bits.empty())
            values.push_back(value);
        return true;
    });
    walk.fields(fields);
    return values;
}

QStringList fieldNames(Fields fields)
{
    QStringList names;
    const auto add = [&names](const QString &name) {
        if (!names.contains(name))
            names.append(name);
    };
    Walk walk(nullptr, [&add](const FieldSpec &field, const Place &place) {
        for (const BitsSpec &bits : field.bits)
            add(place.name + u'.' + QLatin1String(bits.name));
        if (field.type == FieldType::Quaternion) {
            for (const char *part : kQuaternionParts)
                add(place.name + QLatin1String(part));
        } else if (*field.name && field.bits.empty()) {
            add(place.name);
        }
        return true;
    });
    walk.fields(fields);
    return names;
}

namespace {

/// Words "name=value" that are taken one after the other.
class Given
{
public:
    explicit Given(Fields fields)
        : m_fields(fields)
    {
    }

    Result<void> read(const QStringList &words)
    {
        for (const QString &word : words) {
            const qsizetype equals = word.indexOf(u'=');
            const QString name = word.left(equals);
            if (equals < 1)
                return failure(ErrorCode::InvalidArgument,
                               u"'%1' is not name=value; the fields are %2"_s.arg(word, names()));
            if (m_words.contains(name))
                return failure(ErrorCode::InvalidArgument, u"%1 is given twice"_s.arg(name));
            m_words.insert(name, word.mid(equals + 1));
        }
        return {};
    }

    [[nodiscard]] bool isEmpty() const { return m_words.isEmpty(); }
    [[nodiscard]] QStringList left() const { return m_words.keys(); }
    [[nodiscard]] QString names() const { return fieldNames(m_fields).join(u", "_s); }
    [[nodiscard]] Error missing(const QString &name) const
    {
        return {ErrorCode::InvalidArgument, u"%1 is missing; the fields are %2"_s.arg(name, names()), 0};
    }

    /// Whether anything of it is given.
    [[nodiscard]] bool has(const FieldSpec &field, const QString &name) const
    {
        const auto hasPart = [&](const char *part) { return m_words.contains(name + QLatin1String(part)); };
        if (field.type == FieldType::Quaternion)
            return std::any_of(kQuaternionParts.begin(), kQuaternionParts.end(), hasPart);
        return m_words.contains(name)
            || std::any_of(field.bits.begin(), field.bits.end(), [&](const BitsSpec &bits) {
                   return m_words.contains(name + u'.' + QLatin1String(bits.name));
               });
    }

    QString take(const QString &name) { return m_words.take(name); }

    Result<double> takeNumber(const FieldSpec &field, const QString &name)
    {
        if (field.bits.empty() || m_words.contains(name))
            return numberOf(field, name, take(name));
        std::uint32_t whole = 0;
        for (const BitsSpec &bits : field.bits) {
            const QString part = name + u'.' + QLatin1String(bits.name);
            if (!m_words.contains(part))
                continue;
            const auto value = valueOf(bits.words, part, take(part));
            if (!value)
                return value;
            if (*value < 0 || *value > maskOf(bits))
                return failure(ErrorCode::OutOfRange,
                               u"%1: %2 is not within 0 .. %3"_s.arg(part).arg(*value).arg(maskOf(bits)));
            whole |= std::uint32_t(std::lround(*value)) << unsigned(bits.first);
        }
        return whole;
    }

    Result<std::uint64_t> takeQuaternion(const QString &name)
    {
        std::array<double, 4> parts{};
        double squares = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const QString part = name + QLatin1String(kQuaternionParts[i]);
            if (!m_words.contains(part))
                return tl::unexpected(missing(part));
            const auto value = valueOf({}, part, take(part));
            if (!value)
                return tl::unexpected(value.error());
            parts[i] = *value;
            squares += *value * *value;
        }
        constexpr double kMostOff = 0.01;
        if (std::abs(squares - 1) > kMostOff)
            return failure(ErrorCode::OutOfRange,
                           u"%1: the length of a rotation is 1, not %2"_s.arg(name).arg(std::sqrt(squares)));
        for (double &part : parts)
            part /= std::sqrt(squares);
        return pack(parts);
    }

private:
    Fields m_fields;
    QHash<QString, QString> m_words;
};

// One field behind the others; nothing: it need not be there, and nothing behind it.
Result<bool> write(ByteWriter &writer, Told &told, Given &given, const FieldSpec &field, const Place &place)
{
    const bool isGiven = given.has(field, place.name);
    if (!isGiven && *field.name) {
        if (place.isOpen)
            return false;  // there are no more of them
        if (field.count == 0)
            return true;  // bytes that may be none
        return tl::unexpected(given.missing(place.name));
    }
    if (isBytes(field.type)) {
        const auto bytes = bytesOf(field, place.name, isGiven ? given.take(place.name) : QString());
        if (!bytes)
            return tl::unexpected(bytes.error());
        writer.bytes(*bytes);
    } else if (field.type == FieldType::Quaternion) {
        const auto word = given.takeQuaternion(place.name);
        if (!word)
            return tl::unexpected(word.error());
        writer.u32(std::uint32_t(*word)).u32(std::uint32_t(*word >> 32U));
    } else {
        const auto raw = given.takeNumber(field, place.name);
        if (!raw)
            return tl::unexpected(raw.error());
        told.insert(place.name, wholeOf(field, *raw));
        writeNumber(field.type, *raw, writer);
    }
    return writer.size() <= kLargestPayload;
}

}  // namespace

Result<QByteArray> encodeFields(Fields fields, const QStringList &words, int least)
{
    Given given(fields);
    if (const auto read = given.read(words); !read)
        return tl::unexpected(read.error());
    ByteWriter writer;
    Told told;
    std::optional<Error> error;
    Walk walk(&told, [&](const FieldSpec &field, const Place &place) {
        if (given.isEmpty() && writer.size() == least && !place.isChosen)
            return false;  // the short form
        const auto goesOn = write(writer, told, given, field, place);
        if (!goesOn)
            error = goesOn.error();
        return goesOn && *goesOn;
    });
    walk.fields(fields);
    if (error)
        return tl::unexpected(*error);
    if (!given.isEmpty())
        return failure(ErrorCode::InvalidArgument,
                       u"there is no field '%1' here; the fields are %2"_s.arg(given.left().join(u"', '"_s),
                                                                               given.names()));
    if (writer.size() > kLargestPayload)
        return failure(ErrorCode::OutOfRange, u"a frame holds %1 payload bytes"_s.arg(kLargestPayload));
    return writer.take();
}

}  // namespace simplebgc
