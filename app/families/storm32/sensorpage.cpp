// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/storm32/sensorpage.h"

#include "app/workspace/question.h"
#include "app/workspace/wizardparts.h"
#include "protocol/base/filefault.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/sensorcube.h"

#include <QComboBox>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <bit>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLargestFile = 1024 * 1024;
constexpr double kGoodQuality = 0.01;  // g
constexpr double kFairQuality = 0.03;
constexpr unsigned kAllFaces = (1U << kSensorFaces) - 1;

}  // namespace

SensorPage::SensorPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"sensor"_s, tr("Calibration"), parent)
    , m_stack(new QStackedWidget)
    , m_imu(new QComboBox)
    , m_what(new QLabel)
    , m_sees(new QLabel)
    , m_live(new QLabel)
    , m_result(new QLabel)
    , m_cube(new SensorCube(workspace.theme()))
    , m_faces(new FaceList)
    , m_progress(new QProgressBar)
    , m_hands(new SimulatedHands(workspace, SimulatedHands::faces(), this))
    , m_load(new QPushButton(tr("Load a calibration…")))
    , m_save(new QPushButton(tr("Save…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_again(new QPushButton(tr("Back")))
    , m_store(new QPushButton(tr("Store on the board")))
{
    m_imu->addItem(tr("Camera sensor (Imu)"), 1);
    m_imu->addItem(tr("Frame sensor (Imu2)"), 2);
    m_imu->setAccessibleName(tr("Sensor"));
    m_load->setToolTip(tr("Look at a calibration from a file before it is stored"));
    header()->addWidget(m_imu);
    header()->addWidget(m_load);
    m_stack->addWidget(makeChooser());
    m_stack->addWidget(makeWizard());
    body()->addWidget(m_stack, 1);
    body()->addWidget(m_hands);

    connect(m_load, &QPushButton::clicked, this, [this] {
        const Family *family = this->workspace().family();
        askOpenPath(
            this, tr("Load a calibration"),
            u"%1 (*.%2)"_s.arg(family->calibrationFile->name, family->calibrationFile->suffix),
            [this](const QString &path) { this->workspace().notifications().reportLoaded(loadFile(path)); });
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        const Family *family = this->workspace().family();
        const QString suffix = family->calibrationFile->suffix;
        askSavePath(this, tr("Save the calibration"), u"calibration."_s + suffix,
                    u"%1 (*.%2)"_s.arg(family->calibrationFile->name, suffix), [this](const QString &path) {
                        this->workspace().notifications().reportSaved(saveFile(path), path);
                    });
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        this->workspace().client().cancelJobs();
        setStep(Step::Choose);
    });
    connect(m_again, &QPushButton::clicked, this, [this] { setStep(Step::Choose); });
    connect(m_store, &QPushButton::clicked, this, &SensorPage::store);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, &SensorPage::onProgress);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &SensorPage::updateState);
    setStep(Step::Choose);
}

QWidget *SensorPage::makeChooser()
{
    auto *holder = new QWidget;
    auto *column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    auto *warning = new QLabel(tr("⚠ Take the battery off and work on USB power alone, so that the motors "
                                  "cannot move. Nothing is stored "
                                  "before you have seen the result."));
    warning->setObjectName(u"warning"_s);
    warning->setWordWrap(true);
    column->addWidget(warning);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    column->addLayout(row);
    column->addStretch(1);
    m_oneButton = addMethod(*row, workspace().theme(), tr("Accelerometer, one position"),
                            tr("Finds the zeros of the three axes. Takes two seconds while the sensor lies "
                               "level and still, as it is mounted. "
                               "Good enough for a horizon that is a little crooked."),
                            tr("Calibrate one position"), 0);
    m_sixButton = addMethod(*row, workspace().theme(), tr("Accelerometer, six positions"),
                            tr("Finds zeros and scales, for a horizon that stays straight at every angle. "
                               "Each of the sensor's six faces has to lie "
                               "up once, in any order. Takes about a minute."),
                            tr("Calibrate six positions"), 2);
    connect(m_oneButton, &QPushButton::clicked, this, [this] { start(false); });
    connect(m_sixButton, &QPushButton::clicked, this,
            [this] { askForMotorsOff(workspace(), this, [this] { start(true); }); });
    return holder;
}

QWidget *SensorPage::makeWizard()
{
    auto *card = new Card({});
    setHeadline(*m_what);
    for (QLabel *label : {m_sees, m_result})
        label->setWordWrap(true);
    m_live->setTextFormat(Qt::RichText);
    m_live->setAlignment(Qt::AlignTop);
    m_result->setTextFormat(Qt::RichText);
    m_result->setAlignment(Qt::AlignTop);
    setQuiet(*m_progress, tr("Progress of the measurement"));
    m_store->setObjectName(u"primary"_s);
    for (QPushButton *button : {m_again, m_cancel, m_save})
        setHarmless(*button);
    auto *middle = new QHBoxLayout;
    middle->setSpacing(Metric::kGroupGap);
    middle->addWidget(m_cube, 2);
    middle->addWidget(m_live, 1);
    middle->addWidget(m_result, 3);
    middle->addWidget(m_faces, 1);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_again);
    buttons->addWidget(m_cancel);
    buttons->addStretch(1);
    buttons->addWidget(m_save);
    buttons->addWidget(m_store);
    QVBoxLayout *content = card->content();
    content->setSpacing(12);
    content->addWidget(m_what);
    content->addLayout(middle, 1);
    content->addWidget(m_sees);
    content->addWidget(m_progress);
    content->addLayout(buttons);
    return card;
}

void SensorPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    updateState();
}

void SensorPage::updateState()
{
    const DeviceClient &client = workspace().client();
    const bool ready = client.isConnected() && client.identity().writable;
    for (QWidget *widget : {static_cast<QWidget *>(m_oneButton), static_cast<QWidget *>(m_sixButton),
                            static_cast<QWidget *>(m_load)})
        widget->setEnabled(ready);
    m_imu->setEnabled(ready && m_step == Step::Choose);
    m_store->setEnabled(ready);
    if (!client.isConnected() && m_step == Step::Measure)
        breakOff();
}

void SensorPage::breakOff()
{
    const QString done = m_six
        ? tr("%1 of 6 faces were measured; nothing of it is on the board.").arg(doneCount())
        : tr("Nothing of it is on the board.");
    workspace().notifications().notify(tr("The calibration ended with the link.") + u' ' + done,
                                       Notice::Attention);
    setStep(Step::Choose);
}

int SensorPage::doneCount() const
{
    return (m_six ? kSensorFaces : 1) - (m_six ? std::popcount(m_missing) : m_missing ? 1 : 0);
}

QString SensorPage::sees() const
{
    return m_sees->text();
}

void SensorPage::start(bool six)
{
    m_six = six;
    m_missing = kAllFaces;
    setStep(Step::Measure);
    m_sees->setText(tr("Waiting for readings of the sensor."));
    whenDone(workspace().perform(six ? u"calibrate.six"_s : u"calibrate.level"_s,
                                 {{u"imu"_s, m_imu->currentData()}, {u"store"_s, false}}, true),
             this, [this](const Result<ActionOutcome> &outcome) { onMeasured(outcome); });
}

void SensorPage::setStep(Step step)
{
    m_step = step;
    m_stack->setCurrentIndex(step == Step::Choose ? 0 : 1);
    const bool measuring = step == Step::Measure;
    m_cube->setVisible(measuring);
    m_live->setVisible(measuring);
    m_faces->setVisible(measuring && m_six);
    m_progress->setVisible(measuring);
    m_sees->setVisible(measuring);
    m_cancel->setVisible(measuring);
    m_result->setVisible(step == Step::Result);
    m_again->setVisible(step == Step::Result);
    m_save->setVisible(step == Step::Result);
    m_store->setVisible(step == Step::Result);
    if (measuring) {
        m_progress->setValue(0);
        m_cube->setPosition(-1);
        m_what->setText(
            m_six ? tr("Lay the sensor on its faces, one after the other, and let it lie still on each.")
                  : tr("Let the sensor lie level and still, as it is mounted."));
        m_faces->setDone(0);
        if (isVisible())
            m_cancel->setFocus();
    }
    updateState();
}

void SensorPage::onProgress(const Progress &progress)
{
    if (m_step != Step::Measure || !progress.values.contains(u"face"_s))
        return;
    const int face = int(progress.values.value(u"face"_s));
    const bool moves = progress.values.value(u"moves"_s) != 0;
    const bool measuring = progress.step == u"calibrate"_s;
    m_missing = unsigned(progress.values.value(u"missing"_s, double(kAllFaces)));
    m_cube->setPosition(face);
    const auto value = [&progress](const QString &key) { return progress.values.value(key); };
    const double length = std::hypot(value(u"x"_s), value(u"y"_s), value(u"z"_s));
    QString rows;
    const auto row = [&rows](const QString &name, double number, int decimals, const QString &unit) {
        rows += u"<tr><td style='padding:2px 16px 2px 0'>%1</td>"
                "<td style='padding:2px 0' align='right'>%2 %3</td></tr>"_s.arg(
                    name, numberText(number, decimals), unit);
    };
    row(u"X"_s, value(u"x"_s), 3, u"g"_s);
    row(u"Y"_s, value(u"y"_s), 3, u"g"_s);
    row(u"Z"_s, value(u"z"_s), 3, u"g"_s);
    row(tr("Magnitude"), length, 3, u"g"_s);
    row(tr("Deviation"), value(u"deviation"_s), 4, u"g"_s);
    row(tr("Temperature"), value(u"temperature"_s), 1, u"°C"_s);
    m_live->setText(u"<table>%1</table>"_s.arg(rows));
    const bool known = m_six && face >= 0 && !(m_missing >> face & 1U);
    if (measuring)
        m_sees->setText(tr("%1 lies still: measuring. Do not touch it.").arg(faceName(face)));
    else if (moves)
        m_sees->setText(tr("It moves. Waiting until it lies still."));
    else if (value(u"impossible"_s) != 0)
        m_sees->setText(tr("It measures %1 g instead of 1 g, which no sensor at rest does: it is not taken. "
                           "Let it lie still, or check the sensor.")
                            .arg(numberText(length, 2)));
    else if (face < 0)
        m_sees->setText(tr("It is tilted. Waiting until one face lies up."));
    else if (known)
        m_sees->setText(
            tr("%1 is done. %n face(s) to go: turn the sensor.", nullptr, std::popcount(m_missing))
                .arg(faceName(face)));
    else
        m_sees->setText(tr("%1 lies up. Waiting until it has been still for a moment.").arg(faceName(face)));
    m_progress->setValue(measuring ? int(100 * value(u"measured"_s)) : 0);
    m_faces->setDone(kAllFaces & ~m_missing);
}

void SensorPage::onMeasured(const Result<ActionOutcome> &outcome)
{
    if (m_step != Step::Measure)
        return;
    if (!outcome) {
        if (isLinkLoss(outcome.error())) {
            breakOff();
            return;
        }
        if (outcome.error().code != ErrorCode::Cancelled)
            workspace().notifications().report(outcome.error());
        setStep(Step::Choose);
        return;
    }
    const QVariantMap &reply = outcome->reply;
    m_calibration = {};
    constexpr std::array<char16_t, 3> kAxisNames{u'x', u'y', u'z'};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_calibration.zero[axis] = reply.value(u"zero.%1"_s.arg(QChar(kAxisNames[axis]))).toInt();
        m_calibration.scale[axis] = reply.value(u"scale.%1"_s.arg(QChar(kAxisNames[axis]))).toInt();
    }
    m_calibration.method = m_six ? u"6 point"_s : u"1 point"_s;
    m_calibration.temperature = reply.value(u"temperature"_s).toDouble();
    m_quality = reply.value(u"quality"_s).toDouble();
    m_oneG = reply.value(u"one_g"_s).toDouble();
    m_plausible = reply.value(u"plausible"_s).toBool();
    showResult();
}

void SensorPage::showResult()
{
    const bool measured = m_oneG > 0;
    const bool six = m_calibration.method.startsWith(u'6');
    if (!measured)
        m_what->setText(tr("Calibration from the file"));
    else if (!m_plausible)
        m_what->setText(
            tr("⚠ No working sensor has such values. One of the readings was bad: calibrate again."));
    else if (six)
        m_what->setText(
            m_quality <= kGoodQuality ? tr("The calibration is good.")
                : m_quality <= kFairQuality
                ? tr("The calibration is usable.")
                : tr(
                    "The calibration is poor: the sensor did not lie square on its faces. Calibrate again."));
    else
        m_what->setText(tr("The zeros are found."));
    QString rows
        = u"<tr><td></td><td align='right' style='padding:2px 12px'>%1</td>"
          "<td align='right' style='padding:2px 12px'>%2</td></tr>"_s.arg(tr("Zero"), tr("Counts per g"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        rows += u"<tr><td style='padding:2px 16px 2px 0'>%1</td><td align='right' style='padding:2px "
                u"12px'>%2</td>"
                "<td align='right' style='padding:2px 12px'>%3</td></tr>"_s.arg(QChar(u"XYZ"[axis]))
                    .arg(m_calibration.zero[axis])
                    .arg(m_calibration.scale[axis]);
    }
    QString html = u"<table>%1</table>"_s.arg(rows);
    if (measured && six)
        html += u"<p>%1</p>"_s.arg(tr("Quality: %1 g off axis; good is below %2 g.")
                                       .arg(numberText(m_quality, 4))
                                       .arg(shortNumberText(kGoodQuality)));
    if (m_calibration.temperature != 0)
        html += u"<p>%1</p>"_s.arg(tr("Measured at %1 °C.").arg(numberText(m_calibration.temperature, 1)));
    html += u"<p>%1</p>"_s.arg(
        tr("Nothing is on the board yet. Storing replaces the calibration of the sensor chosen above."));
    m_result->setText(html);
    m_store->setText(m_plausible ? tr("Store on the board") : tr("Store although it is implausible"));
    m_store->setObjectName(m_plausible ? u"primary"_s : u"danger"_s);
    repolish(m_store);
    setStep(Step::Result);
    if (isVisible())
        (m_plausible ? m_save : m_again)->setFocus();
}

void SensorPage::store()
{
    QVariantMap arguments{{u"imu"_s, m_imu->currentData()}};
    constexpr std::array<char16_t, 3> kAxisNames{u'x', u'y', u'z'};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        arguments.insert(u"zero.%1"_s.arg(QChar(kAxisNames[axis])), m_calibration.zero[axis]);
        arguments.insert(u"scale.%1"_s.arg(QChar(kAxisNames[axis])), m_calibration.scale[axis]);
    }
    m_store->setEnabled(false);
    whenDone(workspace().perform(u"calibration.write"_s, arguments), this,
             [this](const Result<ActionOutcome> &outcome) {
                 updateState();
                 if (!outcome)
                     return;
                 workspace().notifications().notify(tr("The calibration is stored and read back."));
                 setStep(Step::Choose);
                 m_hands->putBack();
             });
}

Result<void> SensorPage::loadFile(const QString &path)
{
    const Family *family = workspace().family();
    if (!family || !family->calibrationFile)
        return failure(ErrorCode::NotConnected);
    const auto text = readWhole(path, FileKind::Calibration, kLargestFile);
    if (!text)
        return tl::unexpected(text.error());
    const auto calibration = family->calibrationFile->read(*text);
    if (!calibration)
        return tl::unexpected(inFile(calibration.error(), path));
    m_calibration = *calibration;
    m_quality = m_oneG = 0;
    m_plausible = true;
    showResult();
    return {};
}

Result<void> SensorPage::saveFile(const QString &path) const
{
    const Family *family = workspace().family();
    if (!family || !family->calibrationFile)
        return failure(ErrorCode::NotConnected);
    return writeWhole(path, family->calibrationFile->write(m_calibration), FileKind::Calibration);
}
