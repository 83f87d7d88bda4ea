// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/tune/responserecord.h"

#include <QStackedWidget>

class CurveChart;
class Theme;

/// Charts of the measurements: overlaid step responses, or a Bode plot.
class ResponseCharts final : public QStackedWidget
{
    Q_OBJECT
public:
    explicit ResponseCharts(const Theme &theme, QWidget *parent = nullptr);

    void showKind(ResponseRecord::Kind kind);
    /// @param records oldest first; those that are not shown are left out
    void setRecords(const std::vector<ResponseRecord> &records);

private:
    void drawSteps(const std::vector<ResponseRecord> &records);
    void drawBode(const std::vector<ResponseRecord> &records);

    CurveChart *m_steps;
    CurveChart *m_gain;
    CurveChart *m_phase;
    CurveChart *m_coherence;
};
