// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

/// Accelerometer calibration from readings at rest, in sensor counts (STorM32 errata 9.2). The measured
/// acceleration is (reading - zero) / scale, in g.

/// One reading of the sensor's axes x, y, z.
using AccReading = std::array<double, 3>;

inline constexpr int kAccFaces = 6;  ///< Z, -Z, X, -X, Y, -Y up

struct AccCalibration
{
    std::array<int, 3> zero{};
    std::array<int, 3> scale{};
    double quality = 0;  ///< counts: residual on the axes that should read zero; 0 for one point

    friend bool operator==(const AccCalibration &, const AccCalibration &) = default;
};

/// Whether a sensor at rest can read this: it measures gravity and nothing else, give or take what its
/// calibration removes.
[[nodiscard]] bool isGravity(const AccReading &reading, double oneG);
/// Which face lies up: 0-5 as above, -1 for none. @param oneG counts of 1 g
[[nodiscard]] int faceUp(const AccReading &reading, double oneG);
/// Calibration from one reading on any face: the zeros, with the nominal scale.
[[nodiscard]] AccCalibration onePointCalibration(const AccReading &reading, double oneG);
/// Calibration from one reading on each face, in the order of the faces.
[[nodiscard]] AccCalibration sixPointCalibration(const std::array<AccReading, kAccFaces> &readings);
/// Whether a real sensor can have this calibration; if not, one of the readings was bad.
[[nodiscard]] bool isPlausible(const AccCalibration &calibration, double oneG);
