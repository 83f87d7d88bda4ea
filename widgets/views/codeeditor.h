// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <Qsci/qsciscintilla.h>

#include <span>

/// Text of a program: line numbers, the language's words in colour, the wrong line marked. Tab leaves it.
class CodeEditor : public QsciScintilla
{
    Q_OBJECT
public:
    explicit CodeEditor(Theme &theme, QWidget *parent = nullptr);
    ~CodeEditor() override;

    /// The text as it is, in UTF-8 and with the ends of its lines.
    [[nodiscard]] QByteArray bytes() const;
    /// Only what differs is replaced, so that the place that is seen stays.
    void setBytes(const QByteArray &bytes);
    /// Leads to a line, from 1, and shows what is around it.
    void goToLine(int line);
    /// Marks a line (from 1) and shows the mistake beneath it; 0 removes the mark.
    void showMistake(int line, const QString &text);
    /// Marks every place that was found, from a byte to behind one, and selects one of them; -1: none.
    void showFound(std::span<const std::pair<int, int>> places, int chosen);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

    [[nodiscard]] Theme &theme() const { return m_theme; }
    /// To be called once the lexer is there; it then follows the theme.
    void followTheme();
    /// Gives the lexer's styles their colours.
    virtual void colorLexer(const QFont &font) { Q_UNUSED(font) }
    void colorStyle(int style, ColorRole role, const QFont &font);
    void applyTheme();

private:
    Theme &m_theme;
    int m_mistake = 0;
    QString m_mistakeText;
};

/// A text in a language that the program knows by its name ("lua"), or in none. It keeps no steps to undo:
/// whoever holds the text does.
class TextEditor final : public CodeEditor
{
    Q_OBJECT
public:
    explicit TextEditor(Theme &theme, QWidget *parent = nullptr);

    void setLanguage(const QString &language);

protected:
    void colorLexer(const QFont &font) override;

private:
    QString m_language;
};
