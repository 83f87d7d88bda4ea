// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/device.h"

#include "protocol/base/linkloss.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"
#include "protocol/simplebgc/actiontable.h"
#include "protocol/simplebgc/faults.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kProbeTimeout = 250ms;  // errata 1.6: 200-500 ms
constexpr auto kWriteTimeout = 1500ms;  // EEPROM write: tens of milliseconds, with a generous margin
constexpr auto kProfileSwitch = 2000ms;
constexpr int kPauseBetweenLooks = 50;
constexpr int kActiveProfileOffset = 59;  // of REALTIME_DATA_3
constexpr int kMotorFlagOffset = 57;  // of REALTIME_DATA_3: bit 0, the motors run
constexpr int kErrorsOffset = 14;  // of REALTIME_DATA_3: SYSTEM_ERROR, bit 0: no sensor
constexpr int kLiveRetries = 1;

// EXECUTE_MENU numbers of "use profile 1..5" (errata 4.1).
constexpr std::array<int, kProfileCount> kProfileActions{1, 2, 3, 14, 15};

// Bytes that are all 0 or all 0xFF were never written.
bool isNumber(const QByteArray &bytes)
{
    return bytes.count('\0') < bytes.size() && bytes.count('\xFF') < bytes.size();
}

/// @param status REALTIME_DATA_3
bool isWithoutSensor(const QByteArray &status)
{
    return status.size() > kErrorsOffset && (status[kErrorsOffset] & 1);
}

Capabilities capabilitiesOf(const BoardInfo &info)
{
    Capabilities capabilities;
    constexpr std::pair<quint32, const char *> names[]
        = {{ThreeAxis, "yaw-axis"},        {BatteryMonitor, "battery"},
           {Encoders, "encoders"},         {BodeTest, "bode"},
           {Scripting, "scripting"},       {CurrentSensor, "current"},
           {Magnetometer, "magnetometer"}, {CanPort, "can"}};
    for (const auto &[bit, name] : names) {
        if (info.features & bit)
            capabilities.insert(QLatin1String(name));
    }
    if (info.firmware >= 2590)
        capabilities.insert(u"streams"_s);
    return capabilities;
}

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &identity)
{
    return std::make_shared<ParameterSet>(parameterRows(), kBlocks, identity.firmwareNumber,
                                          identity.capabilities, valueRules());
}

// Document "Message format" and errata 1.6: both parities, 115200 first; 256000 came later.
QList<LineSettings> lineCandidates()
{
    QList<LineSettings> candidates;
    for (const Parity parity : {Parity::None, Parity::Even}) {
        for (const int baud : {115200, 57600, 38400, 19200, 9600, 256000})
            candidates.append({baud, parity});
    }
    return candidates;
}

// After so many questions in a row without an answer, the board is silent, not a part of it missing.
constexpr int kSilentParts = 2;
constexpr int kRetries = 2;
constexpr auto kBeforeAskingAgain = 100ms;

// "Operation failed" and "temporarily impossible" (errata 3.18): the next answer may be another one.
bool isPassing(const Error &error)
{
    return error.code == ErrorCode::BoardError && (error.boardCode == 10 || error.boardCode == 11);
}

// Nothing was learnt about what was asked for.
bool isUnanswered(const Error &error)
{
    return error.code == ErrorCode::Timeout || isPassing(error);
}

// An answer with other variables belongs to another question.
bool areAmong(const Result<std::vector<AdjVar>> &values, const QList<int> &ids)
{
    return !values || std::all_of(values->begin(), values->end(), [&ids](const AdjVar &var) {
        return ids.contains(var.id);
    });
}

// Errors after which the other parts are still worth asking for.
bool isPartial(const Error &error)
{
    return error.code == ErrorCode::Timeout || error.code == ErrorCode::BoardError
        || error.code == ErrorCode::BadReply;
}

}  // namespace

// Before a board is asked: what every board can do.
Device::Device()
    : m_actions(availableActions({}))
{
}

Device::~Device() = default;

Request Device::probeRequest()
{
    Request request = replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, kVersion);
    request.timeout = kProbeTimeout;
    request.repeated = true;
    return request;
}

Result<bool> Device::probe(Channel &channel)
{
    Request request = probeRequest();
    request.retries = 0;
    const LinkObservation before = channel.observation();
    // A board that detects parity by itself may use up the first frame for it.
    for (int tries = 0; tries < 2; ++tries) {
        const auto reply = channel.transact(request);
        if (reply) {
            const auto info = BoardInfo::decode(asBytes(reply->payload));
            m_probed = info ? std::optional(*info) : std::nullopt;
            return true;
        }
        if (reply.error().code != ErrorCode::Timeout && reply.error().code != ErrorCode::BoardError)
            return tl::unexpected(reply.error());
        // Whoever answers otherwise is another family's board, and is not asked again.
        const LinkObservation now = channel.observation();
        if (reply.error().code == ErrorCode::BoardError
            || (now.bytesIn != before.bytesIn && now.framing.frames == before.framing.frames))
            break;
    }
    return false;
}

Result<BoardIdentity> Device::identify(Channel &channel)
{
    const auto reply
        = channel.transact(replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, kVersion));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto info = BoardInfo::decode(asBytes(reply->payload));
    if (!info)
        return tl::unexpected(info.error());

    const auto probed = std::exchange(m_probed, std::nullopt);
    if (probed && (probed->modelText() != info->modelText() || probed->firmware != info->firmware))
        return tl::unexpected(otherIdentity(*info, probed->modelText(), probed->firmwareText()));

    BoardIdentity identity;
    identity.family = u"simplebgc"_s;
    identity.model = info->modelText();
    identity.firmware = info->firmwareText();
    identity.firmwareNumber = info->firmware;
    identity.capabilities = capabilitiesOf(*info);
    identity.profileCount = kProfileCount;
    identity.usb = info->usb;
    identity.writable = info->firmware >= kOldestFirmware && info->firmware <= kNewestFirmware;
    identity.extra.insert(u"board.version"_s, info->boardVersion);
    identity.extra.insert(u"debug_mode"_s, info->debugMode);
    identity.extra.insert(u"features"_s, info->features);
    if (info->extraId != 0 || info->baseFirmware != 0)
        identity.extra.insert(kSpecialBuild, true);

    // Boards without BOARD_INFO_3 still have to be told apart in the history, as far as possible.
    identity.serial = u"sbgc-%1-%2"_s.arg(info->boardVersion).arg(info->extraId, 8, 16, QChar(u'0'));
    identity.extra.insert(BoardIdentity::kUnnumbered, true);
    const auto more
        = channel.transact(replyRequest(CommandId::BoardInfo3, {}, CommandId::BoardInfo3, 69, kVersion));
    if (!more && (isLinkLoss(more.error()) || more.error().code == ErrorCode::Cancelled))
        return tl::unexpected(more.error());
    if (more) {
        if (const auto info3 = BoardInfo3::decode(asBytes(more->payload))) {
            // A number that was never given is none; the processor has one as well.
            const bool hasNumber = isNumber(info3->deviceId);
            const QByteArray &number = hasNumber || !isNumber(info3->mcuId) ? info3->deviceId : info3->mcuId;
            identity.serial = QString::fromLatin1(number.toHex());
            if (isNumber(number))
                identity.extra.remove(BoardIdentity::kUnnumbered);
            identity.extra.insert(u"mcu_id"_s, QString::fromLatin1(info3->mcuId.toHex()));
            identity.extra.insert(u"eeprom_size"_s, info3->eepromSize);
        }
    }

    m_isFirst = false;
    if (!more && !channel.observation().isReplayed) {
        const auto first = isOfTheFirst(channel);
        if (!first)
            return tl::unexpected(first.error());
        m_isFirst = *first;
    }
    m_identity = identity;
    m_parameters = parametersOf(identity);
    m_steeringModes = steeringModes(identity.firmwareNumber);
    m_actions = availableActions(identity);
    m_streams.clear();
    if (const auto stopped = endLeftovers(channel); !stopped)
        return tl::unexpected(stopped.error());
    if (const auto found = findCustomFields(channel); !found)
        return tl::unexpected(found.error());
    return m_identity;
}

Result<Configuration> Device::readConfiguration(Channel &channel)
{
    Configuration configuration(m_identity, m_parameters);
    Progress progress;
    progress.step = u"read-block"_s;
    progress.total = kProfileCount * BlockCount + 1;
    int silent = 0;  // questions in a row without an answer
    std::array<bool, BlockCount> wasSilent{};
    const auto read = [&](BlockKey key) -> Result<void> {
        progress.subject = configuration.blockName(key.block);
        progress.profile = key.profile;
        channel.progress(progress);
        // A block that was silent in the profile before is not repeated at once.
        auto bytes = askBlock(channel, key, wasSilent[std::size_t(key.block)] ? 0 : kRetries);
        wasSilent[std::size_t(key.block)] = !bytes && isUnanswered(bytes.error());
        if (bytes) {
            silent = 0;
            const bool isBoardWide = key.block == AdjVarsCfg;
            for (int profile = 0; isBoardWide && profile < kProfileCount; ++profile)
                configuration.setBlock({profile, key.block}, *bytes);
            if (!isBoardWide)
                configuration.setBlock(key, std::move(*bytes));
            return {};
        }
        silent = bytes.error().code == ErrorCode::Timeout ? silent + 1 : 0;
        if (!isPartial(bytes.error()) || silent > kSilentParts)
            return tl::unexpected(bytes.error());
        // A firmware without this block refuses it or stays silent, and so does a recording of an earlier
        // program, which did not ask for it.
        const bool wasNotAsked = key.block >= ParamsExt3 && channel.observation().isReplayed;
        if (m_identity.firmwareNumber >= kBlocks[key.block].since && !wasNotAsked)
            configuration.addMissing(key, bytes.error());
        return {};
    };
    for (int profile = 0; profile < kProfileCount; ++profile) {
        for (int block = 0; block < BlockCount; ++block) {
            ++progress.done;
            const bool isAbsent = profile > 0 && m_identity.firmwareNumber < kBlocks[block].since
                && configuration.block({0, block}).isEmpty();
            const bool isUnknown = m_identity.firmwareNumber < kBlocks[block].since && block == ParamsExt3;
            if (isAbsent || isUnknown || (m_isFirst && block != Params3)
                || (block == AdjVarsCfg && profile > 0))
                continue;
            if (const auto done = read({profile, block}); !done)
                return tl::unexpected(done.error());
        }
    }
    if (const auto named = addProfileNames(channel, configuration); !named)
        return tl::unexpected(named.error());
    // What a bad line has lost is asked for once more; a block that never comes is not waited for again and
    // again.
    silent = 0;
    wasSilent = {};
    const std::vector<MissingPart> lost = configuration.missing();
    for (const MissingPart &part : lost) {
        if (part.key.block < 0 || (part.why.code == ErrorCode::BoardError && !isPassing(part.why)))
            continue;
        if (silent == kSilentParts)
            break;
        if (const auto done = read(part.key); !done)
            return tl::unexpected(done.error());
    }
    // Each profile's PARAMS_3 ends with the number of the active one.
    for (int profile = 0; profile < kProfileCount; ++profile) {
        if (const QByteArray bytes = configuration.block({profile, Params3}); !bytes.isEmpty()) {
            configuration.setActiveProfile(
                std::clamp(int(static_cast<quint8>(bytes.back())), 0, kProfileCount - 1));
            return configuration;
        }
    }
    return tl::unexpected(configuration.findMissing({0, Params3})->why);
}

Result<void> Device::addProfileNames(Channel &channel, Configuration &configuration)
{
    if (m_isFirst)
        return {};
    auto names = readProfileNames(channel);
    if (!names && isUnanswered(names.error()))
        names = readProfileNames(channel);
    if (names)
        configuration.setProfileNames(*names);
    else if (isPartial(names.error()))
        configuration.addMissing({0, MissingPart::kProfileNames}, names.error());
    else
        return tl::unexpected(names.error());
    return {};
}

Result<QByteArray> Device::readBlock(Channel &channel, BlockKey key)
{
    return askBlock(channel, key, kRetries);
}

Result<QByteArray> Device::askBlock(Channel &channel, BlockKey key, int retries)
{
    const BlockSpec &block = kBlocks[key.block];
    const CommandId command = readCommand(key.block);
    Request request = key.block == AdjVarsCfg
        ? replyRequest(command, {}, command, block.size, kVersion)
        : replyRequest(command, ByteWriter().u8(key.profile).take(), command, block.size, kVersion,
                       [profile = key.profile](Bytes payload) {
                           return !payload.empty() && std::to_integer<int>(payload[0]) == profile;
                       });
    request.retries = retries;
    auto reply = channel.transact(request);
    for (int tries = 0; tries < retries && !reply && isPassing(reply.error()); ++tries) {
        if (const auto slept = channel.sleep(kBeforeAskingAgain); !slept)
            return tl::unexpected(slept.error());
        reply = channel.transact(request);
    }
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->payload.size() < block.size)
        return failure(ErrorCode::BadReply,
                       u"%1 with %2 bytes"_s.arg(request.name).arg(reply->payload.size()));
    return reply->payload;
}

Result<void> Device::writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes)
{
    Request request = confirmRequest(writeCommand(key.block), bytes, kVersion);
    request.timeout = kWriteTimeout;
    // Writing the same bytes again does no harm, so the command may be repeated if its confirmation is lost.
    request.idempotent = true;
    request.retries = 2;
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    return {};
}

int Device::profileOf(int menuCommand)
{
    const auto it = std::find(kProfileActions.begin(), kProfileActions.end(), menuCommand);
    return it == kProfileActions.end() ? -1 : int(it - kProfileActions.begin());
}

Result<void> Device::selectProfile(Channel &channel, int profile)
{
    if (profile < 0 || profile >= kProfileCount)
        return failure(ErrorCode::InvalidArgument, u"profile %1"_s.arg(profile + 1));
    const auto reply = channel.transact(confirmRequest(
        CommandId::ExecuteMenu, ByteWriter().u8(kProfileActions[std::size_t(profile)]).take(), kVersion));
    if (!reply && !isUntoldByAnswer(reply.error()))
        return tl::unexpected(reply.error());
    // The confirmation shows that the command was understood; telemetry shows whether it was carried out,
    // also where it was refused or its answer was lost.
    int used = -1;
    for (auto waited = 0ms; waited < kProfileSwitch; waited += milliseconds(kPauseBetweenLooks)) {
        const auto active = activeProfile(channel);
        if (!active)
            return tl::unexpected(reply ? active.error() : reply.error());
        if (*active == profile)
            return {};
        if (!reply)
            return tl::unexpected(reply.error());
        used = *active;
        if (const auto slept = channel.sleep(milliseconds(kPauseBetweenLooks)); !slept)
            return slept;
    }
    return failure(ErrorCode::NoEffect,
                   u"profile %1 was to be used, profile %2 is"_s.arg(profile + 1).arg(used + 1));
}

std::optional<bool> Device::areMotorsRunning(const Frame &frame)
{
    if (frame.id != number(CommandId::RealtimeData3) || frame.payload.size() <= kMotorFlagOffset)
        return {};
    return frame.payload[kMotorFlagOffset] & 1;
}

Result<int> Device::activeProfile(Channel &channel)
{
    const auto reply = channel.transact(statusRequest());
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->payload.size() <= kActiveProfileOffset)
        return failure(ErrorCode::BadReply, u"REALTIME_DATA_3"_s);
    return static_cast<quint8>(reply->payload[kActiveProfileOffset]);
}

Result<QStringList> Device::readProfileNames(Channel &channel)
{
    const auto reply
        = channel.transact(replyRequest(CommandId::ReadProfileNames, {}, CommandId::ReadProfileNames,
                                        kProfileCount * kProfileNameSize, kVersion));
    if (!reply)
        return tl::unexpected(reply.error());
    return decodeProfileNames(asBytes(reply->payload));
}

Result<void> Device::writeProfileNames(Channel &channel, const QStringList &names)
{
    Request request = confirmRequest(CommandId::WriteProfileNames, encodeProfileNames(names), kVersion);
    request.timeout = kWriteTimeout;
    request.idempotent = true;
    request.retries = 2;
    const auto reply = channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    return {};
}

Result<std::vector<AdjustableValue>> Device::readAdjustables(Channel &channel, const QList<int> &ids)
{
    std::vector<AdjustableValue> values;
    for (qsizetype first = 0; first < ids.size(); first += kAdjVarsPerCommand) {
        const QList<int> part = ids.mid(first, kAdjVarsPerCommand);
        ByteWriter writer;
        writer.u8(int(part.size()));
        for (const int id : part)
            writer.u8(id);
        const auto reply = channel.transact(replyRequest(
            CommandId::GetAdjVarsVal, writer.take(), CommandId::SetAdjVarsVal, 1 + 5 * int(part.size()),
            kVersion, [part](Bytes payload) { return areAmong(decodeAdjVars(payload), part); }));
        if (!reply)
            return tl::unexpected(reply.error());
        const auto decoded = decodeAdjVars(asBytes(reply->payload));
        if (!decoded)
            return tl::unexpected(decoded.error());
        for (const AdjVar &var : *decoded)
            values.push_back({var.id, double(var.value)});
    }
    return values;
}

// A confirmation proves nothing: what the board uses then does.
Result<void> Device::putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values)
{
    QList<int> ids;
    for (const AdjustableValue &value : values)
        ids.append(value.id);
    QStringList wrong;
    Result<void> sent;
    for (int attempt = 0; attempt <= kLiveRetries; ++attempt) {
        // Where the answer was lost, or refuses what was carried out, what is in use tells.
        sent = sendAdjustables(channel, values);
        const bool isRefused = !sent && sent.error().code == ErrorCode::BoardError;
        if (!sent && !isUntoldByAnswer(sent.error()))
            return sent;
        const auto back = readAdjustables(channel, ids);
        if (!back)
            return sent ? tl::unexpected(back.error()) : sent;
        wrong.clear();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double wanted = std::round(values[i].value);
            const auto found = std::find_if(back->begin(), back->end(), [&](const AdjustableValue &value) {
                return value.id == values[i].id;
            });
            if (found == back->end() || found->value != wanted)
                wrong += u"variable %1: %2 was written, %3 read"_s.arg(values[i].id)
                             .arg(wanted)
                             .arg(found == back->end() ? u"nothing"_s : QString::number(found->value));
        }
        if (wrong.isEmpty())
            return {};
        if (isRefused)
            return sent;
    }
    return failure(ErrorCode::NotInUse, wrong.join(u"; "));
}

std::vector<Request> Device::adjustableRequests(const std::vector<AdjustableValue> &values)
{
    std::vector<Request> requests;
    for (std::size_t first = 0; first < values.size(); first += kAdjVarsPerCommand) {
        std::vector<AdjVar> part;
        for (std::size_t i = first; i < std::min(values.size(), first + kAdjVarsPerCommand); ++i)
            part.push_back({values[i].id, static_cast<qint32>(std::llround(values[i].value))});
        Request request = confirmRequest(CommandId::SetAdjVarsVal, encodeAdjVars(part), kVersion);
        request.idempotent = true;
        request.retries = 1;
        requests.push_back(std::move(request));
    }
    return requests;
}

Result<void> Device::sendAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) const
{
    for (const Request &request : adjustableRequests(values)) {
        if (const auto reply = channel.transact(request); !reply)
            return tl::unexpected(reply.error());
    }
    return {};
}

std::span<const ActionSpec> Device::actions() const
{
    return m_actions;
}

std::vector<BoardFault> Device::faults(unsigned bits, unsigned detail) const
{
    return faultsOf(bits, detail);
}

bool Device::announcesReset(const FrameView &frame) const
{
    return frame.id == number(CommandId::Reset) && frame.payload.empty();
}

// A board that announces the restart itself does so a second ahead (document CMD_RESET).
std::optional<milliseconds> Device::ordersReset(QByteArrayView sent) const
{
    constexpr char kMenuReset = 7;
    constexpr milliseconds kAnnounced = 1000ms;
    static constexpr std::array kRestarting{2, 4, 5};  // kinds of calibration (errata 3.19)
    std::optional<milliseconds> after;
    Framer framer;
    framer.feed(asBytes(sent), [&after, kAnnounced](const FrameView &frame) {
        ByteReader reader(frame.payload);
        if (frame.id == number(CommandId::Reset)) {
            reader.skip(1);
            after = frame.payload.size() >= 3 ? milliseconds(reader.u16()) : 0ms;
        } else if (frame.id == number(CommandId::UseDefaults)
                   || (frame.id == number(CommandId::ExecuteMenu) && reader.u8() == kMenuReset)) {
            after = kAnnounced;
        } else if (frame.id == number(CommandId::CalibAcc) || frame.id == number(CommandId::CalibGyro)
                   || frame.id == number(CommandId::CalibMag)) {
            reader.skip(1);
            if (std::find(kRestarting.begin(), kRestarting.end(), reader.u8()) != kRestarting.end())
                after = kAnnounced;
        }
    });
    return after;
}

Request Device::harmlessQuestion() const
{
    return probeRequest();
}

StopPlan Device::stopPlan() const
{
    StopPlan plan;
    plan.means.push_back(
        {{confirmRequest(CommandId::MotorsOff, {}, kVersion), statusRequest(), statusRequest()}, 200ms, 5});
    // One answer may be an old one; and one that never changes, of a board that measures, is none at all. One
    // without its sensor measures nothing that would change.
    plan.fromAnswer = [before = QByteArray()](const Frame &frame) mutable {
        const auto running = areMotorsRunning(frame);
        if (!running)
            return Proof::Nothing;
        const QByteArray last = std::exchange(before, *running ? QByteArray() : frame.payload);
        const bool isSame = last == frame.payload && !isWithoutSensor(frame.payload);
        return *running ? Proof::Refuted : last.isEmpty() || isSame ? Proof::Nothing : Proof::Proven;
    };
    return plan;
}

Family family()
{
    Family family;
    family.key = u"simplebgc"_s;
    family.name = u"SimpleBGC 32-bit"_s;
    family.links = {{LinkAddress::Kind::Serial}, {LinkAddress::Kind::Tcp}};
    // Document "Message format": 10-20 ms between commands; CMD_CONTROL: 50 Hz or less.
    family.timing.pause = 10ms;
    family.timing.controlPeriod = 20ms;
    family.lines = lineCandidates();
    family.fullRate = 1250;  // a cycle of 0.8 ms
    family.makeFramer = [] { return std::make_unique<Framer>(); };
    family.makeDevice = [] { return std::make_unique<Device>(); };
    family.makeParameters = parametersOf;
    return family;
}

QString Device::storeAction() const
{
    return u"variables.save"_s;
}

}  // namespace simplebgc
