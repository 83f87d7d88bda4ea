// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/filterresponse.h"
#include "protocol/device/abilities.h"

#include <QWidget>

#include <functional>

class ConfigurationModel;
class EditStack;
class QCheckBox;
class ValueEditor;

/// What a notch lets through by frequency, as a small picture; faint while the filter is not in use.
class FilterCurve final : public QWidget
{
    Q_OBJECT
public:
    explicit FilterCurve(QWidget *parent = nullptr);

    void show(const NotchShape &shape, bool inUse);
    [[nodiscard]] const NotchShape &shape() const { return m_shape; }
    [[nodiscard]] bool isInUse() const { return m_inUse; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    NotchShape m_shape;
    bool m_inUse = false;
};

/// Filters as filters: a row each with whether it is in use, its values and a picture of its curve.
class FilterRows final : public QWidget
{
    Q_OBJECT
public:
    /// @param filters those whose parameters are all there @param makeEditor gives the field for a parameter
    FilterRows(const ConfigurationModel &configuration, EditStack &edits,
               const std::vector<NotchFilter> &filters, const std::function<ValueEditor *(int)> &makeEditor,
               QWidget *parent = nullptr);

    void refresh();
    /// The parameter belongs to one of the filters.
    [[nodiscard]] bool concerns(int parameter) const;
    /// Why the parameter has no effect now; empty if it has or is none of a filter.
    [[nodiscard]] QString inactiveReason(int parameter) const;

private:
    struct Row
    {
        int frequency = -1;
        int width = -1;
        int depth = -1;
        int enabled = -1;
        int bit = 0;
        QCheckBox *use = nullptr;
        FilterCurve *curve = nullptr;
    };
    [[nodiscard]] bool isInUse(const Row &row) const;
    [[nodiscard]] double value(int parameter) const;
    void use(const Row &row, bool on);

    const ConfigurationModel &m_configuration;
    EditStack &m_edits;
    std::vector<Row> m_rows;
};
