// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/composition/links.h"
#include "protocol/device/family.h"
#include "protocol/simulator/world/simulatedfamily.h"

/// The one place that knows which families exist and which kinds of link there are.
[[nodiscard]] QList<Family> allFamilies();
/// What is only met in files.
[[nodiscard]] QList<Family> recordedFamilies();

[[nodiscard]] Links allLinks();

/// The families that can be simulated.
[[nodiscard]] QList<SimulatedFamily> allSimulatedFamilies();

/// The family's tables for a board, null for a family that does not exist here.
[[nodiscard]] std::shared_ptr<const ParameterSet> parametersFor(const BoardIdentity &identity);
