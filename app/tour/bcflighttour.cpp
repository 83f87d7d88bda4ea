// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a drone.
#include "app/tour/tour.h"

#if GIMBAL_WITH_BCFLIGHT

#include "app/mainwindow/mainwindow.h"

using namespace Qt::StringLiterals;

void Tour::addDroneSteps(const QString &family)
{
    addConnecting(family);
    for (const QString &page : {u"dashboard"_s, u"monitor"_s, u"parameters"_s, u"tuning"_s, u"documents"_s,
                                u"actions"_s, u"console"_s, u"backups"_s})
        m_steps.append({family + u'-' + page, show(page), {}, 1500, {}, page == u"dashboard"_s});
    m_steps.append({{}, [this] { m_window.workspace().client().disconnectFromBoard(); }, {}, 100, {}, false});
}

#endif
