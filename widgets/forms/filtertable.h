// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

class QLineEdit;
class QSortFilterProxyModel;
class Theme;

/// A table over a model with a search in the model's own search role; columns keep their place.
class FilterTable final : public QTableView
{
    Q_OBJECT
public:
    /// @param searchRole role with lower-case text to look in
    FilterTable(QAbstractItemModel &model, int searchRole, const Theme &theme, QWidget *parent = nullptr);

    /// A field that filters the table; Ctrl+F anywhere on the page goes there.
    [[nodiscard]] QLineEdit *makeFilterField(const QString &placeholder, const QString &name, QWidget *page);
    /// Shows only rows that hold all of these words.
    void setFilter(const QString &words);
    [[nodiscard]] bool isEditing() const { return state() == EditingState; }
    [[nodiscard]] QModelIndex toSource(const QModelIndex &shown) const;
    [[nodiscard]] QModelIndex fromSource(const QModelIndex &source) const;

private:
    QSortFilterProxyModel *m_proxy;
};
