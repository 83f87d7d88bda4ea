// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/motiontest.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTick = 20ms;  // as often as set-points go out
constexpr double kTail = 0.3;  // seconds after the end until the last samples are there
constexpr double kStale = 0.4;  // seconds without new samples
constexpr double kStill = 1.0;  // degrees off target before it begins
constexpr double kQuiet = 1.0;  // seconds within kStay that show that the camera has arrived
constexpr double kStay = 0.5;  // degrees
constexpr double kCentering = 15.0;  // seconds it may take to arrive
constexpr double kFade = 0.5;  // seconds in which a sweep grows and dies away

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
         {within(degrees, 0.2, kMostDegrees, u"movement"_s), within(steps, 2, 40, u"steps"_s),
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
    // Each frequency as long as it needs: the logarithm of frequency grows evenly.
    const double t = std::clamp(seconds - kFade, 0.0, sweepSeconds);
    const double growth = std::log(toHz / fromHz) / sweepSeconds;
    const double turns = growth > 1e-9 ? fromHz * (std::exp(growth * t) - 1.0) / growth : fromHz * t;
    const double fade = std::clamp(std::min(seconds, duration() - seconds) / kFade, 0.0, 1.0);
    const double phase = seconds < kFade ? fromHz * (seconds - kFade) : turns;
    return degrees * fade * std::sin(2.0 * std::numbers::pi * phase);
}

MotionTest::MotionTest(DeviceClient &client, QObject *parent)
    : QObject(parent)
    , m_client(client)
{
    m_timer.setInterval(kTick);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &MotionTest::tick);
    connect(&m_client, &DeviceClient::connectionLost, this, [this](const Error &error) {
        if (isRunning())
            end(tl::unexpected(error), false);
    });
    connect(&m_client, &DeviceClient::motorsOffFinished, this, [this] {
        if (isRunning())
            end(failure(ErrorCode::Cancelled, u"the motors were switched off"_s), false);
    });
}

bool MotionTest::tellsTargets(const Device &device)
{
    const ChannelRoles roles = device.roles();
    return std::all_of(roles.target.begin(), roles.target.end(), [](int channel) { return channel >= 0; });
}

QList<int> MotionTest::channels(const Device &device, Axis axis)
{
    const ChannelRoles roles = device.roles();
    const auto i = std::size_t(axis);
    return {roles.target[i], roles.angle[i], roles.gyro[i]};
}

double MotionTest::latest(int channel) const
{
    const auto store = m_client.telemetry();
    return store ? double(store->latest(channel)) : std::nan("");
}

Result<void> MotionTest::start(const MotionTestPlan &plan)
{
    if (isRunning())
        return failure(ErrorCode::Busy);
    if (!m_client.isConnected())
        return failure(ErrorCode::NotConnected);
    if (!m_client.identity().writable)
        return failure(ErrorCode::ReadOnly);
    if (const auto checked = plan.check(); !checked)
        return checked;
    const Device &device = *m_client.device();
    const bool told = tellsTargets(device);
    const ControlMode *mode = nullptr;
    for (const ControlMode &each : device.controlModes()) {  // the one that reaches furthest
        const bool fits = each.usesAngle && (each.usesSpeed || !told) && qstrcmp(each.unit, "°") == 0;
        if (fits && (!mode || each.maxAngle > mode->maxAngle))
            mode = &each;
    }
    const QList<int> needed = channels(device, plan.axis);
    if (!mode || needed[1] < 0)
        return failure(ErrorCode::Unsupported, u"the board cannot be steered to an angle"_s);
    if (!told && plan.kind == MotionTestPlan::Kind::Sweep) {
        return failure(
            ErrorCode::Unsupported,
            u"the board does not tell its targets, so the line's delay would be taken for its own; "
            "steps can be measured"_s);
    }
    const ChannelRoles roles = device.roles();
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        m_middle[i] = told ? latest(roles.target[i]) : 0.0;
        if (std::isnan(m_middle[i]) || std::isnan(latest(roles.angle[i])))
            return failure(ErrorCode::Unready, u"no telemetry of the angles"_s);
    }
    if (roles.motorsOn >= 0 && !(latest(roles.motorsOn) > 0.5))
        return failure(ErrorCode::Unready, u"the motors are off"_s);
    m_plan = plan;
    m_mode = mode->id;
    m_speed = mode->maxSpeed;
    m_rest = m_middle[std::size_t(plan.axis)];
    m_centering = !told;
    m_sent.clear();
    const double off = std::abs(latest(needed[1]) - m_rest);
    if (told && !(off < kStill))
        return failure(ErrorCode::Unready, u"the axis is %1° away from its target"_s.arg(off, 0, 'f', 1));
    m_quietAngle = latest(needed[1]);
    m_quietSince = Clock::now();
    m_startedAt = m_lastNewsAt = Clock::now();
    m_lastRows = m_client.telemetry()->rows();
    m_timer.start();
    tick();
    return {};
}

void MotionTest::stop()
{
    if (isRunning())
        end(failure(ErrorCode::Cancelled), true);
}

// What must not be: the axis far from where it should be, nobody looking, motors off.
std::optional<Error> MotionTest::danger()
{
    const ChannelRoles roles = m_client.device()->roles();
    const auto axis = std::size_t(m_plan.axis);
    const TimePoint now = Clock::now();
    if (const quint64 rows = m_client.telemetry()->rows(); rows != m_lastRows) {
        m_lastRows = rows;
        m_lastNewsAt = now;
    }
    if (seconds(now - m_lastNewsAt) > kStale)
        return Error{ErrorCode::Unready,
                     u"no telemetry for %1 s"_s.arg(seconds(now - m_lastNewsAt), 0, 'f', 1), 0};
    if (roles.motorsOn >= 0 && latest(roles.motorsOn) < 0.5)
        return Error{ErrorCode::Unready, u"the motors went off"_s, 0};
    if (m_centering)
        return {};
    // A step is not followed at once: while it rises, its own height does not count.
    const double off = std::abs(latest(roles.angle[axis]) - m_rest);
    const double allowed = m_plan.degrees + m_plan.limit;
    if (off > allowed)
        return Error{ErrorCode::Diverged,
                     u"%1° from the middle, %2° are allowed"_s.arg(off, 0, 'f', 1).arg(allowed, 0, 'f', 1),
                     0};
    return {};
}

void MotionTest::tick()
{
    if (!m_client.isConnected()) {
        end(failure(ErrorCode::NotConnected), false);
        return;
    }
    if (const auto found = danger()) {
        if (found->code == ErrorCode::Diverged) {
            m_timer.stop();  // its own "motors off" is not somebody else's
            m_client.motorsOff();
        }
        end(tl::unexpected(*found), true);
        return;
    }
    if (m_centering) {
        center();
        return;
    }
    const double elapsed = seconds(Clock::now() - m_startedAt);
    if (elapsed > m_plan.duration() + kTail) {
        end(collect(), true);
        return;
    }
    steer(m_plan.offsetAt(elapsed));
    emit progressed(std::min(1.0, elapsed / m_plan.duration()));
}

// Brings the camera to its middle and finds where that is; the test's own time begins then.
void MotionTest::center()
{
    const auto axis = std::size_t(m_plan.axis);
    const int channel = m_client.device()->roles().angle[axis];
    const TimePoint now = Clock::now();
    if (std::abs(latest(channel) - m_quietAngle) > kStay) {
        m_quietAngle = latest(channel);
        m_quietSince = now;
    }
    if (seconds(now - m_startedAt) > kCentering) {
        end(failure(ErrorCode::Unready, u"the axis does not come to rest in its middle"_s), true);
        return;
    }
    steer(0.0);
    if (seconds(now - m_quietSince) < kQuiet)
        return;
    const auto store = m_client.telemetry();
    const double end = store->secondsAt(now);
    const auto still = uniformSamples(*store, channel, -1, end - kQuiet, end);
    m_rest = m_quietAngle;
    if (still)
        m_rest
            = std::accumulate(still->values.begin(), still->values.end(), 0.0) / double(still->values.size());
    m_centering = false;
    m_sent.clear();
    m_startedAt = now;
}

void MotionTest::steer(double offset)
{
    ControlSetpoint setpoint{};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        setpoint[i] = {m_mode, m_speed, m_middle[i]};
        if (i == std::size_t(m_plan.axis))
            setpoint[i].angle += offset;
    }
    if (m_sent.empty() || m_sent.back().second != offset)
        m_sent.emplace_back(Clock::now(), offset);
    m_client.setControl(setpoint);
}

// What was sent, at the instants of the angle.
UniformSamples MotionTest::sentTarget(const UniformSamples &angle) const
{
    const auto store = m_client.telemetry();
    UniformSamples target = angle;
    for (std::size_t i = 0; i < target.values.size(); ++i) {
        const double time = angle.start + double(i) / angle.rate;
        const auto next = std::find_if(m_sent.begin(), m_sent.end(),
                                       [&](const auto &sent) { return store->secondsAt(sent.first) > time; });
        target.values[i] = float(m_rest + (next == m_sent.begin() ? 0.0 : std::prev(next)->second));
    }
    return target;
}

Result<MotionTestResult> MotionTest::collect() const
{
    const QList<int> wanted = channels(*m_client.device(), m_plan.axis);
    const auto store = m_client.telemetry();
    const double from = store->secondsAt(m_startedAt);
    const double to = from + m_plan.duration();
    auto angle = uniformSamples(*store, wanted[1], -1, from, to);
    if (!angle)
        return tl::unexpected(angle.error());
    auto target = wanted[0] < 0 ? Result<UniformSamples>(sentTarget(*angle))
                                : uniformSamples(*store, wanted[0], -1, from, to);
    if (!target)
        return tl::unexpected(target.error());
    if (angle->start != target->start || angle->values.size() != target->values.size())
        return failure(ErrorCode::InvalidArgument, u"target and angle do not come in the same rows"_s);
    if (double(angle->values.size()) / angle->rate < 0.9 * m_plan.duration())
        return failure(ErrorCode::InvalidArgument,
                       u"only %1 of %2 s arrived without a hole"_s
                           .arg(double(angle->values.size()) / angle->rate, 0, 'f', 1)
                           .arg(m_plan.duration(), 0, 'f', 1));
    return MotionTestResult{m_plan, std::move(*target), std::move(*angle)};
}

void MotionTest::end(const Result<MotionTestResult> &result, bool release)
{
    m_timer.stop();
    if (release)
        m_client.releaseControl();
    if (result)
        emit measured(*result);
    else
        emit failed(result.error());
}
