// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"

/// Finds a family by its key. Errors: InvalidArgument listing the existing ones.
Result<SimulatedFamily> findSimulatedFamily(const QList<SimulatedFamily> &families, const QString &key);

/// The options that every family has, and its own; does not include "fault".
[[nodiscard]] QList<SimulatedOption> simulatedOptions(const SimulatedFamily &family);

/// Parses options by name, from the command line of gimbalsim or from a `sim:` address; ignores "fault".
/// Errors: InvalidArgument listing what is accepted.
Result<SimulatorSetup> parseSimulatorSetup(const SimulatedFamily &family,
                                           const QMap<QString, QString> &options, const QStringList &faults);
