// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/device.h"

#include "protocol/base/checksum.h"
#include "protocol/session/channel.h"
#include "protocol/storm32/files.h"
#include "protocol/storm32/framer.h"
#include "protocol/storm32/look.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/scriptlanguage.h"

#include <QCoreApplication>

#include <algorithm>
#include <atomic>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr auto kAnswer
    = 300ms;  // errata 7: the original tool waits 160 ms for the first byte, more on Bluetooth
constexpr auto kBeat = 1100ms;
constexpr auto kStoring = 2s;  // up to about 1 s on hardware
constexpr int kRetries = 2;
constexpr int kRetriesOfLong = 5;  // a bad line is more likely to hit a long frame than a short one
constexpr qsizetype kLong = 100;  // bytes
// Our own address on MAVLink: that of the errata's examples.
constexpr mavlink::Address kOwn{82, 67};
const QString kNoScripts = u"scripts cannot be read while the heartbeat is on"_s;
constexpr int kDefaultAddress = 71 << 8 | 67;  // errata 6

bool isStoring(Simple id)
{
    return id == Simple::Store || id == Simple::EraseEeprom || id == Simple::SetName
        || id == Simple::SetBaudRate || id == Simple::WriteCalibration || id == Simple::NormalMotors;
}

// Commands that can safely be repeated are asked again if the answer is lost.
bool isRepeatable(Simple id)
{
    switch (id) {
    case Simple::Test:
    case Simple::Version:
    case Simple::GetParameters:
    case Simple::PutParameters:
    case Simple::Store:
    case Simple::Retrieve:
    case Simple::LiveData:
    case Simple::Status:
    case Simple::ReadCalibration:
    case Simple::RawSensors: return true;
    default: return false;
    }
}

bool isRepeatable(Rc id)
{
    return id != Rc::DoCamera && id != Rc::SetScriptControl;
}

// 79 is "0.79", 200 is "2.00".
QString firmwareText(int number)
{
    return u"%1.%2"_s.arg(number / 100).arg(number % 100, 2, 10, QChar(u'0'));
}

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &identity)
{
    const int layout = identity.firmwareNumber;
    if (!isKnownLayout(layout))
        return std::make_shared<ParameterSet>(rawRows(layout), blocksOf(layout), layout,
                                              identity.capabilities);
    return std::make_shared<ParameterSet>(parameterRows(), blocksOf(layout), layout, identity.capabilities);
}

}  // namespace

Device::Device() = default;
Device::~Device() = default;

// The same request through MAVLink: simple commands unchanged, RC commands without length and checksum
// (errata 6).
Request Device::embed(int way, const Request &plain, QByteArrayView content, std::optional<Simple> id)
{
    const mavlink::Message *message
        = mavlink::findMessage(mavlink::number(mavlink::MessageId::TargetSpecific));
    // clang-format off
    const auto payload = mavlink::encodeFields(*message, {{u"target_system"_s, way >> 8 & 0xFF}, {u"target_component"_s, way & 0xFF},
                                                          {u"specific_payload"_s, content.toByteArray()}});
    Request request = plain;
    request.bytes = mavlink::encode(mavlink::MessageId::TargetSpecific, payload.value_or(QByteArray()), kOwn, 0);
    request.replyBytes += int(mavlink::kOverhead) + 2;
    request.answer = [answer = plain.answer, id](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id != FrameId::kMavlink + mavlink::number(mavlink::MessageId::TargetSpecificAck) || frame.payload.size() < 3)
            return {};
        // clang-format on
        const Bytes inner = frame.payload.subspan(2);
        if (inner[0] == std::byte{0xFB} && inner.size() >= 2)
            return answer({FrameId::kRc + std::to_integer<int>(inner[1]), inner.subspan(2)});
        if (inner.size() == 1)
            return answer({FrameId::kLetter + std::to_integer<int>(inner[0]), {}});
        if (!id || inner.size() < 4 || inner.back() != std::byte{'o'}
            || crc16Mcrf4xx(inner.first(inner.size() - 1)) != 0)
            return {};
        return answer({FrameId::kSimple + int(*id), inner.first(inner.size() - 3)});
    };
    return request;
}

Request Device::simple(Simple id, QByteArrayView arguments) const
{
    Request request = simpleRequest(id, arguments);
    request.timeout = isStoring(id) ? milliseconds(kStoring) : milliseconds(kAnswer);
    request.idempotent = isRepeatable(id);
    request.retries
        = std::max<qsizetype>(request.bytes.size(), request.replyBytes) > kLong ? kRetriesOfLong : kRetries;
    return isEmbedded() ? embed(m_way, request, request.bytes, id) : request;
}

Request Device::rc(Rc id, const QByteArray &payload) const
{
    return rcAt(m_way, id, payload);
}

Request Device::rcAt(int way, Rc id, const QByteArray &payload)
{
    Request request = rcRequest(id, payload);
    request.timeout = kAnswer;
    request.idempotent = isRepeatable(id);
    request.retries = kRetries;
    return way == kPlain ? request
                         : embed(way, request, ByteWriter().u8(0xFA).u8(int(id)).bytes(payload).take(), {});
}

// First plainly, then in the way that works while a heartbeat is on. Neither harms a board of another family:
// SimpleBGC ignores bytes that do not start one of its own frames.
Result<bool> Device::probe(Channel &channel)
{
    // A board with unusual numbers reports them in its heartbeat, which may be received on another thread.
    const auto heard = std::make_shared<std::atomic<int>>(-1);
    const auto beats = channel.listen([heard](const FrameView &frame) {
        if (frame.id != FrameId::kMavlink || frame.raw.size() < mavlink::kOverhead)
            return false;
        *heard = std::to_integer<int>(frame.raw[3]) << 8 | std::to_integer<int>(frame.raw[4]);
        return true;
    });
    const auto answers = [&](int retries) -> Result<bool> {
        Request request = simple(Simple::Test);
        request.retries = retries;
        const auto reply = channel.transact(request);
        if (reply)
            return true;
        const ErrorCode code = reply.error().code;
        if (code == ErrorCode::Timeout || code == ErrorCode::BoardError || code == ErrorCode::Damaged
            || code == ErrorCode::Unsupported)
            return false;
        return tl::unexpected(reply.error());
    };
    m_way = kPlain;
    auto found = answers(1);
    if (!found || *found)
        return found;
    m_way = kDefaultAddress;
    found = answers(0);
    if (!found || *found)
        return found;
    // Something is sending: a board does so unasked once a second.
    if (*heard < 0 && channel.observation().bytesIn > 0) {
        if (const auto beat = beats->next(kBeat); !beat && beat.error().code != ErrorCode::Timeout)
            return tl::unexpected(beat.error());
    }
    // What speaks is there: one lost frame is no reason to think otherwise.
    if (const int address = *heard; address >= 0) {
        m_way = address;
        found = answers(kRetries);
        if (!found || *found)
            return found;
    }
    m_way = kPlain;
    return false;
}

Result<BoardIdentity> Device::identify(Channel &channel)
{
    auto reply = channel.transact(simple(Simple::Version));
    if (!reply && reply.error().code == ErrorCode::Timeout && !isEmbedded()) {
        m_way = kDefaultAddress;  // not probed yet on a link without a rate
        reply = channel.transact(simple(Simple::Version));
    }
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->payload.size() != 54)
        return failure(ErrorCode::BadReply, u"v: %1 bytes"_s.arg(reply->payload.size()));
    ByteReader numbers(QByteArrayView(reply->payload).sliced(48));
    m_firmware = numbers.u16();
    const int layout = numbers.u16();
    const int capabilities = numbers.u16();

    BoardIdentity identity;
    identity.family = u"storm32"_s;
    identity.firmware = firmwareText(m_firmware);
    identity.firmwareNumber = layout;  // the tables depend on the layout
    describeLook(identity, reply->payload);
    identity.profileCount = 1;
    identity.writable = isKnownLayout(layout);
    identity.extra.insert(u"layout"_s, layout);
    identity.extra.insert(u"firmware"_s, m_firmware);
    identity.extra.insert(u"embedded"_s, isEmbedded());
    static constexpr std::array<std::pair<int, const char *>, 8> kCapabilities{{
        {0x0100, "battery"},
        {0x0200, "on-board-imu"},
        {0x0400, "i2c2"},
        {0x0800, "rc2"},
        {0x1000, "spektrum"},
        {0x2000, "sbus"},
        {0x4000, "ir-camera"},
        {0x8000, "aux"},
    }};
    for (const auto &[bit, key] : kCapabilities) {
        if (capabilities & bit)
            identity.capabilities.insert(QString::fromLatin1(key));
    }
    m_identity = identity;
    m_words = wordsOf(layout);
    m_parameters = parametersOf(identity);
    m_history = std::make_shared<PanHistory>();
    constexpr std::array kShifting{"rc.roll.offset", "rc.pitch.offset", "rc.yaw.offset", "pan.mode.default"};
    for (std::size_t i = 0; i < kShifting.size(); ++i) {
        const ParameterSpec *spec = m_parameters->find(QString::fromLatin1(kShifting[i]));
        m_shiftWords[i] = spec ? spec->offset / 2 : -1;
    }
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

Result<int> Device::readWord(Channel &channel, int word)
{
    const auto reply = channel.transact(rc(Rc::GetParameter, ByteWriter().u16(word).take()));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(reply->payload);
    if (reader.u16() != word)
        return failure(ErrorCode::BadReply, u"another parameter than %1"_s.arg(word));
    const int raw = reader.u16();
    learnShift(word, raw);
    return raw;
}

// The firmware accepts these frames regardless of their checksum (errata 4), so a value only counts as
// written once it reads back.
Result<void> Device::writeWord(Channel &channel, int word, int raw)
{
    const int wanted = raw & 0xFFFF;
    const bool isAddress = word == kSystemWord || word == kSystemWord + 1;
    int found = -1;
    for (int attempt = 0; attempt <= kRetries; ++attempt) {
        const auto reply = channel.transact(rc(Rc::SetParameter, ByteWriter().u16(word).u16(wanted).take()));
        // Where only the answer was lost, what is in use tells.
        if (!reply && (isAddress || reply.error().code != ErrorCode::Timeout))
            return tl::unexpected(reply.error());
        learnAddressWord(word, wanted);
        if (const auto way = word == kHeartbeatWord ? findWay(channel, raw) : Result<void>(); !way)
            return way;
        const auto back = readWord(channel, word);
        if (!back)
            return tl::unexpected(reply ? back.error() : reply.error());
        if (*back == wanted)
            return {};
        found = *back;
    }
    return failure(ErrorCode::VerifyFailed,
                   u"word %1: %2 was written, %3 read"_s.arg(word).arg(wanted).arg(found));
}

// Writing the heartbeat's word locks plain commands out of a UART at once, or allows them again (errata 6).
// USB always answers everything, so the way is tried rather than deduced.
Result<void> Device::findWay(Channel &channel, int heartbeat)
{
    const auto answers = [&] {
        Request request = simple(Simple::Test);
        request.retries = 1;
        return channel.transact(request).map([](const Frame &) {});
    };
    const int before = m_way;
    m_way = kPlain;
    auto found = answers();
    if (found || heartbeat == 0 || found.error().code != ErrorCode::Timeout)
        return found;
    m_way = before == kPlain ? m_address : before;
    return answers();
}

// Words and, if available, scripts. An embedded `g` does not fit into a frame: MAVLink's own list is used
// instead.
Result<QByteArray> Device::readStream(Channel &channel)
{
    if (!isEmbedded()) {
        const auto reply = channel.transact(simple(Simple::GetParameters));
        if (!reply)
            return tl::unexpected(reply.error());
        QByteArray stream = reply->payload;
        takeIn(stream);
        return stream;
    }
    const auto listed = listParameters(channel);
    if (!listed)
        return tl::unexpected(listed.error());
    QByteArray words;
    Progress progress;
    progress.step = u"read-block"_s;
    progress.subject = u"PARAMETERS"_s;
    progress.total = m_words;
    for (int word = 0; word < m_words; ++word) {
        const auto known = listed->find(word);
        const auto raw = known != listed->end() ? Result<int>(known->second)
                                                : readWord(channel, word);  // what the list has lost
        if (!raw)
            return tl::unexpected(raw.error());
        words += ByteWriter().u16(*raw).take();
        progress.done = word + 1;
        channel.progress(progress);
    }
    takeIn(words);
    return words;
}

void Device::takeIn(QByteArray &words)
{
    m_stop->correct(words);
    for (const int word : m_shiftWords) {
        if (word >= 0 && 2 * word + 2 <= words.size())
            learnShift(word, ByteReader(QByteArrayView(words).sliced(2 * word, 2)).u16());
    }
}

// All parameters in one go, as far as they arrive; the coding of the values depends on the firmware (errata
// 6).
Result<std::map<int, int>> Device::listParameters(Channel &channel)
{
    std::map<int, int> words;
    const auto coding = m_firmware >= 91 ? mavlink::ValueCoding::Bits : mavlink::ValueCoding::Number;
    const mavlink::Message *value = mavlink::findMessage(mavlink::number(mavlink::MessageId::ParamValue));
    const auto values = channel.listen([](const FrameView &frame) {
        return frame.id == FrameId::kMavlink + mavlink::number(mavlink::MessageId::ParamValue);
    });
    const mavlink::Message *list
        = mavlink::findMessage(mavlink::number(mavlink::MessageId::ParamRequestList));
    const auto payload = mavlink::encodeFields(
        *list, {{u"target_system"_s, m_way >> 8 & 0xFF}, {u"target_component"_s, m_way & 0xFF}});
    Request request;
    request.name = u"PARAM_REQUEST_LIST"_s;
    request.bytes
        = mavlink::encode(mavlink::MessageId::ParamRequestList, payload.value_or(QByteArray()), kOwn, 0);
    channel.post(request);
    while (int(words.size()) < m_words) {
        const auto frame = values->next(kAnswer);
        if (!frame && frame.error().code == ErrorCode::Timeout)
            break;
        if (!frame)
            return tl::unexpected(frame.error());
        const auto fields = mavlink::decodeFields(*value, asBytes(frame->payload));
        if (!fields)
            continue;
        const int index = fields->value(u"param_index"_s).toInt();
        if (index >= 0 && index < m_words)
            words[index] = mavlink::decodeValue(fields->value(u"param_value"_s).toFloat(), coding) & 0xFFFF;
    }
    return words;
}

Result<Configuration> Device::readConfiguration(Channel &channel)
{
    Progress progress;
    progress.step = u"read-block"_s;
    progress.subject = u"PARAMETERS"_s;
    progress.total = 1;
    channel.progress(progress);
    const auto stream = readStream(channel);
    if (!stream)
        return tl::unexpected(stream.error());
    Configuration configuration = configurationOf(*stream);
    if (isEmbedded())
        configuration.addMissing({0, Scripts}, {ErrorCode::Unsupported, kNoScripts, 0});
    learnAddress(*stream);
    if (configuration.blocks().empty())
        return failure(ErrorCode::BadReply, u"g: %1 bytes"_s.arg(stream->size()));
    return configuration;
}

Result<QByteArray> Device::readBlock(Channel &channel, BlockKey key)
{
    const auto stream = readStream(channel);
    if (!stream)
        return tl::unexpected(stream.error());
    for (const auto &[block, bytes] : splitStream(*stream, m_words)) {
        if (block == key.block)
            return bytes;
    }
    return failure(ErrorCode::Unsupported, kNoScripts);
}

Result<void> Device::writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes)
{
    // Everything that is not ours is written back unchanged: read, overlay, write (errata 3.4).
    auto stream = readStream(channel);
    if (!stream)
        return tl::unexpected(stream.error());
    const qsizetype at = key.block == Parameters ? 0 : 2 * m_words;
    if (at + bytes.size() > stream->size())
        return failure(ErrorCode::Unsupported, u"scripts cannot be written while the heartbeat is on"_s);
    if (isEmbedded()) {
        for (int word = 0; word < int(bytes.size()) / 2; ++word) {  // parameters only
            if (stream->mid(2 * word, 2) == bytes.mid(2 * word, 2))
                continue;
            const auto done
                = writeWord(channel, word, ByteReader(QByteArrayView(bytes).sliced(2 * word, 2)).u16());
            if (!done)
                return done;
        }
        return {};
    }
    const QByteArray before = *stream;
    stream->replace(at, bytes.size(), bytes);
    const auto reply = channel.transact(simple(Simple::PutParameters, *stream));
    if (!reply)
        return tl::unexpected(reply.error());
    learnAddress(*stream);
    if (before.mid(2 * kHeartbeatWord, 2) == stream->mid(2 * kHeartbeatWord, 2))
        return {};
    return findWay(channel, ByteReader(QByteArrayView(*stream).sliced(2 * kHeartbeatWord, 2)).u16());
}

Result<void> Device::endWrite(Channel &channel)
{
    if (const auto free = checkNotStopping(); !free)
        return free;
    const auto reply = channel.transact(simple(Simple::Store));
    if (!reply)
        return tl::unexpected(reply.error());
    return {};
}

std::optional<ConnectOffer> Device::connectOffer() const
{
    if (!isEmbedded())
        return {};
    return ConnectOffer{
        QT_TRANSLATE_NOOP(
            "Tables",
            "This board sends a MAVLink heartbeat and therefore answers no plain commands on "
            "this port. It is reached through MAVLink: that is slower, and scripts cannot be read."),
        QT_TRANSLATE_NOOP("Tables", "Switch the heartbeat off"), "heartbeat.off"};
}

namespace {

// MAVLink frames are recognised by their structure: two in succession of one sender. Noise has all the rest.
bool looksLikeMavlink(const QByteArray &bytes)
{
    for (qsizetype i = 0; i + 8 < bytes.size(); ++i) {
        const auto at = [&](qsizetype k) { return static_cast<unsigned char>(bytes[k]); };
        if (at(i) != 0xFE && at(i) != 0xFD)
            continue;
        const qsizetype sender = at(i) == 0xFE ? 3 : 5;
        const qsizetype next = i + (at(i) == 0xFE ? 8 : 12) + at(i + 1);
        if (next + sender + 1 < bytes.size() && at(next) == at(i) && at(next + sender) == at(i + sender)
            && at(next + sender + 1) == at(i + sender + 1))
            return true;
    }
    return false;
}

// A board answers each unknown byte with the letter e, and incomplete commands with t (errata 3.1). Among
// bytes received at wrong rates, a run of them is enough.
QString recognise(const QByteArray &bytes)
{
    if (looksLikeMavlink(bytes))
        return u"MAVLink"_s;
    constexpr int kRun = 5;
    const auto isAnswer
        = [](char letter) { return letter == 'e' || letter == 't' || letter == 'o' || letter == 'c'; };
    int run = 0;
    int longest = 0;
    for (const char letter : bytes) {
        run = isAnswer(letter) ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    return longest >= kRun || (longest >= 3 && longest == bytes.size()) ? u"STorM32"_s : QString();
}

// Errata 9.1.
class PidGainShape final : public GainShape
{
public:
    [[nodiscard]] PidShape shapeOf(const PidGains &gains) const override { return ::shapeOf(gains); }
    [[nodiscard]] PidGains gainsFor(double damping, double stability) const override
    {
        return ::gainsFor(damping, stability);
    }
    [[nodiscard]] std::pair<double, double> slidersFor(const PidGains &gains) const override
    {
        return ::slidersFor(gains);
    }
};

}  // namespace

std::shared_ptr<const GainShape> Device::gainShape() const
{
    return std::make_shared<PidGainShape>();
}

Family family()
{
    Family family;
    family.key = u"storm32"_s;
    family.name = u"STorM32"_s;
    family.links = {{LinkAddress::Kind::Serial}, {LinkAddress::Kind::Tcp}};
    // Errata 7: one command at a time, answered within 1 to 5 ms; twice that for commands without an answer.
    family.timing.pause = 10ms;
    family.timing.controlPeriod = 20ms;
    // Errata 1: no parity, and the board does not detect the rate; the default comes first.
    for (const int baud : {115200, 57600, 38400, 19200, 9600})
        family.lines.append({baud, Parity::None});
    family.makeFramer = [] { return std::make_unique<Framer>(); };
    family.makeDevice = [] { return std::make_unique<Device>(); };
    family.makeParameters = parametersOf;
    family.recognise = recognise;
    family.scripts = scriptLanguage();
    family.settingsFile = ForeignFile{u"cfg"_s, u"STorM32 settings"_s, readSettings, writeSettings};
    family.calibrationFile
        = CalibrationFile{u"cal"_s, u"STorM32 calibration"_s, readCalibration, writeCalibration};
    return family;
}

}  // namespace storm32
