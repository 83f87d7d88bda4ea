// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/accelerometer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

// Fraction of 1 g above which an axis counts as pointing up or down.
constexpr std::array<double, 3> kUp{0.85, 0.85, 0.75};
constexpr double kMinGravity = 0.8;  // of 1 g, before calibration
constexpr double kMaxGravity = 1.2;
constexpr std::array<std::size_t, 3> kAxisOfPair{2, 0, 1};  // faces come Z, X, Y

int sideOf(const AccReading &reading, std::size_t axis, double oneG)
{
    return std::abs(reading[axis]) <= kUp[axis] * oneG ? 0 : reading[axis] > 0 ? 1 : -1;
}

}  // namespace

bool isGravity(const AccReading &reading, double oneG)
{
    const double length = std::hypot(reading[0], reading[1], reading[2]);
    return length >= kMinGravity * oneG && length <= kMaxGravity * oneG;
}

int faceUp(const AccReading &reading, double oneG)
{
    for (std::size_t pair = 0; pair < kAxisOfPair.size(); ++pair) {
        if (const int side = sideOf(reading, kAxisOfPair[pair], oneG))
            return int(2 * pair) + (side < 0 ? 1 : 0);
    }
    return -1;
}

AccCalibration onePointCalibration(const AccReading &reading, double oneG)
{
    AccCalibration calibration;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        calibration.zero[axis] = int(std::lround(reading[axis] - sideOf(reading, axis, oneG) * oneG));
        calibration.scale[axis] = int(std::lround(oneG));
    }
    return calibration;
}

AccCalibration sixPointCalibration(const std::array<AccReading, kAccFaces> &readings)
{
    AccCalibration calibration;
    AccReading zero{};
    for (std::size_t pair = 0; pair < kAxisOfPair.size(); ++pair) {
        const std::size_t axis = kAxisOfPair[pair];
        const double plus = readings[2 * pair][axis];
        const double minus = readings[2 * pair + 1][axis];
        zero[axis] = (plus + minus) / 2.0;
        calibration.zero[axis] = int(std::lround(zero[axis]));
        calibration.scale[axis] = int(std::lround((plus - minus) / 2.0));
    }
    double squares = 0;
    for (std::size_t face = 0; face < readings.size(); ++face) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis != kAxisOfPair[face / 2])
                squares += std::pow(readings[face][axis] - zero[axis], 2);
        }
    }
    calibration.quality = std::sqrt(squares / 12.0);
    return calibration;
}

bool isPlausible(const AccCalibration &calibration, double oneG)
{
    // Errata 9.2: limits for sensors with a range of 4 g (8192 counts), and of 2 g.
    const bool wide = oneG < 10000;
    const int maxZero = wide ? 3500 : 7000;
    const int min = wide ? 7500 : 15000;
    const int max = wide ? 8900 : 17500;
    return std::all_of(calibration.zero.begin(), calibration.zero.end(),
                       [maxZero](int zero) { return std::abs(zero) <= maxZero; })
        && std::all_of(calibration.scale.begin(), calibration.scale.end(),
                       [=](int scale) { return scale >= min && scale <= max; });
}
