// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/page.h"
#include "widgets/models/channelmodel.h"

#include "widgets/plot/plotclock.h"

#include <QTimer>

class PlotView;
class QComboBox;
class QMenu;
class QPushButton;
class QSplitter;
class QTreeView;

/// Chosen telemetry channels plotted live, one plot per unit.
class MonitorPage final : public Page
{
    Q_OBJECT
public:
    explicit MonitorPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] ChannelModel &channels() { return m_channels; }
    [[nodiscard]] const QList<PlotView *> &plots() const { return m_plots; }
    [[nodiscard]] QPushButton *pauseButton() const { return m_pause; }
    [[nodiscard]] QPushButton *recordButton() const { return m_record; }
    /// Seconds shown.
    [[nodiscard]] double window() const { return m_seconds; }
    /// Saves what is seen of the ticked channels. Errors: BadFile.
    Result<qint64> exportCsv(const QString &path);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void onStore();
    void onTicks();
    void updateNote();
    void connectPlot(PlotView *plot);
    void setSeconds(double seconds);
    void setPaused(bool paused);
    void holdAt(double end);
    void zoom(double factor, double around);
    void askExport();
    void updateRecord();
    void askRecording(const QString &title, Result<void> (LinkRecorder::*record)(const QString &));

    ChannelModel m_channels;
    QTreeView *m_tree;
    QSplitter *m_stack;
    QLabel *m_empty;
    QComboBox *m_window;
    QPushButton *m_pause;
    QPushButton *m_export;
    QPushButton *m_record;
    QMenu *m_recordMenu;
    QLabel *m_note;
    QList<PlotView *> m_plots;
    PlotClock m_clock;
    QTimer m_valueTimer;
    double m_seconds = 10;
    bool m_chosen = false;     // the operator (or the first board) has chosen channels
};
