// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the supervisor tells of the board as a whole, when an alarm is over, and what it cannot see.
#include "protocol/base/battery.h"
#include "protocol/supervisor/supervisor.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace {

constexpr double kCellRise = 0.1;  // until a low battery is none any more
constexpr double kCooler = 5.0;
constexpr double kSensorsFound = 5.0;  // seconds that a board that starts may look for its sensors
constexpr double kNotComing = 3.0;
constexpr double kEnoughHz = 60.0;
constexpr double kStillTurning = 0.7;  // seconds: outputs may be told later than the state
constexpr double kSlowHz = 2.5;

}  // namespace

QSet<AlarmKind> Supervisor::possible(const ChannelRoles &roles)
{
    const auto any = [](const std::array<int, 3> &channels) {
        return std::any_of(channels.begin(), channels.end(), [](int channel) { return channel >= 0; });
    };
    QSet<AlarmKind> kinds{AlarmKind::Stale};
    if (roles.armed >= 0 && roles.outputs >= 0)
        kinds.insert(AlarmKind::Disarmed);
    if (any(roles.angle))
        kinds.insert(AlarmKind::Runaway);
    if (any(roles.gyro))
        kinds.insert(AlarmKind::Oscillation);
    if (any(roles.angle) && any(roles.target))
        kinds += {AlarmKind::Saturation, AlarmKind::Limit};
    if (roles.faults >= 0)
        kinds.insert(AlarmKind::Sensor);
    if (roles.temperature >= 0 || any(roles.motorTemperature))
        kinds.insert(AlarmKind::Heat);
    if (roles.battery >= 0)
        kinds.insert(AlarmKind::Battery);
    return kinds;
}

// What comes as well as what does not is told by the samples, not by what was asked for.
std::vector<Unwatched> Supervisor::unwatched(const QSet<AlarmKind> &possible, double now) const
{
    const auto latest = [this](double AxisState::*at) {
        const auto before = [at](const AxisState &a, const AxisState &b) { return a.*at < b.*at; };
        return *std::max_element(m_axes.begin(), m_axes.end(), before).*at;
    };
    const auto comes = [now](double at) { return now - at < kNotComing; };
    using Reason = Unwatched::Reason;
    std::vector<Unwatched> list;
    const bool hasAngles = comes(latest(&AxisState::angleAt));
    const bool hasTargets = hasAngles && comes(m_targetAt);
    for (std::size_t i = 0; i < kAlarmKinds; ++i) {
        const auto kind = AlarmKind(i);
        const auto is = [&](bool watched) {
            if (!watched)
                list.push_back({kind, possible.contains(kind) ? Reason::NotComing : Reason::NotTold});
        };
        switch (kind) {
        case AlarmKind::Runaway:
            is(hasAngles);
            if (hasAngles && !m_hasTargets && m_situation.isSteered
                && std::none_of(m_axes.begin(), m_axes.end(), std::mem_fn(&AxisState::isCommanded)))
                list.push_back({kind, Reason::ByRate});
            break;
        case AlarmKind::Oscillation:
            is(comes(latest(&AxisState::rateAt)));
            if (const double highest = 0.5 / std::max(1e-3, m_axes.front().ratePeriod);
                comes(m_axes.front().rateAt) && highest < kEnoughHz)
                list.push_back({kind, Reason::TooSlow, std::max(1.0, std::round(highest / 5) * 5)});
            break;
        case AlarmKind::Limit:
        case AlarmKind::Saturation:
            if (hasAngles && !possible.contains(kind))
                list.push_back({kind, Reason::OnlySteered});
            else
                is(hasTargets);
            break;
        case AlarmKind::Sensor: is(m_situation.tellsFaults); break;
        case AlarmKind::Heat: {
            const bool hasMotors = comes(latest(&AxisState::motorAt));
            is(comes(m_temperatureAt) || hasMotors);
            if (comes(m_temperatureAt) && !hasMotors)
                list.push_back(
                    {kind, m_situation.tellsMotorHeat ? Reason::NotComing : Reason::NotTold, 0, true});
            break;
        }
        case AlarmKind::Battery:
            if (comes(m_batteryAt) && m_battery <= kNoBatteryVolts)
                list.push_back({kind, Reason::NoBattery});
            else
                is(comes(m_batteryAt));
            break;
        case AlarmKind::Stale:
        case AlarmKind::Disarmed:
        case AlarmKind::Count: break;
        }
    }
    return list;
}

QString Supervisor::faultOf(AlarmKind kind) const
{
    static const std::array<std::pair<AlarmKind, QStringList>, 3> keys{{
        {AlarmKind::Sensor, {u"no-sensor"_s, u"imu-error"_s, u"imu2-error"_s}},
        {AlarmKind::Battery, {u"battery-empty"_s, u"low-battery"_s}},
        {AlarmKind::Heat, {u"protection"_s}},
    }};
    for (const auto &[of, wanted] : keys) {
        for (const QString &key : wanted) {
            if (of == kind && m_situation.faults.contains(key))
                return key;
        }
    }
    return {};
}

void Supervisor::watchBoard(double now)
{
    const auto lasts = [&](AlarmKind kind, bool is, double duration) {
        return m_lasting[std::size_t(kind)].holds(is, now, duration);
    };
    const auto tell = [&](AlarmKind kind, double value, double limit, Axis axis = Axis::None) {
        Alarm alarm;
        alarm.kind = kind;
        alarm.axis = axis;
        alarm.time = now;
        alarm.value = value;
        alarm.limit = limit;
        alarm.fault = faultOf(kind);
        alarm.cause = alarm.fault.isEmpty() ? AlarmCause::Unknown : AlarmCause::Fault;
        if (kind == AlarmKind::Battery) {
            alarm.cells = m_cells;
            if (isAlarmOfOtherBattery(value, m_cells, m_rules.cellVolts, m_rules.battery,
                                      !alarm.fault.isEmpty()))
                alarm.cause = AlarmCause::OtherBattery;
        }
        raise(alarm);
    };
    const bool isStarting = !m_situation.isStabilising || m_situation.isProcedure;
    if (lasts(AlarmKind::Sensor, !faultOf(AlarmKind::Sensor).isEmpty(), isStarting ? kSensorsFound : 0.5))
        tell(AlarmKind::Sensor, 0, 0);
    const bool isHot = m_temperature > m_rules.hotCelsius;
    const auto motor = std::find_if(m_axes.begin(), m_axes.end(), [this](const AxisState &state) {
        return state.motorTemperature > m_rules.hotCelsius;
    });
    if (lasts(AlarmKind::Heat, isHot || motor != m_axes.end() || !faultOf(AlarmKind::Heat).isEmpty(), 2.0)) {
        if (!isHot && motor != m_axes.end())
            tell(AlarmKind::Heat, motor->motorTemperature, m_rules.hotCelsius,
                 kAxes[std::size_t(motor - m_axes.begin())]);
        else
            tell(AlarmKind::Heat, m_temperature, m_rules.hotCelsius);
    }
    // A battery does not gain cells; one that is nearly flat looks like one with fewer.
    if (!std::isnan(m_battery))
        m_cells = std::max({m_cells, batteryCells(m_battery), m_countedCells});
    const double low = lowBattery(m_cells, m_rules.cellVolts, m_rules.battery).value_or(0.0);
    const bool isLow
        = (m_battery > kNoBatteryVolts && m_battery < low) || !faultOf(AlarmKind::Battery).isEmpty();
    if (lasts(AlarmKind::Battery, isLow, 3.0))
        tell(AlarmKind::Battery, m_battery, low);
    if (lasts(AlarmKind::Disarmed, !m_situation.isProcedure && m_armed == 0 && m_outputs > 0, kStillTurning))
        tell(AlarmKind::Disarmed, 0, 0);
    if (!m_situation.isSteered)
        m_steeringSince = -1;
    else if (m_steeringSince < 0)
        m_steeringSince = now;
    const double unseen = now - std::max(lastSeen(), m_steeringSince);
    if (m_situation.isSteered && unseen > patience())
        tell(AlarmKind::Stale, unseen, patience());
}

double Supervisor::patience() const
{
    return std::max(kStaleTime, kStalePeriods * m_situation.period);
}

double Supervisor::lastSeen() const
{
    const double last = m_situation.tellsMotion ? m_lastMotion : m_lastSample;
    return std::min(last, m_situation.unchangedSince.value_or(last));
}

bool Supervisor::isOver(const Alarm &alarm, double now) const
{
    const bool hasAxis = alarm.axis != Axis::None;
    const AxisState &axis = m_axes[hasAxis ? std::size_t(alarm.axis) : 0];
    const bool isOff = !isDriven(now) && now - m_drivenSince > kAfterStart;
    switch (alarm.kind) {
    case AlarmKind::Runaway:
        if (alarm.isTurning)
            return isOff || axis.turn.turned() == 0;
        return isOff || std::abs(axis.error) < alarm.limit / 2;
    case AlarmKind::Oscillation:
        return isOff
            || (alarm.hertz < kSlowHz ? axis.slow.recent(1.0 / alarm.hertz) : axis.oscillation.roughness())
            < alarm.value / 2;
    case AlarmKind::Limit: return axis.beyondSince < 0;
    case AlarmKind::Saturation: return axis.farSince < 0;
    case AlarmKind::Sensor: return faultOf(AlarmKind::Sensor).isEmpty();
    case AlarmKind::Heat:
        return faultOf(AlarmKind::Heat).isEmpty()
            && !((hasAxis ? axis.motorTemperature : m_temperature) > m_rules.hotCelsius - kCooler);
    case AlarmKind::Battery:
        return faultOf(AlarmKind::Battery).isEmpty()
            && !(m_battery > kNoBatteryVolts
                 && m_battery < lowBattery(m_cells, m_rules.cellVolts, m_rules.battery).value_or(0.0)
                         + m_cells * kCellRise);
    case AlarmKind::Disarmed: return m_armed != 0 || m_outputs <= 0;
    // Nor does it come back because nobody steers it any more.
    case AlarmKind::Stale: return now - lastSeen() <= patience();
    case AlarmKind::Count: break;
    }
    return true;
}
