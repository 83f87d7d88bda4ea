// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/flightpage.h"

#include "app/pages/board/directioncard.h"
#include "app/pages/board/gamepadsteering.h"
#include "app/pages/board/stickstepcard.h"
#include "app/workspace/flightstate.h"
#include "app/workspace/question.h"
#include "app/workspace/unwatchednote.h"
#include "protocol/device/flight.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/forms/panel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/controlpad.h"

#include <QApplication>
#include <QCheckBox>
#include <QDBusConnection>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kFlightPeriod = 20ms;
constexpr auto kFlightRefresh = 100ms;
constexpr int kTellGuardEvery = 5;  // set-points
constexpr int kHeldHeight = 6;
constexpr int kWhyLines = 3;

/// Takes the height there is: with texts that wrap, a scroll area would give it all that it would like.
class FlightCards final : public QWidget
{
public:
    [[nodiscard]] int heightForWidth(int) const override { return -1; }
};

QScrollArea *scrolled(QWidget *content)
{
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    return scroll;
}

// Signals of the desktop that the screen is locked, or the computer goes to sleep.
struct Lock
{
    bool isOfSystem = false;
    const char *interface = "";
    const char *signal = "";
};
constexpr std::array kLocks{
    Lock{false, "org.freedesktop.ScreenSaver", "ActiveChanged"},
    Lock{false, "org.gnome.ScreenSaver", "ActiveChanged"},
    Lock{true, "org.freedesktop.login1.Manager", "PrepareForSleep"},
};

}  // namespace

FlightPage::FlightPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"flight"_s, tr("Flight"), parent)
    , m_open(new QPushButton)
    , m_tune(new QCheckBox(tr("Set values while it is armed")))
    , m_tile(new ArmedState(workspace.theme()))
    , m_why(new QLabel)
    , m_calibrate(new QPushButton(tr("Calibrate (Actions)…")))
    , m_arm(new QPushButton(tr("Hold to arm")))
    , m_held(new QProgressBar)
    , m_disarm(new QPushButton(tr("■ Disarm")))
    , m_throttle(new QSlider(Qt::Vertical))
    , m_throttleText(new QLabel)
    , m_pad(new ControlPad(workspace.theme()))
    , m_yaw(new QSlider(Qt::Horizontal))
    , m_gamepad(new GamepadSteering(workspace, this))
    , m_keys(new QLabel(tr("Keys: W and S throttle, A and D yaw, arrows roll and pitch, space disarms.")))
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_motors(new MotorDiagram(workspace.theme()))
    , m_numbers(new QLabel)
    , m_directions(new DirectionCard(workspace))
    , m_steps(new StickStepCard(workspace))
{
    makeHeader();
    makeBody();
    connectAll();
    for (QWidget *widget : findChildren<QWidget *>())
        widget->installEventFilter(this);
    showState();
}

FlightPage::~FlightPage()
{
    if (m_session.close())
        workspace().client().releaseControl();
    workspace().setFlown(false);
    workspace().setPropellersOn(false);
}

void FlightPage::makeHeader()
{
    m_tune->setToolTip(tr("For experts, in a test stand: gains that are set go to the drone while its motors "
                          "turn. Without it, setting one disarms first."));
    header()->addWidget(m_tune);
    header()->addWidget(m_open);
}

void FlightPage::makeBody()
{
    m_why->setWordWrap(true);
    m_why->setObjectName(u"muted"_s);
    // What stands beneath stays where it is, whatever is said.
    m_why->setAlignment(Qt::AlignTop);
    m_why->setMinimumHeight(kWhyLines * m_why->fontMetrics().lineSpacing());
    auto *state = new Card(tr("State"));
    state->content()->addWidget(m_tile);
    m_held->setTextVisible(false);
    m_held->setMaximum(kFullStick);
    m_held->setFixedHeight(kHeldHeight);
    QSizePolicy kept = m_held->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    m_held->setSizePolicy(kept);
    m_held->setAccessibleName(tr("How long the key has been held"));
    m_arm->setToolTip(tr("Hold it for a second, with the throttle at zero. It arms the motors."));
    m_arm->setAutoRepeat(false);
    m_disarm->setObjectName(u"danger"_s);
    m_disarm->setToolTip(tr("Stops the motors: in flight it falls. The space bar does the same."));
    auto *keys = new QGridLayout;
    keys->setHorizontalSpacing(Metric::kGap);
    keys->addWidget(m_arm, 0, 0);
    keys->addWidget(m_disarm, 0, 1);
    keys->addWidget(m_held, 1, 0, 1, 2);
    // Above what is said, which changes its height: a button that is held stays where it is.
    state->content()->addLayout(keys);
    state->content()->addWidget(m_why);
    state->content()->addWidget(m_calibrate, 0, Qt::AlignLeft);
    // What stops it stands first; what may take more room than there is has a bar of its own.
    auto *more = new FlightCards;
    auto *rest = new QVBoxLayout(more);
    rest->setContentsMargins(0, 0, 0, 0);
    rest->setSpacing(12);
    rest->addWidget(m_directions);
    rest->addWidget(m_steps, 1);
    rest->addStretch();
    auto *left = new QVBoxLayout;
    left->setSpacing(12);
    left->addWidget(state);
    left->addWidget(scrolled(more), 1);
    auto *attitude = new Card(tr("Attitude"));
    attitude->content()->addWidget(m_attitude, 1);
    m_numbers->setTextFormat(Qt::RichText);
    attitude->content()->addWidget(m_numbers);
    auto *motors = new Card(tr("Motors"));
    motors->content()->addWidget(m_motors, 1);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(attitude, 1);
    right->addWidget(motors, 1);
    auto *cards = new FlightCards;
    auto *row = new QHBoxLayout(cards);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addLayout(left, 3);
    row->addWidget(makeStickCard(), 3);
    row->addLayout(right, 2);
    body()->addWidget(scrolled(cards), 1);
}

Card *FlightPage::makeStickCard()
{
    m_throttle->setRange(0, kFullStick);
    m_throttle->setPageStep(5);
    m_throttle->setAccessibleName(tr("Throttle"));
    m_throttle->setTickPosition(QSlider::TicksBothSides);
    m_throttle->setTickInterval(25);
    m_throttleText->setAlignment(Qt::AlignHCenter);
    m_throttleText->setMinimumWidth(56);
    m_pad->setLabels(axisLabel(Axis::Roll), axisLabel(Axis::Pitch));
    m_yaw->setRange(-kFullStick, kFullStick);
    // A click does not take the arrow keys from the pad.
    for (QSlider *slider : {m_throttle, m_yaw})
        slider->setFocusPolicy(Qt::TabFocus);
    m_yaw->setAccessibleName(axisLabel(Axis::Yaw));
    auto *sticks = new Card(tr("Sticks"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(12);
    auto *throttle = new QLabel(tr("Throttle"));
    throttle->setBuddy(m_throttle);
    throttle->setAlignment(Qt::AlignHCenter);
    grid->addWidget(throttle, 0, 0);
    grid->addWidget(m_throttle, 1, 0, Qt::AlignHCenter);
    grid->addWidget(m_throttleText, 2, 0);
    grid->addWidget(m_pad, 0, 1, 3, 2);
    auto *yaw = new QLabel(axisLabel(Axis::Yaw));
    yaw->setBuddy(m_yaw);
    grid->addWidget(yaw, 3, 0);
    grid->addWidget(m_yaw, 3, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 1);
    sticks->content()->addLayout(grid, 1);
    m_keys->setObjectName(u"muted"_s);
    m_keys->setWordWrap(true);
    m_gamepad->choice()->setText(tr("Steer with a gamepad"));
    m_gamepad->choice()->setToolTip(
        tr("If it is unplugged or falls silent, the drone is disarmed. Its sticks are "
           "assigned on the page “Gamepad”."));
    sticks->content()->addWidget(m_gamepad->choice());
    sticks->content()->addWidget(m_keys);
    sticks->content()->addWidget(m_gamepad->note());
    sticks->content()->addWidget(
        new UnwatchedNote(workspace().client(), {AlarmKind::Stale, AlarmKind::Battery, AlarmKind::Disarmed}));
    return sticks;
}

void FlightPage::connectAll()
{
    const auto angles = [this] { return ChannelRoles::present({workspace().roles().angle}); };
    coverWhenStale(*m_attitude, angles);
    coverWhenStale(*m_numbers, angles, StaleCover::Look::Fade);
    coverWhenStale(*m_motors, [this] { return workspace().roles().motors; });
    DeviceClient &client = workspace().client();
    connect(m_open, &QPushButton::clicked, this, [this] {
        if (m_session.phase() == ArmingSession::Phase::Closed)
            askToOpen();
        else
            closeSession();
        showState();
    });
    connect(m_tune, &QCheckBox::clicked, this, &FlightPage::askToTune);
    connect(m_calibrate, &QPushButton::clicked, this, [this] {
        const Device *device = this->workspace().client().device();
        if (device && device->flight())
            emit actionWanted(QLatin1String(device->flight()->calibration()));
    });
    connectGamepad();
    connect(m_arm, &QPushButton::pressed, this, &FlightPage::press);
    connect(m_arm, &QPushButton::released, this, &FlightPage::release);
    connect(m_disarm, &QPushButton::clicked, this, [this] {
        if (isUnderWay())
            disarm(ArmingBar::Operator);
        else  // armed by somebody else
            this->workspace().setMotors(false);
    });
    for (QSlider *slider : {m_throttle, m_yaw})
        connect(slider, &QSlider::valueChanged, this, &FlightPage::touch);
    connect(m_throttle, &QSlider::valueChanged, this, &FlightPage::showNow);
    connect(m_yaw, &QSlider::sliderReleased, this, [this] { m_yaw->setValue(0); });
    connect(m_pad, &ControlPad::moved, this, &FlightPage::touch);
    connect(&client, &DeviceClient::stateChanged, this, [this] {
        if (!workspace().client().isConnected()) {
            disarm(ArmingBar::NoLink);
            closeSession();
            m_tune->setChecked(false);
        }
        showState();
    });
    connect(&client, &DeviceClient::motorsOffBegun, this, [this] { disarm(ArmingBar::Emergency); });
    connect(&client, &DeviceClient::failsafeActed, this, [this] { disarm(ArmingBar::Hung); });
    connect(&client, &DeviceClient::steeringEnded, this, [this](bool confirmed) {
        if (confirmed && !m_isSending)
            m_guardian.leave();
        // Whatever ended it, it is not armed from here any more.
        disarm(ArmingBar::Emergency);
    });
    connect(&client, &DeviceClient::telemetryFailed, this, [this] { disarm(ArmingBar::Failed); });
    connect(&m_guardian, &FlightGuardian::lost, this, [this] { disarm(ArmingBar::Unguarded); });
    connect(&workspace(), &Workspace::controlReleased, this, [this] { disarm(ArmingBar::Operator); });
    connect(&workspace().live(), &LiveModel::sending, this, [this] {
        if (!m_tune->isChecked())
            disarm(ArmingBar::Changed);
    });
    connect(m_directions, &DirectionCard::stepChanged, this, &FlightPage::showState);
    connect(m_directions, &DirectionCard::ending, this, [this] { disarm(ArmingBar::CheckOver); });
    connect(m_directions, &DirectionCard::worked, this, &FlightPage::touch);
    connect(m_steps->startButton(), &QPushButton::clicked, this, &FlightPage::takeSticks);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive)
            disarm(ArmingBar::Focus);
    });
    m_send.setInterval(kFlightPeriod);
    m_send.setTimerType(Qt::PreciseTimer);
    connect(&m_send, &QTimer::timeout, this, &FlightPage::tick);
    m_refresh.setInterval(kFlightRefresh);
    connect(&m_refresh, &QTimer::timeout, this, &FlightPage::showNow);
}

const Steering *FlightPage::steering() const
{
    const Device *device = workspace().client().device();
    return workspace().client().isConnected() && device ? device->steering() : nullptr;
}

ArmingSession::Known FlightPage::known() const
{
    const DeviceClient &client = workspace().client();
    const ChannelRoles &roles = workspace().roles();
    const auto store = client.telemetry();
    ArmingSession::Known known;
    known.isLinked = client.isConnected() && store && steering() && client.identity().writable;
    if (!known.isLinked)
        return known;
    known.toldAt = roles.armed >= 0 ? store->latestAt(roles.armed) : TimePoint{};
    known.heardAt = known.toldAt;
    if (roles.angle[0] >= 0)
        known.heardAt = std::max(known.heardAt, store->latestAt(roles.angle[0]));
    known.isArmed = freshlyTold(workspace(), roles.armed);
    if (m_session.isArming())
        known.disarmedAt = lastToldZero(workspace(), roles.armed, m_begun);
    known.isCalibrated = freshlyTold(workspace(), roles.calibrated);
    known.isCalibrating = freshlyTold(workspace(), roles.calibrating);
    known.isDriven = freshlyTold(workspace(), roles.outputs);
    known.isBusy = workspace().isAtWork() || workspace().isWriting();
    known.isStopping = client.isStopUnproven();
    const auto &quality = client.statistics().quality;
    known.isShared = quality && quality->isShared;
    const QList<AlarmReport> open = workspace().alarms().pressing();
    known.isBatteryLow = std::any_of(open.begin(), open.end(), [](const AlarmReport &report) {
        return report.alarm.kind == AlarmKind::Battery;
    });
    for (const int angle : {roles.angle[0], roles.angle[1]})
        known.tiltDeg = std::fmax(known.tiltDeg, std::abs(workspace().latest(angle)));
    using Level = CheckedDirections::Level;
    const Level level = m_directions->found().level;
    known.isChecked = m_directions->isChecking()
        ? m_directions->wantsArmed() && !m_session.isHeld() && level >= Level::Signs
        : level == Level::All;
    return known;
}

// What an old session wanted is not taken up again: each begins with the key.
void FlightPage::press()
{
    const ArmingBar bar = m_session.bar(known(), sticks(), Clock::now());
    if (bar != ArmingBar::None) {
        workspace().notifications().notify(tr("Not armed: %1").arg(barText(bar)), Notice::Attention,
                                           Concern::Stopped);
        return;
    }
    if (const QString why = whyNotBehind(*this); !why.isEmpty()) {
        workspace().notifications().notify(why, Notice::Attention, Concern::Stopped);
        return;
    }
    m_begun = Clock::now();
    // What was said of motors that stopped is over.
    workspace().notifications().settle(Concern::Stopped);
    m_gamepad->begin();
    m_session.press(m_begun);
    qApp->installEventFilter(this);  // what disarms does so wherever the keyboard is
    m_ticks = 0;
    touch();
    const LinkAddress &address = workspace().client().address();
    if (address.kind() == LinkAddress::Kind::Udp)
        m_guardian.start(address.target(), address.port(), steering()->controlFrames(setpoint(false)).stop);
    m_send.start();
    tick();
}

// Let go of before it has armed.
void FlightPage::release()
{
    if (m_session.phase() == ArmingSession::Phase::Holding)
        disarm(ArmingBar::Operator);
}

void FlightPage::tick()
{
    const TimePoint now = Clock::now();
    // A button that has moved from under the pointer comes up without a word (QAbstractButton).
    if (!m_arm->isDown() && !m_gamepad->isArmHeld())
        release();
    const auto pushed = m_gamepad->isChosen() ? m_gamepad->seen().sticks : m_pushedBefore;
    if (m_steps->isRunning() || std::exchange(m_pushedBefore, pushed) != pushed)
        touch();
    const bool isIdle = m_touched.elapsed() > 1000LL * workspace().settings().disarmSeconds()
        && !m_pad->isHeld() && !m_arm->isDown();
    if (m_session.isArming() && isIdle)
        m_session.end(ArmingBar::Idle);
    // Not only once it is armed: a gamepad is heard behind other windows too.
    if (isUnderWay() && !window()->isActiveWindow())
        m_session.end(ArmingBar::Focus);
    if (isUnderWay() && isCovered())
        m_session.end(ArmingBar::Covered);
    const bool wasArmed = m_session.phase() == ArmingSession::Phase::Armed;
    const ArmingSession::Send send = m_session.step(known(), sticks(), now);
    if (!wasArmed && m_session.phase() == ArmingSession::Phase::Armed)
        takeSticks();
    climb(now);
    if (send == ArmingSession::Send::Nothing) {
        stopSending();
        showState();
        return;
    }
    m_steps->advance(now);
    workspace().client().setControl(setpoint(send == ArmingSession::Send::Armed),
                                    DeviceClient::Steers::FlyingMachine);
    m_isSending = true;
    workspace().setFlown(m_session.isArming());
    if (m_ticks++ % kTellGuardEvery == 0)
        m_guardian.tell();
    showState();
}

// It would go on with its throttle, and nobody could steer it.
bool FlightPage::isCovered() const
{
    const QWidget *focus = QApplication::focusWidget();
    const bool isText = focus && focus->testAttribute(Qt::WA_InputMethodEnabled) && !isAncestorOf(focus)
        && !m_gamepad->isChosen();
    return isText || QApplication::activePopupWidget() || (m_panels && m_panels->isOpen());
}

// From now on keys are for the sticks, not for the button that was held.
void FlightPage::takeSticks()
{
    m_arm->setDown(false);
    if (!m_gamepad->isChosen())
        m_pad->setFocus(Qt::OtherFocusReason);
}

void FlightPage::disarm(ArmingBar why)
{
    if (!m_session.end(why))
        return;
    stopSending();
    showState();
}

void FlightPage::stopSending()
{
    m_send.stop();
    qApp->removeEventFilter(this);
    leaveSticks();
    m_gamepad->end();
    m_steps->cancel();
    workspace().setFlown(false);
    const bool wasSending = std::exchange(m_isSending, false);
    m_pad->reset();
    m_yaw->setValue(0);
    m_climbing = 0;
    m_throttle->setValue(0);  // does not wait for the next time
    if (!wasSending) {
        m_guardian.leave();
        return;
    }
    workspace().client().releaseControl();
    const ArmingBar why = m_session.ended();
    if (why != ArmingBar::Operator && why != ArmingBar::Emergency)
        workspace().notifications().notify(tr("Control has ended: %1").arg(barText(why)), Notice::Attention,
                                           Concern::Stopped);
}

// Only who opens a session has to know, and a screen that nobody sees is not locked.
void FlightPage::followSystem()
{
    if (std::exchange(m_isFollowing, true) || QGuiApplication::platformName() == u"offscreen")
        return;
    for (const Lock &lock : kLocks) {
        QDBusConnection bus = lock.isOfSystem ? QDBusConnection::systemBus() : QDBusConnection::sessionBus();
        bus.connect({}, {}, QLatin1String(lock.interface), QLatin1String(lock.signal), this,
                    SLOT(onScreenLocked(bool)));
    }
    QDBusConnection::systemBus().connect({}, {}, u"org.freedesktop.login1.Session"_s, u"Lock"_s, this,
                                         SLOT(onSessionLocked()));
}

QCheckBox *FlightPage::padChoice() const
{
    return m_gamepad->choice();
}

void FlightPage::closeSession()
{
    workspace().setPropellersOn(false);
    if (m_session.close())
        stopSending();
}

void FlightPage::showNow()
{
    showGamepad();
    showAttitude(workspace(), *m_attitude);
    showMotors(workspace(), *m_motors);
    m_motors->setAsked(m_directions->asked());
    m_throttleText->setText(tr("%1 %").arg(qRound(kFullStick * sticks().throttle)));
    m_keys->setVisible(!m_gamepad->isChosen());
    const auto text = [](double number, int decimals, const QString &unit) {
        return std::isnan(number) ? u"–"_s : u"%1 %2"_s.arg(numberText(number, decimals), unit);
    };
    QString rows;
    const auto angles = shownAngles(workspace());
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        rows += u"<tr><td>%1</td><td align='right'>%2</td></tr>"_s.arg(axisLabel(kAxes[axis]),
                                                                       text(angles[axis], 1, u"°"_s));
    rows += u"<tr><td>%1</td><td align='right'>%2</td></tr>"_s.arg(
        tr("Battery"), text(workspace().latest(workspace().roles().battery), 1, u"V"_s));
    m_numbers->setText(u"<table width='100%'>%1</table>"_s.arg(rows));
    m_directions->feed(pushed(),
                       {.isOpen = m_session.phase() != ArmingSession::Phase::Closed,
                        .isHeld = m_session.isHeld(),
                        .isArmed = m_session.phase() == ArmingSession::Phase::Armed});
    showState();
}

bool FlightPage::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_yaw && ControlPad::endsDrag(*m_yaw, *event))
        m_yaw->setValue(0);
    const bool isKey = event->type() == QEvent::KeyPress;
    const int key = isKey ? static_cast<QKeyEvent *>(event)->key() : 0;
    // Held by the key, the button that arms is still down when it has armed.
    const bool isHolding = isKey && static_cast<QKeyEvent *>(event)->isAutoRepeat();
    if (m_session.isArming() && !isHolding && (key == Qt::Key_Escape || key == Qt::Key_Space)) {
        disarm(ArmingBar::Operator);
        return true;
    }
    const auto *widget = qobject_cast<QWidget *>(watched);
    if (!widget || (widget != this && !isAncestorOf(widget)))
        return Page::eventFilter(watched, event);  // of the whole program, while it is armed
    if (event->type() == QEvent::WindowDeactivate)
        disarm(ArmingBar::Focus);
    if ((isKey || event->type() == QEvent::KeyRelease) && watched != m_pad
        && givesToSticks(watched, *static_cast<QKeyEvent *>(event)))
        return true;
    return Page::eventFilter(watched, event);
}

void FlightPage::onScreenLocked(bool locked)
{
    if (locked)
        disarm(ArmingBar::Locked);
}

void FlightPage::onSessionLocked()
{
    disarm(ArmingBar::Locked);
}

void FlightPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_panels = window()->findChild<PanelArea *>();
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle}) + roles.motors;
    });
    m_gamepad->setShown(true);
    m_refresh.start();
    showState();
}

void FlightPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    disarm(ArmingBar::Hidden);
    m_gamepad->setShown(false);
    m_directions->cancel();
    m_refresh.stop();
}
