// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/reviewdialog.h"

#include "widgets/models/missingtext.h"
#include "widgets/theme/tablelook.h"
#include "widgets/theme/theme.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

ReviewDialog::ReviewDialog(const Configuration &board, const Configuration &edited, QWidget *parent)
    : QDialog(parent)
    , m_changes(board, edited)
    , m_table(new QTableView)
    , m_risk(new QLabel)
    , m_effect(new QLabel)
    , m_write(new QPushButton)
{
    setWindowTitle(tr("Review and write"));
    resize(760, 460);
    auto *intro = new QLabel(
        board.missing().empty()
            ? tr("These values go to the board. They are read back and compared, and a copy of the whole "
                 "board is kept before the first write.")
            : tr("These values go to the board. They are read back and compared, and a copy of what could be "
                 "read of the board is kept before the first write."));
    intro->setWordWrap(true);
    m_table->setModel(&m_changes);
    m_table->setAccessibleName(tr("Changes to write"));
    setPlainRows(*m_table);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ChangeModel::NameColumn, QHeaderView::Stretch);
    m_risk->setObjectName(u"warning"_s);
    m_risk->setWordWrap(true);
    m_risk->setText(tr("⚠ Some of these values are in the risk class: hold the camera, or take it off, while "
                       "motors start."));

    m_effect->setWordWrap(true);
    auto *missing = new QLabel;
    missing->setObjectName(u"muted"_s);
    missing->setWordWrap(true);
    missing->setVisible(!board.missing().empty());
    missing->setText(
        tr("Not compared, because it could not be read: %1.").arg(missingText(board, board.missing())));
    auto *back = new QPushButton(tr("Back"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addStretch(1);
    buttons->addWidget(back);
    buttons->addWidget(m_write);
    m_write->setDefault(true);
    connect(m_write, &QPushButton::clicked, this, &QDialog::accept);
    connect(back, &QPushButton::clicked, this, &QDialog::reject);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(intro);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_risk);
    layout->addWidget(m_effect);
    layout->addWidget(missing);
    layout->addLayout(buttons);
    connect(&m_changes, &ChangeModel::ticksChanged, this, &ReviewDialog::updateButton);
    updateButton();
    m_table->setFocus();
    m_table->selectRow(0);
}

void ReviewDialog::updateButton()
{
    const int count = m_changes.tickedCount();
    const int profiles = m_changes.tickedProfiles();
    const QString values = tr("%n value(s)", nullptr, count);
    m_write->setText(profiles > 1 ? tr("Write %1 to %2 profiles").arg(values).arg(profiles)
                                  : tr("Write %1").arg(values));
    m_write->setEnabled(count > 0);
    QStringList effects;
    if (m_changes.hasTicked(WriteEffect::Restarts))
        effects.append(tr("The board restarts when they are written."));
    if (m_changes.hasTicked(WriteEffect::Volatile))
        effects.append(tr("Some of them are in use only until the board restarts."));
    m_effect->setText(effects.join(u' '));
    m_effect->setVisible(!effects.isEmpty());
    const bool red = m_changes.hasTickedRed();
    m_risk->setVisible(red);
    m_write->setObjectName(red ? u"danger"_s : u"primary"_s);
    repolish(m_write);
}
