// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/messages.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

using enum FieldType;
using enum MaySend;
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
constexpr const char *kMovesAlways = "it moves the drone whether or not it is armed";
constexpr const char *kDead = "nobody uses it";

// Errata 6.
constexpr MessageSpec kMessages[] = {
    {Message::Unknown, "UNKNOWN", {}, Never, kNone},
    {Message::Status, "STATUS", kNone, Anytime, kStatus, false, Generation::A, Generation::F},
    {Message::Ping, "PING", kPing, Anytime, kPing},
    {Message::Telemetry, "TELEMETRY", kNone, Anytime, kTelemetry, false, Generation::A, Generation::C},
    {Message::Controls, "CONTROLS", kControls, Steering, {}},
    {Message::Connect, "CONNECT", {}, Never, {}, false, Generation::E, Generation::E, kDead},
    {Message::Ack, "ACK_ID", kNone, Anytime, kNone},

    {Message::Calibrate, "CALIBRATE", kCalibrate, Disarmed, kCode},
    {Message::Calibrating, "CALIBRATING", {}, Never, kCode},
    {Message::SetTimestamp, "SET_TIMESTAMP", kTime, Disarmed, kCode},
    {Message::Arm, "ARM", kNone, Disarmed, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::Disarm, "DISARM", kNone, Disarmed, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::ResetBattery, "RESET_BATTERY", kZero, Disarmed, {}},
    {Message::CalibrateEscs, "CALIBRATE_ESCS", kNone, Disarmed, {}},
    {Message::SetFullTelemetry, "SET_FULL_TELEMETRY", kSwitch, Anytime, {}},
    {Message::DebugOutput, "DEBUG_OUTPUT", {}, Never, kText},
    {Message::GetBoardInfos, "GET_BOARD_INFOS", kNone, Anytime, kText},
    {Message::GetSensorsInfos, "GET_SENSORS_INFOS", kNone, Anytime, kText},
    {Message::GetCamerasInfos, "GET_CAMERAS_INFOS", kNone, Anytime, kText, false, Generation::B},
    {Message::GetConfigFile, "GET_CONFIG_FILE", kNone, Anytime, kCheckedText},
    {Message::SetConfigFile, "SET_CONFIG_FILE", kCheckedText, Disarmed, kCode},
    {Message::UploadInit, "UPDATE_UPLOAD_INIT", kNone, Disarmed, {}},
    {Message::UploadData, "UPDATE_UPLOAD_DATA", kChunk, Disarmed, kCode},
    {Message::UploadProcess, "UPDATE_UPLOAD_PROCESS", kCrc, Disarmed, {}},
    {Message::EnableTunDevice, "ENABLE_TUN_DEVICE", kNone, Disarmed, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::DisableTunDevice, "DISABLE_TUN_DEVICE", kNone, Disarmed, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::GetUsername, "GET_USERNAME", kNone, Anytime, kText},

    {Message::Pressure, "PRESSURE", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::Temperature, "TEMPERATURE", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::Altitude, "ALTITUDE", {}, Never, kMeters, true},
    {Message::Roll, "ROLL", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::Pitch, "PITCH", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::Yaw, "YAW", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::RollPitchYaw, "ROLL_PITCH_YAW", {}, Never, kAngles, true},
    {Message::Accel, "ACCEL", {}, Never, kAcceleration, true},
    {Message::Gyro, "GYRO", {}, Never, kRates, true},
    {Message::Magn, "MAGN", {}, Never, kField, true},
    {Message::MotorsSpeed, "MOTORS_SPEED", {}, Never, kOutputs, true},
    {Message::CurrentAcceleration, "CURRENT_ACCELERATION", {}, Never, kLength, true},
    {Message::GyroDterm, "GYRO_DTERM", {}, Never, kRates, true},
    {Message::Rates, "RATES", {}, Never, kRates, true, Generation::D},
    {Message::RateSpectrum, "RATE_DNF_DFT", {}, Never, kSpectrum, true, Generation::E},
    {Message::SensorsData, "SENSORS_DATA", {}, Never, {}, false, Generation::A, Generation::A, kDead},
    {Message::PidOutput, "PID_OUTPUT", kNone, Anytime, kCorrection},
    {Message::OuterPidOutput, "OUTER_PID_OUTPUT", kNone, Anytime, kCorrection, false, Generation::A, Generation::A, "Always 0 today."},
    {Message::RollPidFactors, "ROLL_PID_FACTORS", kNone, Anytime, kGains},
    {Message::PitchPidFactors, "PITCH_PID_FACTORS", kNone, Anytime, kGains},
    {Message::YawPidFactors, "YAW_PID_FACTORS", kNone, Anytime, kGains},
    {Message::OuterPidFactors, "OUTER_PID_FACTORS", kNone, Anytime, kGains, false, Generation::A, Generation::A, "Always 0 today."},
    {Message::HorizonOffset, "HORIZON_OFFSET", kNone, Anytime, kHorizon},
    {Message::BatteryVoltage, "VBAT", {}, Never, kVolt, true},
    {Message::TotalCurrent, "TOTAL_CURRENT", {}, Never, kAmpereHours, true},
    {Message::CurrentDraw, "CURRENT_DRAW", {}, Never, kAmpere, true},
    {Message::BatteryLevel, "BATTERY_LEVEL", {}, Never, kShare, true},
    {Message::CpuLoad, "CPU_LOAD", {}, Never, kPercent, true},
    {Message::CpuTemperature, "CPU_TEMP", {}, Never, kCelsius, true},
    {Message::ReceiveQuality, "RX_QUALITY", {}, Never, kPercent, true},
    {Message::ReceiveLevel, "RX_LEVEL", {}, Never, kDbm, true},
    {Message::StabilizerFrequency, "STABILIZER_FREQUENCY", {}, Never, kLoops, true},

    {Message::SetRoll, "SET_ROLL", kThrust, Never, {}, false, Generation::A, Generation::A, kMovesAlways},
    {Message::SetPitch, "SET_PITCH", kThrust, Never, {}, false, Generation::A, Generation::A, kMovesAlways},
    {Message::SetYaw, "SET_YAW", kThrust, Never, {}, false, Generation::A, Generation::A, kMovesAlways},
    {Message::SetThrust, "SET_THRUST", kThrust, Never, kThrust, true, Generation::A, Generation::A, kMovesAlways},
    {Message::ResetMotors, "RESET_MOTORS", kNone, Anytime, {}},
    {Message::SetMode, "SET_MODE", kMode, Disarmed, kMode},
    {Message::SetAltitudeHold, "SET_ALTITUDE_HOLD", kSwitch, Disarmed, kCode, false, Generation::A, Generation::A, "no effect on flight today"},
    {Message::SetRollP, "SET_ROLL_PID_P", kGain, Tuning, kGain},
    {Message::SetRollI, "SET_ROLL_PID_I", kGain, Tuning, kGain},
    {Message::SetRollD, "SET_ROLL_PID_D", kGain, Tuning, kGain},
    {Message::SetPitchP, "SET_PITCH_PID_P", kGain, Tuning, kGain},
    {Message::SetPitchI, "SET_PITCH_PID_I", kGain, Tuning, kGain},
    {Message::SetPitchD, "SET_PITCH_PID_D", kGain, Tuning, kGain},
    {Message::SetYawP, "SET_YAW_PID_P", kGain, Tuning, kGain},
    {Message::SetYawI, "SET_YAW_PID_I", kGain, Tuning, kGain},
    {Message::SetYawD, "SET_YAW_PID_D", kGain, Tuning, kGain},
    {Message::SetOuterP, "SET_OUTER_PID_P", kOuterGain, Tuning, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetOuterI, "SET_OUTER_PID_I", kOuterGain, Tuning, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetOuterD, "SET_OUTER_PID_D", kOuterGain, Tuning, kOuterGain, false, Generation::A, Generation::A, "Confirmed, but not applied by today's firmware."},
    {Message::SetHorizonOffset, "SET_HORIZON_OFFSET", kHorizon, Disarmed, kHorizon},

    {Message::VideoPause, "VIDEO_PAUSE", kNone, Anytime, kCode, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoResume, "VIDEO_RESUME", kNone, Anytime, kCode, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoTakePicture, "VIDEO_TAKE_PICTURE", kNone, Anytime, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::VideoStartRecord, "VIDEO_START_RECORD", kNone, Anytime, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::VideoStopRecord, "VIDEO_STOP_RECORD", kNone, Anytime, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::VideoNightMode, "VIDEO_NIGHT_MODE", kSwitch, Anytime, kCode, false, Generation::A, Generation::A, kNoProof},
    {Message::BrightnessUp, "VIDEO_BRIGHTNESS_INCR", kNone, Anytime, {}},
    {Message::BrightnessDown, "VIDEO_BRIGHTNESS_DECR", kNone, Anytime, {}},
    {Message::ContrastUp, "VIDEO_CONTRAST_INCR", kNone, Anytime, {}},
    {Message::ContrastDown, "VIDEO_CONTRAST_DECR", kNone, Anytime, {}},
    {Message::SaturationUp, "VIDEO_SATURATION_INCR", kNone, Anytime, {}},
    {Message::SaturationDown, "VIDEO_SATURATION_DECR", kNone, Anytime, {}},
    {Message::IsoUp, "VIDEO_ISO_INCR", kNone, Anytime, {}},
    {Message::IsoDown, "VIDEO_ISO_DECR", kNone, Anytime, {}},
    {Message::ShutterUp, "VIDEO_SHUTTER_SPEED_INCR", kNone, Anytime, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::ShutterDown, "VIDEO_SHUTTER_SPEED_DECR", kNone, Anytime, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::Iso, "VIDEO_ISO", kNone, Anytime, kNumber},
    {Message::ShutterSpeed, "VIDEO_SHUTTER_SPEED", kNone, Anytime, kCode},
    {Message::WhiteBalance, "VIDEO_WHITE_BALANCE", kNone, Anytime, kText},
    {Message::ExposureMode, "VIDEO_EXPOSURE_MODE", kNone, Anytime, kText},
    {Message::LockWhiteBalance, "VIDEO_LOCK_WHITE_BALANCE", kNone, Anytime, kText},
    {Message::LensShader, "VIDEO_LENS_SHADER", kNone, Anytime, kShader, false, Generation::A, Generation::A, "Undefined in today's driver."},
    {Message::SetLensShader, "VIDEO_SET_LENS_SHADER", kShader, Anytime, {}, false, Generation::A, Generation::A, kNoEffect},
    {Message::GetRecordingsList, "GET_RECORDINGS_LIST", kNone, Anytime, kCheckedText},

    {Message::MotorTest, "MOTOR_TEST", kMotor, Disarmed, {}},
    {Message::MotorsBeep, "MOTORS_BEEP", kBeep, Disarmed, {}, false, Generation::D},
    {Message::VtxGetSettings, "VTX_GET_SETTINGS", kNone, Anytime, kVtx, false, Generation::E},
    {Message::VtxSetPower, "VTX_SET_POWER", kVtxPower, Disarmed, kVtxPowerSet, false, Generation::E},
    {Message::VtxSetChannel, "VTX_SET_CHANNEL", kVtxChannel, Disarmed, kVtxChannelSet, false, Generation::E},
    {Message::DangerousBattery, "ERROR_DANGEROUS_BATTERY", {}, Never, kNone, false, Generation::A, Generation::A, kDead},
    {Message::CameraMissing, "ERROR_CAMERA_MISSING", {}, Never, kNone},
    {Message::MicrophoneMissing, "ERROR_MICROPHONE_MISSING", {}, Never, kNone, false, Generation::A, Generation::A, kDead},
};
// clang-format on
static_assert(std::ranges::all_of(kMessages, [](const MessageSpec &each) {
    return each.fromGround || each.maySend == Never;
}));

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

std::optional<WireId> readId(Bytes bytes)
{
    if (bytes.empty())
        return {};
    const std::size_t size = (bytes[0] & std::byte{0x80}) != std::byte{} ? 1 : 2;
    const auto wire = counted(bytes, size);
    return wire ? std::optional(WireId{int(*wire), size}) : std::nullopt;
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
