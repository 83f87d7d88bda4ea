// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/documentspage.h"

#include "protocol/base/filefault.h"
#include "protocol/configuration/linediff.h"
#include "protocol/configuration/scriptlanguage.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/codeeditor.h"
#include "widgets/views/diffview.h"
#include "widgets/views/searchbar.h"

#include <QFile>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTakeDelay = 300ms;  // after the last key, what was typed becomes one step
constexpr int kListWidth = 180;
constexpr int kContext = 3;  // lines around a difference

bool isUtf8(const QByteArray &bytes)
{
    return QString::fromUtf8(bytes).toUtf8() == bytes;
}

// As it calls itself.
QString languageName(const BlockSpec &block)
{
    const QString key = QString::fromLatin1(block.language);
    return key.left(1).toUpper() + key.mid(1);
}

}  // namespace

DocumentsPage::DocumentsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"documents"_s, tr("Documents"), parent)
    , m_list(new QListWidget)
    , m_editor(new TextEditor(workspace.theme()))
    , m_searchBar(new SearchBar(*m_editor))
    , m_diff(new DiffView(workspace.theme()))
    , m_views(new QStackedWidget)
    , m_message(new QLabel)
    , m_goThere(new QPushButton)
    , m_search(new QPushButton(tr("Search")))
    , m_difference(new QPushButton(tr("Difference")))
    , m_load(new QPushButton(tr("Load file…")))
    , m_save(new QPushButton(tr("Save file…")))
{
    makeHeader();
    makeBody();
    connectAll();
    reload();
}

void DocumentsPage::makeHeader()
{
    m_search->setToolTip(tr("Search in the text (Ctrl+F)"));
    m_difference->setToolTip(tr("Show line by line what differs from the board"));
    m_difference->setCheckable(true);
    m_load->setToolTip(tr("Put the text of a file in place of this one"));
    m_save->setToolTip(tr("Save the text as it is shown"));
    for (QPushButton *button : {m_search, m_difference, m_load, m_save})
        header()->addWidget(button);
}

void DocumentsPage::makeBody()
{
    m_list->setAccessibleName(tr("Documents of this board"));
    m_list->setFixedWidth(kListWidth);
    m_editor->setAccessibleName(tr("Text of the document"));
    m_diff->setAccessibleName(tr("Difference from the board"));
    m_message->setWordWrap(true);
    auto *text = new QWidget;
    auto *pane = new QVBoxLayout(text);
    pane->setContentsMargins(0, 0, 0, 0);
    pane->setSpacing(Metric::kGap);
    pane->addWidget(m_searchBar);
    pane->addWidget(m_editor, 1);
    m_views->addWidget(text);
    m_views->addWidget(m_diff);
    auto *foot = new QHBoxLayout;
    foot->setSpacing(Metric::kGap);
    foot->addWidget(m_message, 1);
    foot->addWidget(m_goThere, 0, Qt::AlignTop);
    auto *right = new QVBoxLayout;
    right->setSpacing(Metric::kGap);
    right->addWidget(m_views, 1);
    right->addLayout(foot);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_list);
    row->addLayout(right, 1);
    body()->addLayout(row, 1);
}

void DocumentsPage::connectAll()
{
    m_takeTimer.setSingleShot(true);
    m_takeTimer.setInterval(kTakeDelay);
    connect(&m_takeTimer, &QTimer::timeout, this, &DocumentsPage::take);
    connect(m_editor, &QsciScintilla::textChanged, this, [this] {
        if (m_filling)
            return;
        keepDraft();
        m_takeTimer.start();
        showState();
    });
    connect(&drafts(), &Drafts::replaced, this, &DocumentsPage::showDocument);
    m_editor->installEventFilter(this);
    connect(m_difference, &QPushButton::toggled, this, &DocumentsPage::showDifference);
    connect(m_goThere, &QPushButton::clicked, this, &DocumentsPage::goThere);
    connect(m_search, &QPushButton::clicked, this, [this] { search(); });
    new QShortcut(QKeySequence::Find, this, [this] { search(); });
    new QShortcut(QKeySequence(Qt::Key_F3), this, [this] { m_searchBar->findNext(); });
    new QShortcut(QKeySequence(Qt::SHIFT | Qt::Key_F3), this, [this] { m_searchBar->findPrevious(); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        if (!m_filling)
            chooseDocument();
    });
    connect(m_load, &QPushButton::clicked, this, [this] {
        askOpenPath(this, tr("Load a document"), tr("Texts (*)"),
                    [this](const QString &path) { loadFrom(path); });
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        const QString suffix = QString::fromLatin1(*m_shown->language ? m_shown->language : "txt");
        askSavePath(this, tr("Save the document"), u"%1.%2"_s.arg(tableText(m_shown->data), suffix),
                    tr("Texts (*)"), [this](const QString &path) { saveTo(path); });
    });
    const ConfigurationModel &configuration = workspace().configuration();
    connect(&configuration, &ConfigurationModel::boardReset, this, &DocumentsPage::reload);
    connect(&configuration, &ConfigurationModel::dataChanged, this, &DocumentsPage::showDocument);
    connect(&configuration, &ConfigurationModel::storedChanged, this, &DocumentsPage::showDocument);
}

void DocumentsPage::chooseDocument()
{
    if (m_takeTimer.isActive())
        take();
    const int row = m_list->currentRow();
    m_shown = row >= 0 && row < int(m_documents.size()) ? m_documents[std::size_t(row)] : nullptr;
    showDocument();
}

void DocumentsPage::showText(int block, int line)
{
    for (std::size_t row = 0; row < m_documents.size(); ++row) {
        if (m_documents[row]->id == block)
            m_list->setCurrentRow(int(row));
    }
    showDifference(false);
    if (line > 0)
        m_editor->goToLine(line);
    m_editor->setFocus();
}

void DocumentsPage::search(const QString &words)
{
    showDifference(false);
    m_searchBar->begin(words);
}

QByteArray DocumentsPage::held() const
{
    return m_shown ? std::as_const(workspace().configuration()).edited().block({0, m_shown->id})
                   : QByteArray();
}

QByteArray DocumentsPage::typed() const
{
    return m_editor->bytes();
}

bool DocumentsPage::isReadable() const
{
    return m_shown && isUtf8(held());
}

bool DocumentsPage::hasChanges() const
{
    const auto changes = workspace().configuration().dataChanges();
    return drafts().text(draftName()).has_value()
        || std::any_of(changes.begin(), changes.end(),
                       [](const DataChange &change) { return change.spec->isText(); });
}

QString DocumentsPage::draftName() const
{
    return u"document/"_s + (m_shown ? QString::fromLatin1(m_shown->name) : QString());
}

// What is not an edit yet, or is too long to be one, must not be lost.
void DocumentsPage::keepDraft()
{
    if (!m_shown)
        return;
    if (typed() == held())
        drafts().remove(draftName());
    else
        drafts().set(draftName(), QString::fromUtf8(typed()));
}

void DocumentsPage::reload()
{
    const ConfigurationModel &configuration = workspace().configuration();
    m_takeTimer.stop();
    m_filling = true;
    m_documents.clear();
    m_list->clear();
    if (!configuration.isEmpty()) {
        for (const BlockSpec &block : configuration.edited().parameters().blocks()) {
            if (!block.isText() || !configuration.edited().blocks().contains({0, block.id}))
                continue;
            m_documents.push_back(&block);
            m_list->addItem(tableText(block.data));
        }
    }
    m_list->setCurrentRow(0);
    m_list->setVisible(m_documents.size() != 1);
    m_filling = false;
    chooseDocument();
}

// What the configuration holds now, also after an edit was undone. The cursor stays where it was.
void DocumentsPage::showDocument()
{
    if (m_takeTimer.isActive())
        return;  // still being typed; it becomes an edit shortly
    const auto draft = drafts().text(draftName());
    m_filling = true;
    m_editor->setLanguage(m_shown ? QString::fromLatin1(m_shown->language) : QString());
    m_editor->setBytes(draft ? draft->toUtf8() : held());
    m_filling = false;
    showState();
    emit changesChanged();
}

void DocumentsPage::take()
{
    m_takeTimer.stop();
    if (m_shown)
        workspace().edits().editData({0, m_shown->id}, typed());  // one that is too long is not taken
    keepDraft();
    showState();
    emit changesChanged();
}

void DocumentsPage::showState()
{
    const bool readable = isReadable();
    const bool writable = readable && std::as_const(workspace().configuration()).edited().identity().writable;
    m_editor->setEnabled(m_shown);
    m_editor->setReadOnly(!writable);
    m_load->setEnabled(writable);
    m_save->setEnabled(m_shown);
    m_search->setEnabled(m_shown);
    m_difference->setEnabled(m_shown);
    m_goThere->hide();
    m_message->setObjectName(u"muted"_s);
    if (!m_shown) {
        m_message->setText(tr("Connect a board, or open a file, to see its documents."));
    } else if (!readable) {
        m_message->setText(
            tr("This document is not UTF-8 text. It can be saved to a file, but not edited here."));
        m_message->setObjectName(u"warning"_s);
    } else if (m_views->currentWidget() == m_diff) {
        fillDifference();
    } else {
        showMistake();
    }
    repolish(m_message);
}

QString DocumentsPage::sizeText() const
{
    const qsizetype size = typed().size();
    const int max = std::max(m_shown->size, m_shown->maxSize);
    QString text = m_shown->holds(size)
        ? tr("%1 of %2 bytes.").arg(size).arg(max)
        : tr("%1 bytes, and the board takes %2 to %3: this is not kept as an edit.")
              .arg(size)
              .arg(m_shown->size)
              .arg(max);
    if (m_shown->effect == WriteEffect::Restarts)
        text += u' ' + tr("The board restarts when it is written.");
    return text;
}

// What a family can check of its text. Nothing is known of it while it is being typed.
void DocumentsPage::showMistake()
{
    const bool isKnown = m_shown->check && !m_takeTimer.isActive();
    const auto mistake = isKnown ? m_shown->check(typed()) : std::nullopt;
    QString said = sizeText();
    if (mistake) {
        const QString text = mistake->sentence(tableText(mistake->what));
        m_mistakeLine = mistake->line;
        said = (m_mistakeLine > 0 ? tr("Line %1: %2.").arg(QString::number(m_mistakeLine), text)
                                  : tr("The text cannot be used: %1.").arg(text))
            + u' ' + said;
        m_editor->showMistake(m_mistakeLine, text);
        m_goThere->setText(tr("Go to line %1").arg(m_mistakeLine));
        m_goThere->setVisible(m_mistakeLine > 0);
    } else {
        m_mistakeLine = 0;
        m_editor->showMistake(0, {});
        if (isKnown)
            said = tr("✓ Valid %1. That does not prove that the board starts with it.")
                       .arg(languageName(*m_shown))
                + u' ' + said;
    }
    m_message->setText(said);
    m_message->setObjectName(mistake || !m_shown->holds(typed().size()) ? u"error"_s : u"muted"_s);
}

void DocumentsPage::showDifference(bool shown)
{
    m_difference->setChecked(shown);
    m_views->setCurrentIndex(shown ? 1 : 0);
    if (shown && m_takeTimer.isActive())
        take();
    showState();
}

void DocumentsPage::fillDifference()
{
    const Configuration &board = std::as_const(workspace().configuration()).board();
    const auto lines = lineDiff(board.block({0, m_shown->id}), typed());
    const auto [added, removed] = countChanges(lines);
    m_diff->setLines(aroundChanges(lines, kContext));
    if (added == 0 && removed == 0) {
        m_message->setText(tr("No difference: the text is as it is stored."));
        return;
    }
    m_message->setText(
        tr("%n line(s) added", nullptr, added) + u", "_s + tr("%n line(s) removed", nullptr, removed)
        + u". "_s
        + tr("Lines with − are stored now; those with + take their place when the text is written."));
    m_goThere->setText(tr("Show in the text"));
    m_goThere->show();
}

// To the mistake, or to what the difference shows at its cursor.
void DocumentsPage::goThere()
{
    const int line = m_views->currentWidget() == m_diff ? m_diff->lineThere() : m_mistakeLine;
    showText(m_shown->id, line);
}

void DocumentsPage::loadFrom(const QString &path)
{
    if (!m_shown)
        return;
    const auto read = readWhole(path, FileKind::Text, std::max(m_shown->size, m_shown->maxSize));
    if (!workspace().notifications().reportLoaded(read))
        return;
    const QByteArray &bytes = *read;
    if (!m_shown->holds(bytes.size()) || !isUtf8(bytes)) {
        const FileFault fault{.problem = bytes.isEmpty() ? FileProblem::Empty : FileProblem::OtherKind,
                              .kind = FileKind::Text,
                              .path = path};
        workspace().notifications().report(fault.error(), Concern::Loading);
        return;
    }
    m_takeTimer.stop();
    drafts().remove(draftName());
    workspace().edits().editData({0, m_shown->id}, bytes);
    showDocument();
}

void DocumentsPage::saveTo(const QString &path)
{
    take();
    const QByteArray bytes = isUtf8(held()) ? typed() : held();
    workspace().notifications().reportSaved(writeWhole(path, bytes, FileKind::Text), path);
}

void DocumentsPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    if (m_takeTimer.isActive())
        take();
}

// Otherwise the editor would consume the shortcuts of undo and redo.
bool DocumentsPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusOut && m_takeTimer.isActive())
        take();
    if (event->type() == QEvent::KeyPress) {
        auto *key = static_cast<QKeyEvent *>(event);
        const bool undo = key->matches(QKeySequence::Undo);
        if (undo || key->matches(QKeySequence::Redo)) {
            if (m_takeTimer.isActive())
                take();
            undo ? workspace().edits().undo() : workspace().edits().redo();
            return true;
        }
    }
    return Page::eventFilter(watched, event);
}
