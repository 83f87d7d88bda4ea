// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/result.h"

#include <QVariantMap>

/// One named field of a payload and its place on the wire (low byte first).
struct NamedField
{
    enum Type : std::uint8_t { U8, I8, U16, I16, U32, I32, F32, Text, Bytes };
    const char *name = "";
    Type type = U8;
    int offset = 0;
    int size = 1;  ///< in bytes; for Text the space available, for Bytes 0: the rest of the payload
};
using NamedFields = std::span<const NamedField>;

/// The values of a payload by field name; floats unchanged, bytes as QByteArray. Gaps between fields are
/// skipped. Errors: BadReply (too short).
[[nodiscard]] Result<QVariantMap> decodeFields(NamedFields fields, ::Bytes payload);

/// Builds a payload from values by field name; a number may be given as text. Fields that are not named, gaps
/// between fields and bytes up to the size are zero. Errors: InvalidArgument (no such field, not a number),
/// OutOfRange (a number that the field cannot hold).
[[nodiscard]] Result<QByteArray> encodeFields(NamedFields fields, const QVariantMap &values, int size = 0);
