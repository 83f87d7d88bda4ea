// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/actioncommand.h"
#include "protocol/base/filefault.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/record/configurationformats.h"
#include "protocol/record/keptscripts.h"

#include <QJsonArray>
#include <QMap>

using namespace Qt::StringLiterals;

namespace {

class ScriptCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "script"; }
    const char *words() const override { return "N [FILE]"; }
    QString help() const override
    {
        return u"text of a script of the board; with a file, compile and write it"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 script 1 look-around.scr"; }
    QList<CommandOption> options() override
    {
        return {switchOption(u"dry-run"_s, u"only tell what would be written"_s, m_dryRun),
                othersOption(m_others)};
    }
    QString check() const override
    {
        bool ok = false;
        arguments().value(0).toInt(&ok);
        return ok && arguments().size() <= 2 ? QString()
                                             : u"script needs the number of a script, and maybe a file"_s;
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const Family *family = findFamily(families(), device.identity().family);
        const int script = arguments().first().toInt() - 1;
        if (!family || !family->scripts)
            return failure(ErrorCode::Unsupported, u"boards of this family keep no scripts"_s);
        if (script < 0 || script >= family->scripts->count())
            return failure(ErrorCode::InvalidArgument,
                           u"there are scripts 1 to %1"_s.arg(family->scripts->count()));
        WriteOptions options;
        options.history = &history();
        const auto base = arguments().size() == 1 || m_dryRun ? device.readConfiguration(channel)
                                                              : readBase(channel, device, m_others, options);
        if (!base)
            return tl::unexpected(base.error());
        const BlockKey key{0, family->scripts->block()};
        // What did not come this time can be read the next time.
        const MissingPart *part = base->findMissing(key);
        if (part && part->why.code != ErrorCode::Unsupported)
            return failure(ErrorCode::Incomplete, base->partName(key));
        if (base->block(key).isEmpty())
            return failure(ErrorCode::Unsupported, u"the scripts cannot be read over this link"_s);
        if (arguments().size() == 1) {
            CommandOutcome outcome;
            outcome.text = family->scripts->text(*base, script);
            outcome.json = QJsonObject{{u"script"_s, script + 1}, {u"text"_s, outcome.text}};
            reportMissing(outcome, *base, kTheBoard, true);
            return outcome;
        }
        const auto text = readWhole(arguments()[1], FileKind::Script, kLargestScript);
        if (!text)
            return tl::unexpected(text.error());
        QStringList texts;
        for (int each = 0; each < family->scripts->count(); ++each)
            texts.append(each == script ? QString::fromUtf8(*text) : family->scripts->text(*base, each));
        const auto code = family->scripts->compile(*base, texts);
        if (!code)
            return tl::unexpected(code.error().error());
        Configuration edited = *base;
        edited.setBlock(key, *code);
        options.named.insert(QLatin1String(base->parameters().block(key.block)->data));
        if (!m_dryRun)
            return writeAndTellMissing(channel, device, *base, edited, options);
        const auto [used, all] = family->scripts->used(edited);
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"bytesUsed"_s, used}, {u"bytes"_s, all}};
        outcome.text = u"compiles; %1 of %2 bytes would be used\n"_s.arg(used).arg(all);
        return outcome;
    }

private:
    static constexpr qint64 kLargestScript = 65536;
    bool m_dryRun = false;
    std::optional<OtherValues> m_others;
};

/// Compiled scripts in the slots of a board.
class ScriptsCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "scripts"; }
    const char *words() const override
    {
        return "[list | save N FILE | load N FILE | erase N | run N | stop]";
    }
    QString help() const override
    {
        return u"compiled scripts in the slots of a board: list, copy, run and stop them"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 scripts load 2 orbit.bin"; }
    QList<CommandOption> options() override
    {
        return {switchOption(u"follow"_s, u"tell each command of the script that runs; Ctrl-C stops it"_s,
                             m_isFollowed),
                switchOption(u"confirmed"_s,
                             u"what the script does is known, and the gimbal is free to move"_s,
                             m_confirmed)};
    }
    QString check() const override
    {
        const QStringList words = arguments();
        const auto wanted = kVerbs.find(verb());
        if (wanted == kVerbs.end())
            return u"'%1' is not list, save, load, erase, run or stop"_s.arg(verb());
        if (words.size() != *wanted && !(words.isEmpty() && verb() == u"list"_s))
            return u"scripts %1 takes %2 words"_s.arg(verb()).arg(*wanted - 1);
        if (*wanted > 1 && number() < 1)
            return u"'%1' is not the number of a slot"_s.arg(words[1]);
        if ((m_isFollowed || m_confirmed) && verb() != u"run"_s)
            return u"--follow and --confirmed are for scripts run"_s;
        return {};
    }
    bool moves() const override { return verb() == u"run"_s; }

protected:
    QList<int> awaits(const Device &device) const override
    {
        const int outputs = moves() ? rolesOf(device).outputs : -1;
        return outputs >= 0 ? QList<int>{outputs} : QList<int>();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        if (!actionNamed(device, u"script.list"_s))
            return failure(ErrorCode::Unsupported, u"boards of this family keep no compiled scripts"_s);
        const KeptScripts kept(history(), device.identity().serial);
        if (verb() == u"list"_s)
            return list(channel, device, kept);
        if (verb() == u"save"_s)
            return perform(channel, device, u"script.save"_s,
                           {{u"slot"_s, number()}, {u"file"_s, arguments()[2]}});
        if (verb() == u"stop"_s)
            return perform(channel, device, u"script.stop"_s, {{u"slot"_s, 1}});
        if (verb() == u"run"_s)
            return runScript(channel, device, kept);
        QVariantMap given{{u"slot"_s, number()}, {u"keep"_s, kept.next(number())}};
        if (verb() == u"load"_s)
            given.insert(u"file"_s, arguments()[2]);
        auto outcome = perform(channel, device, u"script."_s + verb(), given);
        if (!outcome)
            return outcome;
        kept.settle(number());
        if (const auto copies = kept.copies(number()); !copies.isEmpty())
            outcome->note += u"\nwhat was in the slot: "_s + copies.first().path;
        return outcome;
    }

private:
    [[nodiscard]] QString verb() const { return arguments().value(0, u"list"_s); }
    [[nodiscard]] int number() const { return arguments().value(1).toInt(); }

    Result<CommandOutcome> list(Channel &channel, Device &device, const KeptScripts &kept) const
    {
        const auto told = device.perform(channel, u"script.list"_s, {});
        if (!told)
            return tl::unexpected(told.error());
        CommandOutcome outcome;
        QJsonArray all;
        for (int slot = 1;; ++slot) {
            const QString name = u"script%1."_s.arg(slot);
            const QVariant bytes = told->value(name + u"bytes"_s);
            const QString error = told->value(name + u"error"_s).toString();
            if (!bytes.isValid() && error.isEmpty())
                break;
            const auto copies = kept.copies(slot);
            QJsonObject json{{u"slot"_s, slot}, {u"bytes"_s, bytes.toInt()}};
            QString line = !error.isEmpty() ? error
                : bytes.toInt() == 0        ? u"empty"_s
                                            : u"%1 bytes"_s.arg(bytes.toInt());
            if (!error.isEmpty())
                json.insert(u"error"_s, error);
            if (kept.isUnfinished(slot)) {
                json.insert(u"unfinished"_s, true);
                line += u", but writing it was broken off"_s;
            }
            if (!copies.isEmpty()) {
                json.insert(u"kept"_s, copies.first().path);
                line += u"; from before: "_s + copies.first().path;
            }
            all.append(json);
            outcome.text += u"%1 %2\n"_s.arg(slot, 2).arg(line);
        }
        outcome.json = QJsonObject{{u"slots"_s, all}};
        return outcome;
    }

    Result<CommandOutcome> runScript(Channel &channel, Device &device, const KeptScripts &kept) const
    {
        if (kept.isUnfinished(number()))
            return failure(ErrorCode::ConditionUnmet,
                           u"writing slot %1 was broken off, so it may hold half a script"_s.arg(number()));
        if (!m_confirmed) {
            const std::optional<bool> running = motorsRun(device, latest(), channel.now());
            const QString motors = !running ? u"nothing tells whether the motors run"_s
                : *running                  ? u"the motors are running"_s
                                            : u"the motors are off, and a script can start them"_s;
            return failure(ErrorCode::InvalidArgument,
                           u"nobody can read in a compiled script what it does; %1: confirm it with "
                           "--confirmed"_s.arg(motors));
        }
        if (m_isFollowed)
            return perform(channel, device, u"script.follow"_s, {{u"slot"_s, number()}});
        return perform(channel, device, u"script"_s, {{u"slot"_s, number()}, {u"mode"_s, 1}});
    }

    Result<CommandOutcome> perform(Channel &channel, Device &device, const QString &key,
                                   const QVariantMap &given) const
    {
        const auto done = performSafely(channel, device, key, given, history(), {}, latest());
        if (!done)
            return tl::unexpected(done.error());
        const bool isSeen = done->answered || done->reply.value(u"running"_s).toBool()
            || done->reply.value(u"stopped"_s).toBool();
        CommandOutcome outcome = doneOutcome(key, done->reply, isSeen, actionNamed(device, key));
        if (!done->snapshotPath.isEmpty())
            outcome.note = u"snapshot: "_s + done->snapshotPath;
        if (done->motorsNow)
            outcome.note += u'\n' + motorsChangedText(*done->motorsNow);
        return outcome;
    }

    /// How many words each takes.
    static inline const QMap<QString, int> kVerbs{{u"list"_s, 1},  {u"save"_s, 3}, {u"load"_s, 3},
                                                  {u"erase"_s, 2}, {u"run"_s, 2},  {u"stop"_s, 1}};
    bool m_isFollowed = false;
    bool m_confirmed = false;
};

}  // namespace

Commands scriptCommands(const CommandContext &context)
{
    return makeCommands<ScriptCommand, ScriptsCommand>(context);
}
