// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"
#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>

/// Rows of the ParameterModel in a table: a changed one has a bar at its left edge and its value in bold and
/// in the colour of changes; choices are edited by their names.
class ParameterDelegate final : public QStyledItemDelegate
{
    Q_OBJECT
public:
    ParameterDelegate(const ConfigurationModel &configuration, const Theme &theme, QObject *parent = nullptr);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;

private:
    const ConfigurationModel &m_configuration;
    const Theme &m_theme;
};
