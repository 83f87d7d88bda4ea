// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "protocol/device/motorlayout.h"
#include "protocol/procedure/directioncheck.h"
#include "widgets/views/card.h"

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class SimulatedHands;

/// Leads through the check of directions (DirectionCheck): what to do, what the program sees, what to answer.
/// What was found is kept for this board and configuration.
class DirectionCard final : public Card
{
    Q_OBJECT
public:
    explicit DirectionCard(Workspace &workspace, QWidget *parent = nullptr);

    /// What is known of the connected board.
    [[nodiscard]] CheckedDirections found() const;
    [[nodiscard]] bool isChecking() const { return m_check.has_value(); }
    [[nodiscard]] const DirectionCheck *check() const { return m_check ? &*m_check : nullptr; }
    /// It has to be armed without propellers for the step that is on.
    [[nodiscard]] bool wantsArmed() const { return m_check && m_check->isArmedStep(); }
    /// @param known what was found before; checking begins with what is missing
    void begin(const CheckedDirections &known = {});
    void cancel();
    struct Session
    {
        bool isOpen = false;
        bool isHeld = false;  ///< in a test stand, with its propellers on
        bool isArmed = false;
    };
    /// What is measured now. @param sticks as the operator pushes them
    void feed(const DirectionCheck::Axes &sticks, const Session &session);

    [[nodiscard]] QPushButton *beginButton() const { return m_begin; }
    /// "It is the drone that was checked", where nobody has said so yet.
    [[nodiscard]] QPushButton *sameButton() const { return m_same; }
    [[nodiscard]] QPushButton *yesButton() const { return m_yes; }
    [[nodiscard]] QPushButton *noButton() const { return m_no; }
    [[nodiscard]] QString instruction() const;
    /// The motors, from 1, that are asked about now.
    [[nodiscard]] QList<int> asked() const;

signals:
    /// It has begun, ended, or is at another step.
    void stepChanged();
    /// It ends, however it does, while it can still be armed for it.
    void ending();
    /// The operator works at it: an answer, a tilt.
    void worked();

private:
    [[nodiscard]] bool isAsking() const;
    void show();
    void showSame();
    [[nodiscard]] QString checkedText() const;
    [[nodiscard]] QString presumedText() const;
    void answer(bool isRight);
    [[nodiscard]] QString sees() const;
    /// What is missing until the motors of this step are compared.
    [[nodiscard]] QString waitsFor(const DirectionCheck::Step &step) const;
    [[nodiscard]] QString handsText() const;
    [[nodiscard]] QString question() const;

    [[nodiscard]] QString lacking() const;
    [[nodiscard]] std::vector<MotorShare> shares() const;
    [[nodiscard]] CheckedDirections withMotors(CheckedDirections found) const;
    [[nodiscard]] std::array<int, kAxisCount> sizes() const;

    Workspace &m_workspace;
    Session m_session;
    std::optional<DirectionCheck> m_check;
    DirectionCheck::Axes m_seenAngles{};  // when it was last said that it is worked at
    int m_shownStep = -1;
    QLabel *m_what;
    QLabel *m_sees;
    QProgressBar *m_progress;
    SimulatedHands *m_hands;
    QPushButton *m_same;
    QPushButton *m_begin;
    QPushButton *m_anew;
    QPushButton *m_cancel;
    QPushButton *m_yes;
    QPushButton *m_no;
};
