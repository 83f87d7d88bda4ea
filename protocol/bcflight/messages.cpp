// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/messages.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

using enum FieldType;
using Fields = std::span<const FieldSpec>;

constexpr Fields kNone{};

// clang-format off
constexpr FieldSpec kPing[] = {{"tick", U16, "ms"}, {"rtt", U16, "ms"}};
constexpr FieldSpec kStatus[] = {{"bits", U32}};
constexpr FieldSpec kTelemetry[] = {
    {"voltage", LeU16, "0.01 V"}, {"charge", LeU16, "mAh"}, {"current", U8, "0.1 A"}, {"level", S8, "%"}, {"cpu.load", U8, "%"},
    {"cpu.temperature", U8, "°C"}, {"rx.quality", S8, "%"}, {"rx.level", S8, "dBm"}};
constexpr FieldSpec kControls[] = {{"sticks", Sticks}};
constexpr FieldSpec kCalibrate[] = {{"full", U32, "", 0, 1}, {"altitude", F32, "m", -500, 10000}};
constexpr FieldSpec kCode[] = {{"code", U32}};
constexpr FieldSpec kTime[] = {{"time", U32, "s"}};
constexpr FieldSpec kZero[] = {{"value", U32, "", 0, 0}};
constexpr FieldSpec kSwitch[] = {{"on", U32, "", 0, 1}};
constexpr FieldSpec kText[] = {{"text", Text}};
constexpr FieldSpec kCheckedText[] = {{"crc", U32}, {"text", Text}};
constexpr FieldSpec kChunk[] = {{"crc", U32}, {"offset", U32}, {"offset.again", U32}, {"size", U32}, {"size.again", U32}, {"data", Rest}};
constexpr FieldSpec kCrc[] = {{"crc", U32}};
constexpr FieldSpec kAngles[] = {{"roll", F32, "°"}, {"pitch", F32, "°"}, {"yaw", F32, "°"}};
constexpr FieldSpec kRates[] = {{"roll", F32, "°/s"}, {"pitch", F32, "°/s"}, {"yaw", F32, "°/s"}};
constexpr FieldSpec kAcceleration[] = {{"x", F32, "m/s²"}, {"y", F32, "m/s²"}, {"z", F32, "m/s²"}};
constexpr FieldSpec kField[] = {{"x", F32}, {"y", F32}, {"z", F32}};
constexpr FieldSpec kOutputs[] = {{"outputs", Floats}};
constexpr FieldSpec kLength[] = {{"length", F32, "m/s²"}};
constexpr FieldSpec kMeters[] = {{"altitude", F32, "m"}};
constexpr FieldSpec kSpectrum[] = {{"bins", Bins}};
constexpr FieldSpec kCorrection[] = {{"roll", F32}, {"pitch", F32}, {"yaw", F32}};
constexpr FieldSpec kGains[] = {{"p", F32}, {"i", F32}, {"d", F32}};
constexpr FieldSpec kGain[] = {{"gain", F32, "", -1, 1}};
constexpr FieldSpec kOuterGain[] = {{"gain", F32, "", -50, 50}};
constexpr FieldSpec kHorizon[] = {{"roll", F32, "°", -45, 45}, {"pitch", F32, "°", -45, 45}};
constexpr FieldSpec kVolt[] = {{"voltage", F32, "V"}};
constexpr FieldSpec kAmpereHours[] = {{"charge", F32, "Ah"}};
constexpr FieldSpec kAmpere[] = {{"current", F32, "A"}};
constexpr FieldSpec kShare[] = {{"level", F32}};
constexpr FieldSpec kPercent[] = {{"percent", U32, "%"}};
constexpr FieldSpec kCelsius[] = {{"temperature", U32, "°C"}};
constexpr FieldSpec kDbm[] = {{"level", S32, "dBm"}};
constexpr FieldSpec kLoops[] = {{"loops", U32, "/s"}};
constexpr FieldSpec kThrust[] = {{"thrust", F32}};
constexpr FieldSpec kMode[] = {{"mode", U32, "", 0, 1}};
constexpr FieldSpec kNumber[] = {{"value", S32}};
constexpr FieldSpec kShader[] = {
    {"red.base", U8}, {"red.radius", U8}, {"red.strength", S8}, {"green.base", U8}, {"green.radius", U8}, {"green.strength", S8},
    {"blue.base", U8}, {"blue.radius", U8}, {"blue.strength", S8}};
constexpr FieldSpec kMotor[] = {{"motor", U32, "", 0, 31}};
constexpr FieldSpec kBeep[] = {{"on", U16, "", 0, 1}};
constexpr FieldSpec kVtx[] = {{"channel", U8}, {"frequency", U16, "MHz"}, {"power", U8}, {"dbm", U8, "dBm"}, {"powers", Powers, "dBm"}};
constexpr FieldSpec kVtxPower[] = {{"power", U8, "", 0, 7}};
constexpr FieldSpec kVtxPowerSet[] = {{"power", U8}, {"dbm", U8, "dBm"}};
constexpr FieldSpec kVtxChannel[] = {{"channel", U8, "", 1, 40}};
constexpr FieldSpec kVtxChannelSet[] = {{"channel", U8}, {"frequency", U16, "MHz"}};

constexpr const char *kNoEffect = "no effect today";
constexpr const char *kNoProof = "the reply is a constant, no proof";
constexpr const char *kNeverSent = "Not sent by this program: it moves the drone whether or not it is armed.";

// Errata 6.
constexpr MessageSpec kMessages[] = {
    {Message::Unknown, "UNKNOWN", {}, kNone},
    {Message::Status, "STATUS", kNone, kStatus, false, Generation::A, Generation::F},
    {Message::Ping, "PING", kPing, kPing},
    {Message::Telemetry, "TELEMETRY", kNone, kTelemetry, false, Generation::A, Generation::C},
    {Message::Controls, "CONTROLS", kControls, {}},
    {Message::Ack, "ACK_ID", kNone, kNone},

    {Message::Calibrate, "CALIBRATE", kCalibrate, kCode},
    {Message::Calibrating, "CALIBRATING", {}, kCode},
    {Message::SetTimestamp, "SET_TIMESTAMP", kTime, kCode},
    {Message::Arm, "ARM", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::Disarm, "DISARM", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::ResetBattery, "RESET_BATTERY", kZero, {}},
    {Message::CalibrateEscs, "CALIBRATE_ESCS", kNone, {}},
    {Message::SetFullTelemetry, "SET_FULL_TELEMETRY", kSwitch, {}},
    {Message::DebugOutput, "DEBUG_OUTPUT", {}, kText},
    {Message::GetBoardInfos, "GET_BOARD_INFOS", kNone, kText},
    {Message::GetSensorsInfos, "GET_SENSORS_INFOS", kNone, kText},
    {Message::GetCamerasInfos, "GET_CAMERAS_INFOS", kNone, kText, false, Generation::B},
    {Message::GetConfigFile, "GET_CONFIG_FILE", kNone, kCheckedText},
    {Message::SetConfigFile, "SET_CONFIG_FILE", kCheckedText, kCode},
    {Message::UploadInit, "UPDATE_UPLOAD_INIT", kNone, {}},
    {Message::UploadData, "UPDATE_UPLOAD_DATA", kChunk, kCode},
    {Message::UploadProcess, "UPDATE_UPLOAD_PROCESS", kCrc, {}},
    {Message::EnableTunDevice, "ENABLE_TUN_DEVICE", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::DisableTunDevice, "DISABLE_TUN_DEVICE", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::GetUsername, "GET_USERNAME", kNone, kText},

    {Message::Altitude, "ALTITUDE", {}, kMeters, true},
    {Message::RollPitchYaw, "ROLL_PITCH_YAW", {}, kAngles, true},
    {Message::Accel, "ACCEL", {}, kAcceleration, true},
    {Message::Gyro, "GYRO", {}, kRates, true},
    {Message::Magn, "MAGN", {}, kField, true},
    {Message::MotorsSpeed, "MOTORS_SPEED", {}, kOutputs, true},
    {Message::CurrentAcceleration, "CURRENT_ACCELERATION", {}, kLength, true},
    {Message::GyroDterm, "GYRO_DTERM", {}, kRates, true},
    {Message::Rates, "RATES", {}, kRates, true, Generation::D},
    {Message::RateSpectrum, "RATE_DNF_DFT", {}, kSpectrum, true, Generation::E},
    {Message::PidOutput, "PID_OUTPUT", kNone, kCorrection},
    {Message::OuterPidOutput, "OUTER_PID_OUTPUT", kNone, kCorrection, false, Generation::A, Generation::A, "Always 0 today."},
    {Message::RollPidFactors, "ROLL_PID_FACTORS", kNone, kGains},
    {Message::PitchPidFactors, "PITCH_PID_FACTORS", kNone, kGains},
    {Message::YawPidFactors, "YAW_PID_FACTORS", kNone, kGains},
    {Message::OuterPidFactors, "OUTER_PID_FACTORS", kNone, kGains, false, Generation::A, Generation::A, "Always 0 today."},
    {Message::HorizonOffset, "HORIZON_OFFSET", kNone, kHorizon},
    {Message::BatteryVoltage, "VBAT", {}, kVolt, true},
    {Message::TotalCurrent, "TOTAL_CURRENT", {}, kAmpereHours, true},
    {Message::CurrentDraw, "CURRENT_DRAW", {}, kAmpere, true},
    {Message::BatteryLevel, "BATTERY_LEVEL", {}, kShare, true},
    {Message::CpuLoad, "CPU_LOAD", {}, kPercent, true},
    {Message::CpuTemperature, "CPU_TEMP", {}, kCelsius, true},
    {Message::ReceiveQuality, "RX_QUALITY", {}, kPercent, true},
    {Message::ReceiveLevel, "RX_LEVEL", {}, kDbm, true},
    {Message::StabilizerFrequency, "STABILIZER_FREQUENCY", {}, kLoops, true},

    {Message::SetRoll, "SET_ROLL", kThrust, {}, false, Generation::A, Generation::A, kNeverSent},
    {Message::SetPitch, "SET_PITCH", kThrust, {}, false, Generation::A, Generation::A, kNeverSent},
    {Message::SetYaw, "SET_YAW", kThrust, {}, false, Generation::A, Generation::A, kNeverSent},
    {Message::SetThrust, "SET_THRUST", kThrust, kThrust, true, Generation::A, Generation::A, kNeverSent},
    {Message::ResetMotors, "RESET_MOTORS", kNone, {}},
    {Message::SetMode, "SET_MODE", kMode, kMode},
    {Message::SetAltitudeHold, "SET_ALTITUDE_HOLD", kSwitch, kCode, false, Generation::A, Generation::A, "no effect on flight today"},
    {Message::SetRollP, "SET_ROLL_PID_P", kGain, kGain},
    {Message::SetRollI, "SET_ROLL_PID_I", kGain, kGain},
    {Message::SetRollD, "SET_ROLL_PID_D", kGain, kGain},
    {Message::SetPitchP, "SET_PITCH_PID_P", kGain, kGain},
    {Message::SetPitchI, "SET_PITCH_PID_I", kGain, kGain},
    {Message::SetPitchD, "SET_PITCH_PID_D", kGain, kGain},
    {Message::SetYawP, "SET_YAW_PID_P", kGain, kGain},
    {Message::SetYawI, "SET_YAW_PID_I", kGain, kGain},
    {Message::SetYawD, "SET_YAW_PID_D", kGain, kGain},
    {Message::SetOuterP, "SET_OUTER_PID_P", kOuterGain, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetOuterI, "SET_OUTER_PID_I", kOuterGain, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetOuterD, "SET_OUTER_PID_D", kOuterGain, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetHorizonOffset, "SET_HORIZON_OFFSET", kHorizon, kHorizon},

    {Message::VideoPause, "VIDEO_PAUSE", kNone, kCode, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoResume, "VIDEO_RESUME", kNone, kCode, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoTakePicture, "VIDEO_TAKE_PICTURE", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoStartRecord, "VIDEO_START_RECORD", kNone, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::VideoStopRecord, "VIDEO_STOP_RECORD", kNone, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::VideoNightMode, "VIDEO_NIGHT_MODE", kSwitch, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::BrightnessUp, "VIDEO_BRIGHTNESS_INCR", kNone, {}},
    {Message::BrightnessDown, "VIDEO_BRIGHTNESS_DECR", kNone, {}},
    {Message::ContrastUp, "VIDEO_CONTRAST_INCR", kNone, {}},
    {Message::ContrastDown, "VIDEO_CONTRAST_DECR", kNone, {}},
    {Message::SaturationUp, "VIDEO_SATURATION_INCR", kNone, {}},
    {Message::SaturationDown, "VIDEO_SATURATION_DECR", kNone, {}},
    {Message::IsoUp, "VIDEO_ISO_INCR", kNone, {}},
    {Message::IsoDown, "VIDEO_ISO_DECR", kNone, {}},
    {Message::ShutterUp, "VIDEO_SHUTTER_SPEED_INCR", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::ShutterDown, "VIDEO_SHUTTER_SPEED_DECR", kNone, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::Iso, "VIDEO_ISO", kNone, kNumber},
    {Message::ShutterSpeed, "VIDEO_SHUTTER_SPEED", kNone, kCode},
    {Message::WhiteBalance, "VIDEO_WHITE_BALANCE", kNone, kText},
    {Message::ExposureMode, "VIDEO_EXPOSURE_MODE", kNone, kText},
    {Message::LockWhiteBalance, "VIDEO_LOCK_WHITE_BALANCE", kNone, kText},
    {Message::LensShader, "VIDEO_LENS_SHADER", kNone, kShader, false, Generation::A, Generation::A, "Undefined in today's driver."},
    {Message::SetLensShader, "VIDEO_SET_LENS_SHADER", kShader, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::GetRecordingsList, "GET_RECORDINGS_LIST", kNone, kCheckedText},

    {Message::MotorTest, "MOTOR_TEST", kMotor, {}},
    {Message::MotorsBeep, "MOTORS_BEEP", kBeep, {}, false, Generation::D},
    {Message::VtxGetSettings, "VTX_GET_SETTINGS", kNone, kVtx, false, Generation::E},
    {Message::VtxSetPower, "VTX_SET_POWER", kVtxPower, kVtxPowerSet, false, Generation::E},
    {Message::VtxSetChannel, "VTX_SET_CHANNEL", kVtxChannel, kVtxChannelSet, false, Generation::E},
    {Message::DangerousBattery, "ERROR_DANGEROUS_BATTERY", {}, kNone},
    {Message::CameraMissing, "ERROR_CAMERA_MISSING", {}, kNone},
    {Message::MicrophoneMissing, "ERROR_MICROPHONE_MISSING", {}, kNone},
};
// clang-format on

/// Where an id differs from that of generation G (errata 1).
struct Moved
{
    Message id;
    Generation last;  ///< up to this generation
    int wire;
};
constexpr Moved kMoved[] = {
    {Message::Status, Generation::E, 0x80},          {Message::GetConfigFile, Generation::A, 0x6B},
    {Message::SetConfigFile, Generation::A, 0x6C},   {Message::UploadInit, Generation::A, 0x6D},
    {Message::UploadData, Generation::A, 0x6E},      {Message::UploadProcess, Generation::A, 0x6F},
    {Message::EnableTunDevice, Generation::A, 0x70}, {Message::DisableTunDevice, Generation::A, 0x71},
    {Message::GetUsername, Generation::E, 0x1001},
};

constexpr int kAckFirst = 0x0600;
constexpr int kAckLast = 0x067F;

bool isAck(int wire)
{
    return wire >= kAckFirst && wire <= kAckLast;
}

// Big-endian, from the front.
std::optional<std::uint32_t> counted(Bytes bytes, std::size_t size)
{
    if (bytes.size() < size)
        return {};
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
    return value;
}

std::optional<std::size_t> fieldSize(FieldType type, Bytes bytes, int stickBytes)
{
    switch (type) {
    case U8:
    case S8: return 1;
    case U16:
    case LeU16: return 2;
    case U32:
    case S32:
    case F32: return 4;
    case Sticks: return std::size_t(stickBytes);
    case Floats: {
        const auto count = counted(bytes, 4);
        return count ? std::optional<std::size_t>(4 + 4 * std::size_t(*count)) : std::nullopt;
    }
    case Bins: {
        const auto size = counted(bytes, 2);
        return size ? std::optional<std::size_t>(2 + *size) : std::nullopt;
    }
    case Powers: {
        const auto count = counted(bytes, 1);
        return count ? std::optional<std::size_t>(1 + *count) : std::nullopt;
    }
    case Text: {
        const auto end = std::find(bytes.begin(), bytes.end(), std::byte(0));
        return end == bytes.end() ? std::nullopt
                                  : std::optional(std::size_t(std::distance(bytes.begin(), end)) + 1);
    }
    case Rest: return bytes.size();
    }
    return {};
}

bool endsOpen(const std::optional<Fields> &fields)
{
    return fields && !fields->empty() && (fields->back().type == Text || fields->back().type == Rest);
}

}  // namespace

std::span<const MessageSpec> messages()
{
    return kMessages;
}

const MessageSpec *findMessage(Message id)
{
    const auto *it = std::find_if(std::begin(kMessages), std::end(kMessages),
                                  [id](const MessageSpec &message) { return message.id == id; });
    return it == std::end(kMessages) ? nullptr : it;
}

const MessageSpec *findMessage(const QString &name)
{
    const auto *it = std::find_if(std::begin(kMessages), std::end(kMessages), [&](const MessageSpec &each) {
        return name.compare(QLatin1String(each.name), Qt::CaseInsensitive) == 0;
    });
    return it == std::end(kMessages) ? nullptr : it;
}

int wireId(Message id, Generation generation)
{
    const Generation asked = generation == Generation::Unknown ? Generation::G : generation;
    const MessageSpec *spec = findMessage(id);
    if (!spec || asked < spec->since)
        return -1;
    const auto *moved = std::find_if(std::begin(kMoved), std::end(kMoved),
                                     [&](const Moved &each) { return each.id == id && asked <= each.last; });
    return moved == std::end(kMoved) ? int(id) : moved->wire;
}

std::optional<Message> droneMessage(int wire)
{
    if (isAck(wire))
        return Message::Ack;
    const MessageSpec *now = findMessage(Message(wire));
    if (now && now->fromDrone && wireId(now->id, Generation::G) == wire)
        return now->id;
    for (const Moved &moved : kMoved) {
        if (moved.wire == wire && findMessage(moved.id)->fromDrone)
            return moved.id;
    }
    return {};
}

std::optional<Message> groundMessage(int wire, Generation generation)
{
    if (isAck(wire))
        return Message::Ack;
    for (const MessageSpec &message : kMessages) {
        const bool isSent = message.fromGround && generation >= message.askedSince;
        if (wireId(message.id, generation) == wire && (isSent || message.id == Message::Unknown))
            return message.id;
    }
    return {};
}

std::optional<std::size_t> payloadSize(Fields fields, Bytes bytes, int stickBytes)
{
    std::size_t size = 0;
    for (const FieldSpec &field : fields) {
        const auto next = fieldSize(field.type, bytes.subspan(size), stickBytes);
        if (!next || *next > bytes.size() - size)
            return {};
        size += *next;
    }
    return size;
}

QByteArray encode(Message id, QByteArrayView payload, Generation generation)
{
    const int wire = wireId(id, generation);
    Q_ASSERT(wire >= 0);
    const bool isShort
        = id == Message::Ping || id == Message::Telemetry || id == Message::Controls || id == Message::Status;
    QByteArray bytes;
    if (!isShort)
        bytes.append(char(wire >> 8));
    bytes.append(char(wire & 0xFF));
    bytes.append(payload);
    return bytes;
}

QByteArray encodeAck(int number)
{
    const char bytes[] = {char(kAckFirst >> 8), char(number & 0x7F)};
    return {bytes, sizeof bytes};
}

bool standsAlone(Message id)
{
    const MessageSpec *spec = findMessage(id);
    // Without a transmitter the drone does not take the byte behind these (errata 6.6).
    return id == Message::VtxSetPower || id == Message::VtxSetChannel || (spec && endsOpen(spec->fromGround));
}

QString generationText(Generation generation)
{
    return generation == Generation::Unknown ? u"?"_s : QString(QChar(u'A' + int(generation) - 1));
}

}  // namespace bcflight
