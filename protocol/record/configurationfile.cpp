// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/configurationfile.h"

#include "protocol/base/hexbytes.h"
#include "protocol/base/jsonplace.h"
#include "protocol/configuration/rounding.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

const QString kFormat = u"gimbaldesk-configuration"_s;
const QString kNames = u"names"_s;  // among the missing parts
const Error kNotInFile{ErrorCode::Incomplete, u"not in the file"_s, 0};
constexpr int kVersion = 1;
constexpr qint64 kLargestFile = 4 * 1024 * 1024;
constexpr int kMaxProfiles = 32;
constexpr qsizetype kMaxShown = 40;  // characters of a value that is not understood

QJsonValue valueOf(const ParameterSpec &spec, double raw)
{
    if (std::isnan(raw))
        return QJsonValue::Null;  // the blocks hold the bytes
    switch (spec.row->kind) {
    case ValueKind::Toggle: return raw != 0;
    case ValueKind::Choice: return raw;
    case ValueKind::Flags: return spec.format(raw);
    case ValueKind::Number: break;
    }
    // By way of text, so that the file shows 0.18 and not 0.17999999999999999.
    return spec.format(raw).toDouble();
}

std::optional<double> rawOf(const ParameterSpec &spec, const QJsonValue &value)
{
    if (value.isBool())
        return value.toBool() ? 1 : 0;
    if (value.isDouble())
        return spec.parse(QString::number(value.toDouble(), 'g', QLocale::FloatingPointShortest));
    if (value.isString())
        return spec.parse(value.toString());
    return {};
}

QJsonObject valuesOf(const Configuration &configuration, int profile, Scope scope)
{
    QJsonObject values;
    for (const ParameterSpec &spec : configuration.parameters().all()) {
        if (spec.row->scope != scope || spec.row->state)
            continue;
        if (const auto raw = configuration.raw(spec, profile))
            values.insert(spec.key, valueOf(spec, *raw));
    }
    return values;
}

// Whether the file's value equals the one in the blocks. Files of earlier versions show counts with the
// decimals of the screen, which may not be enough to tell two counts apart.
bool isKnown(const ParameterSpec &spec, double known, const QJsonValue &value, double raw)
{
    const bool rounded = spec.row->wire != WireType::F32 && spec.row->kind == ValueKind::Number
        && value.isDouble() && value.toDouble() == spec.rounded(known).toDouble();
    // "On" is written for whatever is not 0.
    const bool isSame = spec.row->kind == ValueKind::Toggle && (known != 0) == (raw != 0);
    return known == raw || rounded || isSame;
}

// An entry of a file as an operator reads it: a text without its quotation marks.
QString shownValue(const QJsonValue &value)
{
    if (value.isString())
        return value.toString().left(kMaxShown);
    const QByteArray json = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(json.mid(1, json.size() - 2)).left(kMaxShown);
}

// A fault of the entry at this place.
FileFault entryFault(FileProblem problem, const QByteArray &json, const QStringList &place,
                     const QJsonValue &value, const QString &expected)
{
    FileFault fault{.problem = problem, .kind = FileKind::Configuration};
    fault.line = lineOfJson(json, place);
    fault.key = place.last();
    fault.value = shownValue(value);
    fault.expected = expected;
    return fault;
}

// Words of earlier files as the values that they hold. What is no number stays as it is, and is not known.
QJsonObject inParts(const ParameterSet &parameters, const QJsonObject &values)
{
    QJsonObject split = values;
    for (auto it = values.begin(); it != values.end(); ++it) {
        const auto parts
            = parameters.find(it.key()) ? QList<const ParameterSpec *>() : parameters.partsOf(it.key());
        bool isNumber = false;
        const quint32 word = it->toVariant().toString().toUInt(&isNumber, 0);
        if (parts.isEmpty() || !isNumber)
            continue;
        split.remove(it.key());
        for (const ParameterSpec *part : parts)
            split.insert(part->key,
                         valueOf(*part, word >> part->row->bitShift & ((1U << part->row->bitCount) - 1)));
    }
    return split;
}

// Puts a file's values into a configuration. A value that the blocks already hold exactly is left alone, so
// rounding in the text never changes a byte.
// @param place where the values stand in the file
Result<void> readValues(ConfigurationFile &file, const QByteArray &json, const QStringList &place,
                        const QJsonObject &kept, int profile)
{
    Configuration &configuration = file.configuration;
    const QJsonObject values = inParts(configuration.parameters(), kept);
    for (auto it = values.begin(); it != values.end(); ++it) {
        const ParameterSpec *spec = configuration.parameters().find(it.key());
        if (!spec) {
            if (!file.unknownKeys.contains(it.key()))
                file.unknownKeys.append(it.key());
            continue;
        }
        const auto known = configuration.raw(*spec, profile);
        if (it.value().isNull() && known && std::isnan(*known))
            continue;
        const auto raw = rawOf(*spec, it.value());
        if (raw && known && isKnown(*spec, *known, it.value(), *raw))
            continue;
        // A value stands in its block, which holds what no value tells as well.
        const BlockSpec *block = configuration.parameters().block(spec->row->block);
        if (!known && block && !configuration.blocks().contains({profile, block->id})) {
            FileFault fault{.problem = FileProblem::MissingEntry, .kind = FileKind::Configuration};
            fault.key = u"blocks: %1/%2"_s.arg(profile + 1).arg(QLatin1String(block->name));
            return fileFailure(fault);
        }
        const auto set = raw ? configuration.setRaw(*spec, profile, *raw)
                             : failure(ErrorCode::InvalidArgument, spec->allowedText());
        if (set) {
            const QString rounded
                = it.value().isDouble() ? roundingText(*spec, it.value().toDouble(), *raw) : QString();
            if (!rounded.isEmpty())
                file.rounded.append(rounded);
            continue;
        }
        const bool isNumber = raw && set.error().code == ErrorCode::OutOfRange;
        FileFault fault = entryFault(isNumber ? FileProblem::OutOfRange : FileProblem::BadValue, json,
                                     place + QStringList{it.key()}, it.value(), spec->allowedText());
        if (spec->row->scope == Scope::Profile)
            fault.profile = profile;
        return fileFailure(fault);
    }
    return {};
}

// Boards with other firmware may use other scales or other numbers for their choices, so the displayed value
// is what is carried over. A choice that does not exist there gets a number out of range.
double translated(const ParameterSpec &from, double raw, int fromFirmware, const ParameterSpec &to,
                  int toFirmware)
{
    if (from.row == to.row)
        return raw;
    if (from.row->kind != ValueKind::Choice || to.row->kind != ValueKind::Choice)
        return to.toRaw(from.toDisplay(raw));
    const auto known = from.choices(fromFirmware);
    const auto name = std::find_if(known.begin(), known.end(),
                                   [raw](const Choice &choice) { return choice.value == raw; });
    if (name == known.end())
        return raw;
    for (const Choice &choice : to.choices(toFirmware)) {
        if (qstrcmp(choice.name, name->name) == 0)
            return choice.value;
    }
    return to.row->max + 1;
}

// Sets the value of a parameter of a file. Errors: with what to tell the operator as their detail.
Result<void> take(Configuration &result, const ParameterSpec &own, int profile, const Configuration &board,
                  const ParameterSpec &spec, double raw, AppliedFor purpose)
{
    const double wanted = translated(spec, raw, spec.firmware, own, own.firmware);
    if (sameValue(board.raw(own, profile), wanted))
        return {};
    const bool isSame = own.row == spec.row;
    const auto set = purpose == AppliedFor::Comparing && isSame ? result.restoreRaw(own, profile, wanted)
                                                                : result.setRaw(own, profile, wanted);
    if (set)
        return {};
    // The translated number of a choice that does not exist there would tell nothing.
    return failure(set.error().code,
                   isSame && std::isfinite(raw) && set.error().code == ErrorCode::OutOfRange
                       ? set.error().detail
                       : spec.key);
}

BoardIdentity identityFrom(const QJsonObject &board)
{
    BoardIdentity identity;
    identity.family = board.value(u"family"_s).toString();
    identity.model = board.value(u"model"_s).toString();
    identity.firmware = board.value(u"firmware"_s).toString();
    identity.firmwareNumber = board.value(u"firmwareNumber"_s).toInt();
    identity.serial = board.value(u"serial"_s).toString();
    identity.profileCount = board.value(u"profileCount"_s).toInt(1);
    for (const auto &capability : board.value(u"capabilities"_s).toArray())
        identity.capabilities.insert(capability.toString());
    return identity;
}

// Blocks, and which of them the board did not deliver.
Result<void> readBlocks(Configuration &configuration, const QByteArray &json, const QJsonObject &root)
{
    const QJsonArray missing = root.value(u"missing"_s).toArray();
    const QJsonObject blocks = root.value(u"blocks"_s).toObject();
    for (int profile = 0; profile < configuration.identity().profileCount; ++profile) {
        for (const BlockSpec &block : configuration.parameters().blocks()) {
            const QString name = u"%1/%2"_s.arg(profile + 1).arg(QLatin1String(block.name));
            if (missing.contains(name))
                configuration.addMissing({profile, block.id}, kNotInFile);
            if (!blocks.contains(name))
                continue;
            const auto bytes = bytesFromHex(blocks.value(name).toString());
            // Parameter blocks may have grown since; data blocks are taken as a whole or not at all.
            if (!bytes || bytes->size() < block.size || (block.isData() && !block.holds(bytes->size()))) {
                FileFault fault = entryFault(FileProblem::BadValue, json, {u"blocks"_s, name},
                                             blocks.value(name), u"%1 B (hex)"_s.arg(block.size));
                if (bytes)
                    fault.value = u"%1 B"_s.arg(bytes->size());
                return fileFailure(fault);
            }
            configuration.setBlock({profile, block.id}, *bytes);
        }
    }
    return {};
}

}  // namespace

QByteArray ConfigurationFile::toJson(const Configuration &configuration, const QString &reason,
                                     const QDateTime &savedAt)
{
    const BoardIdentity &identity = configuration.identity();
    QStringList capabilities(identity.capabilities.begin(), identity.capabilities.end());
    capabilities.sort();
    QJsonObject board{{u"family"_s, identity.family},
                      {u"model"_s, identity.model},
                      {u"firmware"_s, identity.firmware},
                      {u"firmwareNumber"_s, identity.firmwareNumber},
                      {u"serial"_s, identity.serial},
                      {u"profileCount"_s, identity.profileCount},
                      {u"capabilities"_s, QJsonArray::fromStringList(capabilities)}};
    QJsonArray profiles;
    for (int profile = 0; profile < identity.profileCount; ++profile) {
        profiles.append(QJsonObject{{u"name"_s, configuration.profileNames().value(profile)},
                                    {u"values"_s, valuesOf(configuration, profile, Scope::Profile)}});
    }
    QJsonObject blocks;
    for (const auto &[key, bytes] : configuration.blocks()) {
        const BlockSpec *block = configuration.parameters().block(key.block);
        blocks.insert(u"%1/%2"_s.arg(key.profile + 1).arg(QLatin1String(block ? block->name : "?")),
                      QString::fromLatin1(bytes.toHex()));
    }
    QJsonArray missing;
    for (const MissingPart &part : configuration.missing()) {
        const BlockSpec *block = configuration.parameters().block(part.key.block);
        missing.append(
            part.key.block == MissingPart::kProfileNames
                ? kNames
                : u"%1/%2"_s.arg(part.key.profile + 1).arg(QLatin1String(block ? block->name : "?")));
    }
    // clang-format off
    QJsonObject root{{u"format"_s, kFormat}, {u"version"_s, kVersion}, {u"reason"_s, reason},
                           {u"savedAt"_s, savedAt.toString(Qt::ISODateWithMs)}, {u"board"_s, board},
                           {u"activeProfile"_s, configuration.activeProfile() + 1},
                           {u"boardValues"_s, valuesOf(configuration, configuration.activeProfile(), Scope::Board)},
                           {u"profiles"_s, profiles}, {u"blocks"_s, blocks}};
    // clang-format on
    if (!missing.isEmpty())
        root.insert(u"missing"_s, missing);
    return QJsonDocument(root).toJson();
}

Result<ConfigurationFile> ConfigurationFile::fromJson(const QByteArray &json,
                                                      const MakeParameters &makeParameters)
{
    QJsonParseError parse;
    const QJsonDocument document = QJsonDocument::fromJson(json, &parse);
    if (!document.isObject())
        return fileFailure(jsonFault(json, parse, FileKind::Configuration));
    const QJsonObject root = document.object();
    if (root.value(u"format"_s).toString() != kFormat)
        return fileFailure({.problem = FileProblem::OtherKind,
                            .kind = FileKind::Configuration,
                            .said = u"not a GimbalDesk configuration"_s});
    if (const auto once = checkOnce(json, FileKind::Configuration); !once)
        return tl::unexpected(once.error());
    const auto wrong
        = [&json, &root](FileProblem problem, const QStringList &place, const QString &expected) {
              QJsonValue value = root;
              for (const QString &name : place)
                  value = value[name];
              return fileFailure(entryFault(problem, json, place, value, expected));
          };
    if (const int version = root.value(u"version"_s).toInt(); version != kVersion)
        return wrong(version > kVersion ? FileProblem::NewerVersion : FileProblem::BadValue, {u"version"_s},
                     QString::number(kVersion));

    const BoardIdentity identity = identityFrom(root.value(u"board"_s).toObject());
    const QJsonArray profiles = root.value(u"profiles"_s).toArray();
    if (identity.profileCount < 1 || identity.profileCount > kMaxProfiles)
        return wrong(FileProblem::OutOfRange, {u"board"_s, u"profileCount"_s},
                     u"1 to %1"_s.arg(kMaxProfiles));
    if (profiles.size() > identity.profileCount)
        return wrong(FileProblem::BadValue, {u"board"_s, u"profileCount"_s},
                     QString::number(profiles.size()));
    const auto parameters = makeParameters(identity);
    if (!parameters)
        return wrong(FileProblem::OtherFamily, {u"board"_s, u"family"_s}, {});

    ConfigurationFile file;
    file.configuration = Configuration(identity, parameters);
    file.savedAt = QDateTime::fromString(root.value(u"savedAt"_s).toString(), Qt::ISODateWithMs);
    file.reason = root.value(u"reason"_s).toString();
    const int active = root.value(u"activeProfile"_s).toInt(1) - 1;
    if (active < 0 || active >= identity.profileCount)
        return wrong(FileProblem::OutOfRange, {u"activeProfile"_s}, u"1 to %1"_s.arg(identity.profileCount));
    file.configuration.setActiveProfile(active);

    if (const auto read = readBlocks(file.configuration, json, root); !read)
        return tl::unexpected(read.error());
    QStringList names;
    bool areNamed = true;
    for (int profile = 0; profile < profiles.size(); ++profile) {
        const QJsonObject object = profiles[profile].toObject();
        areNamed = areNamed && object.contains(u"name"_s);
        names.append(object.value(u"name"_s).toString());
        const auto read = readValues(file, json, {u"profiles"_s, QString::number(profile), u"values"_s},
                                     object.value(u"values"_s).toObject(), profile);
        if (!read)
            return tl::unexpected(read.error());
    }
    if (!areNamed || root.value(u"missing"_s).toArray().contains(kNames))
        file.configuration.addMissing({0, MissingPart::kProfileNames}, kNotInFile);
    else
        file.configuration.setProfileNames(names);
    if (const auto read
        = readValues(file, json, {u"boardValues"_s}, root.value(u"boardValues"_s).toObject(), active);
        !read)
        return tl::unexpected(read.error());
    return file;
}

Result<void> ConfigurationFile::save(const QString &path, const Configuration &configuration,
                                     const QString &reason)
{
    return writeWhole(path, toJson(configuration, reason, QDateTime::currentDateTimeUtc()),
                      FileKind::Configuration);
}

Result<ConfigurationFile> ConfigurationFile::load(const QString &path, const MakeParameters &makeParameters)
{
    const auto json = readWhole(path, FileKind::Configuration, kLargestFile);
    if (!json)
        return tl::unexpected(json.error());
    auto loaded = fromJson(*json, makeParameters);
    if (!loaded)
        return tl::unexpected(inFile(loaded.error(), path));
    return loaded;
}

Configuration applied(const Configuration &board, const Configuration &file, QStringList &skipped,
                      AppliedFor purpose, const QStringList &missingKeys)
{
    Configuration result = board;
    for (const ParameterSpec &spec : file.parameters().all()) {
        if (spec.row->state || missingKeys.contains(spec.key))
            continue;
        const ParameterSpec *own = board.parameters().find(spec.key);
        const bool boardWide = spec.row->scope == Scope::Board;
        for (int profile = 0; profile < board.identity().profileCount; ++profile) {
            const auto raw = file.raw(spec, boardWide ? file.activeProfile() : profile);
            if (!raw) {
                if (boardWide)
                    break;
                continue;  // another profile may have it
            }
            if (own && board.findMissing(*own, profile))
                continue;  // told as a part
            const auto taken = own ? take(result, *own, profile, board, spec, *raw, purpose)
                                   : failure(ErrorCode::Unsupported, spec.key);
            if (!taken) {
                if (!skipped.contains(taken.error().detail))
                    skipped.append(taken.error().detail);
                if (!own)
                    break;
            }
            if (boardWide)
                break;
        }
    }
    for (const auto &[key, bytes] : file.blocks()) {
        const BlockSpec *spec = file.parameters().block(key.block);
        if (!spec || !spec->isData() || key.profile >= board.identity().profileCount)
            continue;
        const auto held = board.blocks().find(key);
        if (held != board.blocks().end() && held->second == bytes)
            continue;
        // Code depends on the firmware it was made for; a text does not.
        const BlockSpec *own = board.parameters().block(key.block);
        const bool fits = spec->isText() || file.parameters().firmware() == board.parameters().firmware();
        if (fits && own && own->kind == spec->kind && own->holds(bytes.size())
            && held != board.blocks().end())
            result.setBlock(key, bytes);
        else
            skipped.append(QLatin1String(spec->data));
    }
    if (!file.profileNames().isEmpty()) {
        if (board.findMissing({0, MissingPart::kProfileNames}))
            skipped.append(u"profile names"_s);
        else
            result.setProfileNames(file.profileNames()
                                   + board.profileNames().mid(file.profileNames().size()));
    }
    return result;
}

Configuration applied(const Configuration &board, const ConfigurationFile &file, QStringList &skipped)
{
    return applied(board, file.configuration, skipped, AppliedFor::Writing, file.missingKeys);
}
