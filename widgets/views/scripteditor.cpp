// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/scripteditor.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QSet>
#include <Qsci/qsciapis.h>
#include <Qsci/qscilexercustom.h>
#include <Qsci/qscistyle.h>

using namespace Qt::StringLiterals;

namespace {

enum Style { PlainStyle, WordStyle, NumberStyle, StringStyle, CommentStyle, StyleCount };

constexpr int kMistakeMarker = 3;
constexpr int kNumberMargin = 0;

}  // namespace

/// Colours words, numbers, quoted names and comments.
class ScriptEditor::Lexer final : public QsciLexerCustom
{
public:
    explicit Lexer(QsciScintilla *parent)
        : QsciLexerCustom(parent)
    {
    }

    void setWords(const QStringList &words)
    {
        m_words.clear();
        for (const QString &word : words)
            m_words.insert(word.toUpper());
    }
    [[nodiscard]] const char *language() const override { return "script"; }
    [[nodiscard]] QString description(int style) const override
    {
        return style < StyleCount ? QString::number(style) : QString();
    }
    // "#" belongs to words: CASE#1.
    [[nodiscard]] const char *wordCharacters() const override
    {
        return "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_#";
    }

    void styleText(int start, int end) override
    {
        // Statements never pass the end of a line, so whole lines are styled.
        const int first = int(editor()->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, start));
        const int from = int(editor()->SendScintilla(QsciScintillaBase::SCI_POSITIONFROMLINE, first));
        QByteArray bytes(end - from + 1, '\0');
        editor()->SendScintilla(QsciScintillaBase::SCI_GETTEXTRANGE, from, end, bytes.data());
        bytes.chop(1);
        startStyling(from);
        for (qsizetype at = 0; at < bytes.size();) {
            const qsizetype begin = at;
            const char c = bytes[at];
            Style style = PlainStyle;
            const auto run = [&](auto &&inside) {
                while (at < bytes.size() && bytes[at] != '\n' && inside(bytes[at]))
                    ++at;
            };
            if (c == ';' || (c == '/' && at + 1 < bytes.size() && bytes[at + 1] == '/')) {
                style = CommentStyle;
                run([](char) { return true; });
            } else if (c == '"') {
                style = StringStyle;
                ++at;
                run([](char each) { return each != '"'; });
                if (at < bytes.size() && bytes[at] == '"')
                    ++at;
            } else if (std::isalpha(std::uint8_t(c))) {
                run([](char each) { return std::isalnum(std::uint8_t(each)) || each == '#' || each == '_'; });
                if (m_words.contains(QString::fromLatin1(bytes.mid(begin, at - begin)).toUpper()))
                    style = WordStyle;
            } else if (std::isdigit(std::uint8_t(c)) || c == '-') {
                style = NumberStyle;
                ++at;
                run([](char each) { return std::isdigit(std::uint8_t(each)) || each == '.'; });
            } else {
                ++at;
            }
            setStyling(int(at - begin), style);
        }
    }

private:
    QSet<QString> m_words;
};

ScriptEditor::ScriptEditor(Theme &theme, QWidget *parent)
    : QsciScintilla(parent)
    , m_theme(theme)
    , m_lexer(new Lexer(this))
    , m_apis(new QsciAPIs(m_lexer))
{
    setLexer(m_lexer);
    setUtf8(true);
    setMarginType(kNumberMargin, NumberMargin);
    setMarginLineNumbers(kNumberMargin, true);
    setMarginWidth(1, 0);
    setAutoCompletionSource(AcsAPIs);
    setAutoCompletionThreshold(2);
    setAutoCompletionCaseSensitivity(false);
    setCaretLineVisible(true);
    setTabWidth(2);
    setIndentationsUseTabs(false);
    setAutoIndent(true);
    setWrapMode(WrapNone);
    setFrameShape(QFrame::StyledPanel);
    setAnnotationDisplay(AnnotationBoxed);
    markerDefine(Background, kMistakeMarker);
    SendScintilla(SCI_SETSCROLLWIDTHTRACKING, 1);
    SendScintilla(SCI_SETSCROLLWIDTH, 1);
    connect(&theme, &Theme::changed, this, &ScriptEditor::applyTheme);
    applyTheme();
}

ScriptEditor::~ScriptEditor()
{
    setLexer(nullptr);  // it is destroyed with the children, after this class
}

void ScriptEditor::applyTheme()
{
    const QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const auto color = [this](ColorRole role) { return m_theme.color(role); };
    m_lexer->setDefaultFont(font);
    m_lexer->setDefaultPaper(color(ColorRole::Surface));
    m_lexer->setDefaultColor(color(ColorRole::Text));
    const std::array<QColor, StyleCount> colors{color(ColorRole::Text), color(ColorRole::Accent),
                                                color(ColorRole::AxisPitch), color(ColorRole::AxisRoll),
                                                color(ColorRole::Muted)};
    for (int style = 0; style < StyleCount; ++style) {
        m_lexer->setColor(colors[std::size_t(style)], style);
        m_lexer->setPaper(color(ColorRole::Surface), style);
        QFont styled = font;
        styled.setBold(style == WordStyle);
        m_lexer->setFont(styled, style);
    }
    setPaper(color(ColorRole::Surface));
    setColor(color(ColorRole::Text));
    setCaretForegroundColor(color(ColorRole::Text));
    setCaretLineBackgroundColor(color(ColorRole::SurfaceRaised));
    setMarginsBackgroundColor(color(ColorRole::Background));
    setMarginsForegroundColor(color(ColorRole::Muted));
    setMarginsFont(font);
    setMarginWidth(kNumberMargin, u"0000"_s);
    setSelectionBackgroundColor(color(ColorRole::Accent));
    setSelectionForegroundColor(color(ColorRole::AccentText));
    QColor wrong = color(ColorRole::Danger);
    wrong.setAlpha(50);
    setMarkerBackgroundColor(wrong, kMistakeMarker);
    if (m_mistake > 0)
        showMistake(m_mistake, m_mistakeText);
}

void ScriptEditor::setWords(const QStringList &words)
{
    m_lexer->setWords(words);
    m_apis->clear();
    for (const QString &word : words)
        m_apis->add(word);
    m_apis->prepare();
    recolor();
}

void ScriptEditor::showMistake(int line, const QString &text)
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

// Tab leaves the editor, as it leaves every other field; scripts need none.
void ScriptEditor::keyPressEvent(QKeyEvent *event)
{
    const bool completing = isListActive();
    if (!completing && (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab)) {
        // The editor's own refuses. NOLINTNEXTLINE(bugprone-parent-virtual-call)
        QAbstractScrollArea::focusNextPrevChild(event->key() == Qt::Key_Tab);
        return;
    }
    QsciScintilla::keyPressEvent(event);
}

bool ScriptEditor::event(QEvent *event)
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
