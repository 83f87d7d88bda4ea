// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations and the board's automatic tuning: actions that take long and report their progress.
#include "protocol/analysis/accelerometer.h"
#include "protocol/base/linkloss.h"
#include "protocol/session/carryout.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kCalibrationLimit = 20s;  // errata 7: gyro about 4 s, accelerometer a few seconds
constexpr auto kSimpleFormWait = 8s;  // the simple form may never confirm its end
constexpr auto kSettleAfterCalibration = 1500ms;
// A measurement takes seconds; what is confirmed before is its start, heard again.
constexpr auto kShortestMeasurement = 1500ms;
constexpr auto kReportOnItsWay = 300ms;
constexpr auto kSearchWatched = 4s;  // each step of a search, about half a second, reports or changes gains
constexpr auto kBetweenLooks = 300ms;
constexpr int kBlindStops = 3;  // nobody hears whether one of them arrives
constexpr auto kVoltageTaken = 2s;
constexpr double kSameVoltage = 0.3;  // it falls and rises with what the motors take
constexpr std::size_t kVoltageOffset = 55;  // of REALTIME_DATA_3 (errata 3.8)
constexpr auto kAutoPidSilence = 15s;  // progress comes every 0.5-1 s
constexpr auto kAutoPidLimit = 10min;
constexpr int kStillnessSamples = 25;
constexpr double kClearBias = 1.0;  // deg/s
constexpr double kClearAccError = 0.03;  // g
constexpr double kUnchanged = 0.1;  // in a hand it would be another one
constexpr double kStillNoise = 2.0;  // deg/s, standard deviation of the shakiest axis
constexpr int kAutoPidSize = 19;
constexpr int kMeasuring = 1;  // kind of calibration: measures this position
constexpr int kTemperature = 3;

// Whether the board speaks of this command: it confirms it, or gives it up.
bool isAbout(const FrameView &frame, CommandId id)
{
    return isConfirmOf(frame, id) || refusalOf(frame, number(id));
}

Result<Frame> checked(const Result<Frame> &frame, CommandId id)
{
    const auto view = [](const Frame &f) { return FrameView{f.id, asBytes(f.payload), f.version, {}}; };
    if (const auto refusal = frame ? refusalOf(view(*frame), number(id)) : std::nullopt)
        return tl::unexpected(*refusal);
    return frame;
}

}  // namespace

Result<ActionReply> Actions::calibrateGyro(const QVariantMap &arguments)
{
    return calibrate(CommandId::CalibGyro, arguments);
}

Result<ActionReply> Actions::calibrateAcc(const QVariantMap &arguments)
{
    return calibrate(CommandId::CalibAcc, arguments);
}

Result<ActionReply> Actions::calibrate(CommandId id, const QVariantMap &arguments)
{
    const bool simple = arguments.value(u"form"_s).toInt() == 1;
    const QByteArray payload = simple
        ? QByteArray()
        : encodeCalibration(arguments.value(u"imu"_s).toInt(), arguments.value(u"action"_s, 1).toInt());
    Progress progress;
    progress.step = u"calibrate"_s;
    progress.subject = commandName(number(id));
    progress.total = 100;
    m_channel.progress(progress);
    const auto before = measureStillness();
    if (!before)
        return tl::unexpected(before.error());
    const bool byHand = arguments.value(u"six"_s).toBool();
    const bool measures = arguments.value(u"action"_s, 1).toInt() == kMeasuring;
    const int imu = arguments.value(u"imu"_s).toInt();
    if (measures && imu != 0 && before->imu != 0 && imu != before->imu) {
        return failure(ErrorCode::ConditionUnmet,
                       u"the board shows its other sensor, so nobody would see what the calibration does: "
                       "imu.select imu=%1 first"_s.arg(imu == 2 ? u"frame"_s : u"main"_s));
    }
    if (const auto still = measures ? checkStill(id, *before) : Result<void>(); !still)
        return tl::unexpected(still.error());
    if (const auto off = byHand ? stopMotors() : Result<void>(); !off)
        return tl::unexpected(off.error());
    if (measures && id == CommandId::CalibAcc && !byHand && before->motorsRun && !before->isUpright) {
        return failure(
            ErrorCode::ConditionUnmet,
            u"the sensor does not lie level and the motors are running; six=on switches them off"_s);
    }

    // Both confirmations are collected from before the command is sent (errata 7: at reception and at the
    // end).
    const auto confirmations = m_channel.listen([id](const FrameView &frame) { return isAbout(frame, id); });
    const TimePoint started = m_channel.now();
    m_channel.expectSilence(kBusyCalibrating);
    const auto accepted = m_channel.transact(confirmRequest(id, payload, Device::kVersion));
    // Perhaps only the answer was lost: nothing stops a calibration, so its end is awaited.
    if (!accepted && accepted.error().code != ErrorCode::Timeout)
        return tl::unexpected(accepted.error());

    const auto limit = simple || !accepted ? kSimpleFormWait : kCalibrationLimit;
    const int kind = arguments.value(u"action"_s, 1).toInt();
    const auto shortest
        = simple || kind == kMeasuring || kind == kTemperature ? kShortestMeasurement : milliseconds(0);
    bool finished = false;
    while (!finished && m_channel.now() - started < limit) {
        const auto end = checked(confirmations->next(200ms), id);
        if (end) {
            finished = m_channel.now() - started >= shortest;
        } else if (end.error().code != ErrorCode::Timeout) {
            return tl::unexpected(end.error());
        }
        // It usually takes about four seconds; the bar stops at 95 % until the end is known.
        progress.done = std::min(95, int(seconds(m_channel.now() - started) / 4.5 * 90.0));
        m_channel.progress(progress);
    }
    if (!finished && !simple) {
        // Motors that were off start by themselves only after a restart.
        const bool wereOff = byHand || !before->motorsRun;
        const bool isMeasurement = kind == kMeasuring || kind == kTemperature;  // others end with one
        if (wereOff && isMeasurement && m_device.areMotorsOn(m_channel) == true)
            return failure(
                ErrorCode::Restarted,
                u"%1: it was not confirmed, and motors that were off run now"_s.arg(commandName(number(id))));
        return failure(
            ErrorCode::Timeout,
            (accepted
                 ? u"%1: the end was not confirmed"_s
                 : u"%1: neither start nor end was confirmed; nobody can tell whether the board calibrated"_s)
                .arg(commandName(number(id))));
    }

    // The sensor is turned over next, so what the board does by itself at the end does not count.
    if (const auto off = byHand ? stopMotors() : Result<void>(); !off)
        return tl::unexpected(off.error());
    // Otherwise the board takes control of the camera again; what counts is its attitude afterwards.
    if (const auto slept = m_channel.sleep(kSettleAfterCalibration); !slept)
        return tl::unexpected(slept.error());
    const auto after = measureStillness();
    if (!after)
        return tl::unexpected(after.error());
    if (const auto shown = measures && !byHand ? checkBetter(id, *before, *after) : Result<void>(); !shown)
        return tl::unexpected(shown.error());
    ActionReply reply;
    reply.insert(u"confirmed"_s, finished);
    reply.insert(u"gyro.bias.before"_s, before->gyroBias);
    reply.insert(u"gyro.bias.after"_s, after->gyroBias);
    reply.insert(u"gyro.noise"_s, after->gyroNoise);
    reply.insert(u"acc.error.before"_s, before->accError);
    reply.insert(u"acc.error.after"_s, after->accError);
    if (byHand && before->motorsRun)
        reply.insert(u"motors_switched_off"_s, true);  // whoever holds the camera starts them again
    return reply;
}

Result<void> Actions::checkStill(CommandId id, const Stillness &stillness)
{
    if (stillness.gyroNoise > kStillNoise) {
        return failure(ErrorCode::ConditionUnmet,
                       u"the sensor moves (%1 °/s): let it lie still"_s.arg(stillness.gyroNoise, 0, 'f', 1));
    }
    if (id != CommandId::CalibAcc || isGravity(stillness.acc, 1.0))
        return {};
    return failure(
        ErrorCode::ConditionUnmet,
        u"the sensor measures %1 g instead of 1 g, which none at rest does: something moves it, it is "
        "defective, or an earlier calibration is wrong, which action=reset-all removes"_s.arg(
            std::hypot(stillness.acc[0], stillness.acc[1], stillness.acc[2]), 0, 'f', 2));
}

// Where the sensor was clearly off before and still is, whatever was confirmed.
Result<void> Actions::checkBetter(CommandId id, const Stillness &before, const Stillness &after)
{
    const bool isGyro = id == CommandId::CalibGyro;
    const double was = isGyro ? before.gyroBias : before.accError;
    const double is = isGyro ? after.gyroBias : after.accError;
    const bool isMeasured = after.gyroNoise < kStillNoise
        && (isGyro || (before.isUpright && after.isUpright && before.motorsRun == after.motorsRun));
    if (!isMeasured || was < (isGyro ? kClearBias : kClearAccError) || std::abs(is - was) > kUnchanged * was)
        return {};
    return failure(ErrorCode::NoEffect,
                   (isGyro ? u"the gyroscope shows %1 °/s at rest, and showed %2 °/s before"_s
                           : u"the accelerometer is off by %1 g, and was by %2 g before"_s)
                       .arg(is, 0, 'f', isGyro ? 2 : 3)
                       .arg(was, 0, 'f', isGyro ? 2 : 3));
}

Result<Actions::Stillness> Actions::measureStillness()
{
    // Mean and spread of the calibrated sensors: what calibration is meant to improve.
    std::array<double, 3> sum{};
    std::array<double, 3> squares{};
    double gravity = 0;
    double upright = 0;
    Stillness stillness;
    std::array<double, 6> first{};
    bool isFrozen = true;
    for (int sample = 0; sample < kStillnessSamples; ++sample) {
        const auto frame = m_channel.transact(m_device.statusRequest());
        if (!frame)
            return tl::unexpected(frame.error());
        if (isBlind(*frame))
            return failure(ErrorCode::ConditionUnmet, u"the board does not see its motion sensor"_s);
        std::array<double, 6> sensed{};
        stillness.motorsRun = Device::areMotorsRunning(*frame).value_or(true);
        std::array<double, 3> acc{};
        for (const WireField &field : realtimeFields()) {
            const double value = double(readField(field, asBytes(frame->payload)));
            if (field.channel >= GyroRoll && field.channel <= GyroYaw) {
                const auto axis = std::size_t(field.channel - GyroRoll);
                sensed[axis] = value;
                sum[axis] += value;
                squares[axis] += value * value;
            } else if (field.channel == CurrentImu) {
                stillness.imu = int(value);
            } else if (field.channel >= AccX && field.channel <= AccZ) {
                const auto axis = std::size_t(field.channel - AccX);
                sensed[3 + axis] = acc[axis] = value;
                stillness.acc[axis] += value / kStillnessSamples;
            }
        }
        if (sample == 0)
            first = sensed;
        isFrozen = isFrozen && sensed == first;
        // Relative to the face that points up, so that all six positions count alike.
        const auto up = std::max_element(acc.begin(), acc.end(),
                                         [](double a, double b) { return std::abs(a) < std::abs(b); });
        upright += up == &acc[2] && *up > 0 ? 1 : -1;
        *up -= std::copysign(1.0, *up);
        gravity += std::hypot(acc[0], acc[1], acc[2]);
    }
    // Sensors have noise: the same numbers again and again are none that were measured.
    if (isFrozen)
        return failure(ErrorCode::NoSamples, u"the board repeats the same figures: they are not measured"_s);
    double variance = 0;
    stillness.isUpright = upright > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double mean = sum[axis] / kStillnessSamples;
        stillness.gyroBias = std::max(stillness.gyroBias, std::abs(mean));
        variance = std::max(variance, squares[axis] / kStillnessSamples - mean * mean);
    }
    stillness.gyroNoise = std::sqrt(std::max(variance, 0.0));
    // Motors hold the camera as the gyroscope's drift lets them: that tilt is no error of this sensor.
    stillness.accError = stillness.motorsRun
        ? std::abs(std::hypot(stillness.acc[0], stillness.acc[1], stillness.acc[2]) - 1.0)
        : gravity / kStillnessSamples;
    return stillness;
}

Result<ActionReply> Actions::calibrateBattery(const QVariantMap &arguments)
{
    const int centivolts = int(std::lround(arguments.value(u"voltage"_s).toDouble() * 100.0));
    const auto confirmed = confirm(CommandId::CalibBat, ByteWriter().u16(centivolts).take());
    if (!confirmed)
        return confirmed;
    double measured = std::numeric_limits<double>::quiet_NaN();
    const auto isTaken
        = holdsWithin(m_channel, m_device.statusRequest(), kVoltageTaken, [&](const Frame &status) {
              ByteReader reader(status.payload);
              reader.skip(kVoltageOffset);
              measured = reader.u16() * 0.01;
              return reader.ok() && std::abs(measured - centivolts / 100.0) < kSameVoltage;
          });
    if (!isTaken)
        return tl::unexpected(isTaken.error());
    if (!*isTaken)
        return failure(ErrorCode::NoEffect, u"it measures %1 V"_s.arg(measured, 0, 'f', 2));
    return ActionReply{{u"voltage"_s, measured}};
}

Result<ActionReply> Actions::calibrateOffset(const QVariantMap &)
{
    Request request = confirmRequest(CommandId::CalibOffset, {}, Device::kVersion);
    request.timeout = 5000ms;
    const auto reply = m_channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Request Actions::stopSearchRequest()
{
    Request request
        = confirmRequest(CommandId::AutoPid, ByteWriter().zeros(kAutoPidSize).take(), Device::kVersion);
    request.idempotent = true;
    request.retries = 2;
    return request;
}

// Whatever was confirmed: a search that goes on reports, where it was asked to, and changes what is in use.
Result<bool> Actions::isSearching()
{
    const auto reports
        = m_channel.listen([](const FrameView &frame) { return frame.id == number(CommandId::AutoPid); });
    std::vector<AdjustableValue> first;
    for (const TimePoint until = m_channel.now() + kSearchWatched; m_channel.now() < until;) {
        const auto report = reports->next(kBetweenLooks);
        if (report)
            return true;
        if (report.error().code != ErrorCode::Timeout)
            return tl::unexpected(report.error());
        const auto values = searchedValues();
        if (!values)
            return tl::unexpected(values.error());
        if (first.empty())
            first = *values;
        if (*values != first)
            return true;
    }
    return false;
}

// Errors: GoesOn, those of the channel.
Result<ActionReply> Actions::stopAutoTune(const QVariantMap &)
{
    const auto confirmed = m_channel.transact(stopSearchRequest());
    if (!confirmed && confirmed.error().code != ErrorCode::Timeout)
        return tl::unexpected(confirmed.error());
    if (m_device.m_identity.firmwareNumber >= kTuneByAxisSince)
        m_channel.post(stopTuningByAxisRequest());
    if (const auto slept = m_channel.sleep(kReportOnItsWay); !slept)
        return tl::unexpected(slept.error());
    const auto searching = isSearching();
    if (!searching)
        return tl::unexpected(searching.error());
    if (*searching)
        return failure(ErrorCode::GoesOn, u"AUTO_PID: it searches on"_s);
    return ActionReply{};
}

// A search may be going on although its start was not confirmed, or nothing more was heard of it: it is
// stopped, and what that showed is told.
Error Actions::afterSearch(Error error)
{
    if (error.code != ErrorCode::Timeout) {
        for (int i = 0; i < kBlindStops; ++i)
            m_channel.post(stopSearchRequest());
        return error;
    }
    const auto stopped = stopAutoTune({});
    addDetail(
        error.detail,
        stopped
            ? u"the board was told to stop searching, and reports no search any more"_s
            : u"the board may be searching; it was told to stop, without proof (%1): switch the motors off"_s
                  .arg(stopped.error().detail));
    return error;
}

// Gains that nobody chose are no result.
Error Actions::afterSearch(const Error &error, const std::vector<AdjustableValue> &before)
{
    Error ended = afterSearch(error);
    if (isLinkLoss(error))
        return ended;
    if (error.code == ErrorCode::Cancelled) {
        for (const Request &request : Device::adjustableRequests(before))
            m_channel.post(request);
        return ended;
    }
    if (const auto back = m_device.putAdjustables(m_channel, before); !back)
        addDetail(ended.detail,
                  u"the gains from before could not be put back (%1)"_s.arg(back.error().detail));
    return ended;
}

Result<std::vector<AdjustableValue>> Actions::searchedValues()
{
    QList<int> ids;
    for (int axis = 0; axis < int(kAxisCount); ++axis) {
        for (const QString &key : {u"pid.%1.p"_s, u"pid.%1.i"_s, u"pid.%1.d"_s, u"filter.%1.lpf"_s}) {
            const ParameterSpec *spec = m_device.m_parameters->find(key.arg(axisName(axis)));
            if (spec && spec->adjustable >= 0)
                ids.append(spec->adjustable);
        }
    }
    return m_device.readAdjustables(m_channel, ids);
}

// "p.roll" and its like, as the progress of a search names them.
Result<QMap<QString, double>> Actions::gainsInUse(int profile, bool isActive)
{
    // What is stored may be told apart from what is in use.
    if (const auto live = isActive ? searchedValues() : failure(ErrorCode::Unsupported)) {
        QMap<QString, double> gains;
        for (const ParameterSpec &spec : m_device.m_parameters->all()) {
            const QStringList parts = spec.key.split(u'.');
            const auto value = std::find_if(live->begin(), live->end(), [&spec](const AdjustableValue &each) {
                return each.id == spec.adjustable;
            });
            if (value != live->end() && parts.size() == 3)
                gains.insert(parts[2] + u'.' + parts[1], spec.toDisplay(spec.rawOf(value->value)));
        }
        return gains;
    }
    const auto bytes = m_device.readBlock(m_channel, {profile, Params3});
    if (!bytes)
        return tl::unexpected(bytes.error());
    QMap<QString, double> gains;
    for (int axis = 0; axis < int(kAxisCount); ++axis) {
        for (const QString &gain : {u"p"_s, u"i"_s, u"d"_s}) {
            const ParameterSpec *spec = m_device.m_parameters->find(u"pid.%1.%2"_s.arg(axisName(axis), gain));
            const auto raw = spec ? spec->read(*bytes) : std::nullopt;
            if (raw)
                gains.insert(gain + u'.' + axisName(axis), spec->toDisplay(*raw));
        }
    }
    return gains;
}

Result<ActionReply> Actions::autoTune(const QVariantMap &arguments)
{
    int flags = AutoPidReport;
    for (int axis = 0; axis < 3; ++axis) {
        if (arguments.value(axisName(axis)).toBool())
            flags |= 1 << axis;
    }
    if (!(flags & 7))
        return failure(ErrorCode::InvalidArgument, u"no axis to tune"_s);
    if (arguments.value(u"keep"_s).toBool())
        flags |= AutoPidKeepCurrent;
    if (arguments.value(u"lpf"_s).toBool())
        flags |= AutoPidTuneLpf;
    const auto active = m_device.activeProfile(m_channel);
    if (!active)
        return tl::unexpected(active.error());
    const int wanted = arguments.value(u"profile"_s).toInt() - 1;
    const int profile = wanted < 0 ? *active : wanted;
    const QByteArray payload
        = ByteWriter().u8(profile).u8(flags).u8(arguments.value(u"gain"_s).toInt()).zeros(16).take();
    if (const auto sees = needSensor(); !sees)
        return tl::unexpected(sees.error());
    const auto before = gainsInUse(profile, profile == *active);
    if (!before)
        return tl::unexpected(before.error());
    // Of another profile they are not in use, and those of this one are no way back to it.
    const auto old = profile == *active ? searchedValues() : std::vector<AdjustableValue>();
    if (!old)
        return tl::unexpected(old.error());
    const auto reports = m_channel.listen([](const FrameView &frame) {
        return frame.id == number(CommandId::AutoPid) || isAbout(frame, CommandId::AutoPid);
    });
    const auto accepted = m_channel.transact(confirmRequest(CommandId::AutoPid, payload, Device::kVersion));
    if (!accepted)
        return tl::unexpected(afterSearch(accepted.error(), *old));

    AutoPidProgress last;
    Progress progress;
    progress.step = u"autotune"_s;
    const TimePoint started = m_channel.now();
    for (;;) {
        const auto report = checked(reports->next(kAutoPidSilence), CommandId::AutoPid);
        // However the wait ends, the board must not go on shaking the camera.
        if (!report || m_channel.now() - started > kAutoPidLimit) {
            return tl::unexpected(
                afterSearch(report ? Error{ErrorCode::Timeout, u"AUTO_PID"_s, 0} : report.error(), *old));
        }
        if (report->id != number(CommandId::AutoPid)) {
            // It may be the confirmation of the start, heard once more.
            const auto searching = isSearching();
            if (!searching)
                return tl::unexpected(afterSearch(searching.error(), *old));
            if (!*searching)
                break;
            continue;
        }
        const auto decoded = AutoPidProgress::decode(asBytes(report->payload));
        if (!decoded)
            continue;
        last = *decoded;
        progress.done = last.iteration;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const auto &[gain, raw] :
                 {std::pair(u"p"_s, last.p[axis]), {u"i"_s, last.i[axis]}, {u"d"_s, last.d[axis]}}) {
                const ParameterSpec *spec
                    = m_device.m_parameters->find(u"pid.%1.%2"_s.arg(axisName(axis), gain));
                progress.values[gain + u'.' + axisName(axis)] = spec ? spec->toDisplay(raw) : raw;
            }
            progress.values[u"lpf."_s + axisName(axis)] = last.lpf[axis];
            progress.values[u"error."_s + axisName(axis)] = double(last.trackingError[axis]);
        }
        m_channel.progress(progress);
    }
    // What it reported is what it tried; what it uses now is the result.
    const auto after = gainsInUse(profile, profile == *active);
    if (!after) {
        Error error = after.error();
        addDetail(error.detail, u"the search has ended; which gains are in use could not be read"_s);
        return tl::unexpected(error);
    }
    for (auto it = after->begin(); it != after->end(); ++it) {
        const bool isSought = flags & AutoPidTuneLpf || !it.key().startsWith(u"lpf."_s);
        const bool isFound
            = !isSought || !progress.values.contains(it.key()) || progress.values[it.key()] == it.value();
        if (!isFound && *before == *after) {
            return failure(
                ErrorCode::NoEffect,
                u"AUTO_PID: the board says that the search has ended, with %1=%2, and still uses %3"_s
                    .arg(it.key())
                    .arg(progress.values[it.key()])
                    .arg(it.value()));
        }
        progress.values[it.key()] = it.value();
    }
    if (arguments.value(u"save"_s).toBool()) {
        const auto saved = saveVariables({});
        if (!saved)
            return saved;
    }
    ActionReply reply;
    for (auto it = progress.values.begin(); it != progress.values.end(); ++it)
        reply.insert(it.key(), it.value());
    reply.insert(u"iterations"_s, last.iteration);
    reply.insert(u"profile"_s, profile + 1);
    // A board answers with what is in use: what it has stored shows at its next start.
    if (arguments.value(u"save"_s).toBool())
        reply.insert(u"stored"_s, u"confirmed"_s);
    else
        reply.insert(u"unstored"_s, true);
    return reply;
}

}  // namespace simplebgc
