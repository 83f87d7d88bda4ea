// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/scriptspage.h"

#include "app/workspace/question.h"
#include "protocol/base/filefault.h"
#include "widgets/forms/parameterform.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/card.h"
#include "widgets/views/scripteditor.h"

#include <QFile>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kCheckDelay = 250ms;
constexpr int kScriptListWidth = 132;
constexpr int kRightWidth = 300;
constexpr qint64 kLargestText = 65536;

QString draftName(int script)
{
    return u"script/%1"_s.arg(script + 1);
}

}  // namespace

ScriptsPage::ScriptsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"scripts"_s, tr("Scripts"), parent)
    , m_list(new QListWidget)
    , m_editor(new ScriptEditor(workspace.theme()))
    , m_message(new QLabel)
    , m_input(new ParameterForm(workspace.configuration(), workspace.edits()))
    , m_listing(new QListWidget)
    , m_memory(new QProgressBar)
    , m_memoryText(new QLabel)
    , m_load(new QPushButton(tr("Load…")))
    , m_save(new QPushButton(tr("Save…")))
    , m_revert(new QPushButton(tr("Discard")))
    , m_take(new QPushButton(tr("Take over")))
{
    m_load->setToolTip(tr("Put the text of a file into this script"));
    m_save->setToolTip(tr("Save the text of this script"));
    m_revert->setToolTip(tr("Throw away what was typed since it was taken over"));
    m_take->setToolTip(tr(
        "Make the texts an edit of the configuration; nothing is on the board before you review and write"));
    m_take->setObjectName(u"primary"_s);
    for (QPushButton *button : {m_load, m_save, m_revert, m_take})
        header()->addWidget(button);
    m_list->setAccessibleName(tr("Scripts"));
    m_list->setFixedWidth(kScriptListWidth);
    m_editor->setAccessibleName(tr("Text of the script"));
    m_message->setWordWrap(true);
    m_listing->setAccessibleName(tr("Code of the script"));
    m_listing->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_listing->setSelectionMode(QAbstractItemView::NoSelection);
    m_memory->setTextVisible(false);
    m_memory->setAccessibleName(tr("Memory used"));
    auto *code = new Card(tr("Code"));
    code->content()->addWidget(m_listing, 1);
    code->content()->addWidget(m_memoryText);
    code->content()->addWidget(m_memory);
    auto *right = new QVBoxLayout;
    right->setSpacing(12);
    right->addWidget(code, 1);
    auto *rightHolder = new QWidget;
    right->setContentsMargins(0, 0, 0, 0);
    rightHolder->setLayout(right);
    rightHolder->setFixedWidth(kRightWidth);
    auto *middle = new QVBoxLayout;
    middle->setSpacing(Metric::kGap);
    middle->addWidget(m_input);
    middle->addWidget(m_editor, 1);
    middle->addWidget(m_message);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_list);
    row->addLayout(middle, 1);
    row->addWidget(rightHolder);
    body()->addLayout(row, 1);

    m_checkTimer.setSingleShot(true);
    m_checkTimer.setInterval(kCheckDelay);
    connect(&m_checkTimer, &QTimer::timeout, this, &ScriptsPage::check);
    connect(m_editor, &QsciScintilla::textChanged, this, &ScriptsPage::onTyped);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int chosen) {
        if (chosen >= 0 && !m_filling)
            showScript(chosen);
    });
    connect(m_load, &QPushButton::clicked, this, &ScriptsPage::load);
    connect(m_save, &QPushButton::clicked, this, &ScriptsPage::save);
    connect(m_take, &QPushButton::clicked, this, &ScriptsPage::take);
    connect(m_revert, &QPushButton::clicked, this, &ScriptsPage::askToDiscard);
    connect(&drafts(), &Drafts::replaced, this, &ScriptsPage::reload);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &ScriptsPage::reload);
    connect(&workspace.configuration(), &ConfigurationModel::dataChanged, this, &ScriptsPage::reload);
    connect(&workspace.configuration(), &ConfigurationModel::storedChanged, this, &ScriptsPage::reload);
    reload();
}

const ScriptLanguage *ScriptsPage::language() const
{
    const Family *family = workspace().family();
    return family && !workspace().configuration().isEmpty() ? family->scripts.get() : nullptr;
}

bool ScriptsPage::isTyped() const
{
    return m_texts != m_taken;
}

bool ScriptsPage::hasChanges() const
{
    return isTyped() || (language() && !workspace().configuration().dataChanges().empty());
}

QString ScriptsPage::message() const
{
    return m_message->text();
}

// What the configuration holds now; what is being typed is kept.
void ScriptsPage::reload()
{
    const ScriptLanguage *scripts = language();
    const Configuration &edited = std::as_const(workspace().configuration()).edited();
    const bool readable = scripts && !edited.block({0, scripts->block()}).isEmpty();
    QStringList texts;
    for (int script = 0; readable && script < scripts->count(); ++script)
        texts.append(scripts->text(edited, script));
    m_taken = texts;
    m_texts = texts;
    for (int script = 0; script < texts.size(); ++script)
        m_texts[script] = drafts().text(draftName(script)).value_or(texts[script]);
    m_filling = true;
    m_list->clear();
    for (int script = 0; script < texts.size(); ++script)
        m_list->addItem(tr("Script %1").arg(script + 1));
    m_filling = false;
    m_editor->setEnabled(readable);
    m_editor->setReadOnly(!edited.identity().writable);
    if (readable)
        m_editor->setWords(scripts->words(edited));
    showScript(std::clamp(m_script, 0, std::max(0, int(texts.size()) - 1)));
    check();
}

void ScriptsPage::showScript(int script)
{
    m_script = script;
    m_filling = true;
    m_list->setCurrentRow(script);
    if (m_editor->text() != m_texts.value(script))
        m_editor->setText(m_texts.value(script));
    m_filling = false;
    QList<int> inputs;
    if (const ScriptLanguage *scripts = language()) {
        const auto set = std::as_const(workspace().configuration()).edited().parameterSet();
        if (const ParameterSpec *input = set->find(scripts->inputKey(script)))
            inputs.append(input->id);
    }
    m_input->setParameters(inputs);
    showState();
}

// In the script that is shown, undo brings the text back; what others lose is asked for.
void ScriptsPage::askToDiscard()
{
    int others = 0;
    for (int script = 0; script < m_texts.size(); ++script)
        others += script != m_script && m_texts[script] != m_taken.value(script) ? 1 : 0;
    if (others == 0) {
        discard();
        return;
    }
    askInPanel(
        {tr("Discard what was typed?"),
         tr("The texts of %n other script(s) that were not taken over are lost as well.", nullptr, others),
         {{tr("Discard"), [this] { discard(); }, true}},
         tr("Keep them")},
        this);
}

void ScriptsPage::discard()
{
    m_texts = m_taken;
    m_filling = true;
    if (m_editor->text() != m_texts.value(m_script)) {
        m_editor->selectAll();  // replaced, not set: that can be undone
        m_editor->replaceSelectedText(m_texts.value(m_script));
    }
    m_filling = false;
    keepDrafts();
    showScript(m_script);
    check();
    // Undo is meant for the text now, not for edits elsewhere. A panel gives the keyboard back first.
    QTimer::singleShot(0, m_editor, [this] { m_editor->setFocus(); });
}

void ScriptsPage::onTyped()
{
    if (m_filling || m_script >= m_texts.size())
        return;
    const bool had = hasChanges();
    m_texts[m_script] = m_editor->text();
    keepDrafts();
    m_checkTimer.start();
    if (had != hasChanges())
        emit changesChanged();
    showState();
}

// A text with a mistake is no edit, and must not be lost either.
void ScriptsPage::keepDrafts()
{
    for (int script = 0; script < m_texts.size(); ++script) {
        if (m_texts[script] == m_taken.value(script))
            drafts().remove(draftName(script));
        else
            drafts().set(draftName(script), m_texts[script]);
    }
}

void ScriptsPage::check()
{
    m_checkTimer.stop();
    if (const ScriptLanguage *scripts = language(); scripts && !m_texts.isEmpty())
        m_code = scripts->compile(std::as_const(workspace().configuration()).edited(), m_texts);
    showState();
    emit changesChanged();
}

void ScriptsPage::showState()
{
    const ScriptLanguage *scripts = language();
    m_listing->clear();
    const bool there = scripts && !m_texts.isEmpty();
    const Configuration &edited = std::as_const(workspace().configuration()).edited();
    if (!there) {
        const MissingPart *part = scripts ? edited.findMissing({0, scripts->block()}) : nullptr;
        const bool isLost = part && part->why.code != ErrorCode::Unsupported;
        m_message->setText(workspace().configuration().isEmpty()
                               ? tr("Connect a board, or open a file, to see its scripts.")
                               : isLost ? tr("The scripts did not come. Read the board again (F5).")
                                        : tr("The scripts of this board cannot be read over this link."));
        m_message->setObjectName(u"muted"_s);
    } else if (m_checkTimer.isActive()) {  // nothing is known of this text yet
        m_editor->showMistake(0, {});
        m_message->setText({});
        m_memoryText->setText({});
        m_memory->setValue(0);
    } else if (m_code) {
        Configuration shown = edited;
        shown.setBlock({0, scripts->block()}, *m_code);
        for (const ScriptLanguage::Line &line : scripts->listing(shown, m_script))
            m_listing->addItem(u"%1  %2"_s.arg(line.offset, 3).arg(line.text));
        const auto [used, all] = scripts->used(shown);
        m_memory->setRange(0, all);
        m_memory->setValue(used);
        m_memoryText->setText(tr("%1 of %2 bytes used by all scripts").arg(used).arg(all));
        m_editor->showMistake(0, {});
        m_message->setText(isTyped() ? tr("✓ Nothing is wrong with it. Take it over to have it written.")
                               : m_texts.value(m_script).trimmed().isEmpty()
                               ? tr("This script is empty. Words are completed while you type.")
                               : tr("✓ As in the configuration."));
        m_message->setObjectName(u"muted"_s);
    } else {
        const ScriptMistake &mistake = m_code.error();
        m_memoryText->setText(tr("No code: a script has a mistake"));
        m_memory->setValue(0);
        const QString text = mistake.sentence(tableText(mistake.what));
        const QString number = QString::number(mistake.script + 1);
        m_message->setText(mistake.line > 0
                               ? tr("Script %1, line %2: %3").arg(number, QString::number(mistake.line), text)
                               : tr("Script %1: %2").arg(number, text));
        m_editor->showMistake(mistake.script == m_script ? mistake.line : 0, text);
        m_message->setObjectName(u"error"_s);
    }
    repolish(m_message);
    for (int script = 0; script < m_list->count(); ++script) {
        const bool changed = m_texts.value(script) != m_taken.value(script);
        const QString name = tr("Script %1").arg(script + 1);
        m_list->item(script)->setText(changed ? name + u"  •"_s : name);
    }
    const bool writable = there && edited.identity().writable;
    m_take->setEnabled(writable && m_code && isTyped() && !m_checkTimer.isActive());
    m_revert->setEnabled(there && isTyped());
    m_load->setEnabled(writable);
    m_save->setEnabled(there && !m_texts.value(m_script).isEmpty());
}

void ScriptsPage::take()
{
    check();
    const ScriptLanguage *scripts = language();
    if (!scripts || m_texts.isEmpty() || !m_code)
        return;
    m_taken = m_texts;  // words and comments as they were typed, as long as the page lives
    const QStringList typed = m_texts;
    workspace().edits().editData({0, scripts->block()}, *m_code);
    m_texts = m_taken = typed;
    static const QRegularExpression comment(u"^\\s*(//|;)"_s, QRegularExpression::MultilineOption);
    if (std::any_of(typed.begin(), typed.end(), [](const QString &text) { return text.contains(comment); }))
        workspace().notifications().notify(
            tr("The board stores no comments. Save the script to a file to keep them."), Notice::Hint);
    keepDrafts();
    showScript(m_script);
    emit changesChanged();
}

void ScriptsPage::load()
{
    askOpenPath(this, tr("Load a script"), tr("Scripts (*.%1)").arg(language()->suffix()),
                [this](const QString &path) {
                    const auto text = readWhole(path, FileKind::Script, kLargestText);
                    if (workspace().notifications().reportLoaded(text))
                        m_editor->setText(QString::fromUtf8(*text));  // as if it had been typed
                });
}

void ScriptsPage::save()
{
    askSavePath(this, tr("Save the script"), u"script%1.%2"_s.arg(m_script + 1).arg(language()->suffix()),
                tr("Scripts (*.%1)").arg(language()->suffix()), [this](const QString &path) {
                    workspace().notifications().reportSaved(
                        writeWhole(path, m_texts.value(m_script).toUtf8(), FileKind::Script), path);
                });
}
