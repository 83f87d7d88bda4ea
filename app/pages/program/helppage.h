// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class QLineEdit;
class QListWidget;
class QTextBrowser;

/// One help text for each page, opened by F1, searchable.
class HelpPage final : public Page
{
    Q_OBJECT
public:
    explicit HelpPage(Workspace &workspace, QWidget *parent = nullptr);

    /// Shows the text of a page; the introduction where there is none.
    void showTopic(const QString &key);
    [[nodiscard]] QString topic() const;
    [[nodiscard]] QLineEdit *search() const { return m_search; }
    /// Keys of all texts, in reading order.
    [[nodiscard]] static QStringList allTopics();

private:
    void refilter();
    void showCurrent();

    QLineEdit *m_search;
    QListWidget *m_topics;
    QTextBrowser *m_text;
};
