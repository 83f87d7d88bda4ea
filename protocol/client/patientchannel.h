// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channelproxy.h"

#include <algorithm>

/// Another channel, on which a question waits longer for its answer and is asked once: what comes then
/// belongs to it, however slow the board is.
class PatientChannel final : public ChannelProxy
{
public:
    PatientChannel(Channel &channel, milliseconds patience)
        : ChannelProxy(channel)
        , m_patience(patience)
    {
    }

    Result<Frame> transact(const Request &request) override
    {
        Request once = request;
        once.timeout = std::max(request.timeout, m_patience);
        once.retries = 0;
        return ChannelProxy::transact(once);
    }

private:
    const milliseconds m_patience;
};
