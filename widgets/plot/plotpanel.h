// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotview.h"
#include "widgets/plot/spanmeter.h"

class QMenu;
class QTableWidget;
class QToolButton;

/// A plot with its menu and, on request, the figures of what it shows.
class PlotPanel final : public QWidget
{
    Q_OBJECT
public:
    PlotPanel(const Theme &theme, QWidget *parent = nullptr);

    [[nodiscard]] PlotView *view() const { return m_view; }
    [[nodiscard]] QMenu *menu() const { return m_menu; }
    [[nodiscard]] QTableWidget *figures() const { return m_figures; }
    void setChannels(ChannelTable table, const QList<int> &channels,
                     std::shared_ptr<const TelemetryStore> store);
    [[nodiscard]] const QList<int> &channels() const { return m_channels; }
    /// Mean, RMS, peak to peak and rate of each trace over the visible span.
    void setFiguresVisible(bool visible);
    [[nodiscard]] bool figuresVisible() const;
    /// Takes the figures anew, a few times a second.
    void refreshFigures();

signals:
    void removeChannelRequested(int channel);
    void removeRequested();
    void changed();

private:
    void fillMenu();

    PlotView *m_view;
    QToolButton *m_button;
    QMenu *m_menu;
    QTableWidget *m_figures;
    ChannelTable m_table;
    QList<int> m_channels;
    std::vector<SpanMeter> m_meters;
};
