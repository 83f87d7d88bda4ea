// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/record/recording.h"

/// Everything of a recording at once, through the same framer and decoder as a live link. Times of the store
/// begin with the recording's first received bytes.
[[nodiscard]] std::shared_ptr<TelemetryStore> readTelemetry(const Recording &recording, const Device &device);
