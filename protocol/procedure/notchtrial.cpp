// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/notchtrial.h"

#include "protocol/analysis/notchadvice.h"
#include "protocol/analysis/spectrum.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/session/channel.h"
#include "protocol/telemetry/roles.h"
#include "protocol/telemetry/uniformsamples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLook = 40ms;  // interval of looking for oscillation
constexpr double kMoment = 0.25;  // seconds of samples that each look covers
constexpr double kSettle = 0.5;  // seconds after the write that do not count
constexpr double kSilence = 0.5;  // seconds without samples that end the trial
constexpr double kGrown = 3.0;  // times the liveliest moment without the notch: it oscillates
constexpr double kAlways = 3.0;  // deg/s that no axis is blamed for
constexpr double kWorse = 1.4;  // of the vibration before: a hand alone makes it differ by a sixth
constexpr double kStrays = 1.5;  // of the error before: hands differ more from span to span
constexpr double kSmallError = 0.05;  // degrees that are nobody's fault
constexpr double kLineGone = 0.7;  // of the line before
constexpr double kCalm = 1.1;  // of the vibration before, which the hand makes too
constexpr int kAttempts = 3;  // at writing the old values back
constexpr double kSharpest = 1.0;  // Hz between bins at most

double rmsAroundMean(std::span<const float> values)
{
    const double count = double(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    const double squares = std::accumulate(values.begin(), values.end(), 0.0, [mean](double sum, float v) {
        return sum + (double(v) - mean) * (double(v) - mean);
    });
    return std::sqrt(squares / count);
}

/// One trial.
class NotchTrial
{
public:
    NotchTrial(Channel &channel, Device &device, const TelemetryStore &telemetry, const NotchTrialPlan &plan,
               const WriteOptions &options, const std::atomic<bool> &stop)
        : m_channel(channel)
        , m_device(device)
        , m_telemetry(telemetry)
        , m_plan(plan)
        , m_options(options)
        , m_stop(stop)
        , m_roles(rolesOf(device))
    {
    }

    Result<NotchTrialResult> run();

private:
    using Figures = std::array<Vibration, kAxisCount>;

    Result<void> prepare();
    /// Waits and looks at the axes; false in `calm` when one oscillates.
    Result<void> watch(double seconds, int stage, bool isGuarded, bool &calm);
    Result<Figures> measure(double from) const;
    void takeBack();
    void judge(const Figures &before, const Figures &after);
    void report(int stage, double share);
    [[nodiscard]] std::optional<double> moment(std::size_t axis) const;
    [[nodiscard]] double now() const { return m_telemetry.secondsAt(m_channel.now()); }

    Channel &m_channel;
    Device &m_device;
    const TelemetryStore &m_telemetry;
    const NotchTrialPlan &m_plan;
    const WriteOptions &m_options;
    const std::atomic<bool> &m_stop;
    const ChannelRoles m_roles;
    NotchTrialResult m_result;
    std::array<double, kAxisCount> m_liveliest{};  // moment of each axis without the notch
};

Result<NotchTrialResult> NotchTrial::run()
{
    if (const auto ready = prepare(); !ready)
        return tl::unexpected(ready.error());
    bool calm = true;
    const double start = now();
    if (const auto watched = watch(m_plan.seconds, 0, false, calm); !watched)
        return tl::unexpected(watched.error());
    const auto before = measure(start);
    if (!before)
        return tl::unexpected(before.error());
    m_result.before = (*before)[std::size_t(m_plan.axis)];

    if (const auto kept = keepTrial(*m_options.history, m_plan.base, m_plan.wanted); !kept)
        return tl::unexpected(kept.error());
    auto written = writeConfiguration(m_channel, m_device, m_plan.base, m_plan.wanted, m_options);
    if (!written) {
        dropTrial(*m_options.history, m_device.identity());
        return tl::unexpected(written.error());
    }
    m_result.lastWrite = std::move(*written);
    if (!m_result.lastWrite.isComplete()) {
        m_result.ended = m_result.lastWrite.error;
        takeBack();
        return m_result;
    }
    auto watched = watch(kSettle, 1, true, calm);
    const double begin = now();
    if (watched && calm)
        watched = watch(m_plan.seconds, 1, true, calm);
    const auto after = watched && calm ? measure(begin) : Result<Figures>(*before);
    takeBack();
    if (!calm)
        m_result.verdict = NotchTrialResult::Verdict::Oscillates;
    else if (!watched || !after)
        m_result.ended = watched ? after.error() : watched.error();
    else
        judge(*before, *after);
    return m_result;
}

Result<void> NotchTrial::prepare()
{
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly, m_device.identity().firmware);
    if (!m_options.history)
        return failure(ErrorCode::NoBackup);
    if (m_plan.axis == Axis::None || m_roles.gyro[std::size_t(m_plan.axis)] < 0)
        return failure(ErrorCode::Unsupported, u"the board sends no angular rate of this axis"_s);
    if (auto off = findMotorsNotRunning(m_roles, m_telemetry))
        return tl::unexpected(std::move(*off));
    return {};
}

// RMS of the last moment around its mean; nothing without samples.
std::optional<double> NotchTrial::moment(std::size_t axis) const
{
    if (m_roles.gyro[axis] < 0)
        return {};
    const auto samples = uniformSamples(m_telemetry, m_roles.gyro[axis], -1, now() - kMoment, now());
    if (!samples || samples->values.size() < 4)
        return {};
    return rmsAroundMean(samples->values);
}

Result<void> NotchTrial::watch(double seconds, int stage, bool isGuarded, bool &calm)
{
    const double start = now();
    double seenAt = start;
    while (now() - start < seconds) {
        if (const auto slept = m_channel.sleep(kLook); !slept)
            return slept;
        if (m_stop)
            return failure(ErrorCode::Cancelled);
        if (m_roles.outputs >= 0 && double(m_telemetry.latest(m_roles.outputs)) < 0.5)
            return failure(ErrorCode::Unready, u"the motors went off"_s);
        report(stage, std::min(1.0, (now() - start) / seconds));
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const auto rms = moment(axis);
            if (!rms)
                continue;
            if (axis == std::size_t(m_plan.axis))
                seenAt = now();
            if (!isGuarded) {
                m_liveliest[axis] = std::max(m_liveliest[axis], *rms);
                continue;
            }
            if (*rms > m_result.peak) {
                m_result.peak = *rms;
                m_result.peakAxis = kAxes[axis];
            }
            if (*rms > std::max(kAlways, kGrown * m_liveliest[axis])) {
                calm = false;
                return {};
            }
        }
        if (now() - seenAt > kSilence)
            return failure(ErrorCode::Unready, u"no telemetry for %1 s"_s.arg(kSilence));
    }
    return {};
}

Result<NotchTrial::Figures> NotchTrial::measure(double from) const
{
    Figures figures{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (m_roles.gyro[axis] < 0)
            continue;
        const auto gyro = uniformSamples(m_telemetry, m_roles.gyro[axis], -1, from, now());
        if (!gyro)
            return tl::unexpected(gyro.error());
        int length = 64;
        while (length * 4 <= int(gyro->values.size()) && gyro->rate / length > kSharpest)
            length *= 2;
        const auto spectrum = ::spectrum(gyro->values, gyro->rate, {length});
        if (!spectrum)
            return tl::unexpected(spectrum.error());
        const double reach = std::max(m_plan.width, 4.0 * spectrum->resolution);
        const double end = spectrum->rate;
        figures[axis].line = spectrum->bandRms(m_plan.hz - reach, m_plan.hz + reach);
        figures[axis].whole = spectrum->bandRms(kVibrationFrom, end);
        const auto error
            = uniformSamples(m_telemetry, m_roles.angle[axis], m_roles.target[axis], from, now());
        figures[axis].error = error ? rmsAroundMean(error->values) : std::numeric_limits<double>::quiet_NaN();
    }
    return figures;
}

// Until the board says that it holds the old values again, or cannot be asked any more; even after a cancel.
void NotchTrial::takeBack()
{
    const auto note = keptTrial(*m_options.history, m_device.identity());
    const Unbroken unbroken(m_channel);
    WriteOptions options = m_options;
    options.backupDone = true;
    for (int attempt = 0; note && attempt < kAttempts && !m_result.isTakenBack; ++attempt) {
        const auto now = m_device.readConfiguration(m_channel);
        auto back = now ? writeConfiguration(m_channel, m_device, *now, note->madeGood(*now), options)
                        : Result<WriteReport>(tl::unexpected(now.error()));
        if (!back)
            continue;
        m_result.lastWrite = std::move(*back);
        m_result.isTakenBack = m_result.lastWrite.isComplete();
    }
    if (m_result.isTakenBack)
        dropTrial(*m_options.history, m_device.identity());
}

void NotchTrial::judge(const Figures &before, const Figures &after)
{
    using Verdict = NotchTrialResult::Verdict;
    const Vibration &was = m_result.before;
    const Vibration &is = m_result.after = after[std::size_t(m_plan.axis)];
    m_result.verdict = is.line < kLineGone * was.line && is.whole < kCalm * was.whole ? Verdict::Better
                                                                                      : Verdict::NoBetter;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double error = before[axis].error;
        if (after[axis].whole > kWorse * before[axis].whole
            || after[axis].error > kStrays * error + kSmallError)
            m_result.verdict = Verdict::Worse;
    }
}

void NotchTrial::report(int stage, double share)
{
    Progress progress;
    progress.step = stage == 0 ? u"measure-before"_s : u"measure-after"_s;
    progress.done = int(std::lround((stage + share) * 500.0));
    progress.total = 1000;
    m_channel.progress(progress);
}

}  // namespace

Result<NotchTrialResult> tryNotch(Channel &channel, Device &device, const TelemetryStore &telemetry,
                                  const NotchTrialPlan &plan, const WriteOptions &options,
                                  const std::atomic<bool> &stop)
{
    return NotchTrial(channel, device, telemetry, plan, options, stop).run();
}
