// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

struct StreamBudget;

/// Says that live data come less often than they are meant to because the line carries no more, and at which
/// rate. Empty where it carries them all.
/// @param rate, fullRate, budget of the telemetry's plan
[[nodiscard]] QString thinningText(double rate, double fullRate, const StreamBudget &budget);
