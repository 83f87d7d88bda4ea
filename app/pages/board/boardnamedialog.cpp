// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/boardnamedialog.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

BoardNameDialog::BoardNameDialog(Workspace &workspace, QWidget *parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_names(workspace.naming().names())
    , m_which(new QButtonGroup(this))
    , m_name(new QLineEdit(workspace.naming().suggestion()))
    , m_store(new QCheckBox(tr("Store the name on the board as well")))
    , m_problem(new QLabel)
    , m_take(new QPushButton(tr("Use this name")))
{
    setWindowTitle(tr("Which board is this?"));
    resize(520, 270);
    makeBody();
    makeButtons();
    update();
    if (m_name->isEnabled()) {
        m_name->setFocus();
        m_name->selectAll();
    } else {
        m_which->checkedButton()->setFocus();
    }
}

void BoardNameDialog::makeBody()
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    auto *intro = new QLabel(tr("It has no serial number. Under its name its snapshots and unwritten changes "
                                "are kept apart from those of other boards."));
    intro->setWordWrap(true);
    layout->addWidget(intro);
    const QString current = m_workspace.naming().name();
    for (int i = 0; i < int(m_names.size()); ++i) {
        auto *known = new QRadioButton(tr("It is “%1”").arg(m_names[i]));
        known->setChecked(m_names[i] == current);
        m_which->addButton(known, i);
        layout->addWidget(known);
    }
    auto *fresh = new QRadioButton(tr("It is a new one, with this name:"));
    m_which->addButton(fresh, int(m_names.size()));
    fresh->setChecked(current.isEmpty());
    fresh->setVisible(!m_names.isEmpty());
    m_name->setAccessibleName(tr("Name of the board"));
    m_name->setMaxLength(40);
    m_store->setToolTip(tr("Then it is told from boards that are otherwise the same. A snapshot is taken "
                           "first."));
    const bool canStore
        = !m_workspace.naming().storeAction().isEmpty() && m_workspace.client().identity().writable;
    m_store->setVisible(canStore);
    m_store->setChecked(canStore);
    m_problem->setObjectName(u"changed"_s);
    m_problem->setWordWrap(true);
    layout->addWidget(fresh);
    layout->addWidget(m_name);
    layout->addWidget(m_store);
    layout->addWidget(m_problem);
    layout->addStretch(1);
    connect(m_which, &QButtonGroup::idClicked, this, &BoardNameDialog::update);
    connect(m_name, &QLineEdit::textChanged, this, &BoardNameDialog::update);
}

void BoardNameDialog::makeButtons()
{
    auto *cancel = new QPushButton(tr("Cancel"));
    m_take->setObjectName(u"primary"_s);
    m_take->setDefault(true);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_take);
    static_cast<QVBoxLayout *>(layout())->addLayout(buttons);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_take, &QPushButton::clicked, this, &BoardNameDialog::take);
}

QString BoardNameDialog::chosen() const
{
    const int which = m_which->checkedId();
    return which >= 0 && which < m_names.size() ? m_names[which] : m_name->text().simplified();
}

void BoardNameDialog::update()
{
    const bool isNew = m_which->checkedId() == m_names.size();
    m_name->setEnabled(isNew);
    m_store->setEnabled(m_workspace.client().identity().extra.value(u"name"_s).toString() != chosen());
    m_take->setText(isNew ? tr("Use this name") : tr("It is this one"));
    m_take->setEnabled(!chosen().isEmpty());
    const bool isOwn = isNew && chosen() == m_workspace.client().identity().extra.value(u"name"_s).toString();
    m_problem->setText(
        isNew && m_names.contains(chosen()) ? tr("A board of that name is known: it becomes this one.")
            : isOwn ? tr("The board has this name already. If it is the one that it left the factory "
                         "with, every such board will be taken for this one.")
                    : QString());
    m_problem->setVisible(!m_problem->text().isEmpty());
}

void BoardNameDialog::take()
{
    const QString name = chosen();
    if (const auto done = m_workspace.naming().choose(name); !done) {
        m_workspace.notifications().report(done.error());
        return;
    }
    if (m_store->isVisible() && m_store->isEnabled() && m_store->isChecked())
        m_workspace.perform(m_workspace.naming().storeAction(), {{u"name"_s, name}});
    accept();
}
