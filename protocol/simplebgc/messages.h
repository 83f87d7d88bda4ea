// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of the serial API as a table: document "Command ID definitions", errata 2 and 3.
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/result.h"
#include "protocol/configuration/parameterspec.h"
#include "protocol/device/actionspec.h"

#include <optional>
#include <span>
#include <vector>

namespace simplebgc {

/// How a field stands in a payload, little-endian (errata 0).
enum class FieldType : std::uint8_t {
    U8,
    S8,
    U16,
    S16,
    U24,
    U32,
    S32,
    F32,
    Quaternion,  ///< w, x, y and z in 8 bytes (errata 3.24)
    Bytes,  ///< as many as `count` says, 0: the rest. Without a name they are reserved: sent as zeros
    Text,  ///< UTF-8 in so many bytes, padded with zeros
    Sized,  ///< u8 length, then as many characters
    Group,  ///< the fields in `inner`, `count` times, 0: as often as they fit
};

/// What the elements of a field are called: "speed" is "speed", "speed.roll", "speed.x", "speed.w" or
/// "speed1".
enum class Elements : std::uint8_t { One, Axes, Xyz, Wxyz, Numbered };

/// Some bits of a field: a flag, or a number of its own.
struct BitsSpec
{
    const char *name = "";  ///< behind that of the field
    int first = 0;
    int count = 1;
    std::span<const Choice> words{};
};

/// Whether a field is there, as a field in front of it tells.
struct Presence
{
    const char *field = "";  ///< in the same group, or outside of it
    /// Null: always. @param element of the nearest group that repeats, from 0
    bool (*isThere)(std::uint32_t told, int element) = nullptr;
};

/// One field of a payload.
struct FieldSpec
{
    const char *name = "";
    FieldType type = FieldType::U8;
    int count = 1;
    Elements elements = Elements::One;
    const char *unit = "";
    double scale = 1;  ///< raw x scale = value in that unit
    std::span<const Choice> words{};  ///< of its numbers
    std::span<const FieldSpec> inner{};
    std::span<const BitsSpec> bits{};  ///< what it is made of; none: one number
    Presence when{};
};

using Fields = std::span<const FieldSpec>;

/// What the board says to a command.
enum class Reply : std::uint8_t { None, Confirm, Frame };

/// One command, both ways. The board's frames of the same number may be something else.
struct MessageSpec
{
    int id = 0;
    const char *name = "";
    std::optional<Fields> toBoard;  ///< none: there is no such direction, or nobody outside knows its layout
    std::optional<Fields> fromBoard;
    Reply reply = Reply::None;
    ActionRisk risk = ActionRisk::Destroys;  ///< of a payload by hand
    int since = 0;  ///< firmware; 0: the document's; kLater where the errata say "later" only
    int least = -1;  ///< bytes towards the board at least; -1: all of them
    bool isPublic = true;  ///< false: its layout is in no public text
    const char *where = "";  ///< where the program uses it; empty: by hand only (Console, `gimbalctl raw`)
    int answeredBy = 0;  ///< the number of the reply where it is another
};

/// Stands for "later" where the errata name no version.
inline constexpr int kLater = 2600;
/// Newer than any.
inline constexpr int kAnyFirmware = 99999;
/// The first firmware with AUTO_PID2.
inline constexpr int kTuneByAxisSince = 2730;

[[nodiscard]] std::span<const MessageSpec> messages();
/// Null: no such number.
[[nodiscard]] const MessageSpec *findMessage(int id);
[[nodiscard]] const MessageSpec *findMessage(const QString &name);
/// With the fields that it had in that firmware. @param firmware 0: not known, taken for the newest
[[nodiscard]] MessageSpec asOf(const MessageSpec &message, int firmware);
/// What REALTIME_DATA_4 holds behind `kRealtime4LaterAt`, reserved in the document's firmware (errata 3.8).
[[nodiscard]] Fields realtime4Later();
inline constexpr int kRealtime4LaterAt = 88;

/// A number or a text that one field holds.
struct FieldValue
{
    QString name;  ///< "roll.speed", "channel3"
    const FieldSpec *spec = nullptr;
    double number = 0;  ///< in the field's unit
    QByteArray bytes = {};  ///< of Bytes, Text and Sized
    const BitsSpec *bits = nullptr;  ///< it is this part of the field

    [[nodiscard]] bool isText() const;
    /// "16 (AUX1)", "12.50°".
    [[nodiscard]] QString text() const;
};

/// The fields of a payload, as many as it holds whole; reserved ones are left out. Of a field that is made of
/// bits come its parts.
[[nodiscard]] std::vector<FieldValue> decodeFields(Fields fields, Bytes payload);

/// The names of the fields, also of those that are there only with others; where they repeat as often as they
/// fit, those of the first.
[[nodiscard]] QStringList fieldNames(Fields fields);

/// A payload from words "name=value". What is not named behind the last field that is need not be there,
/// unless another field says that it is. Bits are given by their parts, of which those that are not named are
/// 0, or as one number.
/// @param least bytes that it has to have. Errors: InvalidArgument with the names; OutOfRange.
[[nodiscard]] Result<QByteArray> encodeFields(Fields fields, const QStringList &words, int least);

}  // namespace simplebgc
