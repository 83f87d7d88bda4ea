// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/clickshield.h"

#include <QTimer>

using namespace std::chrono_literals;

namespace {

constexpr auto kShieldTime = 500ms;

}  // namespace

ClickShield::ClickShield(QWidget &area, const QRect &place)
    : QWidget(&area)
{
    setGeometry(place);
    show();
    raise();
    QTimer::singleShot(kShieldTime, this, &QWidget::deleteLater);
}

void ClickShield::raiseAll(QWidget &area)
{
    for (ClickShield *shield : area.findChildren<ClickShield *>(QString(), Qt::FindDirectChildrenOnly))
        shield->raise();
}
