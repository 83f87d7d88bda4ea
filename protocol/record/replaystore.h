// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/record/recording.h"

class TelemetryStore;

/// Decodes a whole recording at once, with the same framer and decoder as a live link. The store's times
/// start with the recording's first received bytes. Where a part of the recording is missing, the samples
/// have a gap.
[[nodiscard]] std::shared_ptr<TelemetryStore> readTelemetry(const Recording &recording, const Family &family,
                                                            const Device &device);
