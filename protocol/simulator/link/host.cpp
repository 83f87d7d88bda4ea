// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/host.h"

#include <algorithm>

namespace {

constexpr auto kTick = 2ms;
// After a pause of the whole machine the simulation catches up by no more than this.
constexpr qint64 kMaxCatchUpNs = 500'000'000;

}  // namespace

SimulatorHost::SimulatorHost(std::unique_ptr<SimulatedPort> port, QObject *parent)
    : QObject(parent)
    , m_port(std::move(port))
    , m_timer(this)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kTick);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorHost::onTick);
}

Result<void> SimulatorHost::start()
{
    m_clock.start();
    m_timer.start();
    return {};
}

void SimulatorHost::onTick()
{
    poll();
    const qint64 elapsed = m_clock.nsecsElapsed();
    m_simulatedNs = std::max(m_simulatedNs, elapsed - kMaxCatchUpNs);
    m_port->advance(std::chrono::nanoseconds(elapsed - m_simulatedNs));
    m_simulatedNs = elapsed;
    if (m_camera)
        m_camera->set(m_port->isPlugged() ? m_port->board().cameraView() : std::nullopt);
    if (m_plugged == m_port->isGone()) {
        m_plugged = !m_plugged;
        plugged(m_plugged);
    }
    for (const QByteArray &bytes : m_port->hostReads())
        deliver(bytes);
}
