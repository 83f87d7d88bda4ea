// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/scriptslotspage.h"

#include "app/workspace/filedialogs.h"
#include "app/workspace/question.h"
#include "app/workspace/wizardparts.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/theme/tablelook.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kScriptsBesideEms = 80;  // of width, and what runs stands beside the slots
constexpr int kShownRows = 6;
constexpr int kShownCommands = 4;
constexpr int kMostCommands = 2000;  // that are listed
constexpr int kMostCopies = 12;  // that are offered
constexpr double kSilentFor = 1.5;  // seconds

QString scriptBytes(int bytes)
{
    return ScriptSlotsPage::tr("%n byte(s)", nullptr, bytes);
}

}  // namespace

ScriptSlotsPage::ScriptSlotsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"scriptslots"_s, tr("Scripts"), parent)
    , m_finding(new QLabel)
    , m_table(new QTableWidget(0, ColumnCount))
    , m_load(new QPushButton(tr("Load…")))
    , m_save(new QPushButton(tr("Save…")))
    , m_restore(new QPushButton(tr("Restore")))
    , m_erase(new QPushButton(tr("Erase")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_copies(new QMenu(this))
    , m_running(new QLabel)
    , m_about(new QLabel)
    , m_commands(new QListWidget)
    , m_run(new QPushButton(tr("Run…")))
    , m_follow(new QPushButton(tr("Run and follow…")))
    , m_stop(new QPushButton(tr("Stop script")))
    , m_refresh(new QPushButton(tr("Read again")))
    , m_cards(new QBoxLayout(QBoxLayout::TopToBottom))
{
    m_stop->setToolTip(tr("Stop the script that runs; the motors go on"));
    m_refresh->setToolTip(tr("Ask the board once more what is in its slots"));
    header()->addWidget(m_stop);  // in reach on a small screen too
    header()->addWidget(m_refresh);
    makeBody();
    connectAll();
    tellNothing();
    onState();
}

QWidget *ScriptSlotsPage::makeSlots()
{
    auto *card = new Card(tr("Slots"));
    m_table->setAccessibleName(tr("Slots for scripts"));
    m_table->setHorizontalHeaderLabels({tr("Slot"), tr("Script"), tr("Kept from before")});
    setSelectableRows(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(CopyColumn, QHeaderView::Stretch);
    m_table->setMinimumHeight((kShownRows + 1) * m_table->verticalHeader()->defaultSectionSize());
    m_load->setToolTip(
        tr("Write a compiled script from a file into the slot, and read it back. A script that "
           "runs is stopped first; what is in the slot is kept"));
    m_save->setToolTip(tr("Copy the script in the slot into a file"));
    m_restore->setToolTip(tr("Write what was in the slot before into it again"));
    m_erase->setToolTip(tr("Empty the slot. What is in it is kept, and can be restored"));
    m_restore->setMenu(m_copies);
    setHarmless(*m_cancel);
    auto *row = new QHBoxLayout;
    row->setSpacing(Metric::kGap);
    for (QPushButton *button : {m_load, m_save, m_restore, m_erase, m_cancel})
        row->addWidget(button);
    row->addStretch(1);
    card->content()->addWidget(m_table, 1);
    card->content()->addLayout(row);
    return card;
}

QWidget *ScriptSlotsPage::makeRun()
{
    auto *card = new Card(tr("What runs"));
    setHeadline(*m_running);
    m_about->setWordWrap(true);
    m_run->setObjectName(u"danger"_s);
    m_follow->setObjectName(u"danger"_s);
    m_run->setToolTip(tr("Start the script in the slot"));
    m_follow->setToolTip(tr("Start the script in the slot and show each command that the board carries out"));
    auto *row = new QHBoxLayout;
    row->setSpacing(Metric::kGap);
    for (QPushButton *button : {m_run, m_follow})
        row->addWidget(button);
    row->addStretch(1);
    auto *note = new QLabel(tr(
        "“STOP MOTORS” ends a script that is followed here. One that was started otherwise goes on and may "
        "start the motors again: stop it as well."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    card->content()->addWidget(m_running);
    card->content()->addWidget(m_about);
    auto *title = new QLabel(tr("Commands as the board tells them"));
    title->setObjectName(u"muted"_s);
    m_commands->setAccessibleName(tr("Commands of the script"));
    m_commands->setMinimumHeight(kShownCommands * m_table->verticalHeader()->defaultSectionSize());
    card->content()->addLayout(row);
    card->content()->addWidget(note);
    card->content()->addWidget(title);
    card->content()->addWidget(m_commands, 1);
    return card;
}

void ScriptSlotsPage::makeBody()
{
    m_finding->setWordWrap(true);
    auto *note = new QLabel(tr(
        "Scripts are stored compiled. This program has no compiler for them and cannot show what one does: "
        "it copies them as files, as they are. Compile a script with the maker's program."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    auto *content = new QWidget;
    content->setLayout(m_cards);
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(12);
    m_cards->addWidget(makeSlots(), 3);
    m_cards->addWidget(makeRun(), 2);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    body()->addWidget(m_finding);
    body()->addWidget(scroll, 1);
    body()->addWidget(note);
}

void ScriptSlotsPage::connectAll()
{
    DeviceClient &client = workspace().client();
    connect(m_refresh, &QPushButton::clicked, this, [this] {
        m_result.clear();
        read();
    });
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &ScriptSlotsPage::showState);
    const QString filter = tr("Compiled scripts (*.bin);;All files (*)");
    connect(m_load, &QPushButton::clicked, this, [this, filter] {
        askOpenPath(this, tr("Load a script"), filter, [this](const QString &path) { loadFrom(path); });
    });
    connect(m_save, &QPushButton::clicked, this, [this, filter] {
        askSavePath(this, tr("Save the script"), u"script%1.bin"_s.arg(slot()), filter,
                    [this](const QString &path) { saveTo(path); });
    });
    connect(m_copies, &QMenu::aboutToShow, this, &ScriptSlotsPage::offerCopies);
    connect(m_erase, &QPushButton::clicked, this, &ScriptSlotsPage::erase);
    connect(m_cancel, &QPushButton::clicked, &client, &DeviceClient::cancelJobs);
    connect(m_run, &QPushButton::clicked, this, [this] { askToRun(false); });
    connect(m_follow, &QPushButton::clicked, this, [this] { askToRun(true); });
    connect(m_stop, &QPushButton::clicked, this, &ScriptSlotsPage::stop);
    connect(&client, &DeviceClient::progressChanged, this, &ScriptSlotsPage::onProgress);
    connect(&client, &DeviceClient::stateChanged, this, &ScriptSlotsPage::onState);
    connect(&workspace(), &Workspace::boardRead, this, [this] {
        if (isVisible())
            read();
    });
    connect(&workspace(), &Workspace::guidedChanged, this, &ScriptSlotsPage::showState);
    connect(&workspace().live(), &LiveModel::heldChanged, this, &ScriptSlotsPage::showState);
}

QString ScriptSlotsPage::finding() const
{
    return m_finding->text();
}

QString ScriptSlotsPage::running() const
{
    return m_running->text();
}

QString ScriptSlotsPage::about() const
{
    return m_about->text();
}

std::any ScriptSlotsPage::keep()
{
    return slot();
}

void ScriptSlotsPage::resume(const std::any &kept)
{
    if (const int *chosen = std::any_cast<int>(&kept); chosen && m_table->rowCount() >= *chosen)
        m_table->selectRow(*chosen - 1);
}

void ScriptSlotsPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    read();
}

void ScriptSlotsPage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    const bool isWide = width() > kScriptsBesideEms * fontMetrics().horizontalAdvance(u'm');
    m_cards->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

KeptScripts ScriptSlotsPage::kept() const
{
    return {workspace().history(), workspace().client().identity().serial};
}

int ScriptSlotsPage::slot() const
{
    return m_table->currentRow() + 1;
}

// What runs on a board is known as long as the link lasts.
void ScriptSlotsPage::onState()
{
    if (!workspace().client().isConnected()) {
        m_slots.clear();
        m_isReading = false;
        tellNothing();
        showSlots();
    }
    showState();
}

void ScriptSlotsPage::read()
{
    if (!workspace().client().isConnected() || m_isReading || m_isBusy)
        return;
    m_isReading = true;
    showState();
    whenDone(workspace().client().submit<ActionReply>([](Channel &channel, Device &device) {
        return device.perform(channel, u"script.list"_s, {});
    }),
             this, [this](const Result<ActionReply> &told) {
                 m_isReading = false;
                 m_slots.clear();
                 for (int number = 1; told; ++number) {
                     const QString name = u"script%1."_s.arg(number);
                     const QVariant bytes = told->value(name + u"bytes"_s);
                     const QString error = told->value(name + u"error"_s).toString();
                     if (!bytes.isValid() && error.isEmpty())
                         break;
                     m_slots.append({bytes.toInt(), error});
                 }
                 if (!told && !isEndOfLink(told.error()))
                     m_result = describe(told.error()).oneLine();
                 showSlots();
                 showState();
             });
}

void ScriptSlotsPage::showSlots()
{
    const int chosen = std::max(m_table->currentRow(), 0);
    m_table->setRowCount(int(m_slots.size()));
    for (int row = 0; row < int(m_slots.size()); ++row) {
        const Slot &read = m_slots[row];
        QString size = !read.error.isEmpty() ? detailText(read.error)
            : read.bytes == 0                ? tr("empty")
                                             : scriptBytes(read.bytes);
        if (kept().isUnfinished(row + 1))
            size = tr("⚠ %1, not certain").arg(size);
        const auto copies = kept().copies(row + 1);
        m_table->setItem(row, SlotColumn, new QTableWidgetItem(QString::number(row + 1)));
        m_table->setItem(row, SizeColumn, new QTableWidgetItem(size));
        m_table->setItem(
            row, CopyColumn,
            new QTableWidgetItem(copies.isEmpty() ? QString() : dateText(copies.first().time.toLocalTime())));
    }
    if (!m_slots.isEmpty())
        m_table->selectRow(std::min(chosen, int(m_slots.size()) - 1));
}

void ScriptSlotsPage::showState()
{
    const DeviceClient &client = workspace().client();
    const bool isFree = client.isConnected() && !m_isBusy && !m_isReading && !workspace().isGuided()
        && !workspace().live().isHeld();
    const bool isChosen = slot() > 0 && slot() <= m_slots.size();
    const Slot chosen = isChosen ? m_slots[slot() - 1] : Slot();
    const bool isWritable = isFree && isChosen && client.identity().writable;
    const bool isWhole = isChosen && chosen.bytes > 0 && !kept().isUnfinished(slot());
    m_refresh->setEnabled(isFree);
    m_load->setEnabled(isWritable);
    m_save->setEnabled(isFree && chosen.bytes > 0);
    m_restore->setEnabled(isWritable && !kept().copies(slot()).isEmpty());
    m_erase->setEnabled(isWritable && (chosen.bytes > 0 || !chosen.error.isEmpty()));
    m_run->setEnabled(isWritable && isWhole);
    m_follow->setEnabled(isWritable && isWhole);
    m_stop->setEnabled(client.isConnected() && (isWritable || m_followed > 0));
    m_cancel->setVisible(m_isBusy && m_followed == 0);
    QStringList unfinished;
    int used = 0;
    for (int number = 1; number <= m_slots.size(); ++number) {
        used += m_slots[number - 1].bytes > 0 ? 1 : 0;
        if (kept().isUnfinished(number))
            unfinished.append(QString::number(number));
    }
    QStringList told;
    if (!m_isBusy && !unfinished.isEmpty())
        told.append(tr("⚠ Writing slot %1 was broken off: what it holds is not certain, and it is not run. "
                       "Load the script again, restore what was there, or erase it.")
                        .arg(unfinished.join(u", "_s)));
    if (!m_result.isEmpty())
        told.append(m_result);
    else if (!client.isConnected())
        told.append(tr("Connect a board to see its scripts."));
    else if (m_slots.isEmpty())
        told.append(tr("Asking the board…"));
    else
        told.append(tr("%1 of %2 slots hold a script.").arg(used).arg(m_slots.size()));
    m_finding->setText(told.join(u' '));
}

void ScriptSlotsPage::offerCopies()
{
    m_copies->clear();
    for (const KeptScripts::Copy &copy : kept().copies(slot()).mid(0, kMostCopies))
        m_copies->addAction(tr("%1, %2").arg(dateText(copy.time.toLocalTime()), scriptBytes(int(copy.bytes))),
                            this, [this, path = copy.path] { loadFrom(path); });
}

void ScriptSlotsPage::tellRunning(const QString &what, const QString &about)
{
    m_running->setText(what);
    m_about->setText(about);
}

void ScriptSlotsPage::perform(const QString &key, const QVariantMap &arguments, const Done &done)
{
    m_isBusy = true;
    showState();
    // What is cancelled by intent is told here alone.
    whenDone(workspace().perform(key, arguments, true), this,
             [this, done](const Result<ActionOutcome> &outcome) {
                 m_isBusy = false;
                 m_followed = 0;
                 if (!outcome && outcome.error().code != ErrorCode::Cancelled)
                     workspace().notifications().report(outcome.error());
                 done(outcome);
                 showState();
                 read();
             });
}

QString ScriptSlotsPage::replaced(int slot, const ActionReply &reply, const QString &what) const
{
    if (reply.value(u"unchanged"_s).toBool())
        return tr("Slot %1 held this script already.").arg(slot);
    return reply.contains(u"kept"_s) ? what + u' ' + tr("What was in it is kept, and can be restored.")
                                     : what;
}

void ScriptSlotsPage::loadFrom(const QString &path)
{
    const int number = slot();
    m_result = tr("Writing slot %1…").arg(number);
    perform(u"script.load"_s, {{u"slot"_s, number}, {u"file"_s, path}, {u"keep"_s, kept().next(number)}},
            [this, number](const Result<ActionOutcome> &outcome) {
                if (!outcome) {
                    m_result = describe(outcome.error()).oneLine();
                    return;
                }
                kept().settle(number);
                m_result = replaced(number, outcome->reply,
                                    tr("Slot %1 holds the script, read back byte for byte: %2.")
                                        .arg(number)
                                        .arg(scriptBytes(outcome->reply.value(u"bytes"_s).toInt())));
            });
}

void ScriptSlotsPage::saveTo(const QString &path)
{
    const int number = slot();
    m_result = tr("Reading slot %1…").arg(number);
    perform(u"script.save"_s, {{u"slot"_s, number}, {u"file"_s, path}},
            [this, number](const Result<ActionOutcome> &outcome) {
                m_result = outcome ? tr("The script in slot %1 is saved: %2.")
                                         .arg(number)
                                         .arg(scriptBytes(outcome->reply.value(u"bytes"_s).toInt()))
                                   : describe(outcome.error()).oneLine();
            });
}

void ScriptSlotsPage::erase()
{
    const int number = slot();
    m_result = tr("Erasing slot %1…").arg(number);
    perform(u"script.erase"_s, {{u"slot"_s, number}, {u"keep"_s, kept().next(number)}},
            [this, number](const Result<ActionOutcome> &outcome) {
                if (!outcome) {
                    m_result = describe(outcome.error()).oneLine();
                    return;
                }
                kept().settle(number);
                m_result = replaced(number, outcome->reply, tr("Slot %1 is empty now.").arg(number));
            });
}

void ScriptSlotsPage::askToRun(bool isFollowed)
{
    const std::optional<bool> run = workspace().motorsRunning();
    const QString motors = !run ? tr("The motors may be running.")
        : *run                  ? tr("The motors are running.")
                                : tr("The motors are off now; a script can start them.");
    QDialog *panel = askInPanel(
        {tr("Run script %1?").arg(slot()),
         tr("Nobody can read in a compiled script what it does: it may turn the camera, start or stop motors "
            "and change what is in use.")
             + u' ' + motors + u' ' + tr("Keep hands and cables clear."),
         {{tr("Run script %1").arg(slot()), [this, isFollowed] { isFollowed ? follow() : this->run(); },
           true}},
         tr("Do not run it")},
        this);
    connect(&workspace().client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

void ScriptSlotsPage::run()
{
    const int number = slot();
    m_result.clear();
    perform(u"script"_s, {{u"slot"_s, number}, {u"mode"_s, 1}},
            [this, number](const Result<ActionOutcome> &outcome) {
                if (!outcome)
                    m_result = describe(outcome.error()).oneLine();
                else if (outcome->reply.value(u"running"_s).toBool())
                    tellRunning(tr("Script %1 runs").arg(number),
                                tr("The board has told that it began. Its end is not watched from here."));
                else
                    tellRunning(tr("Script %1 was started").arg(number),
                                tr("The board confirms it, and nothing shows whether it runs."));
            });
}

void ScriptSlotsPage::follow()
{
    const int number = slot();
    m_result.clear();
    m_followed = number;
    m_command = 0;
    m_commands->clear();
    m_since.start();
    tellRunning(tr("Script %1 is started…").arg(number), {});
    perform(u"script.follow"_s, {{u"slot"_s, number}},
            [this, number](const Result<ActionOutcome> &outcome) { onFollowed(number, outcome); });
}

void ScriptSlotsPage::tellNothing()
{
    tellRunning(tr("Not known"), tr("No command tells whether a script runs that was not started here."));
}

void ScriptSlotsPage::onProgress(const Progress &progress)
{
    if (m_followed == 0 || progress.step != u"script"_s)
        return;
    const int before = std::exchange(m_command, int(progress.values.value(u"command"_s)));
    if (m_command != before) {
        const QString time = numberText(double(m_since.elapsed()) / 1000, 1);
        m_commands->addItem(tr("%1 s: command %2").arg(time).arg(m_command));
        if (m_commands->count() > kMostCommands)
            delete m_commands->takeItem(0);
        m_commands->scrollToBottom();
    }
    const double silent = progress.values.value(u"silent"_s);
    tellRunning(tr("Script %1: command %2").arg(m_followed).arg(m_command),
                silent < kSilentFor
                    ? tr("The board tells each command that it carries out.")
                    : tr("No other command for %n second(s): it waits, or has ended.", nullptr, int(silent)));
}

void ScriptSlotsPage::onFollowed(int slot, const Result<ActionOutcome> &outcome)
{
    const QString last = tr("Its last command was %1.").arg(m_command);
    if (outcome && outcome->reply.value(u"ended"_s).toBool())
        tellRunning(tr("Script %1 has ended").arg(slot), last + u' ' + tr("The board has told so."));
    else if (outcome)
        tellRunning(tr("Script %1 tells nothing any more").arg(slot),
                    last + u' ' + tr("It has ended, or waits: stop it before you rely on either."));
    else if (outcome.error().code == ErrorCode::Cancelled && outcome.error().detail.isEmpty())
        tellRunning(tr("Script %1 was not started").arg(slot), {});
    else if (outcome.error().code == ErrorCode::Cancelled)
        tellRunning(tr("Script %1 was stopped").arg(slot), last);
    else if (isLinkLoss(outcome.error()))
        tellRunning(tr("Not known"),
                    last + u' '
                        + tr("The link was lost: it may run on. Stop it once the board "
                             "is back."));
    else
        tellRunning(tr("Script %1 broke off").arg(slot), describe(outcome.error()).oneLine());
}

void ScriptSlotsPage::stop()
{
    if (m_followed > 0) {
        workspace().client().cancelJobs();
        return;
    }
    m_result.clear();
    perform(u"script.stop"_s, {{u"slot"_s, std::max(slot(), 1)}},
            [this](const Result<ActionOutcome> &outcome) {
                if (!outcome)
                    m_result = describe(outcome.error()).oneLine();
                else if (outcome->reply.value(u"stopped"_s).toBool())
                    tellRunning(tr("Stopped"), tr("The board has told that a script ended."));
                else
                    tellRunning(tr("Told to stop"),
                                tr("The board confirms it. Whether a script ran before, nothing shows."));
            });
}
