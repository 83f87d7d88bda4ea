// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/guide/setuprecord.h"

class ArgumentForm;
class Card;
class LiveFigures;
class QCheckBox;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTextBrowser;
class SimulatedHands;
class StickInputs;

/// Leads from an unpacked gimbal to a tuned one: the steps, how far they have come, and one of them at a
/// time. What was found is kept with the board's history, so that the way can be gone on with on another day.
class GuidePage final : public Page
{
    Q_OBJECT
public:
    explicit GuidePage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool isUnderWay() const override { return m_running.has_value(); }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;

    void choose(SetupStep step);
    [[nodiscard]] SetupStep chosen() const { return m_chosen; }
    [[nodiscard]] const SetupRecord &record() const { return m_record; }
    [[nodiscard]] QListWidget *list() const { return m_list; }
    [[nodiscard]] QPushButton *beginButton() const { return m_begin; }
    [[nodiscard]] QPushButton *skipButton() const { return m_skip; }
    [[nodiscard]] QPushButton *nextButton() const { return m_next; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] QPushButton *elsewhereButton() const { return m_elsewhere; }
    [[nodiscard]] QPushButton *forgetButton() const { return m_forget; }
    [[nodiscard]] QCheckBox *confirmBox() const { return m_confirm; }
    [[nodiscard]] ArgumentForm *form() const { return m_form; }
    [[nodiscard]] QTextBrowser *findings() const { return m_findings; }
    /// What the step that runs asks for.
    [[nodiscard]] const Progress &asks() const { return m_asks; }
    [[nodiscard]] StickInputs *remote() const { return m_remote; }
    [[nodiscard]] LiveFigures *live() const { return m_live; }
    /// Writes the certificate; a name that ends in .pdf gets that, all others HTML. Errors: BadFile.
    Result<void> saveCertificate(const QString &path) const;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    [[nodiscard]] Card *makeStep();
    [[nodiscard]] static QString pageTitle(const QString &key);
    void load();
    void compare();
    void goToNext();
    void save();
    void fillList();
    void showStep();
    void showFindings();
    void updateButtons();
    void begin();
    void skip();
    void forget();
    void finished(SetupStep step, const Result<SetupResult> &result);
    void endWhatGoesOn(const Error &error);
    void goOn();
    void onProgress(const Progress &progress);

    QListWidget *m_list;
    QLabel *m_title;
    QLabel *m_help;
    QLabel *m_needs;
    QVBoxLayout *m_formHolder;
    ArgumentForm *m_form = nullptr;
    QCheckBox *m_confirm;
    QPushButton *m_begin;
    QPushButton *m_skip;
    QPushButton *m_cancel;
    QPushButton *m_next;
    QPushButton *m_elsewhere;
    QPushButton *m_forget;
    QPushButton *m_certificate;
    QLabel *m_doing;
    QProgressBar *m_progress;
    QTextBrowser *m_findings;
    SimulatedHands *m_hands;
    StickInputs *m_remote;
    LiveFigures *m_live;
    std::vector<SetupStep> m_steps;
    SetupStep m_chosen = SetupStep::Power;
    std::optional<SetupStep> m_running;
    Progress m_asks;
    SetupRecord m_record;
    QString m_board;  // whose record it is
};
