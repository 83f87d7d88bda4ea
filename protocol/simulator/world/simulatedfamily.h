// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedboard.h"

#include <functional>

/// A simulated board and the line it is connected to, as requested by the operator.
struct SimulatorSetup
{
    SimulatorOptions options;
    std::optional<int> rate;  ///< of its UART; empty = native USB, or a network
    Parity parity = Parity::None;

    [[nodiscard]] std::optional<LineSettings> line() const
    {
        return rate ? std::optional(LineSettings{*rate, parity}) : std::nullopt;
    }
};

/// `gimbalsim --NAME VALUE` and `sim:FAMILY?NAME=VALUE`.
struct SimulatedOption
{
    QString name;
    QString value;  ///< placeholder for the value in the help: "N"
    QStringList help;  ///< lines
    /// Errors: InvalidArgument listing what is accepted.
    std::function<Result<void>(SimulatorSetup &setup, const QString &text)> read;
};

/// The firmware versions that a family's simulated boards can run.
struct SimulatedFirmware
{
    QString help;  ///< the versions, with the default: "0.79, 0.90, 0.96 (default)"
    /// The version as the family numbers it. Errors: InvalidArgument listing the existing ones.
    std::function<Result<int>(const QString &text)> parse;
};

/// The simulated boards of a family, as the program's table lists them.
struct SimulatedFamily
{
    QString key;  ///< "simplebgc", as in the table of families
    QList<LinkAddress::Kind> links;  ///< links over which a real board of this family is reached
    SimulatedFirmware firmware;
    QList<SimulatedOption> options;  ///< options that other families do not have
    std::function<std::unique_ptr<SimulatedBoard>(const SimulatorOptions &)> makeBoard;
};

/// Parses an integer within a range. Errors: InvalidArgument naming the option and its range.
Result<int> wholeNumber(const QString &name, const QString &text, int min, int max);
