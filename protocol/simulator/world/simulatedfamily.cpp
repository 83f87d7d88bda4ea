// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/world/simulatedfamily.h"

using namespace Qt::StringLiterals;

Result<int> wholeNumber(const QString &name, const QString &text, int min, int max)
{
    bool ok = false;
    const int value = text.toInt(&ok);
    if (ok && value >= min && value <= max)
        return value;
    return failure(
        ErrorCode::InvalidArgument,
        u"%1 needs a whole number from %2 to %3, not '%4'"_s.arg(name).arg(min).arg(max).arg(text));
}
