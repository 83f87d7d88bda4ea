// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a drone can be told to do (errata 6 and 7).
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/tables.h"
#include "protocol/bcflight/transmitter.h"
#include "protocol/session/channel.h"

#include <QDateTime>

#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr auto kCalibrationLimit = 15s;  // errata 7.1
constexpr int kCalibrationAttempts = 3;
constexpr auto kStatusPause = 200ms;
constexpr auto kTenth = 100ms;
constexpr auto kHearsAgain = 5s;
constexpr auto kOutputsCome = 1s;
constexpr auto kAway = 1500ms;  // without any answer: no loss of packets lasts so long by chance
constexpr std::uint32_t kAccepted = 3;
constexpr int kStopRounds = 5;
constexpr int kOutputsLooked = 5;

QString textIn(const Frame &frame)
{
    return QString::fromUtf8(frame.payload.left(frame.payload.indexOf('\0')));
}

QString bandOf(int channelNumber)
{
    return QLatin1String(kTransmitterBands.at(std::size_t(channelNumber - 1) / kBandChannels).name);
}

int channelInBand(int channelNumber)
{
    return (channelNumber - 1) % kBandChannels + 1;
}

enum class Standing { Driven, Stands, Untold };

// By what it streams from now on; where nothing is streamed, nothing tells.
Result<Standing> standing(Channel &channel)
{
    const auto outputs
        = channel.listen([](const FrameView &frame) { return frame.id == int(Message::MotorsSpeed); });
    for (int i = 0; i < kOutputsLooked; ++i) {
        const auto told = outputs->next(kOutputsCome);
        if (!told && told.error().code != ErrorCode::Timeout)
            return tl::unexpected(told.error());
        if (!told)
            return Standing::Untold;
        if (!areDriven(outputsIn(asBytes(told->payload))))
            return Standing::Stands;
    }
    return Standing::Driven;
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

}  // namespace

std::uint32_t Device::codeOf(const Frame &frame)
{
    const FieldSpec field{"code", FieldType::U32};
    const auto values = decodeFields({&field, 1}, asBytes(frame.payload));
    return values.empty() ? ~0U : std::uint32_t(values.front().number);
}

Result<ActionReply> Device::perform(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    const auto is = [&key](const char *name) { return key == QLatin1String(name); };
    const auto send = [&](Message id, const Request &request) -> Result<Frame> {
        const auto may = checkMaySend(channel, id);
        return may ? channel.transact(request) : tl::unexpected(may.error());
    };
    const auto nothing = [](const Frame &) { return ActionReply(); };
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
    if (is("firmware.upload"))
        return uploadFirmware(channel, arguments.value(u"file"_s).toString());
    if (is("mode"))
        return send(Message::SetMode, ask(Message::SetMode, bigU32(std::uint32_t(number("mode")))))
            .map([](const Frame &frame) {
                return ActionReply{{u"mode"_s, int(codeOf(frame))}};
            });
    if (is("motors.beep"))
        return send(Message::MotorsBeep, order(Message::MotorsBeep, bigU16(on ? 1 : 0))).map(nothing);
    if (is("battery.reset"))
        return send(Message::ResetBattery, order(Message::ResetBattery, bigU32(0))).map(nothing);
    if (is("telemetry.full"))
        return send(Message::SetFullTelemetry, order(Message::SetFullTelemetry, bigU32(on ? 1 : 0)))
            .map(nothing);
    if (is("clock"))
        return send(Message::SetTimestamp,
                    ask(Message::SetTimestamp, bigU32(std::uint32_t(QDateTime::currentSecsSinceEpoch()))))
            .map(nothing);
    if (is("vtx"))
        return transmitter(channel);
    if (is("vtx.channel"))
        return setTransmitter(channel, Message::VtxSetChannel,
                              number("band") * kBandChannels + number("channel"));
    if (is("vtx.power"))
        return setTransmitter(channel, Message::VtxSetPower, number("power") - 1);
    if (key == u"camera"_s || key.startsWith(u"camera."_s))
        return performCamera(channel, key, arguments);
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
        if (now && !now->armed) {
            const auto seen = standing(channel);
            if (!seen)
                return tl::unexpected(seen.error());
            if (*seen == Standing::Untold)
                return ActionReply{{u"outputs"_s, u"not told"_s}};
            if (*seen == Standing::Stands)
                return ActionReply();
        }
        if (!now && now.error().code != ErrorCode::Timeout)
            break;
    }
    return now ? failure(ErrorCode::NotProven,
                         now->armed ? u"the drone says that it is armed"_s
                                    : u"the drone drives its motors though disarmed"_s)
               : tl::unexpected(now.error());
}

Result<ActionReply> Device::tellStatus(Channel &channel)
{
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    const auto reply = channel.transact(askState(Message::Telemetry));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto telemetry = Telemetry::decode(asBytes(reply->payload));
    if (!telemetry)
        return failure(ErrorCode::BadReply, u"TELEMETRY"_s);
    ActionReply told{{u"armed"_s, now->armed},
                     {u"calibrated"_s, now->calibrated},
                     {u"calibrating"_s, now->calibrating},
                     {u"battery.voltage"_s, telemetry->voltage},
                     {u"battery.charge"_s, telemetry->charge},
                     {u"battery.level"_s, telemetry->level},
                     {u"cpu.load"_s, telemetry->cpuLoad},
                     {u"cpu.temperature"_s, telemetry->cpuTemperature},
                     {u"rx.quality"_s, telemetry->receiveQuality},
                     {u"rx.dbm"_s, telemetry->receiveLevel}};
    if (telemetry->current != 0)  // 0 where nothing measures it (errata 4.2)
        told.insert(u"battery.current"_s, telemetry->current);
    return told;
}

Result<QString> Device::readInformation(Channel &channel, Message id)
{
    if (wireId(id, m_generation) < 0)
        return failure(ErrorCode::Unsupported, u"this generation does not tell it"_s);
    return channel.transact(ask(id)).map(textIn);
}

// Where it cannot be read as a table it is told as it came.
Result<ActionReply> Device::tellInfo(Channel &channel, Message id)
{
    const auto text = readInformation(channel, id);
    if (!text)
        return tl::unexpected(text.error());
    const auto nodes = readInfo(text->toUtf8());
    if (!nodes)
        return ActionReply{{u"text"_s, *text}};
    ActionReply told;
    flatten(*nodes, {}, told);
    return told;
}

Result<QByteArray> Device::readRecordingsList(Channel &channel)
{
    if (m_generation < Generation::F)
        return failure(ErrorCode::Unsupported, u"only generations F and G are asked for their recordings"_s);
    const auto reply = channel.transact(ask(Message::GetRecordingsList));
    return reply ? decodeChecked(asBytes(reply->payload)) : tl::unexpected(reply.error());
}

Result<ActionReply> Device::tellRecordings(Channel &channel)
{
    const auto text = readRecordingsList(channel);
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

// Its answer carries what it really set (errata 6.6), and so do its settings.
Result<ActionReply> Device::setTransmitter(Channel &channel, Message id, int wanted) const
{
    if (const auto may = checkMaySend(channel, id); !may)
        return tl::unexpected(may.error());
    const auto there = transmitter(channel);
    if (!there)
        return there;
    const auto steps = there->value(u"powers"_s).toString().split(u' ', Qt::SkipEmptyParts).size();
    if (id == Message::VtxSetPower && wanted >= steps)
        return failure(ErrorCode::OutOfRange, u"the transmitter has %1 steps of power"_s.arg(steps));
    if (const auto set = channel.transact(ask(id, QByteArray(1, char(wanted)))); !set)
        return tl::unexpected(set.error());
    const auto now = transmitter(channel);
    if (!now)
        return now;
    const int power = now->value(u"power"_s).toInt();
    const QString band = now->value(u"band"_s).toString();
    const int number = now->value(u"channel"_s).toInt();
    if (id == Message::VtxSetPower && power != wanted + 1)
        return failure(ErrorCode::NoEffect, u"the transmitter sends with power %1"_s.arg(power));
    if (id == Message::VtxSetChannel && (band != bandOf(wanted) || number != channelInBand(wanted)))
        return failure(ErrorCode::NoEffect,
                       u"the transmitter sends in the band %1 on channel %2"_s.arg(band).arg(number));
    return now;
}

// Errata 6.6: all ones where there is no transmitter.
Result<ActionReply> Device::transmitter(Channel &channel) const
{
    const Request request = ask(Message::VtxGetSettings);
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    const auto values
        = decodeFields(*findMessage(Message::VtxGetSettings)->fromDrone, asBytes(reply->payload));
    if (values.size() < 5)
        return failure(ErrorCode::BadReply, request.name);
    const int channelNumber = int(values[0].number);
    if (channelNumber < 1 || channelNumber > int(kTransmitterBands.size()) * kBandChannels)
        return failure(ErrorCode::Unsupported, u"the drone has no video transmitter"_s);
    QStringList powers;
    for (const float dbm : values[4].numbers)
        powers.append(QString::number(int(dbm)));
    return ActionReply{{u"band"_s, bandOf(channelNumber)},      {u"channel"_s, channelInBand(channelNumber)},
                       {u"frequency"_s, int(values[1].number)}, {u"power"_s, int(values[2].number) + 1},
                       {u"power.dbm"_s, int(values[3].number)}, {u"powers"_s, powers.join(u' ')}};
}

// Its one answer may be lost, or what it answers to; its status tells which, and only a drone that has not
// begun is told again.
Result<bool> Device::beginCalibration(Channel &channel, bool isFull)
{
    Request request = ask(Message::Calibrate, bigU32(isFull ? 1 : 0) + bigF32(0));
    request.idempotent = false;
    const auto before = status(channel);
    if (!before)
        return tl::unexpected(before.error());
    for (int attempt = 1;; ++attempt) {
        const auto reply = channel.transact(request);
        if (reply && codeOf(*reply) == kAccepted)
            return !before->calibrated;
        if (reply)
            return tl::unexpected(
                Error{ErrorCode::BoardError, u"the drone refuses to calibrate"_s, int(codeOf(*reply))});
        if (reply.error().code != ErrorCode::Timeout || attempt == kCalibrationAttempts)
            return tl::unexpected(reply.error());
        const auto now = status(channel);
        if (!now)
            return tl::unexpected(now.error());
        if (now->armed)
            return failure(ErrorCode::ConditionUnmet, u"the drone is armed"_s);
        if (now->calibrating || now->calibrated != before->calibrated)
            return true;
    }
}

// One answer, then its status tells (errata 7.1).
Result<ActionReply> Device::calibrate(Channel &channel, bool isFull)
{
    if (const auto may = checkMaySend(channel, Message::Calibrate); !may)
        return tl::unexpected(may.error());
    const auto begun = beginCalibration(channel, isFull);
    if (!begun)
        return tl::unexpected(begun.error());
    Progress progress;
    progress.step = u"calibrate-drone"_s;
    channel.progress(progress);
    bool wasSeen = *begun;
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

// Nobody can call it back, so nobody ends the wait: what came after it would queue up behind its command.
Result<void> Device::waitDeaf(Channel &channel, const Request &request, std::span<const DeafPhase> phases,
                              QMap<QString, double> figures)
{
    const Unbroken unbroken(channel);
    milliseconds deaf{};
    for (const DeafPhase &phase : phases)
        deaf += phase.time;
    channel.keepQuiet(deaf);
    channel.expectSilence(deaf + kHearsAgain);
    channel.post(request);
    Progress progress;
    progress.total = int(deaf / kTenth);
    progress.values = std::move(figures);
    const TimePoint begin = channel.now();
    TimePoint ends = begin;
    for (const DeafPhase &phase : phases) {
        ends += phase.time;
        progress.step = QLatin1String(phase.step);
        while (channel.now() < ends) {
            progress.done = int((channel.now() - begin) / kTenth);
            progress.values.insert(u"left"_s, seconds(begin + deaf - channel.now()));
            channel.progress(progress);
            if (const auto slept = channel.sleep(kStatusPause); !slept)
                return slept;
        }
    }
    return {};
}

Result<ActionReply> Device::beDeaf(Channel &channel, const Request &request,
                                   std::span<const DeafPhase> phases, const QMap<QString, double> &figures)
{
    if (const auto waited = waitDeaf(channel, request, phases, figures); !waited)
        return tl::unexpected(waited.error());
    if (channel.cancelled())
        return failure(ErrorCode::Cancelled, u"the drone had taken it up already, and has carried it out"_s);
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

// Over TCP its silence may cost the link (errata 2.6), and with it the stop that it has to hear first.
Result<void> Device::checkMayTurn() const
{
    return m_isWhole ? Result<void>() : failure(ErrorCode::Unsupported, u"motors are turned over UDP only"_s);
}

// Errata 7.7: an index that it has not ends its program, and a test before a calibration hangs it.
Result<ActionReply> Device::testMotor(Channel &channel, int motor)
{
    if (const auto may = checkMayTurn(); !may)
        return tl::unexpected(may.error());
    const auto outputs
        = channel.listen([](const FrameView &frame) { return frame.id == int(Message::MotorsSpeed); });
    if (const auto may = checkMaySend(channel, Message::MotorTest); !may)
        return tl::unexpected(may.error());
    const auto now = status(channel);
    if (!now)
        return tl::unexpected(now.error());
    if (!now->calibrated)
        return failure(ErrorCode::ConditionUnmet, u"the drone is not calibrated"_s);
    const auto told = outputs->next(kOutputsCome);
    if (!told && told.error().code != ErrorCode::Timeout)
        return tl::unexpected(told.error());
    if (!told)
        return failure(ErrorCode::ConditionUnmet,
                       u"the drone does not stream its outputs, so nobody knows how many motors it has; "
                       "switch full telemetry on"_s);
    const int count = int(outputsIn(asBytes(told->payload)).size());
    if (motor < 1 || motor > count)
        return failure(ErrorCode::InvalidArgument, u"the drone has %1 motors"_s.arg(count));
    constexpr DeafPhase kPhases[] = {{"motor-test", 8s}};  // errata 7.7
    return beDeaf(channel, order(Message::MotorTest, bigU32(std::uint32_t(motor - 1))), kPhases,
                  {{u"motor"_s, double(motor)}});
}

Result<ActionReply> Device::calibrateEscs(Channel &channel)
{
    if (const auto may = checkMayTurn(); !may)
        return tl::unexpected(may.error());
    if (const auto may = checkMaySend(channel, Message::CalibrateEscs); !may)
        return tl::unexpected(may.error());
    constexpr DeafPhase kPhases[] = {{"escs-off", 10s}, {"escs-full", 8s}, {"escs-zero", 8s}};  // errata 7.7
    return beDeaf(channel, order(Message::CalibrateEscs), kPhases, {});
}

Result<QByteArray> Device::withGains(const QByteArray &text, const QByteArray &gains,
                                     ActionReply &changes) const
{
    const auto scales = findScales(text);
    if (!scales)
        return tl::unexpected(scales.error());
    QByteArray next = text;
    for (int variable = 0; variable < kRateGains; ++variable) {
        const auto term = std::size_t(variable % 3);
        const auto found = findGains(next, QString::fromLatin1(kGainNames[std::size_t(variable / 3)]));
        if (!found)
            return tl::unexpected(found.error());
        const double scale = (*scales)[term];
        const float gain = gainAt(gains, variable);
        const Literal &literal = (*found)[term];
        if (isSameGain(float(literal.value * scale), gain))
            continue;
        // Another ground may have set anything, and what is no number names a variable there.
        const double value = literalFor(gain, scale);
        if (const auto known = checkAdjustable({variable, double(gain)}); !known)
            return tl::unexpected(known.error());
        if (!std::isfinite(value))
            return failure(ErrorCode::ConditionUnmet,
                           u"the scale of a gain in the text is %1, which gives no number"_s.arg(scale));
        changes.insert(adjustableKey(variable), u"%1 > %2"_s.arg(literal.value).arg(value));
        next = replaced(next, literal, value);
    }
    return next;
}

// What is in use is forgotten at the next start, so it is written into the text that the drone reads then:
// one number for each gain that differs, everything else byte for byte (errata 7.2).
Result<ActionReply> Device::storeGains(Channel &channel)
{
    if (const auto may = checkMaySend(channel, Message::SetConfigFile); !may)
        return tl::unexpected(may.error());
    const auto gains = readGains(channel);
    if (!gains)
        return tl::unexpected(gains.error());
    const auto text = readText(channel);
    if (!text)
        return tl::unexpected(text.error());
    ActionReply changes;
    const auto next = withGains(*text, *gains, changes);
    if (!next)
        return tl::unexpected(next.error());
    ActionReply reply = changes;
    reply.insert(u"changed"_s, changes.size());
    if (changes.isEmpty())
        return reply;
    if (const auto written = writeText(channel, *next); !written)
        return tl::unexpected(written.error());
    const auto held = readText(channel);
    if (!held)
        return tl::unexpected(held.error());
    if (*held != *next)
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
        if (!isSameGain(gainAt(*used, variable), gainAt(*gains, variable)))
            return failure(ErrorCode::NotStored, u"after its restart the drone uses other gains"_s);
    }
    return reply;
}

// It confirms, waits, goes and comes back; the first packet that it hears then is thrown away (errata
// 3, 7.3). A single answer that got lost does not mean that it has gone.
Result<bool> Device::goesAndReturns(Channel &channel, milliseconds leaves, milliseconds comesBack)
{
    Request ping = ask(Message::Ping, bigU32(0));
    ping.retries = 0;
    ping.repeated = true;
    bool isAway = false;
    TimePoint heardAt = channel.now();
    const TimePoint leavesBy = heardAt + leaves;
    const TimePoint limit = leavesBy + comesBack;
    while (channel.now() < (isAway ? limit : leavesBy)) {
        const auto heard = channel.transact(ping);
        if (!heard && heard.error().code != ErrorCode::Timeout)
            return tl::unexpected(heard.error());
        if (heard && isAway)
            return true;
        if (heard)
            heardAt = channel.now();
        isAway |= channel.now() - heardAt >= kAway;
        if (const auto slept = channel.sleep(kStatusPause); heard && !slept)
            return tl::unexpected(slept.error());
    }
    if (!isAway)
        return false;
    return failure(
        ErrorCode::NotSeen,
        u"the drone has not come back after its restart; what it was given may not start, and then only "
        "a login on its computer helps"_s);
}

Result<void> Device::awaitReturn(Channel &channel, milliseconds leaves, milliseconds comesBack)
{
    const auto returned = goesAndReturns(channel, leaves, comesBack);
    if (!returned)
        return tl::unexpected(returned.error());
    return *returned ? Result<void>() : failure(ErrorCode::NotSeen, u"the drone has not restarted"_s);
}

}  // namespace bcflight
