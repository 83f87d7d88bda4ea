// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class NumberBox;
class Card;
class QCheckBox;
class QListWidget;
class QProgressBar;
class QPushButton;
class SimulatedHands;

/// Sets a gimbal up, task by task: how its sensors sit, its motors, where they start. Each task says what to
/// do and what the program waits for; nothing is stored before the end.
class SetupPage final : public Page
{
    Q_OBJECT
public:
    enum class Task { Orientation, Poles, AutoDirections, TakeDirections, StartPositions, AlignYaw };
    static constexpr int kTasks = 6;
    /// What the wizard is doing: a task, or what lies between them.
    enum class Step {
        Choose,
        MotorsOff,
        Orientation,
        Poles,
        AutoDirections,
        AskStart,
        Start,
        Take,
        AlignYaw,
        AskFinish,
        Finish,
        Done
    };

    explicit SetupPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] bool isUnderWay() const override { return m_step != Step::Choose && m_step != Step::Done; }
    [[nodiscard]] QCheckBox *box(Task task) const { return m_boxes[std::size_t(task)]; }
    [[nodiscard]] QPushButton *continueButton() const { return m_continue; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] NumberBox *poles(Axis axis) const { return m_poles[std::size_t(axis)]; }
    [[nodiscard]] double yaw() const { return m_yaw; }
    [[nodiscard]] QString what() const;
    [[nodiscard]] QString sees() const;
    /// What was done so far, a line each.
    [[nodiscard]] QStringList report() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    [[nodiscard]] QWidget *makeTasks();
    [[nodiscard]] QWidget *makeGuide();
    void begin();
    void next();
    void enter(Step step);
    void leadOn();
    void sayWhatToDo();
    void showPoles();
    [[nodiscard]] QSet<QString> setHere() const;
    void runStep();
    void finished(const Result<ActionOutcome> &outcome);
    void onContinue();
    void cancel();
    void breakOff();
    void showYaw();
    void moveYaw(double by);
    void onProgress(const Progress &progress);
    void updateState();
    [[nodiscard]] bool wants(Task task) const;
    void note(const QString &text);

    Step m_step = Step::Choose;
    bool m_failed = false;  // the step can be done again
    bool m_running = false;
    bool m_yawBegun = false;
    double m_yaw = 0;  // degrees
    int m_run = 0;  // answers of an earlier run are dropped
    std::array<QCheckBox *, kTasks> m_boxes{};
    Card *m_tasks;
    SimulatedHands *m_hands;
    QLabel *m_what;
    QLabel *m_sees;
    QProgressBar *m_held;
    QWidget *m_polesForm = nullptr;
    std::array<NumberBox *, kAxisCount> m_poles{};
    QWidget *m_yawForm = nullptr;
    QLabel *m_yawText;
    QListWidget *m_report;
    QPushButton *m_cancel;
    QPushButton *m_continue;
};
