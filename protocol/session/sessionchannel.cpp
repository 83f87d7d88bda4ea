// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/sessionchannel.h"

#include <QMetaObject>

namespace {

/// Where the worker waits for one answer from the I/O thread. Completed exactly once; a handle that is
/// destroyed unused (the session died before it ran) completes it with LinkClosed.
template <typename T> struct Waiter
{
    std::shared_ptr<JobControl> control;
    std::mutex &mutex;
    std::condition_variable &wake;
    std::optional<Result<T>> result;

    Waiter(std::shared_ptr<JobControl> c, std::mutex &m, std::condition_variable &w)
        : control(std::move(c))
        , mutex(m)
        , wake(w)
    {
    }

    void complete(Result<T> value)
    {
        const std::lock_guard lock(mutex);
        if (!result)
            result = std::move(value);
        wake.notify_all();
    }
};

template <typename T> std::shared_ptr<Waiter<T>> completionHandle(const std::shared_ptr<Waiter<T>> &waiter)
{
    return {waiter.get(), [waiter](Waiter<T> *w) { w->complete(failure(ErrorCode::LinkClosed)); }};
}

}  // namespace

void JobControl::cancel(const Error &why)
{
    const std::lock_guard lock(m_mutex);
    if (!m_cancelled.exchange(true))
        m_why = why;
    m_wake.notify_all();
}

Error JobControl::why()
{
    const std::lock_guard lock(m_mutex);
    return m_why;
}

/// What the worker knows about the link. Guarded by the control's mutex.
struct SessionChannel::LinkWatch
{
    bool open = false;
    std::optional<Error> lost;
};

SessionChannel::SessionChannel(Session &session, std::shared_ptr<JobControl> control, Hooks hooks, Link link)
    : m_session(session)
    , m_control(std::move(control))
    , m_hooks(std::move(hooks))
    , m_link(std::make_shared<LinkWatch>())
{
    m_link->open = link == Link::Open;
    // Called on the I/O thread, where the session lives; the waiting code is on the worker thread.
    m_watches[0] = QObject::connect(&session, &Session::opened, [control = m_control, watch = m_link] {
        const std::lock_guard lock(control->m_mutex);
        watch->open = true;
        watch->lost.reset();
    });
    m_watches[1] = QObject::connect(&session, &Session::closed,
                                    [control = m_control, watch = m_link](const Error &why) {
                                        const std::lock_guard lock(control->m_mutex);
                                        if (std::exchange(watch->open, false))
                                            watch->lost = Error{ErrorCode::LinkClosed, why.detail};
                                        control->m_wake.notify_all();
                                    });
}

SessionChannel::~SessionChannel()
{
    for (const QMetaObject::Connection &watch : m_watches)
        QObject::disconnect(watch);
}

Result<Frame> SessionChannel::transact(const Request &request)
{
    if (cancelled())
        return tl::unexpected(m_control->why());
    auto waiter = std::make_shared<Waiter<Frame>>(m_control, m_control->m_mutex, m_control->m_wake);
    auto id = std::make_shared<std::atomic<TransactionQueue::Id>>(0);
    QMetaObject::invokeMethod(
        &m_session,
        [session = &m_session, request, id, handle = completionHandle(waiter)] {
            *id = session->submit(request,
                                  [handle](Result<Frame> result) { handle->complete(std::move(result)); });
        },
        Qt::QueuedConnection);

    std::unique_lock lock(m_control->m_mutex);
    m_control->m_wake.wait(lock, [&] { return waiter->result || cancelled(); });
    if (waiter->result)
        return *waiter->result;
    lock.unlock();
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session, id] { session->cancel(*id); }, Qt::QueuedConnection);
    return tl::unexpected(m_control->why());
}

void SessionChannel::post(const Request &request)
{
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session, request] { session->submit(request, {}); }, Qt::QueuedConnection);
}

Result<void> SessionChannel::sleep(milliseconds duration)
{
    std::unique_lock lock(m_control->m_mutex);
    m_control->m_wake.wait_for(lock, duration, [&] { return cancelled() || m_link->lost; });
    if (cancelled())
        return tl::unexpected(m_control->m_why);
    if (m_link->lost)
        return tl::unexpected(*m_link->lost);
    return {};
}

Result<void> SessionChannel::pause(milliseconds duration)
{
    std::unique_lock lock(m_control->m_mutex);
    m_control->m_wake.wait_for(lock, duration, [&] { return cancelled(); });
    return cancelled() ? tl::unexpected(m_control->m_why) : Result<void>();
}

class SessionMailbox final : public Mailbox, public FrameListener
{
public:
    /// @param isHeld whether what is cancelled goes on for now (Channel::holdCancel()); read by the job alone
    SessionMailbox(Session &session, std::shared_ptr<JobControl> control, const bool &isHeld,
                   std::function<bool(const FrameView &)> filter)
        : m_session(session)
        , m_control(std::move(control))
        , m_isHeld(isHeld)
        , m_filter(std::move(filter))
    {
        m_closedConnection = QObject::connect(
            &session, &Session::closed, &session,
            [this](const Error &why) {
                const std::lock_guard lock(m_control->m_mutex);
                m_closed = Error{ErrorCode::LinkClosed, why.detail};
                m_control->m_wake.notify_all();
            },
            Qt::DirectConnection);
        QMetaObject::invokeMethod(
            &m_session, [this] { m_session.addListener(this); }, Qt::BlockingQueuedConnection);
    }

    ~SessionMailbox() override
    {
        QMetaObject::invokeMethod(
            &m_session,
            [this] {
                m_session.removeListener(this);
                QObject::disconnect(m_closedConnection);
            },
            Qt::BlockingQueuedConnection);
    }

    SessionMailbox(const SessionMailbox &) = delete;
    SessionMailbox &operator=(const SessionMailbox &) = delete;

    void frameReceived(const FrameView &frame, TimePoint, bool claimed) override
    {
        if (claimed || !m_filter(frame))
            return;
        const std::lock_guard lock(m_control->m_mutex);
        m_frames.push_back(Frame(frame));
        m_control->m_wake.notify_all();
    }

    Result<Frame> next(milliseconds timeout) override
    {
        std::unique_lock lock(m_control->m_mutex);
        const auto isCancelled = [&] { return !m_isHeld && m_control->isCancelled(); };
        m_control->m_wake.wait_for(lock, timeout,
                                   [&] { return !m_frames.empty() || m_closed || isCancelled(); });
        if (isCancelled())
            return tl::unexpected(m_control->m_why);
        if (!m_frames.empty()) {
            Frame frame = std::move(m_frames.front());
            m_frames.pop_front();
            return frame;
        }
        if (m_closed)
            return tl::unexpected(*m_closed);
        return failure(ErrorCode::Timeout);
    }

private:
    Session &m_session;
    std::shared_ptr<JobControl> m_control;
    const bool &m_isHeld;
    std::function<bool(const FrameView &)> m_filter;
    std::deque<Frame> m_frames;
    std::optional<Error> m_closed;
    QMetaObject::Connection m_closedConnection;
};

std::unique_ptr<Mailbox> SessionChannel::listen(std::function<bool(const FrameView &)> filter)
{
    return std::make_unique<SessionMailbox>(m_session, m_control, m_held, std::move(filter));
}

Result<void> SessionChannel::setLine(const LineSettings &line)
{
    bool ok = false;
    QMetaObject::invokeMethod(
        &m_session, [&] { ok = m_session.setLine(line); }, Qt::BlockingQueuedConnection);
    if (!ok)
        return failure(ErrorCode::Unsupported, QString::number(line.baud));
    return {};
}

LinkObservation SessionChannel::observation() const
{
    LinkObservation observation;
    QMetaObject::invokeMethod(
        &m_session, [&] { observation = m_session.observation(); }, Qt::BlockingQueuedConnection);
    return observation;
}

void SessionChannel::steer(const ControlFrames &frames)
{
    if (m_hooks.steered)
        m_hooks.steered(&frames);
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session, frames] { session->refreshControl(frames); },
        Qt::QueuedConnection);
}

void SessionChannel::releaseControl()
{
    if (m_hooks.steered)
        m_hooks.steered(nullptr);
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session] { session->endControl(); }, Qt::QueuedConnection);
}

void SessionChannel::allowMotors()
{
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session] { session->allowMotors(); }, Qt::QueuedConnection);
}

void SessionChannel::stopMotors(const StopPlan &plan)
{
    QMetaObject::invokeMethod(
        &m_session,
        [session = &m_session, plan, told = m_hooks.motorsStopped] {
            session->stopMotors(plan, [told](const Result<void> &result) {
                if (told)
                    told(result.has_value());
            });
        },
        Qt::QueuedConnection);
}

void SessionChannel::expectSilence(milliseconds duration)
{
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session, duration] { session->expectSilence(duration); },
        Qt::QueuedConnection);
}

void SessionChannel::keepQuiet(milliseconds duration)
{
    if (m_hooks.deaf)
        m_hooks.deaf(duration);
    QMetaObject::invokeMethod(
        &m_session, [session = &m_session, duration] { session->keepQuiet(duration); }, Qt::QueuedConnection);
}

Result<void> SessionChannel::open(const LinkAddress &address, std::unique_ptr<Framer> framer,
                                  const LinkTiming &timing)
{
    auto waiter = std::make_shared<Waiter<bool>>(m_control, m_control->m_mutex, m_control->m_wake);
    auto owned = std::make_shared<std::unique_ptr<Framer>>(std::move(framer));
    QMetaObject::invokeMethod(
        &m_session,
        [session = &m_session, address, owned, timing, handle = completionHandle(waiter)] {
            session->finish([session, address, owned, timing, handle] {
                // Whichever comes first ends the wait and both watchers.
                auto *watch = new QObject(session);
                QObject::connect(session, &Session::opened, watch, [watch, handle] {
                    handle->complete(true);
                    watch->deleteLater();
                });
                QObject::connect(session, &Session::closed, watch, [watch, handle](const Error &why) {
                    handle->complete(tl::unexpected(why));
                    watch->deleteLater();
                });
                session->open(address, std::move(*owned), timing);
            });
        },
        Qt::QueuedConnection);
    std::unique_lock lock(m_control->m_mutex);
    m_control->m_wake.wait(lock, [&] { return waiter->result || m_control->isCancelled(); });
    if (m_control->isCancelled())
        return tl::unexpected(m_control->m_why);
    if (!*waiter->result)
        return tl::unexpected(waiter->result->error());
    return {};
}
