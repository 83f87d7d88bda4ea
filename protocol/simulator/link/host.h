// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/simulatedport.h"
#include "protocol/simulator/video/camerafeed.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

/// Runs a simulated port in real time and makes it available to clients. Lives on a thread with an event
/// loop.
class SimulatorHost : public QObject
{
    Q_OBJECT
public:
    explicit SimulatorHost(std::unique_ptr<SimulatedPort> port, QObject *parent = nullptr);

    /// Starts real time. Errors: InvalidArgument, PortBusy and the like, with an explanation.
    virtual Result<void> start();
    /// What a client connects to.
    [[nodiscard]] virtual QString address() const = 0;
    [[nodiscard]] SimulatedPort &port() { return *m_port; }
    /// From now on, what the board's camera sees goes in there.
    void setCameraFeed(std::shared_ptr<CameraFeed> feed) { m_camera = std::move(feed); }

protected:
    void hostWrote(QByteArrayView bytes) { m_port->hostWrites(asBytes(bytes)); }
    /// Delivers bytes, or one packet, to the client.
    virtual void deliver(const QByteArray &bytes) = 0;
    /// The cable was plugged in or pulled out, on hosts where a client can notice.
    virtual void plugged(bool) { }
    /// Called before time advances, to read the host's line settings and bytes.
    virtual void poll() { }

private:
    void onTick();

    std::unique_ptr<SimulatedPort> m_port;
    std::shared_ptr<CameraFeed> m_camera;
    QTimer m_timer;
    QElapsedTimer m_clock;
    qint64 m_simulatedNs = 0;
    bool m_plugged = true;
};
