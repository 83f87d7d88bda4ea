// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/calibrationpage.h"

#include "app/families/simplebgc/copycard.h"
#include "app/families/simplebgc/magnetometercard.h"
#include "app/workspace/question.h"
#include "app/workspace/wizardparts.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/whendone.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/numbertext.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/views/sensorcube.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <bit>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLookPeriod = 100ms;
constexpr double kStillSpan = 1.0;  // seconds without motion before a measurement
constexpr double kStillEnough = 0.8;  // deg/s, standard deviation of the shakiest axis
constexpr double kFaceUp = 0.8;  // g on the axis that points up
constexpr double kFaceSide = 0.35;  // g at most on the others
// Residual errors that are good and that are usable.
constexpr double kGoodBias = 0.1;
constexpr double kFairBias = 0.5;
constexpr double kGoodLevel = 0.012;
constexpr double kFairLevel = 0.04;
constexpr int kDefaultSeconds = 6;

QString rating(double value, double good, double fair)
{
    return value <= good ? CalibrationPage::tr("good")
        : value <= fair  ? CalibrationPage::tr("usable")
                         : CalibrationPage::tr("poor, repeat it");
}

}  // namespace

CalibrationPage::CalibrationPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"calibration"_s, tr("Calibration"), parent)
    , m_stack(new QStackedWidget)
    , m_sensor(new QComboBox)
    , m_magnetometer(new MagnetometerCard(workspace))
    , m_what(new QLabel)
    , m_sees(new QLabel)
    , m_result(new QLabel)
    , m_cube(new SensorCube(workspace.theme()))
    , m_stillness(new QProgressBar)
    , m_progress(new QProgressBar)
    , m_positions(new FaceList)
    , m_hands(new SimulatedHands(workspace, SimulatedHands::faces(), this))
    , m_back(new QPushButton(tr("Back")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_continue(new QPushButton(tr("Continue")))
{
    m_sensor->setAccessibleName(tr("Sensor that the board shows and calibrates"));
    m_sensor->addItem(tr("Sensor: main IMU"), 1);
    m_sensor->addItem(tr("Sensor: frame IMU"), 2);
    header()->addWidget(m_sensor);
    m_stack->addWidget(makeChooser());
    m_stack->addWidget(makeWizard());
    m_stack->addWidget(m_magnetometer);
    m_hands->add(u"hand"_s, tr("How the simulated camera is turned"),
                 {{tr("not turned, unless the page asks for it"), 0},
                  {tr("turned to all sides"), 5},
                  {tr("turned about its upright axis only"), 6}});
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_stack, 1);
    body()->addLayout(row, 1);
    body()->addWidget(m_hands);

    connect(m_back, &QPushButton::clicked, this, [this] { setStep(Step::Choose); });
    connect(m_cancel, &QPushButton::clicked, this, &CalibrationPage::cancel);
    connect(m_continue, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Place)
            measure();
        else
            setStep(Step::Choose);
    });
    connect(&workspace.client(), &DeviceClient::progressChanged, this, [this](const Progress &progress) {
        if (m_step == Step::Measure && progress.step == u"calibrate"_s)
            m_progress->setValue(progress.done);
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this] {
        const bool isMeasured = m_step == Step::Place || m_step == Step::Measure;
        if (!this->workspace().client().isConnected() && isMeasured)
            breakOff();
        updateButtons();
    });
    connect(m_sensor, &QComboBox::activated, this, [this] {
        whenDone(this->workspace().perform(u"imu.select"_s, {{u"imu"_s, m_sensor->currentData()}}), this,
                 [this](const Result<ActionOutcome> &) { followSensor(); });
    });
    connect(m_magnetometer, &MagnetometerCard::left, this, [this] { setStep(Step::Choose); });
    m_timer.setInterval(kLookPeriod);
    connect(&m_timer, &QTimer::timeout, this, &CalibrationPage::look);
    setStep(Step::Choose);
    updateButtons();
}

QWidget *CalibrationPage::makeChooser()
{
    auto *holder = new QWidget;
    auto *column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    column->addLayout(row);
    m_copies = new CopyCard(
        workspace(), tr("Copies of the calibrations"),
        tr("Keep the calibrations that the board holds in files, and compare what it has now with what it "
           "had "
           "before. What its sensors keep themselves no command reads."),
        u"calibration.bin"_s,
        {{tr("Copy…"), tr("Into a file; nothing on the board is changed"), u"calibration.save"_s, true},
         {tr("Compare…"), tr("Tell what differs between a copy and the board"), u"calibration.compare"_s},
         {tr("Restore…"),
          tr("Write the calibrations of a copy"),
          u"calibration.restore"_s,
          false,
          {},
          true}});
    column->addWidget(makeFurther());
    column->addWidget(m_copies, 1);
    const auto add
        = [&](Kind kind, const QString &title, const QString &text, const QString &button, int face) {
              connect(addMethod(*row, workspace().theme(), title, text, button, face), &QPushButton::clicked,
                      this, [this, kind] {
                          if (kind == Kind::SixPositions)
                              askForMotorsOff(workspace(), this, [this, kind] { start(kind); });
                          else
                              start(kind);
                      });
          };
    add(Kind::Gyroscope, tr("Gyroscope"),
        tr("Finds the zero of the turn-rate sensor. Do it when the camera drifts, after large temperature "
           "changes, and before anything else. Takes about ten seconds, with the camera lying still."),
        tr("Calibrate the gyroscope"), 4);
    add(Kind::Level, tr("Accelerometer, level"),
        tr("Finds what is level. Do it when the horizon is crooked. Takes about ten seconds, with the sensor "
           "lying level."),
        tr("Calibrate level"), 0);
    add(Kind::SixPositions, tr("Accelerometer, six positions"),
        tr("Finds zero and scale of all three directions, for a horizon that stays straight at every angle. "
           "Do it once for "
           "each sensor; each of its six faces has to lie up once. Takes about two minutes."),
        tr("Calibrate six positions"), 2);
    auto *scroll = new QScrollArea;
    scroll->setWidget(holder);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    return scroll;
}

QWidget *CalibrationPage::makeFurther()
{
    m_further = new Card(tr("Magnetometer"));
    auto *text = new QLabel(tr(
        "Finds what the iron beside it adds to the earth's field. Do it when the camera does not keep its "
        "heading, and after anything made of iron was mounted. Takes about a minute, with the camera turned "
        "in your hands to all sides."));
    text->setWordWrap(true);
    auto *go = new QPushButton(tr("Magnetometer…"));
    setHarmless(*go);  // it leads to the first step
    connect(go, &QPushButton::clicked, this, &CalibrationPage::startMagnetometer);
    auto *row = new QHBoxLayout;
    row->addWidget(text, 1);
    row->addWidget(go);
    m_further->content()->addLayout(row);
    return m_further;
}

QWidget *CalibrationPage::makeWizard()
{
    auto *card = new Card({});
    setHeadline(*m_what);
    m_sees->setWordWrap(true);
    m_result->setObjectName(u"result"_s);
    m_result->setWordWrap(true);
    m_result->setAlignment(Qt::AlignTop);
    m_result->setTextFormat(Qt::RichText);
    setQuiet(*m_stillness, tr("Stillness"));  // the sentence above gives the meaning
    setQuiet(*m_progress, tr("Progress of the measurement"));
    m_continue->setObjectName(u"primary"_s);
    for (QPushButton *button : {m_back, m_cancel, m_continue})
        setHarmless(*button);  // what is measured lies still, and nothing is moved
    auto *middle = new QHBoxLayout;
    middle->setSpacing(Metric::kGroupGap);
    middle->addWidget(m_cube, 2);
    middle->addWidget(m_result, 2);  // in the cube's place when the measurement is over
    middle->addWidget(m_positions, 1);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_back);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_continue);
    QVBoxLayout *content = card->content();
    content->setSpacing(12);
    content->addWidget(m_what);
    content->addLayout(middle, 1);
    content->addWidget(m_sees);
    content->addWidget(m_stillness);
    content->addWidget(m_progress);
    content->addLayout(buttons);
    return card;
}

void CalibrationPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        QList<int> channels = ChannelRoles::present({roles.gyro, roles.acc});
        if (workspace().hasAction(u"calibrate.magnetometer"_s))
            channels += {simplebgc::MagRoll, simplebgc::MagPitch, simplebgc::MagYaw, simplebgc::HeadingError};
        return channels;
    });
    updateButtons();
    m_timer.start();
}

void CalibrationPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
}

void CalibrationPage::startMagnetometer()
{
    m_stack->setCurrentWidget(m_magnetometer);
    m_magnetometer->begin();
}

bool CalibrationPage::isUnderWay() const
{
    return m_step == Step::Place || m_step == Step::Measure
        || m_magnetometer->step() == MagnetometerCard::Step::Turning;
}

void CalibrationPage::updateButtons()
{
    m_further->setVisible(workspace().hasAction(u"calibrate.magnetometer"_s));
    const bool can = !workspace().client().device() || workspace().hasAction(u"calibrate.gyro"_s);
    for (QPushButton *button : m_stack->widget(0)->findChildren<QPushButton *>()) {
        if (m_copies->isAncestorOf(button))
            continue;
        button->setEnabled(workspace().client().isConnected() && workspace().client().identity().writable
                           && can);
        button->setToolTip(can ? QString() : tr("This board has no command for it."));
    }
}

int CalibrationPage::doneCount() const
{
    return std::popcount(m_done);
}

void CalibrationPage::start(Kind kind)
{
    m_kind = kind;
    m_begunWith = workspace().latest(simplebgc::CurrentImu);
    m_done = 0;
    m_quality = {};
    setStep(Step::Place);
}

void CalibrationPage::setStep(Step step)
{
    m_step = step;
    m_stack->setCurrentIndex(step == Step::Choose ? 0 : 1);
    const bool six = m_kind == Kind::SixPositions;
    m_positions->setVisible(six && step != Step::Choose);
    m_positions->setDone(m_done);
    m_stillness->setVisible(step == Step::Place);
    m_sees->setVisible(step == Step::Place || step == Step::Measure);
    m_progress->setVisible(step == Step::Measure);
    m_cube->setVisible(step == Step::Place || step == Step::Measure);
    m_result->setVisible(step == Step::Result);
    m_back->setVisible(step == Step::Place && doneCount() == 0);
    m_cancel->setVisible(step == Step::Measure || (step == Step::Place && doneCount() > 0));
    m_continue->setText(step == Step::Result ? tr("Finish") : tr("Continue"));
    m_continue->setEnabled(step == Step::Result);
    m_continue->setVisible(step != Step::Measure);
    if (step == Step::Place) {
        switch (m_kind) {
        case Kind::Gyroscope:
            m_what->setText(
                tr("Lay the camera down so that nothing moves it. Take your hands off the table."));
            break;
        case Kind::Level: m_what->setText(tr("Put the sensor level, Z up, and let it lie still.")); break;
        case Kind::SixPositions:
            m_what->setText(
                doneCount() == 0
                    ? tr("Lay the sensor on one of its six faces, with the motors off. Begin with Z up.")
                    : tr("%1 of 6 done. Lay the sensor on another face.").arg(doneCount()));
            break;
        }
        look();
    } else if (step == Step::Measure) {
        m_progress->setValue(0);
        m_what->setText(
            tr("Measuring. Leave it absolutely still for about %1 seconds; the motors are off meanwhile.")
                .arg(kDefaultSeconds));
        m_sees->setText(tr("If it is moved, the board begins again."));
    }
    if (step != Step::Choose && isVisible())
        (m_continue->isEnabled() ? m_continue : m_cancel->isVisible() ? m_cancel : m_back)->setFocus();
}

QString CalibrationPage::waitingFor() const
{
    if (std::isnan(m_motion) || std::isnan(m_acc[0]))
        return tr("Waiting for live data of the sensor.");
    // What a board repeats looks perfectly still.
    if (const QString trouble = workspace().freshness().troubleText(); !trouble.isEmpty())
        return tr("%1. Waiting until the sensor sends live data again.").arg(trouble);
    if (m_motion > kStillEnough)
        return tr("It moves (%1 °/s). Waiting until it is still.").arg(numberText(m_motion, 1));
    if (m_kind == Kind::SixPositions && workspace().motorsRunning() == true)
        return tr("The motors run. Stop them before the sensor is turned over.");
    if (m_kind != Kind::Gyroscope && !isGravity(m_acc, 1.0))
        return tr("It measures %1 g instead of 1 g, which no sensor at rest does. Let it lie still, or check "
                  "the sensor and its calibration.")
            .arg(numberText(std::hypot(m_acc[0], m_acc[1], m_acc[2]), 2));
    if (m_kind == Kind::Level && m_face != 0)
        return tr("Still, but not level: %1. Waiting for Z up.").arg(faceName(m_face));
    if (m_kind == Kind::SixPositions && m_face < 0)
        return tr("Still, but tilted. Waiting until one face lies up.");
    if (m_kind == Kind::SixPositions && m_done >> m_face & 1U)
        return tr("%1 is done already. Waiting for another face.").arg(faceName(m_face));
    return {};
}

// Whoever has selected it, a program beside this one or a restart as well.
void CalibrationPage::followSensor()
{
    const double selected = workspace().latest(simplebgc::CurrentImu);
    if (const int at = std::isnan(selected) ? 0 : m_sensor->findData(int(selected));
        at >= 0 && !m_sensor->view()->isVisible())
        m_sensor->setCurrentIndex(at);
    m_sensor->setVisible(workspace().hasAction(u"imu.select"_s));
    m_sensor->setEnabled(workspace().client().isConnected() && !isUnderWay()
                         && !workspace().client().isBusy());
    if (std::isnan(m_begunWith))
        m_begunWith = selected;
    const bool isOther = m_step == Step::Place && !std::isnan(selected) && selected != m_begunWith;
    if (!isOther)
        return;
    workspace().notifications().notify(tr("The board shows another sensor now. The calibration begins anew."),
                                       Notice::Attention);
    start(m_kind);
}

void CalibrationPage::look()
{
    followSensor();
    if (m_step != Step::Place)
        return;
    const auto store = workspace().client().telemetry();
    const ChannelRoles &roles = workspace().roles();
    m_motion = std::nan("");
    m_face = -1;
    if (store && workspace().client().isConnected()) {
        const double now = store->now();
        m_motion = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double deviation
                = spanStatistics(*store, roles.gyro[axis], -1, now - kStillSpan, now).aroundMean().rms;
            // Without samples, a sensor does not count as still.
            m_motion = std::isnan(deviation) ? deviation : std::max(m_motion, deviation);
            m_acc[axis] = spanStatistics(*store, roles.acc[axis], -1, now - kStillSpan / 2, now).mean;
            if (std::isnan(m_motion))
                break;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double up = m_acc[std::size_t(axis)];
            const double side = std::max(std::abs(m_acc[std::size_t((axis + 1) % 3)]),
                                         std::abs(m_acc[std::size_t((axis + 2) % 3)]));
            constexpr std::array<int, 3> faceOfAxis{2, 4, 0};
            if (std::abs(up) > kFaceUp && side < kFaceSide)
                m_face = faceOfAxis[std::size_t(axis)] + (up < 0 ? 1 : 0);
        }
    }
    m_cube->setPosition(m_face);
    m_stillness->setValue(
        std::isnan(m_motion) ? 0 : int(100.0 * std::clamp(1.0 - m_motion / (4 * kStillEnough), 0.0, 1.0)));
    const QString waiting = waitingFor();
    m_satisfied = waiting.isEmpty();
    m_sees->setText(m_satisfied ? tr("✓ Still, %1. Ready.").arg(faceName(m_face)) : waiting);
    m_sees->setObjectName(m_satisfied ? u"ok"_s : u"muted"_s);
    repolish(m_sees);
    const bool had = m_continue->isEnabled();
    m_continue->setEnabled(m_satisfied);
    if (m_satisfied && !had && m_back->hasFocus())
        m_continue->setFocus();
}

void CalibrationPage::measure()
{
    m_measuring = std::max(0, m_face);
    setStep(Step::Measure);
    const QString key = m_kind == Kind::Gyroscope ? u"calibrate.gyro"_s : u"calibrate.acc"_s;
    whenDone(workspace().perform(
                 key,
                 {{u"imu"_s, 0}, {u"action"_s, 1}, {u"form"_s, 0}, {u"six"_s, m_kind == Kind::SixPositions}},
                 true),
             this, [this](const Result<ActionOutcome> &outcome) { onMeasured(outcome); });
}

void CalibrationPage::onMeasured(const Result<ActionOutcome> &outcome)
{
    if (m_step != Step::Measure)
        return;
    if (!outcome && isLinkLoss(outcome.error())) {
        breakOff();
        return;
    }
    if (!outcome) {
        ErrorText text = describe(outcome.error());
        if (outcome.error().code == ErrorCode::Cancelled) {
            text.what = tr("The calibration was cancelled.");
            text.meaning = tr("The board may still finish this measurement by itself within a few seconds.");
            text.cure = tr("Calibrate again when the sensor lies still.");
        }
        workspace().notifications().report(text);
        setStep(Step::Choose);
        return;
    }
    const QVariantMap &figures = outcome->reply;
    const double level = figures.value(u"acc.error.after"_s).toDouble();
    m_quality.biasAfter = figures.value(u"gyro.bias.after"_s).toDouble();
    m_quality.biasBefore = figures.value(u"gyro.bias.before"_s).toDouble();
    m_quality.noise = figures.value(u"gyro.noise"_s).toDouble();
    m_quality.level = level;
    m_done |= 1U << m_measuring;
    if (m_kind == Kind::SixPositions && doneCount() < kSensorFaces) {
        setStep(Step::Place);  // the error says something about the calibration only once all six are known
        return;
    }
    showResult();
}

// The link is gone in the middle: what was done by then, and what is not known.
void CalibrationPage::breakOff()
{
    QStringList meaning;
    if (m_kind == Kind::SixPositions && m_done) {
        QStringList faces;
        for (int face = 0; face < kSensorFaces; ++face) {
            if (m_done >> face & 1U)
                faces.append(faceName(face));
        }
        meaning.append(tr("%1 of 6 positions were measured: %2.").arg(doneCount()).arg(faces.join(u", "_s)));
    }
    if (m_step == Step::Measure)
        meaning.append(tr("Whether the board has finished the measurement under way is not known."));
    else if (!m_done)
        meaning.append(tr("Nothing was measured; the sensor's calibration is the one from before."));
    const QString again = tr("Calibrate again from the beginning when the board is connected.");
    workspace().notifications().report(
        ErrorText{tr("The calibration ended with the link."), meaning.join(u' '), again, {}},
        Concern::Writing);
    setStep(Step::Choose);
}

void CalibrationPage::showResult()
{
    const bool gyro = m_kind == Kind::Gyroscope;
    const double figure = gyro ? m_quality.biasAfter : m_quality.level;
    const QString verdict
        = gyro ? rating(figure, kGoodBias, kFairBias) : rating(figure, kGoodLevel, kFairLevel);
    m_what->setText(gyro ? tr("Gyroscope: %1").arg(verdict) : tr("Accelerometer: %1").arg(verdict));
    QString html = u"<table>"_s;
    const auto row = [&html](const QString &name, const QString &value) {
        html += u"<tr><td style='padding:2px 24px 2px 0'>%1</td>"
                "<td style='padding:2px 0' align='right'>%2</td></tr>"_s.arg(name.toHtmlEscaped(),
                                                                             value.toHtmlEscaped());
    };
    row(tr("Sensor"), m_begunWith == 2 ? tr("frame IMU") : tr("main IMU"));
    if (gyro) {
        row(tr("Drift before"), tr("%1 °/s").arg(numberText(m_quality.biasBefore, 2)));
        row(tr("Drift now"), tr("%1 °/s").arg(numberText(m_quality.biasAfter, 2)));
        row(tr("Noise of the sensor"), tr("%1 °/s").arg(numberText(m_quality.noise, 2)));
        html += u"</table><p>%1</p>"_s.arg(
            tr("Good is a drift below %1 °/s.").arg(shortNumberText(kGoodBias)));
    } else {
        row(tr("Error against gravity"), tr("%1 g").arg(numberText(m_quality.level, 4)));
        row(tr("That is a tilt of about"),
            tr("%1°").arg(numberText(std::asin(std::min(1.0, figure)) * 180 / 3.14159265358979, 2)));
        html += u"</table><p>%1</p>"_s.arg(
            tr("Good is an error below %1 g; the noise of the sensor is part of it.")
                .arg(shortNumberText(kGoodLevel)));
    }
    html += u"<p>%1</p>"_s.arg(
        tr("The result is stored in the sensor's memory; the settings as they were are among the backups."));
    m_result->setText(html);
    setStep(Step::Result);
    m_hands->putBack();
}

void CalibrationPage::cancel()
{
    if (m_step == Step::Measure)
        workspace().client().cancelJobs();
    else
        setStep(Step::Choose);
}
