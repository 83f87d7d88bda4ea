// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/livemodel.h"

#include <QTimer>

#include <array>
#include <functional>

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
    [[nodiscard]] bool isUnderWay() const override { return m_state != State::Ready; }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] ArgumentForm *form() const { return m_form; }
    [[nodiscard]] QPushButton *startButton() const { return m_start; }
    [[nodiscard]] QPushButton *revertButton() const { return m_revert; }

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    [[nodiscard]] static QString readyText();
    void onState();
    void start();
    void stop();
    void offerToStore();
    [[nodiscard]] bool isAsBefore() const;
    void onProgress(const Progress &progress);
    void onFinished(const Result<ActionOutcome> &outcome);
    /// How far the axes are from their targets, RMS of the last seconds in degrees; NaN: not known.
    [[nodiscard]] std::array<double, kAxisCount> errors() const;
    void judge();
    /// What a link that broke has left to be looked after.
    enum class Left {
        Nothing,
        Searching,  ///< the board may be searching on
        Found,  ///< new gains are in use, neither accepted nor reverted
    };
    struct Kept
    {
        Left left;
        QString board;
        QHash<int, double> before;
    };
    void clearUp(Left left);
    void tellLeft(const Configuration &board, Left left);
    void accept();
    void revert(const std::function<void()> &tell);
    void revertAndTell();
    /// What was found is no longer what waits for an answer: another profile is in use, or others have stored
    /// or reverted it.
    void onValues();
    void leaveProfile();
    void giveUp(bool tells);
    void tellReverted(const QString &measured);
    [[nodiscard]] int activeProfile() const;
    void setState(State state);
    void updateStart();
    void fillTable();
    [[nodiscard]] std::optional<double> tried(const ParameterSpec &spec) const;

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
    int m_profile = 0;  // whose values these are
    bool m_isUnstored = false;  // what was found has been seen in use without being stored
    bool m_isGone = false;  // no more, before it was judged
    QMap<QString, double> m_last;  // latest figures of the run
    std::array<double, kAxisCount> m_errorBefore{};
    QTimer m_following;  // what is in use while the search goes on
    QTimer m_judging;  // what was found is measured before it is recommended
    std::function<void()> m_whenReverted;
    Left m_left = Left::Nothing;
    QString m_board;  // that has searched last
    State m_state = State::Ready;
    bool m_mayBeStored = false;  // what a search that was broken off had found
    bool m_goesOn = false;  // the search, although it was told to stop
};
