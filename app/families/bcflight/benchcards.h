// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "widgets/views/card.h"

#include <array>

class ElidedLabel;
class QLabel;
class QProgressBar;
class QPushButton;

/// The calibration of the motor controllers: its three phases, and which of them goes on.
class EscCard final : public Card
{
    Q_OBJECT
public:
    explicit EscCard(QWidget *parent = nullptr);

    [[nodiscard]] QPushButton *startButton() const { return m_start; }
    /// Why it cannot be started now; empty: it can.
    void setObstacle(const QString &why);
    void take(const Progress &progress);
    void setRunning(bool running);
    /// The phase that goes on, from 0; -1: none.
    [[nodiscard]] int phase() const { return m_phase; }

private:
    void showState();

    QPushButton *m_start;
    std::array<QLabel *, 3> m_phases{};
    QProgressBar *m_bar;
    QLabel *m_why;
    int m_phase = -1;
};

/// Another firmware: a file is chosen, looked at, uploaded with progress and a way to break off; what that
/// leaves behind is said.
class FirmwareCard final : public Card
{
    Q_OBJECT
public:
    explicit FirmwareCard(Workspace &workspace, QWidget *parent = nullptr);

    void choose(const QString &path);
    /// Why nothing can be uploaded now; empty: it can.
    void setObstacle(const QString &why);
    void take(const Progress &progress);
    [[nodiscard]] bool isRunning() const { return m_isRunning; }
    [[nodiscard]] QPushButton *uploadButton() const { return m_upload; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] QString said() const;

signals:
    void runningChanged(bool running);

private:
    [[nodiscard]] bool refusesBattery();
    void upload();
    void onDone(const Result<ActionOutcome> &outcome);
    void setRunning(bool running);
    void say(const QString &text, const char *look);
    void showState();

    Workspace &m_workspace;
    ElidedLabel *m_file;
    QLabel *m_about;
    QPushButton *m_choose;
    QPushButton *m_upload;
    QPushButton *m_cancel;
    QProgressBar *m_bar;
    QLabel *m_why;
    QLabel *m_said;
    QString m_path;
    bool m_isRunning = false;
    bool m_hasBegun = false;  // something of it is on the drone
    bool m_isRestarting = false;  // and cannot be called back
};
