// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <QTimer>

class ParameterForm;
class QListWidget;
class QProgressBar;
class QPushButton;
class ScriptEditor;

/// The programs that a board keeps: text, checked while it is typed; what comes of it; taken over as an edit
/// like any other, so that it is reviewed, written, read back and can be undone.
class ScriptsPage final : public Page
{
    Q_OBJECT
public:
    explicit ScriptsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override;
    void showScript(int script);
    [[nodiscard]] ScriptEditor *editor() const { return m_editor; }
    [[nodiscard]] QPushButton *takeButton() const { return m_take; }
    [[nodiscard]] QPushButton *revertButton() const { return m_revert; }
    [[nodiscard]] QListWidget *listing() const { return m_listing; }
    [[nodiscard]] QString message() const;

private:
    [[nodiscard]] const ScriptLanguage *language() const;
    [[nodiscard]] bool isTyped() const;
    [[nodiscard]] Drafts &drafts() const { return workspace().journal().drafts(); }
    void keepDrafts();
    void reload();
    void onTyped();
    void askToDiscard();
    void discard();
    void check();
    void take();
    void showState();
    void load();
    void save();

    QListWidget *m_list;
    ScriptEditor *m_editor;
    QLabel *m_message;
    ParameterForm *m_input;
    QListWidget *m_listing;
    QProgressBar *m_memory;
    QLabel *m_memoryText;
    QPushButton *m_load;
    QPushButton *m_save;
    QPushButton *m_revert;
    QPushButton *m_take;
    QTimer m_checkTimer;
    QStringList m_texts;  // as typed
    QStringList m_taken;  // as the configuration has them
    CompiledScripts m_code;  // of the texts
    int m_script = 0;
    bool m_filling = false;
};
