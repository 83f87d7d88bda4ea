// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/mavlink/frame.h"
#include "protocol/session/request.h"

#include <array>
#include <optional>

namespace storm32 {

/// Simple commands (document "Simple Commands", errata 3). The number is that of their answer's frame, see
/// FrameId.
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

/// Numbers of the frames that come from a board: letters and data of simple commands, answers of the RC set,
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
    int argumentBytes = 0;  ///< that follow the letters, without their checksum; -1: the parameter stream
    std::array<int, 3> replyWords{};  ///< words of the answer, as firmware differs; 0: the letter alone
};

[[nodiscard]] std::span<const SimpleCommand> simpleCommands();
[[nodiscard]] const SimpleCommand &simpleCommand(Simple id);
/// The command that these bytes begin with, or null.
[[nodiscard]] const SimpleCommand *findSimple(Bytes bytes);

struct RcCommand
{
    Rc id{};
    const char *name = "";
    int payloadBytes = 0;
    NamedFields fields{};
    NamedFields answer{};  ///< of the data that comes back; none: an ack
};

[[nodiscard]] std::span<const RcCommand> rcCommands();
[[nodiscard]] const RcCommand *findRc(int id);
/// What a board's frame answers, or the ack itself; null when it is none of both. Texts come under the number
/// of the data up to v2.08 and are told by their length (errata 4).
[[nodiscard]] const RcCommand *findRcAnswer(int id, Bytes payload);

/// The bytes of a simple command; arguments get their checksum.
[[nodiscard]] QByteArray encodeSimple(Simple id, QByteArrayView arguments = {});
/// A frame of the RC set towards the board. @param answer the same frame from it (starts with FB)
[[nodiscard]] QByteArray encodeRc(int id, QByteArrayView payload, bool answer = false);
/// The answer to a simple command as it stands on the wire.
[[nodiscard]] QByteArray encodeReply(QByteArrayView data);

/// What an ack code of the RC set says (errata 4): nothing for 0. The code is in Error::boardCode.
[[nodiscard]] std::optional<Error> ackError(int code, const QString &command);

/// A request for a simple command: answered by its data or 'o'; 'e', 't' and 'c' become BoardError.
[[nodiscard]] Request simpleRequest(Simple id, QByteArrayView arguments = {});
/// A request of the RC set: answered by its data or an ack; a refusal becomes BoardError.
[[nodiscard]] Request rcRequest(Rc id, const QByteArray &payload = {});

}  // namespace storm32
