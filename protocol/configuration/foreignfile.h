// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <functional>

/// Contents of another program's settings file.
struct ForeignSettings
{
    Configuration configuration;
    QStringList unknown;  ///< entries that match no parameter
    /// Keys of parameters, and names of blocks without any, that it does not contain: nothing is known of
    /// them, and the configuration has their defaults.
    QStringList missing;
};

/// Settings files of the manufacturer's own program, read and written as data.
struct ForeignFile
{
    QString suffix;  ///< "cfg"
    QString name;  ///< "STorM32 settings"
    /// Errors: BadFile with the reason and the place.
    std::function<Result<ForeignSettings>(const QByteArray &)> read;
    /// Errors: Unsupported (the file cannot hold this configuration).
    std::function<Result<QByteArray>(const Configuration &)> write;
};

/// Calibration of one accelerometer, in sensor counts: zero offset, and counts per g, of each axis.
struct SensorCalibration
{
    std::array<int, 3> zero{};
    std::array<int, 3> scale{};
    QString method;  ///< "1 point", "6 point"
    double temperature = 0;  ///< degrees Celsius

    friend bool operator==(const SensorCalibration &, const SensorCalibration &) = default;
};

/// Files with such calibrations.
struct CalibrationFile
{
    QString suffix;  ///< "cal"
    QString name;
    std::function<Result<SensorCalibration>(const QByteArray &)> read;
    std::function<QByteArray(const SensorCalibration &)> write;
};
