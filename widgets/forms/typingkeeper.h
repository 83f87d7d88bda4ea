// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModelIndex>
#include <QObject>
#include <QVariant>

#include <functional>
#include <optional>

class QAbstractItemView;
class QWidget;

/// What stands half typed in a cell of a table stays there when the table is filled anew for the same board.
/// Belongs to the table.
class TypingKeeper final : public QObject
{
    Q_OBJECT
public:
    /// @param idRole what a row is about, before and after
    /// @param board whose values the table shows
    TypingKeeper(QAbstractItemView &view, int idRole, std::function<QString()> board);

private:
    struct Typed
    {
        QVariant id;
        int column = 0;
        QString text;
    };

    /// The open field of a cell, of any if none is given; null without one.
    [[nodiscard]] QWidget *fieldOf(const QModelIndex &cell) const;
    void keep();
    void onReset();
    void putBack();

    QAbstractItemView &m_view;
    int m_idRole;
    std::function<QString()> m_boardNow;
    QString m_board;
    std::optional<Typed> m_typed;
};
