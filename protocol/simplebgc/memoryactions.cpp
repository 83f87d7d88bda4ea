// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The board's memory as a whole (errata 3.21). Which address holds what no document tells.
#include "protocol/base/filefault.h"
#include "protocol/configuration/memoryimage.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/memoryplaces.h"
#include "protocol/simplebgc/parametertables.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kMemoryStep = 192;  // bytes: the largest piece (errata 3.21)
constexpr int kMemoryUnit = 64;
constexpr std::size_t kMostRanges = 100;  // that are listed

}  // namespace

Result<QByteArray> Actions::readMemory(int size)
{
    Progress progress;
    progress.step = u"read-memory"_s;
    progress.total = size;
    QByteArray image;
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
    return image;
}

Result<ActionReply> Actions::saveMemory(const QVariantMap &arguments)
{
    const int size = m_device.m_identity.extra.value(u"eeprom_size"_s).toInt();
    if (size <= 0 || size > MemoryImage::kLargest || size % kMemoryUnit != 0)
        return failure(ErrorCode::Unsupported, u"the board does not tell the size of its memory"_s);
    const QString path = arguments.value(u"file"_s).toString();
    if (const auto target = checkTarget(path, FileKind::Other); !target)
        return tl::unexpected(target.error());
    const auto image = readMemory(size);
    if (!image)
        return tl::unexpected(image.error());
    const MemoryImage file{m_device.m_identity.serial, m_device.m_identity.model,
                           m_device.m_identity.firmware, *image};
    if (const auto written = writeWhole(path, file.encode()); !written)
        return tl::unexpected(written.error());
    return ActionReply{{u"bytes"_s, size}};
}

// Only what differs is written, so what was broken off goes on where it was.
Result<ActionReply> Actions::restoreMemory(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto image = MemoryImage::load(path);
    if (!image)
        return tl::unexpected(image.error());
    // Its calibrations and its licence are in it.
    if (image->serial != m_device.m_identity.serial && !arguments.value(u"other"_s).toBool())
        return failure(ErrorCode::ConditionUnmet,
                       u"this is the memory of another board (%1, firmware %2), with its calibrations and "
                       "its licence; other=on writes it all the same"_s.arg(image->serial, image->firmware));
    if (image->firmware != m_device.m_identity.firmware)
        return failure(ErrorCode::ConditionUnmet,
                       u"it was read from firmware %1, and nobody tells where %2 keeps what"_s.arg(
                           image->firmware, m_device.m_identity.firmware));
    const auto now = readMemory(int(image->bytes.size()));
    if (!now)
        return tl::unexpected(now.error());
    Progress progress;
    progress.step = u"write-memory"_s;
    progress.total = int(image->bytes.size());
    int written = 0;
    for (int at = 0; at < int(image->bytes.size()); at += kMemoryUnit) {
        const QByteArray part = image->bytes.mid(at, kMemoryUnit);
        progress.done = at;
        m_channel.progress(progress);
        if (part == now->mid(at, kMemoryUnit))
            continue;
        Request request = confirmRequest(CommandId::EepromWrite, ByteWriter().u32(quint32(at)).take() + part,
                                         Device::kVersion);
        request.idempotent = true;
        request.retries = 2;
        request.timeout = 1500ms;
        const auto done = m_channel.transact(request);
        if (!done) {
            Error error = done.error();
            addDetail(error.detail,
                      u"%1 bytes were written before; the same again goes on from there"_s.arg(written));
            return tl::unexpected(error);
        }
        written += int(part.size());
    }
    const auto back = readMemory(int(image->bytes.size()));
    if (!back)
        return tl::unexpected(back.error());
    if (*back != image->bytes) {
        const auto wrong = std::mismatch(back->begin(), back->end(), image->bytes.begin()).first;
        return failure(
            ErrorCode::NoEffect,
            u"from address %1 on the board holds other bytes than were written"_s.arg(wrong - back->begin()));
    }
    return ActionReply{{u"written"_s, written}, {u"restart_needed"_s, true}};
}

// Where parameters lie no document tells. But the board tells their blocks, and where one of them stands in
// its memory once, and once only, that is where it lies.
Result<ActionReply> Actions::compareMemory(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto image = MemoryImage::load(path);
    if (!image)
        return tl::unexpected(image.error());
    const int size = m_device.m_identity.extra.value(u"eeprom_size"_s).toInt();
    if (image->bytes.size() != size)
        return failure(
            ErrorCode::ConditionUnmet,
            u"%1 holds %2 bytes, the board's memory has %3"_s.arg(path).arg(image->bytes.size()).arg(size));
    const auto now = readMemory(size);
    if (!now)
        return tl::unexpected(now.error());
    ActionReply reply;
    QByteArray file = image->bytes;
    int differing = 0;
    for (const MemoryDifference &difference : memoryDifferences(file, *now))
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
        const auto places = findPlaces(*now, *board);
        for (const auto &[name, change] : explainDifferences(file, *now, places, *board))
            reply.insert(name, change);
        reply.insert(u"found"_s, u"%1/%2"_s.arg(places.size()).arg(placesWanted(*board)));
    }
    const auto rest = memoryDifferences(file, *now);
    for (std::size_t i = 0; i < std::min(rest.size(), kMostRanges); ++i)
        reply.insert(rest[i].place(), rest[i].text());
    if (!rest.empty())
        reply.insert(u"unnamed"_s, qlonglong(rest.size()));
    return reply;
}

}  // namespace simplebgc
