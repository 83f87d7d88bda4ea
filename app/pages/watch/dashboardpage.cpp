// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/dashboardpage.h"

#include "app/pages/watch/alarmcard.h"
#include "app/pages/watch/flightoverview.h"
#include "app/workspace/signsnote.h"
#include "protocol/device/bearings.h"
#include "protocol/device/device.h"
#include "protocol/device/firmwareadvice.h"
#include "protocol/device/flight.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/firmwaretext.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/batteryview.h"
#include "widgets/views/card.h"
#include "widgets/views/gimbalview.h"
#include "widgets/views/motordiagram.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kRefresh = 33ms;
constexpr int kTicksPerFacts = 10;
constexpr qint64 kRatesEveryMs = 1000;
constexpr int kFactsWidth = 460;
constexpr int kRoomForCourse = 800;  // height of a page that would leave a third empty without it
constexpr double kCourseSeconds = 30.0;

QString number(double value, int decimals, const QString &unit)
{
    if (std::isnan(value))
        return u"–"_s;
    const QString text = numberText(value, decimals);
    return unit.isEmpty() ? text : text + u' ' + unit;
}

QString tableRow(const QString &name, const QString &text)
{
    return u"<tr><td style='padding:2px 16px 2px 0'>%1</td>"
           "<td style='padding:2px 0' align='right'>%2</td></tr>"_s.arg(name, text);
}

/// A fault of the board: its name large, then what it means and what to do.
QWidget *faultCard(const BoardFault &fault)
{
    auto *card = new QFrame;
    card->setObjectName(u"fault"_s);
    card->setProperty("severe", fault.severe);
    auto *rows = new QVBoxLayout(card);
    rows->setContentsMargins(12, Metric::kGap, 12, Metric::kGap);
    rows->setSpacing(Metric::kUnit);
    const auto add = [rows](const QString &text, const char *name) {
        auto *label = new QLabel(text);
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
        rows->addWidget(label);
        return label;
    };
    QLabel *title = add((fault.severe ? u"✖ "_s : u"⚠ "_s) + tableText(fault.name.toUtf8().constData()),
                        fault.severe ? "error" : "warning");
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() + 3);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    for (const QString &sentence : {fault.meaning, fault.cure}) {
        if (!sentence.isEmpty())
            add(tableText(sentence.toUtf8().constData()), "");
    }
    return card;
}

}  // namespace

DashboardPage::DashboardPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"dashboard"_s, tr("Dashboard"), parent)
    , m_motion(new QStackedWidget)
    , m_gimbal(new GimbalView(workspace.theme()))
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_motorCard(new Card(tr("Motors")))
    , m_motorRows(new QFormLayout)
    , m_batteryCard(new Card(tr("Battery")))
    , m_battery(new BatteryView(workspace.theme()))
    , m_facts(new QLabel)
    , m_link(new QLabel)
    , m_faultList(new QVBoxLayout)
    , m_courseCard(new Card(tr("Angles, last %1 s").arg(shortNumberText(kCourseSeconds))))
    , m_course(new PlotView(workspace.theme()))
    , m_signs(new SignsNote(workspace))
{
    auto *columns = new QHBoxLayout;
    columns->setSpacing(12);
    columns->addWidget(makeMotion(), 5);
    columns->addWidget(makeFacts(), 3);
    body()->addLayout(columns, 1);

    const auto angles = [this] { return ChannelRoles::present({this->workspace().roles().angle}); };
    coverWhenStale(*m_gimbal, angles);
    coverWhenStale(*m_attitude, angles);
    for (AxisDial *dial : m_dials)
        coverWhenStale(*dial, angles, StaleCover::Look::Fade);
    coverWhenStale(*m_motorCard, [this] { return this->workspace().roles().motors; });
    coverWhenStale(*m_battery, {}, StaleCover::Look::Fade);
    coverWhenStale(*m_facts, {}, StaleCover::Look::Fade);
    coverWhenStale(*m_course, angles, StaleCover::Look::Tag);
    m_clock.setPlots({m_course});
    m_timer.setInterval(kRefresh);
    connect(&m_timer, &QTimer::timeout, this, &DashboardPage::refresh);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::fillParts);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::fillCourse);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::refreshFacts);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::refreshFaults);
    connect(&workspace.alarms(), &Alarms::changed, this, &DashboardPage::refreshFaults);
    fillParts();
    fillCourse();
    refreshFaults();
}

bool DashboardPage::flies() const
{
    const Family *family = workspace().expectedFamily();
    return family && family->nouns.flies;
}

QWidget *DashboardPage::makeMotion()
{
    m_motion->addWidget(makePictures());
    return m_motion;
}

void DashboardPage::chooseMotion()
{
    if (flies() && !m_flight) {
        m_flight = new FlightOverview(workspace());
        m_motion->addWidget(m_flight);
        connect(m_flight, &FlightOverview::calibrationWanted, this, [this] {
            const Device *device = workspace().client().device();
            if (device && device->flight())
                emit actionWanted(QLatin1String(device->flight()->calibration()));
        });
        coverWhenStale(*m_flight->attitude(),
                       [this] { return ChannelRoles::present({workspace().roles().angle}); });
        coverWhenStale(*m_flight->motors(), [this] { return workspace().roles().motors; });
    }
    m_motion->setCurrentIndex(flies() ? m_motion->indexOf(m_flight) : 0);
}

QWidget *DashboardPage::makePictures()
{
    auto *gimbal = new Card(tr("Camera and frame"));
    gimbal->content()->addWidget(m_gimbal, 1);
    auto *attitude = new Card(tr("Attitude"));
    attitude->content()->addWidget(m_attitude, 1);
    auto *pictures = new QHBoxLayout;
    pictures->setSpacing(12);
    pictures->addWidget(gimbal, 1);
    pictures->addWidget(attitude, 1);
    auto *axes = new Card(tr("Axes: angle and target"));
    auto *dials = new QHBoxLayout;
    for (const Axis axis : kAxes) {
        m_dials[std::size_t(axis)] = new AxisDial(workspace().theme(), axis);
        dials->addWidget(m_dials[std::size_t(axis)]);
    }
    axes->content()->addLayout(dials, 1);
    auto *motion = new QWidget;
    auto *rows = new QVBoxLayout(motion);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    rows->addLayout(pictures, 1);
    rows->addWidget(axes, 1);
    return motion;
}

// What is told of the board gets all the room that is left.
QWidget *DashboardPage::makeFacts()
{
    m_motorRows->setHorizontalSpacing(12);
    m_motorRows->setVerticalSpacing(Metric::kGap);
    m_motorCard->content()->addLayout(m_motorRows);
    m_motorCard->hide();
    m_batteryCard->content()->addWidget(m_battery);
    auto *state = new Card(tr("State of the board"));
    m_faultList->setSpacing(Metric::kGap);
    state->content()->addLayout(m_faultList);
    for (QLabel *table : {m_facts, m_link}) {
        table->setTextFormat(Qt::RichText);
        table->setWordWrap(true);
    }
    state->content()->addWidget(m_facts);
    state->content()->addStretch(1);
    auto *link = new Card(tr("Link"));
    link->content()->addWidget(m_link);
    m_course->setWindow(kCourseSeconds);
    m_course->setMarks(&workspace().marks());
    m_courseCard->content()->addWidget(m_course, 1);
    m_courseCard->content()->addWidget(m_signs);
    m_courseCard->hide();
    auto *facts = new QWidget;
    auto *rows = new QVBoxLayout(facts);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    rows->addWidget(state, 1);
    rows->addWidget(m_courseCard);
    rows->addWidget(m_motorCard);
    rows->addWidget(m_batteryCard);
    rows->addWidget(link);
    m_factRows = rows;
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setWidget(facts);
    scroll->setMaximumWidth(kFactsWidth);  // the rest is for the pictures
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return scroll;
}

// What is told of the board gives room to the plot, where there is enough for both.
void DashboardPage::giveRoom()
{
    const bool hasRoom = height() >= kRoomForCourse && workspace().client().telemetry();
    m_courseCard->setVisible(hasRoom);
    m_factRows->setStretchFactor(m_courseCard, hasRoom ? 2 : 0);
    if (hasRoom && isVisible())
        m_clock.start();
    else
        m_clock.stop();
}

void DashboardPage::fillCourse()
{
    const Device *device = workspace().client().device();
    const auto store = workspace().client().telemetry();
    if (device && store) {
        QList<Curve> curves;
        for (const int channel : ChannelRoles::present({workspace().roles().angle}))
            curves.append({channel, -1, {}});
        m_course->setAccessibleName(flies() ? tr("Angles of the drone") : tr("Angles of the camera"));
        m_course->setCurves(device->channels(), curves, store);
        m_clock.updateRate();
    }
    giveRoom();
}

void DashboardPage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    giveRoom();
}

// A dial for each axis, a bar for each numbered motor that the board has.
void DashboardPage::fillParts()
{
    chooseMotion();
    if (!workspace().client().isConnected())
        return;
    const ChannelRoles &roles = workspace().roles();
    const bool any = !ChannelRoles::present({roles.angle, roles.target}).isEmpty();
    for (std::size_t axis = 0; axis < m_dials.size(); ++axis)
        m_dials[axis]->setVisible(!any || roles.angle[axis] >= 0 || roles.target[axis] >= 0);
    while (m_motorRows->rowCount() > 0)
        m_motorRows->removeRow(0);
    m_motors.clear();
    for (const int channel : roles.motors) {
        const ChannelSpec &spec = workspace().client().device()->channels()[std::size_t(channel)];
        auto *bar = new QProgressBar;
        bar->setRange(int(spec.min), int(spec.max));
        bar->setAccessibleName(tableText(spec.label));
        m_motorRows->addRow(tableText(spec.label), bar);
        m_motors.push_back(bar);
    }
    m_motorCard->setVisible(!m_motors.empty() && !flies());
}

void DashboardPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_signs->refresh();
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle, roles.target, roles.frameAngle}) + roles.motors;
    });
    refreshBearings();
    m_timer.start();
    giveRoom();
}

void DashboardPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
    m_clock.stop();
}

void DashboardPage::refresh()
{
    const ChannelRoles &roles = workspace().roles();
    if (m_tick++ % kTicksPerFacts == 0) {
        refreshBearings();
        refreshFacts();
        refreshFaults();
    }
    if (m_flight && m_motion->currentWidget() == m_flight) {
        m_flight->refresh();
        return;
    }
    const auto value = [this](int channel) { return workspace().latest(channel); };
    GimbalView::Pose pose{{value(roles.angle[0]), value(roles.angle[1]), value(roles.angle[2])}, {}, {}};
    if (m_frameMeasured == true && !std::isnan(value(roles.frameAngle[0])))
        pose.frame = {value(roles.frameAngle[0]), value(roles.frameAngle[1]), value(roles.frameAngle[2])};
    pose.running = workspace().motorsRunning();
    m_gimbal->setPose(pose);
    m_attitude->setAttitude(value(roles.angle[0]), value(roles.angle[1]), value(roles.angle[2]));
    for (std::size_t axis = 0; axis < m_dials.size(); ++axis)
        m_dials[axis]->setValues(value(roles.angle[axis]), value(roles.target[axis]),
                                 value(roles.motorPower[axis]));
    for (std::size_t i = 0; i < m_motors.size(); ++i) {
        const double output = value(roles.motors.value(qsizetype(i), -1));
        const QString unit = std::isnan(output)
            ? QString()
            : QString::fromUtf8(
                workspace().client().device()->channels()[std::size_t(roles.motors[qsizetype(i)])].unit);
        m_motors[i]->setValue(std::isnan(output) ? m_motors[i]->minimum() : qRound(output));
        m_motors[i]->setFormat(number(output, 0, unit));
    }
}

void DashboardPage::refreshFacts()
{
    const ChannelRoles &roles = workspace().roles();
    m_batteryCard->setVisible(!workspace().client().isConnected() || roles.battery >= 0);
    const double cells = workspace().latest(roles.batteryCells);
    m_battery->setVolts(workspace().latest(roles.battery), std::isnan(cells) ? 0 : int(cells));
    QStringList rows;
    const auto row = [&](const QString &name, const QString &text, ColorRole role = ColorRole::Text) {
        const QString plain = text.toHtmlEscaped();
        rows.append(tableRow(name,
                             role == ColorRole::Text ? plain
                                                     : u"<span style='color:%1'>%2</span>"_s.arg(
                                                         workspace().theme().color(role).name(), plain)));
    };
    if (roles.current >= 0)
        row(tr("Current"), number(workspace().latest(roles.current), 2, u"A"_s));
    if (roles.temperature >= 0) {
        const double celsius = workspace().latest(roles.temperature);
        const QString temperature = temperatureText(celsius, workspace().settings().fahrenheit());
        const bool isHot = celsius > workspace().settings().supervisorRules().hotCelsius;
        row(tr("Sensor temperature"),
            temperature.isEmpty() ? u"–"_s : (isHot ? u"✖ "_s : QString()) + temperature,
            isHot ? ColorRole::Danger : ColorRole::Text);
    }
    const Device *device = workspace().client().device();
    if (const StatusWords *told = device ? device->statusWords() : nullptr;
        told && workspace().client().isConnected() && !flies()) {
        for (const BoardFact &fact :
             told->facts([this](int channel) { return workspace().latest(channel); })) {
            QStringList words;
            for (const char *word : fact.words)
                words.append(tableText(word));
            row(tableText(fact.name), words.join(u", "_s));
        }
    }
    for (const FlightFact &fact : flightFacts(workspace()))
        row(fact.name, fact.text, fact.role);
    if (!flies()) {
        row(tr("Control cycle"), number(workspace().latest(roles.cycleTime), 0, u"µs"_s));
        row(tr("Sensor bus errors"), number(workspace().latest(roles.busErrors), 0, {}));
    }
    m_facts->setText(u"<table width='100%'>%1</table>"_s.arg(rows.join(QString())));
    refreshLink();
}

// Both ways; nothing of it outlives the link.
void DashboardPage::refreshLink()
{
    const LinkStatistics &link = workspace().client().statistics();
    const bool linked = workspace().client().isConnected();
    if (!linked || link.bytesIn < m_bytesIn || link.bytesOut < m_bytesOut)
        m_bytesAt.invalidate();
    if (!m_bytesAt.isValid() || m_bytesAt.elapsed() > kRatesEveryMs) {
        const double passed = m_bytesAt.isValid() ? double(m_bytesAt.elapsed()) / 1000.0 : 0.0;
        const auto rate = [passed](quint64 now, quint64 before) {
            return passed > 0 ? number(double(now - before) / passed / 1000.0, 1, tr("kB/s")) : u"–"_s;
        };
        m_received = rate(link.bytesIn, m_bytesIn);
        m_sent = rate(link.bytesOut, m_bytesOut);
        m_bytesIn = link.bytesIn;
        m_bytesOut = link.bytesOut;
        if (linked)
            m_bytesAt.start();
    }
    QStringList rows;
    const auto row = [&rows, linked](const QString &name, const QString &text) {
        rows.append(tableRow(name, linked ? text.toHtmlEscaped() : u"–"_s));
    };
    for (const FlightFact &fact : flightLink(workspace()))
        row(fact.name, fact.text);
    row(tr("Received"), m_received);
    row(tr("Sent"), m_sent);
    row(tr("Unanswered"), QString::number(link.timeouts));
    row(tr("Frames received"), tr("%1 per second").arg(numberText(link.framesPerSecond, 0)));
    row(tr("Damaged frames"), QString::number(link.framing.headerErrors + link.framing.bodyErrors));
    const auto time = workspace().freshness().answerTime();
    row(tr("Answer time"), time ? tr("%1 ms").arg(numberText(seconds(*time) * 1000, 1)) : u"–"_s);
    m_link->setText(u"<table width='100%'>%1</table>"_s.arg(rows.join(QString())));
}

// Why nothing is said of the motors; empty where the board does not report them.
QString DashboardPage::silenceText() const
{
    const auto store = workspace().client().telemetry();
    if (!store || store->rows() == 0)
        return tr("No live data yet.");
    if (std::isnan(workspace().latest(workspace().roles().outputs)))
        return {};
    return workspace().client().address().isReplay() ? tr("The recording stands still.")
                                                     : tr("Live data have stopped.");
}

void DashboardPage::refreshFaults()
{
    std::vector<BoardFault> faults = workspace().faults();
    QStringList keys;
    for (const BoardFault &fault : faults)
        keys.append(fault.name);
    const auto running = workspace().motorsRunning();
    const double state = workspace().latest(workspace().roles().state);
    const Device *device = workspace().client().device();
    const StatusWords *told = device ? device->statusWords() : nullptr;
    const bool isFrozen = workspace().freshness().frozenSince().has_value();
    const QString doing
        = running && !isFrozen && told && !std::isnan(state) ? told->statusText(int(state)) : QString();
    keys.append(doing);
    keys.append(isFrozen ? u"frozen"_s : QString());
    keys.append(workspace().client().isConnected() ? (running ? (*running ? u"on"_s : u"off"_s) : u"?"_s)
                                                   : u"-"_s);
    const QString silence = silenceText();
    keys.append(silence);
    const Configuration &board = std::as_const(workspace().configuration()).board();
    const QString missing = missingText(board, board.missing());
    keys.append(missing);
    const FirmwareAdvice *advice = workspace().client().isConnected() ? device->firmwareAdvice() : nullptr;
    keys.append(advice ? device->identity().firmware : QString());
    const QList<AlarmReport> &alarms = workspace().alarms().all();
    for (const AlarmReport &alarm : alarms)
        keys.append(workspace().alarms().text(alarm).oneLine() + (alarm.isOver ? u'.' : u'!'));
    if (keys == m_shownFaults)
        return;
    m_shownFaults = keys;
    while (QLayoutItem *item = m_faultList->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const auto add = [this](const QString &text, const char *name) {
        auto *label = new QLabel(text);
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
        m_faultList->addWidget(label);
    };
    for (const AlarmReport &alarm : alarms)
        m_faultList->addWidget(new AlarmCard(workspace().alarms(), alarm));
    if (!workspace().client().isConnected()) {
        add(tr("Not connected."), "muted");
        return;
    }
    if (!running && isFrozen)
        add(tr("⚠ Whether the motors run is not known: the live data stand still."), "warning");
    else if (!running && !silence.isEmpty())
        add(silence, "muted");
    else if (running)
        add(*running ? tr("● Motors are running.") : tr("○ Motors are off."), *running ? "ok" : "muted");
    if (!doing.isEmpty())
        add(tr("State: %1").arg(tableText(doing.toUtf8().constData())), "muted");
    if (faults.empty() && running && !isFrozen && device && device->faultWords())
        add(tr("✓ The board reports no errors."), "ok");
    if (!missing.isEmpty()) {
        add(tr("⚠ Could not be read: %1.").arg(missing), "warning");
        add(tr("Nothing is known about the values there."), "muted");
    }
    for (const BoardFault &fault : faults)
        m_faultList->addWidget(faultCard(fault));
    if (!advice)
        return;
    for (const FirmwareRemark &remark : advice->firmwareRemarks())
        add((remark.isCaution ? u"⚠ "_s : QString()) + tableText(remark.text),
            remark.isCaution ? "warning" : "muted");
    const std::vector<FirmwareStep> steps = advice->firmwareSteps();
    if (const QString gain = gainText(steps); !gain.isEmpty()) {
        add(gain, "muted");
        m_faultList->itemAt(m_faultList->count() - 1)->widget()->setToolTip(stepsText(steps));
    }
}

// What settings and status say of the axes, the frame and the battery.
void DashboardPage::refreshBearings()
{
    m_battery->setLowCell(workspace().settings().supervisorRules().cellVolts);
    const ConfigurationModel &model = workspace().configuration();
    const Bearings *bearings = workspace().tables() ? workspace().tables()->bearings() : nullptr;
    if (!bearings || model.isEmpty()) {
        m_frameMeasured.reset();
        m_battery->setThresholds({}, {}, false);
        return;
    }
    const auto latest = [this](int channel) { return workspace().latest(channel); };
    for (const Axis axis : kAxes) {
        const AxisBearing bearing = bearings->bearing(axis, model.board(), latest);
        m_dials[std::size_t(axis)]->setLimits(bearing.limits);
        m_dials[std::size_t(axis)]->setFollows(bearing.follows);
        m_dials[std::size_t(axis)]->setDriven(workspace().client().isConnected() ? bearing.isDriven
                                                                                 : std::nullopt);
    }
    m_frameMeasured = bearings->isFrameMeasured(model.board(), latest);
    const BatteryThresholds battery = bearings->batteryThresholds(model.board());
    m_battery->setThresholds(battery.alarm, battery.motorsOff, battery.perCell);
}
