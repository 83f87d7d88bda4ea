// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/page.h"
#include "widgets/models/channelmodel.h"

#include <QTimer>

class PlotView;
class QComboBox;
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

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void onStore();
    void onTicks();
    void frame();
    void updateRate();
    void updateNote();

    ChannelModel m_channels;
    QTreeView *m_tree;
    QSplitter *m_stack;
    QLabel *m_empty;
    QComboBox *m_window;
    QPushButton *m_pause;
    QLabel *m_note;
    QList<PlotView *> m_plots;
    QTimer m_frameTimer;       // one for all plots
    QTimer m_valueTimer;
    int m_slowFrames = 0;
    int m_rateDivider = 1;
    bool m_chosen = false;     // the operator (or the first board) has chosen channels
};
