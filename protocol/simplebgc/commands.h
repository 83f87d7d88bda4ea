// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/request.h"

namespace simplebgc {

/// The first firmware with GET_ANGLES_EXT. Assumed: the document only tells that it came in August 2015,
/// after 2.55b5 in July.
inline constexpr int kAnglesExtSince = 2556;

/// Command numbers (document "Command ID definitions", errata 2). Incoming and outgoing share numbers: 67 is
/// CONTROL towards the board and CONFIRM from it.
enum class CommandId : std::uint8_t {
    BoardInfo3 = 20,
    ReadParams3 = 21,
    WriteParams3 = 22,
    RealtimeData3 = 23,
    SelectImu3 = 24,
    RealtimeData4 = 25,
    EncodersCalibOffset = 26,
    EncodersCalibFldOffset = 27,
    ReadProfileNames = 28,
    WriteProfileNames = 29,
    GetParams3 = 30,
    SetAdjVarsVal = 31,
    SaveParams3 = 32,
    ReadParamsExt = 33,
    WriteParamsExt = 34,
    AutoPid = 35,
    ServoOut = 36,
    BodeTestStartStop = 37,
    BodeTestData = 38,
    I2cWriteRegBuf = 39,
    I2cReadRegBuf = 40,
    WriteExternalData = 41,
    ReadExternalData = 42,
    ReadAdjVarsCfg = 43,
    WriteAdjVarsCfg = 44,
    ApiVirtChControl = 45,
    AdjVarsState = 46,
    EepromWrite = 47,
    EepromRead = 48,
    CalibInfo = 49,
    BootMode3 = 51,
    ReadFile = 53,
    WriteFile = 54,
    FsClearAll = 55,
    AhrsHelper = 56,
    RunScript = 57,
    ScriptDebug = 58,
    CalibMag = 59,
    GetAnglesExt = 61,
    ReadParamsExt2 = 62,
    WriteParamsExt2 = 63,
    GetAdjVarsVal = 64,
    CalibAcc = 65,
    CalibBat = 66,
    Control = 67,
    Confirm = 67,
    RealtimeData = 68,
    ExecuteMenu = 69,
    UseDefaults = 70,
    CalibExtGain = 71,
    HelperData = 72,
    GetAngles = 73,
    CalibMotorMagLink = 74,
    GyroCorrection = 75,
    MotorsOn = 77,
    CalibOffset = 79,
    CalibPoles = 80,
    ReadParams = 82,
    TriggerPin = 84,
    DataStreamInterval = 85,
    BoardInfo = 86,
    WriteParams = 87,
    RealtimeDataCustom = 88,
    BeepSound = 89,
    ControlConfig = 90,
    CalibOrientCorr = 91,
    CalibCogging = 93,
    CalibAccExtRef = 94,
    ProfileSet = 95,
    ReadRcInputs = 100,
    Event = 102,
    CalibGyro = 103,
    ReadParamsExt3 = 104,
    WriteParamsExt3 = 105,
    ExtImuDebugInfo = 106,
    AutoPid2 = 108,
    MotorsOff = 109,
    ReadStateVars = 111,
    WriteStateVars = 112,
    Reset = 114,
    ApiVirtChHighRes = 116,
    WriteParamsSet = 119,
    ControlExt = 121,
    SyncMotors = 123,
    AdjVarsInfo = 132,
    ServoOutExt = 133,
    SetAdjVarsValF = 134,
    GetAdjVarsValF = 135,
    RealtimeDataCustom2 = 139,
    ControlQuat = 140,
    ControlQuatStatus = 141,
    ControlQuatConfig = 142,
    DebugVarsInfo3 = 253,
    DebugVars3 = 254,
    Error = 255,
};

constexpr int number(CommandId id)
{
    return static_cast<int>(id);
}

/// The document's name of a command without "CMD_", or "CMD_n".
[[nodiscard]] QString commandName(int id);

/// A complete frame of version 1 ('>', sum checksums) or 2 ('$', CRC16; firmware 2.68b0 and later). Errata
/// 1.1, 1.2. The payload must not exceed 255 bytes.
[[nodiscard]] QByteArray encodeFrame(int id, QByteArrayView payload, int version = 1);

/// A request that is answered by a frame with that number. Refusals (ERROR for this command) become
/// BoardError.
[[nodiscard]] Request replyRequest(CommandId id, const QByteArray &payload, CommandId reply, int replyPayload,
                                   int version);
/// The same, if the reply must also satisfy a condition (which profile, which variables).
[[nodiscard]] Request replyRequest(CommandId id, const QByteArray &payload, CommandId reply, int replyPayload,
                                   int version, std::function<bool(Bytes)> accept);
/// A request that is answered by CONFIRM with its own number.
[[nodiscard]] Request confirmRequest(CommandId id, const QByteArray &payload, int version);
/// A request that is not answered.
[[nodiscard]] Request silentRequest(CommandId id, const QByteArray &payload, int version);

/// The board's refusal of this command, if the frame is one. The document's 5-byte form of ERROR does not
/// name the command (errata 3.18); with one request in flight it can only be that one.
[[nodiscard]] std::optional<Error> refusalOf(const FrameView &frame, int command);

/// True for a CONFIRM of this command.
[[nodiscard]] bool isConfirmOf(const FrameView &frame, CommandId id);

/// Meaning of an ERROR code, in the document's words (errata 3.18): "wrong payload size".
/// @param command that was refused: those of memory and files have words of their own beside
[[nodiscard]] QString errorCodeText(int code, int command = 0);

}  // namespace simplebgc
