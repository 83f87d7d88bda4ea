// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/documentspage.h"

#include "protocol/base/filefault.h"
#include "widgets/models/parametermodel.h"

#include <QFile>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTakeDelay = 300ms;  // after the last key, what was typed becomes one step
constexpr int kListWidth = 180;

bool isUtf8(const QByteArray &bytes)
{
    return QString::fromUtf8(bytes).toUtf8() == bytes;
}

}  // namespace

DocumentsPage::DocumentsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"documents"_s, tr("Documents"), parent)
    , m_list(new QListWidget)
    , m_editor(new QPlainTextEdit)
    , m_message(new QLabel)
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
    m_load->setToolTip(tr("Put the text of a file in place of this one"));
    m_save->setToolTip(tr("Save the text as it is shown"));
    for (QPushButton *button : {m_load, m_save})
        header()->addWidget(button);
}

void DocumentsPage::makeBody()
{
    m_list->setAccessibleName(tr("Documents of this board"));
    m_list->setFixedWidth(kListWidth);
    m_editor->setAccessibleName(tr("Text of the document"));
    m_editor->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_editor->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_editor->setTabChangesFocus(true);
    m_editor->setUndoRedoEnabled(false);  // there is one stack of edits, for all pages
    m_message->setWordWrap(true);
    auto *right = new QVBoxLayout;
    right->setSpacing(Metric::kGap);
    right->addWidget(m_editor, 1);
    right->addWidget(m_message);
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
    connect(m_editor, &QPlainTextEdit::textChanged, this, [this] {
        if (m_filling)
            return;
        keepDraft();
        m_takeTimer.start();
        showState();
    });
    connect(&drafts(), &Drafts::replaced, this, &DocumentsPage::showDocument);
    m_editor->installEventFilter(this);
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

void DocumentsPage::showText(int block)
{
    for (std::size_t row = 0; row < m_documents.size(); ++row) {
        if (m_documents[row]->id == block)
            m_list->setCurrentRow(int(row));
    }
    m_editor->setFocus();
}

QByteArray DocumentsPage::held() const
{
    return m_shown ? std::as_const(workspace().configuration()).edited().block({0, m_shown->id})
                   : QByteArray();
}

// Line endings are kept.
QByteArray DocumentsPage::typed() const
{
    QByteArray text = m_editor->toPlainText().toUtf8();
    if (held().contains("\r\n"))
        text.replace("\n", "\r\n");
    return text;
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
        drafts().set(draftName(), m_editor->toPlainText());
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
    m_filling = false;
    chooseDocument();
}

// What the configuration holds now, also after an edit was undone. The cursor stays where it was.
void DocumentsPage::showDocument()
{
    if (m_takeTimer.isActive())
        return;  // still being typed; it becomes an edit shortly
    const auto draft = drafts().text(draftName());
    const QByteArray bytes = draft ? draft->toUtf8() : held();
    if (draft ? m_editor->toPlainText() != *draft : typed() != bytes) {
        m_filling = true;
        const int place = m_editor->textCursor().position();
        m_editor->setPlainText(QString::fromUtf8(bytes));
        QTextCursor cursor = m_editor->textCursor();
        cursor.setPosition(std::min<int>(place, int(m_editor->toPlainText().size())));
        m_editor->setTextCursor(cursor);
        m_filling = false;
    }
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
    const bool readable = m_shown && isUtf8(held());
    const bool writable = readable && std::as_const(workspace().configuration()).edited().identity().writable;
    m_editor->setEnabled(m_shown);
    m_editor->setReadOnly(!writable);
    m_load->setEnabled(writable);
    m_save->setEnabled(m_shown);
    QString text;
    const char *name = "muted";
    if (!m_shown) {
        text = tr("Connect a board, or open a file, to see its documents.");
    } else if (!readable) {
        text = tr("This document is not UTF-8 text. It can be saved to a file, but not edited here.");
        name = "warning";
    } else {
        const qsizetype size = typed().size();
        const int max = std::max(m_shown->size, m_shown->maxSize);
        text = m_shown->holds(size)
            ? tr("%1 of %2 bytes").arg(size).arg(max)
            : tr("%1 bytes, and the board takes %2 to %3: this is not kept as an edit.")
                  .arg(size)
                  .arg(m_shown->size)
                  .arg(max);
        if (m_shown->effect == WriteEffect::Restarts)
            text += u' ' + tr("The board restarts when it is written.");
        name = m_shown->holds(size) ? "muted" : "error";
    }
    m_message->setText(text);
    m_message->setObjectName(QLatin1String(name));
    repolish(m_message);
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
