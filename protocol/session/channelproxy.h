// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"

#include <utility>

/// Passes everything on to another channel; whoever derives from it changes some of that.
class ChannelProxy : public Channel
{
public:
    explicit ChannelProxy(Channel &channel)
        : m_channel(channel)
    {
    }
    Result<Frame> transact(const Request &request) override { return m_channel.transact(request); }
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
    void keepQuiet(milliseconds duration) override { m_channel.keepQuiet(duration); }
    [[nodiscard]] bool cancelled() const override { return m_channel.cancelled(); }
    void holdCancel(bool held) override { m_channel.holdCancel(held); }
    void progress(const Progress &progress) override { m_channel.progress(progress); }
    [[nodiscard]] TimePoint now() const override { return m_channel.now(); }
    [[nodiscard]] LinkObservation observation() const override { return m_channel.observation(); }

private:
    Channel &m_channel;
};
