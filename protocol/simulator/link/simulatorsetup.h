// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"

/// One of the families by its key. Errors: InvalidArgument with those that there are.
Result<SimulatedFamily> findSimulatedFamily(const QList<SimulatedFamily> &families, const QString &key);

/// The options that every family has, and its own; "fault" is not among them.
[[nodiscard]] QList<SimulatedOption> simulatedOptions(const SimulatedFamily &family);

/// Understands options by name, from the command line of gimbalsim or from a `sim:` address; "fault" is
/// passed over here. Errors: InvalidArgument with what there is.
Result<SimulatorSetup> parseSimulatorSetup(const SimulatedFamily &family,
                                           const QMap<QString, QString> &options, const QStringList &faults);
