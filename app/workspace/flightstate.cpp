// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/flightstate.h"

#include "app/workspace/workspace.h"
#include "protocol/device/device.h"
#include "protocol/device/flight.h"
#include "protocol/device/motorlayout.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/views/attitudeview.h"

#include <QCoreApplication>

#include <cmath>

std::optional<bool> freshlyTold(const Workspace &workspace, int channel)
{
    const auto store = workspace.client().telemetry();
    const double value = workspace.latest(channel);
    if (!workspace.client().isConnected() || !store || channel < 0 || std::isnan(value)
        || Clock::now() - store->latestAt(channel) > kOldFlightState)
        return {};
    return value != 0;
}

TimePoint lastToldZero(const Workspace &workspace, int channel, TimePoint since)
{
    const auto store = workspace.client().telemetry();
    if (!store || channel < 0)
        return {};
    const double from = store->secondsAt(since);
    std::optional<double> last;
    for (TrackView &track : store->tracks(channel)) {
        track.refresh();
        for (std::size_t row = track.end(); row > track.begin() && track.time(row - 1) >= from; --row) {
            if (track.value(row - 1) != 0)
                continue;
            last = std::max(last.value_or(from), track.time(row - 1));
            break;
        }
    }
    return last ? store->origin() + std::chrono::round<Duration>(std::chrono::duration<double>(*last))
                : TimePoint{};
}

ArmedState::State flightState(const Workspace &workspace)
{
    const ChannelRoles &roles = workspace.roles();
    // What it said before says nothing of the test that it carries out.
    if (workspace.isDeaf())
        return ArmedState::State::RunsOn;
    const auto told = ArmedState::stateOf(
        freshlyTold(workspace, roles.armed), freshlyTold(workspace, roles.calibrated),
        freshlyTold(workspace, roles.calibrating), freshlyTold(workspace, roles.outputs));
    // What it said before it was armed from here, or disarmed, says nothing of what has become of that.
    const bool isAwaited = workspace.isFlown() || workspace.mayStillFly();
    return isAwaited && ArmedState::isDisarmed(told) ? ArmedState::State::Awaited : told;
}

QByteArray axesKey(const Workspace &workspace)
{
    const Device *device = workspace.isBoardRead() ? workspace.client().device() : nullptr;
    const ConfigurationModel &shown = workspace.configuration();
    return device && device->flight() && !shown.isEmpty() ? device->flight()->axesKey(shown.board())
                                                          : QByteArray();
}

namespace {

// What was checked holds for what the sticks were pushed with: the screen, or a gamepad as it is assigned.
QByteArray handsKey(Workspace &workspace)
{
    if (!workspace.settings().gamepadSteers())
        return {};
    const GamepadMapping mapping = workspace.gamepad().mapping();
    QByteArray text;
    for (const GamepadStick stick : {GamepadStick::Roll, GamepadStick::Pitch, GamepadStick::Yaw})
        text += '-' + QByteArray::number(mapping[stick].axis) + (mapping[stick].inverted ? 'i' : 'n');
    return text;
}

// What was answered about the drone itself, whatever its sticks were pushed with.
const QByteArray kDroneAlone = "-drone";

// As it is kept: what was found, and since when.
QByteArray datedToday(const CheckedDirections &found)
{
    return found.encode() + '@' + QDate::currentDate().toString(Qt::ISODate).toLatin1();
}

PresumedDirections directionsIn(const QByteArray &kept)
{
    const QList<QByteArray> parts = kept.split('@');
    return {CheckedDirections::decode(parts.value(0)),
            QDate::fromString(QString::fromLatin1(parts.value(1)), Qt::ISODate)};
}

CheckedDirections directionsKept(Workspace &workspace, const QByteArray &hands)
{
    const QByteArray key = axesKey(workspace);
    if (key.isEmpty())
        return {};
    const QString board = workspace.naming().lastingKey();
    return directionsIn(board.isEmpty()
                            ? workspace.naming().untilReconnected().value(hands + ' ' + key)
                            : workspace.settings().checkedDirections(board + QString::fromLatin1(hands), key))
        .found;
}

}  // namespace

CheckedDirections checkedDirections(Workspace &workspace)
{
    return directionsKept(workspace, handsKey(workspace));
}

PresumedDirections presumedDirections(Workspace &workspace)
{
    const QString board = workspace.naming().presumedKey();
    if (workspace.naming().isCertain() || board.isEmpty())
        return {};
    return directionsIn(
        workspace.settings().checkedDirections(board + QString::fromLatin1(kDroneAlone), axesKey(workspace)));
}

CheckedDirections droneDirections(Workspace &workspace)
{
    return directionsKept(workspace, kDroneAlone);
}

void keepDirections(Workspace &workspace, const CheckedDirections &found)
{
    const QByteArray key = axesKey(workspace);
    const QString board = workspace.naming().lastingKey();
    for (const QByteArray &hands : {handsKey(workspace), kDroneAlone}) {
        if (board.isEmpty())
            workspace.naming().untilReconnected().insert(hands + ' ' + key, datedToday(found));
        else
            workspace.settings().setCheckedDirections(board + QString::fromLatin1(hands), key,
                                                      datedToday(found));
    }
}

void dropDirections(Workspace &workspace)
{
    workspace.naming().untilReconnected().clear();
    if (const QString board = workspace.naming().presumedKey(); !board.isEmpty())
        workspace.settings().dropDirections(board);
}

void keepDirectionsByName(Workspace &workspace)
{
    const QString board = workspace.naming().lastingKey();
    auto &passing = workspace.naming().untilReconnected();
    for (auto it = passing.cbegin(); !board.isEmpty() && it != passing.cend(); ++it) {
        const qsizetype end = it.key().indexOf(' ');
        workspace.settings().setCheckedDirections(board + QString::fromLatin1(it.key().left(end)),
                                                  it.key().mid(end + 1), it.value());
    }
    passing.clear();
}

namespace {

// NaN before a calibration, when the board tells 0 or what it was long ago.
double flightAngle(const Workspace &workspace, std::size_t axis)
{
    const ChannelRoles &roles = workspace.roles();
    return freshlyTold(workspace, roles.calibrated).value_or(false) ? workspace.latest(roles.angle[axis])
                                                                    : qQNaN();
}

}  // namespace

std::array<int, kAxisCount> shownSigns(Workspace &workspace)
{
    // Found is what grows with the nose down; a horizon is drawn by what grows with the nose up.
    const CheckedDirections found = droneDirections(workspace);
    const bool isFound = found.level != CheckedDirections::Level::Nothing;
    return {found.angles[0], isFound ? -found.angles[1] : 1, found.angles[2]};
}

std::array<double, kAxisCount> shownAngles(Workspace &workspace)
{
    const auto signs = shownSigns(workspace);
    return {signs[0] * flightAngle(workspace, 0), signs[1] * flightAngle(workspace, 1),
            signs[2] * flightAngle(workspace, 2)};
}

void showAttitude(Workspace &workspace, AttitudeView &view)
{
    view.setPlaceholder(
        flightState(workspace) == ArmedState::State::NotCalibrated
            ? QCoreApplication::translate("Workspace", "It tells no attitude before a calibration")
            : QCoreApplication::translate("Workspace", "No attitude yet"));
    const auto angles = shownAngles(workspace);
    view.setAttitude(angles[0], angles[1], angles[2]);
}

int motorCount(const Workspace &workspace)
{
    int count = 0;
    for (const int channel : workspace.roles().motors)
        count += std::isnan(workspace.latest(channel)) ? 0 : 1;
    return count;
}

void showMotors(Workspace &workspace, MotorDiagram &diagram)
{
    const MotorLayout *layout = workspace.tables() ? workspace.tables()->motorLayout() : nullptr;
    const ConfigurationModel &model = workspace.configuration();
    std::vector<MotorShare> shares
        = layout && !model.isEmpty() ? layout->motorShares(model.board()) : std::vector<MotorShare>();
    const CheckedDirections found = droneDirections(workspace);
    for (MotorShare &share : shares) {
        share.roll *= found.motors[0];
        share.pitch *= found.motors[1];
        share.yaw *= found.motors[2];
    }
    diagram.setSidesKnown(found.level == CheckedDirections::Level::All);
    const int told = motorCount(workspace);
    diagram.setMotors(told > 0 ? told : int(shares.size()), shares);
    std::vector<double> outputs;
    for (const int channel : workspace.roles().motors)
        outputs.push_back(workspace.latest(channel));
    diagram.setOutputs(outputs);
}
