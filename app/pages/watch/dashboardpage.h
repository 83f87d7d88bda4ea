// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <QTimer>

class AttitudeView;
class AxisDial;
class Card;
class QFormLayout;
class QProgressBar;

/// Attitude, angles against targets, motor power, battery, faults in words: the gimbal at a glance.
class DashboardPage final : public Page
{
    Q_OBJECT
public:
    explicit DashboardPage(Workspace &workspace, QWidget *parent = nullptr);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void refresh();
    void refreshFacts();
    void refreshFaults();
    void updateLimits();
    void fillParts();

    QTimer m_timer;
    AttitudeView *m_attitude;
    std::array<AxisDial *, kAxisCount> m_dials{};
    Card *m_motorCard;
    QFormLayout *m_motorRows;
    std::vector<QProgressBar *> m_motors;  // in the order of the numbered motors
    QLabel *m_battery;
    QLabel *m_facts;
    QVBoxLayout *m_faultList;
    QStringList m_shownFaults;
    int m_tick = 0;
};
