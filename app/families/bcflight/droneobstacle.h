// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class Workspace;

enum class Calibration { Needed, NotNeeded };

/// Why the drone is told nothing that it has to be disarmed for; empty: it can be told.
[[nodiscard]] QString droneObstacle(const Workspace &workspace, Calibration calibration);
