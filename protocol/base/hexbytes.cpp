// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/hexbytes.h"

#include <QRegularExpression>

using namespace Qt::StringLiterals;

std::optional<QByteArray> bytesFromHex(QString digits)
{
    static const QRegularExpression blank(u"\\s"_s);
    static const QRegularExpression valid(u"^([0-9A-Fa-f]{2})*$"_s);
    digits.remove(blank);
    if (!valid.match(digits).hasMatch())
        return {};
    return QByteArray::fromHex(digits.toLatin1());
}
