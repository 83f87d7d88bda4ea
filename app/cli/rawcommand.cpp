// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/actioncommand.h"
#include "protocol/base/bytes.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/session/channel.h"

using namespace Qt::StringLiterals;

namespace {

constexpr auto kAnswerTime = 1s;
constexpr auto kQuiet = 200ms;  // after an answer: there may be another one

/// Sends a command typed by hand, as the console does, and tells what comes back.
class RawFrameCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "raw"; }
    const char *words() const override { return "NAME [FIELD=VALUE...|HEX...] | HEX... | help"; }
    QString help() const override
    {
        return u"send one command by name, with its fields or bytes, or in hex, and tell the answers; \"raw "
               u"help\" lists "
               "the names"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 raw EXECUTE_MENU 12"; }
    QList<CommandOption> options() override
    {
        return {switchOption(u"confirmed"_s,
                             u"the command may write, destroy, or let the motors go (see \"raw help\")"_s,
                             m_confirmed)};
    }
    QString check() const override
    {
        return arguments().isEmpty() ? u"raw needs the name of a command, or a frame in hex"_s : QString();
    }
    bool moves() const override { return true; }

protected:
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const FrameInspector *inspector = device.inspector();
        if (!inspector)
            return failure(ErrorCode::Unsupported, u"raw"_s);
        if (arguments() == QStringList{u"help"_s})
            return names(*inspector);
        const auto command = inspector->parseCommand(arguments().join(u' '));
        if (!command)
            return tl::unexpected(command.error());
        const RestartNotice *notice = device.restartNotice();
        const bool restarts = notice && notice->ordersReset(command->bytes);
        if (!m_confirmed && (command->risk >= ActionRisk::Writes || restarts))
            return failure(ErrorCode::InvalidArgument,
                           (restarts
                                ? u"%1 restarts the board, and what its motors hold falls: confirm it with "
                                  "--confirmed"_s
                                : u"%1 may change what the board keeps: confirm it with --confirmed"_s)
                               .arg(command->name));
        const auto heard = channel.listen([](const FrameView &) { return true; });
        if (const auto sent = sendRaw(channel, device, *command, history()); !sent)
            return tl::unexpected(sent.error());
        return answers(channel, *heard, *inspector, command->name);
    }

private:
    static CommandOutcome names(const FrameInspector &inspector)
    {
        CommandOutcome outcome;
        QJsonArray array;
        for (const QString &name : inspector.commandNames()) {
            const auto command = inspector.parseCommand(name);
            const QString risk = command ? riskName(command->risk) : u"-"_s;
            outcome.text += u"%1 %2\n"_s.arg(name.leftJustified(28), risk);
            array.append(QJsonObject{{u"name"_s, name}, {u"risk"_s, risk}});
        }
        outcome.json = array;
        return outcome;
    }

    static Result<CommandOutcome> answers(const Channel &channel, Mailbox &heard,
                                          const FrameInspector &inspector, const QString &name)
    {
        CommandOutcome outcome;
        QJsonArray array;
        for (TimePoint until = channel.now() + kAnswerTime; channel.now() < until;) {
            const auto frame = heard.next(std::chrono::ceil<milliseconds>(until - channel.now()));
            if (!frame && frame.error().code != ErrorCode::Timeout)
                return tl::unexpected(frame.error());
            if (!frame)
                break;
            // What a board streams by itself is no answer, unless it was asked for.
            const FrameText text = inspector.describeFrame({frame->id, asBytes(frame->payload)}, true);
            if (inspector.isTelemetryFrame(frame->id) && text.name != name)
                continue;
            outcome.text
                += text.fields.isEmpty() ? text.name + u'\n' : u"%1: %2\n"_s.arg(text.name, text.fields);
            array.append(QJsonObject{{u"name"_s, text.name},
                                     {u"fields"_s, text.fields},
                                     {u"bytes"_s, QString::fromLatin1(frame->payload.toHex(' '))}});
            if (text.isRefusal)
                outcome.exitCode = Refused;
            until = std::min(until, channel.now() + kQuiet);
        }
        outcome.json = QJsonObject{{u"command"_s, name}, {u"answers"_s, array}};
        if (array.isEmpty())
            outcome.note = u"sent; nothing answered, so whether it was done nobody can tell"_s;
        return outcome;
    }

    bool m_confirmed = false;
};

}  // namespace

Commands rawCommands(const CommandContext &context)
{
    return makeCommands<RawFrameCommand>(context);
}
