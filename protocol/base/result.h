// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>
#include <optional>
#include <tl/expected.hpp>

struct Aftermath;
struct FileFault;

/// Why something failed. The operator's wording is made from it in widgets/models/errortext.h.
enum class ErrorCode {
    Cancelled,  ///< the operator stopped the job
    Timeout,  ///< no answer in time
    LinkClosed,  ///< the link went away while the job ran
    PortNotFound,  ///< no such port, host or file
    NoPermission,  ///< this user may not open the port
    PortBusy,  ///< another program holds the port
    HostUnreachable,  ///< the TCP or UDP peer refused or does not exist
    Silent,  ///< the port is open, but nothing ever answered
    SilentPeer,  ///< a network address to which a connection stands, but which sends nothing
    Garbage,  ///< bytes arrive, but no frame of a known protocol
    WrongProtocol,  ///< frames of another family arrive
    ReadOnly,  ///< the firmware is unknown to us: nothing may be written
    Damaged,  ///< the command reached the board damaged or incomplete and was discarded
    BoardError,  ///< the board refused with its own error code (boardCode)
    BadReply,  ///< the board's answer is not what its document specifies
    InvalidArgument,  ///< a value, key or address that makes no sense
    OutOfRange,  ///< a value outside its parameter's range
    Contradiction,  ///< two values that exclude each other; the detail names both
    Unsupported,  ///< this board or firmware cannot do that
    Conflict,  ///< the board's values changed since they were read
    VerifyFailed,  ///< written values were not the ones read back
    BadFile,  ///< a file that cannot be read, written or understood; Error::file says what is wrong with it
    NotConnected,  ///< there is no board
    Incomplete,  ///< parts of the board could not be read; the detail names them
    NoBackup,  ///< the safety copy could not be made, so nothing was changed
    TooMuch,  ///< more than the link can carry
    Unready,  ///< a precondition is not met
    ConditionUnmet,  ///< a condition of an action is not met, or unknown; the detail says which
    NotSeen,  ///< what a procedure waited for did not happen; the detail says what
    NotRestored,  ///< values in use were replaced and could not be restored; the detail lists them
    Diverged,  ///< an axis did not follow and was stopped
    NoSamples,  ///< live data do not come, or not any more
    TooFewSamples,  ///< what was received or recorded is too short to be measured
    NoMotion,  ///< what was received or recorded is the same all the time
    NotProven,  ///< commands were sent, but nothing the board reports proves that they took effect
    NotInUse,  ///< the board confirmed a live value, but uses another
    NotStored,  ///< the board confirmed storing what is in use, but holds something else; the detail says
                ///< what
    NoEffect,  ///< the board acknowledged a command, but does not report that it took effect
    Disabled,  ///< a stop has disabled the motors in volatile memory, and nothing may be stored meanwhile
    GoesOn,  ///< the board was told to end what it does, and goes on
    Restarted,  ///< the board has started anew; the link is set up again
    Busy,  ///< another job of the same kind is running
};
inline constexpr std::size_t kErrorCodes = std::size_t(ErrorCode::Busy) + 1;

/// A place in a text that a board keeps.
struct TextPlace
{
    int block = 0;  ///< BlockSpec::id
    int line = 0;  ///< from 1; 0 = the text as a whole

    friend bool operator==(const TextPlace &, const TextPlace &) = default;
};

/// An error as a value: a code, details for experts and, for BoardError, the board's own number.
struct Error
{
    ErrorCode code = ErrorCode::BadReply;
    QString detail;
    int boardCode = 0;
    std::shared_ptr<const FileFault> file = {};  ///< for BadFile and NoBackup: see protocol/base/filefault.h
    /// What the board holds, where something was sent before it failed; see
    /// protocol/configuration/aftermath.h
    std::shared_ptr<const Aftermath> after = {};
    /// Where in a text that the board keeps it can be mended.
    std::optional<TextPlace> place = {};

    friend bool operator==(const Error &a, const Error &b);
};

template <typename T> using Result = tl::expected<T, Error>;

/// One more thing to tell, behind what the detail tells already.
inline void addDetail(QString &detail, const QString &more)
{
    if (!detail.isEmpty() && !more.isEmpty())
        detail += QLatin1String("; ");
    detail += more;
}

/// Short form for returning an error: `return failure(ErrorCode::Timeout, u"BOARD_INFO"_s);`
inline tl::unexpected<Error> failure(ErrorCode code, QString detail = {}, int boardCode = 0)
{
    return tl::unexpected<Error>(Error{code, std::move(detail), boardCode});
}
