// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/frequencyresponse.h"
#include "protocol/analysis/stepresponse.h"
#include "protocol/procedure/motiontest.h"
#include "widgets/plot/curvechart.h"

/// One measurement of how an axis follows: target and angle samples, and the results.
struct ResponseRecord
{
    enum class Kind { Steps, Frequency };

    Kind kind = Kind::Steps;
    QString name;
    QString board;  ///< its model and serial number; empty where it came from a file
    Axis axis = Axis::None;
    bool shown = true;
    double rate = 0;
    std::vector<float> target;
    std::vector<float> angle;

    // Steps.
    StepMeasurement steps;

    // Frequency.
    FrequencyResponse closed;
    Margins margins;
    double fromHz = 0;  ///< lowest frequency in the target
    double toHz = 0;  ///< highest frequency in the target
};

/// Finds steps in a motion test. Errors: InvalidArgument (there is no step to measure).
[[nodiscard]] Result<ResponseRecord> stepRecord(const MotionTestResult &result);
/// The response of evenly spaced samples. @param fromHz,toHz frequencies that were in the input
/// Errors: TooFewSamples, InvalidArgument (no frequency with enough motion).
[[nodiscard]] Result<ResponseRecord> frequencyRecord(std::vector<float> target, std::vector<float> angle,
                                                     double rate, double fromHz, double toHz);

/// Curves of a record, drawn faintly when it is not the newest one.
[[nodiscard]] QList<ChartCurve> stepCurves(const ResponseRecord &record, int color, bool newest);
enum class BodePart { Gain, Phase, Coherence };
[[nodiscard]] ChartCurve bodeCurve(const ResponseRecord &record, BodePart part, int color, bool newest);
