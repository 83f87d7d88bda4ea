// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of BCFlight's radio protocol (document "BCFlight radio protocol" and its errata, sections 1 to
// 6).
#pragma once

#include "protocol/base/bytes.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <optional>
#include <span>

namespace bcflight {

/// Generations of the protocol (errata 1). Nothing on the wire names them.
enum class Generation : std::uint8_t { Unknown, A, B, C, D, E, F, G };

/// Messages, by their ids of generation G (errata 6).
enum class Message : std::uint16_t {
    Unknown = 0x00,
    Pressure = 0x10,
    Temperature = 0x11,
    Altitude = 0x12,
    Roll = 0x13,
    Pitch = 0x14,
    Yaw = 0x15,
    RollPitchYaw = 0x16,
    Accel = 0x17,
    Gyro = 0x18,
    Magn = 0x19,
    MotorsSpeed = 0x1A,
    CurrentAcceleration = 0x1B,
    GyroDterm = 0x1C,
    Rates = 0x1D,
    RateSpectrum = 0x1E,  ///< RATE_DNF_DFT
    SensorsData = 0x20,
    PidOutput = 0x21,
    OuterPidOutput = 0x22,
    RollPidFactors = 0x23,
    PitchPidFactors = 0x24,
    YawPidFactors = 0x25,
    OuterPidFactors = 0x26,
    HorizonOffset = 0x27,
    BatteryVoltage = 0x30,  ///< VBAT
    TotalCurrent = 0x31,
    CurrentDraw = 0x32,
    BatteryLevel = 0x34,
    CpuLoad = 0x35,
    CpuTemperature = 0x36,
    ReceiveQuality = 0x37,
    ReceiveLevel = 0x38,
    StabilizerFrequency = 0x39,
    SetRoll = 0x40,
    SetPitch = 0x41,
    SetYaw = 0x42,
    SetThrust = 0x43,
    ResetMotors = 0x47,
    SetMode = 0x48,
    SetAltitudeHold = 0x49,
    SetRollP = 0x50,
    SetRollI = 0x51,
    SetRollD = 0x52,
    SetPitchP = 0x53,
    SetPitchI = 0x54,
    SetPitchD = 0x55,
    SetYawP = 0x56,
    SetYawI = 0x57,
    SetYawD = 0x58,
    SetOuterP = 0x59,
    SetOuterI = 0x5A,
    SetOuterD = 0x5B,
    SetHorizonOffset = 0x5C,
    Calibrate = 0x60,
    Calibrating = 0x61,
    SetTimestamp = 0x62,
    Arm = 0x63,
    Disarm = 0x64,
    ResetBattery = 0x65,
    CalibrateEscs = 0x66,
    SetFullTelemetry = 0x67,
    DebugOutput = 0x68,
    GetBoardInfos = 0x69,
    GetSensorsInfos = 0x6A,
    GetCamerasInfos = 0x6B,
    GetConfigFile = 0x70,
    SetConfigFile = 0x71,
    UploadInit = 0x72,
    UploadData = 0x73,
    UploadProcess = 0x74,
    EnableTunDevice = 0x75,
    DisableTunDevice = 0x76,
    Ping = 0x81,
    Telemetry = 0x82,
    Controls = 0x83,
    Connect = 0x84,
    Status = 0x85,
    VideoPause = 0xA0,
    VideoResume = 0xA1,
    VideoTakePicture = 0xA2,
    VideoStartRecord = 0xA3,
    VideoStopRecord = 0xA4,
    VideoNightMode = 0xA5,
    BrightnessUp = 0xB0,
    BrightnessDown = 0xB2,
    ContrastUp = 0xB3,
    ContrastDown = 0xB4,
    SaturationUp = 0xB5,
    SaturationDown = 0xB6,
    IsoUp = 0xB7,
    IsoDown = 0xB8,
    ShutterUp = 0xB9,
    ShutterDown = 0xBA,
    Iso = 0xBB,
    ShutterSpeed = 0xBC,
    WhiteBalance = 0xC1,
    ExposureMode = 0xC2,
    LockWhiteBalance = 0xC3,
    LensShader = 0xC5,
    SetLensShader = 0xC6,
    GetRecordingsList = 0xD0,
    MotorTest = 0xE0,
    MotorsBeep = 0xE1,
    Ack = 0x0600,  ///< 0x0600 to 0x067F: the number is part of the id (errata 5)
    VtxGetSettings = 0x2001,
    VtxSetPower = 0x2002,
    VtxSetChannel = 0x2003,
    GetUsername = 0x3001,
    DangerousBattery = 0x7301,
    CameraMissing = 0x7F01,
    MicrophoneMissing = 0x7F02,
};

/// How a field stands in a payload. Numbers are big-endian unless the name says otherwise (errata 2.3).
enum class FieldType : std::uint8_t {
    U8,
    S8,
    U16,
    U32,
    S32,
    F32,
    LeU16,
    Sticks,  ///< CONTROLS: 6 bytes from generation D on, 5 before
    Floats,  ///< u32 count, then as many F32
    Bins,  ///< u16 number of bytes, then four little-endian F32 per bin (errata 8.3)
    Powers,  ///< u8 count, then as many U8
    Text,  ///< up to a zero, which ends it; the last field
    Rest,  ///< all bytes that follow; the last field
};

struct FieldSpec
{
    const char *name = "";
    FieldType type = FieldType::U32;
    const char *unit = "";
    double min = 0;  ///< with max: what may be sent; both 0: whatever the type holds
    double max = 0;
};

/// When the ground may send it (errata 9.2). Nobody else asks: the drone refuses hardly anything by itself.
enum class MaySend : std::uint8_t {
    Anytime,  ///< in flight as well
    Disarmed,  ///< and not while it calibrates
    Tuning,  ///< as Disarmed, or while it is held in a test stand
    Steering,  ///< while somebody steers, and to end that
    Never,
};

/// One message. What is not sent in a direction has no entry there; an empty list is a message without a
/// payload. One that has none at all is known by its name alone: how long it would be nobody knows.
struct MessageSpec
{
    Message id = Message::Unknown;
    const char *name = "";  ///< as the document has it
    std::optional<std::span<const FieldSpec>> fromGround;
    MaySend maySend = MaySend::Never;
    std::optional<std::span<const FieldSpec>> fromDrone;
    bool isStreamed = false;  ///< the drone sends it by itself; it cannot be asked for
    Generation since = Generation::A;
    Generation askedSince = Generation::A;  ///< before, the ground cannot send it, but the drone does
    const char *note = "";  ///< what has to be known of it; stands behind its fields in the console
};

[[nodiscard]] std::span<const MessageSpec> messages();
/// Null for a message that has no entry.
[[nodiscard]] const MessageSpec *findMessage(Message id);
[[nodiscard]] const MessageSpec *findMessage(const QString &name);

/// The id on the wire in that generation, -1 where it does not exist. @param generation Unknown: as in G
[[nodiscard]] int wireId(Message id, Generation generation);
/// An id as it stands in a packet: one byte, or two where the first has no top bit (errata 2.2).
struct WireId
{
    int wire = 0;
    std::size_t size = 0;
};
/// The one at the front. Empty: more has to come.
[[nodiscard]] std::optional<WireId> readId(Bytes bytes);
/// What the drone means by this id, in whatever generation; empty: nothing. GET_CONFIG_FILE of generation A
/// has the id of GET_CAMERAS_INFOS of the others: that one is returned.
[[nodiscard]] std::optional<Message> droneMessage(int wire);
/// What a drone of that generation takes it for.
[[nodiscard]] std::optional<Message> groundMessage(int wire, Generation generation);

/// Bytes that a payload begins with occupy: up to the end of its last field. Empty: more has to come.
/// @param stickBytes size of FieldType::Sticks
[[nodiscard]] std::optional<std::size_t> payloadSize(std::span<const FieldSpec> fields, Bytes bytes,
                                                     int stickBytes = 6);

/// A whole message as the ground sends it: one byte for PING, TELEMETRY, CONTROLS and STATUS, two bytes of id
/// for all others (errata 2.2, section 6). @pre wireId() exists
[[nodiscard]] QByteArray encode(Message id, QByteArrayView payload = {},
                                Generation generation = Generation::G);
/// ACK_ID. @param number 1 to 126 (errata 5)
[[nodiscard]] QByteArray encodeAck(int number);

/// Whether it ends in a text, or in bytes of any number: nothing may stand behind it in its packet (errata
/// 2.5).
[[nodiscard]] bool standsAlone(Message id);

/// One letter; "?" for Unknown.
[[nodiscard]] QString generationText(Generation generation);

}  // namespace bcflight
