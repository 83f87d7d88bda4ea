// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/parameterspec.h"

#include "protocol/base/bytes.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

const double kLogBase = std::log(52.0) / 255.0;

QString expandKey(const char *pattern, Axis axis, int index)
{
    QString key = QLatin1String(pattern);
    key.replace(u"%a"_s, QLatin1String(axisKey(axis)));
    key.replace(u"%n"_s, QString::number(index));
    return key;
}

}  // namespace

double ParameterSpec::toDisplay(int raw) const
{
    if (row->conversion == Conversion::Logarithmic)
        return 5.0 * std::exp(raw * kLogBase) - 5.0;
    return raw * row->scale + row->bias;
}

int ParameterSpec::toRaw(double display) const
{
    if (row->conversion == Conversion::Logarithmic)
        return static_cast<int>(std::lround(std::log(std::max(display + 5.0, 5.0) / 5.0) / kLogBase));
    const double raw = (display - row->bias) / row->scale;
    return static_cast<int>(std::lround(std::clamp(raw, -1e9, 1e9)));
}

bool ParameterSpec::isInRange(int raw) const
{
    return raw >= row->min && raw <= row->max;
}

int ParameterSpec::clamped(int raw) const
{
    return std::clamp(raw, row->min, row->max);
}

std::optional<int> ParameterSpec::read(const QByteArray &block) const
{
    if (block.size() < offset + wireSize(row->wire))
        return {};
    ByteReader reader(QByteArrayView(block).sliced(offset));
    int value = 0;
    switch (row->wire) {
    case WireType::U8: value = reader.u8(); break;
    case WireType::I8: value = reader.i8(); break;
    case WireType::U16: value = reader.u16(); break;
    case WireType::I16: value = reader.i16(); break;
    }
    if (row->bitCount)
        value = (value >> row->bitShift) & ((1 << row->bitCount) - 1);
    return value;
}

bool ParameterSpec::write(QByteArray &block, int raw) const
{
    const int size = wireSize(row->wire);
    if (block.size() < offset + size)
        return false;
    int word = raw;
    if (row->bitCount) {
        const int mask = ((1 << row->bitCount) - 1) << row->bitShift;
        ByteReader reader(QByteArrayView(block).sliced(offset));
        const int old = size == 1 ? reader.u8() : reader.u16();
        word = (old & ~mask) | ((raw << row->bitShift) & mask);
    }
    block[offset] = static_cast<char>(word & 0xFF);
    if (size == 2)
        block[offset + 1] = static_cast<char>((word >> 8) & 0xFF);
    return true;
}

std::vector<Choice> ParameterSpec::choices(int firmware) const
{
    std::vector<Choice> list;
    std::copy_if(
        row->choices.begin(), row->choices.end(), std::back_inserter(list),
        [firmware](const Choice &choice) { return firmware >= choice.since && firmware <= choice.until; });
    return list;
}

QString ParameterSpec::format(int raw) const
{
    switch (row->kind) {
    case ValueKind::Toggle: return raw ? u"on"_s : u"off"_s;
    case ValueKind::Flags:
        return u"0x"_s + QString::number(raw, 16).rightJustified(2 * wireSize(row->wire), u'0');
    case ValueKind::Choice: return QString::number(raw);
    case ValueKind::Number: break;
    }
    return QString::number(toDisplay(raw), 'f', row->decimals);
}

std::optional<int> ParameterSpec::parse(const QString &text) const
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
        const double value = word.toDouble(&ok);
        return ok && std::isfinite(value) ? std::optional(toRaw(value)) : std::nullopt;
    }
    const int value = word.toInt(&ok, 0);
    if (ok)
        return value;
    for (const Choice &choice : row->choices) {
        if (row->kind == ValueKind::Choice
            && word.compare(QLatin1String(choice.name), Qt::CaseInsensitive) == 0)
            return choice.value;
    }
    return {};
}

QString ParameterSpec::idleKey() const
{
    return *row->idle.key ? expandKey(row->idle.key, axis, index) : QString();
}

ParameterSet::ParameterSet(std::span<const ParameterRow> rows, std::span<const BlockSpec> blocks,
                           int firmware, const Capabilities &capabilities)
    : m_blocks(blocks)
    , m_firmware(firmware)
{
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
                spec.axis = row.axes > 1 ? kAxes[static_cast<std::size_t>(axis)] : row.axis;
                spec.index = row.count > 1 ? index + 1 : 0;
                spec.key = expandKey(row.key, spec.axis, spec.index);
                const int place = row.pitchFirst && axis < 2 ? 1 - axis : axis;
                spec.offset = row.offset + place * row.axisStride + index * row.countStride;
                spec.adjustable = row.adjustable < 0 ? -1 : row.adjustable + place * row.adjustableStride;
                spec.defaultRaw = row.defaults[static_cast<std::size_t>(axis)];
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

const BlockSpec *ParameterSet::block(int id) const
{
    const auto it
        = std::find_if(m_blocks.begin(), m_blocks.end(), [id](const BlockSpec &b) { return b.id == id; });
    return it == m_blocks.end() ? nullptr : &*it;
}
