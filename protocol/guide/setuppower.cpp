// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that finds how much power each motor needs.
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

// Half of the torque stays in reserve: a battery near its end gives a fifth less, a winding that is 80 °C
// warmer a quarter less, and what is left is for wind and for a push.
constexpr double kMargin = 2.0;
// Less is not searched for: below it cogging decides, and no small move shows what a gust does.
constexpr double kLeast = 50.0 / 255;
// More heats a motor without end: what needs it is out of balance, or has too small a motor.
constexpr double kMost = 0.8;
constexpr double kUp = 1.4;
constexpr double kDown = 0.7;
constexpr double kClose = 1.12;  // so near to one another are what holds and what does not in the end

constexpr double kMoveDegrees = 2;
constexpr double kPause = 0.8;  // seconds between moves
constexpr double kArriving = 0.4;  // of which it may be on its way
constexpr double kHeld = 0.5;  // degrees RMS: less is held
constexpr double kFalls = 8;  // degrees beyond the move: it is not held, and gets more power again
constexpr double kWild = 150;  // deg/s: no move of this step turns it so fast, so it runs away or oscillates
constexpr double kNear = 0.8;  // degrees
constexpr double kNearSeconds = 0.3;
constexpr double kComing = 3;  // seconds in which an axis comes back
constexpr double kLost = 25;  // degrees that an axis goes on falling away: nothing brings it back
constexpr double kHeatSeconds = 1;
constexpr double kHot = 60;  // °C: magnets and glue of small motors last to 80

}  // namespace

/// The powers that are in use for the moment, and what was before.
struct SetupGuide::PowerTrial
{
    Configuration base;
    Configuration tried;
    std::vector<Axis> axes = {};  ///< that have a motor
    std::vector<AdjustableValue> old = {};  ///< in use, in the order of the axes
    Progress told = {};
    bool isWritten = false;

    void tells(Axis axis, double power)
    {
        told.step = u"setup-power"_s;
        told.subject = QLatin1String(axisKey(axis));
        told.total = 100;
        told.values = {{u"power"_s, power}};
    }
    /// @param share of that axis' own part of the way
    void goesOn(Axis axis, double share)
    {
        const auto at = std::find(axes.begin(), axes.end(), axis) - axes.begin();
        told.done = int(100 * (double(at) + share) / double(axes.size()));
    }
};

Result<SetupResult> SetupGuide::motorPower()
{
    if (const auto run = requireMotors(); !run)
        return tl::unexpected(run.error());
    const auto read = m_device.readConfiguration(m_channel);
    if (!read)
        return tl::unexpected(read.error());
    const Configuration base = withoutLive(*read, m_live);
    PowerTrial trial{base, base};
    QList<int> ids;
    for (const Axis axis : kAxes) {
        const ParameterSpec *power = find(m_keys.motorPower, axis);
        const ParameterSpec *output = find(m_keys.motorOutput, axis);
        if (!power || !base.raw(*power, base.activeProfile())
            || (output && base.raw(*output, base.activeProfile()) == 0.0))
            continue;
        trial.axes.push_back(axis);
        ids.append(m_device.live()->variableOf(*power));
    }
    const auto old = m_device.live()->readAdjustables(m_channel, ids);
    if (!old)
        return tl::unexpected(old.error());
    if (old->empty() || old->size() != trial.axes.size())
        return failure(ErrorCode::Unsupported, u"the board does not tell the power of its motors"_s);
    trial.old = *old;
    auto result = findPowers(trial);
    if (!result)
        return tl::unexpected(powersBack(trial, result.error()));
    dropTrial(m_history, m_device.identity());
    return result;
}

Result<SetupResult> SetupGuide::findPowers(PowerTrial &trial)
{
    SetupResult before;
    if (const auto told = measureHeat(before, nullptr); !told)
        return tl::unexpected(told.error());
    SetupResult result;
    const int profile = trial.base.activeProfile();
    for (std::size_t i = 0; i < trial.axes.size(); ++i) {
        const Axis axis = trial.axes[i];
        const ParameterSpec &spec = *find(m_keys.motorPower, axis);
        const double full = spec.toDisplay(spec.row->max);
        const auto need = findPower(trial, axis);
        if (!need)
            return tl::unexpected(need.error());
        const int power = int(std::lround(std::clamp(kMargin * *need, kLeast * full, kMost * full)));
        if (kMargin * *need > kMost * full)
            result.remarks.append(u"motorpower.scarce"_s);
        if (const auto used = usePower(trial, axis, power); !used)
            return tl::unexpected(used.error());
        const double stored = *trial.base.raw(spec, profile);
        result.figures.append({setupFigureKey("motorpower", axis), double(power), stored});
        result.figures.append({setupFigureKey("need", axis), double(*need)});
        std::erase_if(m_live, [&spec](const LiveValue &value) { return value.key == spec.key; });
        m_live.push_back({spec.key, stored, double(power)});
    }
    trial.isWritten = true;
    if (!trial.base.changesTo(trial.tried).empty()) {
        if (const auto written = writeOnTrial(trial.base, trial.tried, result); !written)
            return tl::unexpected(written.error());
    }
    for (const Axis axis : trial.axes) {
        trial.tells(axis, *result.figure(setupFigureKey("motorpower", axis)));
        const auto off = probe(trial.told, axis);
        if (!off)
            return tl::unexpected(off.error());
        if (*off > kHeld)
            return failure(
                ErrorCode::NotProven,
                u"%1 is not held with the power that was found for it"_s.arg(QLatin1String(axisKey(axis))));
        result.figures.append({setupFigureKey("settles", axis), *off});
    }
    if (const auto told = measureHeat(result, &before); !told)
        return tl::unexpected(told.error());
    result.remarks.removeDuplicates();
    result.remarks.prepend(result.changes.isEmpty() ? u"motorpower.fits"_s : u"motorpower.set"_s);
    const bool isPoor = std::any_of(result.remarks.begin(), result.remarks.end(),
                                    [](const QString &remark) { return !findSetupRemark(remark)->isGood; });
    result.state = isPoor ? SetupResult::State::Poor : SetupResult::State::Done;
    return result;
}

// From what it has upwards until it is held, or downwards until it is not any more; then between the two.
Result<int> SetupGuide::findPower(PowerTrial &trial, Axis axis)
{
    const auto place = std::find(trial.axes.begin(), trial.axes.end(), axis) - trial.axes.begin();
    const ParameterSpec &spec = *find(m_keys.motorPower, axis);
    const int most = int(kMost * spec.toDisplay(spec.row->max));
    const int least = int(std::lround(kLeast / kMargin * spec.toDisplay(spec.row->max)));
    int tries = 0;
    const auto holds = [&](int power) -> Result<bool> {
        trial.goesOn(axis, 1 - std::pow(0.8, tries++));  // how many there will be nobody knows
        if (const auto used = usePower(trial, axis, power); !used)
            return tl::unexpected(used.error());
        const auto off = probe(trial.told, axis);
        return off ? Result<bool>(*off <= kHeld) : tl::unexpected(off.error());
    };
    int high = std::clamp(int(trial.old[std::size_t(place)].value), least, most);
    int low = 0;
    for (;;) {
        const auto held = holds(high);
        if (!held)
            return tl::unexpected(held.error());
        if (*held)
            break;
        if (high == most)
            return failure(
                ErrorCode::ConditionUnmet,
                u"%1 is not held with any power that its motor can bear: balance the camera, and see whether "
                "a cable pulls at it"_s.arg(QLatin1String(axisKey(axis))));
        low = std::exchange(high, std::min(most, std::max(high + 10, int(kUp * high))));
    }
    while (high > least && (low == 0 || high > kClose * low)) {
        const int next
            = low == 0 ? std::max(least, int(kDown * high)) : int(std::lround(std::sqrt(double(low) * high)));
        if (next == low || next == high)
            break;
        const auto held = holds(next);
        if (!held)
            return tl::unexpected(held.error());
        (*held ? high : low) = next;
    }
    return high;
}

// What is in use alone a restart ends; the note is for a program that ends before.
Result<void> SetupGuide::usePower(PowerTrial &trial, Axis axis, int power)
{
    const ParameterSpec &spec = *find(m_keys.motorPower, axis);
    if (const auto set = trial.tried.setRaw(spec, trial.base.activeProfile(), spec.toRaw(power)); !set)
        return set;
    if (const auto kept = keepTrial(m_history, trial.base, trial.tried); !kept)
        return kept;
    trial.tells(axis, power);
    m_channel.progress(trial.told);
    return m_device.live()->writeAdjustables(m_channel, {{m_device.live()->variableOf(spec), double(power)}});
}

Result<double> SetupGuide::probe(const Progress &told, Axis axis)
{
    constexpr double kNotHeld = std::numeric_limits<double>::infinity();
    const auto rests = comesToRest(told, axis);
    if (!rests)
        return tl::unexpected(rests.error());
    if (!*rests)
        return kNotHeld;
    MotionTestPlan plan;
    plan.axis = axis;
    plan.degrees = kMoveDegrees;
    plan.steps = 2;
    plan.rest = kPause;
    plan.limit = kFalls;
    plan.maxRate = kWild;
    plan.mayStray = true;
    plan.told = told;
    const auto moved = measureMotion(m_channel, m_device, m_telemetry, plan);
    if (!moved && moved.error().code == ErrorCode::ConditionUnmet)
        return kNotHeld;
    if (!moved)
        return tl::unexpected(moved.error());
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < moved->angle.values.size(); ++i) {
        if (std::fmod(double(i) / moved->angle.rate, kPause) < kArriving)
            continue;
        const double off = std::remainder(double(moved->target.values[i] - moved->angle.values[i]), 360.0);
        sum += off * off;
        ++count;
    }
    return std::sqrt(sum / std::max(1, count));
}

Result<bool> SetupGuide::comesToRest(const Progress &told, Axis axis)
{
    const auto at = std::size_t(axis);
    const auto away = [this, at] {
        return std::abs(std::remainder(latest(m_roles.angle[at]) - latest(m_roles.target[at]), 360.0));
    };
    const double first = away();
    const TimePoint began = m_channel.now();
    TimePoint nearSince = began;
    while (::seconds(m_channel.now() - nearSince) < kNearSeconds) {
        if (::seconds(m_channel.now() - began) > kComing)
            return false;
        m_channel.progress(told);
        if (const auto passed = letPass(); !passed)
            return tl::unexpected(passed.error());
        if (m_roles.outputs >= 0 && latest(m_roles.outputs) < 0.5)
            return failure(ErrorCode::Unready, u"the motors went off"_s);
        const double rate = m_roles.gyro[at] >= 0 ? std::abs(latest(m_roles.gyro[at])) : 0.0;
        const double now = away();
        if (now > first + kLost || (rate > kWild && now > kLost)) {
            m_channel.stopMotors(m_device.stopPlan());
            return failure(
                ErrorCode::Diverged,
                u"%1 is %2° away from its target"_s.arg(QLatin1String(axisKey(axis))).arg(now, 0, 'f', 0));
        }
        if (!(now < kNear))
            nearSince = m_channel.now();
    }
    return true;
}

Result<void> SetupGuide::measureHeat(SetupResult &result, const SetupResult *before)
{
    const auto add = [&result, before](const QString &key, double value) {
        result.figures.append({key, value, before ? before->figure(key) : std::nullopt});
    };
    if (m_roles.current >= 0 && !std::isnan(latest(m_roles.current))) {
        const auto drawn = average(m_roles.current, kHeatSeconds);
        if (!drawn)
            return tl::unexpected(drawn.error());
        if (*drawn > 0)  // what has no sensor for it says zero
            add(u"current"_s, *drawn);
    }
    bool isTold = false;
    for (const Axis axis : kAxes) {
        const int channel = m_roles.motorTemperature[std::size_t(axis)];
        const double celsius = channel >= 0 ? latest(channel) : std::numeric_limits<double>::quiet_NaN();
        if (std::isnan(celsius) || celsius == 0)
            continue;
        isTold = true;
        add(setupFigureKey("heat", axis), celsius);
        if (celsius >= kHot)
            result.remarks.append(u"motorpower.hot"_s);
    }
    result.remarks.append(isTold ? u"motorpower.warms"_s : u"motorpower.untold"_s);
    return {};
}

// What was in use is so again, and proven; what was written is written back.
Error SetupGuide::powersBack(const PowerTrial &trial, const Error &why)
{
    if (!trial.isWritten) {
        const Unbroken unbroken(m_channel);
        if (m_device.live()->restoreAdjustables(m_channel, trial.old)) {
            dropTrial(m_history, m_device.identity());
            return why;
        }
    }
    return takenBack(why);
}
