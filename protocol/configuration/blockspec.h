// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QByteArray>

#include <cstdint>
#include <optional>

struct ScriptMistake;

/// Effect that writing a block has on the board.
enum class WriteEffect : std::uint8_t {
    Permanent,  ///< stored at once
    Volatile,  ///< in use until the board restarts
    Restarts,  ///< stored, and the board restarts
};

/// Kind of data in a block without parameters.
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
    /// Names the content of a block that has no parameters but is edited and written as a whole.
    const char *data = "";
    int maxSize = 0;  ///< for a variable length: size to maxSize bytes; 0 = always size bytes
    DataKind kind = DataKind::Code;
    const char *language = "";  ///< of a text, for its editor: "lua"
    WriteEffect effect = WriteEffect::Permanent;
    int since = 0;  ///< first firmware that has it; an older one may lack it
    milliseconds restartTime{0};  ///< longest absence after a write that restarts; 0 = kRestartLimit
    /// What is wrong with a text in its language; empty where it is valid, which does not prove that the
    /// board can use it. Null: nobody can tell.
    std::optional<ScriptMistake> (*check)(const QByteArray &text) = nullptr;

    /// Whether this many bytes make a whole block.
    [[nodiscard]] constexpr bool holds(qsizetype bytes) const
    {
        return bytes >= size && bytes <= (maxSize > 0 ? maxSize : size);
    }
    [[nodiscard]] constexpr bool isData() const { return *data; }
    [[nodiscard]] constexpr bool isText() const { return isData() && kind == DataKind::Text; }
};

/// How long to wait for a restarting board if its family does not say: several times what controllers need to
/// start, and about as long as an operator waits before looking for the cause.
inline constexpr milliseconds kRestartLimit = 20s;
