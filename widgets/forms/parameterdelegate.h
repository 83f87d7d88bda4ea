// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/forms/celldelegate.h"
#include "widgets/models/configurationmodel.h"

/// Rows of the ParameterModel in a table: a changed one has a bar at its left edge and its value in bold and
/// in the colour of changes; choices are edited by their names.
class ParameterDelegate final : public CellDelegate
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
    [[nodiscard]] NumberBox *makeBox(const QModelIndex &index) const override;
    void showValue(NumberBox &box, const QModelIndex &index) const override;
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;

private:
    [[nodiscard]] const ParameterSpec &specOf(const QModelIndex &index) const;

    const ConfigurationModel &m_configuration;
};
