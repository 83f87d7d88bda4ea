// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/streams.h"

using namespace Qt::StringLiterals;

Result<StreamChoice> parseStreamChoice(const QString &text)
{
    StreamChoice choice;
    choice.key = text.section(u'@', 0, 0).trimmed();
    bool ok = true;
    if (text.contains(u'@'))
        choice.rate = text.section(u'@', 1).toDouble(&ok);
    if (choice.key.isEmpty() || !ok || !(choice.rate >= 0 && choice.rate <= 1e5))
        return failure(ErrorCode::InvalidArgument,
                       u"'%1' is not a stream; one looks like realtime4@100"_s.arg(text));
    return choice;
}

Error StreamBudget::refusal() const
{
    return {ErrorCode::TooMuch,
            u"%1 bytes/s wanted, %2 of the line's %3 are there for streams"_s.arg(bytesPerSecond(), 0, 'f', 0)
                .arg(capacity * kShare, 0, 'f', 0)
                .arg(capacity, 0, 'f', 0),
            0};
}
