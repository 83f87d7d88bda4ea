// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/simulatedport.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

/// Runs a simulated port in real time and offers it to the world. Lives on a thread with an event loop.
class SimulatorHost : public QObject
{
    Q_OBJECT
public:
    explicit SimulatorHost(std::unique_ptr<SimulatedPort> port, QObject *parent = nullptr);

    /// Starts real time. Errors: InvalidArgument, PortBusy and the like, in words.
    virtual Result<void> start();
    /// What a client connects to.
    [[nodiscard]] virtual QString address() const = 0;
    [[nodiscard]] SimulatedPort &port() { return *m_port; }

protected:
    void hostWrote(QByteArrayView bytes) { m_port->hostWrites(asBytes(bytes)); }
    /// Bytes for the client, or one packet.
    virtual void deliver(const QByteArray &bytes) = 0;
    /// The cable went in or out, where a client notices.
    virtual void plugged(bool) { }
    /// Called before time passes, to look at the host's line settings and bytes.
    virtual void poll() { }

private:
    void onTick();

    std::unique_ptr<SimulatedPort> m_port;
    QTimer m_timer;
    QElapsedTimer m_clock;
    qint64 m_simulatedNs = 0;
    bool m_plugged = true;
};
