// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

#include <array>

/// What kinds of alarm are called in files and on the command line, in the order of the enumeration.
inline constexpr std::array<const char *, kAlarmKinds> kAlarmKeys{
    "runaway", "oscillation", "limit", "saturation", "sensor", "heat", "battery", "stale", "disarmed"};
