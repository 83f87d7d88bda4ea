// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts that the board stores compiled (errata 3.21). What is in one only the board knows: here they are
// files that are copied, run and stopped.
#include "protocol/base/filefault.h"
#include "protocol/base/linkloss.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"

#include <QFile>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

enum ScriptMode { StopIt, StartIt, DebugIt };

constexpr int kNoSuchFile = 2;
constexpr int kScriptEvent = 5;  // of EVENT (errata 3.20)
constexpr int kScriptOff = 1;
constexpr int kScriptOn = 2;
constexpr int kScriptEventsSince = 2657;
constexpr int kScriptEventInterval = 100;  // ms
constexpr auto kScriptEventWait = 1s;
constexpr auto kMessageWait = 200ms;
constexpr auto kOnItsWay = 200ms;  // a message that was sent before the script stopped
constexpr auto kStopWatch = 700ms;
// A script that waits says nothing, as one that has ended: only an event tells them apart.
constexpr auto kSilentWithoutEvents = 5s;
constexpr auto kSilentWithEvents = 60s;

int slotIn(const QVariantMap &arguments)
{
    return arguments.value(u"slot"_s).toInt() - 1;
}

QString unknownNow(int slot)
{
    return u"what slot %1 holds now is not known"_s.arg(slot + 1);
}

}  // namespace

// BOARD_INFO_3 tells five sizes before the later firmware, and what is in use may be newer than it.
int Actions::scriptSlots() const
{
    return m_device.m_identity.firmwareNumber >= kLater ? 10 : 5;
}

Result<void> Actions::checkSlot(int slot) const
{
    if (slot >= 0 && slot < scriptSlots())
        return {};
    return failure(ErrorCode::OutOfRange, u"this firmware has the slots 1 to %1"_s.arg(scriptSlots()));
}

Result<int> Actions::scriptSize(int slot)
{
    const auto frame = m_channel.transact(replyRequest(
        CommandId::ReadFile, ByteWriter().u8(kScriptFile).u8(slot).u16(0).u16(kFilePage).zeros(14).take(),
        CommandId::ReadFile, 4 + kFilePage, Device::kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    if (frame->payload.size() > 1)
        return int(ByteReader(frame->payload).u16());
    const int code = frame->payload.isEmpty() ? kNoSuchFile : quint8(frame->payload[0]);
    return code == kNoSuchFile ? Result<int>(0) : tl::unexpected(fileRefusal(code));
}

Result<QByteArray> Actions::scriptIn(int slot)
{
    auto content = readFile(kScriptFile, slot);
    if (!content && content.error().code == ErrorCode::BoardError && content.error().boardCode == kNoSuchFile)
        return QByteArray();
    return content;
}

// One that cannot be read hides no other.
Result<ActionReply> Actions::listScripts(const QVariantMap &)
{
    ActionReply reply;
    int broken = 0;
    for (int slot = 0; slot < scriptSlots(); ++slot) {
        const QString name = u"script%1"_s.arg(slot + 1);
        const auto size = scriptSize(slot);
        if (size)
            reply.insert(name + u".bytes"_s, *size);
        else if (size.error().code == ErrorCode::BoardError && ++broken < scriptSlots())
            reply.insert(name + u".error"_s, size.error().detail);
        else
            return tl::unexpected(size.error());
    }
    return reply;
}

Result<ActionReply> Actions::saveScript(const QVariantMap &arguments)
{
    const int slot = slotIn(arguments);
    if (const auto is = checkSlot(slot); !is)
        return tl::unexpected(is.error());
    const auto content = scriptIn(slot);
    if (!content)
        return tl::unexpected(content.error());
    if (content->isEmpty())
        return failure(ErrorCode::ConditionUnmet, u"slot %1 holds no script"_s.arg(slot + 1));
    const QString path = arguments.value(u"file"_s).toString();
    if (const auto written = writeWhole(path, *content, FileKind::Script); !written)
        return tl::unexpected(written.error());
    return ActionReply{{u"bytes"_s, int(content->size())}};
}

Result<ActionReply> Actions::loadScript(const QVariantMap &arguments)
{
    const QString path = arguments.value(u"file"_s).toString();
    const auto content = readWhole(path, FileKind::Script, kLargestFile);
    if (!content)
        return tl::unexpected(content.error());
    if (content->isEmpty())
        return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Script, .path = path});
    return replaceScript(slotIn(arguments), *content, arguments.value(u"keep"_s).toString());
}

Result<ActionReply> Actions::eraseScript(const QVariantMap &arguments)
{
    const int slot = slotIn(arguments);
    if (const auto size = checkSlot(slot) ? scriptSize(slot) : Result<int>(0); size && *size == 0)
        return failure(ErrorCode::ConditionUnmet, u"slot %1 holds no script"_s.arg(slot + 1));
    return replaceScript(slot, {}, arguments.value(u"keep"_s).toString());
}

// What was in the slot is in a file first. That is called ".part" until the slot is known to hold what was
// wanted or what it held before: what is left of one tells of a write that nobody saw the end of.
Result<ActionReply> Actions::replaceScript(int slot, const QByteArray &wanted, const QString &keep)
{
    if (const auto is = checkSlot(slot); !is)
        return tl::unexpected(is.error());
    if (QFile::exists(keep))
        return failure(
            ErrorCode::InvalidArgument,
            u"%1 is there already: the copy that is made before needs a file of its own"_s.arg(keep));
    const auto before = scriptIn(slot);
    if (!before && before.error().code != ErrorCode::BoardError)
        return tl::unexpected(before.error());
    ActionReply reply{{u"bytes"_s, int(wanted.size())}};
    if (before && *before == wanted) {
        reply.insert(u"unchanged"_s, true);
        return reply;
    }
    const QByteArray old = before.value_or(QByteArray());
    if (const auto target = checkTarget(keep, FileKind::Script); !target)
        return tl::unexpected(target.error());
    const QString part = keep + u".part"_s;
    if (const auto written = writeWhole(part, old, FileKind::Script); !written)
        return tl::unexpected(written.error());
    if (readWhole(part, FileKind::Script, kLargestFile).value_or(QByteArray()) != old)
        return failure(ErrorCode::NoBackup, part);
    // What runs while it is written over may do anything. A board that runs none may say so.
    if (const auto stopped = orderScript(StopIt, slot);
        !stopped && stopped.error().code != ErrorCode::BoardError)
        return tl::unexpected(stopped.error());
    if (const auto put = putScript(slot, wanted); !put) {
        Error error = put.error();
        if (before && !isLinkLoss(error) && takeScriptBack(slot, old)) {
            QFile::remove(part);
            addDetail(error.detail, u"slot %1 holds again what it held before"_s.arg(slot + 1));
            return tl::unexpected(error);
        }
        addDetail(error.detail, unknownNow(slot));
        if (!old.isEmpty())
            addDetail(error.detail, u"what it held is in %1"_s.arg(part));
        return tl::unexpected(error);
    }
    if (old.isEmpty())
        QFile::remove(part);
    else if (QFile::rename(part, keep))
        reply.insert(u"kept"_s, keep);
    else
        reply.insert(u"kept"_s, part);
    return reply;
}

// Also for one who has cancelled: half a script is none.
bool Actions::takeScriptBack(int slot, const QByteArray &old)
{
    const Unbroken unbroken(m_channel);
    return putScript(slot, old).has_value();
}

// That it was written is what can be read afterwards.
Result<void> Actions::putScript(int slot, const QByteArray &content)
{
    const auto put = putFile(kScriptFile, slot, content);
    const bool isGone = content.isEmpty() && !put && put.error().boardCode == kNoSuchFile;
    if (!put && !isGone)
        return put;
    const auto back = scriptIn(slot);
    if (!back)
        return tl::unexpected(back.error());
    if (*back == content)
        return {};
    return failure(ErrorCode::NoEffect,
                   content.isEmpty() ? u"the board still has the file"_s : u"the board holds another file"_s);
}

Result<ActionReply> Actions::orderScript(int mode, int slot)
{
    return confirm(CommandId::RunScript, ByteWriter().u8(mode).u8(slot).zeros(32).take());
}

Result<void> Actions::checkScript(int slot)
{
    if (const auto is = checkSlot(slot); !is)
        return is;
    const auto size = scriptSize(slot);
    if (!size)
        return tl::unexpected(size.error());
    return *size > 0 ? Result<void>()
                     : failure(ErrorCode::ConditionUnmet, u"slot %1 holds no script"_s.arg(slot + 1));
}

/// Hears of scripts that begin and end, as long as it exists, where the board tells of that.
class Actions::ScriptEvents
{
public:
    explicit ScriptEvents(Actions &actions)
        : m_actions(actions)
        , m_heard(actions.m_channel.listen(
              [](const FrameView &frame) { return frame.id == number(CommandId::Event); }))
        , m_areTold(actions.m_device.m_identity.firmwareNumber >= kScriptEventsSince
                    && actions.m_device.setStream(actions.m_channel, stream(kScriptEventInterval)))
    {
    }
    ~ScriptEvents()
    {
        if (!m_areTold)
            return;
        const Unbroken unbroken(m_actions.m_channel);
        std::ignore = m_actions.m_device.setStream(m_actions.m_channel, stream(0));
    }
    ScriptEvents(const ScriptEvents &) = delete;
    ScriptEvents &operator=(const ScriptEvents &) = delete;

    [[nodiscard]] bool areTold() const { return m_areTold; }
    /// Whether the board has told this since it was asked last; waits for it at most so long.
    bool tell(int type, milliseconds wait)
    {
        const TimePoint until = m_actions.m_channel.now() + wait;
        for (milliseconds left = wait; m_areTold;
             left = duration_cast<milliseconds>(until - m_actions.m_channel.now())) {
            const auto frame = m_heard->next(std::max(left, 1ms));
            if (!frame)
                return false;
            if (frame->payload.size() > 1 && quint8(frame->payload[0]) == kScriptEvent
                && quint8(frame->payload[1]) == type)
                return true;
        }
        return false;
    }

private:
    static DataStream stream(int interval)
    {
        DataStream wanted;
        wanted.command = number(CommandId::Event);
        wanted.intervalMs = interval;
        wanted.config = ByteWriter().u8(kScriptEvent).u8(kScriptOff | kScriptOn).zeros(6).take();
        return wanted;
    }

    Actions &m_actions;
    std::unique_ptr<Mailbox> m_heard;
    bool m_areTold;
};

// The confirmation proves nothing. An event does; that none came may have other reasons: another one may have
// run before.
Result<ActionReply> Actions::runScript(const QVariantMap &arguments)
{
    const int mode = arguments.value(u"mode"_s).toInt();
    const int slot = slotIn(arguments);
    if (mode == StopIt)
        return stopScript(arguments);
    if (const auto is = checkScript(slot); !is)
        return tl::unexpected(is.error());
    ScriptEvents events(*this);
    auto begun = orderScript(mode, slot);
    if (begun && events.tell(kScriptOn, kScriptEventWait))
        begun->insert(u"running"_s, true);
    return begun;
}

Result<ActionReply> Actions::stopScript(const QVariantMap &arguments)
{
    if (const auto is = checkSlot(slotIn(arguments)); !is)
        return tl::unexpected(is.error());
    ScriptEvents events(*this);
    return endScript(slotIn(arguments), events);
}

// One that still tells commands has not stopped; that it tells none is no proof, for it may wait.
Result<ActionReply> Actions::endScript(int slot, ScriptEvents &events)
{
    auto stopped = orderScript(StopIt, slot);
    if (!stopped)
        return stopped;
    const auto told
        = m_channel.listen([](const FrameView &frame) { return frame.id == number(CommandId::ScriptDebug); });
    const TimePoint begin = m_channel.now();
    while (m_channel.now() - begin < kStopWatch) {
        if (events.tell(kScriptOff, 1ms)) {
            stopped->insert(u"stopped"_s, true);
            break;
        }
        const auto frame = told->next(kMessageWait);
        if (frame && m_channel.now() - begin > kOnItsWay)
            return failure(
                ErrorCode::NoEffect,
                u"the script goes on: it tells command %1"_s.arg(ByteReader(frame->payload).u16()));
        if (!frame && frame.error().code != ErrorCode::Timeout)
            return tl::unexpected(frame.error());
    }
    return stopped;
}

// The board tells each command that it carries out, and nothing at the end.
Result<ActionReply> Actions::followScript(const QVariantMap &arguments)
{
    const int slot = slotIn(arguments);
    if (const auto is = checkScript(slot); !is)
        return tl::unexpected(is.error());
    const auto told
        = m_channel.listen([](const FrameView &frame) { return frame.id == number(CommandId::ScriptDebug); });
    ScriptEvents events(*this);
    if (const auto begun = orderScript(DebugIt, slot); !begun)
        return begun;
    Progress progress;
    progress.step = u"script"_s;
    progress.subject = QString::number(slot + 1);
    const auto patience = events.areTold() ? kSilentWithEvents : kSilentWithoutEvents;
    int command = 0;
    TimePoint heard = m_channel.now();
    while (m_channel.now() - heard < patience) {
        const auto frame = told->next(kMessageWait);
        if (!frame && frame.error().code == ErrorCode::Cancelled) {
            const Unbroken unbroken(m_channel);
            const auto stopped = endScript(slot, events);
            return stopped ? failure(ErrorCode::Cancelled, u"stopped at command %1"_s.arg(command)) : stopped;
        }
        if (!frame && frame.error().code != ErrorCode::Timeout)
            return tl::unexpected(frame.error());
        if (!frame && events.tell(kScriptOff, 1ms))
            return ActionReply{{u"command"_s, command}, {u"ended"_s, true}};
        if (frame) {
            heard = m_channel.now();
            ByteReader reader(frame->payload);
            command = reader.u16();
            if (const int code = reader.u8(); code != 0)
                return failure(ErrorCode::BoardError,
                               u"command %1: %2"_s.arg(command).arg(fileRefusal(code).detail), code);
        }
        progress.values[u"command"_s] = command;
        progress.values[u"silent"_s] = seconds(m_channel.now() - heard);
        m_channel.progress(progress);
    }
    if (command == 0)
        return failure(ErrorCode::NoEffect, u"no command of it was told: whether it runs is not known"_s);
    return ActionReply{{u"command"_s, command}};
}

}  // namespace simplebgc
