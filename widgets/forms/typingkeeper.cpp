// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/typingkeeper.h"

#include "widgets/forms/celldelegate.h"
#include "widgets/forms/numberbox.h"

#include <QAbstractItemView>
#include <QLineEdit>

#include <utility>

TypingKeeper::TypingKeeper(QAbstractItemView &view, int idRole, std::function<QString()> board)
    : QObject(&view)
    , m_view(view)
    , m_idRole(idRole)
    , m_boardNow(std::move(board))
    , m_board(m_boardNow())
{
    const QAbstractItemModel *model = view.model();
    connect(model, &QAbstractItemModel::modelAboutToBeReset, this, &TypingKeeper::keep);
    connect(model, &QAbstractItemModel::modelReset, this, &TypingKeeper::onReset);
    connect(model, &QAbstractItemModel::dataChanged, this, &TypingKeeper::putBack);
}

QWidget *TypingKeeper::fieldOf(const QModelIndex &cell) const
{
    for (QWidget *field : m_view.viewport()->findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        const QModelIndex its = CellDelegate::cellOf(*field);
        if (field->isVisible() && its.isValid() && (!cell.isValid() || its == cell))
            return field;
    }
    return nullptr;
}

void TypingKeeper::keep()
{
    QWidget *field = fieldOf({});
    const QLineEdit *line = field ? CellDelegate::lineOf(*field) : nullptr;
    if (!line || !line->isModified())
        return;
    const auto *box = qobject_cast<NumberBox *>(field);
    const QModelIndex cell = CellDelegate::cellOf(*field);
    m_typed = Typed{cell.siblingAtColumn(0).data(m_idRole), cell.column(), box ? box->typed() : line->text()};
}

void TypingKeeper::onReset()
{
    if (const QString before = std::exchange(m_board, m_boardNow()); before != m_board)
        m_typed.reset();
    if (!m_typed)
        return;
    m_view.setFocus();
    putBack();
}

// At once, or when the value of that cell is there again, unless the operator has gone elsewhere.
void TypingKeeper::putBack()
{
    if (!m_typed || !m_view.hasFocus())
        return;
    const QAbstractItemModel &model = *m_view.model();
    const auto rows = model.match(model.index(0, 0), m_idRole, m_typed->id, 1, Qt::MatchExactly);
    const QModelIndex cell = rows.isEmpty() ? QModelIndex() : rows.first().siblingAtColumn(m_typed->column);
    if (!cell.data(Qt::EditRole).isValid())
        return;
    const Typed typed = *std::exchange(m_typed, std::nullopt);
    m_view.setCurrentIndex(cell);
    m_view.edit(cell);
    QWidget *field = fieldOf(cell);
    if (auto *box = qobject_cast<NumberBox *>(field)) {
        box->goOnTyping(typed.text);
    } else if (QLineEdit *line = field ? CellDelegate::lineOf(*field) : nullptr) {
        line->setText(typed.text);
        line->setModified(true);
    }
}
