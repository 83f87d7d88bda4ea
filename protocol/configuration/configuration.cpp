// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/configuration.h"

#include "protocol/configuration/scriptmistake.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

Configuration::Configuration(BoardIdentity identity, std::shared_ptr<const ParameterSet> parameters)
    : m_identity(std::move(identity))
    , m_parameters(std::move(parameters))
{
}

void Configuration::setProfileNames(const QStringList &names)
{
    m_profileNames = names;
    std::erase_if(m_missing,
                  [](const MissingPart &part) { return part.key.block == MissingPart::kProfileNames; });
}

void Configuration::setBlock(BlockKey key, QByteArray bytes)
{
    m_blocks[key] = std::move(bytes);
    std::erase_if(m_missing, [key](const MissingPart &part) { return part.key == key; });
}

void Configuration::addMissing(BlockKey key, const Error &why)
{
    if (!findMissing(key))
        m_missing.push_back({key, why});
}

const MissingPart *Configuration::findMissing(BlockKey key) const
{
    const auto it = std::find_if(m_missing.begin(), m_missing.end(),
                                 [key](const MissingPart &part) { return part.key == key; });
    return it == m_missing.end() ? nullptr : &*it;
}

const MissingPart *Configuration::findMissing(const ParameterSpec &spec, int profile) const
{
    return findMissing({spec.row->scope == Scope::Board ? m_activeProfile : profile, spec.row->block});
}

QString Configuration::blockName(int block) const
{
    const BlockSpec *spec = m_parameters ? m_parameters->block(block) : nullptr;
    return spec ? QLatin1String(spec->name) : u"block %1"_s.arg(block);
}

QString Configuration::partName(BlockKey key) const
{
    if (key.block == MissingPart::kProfileNames)
        return u"profile names"_s;
    const QString name = blockName(key.block);
    return m_identity.profileCount > 1 ? u"%1 of profile %2"_s.arg(name).arg(key.profile + 1) : name;
}

QStringList Configuration::missingNames() const
{
    QStringList names;
    for (const MissingPart &part : m_missing)
        names.append(partName(part.key));
    return names;
}

QString Configuration::profileName(int profile) const
{
    const QString name = m_profileNames.value(profile).trimmed();
    return name.isEmpty() ? u"Profile %1"_s.arg(profile + 1) : name;
}

bool Configuration::hasOtherNames(const Configuration &other) const
{
    const qsizetype count = std::max(m_profileNames.size(), other.m_profileNames.size());
    for (qsizetype profile = 0; profile < count; ++profile) {
        if (m_profileNames.value(profile) != other.m_profileNames.value(profile))
            return true;
    }
    return false;
}

QByteArray Configuration::block(BlockKey key) const
{
    const auto it = m_blocks.find(key);
    return it == m_blocks.end() ? QByteArray() : it->second;
}

std::optional<double> Configuration::raw(const ParameterSpec &spec, int profile) const
{
    const int from = spec.row->scope == Scope::Board ? m_activeProfile : profile;
    const auto it = m_blocks.find({from, spec.row->block});
    return it == m_blocks.end() ? std::nullopt : spec.read(it->second);
}

Result<void> Configuration::setRaw(const ParameterSpec &spec, int profile, double raw)
{
    if (spec.row->state)
        return failure(ErrorCode::ReadOnly, spec.key);
    if (spec.row->wire != WireType::F32 && std::isfinite(raw) && raw != spec.nearest(raw))
        return failure(ErrorCode::InvalidArgument, u"%1 counts in whole steps"_s.arg(spec.key));
    if (!spec.accepts(raw, this->raw(spec, profile))) {
        return failure(ErrorCode::OutOfRange,
                       u"%1 = %2, allowed %3"_s.arg(spec.key, spec.format(raw), spec.allowedText()));
    }
    return put(spec, profile, raw);
}

Result<void> Configuration::restoreRaw(const ParameterSpec &spec, int profile, double raw)
{
    if (spec.row->state)
        return failure(ErrorCode::ReadOnly, spec.key);
    QByteArray trial(spec.offset + wireSize(spec.row->wire), '\0');
    if (!spec.write(trial, raw) || !sameValue(spec.read(trial), spec.nearest(raw)))
        return failure(ErrorCode::OutOfRange, u"%1 = %2"_s.arg(spec.key, spec.format(raw)));
    return put(spec, profile, raw);
}

Result<void> Configuration::put(const ParameterSpec &spec, int profile, double raw)
{
    bool found = false;
    for (auto &[key, bytes] : m_blocks) {
        if (key.block == spec.row->block && (spec.row->scope == Scope::Board || key.profile == profile))
            found |= spec.write(bytes, raw);
    }
    if (!found)
        return failure(ErrorCode::Unsupported, spec.key);
    return {};
}

Result<void> Configuration::copyRaw(const ParameterSpec &spec, int profile, const Configuration &from)
{
    if (spec.row->state)
        return failure(ErrorCode::ReadOnly, spec.key);
    const bool boardWide = spec.row->scope == Scope::Board;
    const QByteArray source = from.block({boardWide ? from.activeProfile() : profile, spec.row->block});
    bool found = false;
    for (auto &[key, bytes] : m_blocks) {
        if (key.block == spec.row->block && (boardWide || key.profile == profile))
            found |= spec.copy(bytes, source);
    }
    if (!found)
        return failure(ErrorCode::Unsupported, spec.key);
    return {};
}

std::optional<double> Configuration::startsWith(const ParameterSpec &spec) const
{
    return spec.row->startsWith ? spec.row->startsWith(*this, spec) : std::nullopt;
}

std::optional<bool> Configuration::usesUnstored() const
{
    if (isEmpty())
        return {};
    int told = 0;
    int untold = 0;
    for (const ParameterSpec &spec : parameters().all()) {
        if (!spec.row->startsWith)
            continue;
        const auto first = startsWith(spec);
        if (first && raw(spec, 0) != first)
            return true;
        ++(first ? told : untold);
    }
    return told > 0 && untold == 0 ? std::optional(false) : std::nullopt;
}

std::optional<double> Configuration::textFigure(const ParameterSpec &spec, double raw) const
{
    return spec.row->textFigure && std::isfinite(raw) ? spec.row->textFigure(*this, spec, raw) : std::nullopt;
}

// A rule that is not about two parameters which this board has is not broken.
bool Configuration::isBroken(const ValueRule &rule, int profile) const
{
    const ParameterSpec *first = m_parameters->find(QLatin1String(rule.first));
    const ParameterSpec *second = m_parameters->find(QLatin1String(rule.second));
    if (!first || (!second && *rule.second))
        return false;
    const auto a = raw(*first, profile);
    const auto b = second ? raw(*second, profile) : 0;
    return a && b && rule.isBroken(*a, *b);
}

Configuration::Contradiction Configuration::findContradiction(const ParameterSpec &spec, int profile) const
{
    if (!m_parameters)
        return {};
    for (const ValueRule &rule : m_parameters->rules()) {
        if (rule.concerns(spec.key) && isBroken(rule, profile))
            return {&rule,
                    m_parameters->find(
                        QLatin1String(spec.key == QLatin1String(rule.first) ? rule.second : rule.first))};
    }
    return {};
}

Result<void> Configuration::checkRules(const Configuration &held) const
{
    if (!m_parameters)
        return {};
    for (const ValueRule &rule : m_parameters->rules()) {
        for (int profile = 0; profile < m_identity.profileCount; ++profile) {
            if (!isBroken(rule, profile))
                continue;
            QStringList values;
            bool isNew = false;
            for (const char *key : {rule.first, rule.second}) {
                const ParameterSpec *spec = m_parameters->find(QLatin1String(key));
                if (!spec)
                    continue;
                const auto value = raw(*spec, profile);
                values.append(u"%1 = %2"_s.arg(spec->key, spec->format(*value)));
                isNew |= !sameValue(held.raw(*spec, profile), value);
            }
            if (isNew)
                return failure(ErrorCode::Contradiction,
                               u"%1: %2"_s.arg(values.join(u" and "_s), QLatin1String(rule.why)));
        }
    }
    for (const BlockSpec &block : m_parameters->blocks()) {
        const QByteArray text = block.isText() && block.check ? this->block({0, block.id}) : QByteArray();
        if (text.isEmpty() || text == held.block({0, block.id}))
            continue;
        if (const auto mistake = block.check(text)) {
            const QString sentence = mistake->sentence(QString::fromUtf8(mistake->what));
            Error error{ErrorCode::InvalidArgument, u"%1: %2"_s.arg(QLatin1String(block.data), sentence), 0};
            if (mistake->line > 0)
                error.detail
                    = u"%1, line %2: %3"_s.arg(QLatin1String(block.data)).arg(mistake->line).arg(sentence);
            error.place = TextPlace{block.id, mistake->line};
            return tl::unexpected(error);
        }
    }
    return {};
}

std::vector<ParameterChange> Configuration::changesTo(const Configuration &other) const
{
    std::vector<ParameterChange> changes;
    if (!m_parameters)
        return changes;
    for (const ParameterSpec &spec : m_parameters->all()) {
        if (spec.row->state)
            continue;
        const bool boardWide = spec.row->scope == Scope::Board;
        for (int profile = 0; profile < m_identity.profileCount; ++profile) {
            const int which = boardWide ? m_activeProfile : profile;
            const auto from = raw(spec, which);
            const auto to = other.raw(spec, which);
            if (from && to && !sameValue(*from, *to))
                changes.push_back({&spec, which, *from, *to});
            if (boardWide)
                break;
        }
    }
    return changes;
}

std::vector<DataChange> Configuration::dataChangesTo(const Configuration &other) const
{
    std::vector<DataChange> changes;
    for (const auto &[key, bytes] : m_blocks) {
        const BlockSpec *spec = m_parameters->block(key.block);
        const auto it = other.m_blocks.find(key);
        if (spec && spec->isData() && it != other.m_blocks.end() && it->second != bytes)
            changes.push_back({spec, key, bytes, it->second});
    }
    return changes;
}
