// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/faults.h"
#include "protocol/simulator/world/plant.h"

#include <optional>

namespace simplebgc {

/// A transmitter in somebody's hands, and its receiver at the board's inputs.
class SimulatedReceiver
{
public:
    explicit SimulatedReceiver(unsigned seed)
        : m_noise(seed)
    {
    }

    void step(const Faults &faults, double seconds);
    /// Something arrives from the transmitter.
    [[nodiscard]] bool isReceiving() const { return m_silence < kFailsafe; }
    /// -1 to 1; empty: there is none. @param inputMode what the board expects at RC_ROLL (RC_VIRT_MODE)
    [[nodiscard]] std::optional<double> signal(int source, int inputMode) const;

private:
    enum Stick { Roll, Pitch, Throttle, Yaw, Switch, StickCount };
    static constexpr double kFailsafe = 0.5;  // seconds without a frame

    int m_kind = 0;  // see Faults::receiver
    std::array<double, StickCount> m_sticks{0, 0, -1, 0, 0};
    std::array<double, StickCount> m_received{};
    double m_sinceFrame = 0;
    double m_silence = kFailsafe;
    SimulatedNoise m_noise;
};

}  // namespace simplebgc
