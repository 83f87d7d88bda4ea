// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/boardtext.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace {

struct BoardText
{
    Q_DECLARE_TR_FUNCTIONS(BoardText)
};

}  // namespace

QString boardText(const BoardIdentity &identity)
{
    const QString name = identity.extra.value(u"name"_s).toString();
    if (!name.isEmpty())
        return BoardText::tr("%1, “%2”").arg(identity.model, name);
    return identity.isNumbered() ? BoardText::tr("%1, number %2").arg(identity.model, identity.serial)
                                 : identity.model;
}
