// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/simulator/video/camerafeed.h"

#include <QThread>

#include <memory>

/// The video port of a simulated drone on the loopback interface: encodes what its camera sees, on a thread
/// of its own, and sends it to whoever wrote last. Unlike a drone it stops when nobody has written for some
/// seconds, so that a demonstration which nobody watches costs nothing.
class CameraServer
{
public:
    static constexpr int kWidth = 1280;
    static constexpr int kHeight = 720;

    explicit CameraServer(std::shared_ptr<const CameraFeed> feed);
    ~CameraServer();
    CameraServer(const CameraServer &) = delete;
    CameraServer &operator=(const CameraServer &) = delete;

    /// @param port 0 = any. Errors: PortBusy, Unsupported (the video module is missing)
    Result<void> start(quint16 port);
    [[nodiscard]] quint16 port() const { return m_port; }
    /// No encoder for H.264 is installed: JPEGs are sent, whatever the board says.
    [[nodiscard]] bool isWithoutH264() const { return m_isWithoutH264; }

private:
    std::shared_ptr<const CameraFeed> m_feed;
    QThread m_thread;
    quint16 m_port = 0;
    bool m_isWithoutH264 = false;
};
