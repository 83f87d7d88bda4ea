// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

namespace bcflight {

/// Reads what is to replace a drone's program. No document says how such a file looks, so only what cannot be
/// one is refused. Errors: BadFile (missing, empty, under 1 KiB, over 4 MiB, another kind of file).
[[nodiscard]] Result<QByteArray> readFirmware(const QString &path);
/// It says of itself that it is a program for a processor as drones have it.
[[nodiscard]] bool isDroneProgram(const QByteArray &image);

}  // namespace bcflight
