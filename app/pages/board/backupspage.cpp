// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/backupspage.h"

#include "app/pages/board/boardnamedialog.h"
#include "app/pages/board/sharedialog.h"
#include "app/workspace/question.h"
#include "protocol/base/filefault.h"
#include "widgets/forms/panel.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"
#include "widgets/views/card.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxShown = 60;  // snapshots listed; older ones stay on the disk
constexpr int kMaxDifferences = 500;

void prepare(QTableWidget *table, const QStringList &heads)
{
    table->setColumnCount(int(heads.size()));
    table->setHorizontalHeaderLabels(heads);
    setSelectableRows(*table);
    table->setAlternatingRowColors(true);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->horizontalHeader()->setStretchLastSection(true);
}

// Reasons are stored in English, the language of files.
// Actions are named as they are on their page, when the board (or its tables) is there.
QString reasonText(const QString &reason, const Device *device)
{
    if (reason == u"by the operator"_s)
        return BackupsPage::tr("by the operator");
    if (reason == u"by the operator, in use"_s)
        return BackupsPage::tr("by the operator, of what was in use");
    if (reason == u"before the first write"_s)
        return BackupsPage::tr("before the first write");
    // Version 0.1 called them unsaved.
    if (reason == u"unwritten edits of an earlier run"_s || reason == u"unsaved edits of an earlier run"_s)
        return BackupsPage::tr("unwritten edits of an earlier run");
    if (!reason.startsWith(u"before "_s))
        return reason;
    const QString key = reason.mid(7);
    if (device) {
        for (const ActionSpec &action : device->actions()) {
            if (key == QLatin1String(action.key))
                return BackupsPage::tr("before “%1”").arg(tableText(action.label));
        }
    }
    return BackupsPage::tr("before the action %1").arg(key);
}

}  // namespace

BackupsPage::BackupsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"backups"_s, tr("Backups"), parent)
    , m_table(new QTableWidget)
    , m_differences(new QTableWidget)
    , m_summary(new QLabel)
    , m_take(new QPushButton(tr("Take a snapshot now")))
    , m_restore(new QPushButton(tr("Restore as edits")))
    , m_export(new QPushButton(tr("Export…")))
    , m_board(new QLabel)
    , m_which(new QPushButton(tr("Which board…")))
    , m_lacking(new QLabel(tr("A snapshot holds no calibration of the board's sensors: restoring one leaves "
                              "that as it is.")))
{
    makeHeader();
    makeBody();
    connectAll();
}

void BackupsPage::makeHeader()
{
    m_take->setObjectName(u"primary"_s);
    auto *load = new QPushButton(tr("Load a file…"));
    load->setToolTip(
        tr("Put a file's values into the forms; nothing is on the board before you review and write"));
    auto *saveAs = new QPushButton(tr("Save to a file…"));
    saveAs->setToolTip(tr("Save the values as they are shown, edits included"));
    connect(load, &QPushButton::clicked, this, [this] {
        askOpenPath(this, tr("Load a configuration"), workspace().openFilter(), [this](const QString &path) {
            workspace().notifications().reportLoaded(workspace().applyFile(path));
        });
    });
    connect(saveAs, &QPushButton::clicked, this, [this] {
        askSavePath(this, tr("Save the configuration"), u"gimbal.json"_s, workspace().configurationFilter(),
                    [this](const QString &path) {
                        workspace().notifications().reportSaved(workspace().saveFile(path), path,
                                                                workspace().lacking());
                    });
    });
    header()->addWidget(load);
    auto *share = new QPushButton(tr("Share…"));
    share->setObjectName(u"share"_s);
    share->setToolTip(tr("All values as one picture"));
    connect(share, &QPushButton::clicked, this, [this] {
        if (workspace().configuration().isEmpty())
            return;
        auto *dialog = new ShareDialog(workspace(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        openPanel(*dialog);
    });
    for (QPushButton *button : {load, saveAs, share, m_take})
        header()->addWidget(button);
}

void BackupsPage::makeBody()
{
    m_restore->setToolTip(
        tr("Put the snapshot's values into the forms; nothing is on the board before you review and write"));
    m_export->setToolTip(tr("Copy the snapshot to a file of your choice"));
    prepare(m_table, {tr("Taken"), tr("Why"), tr("File")});
    m_table->setAccessibleName(tr("Snapshots of this board"));
    m_table->setColumnWidth(0, 190);
    m_table->setColumnWidth(1, 400);
    prepare(m_differences, {tr("Parameter"), tr("Profile"), tr("Snapshot"), tr("Now")});
    m_differences->setAccessibleName(tr("Differences between the snapshot and now"));
    m_differences->setColumnWidth(0, 300);
    m_differences->setColumnWidth(1, 90);
    m_differences->setColumnWidth(2, 180);
    m_summary->setWordWrap(true);
    auto *card = new Card(tr("What differs from now"));
    auto *line = new QHBoxLayout;
    line->setSpacing(Metric::kGap);
    line->addWidget(m_summary, 1);
    line->addWidget(m_export);
    line->addWidget(m_restore);
    card->content()->addLayout(line);
    card->content()->addWidget(m_lacking);
    card->content()->addWidget(m_differences, 1);
    m_board->setWordWrap(true);
    m_which->setToolTip(tr("Say which board this is"));
    auto *board = new QHBoxLayout;
    board->setSpacing(Metric::kGap);
    board->addWidget(m_board, 1);
    board->addWidget(m_which);
    m_lacking->setWordWrap(true);
    m_lacking->setObjectName(u"muted"_s);
    body()->addLayout(board);
    body()->addWidget(m_table, 1);
    body()->addWidget(card, 1);
}

void BackupsPage::connectAll()
{
    connect(m_take, &QPushButton::clicked, &workspace(), &Workspace::takeSnapshot);
    connect(m_restore, &QPushButton::clicked, this, [this] {
        if (workspace().naming().isNeeded() && !workspace().naming().isCertain()
            && !workspace().naming().name().isEmpty())
            askBeforeRestoring();
        else
            restore();
    });
    connect(m_export, &QPushButton::clicked, this, [this] {
        const QString from = chosenPath();
        askSavePath(this, tr("Export snapshot"), u"snapshot.json"_s, tr("GimbalDesk configurations (*.json)"),
                    [this, from](const QString &to) {
                        const auto file = workspace().loadFile(from);
                        workspace().notifications().reportSaved(
                            copyWhole(from, to, FileKind::Configuration), to,
                            file ? missingText(file->configuration, file->configuration.missing())
                                 : QString());
                    });
    });
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &BackupsPage::showDifferences);
    connect(m_which, &QPushButton::clicked, this, &BackupsPage::askName);
    connect(&workspace().naming(), &BoardNaming::asked, this, &BackupsPage::askWhatIsOpen);
    connect(&workspace().naming(), &BoardNaming::changed, this, &BackupsPage::reload);
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &BackupsPage::reload);
    connect(&workspace(), &Workspace::snapshotTaken, this, &BackupsPage::reload);
    connect(&workspace().configuration(), &ConfigurationModel::boardReset, this, &BackupsPage::reload);
    connect(&workspace().configuration(), &ConfigurationModel::storedChanged, this,
            &BackupsPage::showDifferences);
    connect(&workspace().configuration(), &ConfigurationModel::changeCountChanged, this, [this] {
        if (isVisible())
            showDifferences();
    });
}

void BackupsPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    reload();
    askWhatIsOpen();
}

void BackupsPage::askName()
{
    auto *dialog = new BoardNameDialog(workspace(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    openPanel(*dialog);
}

void BackupsPage::restore()
{
    workspace().notifications().reportLoaded(workspace().applyFile(chosenPath()));
    showDifferences();
}

// What fits one drone can make another one that looks the same turn over.
void BackupsPage::askBeforeRestoring()
{
    const QString name = workspace().naming().name();
    const auto take = [this, name] {
        if (const auto said = workspace().naming().choose(name); !said)
            workspace().notifications().report(said.error());
        else
            restore();
    };
    QDialog *panel
        = askInPanel({tr("Is this the same board?"),
                      tr("The snapshot is of “%1”. The board that is connected looks the same and "
                         "has no serial number: it may be another one.")
                          .arg(name),
                      {{tr("It is “%1”").arg(name), take}, {tr("It is another one…"), [this] { askName(); }}},
                      tr("Do not restore")},
                     this);
    connect(&workspace().client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

void BackupsPage::askWhatIsOpen()
{
    if (isVisible() && workspace().naming().takeQuestion())
        askName();
}

QString BackupsPage::chosenPath() const
{
    const auto items = m_table->selectedItems();
    return items.isEmpty() ? QString()
                           : m_table->item(items.first()->row(), 0)->data(Qt::UserRole).toString();
}

bool BackupsPage::hasCalibration() const
{
    const auto actions
        = workspace().tables() ? workspace().tables()->actions() : std::span<const ActionSpec>();
    return std::any_of(actions.begin(), actions.end(), [](const ActionSpec &action) {
        return QLatin1String(action.key).startsWith(u"calibrate."_s);
    });
}

void BackupsPage::reload()
{
    if (!isVisible())
        return;
    const ConfigurationModel &model = workspace().configuration();
    const QString before = chosenPath();
    const BoardNaming &naming = workspace().naming();
    m_board->setText(
        naming.name().isEmpty() ? tr("This board has no serial number and no name yet.")
            : naming.isCertain()
            ? tr("Board “%1”. It has no serial number.").arg(naming.name())
            : tr("Taken for “%1”, a board that looks the same. It has no serial number.").arg(naming.name()));
    m_board->setVisible(naming.isNeeded());
    m_which->setVisible(naming.isNeeded());
    m_lacking->setVisible(hasCalibration());
    m_table->setRowCount(0);
    m_take->setEnabled(!model.isEmpty());
    const QStringList paths
        = model.isEmpty() ? QStringList() : workspace().history().snapshots(model.board().identity().serial);
    for (const QString &path : paths.mid(0, kMaxShown)) {
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        const QDateTime time = BoardHistory::timeOf(path).toLocalTime();
        auto *when = new QTableWidgetItem(dateText(time));
        when->setData(Qt::UserRole, path);
        const auto file = workspace().loadFile(path);
        m_table->setItem(row, 0, when);
        QString reason = file ? reasonText(file->reason, workspace().tables()) : tr("damaged");
        if (file && !file->configuration.missing().empty())
            reason = tr("%1 (incomplete)").arg(reason);
        m_table->setItem(row, 1, new QTableWidgetItem(reason));
        auto *name = new QTableWidgetItem(QFileInfo(path).fileName());
        name->setToolTip(path);
        m_table->setItem(row, 2, name);
        if (path == before)
            m_table->selectRow(row);
    }
    if (chosenPath().isEmpty() && m_table->rowCount() > 0)
        m_table->selectRow(0);
    showDifferences();
}

void BackupsPage::showDifferences()
{
    const QString path = chosenPath();
    const ConfigurationModel &model = workspace().configuration();
    m_differences->setRowCount(0);
    m_restore->setEnabled(false);
    m_export->setEnabled(!path.isEmpty());
    if (path.isEmpty() || model.isEmpty()) {
        m_summary->setText(
            tr("No snapshot yet. One is taken before the first write to a board, and before each action that "
               "writes."));
        return;
    }
    const auto file = workspace().loadFile(path);
    if (!file) {
        m_summary->setText(describe(file.error()).oneLine());
        return;
    }
    QStringList skipped;
    // What the board holds; what is only an edit yet would hide how it differs.
    const Configuration &board = model.board();
    const Configuration wanted = applied(board, *file, skipped);
    const auto changes = board.changesTo(wanted);
    const bool names = board.hasOtherNames(wanted);
    const auto blocks = board.dataChangesTo(wanted);
    QStringList ignored;
    const Configuration restored = applied(model.edited(), *file, ignored);
    m_restore->setEnabled(!model.edited().changesTo(restored).empty()
                          || !model.edited().dataChangesTo(restored).empty()
                          || model.edited().hasOtherNames(restored));
    std::vector<MissingPart> missing = file->configuration.missing();
    missing.insert(missing.end(), board.missing().begin(), board.missing().end());
    QString text = !changes.empty() ? tr("%n value(s) differ.", nullptr, int(changes.size()))
        : missing.empty()           ? tr("All values are the same.")
                                    : tr("All values that could be compared are the same.");
    if (!missing.empty())
        text += u' ' + tr("Not known: %1.").arg(missingText(model.edited(), missing));
    if (!skipped.isEmpty())
        text += u' '
            + tr("Left out, as this board does not take them: %1.").arg(withNumbers(skipped.join(u"; "_s)));
    for (const DataChange &change : blocks)
        text += u' ' + tr("%1 differ.").arg(tableText(change.spec->data));
    if (names)
        text += u' ' + tr("Profile names differ.");
    if (model.changeCount() > 0)
        text += u' '
            + tr("Compared with what the board holds; %n unwritten change(s) are left aside.", nullptr,
                 model.changeCount());
    m_summary->setText(text);
    for (const ParameterChange &change : changes) {
        const int row = m_differences->rowCount();
        if (row >= kMaxDifferences)
            break;
        m_differences->insertRow(row);
        const bool boardWide = change.spec->row->scope == Scope::Board;
        const QStringList cells{
            parameterLabel(*change.spec), boardWide ? tr("all") : QString::number(change.profile + 1),
            parameterValueText(*change.spec, change.to), parameterValueText(*change.spec, change.from)};
        for (int column = 0; column < cells.size(); ++column)
            m_differences->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
}
