// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"
#include "protocol/session/session.h"

#include <atomic>
#include <condition_variable>
#include <mutex>

/// Shared between a job on the worker thread and the code that may cancel it.
class JobControl
{
public:
    /// @param why what the job fails with from now on; the first one counts
    void cancel(const Error &why = {ErrorCode::Cancelled, {}, 0});
    [[nodiscard]] bool isCancelled() const { return m_cancelled.load(std::memory_order_relaxed); }
    /// Once it is cancelled.
    [[nodiscard]] Error why();

private:
    friend class SessionChannel;
    friend class SessionMailbox;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    Error m_why;
    std::atomic<bool> m_cancelled = false;
};

/// The production channel: code on the worker thread talks to a session on the I/O thread.
class SessionChannel final : public Channel
{
public:
    /// What a job reports to its client, from any thread.
    struct Hooks
    {
        std::function<void(const Progress &)> progress;
        std::function<void(bool proven)> motorsStopped;
        /// What it steers with from now on; null when it ends.
        std::function<void(const ControlFrames *)> steered = {};
        /// The board hears nothing for so long.
        std::function<void(milliseconds)> deaf = {};
    };

    enum class Link { Open, NotYet };

    /// The session must outlive the channel; the control is shared with the code that may cancel.
    /// @param link whether the job starts on an open link, whose end then ends every wait
    SessionChannel(Session &session, std::shared_ptr<JobControl> control, Hooks hooks, Link link);
    ~SessionChannel() override;

    Result<Frame> transact(const Request &request) override;
    void post(const Request &request) override;
    Result<void> sleep(milliseconds duration) override;
    /// The same, whether there is a link or not.
    Result<void> pause(milliseconds duration);
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) override;
    Result<void> setLine(const LineSettings &line) override;
    void steer(const ControlFrames &frames) override;
    void releaseControl() override;
    void allowMotors() override;
    void stopMotors(const StopPlan &plan) override;
    void expectSilence(milliseconds duration) override;
    void keepQuiet(milliseconds duration) override;
    [[nodiscard]] bool cancelled() const override { return !m_held && m_control->isCancelled(); }
    void holdCancel(bool held) override { m_held = held; }
    void progress(const Progress &progress) override { m_hooks.progress(progress); }
    [[nodiscard]] TimePoint now() const override { return Clock::now(); }
    [[nodiscard]] LinkObservation observation() const override;

    /// Opens the link and waits until it is open. Errors: those of the transport.
    Result<void> open(const LinkAddress &address, std::unique_ptr<Framer> framer, const LinkTiming &timing);

private:
    Session &m_session;
    std::shared_ptr<JobControl> m_control;
    Hooks m_hooks;
    struct LinkWatch;
    std::shared_ptr<LinkWatch> m_link;
    std::array<QMetaObject::Connection, 2> m_watches;
    bool m_held = false;
};
