// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/views/card.h"

class ArmedState;
class EscCard;
class FirmwareCard;
class MotorDiagram;
class NumberBox;
class QProgressBar;
class QPushButton;

/// What is done with a drone on the bench, its propellers off: one motor is turned, motors beep, their
/// controllers are calibrated, another firmware is uploaded. What makes the drone deaf is counted down here.
class BenchPage final : public Page
{
    Q_OBJECT
public:
    explicit BenchPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool isUnderWay() const override { return m_isRunning; }
    [[nodiscard]] MotorDiagram *motors() const { return m_motors; }
    [[nodiscard]] QPushButton *turnButton() const { return m_turn; }
    [[nodiscard]] FirmwareCard *firmware() const { return m_firmware; }
    [[nodiscard]] EscCard *escs() const { return m_escs; }
    /// What is said of the time in which the drone hears nothing; empty: it hears.
    [[nodiscard]] QString deafText() const;
    /// Why no motor can be turned now; empty: it can.
    [[nodiscard]] QString obstacle() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    QWidget *makeMotors();
    QWidget *makeSignals();
    void connectAll();
    void refresh();
    void refreshDeaf();
    void turn();
    void beep(bool on);
    void calibrateEscs();
    void begin(bool running);
    void onProgress(const Progress &progress);

    bool m_isRunning = false;
    int m_turned = 0;  // asked about, or turning; 0: none
    ArmedState *m_state;
    MotorDiagram *m_motors;
    NumberBox *m_number;
    QPushButton *m_turn;
    QLabel *m_why;
    QLabel *m_deaf;
    QProgressBar *m_deafBar;
    double m_deafFor = 0;  // seconds, when it began
    QPushButton *m_beep;
    QPushButton *m_silence;
    QPushButton *m_go;
    QString m_lacking;  // the action that it needs first
    QLabel *m_beepSaid;
    EscCard *m_escs;
    FirmwareCard *m_firmware;
};
