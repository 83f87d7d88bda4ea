// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/choice.h"
#include "protocol/configuration/blockspec.h"

#include <QByteArray>
#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

class Configuration;
struct ParameterSpec;

enum class WireType : std::uint8_t { U8, I8, U16, I16, U32, I32, F32 };
enum class ByteOrder : std::uint8_t { Little, Big };
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
    switch (type) {
    case WireType::U8:
    case WireType::I8: return 1;
    case WireType::U16:
    case WireType::I16: return 2;
    default: return 4;
    }
}

/// Lowest and highest number that a wire type carries.
constexpr std::pair<double, double> wireRange(WireType type)
{
    switch (type) {
    case WireType::U8: return {0, 255};
    case WireType::I8: return {-128, 127};
    case WireType::U16: return {0, 65535};
    case WireType::I16: return {-32768, 32767};
    case WireType::U32: return {0, 4294967295};
    case WireType::I32: return {-2147483648.0, 2147483647};
    case WireType::F32: break;
    }
    return {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()};
}

/// Whether two raw values are equal. A raw value is a double, which carries every 32-bit integer and every
/// float exactly; NaN stands for a float that is not a number and equals every other NaN.
inline bool sameValue(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}
inline bool sameValue(std::optional<double> a, std::optional<double> b)
{
    return a.has_value() == b.has_value() && (!a || sameValue(*a, *b));
}

/// Shortest plain text that toDouble() reads as exactly the same number: "100000", "0.18", "2e-06".
[[nodiscard]] QString plainNumber(double value);

/// The bits of a raw value that is a flag word.
inline quint32 flagBits(double raw)
{
    return std::isfinite(raw) ? static_cast<quint32>(static_cast<qint64>(raw)) : 0;
}

/// Condition under which a parameter has no effect: another one has this value. "%a" and "%n" in the key
/// stand for the parameter's own axis and index.
struct NoEffectWhile
{
    const char *key = "";
    int value = 0;
};

/// The declaration of a parameter: one row of a family's table. A row with several axes or indices stands for
/// that many parameters, consecutive in the block; "%a" in the key is the axis, "%n" the index from 1.
struct ParameterRow
{
    const char *key = "";
    const char *label = "";
    const char *group = "";
    const char *help = "";
    std::uint8_t block = 0;
    std::uint16_t offset = 0;
    WireType wire = WireType::U8;
    ByteOrder order = ByteOrder::Little;
    std::uint8_t bitShift = 0;
    std::uint8_t bitCount = 0;  ///< 0 = the whole word; integers only
    ValueKind kind = ValueKind::Number;
    std::uint8_t axes = 1;  ///< 1, 2 (roll, pitch) or 3
    std::uint8_t axisStride = 0;
    bool pitchFirst = false;  ///< the axes lie in the order pitch, roll, yaw
    Axis axis = Axis::None;  ///< for a single value that belongs to one axis
    std::uint8_t count = 1;
    std::uint8_t countStride = 0;
    std::uint8_t firstIndex = 1;
    const char *unit = "";
    double scale = 1.0;
    double bias = 0.0;
    double min = 0;  ///< range in raw numbers
    double max = 255;
    int step = 1;  ///< of integers: only every so many counts from min are allowed
    int decimals = 0;  ///< on the screen
    std::array<double, 3> defaults{0, 0, 0};
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
    const char *name = "";  ///< name in the family's own files; "%A" is the axis
    NoEffectWhile inactive{};
    const char *formerly = "";  ///< key of earlier files, which held all bits of the word
    /// The number that stands for this value in a text which the board keeps, where that is another one.
    /// Empty: it is not known, because the text is not there or does not tell. Null: there is none.
    std::optional<double> (*textFigure)(const Configuration &configuration, const ParameterSpec &spec,
                                        double raw)
        = nullptr;
    /// The value that the board starts with, where such a text tells it. Empty: it does not. Null: there is
    /// none.
    std::optional<double> (*startsWith)(const Configuration &configuration, const ParameterSpec &spec)
        = nullptr;
};

/// Two parameters whose values can exclude each other although each is allowed; or one, whose values exclude
/// what the board is.
struct ValueRule
{
    const char *first = "";
    const char *second = "";  ///< empty: the rule is about the first alone, and `b` is 0
    bool (*isBroken)(double a, double b) = nullptr;
    const char *why = "";  ///< "one axis of the sensor cannot point both up and right"
    const char *capability = "";  ///< the rule holds for boards that have this
    int until = 99999;  ///< the last firmware for which it holds

    [[nodiscard]] bool concerns(const QString &key) const
    {
        return key == QLatin1String(first) || key == QLatin1String(second);
    }
};

using Capabilities = QSet<QString>;

/// One parameter: a row with its axis and index filled in.
struct ParameterSpec
{
    const ParameterRow *row = nullptr;
    int id = 0;  ///< position in its ParameterSet
    QString key;  ///< "pid.roll.p": files, command line, diffs
    Axis axis = Axis::None;
    int index = -1;  ///< from ParameterRow::firstIndex; -1 = the row has none
    int offset = 0;
    int adjustable = -1;
    double defaultRaw = 0;
    int firmware = 0;  ///< of its ParameterSet; decides which choices there are

    /// The number the operator sees.
    [[nodiscard]] double toDisplay(double raw) const;
    /// The nearest raw number that the wire type can represent, not clamped. Accepts what toDisplay()
    /// returns.
    [[nodiscard]] double toRaw(double display) const;
    /// The nearest number that the wire type can represent: an integer or a float; not clamped.
    [[nodiscard]] double nearest(double raw) const;
    /// The raw number behind its live variable; of integers whole counts, as the board divides.
    [[nodiscard]] double rawOf(double variable) const;
    /// False also for NaN.
    [[nodiscard]] bool isInRange(double raw) const;
    /// Whether an operator may set it: in range, on a step and, for a choice or a flag, one that this
    /// firmware has. A board may hold others all the same.
    [[nodiscard]] bool accepts(double raw) const;
    /// The same where the board holds `held`: bits of a flag word that have no name may stay, or go.
    [[nodiscard]] bool accepts(double raw, std::optional<double> held) const;
    /// The nearest one in range and on a step; of a choice, in range.
    [[nodiscard]] double clamped(double raw) const;
    /// Raw number from a block, NaN for a float that is NaN or infinite; empty when the block is too short.
    [[nodiscard]] std::optional<double> read(const QByteArray &block) const;
    /// Writes a raw number into a block, leaving every other bit unchanged. False when the block is too short
    /// or the value is not a number.
    bool write(QByteArray &block, double raw) const;
    /// Copies the bits unchanged from another block, a number or not. False when either block is too short.
    bool copy(QByteArray &block, const QByteArray &from) const;
    /// Key of the parameter that decides whether this one has an effect; empty: it always has.
    [[nodiscard]] QString inactiveKey() const;
    /// Choices (or flag bits) that this version of the firmware has.
    [[nodiscard]] std::vector<Choice> choices(int version) const;

    /// Plain text of a value as files and the command line use it: "15", "0.18", "2e-06", "on", "0x0410"; "no
    /// number" for NaN. Has as many digits as parse() needs to restore exactly the same value.
    [[nodiscard]] QString format(double raw) const;
    /// A number for the screen, with the row's decimals.
    [[nodiscard]] QString rounded(double raw) const;
    /// Parses what format() writes for a number and, for choices, the choice's name. Empty: not understood,
    /// or a value that the wire type cannot represent (NaN, infinite).
    [[nodiscard]] std::optional<double> parse(const QString &text) const;
    [[nodiscard]] QString minText() const { return format(row->min); }
    [[nodiscard]] QString maxText() const { return format(row->max); }
    /// What accepts() allows: "0 to 30", "12 to 28 in steps of 2", "0 to 5, 33 to 35".
    [[nodiscard]] QString allowedText() const;

private:
    [[nodiscard]] quint32 unnamedBits(double raw) const;
    [[nodiscard]] std::optional<quint32> word(const QByteArray &block) const;
    void putWord(QByteArray &block, quint32 word) const;
};

/// The parameters that one board has: rows expanded and filtered by firmware and capabilities.
class ParameterSet
{
public:
    ParameterSet(std::span<const ParameterRow> rows, std::span<const BlockSpec> blocks, int firmware,
                 const Capabilities &capabilities, std::span<const ValueRule> rules = {});

    [[nodiscard]] const std::vector<ParameterSpec> &all() const { return m_specs; }
    [[nodiscard]] const ParameterSpec &at(int id) const { return m_specs[static_cast<std::size_t>(id)]; }
    [[nodiscard]] const ParameterSpec *find(const QString &key) const;
    /// What the word behind this key of earlier files has become.
    [[nodiscard]] QList<const ParameterSpec *> partsOf(const QString &formerKey) const;
    [[nodiscard]] std::span<const BlockSpec> blocks() const { return m_blocks; }
    [[nodiscard]] const BlockSpec *block(int id) const;
    /// Group names in table order.
    [[nodiscard]] const QList<const char *> &groups() const { return m_groups; }
    [[nodiscard]] int firmware() const { return m_firmware; }
    /// Those that hold for this board.
    [[nodiscard]] const std::vector<ValueRule> &rules() const { return m_rules; }

private:
    std::vector<ParameterSpec> m_specs;
    std::span<const BlockSpec> m_blocks;
    std::vector<ValueRule> m_rules;
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

/// True when each row's range fits its wire type and its defaults are allowed; a float has no bit field
/// and no steps, is a plain number and is converted linearly.
constexpr bool rangesFit(std::span<const ParameterRow> rows)
{
    const auto isWhole = [](double value) { return double(static_cast<long long>(value)) == value; };
    for (const ParameterRow &row : rows) {
        const bool isFloat = row.wire == WireType::F32;
        if (isFloat
            && (row.bitCount || row.step != 1 || row.kind != ValueKind::Number
                || row.conversion != Conversion::Linear))
            return false;
        auto [low, high] = wireRange(row.wire);
        if (row.kind == ValueKind::Flags && low < 0)
            return false;
        if (row.bitShift + row.bitCount > 8 * wireSize(row.wire))
            return false;
        if (row.bitCount)
            high = double((1LL << row.bitCount) - 1);
        if (!(row.min <= row.max && row.min >= low && row.max <= high))
            return false;
        if (!isFloat && !(isWhole(row.min) && isWhole(row.max)))
            return false;
        if (row.step < 1 || (row.step > 1 && (static_cast<long long>(row.max - row.min) % row.step)))
            return false;
        for (int axis = 0; axis < row.axes; ++axis) {
            const double value = row.defaults[std::size_t(axis)];
            bool listed = row.kind != ValueKind::Choice || row.choices.empty() || row.state;
            for (const Choice &choice : row.choices)
                listed = listed || choice.value == value;
            if (!listed || (row.step > 1 && static_cast<long long>(value - row.min) % row.step))
                return false;
            if (!row.state && !(value >= row.min && value <= row.max && (isFloat || isWhole(value))))
                return false;
        }
    }
    return true;
}
