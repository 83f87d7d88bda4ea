// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/scripteditor.h"

#include <QSet>
#include <Qsci/qsciapis.h>
#include <Qsci/qscilexercustom.h>

#include <array>

using namespace Qt::StringLiterals;

namespace {

enum Style { PlainStyle, WordStyle, NumberStyle, StringStyle, CommentStyle, StyleCount };

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
    : CodeEditor(theme, parent)
    , m_lexer(new Lexer(this))
    , m_apis(new QsciAPIs(m_lexer))
{
    setLexer(m_lexer);
    setAutoCompletionSource(AcsAPIs);
    setAutoCompletionThreshold(2);
    setAutoCompletionCaseSensitivity(false);
    followTheme();
}

void ScriptEditor::colorLexer(const QFont &font)
{
    constexpr std::array<ColorRole, StyleCount> kRoles{
        ColorRole::Text, ColorRole::Accent, ColorRole::AxisPitch, ColorRole::AxisRoll, ColorRole::Muted};
    for (int style = 0; style < StyleCount; ++style) {
        QFont styled = font;
        styled.setBold(style == WordStyle);
        colorStyle(style, kRoles[std::size_t(style)], styled);
    }
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
