// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/flightoverview.h"

#include "app/workspace/flightstate.h"
#include "app/workspace/workspace.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
struct Flight
{
    Q_DECLARE_TR_FUNCTIONS(FlightOverview)
};

// Drones run on Raspberry Pis, which slow down from 80 °C (their maker's documentation); the scale of the
// original's bar ends there as well (errata 10).
constexpr double kWarmProcessor = 70;
constexpr double kHotProcessor = 80;

QString figure(double value, int decimals, const QString &unit)
{
    return std::isnan(value) ? u"–"_s : numberText(value, decimals) + u' ' + unit;
}

// What the board casts without limits may be nonsense; it is limited for the eye, and kept beside it.
QString share(double percent)
{
    const double shown = std::clamp(percent, 0.0, 100.0);
    if (std::isnan(percent) || shown == percent)
        return figure(percent, 0, u"%"_s);
    return Flight::tr("%1 % (reported: %2)").arg(numberText(shown, 0), numberText(percent, 0));
}

QLabel *mutedHint(const QString &text)
{
    auto *label = new QLabel(text);
    label->setObjectName(u"muted"_s);
    label->setWordWrap(true);
    return label;
}

}  // namespace

FlightOverview::FlightOverview(Workspace &workspace, QWidget *parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_state(new ArmedState(workspace.theme()))
    , m_calibrate(new QPushButton(tr("Calibrate (Actions)…")))
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_hint(mutedHint({}))
    , m_motorsHint(mutedHint({}))
    , m_motors(new MotorDiagram(workspace.theme()))
{
    m_attitude->setAccessibleName(tr("Attitude of the drone"));
    auto *attitude = new Card(tr("Attitude and heading"));
    attitude->content()->addWidget(m_attitude, 1);
    attitude->content()->addWidget(m_hint);
    auto *motors = new Card(tr("Motors"));
    motors->content()->addWidget(m_motors, 1);
    motors->content()->addWidget(m_motorsHint);
    auto *pictures = new QHBoxLayout;
    pictures->setSpacing(12);
    pictures->addWidget(attitude, 1);
    pictures->addWidget(motors, 1);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    auto *state = new QHBoxLayout;
    state->setSpacing(12);
    state->addWidget(m_state, 1);
    state->addWidget(m_calibrate);
    rows->addLayout(state);
    connect(m_calibrate, &QPushButton::clicked, this, &FlightOverview::calibrationWanted);
    rows->addLayout(pictures, 1);
}

void FlightOverview::refresh()
{
    m_state->setState(flightState(m_workspace));
    m_calibrate->setVisible(m_state->state() == ArmedState::State::NotCalibrated);
    showAttitude(m_workspace, *m_attitude);
    m_hint->setText(droneDirections(m_workspace).level != CheckedDirections::Level::Nothing
                        ? tr("Drawn as the check of directions has found it (Flight).")
                        : tr("Drawn as the drone tells it. Which sign leans which way is not established: "
                             "tilt it by hand and compare."));
    showMotors(m_workspace, *m_motors);
    m_motorsHint->setText(
        m_motors->areSidesKnown()
            ? tr("What the drone commands, not what turns. Seen from above, as the check of "
                 "directions has found it.")
            : tr("What the drone commands, not what turns. Signs as in its mixing; which side "
                 "is the front is not established."));
}

QList<FlightFact> flightFacts(Workspace &workspace)
{
    const ChannelRoles &roles = workspace.roles();
    QList<FlightFact> rows;
    const auto row
        = [&rows](int channel, const QString &name, const QString &text, ColorRole role = ColorRole::Text) {
              if (channel >= 0)
                  rows.append({name, text, role});
          };
    const auto value = [&workspace](int channel) { return workspace.latest(channel); };
    row(roles.batteryLevel, Flight::tr("Battery level"), share(value(roles.batteryLevel)));
    row(roles.charge, Flight::tr("Charge drawn"), figure(value(roles.charge), 0, u"mAh"_s));
    row(roles.cpuLoad, Flight::tr("Processor load"), share(value(roles.cpuLoad)));
    const double celsius = value(roles.cpuTemperature);
    const QString heat = temperatureText(celsius, workspace.settings().fahrenheit());
    const bool isHot = celsius >= kHotProcessor;
    const bool isWarm = celsius >= kWarmProcessor;
    row(roles.cpuTemperature, Flight::tr("Processor temperature"),
        heat.isEmpty() ? u"–"_s
                       : (isHot        ? u"✖ "_s
                              : isWarm ? u"⚠ "_s
                                       : QString())
                + heat,
        isHot        ? ColorRole::Danger
            : isWarm ? ColorRole::Warning
                     : ColorRole::Text);
    row(roles.loops, Flight::tr("Control loop"), figure(value(roles.loops), 0, Flight::tr("per second")));
    return rows;
}

QList<FlightFact> flightLink(const Workspace &workspace)
{
    const ChannelRoles &roles = workspace.roles();
    QList<FlightFact> rows;
    if (roles.receiveQuality >= 0)
        rows.append({Flight::tr("Drone receives"), share(workspace.latest(roles.receiveQuality))});
    if (roles.receiveLevel >= 0) {
        // A level that it does not know arrives as a positive one.
        const double level = workspace.latest(roles.receiveLevel);
        rows.append({Flight::tr("Level at the drone"),
                     level > 0 ? Flight::tr("not known (reported: %1)").arg(numberText(level, 0))
                               : figure(level, 0, u"dBm"_s)});
    }
    return rows;
}
