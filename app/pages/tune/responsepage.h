// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/tune/responserecord.h"
#include "app/workspace/page.h"

#include <QElapsedTimer>
#include <QTimer>

class MovementForm;
class QComboBox;
class QProgressBar;
class QPushButton;
class QStandardItemModel;
class QTableView;
class ResponseCharts;

/// How an axis follows, measured by small guarded steps, by a sweep, or from motion that has already
/// happened; with the measurements side by side.
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
    [[nodiscard]] bool isUnderWay() const override { return m_running; }
    [[nodiscard]] std::any keep() override { return m_records; }
    void resume(const std::any &kept) override;
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
    void makeResults(QVBoxLayout *column);
    void offerWays();
    void onWay();
    void setArmed(bool armed);
    void start();
    void measureOwnMotion();
    void onMeasured(const MotionTestResult &result);
    void onFailed(const Error &error);
    void add(Result<ResponseRecord> record, Axis axis);
    void removeChosen();
    void putOthersAside();
    void showRecords();
    void updateButtons();
    [[nodiscard]] bool tellsTargets() const;
    [[nodiscard]] Way way() const;
    [[nodiscard]] Axis axis() const;
    [[nodiscard]] ResponseRecord::Kind kind() const;
    /// The test that moves the axis; none to measure motion that has already happened.
    [[nodiscard]] std::optional<MotionTestPlan::Kind> testKind() const;
    /// Which record a row of the table shows.
    [[nodiscard]] std::optional<std::size_t> recordAt(int row) const;

    bool m_running = false;
    std::vector<ResponseRecord> m_records;  // oldest first
    QComboBox *m_way;
    QComboBox *m_axis;
    MovementForm *m_movement;
    QLabel *m_state;
    QPushButton *m_arm;
    QPushButton *m_start;
    QProgressBar *m_progress;
    ResponseCharts *m_charts;
    QStandardItemModel *m_model;
    QTableView *m_table;
    QPushButton *m_remove;
    QPushButton *m_export;
    QTimer m_disarm;
    bool m_filling = false;
};
