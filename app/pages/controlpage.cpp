// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/controlpage.h"

#include "widgets/forms/argumentform.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/card.h"
#include "widgets/views/controlpad.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kSendPeriod = 50ms;  // well below the dead-man's 250 ms
constexpr auto kRefreshPeriod = 100ms;
constexpr int kSliderSteps = 100;

}  // namespace

ControlPage::ControlPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"control"_s, tr("Control"), parent)
    , m_mode(new QComboBox)
    , m_arm(new QPushButton)
    , m_center(new QPushButton(tr("To the middle")))
    , m_pad(new ControlPad(workspace.theme()))
    , m_roll(new QSlider(Qt::Horizontal))
    , m_speed(new QSlider(Qt::Horizontal))
    , m_speedText(new QLabel)
    , m_state(new QLabel)
    , m_now(new QLabel)
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_functions(new Card(tr("Functions")))
{
    m_arm->setCheckable(true);
    m_arm->setToolTip(
        tr("While armed the camera moves as you steer. Let go, leave this page or press Esc to end it."));
    m_mode->setAccessibleName(tr("Mode of control"));
    m_pad->setLabels(axisLabel(Axis::Yaw), axisLabel(Axis::Pitch));
    m_roll->setRange(-kSliderSteps, kSliderSteps);
    m_roll->setAccessibleName(axisLabel(Axis::Roll));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setRange(1, workspace.settings().controlSpeedLimit());
    m_speed->setValue(std::min(20, m_speed->maximum()));
    m_state->setWordWrap(true);
    header()->addWidget(m_mode);
    header()->addWidget(m_arm);

    auto *steer = new Card(tr("Steer"));
    steer->content()->addWidget(m_pad, 1);
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(Metric::kGap);
    auto *rollLabel = new QLabel(axisLabel(Axis::Roll));
    rollLabel->setBuddy(m_roll);
    grid->addWidget(rollLabel, 0, 0);
    grid->addWidget(m_roll, 0, 1, 1, 2);
    auto *speedLabel = new QLabel(tr("Speed"));
    speedLabel->setBuddy(m_speed);
    grid->addWidget(speedLabel, 1, 0);
    grid->addWidget(m_speed, 1, 1);
    m_speedText->setMinimumWidth(64);
    m_speedText->setAlignment(Qt::AlignRight);
    grid->addWidget(m_speedText, 1, 2);
    grid->setColumnStretch(1, 1);
    steer->content()->addLayout(grid);

    auto *goal = new Card(tr("Angles to go to"));
    auto *angles = new QGridLayout;
    angles->setHorizontalSpacing(12);
    angles->setVerticalSpacing(Metric::kGap);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_angles[axis] = new QDoubleSpinBox;
        m_angles[axis]->setDecimals(1);
        m_angles[axis]->setAlignment(Qt::AlignRight);
        m_angles[axis]->setAccessibleName(tr("Angle, %1").arg(axisLabel(kAxes[axis])));
        auto *label = new QLabel(axisLabel(kAxes[axis]));
        label->setBuddy(m_angles[axis]);
        angles->addWidget(label, int(axis), 0);
        angles->addWidget(m_angles[axis], int(axis), 1);
    }
    angles->addWidget(m_center, 3, 1);
    angles->setColumnStretch(1, 1);
    goal->content()->addLayout(angles);

    auto *now = new Card(tr("Camera"));
    now->content()->addWidget(m_attitude, 1);
    m_now->setTextFormat(Qt::RichText);
    now->content()->addWidget(m_now);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(goal);
    right->addWidget(now, 1);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(steer, 2);
    row->addWidget(m_functions, 2);
    row->addLayout(right, 2);
    body()->addWidget(m_state);
    body()->addLayout(row, 1);

    const auto touch = [this] { m_touched.start(); };
    connect(m_pad, &ControlPad::moved, this, [this] {
        m_touched.start();
        const ControlMode *chosen = mode();
        if (!chosen || !chosen->usesAngle || m_filling)
            return;
        // In an angle mode the pad points at angles, within half of the range either way.
        const double reach = chosen->padReach;
        m_angles[1]->setValue(m_pad->value().y() * (reach > 0 ? reach : 45.0));
        m_angles[2]->setValue(m_pad->value().x() * (reach > 0 ? reach : 90.0));
    });
    connect(m_roll, &QSlider::valueChanged, this, touch);
    connect(m_roll, &QSlider::sliderReleased, this, [this] {
        if (mode() && !mode()->usesAngle)
            m_roll->setValue(0);
    });
    connect(m_roll, &QSlider::valueChanged, this, [this](int value) {
        if (mode() && mode()->usesAngle && !m_filling)
            m_angles[0]->setValue((mode()->padReach > 0 ? mode()->padReach : 45.0) * value / kSliderSteps);
    });
    for (QDoubleSpinBox *angle : m_angles)
        connect(angle, &QDoubleSpinBox::valueChanged, this, touch);
    connect(m_speed, &QSlider::valueChanged, this, [this, touch](int value) {
        m_speedText->setText(tr("%1 °/s").arg(value));
        touch();
    });
    m_speedText->setText(tr("%1 °/s").arg(m_speed->value()));
    connect(m_center, &QPushButton::clicked, this, [this] {
        m_pad->reset();
        m_roll->setValue(0);
        for (QDoubleSpinBox *angle : m_angles)
            angle->setValue(0);
        m_touched.start();
    });
    connect(m_arm, &QPushButton::toggled, this, &ControlPage::setArmed);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &ControlPage::onMode);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &ControlPage::onState);
    connect(&workspace.client(), &DeviceClient::motorsOffFinished, this, [this] { setArmed(false); });
    connect(&workspace.client(), &DeviceClient::controlRescued, this, [this] { setArmed(false); });
    connect(&workspace.settings(), &Settings::changed, this,
            [this] { m_speed->setMaximum(this->workspace().settings().controlSpeedLimit()); });
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive)
            setArmed(false);
    });
    m_send.setInterval(kSendPeriod);
    m_send.setTimerType(Qt::PreciseTimer);
    connect(&m_send, &QTimer::timeout, this, &ControlPage::tick);
    m_refresh.setInterval(kRefreshPeriod);
    connect(&m_refresh, &QTimer::timeout, this, &ControlPage::updateNow);
    for (QWidget *widget : findChildren<QWidget *>())
        widget->installEventFilter(this);
    onState();
}

// Actions that belong to steering: each with its fields and a button.
void ControlPage::fillFunctions()
{
    auto *rows = new QWidget;
    auto *grid = new QGridLayout(rows);
    grid->setContentsMargins(0, 0, Metric::kGap, 0);
    grid->setHorizontalSpacing(Metric::kGap);
    grid->setVerticalSpacing(12);
    grid->setColumnStretch(0, 1);
    int line = 0;
    const Device *tables = workspace().tables();
    for (const ActionSpec &action : tables ? tables->actions() : std::span<const ActionSpec>()) {
        if (!action.whileSteering)
            continue;
        auto *form = new ArgumentForm(action);
        auto *button = new QPushButton(tableText(action.label));
        // One field needs no name beside the button's; a tick does.
        if (action.arguments.size() == 1 && action.arguments.front().kind != ArgumentKind::Toggle) {
            for (QLabel *label : form->findChildren<QLabel *>())
                label->hide();
            static_cast<QFormLayout *>(form->layout())->setHorizontalSpacing(0);
        }
        button->setToolTip(tableText(action.help));
        grid->addWidget(form, line, 0, Qt::AlignVCenter);
        grid->addWidget(button, line++, 1, action.arguments.size() > 1 ? Qt::AlignBottom : Qt::AlignVCenter);
        connect(button, &QPushButton::clicked, this, [this, form, key = QString::fromLatin1(action.key)] {
            if (const auto arguments = form->arguments())
                workspace().perform(key, *arguments);
            else
                emit workspace().problem(describe(arguments.error()));
        });
    }
    grid->setRowStretch(line, 1);
    auto *scroll = m_functions->findChild<QScrollArea *>();
    if (!scroll) {
        scroll = new QScrollArea;
        scroll->setWidgetResizable(true);
        scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        m_functions->content()->addWidget(scroll, 1);
    }
    delete scroll->takeWidget();
    scroll->setWidget(rows);
    scroll->setMinimumWidth(rows->minimumSizeHint().width()
                            + scroll->verticalScrollBar()->sizeHint().width());
    m_functions->setVisible(line > 0);
    for (QWidget *widget : rows->findChildren<QWidget *>())
        widget->installEventFilter(this);
}

const ControlMode *ControlPage::mode() const
{
    const Device *device = workspace().client().device();
    if (!device)
        return nullptr;
    for (const ControlMode &candidate : device->controlModes()) {
        if (candidate.id == m_mode->currentData().toInt())
            return &candidate;
    }
    return nullptr;
}

void ControlPage::onState()
{
    const DeviceClient &client = workspace().client();
    if (!client.isConnected()) {
        setArmed(false);
    } else {
        const int before = m_mode->count() ? m_mode->currentData().toInt() : -1;
        m_filling = true;
        m_mode->clear();
        for (const ControlMode &candidate : client.device()->controlModes()) {
            if (candidate.usesSpeed || candidate.usesAngle)
                m_mode->addItem(tableText(candidate.label), candidate.id);
        }
        m_mode->setCurrentIndex(std::max(0, m_mode->findData(before)));
        m_filling = false;
        onMode();
    }
    const bool ready = client.isConnected() && client.identity().writable;
    fillFunctions();
    m_functions->setEnabled(ready);
    m_arm->setEnabled(ready);
    m_mode->setEnabled(ready);
    updateNow();
}

void ControlPage::onMode()
{
    if (m_filling)
        return;
    setArmed(false);
    const ControlMode *chosen = mode();
    const bool angles = chosen && chosen->usesAngle;
    m_pad->setSprings(!angles);
    m_filling = true;
    m_roll->setValue(0);
    for (QDoubleSpinBox *angle : m_angles) {
        angle->setEnabled(angles);
        angle->setRange(chosen ? chosen->minAngle : 0, chosen ? chosen->maxAngle : 0);
        angle->setSuffix(chosen && *chosen->unit ? QString::fromUtf8(chosen->unit) : QString());
        angle->setValue(0);
    }
    m_filling = false;
    m_center->setEnabled(angles);
    m_speed->setEnabled(chosen && chosen->usesSpeed);
}

bool ControlPage::isArmed() const
{
    return m_send.isActive();
}

void ControlPage::setArmed(bool on)
{
    const bool allowed = on && isVisible() && workspace().client().isConnected()
        && workspace().client().identity().writable && mode();
    if (allowed && !isArmed()) {
        m_pad->reset();
        m_touched.start();
        // What is to be held is where the camera is now, so that arming moves nothing.
        const ChannelRoles roles = workspace().roles();
        m_filling = true;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const double target = workspace().latest(roles.target[axis]);
            if (mode()->usesAngle && mode()->usesSpeed)
                m_angles[axis]->setValue(std::isnan(target) ? 0.0 : target);
        }
        m_filling = false;
        m_send.start();
    } else if (!allowed && isArmed()) {
        m_send.stop();
        m_pad->reset();
        m_roll->setValue(0);
        workspace().client().releaseControl();
    }
    m_arm->setChecked(isArmed());
    m_arm->setText(isArmed() ? tr("■ Disarm") : tr("Arm"));
    m_arm->setObjectName(isArmed() ? u"danger"_s : QString());
    repolish(m_arm);
    for (QWidget *widget : {static_cast<QWidget *>(m_pad), static_cast<QWidget *>(m_roll)})
        widget->setEnabled(isArmed());
    if (allowed)
        m_pad->setFocus();
    m_state->setText(
        isArmed()
            ? tr("Armed: the camera follows you. It stops when you let go, leave this page, or do nothing "
                 "for %1 s.")
                  .arg(workspace().settings().disarmSeconds())
            : tr("Not armed: nothing is sent. Choose a mode, then arm."));
    m_state->setObjectName(isArmed() ? u"warning"_s : u"muted"_s);
    repolish(m_state);
}

ControlSetpoint ControlPage::setpoint() const
{
    ControlSetpoint wanted{};
    const ControlMode *chosen = mode();
    if (!chosen)
        return wanted;
    const double speed = m_speed->value();
    const std::array<double, kAxisCount> push{double(m_roll->value()) / kSliderSteps, m_pad->value().y(),
                                              m_pad->value().x()};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        wanted[axis].mode = chosen->id;
        wanted[axis].speed = !chosen->usesSpeed ? 0.0 : chosen->usesAngle ? speed : push[axis] * speed;
        wanted[axis].angle = chosen->usesAngle ? m_angles[axis]->value() : 0.0;
    }
    return wanted;
}

void ControlPage::tick()
{
    if (m_touched.elapsed() > 1000LL * workspace().settings().disarmSeconds() && !m_pad->isHeld()) {
        setArmed(false);
        emit workspace().notice(tr("Control was disarmed: nothing was moved for %1 s.")
                                    .arg(workspace().settings().disarmSeconds()));
        return;
    }
    workspace().client().setControl(setpoint());
}

void ControlPage::updateNow()
{
    const ChannelRoles roles = workspace().roles();
    const auto value = [this](int channel) { return workspace().latest(channel); };
    m_attitude->setAttitude(value(roles.angle[0]), value(roles.angle[1]), value(roles.angle[2]));
    const auto text = [](double number) {
        return std::isnan(number) ? u"–"_s : u"%1°"_s.arg(std::abs(number) < 0.05 ? 0.0 : number, 0, 'f', 1);
    };
    QString rows = u"<tr><td></td><td align='right'>%1</td><td align='right'>%2</td></tr>"_s.arg(
        tr("is"), tr("target"));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        rows += u"<tr><td>%1</td><td align='right'>%2</td><td align='right'>%3</td></tr>"_s.arg(
            axisLabel(kAxes[axis]), text(value(roles.angle[axis])), text(value(roles.target[axis])));
    }
    m_now->setText(u"<table width='100%'>%1</table>"_s.arg(rows));
}

bool ControlPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && isArmed()
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
        setArmed(false);
    return Page::eventFilter(watched, event);
}

void ControlPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    const ChannelRoles roles = workspace().roles();
    QList<int> wanted(roles.angle.begin(), roles.angle.end());
    wanted.append(QList<int>(roles.target.begin(), roles.target.end()));
    workspace().wishTelemetry(this, wanted);
    m_refresh.start();
    setArmed(false);
}

void ControlPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    setArmed(false);
    m_refresh.stop();
}
