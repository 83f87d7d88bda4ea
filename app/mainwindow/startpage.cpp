// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/startpage.h"

#include "widgets/forms/keyboard.h"
#include "widgets/models/numbertext.h"
#include "widgets/theme/theme.h"
#include "widgets/views/card.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxLeftovers = 3;
constexpr int kMaxRecent = 3;
constexpr int kRecentWidth = 480;

void removeRows(QLayout &layout)
{
    while (QLayoutItem *item = layout.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

}  // namespace

StartPage::StartPage(QWidget *parent)
    : QWidget(parent)
    , m_leftovers(new QVBoxLayout)
    , m_recent(new QVBoxLayout)
{
    auto *card = new Card({});
    card->setMaximumWidth(600);
    auto *title = new QLabel(tr("No board yet"));
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() + 8);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto *text = new QLabel(
        tr("Plug the controller in with USB or a serial adapter, choose its port at the top left and "
           "connect. Rate and parity are found by the program. A drone is met in its own wireless network: "
           "join it, then choose its address in the same list. Nothing is sent to a port you did not "
           "choose, and nothing is written without your review."));
    text->setWordWrap(true);
    auto *connectButton = new QPushButton(tr("&Choose a port"));
    connectButton->setObjectName(u"primary"_s);
    setHarmless(*connectButton);
    auto *demo = new QPushButton(tr("&Try the simulated gimbal"));
    auto *open = new QPushButton(tr("&Open a file"));
    open->setToolTip(
        tr("Look at a snapshot or a saved configuration and edit it without a board, or replay a recording"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addWidget(connectButton);
    buttons->addWidget(open);
    buttons->addWidget(demo);
    buttons->addStretch(1);
    auto *hint = new QLabel(
        tr("The simulated gimbal shakes, drifts and answers like a real one: a safe place to learn."));
    hint->setObjectName(u"muted"_s);
    hint->setWordWrap(true);
    card->content()->setContentsMargins(24, 24, 24, 24);
    card->content()->setSpacing(Metric::kMargin);
    card->content()->addWidget(title);
    card->content()->addWidget(text);
    card->content()->addLayout(buttons);
    card->content()->addWidget(hint);
    card->content()->addLayout(m_recent);
    card->content()->addLayout(m_leftovers);
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
    connect(open, &QPushButton::clicked, this, &StartPage::fileRequested);
}

void StartPage::setRecent(const QStringList &addresses, const QStringList &files)
{
    removeRows(*m_recent);
    if (addresses.isEmpty() && files.isEmpty())
        return;
    auto *title = new QLabel(tr("Lately:"));
    title->setObjectName(u"muted"_s);
    m_recent->addWidget(title);
    const auto add = [this](const QString &text, const QString &tip, auto chosen) {
        auto *button = new QPushButton;
        button->setText(
            button->fontMetrics().elidedText(text, Qt::ElideMiddle, kRecentWidth).replace(u'&', u"&&"_s));
        button->setAccessibleName(text);
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, chosen);
        m_recent->addWidget(button, 0, Qt::AlignLeft);
    };
    for (const QString &address : addresses.mid(0, kMaxRecent))
        add(tr("Connect to %1").arg(address), address, [this, address] { emit addressRequested(address); });
    for (const QString &path : files.mid(0, kMaxRecent))
        add(tr("Open %1").arg(QFileInfo(path).fileName()), path, [this, path] { emit pathRequested(path); });
}

void StartPage::setLeftovers(const QStringList &bases)
{
    removeRows(*m_leftovers);
    if (bases.isEmpty())
        return;
    auto *title = new QLabel(tr("Unwritten changes of an earlier run:"));
    title->setObjectName(u"changed"_s);
    m_leftovers->addWidget(title);
    for (const QString &base : bases.mid(0, kMaxLeftovers)) {
        const QString serial = QFileInfo(base).dir().dirName() == u"unsaved"_s
            ? QFileInfo(QFileInfo(base).path()).dir().dirName()
            : QFileInfo(base).baseName();
        const QString when = dateText(QFileInfo(base).lastModified());
        auto *button = new QPushButton(tr("Board %1, %2").arg(serial, when));
        connect(button, &QPushButton::clicked, this, [this, base] { emit leftoverRequested(base); });
        m_leftovers->addWidget(button, 0, Qt::AlignLeft);
    }
}
