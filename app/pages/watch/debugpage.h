// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/debugmodel.h"

class QPushButton;
class QTableView;
class PlotStack;

/// The firmware's inner variables with their values as they come.
class DebugPage final : public Page
{
    Q_OBJECT
public:
    explicit DebugPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] DebugModel &model() { return m_model; }
    [[nodiscard]] QTableView *table() const { return m_table; }
    /// The chosen variables over time.
    [[nodiscard]] PlotStack *plots() const { return m_plots; }

private:
    void showCurves();

    DebugModel m_model;
    QTableView *m_table;
    PlotStack *m_plots;
    QPushButton *m_pause;
};
