// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/functionscard.h"

#include "app/workspace/question.h"
#include "widgets/forms/argumentform.h"
#include "widgets/models/parametermodel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

FunctionsCard::FunctionsCard(Workspace &workspace, QWidget *parent)
    : Card(tr("Functions"), parent)
    , m_workspace(workspace)
    , m_scroll(new QScrollArea)
{
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    content()->addWidget(m_scroll, 1);
}

void FunctionsCard::fill()
{
    auto *rows = new QWidget;
    auto *grid = new QGridLayout(rows);
    grid->setContentsMargins(0, 0, Metric::kGap, 0);
    grid->setHorizontalSpacing(Metric::kGap);
    grid->setVerticalSpacing(12);
    grid->setColumnStretch(0, 1);
    int line = 0;
    const Device *tables = m_workspace.tables();
    for (const ActionSpec &action : tables ? tables->actions() : std::span<const ActionSpec>()) {
        if (!action.whileSteering)
            continue;
        auto *form = new ArgumentForm(action, {}, rows);
        auto *button = new QPushButton(tableText(action.label));
        // The card is narrow: a field has its label above it, a check box beside it.
        const bool ticks
            = std::any_of(action.arguments.begin(), action.arguments.end(),
                          [](const ArgumentSpec &argument) { return argument.kind == ArgumentKind::Toggle; });
        if (!ticks) {
            auto *fields = static_cast<QFormLayout *>(form->layout());
            fields->setRowWrapPolicy(QFormLayout::WrapAllRows);
            fields->setVerticalSpacing(Metric::kUnit);
            for (QLabel *label : form->findChildren<QLabel *>())
                label->setMinimumHeight(0);
        }
        button->setToolTip(tableText(action.help));
        // Beside the fields it would have no room in the smallest window.
        auto *cell = new QVBoxLayout;
        cell->setSpacing(Metric::kUnit);
        cell->addWidget(form);
        cell->addWidget(button, 0, Qt::AlignLeft);
        form->setVisible(!action.arguments.empty());
        grid->addLayout(cell, line++, 0);
        connect(button, &QPushButton::clicked, this, [this, form, action] {
            const auto arguments = form->arguments();
            if (!arguments) {
                m_workspace.notifications().report(arguments.error());
                return;
            }
            const auto perform = [this, action, given = *arguments] {
                m_workspace.perform(QString::fromLatin1(action.key), given);
            };
            if (chosenAction(action, *arguments).letsGo)
                askToLetGo(m_workspace, tableText(action.label), this, perform);
            else
                perform();
        });
    }
    grid->setRowStretch(line, 1);
    delete m_scroll->takeWidget();
    m_scroll->setWidget(rows);
    // Before the style sheet applies, buttons ask for less than they need.
    for (QWidget *widget : rows->findChildren<QWidget *>())
        widget->ensurePolished();
    grid->invalidate();
    m_scroll->setMinimumWidth(rows->minimumSizeHint().width()
                              + m_scroll->verticalScrollBar()->sizeHint().width());
    setVisible(line > 0);
}
