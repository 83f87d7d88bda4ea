// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>

class NumberBox;
class QLineEdit;

/// Cells of a TableModel and what they are edited in: a number in a NumberBox, never in Qt's own fields,
/// which know one decimal mark and drop what they do not take. What is refused stays in its cell, red, and
/// stands in the field again when it is opened; Esc brings the value back.
class CellDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    explicit CellDelegate(const Theme &theme, QObject *parent = nullptr);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const override;
    /// The cell that is edited in a field of this delegate.
    [[nodiscard]] static QModelIndex cellOf(const QWidget &field);
    /// Where it is typed in such a field; null if nothing can be typed.
    [[nodiscard]] static QLineEdit *lineOf(QWidget &field);
    bool helpEvent(QHelpEvent *event, QAbstractItemView *view, const QStyleOptionViewItem &option,
                   const QModelIndex &index) override;

protected:
    /// The field for a cell that holds a number; null for another.
    [[nodiscard]] virtual NumberBox *makeBox(const QModelIndex &index) const;
    virtual void showValue(NumberBox &box, const QModelIndex &index) const;
    [[nodiscard]] const Theme &theme() const { return m_theme; }

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill(NumberBox &box, const QModelIndex &index) const;

    const Theme &m_theme;
};
