// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/alarmbar.h"

#include "app/workspace/alarms.h"
#include "widgets/forms/clickshield.h"
#include "widgets/models/alarmtext.h"
#include "widgets/theme/theme.h"

#include <QCursor>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

AlarmBar::AlarmBar(Alarms &alarms, QWidget *area, int smallest, FreePlace freePlace)
    : QFrame(area->parentWidget())
    , m_alarms(alarms)
    , m_area(area)
    , m_smallest(smallest)
    , m_freePlace(std::move(freePlace))
    , m_icon(new QLabel)
    , m_text(new QLabel)
    , m_more(new QLabel)
    , m_remedy(new QPushButton(tr("Stop motors")))
    , m_acknowledge(new QPushButton(tr("Acknowledge")))
{
    setObjectName(u"alarmBar"_s);
    setAccessibleName(tr("Alarm"));
    QFont large = m_icon->font();
    large.setPointSizeF(large.pointSizeF() + 8);
    m_icon->setFont(large);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    m_remedy->setObjectName(u"alarmRemedy"_s);
    m_acknowledge->setToolTip(tr("Takes the alarm away, here and on the dashboard"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, Metric::kGap);
    row->setSpacing(Metric::kGap);
    row->addWidget(m_icon, 0, Qt::AlignTop);
    row->addWidget(m_text, 1);
    row->addWidget(m_more);
    for (QPushButton *button : {m_remedy, m_acknowledge}) {
        button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard where it was
        row->addWidget(button, 0, Qt::AlignVCenter);
    }
    connect(m_remedy, &QPushButton::clicked, &alarms, &Alarms::motorsOff);
    connect(m_acknowledge, &QPushButton::clicked, this, [this] { m_alarms.acknowledge(m_number); });
    connect(&alarms, &Alarms::changed, this, &AlarmBar::refresh);
    area->installEventFilter(this);
    refresh();
}

QString AlarmBar::text() const
{
    return isHidden() ? QString() : accessibleDescription();
}

bool AlarmBar::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_area && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) {
        m_start.reset();
        place();
    }
    if (watched == m_area && event->type() == QEvent::Leave)
        makeRoom();
    return QFrame::eventFilter(watched, event);
}

void AlarmBar::place()
{
    if (isHidden())
        return;
    const bool hasRoom = m_area->layout()->contentsMargins().top() > 0;
    if (!hasRoom && !m_start)
        m_start = m_freePlace([this](int width) { return heightFor(width); });
    const QPoint start = hasRoom ? QPoint() : *m_start;
    const int width = m_area->width() - start.x();
    setGeometry(QRect(m_area->pos() + start, QSize(width, heightFor(width))));
    raise();
    makeRoom();
}

int AlarmBar::heightFor(int width) const
{
    return std::max(minimumSizeHint().height(), layout()->heightForWidth(width));
}

void AlarmBar::makeRoom()
{
    if (m_area->rect().contains(m_area->mapFromGlobal(QCursor::pos())))
        return;
    const int height = heightFor(m_area->width());
    const int wanted = isHidden() || m_area->height() - height < m_smallest ? 0 : height;
    if (m_area->layout()->contentsMargins().top() == wanted)
        return;
    m_area->layout()->setContentsMargins(0, wanted, 0, 0);
    shield(m_area->geometry());
    place();
}

// A click that was meant for what has just moved, or for this bar, reaches nothing.
void AlarmBar::shield(const QRect &place)
{
    if (!parentWidget()->isVisible())
        return;
    new ClickShield(*parentWidget(), place);
    raise();
}

void AlarmBar::leaveEvent(QEvent *event)
{
    QFrame::leaveEvent(event);
    makeRoom();
}

void AlarmBar::hideEvent(QHideEvent *event)
{
    QFrame::hideEvent(event);
    m_start.reset();
    if (!event->spontaneous())
        shield(geometry());
}

void AlarmBar::refresh()
{
    const QList<AlarmReport> pressing = m_alarms.pressing();
    if (pressing.isEmpty()) {
        m_number = 0;
        hide();
        makeRoom();
        return;
    }
    const AlarmReport &first = pressing.first();
    ErrorText text = m_alarms.text(first);
    // Motion and what the program had to do is red; what gives time is amber.
    const bool isSevere = first.hasActed() || first.alarm.kind <= AlarmKind::Oscillation
        || first.alarm.kind == AlarmKind::Sensor || first.alarm.kind >= AlarmKind::Stale;
    m_icon->setText(isSevere ? u"✖"_s : u"⚠"_s);
    m_icon->setAccessibleName(isSevere ? tr("Severe") : tr("Warning"));
    const int times = m_alarms.timesOf(first.number);
    const QString again = times > 1 ? u' ' + tr("(%1 times)").arg(times) : QString();
    if (first.isOver)
        text.what = (first.wasSeenToEnd ? tr("Over: %1") : tr("Not watched any more: %1")).arg(text.what);
    m_text->setText(u"<b>%1</b>%2 %3 %4"_s.arg(text.what.toHtmlEscaped(), again.toHtmlEscaped(),
                                               text.meaning.toHtmlEscaped(), text.cure.toHtmlEscaped()));
    setAccessibleDescription(text.oneLine());
    m_more->setVisible(pressing.size() > 1);
    m_more->setText(tr("and %n more", nullptr, int(pressing.size()) - 1));
    m_remedy->setVisible(m_alarms.offersMotorsOff(first));
    setProperty("severe", isSevere);
    for (QWidget *part :
         std::initializer_list<QWidget *>{this, m_icon, m_text, m_more, m_remedy, m_acknowledge})
        repolish(part);
    const bool isAnother = std::exchange(m_number, first.number) != first.number;
    show();
    place();
    // A click that was meant for what lay there before, or for the alarm before, must not do anything.
    if (isAnother)
        new ClickShield(*this);
}
