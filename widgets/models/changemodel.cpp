// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/changemodel.h"

#include "protocol/configuration/leap.h"
#include "protocol/configuration/linediff.h"
#include "widgets/models/parametermodel.h"

#include <QSet>

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

ChangeModel::ChangeModel(Configuration board, Configuration edited, QObject *parent)
    : TableModel({tr("Parameter"), tr("Profile"), tr("On the board"), tr("New")}, parent)
    , m_board(std::move(board))
    , m_edited(std::move(edited))
{
    for (const ParameterChange &change : m_board.changesTo(m_edited))
        m_rows.push_back({change, {}, true});
    std::stable_partition(m_rows.begin(), m_rows.end(), [this](const Row &row) { return isRed(row); });
    for (const DataChange &change : m_board.dataChangesTo(m_edited))
        m_rows.push_back({{nullptr, change.key.profile, 0, 0}, change, true, linesText(change)});
    for (int profile = 0; profile < m_board.identity().profileCount; ++profile) {
        if (m_board.profileNames().value(profile) != m_edited.profileNames().value(profile))
            m_rows.push_back({{nullptr, profile, 0, 0}, {}, true});
    }
}

bool ChangeModel::isRed(const Row &row) const
{
    return row.change.spec ? row.change.spec->row->risk == Risk::Red
                           : row.data.spec && isOfRiskClass(m_board.parameters(), *row.data.spec);
}

QString ChangeModel::linesText(const DataChange &change) const
{
    if (!change.spec->isText() || m_board.findMissing(change.key))
        return {};
    const auto [added, removed] = countChanges(lineDiff(change.from, change.to));
    return tr("+%1 −%2 lines").arg(added).arg(removed);
}

QVariant ChangeModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[std::size_t(index.row())];
    const ParameterSpec *spec = row.change.spec;
    if (role == Qt::CheckStateRole && index.column() == NameColumn)
        return row.ticked ? Qt::Checked : Qt::Unchecked;
    if (role == RedRole)
        return isRed(row);
    if (role == Qt::ToolTipRole && spec)
        return tableText(spec->row->help);
    if (role == Qt::TextAlignmentRole && index.column() >= BoardColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString mark = isRed(row) ? u"⚠ "_s : QString();
    if (row.data.spec && index.column() != ProfileColumn) {
        return index.column() == NameColumn ? mark + tableText(row.data.spec->data)
            : index.column() == BoardColumn
            ? (m_board.findMissing(row.data.key) ? unknownText() : tr("as on the board"))
            : row.lines.isEmpty() ? tr("changed")
                                  : row.lines;
    }
    switch (index.column()) {
    case NameColumn:
        if (!spec)
            return tr("Profile name");
        return mark + tableText(spec->row->group) + u" · "_s + parameterLabel(*spec);
    case ProfileColumn:
        if (spec && spec->row->scope == Scope::Board)
            return tr("All profiles");
        return profileLabel(m_board, row.change.profile);
    case BoardColumn:
        if (spec ? m_board.findMissing(*spec, row.change.profile)
                 : m_board.findMissing({0, MissingPart::kProfileNames}))
            return unknownText();
        return spec ? parameterQuantityText(*spec, row.change.from)
                    : m_board.profileNames().value(row.change.profile);
    case EditedColumn:
        return spec ? parameterQuantityText(*spec, row.change.to)
                    : m_edited.profileNames().value(row.change.profile);
    default: return {};
    }
}

bool ChangeModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || index.column() != NameColumn)
        return false;
    m_rows[std::size_t(index.row())].ticked = value.toInt() == Qt::Checked;
    emit dataChanged(index, index, {Qt::CheckStateRole});
    emit ticksChanged();
    return true;
}

Qt::ItemFlags ChangeModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModel::flags(index);
    if (index.isValid() && index.column() == NameColumn)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

QVariant ChangeModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section >= BoardColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return TableModel::headerData(section, orientation, role);
}

int ChangeModel::tickedCount() const
{
    return int(std::count_if(m_rows.begin(), m_rows.end(), [](const Row &row) { return row.ticked; }));
}

int ChangeModel::tickedProfiles() const
{
    QSet<int> profiles;
    for (const Row &row : m_rows) {
        if (row.ticked)
            profiles.insert(row.change.profile);
    }
    return int(profiles.size());
}

bool ChangeModel::hasTickedRed() const
{
    return std::any_of(m_rows.begin(), m_rows.end(),
                       [this](const Row &row) { return row.ticked && isRed(row); });
}

std::vector<ParameterChange> ChangeModel::tickedLeaps() const
{
    std::vector<ParameterChange> changes;
    for (const Row &row : m_rows) {
        if (row.ticked && row.change.spec)
            changes.push_back(row.change);
    }
    return leapsAmong(changes);
}

bool ChangeModel::hasTickedText() const
{
    return std::any_of(m_rows.begin(), m_rows.end(),
                       [](const Row &row) { return row.ticked && row.data.spec && row.data.spec->isText(); });
}

bool ChangeModel::hasTicked(WriteEffect effect) const
{
    return std::any_of(m_rows.begin(), m_rows.end(), [&](const Row &row) {
        const BlockSpec *block = row.data.spec;
        if (row.change.spec)
            block = m_board.parameters().block(row.change.spec->row->block);
        return row.ticked && block && block->effect == effect;
    });
}

Configuration ChangeModel::ticked() const
{
    Configuration result = m_board;
    QStringList names = m_board.profileNames();
    names.resize(m_board.identity().profileCount);
    bool renamed = false;
    for (const Row &row : m_rows) {
        if (!row.ticked)
            continue;
        if (row.change.spec) {
            std::ignore = result.copyRaw(*row.change.spec, row.change.profile, m_edited);
        } else if (row.data.spec) {
            result.setBlock(row.data.key, row.data.to);
        } else {
            names[row.change.profile] = m_edited.profileNames().value(row.change.profile);
            renamed = true;
        }
    }
    if (renamed)
        result.setProfileNames(names);
    return result;
}
