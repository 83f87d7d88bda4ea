// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The console's view of the messages.
#include "protocol/base/hexbytes.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/framer.h"

#include <QRegularExpression>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr qsizetype kLongestText = 200;
constexpr std::size_t kLongestHex = 64;

QString hexText(Bytes bytes)
{
    return QString::fromLatin1(toByteArray(bytes).toHex(' '));
}

QString fieldsText(std::span<const FieldSpec> fields, Bytes payload, int stickBytes)
{
    QStringList parts;
    for (const FieldValue &value : decodeFields(fields, payload, stickBytes)) {
        const QString name = QString::fromUtf8(value.spec->name);
        const QString unit = QString::fromUtf8(value.spec->unit);
        QString text;
        switch (value.spec->type) {
        case FieldType::Text:
            text = QString::fromUtf8(value.bytes.left(kLongestText)).simplified();
            if (value.bytes.size() > kLongestText)
                text += u"… (%1 bytes)"_s.arg(value.bytes.size());
            break;
        case FieldType::Sticks:
        case FieldType::Rest: text = QString::fromLatin1(value.bytes.left(kLongestText).toHex(' ')); break;
        case FieldType::Floats:
        case FieldType::Bins:
        case FieldType::Powers: {
            QStringList numbers;
            for (const float number : value.numbers)
                numbers.append(QString::number(double(number), 'g', 6));
            text = numbers.size() > 8 ? u"%1 values"_s.arg(numbers.size()) : numbers.join(u' ');
            break;
        }
        case FieldType::F32: text = plainNumber(double(float(value.number))); break;
        default: text = QString::number(qint64(value.number)); break;
        }
        parts.append(unit.isEmpty() ? name + u' ' + text : name + u' ' + text + u' ' + unit);
    }
    return parts.join(u", "_s);
}

// What a message may do when it is typed. What steers is refused altogether.
ActionRisk riskOf(Message id)
{
    switch (id) {
    case Message::Status:
    case Message::Ping:
    case Message::Telemetry:
    case Message::ResetMotors: return ActionRisk::Safe;
    case Message::MotorTest:
    case Message::MotorsBeep:
    case Message::CalibrateEscs: return ActionRisk::Destroys;
    case Message::SetConfigFile:
    case Message::UploadInit:
    case Message::UploadData:
    case Message::UploadProcess: return ActionRisk::Destroys;
    default: break;
    }
    const MessageSpec *spec = findMessage(id);
    const bool isQuestion = spec && spec->fromGround && spec->fromGround->empty() && spec->fromDrone
        && id < Message::VideoPause;
    return isQuestion ? ActionRisk::Safe : ActionRisk::Writes;
}

// Of uploads one wrong byte is a burst of commands, and what makes it deaf is waited for.
bool isTyped(const MessageSpec &message, Generation generation)
{
    const Message id = message.id;
    const bool uploads
        = id == Message::SetConfigFile || (id >= Message::UploadInit && id <= Message::UploadProcess);
    const bool isDeaf = id == Message::MotorTest || id == Message::CalibrateEscs;
    const bool mayBe = message.maySend != MaySend::Never && message.maySend != MaySend::Steering;
    return mayBe && id != Message::Ack && !uploads && !isDeaf && generation >= message.askedSince
        && wireId(id, generation) >= 0;
}

QString withNote(const MessageSpec &message, const QString &fields)
{
    const QString note = QLatin1String(message.note);
    return note.isEmpty() ? fields : fields.isEmpty() ? u"(%1)"_s.arg(note) : u"%1 (%2)"_s.arg(fields, note);
}

// What somebody would type for it: its name and its numbers. Nothing may stand behind one message, which the
// drone would take for others. Empty: it is not that.
QStringList wordsOf(const QByteArray &bytes, Generation generation)
{
    const auto front = readId(asBytes(bytes));
    const auto id = front ? groundMessage(front->wire, generation) : std::nullopt;
    const MessageSpec *spec = id ? findMessage(*id) : nullptr;
    if (!spec || !spec->fromGround)
        return {};
    const Bytes payload = asBytes(bytes).subspan(front->size);
    if (payloadSize(*spec->fromGround, payload, Controls::size(generation)) != payload.size())
        return {};
    QStringList words{QString::fromLatin1(spec->name)};
    for (const FieldValue &value : decodeFields(*spec->fromGround, payload))
        words.append(QString::number(value.number, 'g', std::numeric_limits<double>::max_digits10));
    return words;
}

}  // namespace

FrameText Device::describeFrame(const FrameView &frame, bool fromBoard) const
{
    if (frame.id == kDiscarded) {
        const QString bytes
            = hexText(frame.payload.first(std::min<std::size_t>(frame.payload.size(), kLongestHex)));
        const auto front = readId(frame.payload);
        const MessageSpec *dead = front ? findMessage(Message(front->wire)) : nullptr;
        if (!dead || dead->fromDrone || dead->fromGround)
            return {u"?"_s, bytes};
        return {QString::fromLatin1(dead->name), withNote(*dead, bytes)};
    }
    if (frame.id >= int(Message::Ack) && frame.id < int(Message::Ack) + 0x80)
        return {u"ACK_ID"_s, u"number %1"_s.arg(frame.id - int(Message::Ack))};
    const MessageSpec *spec = findMessage(Message(frame.id));
    const auto &fields = spec ? (fromBoard ? spec->fromDrone : spec->fromGround)
                              : std::optional<std::span<const FieldSpec>>();
    if (!fields)
        return {spec ? QString::fromLatin1(spec->name) : u"?"_s, hexText(frame.payload)};
    return {QString::fromLatin1(spec->name),
            withNote(*spec, fieldsText(*fields, frame.payload, Controls::size(m_generation)))};
}

// What is sent is a list of messages as well, in the ground's own forms.
FrameText Device::describeSent(QByteArrayView bytes) const
{
    QStringList names;
    QStringList texts;
    Bytes rest = asBytes(bytes);
    while (!rest.empty()) {
        const auto front = readId(rest);
        if (!front)
            break;
        const auto id
            = groundMessage(front->wire, m_generation == Generation::Unknown ? Generation::G : m_generation);
        const MessageSpec *spec = id ? findMessage(*id) : nullptr;
        if (!spec || !spec->fromGround) {
            names.append(u"?"_s);
            texts.append(hexText(rest));
            break;
        }
        rest = rest.subspan(front->size);
        const int sticks = Controls::size(m_generation);
        const std::size_t size
            = std::min(payloadSize(*spec->fromGround, rest, sticks).value_or(rest.size()), rest.size());
        names.append(QString::fromLatin1(spec->name));
        const QString text = withNote(*spec, fieldsText(*spec->fromGround, rest.first(size), sticks));
        if (!text.isEmpty())
            texts.append(text);
        rest = rest.subspan(size);
    }
    return {names.join(u" + "_s), texts.join(u" + "_s)};
}

bool Device::isTelemetryFrame(int id) const
{
    const auto message = Message(id);
    const MessageSpec *spec = findMessage(message);
    return (spec && spec->isStreamed) || message == Message::Status || message == Message::Telemetry
        || message == Message::Ping;
}

Result<RawCommand> Device::parseCommand(const QString &text) const
{
    const auto whole = bytesFromHex(text.trimmed());
    const QStringList words
        = whole ? wordsOf(*whole, m_generation) : text.simplified().split(u' ', Qt::SkipEmptyParts);
    if (words.isEmpty())
        return failure(ErrorCode::InvalidArgument,
                       whole ? u"these bytes are not one whole message"_s : u"nothing to send"_s);
    const MessageSpec *spec = findMessage(words.front());
    if (!spec)
        return failure(ErrorCode::InvalidArgument, u"there is no message '%1'"_s.arg(words.front()));
    if (spec->maySend == MaySend::Never && *spec->note)
        return failure(ErrorCode::InvalidArgument,
                       u"%1 is not sent from here: %2"_s.arg(words.front(), QLatin1String(spec->note)));
    if (!isTyped(*spec, m_generation))
        return failure(ErrorCode::InvalidArgument, u"%1 is not sent from here"_s.arg(words.front()));
    std::vector<double> numbers;
    for (const QString &word : words.mid(1)) {
        bool ok = false;
        const double number = word.toDouble(&ok);
        if (!ok)
            return failure(ErrorCode::InvalidArgument, u"'%1' is no number"_s.arg(word));
        numbers.push_back(number);
    }
    const auto payload = encodeFields(*spec->fromGround, numbers);
    if (!payload)
        return tl::unexpected(payload.error());
    return RawCommand{QString::fromLatin1(spec->name), encode(spec->id, *payload, m_generation),
                      riskOf(spec->id)};
}

QStringList Device::commandNames() const
{
    QStringList names;
    for (const MessageSpec &message : messages()) {
        if (isTyped(message, m_generation))
            names.append(QString::fromLatin1(message.name));
    }
    return names;
}

}  // namespace bcflight
