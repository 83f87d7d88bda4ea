// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/filterresponse.h"
#include "protocol/analysis/frequencyresponse.h"

/// An open loop as it was measured, and between which frequencies (Hz) the input moved it.
struct MeasuredLoop
{
    FrequencyResponse open;
    double fromHz = 0;
    double toHz = 0;
};

/// What is known about a line in the spectrum of an axis before a notch is offered for it.
struct NotchEvidence
{
    SpectrumPeak peak;
    double wholeRms = 0;  ///< all vibration of that signal from 5 Hz up, in its unit
    double commandedRms = 0;  ///< the part of the line that the target makes, in the same unit
    NotchShape shape;  ///< of the notch in question
    const MeasuredLoop *loop = nullptr;  ///< null where none was measured with these gains
};

/// Whether a notch is worth trying, and why not.
struct NotchAdvice
{
    enum class Finding {
        TryIt,
        TooWeak,  ///< without the line the axis would vibrate nearly as much
        TooBroad,  ///< not a resonance: what shakes the gimbal, or the loop's own reaction to it
        Commanded,  ///< the axis was told to move so
        OwnLoop,  ///< where the loop itself amplifies: less gain helps, a notch there makes it worse
        CostsMargin,  ///< the loop has too little phase to spare for it
    };

    Finding finding = Finding::TryIt;
    double gain = 0;  ///< fraction of the vibration that would go away with the whole line, 0 to 1
    std::optional<Margins> before;  ///< of the measured loop
    std::optional<Margins> after;  ///< the same with the notch in it, computed

    [[nodiscard]] bool isOffered() const { return finding == Finding::TryIt; }
};

/// The lowest frequency in Hz that counts as vibration; below it a hand sways.
inline constexpr double kVibrationFrom = 5.0;

/// Judges a notch before it is offered. What was not measured is not judged: a notch near a resonance that
/// the loop only bears because of its phase makes it oscillate, which no passive measurement tells, so it is
/// always tried before it is kept.
[[nodiscard]] NotchAdvice adviseNotch(const NotchEvidence &evidence);
