// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/livemodel.h"
#include "widgets/plot/plotclock.h"

class GainCard;
class LiveSlider;
class QButtonGroup;
class QGridLayout;
class QPushButton;
class QScrollArea;
class SignsNote;

/// Gains and filters as live controls beside plots of their effect: two sets to compare, revert, and figures
/// of the holding error.
class TuningPage final : public Page
{
    Q_OBJECT
public:
    explicit TuningPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override { return m_live.changeCount() > 0; }
    [[nodiscard]] std::any keep() override { return m_before; }
    void resume(const std::any &kept) override;
    [[nodiscard]] LiveModel &live() { return m_live; }
    [[nodiscard]] LiveSlider *control(const QString &key) const;
    [[nodiscard]] QPushButton *revertButton() const { return m_revert; }
    [[nodiscard]] QPushButton *compareButton() const { return m_compare; }
    /// What is in use, and whether that is stored.
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QPushButton *slotButton(LiveModel::Slot slot) const
    {
        return slot == LiveModel::Slot::A ? m_a : m_b;
    }
    [[nodiscard]] const QList<PlotView *> &plots() const { return m_plots; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void makeHeader();
    void makeBody();
    [[nodiscard]] QWidget *makeFigures();
    void connectAll();
    void rebuild();
    void showValue(LiveSlider &control, int parameter) const;
    void onStore();
    void updateState();
    void updateFigures();
    void keepFigures();
    void save();
    void compare();
    [[nodiscard]] QWidget *makeControls();

    struct Figures
    {
        double rms = 0;
        double peak = 0;
    };
    LiveModel &m_live;
    QScrollArea *m_scroll;
    QHash<int, LiveSlider *> m_controls;
    GainCard *m_gains = nullptr;  // null where the board's gains are of another kind
    QPushButton *m_a;
    QPushButton *m_b;
    QPushButton *m_copy;
    QPushButton *m_revert;
    QPushButton *m_save;
    QLabel *m_state;
    SignsNote *m_signs;
    QPushButton *m_compare;
    QList<PlotView *> m_plots;
    PlotClock m_clock;
    QTimer m_figureTimer;
    std::array<Figures, kAxisCount> m_now{};
    std::array<std::optional<Figures>, kAxisCount> m_before{};
    std::array<std::array<QLabel *, 5>, kAxisCount> m_cells{};
    std::shared_ptr<const ParameterSet> m_set;  // what the controls refer to
    QString m_serial;  // of the board whose values they show
    bool m_saving = false;
};
