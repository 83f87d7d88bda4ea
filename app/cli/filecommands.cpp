// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "protocol/base/filefault.h"
#include "protocol/configuration/memoryimage.h"
#include "protocol/record/configurationformats.h"
#include "protocol/transport/portlist.h"

using namespace Qt::StringLiterals;

namespace {

CommandOption dryRunOption(bool &on)
{
    return switchOption(u"dry-run"_s, u"only tell what would be written"_s, on);
}

// Everything that a file says is to be in use.
QSet<QString> namesIn(const ConfigurationFile &file)
{
    QSet<QString> names;
    for (const ParameterSpec &spec : file.configuration.parameters().all())
        names.insert(spec.key);
    for (const auto &[key, bytes] : file.configuration.blocks()) {
        if (const BlockSpec *block = file.configuration.parameters().block(key.block);
            block && block->isData())
            names.insert(QLatin1String(block->data));
    }
    for (const QString &key : file.missingKeys)
        names.remove(key);
    return names;
}

// Values that a file does not have: what became of them, in the note and in the document. The exit code is 1
// unless the operator wants a partial result.
void reportAbsent(CommandOutcome &outcome, const QStringList &keys, const QString &where, const QString &what,
                  bool partial)
{
    if (keys.isEmpty())
        return;
    outcome.note += outcome.note.isEmpty() ? u""_s : u"\n"_s;
    outcome.note += u"not in %1, so %2: %3"_s.arg(where, what, keys.join(u", "_s));
    addMissing(outcome, keys, where);
    if (!partial)
        outcome.exitCode = Refused;
}

// Two images of a memory, by addresses: no document tells what lies where.
Result<CommandOutcome> compareImages(const QString &first, const QString &second)
{
    const auto from = MemoryImage::load(first);
    if (!from)
        return tl::unexpected(from.error());
    const auto to = MemoryImage::load(second);
    if (!to)
        return tl::unexpected(to.error());
    if (from->bytes.size() != to->bytes.size())
        return failure(ErrorCode::InvalidArgument,
                       u"%1 holds %2 bytes of memory, %3 holds %4"_s.arg(first)
                           .arg(from->bytes.size())
                           .arg(second)
                           .arg(to->bytes.size()));
    CommandOutcome outcome;
    QJsonArray array;
    for (const MemoryDifference &difference : memoryDifferences(from->bytes, to->bytes)) {
        array.append(QJsonObject{{u"address"_s, qint64(difference.at)},
                                 {u"bytes"_s, qint64(difference.from.size())},
                                 {u"changed"_s, difference.changed()},
                                 {u"from"_s, QString::fromLatin1(difference.from.toHex(' '))},
                                 {u"to"_s, QString::fromLatin1(difference.to.toHex(' '))}});
        outcome.text += u"%1 %2 of %3 bytes differ: %4\n"_s.arg(difference.place().leftJustified(16))
                            .arg(difference.changed())
                            .arg(difference.from.size())
                            .arg(difference.text());
    }
    // Where one of the copies was made without them, nothing is said of files.
    const auto files
        = from->files && to->files ? fileDifferences(*from->files, *to->files) : QMap<QString, QString>();
    for (auto it = files.begin(); it != files.end(); ++it) {
        array.append(QJsonObject{{u"file"_s, it.key()}, {u"change"_s, *it}});
        outcome.text += u"%1 differs: %2\n"_s.arg(it.key().leftJustified(16), *it);
    }
    outcome.json = array;
    QStringList notes;
    if (from->files.has_value() != to->files.has_value())
        notes.append(u"only one of both copies holds the board's files, so these were not compared"_s);
    if (from->serial != to->serial)
        notes.append(u"of two boards: %1 and %2"_s.arg(from->serial, to->serial));
    if (from->firmware != to->firmware)
        notes.append(u"of two firmwares, which may keep things in other places: %1 and %2"_s.arg(
            from->firmware, to->firmware));
    if (array.isEmpty())
        outcome.text = u"no difference\n"_s;
    else
        notes.append(u"where parameters lie in a memory is documented nowhere; with the board connected, "
                     u"\"do memory.compare\" names those that it finds there"_s);
    outcome.note = notes.join(u'\n');
    return outcome;
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
        if (device.wholeMemory())
            outcome.note
                = u"these are the values in use; \"do stored.compare\" tells whether others are stored"_s;
        reportMissing(outcome, *configuration, kTheBoard, m_partial);
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
    QString help() const override
    {
        return u"differences between two files, or a file and \"board\"; also two copies of a whole memory"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 diff before.json board"; }
    QString check() const override
    {
        return arguments().size() == 2 ? QString() : u"diff needs two files, one may be \"board\""_s;
    }
    QList<CommandOption> options() override { return {partialOption(m_partial)}; }
    bool needsBoard() const override { return arguments().contains(u"board"_s); }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        if (!images().isEmpty())
            return compareMemories();
        auto board = device.readConfiguration(channel);
        if (!board)
            return tl::unexpected(board.error());
        return compare(&*board);
    }
    void startWithoutBoard() override
    {
        emit finished(images().isEmpty() ? compare(nullptr) : compareMemories());
    }

private:
    [[nodiscard]] QStringList images() const
    {
        QStringList found;
        for (const QString &name : arguments()) {
            if (name != u"board"_s && MemoryImage::isAt(name))
                found.append(name);
        }
        return found;
    }

    [[nodiscard]] Result<CommandOutcome> compareMemories() const
    {
        if (images().size() == 2)
            return compareImages(arguments()[0], arguments()[1]);
        const QString image = images().first();
        if (needsBoard())
            return failure(
                ErrorCode::InvalidArgument,
                u"%1 is a copy of a whole memory; \"do memory.compare file=%1\" compares it with the "
                "board's"_s.arg(image));
        return failure(ErrorCode::InvalidArgument,
                       u"%1 is a copy of a whole memory, %2 is none"_s.arg(
                           image, arguments()[image == arguments()[0] ? 1 : 0]));
    }

    [[nodiscard]] Result<CommandOutcome> compare(const Configuration *board) const
    {
        std::array<Configuration, 2> sides;
        std::array<QStringList, 2> absent;
        QStringList unknown;  // entries that match no parameter
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const QString name = arguments().value(qsizetype(i));
            if (name == u"board"_s) {
                sides[i] = *board;
                continue;
            }
            auto file = loadConfiguration(name, families());
            if (!file)
                return tl::unexpected(file.error());
            for (const QString &key : std::as_const(file->unknownKeys))
                unknown.append(u"%1 (%2)"_s.arg(key, name));
            sides[i] = std::move(file->configuration);
            absent[i] = file->missingKeys;
        }
        // Families use some of the same names for other things.
        const bool secondIsBoard = arguments().value(1) == u"board"_s;
        const std::size_t file = secondIsBoard ? 0 : 1;
        if (const auto same = checkSameFamily(sides[file], arguments().value(qsizetype(file)),
                                              sides[1 - file].identity().family, families());
            !same)
            return tl::unexpected(same.error());
        // Both sides in the first one's terms, so boards of different firmware can be compared.
        CommandOutcome outcome;
        QStringList skipped;
        const Configuration second
            = applied(sides[0], sides[1], skipped, AppliedFor::Comparing, absent[0] + absent[1]);
        const auto changes = sides[0].changesTo(second);
        QJsonArray array;
        for (const ParameterChange &change : changes)
            array.append(changeJson(change));
        outcome.text = changeText(sides[0], changes) + dataText(sides[0].dataChangesTo(second));
        for (const DataChange &change : sides[0].dataChangesTo(second))
            array.append(dataJson(change));
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
        const bool isWhole = sides[0].missing().empty() && sides[1].missing().empty() && unknown.isEmpty()
            && absent[0].isEmpty() && absent[1].isEmpty();
        if (array.isEmpty())
            outcome.text = isWhole ? u"no difference\n"_s : u"no difference in what both have\n"_s;
        if (!skipped.isEmpty())
            outcome.note
                = u"not compared, as the first side does not have them: %1"_s.arg(skipped.join(u", "_s));
        if (!unknown.isEmpty()) {
            outcome.note += outcome.note.isEmpty() ? u""_s : u"\n"_s;
            outcome.note += u"not compared, as no parameter has this name: "_s + unknown.join(u", "_s);
        }
        outcome.json = array;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const QString name = arguments().value(qsizetype(i));
            reportMissing(outcome, sides[i], name == u"board"_s ? kTheBoard : name, m_partial);
            reportAbsent(outcome, absent[i], name, u"not compared"_s, m_partial);
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
        return {dryRunOption(m_dryRun), partialOption(m_partial), othersOption(m_others),
                leapOption(m_areLeapsConfirmed)};
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
        if (const auto same
            = checkSameFamily(file->configuration, arguments().first(), device.identity().family, families());
            !same)
            return tl::unexpected(same.error());
        WriteOptions options;
        const auto base = readBase(channel, device, m_others, options);
        if (!base)
            return tl::unexpected(base.error());
        QStringList skipped = file->unknownKeys;
        const Configuration edited = applied(*base, *file, skipped);
        Result<CommandOutcome> outcome = CommandOutcome();
        if (const auto checked = edited.checkRules(*base); !checked) {
            if (!checked.error().place)
                return tl::unexpected(checked.error());
            outcome->exitCode = Refused;  // the file's fault, not that of the command line
            outcome->note = checked.error().detail;
            return outcome;
        }
        QSet<QString> wanted;
        for (const ParameterChange &change : base->changesTo(edited))
            wanted.insert(change.spec->key);
        const QString replaced = wanted.isEmpty() ? QString() : replacedText(channel, device, *base, wanted);
        if (m_dryRun) {
            const auto changes = base->changesTo(edited);
            QJsonArray array;
            for (const ParameterChange &change : changes)
                array.append(changeJson(change));
            for (const DataChange &change : base->dataChangesTo(edited))
                array.append(dataJson(change));
            outcome->json = array;
            outcome->text = array.isEmpty()
                ? u"nothing would change\n"_s
                : changeText(*base, changes) + dataText(base->dataChangesTo(edited));
            outcome->note = othersText(device, options, namesIn(*file));
            outcome->note += replaced;
        } else {
            if (const auto same = checkSaid(device.identity(), device.flight()); !same)
                return tl::unexpected(same.error());
            if (const auto clear = checkLeaps(*base, edited, m_areLeapsConfirmed); !clear)
                return tl::unexpected(clear.error());
            if (!replaced.isEmpty())
                emit told(replaced);
            options.history = &history();
            options.named = namesIn(*file);
            outcome = writeAndReport(channel, device, *base, edited, options);
        }
        if (outcome && !skipped.isEmpty())
            outcome->note += u"\nnot applied, as this board does not take them: "_s + skipped.join(u", "_s);
        if (outcome && !skipped.isEmpty() && !m_partial)
            outcome->exitCode = Refused;
        if (outcome) {
            reportMissing(*outcome, *base, kTheBoard, m_partial);
            reportMissing(*outcome, file->configuration, arguments().first(), m_partial);
            reportRounded(*outcome, file->rounded);
            reportAbsent(*outcome, file->missingKeys, arguments().first(), u"left as the board holds them"_s,
                         m_partial);
        }
        return outcome;
    }

private:
    // What fits one drone can make another one that looks the same turn over.
    [[nodiscard]] Result<void> checkSaid(const BoardIdentity &identity, bool flies) const
    {
        const bool isKnown = identity.isNumbered() || context().isBoardSaid;
        if (isKnown || (!flies && history().nameOf(identity.serial).isEmpty()))
            return {};
        return failure(ErrorCode::InvalidArgument,
                       u"this board has no serial number and may be another one than that of the file: say "
                       "with --board NAME which one it is"_s);
    }

    bool m_dryRun = false;
    bool m_partial = false;
    bool m_areLeapsConfirmed = false;
    std::optional<OtherValues> m_others;
};

}  // namespace

Commands fileCommands(const CommandContext &context)
{
    return makeCommands<PortsCommand, DumpCommand, DiffCommand, ApplyCommand>(context);
}
