// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/searchbar.h"

#include "widgets/views/codeeditor.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>

using namespace Qt::StringLiterals;

SearchBar::SearchBar(CodeEditor &editor, QWidget *parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_field(new QLineEdit)
    , m_count(new QLabel)
    , m_previous(new QToolButton)
    , m_next(new QToolButton)
    , m_close(new QToolButton)
{
    m_field->setPlaceholderText(tr("Search in the text"));
    m_field->setAccessibleName(tr("Search in the text"));
    m_field->setMaximumWidth(Metric::kFieldWidth);
    m_field->setClearButtonEnabled(true);
    m_count->setObjectName(u"muted"_s);
    m_previous->setText(u"▲"_s);
    m_previous->setAccessibleName(tr("Previous place"));
    m_previous->setToolTip(tr("Previous place (Shift+F3)"));
    m_next->setText(u"▼"_s);
    m_next->setAccessibleName(tr("Next place"));
    m_next->setToolTip(tr("Next place (F3 or Enter)"));
    m_close->setText(u"✕"_s);
    m_close->setAccessibleName(tr("Close the search"));
    m_close->setToolTip(tr("Close the search (Esc)"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(Metric::kGap);
    row->addWidget(m_field, 1);
    row->addWidget(m_previous);
    row->addWidget(m_next);
    row->addWidget(m_count);
    row->addStretch();
    row->addWidget(m_close);
    hide();
    connect(m_field, &QLineEdit::textChanged, this, [this] {
        search();
        const int from = cursor();
        const auto first = std::find_if(m_places.begin(), m_places.end(),
                                        [from](const auto &place) { return place.first >= from; });
        choose(m_places.empty() ? -1 : first == m_places.end() ? 0 : int(first - m_places.begin()));
    });
    connect(&editor, &QsciScintilla::textChanged, this, [this] {
        if (isVisible()) {
            search();
            showCount(-1);
            m_editor.showFound(m_places, -1);
        }
    });
    connect(m_next, &QToolButton::clicked, this, &SearchBar::findNext);
    connect(m_previous, &QToolButton::clicked, this, &SearchBar::findPrevious);
    connect(m_close, &QToolButton::clicked, this, &SearchBar::end);
}

void SearchBar::begin(const QString &words)
{
    const QString selected = words.isEmpty() ? m_editor.selectedText() : words;
    show();
    if (!selected.isEmpty() && !selected.contains(u'\n'))
        m_field->setText(selected);
    else
        emit m_field->textChanged(m_field->text());
    m_field->setFocus();
    m_field->selectAll();
}

void SearchBar::end()
{
    m_editor.showFound({}, -1);
    m_editor.setFocus();
    hide();
}

// Where what is selected begins; it is found again when a letter is added.
int SearchBar::cursor() const
{
    return int(m_editor.SendScintilla(QsciScintillaBase::SCI_GETSELECTIONSTART));
}

void SearchBar::search()
{
    m_places.clear();
    const QString wanted = m_field->text();
    const bool isExact = std::any_of(wanted.begin(), wanted.end(), [](QChar c) { return c.isUpper(); });
    const QString text = QString::fromUtf8(m_editor.bytes());
    qsizetype letters = 0;  // counted so far, and their bytes
    int bytes = 0;
    for (qsizetype at = wanted.isEmpty() ? -1 : 0; at >= 0;) {
        at = text.indexOf(wanted, at, isExact ? Qt::CaseSensitive : Qt::CaseInsensitive);
        if (at < 0)
            break;
        bytes += int(QStringView(text).sliced(letters, at - letters).toUtf8().size());
        const int end = bytes + int(QStringView(text).sliced(at, wanted.size()).toUtf8().size());
        m_places.emplace_back(bytes, end);
        at += wanted.size();
        letters = at;
        bytes = end;
    }
}

void SearchBar::choose(int place)
{
    m_editor.showFound(m_places, place);
    showCount(place);
}

void SearchBar::showCount(int chosen)
{
    const int all = count();
    for (QToolButton *button : {m_previous, m_next})
        button->setEnabled(all > 0);
    m_count->setText(m_field->text().isEmpty() ? QString()
                         : all == 0            ? tr("Not found")
                         : chosen >= 0         ? tr("%1 of %2").arg(chosen + 1).arg(all)
                                               : tr("%n place(s)", nullptr, all));
}

void SearchBar::findNext()
{
    search();
    const int from = cursor();
    const auto next = std::find_if(m_places.begin(), m_places.end(),
                                   [from](const auto &place) { return place.first > from; });
    choose(m_places.empty() ? -1 : next == m_places.end() ? 0 : int(next - m_places.begin()));
}

void SearchBar::findPrevious()
{
    search();
    const int from = cursor();
    const auto next = std::find_if(m_places.begin(), m_places.end(),
                                   [from](const auto &place) { return place.first >= from; });
    choose(next == m_places.begin() ? count() - 1 : int(next - m_places.begin()) - 1);
}

void SearchBar::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Escape)
        end();
    else if (isEnter && (event->modifiers() & Qt::ShiftModifier))
        findPrevious();
    else if (isEnter)
        findNext();
    else
        QWidget::keyPressEvent(event);
}
