// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions for experts: the buses behind the board, its boot loader, and what other sensors tell it (errata
// 3.20 to 3.22).
#include "protocol/base/filefault.h"
#include "protocol/base/hexbytes.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kInternalBus = 1;
constexpr int kFirstDevice = 0x08;  // below and above are reserved addresses of I2C
constexpr int kLastDevice = 0x77;
constexpr int kFirstMemory = 0x50;
constexpr int kLastMemory = 0x57;
constexpr auto kNobodyThere = 120ms;
constexpr int kBootNotice = 500;  // ms
constexpr auto kBootSettles = 500ms;
constexpr int kBootQuestions = 3;
constexpr qint64 kLargestFeed = 16 * 1024 * 1024;
constexpr int kWideModeSince = 2695;  // AHRS_HELPER has two bytes of mode (errata 3.22)
constexpr auto kLate = 200ms;  // what is older corrects nothing any more

QString deviceText(int device)
{
    return u"0x%1"_s.arg(device, 2, 16, QLatin1Char('0'));
}

/// A row of a file that is fed to the board.
struct FedRow
{
    double time = 0;  // seconds
    QByteArray payload;
};

FileFault feedFault(FileProblem problem, int line, const QString &key, const QString &value,
                    const QString &expected)
{
    return {.problem = problem,
            .kind = FileKind::Measurement,
            .line = line,
            .key = key,
            .value = value,
            .expected = expected};
}

// "time" in seconds, which grows, and fields of the message. All of it is read before anything is sent.
Result<std::vector<FedRow>> readFeed(const QByteArray &text, const MessageSpec &message)
{
    std::vector<FedRow> rows;
    QStringList names;
    int number = 0;
    for (const QByteArray &line : text.split('\n')) {
        ++number;
        const QString written = QString::fromUtf8(line).trimmed();
        if (written.isEmpty() || written.startsWith(u'#'))
            continue;
        QStringList words = written.split(u',');
        for (QString &word : words)
            word = word.trimmed();
        if (names.isEmpty()) {
            if (words.front() != u"time"_s)
                return fileFailure(
                    feedFault(FileProblem::BadValue, number, u"1"_s, words.front(), u"time"_s));
            names = words.mid(1);
            const QStringList known = fieldNames(*message.toBoard);
            for (const QString &name : std::as_const(names)) {
                if (!known.contains(name))
                    return fileFailure(
                        feedFault(FileProblem::BadValue, number, u"1"_s, name, known.join(u", "_s)));
            }
            continue;
        }
        if (words.size() != names.size() + 1)
            return fileFailure(feedFault(FileProblem::BadValue, number, u"columns"_s,
                                         QString::number(words.size()), QString::number(names.size() + 1)));
        bool ok = false;
        const double time = words.front().toDouble(&ok);
        if (!ok || !std::isfinite(time) || (!rows.empty() && time < rows.back().time))
            return fileFailure(
                feedFault(FileProblem::BadValue, number, u"time"_s, words.front(), u"seconds that grow"_s));
        QStringList fields;
        for (qsizetype i = 0; i < names.size(); ++i)
            fields.append(names[i] + u'=' + words[i + 1]);
        auto payload = encodeFields(*message.toBoard, fields, message.least);
        if (!payload) {
            payload.error().detail.prepend(u"line %1: "_s.arg(number));
            return tl::unexpected(payload.error());
        }
        rows.push_back({time, std::move(*payload)});
    }
    if (rows.empty())
        return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Measurement});
    return rows;
}

}  // namespace

Result<QByteArray> Actions::i2cRead(int bus, int device, int reg, int length)
{
    Request request
        = replyRequest(CommandId::I2cReadRegBuf, ByteWriter().u8(device << 1 | bus).u8(reg).u8(length).take(),
                       CommandId::I2cReadRegBuf, length, Device::kVersion,
                       [length](Bytes payload) { return int(payload.size()) == length; });
    request.retries = 0;
    request.timeout = kNobodyThere;
    const auto frame = m_channel.transact(request);
    return frame ? Result<QByteArray>(frame->payload) : tl::unexpected(frame.error());
}

Result<ActionReply> Actions::i2cScan(const QVariantMap &arguments)
{
    const int bus = arguments.value(u"bus"_s).toInt();
    Progress progress;
    progress.step = u"search-bus"_s;
    progress.total = kLastDevice - kFirstDevice + 1;
    QStringList found;
    bool isHeard = false;  // anything, a refusal too
    for (int device = kFirstDevice; device <= kLastDevice; ++device) {
        // Its answer carries no address: a late one of the device before would be taken for this one's.
        bool answers = true;
        for (int time = 0; time < 2 && answers; ++time) {
            const auto bytes = i2cRead(bus, device, 0, 1);
            if (!bytes && bytes.error().code != ErrorCode::Timeout
                && bytes.error().code != ErrorCode::BoardError)
                return tl::unexpected(bytes.error());
            answers = bytes.has_value();
            isHeard |= bytes || bytes.error().code == ErrorCode::BoardError;
        }
        if (answers)
            found.append(deviceText(device));
        progress.done = device - kFirstDevice + 1;
        m_channel.progress(progress);
        if (m_channel.cancelled())
            return failure(ErrorCode::Cancelled);
    }
    if (!isHeard)
        return failure(ErrorCode::Timeout, u"I2C_READ_REG_BUF"_s);
    return ActionReply{{u"devices"_s, found.isEmpty() ? u"none"_s : found.join(u' ')}};
}

Result<ActionReply> Actions::i2cReadRegisters(const QVariantMap &arguments)
{
    const auto bytes = i2cRead(arguments.value(u"bus"_s).toInt(), arguments.value(u"device"_s).toInt(),
                               arguments.value(u"register"_s).toInt(), arguments.value(u"length"_s).toInt());
    if (!bytes)
        return tl::unexpected(bytes.error());
    return ActionReply{{u"data"_s, QString::fromLatin1(bytes->toHex(' '))}};
}

// What a register holds afterwards need not be what was written to it: it is told, not judged.
Result<ActionReply> Actions::i2cWriteRegisters(const QVariantMap &arguments)
{
    const int bus = arguments.value(u"bus"_s).toInt();
    const int device = arguments.value(u"device"_s).toInt();
    const int reg = arguments.value(u"register"_s).toInt();
    const auto bytes = bytesFromHex(arguments.value(u"data"_s).toString());
    if (!bytes || bytes->isEmpty() || bytes->size() > kMostI2c)
        return failure(ErrorCode::InvalidArgument, u"data needs 1 to %1 bytes in hex"_s.arg(kMostI2c));
    if (bus == kInternalBus && device >= kFirstMemory && device <= kLastMemory)
        return failure(ErrorCode::ConditionUnmet,
                       u"this is the memory with the board's calibrations and its licence; memory.restore "
                       "writes it with a copy, and compares"_s);
    const auto before = i2cRead(bus, device, reg, int(bytes->size()));
    if (!before)
        return tl::unexpected(before.error());
    if (const auto done
        = confirm(CommandId::I2cWriteRegBuf, ByteWriter().u8(device << 1 | bus).u8(reg).bytes(*bytes).take());
        !done)
        return done;
    const auto after = i2cRead(bus, device, reg, int(bytes->size()));
    if (!after)
        return tl::unexpected(after.error());
    return ActionReply{{u"before"_s, QString::fromLatin1(before->toHex(' '))},
                       {u"now"_s, QString::fromLatin1(after->toHex(' '))}};
}

// That it has gone shows only in its silence: nobody there speaks this protocol (errata 3.20).
Result<ActionReply> Actions::enterBootLoader(const QVariantMap &)
{
    Request request = replyRequest(CommandId::BootMode3, ByteWriter().u8(1).u16(kBootNotice).take(),
                                   CommandId::Reset, 0, Device::kVersion);
    request.idempotent = false;
    request.retries = 0;
    const auto notice = m_channel.transact(request);
    if (!notice)
        return tl::unexpected(notice.error());
    const ActionReply gone{{u"silent"_s, true}};
    const auto isClosed = [](const Error &error) { return error.code == ErrorCode::LinkClosed; };
    if (const auto slept = m_channel.sleep(milliseconds(kBootNotice) + kBootSettles); !slept)
        return isClosed(slept.error()) ? Result<ActionReply>(gone) : tl::unexpected(slept.error());
    for (int question = 0; question < kBootQuestions; ++question) {
        Request who = replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, Device::kVersion);
        who.retries = 0;
        const auto answer = m_channel.transact(who);
        if (answer)
            return failure(ErrorCode::NoEffect, u"the board goes on as before"_s);
        if (isClosed(answer.error()))
            return gone;
        if (answer.error().code != ErrorCode::Timeout)
            return tl::unexpected(answer.error());
    }
    return gone;
}

Result<ActionReply> Actions::readAttitude(const QVariantMap &arguments)
{
    constexpr int kFrameSensor = 2;  // bit 1 of the mode; bit 0 would set it
    const int mode = arguments.value(u"imu"_s).toInt() == 2 ? kFrameSensor : 0;
    ByteWriter question;
    question.u8(mode);
    if (m_device.m_identity.firmwareNumber >= kWideModeSince)
        question.u8(0);
    const auto frame = m_channel.transact(replyRequest(CommandId::AhrsHelper, question.zeros(24).take(),
                                                       CommandId::AhrsHelper, 24, Device::kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    ActionReply reply;
    for (const FieldValue &value :
         decodeFields(*findMessage(number(CommandId::AhrsHelper))->fromBoard, asBytes(frame->payload)))
        reply.insert(value.name, value.number);
    return reply.size() == 6 ? Result<ActionReply>(reply) : failure(ErrorCode::BadReply, u"AHRS_HELPER"_s);
}

// The board confirms none of it. What it says against it ends the feed.
Result<ActionReply> Actions::feed(const QVariantMap &arguments)
{
    const MessageSpec message
        = asOf(*findMessage(arguments.value(u"what"_s).toInt()), m_device.m_identity.firmwareNumber);
    const QString path = arguments.value(u"file"_s).toString();
    const auto text = readWhole(path, FileKind::Measurement, kLargestFeed);
    if (!text)
        return tl::unexpected(text.error());
    auto rows = readFeed(*text, message);
    if (!rows)
        return tl::unexpected(inFile(rows.error(), path));
    for (const FedRow &row : *rows) {
        if (message.id == number(CommandId::AhrsHelper) && !(row.payload[0] & 1))
            return failure(ErrorCode::InvalidArgument, u"mode asks for an attitude and sets none"_s);
    }
    const auto refusals = m_channel.listen(
        [id = message.id](const FrameView &frame) { return refusalOf(frame, id).has_value(); });
    Progress progress;
    progress.step = u"feed"_s;
    progress.subject = QLatin1String(message.name);
    progress.total = int(rows->size());
    const TimePoint begin = m_channel.now();
    int skipped = 0;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const FedRow &row = (*rows)[i];
        const TimePoint due = begin + durationFromSeconds(row.time - rows->front().time);
        if (const Duration left = due - m_channel.now(); left > Duration::zero()) {
            if (const auto slept = m_channel.sleep(std::chrono::ceil<milliseconds>(left)); !slept)
                return tl::unexpected(slept.error());
        }
        progress.done = int(i) + 1;
        m_channel.progress(progress);
        const bool isLast = i + 1 == rows->size();
        if (!isLast && m_channel.now() - due > kLate) {
            ++skipped;
            continue;
        }
        if (const auto sent
            = m_channel.transact(silentRequest(CommandId(message.id), row.payload, Device::kVersion));
            !sent)
            return tl::unexpected(sent.error());
        if (const auto refused = refusals->next(0ms)) {
            const FrameView view{refused->id, asBytes(refused->payload), refused->version, {}};
            return tl::unexpected(*refusalOf(view, message.id));
        }
    }
    ActionReply reply{{u"rows"_s, int(rows->size()) - skipped}};
    if (skipped > 0)
        reply.insert(u"late"_s, skipped);
    return reply;
}

}  // namespace simplebgc
