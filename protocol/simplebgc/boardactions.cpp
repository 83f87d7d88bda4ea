// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions on the rest of the board: motors and sensors as they are mounted, pins and signals, profile sets,
// and files (errata 3.19 to 3.23).
#include "protocol/base/filefault.h"
#include "protocol/base/hexbytes.h"
#include "protocol/session/carryout.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kChannelPeriod = 50ms;
constexpr auto kSwitched = 2s;
constexpr int kUsedImuOffset = 58;  // of REALTIME_DATA_3
constexpr int kUndefinedSignal = -10000;
constexpr int kFineUndefined = -32768;
constexpr double kFineFull = 16384;
constexpr int kFilePart = 192;
constexpr int kExternalSize = 128;

}  // namespace

Result<ActionReply> Actions::selectImu(const QVariantMap &arguments)
{
    const int wanted = arguments.value(u"imu"_s).toInt();
    const auto reply = confirm(CommandId::SelectImu3, ByteWriter().u8(wanted).take());
    if (!reply && reply.error().code != ErrorCode::Timeout)
        return reply;
    // A board without that sensor ignores it (document SELECT_IMU_3).
    const auto isUsed = holdsWithin(
        m_channel, m_device.statusRequest(), kSwitched, [wanted](const Frame &status) {
            return status.payload.size() > kUsedImuOffset && quint8(status.payload[kUsedImuOffset]) == wanted;
        });
    if (!isUsed)
        return tl::unexpected(isUsed.error());
    if (!*isUsed)
        return failure(ErrorCode::NoEffect,
                       wanted == 2 ? u"the board has no frame sensor that works"_s
                                   : u"the board goes on with its frame sensor"_s);
    return ActionReply{};
}

Result<ActionReply> Actions::setPin(const QVariantMap &arguments)
{
    return confirm(
        CommandId::TriggerPin,
        ByteWriter().u8(arguments.value(u"pin"_s).toInt()).u8(arguments.value(u"state"_s).toInt()).take());
}

Result<ActionReply> Actions::setServo(const QVariantMap &arguments)
{
    ByteWriter writer;
    for (int i = 1; i <= 4; ++i)
        writer.i16(arguments.value(u"servo%1"_s.arg(i)).toInt());
    const auto sent
        = m_channel.transact(silentRequest(CommandId::ServoOut, writer.zeros(8).take(), Device::kVersion));
    return sent ? Result<ActionReply>(ActionReply{}) : tl::unexpected(sent.error());
}

// Given again and again, as a stick is; at the end, however it comes, nobody gives it any more, which the
// board treats as a signal that is lost.
Result<ActionReply> Actions::setChannel(const QVariantMap &arguments)
{
    std::vector<double> signal(std::size_t(arguments.value(u"channel"_s).toInt()), std::nan(""));
    signal.back() = arguments.value(u"value"_s).toDouble();
    const ControlFrames frames = Device::channelFrames(signal, arguments.value(u"fine"_s).toBool());
    const TimePoint end = m_channel.now() + durationFromSeconds(arguments.value(u"seconds"_s).toDouble());
    Result<void> slept;
    while (slept && m_channel.now() < end) {
        m_channel.steer(frames);
        slept = m_channel.sleep(kChannelPeriod);
    }
    m_channel.releaseControl();
    return slept.map([] { return ActionReply(); });
}

Result<ActionReply> Actions::readStatistics(const QVariantMap &)
{
    const auto frame = m_channel.transact(
        replyRequest(CommandId::ReadStateVars, {}, CommandId::ReadStateVars, 192, Device::kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    ActionReply reply;
    for (const FieldValue &value :
         decodeFields(*findMessage(number(CommandId::ReadStateVars))->fromBoard, asBytes(frame->payload)))
        reply.insert(value.name, value.number);
    return reply;
}

Result<ActionReply> Actions::profileSet(const QVariantMap &arguments)
{
    const int slot = arguments.value(u"slot"_s).toInt();
    const int action = arguments.value(u"action"_s).toInt();
    constexpr int kSave = 1;
    constexpr int kClear = 2;
    const auto reply = confirm(CommandId::ProfileSet, ByteWriter().u8(slot).u8(action).zeros(8).take());
    if (!reply)
        return reply;
    // The board tells which slots are in use (errata 3.2).
    const auto info = m_channel.transact(
        replyRequest(CommandId::BoardInfo3, {}, CommandId::BoardInfo3, 69, Device::kVersion));
    if (!info)
        return tl::unexpected(info.error());
    ByteReader reader(info->payload);
    reader.skip(35);
    const unsigned used = reader.u8();
    const bool isUsed = used >> (slot - 1) & 1U;
    if (reader.ok() && ((action == kSave && !isUsed) || (action == kClear && isUsed)))
        return failure(ErrorCode::NoEffect,
                       u"the board tells that the slot is %1"_s.arg(isUsed ? u"still in use"_s : u"empty"_s));
    return ActionReply{};
}

Result<QByteArray> Actions::externalData()
{
    const auto frame = m_channel.transact(replyRequest(
        CommandId::ReadExternalData, {}, CommandId::ReadExternalData, kExternalSize, Device::kVersion));
    return frame ? Result<QByteArray>(frame->payload) : tl::unexpected(frame.error());
}

Result<ActionReply> Actions::readExternal(const QVariantMap &)
{
    const auto data = externalData();
    if (!data)
        return tl::unexpected(data.error());
    return ActionReply{{u"data"_s, QString::fromLatin1(data->toHex(' '))}};
}

Result<ActionReply> Actions::writeExternal(const QVariantMap &arguments)
{
    const auto bytes = bytesFromHex(arguments.value(u"data"_s).toString());
    if (!bytes || bytes->size() > kExternalSize)
        return failure(ErrorCode::InvalidArgument, u"data needs up to %1 bytes in hex"_s.arg(kExternalSize));
    const QByteArray wanted = bytes->leftJustified(kExternalSize, '\0');
    if (const auto done = confirm(CommandId::WriteExternalData, wanted); !done)
        return done;
    const auto back = externalData();
    if (!back)
        return tl::unexpected(back.error());
    return *back == wanted ? Result<ActionReply>(ActionReply{})
                           : failure(ErrorCode::NoEffect, u"the board holds other data"_s);
}

// --- files ---

Result<QByteArray> Actions::readFile(int type, int index)
{
    QByteArray content;
    Progress progress;
    progress.step = u"read-file"_s;
    for (int size = 1; content.size() < size;) {
        const int page = int(content.size()) / kFilePage;
        const auto frame = m_channel.transact(replyRequest(
            CommandId::ReadFile, ByteWriter().u8(type).u8(index).u16(page).u16(kFilePart).zeros(14).take(),
            CommandId::ReadFile, 4 + kFilePart, Device::kVersion, [page](Bytes payload) {
                ByteReader reader(payload);
                reader.skip(2);
                return payload.size() == 1 || reader.u16() == page;
            }));
        if (!frame)
            return tl::unexpected(frame.error());
        if (frame->payload.size() == 1)
            return tl::unexpected(fileRefusal(quint8(frame->payload[0])));
        ByteReader reader(frame->payload);
        size = reader.u16();
        reader.skip(2);
        const QByteArray part = toByteArray(reader.take(reader.remaining()));
        if (size == 0)
            break;
        if (part.isEmpty())
            return failure(ErrorCode::BadReply, u"READ_FILE at page %1"_s.arg(page));
        content += part;
        progress.total = size;
        progress.done = int(content.size());
        m_channel.progress(progress);
    }
    return content;
}

Error Actions::fileRefusal(int code)
{
    const auto word = std::find_if(std::begin(kFileCodes), std::end(kFileCodes),
                                   [code](const Choice &choice) { return choice.value == code; });
    return {ErrorCode::BoardError,
            word == std::end(kFileCodes) ? u"file error %1"_s.arg(code) : QString(QLatin1String(word->name)),
            code};
}

Result<void> Actions::putFile(int type, int index, const QByteArray &content)
{
    Progress progress;
    progress.step = u"write-file"_s;
    progress.total = int(content.size());
    int at = 0;
    do {
        const QByteArray part = content.mid(at, kFilePart);
        Request request = confirmRequest(
            CommandId::WriteFile,
            ByteWriter().u8(type).u8(index).u16(int(content.size())).u16(at / kFilePage).bytes(part).take(),
            Device::kVersion);
        request.timeout = 3000ms;
        const auto done = m_channel.transact(request);
        if (!done)
            return tl::unexpected(done.error());
        if (done->payload.size() > 1 && done->payload[1] != 0)
            return tl::unexpected(fileRefusal(quint8(done->payload[1])));
        at += int(part.size());
        progress.done = at;
        m_channel.progress(progress);
    } while (at < content.size());
    return {};
}

Result<ActionReply> Actions::saveFile(const QVariantMap &arguments)
{
    const auto content = readFile(arguments.value(u"type"_s).toInt(), arguments.value(u"number"_s).toInt());
    if (!content)
        return tl::unexpected(content.error());
    if (const auto written = writeWhole(arguments.value(u"file"_s).toString(), *content); !written)
        return tl::unexpected(written.error());
    return ActionReply{{u"bytes"_s, int(content->size())}};
}

Result<ActionReply> Actions::loadFile(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto content = readWhole(path, FileKind::Other, kLargestFile);
    if (!content)
        return tl::unexpected(content.error());
    if (content->isEmpty())
        return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Other, .path = path});
    const int type = arguments.value(u"type"_s).toInt();
    const int index = arguments.value(u"number"_s).toInt();
    if (const auto done = putFile(type, index, *content); !done)
        return tl::unexpected(done.error());
    const auto back = readFile(type, index);
    if (!back)
        return tl::unexpected(back.error());
    if (*back != *content)
        return failure(ErrorCode::NoEffect, u"the board holds another file"_s);
    return ActionReply{{u"bytes"_s, int(content->size())}};
}

Result<ActionReply> Actions::eraseFile(const QVariantMap &arguments)
{
    const int type = arguments.value(u"type"_s).toInt();
    const int index = arguments.value(u"number"_s).toInt();
    if (const auto done = putFile(type, index, {}); !done)
        return tl::unexpected(done.error());
    const auto back = readFile(type, index);
    if (back && !back->isEmpty())
        return failure(ErrorCode::NoEffect, u"the board still has the file"_s);
    // Only its own word that there is none proves it.
    if (!back && back.error().code != ErrorCode::BoardError)
        return tl::unexpected(back.error());
    return ActionReply{};
}

// One trigger slot and one analog slot are asked together (errata 3.15).
Result<ActionReply> Actions::readSlots(const QVariantMap &)
{
    const auto config = m_device.readBlock(m_channel, {0, AdjVarsCfg});
    if (!config)
        return tl::unexpected(config.error());
    const bool isBySource = m_device.m_identity.firmwareNumber >= kSlotStateBySource;
    const auto value = [&](const QString &key) {
        const ParameterSpec *spec = m_device.m_parameters->find(key);
        return spec ? int(spec->read(*config).value_or(0)) : 0;
    };
    ActionReply reply;
    QStringList silent;
    const auto tellSignal = [&](const QString &name, int raw) {
        if (raw == (isBySource ? kFineUndefined : kUndefinedSignal))
            silent.append(name);
        else
            reply.insert(name + u".signal"_s, isBySource ? 100.0 * raw / kFineFull : raw / 5.0);
    };
    for (int slot = 0; slot < kAnalogSlots; ++slot) {
        const QString trigger = u"trigger%1"_s.arg(slot + 1);
        const QString analog = u"analog%1"_s.arg(slot + 1);
        const bool hasTrigger = slot < kTriggerSlots && value(u"slot."_s + trigger + u".source"_s) != 0;
        const int source = value(u"slot."_s + analog + u".source"_s);
        if (!hasTrigger && source == 0)
            continue;
        ByteWriter question;
        question.u8(std::min(slot, kTriggerSlots - 1));
        if (isBySource)
            question.u16(source).u8(value(u"slot."_s + analog + u".variable"_s)).zeros(3);
        else
            question.u8(slot);
        const auto frame = m_channel.transact(replyRequest(CommandId::AdjVarsState, question.take(),
                                                           CommandId::AdjVarsState, 15, Device::kVersion));
        if (!frame)
            return tl::unexpected(frame.error());
        ByteReader reader(frame->payload);
        const int stick = reader.i16();
        const int action = reader.u8();
        const int signal = reader.i16();
        const double number = isBySource ? double(reader.f32()) : double(reader.i32());
        if (!reader.ok())
            return failure(ErrorCode::BadReply, u"ADJ_VARS_STATE"_s);
        if (hasTrigger) {
            const auto word = std::find_if(std::begin(kMenuActions), std::end(kMenuActions),
                                           [action](const Choice &each) { return each.value == action; });
            tellSignal(trigger, stick);
            reply.insert(trigger + u".action"_s,
                         word == std::end(kMenuActions) ? QString::number(action)
                                                        : QString::fromUtf8(word->name));
        }
        if (source != 0) {
            tellSignal(analog, signal);
            reply.insert(analog + u".value"_s, number);
        }
    }
    if (!silent.isEmpty())
        reply.insert(u"no_signal"_s, silent.join(u", "_s));
    return reply.isEmpty() ? failure(ErrorCode::ConditionUnmet, u"no slot has a signal"_s)
                           : Result<ActionReply>(reply);
}

}  // namespace simplebgc
