// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/profilemodel.h"

#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <utility>

ProfileModel::ProfileModel(ConfigurationModel &configuration, QObject *parent)
    : TableModel({tr("No."), tr("Name"), tr("State"), tr("Changes"), tr("Against the active profile")},
                 parent)
    , m_configuration(configuration)
{
    connect(&configuration, &ConfigurationModel::boardReset, this,
            [this] { resetWith([this] { refresh(); }); });
    const auto changed = [this] {
        refresh();
        tellAllChanged(0, ColumnCount - 1);
    };
    connect(&configuration, &ConfigurationModel::profileNamesChanged, this, changed);
    connect(&configuration, &ConfigurationModel::activeProfileChanged, this, changed);
    connect(&configuration, &ConfigurationModel::changeCountChanged, this, changed);
    connect(&configuration, &ConfigurationModel::storedChanged, this, changed);
    refresh();
}

void ProfileModel::refresh()
{
    m_changes.assign(
        std::size_t(m_configuration.isEmpty() ? 0 : m_configuration.edited().identity().profileCount), 0);
    m_differences.assign(m_changes.size(), 0);
    if (m_configuration.isEmpty())
        return;
    for (const ParameterChange &change : m_configuration.changes()) {
        if (std::size_t(change.profile) < m_changes.size())
            ++m_changes[std::size_t(change.profile)];
    }
    for (std::size_t profile = 0; profile < m_changes.size(); ++profile)
        m_differences[profile] = differences(int(profile));
}

int ProfileModel::differences(int profile) const
{
    const Configuration &edited = m_configuration.edited();
    int count = 0;
    for (const ParameterSpec &spec : edited.parameters().all()) {
        if (spec.row->scope == Scope::Profile && !spec.row->state)
            count += !sameValue(edited.raw(spec, profile), edited.raw(spec, edited.activeProfile()));
    }
    return count;
}

QVariant ProfileModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const int profile = index.row();
    const Configuration &edited = m_configuration.edited();
    if (role == Qt::EditRole && index.column() == NameColumn)
        return edited.profileNames().value(profile);
    if (role == Qt::TextAlignmentRole && index.column() == NumberColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case NumberColumn: return profile + 1;
    case NameColumn:
        return m_configuration.canRename() || !edited.profileNames().value(profile).isEmpty()
            ? profileLabel(edited, profile)
            : tr("not read");
    case StateColumn: return profile == edited.activeProfile() ? tr("● active") : QString();
    case ChangesColumn: {
        const bool renamed = m_configuration.edited().profileNames().value(profile)
            != std::as_const(m_configuration).board().profileNames().value(profile);
        const int count = m_changes[std::size_t(profile)] + (renamed ? 1 : 0);
        return count > 0 ? tr("%n unwritten", nullptr, count) : QString();
    }
    case DifferenceColumn: {
        if (profile == edited.activeProfile())
            return QString();
        const int count = m_differences[std::size_t(profile)];
        return count > 0 ? tr("differs in %n value(s)", nullptr, count) : tr("same values");
    }
    default: return {};
    }
}

bool ProfileModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || index.column() != NameColumn || !m_configuration.canRename())
        return false;
    // What was pasted may have line breaks; the field showed them as spaces.
    QString name = value.toString();
    std::replace_if(
        name.begin(), name.end(), [](QChar letter) { return letter.category() == QChar::Other_Control; },
        u' ');
    name = name.trimmed();
    if (name.toUtf8().size() > m_nameLimit) {
        emit nameRefused(index.row(), name, m_nameLimit);
        return false;
    }
    emit renameRequested(index.row(), name);
    return true;
}

Qt::ItemFlags ProfileModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModel::flags(index);
    if (index.isValid() && index.column() == NameColumn && m_configuration.canRename())
        flags |= Qt::ItemIsEditable;
    return flags;
}
