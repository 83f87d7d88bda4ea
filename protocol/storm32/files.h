// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/foreignfile.h"

/// Text files of the original program: settings (.cfg, a hash with 'Name' => [ raw , 'shown' ] in each line)
/// and calibrations (.cal, lines of KEY: value). Read as data, never run (errata 9, 9.2).
namespace storm32 {

/// Uses the layout that knows most of the names, because the file does not say which one it is. If a choice's
/// number and text disagree, the text is used: numbers change between layouts. Errors: BadFile.
[[nodiscard]] Result<ForeignSettings> readSettings(const QByteArray &text);
[[nodiscard]] Result<QByteArray> writeSettings(const Configuration &configuration);

/// Errors: BadFile naming the line that is missing or wrong.
[[nodiscard]] Result<SensorCalibration> readCalibration(const QByteArray &text);
[[nodiscard]] QByteArray writeCalibration(const SensorCalibration &calibration);

}  // namespace storm32
