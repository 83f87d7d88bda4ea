// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera of a drone can be told (errata 6.5).
#include "protocol/bcflight/device.h"
#include "protocol/session/channel.h"

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr std::array kPictureSteps{Message::BrightnessUp, Message::BrightnessDown, Message::ContrastUp,
                                   Message::ContrastDown, Message::SaturationUp,   Message::SaturationDown,
                                   Message::IsoUp,        Message::IsoDown,        Message::ShutterUp,
                                   Message::ShutterDown};
constexpr int kLensRepeats = 4;  // nothing answers it
constexpr auto kLensPause = 20ms;

// The drone answers in text; what it leaves open ends with a zero.
QString cameraWord(const Frame &frame)
{
    return QString::fromUtf8(frame.payload.left(frame.payload.indexOf('\0')));
}

QVariant firstNumber(Message id, const Frame &frame)
{
    const auto values = decodeFields(*findMessage(id)->fromDrone, asBytes(frame.payload));
    return values.empty() ? QVariant() : QVariant(int(values.front().number));
}

Error withoutCamera(const Error &error)
{
    return error.code == ErrorCode::Timeout ? Error{ErrorCode::Unsupported, u"no camera answers"_s, 0}
                                            : error;
}

}  // namespace

Result<ActionReply> Device::performCamera(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    const auto is = [&key](const char *name) { return key == QLatin1String(name); };
    const bool on = arguments.value(u"on"_s).toBool();
    const auto send = [&channel](const Request &request) {
        return channel.transact(request).map([](const Frame &) { return ActionReply(); });
    };
    if (is("camera"))
        return tellCamera(channel);
    if (is("camera.step"))
        return send(order(kPictureSteps[std::size_t(arguments.value(u"step"_s).toInt())]));
    if (is("camera.record"))
        return send(ask(on ? Message::VideoStartRecord : Message::VideoStopRecord));
    if (is("camera.picture"))
        return send(order(Message::VideoTakePicture));
    if (is("camera.night"))
        return send(ask(Message::VideoNightMode, bigU32(on ? 1 : 0)));
    if (is("camera.white_balance"))
        return switchCamera(channel, Message::WhiteBalance, u"white_balance"_s);
    if (is("camera.lock"))
        return switchCamera(channel, Message::LockWhiteBalance, u"white_balance"_s);
    if (is("camera.exposure"))
        return switchCamera(channel, Message::ExposureMode, u"exposure"_s);
    if (is("camera.lens"))
        return tellLens(channel);
    if (is("camera.lens.set"))
        return setLens(channel, arguments);
    return failure(ErrorCode::Unsupported, key);
}

Request Device::acknowledgement(int number) const
{
    Request echo = ask(Message::Status);
    echo.name = u"ACK_ID"_s;
    echo.bytes = encodeAck(number);
    echo.answer = [number](const FrameView &frame) -> std::optional<Result<Frame>> {
        return frame.id == int(Message::Ack) + number ? std::optional(Result<Frame>(Frame(frame)))
                                                      : std::nullopt;
    };
    return echo;
}

// What it heard last from whomever is not known, so the first one of a link is a number of its own.
Result<Request> Device::once(Channel &channel, Request request)
{
    if (m_operation == 0) {
        if (const auto heard = channel.transact(acknowledgement(1)); !heard)
            return tl::unexpected(heard.error());
        m_operation = 1;
    }
    constexpr int kLastOperation = 126;
    m_operation = m_operation == kLastOperation ? 1 : m_operation + 1;
    request.bytes.prepend(encodeAck(m_operation));
    return request;
}

// Each of these switches to the next one; repeated under its number it only tells (errata 5). A drone without
// a camera says so.
Result<ActionReply> Device::switchCamera(Channel &channel, Message id, const QString &figure)
{
    const auto request = once(channel, ask(id));
    if (!request)
        return tl::unexpected(request.error());
    const auto reply = channel.transact(*request);
    if (!reply && reply.error().code == ErrorCode::Timeout)
        return failure(ErrorCode::NotProven,
                       u"no answer came; whether the camera has switched is not known"_s);
    if (!reply)
        return tl::unexpected(reply.error());
    const QString word = cameraWord(*reply);
    if (word == u"(none)"_s)
        return failure(ErrorCode::Unsupported, u"the drone has no camera"_s);
    return ActionReply{{figure, word}};
}

// Without a camera it says nothing to these.
Result<ActionReply> Device::tellCamera(Channel &channel)
{
    const auto iso = channel.transact(ask(Message::Iso));
    if (!iso)
        return tl::unexpected(withoutCamera(iso.error()));
    ActionReply told{{u"iso"_s, firstNumber(Message::Iso, *iso)}};
    if (const auto shutter = channel.transact(ask(Message::ShutterSpeed)))
        told.insert(u"shutter"_s, firstNumber(Message::ShutterSpeed, *shutter));
    return told;
}

Result<ActionReply> Device::tellLens(Channel &channel)
{
    const auto reply = channel.transact(ask(Message::LensShader));
    if (!reply)
        return tl::unexpected(withoutCamera(reply.error()));
    ActionReply told;
    for (const FieldValue &value :
         decodeFields(*findMessage(Message::LensShader)->fromDrone, asBytes(reply->payload)))
        told.insert(QLatin1String(value.spec->name), int(value.number));
    return told;
}

Result<ActionReply> Device::setLens(Channel &channel, const QVariantMap &arguments)
{
    const auto fields = *findMessage(Message::SetLensShader)->fromGround;
    std::vector<double> numbers;
    for (const FieldSpec &field : fields)
        numbers.push_back(arguments.value(QLatin1String(field.name)).toDouble());
    const auto payload = encodeFields(fields, numbers);
    if (!payload)
        return tl::unexpected(payload.error());
    for (int i = 0; i < kLensRepeats; ++i) {
        channel.post(order(Message::SetLensShader, *payload));
        if (const auto slept = channel.sleep(kLensPause); !slept)
            return tl::unexpected(slept.error());
    }
    return ActionReply();
}

}  // namespace bcflight
