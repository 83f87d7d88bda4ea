// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/alarmcard.h"

#include "app/workspace/alarms.h"
#include "widgets/models/alarmtext.h"
#include "widgets/theme/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

AlarmCard::AlarmCard(Alarms &alarms, const AlarmReport &report)
{
    setObjectName(u"alarmCard"_s);
    setProperty("over", report.isOver);
    const ErrorText text = alarms.text(report);
    setAccessibleName(alarmName(report.alarm));
    setAccessibleDescription(text.oneLine());
    const auto label = [](const QString &words, const char *name) {
        auto *made = new QLabel(words);
        made->setObjectName(QLatin1String(name));
        made->setWordWrap(true);
        return made;
    };
    const QString when = QLocale().toString(report.at.time(), u"HH:mm:ss"_s);
    const QString pattern = !report.isOver ? tr("%1, %2")
        : report.wasSeenToEnd              ? tr("%1, %2, over")
                                           : tr("%1, %2, not watched any more");
    auto *title = label(pattern.arg(alarmName(report.alarm), when), report.isOver ? "muted" : "error");
    auto *acknowledge = new QPushButton(tr("Acknowledge"));
    acknowledge->setAccessibleName(tr("Acknowledge: %1").arg(alarmName(report.alarm)));
    // Not at once: the card goes with it.
    connect(
        acknowledge, &QPushButton::clicked, &alarms,
        [&alarms, number = report.number] { alarms.acknowledge(number); }, Qt::QueuedConnection);
    auto *head = new QHBoxLayout;
    head->addWidget(title, 1);
    head->addWidget(acknowledge);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(Metric::kGap, Metric::kGap, Metric::kGap, Metric::kGap);
    column->setSpacing(Metric::kUnit);
    column->addLayout(head);
    column->addWidget(label(text.what, "plain"));
    column->addWidget(label(text.meaning + u' ' + text.cure, "muted"));
}
