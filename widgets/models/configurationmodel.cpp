// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/configurationmodel.h"

#include <QSet>

#include <tuple>
#include <utility>

using namespace Qt::StringLiterals;

ConfigurationModel::ConfigurationModel(QObject *parent)
    : QObject(parent)
{
}

void ConfigurationModel::reset(Configuration board)
{
    // Views of the old board refer to its parameters until they are notified; until then these must live.
    const auto keep = m_board.parameterSet();
    m_board = std::move(board);
    m_edited = m_board;
    m_shownProfile = m_board.activeProfile();
    emit boardReset();
    emit shownProfileChanged(m_shownProfile);
    recount();
}

bool ConfigurationModel::rebase(Configuration board)
{
    if (m_board.isEmpty() || board.identity().serial != m_board.identity().serial
        || board.identity().firmwareNumber != m_board.identity().firmwareNumber)
        return false;
    const auto keep = m_board.parameterSet();
    const auto edits = m_board.changesTo(m_edited);
    const auto data = m_board.dataChangesTo(m_edited);
    const Configuration before = m_board;
    const QStringList names = m_edited.profileNames();
    const int shown = m_shownProfile;
    m_board = std::move(board);
    m_edited = m_board;
    for (const ParameterChange &edit : edits) {
        // The new parameter set is another object, so the parameter is found by its key.
        if (const ParameterSpec *spec = m_board.parameters().find(edit.spec->key))
            std::ignore = m_edited.restoreRaw(*spec, edit.profile, edit.to);
    }
    for (const DataChange &edit : data) {
        if (m_board.blocks().contains(edit.key))
            m_edited.setBlock(edit.key, edit.to);
    }
    keepNames(before, names);
    m_shownProfile = shown;
    emit boardReset();
    recount();
    return true;
}

void ConfigurationModel::setBoard(const Configuration &board)
{
    const auto keep = m_board.parameterSet();
    const auto edits = m_board.changesTo(m_edited);
    const auto data = m_board.dataChangesTo(m_edited);
    const Configuration before = std::exchange(m_board, board);
    const QStringList names = m_edited.profileNames();
    m_edited = m_board;
    keepNames(before, names);
    for (const ParameterChange &edit : edits)
        std::ignore = m_edited.restoreRaw(*edit.spec, edit.profile, edit.to);
    for (const DataChange &edit : data)
        m_edited.setBlock(edit.key, edit.to);
    // Also what was no edit: the board may hold something else than was known.
    for (const auto &changes : {edits, before.changesTo(m_board)}) {
        for (const ParameterChange &change : changes)
            emit valueChanged(change.spec->id, change.profile);
    }
    for (const auto &changes : {data, before.dataChangesTo(m_board)}) {
        for (const DataChange &change : changes)
            emit dataChanged(change.key.block, change.key.profile);
    }
    recount();
    emit profileNamesChanged();
    emit storedChanged();
}

// Only names that were edited stay as they are; the others are the board's.
void ConfigurationModel::keepNames(const Configuration &before, const QStringList &edited)
{
    QStringList names = m_board.profileNames();
    bool any = false;
    for (int profile = 0; profile < m_board.identity().profileCount; ++profile) {
        if (edited.value(profile) == before.profileNames().value(profile))
            continue;
        any = true;
        while (names.size() <= profile)
            names.append(QString());
        names[profile] = edited.value(profile);
    }
    if (any)
        m_edited.setProfileNames(names);
}

void ConfigurationModel::setActiveProfile(int profile)
{
    if (profile == m_board.activeProfile() || profile < 0 || profile >= m_board.identity().profileCount)
        return;
    m_board.setActiveProfile(profile);
    m_edited.setActiveProfile(profile);
    emit activeProfileChanged(profile);
    setShownProfile(profile);
}

void ConfigurationModel::setShownProfile(int profile)
{
    if (profile == m_shownProfile || profile < 0 || profile >= m_board.identity().profileCount)
        return;
    m_shownProfile = profile;
    emit shownProfileChanged(profile);
}

std::optional<double> ConfigurationModel::value(const ParameterSpec &spec, int profile) const
{
    return m_edited.raw(spec, profile);
}

std::optional<double> ConfigurationModel::boardValue(const ParameterSpec &spec, int profile) const
{
    return m_board.raw(spec, profile);
}

bool ConfigurationModel::isChanged(const ParameterSpec &spec, int profile) const
{
    return !spec.row->state && !sameValue(m_board.raw(spec, profile), m_edited.raw(spec, profile));
}

Result<void> ConfigurationModel::setValue(const ParameterSpec &spec, int profile, double raw)
{
    if (sameValue(m_edited.raw(spec, profile), raw))
        return {};
    return taken(sameValue(m_board.raw(spec, profile), raw) ? m_edited.copyRaw(spec, profile, m_board)
                                                            : m_edited.setRaw(spec, profile, raw),
                 spec, profile);
}

Result<void> ConfigurationModel::restoreValue(const ParameterSpec &spec, int profile, double raw)
{
    if (sameValue(m_edited.raw(spec, profile), raw))
        return {};
    return taken(sameValue(m_board.raw(spec, profile), raw) ? m_edited.copyRaw(spec, profile, m_board)
                                                            : m_edited.restoreRaw(spec, profile, raw),
                 spec, profile);
}

Result<void> ConfigurationModel::taken(const Result<void> &set, const ParameterSpec &spec, int profile)
{
    if (!set)
        return set;
    emit valueChanged(spec.id, profile);
    recount();
    return {};
}

void ConfigurationModel::setProfileName(int profile, const QString &name)
{
    QStringList names = m_edited.profileNames();
    names.resize(m_edited.identity().profileCount);
    if (names[profile] == name)
        return;
    names[profile] = name;
    m_edited.setProfileNames(names);
    recount();
    emit profileNamesChanged();
}

Result<void> ConfigurationModel::setData(BlockKey key, const QByteArray &bytes)
{
    if (!m_edited.blocks().contains(key))
        return failure(ErrorCode::Unsupported, QString::number(key.block));
    if (const BlockSpec *spec = m_edited.parameters().block(key.block); spec && !spec->holds(bytes.size()))
        return failure(ErrorCode::OutOfRange,
                       u"%1: %2 bytes"_s.arg(QLatin1String(spec->name)).arg(bytes.size()));
    if (m_edited.block(key) == bytes)
        return {};
    m_edited.setBlock(key, bytes);
    emit dataChanged(key.block, key.profile);
    recount();
    return {};
}

QMap<int, int> ConfigurationModel::changesByProfile() const
{
    QMap<int, int> counts;
    for (const ParameterChange &change : changes())
        ++counts[change.spec->row->scope == Scope::Profile ? change.profile : kAllProfiles];
    if (const int others = int(dataChanges().size()) + (namesChanged() ? 1 : 0))
        counts[kAllProfiles] += others;
    return counts;
}

void ConfigurationModel::recount()
{
    const int count = int(changes().size() + dataChanges().size()) + (namesChanged() ? 1 : 0);
    if (count == m_changeCount)
        return;
    m_changeCount = count;
    emit changeCountChanged(count);
}
