// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/scriptmistake.h"

using namespace Qt::StringLiterals;

QString ScriptMistake::sentence(const QString &pattern) const
{
    switch (values.size()) {  // in one call: a value may itself look like a placeholder
    case 0: return pattern;
    case 1: return pattern.arg(values[0]);
    case 2: return pattern.arg(values[0], values[1]);
    case 3: return pattern.arg(values[0], values[1], values[2]);
    default: return pattern.arg(values[0], values[1], values[2], values[3]);
    }
}

Error ScriptMistake::error() const
{
    const QString text = sentence(QString::fromUtf8(what));
    const QString number = QString::number(script + 1);
    return {ErrorCode::InvalidArgument,
            line > 0 ? u"script %1, line %2: %3"_s.arg(number, QString::number(line), text)
                     : u"script %1: %2"_s.arg(number, text),
            0};
}
