// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"
#include "tests/support/channelproxy.h"

#include <map>

/// A channel on which the answers to some questions about blocks get lost.
class LossyChannel final : public ChannelProxy
{
public:
    explicit LossyChannel(Channel &channel)
        : ChannelProxy(channel)
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
        return lost ? tl::unexpected(*lost) : ChannelProxy::transact(request);
    }

private:
    std::map<std::pair<int, int>, int> m_losses;  // by command and profile
    int m_lost = 0;
};
