// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/replaybar.h"

#include "protocol/client/replaycontrol.h"
#include "protocol/transport/replay.h"
#include "widgets/models/numbertext.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<double, 6> kSpeeds{0.25, 0.5, 1, 2, 4, 10};
constexpr double kStepsPerSecond = 10;

QString clock(double seconds)
{
    const int whole = int(seconds);
    return u"%1:%2"_s.arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

ReplayBar::ReplayBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_pause(new QPushButton)
    , m_place(new QSlider(Qt::Horizontal))
    , m_text(new QLabel)
    , m_speed(new QComboBox)
{
    setObjectName(u"bar"_s);
    auto *title = new QLabel(tr("Recording"));
    m_pause->setCheckable(true);
    m_pause->setText(tr("Pause"));
    m_place->setAccessibleName(tr("Place in the recording"));
    m_place->setPageStep(int(10 * kStepsPerSecond));
    m_place->setSingleStep(int(kStepsPerSecond));
    m_place->setTracking(false);  // playback moves when the slider is released
    for (const double speed : kSpeeds)
        m_speed->addItem(tr("%1×").arg(shortNumberText(speed)), speed);
    m_speed->setCurrentIndex(2);
    m_speed->setAccessibleName(tr("Speed of the recording"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kUnit, Metric::kMargin, Metric::kUnit);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(title);
    layout->addWidget(m_pause);
    layout->addWidget(m_place, 1);
    layout->addWidget(m_text);
    layout->addWidget(m_speed);
    connect(m_pause, &QPushButton::toggled, this, [this](bool paused) {
        m_pause->setText(paused ? tr("Play") : tr("Pause"));
        m_workspace.client().replay().setPaused(paused);
    });
    connect(m_place, &QSlider::valueChanged, this, &ReplayBar::seek);
    connect(m_place, &QSlider::sliderMoved, this,
            [this](int value) { m_text->setText(clock(value / kStepsPerSecond)); });
    connect(m_speed, &QComboBox::activated, this,
            [this] { m_workspace.client().replay().setSpeed(m_speed->currentData().toDouble()); });
    DeviceClient &client = workspace.client();
    connect(&client, &DeviceClient::statisticsChanged, this, &ReplayBar::showState);
    const auto showWhilePlaying = [this] {
        const DeviceClient &now = m_workspace.client();
        setVisible(now.address().isReplay() && now.state() != DeviceClient::State::Disconnected);
    };
    // Queued: seeking backwards reopens the recording, and the bar must not disappear and reappear meanwhile.
    connect(&client, &DeviceClient::stateChanged, this, showWhilePlaying, Qt::QueuedConnection);
    showWhilePlaying();
}

QString ReplayBar::text() const
{
    return m_text->text();
}

void ReplayBar::seek()
{
    m_workspace.client().replay().seek(m_place->value() / kStepsPerSecond);
}

void ReplayBar::showState()
{
    const auto &state = m_workspace.client().replay().state();
    if (!state || m_place->isSliderDown())
        return;
    const QSignalBlocker slider(m_place);
    const QSignalBlocker button(m_pause);
    m_place->setRange(0, int(std::ceil(state->length * kStepsPerSecond)));
    m_place->setValue(int(std::lround(state->position * kStepsPerSecond)));
    m_pause->setChecked(state->paused);
    m_pause->setText(state->paused ? tr("Play") : tr("Pause"));
    QString text = tr("%1 of %2").arg(clock(state->position), clock(state->length));
    if (state->hasEnded())
        text += u" · "_s + tr("the end");
    m_text->setText(text);
    if (m_speed->currentData().toDouble() != state->speed) {
        int place = m_speed->findData(state->speed);
        if (place < 0) {  // from the address
            m_speed->addItem(tr("%1×").arg(shortNumberText(state->speed)), state->speed);
            place = m_speed->count() - 1;
        }
        m_speed->setCurrentIndex(place);
    }
}
