// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/memoryimage.h"

#include "protocol/base/filefault.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView kHeading = "GIMBALDESK-EEPROM ";
constexpr QByteArrayView kAlone = "1\n";
constexpr QByteArrayView kWithFiles = "2\n";
constexpr qsizetype kHeadingSize = kHeading.size() + kAlone.size();
constexpr int kRoomForFiles = 8 * 1024 * 1024;  // and the description
constexpr qsizetype kGap = 8;  // equal bytes within a difference
constexpr qsizetype kShownBytes = 16;

QString sumOf(const QByteArray &bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha1).toHex());
}

}  // namespace

QByteArray MemoryImage::encode() const
{
    QByteArray all = bytes;
    QJsonArray list;
    const Files none;
    const Files &kept = files ? *files : none;
    for (auto it = kept.begin(); it != kept.end(); ++it) {
        list.append(QJsonObject{{u"name"_s, it.key()}, {u"bytes"_s, int(it->size())}});
        all += *it;
    }
    QJsonObject about{{u"serial"_s, serial},
                      {u"model"_s, model},
                      {u"firmware"_s, firmware},
                      {u"bytes"_s, int(bytes.size())},
                      {u"sha1"_s, sumOf(all)}};
    if (files)
        about.insert(u"files"_s, list);
    return kHeading.toByteArray() + (files ? kWithFiles : kAlone).toByteArray()
        + QJsonDocument(about).toJson(QJsonDocument::Compact) + '\n' + all;
}

Result<MemoryImage> MemoryImage::decode(const QByteArray &file)
{
    const qsizetype end = file.indexOf('\n', kHeadingSize);
    const QByteArray version = file.mid(kHeading.size(), kAlone.size());
    const bool hasFiles = version == kWithFiles;
    if (!file.startsWith(kHeading) || end < 0 || !(hasFiles || version == kAlone))
        return fileFailure({.problem = FileProblem::OtherKind, .kind = FileKind::Other});
    const QJsonObject about = QJsonDocument::fromJson(file.mid(kHeadingSize, end - kHeadingSize)).object();
    const QByteArray all = file.mid(end + 1);
    const auto sizeIn = [](const QJsonObject &object) {
        return qsizetype(std::clamp(object.value(u"bytes"_s).toInt(), 0, kLargest + kRoomForFiles));
    };
    qsizetype at = sizeIn(about);
    MemoryImage image{about.value(u"serial"_s).toString(), about.value(u"model"_s).toString(),
                      about.value(u"firmware"_s).toString(), all.left(at)};
    if (hasFiles)
        image.files.emplace();
    for (const QJsonValue &each : about.value(u"files"_s).toArray()) {
        const qsizetype size = sizeIn(each.toObject());
        if (image.files)
            image.files->insert(each.toObject().value(u"name"_s).toString(), all.mid(at, size));
        at += size;
    }
    if (all.size() < at)
        return fileFailure({.problem = FileProblem::Truncated, .kind = FileKind::Other});
    if (about.isEmpty() || all.isEmpty() || all.size() > at
        || sumOf(all) != about.value(u"sha1"_s).toString())
        return fileFailure({.problem = FileProblem::Damaged, .kind = FileKind::Other});
    return image;
}

Result<MemoryImage> MemoryImage::load(const QString &path)
{
    const auto file = readWhole(path, FileKind::Other, kLargest + kRoomForFiles);
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

QMap<QString, QString> fileDifferences(const MemoryImage::Files &from, const MemoryImage::Files &to)
{
    const auto size = [](const MemoryImage::Files &files, const QString &name) {
        return files.contains(name) ? u"%1 bytes"_s.arg(files[name].size()) : u"none"_s;
    };
    MemoryImage::Files all = from;
    all.insert(to);
    QMap<QString, QString> changes;
    for (auto it = all.begin(); it != all.end(); ++it) {
        const bool isInBoth = from.contains(it.key()) && to.contains(it.key());
        if (!isInBoth || from[it.key()] != to[it.key()])
            changes.insert(it.key(), size(from, it.key()) + u" -> "_s + size(to, it.key()));
    }
    return changes;
}
