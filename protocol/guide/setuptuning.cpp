// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that measure how the camera is held, and what it is for.
#include "protocol/analysis/stepresponse.h"
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/procedure/notchplan.h"
#include "protocol/procedure/notchtrial.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/session/channel.h"
#include "protocol/telemetry/uniformsamples.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kHoldingSeconds = 8;
constexpr auto kRest = 2s;
// The response: small steps, so that nothing is hit, and more than a hand sways.
constexpr double kStepDegrees = 3;
constexpr double kStepRest = 1;
constexpr int kStepCount = 2;
constexpr double kMostOff = 15;  // degrees beyond the step
constexpr double kTooWild = 250;  // deg/s
constexpr double kOvershoots = 60;  // % of the step: it rings before it rests
constexpr double kBetter = 0.95;
constexpr double kWorse = 1.1;
constexpr double kAxisWorse = 1.3;  // what a hand does differs from one measurement to the next
constexpr double kStrong = 3;  // °/s RMS: a hand-held camera that is held well has a tenth of it

double rmsOfAngles(const std::vector<float> &values)
{
    double sum = 0;
    for (const float value : values) {
        const double part = std::remainder(double(value), 360.0);
        sum += part * part;
    }
    return values.empty() ? 0.0 : std::sqrt(sum / double(values.size()));
}

bool shakesStrongly(const SetupResult &result)
{
    return std::any_of(result.figures.begin(), result.figures.end(), [](const SetupFigure &figure) {
        return figure.key.startsWith(u"shakes."_s) && figure.value > kStrong;
    });
}

double wholeOf(const std::array<double, kAxisCount> &held)
{
    return std::sqrt(held[0] * held[0] + held[1] * held[1] + held[2] * held[2]);
}

}  // namespace

Result<SetupGuide::Span> SetupGuide::measure(double seconds)
{
    const double from = m_telemetry.secondsAt(m_channel.now());
    const auto watched = watch(
        seconds, []() -> Result<void> { return {}; }, u"setup-measure"_s);
    if (!watched)
        return tl::unexpected(watched.error());
    return std::pair(from, m_telemetry.secondsAt(m_channel.now()));
}

Result<SetupGuide::Held> SetupGuide::measureHolding()
{
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.angle, m_roles.target})); !news)
        return tl::unexpected(news.error());
    const auto span = measure(kHoldingSeconds);
    if (!span)
        return tl::unexpected(span.error());
    Held held;
    held.span = *span;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (m_roles.angle[axis] < 0 || m_roles.target[axis] < 0)
            continue;
        const auto samples = uniformSamples(m_telemetry, m_roles.angle[axis], m_roles.target[axis],
                                            span->first, span->second);
        if (!samples)
            return tl::unexpected(samples.error());
        held.off[axis] = rmsOfAngles(samples->values);
    }
    return held;
}

Result<SetupGuide::Held> SetupGuide::measureHeld()
{
    auto held = measureHolding();
    if (!held)
        return held;
    for (const Axis axis : kAxes) {
        const auto response = measureResponse(axis);
        if (!response)
            return tl::unexpected(response.error());
        held->response[std::size_t(axis)] = *response;
    }
    return held;
}

Result<std::optional<SetupGuide::Response>> SetupGuide::measureResponse(Axis axis)
{
    const auto at = std::size_t(axis);
    const std::optional<Response> none;
    if (m_roles.angle[at] < 0 || m_roles.target[at] < 0 || !m_device.steering())
        return none;
    MotionTestPlan plan;
    plan.axis = axis;
    plan.degrees = kStepDegrees;
    plan.steps = kStepCount;
    plan.rest = kStepRest;
    plan.limit = kMostOff;
    plan.maxRate = kTooWild;
    plan.mayStray = true;
    plan.told = Progress();
    plan.told->step = u"setup-response"_s;
    plan.told->done = int(at);
    plan.told->total = int(kAxisCount);
    const auto moved = measureMotion(m_channel, m_device, m_telemetry, plan);
    if (!moved) {
        const bool isAbout
            = moved.error().code == ErrorCode::ConditionUnmet || moved.error().code == ErrorCode::Unready;
        if (!isAbout)
            return tl::unexpected(moved.error());
        // It does not follow; motors that are off say nothing of it.
        const auto run = requireMotors();
        return run ? Result<std::optional<Response>>(none) : tl::unexpected(run.error());
    }
    const auto steps = measureSteps(moved->target.values, moved->angle.values, moved->angle.rate, kStepRest);
    if (!steps || !steps->metrics.riseSeconds)
        return none;
    return Response{steps->metrics.overshoot, *steps->metrics.riseSeconds};
}

void SetupGuide::addHeld(const Held &is, const Held *before, SetupResult &result)
{
    constexpr double kMilliseconds = 1000;
    for (const Axis axis : kAxes) {
        const auto at = std::size_t(axis);
        result.figures.append({setupFigureKey("holds", axis), is.off[at],
                               before ? std::optional(before->off[at]) : std::nullopt});
        const auto &now = is.response[at];
        const auto was = before ? before->response[at] : std::nullopt;
        if (!now)
            continue;
        const auto add = [&](const char *figure, double Response::*part, double unit) {
            result.figures.append({setupFigureKey(figure, axis), *now.*part * unit,
                                   was ? std::optional(*was.*part * unit) : std::nullopt});
        };
        add("rises", &Response::riseSeconds, kMilliseconds);
        add("overshoots", &Response::overshoot, 1);
        if (now->overshoot > kOvershoots)
            result.remarks.append(u"gains.overshoots"_s);
    }
    result.remarks.removeDuplicates();
}

// Found elsewhere, by hand or on another page: they are measured all the same.
Result<SetupResult> SetupGuide::measureGains()
{
    const auto held = measureHeld();
    if (!held)
        return tl::unexpected(held.error());
    SetupResult result;
    result.remarks = QStringList{u"gains.measured"_s};
    addHeld(*held, nullptr, result);
    return result;
}

Result<SetupResult> SetupGuide::gains(const QVariantMap &answers)
{
    if (const auto run = requireMotors(); !run)
        return tl::unexpected(run.error());
    if (!answers.value(u"search"_s).toBool())
        return measureGains();
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    const auto before = measureHeld();
    if (!before)
        return tl::unexpected(before.error());
    const auto actions = m_device.actions();
    const auto tune = std::find_if(actions.begin(), actions.end(), [this](const ActionSpec &each) {
        return m_keys.autoTune == QLatin1String(each.key);
    });
    const auto arguments = parseArguments(*tune, {});
    if (!arguments)
        return tl::unexpected(arguments.error());
    const auto done
        = performSafely(m_channel, m_device, m_keys.autoTune, *arguments, m_history, m_live, &m_telemetry);
    if (!done)
        return tl::unexpected(done.error());
    auto judged = judgeGains(*base, *before);
    if (!judged)
        return tl::unexpected(takenBack(judged.error()));
    dropTrial(m_history, m_device.identity());
    judged->snapshot = done->snapshotPath;
    return judged;
}

// An axis that the search has made worse has its own gains again; the others keep theirs.
Result<Configuration> SetupGuide::withoutWorse(const Configuration &base, const Configuration &board,
                                               const Held &before, const Held &after)
{
    Configuration edited = board;
    for (const ParameterChange &change : base.changesTo(board)) {
        const auto at = std::size_t(change.spec->axis);
        if (at >= kAxisCount || after.off[at] <= kAxisWorse * before.off[at])
            continue;
        if (const auto set = edited.setRaw(*change.spec, change.profile, change.from); !set)
            return tl::unexpected(set.error());
    }
    return edited;
}

Result<void> SetupGuide::restoreAxes(const Configuration &base, const Configuration &board,
                                     const Configuration &edited)
{
    if (const auto kept = keepTrial(m_history, base, board, &edited); !kept)
        return tl::unexpected(kept.error());
    const Unbroken unbroken(m_channel);
    const auto report = writeConfiguration(m_channel, m_device, board, edited,
                                           {.history = &m_history, .backupDone = true, .live = m_live});
    if (!report)
        return tl::unexpected(report.error());
    return report->error ? Result<void>(tl::unexpected(*report->error)) : Result<void>();
}

Result<SetupResult> SetupGuide::judgeGains(const Configuration &base, const Held &before)
{
    auto now = m_device.readConfiguration(m_channel);
    if (!now)
        return tl::unexpected(now.error());
    if (const auto kept = keepTrial(m_history, base, *now); !kept)
        return tl::unexpected(kept.error());
    if (const auto slept = m_channel.sleep(kRest); !slept)
        return tl::unexpected(slept.error());
    auto after = measureHeld();
    if (!after)
        return tl::unexpected(after.error());
    SetupResult result;
    const auto edited = withoutWorse(base, *now, before, *after);
    if (!edited)
        return tl::unexpected(edited.error());
    const bool hasBetter = base.changesTo(*now).empty() || !base.changesTo(*edited).empty();
    if (hasBetter && !now->changesTo(*edited).empty()) {
        if (const auto restored = restoreAxes(base, *now, *edited); !restored)
            return tl::unexpected(restored.error());
        now = edited;
        result.remarks.append(u"gains.axisback"_s);
        after = measureHeld();
        if (!after)
            return tl::unexpected(after.error());
    }
    list(base, *now, result);
    addHeld(*after, &before, result);
    const double was = wholeOf(before.off);
    const double is = wholeOf(after->off);
    if (hasBetter && is <= kWorse * was) {
        result.remarks.prepend(is < kBetter * was ? u"gains.better"_s : u"gains.same"_s);
        // What holds well may ring.
        if (const auto lines = linesOf(after->span, result); !lines)
            return tl::unexpected(lines.error());
        if (shakesStrongly(result)) {
            result.remarks.append(u"gains.shakes"_s);
            result.state = SetupResult::State::Poor;
        }
        return result;
    }
    const auto undone = makeTrialGood(m_channel, m_device, m_history, *now);
    if (undone)
        result.changes.clear();
    result.state = SetupResult::State::Poor;
    result.remarks = QStringList{undone ? u"gains.takenback"_s : u"gains.worse"_s};
    return result;
}

Result<SetupGuide::Lines> SetupGuide::linesOf(const Span &span, SetupResult &result) const
{
    Lines lines;
    for (const Axis axis : kAxes) {
        const int channel = m_roles.gyro[std::size_t(axis)];
        if (channel < 0)
            continue;
        const auto samples = uniformSamples(m_telemetry, channel, -1, span.first, span.second);
        if (!samples)
            return tl::unexpected(samples.error());
        const auto found = spectrum(samples->values, samples->rate);
        if (!found)
            return tl::unexpected(found.error());
        const double whole = found->bandRms(kVibrationFrom, samples->rate / 2);
        result.figures.append({setupFigureKey("shakes", axis), whole});
        const auto peaks = findPeaks(*found, 1, kVibrationFrom);
        if (peaks.empty())
            continue;
        result.figures.append({setupFigureKey("line", axis), peaks.front().frequency});
        if (adviseNotch({peaks.front(), whole, 0, {}, nullptr}).isOffered())
            lines.emplace_back(axis, peaks.front());
    }
    return lines;
}

// What a trial has shown to be better is written; all else is as it was.
Result<bool> SetupGuide::tryNotchFor(Axis axis, const SpectrumPeak &peak, SetupResult &result)
{
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    const auto plan = planNotch(m_device, *base, *base, axis, peak);
    if (!plan)
        return false;
    NotchTrialPlan trial;
    trial.axis = axis;
    trial.hz = peak.frequency;
    trial.width = peak.width;
    trial.base = *base;
    trial.wanted = plan->appliedTo(*base);
    const std::atomic<bool> goesOn = false;
    const auto tried
        = tryNotch(m_channel, m_device, m_telemetry, trial, {.history = &m_history, .live = m_live}, goesOn);
    if (!tried)
        return tl::unexpected(tried.error());
    if (!tried->isTakenBack)
        return failure(ErrorCode::NotRestored, u"the notch that was tried is still on the board"_s);
    if (tried->ended)
        return tl::unexpected(*tried->ended);
    if (tried->verdict != NotchTrialResult::Verdict::Better)
        return false;
    if (const auto written = write(*base, trial.wanted, result); !written)
        return tl::unexpected(written.error());
    for (SetupFigure &figure : result.figures) {
        if (figure.key == setupFigureKey("shakes", axis)) {
            figure.before = tried->before.whole;
            figure.value = tried->after.whole;
        }
    }
    return true;
}

Result<SetupResult> SetupGuide::vibration(const QVariantMap &answers)
{
    if (const auto run = requireMotors(); !run)
        return tl::unexpected(run.error());
    SetupResult result;
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.gyro})); !news)
        return tl::unexpected(news.error());
    const auto span = measure(kHoldingSeconds);
    if (!span)
        return tl::unexpected(span.error());
    const auto lines = linesOf(*span, result);
    if (!lines)
        return tl::unexpected(lines.error());
    const bool tries = answers.value(u"try"_s).toBool() && m_device.notchFilters();
    bool helped = false;
    for (const auto &[axis, peak] : *lines) {
        const auto kept = tries ? tryNotchFor(axis, peak, result) : Result<bool>(false);
        if (!kept)
            return tl::unexpected(kept.error());
        helped = helped || *kept;
    }
    result.remarks = QStringList{lines->empty() ? u"vibration.calm"_s
                                     : !tries   ? u"vibration.lines"_s
                                     : helped   ? u"vibration.notch"_s
                                                : u"vibration.nonotch"_s};
    if (shakesStrongly(result)) {
        result.remarks.append(u"vibration.strong"_s);
        result.state = SetupResult::State::Poor;
    }
    return result;
}

Result<SetupResult> SetupGuide::use(const QVariantMap &answers)
{
    const auto &wanted = m_keys.uses[std::size_t(answers.value(u"use"_s).toInt())];
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    Configuration edited = *base;
    for (const auto &[key, value] : wanted.values) {
        const ParameterSpec *spec = find(key);
        if (!spec || !base->raw(*spec, base->activeProfile()))
            continue;  // of another firmware
        if (const auto set = edited.setRaw(*spec, base->activeProfile(), spec->clamped(spec->toRaw(value)));
            !set)
            return tl::unexpected(set.error());
    }
    SetupResult result;
    if (base->changesTo(edited).empty()) {
        result.state = SetupResult::State::Done;
        result.remarks = QStringList{u"use.same"_s};
        return result;
    }
    if (!answers.value(u"apply"_s).toBool()) {
        list(*base, edited, result);
        result.remarks = QStringList{u"use.shown"_s};
        return result;
    }
    if (const auto written = write(*base, edited, result); !written)
        return tl::unexpected(written.error());
    result.state = SetupResult::State::Done;
    result.remarks = QStringList{u"use.set"_s};
    return result;
}
