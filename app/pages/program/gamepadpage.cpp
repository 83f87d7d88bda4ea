// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/program/gamepadpage.h"

#include "widgets/forms/numberbox.h"
#include "widgets/views/card.h"
#include "widgets/views/stickbar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLiveLook = 30ms;
constexpr double kPercent = 100.0;
constexpr int kMaxPageWidth = 960;

QString stickName(GamepadStick stick)
{
    switch (stick) {
    case GamepadStick::Throttle: return GamepadPage::tr("Throttle");
    case GamepadStick::Roll: return GamepadPage::tr("Roll");
    case GamepadStick::Pitch: return GamepadPage::tr("Pitch");
    case GamepadStick::Yaw: return GamepadPage::tr("Yaw");
    case GamepadStick::Speed: return GamepadPage::tr("Speed");
    }
    return {};
}

QString buttonName(GamepadButton button)
{
    switch (button) {
    case GamepadButton::ArmHold: return GamepadPage::tr("Arm (held for a second)");
    case GamepadButton::Disarm: return GamepadPage::tr("Disarm");
    case GamepadButton::Centre: return GamepadPage::tr("To the middle");
    }
    return {};
}

// Which way counts as up.
QString moveText(GamepadStick stick)
{
    switch (stick) {
    case GamepadStick::Throttle:
        return GamepadPage::tr("Push the stick for the throttle from the bottom all the way up.");
    case GamepadStick::Roll: return GamepadPage::tr("Push the stick for roll all the way to the right.");
    case GamepadStick::Pitch: return GamepadPage::tr("Push the stick for pitch all the way forward.");
    case GamepadStick::Yaw: return GamepadPage::tr("Push the stick for yaw all the way to the right.");
    case GamepadStick::Speed:
        return GamepadPage::tr("Push the stick, lever or trigger for the speed all the way to fast.");
    }
    return {};
}

}  // namespace

GamepadPage::GamepadPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"gamepad"_s, tr("Gamepad"), parent)
    , m_gamepad(workspace.gamepad())
    , m_pads(new QComboBox)
    , m_all(new QPushButton(tr("Assign all sticks")))
    , m_standard(new QPushButton(tr("Use the default")))
    , m_skip(new QPushButton(tr("Skip")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_sentence(new QLabel)
    , m_task(new QLabel)
{
    makeHeader();
    makeBody();
    connectAll();
    fill();
}

void GamepadPage::makeHeader()
{
    m_pads->setAccessibleName(tr("Gamepad to use"));
    m_pads->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_all->setObjectName(u"primary"_s);
    m_standard->setToolTip(tr("Forgets what was assigned for this kind of gamepad"));
    header()->addWidget(m_pads);
    header()->addWidget(m_standard);
    header()->addWidget(m_all);
}

void GamepadPage::makeBody()
{
    m_sentence->setWordWrap(true);
    auto *task = new QHBoxLayout;
    m_task->setWordWrap(true);
    QFont large = m_task->font();
    large.setBold(true);
    m_task->setFont(large);
    task->addWidget(m_task, 1);
    task->addWidget(m_skip);
    task->addWidget(m_cancel);
    auto *column = new QWidget;
    column->setMaximumWidth(kMaxPageWidth);
    auto *cards = new QVBoxLayout(column);
    cards->setContentsMargins(0, 0, 0, 0);
    cards->setSpacing(12);
    auto *sticks = new Card(tr("Sticks"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(Metric::kGap);
    grid->setColumnStretch(1, 1);
    int at = 0;
    for (const QString &title :
         {QString(), tr("Now"), tr("Axis"), tr("Inverted"), tr("Dead band"), tr("Expo")}) {
        auto *heading = new QLabel(title);
        heading->setObjectName(u"muted"_s);
        grid->addWidget(heading, 0, at++);
    }
    for (std::size_t i = 0; i < kGamepadSticks; ++i)
        addStick(*grid, GamepadStick(i));
    sticks->content()->addLayout(grid);
    auto *hint
        = new QLabel(tr("Expo makes a stick gentler around its rest; its end stays where it is. Throttle is "
                        "for drones, speed for gimbals."));
    hint->setObjectName(u"muted"_s);
    hint->setWordWrap(true);
    sticks->content()->addWidget(hint);
    auto *buttons = new Card(tr("Buttons"));
    auto *places = new QGridLayout;
    places->setHorizontalSpacing(12);
    places->setVerticalSpacing(Metric::kGap);
    places->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < kGamepadButtons; ++i)
        addButton(*places, GamepadButton(i));
    buttons->content()->addLayout(places);
    cards->addWidget(sticks);
    cards->addWidget(buttons);
    body()->addWidget(m_sentence);
    body()->addLayout(task);
    auto *line = new QHBoxLayout;
    line->addWidget(column, 1);
    line->addStretch();
    body()->addLayout(line);
    body()->addStretch(1);
}

void GamepadPage::addStick(QGridLayout &grid, GamepadStick stick)
{
    StickRow &row = m_sticks[std::size_t(stick)];
    const QString name = stickName(stick);
    row.bar = new StickBar(workspace().theme(), startsAtStop(stick));
    row.bar->setAccessibleName(name);
    row.axis = new QLabel;
    row.axis->setMinimumWidth(64);
    row.inverted = new QCheckBox;
    row.inverted->setAccessibleName(tr("%1: inverted").arg(name));
    row.deadBand = new NumberBox(0, GamepadMapping::kMaxDeadBand * kPercent, 0, u" %"_s);
    row.deadBand->setAccessibleName(tr("%1: dead band").arg(name));
    row.expo = new NumberBox(0, kPercent, 0, u" %"_s);
    row.expo->setAccessibleName(tr("%1: expo").arg(name));
    row.assign = new QPushButton(tr("Assign"));
    row.assign->setAccessibleName(tr("Assign %1").arg(name));
    const int line = int(stick) + 1;
    grid.addWidget(new QLabel(name), line, 0);
    int column = 1;
    for (QWidget *widget : std::initializer_list<QWidget *>{row.bar, row.axis, row.inverted, row.deadBand,
                                                            row.expo, row.assign})
        grid.addWidget(widget, line, column++);
    connect(row.assign, &QPushButton::clicked, this, [this, stick] { assign(stick); });
    connect(row.inverted, &QCheckBox::toggled, this, &GamepadPage::applyFields);
    connect(row.deadBand, &NumberBox::valueChanged, this, &GamepadPage::applyFields);
    connect(row.expo, &NumberBox::valueChanged, this, &GamepadPage::applyFields);
}

void GamepadPage::addButton(QGridLayout &grid, GamepadButton button)
{
    ButtonRow &row = m_buttons[std::size_t(button)];
    row.state = new QLabel;
    row.assign = new QPushButton(tr("Assign"));
    row.assign->setAccessibleName(tr("Assign %1").arg(buttonName(button)));
    grid.addWidget(new QLabel(buttonName(button)), int(button), 0);
    grid.addWidget(row.state, int(button), 1);
    grid.addWidget(row.assign, int(button), 2);
    connect(row.assign, &QPushButton::clicked, this, [this, button] { assign(button); });
}

void GamepadPage::connectAll()
{
    connect(&m_gamepad, &Gamepad::changed, this, &GamepadPage::fill);
    connect(&m_gamepad, &Gamepad::lost, this, &GamepadPage::cancel);
    connect(m_pads, &QComboBox::activated, this, [this] {
        m_gamepad.prefer({m_pads->currentData().toByteArray(), m_pads->currentText()});
    });
    connect(m_standard, &QPushButton::clicked, this, [this] {
        cancel();
        m_gamepad.useStandard();
    });
    connect(m_all, &QPushButton::clicked, this, &GamepadPage::assignAll);
    connect(m_skip, &QPushButton::clicked, this, &GamepadPage::next);
    connect(m_cancel, &QPushButton::clicked, this, &GamepadPage::cancel);
    m_look.setInterval(kLiveLook);
    connect(&m_look, &QTimer::timeout, this, &GamepadPage::look);
}

void GamepadPage::assign(GamepadStick stick)
{
    m_inTurn = false;
    m_wanted = std::size_t(stick);
    begin(GamepadDetector::Wanted::Axis);
}

void GamepadPage::assign(GamepadButton button)
{
    m_inTurn = false;
    m_wanted = std::size_t(button);
    begin(GamepadDetector::Wanted::Button);
}

void GamepadPage::assignAll()
{
    m_inTurn = true;
    m_taken.clear();
    m_beforeTurn = m_gamepad.mapping();
    askFrom(0);
}

void GamepadPage::begin(GamepadDetector::Wanted wanted)
{
    if (!m_gamepad.reading())
        return;
    m_wantsButton = wanted == GamepadDetector::Wanted::Button;
    m_detector.emplace(wanted, m_inTurn ? m_taken : std::vector<int>());
    updateTask();
}

void GamepadPage::next()
{
    if (m_inTurn)
        askFrom(m_wanted + 1);
    else
        endTask();
}

// What is steered now has no speed, or no throttle.
void GamepadPage::askFrom(std::size_t stick)
{
    const auto without = std::size_t(m_gamepad.steers() == GamepadUse::Flight ? GamepadStick::Speed
                                                                              : GamepadStick::Throttle);
    m_wanted = stick + (stick == without ? 1 : 0);
    if (m_wanted < kGamepadSticks)
        begin(GamepadDetector::Wanted::Axis);
    else
        endTask();
}

// What was assigned in turn so far is half of something.
void GamepadPage::cancel()
{
    if (m_inTurn && m_detector && m_gamepad.mapping() != m_beforeTurn)
        m_gamepad.setMapping(m_beforeTurn);
    endTask();
}

void GamepadPage::endTask()
{
    if (m_skip->hasFocus() || m_cancel->hasFocus())
        m_all->setFocus(Qt::OtherFocusReason);
    m_detector.reset();
    m_inTurn = false;
    updateTask();
}

void GamepadPage::look()
{
    const auto reading = m_gamepad.reading();
    const GamepadSnapshot now = m_gamepad.snapshot();
    const bool isAlive = now.isAlive(Clock::now());
    const GamepadMapping mapping = m_gamepad.mapping();
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        const bool has = isAlive && now.assigned[i];
        const double place = has && reading ? reading->axes[std::size_t(mapping.sticks[i].axis)] : qQNaN();
        m_sticks[i].bar->setValue(has ? now.sticks[i] : qQNaN(), mapping.sticks[i].inverted ? -place : place);
    }
    for (std::size_t i = 0; i < kGamepadButtons; ++i) {
        const int button = mapping.buttons[i];
        m_buttons[i].state->setText(button < 0        ? tr("not assigned")
                                        : now.held[i] ? tr("button %1: pressed").arg(button + 1)
                                                      : tr("button %1").arg(button + 1));
    }
    if (!m_detector || !reading || !isAlive)
        return;
    const bool wasReady = m_detector->isReady();
    if (const auto found = m_detector->look(*reading, now.at))
        take(*found);
    else if (m_detector->isReady() != wasReady)
        updateTask();
}

void GamepadPage::take(const GamepadDetector::Found &found)
{
    m_detector.reset();  // what is set now is looked at again
    GamepadMapping mapping = m_gamepad.mapping();
    if (m_wantsButton)
        mapping.assign(GamepadButton(m_wanted), found.index);
    else {
        mapping.assign(GamepadStick(m_wanted), found.index, found.negative);
        m_taken.push_back(found.index);
    }
    m_gamepad.setMapping(mapping);
    next();
}

void GamepadPage::fill()
{
    fillPads();
    fillRows(m_gamepad.mapping());
    updateSentence();
    updateTask();
}

void GamepadPage::fillPads()
{
    const auto find = [this](const QByteArray &guid, const QString &name) {
        for (int i = 0; i < m_pads->count(); ++i) {
            if (m_pads->itemData(i).toByteArray() == guid && m_pads->itemText(i) == name)
                return i;
        }
        return -1;
    };
    m_pads->clear();
    for (const auto &[guid, name] : m_gamepad.pads()) {
        if (find(guid, name) < 0)
            m_pads->addItem(name, guid);
    }
    if (const auto used = m_gamepad.reading())
        m_pads->setCurrentIndex(find(used->guid, used->name));
    m_pads->setVisible(m_pads->count() > 1);
}

void GamepadPage::fillRows(const GamepadMapping &mapping)
{
    const bool has = m_gamepad.reading().has_value();
    m_filling = true;
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        const GamepadAxisUse &use = mapping.sticks[i];
        const StickRow &row = m_sticks[i];
        row.axis->setText(use.axis < 0 ? u"–"_s : tr("axis %1").arg(use.axis + 1));
        row.inverted->setChecked(use.inverted);
        if (!row.deadBand->hasFocus())
            row.deadBand->setValue(use.deadBand * kPercent);
        if (!row.expo->hasFocus())
            row.expo->setValue(use.expo * kPercent);
        for (QWidget *widget : {static_cast<QWidget *>(row.inverted), static_cast<QWidget *>(row.deadBand),
                                static_cast<QWidget *>(row.expo)})
            widget->setEnabled(has && use.axis >= 0);
        row.assign->setEnabled(has);
    }
    for (const ButtonRow &row : m_buttons)
        row.assign->setEnabled(has);
    m_all->setEnabled(has);
    m_standard->setVisible(m_gamepad.hasStandard());
    m_standard->setEnabled(!m_gamepad.isStandard());
    m_filling = false;
    look();
}

void GamepadPage::applyFields()
{
    if (m_filling)
        return;
    GamepadMapping mapping = m_gamepad.mapping();
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        mapping.sticks[i].inverted = m_sticks[i].inverted->isChecked();
        mapping.sticks[i].deadBand = m_sticks[i].deadBand->value() / kPercent;
        mapping.sticks[i].expo = m_sticks[i].expo->value() / kPercent;
    }
    m_gamepad.setMapping(mapping);
}

void GamepadPage::updateTask()
{
    m_skip->setVisible(m_detector && m_inTurn);
    m_cancel->setVisible(m_detector.has_value());
    if (!m_detector)
        m_task->setText(QString());
    else if (!m_detector->isReady())
        m_task->setText(tr("Let go of all sticks and buttons, and pull a throttle that stays down."));
    else if (m_wantsButton)
        m_task->setText(tr("Press the button for: %1.").arg(buttonName(GamepadButton(m_wanted))));
    else
        m_task->setText(moveText(GamepadStick(m_wanted)));
}

void GamepadPage::updateSentence()
{
    const GamepadSnapshot now = m_gamepad.snapshot();
    if (const auto error = m_gamepad.error())
        m_sentence->setText(
            tr("Gamepads cannot be read: %1. Everything else works without. Install the program's "
               "module for gamepads and SDL 2, then open this page again.")
                .arg(error->detail));
    else if (!now.connected)
        m_sentence->setText(tr("No gamepad is plugged in. Plug one in, it is found by itself."));
    else if (!now.isAlive(Clock::now()))
        m_sentence->setText(tr("%1 is not heard of any more. Plug it out and in again.").arg(now.name));
    else if (!now.isSetUp)
        m_sentence->setText(
            tr("%1 is plugged in. Its sticks steer nothing until they are assigned.").arg(now.name));
    else if (now.isStandard)
        m_sentence->setText(standardText().arg(now.name));
    else
        m_sentence->setText(tr("%1 is ready. It steers only where you arm with it.").arg(now.name));
}

QString GamepadPage::standardText() const
{
    return m_gamepad.steers() == GamepadUse::Flight
        ? tr("%1 is ready with the default for drones: left stick throttle and yaw, right stick roll and "
             "pitch. "
             "The throttle counts from the stick's middle up: let go, it is zero. Assign sticks to change "
             "that. "
             "It steers only where you arm with it.")
        : tr("%1 is ready with the default for gimbals: the right stick pans and tilts. Assign sticks to "
             "change "
             "that. It steers only where you arm with it.");
}

void GamepadPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_gamepad.use(*this);
    m_look.start();
    fill();
}

void GamepadPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    cancel();
    m_look.stop();
    m_gamepad.letGo(*this);
}

void GamepadPage::keyPressEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_Escape || !m_detector) {
        Page::keyPressEvent(event);
        return;
    }
    cancel();
}
