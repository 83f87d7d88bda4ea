// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/guide/setuplive.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class Workspace;

/// What a step of the gimbal setup judges, as the board tells it now.
class LiveFigures final : public QWidget
{
    Q_OBJECT
public:
    explicit LiveFigures(Workspace &workspace, QWidget *parent = nullptr);

    /// Those of that step; hidden where it has none.
    void showStep(SetupStep step);
    void refresh();
    /// As it stands in that row, axis after axis; empty: there is no such row.
    [[nodiscard]] QString text(const char *label) const;

private:
    struct Figure
    {
        const SetupLiveSpec *spec = nullptr;
        int channel = -1;
        QLabel *label = nullptr;
    };
    [[nodiscard]] QString valueText(const Figure &figure) const;
    void addHeads();
    void addRow(const SetupLiveSpec &spec, const ChannelRoles &roles, int row);

    Workspace &m_workspace;
    QWidget *m_body;
    QGridLayout *m_grid;
    std::vector<Figure> m_figures;
};
