// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class ArgumentForm;
class Card;
class QLineEdit;
class QPushButton;
class QTextBrowser;
class QTreeWidget;

/// Every action of the board in a searchable list, with its arguments, what it can do to the gimbal, and its
/// reply.
class ActionsPage final : public Page
{
    Q_OBJECT
public:
    explicit ActionsPage(Workspace &workspace, QWidget *parent = nullptr);

    /// Chooses an action; true if the board has it.
    bool showAction(const QString &key);
    [[nodiscard]] bool isUnderWay() const override { return m_running; }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;
    [[nodiscard]] ArgumentForm *form() const { return m_form; }
    [[nodiscard]] QPushButton *runButton() const { return m_run; }
    [[nodiscard]] QTextBrowser *reply() const { return m_reply; }
    [[nodiscard]] QTreeWidget *list() const { return m_list; }
    [[nodiscard]] QLineEdit *search() const { return m_search; }

private:
    void fillList();
    void refilter();
    void onChosen();
    void run();
    void performNow(const ActionSpec &action, const QVariantMap &arguments);
    [[nodiscard]] std::optional<ActionSpec> chosen() const;
    void updateRun();

    QLineEdit *m_search;
    QTreeWidget *m_list;
    Card *m_card;
    QLabel *m_title;
    QLabel *m_help;
    QLabel *m_risk;
    QVBoxLayout *m_formHolder;
    ArgumentForm *m_form = nullptr;
    QPushButton *m_run;
    QPushButton *m_cancel;
    QTextBrowser *m_reply;
    QString m_board;  // whose reply it is
    std::optional<ActionSpec> m_action;
    bool m_running = false;
};

/// What an action can do, in the operator's words.
[[nodiscard]] QString riskText(ActionRisk risk);
