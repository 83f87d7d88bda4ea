// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/analysis/accelerometer.h"

#include <QTimer>

class Card;
class CopyCard;
class FaceList;
class MagnetometerCard;
class QComboBox;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class SensorCube;
class SimulatedHands;

/// Calibration step by step: what to do, what the program sees, when it is satisfied, how good the result is.
class CalibrationPage final : public Page
{
    Q_OBJECT
public:
    enum class Kind { Gyroscope, Level, SixPositions };
    enum class Step { Choose, Place, Measure, Result };

    explicit CalibrationPage(Workspace &workspace, QWidget *parent = nullptr);

    void start(Kind kind);
    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] bool isUnderWay() const override;
    [[nodiscard]] QPushButton *continueButton() const { return m_continue; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] QPushButton *backButton() const { return m_back; }
    [[nodiscard]] CopyCard *copies() const { return m_copies; }
    [[nodiscard]] QComboBox *sensorBox() const { return m_sensor; }
    [[nodiscard]] MagnetometerCard *magnetometer() const { return m_magnetometer; }
    void startMagnetometer();
    /// The sensor has been still for long enough and lies as it should.
    [[nodiscard]] bool isSatisfied() const { return m_satisfied; }
    /// Positions that are done.
    [[nodiscard]] int doneCount() const;
    /// Which face lies up, -1 = none; as setPosition() of SensorCube counts.
    [[nodiscard]] int faceUp() const { return m_face; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    [[nodiscard]] QWidget *makeChooser();
    [[nodiscard]] QWidget *makeFurther();
    [[nodiscard]] QWidget *makeWizard();
    void setStep(Step step);
    void followSensor();
    void look();
    void measure();
    void onMeasured(const Result<ActionOutcome> &outcome);
    void showResult();
    void breakOff();
    void cancel();
    void updateButtons();
    [[nodiscard]] QString waitingFor() const;

    struct Quality
    {
        double biasAfter = 0;
        double biasBefore = 0;
        double noise = 0;
        double level = 0;  // g, in the last position
    };
    Kind m_kind = Kind::Gyroscope;
    Step m_step = Step::Choose;
    unsigned m_done = 0;  // positions, bit by face
    Quality m_quality;
    int m_face = -1;
    int m_measuring = 0;  // position being measured
    AccReading m_acc{};  // g
    double m_motion = 0;  // standard deviation of the gyroscope, deg/s
    bool m_satisfied = false;
    QStackedWidget *m_stack;
    CopyCard *m_copies = nullptr;
    QComboBox *m_sensor;  // which one the board shows and calibrates
    double m_begunWith = 0;  // that one, when the wizard began
    Card *m_further = nullptr;  // what only boards with a magnetometer have
    MagnetometerCard *m_magnetometer;
    QLabel *m_what;
    QLabel *m_sees;
    QLabel *m_result;
    SensorCube *m_cube;
    QProgressBar *m_stillness;
    QProgressBar *m_progress;
    FaceList *m_positions;
    SimulatedHands *m_hands;
    QPushButton *m_back;
    QPushButton *m_cancel;
    QPushButton *m_continue;
    QTimer m_timer;
};
