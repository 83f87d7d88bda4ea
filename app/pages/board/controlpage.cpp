// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/controlpage.h"

#include "app/pages/board/functionscard.h"
#include "app/pages/board/gamepadsteering.h"
#include "app/workspace/unwatchednote.h"
#include "protocol/session/controlstream.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/card.h"
#include "widgets/views/controlpad.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kRefreshPeriod = 100ms;
constexpr double kPitchReach = 45.0;  // angle at the rim of the pad, unless the family specifies another
constexpr double kYawReach = 90.0;

}  // namespace

ControlPage::ControlPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"control"_s, tr("Control"), parent)
    , m_mode(new QComboBox)
    , m_arm(new QPushButton)
    , m_center(new QPushButton(tr("To the middle")))
    , m_neverPanned(new QCheckBox(tr("Not in pan mode since it started")))
    , m_pad(new ControlPad(workspace.theme()))
    , m_roll(new QSlider(Qt::Horizontal))
    , m_rollLabel(new QLabel(axisLabel(Axis::Roll)))
    , m_inputs(new QGridLayout)
    , m_speed(new QSlider(Qt::Horizontal))
    , m_speedText(new QLabel)
    , m_state(new QLabel)
    , m_now(new QLabel)
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_functions(new FunctionsCard(workspace))
    , m_gamepad(new GamepadSteering(workspace, this))
{
    makeHeader();
    makeBody();
    connectAll();
    for (QWidget *widget : findChildren<QWidget *>())
        widget->installEventFilter(this);
    onState();
}

ControlPage::~ControlPage()
{
    if (isArmed())
        workspace().client().releaseControl();
}

void ControlPage::makeHeader()
{
    m_arm->setCheckable(true);
    m_arm->setToolTip(
        tr("While armed the camera moves as you steer. Let go, leave this page or press Esc to end it."));
    m_mode->setAccessibleName(tr("Mode of control"));
    m_mode->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // its modes come with the board
    header()->addWidget(m_gamepad->choice());
    header()->addWidget(m_mode);
    header()->addWidget(m_arm);
}

void ControlPage::makeBody()
{
    m_state->setWordWrap(true);
    auto *now = new Card(tr("Camera"));
    now->content()->addWidget(m_attitude, 1);
    m_now->setTextFormat(Qt::RichText);
    now->content()->addWidget(m_now);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(makeAnglesCard());
    right->addWidget(now, 1);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(makeSteerCard(), 2);
    row->addWidget(m_functions, 2);
    row->addLayout(right, 2);
    body()->addWidget(m_state);
    body()->addLayout(row, 1);
    body()->addWidget(new UnwatchedNote(workspace().client(),
                                        {AlarmKind::Runaway, AlarmKind::Oscillation, AlarmKind::Limit,
                                         AlarmKind::Saturation, AlarmKind::Stale}));
}

Card *ControlPage::makeSteerCard()
{
    m_pad->setLabels(axisLabel(Axis::Yaw), axisLabel(Axis::Pitch));
    m_roll->setRange(-kSliderSteps, kSliderSteps);
    m_roll->setAccessibleName(axisLabel(Axis::Roll));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setRange(1, workspace().settings().controlSpeedLimit());
    m_speed->setValue(std::min(20, m_speed->maximum()));
    m_speedText->setText(tr("%1 °/s").arg(m_speed->value()));
    auto *steer = new Card(tr("Steer"));
    steer->content()->addWidget(m_pad, 1);
    QGridLayout *grid = m_inputs;
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(Metric::kGap);
    m_rollLabel->setBuddy(m_roll);
    grid->addWidget(m_rollLabel, 0, 0);
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
    steer->content()->addWidget(m_gamepad->note());
    return steer;
}

Card *ControlPage::makeAnglesCard()
{
    auto *goal = new Card(tr("Angles to go to"));
    auto *angles = new QGridLayout;
    angles->setHorizontalSpacing(12);
    angles->setVerticalSpacing(Metric::kGap);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_angles[axis] = new NumberBox;
        m_angles[axis]->setDecimals(1);
        m_angles[axis]->setEmptyAllowed(true);  // unknown
        m_angles[axis]->setAlignment(Qt::AlignRight);
        m_angles[axis]->setAccessibleName(tr("Angle, %1").arg(axisLabel(kAxes[axis])));
        m_angleLabels[axis] = new QLabel(axisLabel(kAxes[axis]));
        m_angleLabels[axis]->setBuddy(m_angles[axis]);
        angles->addWidget(m_angleLabels[axis], int(axis), 0);
        angles->addWidget(m_angles[axis], int(axis), 1);
    }
    angles->addWidget(m_center, 3, 1);
    m_neverPanned->setToolTip(tr(
        "The board does not report its targets, and an axis that has followed the handle counts its angles "
        "from there. If you know that none has since the board was switched on, by remote control or "
        "otherwise, the camera can be held where it is."));
    m_neverPanned->hide();
    angles->addWidget(m_neverPanned, 4, 0, 1, 2);
    angles->setColumnStretch(1, 1);
    goal->content()->addLayout(angles);
    return goal;
}

void ControlPage::connectAll()
{
    const auto angles = [this] { return ChannelRoles::present({workspace().roles().angle}); };
    coverWhenStale(*m_attitude, angles);
    coverWhenStale(*m_now, angles, StaleCover::Look::Fade);
    connect(m_pad, &ControlPad::moved, this, &ControlPage::touch);
    connect(m_pad, &ControlPad::moved, this, &ControlPage::pointWithPad);
    connect(m_roll, &QSlider::valueChanged, this, &ControlPage::touch);
    connect(m_roll, &QSlider::valueChanged, this, &ControlPage::pointWithRoll);
    connect(m_roll, &QSlider::sliderReleased, this, [this] {
        if (mode() && !mode()->isPositional())
            m_roll->setValue(0);
    });
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        connect(m_angles[axis], &QDoubleSpinBox::valueChanged, this,
                [this, axis] { m_known[axis] = m_known[axis] || !m_filling; });
        connect(m_angles[axis]->findChild<QLineEdit *>(), &QLineEdit::textEdited, this, &ControlPage::touch);
        // What was typed counts even if it is the value that the empty field had.
        connect(m_angles[axis], &NumberBox::editingFinished, this, [this, axis] { m_known[axis] = true; });
    }
    for (NumberBox *angle : m_angles)
        connect(angle, &QDoubleSpinBox::valueChanged, this, &ControlPage::touch);
    connect(m_speed, &QSlider::valueChanged, this, [this](int value) {
        m_speedText->setText(tr("%1 °/s").arg(value));
        touch();
    });
    connect(m_center, &QPushButton::clicked, this, &ControlPage::center);
    connect(m_neverPanned, &QCheckBox::toggled, this, &ControlPage::onWord);
    connect(m_arm, &QPushButton::toggled, this, &ControlPage::setArmed);
    connectGamepad();
    connect(m_mode, &QComboBox::currentIndexChanged, this, &ControlPage::onMode);
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &ControlPage::onState);
    connect(&workspace().client(), &DeviceClient::motorsOffFinished, this, [this] { setArmed(false); });
    connect(&workspace().client(), &DeviceClient::failsafeActed, this, [this] { setArmed(false); });
    connect(&workspace(), &Workspace::controlReleased, this, [this] { setArmed(false); });
    connect(&workspace().settings(), &Settings::changed, this,
            [this] { m_speed->setMaximum(workspace().settings().controlSpeedLimit()); });
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive)
            setArmed(false);
    });
    m_send.setInterval(kSendPeriod);
    m_send.setTimerType(Qt::PreciseTimer);
    connect(&m_send, &QTimer::timeout, this, &ControlPage::tick);
    m_refresh.setInterval(kRefreshPeriod);
    connect(&m_refresh, &QTimer::timeout, this, &ControlPage::updateNow);
}

void ControlPage::connectGamepad()
{
    connect(m_gamepad, &GamepadSteering::gone, this, [this](const QString &what) {
        setArmed(false);
        workspace().notifications().notify(what, Notice::Attention);
    });
    connect(m_gamepad, &GamepadSteering::armWanted, this, [this] { setArmed(true); });
    connect(m_gamepad, &GamepadSteering::disarmWanted, this, [this] { setArmed(false); });
    connect(m_gamepad, &GamepadSteering::centreWanted, this, [this] {
        if (isArmed() && m_center->isEnabled())
            center();
    });
}

// The operator moved something.
void ControlPage::touch()
{
    m_touched.start();
    m_moved = m_moved || !m_filling;
}

// In a positional mode the pad sets angles, within half of the range either way.
void ControlPage::pointWithPad()
{
    const SteeringMode *chosen = mode();
    if (!chosen || !chosen->isPositional() || m_filling)
        return;
    const auto point = [&](std::size_t axis, double share, double fallback) {
        const int input = chosen->inputOf(kAxes[axis]);
        const double reach = input < 0 ? 0.0 : chosen->inputs[std::size_t(input)].padReach;
        m_angles[axis]->setValue(share * (reach > 0 ? reach : fallback));
    };
    point(1, m_pad->value().y(), kPitchReach);
    point(2, m_pad->value().x(), kYawReach);
}

void ControlPage::pointWithRoll(int value)
{
    const SteeringMode *chosen = mode();
    const int input = chosen ? chosen->inputOf(Axis::Roll) : -1;
    if (input < 0 || !chosen->isPositional() || m_filling)
        return;
    const double reach = chosen->inputs[std::size_t(input)].padReach;
    m_angles[0]->setValue((reach > 0 ? reach : kPitchReach) * value / kSliderSteps);
}

void ControlPage::center()
{
    m_pad->reset();
    m_roll->setValue(0);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        m_angles[axis]->setValue(0);
        m_known[axis] = true;
    }
    touch();
}

const Steering *ControlPage::steering() const
{
    const Device *device = workspace().client().device();
    return device ? device->steering() : nullptr;
}

const SteeringMode *ControlPage::mode() const
{
    return steering() ? steering()->mode(m_mode->currentData().toInt()) : nullptr;
}

void ControlPage::onState()
{
    const DeviceClient &client = workspace().client();
    if (!client.isConnected()) {
        setArmed(false);
        m_neverPanned->setChecked(false);
    } else if (steering()) {
        // Another family's modes have the same numbers.
        const QString family = client.identity().family;
        const bool isSame = family == std::exchange(m_modesOf, family);
        const int before = isSame && m_mode->count() ? m_mode->currentData().toInt() : -1;
        m_filling = true;
        m_mode->clear();
        for (const SteeringMode &candidate : steering()->modes())
            m_mode->addItem(tableText(candidate.label), candidate.id);
        m_mode->setCurrentIndex(std::max(0, m_mode->findData(before)));
        m_filling = false;
        onMode();
    }
    const bool ready = client.isConnected() && client.identity().writable && steering();
    m_functions->fill();
    for (QWidget *widget : m_functions->findChildren<QWidget *>())
        widget->installEventFilter(this);
    m_functions->setEnabled(ready);
    m_state->setText(stateText());  // which functions there are is part of it
    m_arm->setEnabled(ready);
    m_mode->setEnabled(ready);
    updateNow();
}

void ControlPage::onMode()
{
    if (m_filling)
        return;
    setArmed(false);
    const SteeringMode *chosen = mode();
    m_pad->setSprings(!chosen || !chosen->isPositional());
    showTargets(chosen);
    fillInputs();
    const auto has = [chosen](Axis axis) { return !chosen || chosen->inputOf(axis) >= 0; };
    m_pad->setVisible(has(Axis::Pitch) || has(Axis::Yaw));
    m_roll->setVisible(has(Axis::Roll));
    m_rollLabel->setVisible(has(Axis::Roll));
    m_center->setEnabled(chosen && chosen->isPositional());
    const bool turns = chosen && !chosen->inputs.empty() && qstrcmp(chosen->inputs.front().unit, "°/s") == 0;
    m_speed->setEnabled(turns || (chosen && chosen->find("speed") >= 0));
}

// The fields for target angles that this mode has.
void ControlPage::showTargets(const SteeringMode *chosen)
{
    m_filling = true;
    m_roll->setValue(0);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
        NumberBox *angle = m_angles[axis];
        const int at = chosen ? chosen->inputOf(kAxes[axis]) : -1;
        const SteeringInput input = at < 0 ? SteeringInput() : chosen->inputs[std::size_t(at)];
        const bool place = at >= 0 && !input.springsBack;
        for (QWidget *widget : {static_cast<QWidget *>(angle), static_cast<QWidget *>(m_angleLabels[axis])})
            widget->setVisible(!chosen || at >= 0);
        angle->setEnabled(place);
        angle->setRange(place ? input.min : 0, place ? input.max : 0);
        angle->setSuffix(place ? QString::fromUtf8(input.unit) : chosen ? u"°"_s : QString());
        angle->setValue(0);
        m_known[axis] = false;
    }
    m_filling = false;
}

// One row for each input that turns no axis, and for each switch.
void ControlPage::fillInputs()
{
    for (QWidget *widget : std::exchange(m_rows, {}))
        delete widget;
    m_moreInputs.clear();
    m_switches.clear();
    const SteeringMode *chosen = mode();
    if (!chosen)
        return;
    int row = m_inputs->rowCount();
    const auto addRow = [this, &row](const char *text, QWidget *field) {
        auto *label = new QLabel(tableText(text));
        label->setBuddy(field);
        field->setAccessibleName(tableText(text));
        m_inputs->addWidget(label, row, 0);
        m_inputs->addWidget(field, row++, 1, 1, 2);
        field->installEventFilter(this);
        m_rows.insert(m_rows.end(), {label, field});
    };
    for (const SteeringInput &input : chosen->inputs) {
        if (input.axis != Axis::None || qstrcmp(input.key, "speed") == 0)
            continue;
        auto *box = new NumberBox(input.min, input.max, 2,
                                  *input.unit ? u' ' + QString::fromUtf8(input.unit) : QString());
        box->setSingleStep((input.max - input.min) / 20);
        box->setValue(input.centre);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] { m_touched.start(); });
        addRow(input.label, box);
        m_moreInputs[input.key] = box;
    }
    for (const SteeringSwitch &toggle : steering()->switches()) {
        auto *box = new QComboBox;
        for (const Choice &choice : toggle.choices)
            box->addItem(tableText(choice.name), choice.value);
        box->setCurrentIndex(std::max(0, box->findData(toggle.start)));
        connect(box, &QComboBox::currentIndexChanged, this, [this] { m_touched.start(); });
        addRow(toggle.label, box);
        m_switches.push_back(box);
    }
}

void ControlPage::setArmed(bool on)
{
    const bool isStopping = workspace().client().isStopUnproven();
    if (on && isVisible() && isStopping)
        workspace().notifications().notify(
            tr("Not armed: the motors are being stopped, and the board has not confirmed it."),
            Notice::Attention);
    const QString hands = on && isVisible() && !isArmed() ? m_gamepad->whyNot() : QString();
    if (!hands.isEmpty())
        workspace().notifications().notify(hands, Notice::Attention);
    const bool allowed = on && !isStopping && hands.isEmpty() && isVisible()
        && workspace().client().isConnected() && workspace().client().identity().writable && mode()
        && workspace().client().telemetry() && !isLimp();
    if (on && !allowed && isVisible() && isLimp())
        workspace().notifications().notify(
            tr("Not armed: the motors are off, and where a limp camera hangs is no target. Start the motors, "
               "then arm."),
            Notice::Hint);
    if (allowed && !isArmed()) {
        m_pad->reset();
        m_touched.start();
        m_known = {};
        takeHold();
        m_moved = false;
        m_pushed = {};
        m_gamepad->begin();
        m_send.start();
    } else if (!allowed && isArmed()) {
        m_send.stop();
        m_gamepad->end();
        m_pad->reset();
        m_roll->setValue(0);
        const auto switches = steering() ? steering()->switches() : std::span<const SteeringSwitch>();
        for (std::size_t i = 0; i < std::min(switches.size(), m_switches.size()); ++i)
            m_switches[i]->setCurrentIndex(std::max(0, m_switches[i]->findData(switches[i].start)));
        const SteeringMode *chosen = mode();
        for (const SteeringInput &input : chosen ? chosen->inputs : std::vector<SteeringInput>()) {
            if (const auto more = m_moreInputs.find(input.key); more != m_moreInputs.end())
                more->second->setValue(input.centre);  // a throttle does not wait for the next time
        }
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
    m_state->setText(stateText());
    m_state->setObjectName(isArmed() ? u"warning"_s : u"muted"_s);
    repolish(m_state);
}

void ControlPage::updateNow()
{
    m_neverPanned->setVisible(wordIsNeeded());
    const ChannelRoles &roles = workspace().roles();
    const auto value = [this](int channel) { return workspace().latest(channel); };
    m_attitude->setAttitude(value(roles.angle[0]), value(roles.angle[1]), value(roles.angle[2]));
    const auto text = [](double number) {
        return std::isnan(number) ? u"–"_s
                                  : u"%1°"_s.arg(numberText(std::abs(number) < 0.05 ? 0.0 : number, 1));
    };
    QString rows = u"<tr><td></td><td align='right'>%1</td><td align='right'>%2</td></tr>"_s.arg(
        tr("is"), tr("target"));
    const bool any = !ChannelRoles::present({roles.angle, roles.target}).isEmpty();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (any && roles.angle[axis] < 0 && roles.target[axis] < 0)
            continue;
        rows += u"<tr><td>%1</td><td align='right'>%2</td><td align='right'>%3</td></tr>"_s.arg(
            axisLabel(kAxes[axis]), text(value(roles.angle[axis])), text(value(roles.target[axis])));
    }
    m_now->setText(u"<table width='100%'>%1</table>"_s.arg(rows));
}

bool ControlPage::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_roll && ControlPad::endsDrag(*m_roll, *event))
        m_roll->setSliderDown(false);
    if (event->type() == QEvent::KeyPress && isArmed()
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
        setArmed(false);
    return Page::eventFilter(watched, event);
}

void ControlPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle, roles.target});
    });
    m_refresh.start();
    m_gamepad->setShown(true);
    setArmed(false);
}

void ControlPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    setArmed(false);
    m_gamepad->setShown(false);
    m_refresh.stop();
}
