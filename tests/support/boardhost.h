// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/tcphost.h"
#include "protocol/simulator/link/udphost.h"

#include <QThread>

#include <type_traits>

/// A simulated board behind a host with a thread of its own, as a board is: a window that is busy does not
/// keep it from answering.
template <typename Host> class BoardBehind
{
public:
    explicit BoardBehind(std::unique_ptr<SimulatedPort> port)
        : m_host(new Host(std::move(port), 0))
    {
        m_host->moveToThread(&m_thread);
        QObject::connect(&m_thread, &QThread::finished, m_host, &QObject::deleteLater);
        m_thread.start();
    }
    ~BoardBehind()
    {
        m_thread.quit();
        m_thread.wait();
    }
    Q_DISABLE_COPY_MOVE(BoardBehind)
    [[nodiscard]] bool start()
    {
        return at([this] { return m_host->start().has_value(); });
    }
    [[nodiscard]] QString address()
    {
        return at([this] { return m_host->address(); });
    }
    /// What `ask` returns of the board, or does to it, on the board's thread while this one waits.
    template <typename Board, typename Ask> auto with(Ask ask)
    {
        return at([this, &ask] { return ask(static_cast<Board &>(m_host->port().board())); });
    }
    /// Changes what is around it: a fault as NAME=VALUE.
    [[nodiscard]] bool change(const QString &assignment)
    {
        return at([&] { return m_host->port().change(assignment).has_value(); });
    }
    /// What its camera sees goes in there from now on.
    void setCameraFeed(const std::shared_ptr<CameraFeed> &feed)
    {
        at([&] { m_host->setCameraFeed(feed); });
    }

private:
    template <typename Ask> std::invoke_result_t<Ask> at(Ask ask)
    {
        if constexpr (std::is_void_v<std::invoke_result_t<Ask>>) {
            QMetaObject::invokeMethod(m_host, ask, Qt::BlockingQueuedConnection);
        } else {
            std::invoke_result_t<Ask> answer{};
            QMetaObject::invokeMethod(
                m_host, [&] { answer = ask(); }, Qt::BlockingQueuedConnection);
            return answer;
        }
    }

    QThread m_thread;
    Host *m_host;  // lives on the thread, which deletes it
};

using BoardHost = BoardBehind<TcpHost>;
using DatagramBoardHost = BoardBehind<UdpHost>;
