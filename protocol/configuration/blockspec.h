// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QtGlobal>

#include <cstdint>

/// What writing a block means for the board.
enum class WriteEffect : std::uint8_t {
    Permanent,  ///< stored at once
    Volatile,  ///< in use until the board restarts
    Restarts,  ///< stored, and the board restarts with it
};

/// What a block of data without parameters is.
enum class DataKind : std::uint8_t {
    Code,  ///< bytes for the board, made from the operator's texts by a ScriptLanguage
    Text,  ///< the operator's own text, in UTF-8
};

/// A block of raw bytes that is read and written as a whole.
struct BlockSpec
{
    std::uint8_t id = 0;
    const char *name = "";
    int size = 0;  ///< in bytes
    /// What is in it, where that is no parameters but one thing, edited and written as a whole.
    const char *data = "";
    int maxSize = 0;  ///< where its length varies: size to maxSize bytes; 0 = always size bytes
    DataKind kind = DataKind::Code;
    const char *language = "";  ///< of a text, for its editor: "lua"
    WriteEffect effect = WriteEffect::Permanent;
    milliseconds restartTime{0};  ///< longest absence after a write that restarts; 0 = kRestartLimit

    /// Whether so many bytes are a whole block.
    [[nodiscard]] constexpr bool holds(qsizetype bytes) const
    {
        return bytes >= size && bytes <= (maxSize > 0 ? maxSize : size);
    }
    [[nodiscard]] constexpr bool isData() const { return *data; }
    [[nodiscard]] constexpr bool isText() const { return isData() && kind == DataKind::Text; }
};

/// How long a restarting board is waited for, where its family does not say: several times what controllers
/// need to start, and as long as an operator waits before looking what is wrong.
inline constexpr milliseconds kRestartLimit = 20s;
