// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"

#include <algorithm>

/// Another channel, on which a question waits longer for its answer and is asked once: what comes then
/// belongs to it, however slow the board is.
class PatientChannel final : public Channel
{
public:
    PatientChannel(Channel &channel, milliseconds patience)
        : m_channel(channel)
        , m_patience(patience)
    {
    }

    Result<Frame> transact(const Request &request) override
    {
        Request once = request;
        once.timeout = std::max(request.timeout, m_patience);
        once.retries = 0;
        return m_channel.transact(once);
    }
    void post(const Request &request) override { m_channel.post(request); }
    Result<void> sleep(milliseconds duration) override { return m_channel.sleep(duration); }
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) override
    {
        return m_channel.listen(std::move(filter));
    }
    Result<void> setLine(const LineSettings &line) override { return m_channel.setLine(line); }
    void steer(const ControlFrames &frames) override { m_channel.steer(frames); }
    void releaseControl() override { m_channel.releaseControl(); }
    void allowMotors() override { m_channel.allowMotors(); }
    void stopMotors(const StopPlan &plan) override { m_channel.stopMotors(plan); }
    void expectSilence(milliseconds duration) override { m_channel.expectSilence(duration); }
    [[nodiscard]] bool cancelled() const override { return m_channel.cancelled(); }
    void holdCancel(bool held) override { m_channel.holdCancel(held); }
    void progress(const Progress &progress) override { m_channel.progress(progress); }
    [[nodiscard]] TimePoint now() const override { return m_channel.now(); }
    [[nodiscard]] LinkObservation observation() const override { return m_channel.observation(); }

private:
    Channel &m_channel;
    const milliseconds m_patience;
};
