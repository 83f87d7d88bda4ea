// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that finds what each motor is: one at a time, with little power.
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Shares of full power: the first turns a camera that is balanced, the last does not yet tear at a cable.
constexpr double kGentle = 0.2;
constexpr double kMostGentle = 0.5;
constexpr double kFirmer = 1.5;
constexpr double kTurns = 2;  // °/s RMS: what turns less was not turned
constexpr double kClearly = 2;  // times more than any other axis, which the hand moves
constexpr double kAloneSeconds = 1.5;
constexpr double kTogetherSeconds = 2.5;
constexpr double kObeys = 1;  // degrees RMS off its targets: an axis that does not move at all has 1.4
constexpr double kRunaway = 25;  // degrees away from the target
constexpr double kGoesOn = 8;  // degrees further away than at first: it does not fall back to its target
constexpr double kTooFast = 200;  // deg/s: no motor that holds turns so fast
constexpr double kAway = 8;  // degrees: where it counts how fast

double rmsOf(const std::vector<float> &values)
{
    double sum = 0;
    for (const float value : values)
        sum += double(value) * double(value);
    return values.empty() ? 0.0 : std::sqrt(sum / double(values.size()));
}

}  // namespace

/// How the board was, what it holds now, and what is found of the motors.
struct SetupGuide::MotorTrial
{
    Configuration origin;
    Configuration board;
    std::vector<Axis> axes = {};  ///< that have a motor
    std::array<double, kAxisCount> output = {};
    std::array<double, kAxisCount> power = {};  ///< with which it turns the camera
};

Result<SetupResult> SetupGuide::motors()
{
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    // What nobody knows yet does not hold the camera.
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    MotorTrial trial{*base, *base};
    for (const Axis axis : kAxes) {
        const ParameterSpec *output = find(m_keys.motorOutput, axis);
        const auto is = output ? base->raw(*output, base->activeProfile()) : std::nullopt;
        if (is.value_or(0) == 0.0)
            continue;
        trial.axes.push_back(axis);
        trial.output[std::size_t(axis)] = *is;
        trial.power[std::size_t(axis)] = kGentle * fullPower(axis);
    }
    if (trial.axes.empty())
        return failure(ErrorCode::ConditionUnmet, u"no axis has a motor output: set them first"_s);
    auto result = findMotors(trial);
    if (!result) {
        // Whoever gives it up does not leave what nobody has seen to hold.
        m_channel.stopMotors(m_device.stopPlan());
        return tl::unexpected(motorsBack(trial, result.error()));
    }
    dropTrial(m_history, m_device.identity());
    return result;
}

double SetupGuide::fullPower(Axis axis) const
{
    const ParameterSpec *spec = find(m_keys.motorPower, axis);
    return spec ? spec->toDisplay(spec->row->max) : 0.0;
}

Result<SetupResult> SetupGuide::findMotors(MotorTrial &trial)
{
    SetupResult result;
    for (const Axis axis : trial.axes) {
        if (const auto found = findMotor(trial, axis, result); !found)
            return tl::unexpected(found.error());
    }
    // All of them, first with the power that was enough for each, then with their own.
    if (const auto used = useMotors(trial, withMotors(trial, {}), result); !used)
        return tl::unexpected(used.error());
    m_channel.allowMotors();
    if (const auto on = m_device.motorSwitch()->switchMotorsOn(m_channel); !on)
        return tl::unexpected(on.error());
    Figures strays{};
    if (const auto run = watchMotors(trial.axes, kTogetherSeconds, u"setup-run"_s, strays); !run)
        return tl::unexpected(run.error());
    Configuration own = trial.board;
    const int profile = own.activeProfile();
    for (const Axis axis : trial.axes) {
        const ParameterSpec &power = *find(m_keys.motorPower, axis);
        const double before = *trial.origin.raw(power, profile);
        const double enough = power.toRaw(std::round(trial.power[std::size_t(axis)]));
        if (const auto set = own.setRaw(power, profile, std::max(before, enough)); !set)
            return tl::unexpected(set.error());
    }
    if (const auto used = useMotors(trial, own, result); !used)
        return tl::unexpected(used.error());
    strays = {};  // so far they hold how the camera had hung when the motors came on
    if (const auto run = watchMotors(trial.axes, kTogetherSeconds, u"setup-run"_s, strays); !run)
        return tl::unexpected(run.error());
    list(trial.origin, trial.board, result);
    for (const Axis axis : trial.axes) {
        const ParameterSpec *spec = find(m_keys.poles, axis);
        const auto is = spec ? trial.board.raw(*spec, profile) : std::nullopt;
        const auto was = spec ? trial.origin.raw(*spec, profile) : std::nullopt;
        if (is && was)
            result.figures.append({setupFigureKey("poles", axis), spec->toDisplay(*is),
                                   *is == *was ? std::nullopt : std::optional(spec->toDisplay(*was))});
        result.figures.append({setupFigureKey("strays", axis), strays[std::size_t(axis)]});
    }
    result.remarks.removeDuplicates();
    result.remarks.prepend(result.changes.isEmpty() ? u"motors.same"_s : u"motors.changed"_s);
    result.remarks.append(u"motors.hold"_s);
    return result;
}

// The others are off meanwhile, and it gets no more power than it needs to turn the camera.
Result<void> SetupGuide::findMotor(MotorTrial &trial, Axis axis, SetupResult &result)
{
    double &power = trial.power[std::size_t(axis)];
    const double most = kMostGentle * fullPower(axis);
    for (std::size_t swaps = 0;;) {
        if (const auto used = useMotors(trial, withMotors(trial, axis), result); !used)
            return used;
        const auto turned = turnMotor(trial, axis);
        if (!turned)
            return tl::unexpected(turned.error());
        const Axis other = turned->axis;
        if (other != axis && std::ranges::count(trial.axes, other) > 0 && swaps < trial.axes.size()) {
            std::swap(trial.output[std::size_t(axis)], trial.output[std::size_t(other)]);
            result.remarks.append(u"motors.outputs"_s);
            ++swaps;
            continue;
        }
        const auto follows = other == axis && turned->isFound ? runAlone(trial, axis, result) : false;
        if (!follows)
            return tl::unexpected(follows.error());
        if (*follows)
            break;
        if (power >= most)
            return failure(ErrorCode::ConditionUnmet,
                           u"the motor of %1 does not turn the camera: see whether it is connected, and "
                           "nothing is in its way"_s.arg(QLatin1String(axisKey(axis))));
        power = std::min(most, kFirmer * power);
    }
    result.figures.append({setupFigureKey("gentle", axis), std::round(power)});
    return {};
}

// Not broken off in the middle, as the board would go on, and store what it finds.
Result<SetupGuide::TurnedMotor> SetupGuide::turnMotor(MotorTrial &trial, Axis axis)
{
    const double from = m_telemetry.secondsAt(m_channel.now());
    TurnedMotor turned;
    {
        const Unbroken unbroken(m_channel);
        const auto done
            = performSafely(m_channel, m_device, m_keys.findPoles, {}, m_history, m_live, &m_telemetry);
        if (!done && done.error().code != ErrorCode::BoardError)
            return tl::unexpected(done.error());
        turned.isFound = done.has_value();
        const auto now = m_device.readConfiguration(m_channel);
        if (!now)
            return tl::unexpected(now.error());
        trial.board = *now;
        if (const auto kept = keepTrial(m_history, trial.origin, trial.board); !kept)
            return tl::unexpected(kept.error());
    }
    Figures rates{};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (m_roles.gyro[i] < 0)
            continue;
        const auto samples
            = uniformSamples(m_telemetry, m_roles.gyro[i], -1, from, m_telemetry.secondsAt(m_channel.now()));
        if (!samples)
            return tl::unexpected(samples.error());
        rates[i] = rmsOf(samples->values);
    }
    const auto most = std::size_t(std::ranges::max_element(rates) - rates.begin());
    const bool isClear = rates[most] > kTurns
        && std::ranges::count_if(rates, [&](double rate) { return rate * kClearly > rates[most]; }) == 1;
    // Where a hand moves it as much, the board's own word counts.
    turned.axis = isClear ? kAxes[most] : turned.isFound ? axis : Axis::None;
    return turned;
}

// What runs away turns the wrong way; the other way round it is tried once more.
Result<bool> SetupGuide::runAlone(MotorTrial &trial, Axis axis, SetupResult &result)
{
    const auto run = [&]() -> Result<bool> {
        m_channel.allowMotors();
        if (const auto on = m_device.motorSwitch()->switchMotorsOn(m_channel); !on)
            return tl::unexpected(on.error());
        const QString step = u"setup-motor-"_s + QLatin1String(axisKey(axis));
        Figures strays{};
        if (const auto held = watchMotors({axis}, kAloneSeconds, step, strays); !held)
            return tl::unexpected(held.error());
        Progress told;
        told.step = step;
        told.done = told.total = 100;
        const auto off = tellsTargets(m_device) ? probe(told, axis) : Result<double>(0.0);
        return off ? Result<bool>(*off < kObeys) : tl::unexpected(off.error());
    };
    auto follows = run();
    if (!follows && follows.error().code == ErrorCode::Diverged) {
        if (const auto off = switchOff(); !off)
            return tl::unexpected(off.error());
        const auto now = m_device.readConfiguration(m_channel);
        if (!now)
            return tl::unexpected(now.error());
        trial.board = *now;
        const ParameterSpec *invert = find(m_keys.motorInverted, axis);
        const auto is = invert ? now->raw(*invert, now->activeProfile()) : std::nullopt;
        if (!is)
            return follows;
        Configuration turned = *now;
        if (const auto set = turned.setRaw(*invert, turned.activeProfile(), *is == 0.0 ? 1 : 0); !set)
            return tl::unexpected(set.error());
        if (const auto used = useMotors(trial, turned, result); !used)
            return tl::unexpected(used.error());
        result.remarks.append(u"motors.turned"_s);
        follows = run();
    }
    if (!follows)
        return follows;
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    return follows;
}

Result<void> SetupGuide::watchMotors(const std::vector<Axis> &axes, double seconds, const QString &step,
                                     Figures &strays)
{
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.angle, m_roles.gyro})); !news)
        return news;
    const auto away = [this](std::size_t at) {
        const double target = m_roles.target[at] >= 0 ? latest(m_roles.target[at]) : 0.0;
        return std::remainder(latest(m_roles.angle[at]) - target, 360.0);
    };
    Figures first{};
    for (const Axis axis : axes)
        first[std::size_t(axis)] = std::abs(away(std::size_t(axis)));
    const auto look = [&]() -> Result<void> {
        for (const Axis axis : axes) {
            const auto at = std::size_t(axis);
            const double off = away(at);
            const double rate = m_roles.gyro[at] >= 0 ? std::abs(latest(m_roles.gyro[at])) : 0.0;
            strays[at] = std::max(strays[at], std::abs(off));
            const bool isFar = std::abs(off) > std::max(kRunaway, first[at] + kGoesOn);
            const bool isWild = rate > kTooFast && std::abs(off) > std::max(kAway, first[at]);
            if (!isFar && !isWild)
                continue;
            m_channel.stopMotors(m_device.stopPlan());
            return failure(
                ErrorCode::Diverged,
                u"%1 is %2° away from its target"_s.arg(QLatin1String(axisKey(axis))).arg(off, 0, 'f', 0));
        }
        return {};
    };
    return watch(seconds, look, step);
}

// Outputs and powers as they are known; with an axis, that one alone.
Configuration SetupGuide::withMotors(const MotorTrial &trial, std::optional<Axis> alone) const
{
    Configuration edited = trial.board;
    const int profile = edited.activeProfile();
    for (const Axis axis : trial.axes) {
        const auto at = std::size_t(axis);
        const ParameterSpec &power = *find(m_keys.motorPower, axis);
        std::ignore = edited.setRaw(*find(m_keys.motorOutput, axis), profile,
                                    alone.value_or(axis) == axis ? trial.output[at] : 0.0);
        std::ignore = edited.setRaw(power, profile, power.toRaw(std::round(trial.power[at])));
    }
    return edited;
}

Result<void> SetupGuide::useMotors(MotorTrial &trial, const Configuration &edited, SetupResult &result)
{
    if (trial.board.changesTo(edited).empty())
        return {};
    if (const auto kept = keepTrial(m_history, trial.origin, edited, &trial.board); !kept)
        return kept;
    const Unbroken unbroken(m_channel);
    const auto report = writeConfiguration(
        m_channel, m_device, trial.board, edited,
        {.history = &m_history, .backupDone = !result.snapshot.isEmpty(), .live = m_live});
    if (!report)
        return tl::unexpected(report.error());
    if (result.snapshot.isEmpty())
        result.snapshot = report->snapshotPath;
    if (report->error)
        return tl::unexpected(*report->error);
    trial.board = edited;
    return {};
}

// What the board has found by itself is taken back, too.
Error SetupGuide::motorsBack(const MotorTrial &trial, const Error &why)
{
    {
        const Unbroken unbroken(m_channel);
        if (const auto now = m_device.readConfiguration(m_channel))
            std::ignore = keepTrial(m_history, trial.origin, *now);
    }
    return takenBack(why);
}
