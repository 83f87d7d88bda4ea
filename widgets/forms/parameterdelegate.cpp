// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/parameterdelegate.h"

#include "widgets/forms/parameterbox.h"
#include "widgets/models/parametermodel.h"

#include <QComboBox>
#include <QPainter>

namespace {

constexpr int kBar = 4;

}  // namespace

ParameterDelegate::ParameterDelegate(const ConfigurationModel &configuration, const Theme &theme,
                                     QObject *parent)
    : CellDelegate(theme, parent)
    , m_configuration(configuration)
{
}

void ParameterDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    CellDelegate::initStyleOption(option, index);
    if (!index.data(ParameterModel::ChangedRole).toBool() || index.data(TableModel::RefusedRole).isValid())
        return;
    if (index.column() == ParameterModel::NameColumn || index.column() == ParameterModel::ValueColumn)
        option->font.setBold(true);
    if (index.column() == ParameterModel::ValueColumn)
        option->palette.setColor(QPalette::Text, theme().color(ColorRole::Changed));
}

void ParameterDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const
{
    CellDelegate::paint(painter, option, index);
    if (index.column() != ParameterModel::NameColumn || !index.data(ParameterModel::ChangedRole).toBool())
        return;
    const QRect row = option.rect;
    painter->fillRect(QRect(row.left(), row.top() + 1, kBar, row.height() - 2),
                      theme().color(ColorRole::Changed));
}

const ParameterSpec &ParameterDelegate::specOf(const QModelIndex &index) const
{
    return m_configuration.edited().parameters().at(index.data(ParameterModel::IdRole).toInt());
}

NumberBox *ParameterDelegate::makeBox(const QModelIndex &index) const
{
    const ParameterSpec &spec = specOf(index);
    return spec.row->kind == ValueKind::Number ? new ParameterBox(spec) : nullptr;
}

void ParameterDelegate::showValue(NumberBox &box, const QModelIndex &index) const
{
    if (const auto raw = m_configuration.value(specOf(index), m_configuration.shownProfile()))
        static_cast<ParameterBox &>(box).showRaw(*raw);
}

QWidget *ParameterDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                         const QModelIndex &index) const
{
    const ParameterSet &parameters = m_configuration.edited().parameters();
    const ParameterSpec &spec = specOf(index);
    const bool toggle = spec.row->kind == ValueKind::Toggle;
    if (!toggle && spec.row->kind != ValueKind::Choice) {
        QWidget *field = CellDelegate::createEditor(parent, option, index);
        if (field)
            field->setAccessibleName(parameterLabel(spec));
        return field;
    }
    auto *box = new QComboBox(parent);
    if (toggle) {
        for (const int value : {0, 1})
            box->addItem(parameterValueText(spec, value), spec.format(value));
    } else {
        for (const Choice &choice : spec.choices(parameters.firmware()))
            box->addItem(tableText(choice.name), spec.format(choice.value));
    }
    box->setAccessibleName(parameterLabel(spec));
    connect(box, &QComboBox::activated, this, [this, box] {
        auto *self = const_cast<ParameterDelegate *>(this);
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void ParameterDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    if (auto *box = qobject_cast<QComboBox *>(editor))
        box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    else
        CellDelegate::setEditorData(editor, index);
}

void ParameterDelegate::setModelData(QWidget *editor, QAbstractItemModel *model,
                                     const QModelIndex &index) const
{
    const auto *box = qobject_cast<QComboBox *>(editor);
    if (!box)
        CellDelegate::setModelData(editor, model, index);
    else if (box->currentIndex() >= 0)
        model->setData(index, box->currentData());
}
