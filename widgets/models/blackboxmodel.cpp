// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/blackboxmodel.h"

#include "widgets/models/numbertext.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kTimeDecimals = 6;
constexpr double kTicksPerSecond = 1e6;

}  // namespace

BlackBoxModel::BlackBoxModel(QObject *parent)
    : QAbstractTableModel(parent)
{
}

void BlackBoxModel::setBox(std::shared_ptr<const BlackBox> box)
{
    beginResetModel();
    m_box = std::move(box);
    m_linesOf.assign(m_box ? std::size_t(m_box->names().size()) : 0, {});
    for (int line = 0; m_box && line < int(m_box->lines().size()); ++line)
        m_linesOf[std::size_t(m_box->lines()[std::size_t(line)].name)].push_back(line);
    fill();
    endResetModel();
}

void BlackBoxModel::setFilter(const QString &words)
{
    const QStringList wanted = words.toLower().split(u' ', Qt::SkipEmptyParts);
    if (wanted == m_words)
        return;
    beginResetModel();
    m_words = wanted;
    fill();
    endResetModel();
}

void BlackBoxModel::fill()
{
    m_names.clear();
    m_rows.clear();
    if (!m_box)
        return;
    std::vector<bool> isShown(std::size_t(m_box->names().size()), false);
    for (int name = 0; name < int(m_box->names().size()); ++name) {
        const QString text = QString::fromLatin1(m_box->names()[name]).toLower();
        isShown[std::size_t(name)] = std::all_of(
            m_words.begin(), m_words.end(), [&text](const QString &word) { return text.contains(word); });
        if (isShown[std::size_t(name)])
            m_names.push_back(name);
    }
    for (int line = 0; line < int(m_box->lines().size()); ++line) {
        if (isShown[std::size_t(m_box->lines()[std::size_t(line)].name)])
            m_rows.push_back(line);
    }
}

int BlackBoxModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int BlackBoxModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_box ? 0 : int(m_names.size()) + 1;
}

int BlackBoxModel::columnOf(const QByteArray &name) const
{
    for (std::size_t column = 0; column < m_names.size(); ++column) {
        if (m_box->names()[m_names[column]] == name)
            return int(column) + 1;
    }
    return -1;
}

// The line in force there: this row's own, or the last one of that name before it; -1: none yet.
int BlackBoxModel::lineFor(const QModelIndex &index) const
{
    const auto &lines = m_linesOf[std::size_t(m_names[std::size_t(index.column() - 1)])];
    const auto later = std::upper_bound(lines.begin(), lines.end(), m_rows[std::size_t(index.row())]);
    return later == lines.begin() ? -1 : *std::prev(later);
}

bool BlackBoxModel::isChanged(int line) const
{
    const BlackBox::Line &written = m_box->lines()[std::size_t(line)];
    const auto &lines = m_linesOf[std::size_t(written.name)];
    const auto here = std::lower_bound(lines.begin(), lines.end(), line);
    return here != lines.begin()
        && m_box->value(written) != m_box->value(m_box->lines()[std::size_t(*std::prev(here))]);
}

int BlackBoxModel::nextChange(int row, int column) const
{
    for (int next = row + 1; next < rowCount(); ++next) {
        const int line = m_rows[std::size_t(next)];
        const bool isWanted = column <= kTimeColumn
            || m_names[std::size_t(column - 1)] == m_box->lines()[std::size_t(line)].name;
        if (isWanted && isChanged(line))
            return next;
    }
    return -1;
}

QVariant BlackBoxModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (index.column() == kTimeColumn) {
        const qint64 at = m_box->lines()[std::size_t(m_rows[std::size_t(index.row())])].at;
        const double seconds = double(at - m_box->lines().front().at) / kTicksPerSecond;
        if (role == Qt::TextAlignmentRole)
            return int(Qt::AlignRight | Qt::AlignVCenter);
        return role == Qt::DisplayRole ? QVariant(numberText(seconds, kTimeDecimals)) : QVariant();
    }
    const int line = lineFor(index);
    const bool isWritten = line == m_rows[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return line < 0 ? QVariant()
                        : QVariant(QString::fromUtf8(m_box->value(m_box->lines()[std::size_t(line)])));
    case ChangedRole: return isWritten && isChanged(line);
    case WrittenRole: return isWritten;
    // State is never told by a colour alone, nor to the eye alone.
    case Qt::AccessibleDescriptionRole:
        return isWritten && isChanged(line) ? QVariant(tr("changed")) : QVariant();
    default: return {};
    }
}

QVariant BlackBoxModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section < 0 || section >= columnCount())
        return QAbstractTableModel::headerData(section, orientation, role);
    return section == kTimeColumn ? tr("Time, s")
                                  : QString::fromLatin1(m_box->names()[m_names[std::size_t(section - 1)]]);
}
