// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/views/codeeditor.h"

class QsciAPIs;

/// Text of a script that a board keeps: its words are coloured and completed.
class ScriptEditor final : public CodeEditor
{
    Q_OBJECT
public:
    explicit ScriptEditor(Theme &theme, QWidget *parent = nullptr);

    /// Words of the language; names in quotes are completed too.
    void setWords(const QStringList &words);

protected:
    void colorLexer(const QFont &font) override;

private:
    class Lexer;
    Lexer *m_lexer;
    QsciAPIs *m_apis;
};
