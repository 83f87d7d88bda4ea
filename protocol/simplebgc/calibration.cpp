// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations and the board's automatic tuning: actions that take long and report their progress.
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kCalibrationLimit = 20s;  // errata 7: gyro about 4 s, accelerometer a few seconds
constexpr auto kSimpleFormWait = 8s;  // the simple form may never confirm its end
constexpr auto kSettleAfterCalibration = 1500ms;
constexpr auto kAutoPidSilence = 15s;  // progress comes every 0.5-1 s
constexpr auto kAutoPidLimit = 10min;
constexpr int kStillnessSamples = 25;

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

    // Both confirmations are collected from before the command is sent (errata 7: at reception and at the
    // end).
    const auto confirmations = m_channel.listen([id](const FrameView &frame) { return isAbout(frame, id); });
    const auto accepted = m_channel.transact(confirmRequest(id, payload, Device::kVersion));
    if (!accepted && !(simple && accepted.error().code == ErrorCode::Timeout))
        return tl::unexpected(accepted.error());

    const TimePoint started = m_channel.now();
    const auto limit = simple ? kSimpleFormWait : kCalibrationLimit;
    bool finished = false;
    while (!finished && m_channel.now() - started < limit) {
        const auto end = checked(confirmations->next(200ms), id);
        if (end) {
            finished = true;
        } else if (end.error().code != ErrorCode::Timeout) {
            return tl::unexpected(end.error());
        }
        // It usually takes about four seconds; the bar stops at 95 % until the end is known.
        progress.done = std::min(95, int(seconds(m_channel.now() - started) / 4.5 * 90.0));
        m_channel.progress(progress);
    }
    if (!finished && !simple)
        return failure(ErrorCode::Timeout, u"%1: the end was not confirmed"_s.arg(commandName(number(id))));

    // The board takes control of the camera again; what counts is its attitude afterwards.
    if (const auto slept = m_channel.sleep(kSettleAfterCalibration); !slept)
        return tl::unexpected(slept.error());
    const auto after = measureStillness();
    if (!after)
        return tl::unexpected(after.error());
    ActionReply reply;
    reply.insert(u"confirmed"_s, finished);
    reply.insert(u"gyro.bias.before"_s, before->gyroBias);
    reply.insert(u"gyro.bias.after"_s, after->gyroBias);
    reply.insert(u"gyro.noise"_s, after->gyroNoise);
    reply.insert(u"acc.error.before"_s, before->accError);
    reply.insert(u"acc.error.after"_s, after->accError);
    return reply;
}

Result<Actions::Stillness> Actions::measureStillness()
{
    // Mean and spread of the calibrated sensors: what calibration is meant to improve.
    std::array<double, 3> sum{};
    std::array<double, 3> squares{};
    double gravity = 0;
    for (int sample = 0; sample < kStillnessSamples; ++sample) {
        const auto frame = m_channel.transact(replyRequest(
            CommandId::RealtimeData3, {}, CommandId::RealtimeData3, kRealtime3Size, Device::kVersion));
        if (!frame)
            return tl::unexpected(frame.error());
        std::array<double, 3> acc{};
        for (const WireField &field : realtimeFields()) {
            const double value = double(readField(field, asBytes(frame->payload)));
            if (field.channel >= GyroRoll && field.channel <= GyroYaw) {
                const auto axis = std::size_t(field.channel - GyroRoll);
                sum[axis] += value;
                squares[axis] += value * value;
            } else if (field.channel >= AccX && field.channel <= AccZ) {
                acc[std::size_t(field.channel - AccX)] = value;
            }
        }
        // Relative to the face that points up, so that all six positions count alike.
        const auto up = std::max_element(acc.begin(), acc.end(),
                                         [](double a, double b) { return std::abs(a) < std::abs(b); });
        *up -= std::copysign(1.0, *up);
        gravity += std::hypot(acc[0], acc[1], acc[2]);
    }
    Stillness stillness;
    double variance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double mean = sum[axis] / kStillnessSamples;
        stillness.gyroBias = std::max(stillness.gyroBias, std::abs(mean));
        variance = std::max(variance, squares[axis] / kStillnessSamples - mean * mean);
    }
    stillness.gyroNoise = std::sqrt(std::max(variance, 0.0));
    stillness.accError = gravity / kStillnessSamples;
    return stillness;
}

Result<ActionReply> Actions::calibrateBattery(const QVariantMap &arguments)
{
    const int centivolts = int(std::lround(arguments.value(u"voltage"_s).toDouble() * 100.0));
    return confirm(CommandId::CalibBat, ByteWriter().u16(centivolts).take());
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
    int profile = arguments.value(u"profile"_s).toInt() - 1;
    if (profile < 0) {
        const auto active = m_device.activeProfile(m_channel);
        if (!active)
            return tl::unexpected(active.error());
        profile = *active;
    }
    const auto payload = [profile, &arguments](int configFlags) {
        return ByteWriter()
            .u8(profile)
            .u8(configFlags)
            .u8(arguments.value(u"gain"_s).toInt())
            .zeros(16)
            .take();
    };
    const auto reports = m_channel.listen([](const FrameView &frame) {
        return frame.id == number(CommandId::AutoPid) || isAbout(frame, CommandId::AutoPid);
    });
    const auto accepted
        = m_channel.transact(confirmRequest(CommandId::AutoPid, payload(flags), Device::kVersion));
    if (!accepted)
        return tl::unexpected(accepted.error());

    AutoPidProgress last;
    Progress progress;
    progress.step = u"autotune"_s;
    const TimePoint started = m_channel.now();
    for (;;) {
        const auto report = checked(reports->next(kAutoPidSilence), CommandId::AutoPid);
        if (!report || m_channel.now() - started > kAutoPidLimit) {
            // However the wait ends, the board must not go on shaking the camera.
            m_channel.post(confirmRequest(CommandId::AutoPid, payload(0), Device::kVersion));
            return tl::unexpected(report ? Error{ErrorCode::Timeout, u"AUTO_PID"_s, 0} : report.error());
        }
        if (report->id != number(CommandId::AutoPid))
            break;
        const auto decoded = AutoPidProgress::decode(asBytes(report->payload));
        if (!decoded)
            continue;
        last = *decoded;
        progress.done = last.iteration;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            progress.values[u"p."_s + axisName(axis)] = last.p[axis];
            progress.values[u"i."_s + axisName(axis)] = last.i[axis] * 0.01;
            progress.values[u"d."_s + axisName(axis)] = last.d[axis];
            progress.values[u"lpf."_s + axisName(axis)] = last.lpf[axis];
            progress.values[u"error."_s + axisName(axis)] = double(last.trackingError[axis]);
        }
        m_channel.progress(progress);
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
    reply.insert(u"unstored"_s, !arguments.value(u"save"_s).toBool());
    return reply;
}

}  // namespace simplebgc
