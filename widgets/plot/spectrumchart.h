// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"
#include "widgets/plot/curvechart.h"

/// One spectrum and what it is called.
struct SpectrumCurve
{
    QString name;
    Axis axis = Axis::None;
    Spectrum spectrum;
    bool earlier = false;  ///< kept for comparison: drawn faintly
    bool isBoards = false;  ///< the board has computed it: drawn dashed
};

/// How spectra are drawn.
struct SpectrumScale
{
    bool linearFrequency = false;
    bool amplitude = false;  ///< RMS of each line in the unit of the samples, instead of decibels of density
};

/// Spectra over a scale of frequency. Nothing above half the sample rate is shown.
class SpectrumChart final : public CurveChart
{
    Q_OBJECT
public:
    explicit SpectrumChart(const Theme &theme, QWidget *parent = nullptr);

    /// @param unit of the samples
    void setSpectra(const std::vector<SpectrumCurve> &spectra, const QString &unit,
                    const SpectrumScale &scale = {});
    /// Labels at the highest peaks of a spectrum.
    void setPeaks(const std::vector<std::pair<const Spectrum *, SpectrumPeak>> &peaks);

private:
    [[nodiscard]] double levelOf(const Spectrum &spectrum, std::size_t bin) const;
    [[nodiscard]] QList<QPointF> pointsOf(const Spectrum &spectrum) const;

    SpectrumScale m_scale;
};
