// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/directioncheck.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

constexpr int kKinds = 4;
constexpr int kSteps = kKinds * int(kAxisCount);
constexpr int kArmedFrom = 2 * int(kAxisCount);
constexpr double kDifference = 0.003;  // share of full output that tells motors apart
// Of what is looked at, of other axes: a hand is not exact, and what tumbles is no answer.
constexpr double kAside = 0.5;
constexpr double kStartsLevel = 25;  // degrees, of roll and pitch: tables and hands are not level
constexpr double kMarked = 0.25;  // of the greatest difference
constexpr double kBack = 12;  // degrees: a step may have begun while it was brought back from the one before
constexpr double kHeldLevel = 10;  // degrees, while it is armed
constexpr double kUntouched = 3;  // degrees
constexpr double kSteady = 0.02;  // share of full output
constexpr int kSteadyCount = 5;  // looks
constexpr double kOverNoise = 3;

double difference(double to, double from)
{
    return std::remainder(to - from, 360.0);
}

}  // namespace

QByteArray CheckedDirections::encode() const
{
    QByteArray text = QByteArray::number(int(level));
    for (const auto *signs : {&angles, &sticks, &motors}) {
        for (const int sign : *signs)
            text += sign < 0 ? '-' : '+';
    }
    return text;
}

CheckedDirections CheckedDirections::decode(const QByteArray &text)
{
    CheckedDirections read;
    constexpr auto kSigns = qsizetype(kAxisCount);
    // Earlier versions did not keep where the motors are.
    if ((text.size() != 1 + 3 * kSigns && text.size() != 1 + 2 * kSigns) || text[0] < '0' || text[0] > '2')
        return read;
    read.level = Level(text[0] - '0');
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        read.angles[axis] = text[1 + qsizetype(axis)] == '-' ? -1 : 1;
        read.sticks[axis] = text[1 + kSigns + qsizetype(axis)] == '-' ? -1 : 1;
        const qsizetype at = 1 + 2 * kSigns + qsizetype(axis);
        read.motors[axis] = at < text.size() && text[at] == '-' ? -1 : 1;
    }
    return read;
}

DirectionCheck::DirectionCheck(const CheckedDirections &known)
    : m_found(known)
    , m_step(known.level == CheckedDirections::Level::Nothing ? 0 : kArmedFrom)
{
    std::fill_n(m_isDone.begin(), m_step, true);
    if (known.level == CheckedDirections::Level::All)
        *this = DirectionCheck();  // once more, from the beginning
}

int DirectionCheck::stepCount()
{
    return kSteps;
}

std::optional<DirectionCheck::Step> DirectionCheck::step() const
{
    if (m_failed || m_step >= kSteps)
        return {};
    return Step{Kind(m_step / int(kAxisCount)), kAxes[std::size_t(m_step) % kAxisCount]};
}

bool DirectionCheck::isArmedStep() const
{
    return step() && m_step >= kArmedFrom;
}

void DirectionCheck::await()
{
    m_sight = Sight::Waiting;
    m_isStarted = m_isStimulated = m_isReady = false;
    m_restCount = m_idleCount = m_seenCount = 0;
    m_faster.clear();
}

void DirectionCheck::next()
{
    m_isDone[std::size_t(m_step)] = true;
    while (m_step < kSteps && m_isDone[std::size_t(m_step)])
        ++m_step;
    await();
    if (m_step == kArmedFrom)
        m_found.level = CheckedDirections::Level::Signs;
    if (m_step == kSteps)
        m_found.level = CheckedDirections::Level::All;
}

// What was answered for this axis counts no more.
void DirectionCheck::repeat(std::size_t axis)
{
    const auto first = std::size_t(kArmedFrom) + axis;
    m_isDone[first] = m_isDone[first + kAxisCount] = false;
    m_named[axis].clear();
    m_isReversed[axis] = false;
    m_step = std::min(m_step, int(first));
    await();
}

// The same motors, or just the others.
bool DirectionCheck::isAlike(const QList<int> &motors, const QList<int> &others) const
{
    const auto shared = std::count_if(motors.begin(), motors.end(),
                                      [&others](int motor) { return others.contains(motor); });
    return shared == motors.size() || (shared == 0 && motors.size() + others.size() == m_rest.size());
}

// A motor has one place and turns one way: what lifts the side that hangs must not be what lowers it, and no
// two axes move the same motors.
std::optional<std::size_t> DirectionCheck::contradicted(Step step, bool isRight) const
{
    const auto own = std::size_t(step.axis);
    if (step.kind == Kind::StickAnswer && !m_named[own].isEmpty()) {
        const bool isOpposite = std::none_of(m_faster.begin(), m_faster.end(),
                                             [&](int motor) { return m_named[own].contains(motor); });
        return isOpposite == isRight ? std::nullopt : std::optional(own);
    }
    for (std::size_t axis = 0; isRight && axis < kAxisCount; ++axis) {
        if (axis != own && !m_named[axis].isEmpty() && isAlike(m_faster, m_named[axis]))
            return axis;
    }
    return {};
}

// One axis has gone far enough, and no other nearly as far.
void DirectionCheck::look(const Axes &values, double enough, double level)
{
    const auto axis = std::size_t(step()->axis);
    const bool isBack = std::all_of(values.begin(), values.end(),
                                    [level](double value) { return std::abs(value) < level; });
    if (m_sight == Sight::Seen) {
        if (isBack)
            next();
        return;
    }
    const double own = std::abs(values[axis]);
    double others = 0;
    for (std::size_t other = 0; other < values.size(); ++other)
        others = std::max(others, other == axis ? 0 : std::abs(values[other]));
    m_sight = others > std::max(enough, own)    ? Sight::Other
        : own > enough && others < kAside * own ? Sight::Seen
                                                : Sight::Waiting;
}

void DirectionCheck::feedAngles(const Axes &angles)
{
    const auto isKnown = [](double angle) { return !std::isnan(angle); };
    if (!std::all_of(angles.begin(), angles.end(), isKnown))
        return;
    m_angles = angles;
    const auto now = step();
    if (!now || (now->kind != Kind::Tilt && now->kind != Kind::TiltAnswer))
        return;
    const auto axis = std::size_t(now->axis);
    if (now->kind == Kind::TiltAnswer) {
        Axes moved{};
        for (std::size_t each = 0; each < kAxisCount; ++each)
            moved[each] = difference(angles[each], m_start[each]);
        const double own = moved[axis] * m_found.angles[axis];
        m_isStimulated = m_isReady && own > kTilt
            && std::all_of(moved.begin(), moved.end(), [own](double one) { return std::abs(one) <= own; });
        return;
    }
    if (!m_isStarted
        && !(std::abs(difference(angles[0], 0)) < kStartsLevel
             && std::abs(difference(angles[1], 0)) < kStartsLevel))
        return;
    if (!m_isStarted)
        m_start = angles;
    m_isStarted = true;
    Axes turned{};
    for (std::size_t each = 0; each < kAxisCount; ++each)
        turned[each] = difference(angles[each], m_start[each]);
    const bool wasSeen = m_sight == Sight::Seen;
    look(turned, kTilt, kBack);
    // Turned on the spot, and held level: it begins from there.
    if (m_sight == Sight::Other && std::abs(difference(angles[0], 0)) < kLevel
        && std::abs(difference(angles[1], 0)) < kLevel) {
        m_start = angles;
        m_sight = Sight::Waiting;
    }
    if (!wasSeen && m_sight == Sight::Seen)
        m_found.angles[axis] = turned[axis] < 0 ? -1 : 1;
}

void DirectionCheck::feedSticks(const Axes &sticks)
{
    const auto now = step();
    m_sticks = sticks;
    if (now && now->kind == Kind::StickAnswer)
        m_isStimulated = m_isReady && sticks[std::size_t(now->axis)] > kPush;
    if (!now || now->kind != Kind::Stick)
        return;
    look(sticks, kPush, kStickLevel);
    // Pushed the other way it has to be pushed again.
    if (m_sight == Sight::Seen && sticks[std::size_t(now->axis)] < -kPush)
        m_sight = Sight::Other;
}

// Steady for a while, held level, with no stick pushed.
void DirectionCheck::rest(const QList<double> &outputs)
{
    const bool isLevel = std::abs(difference(m_angles[0], 0)) < kHeldLevel
        && std::abs(difference(m_angles[1], 0)) < kHeldLevel
        && std::all_of(m_sticks.begin(), m_sticks.end(),
                       [](double stick) { return std::abs(stick) < kStickLevel; });
    if (m_idleCount < kIdleCount) {
        m_idleCount = isLevel ? m_idleCount + 1 : 0;
        return;
    }
    if (m_restCount == 0 || !isLevel || outputs.size() != m_rest.size()) {
        m_rest = outputs;
        m_start = m_angles;
        m_noise = 0;
        m_restCount = isLevel ? 1 : 0;
        return;
    }
    for (qsizetype motor = 0; motor < outputs.size(); ++motor)
        m_noise = std::max(m_noise, std::abs(outputs[motor] - m_rest[motor]));
    const bool isStill = std::abs(difference(m_angles[2], m_start[2])) < kLevel;
    m_restCount = m_noise < kSteady && isStill ? m_restCount + 1 : 0;
    m_isReady = m_restCount >= kSteadyCount;
}

// Neither tilted nor pushed since it was steady.
bool DirectionCheck::isUntouched() const
{
    bool isStill = true;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        isStill &= std::abs(m_sticks[axis]) < kStickLevel
            && std::abs(difference(m_angles[axis], m_start[axis])) < kUntouched;
    return isStill;
}

void DirectionCheck::feedOutputs(const QList<double> &outputs)
{
    if (!isArmedStep() || m_sight == Sight::Seen)
        return;
    if (outputs.isEmpty() || (m_isReady && outputs.size() != m_rest.size())) {
        await();
        return;
    }
    if (!m_isReady)
        return rest(outputs);
    if (!m_isStimulated) {
        m_seenCount = 0;
        // A controller that cannot move what it holds sums up: they drift.
        if (isUntouched())
            m_rest = outputs;
        return;
    }
    const QList<int> faster = compare(outputs);
    m_seenCount = faster.isEmpty() ? 0 : faster == m_candidates ? m_seenCount + 1 : 1;
    m_candidates = faster;
    if (m_seenCount < kSeenCount)
        return;
    m_faster = faster;
    m_sight = Sight::Seen;
}

// The motors that turn faster than at rest, against the others; none: that cannot be told.
QList<int> DirectionCheck::compare(const QList<double> &outputs) const
{
    QList<std::pair<double, int>> changes;
    for (qsizetype motor = 0; motor < outputs.size(); ++motor)
        changes.append({outputs[motor] - m_rest[motor], int(motor) + 1});
    std::sort(changes.begin(), changes.end());
    const int told = m_sizes[std::size_t(step()->axis)];
    const qsizetype size = told > 0 ? told : outputs.size() / 2;
    const double all = changes.last().first - changes.first().first;
    if (size < 1 || size >= changes.size() || all < std::max(kDifference, kOverNoise * m_noise))
        return {};
    const qsizetype from = changes.size() - size;
    if (changes[from].first - changes[from - 1].first < kMarked * all
        || changes.last().first - changes[from].first > (1 - kMarked) * all / 2)
        return {};  // more or fewer than can be
    QList<int> faster;
    for (qsizetype i = from; i < changes.size(); ++i)
        faster.append(changes[i].second);
    std::sort(faster.begin(), faster.end());
    return faster;
}

bool DirectionCheck::isReversed() const
{
    const auto now = step();
    return now && now->kind == Kind::StickAnswer && m_isReversed[std::size_t(now->axis)];
}

void DirectionCheck::answer(bool isRight)
{
    const auto now = step();
    if (!now || !isArmedStep() || m_sight != Sight::Seen)
        return;
    const auto axis = std::size_t(now->axis);
    const auto other = contradicted(*now, isRight);
    m_isContradicted = other.has_value();
    if (other) {
        repeat(axis);
        repeat(*other);
    } else if (isRight) {
        if (now->kind == Kind::TiltAnswer)
            m_named[axis] = m_faster;
        next();
    } else if (now->kind == Kind::StickAnswer && !m_isReversed[axis]) {
        m_isReversed[axis] = true;
        m_found.sticks[axis] = -m_found.sticks[axis];
        await();
    } else {
        m_failed = now->axis;
        m_found = {};
    }
}
