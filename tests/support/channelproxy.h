// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channelproxy.h"

#include <functional>
#include <utility>

/// Each request goes through a function, which may alter it, answer for the board, or let it pass.
class Altering final : public ChannelProxy
{
public:
    using Pass = std::function<Result<Frame>(const Request &)>;
    using Alter = std::function<Result<Frame>(const Request &, const Pass &)>;
    Altering(Channel &channel, Alter alter)
        : ChannelProxy(channel)
        , m_alter(std::move(alter))
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        return m_alter(request, [this](const Request &passed) { return ChannelProxy::transact(passed); });
    }

private:
    Alter m_alter;
};
