// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

#include <QWidget>

class QSlider;
class ValueEditor;

/// One live value: a slider and a number box that are one control. Drag, type, arrow keys; Shift with the
/// wheel or an arrow moves by single counts.
class LiveSlider final : public QWidget
{
    Q_OBJECT
public:
    /// @param range raw values that can be set live
    LiveSlider(const ParameterSpec &spec, std::pair<double, double> range, int firmware,
               QWidget *parent = nullptr);

    /// Shows the value in use and the stored one; empty = not known.
    void show(std::optional<double> value, std::optional<double> stored);
    [[nodiscard]] QSlider *slider() const { return m_slider; }
    [[nodiscard]] ValueEditor *editor() const { return m_editor; }

signals:
    void edited(double raw);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Where a float may be far greater than anybody uses, the slider spans what is near.
    void span(double value, std::optional<double> stored);
    [[nodiscard]] double rawAt(int position) const;
    [[nodiscard]] int positionOf(double raw) const;

    const ParameterSpec &m_spec;
    ValueEditor *m_editor;
    QSlider *m_slider = nullptr;
    std::pair<double, double> m_range;
    std::pair<double, double> m_span;  // of the slider
    std::optional<double> m_reference;  // that the span was made for
    bool m_inCounts = true;  // a position is a raw count; otherwise a fraction of the range
    bool m_updating = false;
};
