// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedure/writeconfiguration.h"
#include "protocol/telemetry/telemetrystore.h"

#include <atomic>

/// A notch to be tried on the running gimbal.
struct NotchTrialPlan
{
    Axis axis = Axis::None;
    double hz = 0;  ///< the line that it is for
    double width = 0;  ///< Hz around it that count as the line
    double seconds = 6;  ///< measured without and with the notch, 1 to 30
    Configuration base;  ///< what the board holds
    Configuration wanted;  ///< the same with the notch
};

/// How an axis vibrates over a span.
struct Vibration
{
    double line = 0;  ///< deg/s RMS around the line
    double whole = 0;  ///< deg/s RMS from 5 Hz up
    double error = 0;  ///< degrees RMS between target and angle, or around the mean; NaN if unknown
};

/// What a trial has shown. The board holds what it held before, unless isTakenBack says otherwise.
struct NotchTrialResult
{
    enum class Verdict {
        Better,
        NoBetter,  ///< not enough to be worth its delay
        Worse,  ///< this axis or another vibrates or strays more
        Oscillates,  ///< it began to: taken back at once
        Ended,  ///< see `ended`
    };

    Verdict verdict = Verdict::Ended;
    Vibration before;
    Vibration after;  ///< not measured where the trial was ended or the axis oscillated
    double peak = 0;  ///< deg/s RMS, the greatest of any quarter second with the notch
    Axis peakAxis = Axis::None;
    std::optional<Error> ended;  ///< why it was not watched to its end
    bool isTakenBack = false;  ///< the old values were written and read back
    WriteReport lastWrite;
};

/// Tries a notch: measures the axis, writes the notch with a safety copy (verified), measures again over an
/// equal span, and writes the old values back, whatever came out: to keep it is the operator's decision.
/// Until they are back, a TrialNote is kept. Oscillation of any axis ends it at once. It runs on the worker
/// and needs nobody to look on.
/// @param stop ends the trial early when set; the old values are written back then too.
/// Errors, with nothing changed on the board: ReadOnly, Unsupported (no gyro), Unready (motors off, no
/// telemetry), TooFewSamples, Cancelled, and those of writeConfiguration().
[[nodiscard]] Result<NotchTrialResult> tryNotch(Channel &channel, Device &device,
                                                const TelemetryStore &telemetry, const NotchTrialPlan &plan,
                                                const WriteOptions &options, const std::atomic<bool> &stop);
