// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is found and replaced in a drone's configuration text (errata 7.2). It is Lua; it is read, never run.
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace bcflight {

/// A number in the text: where it stands, from a byte to behind one.
struct Literal
{
    qsizetype from = 0;
    qsizetype to = 0;
    double value = 0;
};

/// The three numbers of `name = PID( p, i, d )`.
using GainLiterals = std::array<Literal, 3>;

/// The names of the rate controller's gains: roll, pitch, yaw (errata 7.2).
inline constexpr std::array kGainNames{"pid_roll", "pid_pitch", "pid_yaw"};
/// Finds a name's three gains. Errors: ConditionUnmet (not there outside comments and strings, or more than
/// once, or something else than three plain numbers; the detail has the lines, the place the one to mend).
[[nodiscard]] Result<GainLiterals> findGains(const QByteArray &text, const QString &name);

/// Value of `name = a * b ...`, a number or a product of numbers; 1 where the name is not set. Errors:
/// ConditionUnmet.
[[nodiscard]] Result<double> findScale(const QByteArray &text, const QString &name);

/// The three scales of gains: PID.pscale, .iscale, .dscale.
[[nodiscard]] Result<std::array<double, 3>> findScales(const QByteArray &text);

/// The number of which the drone makes this gain by its scale: as short as it can be, also where the drone
/// computes in single precision at each step. @param scale not 0
[[nodiscard]] double literalFor(float gain, double scale);
/// The same for the screen: the shortest of which it can have made this gain.
[[nodiscard]] double figureFor(float gain, double scale);

/// As alike as the drone's arithmetic, in single precision at one step or another, can leave them.
[[nodiscard]] bool isSameGain(float a, float b);

/// The text with another number there; all else stays byte for byte. As short as it reads back the same in
/// single precision, which is what the drone computes with.
[[nodiscard]] QByteArray replaced(const QByteArray &text, const Literal &literal, double value);

/// How a motor takes part in each motion: roll, pitch, yaw, thrust.
using MotorMix = std::array<double, 4>;
/// The rows `Vector( roll, pitch, yaw, thrust )` of the motors, in their order. Empty: none was found, or
/// they are not four plain numbers each.
[[nodiscard]] std::vector<MotorMix> findMotors(const QByteArray &text);
/// Where each of those rows stands.
[[nodiscard]] std::vector<qsizetype> motorRows(const QByteArray &text);
/// Entries of the one table that is set as `name = { ... }`; empty: there is none, or more than one.
[[nodiscard]] std::optional<int> countEntries(const QByteArray &text, const QString &name);

/// The line, from 1, in which a byte stands.
[[nodiscard]] int lineAt(const QByteArray &text, qsizetype position);

/// The same text with spaces for comments and the contents of strings, so that what is found in it is code.
[[nodiscard]] QByteArray onlyCode(const QByteArray &text);

/// Where an escape of later versions of Lua, \u{, stands in a quoted string; -1: nowhere.
[[nodiscard]] qsizetype laterEscape(const QByteArray &text);

}  // namespace bcflight
