// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <functional>

/// What a settings file of another program says.
struct ForeignSettings
{
    Configuration configuration;
    QStringList unknown;  ///< entries that no parameter fits
    QStringList missing;  ///< parameters it does not name: they have their defaults
};

/// Settings files of a family's original program, read and written as data.
struct ForeignFile
{
    QString suffix;  ///< "cfg"
    QString name;  ///< "STorM32 settings"
    /// Errors: BadFile with what is wrong and where.
    std::function<Result<ForeignSettings>(const QByteArray &)> read;
    /// Errors: Unsupported (the file cannot hold this configuration).
    std::function<Result<QByteArray>(const Configuration &)> write;
};

/// Calibration of one accelerometer, in counts of the sensor: what it shows lying level, and per g.
struct SensorCalibration
{
    std::array<int, 3> zero{};
    std::array<int, 3> scale{};
    QString method;  ///< "1 point", "6 point"
    double temperature = 0;  ///< degrees Celsius

    friend bool operator==(const SensorCalibration &, const SensorCalibration &) = default;
};

/// Files of such calibrations.
struct CalibrationFile
{
    QString suffix;  ///< "cal"
    QString name;
    std::function<Result<SensorCalibration>(const QByteArray &)> read;
    std::function<QByteArray(const SensorCalibration &)> write;
};
