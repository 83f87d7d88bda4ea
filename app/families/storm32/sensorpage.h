// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class FaceList;
class QComboBox;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class SensorCube;
class SimulatedHands;

/// Calibration of accelerometers whose readings the program averages itself: the sensor is laid on its faces,
/// each is measured as soon as it lies still; the result is looked at before it is stored.
class SensorPage final : public Page
{
    Q_OBJECT
public:
    enum class Step { Choose, Measure, Result };

    explicit SensorPage(Workspace &workspace, QWidget *parent = nullptr);

    void start(bool six);
    [[nodiscard]] bool isUnderWay() const override { return m_step != Step::Choose; }
    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] int doneCount() const;
    [[nodiscard]] QPushButton *storeButton() const { return m_store; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] QString sees() const;
    /// Takes a calibration out of a file, to be looked at and stored. Errors: BadFile.
    Result<void> loadFile(const QString &path);
    Result<void> saveFile(const QString &path) const;
    [[nodiscard]] const SensorCalibration &calibration() const { return m_calibration; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    [[nodiscard]] QWidget *makeChooser();
    [[nodiscard]] QWidget *makeWizard();
    void setStep(Step step);
    void onProgress(const Progress &progress);
    void onMeasured(const Result<ActionOutcome> &outcome);
    void showResult();
    void breakOff();
    void store();
    void updateState();

    Step m_step = Step::Choose;
    bool m_six = false;
    unsigned m_missing = 0;  // faces still to be measured, bit by face
    SensorCalibration m_calibration;
    double m_quality = 0;  // g
    double m_oneG = 0;
    bool m_plausible = true;
    QStackedWidget *m_stack;
    QComboBox *m_imu;
    QLabel *m_what;
    QLabel *m_sees;
    QLabel *m_live;
    QLabel *m_result;
    SensorCube *m_cube;
    FaceList *m_faces;
    QProgressBar *m_progress;
    SimulatedHands *m_hands;
    QPushButton *m_sixButton = nullptr;
    QPushButton *m_oneButton = nullptr;
    QPushButton *m_load;
    QPushButton *m_save;
    QPushButton *m_cancel;
    QPushButton *m_again;
    QPushButton *m_store;
};
