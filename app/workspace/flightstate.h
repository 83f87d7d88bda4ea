// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedure/directioncheck.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/motordiagram.h"

class AttitudeView;
class Workspace;

// What every page that shows a flying machine says of it, by roles.

/// Armed, calibrated and so on, as the board has reported within the last moment; older is not known.
[[nodiscard]] ArmedState::State flightState(const Workspace &workspace);
/// Whether a channel's newest value is not 0; empty: there is none, or it is old.
[[nodiscard]] std::optional<bool> freshlyTold(const Workspace &workspace, int channel);
/// When a channel was told last to be 0, not before `since`; TimePoint{}: it was not.
[[nodiscard]] TimePoint lastToldZero(const Workspace &workspace, int channel, TimePoint since);
/// What decides how the board shown counts its axes (FlyingMachine::axesKey); empty: nothing flies, or
/// nothing was read on this connection.
[[nodiscard]] QByteArray axesKey(const Workspace &workspace);
/// What a check of its directions has found, if there was one since that has changed.
[[nodiscard]] CheckedDirections checkedDirections(Workspace &workspace);
/// What was kept about a drone that the connected one is taken for, and nobody has said that it is it.
struct PresumedDirections
{
    CheckedDirections found;
    QDate on;  ///< invalid: an earlier version has kept it
};
[[nodiscard]] PresumedDirections presumedDirections(Workspace &workspace);
/// What it has found of the drone itself: its angles and where its motors are; its sticks may not hold.
[[nodiscard]] CheckedDirections droneDirections(Workspace &workspace);
/// Keeps it for this board; until the next connection where nobody has said which one it is.
void keepDirections(Workspace &workspace, const CheckedDirections &found);
/// Another program may count its axes otherwise: nothing that was found before holds.
void dropDirections(Workspace &workspace);
/// The board has a name now: what was kept until the next connection is kept with it.
void keepDirectionsByName(Workspace &workspace);
/// What the board's angles are multiplied by where they are shown as the check of directions has found them;
/// 1 without one.
[[nodiscard]] std::array<int, kAxisCount> shownSigns(Workspace &workspace);
/// Degrees as the check of directions has found them: to the right, nose up, turned to the right; without one
/// as the board tells them. NaN: not known.
[[nodiscard]] std::array<double, kAxisCount> shownAngles(Workspace &workspace);
/// Draws them, or says why there are none.
void showAttitude(Workspace &workspace, AttitudeView &view);
/// How many numbered motors the board has reported so far; 0: it has not.
[[nodiscard]] int motorCount(const Workspace &workspace);
/// Gives the diagram the motors of the board, with their places as far as its configuration tells them, and
/// what they are driven with.
void showMotors(Workspace &workspace, MotorDiagram &diagram);
