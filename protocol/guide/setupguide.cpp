// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setupguide.h"

#include "protocol/device/device.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kMoment = 50ms;
constexpr auto kNews = 3s;  // in which telemetry has to come
// Volts of a cell: what a healthy one can have, when to warn, and when to let go. Lithium polymer is damaged
// below 3.0 V, lithium ion below 2.5 V; under load both drop by some tenths.
constexpr double kFullCell = 4.25;
constexpr double kUsableCell = 3.35;
constexpr double kUsbOnly = 5.6;
constexpr int kMostCells = 14;
struct CellLimits
{
    double alarm, off;
};
constexpr std::array kCellLimits{CellLimits{3.5, 3.3}, CellLimits{3.2, 2.9}};
// What calibrations leave: the same figures as on the page for calibrations.
constexpr double kGoodBias = 0.1;
constexpr double kUsableBias = 0.5;
constexpr double kGoodLevel = 0.012;
constexpr double kUsableLevel = 0.04;
// Balance.
constexpr double kHeldLevel = 6;  // degrees
constexpr double kHeldSeconds = 1;
constexpr double kHoldPatience = 60;
constexpr double kLetGoSeconds = 2;
constexpr double kSwingSeconds = 4;
constexpr double kBalanced = 8;  // degrees: a light push moves it by some
constexpr double kStirred = 7;  // deg/s from least to most: less is a camera that was never let go

bool needsCamera(SetupStep step)
{
    return step != SetupStep::Power && step != SetupStep::Remote && step != SetupStep::Use;
}

// What another sensor measures would be taken for the camera's.
Result<void> isCameraShown(const Device &device, const TelemetryStore &telemetry)
{
    constexpr float kCamera = 1;
    const int sensor = findRole(device.channels(), device.identity().capabilities, "sensor");
    if (sensor < 0 || std::isnan(telemetry.latest(sensor)) || telemetry.latest(sensor) == kCamera)
        return {};
    return failure(
        ErrorCode::ConditionUnmet,
        u"the board shows the sensor of its frame, and this step is about the camera's: select that one "
        "first"_s);
}

}  // namespace

SetupGuide::SetupGuide(Channel &channel, Device &device, const TelemetryStore &telemetry,
                       const BoardHistory &history, LiveValues live)
    : m_channel(channel)
    , m_device(device)
    , m_telemetry(telemetry)
    , m_history(history)
    , m_live(std::move(live))
    , m_roles(rolesOf(device))
{
    if (const SetupFacts *facts = device.setupFacts())
        m_keys = facts->setupKeys();
}

QList<int> SetupGuide::channels(const Device &device)
{
    const ChannelRoles roles = rolesOf(device);
    QList<int> all
        = ChannelRoles::present({roles.angle, roles.target, roles.gyro, roles.acc, roles.motorTemperature,
                                 roles.frameAngle, roles.joint, roles.motorPower});
    for (const int channel : {roles.battery, roles.current, roles.outputs, roles.faults, roles.faultDetail}) {
        if (channel >= 0)
            all.append(channel);
    }
    const SetupFacts *facts = device.setupFacts();
    const QString input = facts ? facts->setupKeys().inputChannel.section(u'%', 0, 0) : QString();
    const auto table = device.channels();
    for (std::size_t i = 0; i < table.size() && !input.isEmpty(); ++i) {
        if (QLatin1String(table[i].key).startsWith(input))
            all.append(int(i));
    }
    return all;
}

Result<SetupResult> SetupGuide::run(SetupStep step, const QVariantMap &answers, bool areMotorsKnown)
{
    const std::vector<SetupStep> steps = stepsOf(m_device);
    if (std::find(steps.begin(), steps.end(), step) == steps.end())
        return failure(ErrorCode::Unsupported, u"this board lacks something for that step"_s);
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly);
    if (const auto shown = needsCamera(step) ? isCameraShown(m_device, m_telemetry) : Result<void>(); !shown)
        return tl::unexpected(shown.error());
    Result<SetupResult> result = failure(ErrorCode::Unsupported);
    switch (step) {
    case SetupStep::Power: result = power(answers); break;
    case SetupStep::Sensors: result = sensors(); break;
    case SetupStep::Gyroscope:
        result = calibrate(m_keys.calibrateGyro, u"gyro.bias"_s, u"bias"_s, kGoodBias, kUsableBias,
                           areMotorsKnown);
        break;
    case SetupStep::Orientation: result = orientation(); break;
    case SetupStep::Level:
        result = calibrate(m_keys.calibrateLevel, u"acc.error"_s, u"acc"_s, kGoodLevel, kUsableLevel,
                           areMotorsKnown);
        break;
    case SetupStep::Balance: result = balance(); break;
    case SetupStep::Motors: result = motors(); break;
    case SetupStep::MotorPower: result = motorPower(); break;
    case SetupStep::Gains: result = gains(answers); break;
    case SetupStep::Vibration: result = vibration(answers); break;
    case SetupStep::Limits: result = limits(answers); break;
    case SetupStep::Remote: result = remote(answers); break;
    case SetupStep::Use: result = use(answers); break;
    }
    if (!result)
        return result;
    result->at = QDateTime::currentDateTimeUtc();
    if (result->state == SetupResult::State::Open && step != SetupStep::Use)
        result->state = SetupResult::State::Done;
    return result;
}

void SetupGuide::tell(const QString &step, double share)
{
    Progress progress;
    progress.step = step;
    progress.done = std::clamp(int(100 * share), 0, 100);
    progress.total = 100;
    m_channel.progress(progress);
}

const ParameterSpec *SetupGuide::find(const QString &key, Axis axis) const
{
    return m_device.parameters()->find(axis == Axis::None ? key : key.arg(QLatin1String(axisKey(axis))));
}

Result<void> SetupGuide::awaitNews(const QList<int> &channels)
{
    const TimePoint began = m_channel.now();
    for (;;) {
        const bool isThere = std::all_of(channels.begin(), channels.end(), [&](int channel) {
            return channel < 0 || m_telemetry.latestAt(channel) > began;
        });
        if (isThere)
            return {};
        if (m_channel.now() - began > kNews)
            return failure(ErrorCode::Unready, u"no telemetry"_s);
        if (const auto slept = m_channel.sleep(kMoment); !slept)
            return slept;
    }
}

Result<void> SetupGuide::letPass()
{
    if (const auto slept = m_channel.sleep(kMoment); !slept)
        return slept;
    const QList<int> all = channels(m_device);
    const bool isThere = std::any_of(all.begin(), all.end(), [this](int channel) {
        return m_channel.now() - m_telemetry.latestAt(channel) < kNews;
    });
    return isThere ? Result<void>() : failure(ErrorCode::NoSamples);
}

Result<void> SetupGuide::watch(double seconds, const std::function<Result<void>()> &each, const QString &step)
{
    const TimePoint began = m_channel.now();
    for (;;) {
        const double gone = ::seconds(m_channel.now() - began);
        if (gone >= seconds)
            return {};
        tell(step, gone / seconds);
        if (const auto passed = letPass(); !passed)
            return passed;
        if (const auto goesOn = each(); !goesOn)
            return goesOn;
    }
}

Result<double> SetupGuide::average(int channel, double seconds)
{
    if (const auto news = awaitNews({channel}); !news)
        return tl::unexpected(news.error());
    double sum = 0;
    int count = 0;
    const auto watched = watch(
        seconds,
        [&]() -> Result<void> {
            if (const double value = latest(channel); !std::isnan(value)) {
                sum += value;
                ++count;
            }
            return {};
        },
        u"setup-measure"_s);
    if (!watched)
        return tl::unexpected(watched.error());
    if (const auto news = awaitNews({channel}); !news)  // what came last may be old
        return tl::unexpected(news.error());
    if (count == 0)
        return failure(ErrorCode::Unready, u"no telemetry"_s);
    return sum / count;
}

void SetupGuide::list(const Configuration &base, const Configuration &edited, SetupResult &result)
{
    for (const ParameterChange &change : base.changesTo(edited))
        result.changes.append({change.spec->key, change.profile, change.spec->format(change.from),
                               change.spec->format(change.to)});
}

Result<void> SetupGuide::write(const Configuration &base, const Configuration &edited, SetupResult &result)
{
    const auto written = writeOnTrial(base, edited, result);
    if (!written)
        return tl::unexpected(takenBack(written.error()));
    dropTrial(m_history, m_device.identity());
    return {};
}

Result<void> SetupGuide::writeOnTrial(const Configuration &base, const Configuration &edited,
                                      SetupResult &result)
{
    if (const auto kept = keepTrial(m_history, base, edited); !kept)
        return kept;
    const Unbroken unbroken(m_channel);
    const auto report
        = writeConfiguration(m_channel, m_device, base, edited, {.history = &m_history, .live = m_live});
    if (!report)
        return tl::unexpected(report.error());
    result.snapshot = report->snapshotPath;
    if (report->error)
        return tl::unexpected(*report->error);
    list(base, edited, result);
    return {};
}

Error SetupGuide::takenBack(const Error &why)
{
    const Unbroken unbroken(m_channel);
    const auto now = m_device.readConfiguration(m_channel);
    if (now && makeTrialGood(m_channel, m_device, m_history, *now))
        return why;
    return {ErrorCode::NotRestored,
            u"%1; the old values are written back when the board is connected again"_s.arg(why.detail)};
}

Result<void> SetupGuide::requireMotors()
{
    const auto run = askMotors(m_channel, m_device);
    if (!run)
        return tl::unexpected(run.error());
    return *run ? Result<void>() : failure(ErrorCode::Unready, u"the motors are off"_s);
}

// An acknowledgement proves nothing: the board is asked afterwards.
Result<void> SetupGuide::switchOff()
{
    m_channel.stopMotors(m_device.stopPlan());
    const TimePoint began = m_channel.now();
    while (askMotors(m_channel, m_device) != false) {
        if (m_channel.now() - began > kNews)
            return failure(ErrorCode::NotProven, u"motors off"_s);
        if (const auto slept = m_channel.sleep(kMoment); !slept)
            return slept;
    }
    return {};
}

Result<SetupResult> SetupGuide::power(const QVariantMap &answers)
{
    const auto volts = average(m_roles.battery, 2);
    if (!volts)
        return tl::unexpected(volts.error());
    if (*volts < kUsbOnly)
        return failure(ErrorCode::ConditionUnmet,
                       u"%1 V: that is no battery, only USB feeds the board. Connect the battery"_s.arg(
                           *volts, 0, 'f', 1));
    int cells = answers.value(u"cells"_s).toInt();
    if (cells == 0) {
        QStringList possible;
        for (int count = 1; count <= kMostCells; ++count) {
            if (*volts / count <= kFullCell && *volts / count >= kUsableCell) {
                possible.append(QString::number(count));
                cells = count;
            }
        }
        if (possible.size() != 1)
            return failure(
                ErrorCode::ConditionUnmet,
                possible.isEmpty()
                    ? u"%1 V fits no number of cells: charge the battery, or say how many it has"_s.arg(
                        *volts, 0, 'f', 1)
                    : u"%1 V fits %2 cells: say how many it has"_s.arg(*volts, 0, 'f', 1)
                          .arg(possible.join(u" or "_s)));
    }
    const CellLimits &limits = kCellLimits[std::size_t(answers.value(u"chemistry"_s).toInt())];
    if (*volts / cells > kFullCell || *volts / cells < limits.alarm)
        return failure(ErrorCode::ConditionUnmet,
                       u"%1 V at %2 cells is %3 V for each: charge the battery, or correct the number"_s
                           .arg(*volts, 0, 'f', 1)
                           .arg(cells)
                           .arg(*volts / cells, 0, 'f', 2));
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    SetupResult result;
    result.figures = {SetupFigure{u"voltage"_s, *volts}, SetupFigure{u"cells"_s, double(cells)},
                      SetupFigure{u"percell"_s, *volts / cells}};
    Configuration edited = *base;
    const int profile = base->activeProfile();
    for (const auto &[key, each, figure] : {std::tuple(m_keys.batteryAlarm, limits.alarm, u"alarm"_s),
                                            std::tuple(m_keys.batteryOff, limits.off, u"off"_s)}) {
        const ParameterSpec *spec = find(key);
        const auto before = spec ? base->raw(*spec, profile) : std::nullopt;
        if (!before)
            return failure(ErrorCode::Unsupported, key);
        const double raw = spec->clamped(spec->toRaw(each * cells));
        if (const auto set = edited.setRaw(*spec, profile, raw); !set)
            return tl::unexpected(set.error());
        const double was = spec->toDisplay(*before);  // negative: it was switched off
        result.figures.append({figure, spec->toDisplay(raw), was > 0 ? std::optional(was) : std::nullopt});
    }
    if (base->changesTo(edited).empty()) {
        result.remarks = QStringList{u"power.fits"_s};
        return result;
    }
    if (const auto written = write(*base, edited, result); !written)
        return tl::unexpected(written.error());
    result.remarks = QStringList{u"power.set"_s};
    return result;
}

Result<SetupResult> SetupGuide::calibrate(const QString &action, const QString &part, const QString &figure,
                                          double good, double usable, bool areMotorsKnown)
{
    const bool letsGo = !areMotorsKnown && askMotors(m_channel, m_device).value_or(true);
    if (const auto off = letsGo ? switchOff() : Result<void>(); !off)
        return tl::unexpected(off.error());
    const auto actions = m_device.actions();
    const auto spec = std::find_if(actions.begin(), actions.end(), [&action](const ActionSpec &each) {
        return action == QLatin1String(each.key);
    });
    const auto arguments = parseArguments(*spec, {});
    if (!arguments)
        return tl::unexpected(arguments.error());
    const auto done = performSafely(m_channel, m_device, action, *arguments, m_history, m_live, &m_telemetry);
    if (!done)
        return tl::unexpected(done.error());
    SetupResult result;
    result.snapshot = done->snapshotPath;
    const double after = done->reply.value(part + u".after"_s).toDouble();
    result.figures.append({figure, after, done->reply.value(part + u".before"_s).toDouble()});
    result.remarks.append(after <= good         ? u"calibrated.good"_s
                              : after <= usable ? u"calibrated.usable"_s
                                                : u"calibrated.poor"_s);
    if (after > usable)
        result.state = SetupResult::State::Poor;
    if (letsGo)
        result.remarks.append(u"motors.off"_s);
    return result;
}

Result<SetupResult> SetupGuide::balance()
{
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.angle})); !news)
        return tl::unexpected(news.error());
    // Held level and still by hand, for a second.
    std::optional<TimePoint> level;
    const TimePoint began = m_channel.now();
    while (!level || ::seconds(m_channel.now() - *level) < kHeldSeconds) {
        const double gone = ::seconds(m_channel.now() - began);
        if (gone > kHoldPatience)
            return failure(ErrorCode::ConditionUnmet,
                           u"the camera was not held level for a minute: hold it level, then begin again"_s);
        const bool isLevel = std::abs(latest(m_roles.angle[0])) < kHeldLevel
            && std::abs(latest(m_roles.angle[1])) < kHeldLevel;
        if (!isLevel)
            level.reset();
        else if (!level)
            level = m_channel.now();
        tell(u"setup-hold"_s, gone / kHoldPatience);
        if (const auto passed = letPass(); !passed)
            return tl::unexpected(passed.error());
    }
    const Figures start{latest(m_roles.angle[0]), latest(m_roles.angle[1]), 0};
    Figures swing{};
    std::array<std::pair<double, double>, 2> turns{};  // least and most, deg/s
    for (std::size_t axis = 0; axis < turns.size(); ++axis)
        turns[axis] = {latest(m_roles.gyro[axis]), latest(m_roles.gyro[axis])};
    const auto look = [&]() -> Result<void> {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double now = std::remainder(latest(m_roles.angle[axis]) - start[axis], 360.0);
            if (std::abs(now) > std::abs(swing[axis]))
                swing[axis] = now;
            const double turn = latest(m_roles.gyro[axis]);
            turns[axis] = {std::min(turns[axis].first, turn), std::max(turns[axis].second, turn)};
        }
        return {};
    };
    const auto watched = watch(kLetGoSeconds + kSwingSeconds, look, u"setup-let-go"_s);
    if (!watched)
        return tl::unexpected(watched.error());
    const bool isStirred = std::any_of(turns.begin(), turns.end(),
                                       [](const auto &turn) { return turn.second - turn.first > kStirred; });
    if (!isStirred)
        return failure(ErrorCode::ConditionUnmet,
                       u"the camera did not move at all, so it was not let go: let go, and tip it lightly"_s);
    SetupResult result;
    bool isBalanced = true;
    for (const Axis axis : {Axis::Roll, Axis::Pitch}) {
        result.figures.append({setupFigureKey("drift", axis), swing[std::size_t(axis)]});
        isBalanced = isBalanced && std::abs(swing[std::size_t(axis)]) < kBalanced;
    }
    result.remarks = QStringList{isBalanced ? u"balance.good"_s : u"balance.bad"_s};
    result.state = isBalanced ? SetupResult::State::Done : SetupResult::State::Poor;
    return result;
}
