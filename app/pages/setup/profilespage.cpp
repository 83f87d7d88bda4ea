// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/profilespage.h"

#include "app/workspace/question.h"
#include "widgets/forms/celldelegate.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/typingkeeper.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"
#include "widgets/views/card.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace {

const char *const kFilter = QT_TRANSLATE_NOOP("ProfilesPage", "GimbalDesk configurations (*.json)");

}  // namespace

ProfilesPage::ProfilesPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"profiles"_s, tr("Profiles"), parent)
    , m_model(workspace.configuration())
    , m_table(new QTableView)
    , m_active(new QPushButton(tr("Make active")))
    , m_rename(new QPushButton(tr("Rename")))
    , m_copy(new QPushButton(tr("Copy onto")))
    , m_target(new QComboBox)
    , m_load(new QPushButton(tr("Load from file…")))
    , m_save(new QPushButton(tr("Save to file…")))
    , m_loadAll(new QPushButton(tr("Load all profiles…")))
{
    makeHeader();
    makeBody();
    connectAll();
    if (!workspace.configuration().isEmpty())
        m_table->selectRow(std::as_const(workspace.configuration()).board().activeProfile());
    updateButtons();
}

void ProfilesPage::makeHeader()
{
    m_loadAll->setToolTip(tr("Load everything in a file, as one edit that can be undone"));
    m_save->setToolTip(tr("Save all profiles with their unwritten changes"));
    header()->addWidget(m_loadAll);
    header()->addWidget(m_save);
}

void ProfilesPage::makeBody()
{
    m_table->setModel(&m_model);
    m_table->setAccessibleName(tr("Profiles"));
    setSelectableRows(*m_table);
    m_table->verticalHeader()->setDefaultSectionSize(36);
    m_table->setItemDelegate(new CellDelegate(workspace().theme(), m_table));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setColumnWidth(ProfileModel::NumberColumn, 56);
    m_table->setColumnWidth(ProfileModel::NameColumn, 260);
    m_table->setColumnWidth(ProfileModel::StateColumn, 120);
    m_table->setColumnWidth(ProfileModel::ChangesColumn, 160);
    m_target->setAccessibleName(tr("Profile to copy onto"));
    m_target->setMinimumContentsLength(14);
    m_active->setToolTip(tr("The board uses this profile from now on"));
    m_copy->setToolTip(
        tr("Copy all values of the chosen profile to another one, as an edit that can be undone"));
    m_load->setToolTip(
        tr("Load one profile of a file into the chosen profile, as an edit that can be undone"));

    auto *row = new QHBoxLayout;
    row->setSpacing(Metric::kGap);
    row->addWidget(m_active);
    row->addWidget(m_rename);
    row->addSpacing(Metric::kMargin);
    row->addWidget(m_copy);
    row->addWidget(m_target);
    row->addSpacing(Metric::kMargin);
    row->addWidget(m_load);
    row->addStretch(1);
    auto *note = new QLabel(
        tr("Copying, renaming and loading are edits: nothing is on the board before you review and write. "
           "Board-wide values (sensors, motors' outputs, ports) belong to no profile and stay."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    body()->addWidget(m_table, 1);
    body()->addLayout(row);
    body()->addWidget(note);
}

void ProfilesPage::connectAll()
{
    connect(&m_model, &ProfileModel::renameRequested, &workspace().edits(), &EditStack::rename);
    connect(&m_model, &ProfileModel::nameRefused, this, &ProfilesPage::onNameRefused);
    connect(m_active, &QPushButton::clicked, this, [this] { askToUseProfile(workspace(), chosen(), this); });
    connect(m_rename, &QPushButton::clicked, this,
            [this] { m_table->edit(m_model.index(chosen(), ProfileModel::NameColumn)); });
    connect(m_copy, &QPushButton::clicked, this, [this] {
        const QStringList leftOut
            = workspace().edits().copyProfile(chosen(), m_target->currentData().toInt());
        if (!leftOut.isEmpty())
            workspace().notifications().notify(
                tr("Left out, as these values are not allowed: %1.").arg(leftOut.join(u"; "_s)),
                Notice::Attention);
    });
    connect(m_load, &QPushButton::clicked, this, [this] {
        const int profile = chosen();
        askOpenPath(this, tr("Load a profile"), tr(kFilter),
                    [this, profile](const QString &path) { loadInto(path, profile); });
    });
    connect(m_loadAll, &QPushButton::clicked, this, [this] {
        askOpenPath(this, tr("Load all profiles"), tr(kFilter), [this](const QString &path) {
            workspace().notifications().reportLoaded(workspace().applyFile(path));
        });
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        askSavePath(this, tr("Save profiles"), u"gimbal.json"_s, tr(kFilter),
                    [this](const QString &path) { saveTo(path); });
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ProfilesPage::updateButtons);
    connect(&m_model, &QAbstractItemModel::modelReset, this, [this] {
        const ConfigurationModel &shown = workspace().configuration();
        const Device *device = workspace().client().device();
        if (const ProfileAccess *profiles = device ? device->profiles() : nullptr)
            m_model.setNameLimit(profiles->profileNameBytes());
        if (!shown.isEmpty())
            m_table->selectRow(shown.board().activeProfile());
    });
    connect(&m_model, &QAbstractItemModel::dataChanged, this, &ProfilesPage::updateButtons);
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &ProfilesPage::updateButtons);
    connect(&workspace().live(), &LiveModel::heldChanged, this, &ProfilesPage::updateButtons);
    connect(&workspace().configuration(), &ConfigurationModel::changeCountChanged, this,
            &Page::changesChanged);
    new TypingKeeper(*m_table, Qt::DisplayRole,
                     [this] { return std::as_const(workspace().configuration()).board().identity().serial; });
}

// The field closes with Enter; it opens again with what was typed.
void ProfilesPage::onNameRefused(int profile, const QString &name, int limit)
{
    ErrorText text;
    text.what = tr("The name of profile %1 is too long.").arg(profile + 1);
    text.meaning = tr("“%1” has %2 bytes, the board holds %3; an accented letter counts as two.")
                       .arg(name)
                       .arg(name.toUtf8().size())
                       .arg(limit);
    text.cure = tr("Choose a shorter one.");
    workspace().notifications().report(text);
    const auto openAgain = [this, profile, name] {
        if (!m_table->hasFocus())
            return;
        const QModelIndex cell = m_model.index(profile, ProfileModel::NameColumn);
        m_table->edit(cell);
        if (auto *line = qobject_cast<QLineEdit *>(QApplication::focusWidget()))
            line->setText(name);
    };
    QTimer::singleShot(0, this, openAgain);
}

int ProfilesPage::chosen() const
{
    const auto rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : rows.first().row();
}

bool ProfilesPage::hasChanges() const
{
    return workspace().configuration().namesChanged();
}

void ProfilesPage::showName(int profile)
{
    const QModelIndex name = m_model.index(profile, ProfileModel::NameColumn);
    m_table->setCurrentIndex(name);
    m_table->scrollTo(name);
    m_table->setFocus();
}

void ProfilesPage::updateButtons()
{
    const ConfigurationModel &model = workspace().configuration();
    const int profile = chosen();
    const bool any = profile >= 0 && !model.isEmpty();
    m_active->setEnabled(any && workspace().client().isConnected() && !workspace().live().isHeld()
                         && profile != model.board().activeProfile());
    for (QPushButton *button : {m_copy, m_load})
        button->setEnabled(any);
    const bool isNameless = any && !model.canRename();
    m_rename->setEnabled(any && !isNameless);
    m_rename->setToolTip(isNameless
                             ? tr("The names could not be read. The board takes all of them at once, so the "
                                  "others would be erased: read the board again (F5) first.")
                             : tr("Change the name (F2)"));
    for (QPushButton *button : {m_loadAll, m_save})
        button->setEnabled(!model.isEmpty());
    m_target->setEnabled(any);
    const int before = m_target->currentData().toInt();
    const QSignalBlocker blocker(m_target);
    m_target->clear();
    for (int other = 0; any && other < model.board().identity().profileCount; ++other) {
        if (other != profile)
            m_target->addItem(u"%1  %2"_s.arg(other + 1).arg(profileLabel(model.edited(), other)), other);
    }
    m_target->setCurrentIndex(std::max(0, m_target->findData(before)));
}

void ProfilesPage::loadFrom(const QString &path, int from, int to)
{
    workspace().notifications().reportLoaded(workspace().applyFile(path, from, to));
}

void ProfilesPage::loadInto(const QString &path, int profile)
{
    const auto file = workspace().loadFile(path);
    if (!workspace().notifications().reportLoaded(file))
        return;
    auto *dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Load into profile %1").arg(profile + 1));
    auto *list = new QListWidget;
    list->setAccessibleName(tr("Profiles of the file"));
    for (int i = 0; i < file->configuration.identity().profileCount; ++i)
        list->addItem(u"%1  %2"_s.arg(i + 1).arg(profileLabel(file->configuration, i)));
    list->setCurrentRow(std::min(profile, list->count() - 1));
    auto *text = new QLabel(tr("Which profile of %1?").arg(QFileInfo(path).fileName()));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *load = buttons->addButton(tr("Load"), QDialogButtonBox::AcceptRole);
    load->setDefault(true);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(list);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(list, &QListWidget::itemActivated, dialog, &QDialog::accept);
    connect(dialog, &QDialog::accepted, this,
            [this, path, list, profile] { loadFrom(path, list->currentRow(), profile); });
    openPanel(*dialog);
}

void ProfilesPage::saveTo(const QString &path)
{
    workspace().notifications().reportSaved(workspace().saveFile(path), path, workspace().lacking());
}
