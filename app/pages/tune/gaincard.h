// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "widgets/models/livemodel.h"
#include "widgets/views/card.h"

#include <array>

class QLabel;
class QSlider;

/// Two sliders per axis, damping and stability, in place of three gains, and the loop that results from the
/// gains in use.
class GainCard final : public Card
{
    Q_OBJECT
public:
    GainCard(LiveModel &live, std::shared_ptr<const GainShape> shape, QWidget *parent = nullptr);

    /// The parameters of another board; null for none.
    void setParameters(std::shared_ptr<const ParameterSet> set);

private:
    struct Row
    {
        QSlider *damping = nullptr;
        QSlider *stability = nullptr;
        QLabel *dampingText = nullptr;
        QLabel *stabilityText = nullptr;
        QLabel *shape = nullptr;
        std::array<int, 3> gains{-1, -1, -1};  // ids of P, I and D
    };
    void onMoved(std::size_t axis);
    void refresh(std::size_t axis);
    [[nodiscard]] std::optional<PidGains> gainsOf(const Row &row) const;

    LiveModel &m_live;
    std::shared_ptr<const ParameterSet> m_set;
    std::shared_ptr<const GainShape> m_shape;
    std::array<Row, kAxisCount> m_rows;
    bool m_filling = false;
};
