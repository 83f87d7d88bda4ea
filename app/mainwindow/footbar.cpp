// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/footbar.h"

#include "widgets/forms/clickshield.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

using namespace Qt::StringLiterals;

FootBar::FootBar(Workspace &workspace, const QList<QWidget *> &bars, QWidget *parent)
    : QFrame(parent)
    , m_bars(bars)
    , m_calm(new QLabel(tr("No unwritten changes"), this))
{
    setObjectName(u"footBar"_s);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_calm->setObjectName(u"muted"_s);
    m_calm->setContentsMargins(Metric::kMargin, 0, Metric::kMargin, 0);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->setSizeConstraint(QLayout::SetNoConstraint);  // the room is there before a bar is
    for (QWidget *bar : m_bars)
        layout->addWidget(bar, 1);  // what they say is cut first
    for (QWidget *bar : m_bars)
        bar->installEventFilter(this);
    const auto refresh = [this, &workspace] {
        const DeviceClient &client = workspace.client();
        setVisible(!workspace.configuration().isEmpty()
                   && !(client.isConnected() && client.address().isReplay()));
        // Such a board answers with what is in use; somebody may have set it without storing it.
        m_calm->setText(workspace.canCompareStored() && !workspace.isStoredKnown()
                            ? tr("No unwritten changes; whether all that is in use is stored is not known "
                                 "(Tuning compares)")
                            : tr("No unwritten changes"));
    };
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, refresh);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, refresh);
    connect(&workspace, &Workspace::unstoredChanged, this, refresh);
    refresh();
}

void FootBar::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    m_calm->setGeometry(rect());
    m_calm->lower();
}

bool FootBar::eventFilter(QObject *watched, QEvent *event)
{
    const auto type = event->type();
    const bool isOther = std::any_of(m_bars.begin(), m_bars.end(), [watched](const QWidget *bar) {
        return bar != watched && bar->isVisible();
    });
    if (isVisible() && (type == QEvent::HideToParent || (type == QEvent::ShowToParent && isOther)))
        new ClickShield(*this, rect());
    return QFrame::eventFilter(watched, event);
}

QSize FootBar::sizeHint() const
{
    QSize size = minimumSizeHint();
    for (const QWidget *bar : m_bars)
        size.setWidth(size.width() + bar->sizeHint().width());
    return size;
}

QSize FootBar::minimumSizeHint() const
{
    int height = 0;
    for (const QWidget *bar : m_bars) {
        for (const QWidget *part : bar->findChildren<QWidget *>())
            part->ensurePolished();  // which a bar is only when it is first shown
        height = std::max(height, bar->sizeHint().height());
    }
    return {0, height};
}
