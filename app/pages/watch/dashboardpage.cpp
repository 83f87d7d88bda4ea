// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/dashboardpage.h"

#include "app/pages/watch/alarmcard.h"
#include "protocol/session/linkstatistics.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/card.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kRefresh = 33ms;
constexpr int kTicksPerFacts = 10;

QString number(double value, int decimals, const QString &unit)
{
    if (std::isnan(value))
        return u"–"_s;
    const QString text = numberText(value, decimals);
    return unit.isEmpty() ? text : text + u' ' + unit;
}

}  // namespace

DashboardPage::DashboardPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"dashboard"_s, tr("Dashboard"), parent)
    , m_attitude(new AttitudeView(workspace.theme()))
    , m_motorCard(new Card(tr("Motors")))
    , m_motorRows(new QFormLayout)
    , m_battery(new QLabel)
    , m_facts(new QLabel)
    , m_faultList(new QVBoxLayout)
{
    auto *attitude = new Card(tr("Attitude"));
    attitude->content()->addWidget(m_attitude, 1);
    auto *axes = new Card(tr("Axes: angle and target"));
    auto *dials = new QHBoxLayout;
    for (const Axis axis : kAxes) {
        m_dials[std::size_t(axis)] = new AxisDial(workspace.theme(), axis);
        dials->addWidget(m_dials[std::size_t(axis)]);
    }
    axes->content()->addLayout(dials, 1);

    m_motorRows->setHorizontalSpacing(12);
    m_motorRows->setVerticalSpacing(Metric::kGap);
    m_motorCard->content()->addLayout(m_motorRows);
    m_motorCard->hide();
    auto *power = new Card(tr("Battery"));
    QFont large = m_battery->font();
    large.setPointSizeF(large.pointSizeF() + 8);
    large.setWeight(QFont::DemiBold);
    m_battery->setFont(large);
    power->content()->addWidget(m_battery);

    auto *state = new Card(tr("State of the board"));
    state->content()->addLayout(m_faultList);
    m_facts->setTextFormat(Qt::RichText);
    m_facts->setWordWrap(true);
    state->content()->addWidget(m_facts);
    state->content()->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setWidget(state);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    // Each column divides its height differently: the messages about the board get all the room that the
    // voltage leaves.
    const auto column = [](QWidget *upper, int share, QWidget *lower, int rest) {
        auto *layout = new QVBoxLayout;
        layout->setSpacing(12);
        layout->addWidget(upper, share);
        layout->addWidget(lower, rest);
        return layout;
    };
    auto *columns = new QHBoxLayout;
    columns->setSpacing(12);
    columns->addLayout(column(attitude, 3, axes, 2), 3);
    auto *told = column(scroll, 1, power, 0);
    told->insertWidget(1, m_motorCard);
    columns->addLayout(told, 2);
    body()->addLayout(columns, 1);

    const auto angles = [this] { return ChannelRoles::present({this->workspace().roles().angle}); };
    coverWhenStale(*m_attitude, angles);
    for (AxisDial *dial : m_dials)
        coverWhenStale(*dial, angles, StaleCover::Look::Fade);
    coverWhenStale(*m_motorCard, [this] { return this->workspace().roles().motors; });
    coverWhenStale(*m_battery, {}, StaleCover::Look::Fade);
    coverWhenStale(*m_facts, {}, StaleCover::Look::Fade);
    m_timer.setInterval(kRefresh);
    connect(&m_timer, &QTimer::timeout, this, &DashboardPage::refresh);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &DashboardPage::updateLimits);
    connect(&workspace.configuration(), &ConfigurationModel::activeProfileChanged, this,
            &DashboardPage::updateLimits);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::fillParts);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::refreshFacts);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DashboardPage::refreshFaults);
    connect(&workspace.alarms(), &Alarms::changed, this, &DashboardPage::refreshFaults);
    fillParts();
    refreshFaults();
}

// A dial for each axis, a bar for each numbered motor that the board has.
void DashboardPage::fillParts()
{
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
    m_motorCard->setVisible(!m_motors.empty());
}

void DashboardPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle, roles.target});
    });
    m_timer.start();
}

void DashboardPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
}

void DashboardPage::refresh()
{
    const ChannelRoles &roles = workspace().roles();
    const auto value = [this](int channel) { return workspace().latest(channel); };
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
    if (m_tick++ % kTicksPerFacts == 0) {
        refreshFacts();
        refreshFaults();
    }
}

void DashboardPage::refreshFacts()
{
    const ChannelRoles &roles = workspace().roles();
    m_battery->setText(number(workspace().latest(roles.battery), 2, u"V"_s));
    QStringList rows;
    const auto row = [&rows](const QString &name, const QString &text) {
        rows.append(u"<tr><td style='padding:2px 16px 2px 0'>%1</td>"
                    "<td style='padding:2px 0' align='right'>%2</td></tr>"_s.arg(name, text.toHtmlEscaped()));
    };
    if (roles.current >= 0)
        row(tr("Current"), number(workspace().latest(roles.current), 2, u"A"_s));
    if (roles.temperature >= 0) {
        const QString temperature
            = temperatureText(workspace().latest(roles.temperature), workspace().settings().fahrenheit());
        row(tr("Sensor temperature"), temperature.isEmpty() ? u"–"_s : temperature);
    }
    const Device *device = workspace().client().device();
    if (const StatusWords *told = device ? device->statusWords() : nullptr;
        told && workspace().client().isConnected()) {
        for (const BoardFact &fact :
             told->facts([this](int channel) { return workspace().latest(channel); })) {
            QStringList words;
            for (const char *word : fact.words)
                words.append(tableText(word));
            row(tableText(fact.name), words.join(u", "_s));
        }
    }
    row(tr("Control cycle"), number(workspace().latest(roles.cycleTime), 0, u"µs"_s));
    row(tr("Sensor bus errors"), number(workspace().latest(roles.busErrors), 0, {}));
    const LinkStatistics &link = workspace().client().statistics();
    row(tr("Frames received"), tr("%1 per second").arg(numberText(link.framesPerSecond, 0)));
    row(tr("Damaged frames"), QString::number(link.framing.headerErrors + link.framing.bodyErrors));
    row(tr("Answer time"),
        link.roundTrip ? tr("%1 ms").arg(numberText(seconds(*link.roundTrip) * 1000, 1)) : u"–"_s);
    m_facts->setText(u"<table width='100%'>%1</table>"_s.arg(rows.join(QString())));
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
    const QString doing = running && told && !std::isnan(state) ? told->statusText(int(state)) : QString();
    keys.append(doing);
    keys.append(workspace().client().isConnected() ? (running ? (*running ? u"on"_s : u"off"_s) : u"?"_s)
                                                   : u"-"_s);
    const Configuration &board = std::as_const(workspace().configuration()).board();
    const QString missing = missingText(board, board.missing());
    keys.append(missing);
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
    if (!running)
        add(tr("No live data yet."), "muted");
    else
        add(*running ? tr("● Motors are running.") : tr("○ Motors are off."), *running ? "ok" : "muted");
    if (!doing.isEmpty())
        add(tr("State: %1").arg(tableText(doing.toUtf8().constData())), "muted");
    if (faults.empty() && running && device && device->faultWords())
        add(tr("✓ The board reports no errors."), "ok");
    if (!missing.isEmpty()) {
        add(tr("⚠ Could not be read: %1.").arg(missing), "warning");
        add(tr("Nothing is known about the values there."), "muted");
    }
    for (const BoardFault &fault : faults) {
        add((fault.severe ? u"✖ "_s : u"⚠ "_s) + tableText(fault.name.toUtf8().constData()),
            fault.severe ? "error" : "warning");
        add(tableText(fault.meaning.toUtf8().constData()) + u' ' + tableText(fault.cure.toUtf8().constData()),
            "muted");
    }
}

void DashboardPage::updateLimits()
{
    const ConfigurationModel &model = workspace().configuration();
    if (model.isEmpty())
        return;
    for (const Axis axis : kAxes) {
        const ParameterSet &set = model.board().parameters();
        const ParameterSpec *low = set.find(u"rc.%1.min_angle"_s.arg(QLatin1String(axisKey(axis))));
        const ParameterSpec *high = set.find(u"rc.%1.max_angle"_s.arg(QLatin1String(axisKey(axis))));
        if (!low || !high)
            continue;
        const int profile = model.board().activeProfile();
        m_dials[std::size_t(axis)]->setLimits(low->toDisplay(model.board().raw(*low, profile).value_or(0)),
                                              high->toDisplay(model.board().raw(*high, profile).value_or(0)));
    }
}
