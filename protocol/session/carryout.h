// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

/// Carries out a plan over a channel, to the end of what it restores. Errors: NotProven, NotRestored, those
/// of the channel.
Result<void> carryOut(Channel &channel, const StopPlan &plan);
/// Asks again and again, for at most `limit`, until an answer holds. Returns whether one did. Errors: those
/// of the channel.
Result<bool> holdsWithin(Channel &channel, const Request &question, milliseconds limit,
                         const std::function<bool(const Frame &)> &holds);
