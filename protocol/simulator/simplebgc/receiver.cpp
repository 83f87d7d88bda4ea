// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/simplebgc/receiver.h"

#include <algorithm>

namespace simplebgc {

namespace {

constexpr double kFrame = 0.02;  // seconds
constexpr double kTravel = 0.96;  // of the whole way
constexpr double kStickSpeed = 8;  // ways a second
constexpr double kPulseWay = 500;  // µs from the middle to an end
constexpr int kPulses = 1;  // a wire for each channel
constexpr int kFirstSerialSource = 65;  // errata 4.3
constexpr int kRcRollPin = 1;
constexpr int kRcPitchPin = 2;
constexpr int kFcRollWire = 3;
constexpr int kRcYawPin = 5;

}  // namespace

void SimulatedReceiver::step(const Faults &faults, double seconds)
{
    const auto end = [&faults](int one, int other) {
        return faults.stick == one ? kTravel : faults.stick == other ? -kTravel : 0.0;
    };
    const bool areTwo = faults.stick == 9;
    const std::array<double, StickCount> held{areTwo ? kTravel : end(1, 2), areTwo ? kTravel : end(3, 4), -1,
                                              end(5, 6), end(7, 8)};
    for (std::size_t i = 0; i < held.size(); ++i)
        m_sticks[i] += std::clamp(held[i] - m_sticks[i], -kStickSpeed * seconds, kStickSpeed * seconds);
    m_kind = faults.receiver;
    m_sinceFrame += seconds;
    m_silence += seconds;
    if (m_kind == 0)
        m_silence = kFailsafe;
    if (m_kind == 0 || m_sinceFrame < kFrame)
        return;
    m_sinceFrame = 0;
    if (m_noise.chance(faults.rcLoss))
        return;
    m_silence = 0;
    for (std::size_t i = 0; i < held.size(); ++i)
        m_received[i] = std::clamp(m_sticks[i] + m_noise.gauss(faults.rcNoise) / kPulseWay, -1.0, 1.0);
}

// The modes of the input are numbered as the kinds of receivers are, from normal pulses on (document,
// RC_VIRT_MODE).
std::optional<double> SimulatedReceiver::signal(int source, int inputMode) const
{
    if (!isReceiving() || inputMode != m_kind - kPulses)
        return {};
    if (m_kind != kPulses) {
        const int channel = source - kFirstSerialSource;
        return channel >= 0 && channel < StickCount ? std::optional(m_received[std::size_t(channel)])
                                                    : std::nullopt;
    }
    switch (source) {
    case kRcRollPin: return m_received[Roll];
    case kRcPitchPin: return m_received[Pitch];
    case kRcYawPin: return m_received[Yaw];
    case kFcRollWire: return m_received[Switch];
    default: return {};
    }
}

}  // namespace simplebgc
