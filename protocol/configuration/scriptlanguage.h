// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"
#include "protocol/configuration/scriptmistake.h"

using CompiledScripts = tl::expected<QByteArray, ScriptMistake>;

/// The programs that boards of a family store in a data block: text for the operator, code for the board.
/// Scripts are compiled, never run here.
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
    /// The block that holds the scripts (BlockSpec::id).
    [[nodiscard]] virtual int block() const = 0;
    [[nodiscard]] virtual int count() const = 0;
    /// Key of the parameter that selects what runs a script; empty: none.
    [[nodiscard]] virtual QString inputKey(int script) const = 0;
    /// Suffix of script files, "scr".
    [[nodiscard]] virtual QString suffix() const = 0;
    /// Text of one script, from 0; empty when there is none.
    [[nodiscard]] virtual QString text(const Configuration &configuration, int script) const = 0;
    [[nodiscard]] virtual std::vector<Line> listing(const Configuration &configuration, int script) const = 0;
    /// Bytes of code used, and bytes available.
    [[nodiscard]] virtual std::pair<int, int> used(const Configuration &configuration) const = 0;
    /// Compiles all texts into the block's bytes.
    [[nodiscard]] virtual CompiledScripts compile(const Configuration &configuration,
                                                  const QStringList &texts) const = 0;
    /// Keywords that this board understands, and names it knows.
    [[nodiscard]] virtual QStringList words(const Configuration &configuration) const = 0;
};
