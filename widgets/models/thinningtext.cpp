// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/thinningtext.h"

#include "protocol/telemetry/streams.h"
#include "widgets/models/numbertext.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace {

QString rateText(double rate)
{
    return numberText(rate, rate < 10 ? 1 : 0);
}

QString words(const char *text)
{
    return QCoreApplication::translate("ThinningText", text);
}

}  // namespace

QString thinningText(double rate, double fullRate, const StreamBudget &budget)
{
    if (fullRate > 0) {
        return words(
                   QT_TRANSLATE_NOOP("ThinningText",
                                     "The line is slow: live data are thinned out to %1 samples/s of the %2 "
                                     "that a faster one would carry."))
            .arg(rateText(rate), rateText(fullRate));
    }
    for (const StreamUse &use : budget.streams) {
        if (use.fullRate > 0) {
            return words(QT_TRANSLATE_NOOP("ThinningText",
                                           "The line is slow: %1 comes %2 times a second instead of %3."))
                .arg(use.label, rateText(use.rate), rateText(use.fullRate));
        }
    }
    return {};
}
