// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>

class MainWindow;

/// Visits pages, wizard steps and dialogs with a running simulated board and saves a PNG of each.
class Tour final : public QObject
{
    Q_OBJECT
public:
    enum class Extent { Pages, Everything };

    /// Pictures go to this folder, which is made if need be; their names end in the suffix.
    /// @param family only with a board of that family; empty: with one of each that the program was built
    /// with
    Tour(MainWindow &window, QString folder, QString suffix, Extent extent, QString family = {},
         QObject *parent = nullptr);

    /// Runs all steps once the board has been read.
    void start();

signals:
    /// Paths of the pictures; empty when something failed, then the error says what.
    void finished(const QStringList &pictures, const QString &error);

private:
    struct Step
    {
        QString name;  ///< of the picture; empty = none
        std::function<void()> prepare;
        std::function<bool()> ready;  ///< empty = only the time counts
        int settleMs = 400;
        std::function<QWidget *()> what;  ///< empty = the window
        bool everythingOnly = false;
    };
    void addSteps();
    void addStepsOf(const QString &family);
    void addGamepadStep();
    void addConnecting(const QString &family);
    void addSimpleBgcSteps();
    void addEditSteps();
    void addCalibrationSteps();
    void addTelemetrySteps();
    void addMotionSteps();
    void addProgramSteps();
    void addDialogSteps();
    void addReplaySteps();
    void addFamilySteps(const QString &family);
    void addDroneSteps(const QString &family);
    void addBenchSteps(const QString &family);
    void addCameraSteps(const QString &family);
    void addFlightSteps(const QString &family);
    void addTextSteps(const QString &family);
    void addBlackBoxSteps(const QString &family);
    void addFamilyWatchSteps(const QString &family);
    void addFamilyTuningSteps(const QString &family);
    void addSensorSteps(const QString &family);
    void addRemoteSteps();
    void addSetupSteps(const QString &family);
    void addScriptSteps(const QString &family);
    void addFamilyBoardSteps(const QString &family);
    void begin();
    void poll();
    void fail(const QString &error);
    bool save(const Step &step);
    [[nodiscard]] std::function<void()> show(const QString &page);

    MainWindow &m_window;
    QString m_folder;
    QString m_suffix;
    Extent m_extent;
    QString m_family;
    QList<Step> m_steps;
    qsizetype m_at = -1;
    QTimer m_timer;
    QElapsedTimer m_since;
    QStringList m_pictures;
};
