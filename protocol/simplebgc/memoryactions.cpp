// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The board as a whole: its memory, the files of its flash and its calibrations (errata 3.21). Which address
// holds what no document tells, nor is there a list of the files.
#include "protocol/base/filefault.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/memoryplaces.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"

#include <QFile>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kMemoryStep = 192;  // bytes: the largest piece (errata 3.21)
constexpr int kMemoryUnit = 64;
constexpr std::size_t kMostRanges = 100;  // that are listed
constexpr int kFileNumbers = 16;  // of each kind that are asked for: no document names one above 14
constexpr int kReadings = 3;  // until two are the same
constexpr int kMissingFile = 2;
constexpr int kUnknownToIt = 6;  // of ERROR
constexpr int kNotSupportedByIt = 9;
constexpr int kCalibrationKinds[] = {3, 4, 10};  // of sensors, motors and drivers
constexpr std::array<const char *, 2> kCalibratedSensors{"main", "frame"};
/// Of CALIB_INFO: no part of a calibration.
constexpr QLatin1String kMeasuredNow[]
    = {QLatin1String("progress"), QLatin1String("acc.x"), QLatin1String("acc.y"),      QLatin1String("acc.z"),
       QLatin1String("gyro"),     QLatin1String("axis"),  QLatin1String("temperature")};
constexpr auto kClearTimeout = 10s;  // errata 3.21: about 5 s
constexpr auto kMemoryTimeout = 1500ms;

/// "script 2", as the command line names the kind.
QString fileName(const Choice &kind, int index)
{
    return u"%1 %2"_s.arg(QLatin1String(kind.name)).arg(index);
}

struct BoardFile
{
    int kind = 0;
    int index = 0;
    [[nodiscard]] bool isCalibration() const
    {
        return std::find(std::begin(kCalibrationKinds), std::end(kCalibrationKinds), kind)
            != std::end(kCalibrationKinds);
    }
};

std::optional<BoardFile> fileNamed(const QString &name)
{
    for (const Choice &kind : kFileTypes) {
        for (int index = 0; index < kFileNumbers; ++index) {
            if (name == fileName(kind, index))
                return BoardFile{kind.value, index};
        }
    }
    return {};
}

MemoryImage::Files filesIn(const MemoryImage &image, const std::function<bool(const BoardFile &)> &isWanted)
{
    MemoryImage::Files found;
    if (!image.files)
        return found;
    for (auto it = image.files->begin(); it != image.files->end(); ++it) {
        if (const auto file = fileNamed(it.key()); file && isWanted(*file))
            found.insert(it.key(), *it);
    }
    return found;
}

Error goesOnAgain(Error error, const QString &done)
{
    addDetail(error.detail, done);
    return error;
}

QString statusName(std::size_t sensor)
{
    return u"status "_s + QLatin1String(kCalibratedSensors[sensor]);
}

}  // namespace

MemoryImage Actions::blankImage() const
{
    const BoardIdentity &board = m_device.m_identity;
    return {board.serial, board.model, board.firmware, {}};
}

Result<int> Actions::memorySize() const
{
    const int size = m_device.m_identity.extra.value(u"eeprom_size"_s).toInt();
    if (size <= 0 || size > MemoryImage::kLargest || size % kMemoryUnit != 0)
        return failure(ErrorCode::Unsupported, u"the board does not tell the size of its memory"_s);
    return size;
}

Result<void> Actions::readMemory(QByteArray &image, int size)
{
    Progress progress;
    progress.step = u"read-memory"_s;
    progress.total = size;
    while (image.size() < size) {
        const auto address = quint32(image.size());
        const int part = std::min(kMemoryStep, size - int(image.size()));
        const auto frame = m_channel.transact(
            replyRequest(CommandId::EepromRead, ByteWriter().u32(address).u16(part).take(),
                         CommandId::EepromRead, 4 + part, Device::kVersion,
                         [address](Bytes payload) { return ByteReader(payload).u32() == address; }));
        if (!frame)
            return tl::unexpected(frame.error());
        if (frame->payload.size() != 4 + part)
            return failure(ErrorCode::BadReply, u"EEPROM_READ at %1"_s.arg(address));
        image += frame->payload.mid(4);
        progress.done = int(image.size());
        m_channel.progress(progress);
        if (m_channel.cancelled())
            return failure(ErrorCode::Cancelled);
    }
    return {};
}

Result<void> Actions::readFiles(MemoryImage::Files &files, const std::function<bool(int kind)> &isWanted)
{
    Progress progress;
    progress.step = u"read-files"_s;
    progress.total = int(std::size(kFileTypes)) * kFileNumbers;
    bool hasFiles = false;
    for (const Choice &kind : kFileTypes) {
        for (int index = 0; index < kFileNumbers && isWanted(kind.value); ++index) {
            ++progress.done;
            const QString name = fileName(kind, index);
            if (files.contains(name))
                continue;
            m_channel.progress(progress);
            if (m_channel.cancelled())
                return failure(ErrorCode::Cancelled);
            const auto content = readFile(kind.value, index);
            const int code
                = !content && content.error().code == ErrorCode::BoardError ? content.error().boardCode : 0;
            if (!hasFiles && files.isEmpty() && (code == kUnknownToIt || code == kNotSupportedByIt))
                return failure(ErrorCode::Unsupported, u"the board keeps no files"_s);
            if (!content && code != kMissingFile)
                return tl::unexpected(content.error());
            hasFiles = true;
            if (content && !content->isEmpty())
                files.insert(name, *content);
        }
    }
    return {};
}

Result<void> Actions::readBoard(MemoryImage &image, int size, bool withFiles)
{
    if (const auto read = readMemory(image.bytes, size); !read)
        return read;
    if (!withFiles)
        return {};
    MemoryImage::Files files = image.files.value_or(MemoryImage::Files());
    const auto read = readFiles(files, [](int) { return true; });
    if (!read && read.error().code == ErrorCode::Unsupported)
        return {};
    image.files = files;
    return read;
}

// It is read until two readings are the same. What was broken off is in a file beside it, goes on there, and
// is read once more like the rest.
Result<MemoryImage> Actions::copyBoard(const QString &path, bool withFiles)
{
    const auto size = memorySize();
    if (!size)
        return tl::unexpected(size.error());
    if (const auto target = checkTarget(path, FileKind::Other); !target)
        return tl::unexpected(target.error());
    const QString partPath = path + u".part"_s;
    MemoryImage image = blankImage();
    if (const auto part = MemoryImage::load(partPath); part && part->serial == image.serial
        && part->firmware == image.firmware && part->bytes.size() <= *size
        && withFiles >= part->files.has_value())
        image = *part;
    const auto keepPart = [&](const Error &error) -> Error {
        if (image.bytes.isEmpty() || !writeWhole(partPath, image.encode()))
            return error;
        return goesOnAgain(
            error, u"%1 bytes were read before; the same again goes on from there"_s.arg(image.bytes.size()));
    };
    if (const auto read = readBoard(image, *size, withFiles); !read)
        return tl::unexpected(keepPart(read.error()));
    for (int readings = 1; readings < kReadings; ++readings) {
        MemoryImage again = blankImage();
        if (const auto read = readBoard(again, *size, withFiles); !read)
            return tl::unexpected(keepPart(read.error()));
        if (again == image) {
            if (const auto written = writeWhole(path, image.encode()); !written)
                return tl::unexpected(written.error());
            QFile::remove(partPath);
            return image;
        }
        image = again;
    }
    return failure(ErrorCode::BadReply, u"each time it is read, the memory holds something else"_s);
}

Result<ActionReply> Actions::saveMemory(const QVariantMap &arguments)
{
    const auto image = copyBoard(arguments.value(u"file"_s).toString(), arguments.value(u"files"_s).toBool());
    if (!image)
        return tl::unexpected(image.error());
    ActionReply reply{{u"bytes"_s, int(image->bytes.size())}};
    if (image->files)
        reply.insert(u"files"_s, int(image->files->size()));
    return reply;
}

// Its calibrations and its licence are in a memory, and nobody knows where.
Result<void> Actions::checkFits(const MemoryImage &image, bool isForeignMeant) const
{
    const BoardIdentity &board = m_device.m_identity;
    if (!isForeignMeant && image.serial != board.serial)
        return failure(ErrorCode::ConditionUnmet,
                       u"this is the memory of another board (%1, firmware %2), with its calibrations and "
                       "its licence; part=settings takes its settings alone, other=on all of it"_s.arg(
                           image.serial, image.firmware));
    if (!isForeignMeant && !board.isNumbered())
        return failure(
            ErrorCode::ConditionUnmet,
            u"this board has no number, so nobody can tell whether the calibrations and the licence "
            "in the copy are its own; part=settings takes the settings alone, other=on all of it"_s);
    if (image.firmware != board.firmware)
        return failure(ErrorCode::ConditionUnmet,
                       u"it was read from firmware %1, and nobody tells where %2 keeps what"_s.arg(
                           image.firmware, board.firmware));
    return {};
}

// Only what differs is written, so what was broken off goes on where it was.
Result<int> Actions::writeMemory(const QByteArray &now, const QByteArray &wanted)
{
    Progress progress;
    progress.step = u"write-memory"_s;
    progress.total = int(wanted.size());
    int written = 0;
    for (int at = 0; at < int(wanted.size()); at += kMemoryUnit) {
        const QByteArray part = wanted.mid(at, kMemoryUnit);
        progress.done = at;
        m_channel.progress(progress);
        if (part == now.mid(at, kMemoryUnit))
            continue;
        Request request = confirmRequest(CommandId::EepromWrite, ByteWriter().u32(quint32(at)).take() + part,
                                         Device::kVersion);
        request.idempotent = true;
        request.retries = 2;
        request.timeout = kMemoryTimeout;
        const auto done = m_channel.transact(request);
        if (!done)
            return tl::unexpected(goesOnAgain(
                done.error(),
                u"%1 bytes were written before; the same again goes on from there"_s.arg(written)));
        written += int(part.size());
    }
    QByteArray back;
    if (const auto read = readMemory(back, int(wanted.size())); !read)
        return tl::unexpected(read.error());
    if (back != wanted) {
        const auto wrong = std::mismatch(back.begin(), back.end(), wanted.begin()).first;
        return failure(
            ErrorCode::NoEffect,
            u"from address %1 on the board holds other bytes than were written"_s.arg(wrong - back.begin()));
    }
    return written;
}

Result<int> Actions::writeFiles(const MemoryImage::Files &now, const MemoryImage::Files &wanted,
                                const std::function<bool(int kind)> &isMeant)
{
    int changed = 0;
    const auto put = [&](const QString &name, const QByteArray &content) -> Result<void> {
        const BoardFile file = *fileNamed(name);
        const auto done = putFile(file.kind, file.index, content);
        if (!done)
            return tl::unexpected(goesOnAgain(
                done.error(),
                u"%1: %2 files were changed before; the same again goes on from there"_s.arg(name).arg(
                    changed)));
        ++changed;
        return {};
    };
    // They make room for the others.
    for (auto it = now.begin(); it != now.end(); ++it) {
        if (wanted.contains(it.key()))
            continue;
        if (const auto done = put(it.key(), {}); !done)
            return tl::unexpected(done.error());
    }
    for (auto it = wanted.begin(); it != wanted.end(); ++it) {
        if (now.value(it.key()) == *it)
            continue;
        if (const auto done = put(it.key(), *it); !done)
            return tl::unexpected(done.error());
    }
    MemoryImage::Files back;
    if (const auto read = readFiles(back, isMeant); !read)
        return tl::unexpected(read.error());
    if (const auto wrong = fileDifferences(wanted, back); !wrong.isEmpty())
        return failure(ErrorCode::NoEffect,
                       u"%1: the board holds another file (%2)"_s.arg(wrong.firstKey(), wrong.first()));
    return changed;
}

// Of two boards with the same firmware each keeps its settings where the other does.
Result<QByteArray> Actions::withSettings(const QByteArray &now, const MemoryImage &image, ActionReply &reply)
{
    const auto board = m_device.readConfiguration(m_channel);
    if (!board)
        return tl::unexpected(board.error());
    const auto places = findPlaces(now, *board);
    if (places.empty())
        return failure(ErrorCode::ConditionUnmet, u"none of the board's settings was found in its memory"_s);
    QByteArray wanted = now;
    for (const MemoryPlace &place : places) {
        // The number of the profile, which is the same, need not stand before its block.
        const bool isBlock = place.key.block != MemoryPlace::kNames && place.key.block != AdjVarsCfg;
        const qsizetype at = place.at + (isBlock ? 1 : 0);
        const qsizetype size = place.size - (isBlock ? 1 : 0);
        wanted.replace(at, size, image.bytes.mid(at, size));
    }
    reply.insert(u"found"_s, u"%1/%2"_s.arg(places.size()).arg(placesWanted(*board)));
    return wanted;
}

Result<ActionReply> Actions::restoreMemory(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto image = MemoryImage::load(path);
    if (!image)
        return tl::unexpected(image.error());
    const bool isWhole = arguments.value(u"part"_s).toInt() == kWholeMemory;
    if (const auto fits = checkFits(*image, !isWhole || arguments.value(u"other"_s).toBool()); !fits)
        return tl::unexpected(fits.error());
    const auto size = memorySize();
    if (!size)
        return tl::unexpected(size.error());
    if (image->bytes.size() != *size)
        return tl::unexpected(otherSize(path, *image, *size));
    QByteArray now;
    if (const auto read = readMemory(now, *size); !read)
        return tl::unexpected(read.error());
    ActionReply reply;
    const auto wanted = isWhole ? Result<QByteArray>(image->bytes) : withSettings(now, *image, reply);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto written = writeMemory(now, *wanted);
    if (!written)
        return tl::unexpected(written.error());
    reply.insert(u"written"_s, *written);
    reply.insert(u"restart_needed"_s, true);
    if (!image->files)
        return reply;
    const auto isMeant = [isWhole](int kind) { return isWhole || !BoardFile{kind, 0}.isCalibration(); };
    MemoryImage::Files there;
    if (const auto read = readFiles(there, isMeant); !read)
        return tl::unexpected(read.error());
    const auto files = writeFiles(
        there, filesIn(*image, [&](const BoardFile &file) { return isMeant(file.kind); }), isMeant);
    if (!files)
        return tl::unexpected(files.error());
    reply.insert(u"files_changed"_s, *files);
    return reply;
}

Error Actions::otherSize(const QString &path, const MemoryImage &image, int size)
{
    return {ErrorCode::ConditionUnmet,
            u"%1 holds %2 bytes, the board's memory has %3"_s.arg(path).arg(image.bytes.size()).arg(size)};
}

// Where parameters lie no document tells. But the board tells their blocks, and where one of them stands in
// its memory once, and once only, that is where it lies.
Result<ActionReply> Actions::compareMemory(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto image = MemoryImage::load(path);
    if (!image)
        return tl::unexpected(image.error());
    const int size = memorySize().value_or(0);
    if (image->bytes.size() != size)
        return tl::unexpected(otherSize(path, *image, size));
    MemoryImage now = blankImage();
    if (const auto read = readBoard(now, size, image->files.has_value()); !read)
        return tl::unexpected(read.error());
    ActionReply reply;
    QByteArray file = image->bytes;
    int differing = 0;
    for (const MemoryDifference &difference : memoryDifferences(file, now.bytes))
        differing += difference.changed();
    reply.insert(u"differing"_s, differing);
    if (image->serial != m_device.m_identity.serial)
        reply.insert(u"other_board"_s, image->serial);
    const bool isSameFirmware = image->firmware == m_device.m_identity.firmware;
    // Another firmware may keep everything in other places.
    if (!isSameFirmware)
        reply.insert(u"other_firmware"_s, image->firmware);
    if (differing > 0 && isSameFirmware) {
        const auto board = m_device.readConfiguration(m_channel);
        if (!board)
            return tl::unexpected(board.error());
        const auto places = findPlaces(now.bytes, *board);
        for (const auto &[name, change] : explainDifferences(file, now.bytes, places, *board))
            reply.insert(name, change);
        reply.insert(u"found"_s, u"%1/%2"_s.arg(places.size()).arg(placesWanted(*board)));
    }
    const auto rest = memoryDifferences(file, now.bytes);
    for (std::size_t i = 0; i < std::min(rest.size(), kMostRanges); ++i)
        reply.insert(rest[i].place(), rest[i].text());
    if (!rest.empty())
        reply.insert(u"unnamed"_s, qlonglong(rest.size()));
    if (!image->files)
        return reply;
    const auto files = fileDifferences(*image->files, now.files.value_or(MemoryImage::Files()));
    reply.insert(u"files_differing"_s, int(files.size()));
    for (auto it = files.begin(); it != files.end(); ++it)
        reply.insert(it.key(), *it);
    return reply;
}

// Whatever is lost by it is in the copy that was made before, as far as files can be found.
Result<ActionReply> Actions::eraseAllFiles(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    if (QFile::exists(path))
        return failure(
            ErrorCode::InvalidArgument,
            u"%1 is there already: the copy that is made before needs a file of its own"_s.arg(path));
    const auto image = copyBoard(path, true);
    if (!image)
        return tl::unexpected(image.error());
    if (!image->files)
        return failure(ErrorCode::Unsupported, u"the board keeps no files"_s);
    Request request = confirmRequest(CommandId::FsClearAll, {}, Device::kVersion);
    request.timeout = kClearTimeout;
    const auto done = m_channel.transact(request);
    if (done && done->payload.size() > 1 && done->payload[1] != 0)
        return tl::unexpected(fileRefusal(quint8(done->payload[1])));
    // Where the confirmation was lost, the board is looked at all the same.
    if (!done && done.error().code != ErrorCode::Timeout)
        return tl::unexpected(done.error());
    MemoryImage::Files left;
    if (const auto read = readFiles(left, [](int) { return true; }); !read)
        return tl::unexpected(read.error());
    if (!left.isEmpty())
        return failure(ErrorCode::NoEffect, u"the board still has the file"_s);
    return ActionReply{{u"files_changed"_s, int(image->files->size())}};
}

// --- calibrations ---

// Files alone can be read and written; what the sensors keep themselves the board only tells about.
Result<MemoryImage> Actions::readCalibrations()
{
    MemoryImage image = blankImage();
    MemoryImage::Files files;
    const auto read = readFiles(files, [](int kind) { return BoardFile{kind, 0}.isCalibration(); });
    if (!read && read.error().code != ErrorCode::Unsupported)
        return tl::unexpected(read.error());
    if (m_device.m_identity.firmwareNumber >= kLater) {
        for (std::size_t sensor = 0; sensor < kCalibratedSensors.size(); ++sensor) {
            const auto info = m_channel.transact(
                replyRequest(CommandId::CalibInfo, ByteWriter().u8(int(sensor) + 1).zeros(11).take(),
                             CommandId::CalibInfo, 33, Device::kVersion));
            if (info)
                files.insert(statusName(sensor), info->payload);
            else if (info.error().code != ErrorCode::BoardError && info.error().code != ErrorCode::Timeout)
                return tl::unexpected(info.error());
        }
    }
    if (files.isEmpty())
        return failure(ErrorCode::Unsupported, u"the board tells nothing of its calibrations"_s);
    image.files = files;
    return image;
}

Result<ActionReply> Actions::saveCalibrations(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    if (const auto target = checkTarget(path, FileKind::Calibration); !target)
        return tl::unexpected(target.error());
    const auto image = readCalibrations();
    if (!image)
        return tl::unexpected(image.error());
    if (const auto written = writeWhole(path, image->encode(), FileKind::Calibration); !written)
        return tl::unexpected(written.error());
    return ActionReply{{u"files"_s, int(filesIn(*image, [](const BoardFile &file) {
                                            return file.isCalibration();
                                        }).size())}};
}

Result<ActionReply> Actions::compareCalibrations(const QVariantMap &arguments)
{
    const auto before = MemoryImage::load(arguments.value(u"file"_s).toString());
    if (!before)
        return tl::unexpected(before.error());
    const auto now = readCalibrations();
    if (!now)
        return tl::unexpected(now.error());
    ActionReply reply;
    if (before->serial != now->serial)
        reply.insert(u"other_board"_s, before->serial);
    const auto calibrationsIn = [](const MemoryImage &image) {
        return filesIn(image, [](const BoardFile &file) { return file.isCalibration(); });
    };
    const auto changes = fileDifferences(calibrationsIn(*before), calibrationsIn(*now));
    reply.insert(u"files_differing"_s, int(changes.size()));
    for (auto it = changes.begin(); it != changes.end(); ++it)
        reply.insert(it.key(), *it);
    for (std::size_t sensor = 0; sensor < kCalibratedSensors.size(); ++sensor) {
        const auto valuesIn = [name = statusName(sensor)](const MemoryImage &image) {
            const QByteArray payload = image.files.value_or(MemoryImage::Files()).value(name);
            return payload.isEmpty()
                ? std::vector<FieldValue>()
                : decodeFields(*findMessage(number(CommandId::CalibInfo))->fromBoard, asBytes(payload));
        };
        const auto was = valuesIn(*before);
        const auto is = valuesIn(*now);
        for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
            const QString name = u"%1.%2"_s.arg(QLatin1String(kCalibratedSensors[sensor]), is[i].name);
            const bool isMeasuredNow = std::find(std::begin(kMeasuredNow), std::end(kMeasuredNow), is[i].name)
                != std::end(kMeasuredNow);
            if (!isMeasuredNow && was[i].name == is[i].name && was[i].text() != is[i].text())
                reply.insert(name, was[i].text() + u" -> "_s + is[i].text());
        }
    }
    return reply;
}

Result<ActionReply> Actions::restoreCalibrations(const QVariantMap &arguments)
{
    const auto image = MemoryImage::load(arguments.value(u"file"_s).toString());
    if (!image)
        return tl::unexpected(image.error());
    if (const auto fits = checkFits(*image, arguments.value(u"other"_s).toBool()); !fits)
        return tl::unexpected(fits.error());
    const auto isMeant = [](int kind) { return BoardFile{kind, 0}.isCalibration(); };
    MemoryImage::Files there;
    if (const auto read = readFiles(there, isMeant); !read)
        return tl::unexpected(read.error());
    const auto wanted = filesIn(*image, [](const BoardFile &file) { return file.isCalibration(); });
    if (wanted.isEmpty())
        return failure(ErrorCode::ConditionUnmet, u"there is no calibration in this file"_s);
    // What the copy does not have stays.
    MemoryImage::Files all = there;
    all.insert(wanted);
    const auto changed = writeFiles(there, all, isMeant);
    if (!changed)
        return tl::unexpected(changed.error());
    return ActionReply{{u"files_changed"_s, *changed}, {u"restart_needed"_s, true}};
}

}  // namespace simplebgc
