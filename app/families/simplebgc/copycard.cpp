// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/copycard.h"

#include "app/workspace/filedialogs.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"
#include "widgets/theme/theme.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

enum CopyColumn { CopyWhat, CopyThere, CopyBoard, CopyColumns };

/// Of a reply: they are in the sentence.
const QStringList kCounted{u"bytes"_s,     u"files"_s,          u"files_changed"_s, u"files_differing"_s,
                           u"differing"_s, u"restart_needed"_s, u"written"_s,       u"other_board"_s,
                           u"found"_s,     u"other_firmware"_s, u"unnamed"_s};

// Sizes and gaps are told in English, as files have them.
QString sideText(const QString &side)
{
    static const QRegularExpression bytes(u"^(\\d+) bytes$"_s);
    if (const auto match = bytes.match(side); match.hasMatch())
        return CopyCard::tr("%n byte(s)", nullptr, match.captured(1).toInt());
    return side == u"none"_s ? CopyCard::tr("not there") : side;
}

}  // namespace

CopyCard::CopyCard(Workspace &workspace, const QString &title, const QString &text, const QString &suggested,
                   const QList<Way> &ways, QWidget *parent)
    : Card(title, parent)
    , m_workspace(workspace)
    , m_suggested(suggested)
    , m_ways(ways)
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_other(new QCheckBox(tr("Also from another board")))
    , m_finding(new QLabel)
    , m_table(new QTableWidget)
{
    auto *about = new QLabel(text);
    about->setWordWrap(true);
    auto *harmless = new QHBoxLayout;
    auto *red = new QHBoxLayout;
    for (const Way &way : m_ways) {
        auto *button = new QPushButton(way.text);
        if (way.isRed)
            button->setObjectName(u"danger"_s);
        (way.isRed ? red : harmless)->addWidget(button);
        m_buttons.append(button);
        connect(button, &QPushButton::clicked, this, [this, way] { ask(way); });
    }
    setHarmless(*m_cancel);
    harmless->addWidget(m_cancel);
    for (QHBoxLayout *line : {harmless, red}) {
        line->setSpacing(Metric::kGap);
        line->addStretch(1);
    }
    m_other->setToolTip(tr("Calibrations and licence of another board are refused otherwise: they do not fit "
                           "this board's sensors"));
    m_finding->setWordWrap(true);
    m_table->setAccessibleName(tr("What differs between the copy and the board"));
    m_table->setColumnCount(CopyColumns);
    m_table->setHorizontalHeaderLabels({tr("What"), tr("Copy"), tr("Board")});
    setSelectableRows(*m_table);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(CopyWhat, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(CopyThere, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(CopyBoard, QHeaderView::ResizeToContents);
    m_table->hide();
    content()->addWidget(about);
    content()->addLayout(harmless);
    content()->addLayout(red);
    content()->addWidget(m_other, 0, Qt::AlignLeft);
    content()->addWidget(m_finding);
    content()->addWidget(m_table, 1);
    content()->addStretch();  // as long as there is no table
    connect(m_cancel, &QPushButton::clicked, &workspace.client(), &DeviceClient::cancelJobs);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &CopyCard::updateButtons);
    connect(&workspace, &Workspace::guidedChanged, this, &CopyCard::updateButtons);
    connect(&workspace.live(), &LiveModel::heldChanged, this, &CopyCard::updateButtons);
    updateButtons();
}

QString CopyCard::finding() const
{
    return m_finding->text();
}

void CopyCard::updateButtons()
{
    const DeviceClient &client = m_workspace.client();
    const bool isFree
        = client.isConnected() && !m_isRunning && !m_workspace.isGuided() && !m_workspace.live().isHeld();
    for (int i = 0; i < int(m_ways.size()); ++i) {
        const bool isThere = !client.device() || m_workspace.hasAction(m_ways[i].action);
        const bool changes = m_ways[i].isRed;
        m_buttons[i]->setEnabled(isFree && isThere && (!changes || client.identity().writable));
        m_buttons[i]->setToolTip(isThere ? m_ways[i].tip : tr("This board has no command for it."));
    }
    m_cancel->setVisible(m_isRunning);
}

void CopyCard::ask(const Way &way)
{
    const auto chosen = [this, way](const QString &path) { run(way, path); };
    const QString filter = tr("Copies of a board (*.bin)");
    if (way.makesCopy)
        askSavePath(this, tr("Copy into a file"), m_suggested, filter, chosen);
    else
        askOpenPath(this, tr("Choose a copy"), filter, chosen);
}

void CopyCard::run(const Way &way, const QString &path)
{
    QVariantMap arguments = way.arguments;
    arguments.insert(u"file"_s, path);
    if (way.isRed && !way.makesCopy)
        arguments.insert(u"other"_s, m_other->isChecked());
    m_isRunning = true;
    m_finding->setText(tr("%1 …").arg(way.text));
    m_table->hide();
    updateButtons();
    whenDone(m_workspace.perform(way.action, arguments), this,
             [this, way](const Result<ActionOutcome> &outcome) { onDone(way, outcome); });
}

void CopyCard::onDone(const Way &way, const Result<ActionOutcome> &outcome)
{
    m_isRunning = false;
    updateButtons();
    if (!outcome) {
        m_finding->setText(describe(outcome.error()).oneLine());
        return;
    }
    m_finding->setText(sentence(way, outcome->reply));
    showRows(outcome->reply);
}

QString CopyCard::sentence(const Way &way, const ActionReply &reply) const
{
    const auto count = [&reply](const QString &key) { return reply.value(key).toInt(); };
    QStringList parts;
    if (reply.contains(u"differing"_s) && count(u"differing"_s) > 0)
        parts.append(tr("%n byte(s) of memory differ.", nullptr, count(u"differing"_s)));
    if (count(u"files_differing"_s) > 0)
        parts.append(tr("%n file(s) differ.", nullptr, count(u"files_differing"_s)));
    const bool isComparison = way.action.endsWith(u".compare"_s);
    const auto keys = reply.keys();
    const bool hasRows
        = !std::all_of(keys.begin(), keys.end(), [](const QString &key) { return kCounted.contains(key); });
    if (isComparison && parts.isEmpty() && !hasRows)
        parts.append(tr("The board holds what the copy does."));
    if (reply.contains(u"bytes"_s))
        parts.append(tr("%n byte(s) of memory are copied.", nullptr, count(u"bytes"_s)));
    if (reply.contains(u"files"_s))
        parts.append(tr("%n file(s) are copied.", nullptr, count(u"files"_s)));
    if (reply.contains(u"written"_s))
        parts.append(tr("%n byte(s) of memory were written.", nullptr, count(u"written"_s)));
    if (reply.contains(u"files_changed"_s))
        parts.append(tr("%n file(s) were written or erased.", nullptr, count(u"files_changed"_s)));
    if (reply.contains(u"found"_s) && !isComparison)
        parts.append(tr("The place of %1 parts of the settings was found; the others are as they were.")
                         .arg(reply.value(u"found"_s).toString()));
    if (reply.contains(u"other_board"_s))
        parts.append(tr("The copy is of another board."));
    if (reply.contains(u"other_firmware"_s))
        parts.append(tr("The copy is of firmware %1.").arg(reply.value(u"other_firmware"_s).toString()));
    if (reply.contains(u"unnamed"_s))
        parts.append(tr("What lies in %n range(s) is documented nowhere.", nullptr, count(u"unnamed"_s)));
    if (reply.contains(u"restart_needed"_s))
        parts.append(tr("It is in use after a restart."));
    return parts.join(u' ');
}

QString CopyCard::nameOf(const QString &key) const
{
    static const QRegularExpression ofProfile(u"^profile (\\d+): (.+)$"_s);
    static const QRegularExpression ofFile(u"^([a-z-]+) (\\d+)$"_s);
    const auto label = [this](const QString &parameter) {
        const ParameterSpec *spec = m_workspace.tables()->parameters()->find(parameter);
        return spec ? parameterLabel(*spec) : tableText(parameter.toUtf8().constData());
    };
    if (const auto match = ofProfile.match(key); match.hasMatch())
        return tr("Profile %1: %2").arg(match.captured(1), label(match.captured(2)));
    if (const auto match = ofFile.match(key); match.hasMatch())
        return tr("File %1 %2").arg(tableText(match.captured(1).toUtf8().constData()), match.captured(2));
    return key.startsWith(u"0x"_s) ? tr("Address %1").arg(key) : label(key);
}

void CopyCard::showRows(const ActionReply &reply)
{
    m_table->setRowCount(0);
    for (auto it = reply.begin(); it != reply.end(); ++it) {
        if (kCounted.contains(it.key()))
            continue;
        const QString sides = it->toString();
        const qsizetype between = sides.indexOf(u" -> "_s);
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        m_table->setItem(row, CopyWhat, new QTableWidgetItem(nameOf(it.key())));
        m_table->setItem(row, CopyThere, new QTableWidgetItem(sideText(sides.left(between))));
        m_table->setItem(row, CopyBoard, new QTableWidgetItem(sideText(sides.mid(between + 4))));
    }
    m_table->setVisible(m_table->rowCount() > 0);
}
