// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/frequencyresponse.h"
#include "protocol/simulator/world/stabilizer.h"

#include <cmath>
#include <numbers>

/// The simulated axis in the mathematics of control: linear, without dry friction and cogging, from the
/// constants that the simulator documents. An independent way to know what a measurement of it should find.
struct LoopMath
{
    AxisMechanics mechanics;
    AxisGains gains;

    using Complex = std::complex<double>;

    /// Gyro reading (deg/s) for motor command (share of full torque), with the loop's delay.
    [[nodiscard]] Complex rate(Complex s) const
    {
        constexpr double kMotorLag = 0.004;
        constexpr double kGyroLag = 0.002;
        constexpr double kDelay
            = 1.5 * Stabilizer::kCycle;  // the command acts one cycle later and is held for one
        // First-order lags as the simulator steps them: a cycle for the sensor, a quarter of it for the
        // motor.
        const auto lag = [s](double seconds, double step) {
            const double share = step / seconds;
            return share / (1.0 - (1.0 - share) * std::exp(-s * step));
        };
        const double omega = 2.0 * std::numbers::pi * mechanics.resonanceHz;
        const Complex bend = mechanics.resonanceGain * s
            / (s * s + 2.0 * mechanics.resonanceDamping * omega * s + omega * omega);
        return std::exp(-s * kDelay) * mechanics.fullTorque * lag(kMotorLag, Stabilizer::kCycle / 4)
            * (1.0 / (s + mechanics.viscous) + bend) * lag(kGyroLag, Stabilizer::kCycle);
    }

    /// Angle for target.
    [[nodiscard]] Complex closed(double hz) const
    {
        const Complex s(0.0, 2.0 * std::numbers::pi * hz);
        const double scale = gains.gain / 4000.0;
        const Complex pi = scale * (28.0 * gains.p + 218.0 * gains.i / s);
        Complex d = scale * 1.5 * gains.d;
        if (gains.dLpfHz > 0) {
            const double w = 2.0 * std::numbers::pi * gains.dLpfHz;
            d *= w * w / (s * s + std::numbers::sqrt2 * w * s + w * w);
        }
        const Complex g = rate(s);
        return pi * g / s / (1.0 + pi * g / s + d * g);
    }

    [[nodiscard]] FrequencyResponse openLoop(double highest) const
    {
        FrequencyResponse response;
        response.resolution = 0.02;
        for (double hz = 0.0; hz < highest; hz += response.resolution) {
            const Complex t = hz > 0.0 ? closed(hz) : Complex(1.0, 0.0);
            response.gain.push_back(hz > 0.0 ? t / (1.0 - t) : Complex(1e6, 0.0));
            response.coherence.push_back(1.0);
        }
        return response;
    }

    /// Angle at a time after a target stepped from 0 to 1.
    [[nodiscard]] std::vector<float> step(double rateHz, double seconds) const
    {
        std::vector<float> angle(std::size_t(rateHz * seconds));
        constexpr double kStep = 0.02;  // Hz
        constexpr double kHighest = 200.0;
        std::vector<double> parts;
        for (double hz = kStep / 2; hz < kHighest; hz += kStep)
            parts.push_back(closed(hz).real() / hz * kStep);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            const double turns = 2.0 * std::numbers::pi * double(i) / rateHz;
            double sum = 0.0;
            for (std::size_t part = 0; part < parts.size(); ++part)
                sum += parts[part] * std::sin(turns * kStep * (double(part) + 0.5));
            angle[i] = float(2.0 / std::numbers::pi * sum);
        }
        return angle;
    }
};
