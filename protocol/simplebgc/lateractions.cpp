// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What later firmware tells and does beside all that: calibration of its sensors, its variables, further live
// data, single servos, events, and gains searched axis by axis (errata 3.9, 3.15, 3.16 and 3.19 to 3.23).
#include "protocol/base/linkloss.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kReferenceReached = 0.03;  // g
constexpr double kStillEnough = 2.0;  // deg/s
constexpr double kLeastReference = 0.5;  // g in all
constexpr double kMostReference = 1.5;
constexpr int kMostVariables = 255;
constexpr int kKeptStatistics = 7;  // bytes: step signals, cause of the last emergency stop
constexpr int kCountedStatistics = 40;  // bytes that count something, with those
constexpr int kStatisticsSize = 192;
constexpr int kEventInterval = 20;
constexpr auto kSearchLasts = 3min;
constexpr auto kRipplePass = 30s;  // of each iteration: an assumption
constexpr std::array kPositionBits{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr std::array kPositions{"+X", "+Y", "+Z", "-X", "-Y", "-Z"};
constexpr Choice kToldEvents[] = {{1, "menu button"}, {2, "motors"}, {3, "emergency stop"},
                                  {4, "camera"},      {5, "script"}, {6, "retracted"}};

QString orNone(const QStringList &words)
{
    return words.isEmpty() ? u"none"_s : words.join(u", "_s);
}

QString rangeText(int low, int high)
{
    return u"%1 .. %2"_s.arg(low).arg(high);
}

}  // namespace

Result<Frame> Actions::ask(CommandId id, const QByteArray &question, int replySize)
{
    return m_channel.transact(replyRequest(id, question, id, replySize, Device::kVersion));
}

Result<ActionReply> Actions::readCalibration(const QVariantMap &arguments)
{
    const auto frame
        = ask(CommandId::CalibInfo, ByteWriter().u8(arguments.value(u"imu"_s).toInt()).zeros(11).take(), 33);
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    ActionReply reply{{u"progress"_s, reader.u8()}};
    reply.insert(u"sensor"_s, reader.u8() == 2 ? u"frame"_s : u"main"_s);
    for (const char *axis : {"x", "y", "z"})
        reply.insert(u"acc."_s + QLatin1String(axis), reader.i16() * kAccUnit);
    reply.insert(u"gyro"_s, reader.u16());
    reader.skip(1);
    const unsigned limits = reader.u8();
    QStringList done;
    for (std::size_t i = 0; i < kPositionBits.size(); ++i) {
        if (limits >> i & 1U)
            done.append(QLatin1String(kPositionBits[i]));
    }
    reply.insert(u"positions"_s, orNone(done));
    reply.insert(u"temperature"_s, int(reader.i8()));
    QStringList used;
    if (reader.u8() != 0)
        used.append(u"gyroscope"_s);
    const int gyroLow = reader.i8();
    const int gyroHigh = reader.i8();
    if (reader.u8() != 0)
        used.append(u"accelerometer"_s);
    QStringList warm;
    for (const char *position : kPositions) {
        if (const int times = reader.u8(); times > 0)
            warm.append(u"%1: %2"_s.arg(QLatin1String(position)).arg(times));
    }
    const int accLow = reader.i8();
    const int accHigh = reader.i8();
    const double heading = reader.u8() * 0.01;
    if (!reader.ok())
        return failure(ErrorCode::BadReply, u"CALIB_INFO"_s);
    reply.insert(u"compensated"_s, orNone(used));
    if (gyroLow != 0 || gyroHigh != 0)
        reply.insert(u"range.gyro"_s, rangeText(gyroLow, gyroHigh));
    if (accLow != 0 || accHigh != 0)
        reply.insert(u"range.acc"_s, rangeText(accLow, accHigh));
    if (!warm.isEmpty())
        reply.insert(u"warm_positions"_s, warm.join(u", "_s));
    reply.insert(u"heading_error"_s, heading);
    return reply;
}

// What the sensor shows afterwards is what counts.
Result<ActionReply> Actions::calibrateByReference(const QVariantMap &arguments)
{
    std::array<double, 3> reference{};
    ByteWriter writer;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        reference[i] = arguments.value(QChar(u'x' + int(i))).toDouble();
        writer.i16(toCount16(reference[i], kAccUnit));
    }
    const double size = std::hypot(reference[0], reference[1], reference[2]);
    if (size < kLeastReference || size > kMostReference)
        return failure(
            ErrorCode::InvalidArgument,
            u"a sensor at rest measures 1 g in all, and the reference has %1 g"_s.arg(size, 0, 'f', 2));
    const auto before = measureStillness();
    if (!before)
        return tl::unexpected(before.error());
    if (before->gyroNoise > kStillEnough)
        return failure(ErrorCode::ConditionUnmet, u"the sensor does not stand still"_s);
    SelfCalibration calibration{CommandId::CalibAccExtRef, 23, Params3, {}, writer.zeros(14).take()};
    const auto done = calibrateByItself(calibration);
    if (!done)
        return tl::unexpected(done.error());
    const auto after = measureStillness();
    if (!after)
        return tl::unexpected(after.error());
    ActionReply reply = done->reply;
    double off = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const QString name = u"acc."_s + QChar(u'x' + int(i));
        reply.insert(name, after->acc[i]);
        reply.insert(name + u".before"_s, before->acc[i]);
        off = std::max(off, std::abs(after->acc[i] - reference[i]));
    }
    if (off > kReferenceReached)
        return failure(ErrorCode::NoEffect,
                       u"the accelerometer is %1 g away from the reference"_s.arg(off, 0, 'f', 3));
    return reply;
}

// The board's own names, ranges and values, part by part.
Result<ActionReply> Actions::describeVariables(const QVariantMap &)
{
    ActionReply reply;
    int next = 0;
    for (int total = 1, known = 0; known < total && next <= kMostVariables;) {
        const auto frame = ask(CommandId::AdjVarsInfo, ByteWriter().u8(next).take(), kMaxPayload);
        if (!frame)
            return tl::unexpected(frame.error());
        ByteReader reader(frame->payload);
        total = reader.u8();
        const int before = known;
        while (reader.ok() && reader.remaining() > 0) {
            const int id = reader.u8();
            const QByteArray name = toByteArray(reader.take(reader.u8()));
            const int low = reader.i16();
            const int high = reader.i16();
            const int value = reader.i32();
            if (!reader.ok())
                break;
            const QString key = u"%1 %2"_s.arg(id).arg(QString::fromLatin1(name));
            reply.insert(key, value);
            reply.insert(key + u".range"_s, rangeText(low, high));
            next = id + 1;
            ++known;
        }
        if (!reader.ok() || known == before)
            return failure(ErrorCode::BadReply, u"ADJ_VARS_INFO"_s);
    }
    return reply;
}

Result<ActionReply> Actions::readRealVariables(const QList<int> &ids)
{
    ByteWriter writer;
    writer.u8(int(ids.size()));
    for (const int id : ids)
        writer.u8(id);
    const auto frame
        = m_channel.transact(replyRequest(CommandId::GetAdjVarsValF, writer.take(), CommandId::SetAdjVarsValF,
                                          1 + 5 * int(ids.size()), Device::kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    ActionReply reply;
    for (int left = reader.u8(); left > 0 && reader.ok(); --left) {
        const QString id = QString::number(reader.u8());
        reply.insert(id, double(reader.f32()));
    }
    return reader.ok() && reply.size() == ids.size() ? Result<ActionReply>(reply)
                                                     : failure(ErrorCode::BadReply, u"GET_ADJ_VARS_VAL_F"_s);
}

// What the step signals have counted to, and why it stopped the last time, stay.
Result<ActionReply> Actions::resetStatistics(const QVariantMap &arguments)
{
    const auto before = ask(CommandId::ReadStateVars, {}, kStatisticsSize);
    if (!before)
        return tl::unexpected(before.error());
    if (before->payload.size() != kStatisticsSize)
        return failure(ErrorCode::BadReply, u"READ_STATE_VARS"_s);
    QByteArray cleared = before->payload;
    cleared.replace(kKeptStatistics, kCountedStatistics - kKeptStatistics,
                    QByteArray(kCountedStatistics - kKeptStatistics, '\0'));
    if (const auto done = confirm(CommandId::WriteStateVars, cleared); !done)
        return done;
    auto reply = readStatistics(arguments);
    if (!reply)
        return reply;
    if (reply->value(u"starts"_s).toInt() != 0)
        return failure(ErrorCode::NoEffect,
                       u"the board still counts %1 starts"_s.arg(reply->value(u"starts"_s).toInt()));
    return reply;
}

Result<ActionReply> Actions::setSingleServo(const QVariantMap &arguments)
{
    const int servo = arguments.value(u"servo"_s).toInt();
    const auto sent = m_channel.transact(
        silentRequest(CommandId::ServoOutExt,
                      ByteWriter().u32(1U << unsigned(servo)).i16(arguments.value(u"pulse"_s).toInt()).take(),
                      Device::kVersion));
    return sent ? Result<ActionReply>(ActionReply{}) : tl::unexpected(sent.error());
}

Result<ActionReply> Actions::readFurtherData(const QVariantMap &)
{
    constexpr quint32 kAll
        = 1U << 31 | 0x57;  // with its flags; what the pins and inner figures are nobody tells
    const auto frame
        = ask(CommandId::RealtimeDataCustom2, ByteWriter().u32(kAll).zeros(6).take(), kMaxPayload);
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    reader.skip(2);
    const quint32 flags = reader.u32();
    ActionReply reply;
    const auto each = [&](int bit, const QString &name, double unit, bool isSigned = true) {
        for (std::size_t axis = 0; axis < kAxisCount && flags >> bit & 1U; ++axis)
            reply.insert(name + u'.' + axisName(axis),
                         (isSigned ? int(reader.i16()) : int(reader.u16())) * unit);
    };
    each(0, u"frame"_s, kDegreesPerCount);
    each(1, u"gyro.frame"_s, kGyroUnit);
    each(2, u"acc.frame"_s, kAccUnit);
    each(4, u"magnetometer"_s, 1);
    each(6, u"error"_s, 0.001, false);
    return reader.ok() && reader.remaining() == 0 ? Result<ActionReply>(reply)
                                                  : failure(ErrorCode::BadReply, u"REALTIME_DATA_CUSTOM2"_s);
}

Result<ActionReply> Actions::readReferences(const QVariantMap &)
{
    const auto frame = ask(CommandId::ExtImuDebugInfo, {}, 74);
    if (!frame)
        return tl::unexpected(frame.error());
    ActionReply reply;
    for (const FieldValue &value :
         decodeFields(*findMessage(number(CommandId::ExtImuDebugInfo))->fromBoard, asBytes(frame->payload))) {
        const bool isWord = value.bits && !value.bits->words.empty();
        reply.insert(value.name, isWord ? QVariant(value.text()) : QVariant(value.number));
    }
    return reply.isEmpty() ? failure(ErrorCode::BadReply, u"EXT_IMU_DEBUG_INFO"_s)
                           : Result<ActionReply>(reply);
}

// A stream of its own for each kind of event, which ends with it.
Result<ActionReply> Actions::followEvents(const QVariantMap &arguments)
{
    constexpr int kAllTypes = 7;
    const auto stream = [](int event, int interval) {
        DataStream wanted;
        wanted.command = number(CommandId::Event);
        wanted.intervalMs = interval;
        wanted.config = ByteWriter().u8(event).u8(kAllTypes).zeros(6).take();
        return wanted;
    };
    const auto heard
        = m_channel.listen([](const FrameView &frame) { return frame.id == number(CommandId::Event); });
    const auto end = [&] {
        const Unbroken unbroken(m_channel);
        Result<void> ended;
        for (const Choice &event : kToldEvents) {
            if (const auto done = m_device.setStream(m_channel, stream(event.value, 0)); !done)
                ended = done;
        }
        return ended;
    };
    for (const Choice &event : kToldEvents) {
        if (const auto begun = m_device.setStream(m_channel, stream(event.value, kEventInterval)); !begun) {
            std::ignore = end();
            return tl::unexpected(begun.error());
        }
    }
    const TimePoint begin = m_channel.now();
    const TimePoint until = begin + durationFromSeconds(arguments.value(u"seconds"_s).toDouble());
    ActionReply reply;
    Progress progress;
    progress.step = u"events"_s;
    progress.total = 100;
    std::optional<Error> failed;
    int count = 0;
    while (m_channel.now() < until && !failed) {
        progress.done = int(100 * seconds(m_channel.now() - begin) / seconds(until - begin));
        m_channel.progress(progress);
        const auto frame = heard->next(100ms);
        if (!frame && frame.error().code != ErrorCode::Timeout)
            failed = frame.error();
        if (!frame || frame->payload.size() < 2)
            continue;
        const int event = quint8(frame->payload[0]);
        const int type = quint8(frame->payload[1]);
        const auto name = std::find_if(std::begin(kToldEvents), std::end(kToldEvents),
                                       [event](const Choice &each) { return each.value == event; });
        const QString what
            = name == std::end(kToldEvents) ? QString::number(event) : QString::fromLatin1(name->name);
        const QString how = type == 1 ? u"off"_s
            : type == 2               ? u"on"_s
            : type == 4               ? u"held"_s
                                      : QString::number(type);
        reply.insert(u"event%1"_s.arg(++count, 3, 10, QChar(u'0')),
                     u"%1 s: %2 %3"_s.arg(seconds(m_channel.now() - begin), 0, 'f', 1).arg(what, how));
    }
    const auto ended = failed && isLinkLoss(*failed) ? Result<void>() : end();
    if (failed)
        return tl::unexpected(*failed);
    if (!ended)
        return tl::unexpected(ended.error());
    reply.insert(u"events"_s, count);
    return reply;
}

Request Actions::stopTuningByAxisRequest()
{
    constexpr int kStop = 5;
    return confirmRequest(CommandId::AutoPid2, ByteWriter().u8(kStop).zeros(10).take(), Device::kVersion);
}

// The rest of its settings stays as the board has it. It reports nothing on its way; what it found is in use
// afterwards.
Result<ActionReply> Actions::tuneByAxis(const QVariantMap &arguments)
{
    constexpr int kStart = 1;
    constexpr int kRead = 6;
    constexpr qsizetype kSize = 73;
    constexpr qsizetype kVersionAt = 11;
    constexpr qsizetype kAxisAt = 12;
    constexpr qsizetype kAxisSize = 13;
    constexpr qsizetype kFlagsAt = 51;
    constexpr int kFromCurrent = 1;
    constexpr int kSave = 16;
    const auto frame = ask(CommandId::AutoPid2, ByteWriter().u8(kRead).zeros(10).take(), kSize);
    if (!frame)
        return tl::unexpected(frame.error());
    QByteArray payload = frame->payload;
    if (payload.size() != kSize || payload[kVersionAt] != 1)
        return failure(ErrorCode::BadReply, u"AUTO_PID2"_s);
    payload.replace(0, kVersionAt, ByteWriter().u8(kStart).zeros(10).take());
    bool isAny = false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const bool isOn = arguments.value(axisName(axis)).toBool();
        isAny |= isOn;
        ByteWriter settings;
        settings.u8(int(isOn) | int(arguments.value(u"lpf"_s).toBool()) << 1
                    | arguments.value(u"notches"_s).toInt() << 2);
        settings.u8(arguments.value(u"gain"_s).toInt()).u16(arguments.value(u"stimulus"_s).toInt());
        payload.replace(kAxisAt + qsizetype(axis) * kAxisSize, 4, settings.take());
    }
    if (!isAny)
        return failure(ErrorCode::InvalidArgument, u"no axis to tune"_s);
    const int flags = (arguments.value(u"keep"_s).toBool() ? kFromCurrent : 0)
        | (arguments.value(u"save"_s).toBool() ? kSave : 0);
    payload.replace(kFlagsAt, 2, ByteWriter().u16(flags).take());
    const auto before = searchedValues();
    if (!before)
        return tl::unexpected(before.error());
    SelfCalibration calibration{CommandId::AutoPid2, 8, Params3, {"pid.%1.p", "pid.%1.i", "pid.%1.d"}};
    calibration.payload = payload;
    calibration.step = "tune-by-axis";
    calibration.length = kSearchLasts;
    auto done = calibrateProven(calibration);
    if (!done) {
        m_channel.post(stopTuningByAxisRequest());
        return tl::unexpected(afterSearch(done.error(), *before));
    }
    if (!(flags & kSave))
        done->insert(u"unstored"_s, true);
    return done;
}

// What it has learned is in no parameter: that it has run to its end is all that shows.
Result<ActionReply> Actions::calibrateRipple(const QVariantMap &arguments)
{
    constexpr int kDelete = 2;
    constexpr int kUsualSpeed = 0;
    const int action = arguments.value(u"action"_s).toInt();
    const int iterations = arguments.value(u"iterations"_s).toInt();
    int axes = 0;
    ByteWriter settings;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        axes |= arguments.value(axisName(axis)).toBool() ? 1 << axis : 0;
        settings.u16(arguments.value(u"angle"_s).toInt()).u8(arguments.value(u"smooth"_s).toInt());
        settings.u8(kUsualSpeed).u16(0).zeros(9);
    }
    if (axes == 0)
        return failure(ErrorCode::InvalidArgument, u"no axis is chosen"_s);
    const QByteArray payload
        = ByteWriter().u8(action).u8(axes).bytes(settings.take()).u8(iterations).zeros(9).take();
    if (action == kDelete)
        return confirm(CommandId::CalibCogging, payload);
    SelfCalibration calibration{CommandId::CalibCogging, 22, Params3, {}, payload};
    calibration.length = kRipplePass * iterations;
    return calibrateProven(calibration);
}

}  // namespace simplebgc
