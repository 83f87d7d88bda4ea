// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/configuration/scriptlanguage.h"

#include <QList>
#include <QString>

#include <array>
#include <functional>
#include <optional>
#include <vector>

/// The four scripts of a STorM32 board: bytecode on the board, text for the operator (errata 8). Text is
/// compiled, never run here.
namespace storm32 {

inline constexpr int kScriptCount = 4;
/// Four offset bytes and the code of all scripts.
inline constexpr int kScriptArea = 128;

/// A parameter as scripts name it.
struct ScriptParameter
{
    int index = 0;
    QString name;  ///< without a remark in brackets
    bool isSigned = false;
    int min = -32768;  ///< what it may be set to
    int max = 65535;
    QList<int> choices = {};  ///< the only ones; empty: all from min to max
    int step = 1;
};

/// The parameters of one layout, and the firmware that decides which words exist.
struct ScriptContext
{
    std::vector<ScriptParameter> parameters;
    int firmware = 96;  ///< 79, 90, 96
    int words = 256;  ///< so many parameters can be named by number
};

/// One statement as stored in memory.
struct ScriptLine
{
    int offset = 0;  ///< from the start of its script
    int size = 0;
    QString text;  ///< what the compiler understands; "?? 2A" for a byte that is no statement
};

/// Disassembles bytecode, statement by statement. Accepts any bytes. @param script 0..3
[[nodiscard]] std::vector<ScriptLine> disassemble(QByteArrayView area, int script,
                                                  const ScriptContext &context);
/// What one script may change: indices of parameters; empty and `all` where it restores everything.
struct ScriptEffect
{
    std::vector<int> parameters;
    bool all = false;
};
[[nodiscard]] ScriptEffect scriptEffect(QByteArrayView area, int script, const ScriptContext &context);
/// The text of one script, ready for the editor.
[[nodiscard]] QString scriptText(QByteArrayView area, int script, const ScriptContext &context);

/// Compiles all four texts into the area of 128 bytes. Empty lines, and lines that start with // or ;, are
/// ignored. What a script may set a parameter to is what an operator may, but for scripts that the board has
/// already.
[[nodiscard]] CompiledScripts compileScripts(const std::array<QString, kScriptCount> &texts,
                                             const ScriptContext &context,
                                             const std::array<bool, kScriptCount> &held = {});

/// The words that this firmware understands, for auto-completion.
[[nodiscard]] QStringList scriptWords(int firmware);

}  // namespace storm32
