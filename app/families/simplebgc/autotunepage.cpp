// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"

#include "protocol/base/linkloss.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/iterationchart.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/theme/tablelook.h"
#include "widgets/theme/theme.h"
#include "widgets/views/card.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

const QString kAction = u"autotune"_s;
const QString kStop = u"autotune.stop"_s;
constexpr int kBeforeColumn = 1;
constexpr int kNowColumn = 2;
constexpr int kAskWidth = 340;
constexpr double kJudged = 3.0;  // seconds whose error counts
constexpr auto kFollowEvery = 1500ms;
constexpr auto kJudgeAfter = 4s;  // the search has shaken the camera
constexpr double kWorseTimes = 2.0;
constexpr double kWorseDegrees = 0.3;

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
    setHarmless(*m_stop);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
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

    // Nobody reports what a search uses that was told to stop and goes on.
    m_following.setInterval(kFollowEvery);
    connect(&m_following, &QTimer::timeout, this, [this] {
        if (!m_goesOn)
            m_following.stop();
        else if (!this->workspace().client().isBusy())
            m_live.read();
    });
    m_judging.setSingleShot(true);
    connect(&m_judging, &QTimer::timeout, this, &AutoTunePage::judge);
    connect(m_start, &QPushButton::clicked, this, &AutoTunePage::start);
    connect(m_stop, &QPushButton::clicked, this, &AutoTunePage::stop);
    connect(m_accept, &QPushButton::clicked, this, &AutoTunePage::accept);
    connect(m_revert, &QPushButton::clicked, this, &AutoTunePage::revertAndTell);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, &AutoTunePage::onProgress);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &AutoTunePage::onState);
    connect(&m_live, &LiveModel::valueChanged, this, &AutoTunePage::fillTable);
    connect(&m_live, &LiveModel::modelReset, this, [this] {
        m_whenReverted = {};  // nothing tells of it any more
        onValues();
        fillTable();
    });
    connect(&m_live, &LiveModel::changeCountChanged, this, &AutoTunePage::onValues);
    connect(&m_live, &LiveModel::heldChanged, this, &AutoTunePage::updateStart);
    connect(&m_live, &LiveModel::settled, this, [this] {
        if (const auto tell = std::exchange(m_whenReverted, {}))
            tell();
    });
    connect(&m_live, &LiveModel::failed, this, [this](const Error &error) {
        if (std::exchange(m_whenReverted, {}) && !isEndOfLink(error))
            this->workspace().notifications().report(error);
    });
    onState();
}

void AutoTunePage::onState()
{
    const DeviceClient &client = workspace().client();
    const ActionSpec *action = client.isConnected() ? findAction(client.device(), kAction) : nullptr;
    if (action && !m_form) {
        // Whether to save is decided once the result is known, not before; and everything here is told of the
        // profile in use.
        m_form = new ArgumentForm(*action, {u"save"_s, u"profile"_s});
        m_ask->content()->insertWidget(1, m_form);
    }
    if (!client.isConnected() && m_state == State::Finished) {
        m_left = m_before.isEmpty() ? Left::Nothing : Left::Found;
        setState(State::Ready);
        workspace().notifications().notify(
            tr("The link ended before the new gains were accepted or reverted."), Notice::Attention);
    }
    if (!client.isConnected() && std::exchange(m_goesOn, false)) {
        m_left = Left::Searching;
        m_state = State::Ready;
    }
    setState(m_state);
    fillTable();
    if (client.isConnected() && client.identity().serial == m_board && m_left != Left::Nothing)
        clearUp(std::exchange(m_left, Left::Nothing));
}

// The link broke during a search, and the board may be searching on, or have ended with other gains; or it
// broke before it was decided which ones to keep, and the board may have restarted.
void AutoTunePage::clearUp(Left left)
{
    whenDone(workspace().client().submit<Configuration>(
                 [left](Channel &channel, Device &device) -> Result<Configuration> {
                     if (left == Left::Searching) {
                         if (const auto stopped = device.perform(channel, kStop, {}); !stopped)
                             return tl::unexpected(stopped.error());
                     }
                     return device.readConfiguration(channel);
                 }),
             this, [this, left](const Result<Configuration> &board) {
                 if (!board && (isLinkLoss(board.error()) || !workspace().client().isConnected())) {
                     m_left = left;  // the next connection
                     return;
                 }
                 workspace().notifications().settle(Concern::Interrupted);
                 if (!board && left == Left::Found) {
                     workspace().notifications().report(board.error());
                     return;
                 }
                 if (!board) {
                     ErrorText text = describe(board.error());
                     text.what = tr(
                         "The search that was broken off could not be ended: the board may be moving the "
                         "camera on.");
                     text.cure = tr("Stop the motors.");
                     workspace().notifications().report(text);
                     return;
                 }
                 if (m_state == State::Ready)
                     tellLeft(*board, left);
             });
}

void AutoTunePage::setState(State state)
{
    const bool changed = state != m_state;
    m_state = state;
    if (state != State::Finished)
        m_judging.stop();
    m_isUnstored = state == State::Finished && m_live.changeCount() > 0;
    m_isGone = false;
    // Neither takes the other's place: a second click, or one that comes too late, must not start a search.
    const bool hasKeyboard = m_start->hasFocus() || m_stop->hasFocus();
    m_stop->setEnabled(state == State::Running);
    updateStart();
    if (hasKeyboard && state == State::Running)
        m_stop->setFocus();
    else if (hasKeyboard && changed)
        giveKeyboard(*m_ask);
    m_start->setToolTip(
        workspace().client().isConnected() && !m_form ? tr("This board has no command for it.") : QString());
    m_start->setText(state == State::Finished ? tr("Search again: the camera will shake")
                                              : tr("Start: the camera will shake"));
    m_start->setObjectName(state == State::Finished ? QString()
                                                    : u"primary"_s);  // then accepting is the next step
    repolish(m_start);
    m_accept->setVisible(state == State::Finished);
    m_revert->setVisible(state == State::Finished);
    if (m_form)
        m_form->setEnabled(state != State::Running);
    switch (state) {
    case State::Ready: m_text->setText(readyText()); break;
    case State::Running:
        m_text->setText(tr("The board is searching. Keep the gimbal as it is. F12 or the button STOP MOTORS "
                           "stops everything."));
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

QString AutoTunePage::readyText()
{
    return tr(
        "Hold the gimbal in your hand or on a stand, balanced, with all motors running. The board moves "
        "the camera a little to find gains; the lower “gain against stability”, the calmer the result. "
        "Nothing is stored before you accept.");
}

// The longest of the texts has its room at any time, so that no button moves under the pointer.
void AutoTunePage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    const QRect room(0, 0, m_text->width(), QWIDGETSIZE_MAX);
    m_text->setMinimumHeight(
        m_text->fontMetrics().boundingRect(room, Qt::TextWordWrap, readyText()).height());
}

void AutoTunePage::updateStart()
{
    const DeviceClient &client = workspace().client();
    m_start->setEnabled(m_state != State::Running && client.isConnected() && client.identity().writable
                        && m_form && !m_live.isHeld());
}

void AutoTunePage::start()
{
    auto arguments = m_form->arguments();
    if (!arguments) {
        workspace().notifications().report(arguments.error());
        return;
    }
    arguments->insert(u"save"_s, false);
    arguments->insert(u"profile"_s, 0);
    m_left = Left::Nothing;
    m_board = workspace().client().identity().serial;
    if (m_state != State::Finished) {
        m_errorBefore = errors();
        m_profile = activeProfile();
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
    fillTable();
    whenDone(workspace().perform(kAction, *arguments, true), this,
             [this](const Result<ActionOutcome> &outcome) { onFinished(outcome); });
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
    fillTable();
    m_text->setText(
        tr("Iteration %1. Keep the gimbal as it is. F12 or the button STOP MOTORS stops everything.")
            .arg(progress.done));
}

void AutoTunePage::stop()
{
    m_stop->setEnabled(false);
    m_text->setText(tr("The board is told to end the search, and watched until it has…"));
    if (!m_goesOn) {
        workspace().client().cancelJobs();
        return;
    }
    whenDone(workspace().perform(kStop, {}, true), this, [this](const Result<ActionOutcome> &stopped) {
        if (stopped)
            onFinished(failure(ErrorCode::Cancelled));
        else  // whatever prevented it, nobody has seen the search end
            onFinished(isLinkLoss(stopped.error()) ? stopped
                                                   : failure(ErrorCode::GoesOn, stopped.error().detail));
    });
}

void AutoTunePage::onFinished(const Result<ActionOutcome> &outcome)
{
    m_live.read();
    const bool wentOn = std::exchange(m_goesOn, !outcome && outcome.error().code == ErrorCode::GoesOn);
    if (wentOn && !m_goesOn)
        workspace().notifications().settle(Concern::Interrupted);
    if (m_goesOn) {
        m_last.clear();
        m_following.start();
        fillTable();
        workspace().notifications().report(outcome.error(), Concern::Interrupted);
        m_stop->setEnabled(true);
        m_text->setText(
            tr("The board searches on although it was told to stop. Stop it once more, or stop the "
               "motors."));
        return;
    }
    if (outcome) {
        setState(State::Finished);
        m_judging.start(kJudgeAfter);
        return;
    }
    if (isLinkLoss(outcome.error()) || !workspace().client().isConnected()) {
        m_left = Left::Searching;
        setState(State::Ready);
        ErrorText text = describe(outcome.error());
        if (outcome.error().code == ErrorCode::Restarted)
            text.meaning = tr("The search has ended with it.");
        else
            text.meaning = tr("The board may be searching on, and store what it finds.");
        text.cure = tr("When it is connected again, the search is stopped and the gains are compared.");
        workspace().notifications().report(text, Concern::Interrupted);
        return;
    }
    // Stopped, or the board gave up: the previous values are put back into use.
    if (outcome.error().code != ErrorCode::Cancelled)
        workspace().notifications().report(outcome.error());
    revertAndTell();
}

std::any AutoTunePage::keep()
{
    return m_left == Left::Nothing ? std::any() : std::any(Kept{m_left, m_board, m_before});
}

void AutoTunePage::resume(const std::any &kept)
{
    const auto &[left, board, before] = std::any_cast<const Kept &>(kept);
    m_left = left;
    m_board = board;
    m_before = before;
    onState();
}

std::array<double, kAxisCount> AutoTunePage::errors() const
{
    std::array<double, kAxisCount> errors{};
    errors.fill(std::nan(""));
    const auto store = workspace().client().telemetry();
    const ChannelRoles &roles = workspace().roles();
    for (std::size_t axis = 0; store && axis < kAxisCount; ++axis) {
        const bool told = roles.target[axis] >= 0;
        SpanStatistics span
            = spanStatistics(*store, told ? roles.target[axis] : roles.angle[axis],
                             told ? roles.angle[axis] : -1, store->now() - kJudged, store->now(), true);
        errors[axis] = told ? span.rms : span.aroundMean().rms;
    }
    return errors;
}

// The board calls its search a success by itself; whether it holds the camera better is seen afterwards.
void AutoTunePage::judge()
{
    if (m_state != State::Finished || !workspace().client().isConnected())
        return;
    if (m_isGone) {
        giveUp(true);
        return;
    }
    if (!workspace().motorsRunning().value_or(true))
        return;
    const auto after = errors();
    QStringList figures;
    bool isWorse = false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (std::isnan(after[axis]) || std::isnan(m_errorBefore[axis]))
            continue;
        figures.append(u"%1 %2° → %3°"_s.arg(axisLabel(kAxes[axis]), numberText(m_errorBefore[axis], 2),
                                             numberText(after[axis], 2)));
        isWorse |= after[axis] > kWorseTimes * m_errorBefore[axis]
            && after[axis] > m_errorBefore[axis] + kWorseDegrees;
    }
    if (figures.isEmpty()) {  // live data pause: it is judged when they come
        m_judging.start(kJudgeAfter);
        return;
    }
    const QString measured = tr("Angle error, RMS: %1.").arg(figures.join(u", "_s));
    if (!isWorse) {
        m_text->setText(m_text->text() + u' ' + measured);
        return;
    }
    revert([this, measured] { tellReverted(measured); });
}

void AutoTunePage::accept()
{
    whenDone(workspace().saveLive(*this), this, [this](bool saved) {
        if (!saved)
            return;
        m_before.clear();
        setState(State::Ready);
    });
}

int AutoTunePage::activeProfile() const
{
    return std::as_const(workspace()).configuration().board().activeProfile();
}

void AutoTunePage::onValues()
{
    if (m_state != State::Finished || workspace().configuration().isEmpty())
        return;
    if (activeProfile() != m_profile) {
        leaveProfile();
        return;
    }
    const bool was = std::exchange(m_isUnstored, m_live.changeCount() > 0);
    m_isGone = !m_isUnstored && (was || m_isGone);
    // Read as stored, because nobody knows better, they are there to be reverted all the same.
    if (m_isGone && !m_judging.isActive() && (!m_mayBeStored || isAsBefore()))
        giveUp(false);
}

bool AutoTunePage::isAsBefore() const
{
    return std::all_of(m_before.keyBegin(), m_before.keyEnd(), [this](int parameter) {
        return sameValue(m_live.value(parameter), m_before.value(parameter));
    });
}

// Others have stored it, or reverted it: the supervisor does, where it oscillates.
void AutoTunePage::giveUp(bool tells)
{
    const bool isReverted = isAsBefore();
    m_before.clear();
    m_mayBeStored = false;
    setState(State::Ready);
    if (isReverted && tells)
        tellReverted({});
}

void AutoTunePage::tellReverted(const QString &measured)
{
    workspace().notifications().report(
        ErrorText{tr("The gains that the board found hold the camera worse; they were reverted."),
                  measured,
                  tr("Balance the camera, hold the gimbal still, and search again with a lower gain."),
                  {}});
}

// The gains from before are those of the other profile.
void AutoTunePage::leaveProfile()
{
    m_before.clear();
    setState(State::Ready);
    workspace().notifications().notify(
        tr("Profile %1 is in use now. What was found for profile %2 was not stored and is gone.")
            .arg(activeProfile() + 1)
            .arg(m_profile + 1),
        Notice::Attention);
}

void AutoTunePage::revertAndTell()
{
    const bool mayBeStored = std::exchange(m_mayBeStored, false);
    revert([this, mayBeStored] {
        workspace().notifications().settle(Concern::Interrupted);
        workspace().notifications().notify(tr("The previous gains are in use again."));
        if (mayBeStored)
            offerToStore();
    });
}

void AutoTunePage::revert(const std::function<void()> &tell)
{
    if (!workspace().configuration().isEmpty() && activeProfile() != m_profile) {
        leaveProfile();
        return;
    }
    const QHash<int, double> before = std::exchange(m_before, {});
    setState(State::Ready);  // first: what follows is no answer of others
    if (!before.isEmpty())
        m_whenReverted = tell;  // once the board has read it back
    m_live.setValues(before);
}

// While the board searches, only its reports tell what it uses: "p.roll" is pid.roll.p. They give I in units
// of one, the board counts hundredths.
std::optional<double> AutoTunePage::tried(const ParameterSpec &spec) const
{
    const QStringList parts = spec.key.split(u'.');
    const auto it = parts.size() == 3 ? m_last.constFind(parts[2] + u'.' + parts[1]) : m_last.constEnd();
    if (it == m_last.constEnd())
        return {};
    return std::round(parts[2] == u"i" ? *it * 100.0 : *it);
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
        const auto now = m_state == State::Running && !m_goesOn ? tried(spec) : m_live.value(parameter);
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
