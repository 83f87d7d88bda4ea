// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class CodeEditor;
class QLabel;
class QLineEdit;
class QToolButton;

/// A bar that searches in the text of an editor: next, previous, how many there are. Letters count as typed
/// only if one of them is a capital.
class SearchBar final : public QWidget
{
    Q_OBJECT
public:
    explicit SearchBar(CodeEditor &editor, QWidget *parent = nullptr);

    /// Shows itself and takes the keyboard; these words are searched for, or what is selected in one line of
    /// the editor.
    void begin(const QString &words = {});
    /// Goes on from where the cursor stands, over the end of the text as well.
    void findNext();
    void findPrevious();
    void end();
    [[nodiscard]] int count() const { return int(m_places.size()); }

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void search();
    void choose(int place);
    [[nodiscard]] int cursor() const;
    void showCount(int chosen);

    CodeEditor &m_editor;
    QLineEdit *m_field;
    QLabel *m_count;
    QToolButton *m_previous;
    QToolButton *m_next;
    QToolButton *m_close;
    std::vector<std::pair<int, int>> m_places;  // bytes
};
