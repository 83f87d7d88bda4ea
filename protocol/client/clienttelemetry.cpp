// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the client requests live data and receives it.
#include "protocol/base/linkloss.h"
#include "protocol/client/deviceclient_p.h"
#include "protocol/device/abilities.h"

using namespace Qt::StringLiterals;

void DeviceClient::Private::installFeed(bool isSameBoard)
{
    auto fresh = std::make_unique<TelemetryFeed>(
        store,
        TelemetryFeed::Hooks{[this, board = device, kept = store,
                              state = roles.state](const FrameView &frame, TimePoint at, bool claimed) {
                                 const StatusWords *words = board->statusWords();
                                 if (const QString text = words ? words->messageText(frame) : QString();
                                     !text.isEmpty())
                                     back([this, text] { emit q.boardSpoke(text); });
                                 const bool isStreamed = !claimed && board->inspector()
                                     && board->inspector()->isTelemetryFrame(frame.id);
                                 watchForRestart(*board, frame, at, isStreamed, kept->latest(state));
                             },
                             [this, board = device](QByteArrayView bytes, TimePoint at) {
                                 const RestartNotice *notice = board->restartNotice();
                                 if (const auto after = notice ? notice->ordersReset(bytes) : std::nullopt)
                                     restarts.order(at + *after);
                             }});
    now([this, next = fresh.get(), old = feed.get(), board = device, isSameBoard] {
        restarts.meet(isSameBoard);
        watched = board;
        restartTimer->start();
        session->removeListener(old);
        session->addListener(next);
        session->setLatestValues(store);
    });
    feed = std::move(fresh);
}

void DeviceClient::Private::requestTelemetry()
{
    if (state != State::Connected || telemetryRequested)
        return;
    if (address.isReplay()) {
        startReplay();
        return;
    }
    Subscription wanted = subscription;
    if (const auto refused = refusal(wanted)) {
        emit q.telemetryFailed(*refused);
        if (plan.decoder)
            return;  // the previous arrangement stays in force
        wanted.streams.clear();
    }
    // Several subscriptions in one round of the event loop make one request.
    telemetryRequested = true;
    // Samples missed while streams are rearranged do not count as lost.
    now([this, feeding = feed.get()] {
        feeding->setDecoder(nullptr);
        restarts.end();
    });
    q.submit<TelemetryPlan>([wanted, wire = line](Channel &channel, Device &board) {
         return board.subscribe(channel, wanted, wire);
     }).then(&q, [this, asked = subscription](const Result<TelemetryPlan> &arranged) {
        telemetryRequested = false;
        if (state != State::Connected)
            return;
        if (arranged) {
            takePlan(*arranged, asked);
            return;
        }
        if (arranged.error().code == ErrorCode::Cancelled || isLinkLoss(arranged.error()))
            requestTelemetry();  // all jobs were cancelled, but telemetry is still wanted
        else
            emit q.telemetryFailed(arranged.error());
    });
}

void DeviceClient::Private::takePlan(const TelemetryPlan &arranged, const Subscription &asked)
{
    plan = arranged;
    now([this, link = session, feeding = feed.get(), arranged] {
        restarts.begin(Clock::now(), arranged.streaming && arranged.rate > 0 ? 1.0 / arranged.rate : 0.0);
        feeding->setDecoder(arranged.decoder);
        link->setPoll(arranged.poll, arranged.pollInterval);
        link->setShutdownFrames(arranged.shutdownFrames);
    });
    supervision->setPeriod(arranged.rate > 0 ? 1.0 / arranged.rate : 0.0);
    emit q.telemetryPlanChanged();
    if (subscription != asked)
        requestTelemetry();
}

// Streams that the line cannot carry are not requested.
std::optional<Error> DeviceClient::Private::refusal(const Subscription &wanted) const
{
    const StreamControl *streams = device->streamControl();
    if (!streams) {
        if (wanted.streams.isEmpty())
            return {};
        return Error{ErrorCode::InvalidArgument, u"this board has no streams; it is asked for each sample"_s};
    }
    const auto budget = streams->streamBudget(wanted, line);
    if (!budget)
        return budget.error();
    return budget->fits() ? std::nullopt : std::optional(budget->refusal());
}

// A recording has only the streams that were recorded; no others can be requested.
void DeviceClient::Private::startReplay()
{
    if (plan.decoder)
        return;
    plan.decoder = device->replayDecoder();
    plan.streaming = true;
    now([feeding = feed.get(), decoder = plan.decoder] { feeding->setDecoder(decoder); });
    replay.begin();
    emit q.telemetryPlanChanged();
}

void DeviceClient::subscribe(const Subscription &subscription)
{
    if (subscription == d->subscription)
        return;
    d->subscription = subscription;
    d->requestTelemetry();
}
