// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

struct TelemetryPlan;

/// Says that live data come less often than they are meant to because the line carries no more, and at which
/// rate. Empty where it carries them all.
[[nodiscard]] QString thinningText(const TelemetryPlan &plan);
