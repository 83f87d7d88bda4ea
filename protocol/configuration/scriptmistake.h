// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QStringList>

/// An error in the text of a script.
struct ScriptMistake
{
    int script = 0;  ///< from 0
    int line = 0;  ///< from 1; 0 if it concerns the whole script
    const char *what = "";  ///< a text of the tables, with placeholders for the values
    QStringList values;

    /// The sentence with its values filled in. @param pattern `what`, possibly translated
    [[nodiscard]] QString sentence(const QString &pattern) const;
    /// "script 2, line 3: 'FLY' is not a statement", as an error.
    [[nodiscard]] Error error() const;
};
