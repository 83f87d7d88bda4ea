// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/parameterspec.h"

#include <QLocale>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

using namespace Qt::StringLiterals;

namespace {

const double kLogBase = std::log(52.0) / 255.0;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

quint32 maskOf(const ParameterRow &row)
{
    const int bits = row.bitCount ? row.bitCount : 8 * wireSize(row.wire);
    return static_cast<quint32>((1ULL << bits) - 1) << row.bitShift;
}

QString expandKey(const char *pattern, Axis axis, int index)
{
    QString key = QLatin1String(pattern);
    key.replace(u"%a"_s, QLatin1String(axisKey(axis)));
    key.replace(u"%n"_s, QString::number(index));
    return key;
}

}  // namespace

QString plainNumber(double value)
{
    constexpr double kLongest = 1e15;  // below it every whole number is exact
    if (value == 0 && std::signbit(value))
        return u"-0"_s;
    if (std::abs(value) < kLongest && value == std::trunc(value))
        return QString::number(value, 'f', 0);
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

double ParameterSpec::toDisplay(double raw) const
{
    if (row->conversion == Conversion::Logarithmic)
        return 5.0 * std::exp(raw * kLogBase) - 5.0;
    const double scaled = raw * row->scale;
    return row->bias == 0 ? scaled : scaled + row->bias;  // keeps -0
}

double ParameterSpec::toRaw(double display) const
{
    if (row->conversion == Conversion::Logarithmic)
        return nearest(std::log(std::max(display + 5.0, 5.0) / 5.0) / kLogBase);
    return nearest((display - row->bias) / row->scale);
}

double ParameterSpec::nearest(double raw) const
{
    if (row->wire != WireType::F32)
        return std::round(raw) + 0.0;  // no -0 among integers
    static_assert(std::numeric_limits<float>::is_iec559);
    const auto stored = static_cast<float>(raw);
    return std::isfinite(stored) ? double(stored) : raw;
}

double ParameterSpec::rawOf(double variable) const
{
    const double raw = variable / row->adjustableScale;
    return row->wire == WireType::F32 ? nearest(raw) : std::trunc(raw);
}

bool ParameterSpec::isInRange(double raw) const
{
    return nearest(raw) >= nearest(row->min) && nearest(raw) <= nearest(row->max);
}

bool ParameterSpec::accepts(double raw) const
{
    if (!isInRange(raw))
        return false;
    if (row->step > 1 && std::fmod(nearest(raw) - row->min, row->step) != 0)
        return false;
    if (row->kind == ValueKind::Flags)
        return unnamedBits(raw) == 0;
    if (row->kind != ValueKind::Choice || row->choices.empty())
        return true;
    const auto list = choices(firmware);
    return std::any_of(list.begin(), list.end(),
                       [value = nearest(raw)](const Choice &choice) { return choice.value == value; });
}

bool ParameterSpec::accepts(double raw, std::optional<double> held) const
{
    if (accepts(raw))
        return true;
    return row->kind == ValueKind::Flags && held && isInRange(raw)
        && (unnamedBits(raw) & ~unnamedBits(*held)) == 0;
}

// Bits without a meaning in this firmware; without a list nobody can tell.
quint32 ParameterSpec::unnamedBits(double raw) const
{
    if (row->choices.empty())
        return 0;
    quint32 named = 0;
    for (const Choice &choice : choices(firmware))
        named |= 1U << choice.value;
    return flagBits(raw) & ~named;
}

double ParameterSpec::clamped(double raw) const
{
    const double value = std::clamp(nearest(raw), nearest(row->min), nearest(row->max));
    return row->step > 1 ? row->min + row->step * std::round((value - row->min) / row->step) : value;
}

QString ParameterSpec::allowedText() const
{
    if (row->kind == ValueKind::Flags && !row->choices.empty()) {
        QStringList bits;
        for (const Choice &choice : choices(firmware))
            bits.append(QString::number(choice.value));
        return u"bits "_s + bits.join(u", "_s);
    }
    if (row->kind != ValueKind::Choice || row->choices.empty()) {
        const QString range = u"%1 to %2"_s.arg(minText(), maxText());
        return row->step > 1 ? u"%1 in steps of %2"_s.arg(range, plainNumber(row->step * row->scale)) : range;
    }
    std::vector<int> values;
    for (const Choice &choice : choices(firmware)) {
        if (isInRange(choice.value))
            values.push_back(choice.value);
    }
    std::sort(values.begin(), values.end());
    QStringList runs;
    for (std::size_t first = 0; first < values.size();) {
        std::size_t last = first;
        while (last + 1 < values.size() && values[last + 1] == values[last] + 1)
            ++last;
        runs.append(first == last ? QString::number(values[first])
                                  : u"%1 to %2"_s.arg(values[first]).arg(values[last]));
        first = last + 1;
    }
    return runs.join(u", "_s);
}

// The bytes of the word as a number; bit fields and signs are handled later.
std::optional<quint32> ParameterSpec::word(const QByteArray &block) const
{
    const int size = wireSize(row->wire);
    if (offset < 0 || block.size() < offset + size)
        return {};
    quint32 word = 0;
    for (int i = 0; i < size; ++i) {
        const int place = row->order == ByteOrder::Little ? i : size - 1 - i;
        word |= quint32(quint8(block[offset + place])) << (8 * i);
    }
    return word;
}

void ParameterSpec::putWord(QByteArray &block, quint32 word) const
{
    const int size = wireSize(row->wire);
    for (int i = 0; i < size; ++i) {
        const int place = row->order == ByteOrder::Little ? i : size - 1 - i;
        block[offset + place] = static_cast<char>((word >> (8 * i)) & 0xFF);
    }
}

std::optional<double> ParameterSpec::read(const QByteArray &block) const
{
    const auto stored = word(block);
    if (!stored)
        return {};
    if (row->bitCount)
        return (*stored & maskOf(*row)) >> row->bitShift;
    switch (row->wire) {
    case WireType::U8:
    case WireType::U16:
    case WireType::U32: return *stored;
    case WireType::I8: return static_cast<qint8>(*stored);
    case WireType::I16: return static_cast<qint16>(*stored);
    case WireType::I32: return static_cast<qint32>(*stored);
    case WireType::F32: break;
    }
    const auto value = std::bit_cast<float>(*stored);
    return std::isfinite(value) ? double(value) : kNoNumber;
}

bool ParameterSpec::write(QByteArray &block, double raw) const
{
    const auto stored = word(block);
    if (!stored || !std::isfinite(raw))
        return false;
    if (row->wire == WireType::F32) {
        putWord(block, std::bit_cast<quint32>(static_cast<float>(raw)));
        return true;
    }
    // Values that do not fit lose their upper bits, as on the board.
    const auto count = static_cast<quint32>(static_cast<qint64>(std::clamp(nearest(raw), -1e15, 1e15)));
    const quint32 mask = maskOf(*row);
    putWord(block, (*stored & ~mask) | ((count << row->bitShift) & mask));
    return true;
}

bool ParameterSpec::copy(QByteArray &block, const QByteArray &from) const
{
    const auto stored = word(block);
    const auto wanted = word(from);
    if (!stored || !wanted)
        return false;
    const quint32 mask = maskOf(*row);
    putWord(block, (*stored & ~mask) | (*wanted & mask));
    return true;
}

std::vector<Choice> ParameterSpec::choices(int version) const
{
    std::vector<Choice> list;
    std::copy_if(
        row->choices.begin(), row->choices.end(), std::back_inserter(list),
        [version](const Choice &choice) { return version >= choice.since && version <= choice.until; });
    return list;
}

QString ParameterSpec::format(double raw) const
{
    if (!std::isfinite(raw))
        return u"no number"_s;
    switch (row->kind) {
    case ValueKind::Toggle: return raw != 0 ? u"on"_s : u"off"_s;
    case ValueKind::Flags:
        return u"0x"_s + QString::number(qint64(raw), 16).rightJustified(2 * wireSize(row->wire), u'0');
    case ValueKind::Choice: return QString::number(qint64(raw));
    case ValueKind::Number: break;
    }
    const double value = nearest(raw);
    if (row->wire != WireType::F32) {
        const QString text = rounded(value);
        if (toRaw(text.toDouble()) == value)
            return text;
    }
    double display = toDisplay(value);
    for (int digits = 1; digits <= std::numeric_limits<double>::digits10; ++digits) {
        const double shorter = QString::number(toDisplay(value), 'g', digits).toDouble();
        if (toRaw(shorter) == value && std::signbit(shorter) == std::signbit(display)) {
            display = shorter;
            break;
        }
    }
    return plainNumber(display);
}

QString ParameterSpec::rounded(double raw) const
{
    return QString::number(toDisplay(raw), 'f', row->decimals);
}

std::optional<double> ParameterSpec::parse(const QString &text) const
{
    const QString word = text.trimmed();
    if (row->kind == ValueKind::Toggle) {
        if (word == u"on"_s || word == u"true"_s || word == u"1"_s)
            return 1;
        if (word == u"off"_s || word == u"false"_s || word == u"0"_s)
            return 0;
        return {};
    }
    bool ok = false;
    if (row->kind == ValueKind::Number) {
        const double raw = toRaw(word.toDouble(&ok));
        const bool fits = row->wire != WireType::F32 || std::isfinite(static_cast<float>(raw));
        return ok && std::isfinite(raw) && fits ? std::optional(raw) : std::nullopt;
    }
    const qint64 value = word.toLongLong(&ok, 0);
    if (ok)
        return double(value);
    for (const Choice &choice : row->choices) {
        if (row->kind == ValueKind::Choice
            && word.compare(QLatin1String(choice.name), Qt::CaseInsensitive) == 0)
            return choice.value;
    }
    return {};
}

QString ParameterSpec::inactiveKey() const
{
    return *row->inactive.key ? expandKey(row->inactive.key, axis, index) : QString();
}

ParameterSet::ParameterSet(std::span<const ParameterRow> rows, std::span<const BlockSpec> blocks,
                           int firmware, const Capabilities &capabilities, std::span<const ValueRule> rules)
    : m_blocks(blocks)
    , m_firmware(firmware)
{
    std::copy_if(rules.begin(), rules.end(), std::back_inserter(m_rules), [&](const ValueRule &rule) {
        return firmware <= rule.until
            && (!*rule.capability || capabilities.contains(QLatin1String(rule.capability)));
    });
    for (const ParameterRow &row : rows) {
        if (firmware < row.since || firmware > row.until)
            continue;
        if (*row.capability && !capabilities.contains(QLatin1String(row.capability)))
            continue;
        for (int index = 0; index < row.count; ++index) {
            for (int axis = 0; axis < row.axes; ++axis) {
                ParameterSpec spec;
                spec.row = &row;
                spec.id = static_cast<int>(m_specs.size());
                spec.firmware = firmware;
                spec.axis = row.axes > 1 ? kAxes[static_cast<std::size_t>(axis)] : row.axis;
                spec.index = row.count > 1 || std::strstr(row.key, "%n") ? index + row.firstIndex : -1;
                spec.key = expandKey(row.key, spec.axis, spec.index);
                const int place = row.pitchFirst && axis < 2 ? 1 - axis : axis;
                spec.offset = row.offset + place * row.axisStride + index * row.countStride;
                spec.adjustable = row.adjustable < 0 ? -1 : row.adjustable + place * row.adjustableStride;
                spec.defaultRaw = spec.nearest(row.defaults[static_cast<std::size_t>(axis)]);
                m_byKey.insert(spec.key, spec.id);
                m_specs.push_back(spec);
            }
        }
        const auto sameName = [&row](const char *group) { return qstrcmp(group, row.group) == 0; };
        if (std::none_of(m_groups.begin(), m_groups.end(), sameName))
            m_groups.append(row.group);
    }
}

const ParameterSpec *ParameterSet::find(const QString &key) const
{
    const auto it = m_byKey.find(key);
    return it == m_byKey.end() ? nullptr : &m_specs[static_cast<std::size_t>(*it)];
}

QList<const ParameterSpec *> ParameterSet::partsOf(const QString &formerKey) const
{
    QList<const ParameterSpec *> parts;
    for (const ParameterSpec &spec : m_specs) {
        if (*spec.row->formerly && expandKey(spec.row->formerly, spec.axis, spec.index) == formerKey)
            parts.append(&spec);
    }
    return parts;
}

const BlockSpec *ParameterSet::block(int id) const
{
    const auto it
        = std::find_if(m_blocks.begin(), m_blocks.end(), [id](const BlockSpec &b) { return b.id == id; });
    return it == m_blocks.end() ? nullptr : &*it;
}
