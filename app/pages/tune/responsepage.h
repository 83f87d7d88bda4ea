// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/tune/responserecord.h"
#include "app/workspace/page.h"

#include <QElapsedTimer>
#include <QTimer>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QStandardItemModel;
class QTableView;

/// How an axis follows: a guarded small step, a sweep, or the motion there was anyway; the measurements side
/// by side.
class ResponsePage final : public Page
{
    Q_OBJECT
public:
    enum class Way { Steps, Sweep, OwnMotion };

    explicit ResponsePage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] QComboBox *wayChoice() const { return m_way; }
    [[nodiscard]] QPushButton *armButton() const { return m_arm; }
    [[nodiscard]] QPushButton *startButton() const { return m_start; }
    [[nodiscard]] QTableView *table() const { return m_table; }
    [[nodiscard]] const std::vector<ResponseRecord> &records() const { return m_records; }
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// Reads a measurement from in;out. Errors: BadFile, InvalidArgument.
    Result<void> importCsv(const QString &path);
    /// Writes both sides of the chosen (or newest) measurement. Errors: BadFile, InvalidArgument (there is
    /// none).
    Result<void> exportCsv(const QString &path) const;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void makeMovementCard(QVBoxLayout *column);
    void makePictures(QVBoxLayout *column);
    void offerWays();
    void onWay();
    void setArmed(bool armed);
    void start();
    void measureOwnMotion();
    void onMeasured(const MotionTestResult &result);
    void onFailed(const Error &error);
    void add(Result<ResponseRecord> record, Axis axis);
    void removeChosen();
    void showRecords();
    void drawSteps();
    void drawBode();
    void updateButtons();
    [[nodiscard]] bool tellsTargets() const;
    [[nodiscard]] Way way() const;
    [[nodiscard]] Axis axis() const;
    [[nodiscard]] ResponseRecord::Kind kind() const;
    [[nodiscard]] MotionTestPlan plan() const;
    /// Which record a row of the table shows.
    [[nodiscard]] std::optional<std::size_t> recordAt(int row) const;

    bool m_running = false;
    std::vector<ResponseRecord> m_records;  // oldest first
    QComboBox *m_way;
    QComboBox *m_axis;
    QDoubleSpinBox *m_degrees;
    QSpinBox *m_count;
    QDoubleSpinBox *m_rest;
    QDoubleSpinBox *m_from;
    QDoubleSpinBox *m_to;
    QDoubleSpinBox *m_seconds;
    QDoubleSpinBox *m_limit;
    QFormLayout *m_form;
    QLabel *m_state;
    QPushButton *m_arm;
    QPushButton *m_start;
    QProgressBar *m_progress;
    QStackedWidget *m_pictures;
    CurveChart *m_steps;
    CurveChart *m_gain;
    CurveChart *m_phase;
    CurveChart *m_coherence;
    QStandardItemModel *m_model;
    QTableView *m_table;
    QPushButton *m_remove;
    QPushButton *m_export;
    QTimer m_disarm;
    bool m_filling = false;
};
