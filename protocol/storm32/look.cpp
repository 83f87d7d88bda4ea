// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/look.h"

#include <QString>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

QString textAt(QByteArrayView bytes, qsizetype offset)
{
    const QByteArray all = bytes.sliced(offset, 16).toByteArray();
    return QString::fromLatin1(all.constData(), qstrnlen(all.constData(), size_t(all.size()))).trimmed();
}

}  // namespace

void describeLook(BoardIdentity &identity, QByteArrayView version)
{
    const QString name = textAt(version, 16);
    const QString type = textAt(version, 32);
    identity.model = u"STorM32 %1"_s.arg(type);
    identity.serial = u"storm32-"_s + QString::fromLatin1((name + u' ' + type).toLatin1().toHex());
    identity.extra.insert(u"name"_s, name);
    identity.extra.insert(BoardIdentity::kUnnumbered, true);
    identity.extra.insert(u"name.action"_s, u"name"_s);
}

}  // namespace storm32
