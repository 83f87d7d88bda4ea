// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/benchpage.h"

#include "app/families/bcflight/benchcards.h"
#include "app/families/bcflight/droneobstacle.h"
#include "app/workspace/flightstate.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kBenchRefresh = 100ms;
constexpr int kSideWidth = 460;
constexpr int kMostNumber = 8;
constexpr double kOffMiddle = 4;  // pixels

// Where it is drawn; which side of the drone that is, only the check of directions tells.
QString placeText(const MotorDiagram &motors, int motor)
{
    const QPointF off = motors.placeOf(motor) - QRectF(motors.rect()).center();
    const int across = std::abs(off.x()) < kOffMiddle ? 0 : off.x() < 0 ? -1 : 1;
    if (!motors.hasPlaces() || std::abs(off.y()) < kOffMiddle)
        return across < 0 ? BenchPage::tr("left")
            : across > 0  ? BenchPage::tr("right")
                          : BenchPage::tr("in the middle");
    if (motors.areSidesKnown() && across != 0)
        return off.y() < 0 ? (across < 0 ? BenchPage::tr("front left") : BenchPage::tr("front right"))
                           : (across < 0 ? BenchPage::tr("rear left") : BenchPage::tr("rear right"));
    if (off.y() < 0)
        return across < 0 ? BenchPage::tr("top left")
            : across > 0  ? BenchPage::tr("top right")
                          : BenchPage::tr("at the top");
    return across < 0 ? BenchPage::tr("bottom left")
        : across > 0  ? BenchPage::tr("bottom right")
                      : BenchPage::tr("at the bottom");
}

}  // namespace

BenchPage::BenchPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"bench"_s, tr("Test bench"), parent)
    , m_state(new ArmedState(workspace.theme()))
    , m_motors(new MotorDiagram(workspace.theme()))
    , m_number(new NumberBox(1, kMostNumber, 0))
    , m_turn(new QPushButton)
    , m_why(new QLabel)
    , m_deaf(new QLabel)
    , m_deafBar(new QProgressBar)
    , m_beep(new QPushButton(tr("Beep")))
    , m_silence(new QPushButton(tr("Stop beeping")))
    , m_go(new QPushButton)
    , m_beepSaid(new QLabel)
    , m_escs(new EscCard)
    , m_firmware(new FirmwareCard(workspace))
{
    auto *columns = new QHBoxLayout;
    columns->setSpacing(12);
    columns->addWidget(makeMotors(), 3);
    columns->addWidget(makeSignals(), 2);
    body()->addLayout(columns, 1);
    coverWhenStale(*m_motors, [this] { return this->workspace().roles().motors; });
    refreshWhileShown(
        kBenchRefresh, [this] { refresh(); }, [] { return false; });
    connectAll();
    refresh();
}

QWidget *BenchPage::makeMotors()
{
    auto *card = new Card(tr("Turn one motor"));
    auto *what = new QLabel(tr("⚠ Propellers off. The motor turns at 5 % for 5 s; the drone hears nothing "
                               "for 8 s, also no stop."));
    what->setObjectName(u"warning"_s);
    m_number->setAccessibleName(tr("Motor"));
    m_number->setMinimumWidth(72);
    m_motors->setSelectable(true);
    m_turn->setObjectName(u"primary"_s);
    m_why->setObjectName(u"muted"_s);
    m_deaf->setObjectName(u"error"_s);
    for (QLabel *label : {what, m_why, m_deaf})
        label->setWordWrap(true);
    m_deafBar->setTextVisible(false);
    m_deafBar->setAccessibleName(tr("How long the drone still hears nothing"));
    QSizePolicy kept = m_deafBar->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    m_deafBar->setSizePolicy(kept);
    // Room for what is said there comes and goes with nothing else moving.
    m_deaf->setMinimumHeight(3 * m_deaf->fontMetrics().lineSpacing());
    m_deaf->setAlignment(Qt::AlignTop);
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("&Motor"));
    label->setBuddy(m_number);
    row->addWidget(label);
    row->addWidget(m_number);
    row->addWidget(m_turn);
    row->addStretch(1);
    card->content()->addWidget(what);
    card->content()->addWidget(m_motors, 1);
    card->content()->addLayout(row);
    card->content()->addWidget(m_why);
    card->content()->addWidget(m_go, 0, Qt::AlignLeft);
    card->content()->addWidget(m_deafBar);
    card->content()->addWidget(m_deaf);
    auto *left = new QWidget;
    auto *rows = new QVBoxLayout(left);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    rows->addWidget(m_state);
    rows->addWidget(card, 1);
    return left;
}

QWidget *BenchPage::makeSignals()
{
    auto *beeper = new Card(tr("Find it by its sound"));
    auto *what = new QLabel(tr("The motors beep until they are told to stop. The drone does not say whether "
                               "they do."));
    what->setWordWrap(true);
    m_beepSaid->setObjectName(u"muted"_s);
    auto *row = new QHBoxLayout;
    row->addWidget(m_beep);
    row->addWidget(m_silence);
    row->addWidget(m_beepSaid, 1);
    beeper->content()->addWidget(what);
    beeper->content()->addLayout(row);
    auto *side = new QWidget;
    auto *rows = new QVBoxLayout(side);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    rows->addWidget(beeper);
    rows->addWidget(m_escs);
    rows->addWidget(m_firmware);
    rows->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setWidget(side);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(side->minimumSizeHint().width() + Metric::kMargin);
    scroll->setMaximumWidth(kSideWidth);
    return scroll;
}

void BenchPage::connectAll()
{
    connect(m_motors, &MotorDiagram::selectedChanged, this, [this](int motor) {
        const QSignalBlocker blocker(m_number);
        if (motor > 0)
            m_number->setValue(motor);
        refresh();
    });
    connect(m_number, &NumberBox::valueChanged, this, [this](double motor) {
        m_motors->setSelected(int(motor));
        refresh();
    });
    connect(m_turn, &QPushButton::clicked, this, &BenchPage::turn);
    connect(m_beep, &QPushButton::clicked, this, [this] { beep(true); });
    connect(m_silence, &QPushButton::clicked, this, [this] { beep(false); });
    connect(m_escs->startButton(), &QPushButton::clicked, this, &BenchPage::calibrateEscs);
    connect(m_firmware, &FirmwareCard::runningChanged, this, &BenchPage::begin);
    connect(&workspace().client(), &DeviceClient::progressChanged, this, &BenchPage::onProgress);
    connect(m_go, &QPushButton::clicked, this, [this] { emit actionWanted(m_lacking); });
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &BenchPage::refresh);
    // Whether it still beeps then, nobody knows.
    connect(&workspace().client(), &DeviceClient::stateChanged, m_beepSaid, &QLabel::clear);
    connect(&workspace().client(), &DeviceClient::motorsOffBegun, m_beepSaid, &QLabel::clear);
    connect(&workspace().client(), &DeviceClient::deafChanged, this, [this] {
        m_deafFor = seconds(this->workspace().client().deafUntil() - Clock::now());
        refreshDeaf();
    });
}

void BenchPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] { return workspace().roles().motors; });
}

QString BenchPage::obstacle() const
{
    return droneObstacle(workspace(), Calibration::Needed);
}

void BenchPage::refresh()
{
    m_state->setState(flightState(workspace()));
    showMotors(workspace(), *m_motors);
    if (m_motors->count() > 0 && m_motors->selected() == 0)
        m_motors->setSelected(int(m_number->value()));  // the field shows one, so that one is chosen
    const int told = motorCount(workspace());
    const int motor = m_motors->selected();
    const bool isFree = !m_isRunning && obstacle().isEmpty();
    // What was asked about is what turns.
    m_number->setEnabled(m_motors->count() > 0 && !m_isRunning);
    m_turn->setText(motor > 0 ? tr("Turn motor %1…").arg(motor) : tr("Turn a motor…"));
    m_turn->setEnabled(isFree && told > 0 && motor > 0 && motor <= told);
    m_why->setText(m_turned > 0 ? tr("Motor %1, %2 in the picture. Until it is over no other can be chosen.")
                                      .arg(m_turned)
                                      .arg(placeText(*m_motors, m_turned))
                       : m_isRunning           ? QString()
                       : !obstacle().isEmpty() ? obstacle()
                       : told == 0    ? tr("The drone does not stream its outputs, so nobody knows how many "
                                              "motors it has. Switch full telemetry on.")
                       : motor == 0   ? tr("Click a motor, or choose its number.")
                       : motor > told ? tr("The drone has %n motor(s).", nullptr, told)
                                      : tr("That the propellers are off is asked each time."));
    m_lacking = m_isRunning                                    ? QString()
        : m_state->state() == ArmedState::State::NotCalibrated ? u"calibrate.all"_s
        : obstacle().isEmpty() && told == 0                    ? u"telemetry.full"_s
                                                               : QString();
    m_go->setText(m_lacking == u"telemetry.full"_s ? tr("Full telemetry (Actions)…")
                                                   : tr("Calibrate (Actions)…"));
    m_go->setVisible(!m_lacking.isEmpty());
    const QString busy = m_isRunning ? tr("Wait until what is being done is over.") : QString();
    m_escs->setObstacle(m_isRunning ? busy : obstacle());
    const QString atRest = droneObstacle(workspace(), Calibration::NotNeeded);
    m_firmware->setObstacle(m_isRunning ? busy : atRest);
    m_beep->setEnabled(atRest.isEmpty() && !m_isRunning);
    m_silence->setEnabled(atRest.isEmpty() && !m_isRunning);
    refreshDeaf();
}

QString BenchPage::deafText() const
{
    const double left = seconds(workspace().client().deafUntil() - Clock::now());
    if (left <= 0)
        return {};
    return tr("The drone hears nothing for %n more second(s), also no stop. Stop motors (F12) is then the "
              "first thing that it hears. To stop it at once: its battery.",
              nullptr, int(std::ceil(left)));
}

void BenchPage::refreshDeaf()
{
    const QString text = deafText();
    m_deaf->setText(text);
    m_deafBar->setVisible(!text.isEmpty());
    if (text.isEmpty())
        return;
    const double left = seconds(workspace().client().deafUntil() - Clock::now());
    m_deafBar->setRange(0, int(std::ceil(std::max(m_deafFor, left) * 10)));
    m_deafBar->setValue(int(left * 10));
}

void BenchPage::begin(bool running)
{
    m_isRunning = running;
    m_motors->setSelectable(!running);
    if (!running) {
        m_turned = 0;
        m_motors->setTested(0);
        m_escs->setRunning(false);
    }
    refresh();
}

void BenchPage::onProgress(const Progress &progress)
{
    m_motors->setTested(progress.step == u"motor-test"_s ? int(progress.values.value(u"motor"_s)) : 0);
    m_escs->take(progress);
    m_firmware->take(progress);
}

void BenchPage::turn()
{
    if (NumberBox::refusedIn(*this))
        return;
    m_turned = m_motors->selected();
    begin(true);
    whenDone(workspace().perform(u"motor.test"_s, {{u"motor"_s, m_turned}}), this,
             [this](const Result<ActionOutcome> &) { begin(false); });
}

void BenchPage::beep(bool on)
{
    whenDone(workspace().perform(u"motors.beep"_s, {{u"on"_s, on}}), this,
             [this, on](const Result<ActionOutcome> &outcome) {
                 m_beepSaid->setText(!outcome ? QString() : on ? tr("Sent: beep") : tr("Sent: stop"));
             });
}

void BenchPage::calibrateEscs()
{
    begin(true);
    whenDone(workspace().perform(u"escs.calibrate"_s, {}), this,
             [this](const Result<ActionOutcome> &outcome) {
                 begin(false);
                 if (outcome)
                     workspace().notifications().notify(tr("The calibration of the motor controllers is "
                                                           "over. Whether they took it only their tones "
                                                           "tell."),
                                                        Notice::Attention);
             });
}
