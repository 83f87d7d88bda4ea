// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/filtertable.h"

#include "widgets/forms/celldelegate.h"
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QShortcut>
#include <QSortFilterProxyModel>

#include <algorithm>

namespace {

/// All words must be there, in any order.
class WordFilter final : public QSortFilterProxyModel
{
public:
    WordFilter(int role, QObject *parent)
        : QSortFilterProxyModel(parent)
        , m_role(role)
    {
    }

    void setWords(const QStringList &words)
    {
        m_words = words;
        invalidateFilter();
    }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        if (m_words.isEmpty())
            return true;
        const QString text = sourceModel()->index(row, 0, parent).data(m_role).toString();
        return std::all_of(m_words.begin(), m_words.end(),
                           [&text](const QString &word) { return text.contains(word); });
    }

private:
    int m_role;
    QStringList m_words;
};

}  // namespace

FilterTable::FilterTable(QAbstractItemModel &model, int searchRole, const Theme &theme, QWidget *parent)
    : QTableView(parent)
    , m_proxy(new WordFilter(searchRole, this))
{
    m_proxy->setSourceModel(&model);
    setModel(m_proxy);
    setItemDelegate(new CellDelegate(theme, this));
    setSelectableRows(*this);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
    setAlternatingRowColors(true);
    setWordWrap(false);
    horizontalHeader()->setStretchLastSection(true);
}

QLineEdit *FilterTable::makeFilterField(const QString &placeholder, const QString &name, QWidget *page)
{
    auto *field = new QLineEdit;
    field->setPlaceholderText(placeholder);
    field->setAccessibleName(name);
    field->setClearButtonEnabled(true);
    connect(field, &QLineEdit::textChanged, this, &FilterTable::setFilter);
    new QShortcut(QKeySequence::Find, page, [field] { field->setFocus(); });
    return field;
}

void FilterTable::setFilter(const QString &words)
{
    static_cast<WordFilter *>(m_proxy)->setWords(words.toLower().split(u' ', Qt::SkipEmptyParts));
}

QModelIndex FilterTable::toSource(const QModelIndex &shown) const
{
    return m_proxy->mapToSource(shown);
}

QModelIndex FilterTable::fromSource(const QModelIndex &source) const
{
    return m_proxy->mapFromSource(source);
}
