// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/mavlink/frame.h"
#include "protocol/session/request.h"

#include <array>
#include <optional>

namespace storm32 {

/// Simple commands (document "Simple Commands", errata 3). The number is used for the frame of their answer,
/// see FrameId.
enum class Simple : std::uint8_t {
    Test,
    Version,
    GetParameters,
    PutParameters,
    LiveData,
    Status,
    Store,
    Retrieve,
    Defaults,
    EraseEeprom,
    Level,
    Restart,
    HardReset,
    NormalMotors,
    TakeDirections,
    TakeStartPositions,
    TakeYawStartPosition,
    SetName,
    SetBaudRate,
    RcTrim,
    ReadCalibration,
    WriteCalibration,
    RawSensors,
    Count
};

/// Commands of the RC set (document "RC Commands", errata 4).
enum class Rc : std::uint8_t {
    GetVersion = 1,
    GetVersionStrings = 2,
    GetParameter = 3,
    SetParameter = 4,
    GetData = 5,
    GetDataFields = 6,
    SetPitch = 10,
    SetRoll = 11,
    SetYaw = 12,
    SetPanMode = 13,
    SetStandby = 14,
    DoCamera = 15,
    SetScriptControl = 16,
    SetAngle = 17,
    SetPitchRollYaw = 18,
    SetPwmOut = 19,
    RestoreParameter = 20,
    RestoreAllParameters = 21,
    ActivePanModeSetting = 100,
    Ack = 150,
};

/// Numbers of the frames that a board sends: letters and data of simple commands, answers of the RC set,
/// MAVLink.
namespace FrameId {
inline constexpr int kLetter = 0x000;  ///< + 'o', 'e', 't' or 'c'
inline constexpr int kSimple = 0x100;  ///< + Simple: the data, without checksum and closing letter
inline constexpr int kRc = 0x200;  ///< + number of the answer
inline constexpr int kMavlink = 0x300;  ///< + message; the payload of the view is the message's
}  // namespace FrameId

struct SimpleCommand
{
    Simple id{};
    const char *letters = "";
    const char *name = "";
    int argumentBytes = 0;  ///< after the letters, without their checksum; -1: the parameter stream
    std::array<int, 3> replyWords{};  ///< words of the answer for different firmware; 0: only the letter
};

[[nodiscard]] std::span<const SimpleCommand> simpleCommands();
[[nodiscard]] const SimpleCommand &simpleCommand(Simple id);
/// The command that these bytes start with, or null.
[[nodiscard]] const SimpleCommand *findSimple(Bytes bytes);

struct RcCommand
{
    Rc id{};
    const char *name = "";
    int payloadBytes = 0;
    NamedFields fields{};
    NamedFields answer{};  ///< of the data in the answer; empty: an ack
};

[[nodiscard]] std::span<const RcCommand> rcCommands();
[[nodiscard]] const RcCommand *findRc(int id);
/// The command that a board's frame answers, or the ack itself; null if it is neither. Up to v2.08 texts have
/// the number of the data and are recognised by their length (errata 4).
[[nodiscard]] const RcCommand *findRcAnswer(int id, Bytes payload);

/// Encodes a simple command; arguments get their checksum.
[[nodiscard]] QByteArray encodeSimple(Simple id, QByteArrayView arguments = {});
/// A frame of the RC set to the board. @param answer the same frame from the board (starts with FB)
[[nodiscard]] QByteArray encodeRc(int id, QByteArrayView payload, bool answer = false);
/// The answer to a simple command as sent on the wire.
[[nodiscard]] QByteArray encodeReply(QByteArrayView data);

/// Meaning of an ack code of the RC set (errata 4): empty for 0. The code is in Error::boardCode.
[[nodiscard]] std::optional<Error> ackError(int code, const QString &command);

/// A request for a simple command: answered by its data or 'o'; 'e', 't' and 'c' become BoardError.
[[nodiscard]] Request simpleRequest(Simple id, QByteArrayView arguments = {});
/// A request of the RC set: answered by its data or an ack; a refusal becomes BoardError.
[[nodiscard]] Request rcRequest(Rc id, const QByteArray &payload = {});

}  // namespace storm32
