// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/memoryimage.h"

#include "protocol/base/filefault.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView kHeading = "GIMBALDESK-EEPROM 1\n";
constexpr int kHeadRoom = 4096;  // heading and description
constexpr qsizetype kGap = 8;  // equal bytes within a difference
constexpr qsizetype kShownBytes = 16;

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

Result<MemoryImage> MemoryImage::load(const QString &path)
{
    const auto file = readWhole(path, FileKind::Other, kLargest + kHeadRoom);
    if (!file)
        return tl::unexpected(file.error());
    auto image = decode(*file);
    if (!image)
        return tl::unexpected(inFile(image.error(), path));
    return image;
}

bool MemoryImage::isAt(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(kHeading.size()) == kHeading;
}

int MemoryDifference::changed() const
{
    int count = 0;
    for (qsizetype i = 0; i < from.size(); ++i)
        count += from[i] != to[i];
    return count;
}

QString MemoryDifference::place() const
{
    const auto hex = [](qsizetype address) { return u"0x%1"_s.arg(address, 4, 16, QLatin1Char('0')); };
    return from.size() == 1 ? hex(at) : hex(at) + u'-' + hex(at + from.size() - 1);
}

QString MemoryDifference::text() const
{
    const auto hex = [](const QByteArray &bytes) {
        return QString::fromLatin1(bytes.left(kShownBytes).toHex(' '))
            + (bytes.size() > kShownBytes ? u" ..."_s : QString());
    };
    return hex(from) + u" -> "_s + hex(to);
}

std::vector<MemoryDifference> memoryDifferences(const QByteArray &from, const QByteArray &to)
{
    std::vector<MemoryDifference> found;
    const qsizetype size = std::min(from.size(), to.size());
    qsizetype end = 0;  // of the last one
    for (qsizetype at = 0; at < size; ++at) {
        if (from[at] == to[at])
            continue;
        if (found.empty() || at - end > kGap)
            found.push_back({at, {}, {}});
        MemoryDifference &last = found.back();
        end = at + 1;
        last.from = from.mid(last.at, end - last.at);
        last.to = to.mid(last.at, end - last.at);
    }
    return found;
}
