// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/carryout.h"

#include "protocol/base/linkloss.h"

#include <optional>

Result<void> carryOut(Channel &channel, const StopPlan &plan)
{
    std::optional<Result<void>> stopped;
    std::optional<Result<void>> restored;
    std::optional<Error> broken;
    StopSequence sequence([&](const Request &request, const StopSequence::Answered &answered) {
        const auto reply = channel.transact(request);
        if (!reply && (isLinkLoss(reply.error()) || reply.error().code == ErrorCode::Cancelled))
            broken = reply.error();
        else
            answered(reply);
    });
    sequence.start(
        plan, [&](const Result<void> &result) { stopped = result; }, channel.now(),
        [&](const Result<void> &result) { restored = result; });
    while (const auto due = sequence.nextDeadline()) {
        if (broken)
            return tl::unexpected(*broken);
        const auto wait = std::chrono::ceil<milliseconds>(*due - channel.now());
        if (wait > 0ms) {
            if (const auto slept = channel.sleep(wait); !slept)
                return slept;
        }
        sequence.advance(channel.now());
    }
    if (!stopped)
        return failure(ErrorCode::NotProven);
    return *stopped ? restored.value_or(Result<void>()) : *stopped;
}

Result<bool> holdsWithin(Channel &channel, const Request &question, milliseconds limit,
                         const std::function<bool(const Frame &)> &holds)
{
    const TimePoint end = channel.now() + limit;
    while (channel.now() < end) {
        const auto answer = channel.transact(question);
        if (!answer)
            return tl::unexpected(answer.error());
        if (holds(*answer))
            return true;
        if (const auto slept = channel.sleep(100ms); !slept)
            return tl::unexpected(slept.error());
    }
    return false;
}
