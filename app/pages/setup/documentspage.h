// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <QTimer>

class QListWidget;
class QPlainTextEdit;
class QPushButton;

/// The texts that a board keeps (BlockSpec::isText): a configuration file, a mission. What is typed becomes
/// an edit like any other, so that it is reviewed, written, read back and can be undone.
class DocumentsPage final : public Page
{
    Q_OBJECT
public:
    explicit DocumentsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override;
    /// Leads to the text of a block.
    void showText(int block);
    /// Puts a file in place of the text shown, as one edit.
    void loadFrom(const QString &path);
    void saveTo(const QString &path);

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
    [[nodiscard]] QByteArray typed() const;
    [[nodiscard]] QByteArray held() const;

    QListWidget *m_list;
    QPlainTextEdit *m_editor;
    QLabel *m_message;
    QPushButton *m_load;
    QPushButton *m_save;
    QTimer m_takeTimer;
    std::vector<const BlockSpec *> m_documents;  // of the configuration's tables
    const BlockSpec *m_shown = nullptr;
    bool m_filling = false;
};
