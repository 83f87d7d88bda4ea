// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"

#include "widgets/forms/argumentform.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/iterationchart.h"
#include "widgets/theme/tablelook.h"
#include "widgets/theme/theme.h"
#include "widgets/views/card.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

const QString kAction = u"autotune"_s;
constexpr int kBeforeColumn = 1;
constexpr int kNowColumn = 2;
constexpr int kAskWidth = 340;

const ActionSpec *findAction(const Device *device, const QString &key)
{
    if (!device)
        return nullptr;
    for (const ActionSpec &action : device->actions()) {
        if (key == QLatin1String(action.key))
            return &action;
    }
    return nullptr;
}

}  // namespace

AutoTunePage::AutoTunePage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"autotune"_s, tr("Auto-tune"), parent)
    , m_live(workspace.live())
    , m_ask(new Card(tr("What to search")))
    , m_text(new QLabel)
    , m_start(new QPushButton(tr("Start: the camera will shake")))
    , m_stop(new QPushButton(tr("Stop and revert to the old gains")))
    , m_accept(new QPushButton(tr("Accept and store")))
    , m_revert(new QPushButton(tr("Revert to the old gains")))
    , m_gains(new IterationChart(workspace.theme(), tr("Gains by iteration (P solid, D dashed)")))
    , m_errors(new IterationChart(workspace.theme(), tr("Tracking error by iteration")))
    , m_table(new QTableWidget)
{
    m_start->setObjectName(u"primary"_s);
    m_accept->setObjectName(u"primary"_s);
    m_text->setWordWrap(true);
    m_ask->setFixedWidth(kAskWidth);
    for (QPushButton *button : {m_start, m_stop, m_accept, m_revert})
        m_ask->content()->addWidget(button);
    m_ask->content()->addStretch(1);
    m_table->setAccessibleName(tr("Gains before and now"));
    m_table->setColumnCount(4);
    m_table->setHorizontalHeaderLabels({tr("Parameter"), tr("Before"), tr("In use now"), tr("Change")});
    m_table->horizontalHeaderItem(kBeforeColumn)
        ->setToolTip(tr("What was in use when the search began; without a search, what is stored"));
    m_table->horizontalHeaderItem(kNowColumn)
        ->setToolTip(tr("What the board uses at this moment; during a search, what it is trying"));
    for (int column = kBeforeColumn; column < m_table->columnCount(); ++column)
        m_table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setPlainRows(*m_table);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 8);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(m_gains, 2);
    right->addWidget(m_errors, 2);
    right->addWidget(m_table, 2);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_ask);
    row->addLayout(right, 1);
    body()->addWidget(m_text);
    body()->addLayout(row, 1);

    connect(m_start, &QPushButton::clicked, this, &AutoTunePage::start);
    connect(m_stop, &QPushButton::clicked, &workspace.client(), &DeviceClient::cancelJobs);
    connect(m_accept, &QPushButton::clicked, this, &AutoTunePage::accept);
    connect(m_revert, &QPushButton::clicked, this, &AutoTunePage::revert);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, &AutoTunePage::onProgress);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &AutoTunePage::onState);
    connect(&m_live, &LiveModel::valueChanged, this, &AutoTunePage::fillTable);
    connect(&m_live, &LiveModel::modelReset, this, &AutoTunePage::fillTable);
    onState();
}

void AutoTunePage::onState()
{
    const DeviceClient &client = workspace().client();
    const ActionSpec *action = client.isConnected() ? findAction(client.device(), kAction) : nullptr;
    if (action && !m_form) {
        // Whether to save is decided once the result is known, not before.
        m_form = new ArgumentForm(*action, {u"save"_s});
        m_ask->content()->insertWidget(1, m_form);
    }
    if (!client.isConnected() && m_state == State::Finished)
        m_before.clear();  // the board may have restarted: the values in use are read again
    if (m_state == State::Finished && m_before.isEmpty())
        m_state = State::Ready;
    setState(m_state);
    fillTable();
}

void AutoTunePage::setState(State state)
{
    const bool changed = state != m_state;
    m_state = state;
    const bool ready
        = workspace().client().isConnected() && workspace().client().identity().writable && m_form;
    m_start->setVisible(state != State::Running);
    m_start->setEnabled(ready);
    m_start->setToolTip(
        workspace().client().isConnected() && !m_form ? tr("This board has no command for it.") : QString());
    m_start->setText(state == State::Finished ? tr("Search again: the camera will shake")
                                              : tr("Start: the camera will shake"));
    m_start->setObjectName(state == State::Finished ? QString()
                                                    : u"primary"_s);  // then accepting is the next step
    repolish(m_start);
    m_stop->setVisible(state == State::Running);
    m_accept->setVisible(state == State::Finished);
    m_revert->setVisible(state == State::Finished);
    if (m_form)
        m_form->setEnabled(state != State::Running);
    switch (state) {
    case State::Ready:
        m_text->setText(
            tr("Hold the gimbal in your hand or on a stand, balanced, with all motors running. The board "
               "moves the "
               "camera a little to find gains; the lower “gain against stability”, the calmer the result. "
               "Nothing is stored before you accept."));
        break;
    case State::Running:
        m_text->setText(
            tr("The board is searching. Keep the gimbal as it is. F12 or the red button stops everything."));
        break;
    case State::Finished:
        m_text->setText(tr("The new gains are in use, but not stored. Try them: turn the gimbal by hand and "
                           "look at Tuning. Then "
                           "accept them or revert to the old ones."));
        break;
    }
    if (changed)
        emit changesChanged();
}

void AutoTunePage::start()
{
    auto arguments = m_form->arguments();
    if (!arguments) {
        workspace().notifications().report(arguments.error());
        return;
    }
    arguments->insert(u"save"_s, false);
    if (m_state != State::Finished) {
        m_before.clear();
        for (const int parameter : m_live.parameters()) {
            if (const auto value = m_live.value(parameter))
                m_before.insert(parameter, *value);
        }
    }
    m_gains->clear();
    m_errors->clear();
    m_last.clear();
    setState(State::Running);
    workspace().perform(kAction, *arguments, true).then(this, [this](const Result<ActionOutcome> &outcome) {
        onFinished(outcome);
    });
}

void AutoTunePage::onProgress(const Progress &progress)
{
    if (m_state != State::Running || progress.step != u"autotune"_s || progress.values.isEmpty())
        return;
    m_last = progress.values;
    for (const Axis axis : kAxes) {
        const QString key = QLatin1String(axisKey(axis));
        const auto add
            = [&](IterationChart *chart, const QString &figure, const QString &name, Qt::PenStyle style) {
                  const QString id = figure + u'.' + key;
                  if (progress.values.contains(id))
                      chart->addPoint(u"%1, %2"_s.arg(name, axisLabel(axis)), axis, progress.done,
                                      progress.values.value(id), style);
              };
        add(m_gains, u"p"_s, u"P"_s, Qt::SolidLine);
        add(m_gains, u"d"_s, u"D"_s, Qt::DashLine);
        add(m_errors, u"error"_s, tr("Error"), Qt::SolidLine);
    }
    m_live.read();
    m_text->setText(tr("Iteration %1. Keep the gimbal as it is. F12 or the red button stops everything.")
                        .arg(progress.done));
}

void AutoTunePage::onFinished(const Result<ActionOutcome> &outcome)
{
    m_live.read();
    if (outcome) {
        setState(State::Finished);
        return;
    }
    if (outcome.error().code == ErrorCode::LinkClosed || !workspace().client().isConnected()) {
        setState(State::Ready);
        ErrorText text = describe(outcome.error());
        text.meaning = tr(
            "Nothing was stored. The board may still use what it has found so far, until its next start.");
        text.cure
            = tr("When it is connected again, look at Tuning: “Revert all” puts the stored gains back.");
        workspace().notifications().report(text);
        return;
    }
    // Stopped, or the board gave up: the previous values are put back into use.
    if (outcome.error().code != ErrorCode::Cancelled)
        workspace().notifications().report(outcome.error());
    revert();
}

void AutoTunePage::accept()
{
    workspace().saveLive().then(this, [this](bool saved) {
        if (!saved)
            return;
        m_before.clear();
        setState(State::Ready);
    });
}

void AutoTunePage::revert()
{
    m_live.setValues(m_before);
    m_before.clear();
    setState(State::Ready);
    workspace().notifications().notify(tr("The previous gains are in use again."));
}

void AutoTunePage::fillTable()
{
    const ConfigurationModel &model = workspace().configuration();
    m_table->setRowCount(0);
    if (model.isEmpty())
        return;
    for (const int parameter : m_live.parameters()) {
        const ParameterSpec &spec = model.board().parameters().at(parameter);
        if (!spec.key.startsWith(u"pid."_s))
            continue;
        const auto now = m_live.value(parameter);
        const auto before = m_before.contains(parameter) ? std::optional(m_before.value(parameter))
                                                         : m_live.stored(parameter);
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        const auto text
            = [&](std::optional<double> raw) { return raw ? parameterValueText(spec, *raw) : u"–"_s; };
        const double change = now && before ? spec.toDisplay(*now) - spec.toDisplay(*before) : 0.0;
        const QStringList cells{parameterLabel(spec), text(before), text(now),
                                change == 0.0 ? QString()
                                              : (change > 0 ? u"▲ "_s : u"▼ "_s)
                                        + shortNumberText(std::abs(change), 3)};
        for (int column = 0; column < cells.size(); ++column) {
            auto *item = new QTableWidgetItem(cells[column]);
            if (column > 0)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
}
