// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "widgets/forms/editstack.h"

#include <QHash>
#include <QWidget>

class FilterRows;
class QVBoxLayout;
class ValueEditor;

/// A form made from parameter declarations: per-axis values as a matrix, the rest in columns. Follows the
/// model; what was typed and is no value is kept with the edits, for the profile that it was typed for.
class ParameterForm final : public QWidget
{
    Q_OBJECT
public:
    ParameterForm(ConfigurationModel &configuration, EditStack &edits, QWidget *parent = nullptr);

    /// Shows these parameters (ids), group after group in the order given.
    void setParameters(const QList<int> &parameters);
    /// Parameters of these filters are shown as filters, where all of a filter's are among those shown.
    void setFilters(const std::vector<NotchFilter> &filters) { m_filters = filters; }
    [[nodiscard]] ValueEditor *editor(int parameter) const { return m_editors.value(parameter); }
    [[nodiscard]] qsizetype count() const { return m_editors.size(); }

signals:
    void parameterFocused(int parameter);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void rebuild();
    void addGroup(QVBoxLayout *layout, const char *group, const QList<int> &parameters);
    /// Takes out those that belong to a filter.
    [[nodiscard]] QList<int> withoutFilters(const QList<int> &parameters, QVBoxLayout *layout);
    QWidget *makeMatrix(const QList<QList<int>> &rows);
    QWidget *makeFields(const QList<int> &parameters);
    ValueEditor *makeEditor(int parameter);
    void refresh(int parameter);
    void refreshAll();
    [[nodiscard]] int columnsFor(int width) const;

    ConfigurationModel &m_configuration;
    EditStack &m_edits;
    std::shared_ptr<const ParameterSet> m_set;  // what the editors refer to
    QList<int> m_parameters;
    QHash<int, ValueEditor *> m_editors;
    std::vector<NotchFilter> m_filters;
    FilterRows *m_filterRows = nullptr;  // null where no filter is shown
    QWidget *m_body = nullptr;
    QString m_serial;  // of the board whose values are shown
    int m_columns = 1;
};
