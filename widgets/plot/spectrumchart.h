// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"
#include "widgets/theme/theme.h"

#include <QChartView>

class QLineSeries;
class QLogValueAxis;
class QValueAxis;

/// One spectrum and what it is called.
struct SpectrumCurve
{
    QString name;
    Axis axis = Axis::None;
    Spectrum spectrum;
};

/// Spectra over a logarithmic scale of frequency, in decibels. Nothing above half the sample rate is shown.
class SpectrumChart final : public QChartView
{
    Q_OBJECT
public:
    explicit SpectrumChart(const Theme &theme, QWidget *parent = nullptr);

    /// @param unit of the samples
    void setCurves(const std::vector<SpectrumCurve> &curves, const QString &unit);
    /// Highest frequency on the scale, 0 without a curve.
    [[nodiscard]] double highestFrequency() const;
    [[nodiscard]] int curveCount() const { return int(m_series.size()); }

private:
    void applyTheme();

    const Theme &m_theme;
    QLogValueAxis *m_frequency;
    QValueAxis *m_level;
    QList<QLineSeries *> m_series;
    QList<Axis> m_axes;
};
