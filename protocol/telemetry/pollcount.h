// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

#include <utility>

/// Samples that a board was asked for and did not send count as lost, until they come late.
class PollCount
{
public:
    void asked(TelemetryStore &store)
    {
        if (!std::exchange(m_isWaiting, true))
            return;
        ++m_unanswered;
        store.countLost(1);
    }
    void answered(TelemetryStore &store)
    {
        if (std::exchange(m_isWaiting, false) || m_unanswered == 0)
            return;
        --m_unanswered;
        store.countFound(1);
    }

private:
    bool m_isWaiting = false;
    quint64 m_unanswered = 0;
};
