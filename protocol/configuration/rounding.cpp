// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/rounding.h"

#include <QLocale>

#include <cmath>

using namespace Qt::StringLiterals;

QString roundingText(const ParameterSpec &spec, double wanted, double raw)
{
    const QString held = spec.format(raw);
    if (spec.row->kind != ValueKind::Number || std::isnan(wanted) || held.toDouble() == wanted)
        return {};
    return u"%1: %2 is the nearest to %3 that the board can hold"_s.arg(
        spec.key, held, QString::number(wanted, 'g', QLocale::FloatingPointShortest));
}
