// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/celldelegate.h"

#include "widgets/forms/numberbox.h"
#include "widgets/models/tablemodel.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <memory>

namespace {

constexpr int kRefusedFrame = 2;
constexpr const char *kValueShown = "valueShown";  // by a field, before anything is typed
constexpr const char *kCell = "cell";
constexpr const char *kTyped = "typed";

// Finishing a number makes its line forget that it was typed into.
bool isTouched(const QWidget &field)
{
    const auto *box = qobject_cast<const NumberBox *>(&field);
    const QVariant shown = field.property(kValueShown);
    return field.property(kTyped).toBool() || (box && shown.isValid() && box->value() != shown.toDouble());
}

QVariant refusedIn(const QModelIndex &index)
{
    return index.data(TableModel::RefusedRole);
}

}  // namespace

CellDelegate::CellDelegate(const Theme &theme, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_theme(theme)
{
}

void CellDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const QVariant refused = refusedIn(index);
    if (!refused.isValid())
        return;
    option->text = refused.toString();
    for (const QPalette::ColorRole role : {QPalette::Text, QPalette::HighlightedText})
        option->palette.setColor(role, m_theme.color(ColorRole::Danger));
}

void CellDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                         const QModelIndex &index) const
{
    QStyledItemDelegate::paint(painter, option, index);
    if (!refusedIn(index).isValid())
        return;
    painter->save();
    painter->setPen(QPen(m_theme.color(ColorRole::Danger), kRefusedFrame));
    painter->drawRect(option.rect.adjusted(1, 1, -1, -1));
    painter->restore();
}

NumberBox *CellDelegate::makeBox(const QModelIndex &index) const
{
    const QVariant range = index.data(TableModel::NumberRole);
    if (!range.canConvert<NumberRange>())
        return nullptr;
    const auto [low, high, decimals] = range.value<NumberRange>();
    auto *box = new NumberBox(low, high, decimals);
    box->setAlignment(Qt::AlignRight);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return box;
}

// A board may hold a value out of range; it is shown as it is.
void CellDelegate::showValue(NumberBox &box, const QModelIndex &index) const
{
    const double value = index.data(Qt::EditRole).toDouble();
    box.setRange(std::min(box.minimum(), value), std::max(box.maximum(), value));
    box.setValue(value);
}

void CellDelegate::fill(NumberBox &box, const QModelIndex &index) const
{
    showValue(box, index);
    box.setProperty(kValueShown, box.value());
    if (const QVariant refused = refusedIn(index); refused.isValid())
        box.type(refused.toString());
}

QWidget *CellDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                    const QModelIndex &index) const
{
    QWidget *field = makeBox(index);
    if (field)
        field->setParent(parent);
    else if (index.data(Qt::EditRole).userType() == QMetaType::QString)
        field = QStyledItemDelegate::createEditor(parent, option, index);
    if (!field)
        return nullptr;
    field->setProperty(kCell, QVariant::fromValue(QPersistentModelIndex(index)));
    field->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
    if (const QLineEdit *line = lineOf(*field))
        connect(line, &QLineEdit::textEdited, field, [field] { field->setProperty(kTyped, true); });
    return field;
}

void CellDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    QLineEdit *line = lineOf(*editor);
    if (isTouched(*editor) || (line && line->isModified()))
        return;  // what was typed is not replaced by what is read meanwhile
    const bool isSelected = line && line->hasSelectedText() && line->selectedText() == line->text();
    if (auto *box = qobject_cast<NumberBox *>(editor))
        fill(*box, index);
    else
        QStyledItemDelegate::setEditorData(editor, index);
    if (isSelected)
        line->selectAll();  // what is typed next replaces this value as well
}

QLineEdit *CellDelegate::lineOf(QWidget &field)
{
    auto *line = qobject_cast<QLineEdit *>(&field);
    return line ? line : field.findChild<QLineEdit *>();
}

void CellDelegate::setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    auto *box = qobject_cast<NumberBox *>(editor);
    if (!box) {
        QStyledItemDelegate::setModelData(editor, model, index);
        return;
    }
    if (!box->settle()) {
        model->setData(index, box->typed(), TableModel::RefusedRole);
        return;
    }
    const std::unique_ptr<NumberBox> now(makeBox(index));
    if (now)
        showValue(*now, index);
    const bool isOther = isTouched(*box) && !(now && now->value() == box->value());
    model->setData(index, QVariant(), TableModel::RefusedRole);
    if (isOther)
        model->setData(index, box->value());
}

QModelIndex CellDelegate::cellOf(const QWidget &field)
{
    return field.property(kCell).value<QPersistentModelIndex>();
}

void CellDelegate::updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                                        const QModelIndex &index) const
{
    if (qobject_cast<NumberBox *>(editor))
        editor->setGeometry(option.rect);
    else
        QStyledItemDelegate::updateEditorGeometry(editor, option, index);
}

// What is refused does not leave its field by a key.
bool CellDelegate::eventFilter(QObject *watched, QEvent *event)
{
    auto *box = qobject_cast<NumberBox *>(watched);
    if (box && event->type() == QEvent::KeyPress) {
        switch (static_cast<QKeyEvent *>(event)->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Tab:
        case Qt::Key_Backtab:
            if (!box->settle())
                return true;
            break;
        case Qt::Key_Escape: {
            const QModelIndex cell = cellOf(*box);
            if (auto *model = const_cast<QAbstractItemModel *>(cell.model()))
                model->setData(cell, QVariant(), TableModel::RefusedRole);
            break;
        }
        default: break;
        }
    }
    return QStyledItemDelegate::eventFilter(watched, event);
}

bool CellDelegate::helpEvent(QHelpEvent *event, QAbstractItemView *view, const QStyleOptionViewItem &option,
                             const QModelIndex &index)
{
    const std::unique_ptr<NumberBox> box(refusedIn(index).isValid() ? makeBox(index) : nullptr);
    if (!box || event->type() != QEvent::ToolTip)
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    fill(*box, index);
    QToolTip::showText(event->globalPos(), box->advice(), view);
    return true;
}
