// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <functional>

class QLineEdit;
class QListWidget;
class QTextBrowser;

/// One help text for each page, opened by F1, searchable.
class HelpPage final : public Page
{
    Q_OBJECT
public:
    /// @param isOffered whether the page of that key is one that the board shown has; texts of others are not
    /// listed
    HelpPage(Workspace &workspace, std::function<bool(const QString &key)> isOffered,
             QWidget *parent = nullptr);

    /// Shows the text of a page; the introduction where there is none.
    void showTopic(const QString &key);
    [[nodiscard]] QString topic() const;
    [[nodiscard]] std::any keep() override { return topic(); }
    void resume(const std::any &kept) override { showTopic(std::any_cast<QString>(kept)); }
    [[nodiscard]] QLineEdit *search() const { return m_search; }
    /// Keys of all texts, in reading order.
    [[nodiscard]] static QStringList allTopics();

private:
    void refilter();
    void showCurrent();

    std::function<bool(const QString &)> m_isOffered;
    QLineEdit *m_search;
    QListWidget *m_topics;
    QTextBrowser *m_text;
};
