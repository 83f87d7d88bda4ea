// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"

#include <map>

/// A channel on which the answers to some questions about blocks get lost.
class LossyChannel final : public Channel
{
public:
    explicit LossyChannel(Channel &channel)
        : m_channel(channel)
    {
    }
    /// The next so many of these questions about that profile stay unanswered.
    void lose(simplebgc::CommandId command, int profile, int times)
    {
        m_losses[{int(command), profile}] = times;
    }
    /// Questions that stayed unanswered so far.
    [[nodiscard]] int lost() const { return m_lost; }

    Result<Frame> transact(const Request &request) override
    {
        std::optional<Error> lost;
        simplebgc::Framer framer;
        framer.feed(asBytes(request.bytes), [&](const FrameView &frame) {
            const auto loss = frame.payload.empty()
                ? m_losses.end()
                : m_losses.find({frame.id, std::to_integer<int>(frame.payload[0])});
            if (loss != m_losses.end() && loss->second-- > 0)
                lost = Error{ErrorCode::Timeout, request.name, 0};
        });
        m_lost += lost.has_value();
        return lost ? tl::unexpected(*lost) : m_channel.transact(request);
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
    void stopMotors(const StopPlan &plan) override { m_channel.stopMotors(plan); }
    void expectSilence(milliseconds duration) override { m_channel.expectSilence(duration); }
    [[nodiscard]] bool cancelled() const override { return m_channel.cancelled(); }
    void progress(const Progress &progress) override { m_channel.progress(progress); }
    [[nodiscard]] TimePoint now() const override { return m_channel.now(); }
    [[nodiscard]] LinkObservation observation() const override { return m_channel.observation(); }

private:
    Channel &m_channel;
    std::map<std::pair<int, int>, int> m_losses;  // by command and profile
    int m_lost = 0;
};
