// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How each segment fades in and out before it is transformed.
enum class WindowShape {
    Rectangular,  ///< sharpest for a tone that fits the segment exactly, leaks everywhere else
    Hann,  ///< the one to use when in doubt
    FlatTop,  ///< true amplitudes of single tones, wide peaks
};

/// How a spectrum is averaged.
struct SpectrumOptions
{
    int length = 1024;  ///< samples per segment, 16 to 65536; its rate / length is the resolution
    double overlap = 0.5;  ///< fraction of a segment shared with the next one, 0 to 0.9
    WindowShape window = WindowShape::Hann;
};
