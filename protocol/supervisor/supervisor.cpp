// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/supervisor.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr double kPast = 1.0;  // seconds of angles that are kept
constexpr double kPastStep = 0.008;  // between them
constexpr double kSlope = 0.05;  // seconds over which an angle's rate is measured

// Runaway: this fast away from the target and not slowing down, for so long and so many samples.
constexpr double kAwayRate = 40.0;
constexpr double kAwayTime = 0.06;
constexpr int kAwaySamples = 2;
constexpr double kNotSlower = 0.9;
// Or twice as far, however slowly.
constexpr double kCreepTimes = 2.0;
constexpr double kCreepRate = 8.0;
constexpr double kCreepTime = 0.25;
// Without targets an axis is compared with where it stood: it has to be further off and faster, because a
// hand or a remote control may have moved it. Yaw follows whoever carries the gimbal.
constexpr double kAnchorTimes = 2.0;
constexpr double kAnchorRate = 120.0;
constexpr double kAnchorRateYaw = 300.0;
constexpr double kIdle = 0.2;  // seconds, by which motors were off or starting
constexpr double kStartRate = 300.0;  // no board levels that fast
constexpr double kStillRate = 15.0;  // deg/s
constexpr double kStillTime = 0.3;
constexpr double kInputStep = 5.0;  // change of an input that counts as steering
constexpr double kAfterSteering = 2.0;  // seconds

// What tells two axes that drive each other from one that turns the wrong way.
constexpr double kTogether = 0.95;  // correlation of the errors
constexpr double kAlikeLow = 0.4;  // their ratio
constexpr double kAlikeHigh = 2.5;
constexpr double kSwing = 5.0;  // degrees: an error that changes sign like this oscillates

constexpr double kLookEvery = 0.08;
constexpr double kAfterChange = 0.5;  // of the limit for oscillations
constexpr double kThanCalm = 3.0;  // times as rough as it was before
constexpr double kCalmShare = 0.05;  // of a new value in the average
constexpr int kOscillatingLooks = 2;
constexpr double kSwingTimes = 2.0;  // of the limit, for swings slower than that
constexpr double kTargetStep = 3.0;  // degrees
constexpr double kMoving = 2.5;  // seconds that a move may take
constexpr double kFastHz = 15.0;  // no move looks like that
constexpr double kResonanceFrom = 25.0;  // Hz: faster than gains alone make a gimbal swing
constexpr double kAfterProcedure = 1.0;

constexpr double kTurnRound = 0.25;
constexpr double kArrived = 3.0;  // degrees

constexpr double kFar = 8.0;  // degrees off the target
constexpr double kFarTime = 3.0;
constexpr double kStandsTime = 2.0;  // beyond the limit of a runaway
constexpr double kStillFar = 0.7;  // of the error at the beginning
constexpr double kBeyond = 5.0;  // degrees beyond a limit
constexpr double kBeyondTime = 2.5;

constexpr double kOver = 1.0;  // seconds without the cause

double wrapped(double degrees)
{
    return std::remainder(degrees, 360.0);
}

bool isKnown(double value)
{
    return !std::isnan(value);
}

bool tellsMotion(const SupervisedSample &sample)
{
    return std::any_of(sample.angle.begin(), sample.angle.end(), isKnown)
        || std::any_of(sample.rate.begin(), sample.rate.end(), isKnown);
}

}  // namespace

bool Supervisor::Lasting::holds(bool is, double now, double duration)
{
    if (!is) {
        since = -1;
        return false;
    }
    if (since < 0 || now < since)
        since = now;
    return now - since >= duration;
}

void Supervisor::interrupt()
{
    for (AxisState &state : m_axes) {
        state.past.clear();
        state.oscillation.clear();
        state.slow.clear();
        state.turn.clear();
        state.awaySince = state.farSince = state.beyondSince = -1;
        state.anchor = SupervisedSample::kNone;
        state.stillSince = -1;
    }
}

void Supervisor::add(const SupervisedSample &sample)
{
    m_lastSample = std::max(m_lastSample, sample.time);
    if (tellsMotion(sample)) {
        if (m_lastMotion >= 0 && sample.time - m_lastMotion > patience())
            interrupt();
        m_lastMotion = std::max(m_lastMotion, sample.time);
    }
    if (isKnown(sample.outputs)) {
        const bool was = m_outputs > 0;
        m_outputs = sample.outputs;
        if (m_outputs > 0 && (!was || m_drivenSince < 0))
            m_drivenSince = sample.time;
    }
    if (isKnown(sample.armed))
        m_armed = sample.armed;
    if (isKnown(sample.batteryCells))
        m_countedCells = int(sample.batteryCells);
    if (isKnown(sample.battery)) {
        m_battery = sample.battery;
        m_batteryAt = sample.time;
    }
    if (isKnown(sample.temperature)) {
        m_temperature = sample.temperature;
        m_temperatureAt = sample.time;
    }
    if (m_situation.isSteered)
        m_steeredAt = sample.time;
    if (m_situation.isProcedure)
        m_busyAt = sample.time;
    if (!m_situation.isStabilising || m_outputs <= 0) {
        m_idleSince = m_idleSince < 0 ? sample.time : m_idleSince;
    } else if (m_idleSince >= 0) {
        m_heldSince = sample.time - m_idleSince > kIdle ? sample.time : m_heldSince;
        m_idleSince = -1;
    }
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis)
        addAxis(axis, sample);
}

void Supervisor::addAxis(std::size_t axis, const SupervisedSample &sample)
{
    AxisState &state = m_axes[axis];
    if (isKnown(sample.rate[axis])) {
        state.oscillation.add(sample.time, sample.rate[axis]);
        state.slow.add(sample.time, sample.rate[axis]);
        const double period = sample.time - state.rateAt;
        state.ratePeriod += period > 0 && period < 1 ? 0.05 * (period - state.ratePeriod) : 0.0;
        state.rateAt = sample.time;
    }
    if (isKnown(sample.motorTemperature[axis])) {
        state.motorTemperature = sample.motorTemperature[axis];
        state.motorAt = sample.time;
    }
    if (isKnown(sample.input[axis])) {
        if (!isKnown(state.input) || std::abs(sample.input[axis] - state.input) > kInputStep) {
            if (isKnown(state.input))
                m_steeredAt = sample.time;
            state.input = sample.input[axis];
        }
    }
    if (isKnown(sample.target[axis])) {
        state.target = sample.target[axis];
        m_hasTargets = true;
        m_targetAt = sample.time;
        state.isCommanded = false;
        if (!isKnown(state.movedFrom) || std::abs(wrapped(state.target - state.movedFrom)) > kTargetStep) {
            state.movedAt = sample.time;
            state.movedFrom = state.target;
        }
    }
    const double angle = sample.angle[axis];
    if (!isKnown(angle))
        return;
    state.angleAt = sample.time;
    if (!m_hasTargets)
        watchCommand(axis, sample.time);
    while (!state.past.empty() && sample.time - state.past.front().time > kPast)
        state.past.pop_front();
    // The rate comes from the angles: what the gyroscope calls positive differs between boards.
    const Past *from = nullptr;
    for (auto it = state.past.rbegin(); it != state.past.rend(); ++it) {
        from = &*it;
        if (sample.time - it->time >= kSlope)
            break;
    }
    const double span = from ? sample.time - from->time : 0.0;
    const double rate = span > 0.5 * kSlope ? wrapped(angle - from->angle) / span : 0.0;
    watchAnchor(state, sample.time, angle, rate);
    measureError(state, sample.time, angle);
    state.hasArrived |= state.isCommanded && std::abs(state.error) < kArrived;
    state.away = !isKnown(state.error) ? 0.0 : state.error > 0 ? -rate : rate;
    if (state.past.empty() || sample.time - state.past.back().time >= kPastStep)
        state.past.push_back({sample.time, angle, state.error});
    watchRunaway(axis, sample.time);
    watchTurn(axis, sample.time, angle, rate);
    watchPlace(axis, sample.time);
}

void Supervisor::measureError(AxisState &state, double time, double angle)
{
    const bool anchored = isAnchored(state);
    const double reference = anchored ? state.anchor : state.target;
    const double error = isKnown(reference) ? wrapped(reference - angle) : SupervisedSample::kNone;
    const bool isStill = state.stillSince >= 0 && time - state.stillSince >= kStillTime;
    // Where it stands, its direction counts.
    const bool goesOn = isKnown(error) && isKnown(state.error) && !state.past.empty()
        && anchored == state.wasAnchored && isDriven(time) && !isStill;
    state.error = goesOn ? state.error + wrapped(error - state.error) : error;
    state.wasAnchored = anchored;
}

// A board that does not tell its targets is judged by what it is steered to from here.
void Supervisor::watchCommand(std::size_t axis, double time)
{
    AxisState &state = m_axes[axis];
    double wanted = m_situation.isSteered ? m_situation.steeredTo[axis] : SupervisedSample::kNone;
    // Beyond its limits it may stop short.
    if (const auto &angles = m_rules.angles[axis];
        angles && (wanted < angles->first || wanted > angles->second))
        wanted = SupervisedSample::kNone;
    const bool was = std::exchange(state.isCommanded, isKnown(wanted));
    if (!state.isCommanded) {
        if (was)
            state.farSince = state.beyondSince = state.awaySince = -1;
        return;
    }
    state.target = wanted;
    if (!was || !isKnown(state.movedFrom) || std::abs(wrapped(wanted - state.movedFrom)) > kTargetStep) {
        state.movedAt = time;
        state.movedFrom = wanted;
        state.hasArrived = false;
        state.farSince = -1;
    }
}

// Where an axis stands still is taken for its target, until somebody moves it.
void Supervisor::watchAnchor(AxisState &state, double time, double angle, double rate)
{
    if (std::abs(rate) > kStillRate) {
        state.stillSince = -1;
        return;
    }
    if (state.stillSince < 0)
        state.stillSince = time;
    if (time - state.stillSince >= kStillTime)
        state.anchor = angle;
}

bool Supervisor::isDriven(double time) const
{
    if (!isKnown(m_outputs))
        return m_situation.isStabilising;
    return m_outputs > 0 && time - m_drivenSince >= kAfterStart;
}

bool Supervisor::isHolding(double time) const
{
    return m_situation.isStabilising && isDriven(time);
}

bool Supervisor::isChangedSince(double time) const
{
    return m_situation.changedAt && *m_situation.changedAt >= time;
}

void Supervisor::watchRunaway(std::size_t axis, double time)
{
    AxisState &state = m_axes[axis];
    const bool isAnchored = this->isAnchored(state);
    // A camera that moved the other way when it was told to turn round needs a moment.
    const bool turnsRound = state.isCommanded && time - state.movedAt < kTurnRound;
    if (!isDriven(time) || !isKnown(state.error) || turnsRound
        || (isAnchored && (time - m_steeredAt < kAfterSteering || time - m_busyAt < kAfterSteering))) {
        state.awaySince = -1;
        return;
    }
    const double limit = m_rules.runawayDeg * (isAnchored ? kAnchorTimes : 1.0);
    const bool isHeld = m_situation.isStabilising;
    const double fast = !isHeld    ? kStartRate
        : !isAnchored              ? kAwayRate
        : kAxes[axis] == Axis::Yaw ? kAnchorRateYaw
                                   : kAnchorRate;
    const double error = std::abs(state.error);
    const bool isFast = error > limit && state.away > fast;
    const bool creeps = !isAnchored && isHeld && error > kCreepTimes * limit && state.away > kCreepRate;
    if (!isFast && !creeps) {
        state.awaySince = -1;
        return;
    }
    // What is being caught slows down.
    if (state.awaySince < 0 || state.away < kNotSlower * state.awayFirst) {
        state.awaySince = time;
        state.awayFirst = state.away;
        state.awaySamples = 0;
    }
    ++state.awaySamples;
    const double lasted = time - state.awaySince;
    if (state.awaySamples > kAwaySamples - 1 && lasted >= (isFast ? kAwayTime : kCreepTime))
        raise(explainRunaway(axis, time));
}

Alarm Supervisor::explainRunaway(std::size_t axis, double time) const
{
    const AxisState &state = m_axes[axis];
    Alarm alarm;
    alarm.kind = AlarmKind::Runaway;
    alarm.axis = kAxes[axis];
    alarm.time = time;
    alarm.value = std::abs(state.error);
    alarm.limit = m_rules.runawayDeg * (isAnchored(state) ? kAnchorTimes : 1.0);
    alarm.isAfterChange = isChangedSince(time - kChangeCounts);
    // An error that swung to and fro has outgrown its loop.
    int swings = 0;
    double side = 0;
    double before = 0;
    for (const Past &past : state.past) {
        // Past half a circle it was told from the other side: it has turned on.
        if (std::abs(past.error - std::exchange(before, past.error)) > 180)
            side = swings = 0;
        if (std::abs(past.error) < kSwing)
            continue;
        swings += side != 0 && side * past.error < 0;
        side = past.error;
    }
    if (swings >= 2) {
        alarm.cause = AlarmCause::TooMuchGain;
        return alarm;
    }
    if (state.away <= kAwayRate) {
        // At its stop it moves as the frame does.
        const Alarm standing = explainStanding(axis, time);
        return standing.other != Axis::None ? standing : alarm;
    }
    alarm.cause = AlarmCause::WrongDirection;
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const AxisState &second = m_axes[i];
        if (i == axis || !isKnown(second.error) || second.away <= 0
            || std::abs(second.error) < 0.25 * std::abs(state.error))
            continue;
        alarm.other = kAxes[i];
        // Axes that drive each other diverge in step, with errors of the same size, and faster than either
        // could alone; two that turn the wrong way each go their own way.
        double both = 0;
        double one = 0;
        double two = 0;
        const std::size_t count = std::min(state.past.size(), second.past.size());
        for (std::size_t k = 1; k <= count; ++k) {
            const double a = state.past[state.past.size() - k].error;
            const double b = second.past[second.past.size() - k].error;
            if (!isKnown(a) || !isKnown(b))
                continue;
            both += a * b;
            one += a * a;
            two += b * b;
        }
        const double together = one > 0 && two > 0 ? std::abs(both) / std::sqrt(one * two) : 0.0;
        const double ratio = one > 0 ? std::sqrt(two / one) : 0.0;
        if (together >= kTogether && ratio > kAlikeLow && ratio < kAlikeHigh)
            alarm.cause = AlarmCause::SwappedAxes;
        break;
    }
    return alarm;
}

// It had run away before it was watched, or nothing can bring it back.
Alarm Supervisor::explainStanding(std::size_t axis, double time) const
{
    const AxisState &state = m_axes[axis];
    Alarm alarm;
    alarm.kind = AlarmKind::Runaway;
    alarm.axis = kAxes[axis];
    alarm.time = time;
    alarm.value = std::abs(state.error);
    alarm.limit = m_rules.runawayDeg;
    alarm.isStanding = true;
    alarm.isAfterChange = isChangedSince(time - kChangeCounts);
    // One axis may be blocked; two that stand off their targets at once, as far as one another, drive each
    // other.
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const double ratio = std::abs(m_axes[i].error / state.error);
        if (i == axis || m_axes[i].farSince < 0 || !(ratio > kAlikeLow && ratio < kAlikeHigh))
            continue;
        alarm.other = kAxes[i];
        alarm.cause = AlarmCause::SwappedAxes;
        break;
    }
    return alarm;
}

void Supervisor::watchPlace(std::size_t axis, double time)
{
    AxisState &state = m_axes[axis];
    const bool isWatched = isHolding(time) && !isAnchored(state) && isKnown(state.error)
        && time - m_busyAt >= kAfterProcedure && !m_situation.isProcedure;
    if (!isWatched || std::abs(state.error) < kFar) {
        state.farSince = -1;
    } else if (state.farSince < 0 || std::abs(state.error) < kStillFar * state.farError) {
        state.farSince = time;
        state.farError = std::abs(state.error);
    } else if (std::abs(state.error) > m_rules.runawayDeg && time - state.farSince >= kStandsTime
               && (m_hasTargets || state.hasArrived)) {  // else it may never have got there
        raise(explainStanding(axis, time));
    } else if (time - state.farSince >= kFarTime) {
        Alarm alarm;
        alarm.kind = AlarmKind::Saturation;
        alarm.axis = kAxes[axis];
        alarm.time = time;
        alarm.value = std::abs(state.error);
        alarm.limit = kFar;
        alarm.isAfterChange = isChangedSince(time - kChangeCounts);
        raise(alarm);
    }
    const auto &angles = m_rules.angles[axis];
    const double angle = isKnown(state.error) ? state.target - state.error : SupervisedSample::kNone;
    const bool isSent = angles && isKnown(state.target)
        && (state.target < angles->first - 1.0 || state.target > angles->second + 1.0);
    const double beyond
        = !angles || !isKnown(angle) ? 0.0 : std::max(angles->first - angle, angle - angles->second);
    if (!isWatched || isSent || beyond < kBeyond) {
        state.beyondSince = -1;
    } else if (state.beyondSince < 0) {
        state.beyondSince = time;
    } else if (time - state.beyondSince >= kBeyondTime) {
        Alarm alarm;
        alarm.kind = AlarmKind::Limit;
        alarm.axis = kAxes[axis];
        alarm.time = time;
        alarm.value = angle;
        alarm.limit = angle > angles->second ? angles->second : angles->first;
        alarm.isAfterChange = isChangedSince(time - kChangeCounts);
        raise(alarm);
    }
}

void Supervisor::watchOscillation(std::size_t axis, double now)
{
    AxisState &state = m_axes[axis];
    const bool isWatched = isHolding(now) && !m_situation.isProcedure && now - m_busyAt >= kAfterProcedure;
    const double roughness = state.oscillation.roughness();
    const bool isChanged = isChangedSince(now - kChangeCounts);
    if (!isChanged && roughness < m_rules.oscillation)
        state.calm += kCalmShare * (roughness - state.calm);
    double least = m_rules.oscillation;
    if (isChanged)
        least = std::max(kAfterChange * m_rules.oscillation, std::min(kThanCalm * state.calm, least));
    // Going to another place is a slow swing, too.
    const bool isMoved = isMovedWithin(state, now);
    const auto finding = isWatched && roughness > 0 ? state.oscillation.look(least, isMoved ? kFastHz : 0.0)
                                                    : std::optional<OscillationDetector::Finding>();
    state.oscillating = finding ? state.oscillating + 1 : 0;
    if (state.oscillating >= kOscillatingLooks)
        raise(explainOscillation(axis, now, *finding));
    if (isWatched && !isMoved && !finding)
        watchSlowly(axis, now);
    else
        state.slow.clear();
}

bool Supervisor::isMovedWithin(const AxisState &state, double now) const
{
    return now - state.movedAt < kMoving || now - m_drivenSince < kMoving
        || (isAnchored(state) && now - m_steeredAt < kMoving);
}

// Yaw of a board without targets turns with whoever carries it.
void Supervisor::watchSlowly(std::size_t axis, double now)
{
    AxisState &state = m_axes[axis];
    if (isAnchored(state) && kAxes[axis] == Axis::Yaw) {
        state.slow.clear();
        return;
    }
    const bool isChanged = isChangedSince(now - kChangeCounts);
    const auto swing = state.slow.look(kSwingTimes * m_rules.oscillation * (isChanged ? kAfterChange : 1.0));
    if (swing)
        raise(explainOscillation(axis, now, {swing->rms, swing->hertz, false}));
}

Alarm Supervisor::explainOscillation(std::size_t axis, double now,
                                     const OscillationDetector::Finding &finding) const
{
    Alarm alarm;
    alarm.kind = AlarmKind::Oscillation;
    alarm.axis = kAxes[axis];
    alarm.time = now;
    alarm.value = finding.rms;
    alarm.limit = m_rules.oscillation;
    alarm.hertz = finding.hertz;
    alarm.isHertzVague = finding.isHertzVague;
    alarm.isAfterChange = isChangedSince(now - kChangeCounts);
    // Values that were changed just before are the cause.
    if (!alarm.isAfterChange)
        return withoutChange(alarm);
    alarm.cause = AlarmCause::TooMuchGain;
    return alarm;
}

// A frequency that no gimbal as a whole can follow belongs to a part of its structure.
Alarm Supervisor::withoutChange(Alarm alarm)
{
    alarm.isAfterChange = false;
    if (alarm.kind != AlarmKind::Oscillation)
        return alarm;
    alarm.cause = alarm.isHertzVague   ? AlarmCause::Unknown
        : alarm.hertz < kResonanceFrom ? AlarmCause::TooMuchGain
                                       : AlarmCause::Resonance;
    return alarm;
}

void Supervisor::look(double now)
{
    if (now - m_lastLook < kLookEvery && now >= m_lastLook)
        return;
    m_lastLook = now;
    for (std::size_t axis = 0; axis < m_axes.size(); ++axis)
        watchOscillation(axis, now);
    watchBoard(now);
    for (auto it = m_active.begin(); it != m_active.end();) {
        if (!it->over.holds(isOver(it->alarm, now), now, kOver)) {
            ++it;
            continue;
        }
        m_ended.push_back(it->alarm);
        it = m_active.erase(it);
    }
}

bool Supervisor::isAbsent(const Alarm &alarm) const
{
    return std::none_of(m_active.begin(), m_active.end(), [&](const Active &active) {
        return active.alarm.isSame(alarm) && active.over.since < 0;
    });
}

bool Supervisor::isActive(AlarmKind kind, Axis axis) const
{
    return std::any_of(m_active.begin(), m_active.end(), [&](const Active &active) {
        return active.alarm.kind == kind && !active.alarm.mayBeMeant
            && (active.alarm.axis == axis || active.alarm.other == axis);
    });
}

void Supervisor::raise(const Alarm &alarm)
{
    if (isActive(alarm.kind, alarm.axis))
        return;
    // What was only told, because it might be meant, can turn out to be worse.
    const auto told = std::find_if(m_active.begin(), m_active.end(), [&](const Active &active) {
        return active.alarm.mayBeMeant && active.alarm.kind == alarm.kind && active.alarm.axis == alarm.axis;
    });
    if (told != m_active.end()) {
        if (alarm.mayBeMeant)
            return;
        m_ended.push_back(told->alarm);
        m_active.erase(told);
    }
    // A runaway is told, not what follows from it.
    if ((alarm.kind == AlarmKind::Saturation || alarm.kind == AlarmKind::Limit)
        && isActive(AlarmKind::Runaway, alarm.axis))
        return;
    if (alarm.kind == AlarmKind::Limit && isActive(AlarmKind::Saturation, alarm.axis))
        return;
    m_active.push_back({alarm, {}});
    m_raised.push_back(alarm);
}

std::vector<Alarm> Supervisor::takeRaised()
{
    return std::exchange(m_raised, {});
}

std::vector<Alarm> Supervisor::takeEnded()
{
    return std::exchange(m_ended, {});
}
