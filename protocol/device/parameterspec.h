// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <QByteArray>
#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>

#include <array>
#include <optional>
#include <span>
#include <vector>

enum class WireType : std::uint8_t { U8, I8, U16, I16 };
enum class ValueKind : std::uint8_t { Number, Choice, Flags, Toggle };
enum class ViewLevel : std::uint8_t { Basic, Advanced, Expert };
/// Profile: each profile has its own value. Board: one value, kept in every profile's block.
enum class Scope : std::uint8_t { Profile, Board };
/// Red: a wrong value can make a motor run away, overheat it or move the camera where it must not go.
enum class Risk : std::uint8_t { Normal, Red };
/// How a raw number becomes the number the operator sees.
enum class Conversion : std::uint8_t {
    Linear,  ///< raw * scale + bias
    Logarithmic,  ///< 5 exp(raw ln 52 / 255) - 5 (SimpleBGC from 2.73.1, errata 3.3)
};

constexpr int wireSize(WireType type)
{
    return type == WireType::U8 || type == WireType::I8 ? 1 : 2;
}

/// One entry of a choice list, or one bit of a flag word (value = bit number).
struct Choice
{
    int value = 0;
    const char *name = "";
    int since = 0;  ///< firmware that introduced it; 0 = always there
    int until = 99999;
};

/// When a parameter has no effect: while another one has this value. "%a" and "%n" in the key are those of
/// its own.
struct NoEffectWhile
{
    const char *key = "";
    int value = 0;
};

/// The declaration of a parameter: one row of a family's table. A row with several axes or indices stands for
/// that many parameters, one after the other in the block; "%a" in the key is the axis, "%n" the index
/// from 1.
struct ParameterRow
{
    const char *key = "";
    const char *label = "";
    const char *group = "";
    const char *help = "";
    std::uint8_t block = 0;
    std::uint16_t offset = 0;
    WireType wire = WireType::U8;
    std::uint8_t bitShift = 0;
    std::uint8_t bitCount = 0;  ///< 0 = the whole word
    ValueKind kind = ValueKind::Number;
    std::uint8_t axes = 1;  ///< 1, 2 (roll, pitch) or 3
    std::uint8_t axisStride = 0;
    bool pitchFirst = false;  ///< the axes lie in the order pitch, roll, yaw
    Axis axis = Axis::None;  ///< for a single value that belongs to one axis
    std::uint8_t count = 1;
    std::uint8_t countStride = 0;
    const char *unit = "";
    double scale = 1.0;
    double bias = 0.0;
    int min = 0;  ///< range in raw numbers
    int max = 255;
    int decimals = 0;
    std::array<int, 3> defaults{0, 0, 0};
    std::span<const Choice> choices{};
    ViewLevel level = ViewLevel::Advanced;
    Scope scope = Scope::Profile;
    Risk risk = Risk::Normal;
    int since = 0;
    int until = 99999;
    const char *capability = "";
    int adjustable = -1;  ///< number of the live-adjustable variable (of the first axis), -1 = none
    int adjustableScale = 1;  ///< variable = raw * this
    int adjustableStride = 1;  ///< from the variable of one axis to that of the next
    Conversion conversion = Conversion::Linear;
    bool state = false;  ///< reported by the board, not set by the operator
    const char *name = "";  ///< what the family's own files call it; "%A" is the axis
    NoEffectWhile idle{};
};

/// A block of raw bytes that is read and written as a whole.
struct BlockSpec
{
    std::uint8_t id = 0;
    const char *name = "";
    int size = 0;
    const char *data
        = "";  ///< what is in it, where that is no parameters but one thing, edited and written as a whole
};

using Capabilities = QSet<QString>;

/// One parameter: a row with its axis and index filled in.
struct ParameterSpec
{
    const ParameterRow *row = nullptr;
    int id = 0;  ///< position in its ParameterSet
    QString key;  ///< "pid.roll.p": files, command line, diffs
    Axis axis = Axis::None;
    int index = 0;  ///< from 1; 0 = the row has no index
    int offset = 0;
    int adjustable = -1;
    int defaultRaw = 0;

    /// The number the operator sees.
    [[nodiscard]] double toDisplay(int raw) const;
    /// The raw number nearest to it, not clamped. Takes what toDisplay() gives.
    [[nodiscard]] int toRaw(double display) const;
    [[nodiscard]] bool isInRange(int raw) const;
    [[nodiscard]] int clamped(int raw) const;
    /// Raw number out of a block; empty when the block is too short.
    [[nodiscard]] std::optional<int> read(const QByteArray &block) const;
    /// Puts a raw number into a block, leaving every other bit alone. False when the block is too short.
    bool write(QByteArray &block, int raw) const;
    /// Key of the parameter that decides whether this one has an effect; empty: it always has.
    [[nodiscard]] QString idleKey() const;
    /// Choices that this firmware has (flag bits likewise).
    [[nodiscard]] std::vector<Choice> choices(int firmware) const;

    /// Plain text of a value as files and the command line use it: "15", "0.18", "on", "0x0410".
    [[nodiscard]] QString format(int raw) const;
    /// Understands what format() writes, and for choices the choice's name. Empty: not understood.
    [[nodiscard]] std::optional<int> parse(const QString &text) const;
    [[nodiscard]] QString minText() const { return format(row->min); }
    [[nodiscard]] QString maxText() const { return format(row->max); }
};

/// The parameters that one board has: rows expanded and filtered by firmware and capabilities.
class ParameterSet
{
public:
    ParameterSet(std::span<const ParameterRow> rows, std::span<const BlockSpec> blocks, int firmware,
                 const Capabilities &capabilities);

    [[nodiscard]] const std::vector<ParameterSpec> &all() const { return m_specs; }
    [[nodiscard]] const ParameterSpec &at(int id) const { return m_specs[static_cast<std::size_t>(id)]; }
    [[nodiscard]] const ParameterSpec *find(const QString &key) const;
    [[nodiscard]] std::span<const BlockSpec> blocks() const { return m_blocks; }
    [[nodiscard]] const BlockSpec *block(int id) const;
    /// Group names in table order.
    [[nodiscard]] const QList<const char *> &groups() const { return m_groups; }
    [[nodiscard]] int firmware() const { return m_firmware; }

private:
    std::vector<ParameterSpec> m_specs;
    std::span<const BlockSpec> m_blocks;
    QHash<QString, int> m_byKey;
    QList<const char *> m_groups;
    int m_firmware;
};

/// True when rows and reserved ranges cover each byte of a block exactly once (bit fields of one word may
/// share it, and rows of different firmware ranges may overlap). For static_asserts beside the tables.
template <std::size_t Size>
constexpr bool coversBlock(std::span<const ParameterRow> rows, int block,
                           std::span<const std::pair<int, int>> reserved)
{
    std::array<std::uint8_t, Size> whole{};
    std::array<std::uint8_t, Size> bits{};
    for (const ParameterRow &row : rows) {
        if (row.block != block)
            continue;
        for (int axis = 0; axis < row.axes; ++axis) {
            for (int index = 0; index < row.count; ++index) {
                const int start = row.offset + axis * row.axisStride + index * row.countStride;
                for (int byte = start; byte < start + wireSize(row.wire); ++byte) {
                    if (byte < 0 || byte >= int(Size))
                        return false;
                    if (row.bitCount)
                        bits[std::size_t(byte)] = 1;
                    else if (whole[std::size_t(byte)]++ && row.since == 0 && row.until == 99999)
                        return false;
                }
            }
        }
    }
    for (const auto &[first, count] : reserved) {
        for (int byte = first; byte < first + count; ++byte) {
            if (whole[std::size_t(byte)] || bits[std::size_t(byte)])
                return false;
            whole[std::size_t(byte)] = 1;
        }
    }
    for (std::size_t byte = 0; byte < Size; ++byte) {
        if (!whole[byte] && !bits[byte])
            return false;
    }
    return true;
}

/// True when each row's range fits its wire type and its defaults lie in the range.
constexpr bool rangesFit(std::span<const ParameterRow> rows)
{
    for (const ParameterRow &row : rows) {
        long low = 0;
        long high = 255;
        switch (row.wire) {
        case WireType::U8: break;
        case WireType::I8:
            low = -128;
            high = 127;
            break;
        case WireType::U16: high = 65535; break;
        case WireType::I16:
            low = -32768;
            high = 32767;
            break;
        }
        if (row.bitCount)
            high = (1L << row.bitCount) - 1;
        if (row.min > row.max || row.min < low || row.max > high)
            return false;
        for (int axis = 0; axis < row.axes; ++axis) {
            const int value = row.defaults[std::size_t(axis)];
            if (!row.state && (value < row.min || value > row.max))
                return false;
        }
    }
    return true;
}
