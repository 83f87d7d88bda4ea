// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/leaptext.h"

#include "protocol/configuration/leap.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QCoreApplication>

namespace {

struct LeapText
{
    Q_DECLARE_TR_FUNCTIONS(LeapText)
};

constexpr double kManyTimes = 10;  // from there on a decimal says nothing

}  // namespace

QString leapText(const ParameterChange &change)
{
    const QString name = parameterLabel(*change.spec);
    const QString to = parameterQuantityText(*change.spec, change.to);
    if (const auto times = timesAsMuch(change.from, change.to))
        return LeapText::tr("%1: %2 is %3 times what the board has, %4")
            .arg(name, to, numberText(*times, *times < kManyTimes ? 1 : 0),
                 parameterQuantityText(*change.spec, change.from));
    return LeapText::tr("%1: %2, where the board has 0").arg(name, to);
}
