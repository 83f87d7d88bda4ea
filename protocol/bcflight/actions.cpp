// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a drone can be told to do (errata 6 and 7).
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/tables.h"
#include "protocol/session/channel.h"

#include <QDateTime>

#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr auto kCalibrationLimit = 15s;  // errata 7.1
constexpr auto kStatusPause = 200ms;
constexpr auto kMotorTestDeaf = 8s;  // errata 7.7
constexpr auto kEscsDeaf = 26s;
constexpr auto kHearsAgain = 5s;
constexpr auto kOutputsCome = 1s;
constexpr auto kLeaves = 10s;  // fixed waits of about 4 s before it restarts (errata 7.3)
constexpr auto kComesBack = 20s;
constexpr std::uint32_t kAccepted = 3;
constexpr int kStopRounds = 5;
constexpr int kBandSize = 8;

constexpr std::array kPictureSteps{Message::BrightnessUp, Message::BrightnessDown, Message::ContrastUp,
                                   Message::ContrastDown, Message::SaturationUp,   Message::SaturationDown,
                                   Message::IsoUp,        Message::IsoDown};

std::uint32_t codeOf(const Frame &frame)
{
    const FieldSpec field{"code", FieldType::U32};
    const auto values = decodeFields({&field, 1}, asBytes(frame.payload));
    return values.empty() ? ~0U : std::uint32_t(values.front().number);
}

QString textIn(const Frame &frame)
{
    return QString::fromUtf8(frame.payload.left(frame.payload.indexOf('\0')));
}

void flatten(const QList<InfoNode> &nodes, const QString &path, ActionReply &reply)
{
    for (const InfoNode &node : nodes) {
        const QString here = path.isEmpty() ? node.name : path + u'.' + node.name;
        if (!node.value.isEmpty() || node.children.isEmpty())
            reply.insert(here, node.value);
        flatten(node.children, here, reply);
    }
}

// As short as the drone, which may compute in single precision at each step, makes the same gain of it.
double literalFor(float gain, double scale)
{
    const double exact = double(gain) / scale;
    for (int digits = 3; digits < 17; ++digits) {
        const double value = QByteArray::number(exact, 'g', digits).toDouble();
        if (float(value) * float(scale) == gain && float(double(float(value)) * scale) == gain
            && float(value * scale) == gain)
            return value;
    }
    return exact;
}

}  // namespace

Result<ActionReply> Device::perform(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    const auto is = [&key](const char *name) { return key == QLatin1String(name); };
    const auto send = [&](const Request &request) {
        return channel.transact(request).map([](const Frame &) { return ActionReply(); });
    };
    const bool on = arguments.value(u"on"_s).toBool();
    const auto number
        = [&arguments](const char *name) { return arguments.value(QLatin1String(name)).toInt(); };
    if (is("status"))
        return tellStatus(channel);
    if (is("motors.off"))
        return stopMotors(channel);
    if (is("board") || is("sensors") || is("cameras"))
        return tellInfo(channel,
                        is("board")         ? Message::GetBoardInfos
                            : is("sensors") ? Message::GetSensorsInfos
                                            : Message::GetCamerasInfos);
    if (m_generation < Generation::F)
        return failure(ErrorCode::Unsupported, u"only generations F and G are told to do anything"_s);
    if (is("calibrate.gyro") || is("calibrate.all"))
        return calibrate(channel, is("calibrate.all"));
    if (is("gains.store"))
        return storeGains(channel);
    if (is("motor.test"))
        return testMotor(channel, number("motor"));
    if (is("escs.calibrate"))
        return calibrateEscs(channel);
    if (is("mode") || is("motors.beep")) {
        if (const auto ready = checkDisarmed(channel); !ready)
            return tl::unexpected(ready.error());
    }
    if (is("mode"))
        return channel.transact(ask(Message::SetMode, bigU32(std::uint32_t(number("mode")))))
            .map([](const Frame &frame) {
                return ActionReply{{u"mode"_s, int(codeOf(frame))}};
            });
    if (is("motors.beep"))
        return send(order(Message::MotorsBeep, bigU16(on ? 1 : 0)));
    if (is("battery.reset"))
        return send(order(Message::ResetBattery, bigU32(0)));
    if (is("telemetry.full"))
        return send(order(Message::SetFullTelemetry, bigU32(on ? 1 : 0)));
    if (is("clock"))
        return send(ask(Message::SetTimestamp, bigU32(std::uint32_t(QDateTime::currentSecsSinceEpoch()))));
    if (is("vtx"))
        return transmitter(channel, ask(Message::VtxGetSettings));
    if (is("vtx.channel"))
        return transmitter(
            channel,
            ask(Message::VtxSetChannel, QByteArray(1, char(number("band") * kBandSize + number("channel")))));
    if (is("vtx.power"))
        return transmitter(channel, ask(Message::VtxSetPower, QByteArray(1, char(number("power") - 1))));
    if (is("camera"))
        return tellCamera(channel);
    if (is("camera.step"))
        return send(order(kPictureSteps[std::size_t(number("step"))]));
    if (is("camera.record"))
        return send(ask(on ? Message::VideoStartRecord : Message::VideoStopRecord));
    if (is("camera.white_balance") || is("camera.lock")) {
        // It switches with each command: a repeated one would switch once more.
        Request request = ask(is("camera.lock") ? Message::LockWhiteBalance : Message::WhiteBalance);
        request.idempotent = false;
        return channel.transact(request).map([](const Frame &frame) {
            return ActionReply{{u"white_balance"_s, textIn(frame)}};
        });
    }
    if (is("recordings"))
        return tellRecordings(channel);
    return failure(ErrorCode::Unsupported, key);
}

// What the stop plan sends, in a row with other steps: until the drone says that it is disarmed.
Result<ActionReply> Device::stopMotors(Channel &channel)
{
    const StopPlan plan = stopPlan();
    Result<Status> now = failure(ErrorCode::Timeout);
    for (int round = 0; round < kStopRounds; ++round) {
        for (const Request &request : plan.means.front().requests) {
            if (!request.answer)
                channel.post(request);
        }
        now = status(channel);
        if (now && !now->armed)
            return ActionReply();
        if (!now && now.error().code != ErrorCode::Timeout)
            break;
    }
    return now ? failure(ErrorCode::NotProven, u"the drone says that it is armed"_s)
               : tl::unexpected(now.error());
}

Result<ActionReply> Device::tellStatus(Channel &channel)
{
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    const auto reply = channel.transact(ask(Message::Telemetry));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto telemetry = Telemetry::decode(asBytes(reply->payload));
    if (!telemetry)
        return failure(ErrorCode::BadReply, u"TELEMETRY"_s);
    return ActionReply{{u"armed"_s, now->armed},
                       {u"calibrated"_s, now->calibrated},
                       {u"calibrating"_s, now->calibrating},
                       {u"battery.voltage"_s, telemetry->voltage},
                       {u"battery.charge"_s, telemetry->charge},
                       {u"battery.current"_s, telemetry->current},
                       {u"battery.level"_s, telemetry->level},
                       {u"cpu.load"_s, telemetry->cpuLoad},
                       {u"cpu.temperature"_s, telemetry->cpuTemperature},
                       {u"rx.quality"_s, telemetry->receiveQuality},
                       {u"rx.dbm"_s, telemetry->receiveLevel}};
}

// Where it cannot be read as a table it is told as it came.
Result<ActionReply> Device::tellInfo(Channel &channel, Message id)
{
    const auto reply = channel.transact(ask(id));
    if (!reply)
        return tl::unexpected(reply.error());
    const QString text = textIn(*reply);
    const auto nodes = readInfo(text.toUtf8());
    if (!nodes)
        return ActionReply{{u"text"_s, text}};
    ActionReply told;
    flatten(*nodes, {}, told);
    return told;
}

Result<ActionReply> Device::tellRecordings(Channel &channel)
{
    const auto reply = channel.transact(ask(Message::GetRecordingsList));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto text = decodeChecked(asBytes(reply->payload));
    if (!text)
        return tl::unexpected(text.error());
    int damaged = 0;
    ActionReply told;
    for (const RecordingEntry &entry : readRecordings(*text, damaged))
        told.insert(entry.name, entry.bytes);
    if (damaged > 0)
        told.insert(u"unreadable"_s, damaged);
    return told;
}

// Without a camera it says nothing to these (errata 6.5).
Result<ActionReply> Device::tellCamera(Channel &channel)
{
    const auto iso = channel.transact(ask(Message::Iso));
    if (!iso)
        return iso.error().code == ErrorCode::Timeout
            ? failure(ErrorCode::Unsupported, u"no camera answers"_s)
            : tl::unexpected(iso.error());
    ActionReply told{{u"iso"_s, int(codeOf(*iso))}};
    if (const auto shutter = channel.transact(ask(Message::ShutterSpeed)))
        told.insert(u"shutter"_s, codeOf(*shutter));
    return told;
}

// Errata 6.6: all ones where there is no transmitter.
Result<ActionReply> Device::transmitter(Channel &channel, const Request &request) const
{
    if (request.kind != int(Message::VtxGetSettings)) {
        const auto there = transmitter(channel, ask(Message::VtxGetSettings));
        if (!there)
            return there;
        if (const auto set = channel.transact(request); !set)
            return tl::unexpected(set.error());
        return transmitter(channel, ask(Message::VtxGetSettings));
    }
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    const auto values
        = decodeFields(*findMessage(Message::VtxGetSettings)->fromDrone, asBytes(reply->payload));
    if (values.size() < 5)
        return failure(ErrorCode::BadReply, request.name);
    const int channelNumber = int(values[0].number);
    if (channelNumber < 1 || channelNumber > 5 * kBandSize)
        return failure(ErrorCode::Unsupported, u"the drone has no video transmitter"_s);
    QStringList powers;
    for (const float dbm : values[4].numbers)
        powers.append(QString::number(int(dbm)));
    static const QStringList bands{u"Boscam A"_s, u"Boscam B"_s, u"Boscam E"_s, u"FatShark"_s, u"RaceBand"_s};
    return ActionReply{{u"band"_s, bands.at((channelNumber - 1) / kBandSize)},
                       {u"channel"_s, (channelNumber - 1) % kBandSize + 1},
                       {u"frequency"_s, int(values[1].number)},
                       {u"power"_s, int(values[2].number) + 1},
                       {u"power.dbm"_s, int(values[3].number)},
                       {u"powers"_s, powers.join(u' ')}};
}

// One answer, then its status tells (errata 7.1).
Result<ActionReply> Device::calibrate(Channel &channel, bool isFull)
{
    if (const auto ready = checkDisarmed(channel); !ready)
        return tl::unexpected(ready.error());
    Request request = ask(Message::Calibrate, bigU32(isFull ? 1 : 0) + bigF32(0));
    request.idempotent = false;
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    if (codeOf(*reply) != kAccepted)
        return tl::unexpected(
            Error{ErrorCode::BoardError, u"the drone refuses to calibrate"_s, int(codeOf(*reply))});
    Progress progress;
    progress.step = u"calibrate-drone"_s;
    channel.progress(progress);
    bool wasSeen = false;
    for (const TimePoint limit = channel.now() + kCalibrationLimit; channel.now() < limit;) {
        const auto now = status(channel);
        if (!now)
            return tl::unexpected(now.error());
        wasSeen |= now->calibrating || !now->calibrated;
        if (wasSeen && now->calibrated && !now->calibrating)
            return ActionReply{{u"calibrated"_s, true}};
        if (const auto slept = channel.sleep(kStatusPause); !slept)
            return tl::unexpected(slept.error());
    }
    return failure(ErrorCode::NotSeen,
                   wasSeen ? u"the drone does not say that it is calibrated"_s
                           : u"the drone did not begin to calibrate"_s);
}

Result<ActionReply> Device::waitDeaf(Channel &channel, const Request &request, milliseconds deaf,
                                     const QString &step)
{
    channel.keepQuiet(deaf);
    channel.expectSilence(deaf + kHearsAgain);
    channel.post(request);
    Progress progress;
    progress.step = step;
    progress.total = 100;
    const TimePoint begin = channel.now();
    while (channel.now() < begin + deaf) {
        progress.done = int(100.0 * (seconds(channel.now() - begin) / seconds(deaf)));
        channel.progress(progress);
        if (const auto slept = channel.sleep(kStatusPause); !slept)
            return tl::unexpected(slept.error());
    }
    for (const TimePoint limit = channel.now() + kHearsAgain; channel.now() < limit;) {
        const auto now = status(channel);
        if (now)
            return ActionReply{{u"armed"_s, now->armed}};
        if (now.error().code != ErrorCode::Timeout)
            return tl::unexpected(now.error());
    }
    return failure(ErrorCode::NotSeen,
                   u"the drone does not answer any more; only switching it off and on helps"_s);
}

// Errata 7.7: an index that it has not ends its program, and a test before a calibration hangs it.
Result<ActionReply> Device::testMotor(Channel &channel, int motor)
{
    const auto outputs
        = channel.listen([](const FrameView &frame) { return frame.id == int(Message::MotorsSpeed); });
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    if (now->armed || now->calibrating || !now->calibrated)
        return failure(ErrorCode::ConditionUnmet,
                       now->armed ? u"the drone is armed"_s : u"the drone is not calibrated"_s);
    const auto told = outputs->next(kOutputsCome);
    if (!told && told.error().code != ErrorCode::Timeout)
        return tl::unexpected(told.error());
    if (!told)
        return failure(ErrorCode::ConditionUnmet,
                       u"the drone does not stream its outputs, so nobody knows how many motors it has; "
                       "switch full telemetry on"_s);
    const auto fields = decodeFields(*findMessage(Message::MotorsSpeed)->fromDrone, asBytes(told->payload));
    const int count = fields.empty() ? 0 : int(fields.front().numbers.size());
    if (motor < 1 || motor > count)
        return failure(ErrorCode::InvalidArgument, u"the drone has %1 motors"_s.arg(count));
    return waitDeaf(channel, order(Message::MotorTest, bigU32(std::uint32_t(motor - 1))), kMotorTestDeaf,
                    u"motor-test"_s);
}

Result<ActionReply> Device::calibrateEscs(Channel &channel)
{
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    if (now->armed || now->calibrating)
        return failure(ErrorCode::ConditionUnmet,
                       now->armed ? u"the drone is armed"_s : u"the drone is calibrating"_s);
    return waitDeaf(channel, order(Message::CalibrateEscs), kEscsDeaf, u"escs"_s);
}

// What is in use is forgotten at the next start, so it is written into the text that the drone reads then:
// one number for each gain that differs, everything else byte for byte (errata 7.2).
Result<ActionReply> Device::storeGains(Channel &channel)
{
    if (const auto ready = checkDisarmed(channel); !ready)
        return tl::unexpected(ready.error());
    const auto gains = readGains(channel);
    if (!gains)
        return tl::unexpected(gains.error());
    const auto text = readText(channel);
    if (!text)
        return tl::unexpected(text.error());
    const auto scales = findScales(*text);
    if (!scales)
        return tl::unexpected(scales.error());
    QByteArray next = *text;
    int changed = 0;
    constexpr std::array kNames{"pid_roll", "pid_pitch", "pid_yaw"};
    for (int variable = 0; variable < kRateGains; ++variable) {
        const auto term = std::size_t(variable % 3);
        const auto found = findGains(next, QString::fromLatin1(kNames[std::size_t(variable / 3)]));
        if (!found)
            return tl::unexpected(found.error());
        const double scale = (*scales)[term];
        const float gain = gainAt(*gains, variable);
        const Literal &literal = (*found)[term];
        if (float(literal.value * scale) == gain)
            continue;
        next = replaced(next, literal, literalFor(gain, scale));
        ++changed;
    }
    if (changed == 0)
        return ActionReply{{u"changed"_s, 0}};
    channel.expectSilence(kLeaves + kComesBack);
    if (const auto written = writeText(channel, next); !written)
        return tl::unexpected(written.error());
    Progress progress;
    progress.step = u"await-restart"_s;
    progress.subject = u"CONFIG_FILE"_s;
    channel.progress(progress);
    if (const auto back = awaitReturn(channel); !back)
        return tl::unexpected(back.error());
    const auto held = readText(channel);
    if (!held)
        return tl::unexpected(held.error());
    if (*held != next)
        return failure(ErrorCode::NotStored, u"the drone holds another text than was uploaded"_s);
    // The offset of the horizon has no place in the text: it is in use again, as it was.
    const QByteArray offsets = gains->mid(kRateGains * 4, kOffsets * 4);
    if (offsets != QByteArray(kOffsets * 4, '\0')) {
        if (const auto set = setGain(channel, kRateGains, *gains); !set)
            return tl::unexpected(set.error());
    }
    const auto used = readGains(channel);
    if (!used)
        return tl::unexpected(used.error());
    for (int variable = 0; variable < kRateGains; ++variable) {
        if (gainAt(*used, variable) != gainAt(*gains, variable))
            return failure(ErrorCode::NotStored, u"after its restart the drone uses other gains"_s);
    }
    return ActionReply{{u"changed"_s, changed}};
}

// It confirms, waits, goes and comes back; the first packet that it hears then is thrown away (errata
// 3, 7.3).
Result<void> Device::awaitReturn(Channel &channel)
{
    Request ping = ask(Message::Ping, bigU32(0));
    ping.retries = 0;
    ping.repeated = true;
    bool isAway = false;
    const TimePoint leaves = channel.now() + kLeaves;
    const TimePoint limit = leaves + kComesBack;
    while (channel.now() < (isAway ? limit : leaves)) {
        const auto heard = channel.transact(ping);
        if (!heard && heard.error().code != ErrorCode::Timeout)
            return tl::unexpected(heard.error());
        if (heard && isAway)
            return {};
        isAway |= !heard;
        if (const auto slept = channel.sleep(kStatusPause); heard && !slept)
            return slept;
    }
    return isAway
        ? failure(ErrorCode::NotSeen,
                  u"the drone has not come back after its restart; its configuration may not load"_s)
        : failure(ErrorCode::NotSeen, u"the drone has not restarted"_s);
}

}  // namespace bcflight
