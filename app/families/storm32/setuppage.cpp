// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/storm32/setuppage.h"

#include "app/workspace/wizardparts.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/keyboard.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr double kMaxYaw = 45.0;
constexpr int kTasksWidth = 300;
constexpr int kMinPoles = 12;
constexpr int kMaxPoles = 28;
constexpr int kDefaultPoles = 14;

// The board has something to do as soon as the step begins.
bool runsAtOnce(SetupPage::Step step)
{
    using Step = SetupPage::Step;
    switch (step) {
    case Step::MotorsOff:
    case Step::Orientation:
    case Step::AutoDirections:
    case Step::Start:
    case Step::Take:
    case Step::AlignYaw:
    case Step::Finish: return true;
    default: return false;
    }
}

}  // namespace

SetupPage::SetupPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"setup"_s, tr("Gimbal setup"), parent)
    , m_tasks(new Card(tr("Tasks")))
    , m_hands(new SimulatedHands(
          workspace, {SimulatedHands::inGimbal(), {tr("held level"), 1}, {tr("tilted 45° down"), 7}}, this))
    , m_what(new QLabel)
    , m_sees(new QLabel)
    , m_held(new QProgressBar)
    , m_yawText(new QLabel)
    , m_report(new QListWidget)
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_continue(new QPushButton)
{
    auto *left = new QVBoxLayout;
    left->setSpacing(12);
    left->addWidget(makeTasks());
    left->addWidget(m_hands);
    left->addStretch(1);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addLayout(left);
    row->addWidget(makeGuide(), 1);
    body()->addLayout(row, 1);

    connect(m_cancel, &QPushButton::clicked, this, &SetupPage::cancel);
    connect(m_continue, &QPushButton::clicked, this, &SetupPage::onContinue);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, &SetupPage::onProgress);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state != DeviceClient::State::Connected && isUnderWay())
            breakOff();
        updateState();
    });
    enter(Step::Choose);
}

QWidget *SetupPage::makeTasks()
{
    const std::array<QString, kTasks> names{
        tr("Orientation of the sensors"),        tr("Poles of the motors"),
        tr("Motor directions: find them"),       tr("Motor directions: keep what was found"),
        tr("Start positions of pitch and roll"), tr("Align yaw")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_boxes[i] = new QCheckBox(names[i]);
        m_boxes[i]->setChecked(true);
        connect(m_boxes[i], &QCheckBox::toggled, this, &SetupPage::updateState);
        m_tasks->content()->addWidget(m_boxes[i]);
    }
    m_tasks->setFixedWidth(kTasksWidth);
    return m_tasks;
}

QWidget *SetupPage::makeGuide()
{
    auto *card = new Card({});
    setHeadline(*m_what);
    m_sees->setWordWrap(true);
    setQuiet(*m_held, tr("How long the position has been held"));

    m_polesForm = new QWidget;
    auto *poles = new QGridLayout(m_polesForm);
    poles->setContentsMargins(0, 0, 0, 0);
    poles->setHorizontalSpacing(12);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_poles[axis] = new NumberBox(kMinPoles, kMaxPoles, 0);
        m_poles[axis]->setSingleStep(2);
        m_poles[axis]->setValue(kDefaultPoles);
        m_poles[axis]->setAccessibleName(tr("Poles, %1").arg(axisLabel(kAxes[axis])));
        auto *label = new QLabel(axisLabel(kAxes[axis]));
        label->setBuddy(m_poles[axis]);
        poles->addWidget(label, int(axis), 0);
        poles->addWidget(m_poles[axis], int(axis), 1);
    }
    poles->setColumnStretch(2, 1);

    m_yawForm = new QWidget;
    auto *yaw = new QHBoxLayout(m_yawForm);
    yaw->setContentsMargins(0, 0, 0, 0);
    yaw->setSpacing(Metric::kGap);
    const auto button = [&](double by) {
        auto *make
            = new QPushButton(u"%1%2°"_s.arg(by > 0 ? u"+"_s : u"−"_s).arg(shortNumberText(std::abs(by))));
        make->setAccessibleName(by > 0 ? tr("Turn by %1° to the left").arg(shortNumberText(by))
                                       : tr("Turn by %1° to the right").arg(shortNumberText(-by)));
        connect(make, &QPushButton::clicked, this, [this, by] { moveYaw(by); });
        yaw->addWidget(make);
    };
    for (const double by : {-5.0, -1.0, -0.1})
        button(by);
    m_yawText->setAlignment(Qt::AlignCenter);
    m_yawText->setMinimumWidth(72);
    yaw->addWidget(m_yawText);
    for (const double by : {0.1, 1.0, 5.0})
        button(by);
    yaw->addStretch(1);

    m_report->setAccessibleName(tr("What was done"));
    m_report->setSelectionMode(QAbstractItemView::NoSelection);
    m_report->setWordWrap(true);
    m_continue->setObjectName(u"primary"_s);
    setHarmless(*m_cancel);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_cancel);
    buttons->addStretch(1);
    buttons->addWidget(m_continue);
    QVBoxLayout *content = card->content();
    content->setSpacing(12);
    content->addWidget(m_what);
    content->addWidget(m_sees);
    content->addWidget(m_held);
    content->addWidget(m_polesForm);
    content->addWidget(m_yawForm);
    content->addWidget(m_report, 4);
    content->addStretch(1);
    content->addLayout(buttons);
    return card;
}

void SetupPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    updateState();
}

bool SetupPage::wants(Task task) const
{
    return m_boxes[std::size_t(task)]->isChecked();
}

QString SetupPage::what() const
{
    return m_what->text();
}

QString SetupPage::sees() const
{
    return m_sees->text();
}

QStringList SetupPage::report() const
{
    QStringList lines;
    for (int row = 0; row < m_report->count(); ++row)
        lines.append(m_report->item(row)->text());
    return lines;
}

void SetupPage::note(const QString &text)
{
    m_report->addItem(text);
    m_report->show();
    m_report->scrollToBottom();
}

void SetupPage::updateState()
{
    const DeviceClient &client = workspace().client();
    const bool ready = client.isConnected() && client.identity().writable;
    const bool choosing = m_step == Step::Choose || m_step == Step::Done;
    const bool any
        = std::any_of(m_boxes.begin(), m_boxes.end(), [](const QCheckBox *box) { return box->isChecked(); });
    m_tasks->setEnabled(choosing);
    m_continue->setEnabled(ready && any && !m_running);
    m_cancel->setVisible(!choosing);
}

void SetupPage::begin()
{
    m_report->clear();
    m_yaw = 0;
    m_yawBegun = false;
    ++m_run;
    enter(Step::MotorsOff);
}

// The next step that the chosen tasks need.
void SetupPage::next()
{
    const bool later = wants(Task::TakeDirections) || wants(Task::StartPositions) || wants(Task::AlignYaw);
    static constexpr std::array kOrder{Step::MotorsOff, Step::Orientation, Step::Poles, Step::AutoDirections,
                                       Step::AskStart,  Step::Start,       Step::Take,  Step::AlignYaw,
                                       Step::AskFinish, Step::Finish,      Step::Done};
    auto it = std::find(kOrder.begin(), kOrder.end(), m_step);
    while (++it != kOrder.end()) {
        const bool needed = *it == Step::Orientation      ? wants(Task::Orientation)
            : *it == Step::Poles                          ? wants(Task::Poles)
            : *it == Step::AutoDirections                 ? wants(Task::AutoDirections)
            : *it == Step::AskStart || *it == Step::Start ? later
            : *it == Step::Take     ? wants(Task::TakeDirections) || wants(Task::StartPositions)
            : *it == Step::AlignYaw ? wants(Task::AlignYaw)
                                    : true;
        if (needed)
            break;
    }
    enter(it == kOrder.end() ? Step::Done : *it);
}

void SetupPage::enter(Step step)
{
    m_step = step;
    workspace().setGuided(step != Step::Choose && step != Step::Done, u"setup."_s);
    m_failed = m_running = false;
    m_held->setVisible(step == Step::Orientation);
    m_held->setValue(0);
    m_report->setVisible(m_report->count() > 0);
    m_polesForm->setVisible(step == Step::Poles);
    m_yawForm->setVisible(step == Step::AlignYaw);
    sayWhatToDo();
    if (step == Step::Poles)
        showPoles();
    if (step == Step::AlignYaw)
        showYaw();
    if (step == Step::AskStart || step == Step::AskFinish)
        m_hands->putBack();
    if (step == Step::Done)
        workspace().readBoard();
    if (runsAtOnce(step))
        runStep();
    repolish(m_continue);
    updateState();
    leadOn();
}

// To what this step asks for, but never to what starts or disables the motors: that wants a deliberate key.
void SetupPage::leadOn()
{
    if (!isVisible())
        return;
    const bool choosing = m_step == Step::Choose || m_step == Step::Done;
    const bool dangerous = m_step == Step::AskStart || m_step == Step::Start || m_step == Step::AskFinish
        || m_step == Step::Finish;
    setHarmless(*m_continue, !choosing && !dangerous);
    if (m_step == Step::Poles)
        m_poles.front()->setFocus();
    else if (mayTakeKeyboard(*m_continue))
        m_continue->setFocus();
    else if (!choosing)
        m_cancel->setFocus();
    else
        giveKeyboard(*this);
}

// What is to be done in this step, and what the button does.
void SetupPage::sayWhatToDo()
{
    struct Words
    {
        QString what;
        QString sees = {};
        QString go = {};  // empty: "Continue"
        bool dangerous = false;  // the motors start
    };
    const auto words = [this]() -> Words {
        switch (m_step) {
        case Step::Choose:
            return {tr("Set the gimbal up after building it, or after changing a motor or a sensor."),
                    tr("Tick the tasks. The motors are disabled first; you are told before they start. "
                       "Nothing is stored before the end, "
                       "so switching the board off takes everything back."),
                    tr("Begin")};
        case Step::MotorsOff: return {tr("Disabling the motors.")};
        case Step::Orientation: return {tr("Hold the camera level and still.")};
        case Step::Poles:
            return {tr("How many magnets does each motor bell have?"),
                    tr("Most gimbal motors have 14. A wrong number makes a motor run away.")};
        case Step::AutoDirections: return {tr("Setting the motor directions to automatic detection.")};
        case Step::AskStart:
            return {tr("Now the motors start. Put the camera into the gimbal, hold the handle still, and "
                       "connect the battery."),
                    tr("The board levels the camera and turns each motor a little to find its direction. "
                       "Stop motors ends it at any time."),
                    tr("Start the motors"), true};
        case Step::Start: return {tr("The board starts. Keep the handle still.")};
        case Step::Take: return {tr("Taking over what the board has found.")};
        case Step::AlignYaw:
            return {tr("Turn the camera until it looks straight ahead."), {}, tr("Take this position")};
        case Step::AskFinish:
            return {tr("Everything is set. Store it, and start the gimbal?"),
                    tr("A snapshot of the settings as they were is kept. The motors start."),
                    tr("Start and store"), true};
        case Step::Finish: return {tr("Starting and storing.")};
        case Step::Done: return {tr("The gimbal is set up."), {}, tr("Begin again")};
        }
        return {};
    }();
    m_what->setText(words.what);
    m_sees->setText(words.sees);
    m_continue->setText(words.go.isEmpty() ? tr("Continue") : words.go);
    m_continue->setObjectName(words.dangerous ? u"danger"_s : u"primary"_s);
}

// The numbers of poles that the board has now.
void SetupPage::showPoles()
{
    const ConfigurationModel &model = workspace().configuration();
    for (std::size_t axis = 0; axis < kAxisCount && !model.isEmpty(); ++axis) {
        const ParameterSpec *spec
            = model.board().parameters().find(u"motor.%1.poles"_s.arg(QLatin1String(axisKey(kAxes[axis]))));
        if (const auto raw = spec ? model.board().raw(*spec, 0) : std::nullopt)
            m_poles[axis]->setValue(int(*raw));
    }
}

void SetupPage::runStep()
{
    if (NumberBox::refusedIn(*this))
        return;
    QString key;
    QVariantMap arguments;
    switch (m_step) {
    case Step::MotorsOff: key = u"setup.motors_off"_s; break;
    case Step::Orientation: key = u"setup.orientation"_s; break;
    case Step::Poles:
        key = u"setup.poles"_s;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            arguments.insert(QString::fromLatin1(axisKey(kAxes[axis])), int(m_poles[axis]->value()));
        break;
    case Step::AutoDirections:
        key = u"setup.directions"_s;
        arguments.insert(u"direction"_s, 2);
        break;
    case Step::Start:
    case Step::Finish: key = u"setup.start"_s; break;
    case Step::Take:
        key = u"setup.take_motors"_s;
        arguments
            = {{u"directions"_s, wants(Task::TakeDirections)}, {u"positions"_s, wants(Task::StartPositions)}};
        break;
    case Step::AlignYaw:
        key = m_yawBegun ? u"setup.yaw_end"_s : u"setup.yaw_begin"_s;
        arguments.insert(u"take"_s, true);
        break;
    default: return;
    }
    m_running = true;
    m_failed = false;
    updateState();
    whenDone(workspace().perform(key, arguments, true), this,
             [this, run = m_run](const Result<ActionOutcome> &outcome) {
                 if (run == m_run && m_running)
                     finished(outcome);
             });
}

void SetupPage::finished(const Result<ActionOutcome> &outcome)
{
    m_running = false;
    if (!outcome && isLinkLoss(outcome.error()))
        return;  // told with the state of the link, which ends the setup
    if (!outcome) {
        m_failed = true;
        const ErrorText text = describe(outcome.error());
        note(u"✖ %1 %2"_s.arg(text.what, text.detail));
        m_sees->setText(u"%1 %2"_s.arg(text.what, text.cure));
        m_continue->setText(tr("Try again"));
        updateState();
        return;
    }
    const QVariantMap &reply = outcome->reply;
    switch (m_step) {
    case Step::MotorsOff: note(tr("✓ Motors are disabled.")); break;
    case Step::Orientation:
        note(reply.contains(u"imu2"_s)
                 ? tr("✓ Sensor: %1, frame sensor: %2")
                       .arg(reply.value(u"imu"_s).toString(), reply.value(u"imu2"_s).toString())
                 : tr("✓ Sensor: %1").arg(reply.value(u"imu"_s).toString()));
        break;
    case Step::Poles:
        note(tr("✓ Poles: roll %1, pitch %2, yaw %3")
                 .arg(shortNumberText(m_poles[0]->value()))
                 .arg(shortNumberText(m_poles[1]->value()))
                 .arg(shortNumberText(m_poles[2]->value())));
        break;
    case Step::AutoDirections: note(tr("✓ Directions will be found at the start.")); break;
    case Step::Start: note(tr("✓ The board works normally.")); break;
    case Step::Take:
        if (wants(Task::TakeDirections)) {
            note(tr("✓ Directions: roll %1, pitch %2, yaw %3")
                     .arg(tableText(reply.value(u"direction.roll"_s).toByteArray().constData()),
                          tableText(reply.value(u"direction.pitch"_s).toByteArray().constData()),
                          tableText(reply.value(u"direction.yaw"_s).toByteArray().constData())));
        }
        if (wants(Task::StartPositions))
            note(tr("✓ Start positions: roll %1, pitch %2")
                     .arg(reply.value(u"start.roll"_s).toInt())
                     .arg(reply.value(u"start.pitch"_s).toInt()));
        break;
    case Step::AlignYaw:
        if (!std::exchange(m_yawBegun, true)) {
            m_sees->setText(tr("The buttons turn it within %1° either way.").arg(shortNumberText(kMaxYaw)));
            updateState();
            leadOn();
            return;
        }
        m_yawBegun = false;
        note(tr("✓ Yaw starts at %1.").arg(reply.value(u"start.yaw"_s).toInt()));
        break;
    case Step::Finish:
        m_running = true;
        updateState();
        workspace().setGuided(false);
        whenDone(workspace().saveLive(*this, setHere()), this, [this, run = m_run](bool stored) {
            if (run != m_run)
                return;
            m_running = false;
            note(stored ? tr("✓ Everything is stored.")
                        : tr("✖ Not everything is stored. Use “Store on the board” below."));
            next();
        });
        return;
    default: break;
    }
    next();
}

// The parameters that the chosen tasks set, as the report of the steps says.
QSet<QString> SetupPage::setHere() const
{
    QSet<QString> keys;
    if (wants(Task::Orientation))
        keys = {u"imu.orientation"_s, u"imu2.orientation"_s};
    for (const Axis axis : kAxes) {
        const QString motor = u"motor.%1."_s.arg(QLatin1String(axisKey(axis)));
        keys.insert(motor + u"usage"_s);
        if (wants(Task::Poles))
            keys.insert(motor + u"poles"_s);
        if (wants(Task::AutoDirections) || wants(Task::TakeDirections))
            keys.insert(motor + u"direction"_s);
        if (wants(axis == Axis::Yaw ? Task::AlignYaw : Task::StartPositions))
            keys.insert(motor + u"start_position"_s);
    }
    return keys;
}

void SetupPage::onContinue()
{
    if (m_step == Step::Choose || m_step == Step::Done) {
        begin();
        return;
    }
    if (m_failed) {
        enter(m_step);
        return;
    }
    if (m_step == Step::AskStart || m_step == Step::AskFinish)
        next();
    else
        runStep();
}

void SetupPage::cancel()
{
    ++m_run;
    workspace().client().cancelJobs();
    if (std::exchange(m_yawBegun, false))
        workspace().perform(u"setup.yaw_end"_s, {{u"take"_s, false}}, true);
    note(tr("Cancelled. The values set so far are in use, but not stored."));
    enter(Step::Choose);
}

// What was set stands in the report; on another page, too, one hears of it.
void SetupPage::breakOff()
{
    ++m_run;  // what the board still answers belongs to no step any more
    m_yawBegun = false;
    note(tr("✖ The link broke; the setup ended here."));
    const bool isLost = workspace().client().loss() != DeviceClient::Loss::Link;
    const QString left = m_step == Step::Finish
        ? tr("It was starting or storing: what is stored is seen when the board is read again.")
        : isLost ? tr("What was set by then is lost: the board restarted.")
                 : tr("What was set by then is in use and not stored: a restart of the board takes it back.");
    workspace().notifications().notify(tr("The gimbal setup ended with the link.") + u' ' + left,
                                       Notice::Attention);
    enter(Step::Choose);
}

void SetupPage::showYaw()
{
    m_yawText->setText(u"%1°"_s.arg(numberText(std::abs(m_yaw) < 0.05 ? 0.0 : m_yaw, 1)));
}

void SetupPage::moveYaw(double by)
{
    m_yaw = std::clamp(m_yaw + by, -kMaxYaw, kMaxYaw);
    showYaw();
    workspace().perform(u"setup.yaw_move"_s, {{u"angle"_s, m_yaw}});
}

void SetupPage::onProgress(const Progress &progress)
{
    if (!m_running)
        return;
    if (m_step == Step::Orientation
        && (progress.step == u"level-camera"_s || progress.step == u"tilt-camera"_s)) {
        const bool tilt = progress.step == u"tilt-camera"_s;
        m_what->setText(tilt ? tr("Tilt camera and frame about 45° down, without rolling them.")
                             : tr("Hold camera and frame level and still."));
        m_sees->setText(tr("The sensor shows x %1 g, y %2 g, z %3 g. %4")
                            .arg(numberText(progress.values.value(u"x"_s), 2))
                            .arg(numberText(progress.values.value(u"y"_s), 2))
                            .arg(numberText(progress.values.value(u"z"_s), 2))
                            .arg(progress.values.value(u"held"_s) > 0 ? tr("Good: hold it so.")
                                     : tilt ? tr("Waiting until one axis shows the tilt and the other none.")
                                            : tr("Waiting until one axis points straight up.")));
        m_held->setValue(int(100 * progress.values.value(u"held"_s)));
    } else if (progress.step == u"wait-battery"_s) {
        m_sees->setText(tr("Waiting for the battery: connect it, and see that it is charged."));
    } else if (progress.step == u"wait-start"_s && progress.values.contains(u"state"_s)) {
        const QString state = workspace().client().device()->statusWords()->statusText(
            int(progress.values.value(u"state"_s)));
        m_sees->setText(
            tr("State: %1. Waiting for normal operation.").arg(tableText(state.toUtf8().constData())));
    }
}
