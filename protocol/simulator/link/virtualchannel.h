// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"
#include "protocol/session/linktiming.h"
#include "protocol/session/transactionqueue.h"
#include "protocol/simulator/link/simulatedport.h"

#include <set>

/// A channel to a simulated board in virtual time, on a single thread: device and procedure code runs in
/// microseconds. Uses the same framer and the same transaction queue as the real session.
class VirtualChannel final : public Channel
{
public:
    VirtualChannel(SimulatedPort &port, std::unique_ptr<Framer> framer, LinkTiming timing = {});
    ~VirtualChannel() override;

    Result<Frame> transact(const Request &request) override;
    void post(const Request &request) override;
    Result<void> sleep(milliseconds duration) override;
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) override;
    Result<void> setLine(const LineSettings &line) override;
    void steer(const ControlFrames &frames) override
    {
        if (!m_stop.isActive())
            m_control.refresh(frames, now());
    }
    void releaseControl() override { m_control.end(now()); }
    void stopMotors(const StopPlan &plan) override;
    void expectSilence(milliseconds duration) override;
    void keepQuiet(milliseconds duration) override
    {
        m_nextBeat = std::max<TimePoint>(m_nextBeat, now() + duration);
        m_stop.boardIsDeaf(now() + duration);
    }
    [[nodiscard]] bool cancelled() const override { return !m_held && m_cancelAt && now() >= *m_cancelAt; }
    void holdCancel(bool held) override { m_held = held; }
    void progress(const Progress &progress) override;
    [[nodiscard]] TimePoint now() const override { return TimePoint() + 1h + m_port.now(); }
    [[nodiscard]] LinkObservation observation() const override;

    /// The job counts as cancelled from then on.
    void cancelAfter(Duration time) { m_cancelAt = now() + time; }
    /// Called for every frame that arrives, claimed or not.
    void setTap(std::function<void(const FrameView &, TimePoint)> tap) { m_tap = std::move(tap); }
    /// Where the tap puts telemetry, to see the effect of a stop.
    void setLatestValues(std::shared_ptr<const LatestValues> latest) { m_latest = std::move(latest); }
    /// Outcome of the last stop; empty until it ends.
    [[nodiscard]] const std::optional<Result<void>> &stopResult() const { return m_stopped; }
    /// How the last steering ended: the board was seen to stand still, or not.
    [[nodiscard]] const std::optional<bool> &stoodStill() const { return m_stoodStill; }
    /// Plays the operator: receives every progress report while the procedure waits.
    void setOperator(std::function<void(const Progress &)> person) { m_operator = std::move(person); }
    [[nodiscard]] const std::vector<Progress> &progressReports() const { return m_progress; }
    [[nodiscard]] TransactionQueue &queue() { return m_queue; }
    /// Bytes that went out so far, request after request.
    [[nodiscard]] qint64 bytesOut() const { return m_bytesOut; }

private:
    friend class VirtualMailbox;
    void step();
    void beat();
    [[nodiscard]] std::optional<Error> stopped() const;
    [[nodiscard]] bool isLost() const;

    SimulatedPort &m_port;
    std::unique_ptr<Framer> m_framer;
    FrameSink m_sink;
    TransactionQueue m_queue;
    LinkTiming m_timing;
    ControlStream m_control;
    StopSequence m_stop;
    std::shared_ptr<const LatestValues> m_latest;
    std::optional<Result<void>> m_stopped;
    bool m_isAsking = false;  // whether the board stands still
    std::optional<bool> m_stoodStill;
    std::set<class VirtualMailbox *> m_mailboxes;
    std::function<void(const FrameView &, TimePoint)> m_tap;
    std::function<void(const Progress &)> m_operator;
    std::vector<Progress> m_progress;
    std::optional<TimePoint> m_cancelAt;
    bool m_held = false;
    LinkObservation m_observed;  // but for the framer's part
    qint64 m_bytesOut = 0;
    TimePoint m_lastArrival{};
    TimePoint m_nextBeat{};
    TimePoint m_silentUntil{};  // silence is expected until then
};
