// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/responserecord.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRunShare = 0.95;  // of the rest between steps, so that the next step is not included
constexpr int kMaxPoints = 400;
constexpr double kCoherence = 0.7;
constexpr double kFinestBin = 0.3;  // Hz from bin to bin
constexpr double kEarlier = 0.45;
constexpr double kPhaseGap = 300;  // degrees: a larger jump is a wrap-around, not the system

}  // namespace

Result<ResponseRecord> stepRecord(const MotionTestResult &result)
{
    ResponseRecord record;
    record.kind = ResponseRecord::Kind::Steps;
    record.axis = result.plan.axis;
    record.rate = result.angle.rate;
    record.target = result.target.values;
    record.angle = result.angle.values;
    auto steps = measureSteps(record.target, record.angle, record.rate, kRunShare * result.plan.rest);
    if (!steps)
        return tl::unexpected(steps.error());
    record.steps = std::move(*steps);
    return record;
}

Result<ResponseRecord> frequencyRecord(std::vector<float> target, std::vector<float> angle, double rate,
                                       double fromHz, double toHz)
{
    ResponseRecord record;
    record.kind = ResponseRecord::Kind::Frequency;
    record.rate = rate;
    record.fromHz = fromHz;
    record.toHz = std::min(toHz, rate / 2);
    int length = 64;
    while (length * 4 <= int(std::min(target.size(), angle.size())) && rate / length > kFinestBin)
        length *= 2;
    auto closed = frequencyResponse(target, angle, rate, {length, 0.5, WindowShape::Hann});
    if (!closed)
        return tl::unexpected(closed.error());
    record.target = std::move(target);
    record.angle = std::move(angle);
    record.closed = std::move(*closed);
    record.margins = margins(openLoop(record.closed), kCoherence, fromHz, record.toHz);
    if (record.margins.bins == 0)
        return failure(ErrorCode::InvalidArgument,
                       u"at no frequency does the axis follow the target clearly enough to tell"_s);
    return record;
}

QList<ChartCurve> stepCurves(const ResponseRecord &record, int color, bool newest)
{
    QList<ChartCurve> curves;
    const auto points = [&record](const std::vector<float> &samples) {
        QList<QPointF> list;
        const std::size_t step = std::max<std::size_t>(1, samples.size() / kMaxPoints);
        for (std::size_t i = 0; i < samples.size(); i += step)
            list.append({1000.0 * double(i) / record.rate, double(samples[i])});
        return list;
    };
    if (newest) {
        for (const std::vector<float> &run : record.steps.runs.response)
            curves.append({{}, points(run), record.axis, color, Qt::SolidLine, 1, 0.25});
        if (!record.steps.runs.target.empty())
            curves.append({CurveChart::tr("Target"), points(record.steps.runs.target.front()), Axis::None, 7,
                           Qt::DashLine, 1, 1});
    }
    curves.append({record.name, points(record.steps.mean), newest ? record.axis : Axis::None, color,
                   Qt::SolidLine, newest ? 2.0 : 1.5, newest ? 1.0 : kEarlier});
    return curves;
}

ChartCurve bodeCurve(const ResponseRecord &record, BodePart part, int color, bool newest)
{
    ChartCurve curve;
    curve.name = part == BodePart::Gain ? record.name : QString();
    curve.axis = newest ? record.axis : Axis::None;
    curve.color = color;
    curve.width = newest ? 2.0 : 1.5;
    curve.strength = newest ? 1.0 : kEarlier;
    double last = 0;
    double turns = 0;
    for (std::size_t bin = 1; bin < record.closed.gain.size(); ++bin) {
        const double hz = record.closed.frequency(bin);
        if (hz > record.toHz)
            break;
        if (part != BodePart::Coherence && record.closed.coherence[bin] < kCoherence)
            continue;  // too uncertain to be drawn
        double value = record.closed.coherence[bin];
        if (part == BodePart::Gain)
            value = record.closed.gainDb(bin);
        if (part == BodePart::Phase) {
            const double phase = record.closed.phaseDeg(bin);
            if (!curve.points.isEmpty() && phase - last > kPhaseGap)
                turns -= 360.0;
            else if (!curve.points.isEmpty() && phase - last < -kPhaseGap)
                turns += 360.0;
            last = phase;
            value = phase + turns;
        }
        curve.points.append({hz, value});
    }
    return curve;
}
