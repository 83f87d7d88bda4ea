// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/droneobstacle.h"

#include "app/workspace/flightstate.h"
#include "app/workspace/workspace.h"

#include <QCoreApplication>

namespace {

/// The context of the catalogue.
class Obstacle
{
    Q_DECLARE_TR_FUNCTIONS(DroneObstacle)
};

}  // namespace

QString droneObstacle(const Workspace &workspace, Calibration calibration)
{
    const DeviceClient &client = workspace.client();
    if (!client.isConnected())
        return Obstacle::tr("Not connected.");
    if (!client.identity().writable)
        return Obstacle::tr(
            "This drone is only looked at: its generation of the protocol is not known well enough.");
    switch (flightState(workspace)) {
    case ArmedState::State::Armed: return Obstacle::tr("The drone is armed.");
    case ArmedState::State::RunsOn: return Obstacle::tr("Motors are driven already.");
    case ArmedState::State::Awaited:
    case ArmedState::State::Unknown: return Obstacle::tr("Whether it is armed is not known at present.");
    case ArmedState::State::Calibrating: return Obstacle::tr("It calibrates.");
    case ArmedState::State::NotCalibrated:
        if (calibration == Calibration::Needed)
            return Obstacle::tr(
                "Calibrate it first: without that, a motor test hangs it until it is switched off.");
        break;
    case ArmedState::State::Disarmed:
    case ArmedState::State::OutputsUnknown: break;
    }
    return {};
}
