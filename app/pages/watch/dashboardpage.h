// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/plot/plotclock.h"

#include <QElapsedTimer>
#include <QTimer>

class AttitudeView;
class AxisDial;
class BatteryView;
class Card;
class FlightOverview;
class GimbalView;
class PlotView;
class QFormLayout;
class QProgressBar;
class QStackedWidget;
class SignsNote;

/// The board at a glance. A gimbal: as a body and as a horizon, angles against targets and limits, motors. A
/// flying machine: whether it is armed, its horizon, its motors. Of both: battery, faults with cause and
/// cure, the link both ways; in a high window what it did lately as well.
class DashboardPage final : public Page
{
    Q_OBJECT
public:
    explicit DashboardPage(Workspace &workspace, QWidget *parent = nullptr);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void refreshFacts();
    void refreshLink();
    void refreshFaults();
    [[nodiscard]] QString silenceText() const;
    void refreshBearings();
    [[nodiscard]] bool flies() const;
    QWidget *makeMotion();
    QWidget *makePictures();
    void chooseMotion();
    QWidget *makeFacts();
    void fillParts();
    void fillCourse();
    void giveRoom();

    QTimer m_timer;
    QStackedWidget *m_motion;
    FlightOverview *m_flight = nullptr;  // made for the first machine that flies
    GimbalView *m_gimbal;
    AttitudeView *m_attitude;
    std::array<AxisDial *, kAxisCount> m_dials{};
    Card *m_motorCard;
    QFormLayout *m_motorRows;
    std::vector<QProgressBar *> m_motors;  // in the order of the numbered motors
    Card *m_batteryCard;
    BatteryView *m_battery;
    QLabel *m_facts;
    QLabel *m_link;
    QVBoxLayout *m_faultList;
    Card *m_courseCard;
    PlotView *m_course;
    SignsNote *m_signs;
    PlotClock m_clock;
    QVBoxLayout *m_factRows = nullptr;
    QStringList m_shownFaults;
    std::optional<bool> m_frameMeasured;
    quint64 m_bytesIn = 0;  // when the rates of the link were last worked out
    quint64 m_bytesOut = 0;
    QElapsedTimer m_bytesAt;
    QString m_received;
    QString m_sent;
    int m_tick = 0;
};
