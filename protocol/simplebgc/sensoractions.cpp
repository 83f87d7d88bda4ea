// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations that a board makes by itself: of its motors and their encoders, of the flight controller's
// signal and of the magnetometer (errata 3.19). Its confirmations tell little, so what it holds is compared.
#include "protocol/analysis/fieldsphere.h"
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

constexpr auto kMotorCalibration = 60s;  // errata 7: poles take tens of seconds
constexpr auto kReceptionHeard = 2s;  // a confirmation that early is that of reception
constexpr auto kEndOnItsWay = 1s;  // after the board has said that it calibrates no longer
constexpr auto kLongestRun = 3min;
constexpr auto kListens = 200ms;
constexpr auto kModeAnswer = 300ms;
// Of REALTIME_DATA_4 (errata 3.8).
constexpr std::size_t kMotorAngleOffset = 63;
constexpr std::size_t kMagOffset = 78;
constexpr std::size_t kHeadingErrorOffset = 87;
constexpr qsizetype kModeOffset = 94;
constexpr qsizetype kStateOffset = 102;
constexpr int kModesSince = 2730;  // firmware that tells its modes there
constexpr int kSingleMotorSince = 2687;
constexpr int kTurnSince = 2626;  // firmware that takes angles for the fields of encoders
constexpr int kTurnSpeedSince = 2711;
constexpr double kUsualTurn = 40;  // degrees
constexpr double kUsualSpeed = 6;  // degrees per second
constexpr double kFarFromZero = 10;  // degrees; a hand sways less
constexpr double kSameAngle = 0.1;  // of it
constexpr int kMagMode = 12;
constexpr int kHeadingSamples = 10;
constexpr auto kBetweenMagSamples = 100ms;
constexpr auto kMagSettles = 3s;
constexpr std::size_t kEnoughDirections = 18;  // of kFieldDirections
constexpr double kWrongHeading = 5;  // degrees

// Whoever leaves, the board does not notice.
Error brokenOff(Error error)
{
    if (error.code == ErrorCode::Cancelled || isLinkLoss(error))
        addDetail(error.detail, u"it had begun on the board"_s);
    return error;
}

}  // namespace

Result<Actions::Values> Actions::parametersOf(int profile, Block block, const std::vector<const char *> &keys)
{
    const auto bytes = m_device.readBlock(m_channel, {profile, block});
    if (!bytes)
        return tl::unexpected(bytes.error());
    Values values;
    for (const char *key : keys) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const ParameterSpec *spec
                = m_device.m_parameters->find(QString::fromLatin1(key).arg(axisName(axis)));
            if (const auto raw = spec ? spec->read(*bytes) : std::nullopt)
                values.insert(spec->key, spec->toDisplay(*raw));
        }
    }
    return values;
}

Result<Frame> Actions::fullStatus()
{
    Request request = replyRequest(CommandId::RealtimeData4, {}, CommandId::RealtimeData4, kRealtime4Size,
                                   Device::kVersion);
    request.timeout = kModeAnswer;
    request.retries = 0;
    return m_channel.transact(request);
}

// A board that is busy may not answer: that says nothing.
Result<std::optional<bool>> Actions::isCalibrating(int mode)
{
    if (mode == 0 || m_device.m_identity.firmwareNumber < kLater)
        return std::optional<bool>();
    const auto status = fullStatus();
    if (!status && status.error().code != ErrorCode::Timeout)
        return tl::unexpected(status.error());
    if (!status || status->payload.size() <= kModeOffset)
        return std::optional<bool>();
    return std::optional<bool>(quint8(status->payload[kModeOffset]) == mode);
}

Result<std::array<double, kAxisCount>> Actions::motorAngles()
{
    const auto status = m_channel.transact(replyRequest(
        CommandId::RealtimeData4, {}, CommandId::RealtimeData4, kRealtime4Size, Device::kVersion));
    if (!status)
        return tl::unexpected(status.error());
    ByteReader reader(status->payload);
    reader.skip(kMotorAngleOffset);
    std::array<double, kAxisCount> angles{};
    for (double &angle : angles)
        angle = reader.i16() * kDegreesPerCount;
    return angles;
}

// Until it is confirmed for the second time, or the board, where it tells, is seen to calibrate no longer.
Result<Actions::Watched> Actions::watchCalibration(const SelfCalibration &calibration,
                                                   const Watcher &meanwhile)
{
    const CommandId id = calibration.id;
    const auto heard = m_channel.listen(
        [id](const FrameView &frame) { return isConfirmOf(frame, id) || refusalOf(frame, number(id)); });
    m_channel.expectSilence(kMotorCalibration);
    const TimePoint started = m_channel.now();
    if (const auto sent = m_channel.transact(silentRequest(id, calibration.payload, Device::kVersion)); !sent)
        return tl::unexpected(sent.error());
    Watched run;
    int confirmations = 0;
    std::optional<TimePoint> ended;
    for (;;) {
        const Duration since = m_channel.now() - started;
        const Duration limit = run.hasRun ? Duration(kLongestRun)
            : confirmations > 0           ? calibration.length
                                          : Duration(kMotorCalibration);
        if (since > limit || (ended && m_channel.now() - *ended > kEndOnItsWay))
            break;
        const auto frame = heard->next(kListens);
        if (!frame && frame.error().code != ErrorCode::Timeout)
            return tl::unexpected(brokenOff(frame.error()));
        if (frame) {
            run.refusal = refusalOf({frame->id, asBytes(frame->payload), frame->version, {}}, number(id));
            confirmations += !run.refusal;
            run.isConfirmed = m_channel.now() - started > kReceptionHeard || (ended && confirmations > 1);
            if (run.refusal || run.isConfirmed)
                break;
            continue;
        }
        const auto calibrates = isCalibrating(calibration.mode);
        if (!calibrates)
            return tl::unexpected(brokenOff(calibrates.error()));
        run.hasRun |= *calibrates == true;
        if (*calibrates == true)
            ended.reset();
        else if (run.hasRun && *calibrates == false && !ended)
            ended = m_channel.now();
        if (const auto seen = meanwhile(since); !seen)
            return tl::unexpected(brokenOff(seen.error()));
    }
    run.hasBegun = confirmations > 0 || run.hasRun;
    run.isConfirmed |= ended && confirmations > 1;
    run.isOver = run.isConfirmed || ended.has_value();
    if (!run.hasBegun && !run.refusal)
        return failure(ErrorCode::Timeout, commandName(number(id)));
    return run;
}

// In words, as far as the errata know them; numbers otherwise.
Result<ActionReply> Actions::readState(const QVariantMap &)
{
    const auto status = m_channel.transact(replyRequest(
        CommandId::RealtimeData4, {}, CommandId::RealtimeData4, kRealtime4Size, Device::kVersion));
    if (!status)
        return tl::unexpected(status.error());
    ByteReader reader(status->payload);
    reader.skip(std::size_t(kModeOffset));
    const int mode = reader.u8();
    const auto known = std::find_if(std::begin(kCalibModes), std::end(kCalibModes),
                                    [mode](const Choice &choice) { return choice.value == mode; });
    ActionReply reply{{u"calibration"_s,
                       known == std::end(kCalibModes) ? QString::number(mode) : QLatin1String(known->name)}};
    if (m_device.m_identity.firmwareNumber < kModesSince)
        return reply;
    reader.skip(std::size_t(kStateOffset - kModeOffset - 1));
    const quint32 bits = reader.u32();
    QStringList modes;
    for (int bit = 0; bit < 32; ++bit) {
        if (!(bits >> bit & 1))
            continue;
        const auto flag = std::find_if(std::begin(kStateFlags), std::end(kStateFlags),
                                       [bit](const Choice &choice) { return choice.value == bit; });
        modes.append(flag == std::end(kStateFlags) ? u"bit %1"_s.arg(bit) : QLatin1String(flag->name));
    }
    reply.insert(u"modes"_s, modes.isEmpty() ? u"none"_s : modes.join(u", "_s));
    return reply;
}

Result<Actions::SelfCalibrated> Actions::calibrateByItself(const SelfCalibration &calibration)
{
    if (const auto sees = needSensor(); !sees)
        return tl::unexpected(sees.error());
    const auto active = m_device.activeProfile(m_channel);
    if (!active)
        return tl::unexpected(active.error());
    const auto before = parametersOf(*active, calibration.block, calibration.keys);
    if (!before)
        return tl::unexpected(before.error());
    Progress progress;
    progress.step = QLatin1String(calibration.step);
    progress.subject = commandName(number(calibration.id));
    progress.total = 100;
    auto run = watchCalibration(calibration, [&](Duration since) -> Result<void> {
        progress.done = std::min(95, int(seconds(since) / seconds(calibration.length) * 95));
        m_channel.progress(progress);
        return {};
    });
    if (!run)
        return tl::unexpected(run.error());
    if (run->refusal && !run->hasBegun)
        return tl::unexpected(*run->refusal);
    const auto after = parametersOf(*active, calibration.block, calibration.keys);
    if (run->refusal) {
        addDetail(run->refusal->detail,
                  !after                  ? u"it had begun; what is stored now could not be read"_s
                      : *after == *before ? u"it had begun; what is stored is as before"_s
                                          : u"it had begun, and what is stored has changed"_s);
        return tl::unexpected(*run->refusal);
    }
    if (!after)
        return tl::unexpected(after.error());
    SelfCalibrated done;
    for (auto it = after->begin(); it != after->end(); ++it) {
        done.reply.insert(it.key(), it.value());
        if (it.value() != before->value(it.key()))
            done.reply.insert(it.key() + u".before"_s, before->value(it.key()));
    }
    done.reply.insert(u"confirmed"_s, run->isConfirmed);
    done.isProven = run->isConfirmed ? run->hasRun || *after != *before : *after != *before;
    return done;
}

Result<ActionReply> Actions::calibrateProven(const SelfCalibration &calibration)
{
    const auto done = calibrateByItself(calibration);
    if (!done)
        return tl::unexpected(done.error());
    if (!done->isProven) {
        return failure(ErrorCode::NoEffect,
                       (done->reply.value(u"confirmed"_s).toBool()
                            ? u"%1: nothing has changed, and the board was not seen to calibrate"_s
                            : u"%1: nothing has changed, and the end was not confirmed"_s)
                           .arg(commandName(number(calibration.id))));
    }
    return done->reply;
}

Result<ActionReply> Actions::calibratePoles(const QVariantMap &)
{
    return calibrateByItself({CommandId::CalibPoles, 3, Params3, {"motor.%1.poles", "motor.%1.invert"}})
        .map([](const SelfCalibrated &done) { return done.reply; });
}

Result<ActionReply> Actions::calibrateMagLink(const QVariantMap &)
{
    return calibrateByItself({CommandId::CalibMotorMagLink, 15, ParamsExt2, {"motor.%1.magnetic_link"}})
        .map([](const SelfCalibrated &done) { return done.reply; });
}

// How far and how fast can be said to later firmware only (errata 3.19).
Result<ActionReply> Actions::calibrateEncoderFields(const QVariantMap &arguments)
{
    const int firmware = m_device.m_identity.firmwareNumber;
    const double angle = arguments.value(u"angle"_s, kUsualTurn).toDouble();
    const double speed = arguments.value(u"speed"_s, kUsualSpeed).toDouble();
    if ((angle != kUsualTurn && firmware < kTurnSince)
        || (speed != kUsualSpeed && firmware < kTurnSpeedSince))
        return failure(ErrorCode::InvalidArgument,
                       u"this firmware turns the motors by %1 at a speed of its own"_s.arg(
                           firmware < kTurnSince ? u"an angle and"_s : u"this angle"_s));
    ByteWriter writer;
    for (std::size_t i = 0; i < kAxisCount && firmware >= kTurnSince; ++i)
        writer.i16(int(std::lround(angle / kDegreesPerCount)));
    for (std::size_t i = 0; i < kAxisCount && firmware >= kTurnSpeedSince; ++i)
        writer.i16(int(std::lround(speed / kGyroUnit)));
    SelfCalibration calibration{CommandId::EncodersCalibFldOffset, 7, ParamsExt, {"encoder.%1.field_offset"}};
    calibration.payload = writer.take();
    calibration.length += durationFromSeconds(2 * angle / speed);
    return calibrateProven(calibration);
}

// Where the camera stands is zero afterwards: that is seen in the angles of the motors.
Result<ActionReply> Actions::calibrateEncoderOffsets(const QVariantMap &arguments)
{
    const int motor = arguments.value(u"motor"_s, kAllMotors).toInt();
    const bool isSingle = m_device.m_identity.firmwareNumber >= kSingleMotorSince;
    if (motor != kAllMotors && !isSingle)
        return failure(ErrorCode::InvalidArgument,
                       u"this firmware takes the position of all motors at once"_s);
    const auto before = motorAngles();
    if (!before)
        return tl::unexpected(before.error());
    SelfCalibration calibration{CommandId::EncodersCalibOffset, 6, ParamsExt, {"encoder.%1.offset"}};
    calibration.payload = isSingle ? ByteWriter().u8(motor).take() : QByteArray();
    calibration.step = "calibrate-encoders";
    auto reply = calibrateProven(calibration);
    if (!reply)
        return reply;
    const auto after = motorAngles();
    if (!after)
        return tl::unexpected(after.error());
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const double was = (*before)[i];
        const double is = (*after)[i];
        reply->insert(u"motor."_s + axisName(i), is);
        reply->insert(u"motor."_s + axisName(i) + u".before"_s, was);
        const bool isMeant = motor == kAllMotors || motor == int(i);
        if (isMeant && std::abs(was) > kFarFromZero && std::abs(is - was) < kSameAngle * std::abs(was)
            && !reply->contains(u"encoder.%1.offset.before"_s.arg(axisName(i)))) {
            return failure(ErrorCode::NoEffect,
                           u"the motor of %1 stands at %2°, as before"_s.arg(axisName(i)).arg(is, 0, 'f', 1));
        }
    }
    return reply;
}

Result<ActionReply> Actions::calibrateFcGain(const QVariantMap &)
{
    const auto active = m_device.activeProfile(m_channel);
    if (!active)
        return tl::unexpected(active.error());
    const auto sources = parametersOf(*active, Params3, {"fc.map.%1"});
    if (!sources)
        return tl::unexpected(sources.error());
    if (std::all_of(sources->begin(), sources->end(), [](double source) { return source == 0; }))
        return failure(
            ErrorCode::ConditionUnmet,
            u"fc.map.roll and fc.map.pitch name no input that carries a flight controller's signal"_s);
    SelfCalibration calibration{CommandId::CalibExtGain, 1, Params3, {"fc.gain.%1"}};
    calibration.step = "calibrate-frame";
    return calibrateProven(calibration);
}

Result<double> Actions::sampleMagnetometer(std::vector<Vector3> &samples)
{
    const auto status = fullStatus();
    if (!status)
        return tl::unexpected(status.error());
    ByteReader reader(status->payload);
    reader.skip(kMagOffset);
    Vector3 counts;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        counts[i] = reader.i16();
    reader.skip(kHeadingErrorOffset - kMagOffset - 6);
    const double error = reader.u8() * 0.1;
    if (!reader.ok())
        return failure(ErrorCode::BadReply, u"REALTIME_DATA_4"_s);
    samples.push_back(counts);
    return error;
}

// Errors: NoSamples where the same numbers come again and again, those of the link.
Result<double> Actions::headingError(std::vector<Vector3> &samples)
{
    double sum = 0;
    for (int i = 0; i < kHeadingSamples; ++i) {
        const auto error = sampleMagnetometer(samples);
        if (!error)
            return error;
        sum += *error;
        if (const auto slept = m_channel.sleep(kBetweenMagSamples); !slept)
            return tl::unexpected(slept.error());
    }
    if (std::all_of(samples.begin(), samples.end(),
                    [&](const Vector3 &sample) { return sample == samples.front(); }))
        return failure(ErrorCode::NoSamples,
                       u"the magnetometer repeats the same figures: they are not measured"_s);
    return sum / kHeadingSamples;
}

// What it finds is in no parameter. That the camera was turned is seen in the raw data, and whether it helped
// in the error of the heading.
Result<ActionReply> Actions::calibrateMagnetometer(const QVariantMap &)
{
    if (const auto sees = needSensor(); !sees)
        return tl::unexpected(sees.error());
    std::vector<Vector3> still;
    const auto before = headingError(still);
    if (!before)
        return tl::unexpected(before.error());
    SelfCalibration calibration;
    calibration.id = CommandId::CalibMag;
    calibration.mode = kMagMode;
    calibration.payload = encodeCalibration(0, 1);
    calibration.length = kLongestRun;
    Progress progress;
    progress.step = u"calibrate-magnetometer"_s;
    progress.subject = commandName(number(calibration.id));
    progress.total = int(kFieldDirections);
    std::vector<Vector3> turned;
    const auto seen = [&turned] {
        const auto sphere = fitFieldSphere(turned);
        return sphere ? directionsSeen(turned, *sphere).count() : 0;
    };
    auto run = watchCalibration(calibration, [&](Duration) -> Result<void> {
        const auto sample = sampleMagnetometer(turned);
        if (!sample && sample.error().code != ErrorCode::Timeout)
            return tl::unexpected(sample.error());
        progress.done = std::max(progress.done, int(seen()));  // the middle moves
        m_channel.progress(progress);
        return {};
    });
    if (!run)
        return tl::unexpected(run.error());
    if (run->refusal && run->hasBegun)
        addDetail(run->refusal->detail, u"%1 of 26 directions were seen"_s.arg(seen()));
    if (run->refusal)
        return tl::unexpected(*run->refusal);
    if (!run->isOver)
        return failure(ErrorCode::Timeout,
                       u"%1: the end was not confirmed"_s.arg(commandName(number(calibration.id))));
    const auto sphere = fitFieldSphere(turned);
    if (!sphere || seen() < kEnoughDirections)
        return failure(
            ErrorCode::ConditionUnmet,
            u"the magnetometer has seen %1 of 26 directions: turn the camera over while it is calibrated"_s
                .arg(seen()));
    // The board finds its heading again.
    if (const auto slept = m_channel.sleep(kMagSettles); !slept)
        return tl::unexpected(slept.error());
    const auto after = headingError(still);
    if (!after)
        return tl::unexpected(after.error());
    if (*before > kWrongHeading && *after > *before * (1 - kSameAngle))
        return failure(ErrorCode::NoEffect,
                       u"the heading is off by %1°, and was off by %2° before"_s.arg(*after, 0, 'f', 1)
                           .arg(*before, 0, 'f', 1));
    ActionReply reply{{u"confirmed"_s, run->isConfirmed},       {u"directions"_s, int(seen())},
                      {u"field"_s, std::round(sphere->radius)}, {u"roughness"_s, 100 * sphere->roughness},
                      {u"heading.error.before"_s, *before},     {u"heading.error.after"_s, *after}};
    for (std::size_t i = 0; i < kAxisCount; ++i)
        reply.insert(u"shift."_s + u"xyz"[i], std::round(sphere->centre[i]));
    if (const auto stretch = fieldStretch(turned))
        reply.insert(u"stretch"_s, *stretch);
    return reply;
}

}  // namespace simplebgc
