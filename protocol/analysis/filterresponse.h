// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

/// A filter that takes one frequency out.
struct NotchShape
{
    double hz = 0;  ///< middle
    double width = 0;  ///< Hz between the points where half of the depth (in dB) is reached
    double depthDb = 0;  ///< how much it takes out in the middle; negative makes a peak
};

/// Gain and phase of a notch at a frequency (Hz): the analogue prototype, which a sampled filter follows to
/// within a few degrees up to a fifth of its rate.
[[nodiscard]] std::complex<double> notchResponse(const NotchShape &notch, double hz);

/// The same of a low-pass of second order (Butterworth) with that corner.
[[nodiscard]] std::complex<double> lowPassResponse(double cornerHz, double hz);

/// Degrees by which a filter's response lags; negative: it leads.
[[nodiscard]] double lagDeg(std::complex<double> response);
