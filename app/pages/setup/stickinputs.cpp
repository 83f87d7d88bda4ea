// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/stickinputs.h"

#include "app/workspace/wizardparts.h"
#include "protocol/client/whendone.h"
#include "protocol/device/setupfacts.h"
#include "widgets/views/inputbars.h"

#include <QVBoxLayout>

using namespace Qt::StringLiterals;

StickInputs::StickInputs(Workspace &workspace, QWidget *parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_bars(new InputBars(workspace.theme()))
{
    auto *live = new Card(tr("What comes in now"));
    live->content()->addWidget(m_bars);
    auto *sticks = new SimulatedHands(workspace, {}, this, tr("Simulated remote control"));
    sticks->add(
        u"receiver"_s, tr("Receiver at the board"),
        {{tr("receiver: none"), 0}, {tr("receiver: a wire for each channel"), 1}, {tr("receiver: S-bus"), 3}},
        -1);
    sticks->add(u"stick"_s, tr("Which stick is held at an end"),
                {{tr("sticks: let go"), 0},
                 {tr("roll stick: right"), 1},
                 {tr("roll stick: left"), 2},
                 {tr("pitch stick: down"), 3},
                 {tr("pitch stick: up"), 4},
                 {tr("yaw stick: right"), 5},
                 {tr("yaw stick: left"), 6},
                 {tr("switch: up"), 7},
                 {tr("switch: down"), 8},
                 {tr("roll and pitch stick at once"), 9}});
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(live);
    column->addWidget(sticks);
}

void StickInputs::ask()
{
    const Device *device = m_workspace.tables();
    if (m_isAsking || !device || !device->setupFacts())
        return;
    m_isAsking = true;
    whenDone(m_workspace.client().submit<ActionReply>(
                 [key = device->setupFacts()->setupKeys().readInputs](Channel &channel, Device &board) {
                     return board.perform(channel, key, {});
                 }),
             this, [this](const Result<ActionReply> &told) {
                 m_isAsking = false;
                 m_bars->setInputs(told.value_or(ActionReply()));
             });
}
