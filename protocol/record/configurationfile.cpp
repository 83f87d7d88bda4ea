// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/configurationfile.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

const QString kFormat = u"gimbaldesk-configuration"_s;
const QString kNames = u"names"_s;  // among the missing parts
const Error kNotInFile{ErrorCode::Incomplete, u"not in the file"_s, 0};
constexpr int kVersion = 1;
constexpr qint64 kLargestFile = 4 * 1024 * 1024;

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
    return known == raw || rounded;
}

// Puts a file's values into a configuration. A value that the blocks already hold exactly is left alone, so
// rounding in the text never changes a byte.
Result<void> readValues(Configuration &configuration, const QJsonObject &values, int profile,
                        QStringList &unknown)
{
    for (auto it = values.begin(); it != values.end(); ++it) {
        const ParameterSpec *spec = configuration.parameters().find(it.key());
        if (!spec) {
            if (!unknown.contains(it.key()))
                unknown.append(it.key());
            continue;
        }
        const auto known = configuration.raw(*spec, profile);
        if (it.value().isNull() && known && std::isnan(*known))
            continue;
        const auto raw = rawOf(*spec, it.value());
        if (!raw) {
            return failure(
                ErrorCode::BadFile,
                u"the value of %1 is not understood: %2"_s.arg(
                    it.key(), it.value().isNull() ? u"null"_s : it.value().toVariant().toString()));
        }
        if (known && isKnown(*spec, *known, it.value(), *raw))
            continue;
        if (const auto set = configuration.setRaw(*spec, profile, *raw); !set)
            return failure(ErrorCode::BadFile, set.error().detail);
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

// ", value of KEY" if the text before that byte ends in a key: a number as large as 1e999 is not valid JSON.
QString entryAt(const QByteArray &json, int offset)
{
    static const QRegularExpression key(u"\"([^\"]*)\"\\s*:[^\":,]*$"_s);
    const auto match = key.match(QString::fromUtf8(json.left(offset)));
    return match.hasMatch() ? u", value of %1"_s.arg(match.captured(1)) : QString();
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
Result<void> readBlocks(Configuration &configuration, const QJsonObject &root)
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
            const QByteArray bytes = QByteArray::fromHex(blocks.value(name).toString().toLatin1());
            // Parameter blocks may have grown since; data blocks are taken as a whole or not at all.
            if (bytes.size() < block.size || (block.isData() && !block.holds(bytes.size()))) {
                return failure(ErrorCode::BadFile,
                               u"block %1 has %2 of %3 bytes"_s.arg(name).arg(bytes.size()).arg(block.size));
            }
            configuration.setBlock({profile, block.id}, bytes);
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
    if (!document.isObject()) {
        return failure(ErrorCode::BadFile,
                       u"not JSON (%1 at byte %2%3)"_s.arg(parse.errorString())
                           .arg(parse.offset)
                           .arg(entryAt(json, parse.offset)));
    }
    const QJsonObject root = document.object();
    if (root.value(u"format"_s).toString() != kFormat)
        return failure(ErrorCode::BadFile, u"not a GimbalDesk configuration"_s);
    if (root.value(u"version"_s).toInt() != kVersion) {
        return failure(ErrorCode::BadFile,
                       u"version %1 of the file format, this program knows version %2"_s
                           .arg(root.value(u"version"_s).toInt())
                           .arg(kVersion));
    }

    const BoardIdentity identity = identityFrom(root.value(u"board"_s).toObject());
    const auto parameters = makeParameters(identity);
    if (!parameters)
        return failure(ErrorCode::BadFile,
                       u"a configuration of the unknown family '%1'"_s.arg(identity.family));

    ConfigurationFile file;
    const QJsonArray profiles = root.value(u"profiles"_s).toArray();
    if (identity.profileCount < 1 || identity.profileCount > 32 || profiles.size() > identity.profileCount)
        return failure(ErrorCode::BadFile, u"%1 profiles"_s.arg(profiles.size()));
    file.configuration = Configuration(identity, parameters);
    file.savedAt = QDateTime::fromString(root.value(u"savedAt"_s).toString(), Qt::ISODateWithMs);
    file.reason = root.value(u"reason"_s).toString();
    const int active = root.value(u"activeProfile"_s).toInt(1) - 1;
    if (active < 0 || active >= identity.profileCount)
        return failure(ErrorCode::BadFile, u"active profile %1"_s.arg(active + 1));
    file.configuration.setActiveProfile(active);

    if (const auto read = readBlocks(file.configuration, root); !read)
        return tl::unexpected(read.error());
    QStringList names;
    for (int profile = 0; profile < profiles.size(); ++profile) {
        const QJsonObject object = profiles[profile].toObject();
        names.append(object.value(u"name"_s).toString());
        if (const auto read
            = readValues(file.configuration, object.value(u"values"_s).toObject(), profile, file.unknownKeys);
            !read)
            return tl::unexpected(read.error());
    }
    if (root.value(u"missing"_s).toArray().contains(kNames))
        file.configuration.addMissing({0, MissingPart::kProfileNames}, kNotInFile);
    else
        file.configuration.setProfileNames(names);
    if (const auto read
        = readValues(file.configuration, root.value(u"boardValues"_s).toObject(), active, file.unknownKeys);
        !read)
        return tl::unexpected(read.error());
    return file;
}

Result<void> ConfigurationFile::save(const QString &path, const Configuration &configuration,
                                     const QString &reason)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)
        || file.write(toJson(configuration, reason, QDateTime::currentDateTimeUtc())) < 0 || !file.commit())
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    return {};
}

Result<ConfigurationFile> ConfigurationFile::load(const QString &path, const MakeParameters &makeParameters)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    if (file.size() > kLargestFile)
        return failure(ErrorCode::BadFile,
                       u"%1: %2 bytes are too many for a configuration"_s.arg(path).arg(file.size()));
    auto loaded = fromJson(file.readAll(), makeParameters);
    if (!loaded)
        return failure(loaded.error().code, path + u": "_s + loaded.error().detail);
    return loaded;
}

Configuration applied(const Configuration &board, const Configuration &file, QStringList &skipped,
                      AppliedFor purpose)
{
    Configuration result = board;
    for (const ParameterSpec &spec : file.parameters().all()) {
        if (spec.row->state)
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
            result.setProfileNames(file.profileNames());
    }
    return result;
}
