// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/frame.h"
#include "protocol/base/result.h"

#include <optional>

/// Decides whether a frame answers a request: nothing = no; otherwise the reply, or the board's refusal as an
/// error.
using AnswerMatcher = std::function<std::optional<Result<Frame>>(const FrameView &)>;

/// Everything about one request: what is sent, what answers it, how long to wait, whether it may be repeated.
struct Request
{
    QString name;  ///< for logs and errors, e.g. "READ_PARAMS_3"
    QByteArray bytes;  ///< the complete frame
    AnswerMatcher answer;  ///< empty: none expected, done as soon as the bytes have been sent
    int kind = 0;  ///< a reply could be taken for that to another request of the same kind
    int replyBytes = 0;  ///< expected size of the reply on the wire, for the timeout
    milliseconds timeout = 300ms;  ///< the board's own time to answer, in addition to the line's
    int retries = 0;  ///< after a timeout or a damaged command; used for idempotent requests only
    bool idempotent = false;
    /// Sent again and again, and any answer will do: it is not held back for a late one.
    bool repeated = false;
};
