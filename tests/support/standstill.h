// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

/// Notices that the machine let this program stand still: what is late then is not the product's fault.
class StandstillWatch
{
public:
    StandstillWatch()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { look(); });
        m_timer.start(10);
        m_since.start();
    }
    [[nodiscard]] bool hasStoodStill()
    {
        look();
        return m_longest > 150;
    }

private:
    void look() { m_longest = std::max(m_longest, m_since.restart()); }

    QTimer m_timer;
    QElapsedTimer m_since;
    qint64 m_longest = 0;  // milliseconds
};
