// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/result.h"

#include <QVariantMap>

/// One field of a payload that is known by name, where it stands on the wire (low byte first).
struct NamedField
{
    enum Type : std::uint8_t { U8, I8, U16, I16, U32, I32, F32, Text, Bytes };
    const char *name = "";
    Type type = U8;
    int offset = 0;
    int size = 1;  ///< in bytes; for Text the room it has, for Bytes 0: all that is left
};
using NamedFields = std::span<const NamedField>;

/// The values of a payload by field name; floats as they stand, bytes as QByteArray. Bytes between fields are
/// passed over. Errors: BadReply (too short).
[[nodiscard]] Result<QVariantMap> decodeFields(NamedFields fields, ::Bytes payload);

/// A payload out of values by name; a number may be given as text. What is not named is zero, and so are
/// bytes between the fields and up to the size. Errors: InvalidArgument (no such field, no number),
/// OutOfRange (a number that the field cannot hold).
[[nodiscard]] Result<QByteArray> encodeFields(NamedFields fields, const QVariantMap &values, int size = 0);
