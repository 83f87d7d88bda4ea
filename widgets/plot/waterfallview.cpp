// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/waterfallview.h"

#include "widgets/models/numbertext.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLowestLine = 1.0;  // Hz
constexpr int kImageLeft = 76;
constexpr int kImageTop = 12;
constexpr int kImageRight = 84;
constexpr int kImageBottom = 30;
constexpr float kRange = 60.0F;  // decibels from dark to bright
constexpr float kBrightStep = 10.0F;  // the bright end moves in steps, so that colours do not flicker

// Dark violet over teal to yellow: even steps of brightness, told apart by colour-blind eyes.
// clang-format off
constexpr std::array<std::array<float, 3>, 6> kColors{{{13, 8, 35}, {62, 35, 110}, {44, 95, 140}, {32, 150, 135},
                                                      {120, 205, 85}, {253, 231, 60}}};
// clang-format on

float densityDecibel(double density)
{
    return 10.0F * std::log10(std::max(float(density), 1e-20F));
}

}  // namespace

WaterfallView::WaterfallView(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setMinimumHeight(180);
    setAccessibleName(tr("Waterfall"));
    m_ring.fill(colorOf(-1e9F));
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

double WaterfallView::frequencyAt(double row) const
{
    const double share = row / (kRows - 1);
    const double highest = m_rate / 2;
    return m_logarithmic ? kLowestLine * std::pow(highest / kLowestLine, share) : share * highest;
}

QRgb WaterfallView::colorOf(float level) const
{
    const float place
        = std::clamp((level - m_low) / (m_high - m_low), 0.0F, 1.0F) * float(kColors.size() - 1);
    const auto index = std::min(kColors.size() - 2, std::size_t(place));
    const float part = place - float(index);
    const auto mix = [&](std::size_t i) {
        return int(kColors[index][i] + part * (kColors[index + 1][i] - kColors[index][i]));
    };
    return qRgb(mix(0), mix(1), mix(2));
}

float WaterfallView::level(int column, double frequency) const
{
    const Spectrum &spectrum = m_columns[m_columns.size() - 1 - std::size_t(column)];
    const auto bin
        = std::min(spectrum.density.size() - 1, std::size_t(std::lround(frequency / spectrum.resolution)));
    return densityDecibel(spectrum.density[bin]);
}

void WaterfallView::clear()
{
    m_columns.clear();
    m_next = 0;
    redraw();
}

void WaterfallView::setLogarithmic(bool logarithmic)
{
    if (m_logarithmic == logarithmic)
        return;
    m_logarithmic = logarithmic;
    redraw();
}

void WaterfallView::add(const Spectrum &spectrum)
{
    if (spectrum.rate != m_rate) {
        m_columns.clear();
        m_rate = spectrum.rate;
    }
    m_columns.push_back(spectrum);
    if (m_columns.size() > kColumns)
        m_columns.pop_front();
    float highest = -200.0F;
    for (std::size_t bin = 1; bin < spectrum.density.size(); ++bin) {
        if (spectrum.frequency(bin) >= kLowestLine)
            highest = std::max(highest, densityDecibel(spectrum.density[bin]));
    }
    const float top = std::ceil(highest / kBrightStep) * kBrightStep;
    if (m_columns.size() == 1 || top > m_high || m_high - top > 3 * kBrightStep) {
        m_high = top;
        m_low = top - kRange;
        redraw();
        return;
    }
    Column column;
    for (int row = 0; row < kRows; ++row)
        column[std::size_t(row)] = level(0, frequencyAt(row));
    drawColumn(m_next, column);
    m_next = (m_next + 1) % kColumns;
    update();
}

void WaterfallView::drawColumn(int slot, const Column &column)
{
    for (int row = 0; row < kRows; ++row)
        reinterpret_cast<QRgb *>(m_ring.scanLine(kRows - 1 - row))[slot] = colorOf(column[std::size_t(row)]);
}

void WaterfallView::redraw()
{
    m_ring.fill(colorOf(-1e9F));
    m_next = 0;
    for (int i = int(m_columns.size()) - 1; i >= 0; --i) {
        Column column;
        for (int row = 0; row < kRows; ++row)
            column[std::size_t(row)] = level(i, frequencyAt(row));
        drawColumn(m_next, column);
        m_next = (m_next + 1) % kColumns;
    }
    update();
}

void WaterfallView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.color(ColorRole::Surface));
    const QRectF area(kImageLeft, kImageTop, std::max(10, width() - kImageLeft - kImageRight),
                      std::max(10, height() - kImageTop - kImageBottom));
    // The slot that is overwritten next is the oldest column, so the ring is cut there.
    const double split = area.width() * (kColumns - m_next) / kColumns;
    painter.drawImage(QRectF(area.left(), area.top(), split, area.height()), m_ring,
                      QRectF(m_next, 0, kColumns - m_next, kRows));
    if (m_next > 0) {
        painter.drawImage(QRectF(area.left() + split, area.top(), area.width() - split, area.height()),
                          m_ring, QRectF(0, 0, m_next, kRows));
    }
    const QFontMetricsF metrics(font());
    painter.setPen(m_theme.color(ColorRole::Muted));
    if (m_rate > 0) {
        for (const double hz : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 300.0, 400.0, 500.0, 600.0}) {
            const double highest = m_rate / 2;
            const double share
                = m_logarithmic ? std::log(hz / kLowestLine) / std::log(highest / kLowestLine) : hz / highest;
            const bool shown = m_logarithmic ? hz <= 200.0 || hz == 500.0 : std::fmod(hz, 100.0) == 0.0;
            if (share > 1.0 || !shown)
                continue;
            const double y = area.bottom() - share * area.height();
            painter.drawText(QRectF(0, y - metrics.height() / 2, kImageLeft - 8, metrics.height()),
                             Qt::AlignRight | Qt::AlignVCenter, tr("%1 Hz").arg(shortNumberText(hz)));
        }
    }
    const double seconds = kColumns * m_hop;
    for (int i = 0; i <= 4; ++i) {
        const double x = area.left() + area.width() * i / 4;
        painter.drawText(QRectF(x - 40, area.bottom() + 6, 80, metrics.height()), Qt::AlignCenter,
                         tr("%1 s").arg(numberText(-seconds * (4 - i) / 4, 0)));
    }
    // What the colours mean.
    const QRectF bar(area.right() + 12, area.top(), 12, area.height());
    for (int y = 0; y < int(bar.height()); ++y) {
        const float share = 1.0F - float(y) / float(bar.height());
        painter.fillRect(QRectF(bar.left(), bar.top() + y, bar.width(), 1),
                         QColor::fromRgb(colorOf(m_low + share * (m_high - m_low))));
    }
    painter.drawText(QRectF(bar.right() + 6, bar.top() - 2, 60, metrics.height()), Qt::AlignLeft,
                     tr("%1 dB").arg(shortNumberText(double(m_high))));
    painter.drawText(QRectF(bar.right() + 6, bar.bottom() - metrics.height() + 2, 60, metrics.height()),
                     Qt::AlignLeft, tr("%1 dB").arg(shortNumberText(double(m_low))));
}
