// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "protocol/record/configurationformats.h"
#include "protocol/transport/portlist.h"

#include <QFile>

using namespace Qt::StringLiterals;

namespace {

CommandOption dryRunOption(bool &on)
{
    return switchOption(u"dry-run"_s, u"only tell what would be written"_s, on);
}

// Everything that a file says is to be in use.
QSet<QString> namesIn(const Configuration &file)
{
    QSet<QString> names;
    for (const ParameterSpec &spec : file.parameters().all())
        names.insert(spec.key);
    for (const auto &[key, bytes] : file.blocks()) {
        if (const BlockSpec *block = file.parameters().block(key.block); block && block->isData())
            names.insert(QLatin1String(block->data));
    }
    return names;
}

class PortsCommand final : public LocalCommand
{
public:
    using LocalCommand::LocalCommand;
    const char *name() const override { return "ports"; }
    QString help() const override { return u"serial ports of this computer; opens none of them"_s; }
    const char *example() const override { return "ports"; }
    Result<CommandOutcome> run() override
    {
        CommandOutcome outcome;
        QJsonArray array;
        for (const PortInfo &port : listSerialPorts()) {
            array.append(QJsonObject{{u"path"_s, port.path},
                                     {u"description"_s, port.description},
                                     {u"vendorId"_s, port.vendorId},
                                     {u"productId"_s, port.productId},
                                     {u"address"_s, u"serial:"_s + port.path}});
            outcome.text += port.label() + u'\n';
        }
        if (array.isEmpty())
            outcome.note = u"no serial ports"_s;
        outcome.json = array;
        return outcome;
    }
};

class DumpCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "dump"; }
    const char *words() const override { return "FILE"; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 dump before.json"; }
    QString help() const override
    {
        QString text = u"save the whole configuration to a file"_s;
        for (const Family &family : families()) {
            if (family.settingsFile)
                text += u"; .%1 for %2"_s.arg(family.settingsFile->suffix, family.settingsFile->name);
        }
        return text;
    }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"dump needs one file name"_s;
    }
    QList<CommandOption> options() override { return {partialOption(m_partial)}; }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return tl::unexpected(configuration.error());
        const QString path = arguments().first();
        if (const auto saved = saveConfiguration(path, *configuration, u"dump"_s, families()); !saved)
            return tl::unexpected(saved.error());
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"file"_s, path}, {u"blocks"_s, qint64(configuration->blocks().size())}};
        outcome.text = u"saved to %1\n"_s.arg(path);
        reportMissing(outcome, *configuration, u"the board"_s, m_partial);
        return outcome;
    }

private:
    bool m_partial = false;
};

class DiffCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "diff"; }
    const char *words() const override { return "A B"; }
    QString help() const override { return u"differences between two files, or a file and \"board\""_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 diff before.json board"; }
    QString check() const override
    {
        return arguments().size() == 2 ? QString() : u"diff needs two files, one may be \"board\""_s;
    }
    QList<CommandOption> options() override { return {partialOption(m_partial)}; }
    bool needsBoard() const override { return arguments().contains(u"board"_s); }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        auto board = device.readConfiguration(channel);
        if (!board)
            return tl::unexpected(board.error());
        return compare(&*board);
    }
    void startWithoutBoard() override { emit finished(compare(nullptr)); }

private:
    [[nodiscard]] Result<CommandOutcome> compare(const Configuration *board) const
    {
        std::array<Configuration, 2> sides;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const QString name = arguments().value(qsizetype(i));
            if (name == u"board"_s) {
                sides[i] = *board;
                continue;
            }
            auto file = loadConfiguration(name, families());
            if (!file)
                return tl::unexpected(file.error());
            sides[i] = std::move(file->configuration);
        }
        // Both sides in the first one's terms, so boards of different firmware can be compared.
        CommandOutcome outcome;
        QStringList skipped;
        const Configuration second = applied(sides[0], sides[1], skipped, AppliedFor::Comparing);
        const auto changes = sides[0].changesTo(second);
        QJsonArray array;
        for (const ParameterChange &change : changes)
            array.append(changeJson(change));
        outcome.text = changeText(sides[0], changes) + dataText(sides[0].dataChangesTo(second));
        for (const DataChange &change : sides[0].dataChangesTo(second))
            array.append(QJsonObject{{u"data"_s, QLatin1String(change.spec->data)}});
        for (int i = 0; i < sides[0].identity().profileCount; ++i) {
            if (sides[0].profileNames().value(i) == second.profileNames().value(i))
                continue;
            array.append(QJsonObject{{u"key"_s, u"profile.name"_s},
                                     {u"profile"_s, i + 1},
                                     {u"from"_s, sides[0].profileNames().value(i)},
                                     {u"to"_s, second.profileNames().value(i)}});
            outcome.text += u"name of profile %1: %2 -> %3\n"_s.arg(i + 1).arg(
                sides[0].profileNames().value(i), second.profileNames().value(i));
        }
        const bool isWhole = sides[0].missing().empty() && sides[1].missing().empty();
        if (array.isEmpty())
            outcome.text = isWhole ? u"no difference\n"_s : u"no difference in what both have\n"_s;
        if (!skipped.isEmpty())
            outcome.note
                = u"not compared, as the first side does not have them: %1"_s.arg(skipped.join(u", "_s));
        outcome.json = array;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const QString name = arguments().value(qsizetype(i));
            reportMissing(outcome, sides[i], name == u"board"_s ? u"the board"_s : name, m_partial);
        }
        return outcome;
    }

    bool m_partial = false;
};

class ApplyCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "apply"; }
    const char *words() const override { return "FILE"; }
    QString help() const override
    {
        return u"write a file's values to the board; --dry-run only shows them"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 apply before.json --dry-run"; }
    QList<CommandOption> options() override
    {
        return {dryRunOption(m_dryRun), partialOption(m_partial), othersOption(m_others)};
    }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"apply needs one file name"_s;
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        auto file = loadConfiguration(arguments().first(), families());
        if (!file)
            return tl::unexpected(file.error());
        if (file->configuration.identity().family != device.identity().family) {
            return failure(
                ErrorCode::BadFile,
                u"it is for a board of the family %1"_s.arg(file->configuration.identity().family));
        }
        WriteOptions options;
        const auto base
            = m_dryRun ? device.readConfiguration(channel) : readBase(channel, device, m_others, options);
        if (!base)
            return tl::unexpected(base.error());
        QStringList skipped = file->unknownKeys;
        const Configuration edited = applied(*base, file->configuration, skipped);
        Result<CommandOutcome> outcome = CommandOutcome();
        if (m_dryRun) {
            const auto changes = base->changesTo(edited);
            QJsonArray array;
            for (const ParameterChange &change : changes)
                array.append(changeJson(change));
            for (const DataChange &change : base->dataChangesTo(edited))
                array.append(QJsonObject{{u"data"_s, QLatin1String(change.spec->data)}});
            outcome->json = array;
            outcome->text = array.isEmpty()
                ? u"nothing would change\n"_s
                : changeText(*base, changes) + dataText(base->dataChangesTo(edited));
        } else {
            options.history = &history();
            options.named = namesIn(file->configuration);
            outcome = writeAndReport(channel, device, *base, edited, options);
        }
        if (outcome && !file->missingKeys.isEmpty())
            outcome->note
                += u"\nnot in the file, so the default was taken: "_s + file->missingKeys.join(u", "_s);
        if (outcome && !skipped.isEmpty())
            outcome->note += u"\nnot applied, as this board does not take them: "_s + skipped.join(u", "_s);
        if (outcome) {
            reportMissing(*outcome, *base, u"the board"_s, m_partial);
            reportMissing(*outcome, file->configuration, arguments().first(), m_partial);
        }
        return outcome;
    }

private:
    bool m_dryRun = false;
    bool m_partial = false;
    OtherValues m_others = OtherValues::Keep;
};

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
    QList<CommandOption> options() override { return {dryRunOption(m_dryRun), othersOption(m_others)}; }
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
        if (base->block(key).isEmpty())
            return failure(ErrorCode::Unsupported, u"the scripts cannot be read over this link"_s);
        if (arguments().size() == 1) {
            CommandOutcome outcome;
            outcome.text = family->scripts->text(*base, script);
            outcome.json = QJsonObject{{u"script"_s, script + 1}, {u"text"_s, outcome.text}};
            return outcome;
        }
        QFile file(arguments()[1]);
        if (!file.open(QIODevice::ReadOnly))
            return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(file.fileName(), file.errorString()));
        QStringList texts;
        for (int each = 0; each < family->scripts->count(); ++each)
            texts.append(each == script ? QString::fromUtf8(file.read(kLargestScript))
                                        : family->scripts->text(*base, each));
        const auto code = family->scripts->compile(*base, texts);
        if (!code)
            return tl::unexpected(code.error().error());
        Configuration edited = *base;
        edited.setBlock(key, *code);
        options.named.insert(QLatin1String(base->parameters().block(key.block)->data));
        if (!m_dryRun)
            return writeAndReport(channel, device, *base, edited, options);
        const auto [used, all] = family->scripts->used(edited);
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"bytesUsed"_s, used}, {u"bytes"_s, all}};
        outcome.text = u"compiles; %1 of %2 bytes would be used\n"_s.arg(used).arg(all);
        return outcome;
    }

private:
    static constexpr qint64 kLargestScript = 65536;
    bool m_dryRun = false;
    OtherValues m_others = OtherValues::Keep;
};

}  // namespace

Commands fileCommands(const CommandContext &context)
{
    return makeCommands<PortsCommand, DumpCommand, DiffCommand, ApplyCommand, ScriptCommand>(context);
}
