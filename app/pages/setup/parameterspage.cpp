// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/parameterspage.h"

#include "widgets/forms/helpcard.h"
#include "widgets/forms/parameterbox.h"
#include "widgets/forms/parameterdelegate.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/typingkeeper.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/theme/tablelook.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace {

/// The table shows the same rows as the form.
class RowFilter final : public QSortFilterProxyModel
{
public:
    using Accept = std::function<bool(int)>;
    RowFilter(Accept accept, QObject *parent)
        : QSortFilterProxyModel(parent)
        , m_accept(std::move(accept))
    {
    }
    void refilter() { invalidateFilter(); }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &) const override { return m_accept(row); }

private:
    Accept m_accept;
};

constexpr int kGroupsColumn = 168;
constexpr int kWidestGroups = 260;
constexpr int kHelpColumn = 248;
constexpr int kNarrowColumn = 196;
constexpr int kNarrowPage = 1000;
constexpr int kShownTyped = 40;  // characters of what was typed, in a message about it

QPushButton *makeChip(const QString &text)
{
    auto *chip = new QPushButton(text);
    chip->setObjectName(u"chip"_s);
    chip->setCheckable(true);
    return chip;
}

}  // namespace

ParametersPage::ParametersPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"parameters"_s, tr("Parameters"), parent)
    , m_model(workspace.configuration(), &workspace.edits().refused())
    , m_proxy(new RowFilter(
          [this](int row) {
              return matches(this->workspace().configuration().edited().parameters().at(row));
          },
          this))
    , m_groups(new QListWidget)
    , m_scroll(new QScrollArea)
    , m_form(new ParameterForm(workspace.configuration(), workspace.edits()))
    , m_help(new HelpCard(workspace.configuration()))
    , m_table(new QTableView)
    , m_views(new QStackedWidget)
    , m_search(new QLineEdit)
    , m_level(new QComboBox)
    , m_onlyChanged(makeChip(tr("Changed")))
    , m_onlyNonDefault(makeChip(tr("Not default")))
    , m_onlyRed(makeChip(tr("⚠ Risk")))
    , m_asTable(makeChip(tr("Table")))
    , m_nothing(new QLabel(tr("Nothing matches. Change the search, the filters or the level.")))
    , m_otherProfile(new QPushButton)
    , m_left(new QVBoxLayout)
    , m_row(new QHBoxLayout)
{
    makeHeader();
    makeBody();
    connectAll();
    onBoard();
}

void ParametersPage::makeHeader()
{
    m_level->addItem(tr("Basic"), int(ViewLevel::Basic));
    m_level->addItem(tr("Advanced"), int(ViewLevel::Advanced));
    m_level->addItem(tr("Expert"), int(ViewLevel::Expert));
    m_level->setCurrentIndex(1);
    m_level->setAccessibleName(tr("How much to show"));
    m_level->setToolTip(tr("How much to show"));
    m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search parameters"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(172);
    m_search->setToolTip(tr("Looks in names, keys and help of all parameters"));
    for (QWidget *widget : {static_cast<QWidget *>(m_onlyChanged), static_cast<QWidget *>(m_onlyNonDefault),
                            static_cast<QWidget *>(m_onlyRed), static_cast<QWidget *>(m_asTable),
                            static_cast<QWidget *>(m_level), static_cast<QWidget *>(m_search)})
        header()->addWidget(widget);
}

void ParametersPage::makeBody()
{
    m_groups->setAccessibleName(tr("Groups"));
    m_groups->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *holder = new QWidget;
    auto *holderLayout = new QVBoxLayout(holder);
    holderLayout->setContentsMargins(Metric::kGap, 0, Metric::kGap, 0);
    m_nothing->setObjectName(u"muted"_s);
    m_otherProfile->setObjectName(u"otherProfile"_s);
    m_otherProfile->hide();
    holderLayout->addWidget(m_nothing);
    holderLayout->addWidget(m_form, 1);
    m_scroll->setWidget(holder);
    m_proxy->setSourceModel(&m_model);
    m_table->setModel(m_proxy);
    m_table->setAccessibleName(tr("All parameters"));
    m_table->setItemDelegate(
        new ParameterDelegate(workspace().configuration(), workspace().theme(), m_table));
    new TypingKeeper(*m_table, ParameterModel::IdRole,
                     [this] { return std::as_const(workspace().configuration()).board().identity().serial; });
    setPlainRows(*m_table);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_views->addWidget(m_scroll);
    m_views->addWidget(m_table);
    m_left->setSpacing(12);
    m_left->addWidget(m_groups, 1);
    m_left->addWidget(m_otherProfile);  // where it moves no field
    m_row->setSpacing(12);
    m_row->addLayout(m_left);
    m_row->addWidget(m_views, 1);
    m_row->addWidget(m_help);
    body()->addLayout(m_row, 1);
    arrange(false);
}

void ParametersPage::connectAll()
{
    connect(m_search, &QLineEdit::textChanged, this, &ParametersPage::refilter);
    connect(m_level, &QComboBox::currentIndexChanged, this, [this] {
        updateGroupMarks();
        refilter();
    });
    for (QPushButton *chip : {m_onlyChanged, m_onlyNonDefault, m_onlyRed})
        connect(chip, &QPushButton::toggled, this, &ParametersPage::refilter);
    connect(m_asTable, &QPushButton::toggled, this, [this](bool on) {
        m_views->setCurrentIndex(on ? 1 : 0);
        refilter();
        if (on)
            m_table->resizeColumnsToContents();
    });
    connect(m_groups, &QListWidget::currentRowChanged, this, &ParametersPage::refilter);
    connect(m_form, &ParameterForm::parameterFocused, m_help, &HelpCard::show);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &index) {
                if (index.isValid())
                    m_help->show(index.data(ParameterModel::IdRole).toInt());
            });
    connect(&m_model, &ParameterModel::editRequested, this, [this](int parameter, double raw) {
        workspace().edits().edit(parameter, workspace().configuration().shownProfile(), raw);
    });
    connect(&m_model, &ParameterModel::refused, this, &ParametersPage::onRefused);
    connect(&workspace().configuration(), &ConfigurationModel::boardReset, this, &ParametersPage::onBoard);
    connect(&workspace().configuration(), &ConfigurationModel::valueChanged, this,
            &ParametersPage::updateGroupMarks);
    connect(&workspace().configuration(), &ConfigurationModel::shownProfileChanged, this,
            &ParametersPage::updateGroupMarks);
    connect(m_otherProfile, &QPushButton::clicked, this, [this] {
        ConfigurationModel &model = workspace().configuration();
        model.setShownProfile(std::as_const(model).board().activeProfile());
    });
    connect(&workspace().configuration(), &ConfigurationModel::changeCountChanged, this, [this] {
        updateGroupMarks();
        emit changesChanged();
    });
    new QShortcut(QKeySequence::Find, this, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
}

// Room for the names of the groups with what may be changed in them, before it is: with the first edit no
// field moves.
void ParametersPage::fitGroups()
{
    QFont bold = m_groups->font();
    bold.setBold(true);
    const QString marks = workspace().profileCount() > 1 ? u"  • P1: 88, P2: 88"_s : u"  • 88"_s;
    int names = 0;
    for (int i = 0; i < m_groups->count(); ++i) {
        const QByteArray group = m_groups->item(i)->data(Qt::UserRole).toString().toLatin1();
        names = std::max(names, QFontMetrics(bold).horizontalAdvance(tableText(group.constData()) + marks));
    }
    constexpr int kAround = 16;  // of the text in its row
    m_groups->setFixedWidth(
        m_narrow ? kNarrowColumn
                 : std::clamp(names + kAround + 2 * m_groups->frameWidth(), kGroupsColumn, kWidestGroups));
}

// A narrow page has no room for three columns: the help card moves below the groups.
void ParametersPage::arrange(bool narrow)
{
    m_narrow = narrow;
    fitGroups();
    m_help->setFixedWidth(narrow ? kNarrowColumn : kHelpColumn);
    m_left->removeWidget(m_help);
    m_row->removeWidget(m_help);
    if (narrow)
        m_left->addWidget(m_help, 1);
    else
        m_row->addWidget(m_help);
}

void ParametersPage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    if (const bool narrow = width() < kNarrowPage; narrow != m_narrow)
        arrange(narrow);
}

bool ParametersPage::hasChanges() const
{
    return workspace().configuration().changeCount() > 0;
}

bool ParametersPage::matches(const ParameterSpec &spec) const
{
    const ConfigurationModel &model = workspace().configuration();
    const int profile = model.shownProfile();
    const QString words = m_search->text().trimmed().toLower();
    const bool filtered = !words.isEmpty() || m_onlyChanged->isChecked() || m_onlyNonDefault->isChecked()
        || m_onlyRed->isChecked();
    const auto value = model.value(spec, profile);
    if (!value)
        return false;
    // A search or a filter looks everywhere, at every level; the group list is for browsing.
    if (!filtered) {
        if (int(spec.row->level) > m_level->currentData().toInt())
            return false;
        const QListWidgetItem *group = m_groups->currentItem();
        return !group || group->data(Qt::UserRole).toString() == QLatin1String(spec.row->group);
    }
    if (m_onlyChanged->isChecked() && !model.isChanged(spec, profile))
        return false;
    if (m_onlyNonDefault->isChecked() && (spec.row->state || *value == spec.defaultRaw))
        return false;
    if (m_onlyRed->isChecked() && spec.row->risk != Risk::Red)
        return false;
    const QString text = parameterSearchText(spec);
    const auto parts = words.split(u' ', Qt::SkipEmptyParts);
    return std::all_of(parts.begin(), parts.end(),
                       [&text](const QString &part) { return text.contains(part); });
}

void ParametersPage::onBoard()
{
    const int row = std::max(0, m_groups->currentRow());
    const QSignalBlocker blocker(m_groups);
    m_groups->clear();
    const ConfigurationModel &model = workspace().configuration();
    if (!model.isEmpty()) {
        for (const char *group : model.board().parameters().groups()) {
            if (qstrcmp(group, "Board state") == 0)
                continue;
            auto *item = new QListWidgetItem(tableText(group), m_groups);
            item->setData(Qt::UserRole, QString::fromLatin1(group));
        }
        m_groups->setCurrentRow(std::min(row, m_groups->count() - 1));
    }
    updateGroupMarks();
    refilter();
}

void ParametersPage::refilter()
{
    const ConfigurationModel &model = workspace().configuration();
    QList<int> shown;
    if (!model.isEmpty() && m_views->currentIndex() == 0) {
        // In the order of the groups, so that each has one heading.
        for (const char *group : model.board().parameters().groups()) {
            for (const ParameterSpec &spec : model.edited().parameters().all()) {
                if (qstrcmp(spec.row->group, group) == 0 && matches(spec))
                    shown.append(spec.id);
            }
        }
    }
    if (m_views->currentIndex() == 0) {
        std::vector<NotchFilter> filters;
        const Device *tables = workspace().tables();
        for (const Axis axis : kAxes) {
            const auto own = tables && tables->notchFilters() ? tables->notchFilters()->notchesOf(axis)
                                                              : std::vector<NotchFilter>();
            filters.insert(filters.end(), own.begin(), own.end());
        }
        m_form->setFilters(filters);
        m_form->setParameters(shown);
        if (!shown.contains(m_help->parameter()))
            m_help->show(-1);  // of a field that is not here
        m_nothing->setVisible(shown.isEmpty() && !model.isEmpty());
        m_scroll->verticalScrollBar()->setValue(0);
    }
    static_cast<RowFilter *>(m_proxy)->refilter();
}

void ParametersPage::updateGroupMarks()
{
    const ConfigurationModel &model = workspace().configuration();
    if (model.isEmpty())
        return;
    QSet<QString> offered;
    for (const ParameterSpec &spec : model.board().parameters().all()) {
        if (int(spec.row->level) <= m_level->currentData().toInt())
            offered.insert(QLatin1String(spec.row->group));
    }
    // Of each group, by profile; kAllProfiles for values of the board as a whole.
    QHash<QString, QMap<int, int>> counts;
    for (const ParameterChange &change : model.changes()) {
        const bool ofProfile = change.spec->row->scope == Scope::Profile && workspace().profileCount() > 1;
        const int profile = ofProfile ? change.profile : ConfigurationModel::kAllProfiles;
        ++counts[QLatin1String(change.spec->row->group)][profile];
    }
    for (int i = 0; i < m_groups->count(); ++i) {
        QListWidgetItem *item = m_groups->item(i);
        const QString group = item->data(Qt::UserRole).toString();
        const QMap<int, int> count = counts.value(group);
        QString name = tableText(group.toLatin1().constData());
        QStringList shorts;
        for (auto each = count.begin(); each != count.end(); ++each) {
            shorts.append(each.key() < 0 ? QString::number(each.value())
                                         : tr("P%1: %2").arg(each.key() + 1).arg(each.value()));
        }
        if (!shorts.isEmpty())
            name += u"  • "_s + shorts.join(u", "_s);
        item->setText(name);
        item->setToolTip(changePlaces(model, count).join(u'\n'));
        QFont font = item->font();
        font.setBold(!shorts.isEmpty());
        item->setFont(font);
        item->setHidden(count.isEmpty() && !offered.contains(group));
    }
    fitGroups();
    // A level that leaves nothing of the group that is shown goes on to the first that it leaves.
    for (int i = 0; i < m_groups->count() && m_groups->currentItem() && m_groups->currentItem()->isHidden();
         ++i) {
        if (!m_groups->item(i)->isHidden())
            m_groups->setCurrentRow(i);
    }
    updateProfileNote();
}

void ParametersPage::onRefused(int parameter, const QString &text)
{
    const ParameterSpec &spec = workspace().configuration().edited().parameters().at(parameter);
    const QString range = parameterRangeText(spec);
    workspace().notifications().notify(
        range.isEmpty()
            ? tr("%1: “%2” is no value of it. The value is as before.")
                  .arg(parameterLabel(spec), text.left(kShownTyped))
            : tr("%1: “%2” is no value of it (%3). The value is as before.")
                  .arg(parameterLabel(spec), text.left(kShownTyped), ParameterBox(spec).rangeSentence(text)),
        Notice::Attention);
}

// With a board, the profile in use and the one that is shown are two things.
void ParametersPage::updateProfileNote()
{
    const ConfigurationModel &model = workspace().configuration();
    const int shown = model.shownProfile();
    const int used = model.board().activeProfile();
    m_otherProfile->setVisible(workspace().client().isConnected() && shown != used
                               && workspace().profileCount() > 1);
    const auto name = [this, &model](int profile) {
        return m_otherProfile->fontMetrics().elidedText(profileLabel(model.edited(), profile), Qt::ElideRight,
                                                        kGroupsColumn / 2);
    };
    m_otherProfile->setText(
        tr("This is %1.\nThe board uses %2:\nshow that one.").arg(name(shown), name(used)));
}

void ParametersPage::showGroup(int row)
{
    m_groups->setCurrentRow(row);
}

void ParametersPage::showParameter(const QString &key)
{
    const ConfigurationModel &model = workspace().configuration();
    const ParameterSpec *spec = model.isEmpty() ? nullptr : model.edited().parameters().find(key);
    if (!spec)
        return;
    m_search->clear();
    for (QPushButton *chip : {m_onlyChanged, m_onlyNonDefault, m_onlyRed, m_asTable})
        chip->setChecked(false);
    m_level->setCurrentIndex(std::max(m_level->currentIndex(), int(spec->row->level)));
    for (int i = 0; i < m_groups->count(); ++i) {
        if (m_groups->item(i)->data(Qt::UserRole).toString() == QLatin1String(spec->row->group))
            m_groups->setCurrentRow(i);
    }
    focusEditor(spec->id);
}

void ParametersPage::reveal(const ParameterSpec &spec)
{
    const QModelIndex row = m_proxy->mapFromSource(m_model.index(spec.id, ParameterModel::ValueColumn));
    if (m_views->currentIndex() == 1 && row.isValid()) {
        m_table->setCurrentIndex(row);
        m_table->scrollTo(row);
        m_table->setFocus();
    } else if (m_views->currentIndex() == 0 && m_form->editor(spec.id)) {
        focusEditor(spec.id);
    } else {
        showParameter(spec.key);
    }
}

void ParametersPage::focusEditor(int parameter)
{
    ValueEditor *editor = m_form->editor(parameter);
    if (!editor)
        return;
    editor->control()->setFocus();
    // Fields that were made just now have no places yet.
    QTimer::singleShot(0, editor, [this, editor] { m_scroll->ensureWidgetVisible(editor); });
}
