// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/spectrumchart.h"

#include "widgets/models/numbertext.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLowest = 1.0;  // Hz: anything slower is steering or drift
constexpr double kPointsPerOctave = 48.0;
constexpr double kPointsLinear = 400.0;
constexpr double kMinDecibel = -160.0;
constexpr double kStep = 20.0;  // dB between lines of the grid
constexpr double kEarlier = 0.35;

double decibel(double density)
{
    return std::max(kMinDecibel, 10.0 * std::log10(std::max(density, 1e-30)));
}

// The next of 1, 2, 5 times a power of ten, so that the scale does not jitter with the noise.
double roundUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value)
            return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

SpectrumChart::SpectrumChart(const Theme &theme, QWidget *parent)
    : CurveChart(theme, tr("Spectrum"), parent)
{
    setMinimumHeight(180);
    setScales({{}, kLowest, 1000, true, u"%g Hz"_s}, {tr("dB"), -80, 0, false, u"%.0f"_s, 4});
}

double SpectrumChart::levelOf(const Spectrum &spectrum, std::size_t bin) const
{
    return m_scale.amplitude ? spectrum.toneRms(bin) : decibel(spectrum.density[bin]);
}

// The greatest value of all bins that fall on one point: no line is lost by drawing fewer points.
QList<QPointF> SpectrumChart::pointsOf(const Spectrum &spectrum) const
{
    QList<QPointF> points;
    int last = -1;
    for (std::size_t bin = 1; bin < spectrum.density.size(); ++bin) {
        const double hz = spectrum.frequency(bin);
        if (hz < kLowest)
            continue;
        const double level = levelOf(spectrum, bin);
        const int place = m_scale.linearFrequency ? int(2.0 * hz / spectrum.rate * kPointsLinear)
                                                  : int(std::log2(hz / kLowest) * kPointsPerOctave);
        if (place == last && level > points.last().y())
            points.last() = {hz, level};
        else if (place != last)
            points.append({hz, level});
        last = place;
    }
    return points;
}

void SpectrumChart::setSpectra(const std::vector<SpectrumCurve> &spectra, const QString &unit,
                               const SpectrumScale &scale)
{
    m_scale = scale;
    QList<ChartCurve> drawn;
    double low = 0.0;
    double high = scale.amplitude ? 0.0 : kMinDecibel;
    double highest = 10.0;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        ChartCurve curve;
        curve.name = spectra[i].earlier ? QString() : spectra[i].name;
        curve.points = pointsOf(spectra[i].spectrum);
        curve.axis = spectra[i].axis;
        curve.color = int(i);
        curve.strength = spectra[i].earlier ? kEarlier : 1.0;
        curve.style = spectra[i].isBoards ? Qt::DashLine : Qt::SolidLine;
        highest = std::max(highest, spectra[i].spectrum.rate / 2);
        for (const QPointF &point : curve.points) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
        drawn.append(curve);
    }
    ChartScale y{unit.isEmpty() ? tr("dB") : tr("dB of (%1)²/Hz").arg(unit), -80, 0, false, u"%.0f"_s, 4};
    if (scale.amplitude) {
        y = {unit.isEmpty() ? tr("RMS") : tr("%1 RMS").arg(unit),
             0,
             roundUp(std::max(high, 1e-4)),
             false,
             u"%g"_s,
             5};
    } else if (high > low) {
        y.high = std::ceil(high / kStep) * kStep;
        y.low = std::max(std::floor(low / kStep) * kStep, y.high - 6 * kStep);
        y.steps = int((y.high - y.low) / kStep);
    }
    const double from = scale.linearFrequency ? 0.0 : kLowest;
    setScales({{}, from, highest, !scale.linearFrequency, u"%g Hz"_s, scale.linearFrequency ? 5 : 0}, y);
    setCurves(drawn);
}

void SpectrumChart::setPeaks(const std::vector<std::pair<const Spectrum *, SpectrumPeak>> &peaks)
{
    QList<ChartLabel> words;
    for (const auto &[spectrum, peak] : peaks) {
        const auto bin = std::min(spectrum->density.size() - 1,
                                  std::size_t(std::lround(peak.frequency / spectrum->resolution)));
        words.append(
            {{peak.frequency, levelOf(*spectrum, bin)}, tr("%1 Hz").arg(numberText(peak.frequency, 1))});
    }
    setLabels(words);
}
