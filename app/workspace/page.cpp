// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/page.h"

#include "app/workspace/setupbutton.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

Page::Page(Workspace &workspace, const QString &key, const QString &title, QWidget *parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_key(key)
    , m_title(title)
    , m_body(new QVBoxLayout)
    , m_header(new QHBoxLayout)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, 12, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(12);
    auto *label = new QLabel(title);
    label->setObjectName(u"title"_s);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() + 4);
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    m_header->setSpacing(Metric::kGap);
    m_header->addWidget(label);
    m_header->addStretch(1);
    const auto steps = setupSteps();
    if (std::any_of(steps.begin(), steps.end(),
                    [&key](const SetupStepSpec &step) { return key == QLatin1String(step.elsewhere); })) {
        auto *setup = new SetupButton(workspace.client(), key, *this);
        m_header->addWidget(setup);
        connect(setup, &SetupButton::stepWanted, this, &Page::setupStepWanted);
    }
    layout->addLayout(m_header);
    layout->addLayout(m_body, 1);
}

// What ends with it tells nothing to a page whose own members are gone.
Page::~Page()
{
    for (const QObject *part : findChildren<QObject *>())
        part->disconnect(this);
}

void Page::coverWhenStale(QWidget &view, const Freshness::Channels &channels, StaleCover::Look look)
{
    workspace().freshness().watch(*new StaleCover(workspace().theme(), view, look), channels);
}

void Page::fadeWhenStale(QAbstractScrollArea &table, const QHeaderView &header, int column)
{
    workspace().freshness().watch(*new StaleCover(workspace().theme(), table, header, column));
}

void Page::refreshWhileShown(std::chrono::milliseconds interval, std::function<void()> refresh,
                             std::function<bool()> isPaused)
{
    m_refresh = std::move(refresh);
    m_refreshTimer.setInterval(interval);
    connect(&m_refreshTimer, &QTimer::timeout, this, [this, isPaused = std::move(isPaused)] {
        if (!isPaused())
            m_refresh();
    });
}

void Page::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (!m_refresh)
        return;
    m_refresh();
    m_refreshTimer.start();
}

void Page::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_refreshTimer.stop();
}
