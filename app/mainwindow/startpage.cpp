// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/startpage.h"

#include "widgets/theme/theme.h"
#include "widgets/views/card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

StartPage::StartPage(QWidget *parent)
    : QWidget(parent)
{
    auto *card = new Card({});
    card->setMaximumWidth(560);
    auto *title = new QLabel(tr("No gimbal yet"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() + 8);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto *text = new QLabel(tr("Plug the controller in with USB or a serial adapter, choose its port at the top left and "
                               "connect. Rate and parity are found by the program. Nothing is sent to a port you did not "
                               "choose, and nothing is written without your review."));
    text->setWordWrap(true);
    auto *connectButton = new QPushButton(tr("&Choose a port"));
    connectButton->setObjectName(u"primary"_s);
    auto *demo = new QPushButton(tr("&Try the simulated gimbal"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addWidget(connectButton);
    buttons->addWidget(demo);
    buttons->addStretch(1);
    auto *hint = new QLabel(tr("The simulated gimbal shakes, drifts and answers like a real one: a safe place to learn."));
    hint->setObjectName(u"muted"_s);
    hint->setWordWrap(true);
    card->content()->setContentsMargins(24, 24, 24, 24);
    card->content()->setSpacing(Metric::kMargin);
    card->content()->addWidget(title);
    card->content()->addWidget(text);
    card->content()->addLayout(buttons);
    card->content()->addWidget(hint);
    auto *layout = new QVBoxLayout(this);
    auto *row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(card, 4);
    row->addStretch(1);
    layout->addStretch(1);
    layout->addLayout(row);
    layout->addStretch(2);
    connect(connectButton, &QPushButton::clicked, this, &StartPage::connectRequested);
    connect(demo, &QPushButton::clicked, this, &StartPage::demoRequested);
}
