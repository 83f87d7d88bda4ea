// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/device.h"

#include "protocol/bcflight/decoder.h"
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/luacheck.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/pingprobe.h"
#include "protocol/bcflight/tables.h"
#include "protocol/session/channel.h"
#include "protocol/telemetry/telemetryplan.h"

#include <QCryptographicHash>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr auto kBeat = 250ms;  // errata 3
constexpr auto kAnswer = 250ms;
constexpr auto kTextAnswer = 1000ms;
constexpr int kRetries = 5;  // errata 3: bounded
constexpr auto kStatusPeriod = 200ms;  // errata 3: faster than the original
constexpr double kNoStream = 5;  // rows per second: what is asked for
constexpr auto kLost = 3s;
constexpr auto kTogether = 150ms;  // what is answered in one packet has come by then
constexpr int kSizeOfFloat = 4;
constexpr int kUploads = 3;
constexpr auto kLeaves
    = 20s;  // fixed waits of about 4 s before it restarts (errata 7.3); a busy computer is slower
constexpr auto kComesBack = 20s;

constexpr std::array kFactors{Message::RollPidFactors, Message::PitchPidFactors, Message::YawPidFactors};

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &identity)
{
    return std::make_shared<ParameterSet>(parameterRows(), blocks(), identity.firmwareNumber,
                                          identity.capabilities);
}

// The tick is this computer's clock; the drone gives it back (errata 3).
QByteArray pingPayload()
{
    return bigU16(PingProbe::tickAt(Clock::now())) + bigU16(0);
}

std::optional<Result<Frame>> accept(const FrameView &frame, Message id)
{
    return frame.id == int(id) ? std::optional(Result<Frame>(Frame(frame))) : std::nullopt;
}

QString valueIn(const QList<InfoNode> &nodes, const QString &name)
{
    const auto it = std::find_if(nodes.begin(), nodes.end(),
                                 [&name](const InfoNode &node) { return node.name == name; });
    return it == nodes.end() ? QString() : it->value;
}

QByteArray floatBytes(const QByteArray &gains, int variable)
{
    return gains.mid(variable * kSizeOfFloat, kSizeOfFloat);
}

QString textOf(const Frame &frame)
{
    return QString::fromUtf8(frame.payload.left(frame.payload.indexOf('\0')));
}

// As far as it can be told without risk (errata 1): C speaks as D does, and F as G.
QString toldGeneration(Generation generation)
{
    return generation == Generation::C ? u"C or D"_s
        : generation == Generation::G  ? u"F or G"_s
                                       : generationText(generation);
}

}  // namespace

Device::Device() = default;

float Device::gainAt(const QByteArray &gains, int variable)
{
    const FieldSpec field{"", FieldType::F32};
    const auto values = decodeFields({&field, 1}, asBytes(floatBytes(gains, variable)));
    return values.empty() ? std::numeric_limits<float>::quiet_NaN() : float(values.front().number);
}

Request Device::order(Message id, const QByteArray &payload) const
{
    Request request;
    request.name = QString::fromLatin1(findMessage(id)->name);
    request.bytes = encode(id, payload, m_generation);
    return request;
}

Request Device::ask(Message id, const QByteArray &payload) const
{
    Request request = order(id, payload);
    request.answer = [id](const FrameView &frame) { return accept(frame, id); };
    request.kind = int(id);
    request.timeout = kAnswer;
    request.retries = kRetries;
    request.idempotent = true;
    return request;
}

// The first packet that a drone hears after its start makes it listen, and is thrown away (errata 3).
Result<bool> Device::probe(Channel &channel)
{
    // Always the same one: a recording answers what it was asked.
    Request ping = ask(Message::Ping, bigU16(0) + bigU16(0));
    ping.repeated = true;
    const auto reply = channel.transact(ping);
    if (!reply && reply.error().code != ErrorCode::Timeout)
        return tl::unexpected(reply.error());
    return reply.has_value();
}

Result<Generation> Device::detect(Channel &channel)
{
    m_generation = Generation::Unknown;
    // Up to generation B the status comes along with the answer to a ping.
    const auto box = channel.listen([](const FrameView &frame) {
        return frame.id == int(Message::Status) && !frame.raw.empty() && frame.raw[0] == std::byte{0x80};
    });
    if (const auto heard = probe(channel); !heard || !*heard)
        return heard ? failure(ErrorCode::Timeout, u"PING"_s) : tl::unexpected(heard.error());
    const auto together = box->next(kTogether);
    if (!together && together.error().code != ErrorCode::Timeout)
        return tl::unexpected(together.error());
    if (together) {
        Request old = ask(Message::GetCamerasInfos);
        old.bytes = QByteArray::fromHex("006b");
        old.answer = [](const FrameView &frame) -> std::optional<Result<Frame>> {
            const auto config = accept(frame, Message::GetConfigFile);
            return config ? config : accept(frame, Message::GetCamerasInfos);
        };
        const auto answer = channel.transact(old);
        if (!answer)
            return tl::unexpected(answer.error());
        return answer->id == int(Message::GetConfigFile) ? Generation::A : Generation::B;
    }
    const auto isAnswered = [&channel](const Request &request) -> Result<bool> {
        const auto answer = channel.transact(request);
        if (!answer && answer.error().code != ErrorCode::Timeout)
            return tl::unexpected(answer.error());
        return answer.has_value();
    };
    Request status = ask(Message::Status);
    status.bytes = QByteArray::fromHex("85");
    // Packets are lost, and a drone that is taken for an old one is open for reading only.
    status.retries = 5;
    if (const auto current = isAnswered(status); !current || *current)
        return current ? Result<Generation>(Generation::G) : tl::unexpected(current.error());
    // C and D cannot be told apart without risk.
    return isAnswered(acknowledgement(1)).map([](bool answers) {
        return answers ? Generation::E : Generation::C;
    });
}

Result<BoardIdentity> Device::identify(Channel &channel)
{
    const auto generation = detect(channel);
    if (!generation)
        return tl::unexpected(generation.error());
    m_generation = *generation;
    m_isWhole = channel.observation().isPacketBased;
    m_isHeld = false;
    m_operation = 0;
    BoardIdentity identity;
    identity.family = u"bcflight"_s;
    identity.firmwareNumber = int(m_generation);
    identity.writable = m_generation >= Generation::F;
    const auto told = channel.transact(ask(Message::GetBoardInfos));
    if (!told)
        return tl::unexpected(told.error());
    const QString board = textOf(*told);
    const auto info = readInfo(board.toUtf8());
    const QString model = info ? valueIn(*info, u"Model"_s) : QString();
    const QString type = info ? valueIn(*info, u"Type"_s) : QString();
    identity.model = u"BCFlight %1"_s.arg(model.isEmpty() ? type : model).trimmed();
    const QString version = info ? valueIn(*info, u"Firmware version"_s) : QString();
    identity.firmware = version.isEmpty() ? u"?"_s : version;
    QString name;
    if (m_generation >= Generation::F) {
        // Asked as often as all else: a name that is lost on the way makes it look like another drone.
        if (const auto reply = channel.transact(ask(Message::GetUsername)))
            name = textOf(*reply);
        else if (reply.error().code != ErrorCode::Timeout)
            return tl::unexpected(reply.error());
    }
    if (name == u"[unknown]"_s)
        name.clear();
    // It has no number; by its looks it is told from others.
    identity.serial = u"bcflight-"_s
        + QString::fromLatin1(QCryptographicHash::hash((name + u'\n' + model + u'\n' + type).toUtf8(),
                                                       QCryptographicHash::Sha1)
                                  .left(6)
                                  .toHex());
    identity.extra.insert(BoardIdentity::kUnnumbered, true);
    identity.extra.insert(u"name"_s, name);
    identity.extra.insert(u"port"_s, u"network"_s);
    identity.extra.insert(u"generation"_s, toldGeneration(m_generation));
    m_identity = identity;
    m_parameters = parametersOf(identity);
    m_adjustables.clear();
    m_adjustableKeys.clear();
    m_adjustableKeys.reserve(m_parameters->all().size());
    for (const ParameterSpec &spec : m_parameters->all()) {
        if (spec.adjustable < 0)
            continue;
        m_adjustableKeys.push_back(spec.key.toLatin1());
        m_adjustables.push_back({spec.adjustable, m_adjustableKeys.back().constData(), spec.row->label,
                                 spec.row->group, spec.axis, spec.row->min, spec.row->max, 0});
    }
    return identity;
}

Result<Status> Device::status(Channel &channel) const
{
    const auto reply = channel.transact(askState(Message::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto status = Status::decode(asBytes(reply->payload));
    return status ? Result<Status>(*status) : failure(ErrorCode::BadReply, u"STATUS"_s);
}

// Before they could be asked for they came along: up to generation B with the answer to a ping, then the
// status with the telemetry (errata 1).
Request Device::askState(Message id) const
{
    Request question = ask(id);
    if (m_generation < findMessage(id)->askedSince)
        question.bytes = m_generation <= Generation::B ? encode(Message::Ping, pingPayload(), m_generation)
                                                       : encode(Message::Telemetry, {}, m_generation);
    return question;
}

Request Device::statusQuestion() const
{
    Request question = askState(Message::Status);
    question.retries = 0;
    question.repeated = true;
    return question;
}

Result<bool> Device::askArmed(Channel &channel)
{
    const auto reply = channel.transact(statusQuestion());
    if (!reply)
        return tl::unexpected(reply.error());
    const auto status = Status::decode(asBytes(reply->payload));
    return status ? Result<bool>(status->armed) : failure(ErrorCode::BadReply, u"STATUS"_s);
}

Result<Configuration> Device::readConfiguration(Channel &channel)
{
    Configuration configuration(m_identity, m_parameters);
    for (const BlockSpec &block : blocks()) {
        auto bytes = readBlock(channel, {0, block.id});
        if (bytes)
            configuration.setBlock({0, block.id}, std::move(*bytes));
        else if (bytes.error().code == ErrorCode::LinkClosed || bytes.error().code == ErrorCode::Cancelled)
            return tl::unexpected(bytes.error());
        else
            configuration.addMissing({0, block.id}, bytes.error());
    }
    return configuration;
}

Result<QByteArray> Device::readBlock(Channel &channel, BlockKey key)
{
    return key.block == Gains ? readGains(channel) : readText(channel);
}

Result<QByteArray> Device::readGains(Channel &channel)
{
    QByteArray gains;
    const auto append = [&](Message id, int floats) -> Result<void> {
        const auto reply = channel.transact(ask(id));
        if (!reply)
            return tl::unexpected(reply.error());
        if (reply->payload.size() != floats * kSizeOfFloat)
            return failure(ErrorCode::BadReply, QString::fromLatin1(findMessage(id)->name));
        gains += reply->payload;
        return {};
    };
    for (const Message axis : kFactors) {
        if (const auto read = append(axis, 3); !read)
            return tl::unexpected(read.error());
    }
    if (const auto read = append(Message::HorizonOffset, kOffsets); !read)
        return tl::unexpected(read.error());
    if (const auto read = append(Message::OuterPidFactors, kOuterGains); !read)
        return tl::unexpected(read.error());
    return gains;
}

// One command per gain; the offset goes as a pair. The echo confirms it, and reading back proves it. A
// refusal is silence (errata 7.2).
Result<void> Device::setGain(Channel &channel, int variable, const QByteArray &gains)
{
    const bool isOffset = variable >= kRateGains;
    const Message id = isOffset ? Message::SetHorizonOffset : Message(int(Message::SetRollP) + variable);
    const QByteArray payload = isOffset ? gains.mid(kRateGains * kSizeOfFloat, kOffsets * kSizeOfFloat)
                                        : floatBytes(gains, variable);
    const auto echo = channel.transact(ask(id, payload));
    if (!echo)
        return tl::unexpected(echo.error());
    return echo->payload == payload
        ? Result<void>()
        : failure(ErrorCode::BadReply,
                  u"%1: another value came back"_s.arg(QLatin1String(findMessage(id)->name)));
}

Result<void> Device::writeGains(Channel &channel, const QByteArray &bytes)
{
    for (int variable = 0; variable < kLiveValues; ++variable) {
        if (!std::isfinite(gainAt(bytes, variable)))
            return failure(ErrorCode::OutOfRange, u"a gain is no number"_s);
    }
    const auto isArmed = checkTunable(channel);
    if (!isArmed)
        return tl::unexpected(isArmed.error());
    const auto now = readGains(channel);
    if (!now)
        return tl::unexpected(now.error());
    const auto offsets = [](const QByteArray &gains) {
        return gains.mid(kRateGains * kSizeOfFloat, kOffsets * kSizeOfFloat);
    };
    if (*isArmed && offsets(*now) != offsets(bytes))
        return failure(ErrorCode::ConditionUnmet, u"the drone is armed"_s);
    bool isOffsetSet = false;
    bool isSet = false;
    for (int variable = 0; variable < kLiveValues; ++variable) {
        if (floatBytes(*now, variable) == floatBytes(bytes, variable)
            || (variable >= kRateGains && std::exchange(isOffsetSet, true)))
            continue;
        if (const auto set = setGain(channel, variable, bytes); !set)
            return set;
        isSet = true;
    }
    if (!isSet)
        return {};
    // That it repeats a value does not say that it has taken it.
    const auto after = readGains(channel);
    if (!after)
        return tl::unexpected(after.error());
    for (int variable = 0; variable < kLiveValues; ++variable) {
        if (floatBytes(*now, variable) != floatBytes(bytes, variable)
            && floatBytes(*after, variable) != floatBytes(bytes, variable))
            return failure(ErrorCode::NoEffect, adjustableKey(variable));
    }
    return {};
}

Result<QByteArray> Device::readText(Channel &channel)
{
    Request request = ask(Message::GetConfigFile);
    request.timeout = kTextAnswer;
    request.answer = [](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id != int(Message::GetConfigFile))
            return {};
        const auto text = decodeChecked(frame.payload);
        return text ? Result<Frame>(Frame(frame)) : tl::unexpected(text.error());
    };
    const auto reply = channel.transact(request);
    return reply ? decodeChecked(asBytes(reply->payload)) : tl::unexpected(reply.error());
}

// Errata 7.3. It overwrites its only copy and restarts, and if it cannot load the text it never comes back:
// the text that it had is in the history by then.
Result<void> Device::writeText(Channel &channel, const QByteArray &text)
{
    if (const auto valid = checkSyntax(text); !valid)
        return valid;
    if (text.size() >= kLargestText)
        return failure(ErrorCode::TooMuch,
                       u"%1 bytes; less than %2 are allowed"_s.arg(text.size()).arg(kLargestText));
    // Over a stream it would arrive in pieces, and the drone would take those for commands (errata 2.6).
    if (!channel.observation().isPacketBased)
        return failure(ErrorCode::Unsupported, u"the configuration text is uploaded over UDP only"_s);
    for (int attempt = 0; attempt < kUploads; ++attempt) {
        // Each time: somebody else may have armed it, and a drone that takes a text restarts even in flight.
        if (const auto may = checkMaySend(channel, Message::SetConfigFile); !may)
            return may;
        channel.expectSilence(kLeaves + kComesBack);
        const auto uploaded = upload(channel, text);
        if (!uploaded && uploaded.error().code != ErrorCode::Timeout)
            return uploaded;
        Progress progress;
        progress.step = u"await-restart"_s;
        progress.subject = u"CONFIG_FILE"_s;
        channel.progress(progress);
        const auto returned = goesAndReturns(channel, kLeaves, kComesBack);
        if (!returned)
            return tl::unexpected(returned.error());
        if (*returned)
            return {};
        // Its answer may have been lost; it is told again only where it is seen to stay (errata 7.3).
        if (uploaded)
            return failure(ErrorCode::NoEffect, u"the drone confirmed the text, and has not restarted"_s);
    }
    return failure(ErrorCode::Timeout, u"the drone answers, and does not take the text"_s);
}

// The answer comes before the text is written, and the drone goes on for a while.
Result<void> Device::upload(Channel &channel, const QByteArray &text)
{
    Request request = ask(Message::SetConfigFile, encodeChecked(text));
    request.timeout = kTextAnswer;
    request.idempotent = false;
    request.retries = 0;
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    constexpr std::uint32_t kNotWhole = 1;
    const std::uint32_t code = codeOf(*reply);
    if (code == kNotWhole)
        return failure(ErrorCode::BoardError, u"the text did not arrive whole; it was not written"_s,
                       int(code));
    // Any other is a damaged answer, which says no more than one that was lost.
    return code == 0 ? Result<void>() : failure(ErrorCode::Timeout);
}

Result<void> Device::writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes)
{
    return key.block == Gains ? writeGains(channel, bytes) : writeText(channel, bytes);
}

std::span<const AdjustableSpec> Device::adjustables() const
{
    return m_adjustables;
}

Result<std::vector<AdjustableValue>> Device::readAdjustables(Channel &channel, const QList<int> &ids)
{
    const auto gains = readGains(channel);
    if (!gains)
        return tl::unexpected(gains.error());
    std::vector<AdjustableValue> values;
    for (const int id : ids)
        values.push_back({id, double(gainAt(*gains, id))});
    return values;
}

QString Device::storeAction() const
{
    return u"gains.store"_s;
}

std::optional<Result<Configuration>> Device::storedAs(const Configuration &inUse) const
{
    ActionReply changes;
    return withGains(inUse.block({0, ConfigurationText}), inUse.block({0, Gains}), changes)
        .map([&inUse](const QByteArray &text) {
            Configuration stored = inUse;
            stored.setBlock({0, ConfigurationText}, text);
            return stored;
        });
}

// They are listed by terms, and numbered by axes.
QString Device::adjustableKey(int variable) const
{
    const auto found = std::ranges::find(m_adjustables, variable, &AdjustableSpec::id);
    return found == m_adjustables.end() ? QString() : QString::fromLatin1(found->key);
}

Result<void> Device::checkAdjustable(const AdjustableValue &wanted) const
{
    const auto spec = std::find_if(m_adjustables.begin(), m_adjustables.end(),
                                   [&wanted](const AdjustableSpec &each) { return each.id == wanted.id; });
    if (spec != m_adjustables.end() && wanted.value >= spec->min && wanted.value <= spec->max)
        return {};
    return failure(ErrorCode::OutOfRange, adjustableKey(wanted.id));
}

Result<void> Device::putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values)
{
    auto gains = readGains(channel);
    if (!gains)
        return tl::unexpected(gains.error());
    for (const AdjustableValue &value : values)
        gains->replace(value.id * kSizeOfFloat, kSizeOfFloat, bigF32(float(value.value)));
    return writeGains(channel, *gains);
}

std::span<const ActionSpec> Device::actions() const
{
    return bcflight::actions();
}

ChannelTable Device::channels() const
{
    return bcflight::channels();
}

// What it streams it streams by itself, as its configuration says; state and battery are asked for.
Result<TelemetryPlan> Device::subscribe(Channel &, const Subscription &subscription,
                                        std::optional<LineSettings>)
{
    if (!subscription.streams.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"a drone decides by itself what it streams"_s);
    TelemetryPlan plan;
    plan.decoder = std::make_shared<Decoder>();
    plan.poll = statusQuestion();
    if (m_generation >= Generation::F)
        plan.poll->bytes += encode(Message::Telemetry, {}, m_generation);
    plan.pollInterval = kStatusPeriod;
    plan.rate = kNoStream;
    plan.isStreamedUnasked = true;
    return plan;
}

std::shared_ptr<TelemetryDecoder> Device::replayDecoder() const
{
    return std::make_shared<Decoder>();
}

std::vector<BoardFact> Device::facts(const std::function<double(int)> &latest) const
{
    const double bits = latest(State);
    if (std::isnan(bits))
        return {};
    const auto has = [bits](std::uint32_t bit) { return (std::uint32_t(bits) & bit) != 0; };
    return {{"Armed", {has(Status::kArmed) ? "yes" : "no"}},
            {"Calibrated",
             {has(Status::kCalibrating)      ? "calibrating"
                  : has(Status::kCalibrated) ? "yes"
                                             : "no"}}};
}

QString Device::statusText(int state) const
{
    const auto bits = std::uint32_t(state);
    if (bits & Status::kArmed)
        return u"Armed"_s;
    if (bits & Status::kCalibrating)
        return u"Calibrating"_s;
    return bits & Status::kCalibrated ? u"Disarmed"_s : u"Not calibrated"_s;
}

bool Device::isStabilising(int state) const
{
    return (std::uint32_t(state) & Status::kArmed) != 0;
}

QString Device::messageText(const FrameView &frame) const
{
    return frame.id == int(Message::DebugOutput) ? textOf(Frame(frame)) : QString();
}

std::vector<MotorShare> Device::motorShares(const Configuration &configuration) const
{
    std::vector<MotorShare> shares;
    for (const MotorMix &mix : findMotors(configuration.block({0, ConfigurationText})))
        shares.push_back({mix[0], mix[1], mix[2], mix[3]});
    return shares;
}

Family family()
{
    Family family;
    family.key = u"bcflight"_s;
    family.name = u"BCFlight"_s;
    // Whatever is sent to a drone it takes for commands: nobody else may ask there. Over TCP it says who it
    // is only when the address names the family.
    family.links = {{LinkAddress::Kind::Udp}, {LinkAddress::Kind::Tcp, false}};
    family.usualAddress = u"udp://192.168.32.1:2020"_s;  // its access point (errata 2.1)
    family.timing.pause = 2ms;
    family.timing.heartbeatPeriod = kBeat;
    family.timing.heartbeat = [] { return encode(Message::Ping, pingPayload()); };
    family.timing.makeProbe = [] { return std::make_unique<PingProbe>(); };
    family.timing.silenceLimit = kLost;
    // RESET_MOTORS has the same number in every generation, disarms, and stops whatever turns (errata 6.4).
    family.timing.blindStop = encode(Message::ResetMotors, {});
    family.nouns.load = "drone";
    family.nouns.flies = true;
    family.makeFramer = [] { return std::make_unique<Framer>(); };
    family.makeDevice = [] { return std::make_unique<Device>(); };
    family.makeParameters = parametersOf;
    return family;
}

}  // namespace bcflight
