// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/record/recording.h"

class TelemetryStore;

/// Decodes a whole recording at once, with the same framer and decoder as a live link: the device, fresh from
/// the family, first identifies the board. The store's times start with the recording's first received bytes.
/// Where a part of the recording is missing, the samples have a gap. Errors: BadFile if the recording does
/// not tell whose values these are.
Result<std::shared_ptr<TelemetryStore>> readTelemetry(const Recording &recording, const Family &family,
                                                      Device &device);

/// The same with a device that knows its board already.
[[nodiscard]] std::shared_ptr<TelemetryStore> decodeTelemetry(const Recording &recording,
                                                              const Family &family, const Device &device);
