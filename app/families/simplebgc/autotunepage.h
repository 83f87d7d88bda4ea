// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/livemodel.h"

class ArgumentForm;
class Card;
class IterationChart;
class QPushButton;
class QTableWidget;

/// The board searches its own gains: what is asked of it, how it goes, and taking or leaving the result.
class AutoTunePage final : public Page
{
    Q_OBJECT
public:
    enum class State { Ready, Running, Finished };

    explicit AutoTunePage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override { return m_state == State::Finished; }
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] ArgumentForm *form() const { return m_form; }
    [[nodiscard]] QPushButton *startButton() const { return m_start; }
    [[nodiscard]] QPushButton *revertButton() const { return m_revert; }

private:
    void onState();
    void start();
    void onProgress(const Progress &progress);
    void onFinished(const Result<ActionOutcome> &outcome);
    void accept();
    void revert();
    void setState(State state);
    void fillTable();

    LiveModel &m_live;
    ArgumentForm *m_form = nullptr;
    Card *m_ask;
    QLabel *m_text;
    QPushButton *m_start;
    QPushButton *m_stop;
    QPushButton *m_accept;
    QPushButton *m_revert;
    IterationChart *m_gains;
    IterationChart *m_errors;
    QTableWidget *m_table;
    QHash<int, double> m_before;  // parameter -> raw value in use before the run
    QMap<QString, double> m_last;  // latest figures of the run
    State m_state = State::Ready;
};
