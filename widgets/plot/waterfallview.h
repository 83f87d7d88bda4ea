// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"
#include "widgets/theme/theme.h"

#include <QImage>
#include <QWidget>

#include <deque>

/// Spectra over time: frequency upwards, the newest at the right, strength as brightness. A ring image takes
/// one column for each spectrum.
class WaterfallView final : public QWidget
{
    Q_OBJECT
public:
    static constexpr int kColumns = 240;
    static constexpr int kRows = 240;

    explicit WaterfallView(const Theme &theme, QWidget *parent = nullptr);

    /// Adds the spectrum of a moment. Another rate starts anew.
    void add(const Spectrum &spectrum);
    void clear();
    void setLogarithmic(bool logarithmic);
    /// Seconds from one spectrum to the next.
    void setHop(double seconds) { m_hop = seconds; }
    [[nodiscard]] int columnCount() const { return int(m_columns.size()); }
    /// Frequency at a row of the picture, 0 = lowest.
    [[nodiscard]] double frequencyAt(double row) const;
    /// Decibels in a column at a frequency; 0 = the newest column.
    [[nodiscard]] float level(int column, double frequency) const;

    [[nodiscard]] QSize sizeHint() const override { return {600, 260}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    using Column = std::array<float, kRows>;
    void drawColumn(int slot, const Column &column);
    void redraw();
    [[nodiscard]] QRgb colorOf(float level) const;

    const Theme &m_theme;
    double m_rate = 0;
    double m_hop = 0.5;
    bool m_logarithmic = true;
    std::deque<Spectrum> m_columns;  // newest last
    QImage m_ring{kColumns, kRows, QImage::Format_RGB32};
    int m_next = 0;  // slot of the next column
    float m_low = -60;  // decibels at the dark end
    float m_high = 0;
};
