// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that boards keep: a configuration, a mission.
#include "app/cli/actioncommand.h"
#include "protocol/base/filefault.h"
#include "protocol/configuration/linediff.h"
#include "protocol/configuration/scriptlanguage.h"
#include "protocol/device/flight.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLargestDocument = 1 << 20;  // what is longer is no text of a board

/// The text that a board keeps, from and to files.
class ConfigCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "config"; }
    const char *words() const override { return "read|write|check|diff FILE|- [board]"; }
    QString help() const override
    {
        return u"the configuration text of a board: read it to a file, write one, check one without a board, "
               "or compare"_s;
    }
    const char *example() const override { return "--link udp://192.168.32.1:2020 config read drone.lua"; }
    QList<CommandOption> options() override
    {
        return {textOption(u"block"_s, u"KEY"_s, u"which text, where boards keep several"_s, m_block),
                switchOption(u"dry-run"_s, u"only show what would be written"_s, m_dryRun),
                switchOption(u"confirmed"_s, u"a text is written although something speaks against it"_s,
                             m_confirmed)};
    }
    QString check() const override
    {
        static const QStringList kinds{u"read"_s, u"write"_s, u"check"_s, u"diff"_s};
        // As "diff A board" does, on either side.
        const bool namesBoard
            = isKind("diff") && arguments().size() == 3 && arguments().count(u"board"_s) == 1;
        if ((arguments().size() != 2 && !namesBoard) || !kinds.contains(arguments().first()))
            return u"config needs read, write, check or diff, and a file"_s;
        if (path() == u"-"_s && !isKind("read"))
            return u"config %1 needs a file"_s.arg(arguments().first());
        return {};
    }
    bool needsBoard() const override { return !isKind("check"); }
    void startWithoutBoard() override { emit finished(checkAlone()); }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const auto block = findText(device.parameters()->blocks());
        if (!block)
            return tl::unexpected(block.error());
        if (isKind("read"))
            return read(channel, device, **block);
        const auto text = load(**block);
        if (!text)
            return tl::unexpected(text.error());
        if (isKind("diff") || m_dryRun)
            return compare(channel, device, **block, *text);
        return write(channel, device, **block, *text);
    }

private:
    [[nodiscard]] bool isKind(const char *kind) const { return arguments().value(0) == QLatin1String(kind); }
    [[nodiscard]] QString path() const
    {
        const bool isBoardFirst = arguments().size() == 3 && arguments()[1] == u"board"_s;
        return arguments().value(isBoardFirst ? 2 : 1);
    }
    // From the file to what the board holds.
    [[nodiscard]] bool isBoardSecond() const { return arguments().value(2) == u"board"_s; }

    [[nodiscard]] bool isNamed(const BlockSpec &block) const
    {
        return m_block.isEmpty() || m_block.compare(QLatin1String(block.name), Qt::CaseInsensitive) == 0
            || m_block.compare(QLatin1String(block.data), Qt::CaseInsensitive) == 0;
    }

    // Errors: Unsupported, InvalidArgument.
    [[nodiscard]] Result<const BlockSpec *> findText(std::span<const BlockSpec> blocks) const
    {
        const BlockSpec *found = nullptr;
        QStringList names;
        bool isAmbiguous = false;
        for (const BlockSpec &block : blocks) {
            if (!block.isText())
                continue;
            names.append(QLatin1String(block.name));
            if (!isNamed(block))
                continue;
            isAmbiguous = found;
            found = &block;
        }
        if (names.isEmpty())
            return failure(ErrorCode::Unsupported, u"this board keeps no text"_s);
        if (!found || isAmbiguous)
            return failure(ErrorCode::InvalidArgument,
                           u"say which text with --block; there are: %1"_s.arg(names.join(u", "_s)));
        return found;
    }

    // Errors: BadFile.
    [[nodiscard]] Result<QByteArray> load(const BlockSpec &block) const
    {
        const auto text = readWhole(path(), FileKind::Text, kLargestDocument);
        if (!text)
            return tl::unexpected(text.error());
        if (text->isEmpty() && !block.holds(0))
            return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Text, .path = path()});
        if (QString::fromUtf8(*text).toUtf8() != *text)
            return fileFailure({.problem = FileProblem::OtherKind, .kind = FileKind::Text, .path = path()});
        return *text;
    }

    // What is known to be wrong before anything is sent: the file's fault, not that of the command line.
    [[nodiscard]] static std::optional<CommandOutcome> refusal(const BlockSpec &block, const QByteArray &text)
    {
        CommandOutcome outcome;
        outcome.exitCode = Refused;
        if (!block.holds(text.size())) {
            outcome.note = u"%1 bytes; the board takes %2 to %3"_s.arg(text.size())
                               .arg(block.size)
                               .arg(std::max(block.size, block.maxSize));
            outcome.json = QJsonObject{{u"valid"_s, false}, {u"mistake"_s, outcome.note}};
            return outcome;
        }
        const auto mistake = block.check ? block.check(text) : std::nullopt;
        if (!mistake)
            return {};
        const QString sentence = mistake->sentence(QString::fromUtf8(mistake->what));
        outcome.note
            = mistake->line > 0 ? u"line %1: %2"_s.arg(QString::number(mistake->line), sentence) : sentence;
        outcome.json = QJsonObject{{u"valid"_s, false}, {u"line"_s, mistake->line}, {u"mistake"_s, sentence}};
        return outcome;
    }

    // What speaks against the texts, a line each.
    [[nodiscard]] static QStringList doubtsOf(const Device &device, const Configuration &wanted,
                                              const Configuration &board)
    {
        QStringList lines;
        const FlyingMachine *flight = device.flight();
        for (const ScriptMistake &doubt :
             flight ? flight->doubts(wanted, board) : std::vector<ScriptMistake>()) {
            const QString line = doubt.line > 0 ? u"line %1: "_s.arg(doubt.line) : QString();
            lines.append(line + doubt.sentence(QString::fromUtf8(doubt.what)));
        }
        return lines;
    }

    // Without a board, whatever board could have such a text.
    [[nodiscard]] Result<CommandOutcome> checkAlone() const
    {
        std::vector<BlockSpec> checked;
        std::optional<Family> meant;
        for (const Family &family : families()) {
            for (const BlockSpec &block : family.makeParameters(BoardIdentity())->blocks()) {
                if (block.isText() && block.check && isNamed(block)) {
                    checked.push_back(block);
                    meant = family;
                }
            }
        }
        if (checked.empty())
            return failure(ErrorCode::Unsupported, u"no text of this name can be checked without a board"_s);
        if (checked.size() > 1)
            return failure(ErrorCode::InvalidArgument, u"say which text with --block"_s);
        const auto text = load(checked.front());
        if (!text)
            return tl::unexpected(text.error());
        if (auto refused = refusal(checked.front(), *text))
            return *refused;
        Configuration wanted(BoardIdentity(), meant->makeParameters(BoardIdentity()));
        wanted.setBlock({0, checked.front().id}, *text);
        const QStringList doubts = doubtsOf(*meant->makeDevice(), wanted, Configuration());
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"valid"_s, true}, {u"doubts"_s, QJsonArray::fromStringList(doubts)}};
        outcome.text = u"valid %1\n"_s.arg(QLatin1String(checked.front().language));
        for (const QString &doubt : doubts)
            outcome.text += u"against it: %1\n"_s.arg(doubt);
        outcome.note = u"that does not prove that the board starts with it"_s;
        return outcome;
    }

    [[nodiscard]] Result<CommandOutcome> read(Channel &channel, Device &device, const BlockSpec &block) const
    {
        const auto text = device.readBlock(channel, {0, block.id});
        if (!text)
            return tl::unexpected(text.error());
        CommandOutcome outcome;
        if (path() == u"-"_s) {
            outcome.text = QString::fromUtf8(*text);
            if (outcome.text.toUtf8() != *text)
                return failure(ErrorCode::Unsupported, u"it is no UTF-8 text: name a file"_s);
            outcome.json = QJsonObject{{u"text"_s, outcome.text}, {u"bytes"_s, text->size()}};
            return outcome;
        }
        if (const auto saved = writeWhole(path(), *text, FileKind::Text); !saved)
            return tl::unexpected(saved.error());
        outcome.text = u"%1 bytes saved to %2\n"_s.arg(text->size()).arg(path());
        outcome.json = QJsonObject{{u"file"_s, path()}, {u"bytes"_s, text->size()}};
        return outcome;
    }

    [[nodiscard]] Result<CommandOutcome> compare(Channel &channel, Device &device, const BlockSpec &block,
                                                 const QByteArray &text) const
    {
        const auto held = device.readBlock(channel, {0, block.id});
        if (!held)
            return tl::unexpected(held.error());
        CommandOutcome outcome;
        if (isBoardSecond())
            tellDifference(outcome, text, *held, path(), u"the board"_s);
        else
            tellDifference(outcome, *held, text, u"the board"_s, path());
        if (auto refused = m_dryRun ? refusal(block, text) : std::nullopt) {
            outcome.note = refused->note;
            outcome.exitCode = Refused;
        }
        return outcome;
    }

    void tellDifference(CommandOutcome &outcome, const QByteArray &before, const QByteArray &after,
                        const QString &beforeName, const QString &afterName) const
    {
        const auto lines = lineDiff(before, after);
        const auto [added, removed] = countChanges(lines);
        outcome.text = before == after
            ? u"no difference\n"_s
            : u"--- %1\n+++ %2\n"_s.arg(beforeName, afterName) + differenceText(lines);
        outcome.json
            = QJsonObject{{u"differs"_s, before != after}, {u"added"_s, added}, {u"removed"_s, removed}};
    }

    [[nodiscard]] Result<CommandOutcome> write(Channel &channel, Device &device, const BlockSpec &block,
                                               const QByteArray &text)
    {
        if (auto refused = refusal(block, text))
            return *refused;
        WriteOptions options;
        options.history = &history();
        const auto base = readBase(channel, device, {}, options);
        if (!base)
            return tl::unexpected(base.error());
        const BlockKey key{0, block.id};
        if (!base->blocks().contains(key))
            return failure(ErrorCode::Incomplete, base->partName(key));
        CommandOutcome shown;
        tellDifference(shown, base->block(key), text, u"the board"_s, path());
        emit told(shown.text.chopped(1));
        Configuration edited = *base;
        edited.setBlock(key, text);
        const QStringList doubts = doubtsOf(device, edited, *base);
        for (const QString &doubt : doubts)
            emit told(u"against the text: "_s + doubt);
        if (!doubts.isEmpty() && !m_confirmed)
            return failure(ErrorCode::InvalidArgument,
                           u"nothing was written: what speaks against the text has to be confirmed with "
                           "--confirmed"_s);
        options.named.insert(QLatin1String(block.data));
        return writeAndTellMissing(channel, device, *base, edited, options);
    }

    QString m_block;
    bool m_dryRun = false;
    bool m_confirmed = false;
};

}  // namespace

QString dataText(const std::vector<DataChange> &changes)
{
    QString text;
    for (const DataChange &change : changes) {
        text += u"%1 %2 differ"_s.arg(QString(), -14).arg(QLatin1String(change.spec->data));
        if (!change.spec->isText()) {
            text += u'\n';
            continue;
        }
        const auto lines = lineDiff(change.from, change.to);
        const auto [added, removed] = countChanges(lines);
        text += u": +%1 -%2 lines\n"_s.arg(added).arg(removed) + differenceText(lines);
    }
    return text;
}

QJsonObject dataJson(const DataChange &change)
{
    QJsonObject json{{u"data"_s, QLatin1String(change.spec->data)}};
    if (!change.spec->isText())
        return json;
    const auto [added, removed] = countChanges(lineDiff(change.from, change.to));
    json.insert(u"added"_s, added);
    json.insert(u"removed"_s, removed);
    return json;
}

QString differenceText(const std::vector<DiffLine> &lines)
{
    constexpr int kContextLines = 3;
    QString text;
    for (const DiffLine &line : aroundChanges(lines, kContextLines)) {
        switch (line.kind) {
        case DiffLine::Kind::Same: text += u' ' + line.text; break;
        case DiffLine::Kind::Added: text += u'+' + line.text; break;
        case DiffLine::Kind::Removed: text += u'-' + line.text; break;
        case DiffLine::Kind::Gap: text += u"@@ %1 lines without a difference @@"_s.arg(line.left); break;
        }
        text += u'\n';
    }
    return text;
}

namespace {

class RecordingsCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "recordings"; }
    QString help() const override { return u"list the recordings that the drone keeps"_s; }
    const char *example() const override { return "--link udp://192.168.32.1:2020 recordings"; }

protected:
    QString actionKey() const override { return u"recordings"_s; }
    QStringList given() const override { return {}; }
};

}  // namespace

Commands textCommands(const CommandContext &context)
{
    return makeCommands<ConfigCommand, RecordingsCommand>(context);
}
