// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <Qsci/qsciscintilla.h>

class QsciAPIs;

/// Text of a program that a board keeps: line numbers, the language's words in colour, completion, the wrong
/// line marked.
class ScriptEditor final : public QsciScintilla
{
    Q_OBJECT
public:
    explicit ScriptEditor(Theme &theme, QWidget *parent = nullptr);
    ~ScriptEditor() override;

    /// Words of the language; names in quotes are completed too.
    void setWords(const QStringList &words);
    /// Marks a line (from 1) and shows the mistake beneath it; 0 removes the mark.
    void showMistake(int line, const QString &text);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

private:
    void applyTheme();

    class Lexer;
    Theme &m_theme;
    Lexer *m_lexer;
    QsciAPIs *m_apis;
    int m_mistake = 0;
    QString m_mistakeText;
};
