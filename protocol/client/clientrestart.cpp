// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the client does when the link breaks or the board restarts.
#include "protocol/client/deviceclient_p.h"
#include "protocol/device/abilities.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kReconnectPause = 500ms;
// A board that announces its restart may go on sending for up to a second (document CMD_RESET); we let go of
// the link before it restarts.
constexpr auto kLetGoBeforeReset = 300ms;
constexpr auto kRestartTime = 1500ms;

}  // namespace

DeviceClient::Loss DeviceClient::loss() const
{
    return d->loss;
}

void DeviceClient::Private::watchForRestart(const Device &board, const FrameView &frame, TimePoint at,
                                            bool isStreamed, float boardState)
{
    restarts.heard(at, isStreamed);
    const RestartNotice *notice = board.restartNotice();
    if (!notice)
        return;
    if (notice->announcesReset(frame))
        back([this] { onResetAnnounced(); });
    if (std::isnan(boardState) || !restarts.takeState(notice->isFreshlyStarted(int(boardState))))
        return;
    // Such a board goes on answering; whoever told it to restart knows what to expect.
    if (!restarts.takeOrder(at))
        back([this] { onRestarted(u"it goes through its start again"_s, false); });
}

void DeviceClient::Private::lookForRestart(const std::shared_ptr<Device> &board)
{
    const RestartNotice *notice = board ? board->restartNotice() : nullptr;
    if (!notice)
        return;
    switch (restarts.look(Clock::now(), session->silentUntil())) {
    case RestartWatch::Step::Wait: return;
    case RestartWatch::Step::Ask:
        session->submit(notice->harmlessQuestion(), [this](const Result<Frame> &answer) {
            restarts.answered(answer || answer.error().code == ErrorCode::BoardError, Clock::now());
        });
        return;
    case RestartWatch::Step::StreamsEnded: back([this] { requestTelemetry(); }); return;
    case RestartWatch::Step::Restarted: {
        const bool isOrdered = restarts.takeOrder(Clock::now()).has_value();
        back([this, isOrdered] { onRestarted(u"it was silent, and its streams are gone"_s, isOrdered); });
    }
    }
}

void DeviceClient::Private::onSessionClosed(const Error &why)
{
    if (state != State::Connected)
        return;
    std::optional<TimePoint> due;
    now([this, &due] { due = restarts.takeOrder(Clock::now()); });
    loss = due ? Loss::OrderedRestart : Loss::Link;
    emit q.connectionLost(due ? Error{ErrorCode::Restarted, why.detail} : why);
    stopIsUnproven = false;
    // Jobs that waited for this link end with it; they must not start unexpectedly on the next one.
    cancelJobs({ErrorCode::LinkClosed, why.detail, 0});
    startAttempt(State::Reconnecting, why.code == ErrorCode::Cancelled ? 0ms : kReconnectPause);
}

void DeviceClient::Private::onResetAnnounced()
{
    if (state != State::Connected)
        return;
    QTimer::singleShot(kLetGoBeforeReset, &q, [this] {
        if (state != State::Connected)
            return;
        std::optional<TimePoint> due;
        now([this, &due] { due = restarts.takeOrder(Clock::now()); });
        loss = due ? Loss::OrderedRestart : Loss::Restart;
        const auto left = due ? std::chrono::ceil<milliseconds>(*due - Clock::now()) : 0ms;
        renewLink({ErrorCode::Restarted, u"it has announced that"_s}, kRestartTime + std::max(0ms, left));
    });
}

void DeviceClient::Private::onRestarted(const QString &evidence, bool isOrdered)
{
    if (state != State::Connected || address.isReplay())
        return;
    loss = isOrdered ? Loss::OrderedRestart : Loss::Restart;
    renewLink({ErrorCode::Restarted, evidence}, 0ms);
}

void DeviceClient::Private::renewLink(const Error &why, milliseconds pause)
{
    emit q.connectionLost(why);
    stopIsUnproven = false;
    cancelJobs(loss == Loss::Restart ? why : Error{ErrorCode::LinkClosed, why.detail, 0});
    later([link = session, why] { link->leaveRestarted(why); });
    startAttempt(State::Reconnecting, pause);
}
