// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/codeeditor.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <Qsci/qscilexerlua.h>
#include <Qsci/qscistyle.h>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMistakeMarker = 3;
constexpr int kNumberMargin = 0;
constexpr int kFoundIndicator = 9;
constexpr int kFoundTint = 70;  // of 255
constexpr int kSeenAround = 5;  // lines

bool isInsideLetter(const QByteArray &bytes, qsizetype at)
{
    return at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xC0U) == 0x80U;
}

}  // namespace

CodeEditor::CodeEditor(Theme &theme, QWidget *parent)
    : QsciScintilla(parent)
    , m_theme(theme)
{
    setUtf8(true);
    setMarginType(kNumberMargin, NumberMargin);
    setMarginLineNumbers(kNumberMargin, true);
    setMarginWidth(1, 0);
    setCaretLineVisible(true);
    setTabWidth(2);
    setIndentationsUseTabs(false);
    setAutoIndent(true);
    setWrapMode(WrapNone);
    setFrameShape(QFrame::StyledPanel);
    setAnnotationDisplay(AnnotationBoxed);
    markerDefine(Background, kMistakeMarker);
    indicatorDefine(StraightBoxIndicator, kFoundIndicator);
    setIndicatorDrawUnder(true, kFoundIndicator);
    SendScintilla(SCI_SETSCROLLWIDTHTRACKING, 1);
    SendScintilla(SCI_SETSCROLLWIDTH, 1);
}

CodeEditor::~CodeEditor()
{
    setLexer(nullptr);  // it is destroyed with the children, after this class
}

void CodeEditor::followTheme()
{
    connect(&m_theme, &Theme::changed, this, &CodeEditor::applyTheme);
    applyTheme();
}

void CodeEditor::colorStyle(int style, ColorRole role, const QFont &font)
{
    lexer()->setColor(m_theme.color(role), style);
    lexer()->setPaper(m_theme.color(ColorRole::Surface), style);
    lexer()->setFont(font, style);
}

void CodeEditor::applyTheme()
{
    const QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const auto color = [this](ColorRole role) { return m_theme.color(role); };
    if (lexer()) {
        lexer()->setDefaultFont(font);
        lexer()->setDefaultPaper(color(ColorRole::Surface));
        lexer()->setDefaultColor(color(ColorRole::Text));
        colorLexer(font);
    } else {
        setFont(font);
    }
    setPaper(color(ColorRole::Surface));
    setColor(color(ColorRole::Text));
    setCaretForegroundColor(color(ColorRole::Text));
    setCaretLineBackgroundColor(color(ColorRole::SurfaceRaised));
    setMarginsBackgroundColor(color(ColorRole::Background));
    setMarginsForegroundColor(color(ColorRole::Muted));
    setMarginsFont(font);
    setMarginWidth(kNumberMargin, u"0000"_s);
    SendScintilla(SCI_SETMARGINLEFT, 0, Metric::kUnit);
    setSelectionBackgroundColor(color(ColorRole::Accent));
    setSelectionForegroundColor(color(ColorRole::AccentText));
    QColor found = color(ColorRole::Changed);
    found.setAlpha(kFoundTint);
    setIndicatorForegroundColor(found, kFoundIndicator);
    QColor wrong = color(ColorRole::Danger);
    wrong.setAlpha(50);
    setMarkerBackgroundColor(wrong, kMistakeMarker);
    if (m_mistake > 0)
        showMistake(m_mistake, m_mistakeText);
}

QByteArray CodeEditor::bytes() const
{
    const auto size = qsizetype(SendScintilla(SCI_GETLENGTH));
    const auto *from = static_cast<const char *>(SendScintillaPtrResult(SCI_GETCHARACTERPOINTER));
    return from ? QByteArray(from, size) : QByteArray();
}

void CodeEditor::setBytes(const QByteArray &bytes)
{
    const QByteArray now = this->bytes();
    if (now == bytes)
        return;
    qsizetype from = std::mismatch(now.begin(), now.end(), bytes.begin(), bytes.end()).first - now.begin();
    while (from > 0 && (isInsideLetter(now, from) || isInsideLetter(bytes, from)))
        --from;
    qsizetype end = now.size();
    qsizetype newEnd = bytes.size();
    while (end > from && newEnd > from && now[end - 1] == bytes[newEnd - 1]) {
        --end;
        --newEnd;
    }
    while (isInsideLetter(now, end) || isInsideLetter(bytes, newEnd)) {
        ++end;
        ++newEnd;
    }
    const bool isFixed = isReadOnly();
    setReadOnly(false);
    SendScintilla(SCI_SETTARGETRANGE, static_cast<unsigned long>(from), static_cast<long>(end));
    SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(newEnd - from), bytes.constData() + from);
    setReadOnly(isFixed);
    setEolMode(bytes.contains("\r\n") ? EolWindows : EolUnix);
}

void CodeEditor::goToLine(int line)
{
    const int wanted = std::clamp(line, 1, std::max(1, lines())) - 1;
    setCursorPosition(wanted, 0);
    ensureLineVisible(wanted);
    const int shown = int(SendScintilla(SCI_LINESONSCREEN));
    const int first = firstVisibleLine();
    if (wanted < first + kSeenAround || wanted > first + shown - kSeenAround)
        setFirstVisibleLine(std::max(0, wanted - shown / 2));
}

void CodeEditor::showMistake(int line, const QString &text)
{
    markerDeleteAll(kMistakeMarker);
    clearAnnotations();
    m_mistake = line;
    m_mistakeText = text;
    if (line < 1 || line > lines())
        return;
    markerAdd(line - 1, kMistakeMarker);
    const QsciStyle style(-1, u"mistake"_s, m_theme.color(ColorRole::Danger),
                          m_theme.color(ColorRole::Surface),
                          QFontDatabase::systemFont(QFontDatabase::GeneralFont));
    annotate(line - 1, text, style);
}

void CodeEditor::showFound(std::span<const std::pair<int, int>> places, int chosen)
{
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(kFoundIndicator));
    SendScintilla(SCI_INDICATORCLEARRANGE, 0UL, SendScintilla(SCI_GETLENGTH));
    for (const auto &[from, to] : places)
        SendScintilla(SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), static_cast<long>(to - from));
    if (chosen < 0 || chosen >= int(places.size()))
        return;
    const auto &[from, to] = places[std::size_t(chosen)];
    SendScintilla(SCI_SETSEL, static_cast<unsigned long>(from), static_cast<long>(to));
    SendScintilla(SCI_SCROLLCARET);
}

// Tab leaves the editor, as it leaves every other field; programs need none.
void CodeEditor::keyPressEvent(QKeyEvent *event)
{
    const bool completing = isListActive();
    if (!completing && (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab)) {
        // The editor's own refuses. NOLINTNEXTLINE(bugprone-parent-virtual-call)
        QAbstractScrollArea::focusNextPrevChild(event->key() == Qt::Key_Tab);
        return;
    }
    QsciScintilla::keyPressEvent(event);
}

bool CodeEditor::event(QEvent *event)
{
    // Undo here is that of the text while it has the focus.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->accept();
            return true;
        }
    }
    return QsciScintilla::event(event);
}

TextEditor::TextEditor(Theme &theme, QWidget *parent)
    : CodeEditor(theme, parent)
{
    SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
    SendScintilla(SCI_EMPTYUNDOBUFFER);
    followTheme();
}

void TextEditor::setLanguage(const QString &language)
{
    if (language == m_language)
        return;
    m_language = language;
    QsciLexer *old = lexer();
    setLexer(language == u"lua"_s ? new QsciLexerLua(this) : nullptr);
    delete old;
    applyTheme();
}

void TextEditor::colorLexer(const QFont &font)
{
    QFont bold = font;
    bold.setBold(true);
    for (int style = QsciLexerLua::Default; style <= QsciLexerLua::Label; ++style)
        colorStyle(style, ColorRole::Text, font);
    colorStyle(QsciLexerLua::Keyword, ColorRole::Accent, bold);
    for (const int style : {QsciLexerLua::Comment, QsciLexerLua::LineComment})
        colorStyle(style, ColorRole::Muted, font);
    for (const int style : {QsciLexerLua::String, QsciLexerLua::Character, QsciLexerLua::LiteralString})
        colorStyle(style, ColorRole::AxisRoll, font);
    colorStyle(QsciLexerLua::UnclosedString, ColorRole::Danger, font);
    colorStyle(QsciLexerLua::Number, ColorRole::AxisPitch, font);
}
