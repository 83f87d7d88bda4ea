// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

/// A notch filter: attenuates a narrow band around one frequency.
struct NotchShape
{
    double hz = 0;  ///< centre frequency
    double width = 0;  ///< Hz between the points where half of the depth (in dB) is reached
    double depthDb = 0;  ///< attenuation at the centre; negative makes a peak
};

/// Gain and phase of a notch at a frequency (Hz): the analogue prototype, which a sampled filter follows to
/// within a few degrees up to a fifth of its rate.
[[nodiscard]] std::complex<double> notchResponse(const NotchShape &notch, double hz);

/// The same for a second-order low-pass (Butterworth) with this corner frequency.
[[nodiscard]] std::complex<double> lowPassResponse(double cornerHz, double hz);

/// Phase lag of a filter response in degrees; negative means lead.
[[nodiscard]] double lagDeg(std::complex<double> response);
