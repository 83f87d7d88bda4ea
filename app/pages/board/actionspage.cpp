// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/actionspage.h"

#include "app/workspace/question.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/argumentform.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/card.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QTextBrowser>
#include <QTime>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

using namespace Qt::StringLiterals;

namespace {

constexpr int kListWidth = 300;

QString replyText(const QVariant &value)
{
    if (value.typeId() == QMetaType::QVariantList) {
        QStringList parts;
        for (const QVariant &element : value.toList())
            parts.append(replyText(element));
        return parts.join(u", "_s);
    }
    if (value.typeId() == QMetaType::Double)
        return shortNumberText(value.toDouble(), 7);
    if (value.typeId() == QMetaType::Bool)
        return value.toBool() ? ActionsPage::tr("yes") : ActionsPage::tr("no");
    // Words of the board's tables, which are English on the wire and in files.
    return tableText(value.toString().toUtf8().constData());
}

struct ReplyWord
{
    const char *key;
    const char *label;
};

// What an action's reply counts, by its keys of all families. What has no words here is what the board itself
// calls it, e.g. a sensor's name.
// clang-format off
constexpr ReplyWord kReplyWords[] = {
    {"armed", QT_TRANSLATE_NOOP("ActionsPage", "Armed")},
    {"band", QT_TRANSLATE_NOOP("ActionsPage", "Band")},
    {"battery.charge", QT_TRANSLATE_NOOP("ActionsPage", "Charge drawn")},
    {"battery.current", QT_TRANSLATE_NOOP("ActionsPage", "Current")},
    {"battery.level", QT_TRANSLATE_NOOP("ActionsPage", "Battery level")},
    {"battery.voltage", QT_TRANSLATE_NOOP("ActionsPage", "Battery voltage")},
    {"before", QT_TRANSLATE_NOOP("ActionsPage", "Before")},
    {"bytes", QT_TRANSLATE_NOOP("ActionsPage", "Bytes")},
    {"calibrated", QT_TRANSLATE_NOOP("ActionsPage", "Calibrated")},
    {"calibrating", QT_TRANSLATE_NOOP("ActionsPage", "Being calibrated")},
    {"changed", QT_TRANSLATE_NOOP("ActionsPage", "Values changed")},
    {"channel", QT_TRANSLATE_NOOP("ActionsPage", "Channel")},
    {"command", QT_TRANSLATE_NOOP("ActionsPage", "Last command")},
    {"confirmed", QT_TRANSLATE_NOOP("ActionsPage", "Confirmed")},
    {"cpu.load", QT_TRANSLATE_NOOP("ActionsPage", "Processor load")},
    {"cpu.temperature", QT_TRANSLATE_NOOP("ActionsPage", "Processor temperature")},
    {"data", QT_TRANSLATE_NOOP("ActionsPage", "Bytes (hex)")},
    {"devices", QT_TRANSLATE_NOOP("ActionsPage", "Devices that answer")},
    {"differing", QT_TRANSLATE_NOOP("ActionsPage", "Differences")},
    {"errors", QT_TRANSLATE_NOOP("ActionsPage", "Errors")},
    {"exposure", QT_TRANSLATE_NOOP("ActionsPage", "Exposure mode")},
    {"files", QT_TRANSLATE_NOOP("ActionsPage", "Files of the board")},
    {"files_changed", QT_TRANSLATE_NOOP("ActionsPage", "Files written or erased")},
    {"files_differing", QT_TRANSLATE_NOOP("ActionsPage", "Files that differ")},
    {"firmware", QT_TRANSLATE_NOOP("ActionsPage", "Firmware")},
    {"found", QT_TRANSLATE_NOOP("ActionsPage", "Parts of the configuration found in it")},
    {"frequency", QT_TRANSLATE_NOOP("ActionsPage", "Frequency")},
    {"iso", QT_TRANSLATE_NOOP("ActionsPage", "Sensitivity (ISO)")},
    {"late", QT_TRANSLATE_NOOP("ActionsPage", "Rows left out because they were late")},
    {"mode", QT_TRANSLATE_NOOP("ActionsPage", "Mode")},
    {"no_signal", QT_TRANSLATE_NOOP("ActionsPage", "Without a signal")},
    {"now", QT_TRANSLATE_NOOP("ActionsPage", "Now")},
    {"other_board", QT_TRANSLATE_NOOP("ActionsPage", "The copy is of another board")},
    {"other_firmware", QT_TRANSLATE_NOOP("ActionsPage", "The copy is of another firmware")},
    {"power", QT_TRANSLATE_NOOP("ActionsPage", "Power step")},
    {"power.dbm", QT_TRANSLATE_NOOP("ActionsPage", "Power")},
    {"powers", QT_TRANSLATE_NOOP("ActionsPage", "Powers it has (dBm)")},
    {"restart_needed", QT_TRANSLATE_NOOP("ActionsPage", "In use only after a restart")},
    {"restarts_in", QT_TRANSLATE_NOOP("ActionsPage", "Restarts in")},
    {"rx.dbm", QT_TRANSLATE_NOOP("ActionsPage", "Receive level")},
    {"rx.quality", QT_TRANSLATE_NOOP("ActionsPage", "Receive quality")},
    {"rows", QT_TRANSLATE_NOOP("ActionsPage", "Rows sent")},
    {"shutter", QT_TRANSLATE_NOOP("ActionsPage", "Shutter")},
    {"silent", QT_TRANSLATE_NOOP("ActionsPage", "The board has fallen silent")},
    {"state", QT_TRANSLATE_NOOP("ActionsPage", "State")},
    {"temperature", QT_TRANSLATE_NOOP("ActionsPage", "Temperature")},
    {"text", QT_TRANSLATE_NOOP("ActionsPage", "Text")},
    {"unnamed", QT_TRANSLATE_NOOP("ActionsPage", "Ranges whose meaning is documented nowhere")},
    {"voltage", QT_TRANSLATE_NOOP("ActionsPage", "Voltage")},
    {"white_balance", QT_TRANSLATE_NOOP("ActionsPage", "White balance")},
    {"written", QT_TRANSLATE_NOOP("ActionsPage", "Bytes written")},
};
// clang-format on

QString replyLabel(const QString &key)
{
    const auto word = std::find_if(std::begin(kReplyWords), std::end(kReplyWords),
                                   [&key](const ReplyWord &each) { return key == QLatin1String(each.key); });
    return word == std::end(kReplyWords) ? key : ActionsPage::tr(word->label);
}

}  // namespace

QString riskText(ActionRisk risk)
{
    switch (risk) {
    case ActionRisk::Safe: return ActionsPage::tr("Changes nothing that is stored");
    case ActionRisk::Moves:
        return ActionsPage::tr("⚠ Can move the camera or change how it is held, until the next start");
    case ActionRisk::Writes: return ActionsPage::tr("⚠ Changes permanent memory; a snapshot is taken first");
    case ActionRisk::Destroys: return ActionsPage::tr("⚠ Overwrites settings; a snapshot is taken first");
    }
    return {};
}

ActionsPage::ActionsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"actions"_s, tr("Actions"), parent)
    , m_search(new QLineEdit)
    , m_list(new QTreeWidget)
    , m_card(new Card({}))
    , m_title(new QLabel)
    , m_help(new QLabel)
    , m_risk(new QLabel)
    , m_formHolder(new QVBoxLayout)
    , m_run(new QPushButton)
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_reply(new QTextBrowser)
{
    m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search actions"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(180);
    header()->addWidget(m_search);
    m_list->setAccessibleName(tr("Actions of this board"));
    m_list->setHeaderHidden(true);
    m_list->setIndentation(14);
    m_list->setFixedWidth(kListWidth);
    QFont font = m_title->font();
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(font.pointSizeF() + 2);
    m_title->setFont(font);
    m_help->setWordWrap(true);
    m_risk->setWordWrap(true);
    m_reply->setAccessibleName(tr("Reply"));
    m_reply->setPlaceholderText(tr("The board's reply appears here."));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_run);
    buttons->addWidget(m_cancel);
    buttons->addStretch(1);
    QVBoxLayout *content = m_card->content();
    content->setSpacing(12);
    content->addWidget(m_title);
    content->addWidget(m_help);
    content->addWidget(m_risk);
    content->addLayout(m_formHolder);
    content->addLayout(buttons);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(m_card);
    right->addWidget(m_reply, 1);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_list);
    row->addLayout(right, 1);
    body()->addLayout(row, 1);

    connect(m_search, &QLineEdit::textChanged, this, &ActionsPage::refilter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ActionsPage::onChosen);
    connect(m_run, &QPushButton::clicked, this, &ActionsPage::run);
    connect(m_cancel, &QPushButton::clicked, &workspace.client(), &DeviceClient::cancelJobs);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &ActionsPage::fillList);
    connect(&workspace, &Workspace::guidedChanged, this, &ActionsPage::updateRun);
    connect(&workspace.live(), &LiveModel::heldChanged, this, &ActionsPage::updateRun);
    new QShortcut(QKeySequence::Find, this, [this] { m_search->setFocus(); });
    fillList();
}

void ActionsPage::fillList()
{
    const DeviceClient &client = workspace().client();
    updateRun();
    if (!client.isConnected())
        return;
    if (std::exchange(m_board, client.identity().serial) != client.identity().serial)
        m_reply->clear();  // another board's
    const QString before = m_action ? QString::fromLatin1(m_action->key) : QString();
    m_list->clear();
    QMap<QString, QTreeWidgetItem *> groups;
    for (const ActionSpec &action : client.device()->actions()) {
        const QString group = tableText(action.group);
        if (!groups.contains(group)) {
            auto *item = new QTreeWidgetItem(m_list, {group});
            item->setFlags(Qt::ItemIsEnabled);
            item->setExpanded(true);
            groups.insert(group, item);
        }
        auto *item = new QTreeWidgetItem(groups.value(group), {tableText(action.label)});
        item->setData(0, Qt::UserRole, QString::fromLatin1(action.key));
        item->setToolTip(0, tableText(action.help));
    }
    m_list->expandAll();
    refilter();
    if (!showAction(before) && m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(0)->child(0));
}

void ActionsPage::refilter()
{
    const auto words = m_search->text().toLower().split(u' ', Qt::SkipEmptyParts);
    for (int g = 0; g < m_list->topLevelItemCount(); ++g) {
        QTreeWidgetItem *group = m_list->topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem *item = group->child(i);
            const QString text = (group->text(0) + u' ' + item->text(0) + u' ' + item->toolTip(0) + u' '
                                  + item->data(0, Qt::UserRole).toString())
                                     .toLower();
            const bool match = std::all_of(words.begin(), words.end(),
                                           [&text](const QString &word) { return text.contains(word); });
            item->setHidden(!match);
            any |= match;
        }
        group->setHidden(!any);
    }
}

std::any ActionsPage::keep()
{
    return m_action ? std::any(QString::fromLatin1(m_action->key)) : std::any();
}

void ActionsPage::resume(const std::any &kept)
{
    showAction(std::any_cast<QString>(kept));
}

bool ActionsPage::showAction(const QString &key)
{
    for (int g = 0; g < m_list->topLevelItemCount(); ++g) {
        QTreeWidgetItem *group = m_list->topLevelItem(g);
        for (int i = 0; i < group->childCount(); ++i) {
            if (group->child(i)->data(0, Qt::UserRole).toString() == key) {
                m_list->setCurrentItem(group->child(i));
                return true;
            }
        }
    }
    return false;
}

void ActionsPage::onChosen()
{
    const QTreeWidgetItem *item = m_list->currentItem();
    const Device *device = workspace().client().device();
    if (!item || !device || item->data(0, Qt::UserRole).toString().isEmpty())
        return;
    const QString key = item->data(0, Qt::UserRole).toString();
    for (const ActionSpec &action : device->actions()) {
        if (key == QLatin1String(action.key))
            m_action = action;
    }
    delete std::exchange(m_form, nullptr);
    m_title->setText(tableText(m_action->label));
    m_help->setText(tableText(m_action->help));
    m_form = new ArgumentForm(*m_action);
    m_formHolder->addWidget(m_form);
    if (!m_action->entries.empty()) {
        auto *entry
            = qobject_cast<QComboBox *>(m_form->field(QLatin1String(m_action->arguments.front().key)));
        connect(entry, &QComboBox::currentIndexChanged, this, &ActionsPage::updateRun);
    }
    updateRun();
}

// As it is with the entry that is chosen.
std::optional<ActionSpec> ActionsPage::chosen() const
{
    if (!m_action || !m_form || m_action->entries.empty())
        return m_action;
    return chosenAction(*m_action, m_form->arguments().value_or(QVariantMap()));
}

void ActionsPage::updateRun()
{
    const bool connected = workspace().client().isConnected();
    const std::optional<ActionSpec> action = chosen();
    const bool red = action && action->risk == ActionRisk::Destroys;
    if (action) {
        m_risk->setText(riskText(action->risk));
        m_risk->setObjectName(action->risk == ActionRisk::Safe ? u"muted"_s
                                  : red                        ? u"error"_s
                                                               : u"warning"_s);
        repolish(m_risk);
    }
    // The button's text says what will happen; there is no further question.
    m_run->setText(!m_action ? tr("Run")
                       : red ? tr("%1: overwrite settings").arg(tableText(m_action->label))
                             : tableText(m_action->label));
    m_run->setObjectName(red ? u"danger"_s : u"primary"_s);
    repolish(m_run);
    const bool isHeld = workspace().live().isHeld() && !(action && action->stopsMotors);
    m_run->setEnabled(connected && m_action && !m_running && !isHeld
                      && (action->risk == ActionRisk::Safe
                          || (workspace().client().identity().writable && !workspace().isGuided())));
    m_run->setToolTip(workspace().isGuided()     ? tr("The gimbal is being set up.")
                          : isHeld && !m_running ? tr("A search, measurement or calibration is running.")
                                                 : QString());
    m_cancel->setVisible(m_running);
    m_list->setEnabled(connected && !m_running);
}

void ActionsPage::run()
{
    const auto arguments = m_form->arguments();
    if (!arguments) {
        workspace().notifications().report(arguments.error());
        return;
    }
    const ActionSpec action = chosenAction(*m_action, *arguments);
    const auto goOn = [this, action, given = *arguments] { performNow(action, given); };
    const QString label = tableText(action.label);
    if (action.letsGo)
        askToLetGo(workspace(), label, this, goOn);
    else if (action.memory == MemoryEffect::Reloads && action.risk != ActionRisk::Destroys)
        askToReload(workspace(), tr("%1: put stored values into use?").arg(label), label, tr("Do nothing"),
                    this, goOn);
    else
        goOn();
}

void ActionsPage::performNow(const ActionSpec &action, const QVariantMap &arguments)
{
    m_running = true;
    updateRun();
    const QString label = tableText(action.label);
    m_reply->setPlainText(tr("%1 …").arg(label));
    const bool rereads = action.risk == ActionRisk::Writes && action.memory == MemoryEffect::None;
    whenDone(workspace().perform(QString::fromLatin1(action.key), arguments), this,
             [this, action, label, rereads](const Result<ActionOutcome> &outcome) {
                 m_running = false;
                 updateRun();
                 const QString time = QTime::currentTime().toString(u"HH:mm:ss"_s);
                 if (!outcome) {
                     m_reply->setPlainText(time + u"  "_s + label + u'\n'
                                           + describe(outcome.error()).oneLine());
                     return;
                 }
                 const QString state = outcome->answered ? tr("done") : tr("sent");
                 QString html = u"<p>%1  <b>%2</b>: %3</p><table>"_s.arg(time, label.toHtmlEscaped(),
                                                                         state.toHtmlEscaped());
                 for (auto it = outcome->reply.begin(); it != outcome->reply.end(); ++it) {
                     html += u"<tr><td style='padding:2px 16px 2px 0'>%1</td>"
                             "<td style='padding:2px 0'>%2 %3</td></tr>"_s.arg(
                                 replyLabel(it.key()).toHtmlEscaped(), replyText(it.value()).toHtmlEscaped(),
                                 replyUnit(action, it.key()));
                 }
                 html += u"</table>"_s;
                 if (!outcome->snapshotPath.isEmpty())
                     html += u"<p>%1</p>"_s.arg(tr("The settings as they were are kept in %1")
                                                    .arg(outcome->snapshotPath)
                                                    .toHtmlEscaped());
                 m_reply->setHtml(html);
                 if (rereads && !outcome->reply.contains(u"unstored"_s))
                     workspace().readBoard();
             });
}
