// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// What is wrong with the text of a script.
struct ScriptMistake
{
    int script = 0;  ///< from 0
    int line = 0;  ///< from 1; 0 where it is the whole script
    const char *what = "";  ///< a text of the tables, with places for the values
    QStringList values;

    /// The sentence with its values. @param pattern what, maybe in another language
    [[nodiscard]] QString sentence(const QString &pattern) const;
    /// "script 2, line 3: 'FLY' is no statement", as an error.
    [[nodiscard]] Error error() const;
};
using CompiledScripts = tl::expected<QByteArray, ScriptMistake>;

/// The programs that boards of a family keep in a block of data: texts for the operator, code for the board.
/// A text is compiled, never run here.
class ScriptLanguage
{
public:
    /// One statement of the code.
    struct Line
    {
        int offset = 0;  ///< bytes from the start of its script
        QString text;
    };

    virtual ~ScriptLanguage() = default;
    /// The block that holds them (BlockSpec::id).
    [[nodiscard]] virtual int block() const = 0;
    [[nodiscard]] virtual int count() const = 0;
    /// Key of the parameter that says what runs a script; empty: none.
    [[nodiscard]] virtual QString inputKey(int script) const = 0;
    /// Ending of their files, "scr".
    [[nodiscard]] virtual QString suffix() const = 0;
    /// Text of one script, from 0; empty when there is none.
    [[nodiscard]] virtual QString text(const Configuration &configuration, int script) const = 0;
    [[nodiscard]] virtual std::vector<Line> listing(const Configuration &configuration, int script) const = 0;
    /// Bytes of code used, and how many there are.
    [[nodiscard]] virtual std::pair<int, int> used(const Configuration &configuration) const = 0;
    /// All texts as the block's bytes.
    [[nodiscard]] virtual CompiledScripts compile(const Configuration &configuration,
                                                  const QStringList &texts) const = 0;
    /// Words that this board understands, and names it knows.
    [[nodiscard]] virtual QStringList words(const Configuration &configuration) const = 0;
};
