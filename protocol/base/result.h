// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <tl/expected.hpp>

/// Why something did not happen. Words for the operator are made from it in widgets/models/errortext.h.
enum class ErrorCode {
    Cancelled,  ///< the operator stopped the job
    Timeout,  ///< no answer in time
    LinkClosed,  ///< the link went away while the job ran
    PortNotFound,  ///< no such port, host or file
    NoPermission,  ///< the port may not be opened by this user
    PortBusy,  ///< another program holds the port
    HostUnreachable,  ///< the TCP or UDP peer refused or does not exist
    Silent,  ///< the port is open, nothing ever answered
    Garbage,  ///< bytes arrive, no frame of a known protocol is among them
    WrongProtocol,  ///< frames of another family arrive
    ReadOnly,  ///< the firmware is unknown to us: nothing may be written
    Damaged,  ///< the command reached the board damaged or in pieces and was thrown away
    BoardError,  ///< the board refused with its own error code (boardCode)
    BadReply,  ///< the board's answer does not hold what the document promises
    InvalidArgument,  ///< a value, key or address that makes no sense
    OutOfRange,  ///< a value outside its parameter's range
    Unsupported,  ///< this board or firmware cannot do that
    Conflict,  ///< the board's values changed since they were read
    VerifyFailed,  ///< written values were not the ones read back
    BadFile,  ///< a file that cannot be read, written or understood
    NotConnected,  ///< there is no board
    NoBackup,  ///< the safety copy could not be made, so nothing was changed
    TooMuch,  ///< more than the link can carry
    Unready,  ///< something has to be so first, and is not
    ConditionUnmet,  ///< an action needs something that is not so, or nothing tells; the detail says what
    NotSeen,  ///< what a procedure waited for did not come; the detail says what
    NotRestored,  ///< values in use were replaced and could not be put back; the detail lists them
    Diverged,  ///< an axis did not follow and was stopped
    NotProven,  ///< commands were sent, and nothing the board tells proves that they took effect
    Busy,  ///< another job of the same kind is running
};
inline constexpr std::size_t kErrorCodes = std::size_t(ErrorCode::Busy) + 1;

/// An error as a value: a code, details for experts and, for BoardError, the board's own number.
struct Error
{
    ErrorCode code = ErrorCode::BadReply;
    QString detail;
    int boardCode = 0;

    friend bool operator==(const Error &, const Error &) = default;
};

template <typename T> using Result = tl::expected<T, Error>;

/// Short form for returning an error: `return failure(ErrorCode::Timeout, u"BOARD_INFO"_s);`
inline tl::unexpected<Error> failure(ErrorCode code, QString detail = {}, int boardCode = 0)
{
    return tl::unexpected<Error>(Error{code, std::move(detail), boardCode});
}
