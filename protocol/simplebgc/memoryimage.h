// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>

namespace simplebgc {

/// A board's whole memory as a file: a line "GIMBALDESK-EEPROM 1", one of JSON (whose it is, its firmware,
/// the number of bytes and their SHA-1), then the bytes.
struct MemoryImage
{
    QString serial;
    QString model;
    QString firmware;
    QByteArray bytes;

    [[nodiscard]] QByteArray encode() const;
    /// Errors: BadFile (another kind of file, cut off, damaged).
    [[nodiscard]] static Result<MemoryImage> decode(const QByteArray &file);
};

}  // namespace simplebgc
