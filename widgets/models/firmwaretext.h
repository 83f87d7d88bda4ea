// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/firmwareadvice.h"

/// "Newer firmware would bring this program 61 parameters and 12 actions."; empty: nothing.
[[nodiscard]] QString gainText(const std::vector<FirmwareStep> &steps);

/// "2.68b0: 65 parameters, 2 actions", a line for each step.
[[nodiscard]] QString stepsText(const std::vector<FirmwareStep> &steps);
