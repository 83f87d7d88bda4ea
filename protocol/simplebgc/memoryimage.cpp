// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/memoryimage.h"

#include "protocol/base/filefault.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr QByteArrayView kHeading = "GIMBALDESK-EEPROM 1\n";

QString sumOf(const QByteArray &bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha1).toHex());
}

}  // namespace

QByteArray MemoryImage::encode() const
{
    const QJsonObject about{{u"serial"_s, serial},
                            {u"model"_s, model},
                            {u"firmware"_s, firmware},
                            {u"bytes"_s, int(bytes.size())},
                            {u"sha1"_s, sumOf(bytes)}};
    return kHeading.toByteArray() + QJsonDocument(about).toJson(QJsonDocument::Compact) + '\n' + bytes;
}

Result<MemoryImage> MemoryImage::decode(const QByteArray &file)
{
    const qsizetype end = file.indexOf('\n', kHeading.size());
    if (!file.startsWith(kHeading) || end < 0)
        return fileFailure({.problem = FileProblem::OtherKind, .kind = FileKind::Other});
    const QJsonObject about
        = QJsonDocument::fromJson(file.mid(kHeading.size(), end - kHeading.size())).object();
    MemoryImage image{about.value(u"serial"_s).toString(), about.value(u"model"_s).toString(),
                      about.value(u"firmware"_s).toString(), file.mid(end + 1)};
    if (image.bytes.size() < about.value(u"bytes"_s).toInt())
        return fileFailure({.problem = FileProblem::Truncated, .kind = FileKind::Other});
    if (about.isEmpty() || image.bytes.isEmpty() || sumOf(image.bytes) != about.value(u"sha1"_s).toString())
        return fileFailure({.problem = FileProblem::Damaged, .kind = FileKind::Other});
    return image;
}

}  // namespace simplebgc
