// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

class Configuration;
class Device;

/// Puts into the rules which angles each axis may be steered to, whether an input of the board may do so, and
/// at which voltage the board warns, by its active profile. What is not known is not limited.
void setBoardLimits(SupervisorRules &rules, const Device &device, const Configuration &active);
