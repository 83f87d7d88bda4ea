// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/motiontest.h"

#include "protocol/device/device.h"
#include "protocol/device/steering.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTick = 20ms;  // the interval at which set-points are sent
constexpr double kTail = 0.3;  // seconds to wait after the end for the last samples
constexpr double kStale = 0.4;  // seconds without new samples that end the test
constexpr double kStill = 1.0;  // degrees off target allowed before it begins
constexpr double kQuiet = 1.0;  // seconds within kStay that show that the camera has arrived
constexpr double kStay = 0.5;  // degrees
constexpr double kCentering = 15.0;  // seconds allowed for arriving
constexpr double kFade = 0.5;  // seconds over which a sweep fades in and out

Result<void> within(double value, double low, double high, const QString &what)
{
    if (value >= low && value <= high)
        return {};
    return failure(ErrorCode::OutOfRange,
                   u"%1 is %2, allowed are %3 to %4"_s.arg(what).arg(value).arg(low).arg(high));
}

}  // namespace

Result<void> MotionTestPlan::check() const
{
    for (const Result<void> &each :
         {within(degrees, 0.2, kMaxDegrees, u"movement"_s), within(steps, 2, 40, u"steps"_s),
          within(rest, 0.3, 5, u"rest"_s), within(fromHz, 0.1, toHz, u"lowest frequency"_s),
          within(toHz, fromHz, 20, u"highest frequency"_s), within(sweepSeconds, 5, 120, u"seconds"_s),
          within(limit, 0.5, 20, u"limit"_s)}) {
        if (!each)
            return each;
    }
    return {};
}

double MotionTestPlan::duration() const
{
    return kind == Kind::Steps ? rest * (steps + 1) : sweepSeconds + 2 * kFade;
}

double MotionTestPlan::offsetAt(double seconds) const
{
    if (kind == Kind::Steps) {
        const int part = int(std::floor(seconds / rest));
        return part >= 1 && part <= steps && part % 2 == 1 ? degrees : 0.0;
    }
    // Each frequency gets as long as it needs: the logarithm of the frequency grows linearly.
    const double t = std::clamp(seconds - kFade, 0.0, sweepSeconds);
    const double growth = std::log(toHz / fromHz) / sweepSeconds;
    const double turns = growth > 1e-9 ? fromHz * (std::exp(growth * t) - 1.0) / growth : fromHz * t;
    const double fade = std::clamp(std::min(seconds, duration() - seconds) / kFade, 0.0, 1.0);
    const double phase = seconds < kFade ? fromHz * (seconds - kFade) : turns;
    return degrees * fade * std::sin(2.0 * std::numbers::pi * phase);
}

namespace {

/// One run of a test.
class Run
{
public:
    Run(Channel &channel, const Device &device, const TelemetryStore &telemetry, const MotionTestPlan &plan)
        : m_channel(channel)
        , m_device(device)
        , m_telemetry(telemetry)
        , m_plan(plan)
        , m_roles(rolesOf(device))
        , m_axis(std::size_t(plan.axis))
        , m_told(tellsTargets(device))
    {
    }

    Result<MotionTestResult> run();

private:
    Result<void> prepare();
    Result<void> center();
    Result<void> move();
    Result<void> wait();
    [[nodiscard]] std::optional<Error> danger();
    void steer(double offset);
    void report(double share);
    [[nodiscard]] Result<MotionTestResult> collect() const;
    [[nodiscard]] UniformSamples sentTarget(const UniformSamples &angle) const;
    [[nodiscard]] double latest(int channel) const { return double(m_telemetry.latest(channel)); }
    [[nodiscard]] const SteeringMode *furthestMode() const;

    Channel &m_channel;
    const Device &m_device;
    const TelemetryStore &m_telemetry;
    const MotionTestPlan m_plan;
    const ChannelRoles m_roles;
    const std::size_t m_axis;
    const bool m_told;
    SteeringSetpoint m_middle;  // set-points without the movement
    int m_input = -1;  // index of the axis' input
    double m_rest = 0;  // position of the axis with these set-points
    bool m_centering = false;
    std::vector<std::pair<TimePoint, double>> m_sent;  // offsets, each valid until the next
    TimePoint m_startedAt{};
    quint64 m_lastRows = 0;
    TimePoint m_lastNewsAt{};
};

Result<MotionTestResult> Run::run()
{
    if (const auto ready = prepare(); !ready)
        return tl::unexpected(ready.error());
    Result<void> done = m_told ? Result<void>() : center();
    if (done)
        done = move();
    if (!done && done.error().code == ErrorCode::Diverged)
        m_channel.stopMotors(m_device.stopPlan());
    else
        m_channel.releaseControl();
    if (!done)
        return tl::unexpected(done.error());
    return collect();
}

// The mode with the longest reach.
const SteeringMode *Run::furthestMode() const
{
    const Steering *steering = m_device.steering();
    const SteeringMode *furthest = nullptr;
    double reach = 0;
    for (const SteeringMode &mode : steering ? steering->modes() : std::span<const SteeringMode>()) {
        const int input = mode.inputOf(m_plan.axis);
        if (input < 0 || !mode.isPositional() || (m_told && mode.find("speed") < 0))
            continue;
        const SteeringInput &turn = mode.inputs[std::size_t(input)];
        if (qstrcmp(turn.unit, "°") == 0 && turn.max > reach) {
            furthest = &mode;
            reach = turn.max;
        }
    }
    return furthest;
}

Result<void> Run::prepare()
{
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly);
    if (const auto checked = m_plan.check(); !checked)
        return checked;
    const SteeringMode *mode = furthestMode();
    const int angle = m_roles.angle[m_axis];
    if (!mode || angle < 0)
        return failure(ErrorCode::Unsupported, u"the board cannot be steered to an angle"_s);
    if (!m_told && m_plan.kind == MotionTestPlan::Kind::Sweep) {
        return failure(
            ErrorCode::Unsupported,
            u"the board does not tell its targets, so the line's delay would be taken for its own; "
            "steps can be measured"_s);
    }
    m_input = mode->inputOf(m_plan.axis);
    m_middle = {mode->id, {}, {}};
    for (const SteeringInput &input : mode->inputs) {
        const auto axis = std::size_t(input.axis);
        const bool turns = input.axis != Axis::None;
        const double start = !turns ? input.max : m_told ? latest(m_roles.target[axis]) : 0.0;
        if (std::isnan(start) || (turns && std::isnan(latest(m_roles.angle[axis]))))
            return failure(ErrorCode::Unready, u"no telemetry of the angles"_s);
        m_middle.inputs.push_back(start);
    }
    if (auto off = findMotorsNotRunning(m_roles, m_telemetry))
        return tl::unexpected(std::move(*off));
    m_rest = m_middle.inputs[std::size_t(m_input)];
    const double off = std::abs(latest(angle) - m_rest);
    if (m_told && !(off < kStill))
        return failure(m_plan.mayStray ? ErrorCode::ConditionUnmet : ErrorCode::Unready,
                       u"the axis is %1° away from its target"_s.arg(off, 0, 'f', 1));
    m_startedAt = m_lastNewsAt = m_channel.now();
    m_lastRows = m_telemetry.rows();
    return {};
}

// Reasons to stop: the axis far from where it should be, no fresh telemetry, motors off.
std::optional<Error> Run::danger()
{
    const TimePoint now = m_channel.now();
    if (const quint64 rows = m_telemetry.rows(); rows != m_lastRows) {
        m_lastRows = rows;
        m_lastNewsAt = now;
    }
    if (seconds(now - m_lastNewsAt) > kStale)
        return Error{ErrorCode::Unready,
                     u"no telemetry for %1 s"_s.arg(seconds(now - m_lastNewsAt), 0, 'f', 1), 0};
    if (m_roles.outputs >= 0 && latest(m_roles.outputs) < 0.5)
        return Error{ErrorCode::Unready, u"the motors went off"_s, 0};
    if (m_centering)
        return {};
    // An axis does not follow a step at once: while it rises, the height of the step does not count as
    // deviation.
    const double off = std::abs(latest(m_roles.angle[m_axis]) - m_rest);
    const double allowed = m_plan.degrees + m_plan.limit;
    if (off > allowed)
        return Error{m_plan.mayStray ? ErrorCode::ConditionUnmet : ErrorCode::Diverged,
                     u"%1° from the middle, %2° are allowed"_s.arg(off, 0, 'f', 1).arg(allowed, 0, 'f', 1),
                     0};
    const double rate = m_roles.gyro[m_axis] >= 0 ? std::abs(latest(m_roles.gyro[m_axis])) : 0.0;
    if (m_plan.maxRate > 0 && rate > m_plan.maxRate)
        return Error{ErrorCode::Diverged, u"it turns with %1°/s"_s.arg(rate, 0, 'f', 0), 0};
    return {};
}

Result<void> Run::wait()
{
    if (const auto found = danger())
        return tl::unexpected(*found);
    return m_channel.sleep(kTick);
}

// Moves the camera to its middle and measures where that is; the test's own time begins then.
Result<void> Run::center()
{
    const int channel = m_roles.angle[m_axis];
    double quietAngle = latest(channel);  // the axis has stayed near this angle since
    TimePoint quietSince = m_channel.now();
    m_centering = true;
    while (seconds(m_channel.now() - quietSince) < kQuiet) {
        if (seconds(m_channel.now() - m_startedAt) > kCentering)
            return failure(ErrorCode::Unready, u"the axis does not come to rest in its middle"_s);
        steer(0.0);
        if (const auto waited = wait(); !waited)
            return waited;
        if (std::abs(latest(channel) - quietAngle) > kStay) {
            quietAngle = latest(channel);
            quietSince = m_channel.now();
        }
    }
    m_centering = false;
    const double end = m_telemetry.secondsAt(m_channel.now());
    const auto still = uniformSamples(m_telemetry, channel, -1, end - kQuiet, end);
    m_rest = still
        ? std::accumulate(still->values.begin(), still->values.end(), 0.0) / double(still->values.size())
        : quietAngle;
    m_sent.clear();
    m_startedAt = m_channel.now();
    return {};
}

Result<void> Run::move()
{
    for (;;) {
        const double elapsed = seconds(m_channel.now() - m_startedAt);
        if (elapsed > m_plan.duration() + kTail)
            return {};
        steer(m_plan.offsetAt(elapsed));
        report(std::min(1.0, elapsed / m_plan.duration()));
        if (const auto waited = wait(); !waited)
            return waited;
    }
}

void Run::steer(double offset)
{
    SteeringSetpoint setpoint = m_middle;
    setpoint.inputs[std::size_t(m_input)] += offset;
    if (m_sent.empty() || m_sent.back().second != offset)
        m_sent.emplace_back(m_channel.now(), offset);
    m_channel.steer(m_device.steering()->controlFrames(setpoint));
}

void Run::report(double share)
{
    if (m_plan.told) {
        m_channel.progress(*m_plan.told);
        return;
    }
    Progress progress;
    progress.step = u"motion-test"_s;
    progress.done = int(std::lround(share * 1000.0));
    progress.total = 1000;
    m_channel.progress(progress);
}

// The target as it was sent, at the instants of the angle samples.
UniformSamples Run::sentTarget(const UniformSamples &angle) const
{
    UniformSamples target = angle;
    for (std::size_t i = 0; i < target.values.size(); ++i) {
        const double time = angle.start + double(i) / angle.rate;
        const auto next = std::find_if(m_sent.begin(), m_sent.end(), [&](const auto &sent) {
            return m_telemetry.secondsAt(sent.first) > time;
        });
        target.values[i] = float(m_rest + (next == m_sent.begin() ? 0.0 : std::prev(next)->second));
    }
    return target;
}

Result<MotionTestResult> Run::collect() const
{
    const double from = m_telemetry.secondsAt(m_startedAt);
    const double to = from + m_plan.duration();
    auto angle = uniformSamples(m_telemetry, m_roles.angle[m_axis], -1, from, to);
    if (!angle)
        return tl::unexpected(angle.error());
    const int told = m_roles.target[m_axis];
    auto target = told < 0 ? Result<UniformSamples>(sentTarget(*angle))
                           : uniformSamples(m_telemetry, told, -1, from, to);
    if (!target)
        return tl::unexpected(target.error());
    if (angle->start != target->start || angle->values.size() != target->values.size())
        return failure(ErrorCode::InvalidArgument, u"target and angle do not come in the same rows"_s);
    if (double(angle->values.size()) / angle->rate < 0.9 * m_plan.duration())
        return failure(ErrorCode::TooFewSamples,
                       u"only %1 of %2 s arrived without a hole"_s
                           .arg(double(angle->values.size()) / angle->rate, 0, 'f', 1)
                           .arg(m_plan.duration(), 0, 'f', 1));
    return MotionTestResult{m_plan, std::move(*target), std::move(*angle)};
}

}  // namespace

bool tellsTargets(const Device &device)
{
    const ChannelRoles roles = rolesOf(device);
    return std::all_of(roles.target.begin(), roles.target.end(), [](int channel) { return channel >= 0; });
}

QList<int> motionChannels(const Device &device, Axis axis)
{
    const ChannelRoles roles = rolesOf(device);
    const auto i = std::size_t(axis);
    QList<int> channels;
    for (const int channel : {roles.target[i], roles.angle[i], roles.gyro[i]}) {
        if (channel >= 0)
            channels.append(channel);
    }
    return channels;
}

Result<MotionTestResult> measureMotion(Channel &channel, const Device &device,
                                       const TelemetryStore &telemetry, const MotionTestPlan &plan)
{
    return Run(channel, device, telemetry, plan).run();
}
