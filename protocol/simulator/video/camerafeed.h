// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/cameraview.h"

#include <mutex>
#include <optional>

/// From the thread on which a board is simulated to the one that encodes what its camera sees.
class CameraFeed
{
public:
    void set(const std::optional<CameraView> &view)
    {
        const std::lock_guard lock(m_mutex);
        m_view = view;
    }
    /// Empty: it has no camera, or is switched off.
    [[nodiscard]] std::optional<CameraView> view() const
    {
        const std::lock_guard lock(m_mutex);
        return m_view;
    }

private:
    mutable std::mutex m_mutex;
    std::optional<CameraView> m_view;
};
