// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a drone is steered and stopped (errata 4.3, 9).
#include "protocol/bcflight/decoder.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/luadoubts.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/tables.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/stopplan.h"

#include <QCoreApplication>
#include <QCryptographicHash>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr auto kStopAtFullRate = 500ms;  // errata 9.2, 2
constexpr auto kDisarms = 1s;
constexpr auto kLookAgain = 100ms;

// clang-format off
constexpr Choice kArmChoices[] = {{0, "disarmed"}, {1, "armed"}};
constexpr SteeringSwitch kArmSwitch[] = {{.key = "arm", .label = "Arm", .choices = kArmChoices, .arms = true}};
// clang-format on

// "Disarmed" does not mean that the motors stand (errata 9.2, 8): outputs that are streamed tell.
Proof standsStill(const LatestValues &latest, TimePoint since)
{
    if (latest.latestAt(Armed) <= since || std::isnan(latest.latest(Armed)))
        return Proof::Nothing;
    if (latest.latest(Armed) != 0)
        return Proof::Refuted;
    // Where they have had the time to tell and do not, its word has to do; whoever reports it says so.
    if (latest.latestAt(Outputs) <= since)
        return latest.latestAt(Armed) >= since + kOutputsTold ? Proof::Proven : Proof::Nothing;
    if (std::isnan(latest.latest(Outputs)))
        return Proof::Nothing;
    return latest.latest(Outputs) == 0 ? Proof::Proven : Proof::Refuted;
}

}  // namespace

std::span<const SteeringMode> Device::modes() const
{
    // clang-format off
    static const std::vector<SteeringMode> all{{1, "fly", "Fly", {
        {.key = "throttle", .label = "Throttle", .min = 0, .max = 1, .springsBack = false},
        {.key = "roll", .label = "Roll", .axis = Axis::Roll},
        {.key = "pitch", .label = "Pitch", .axis = Axis::Pitch},
        {.key = "yaw", .label = "Yaw", .axis = Axis::Yaw},
    }}};
    // clang-format on
    return all;
}

std::span<const SteeringSwitch> Device::switches() const
{
    return kArmSwitch;
}

SteeringSetpoint Device::holdingSetpoint(int mode, const LatestValues &, SteeredBefore) const
{
    return {mode, {0, 0, 0, 0}, {0}};
}

// What ends it is the strongest there is: disarmed controls, and the only message that stops motors in any
// state, in one packet (errata 6.4, 9.2).
ControlFrames Device::controlFrames(const SteeringSetpoint &setpoint) const
{
    const auto input = [&setpoint](std::size_t at, double least) {
        const double wanted = at < setpoint.inputs.size() ? setpoint.inputs[at] : 0.0;
        return std::isnan(wanted) ? 0.0 : std::clamp(wanted, least, 1.0);
    };
    Controls wanted;
    wanted.arm = !setpoint.switches.empty() && setpoint.switches.front() == 1;
    wanted.thrust = input(0, 0);
    wanted.roll = input(1, -1);
    wanted.pitch = input(2, -1);
    wanted.yaw = input(3, -1);
    ControlFrames frames;
    frames.setpoint = encode(Message::Controls, wanted.encode(m_generation), m_generation);
    // Armed is a level (9.1): what another ground disarms, the next set-point arms again, 20 ms later. So
    // each one asks before it arms, in its packet: a disarming in between is always told, whoever ordered it.
    if (wanted.arm)
        frames.setpoint.prepend(statusQuestion().bytes);
    frames.stop = encode(Message::Controls, Controls().encode(m_generation), m_generation)
        + encode(Message::ResetMotors, {}, m_generation);
    frames.release = encode(Message::ResetMotors, {}, m_generation);
    frames.stopFor = kStopAtFullRate;
    frames.begun = setpoint.begun;
    frames.question = statusQuestion();
    frames.stopped = standsStill;
    return frames;
}

const char *Device::refusal() const
{
    if (m_generation < Generation::F)
        return QT_TRANSLATE_NOOP("Tables",
                                 "The generation of its protocol is not one that may be steered (F or G): a "
                                 "packet of another one could be taken for commands.");
    if (!m_isWhole)
        return QT_TRANSLATE_NOOP("Tables",
                                 "Nothing is steered over TCP: if the link closes, the motors go on turning, "
                                 "and disarming does not stop them. Connect by UDP to fly.");
    return "";
}

QByteArray Device::axesKey(const Configuration &configuration) const
{
    constexpr BlockKey kText{0, ConfigurationText};
    QByteArray text = configuration.block(kText);
    // One that did not come this time is shown as it was read before.
    if (text.isEmpty() || configuration.findMissing(kText))
        return {};
    for (const QString &name : {u"pid_roll"_s, u"pid_pitch"_s, u"pid_yaw"_s}) {
        const auto gains = findGains(text, name);
        if (!gains)
            continue;
        // How strong they are is no matter, which way they work is.
        QByteArray signs;
        for (const Literal &gain : *gains)
            signs += gain.value < 0 ? '-' : '+';
        text.replace(gains->front().from, gains->back().to - gains->front().from, signs);
    }
    text += configuration.identity().firmware.toUtf8();
    return QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex();
}

std::vector<ScriptMistake> Device::doubts(const Configuration &wanted, const Configuration &board) const
{
    const BlockKey key{0, ConfigurationText};
    return findDoubts(wanted.block(key), board.isEmpty() ? QByteArray() : board.block(key));
}

Result<void> Device::checkMaySend(Channel &channel, Message id) const
{
    switch (findMessage(id)->maySend) {
    case MaySend::Anytime: return {};
    case MaySend::Disarmed: return checkDisarmed(channel);
    case MaySend::Tuning: return checkTunable(channel).map([](bool) {});
    case MaySend::Steering:
    case MaySend::Never: break;
    }
    return failure(ErrorCode::ConditionUnmet,
                   u"%1 is not sent from here"_s.arg(QLatin1String(findMessage(id)->name)));
}

Result<void> Device::checkMayTake(Channel &channel, const RawCommand &command)
{
    const MessageSpec *spec = findMessage(command.name);
    return spec ? checkMaySend(channel, spec->id)
                : failure(ErrorCode::InvalidArgument, u"there is no message '%1'"_s.arg(command.name));
}

// Whoever asks, and whatever a page has overlooked: an older one takes a packet for something else.
Result<void> Device::checkDisarmed(Channel &channel) const
{
    if (!m_identity.writable)
        return failure(ErrorCode::ReadOnly, m_identity.firmware);
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    if (now->armed)
        return failure(ErrorCode::ConditionUnmet, u"the drone is armed"_s);
    if (now->calibrating)
        return failure(ErrorCode::ConditionUnmet, u"the drone is calibrating"_s);
    return {};
}

Result<bool> Device::checkTunable(Channel &channel) const
{
    const TimePoint until = channel.now() + kDisarms;
    auto now = status(channel);
    while (now && now->armed && !m_isHeld && channel.now() < until) {
        if (const auto slept = channel.sleep(kLookAgain); !slept)
            return tl::unexpected(slept.error());
        now = status(channel);
    }
    if (!now)
        return tl::unexpected(now.error());
    if (now->armed && m_isHeld)
        return true;
    return checkDisarmed(channel).map([] { return false; });
}

// Errata 9.2: disarm, stop whatever the state, and ask until it says so and its outputs stand.
StopPlan Device::stopPlan() const
{
    StopPlan plan;
    std::vector<Request> requests{order(Message::ResetMotors)};
    if (m_generation >= Generation::F)
        requests.insert(requests.begin(), order(Message::Controls, Controls().encode(m_generation)));
    requests.push_back(statusQuestion());
    plan.means = {{requests, 100ms, 30}};
    // During a motor test it hears nothing, and then all at once (errata 7.7).
    plan.firstHeard = {order(Message::ResetMotors)};
    plan.fromTelemetry = standsStill;
    return plan;
}

}  // namespace bcflight
