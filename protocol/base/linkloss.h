// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

/// The link was lost, or the board on it has started anew, while the job ran.
[[nodiscard]] inline bool isLinkLoss(const Error &error)
{
    return error.code == ErrorCode::LinkClosed || error.code == ErrorCode::Restarted;
}

/// A command was refused, or its answer did not come: whether it was carried out all the same, the state
/// afterwards tells.
[[nodiscard]] inline bool isUntoldByAnswer(const Error &error)
{
    return error.code == ErrorCode::BoardError || error.code == ErrorCode::Timeout;
}
