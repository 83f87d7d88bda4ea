// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <QTimer>

class DiffView;
class QListWidget;
class QPushButton;
class QStackedWidget;
class SearchBar;
class TextEditor;

/// The texts that a board keeps (BlockSpec::isText): a configuration file, a mission. What is typed becomes
/// an edit like any other, so that it is reviewed, written, read back and can be undone. Where the family can
/// check the language, the mistake is marked; what differs from the board is shown line by line.
class DocumentsPage final : public Page
{
    Q_OBJECT
public:
    explicit DocumentsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override;
    /// Leads to the text of a block, and to a line of it, from 1; 0: where the cursor is.
    void showText(int block, int line = 0);
    /// Puts a file in place of the text shown, as one edit.
    void loadFrom(const QString &path);
    void saveTo(const QString &path);
    /// Shows what differs from the board instead of the text, or the text again.
    void showDifference(bool shown);
    /// Opens the search, for what is selected or for these words.
    void search(const QString &words = {});
    [[nodiscard]] TextEditor *editor() const { return m_editor; }

protected:
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeHeader();
    void makeBody();
    void connectAll();
    void reload();
    void chooseDocument();
    void showDocument();
    void take();
    void keepDraft();
    [[nodiscard]] Drafts &drafts() const { return workspace().journal().drafts(); }
    [[nodiscard]] QString draftName() const;
    void showState();
    void showMistake();
    void fillDifference();
    void goThere();
    [[nodiscard]] bool isReadable() const;
    [[nodiscard]] QString sizeText() const;
    [[nodiscard]] QByteArray typed() const;
    [[nodiscard]] QByteArray held() const;

    QListWidget *m_list;
    TextEditor *m_editor;
    SearchBar *m_searchBar;
    DiffView *m_diff;
    QStackedWidget *m_views;
    QLabel *m_message;
    QPushButton *m_goThere;
    QPushButton *m_search;
    QPushButton *m_difference;
    QPushButton *m_load;
    QPushButton *m_save;
    QTimer m_takeTimer;
    std::vector<const BlockSpec *> m_documents;  // of the configuration's tables
    const BlockSpec *m_shown = nullptr;
    int m_mistakeLine = 0;  // from 1; 0: none is marked
    bool m_filling = false;
};
