// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/framelogmodel.h"

class FilterTable;
class QCheckBox;
class QLineEdit;
class QPushButton;
class QTextBrowser;
struct RawCommand;

/// Every frame in and out, decoded; and sending by name or in hex.
class ConsolePage final : public Page
{
    Q_OBJECT
public:
    explicit ConsolePage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] FrameLogModel &model() { return m_model; }
    [[nodiscard]] QLineEdit *input() const { return m_input; }
    void send();
    /// Errors: BadFile.
    Result<void> saveText(const QString &path) const;

private:
    void refresh();
    void showDetails(const QModelIndex &shown);
    void sendNow(const RawCommand &command);

    FrameLogModel m_model;
    FilterTable *m_table;
    QLineEdit *m_filter;
    QCheckBox *m_streams;
    QPushButton *m_pause;
    QTextBrowser *m_details;
    QLineEdit *m_input;
    QCheckBox *m_allow;
    bool m_follow = true;
};
