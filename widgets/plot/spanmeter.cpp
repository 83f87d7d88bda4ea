// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/spanmeter.h"

#include <algorithm>
#include <cmath>

void SpanMeter::Sum::add(float value)
{
    if (std::isnan(value))
        return;
    ++samples;
    sum += double(value);
    squares += double(value) * double(value);
    low = std::min(low, value);
    high = std::max(high, value);
}

void SpanMeter::Sum::add(const Sum &other)
{
    samples += other.samples;
    sum += other.sum;
    squares += other.squares;
    low = std::min(low, other.low);
    high = std::max(high, other.high);
}

SpanMeter::SpanMeter(std::shared_ptr<const TelemetryStore> store, int channel, int minus)
    : m_store(std::move(store))
    , m_channel(channel)
    , m_minus(minus)
{
}

SpanMeter::Sum SpanMeter::sumOf(const TraceSource &source, std::size_t first, std::size_t last)
{
    Sum sum;
    for (std::size_t row = first; row < last; ++row)
        sum.add(source.value(row));
    return sum;
}

SpanMeter::Figures SpanMeter::measure(double from, double to)
{
    constexpr std::size_t kChunk = TelemetryGroup::kRowsPerChunk;
    if (m_generation != m_store->generation()) {
        m_generation = m_store->generation();
        m_sources = TraceSource::find(*m_store, m_channel, m_minus);
        m_known.clear();
    }
    Sum all;
    double begin = to;
    double end = from;
    for (std::size_t place = 0; place < m_sources.size(); ++place) {
        TraceSource &source = m_sources[place];
        source.refresh();
        const std::size_t first = source.track.rowAt(from);
        const std::size_t last = std::min(source.track.rowAt(to), source.end());
        if (first >= last)
            continue;
        begin = std::min(begin, source.track.time(first));
        end = std::max(end, source.track.time(last - 1));
        for (std::size_t row = first; row < last;) {
            const std::size_t chunk = row / kChunk;
            const std::size_t next = std::min(last, (chunk + 1) * kChunk);
            if (row % kChunk == 0 && next == (chunk + 1) * kChunk) {
                const auto [known, fresh] = m_known.try_emplace({place, chunk});
                if (fresh)
                    known->second = sumOf(source, row, next);
                all.add(known->second);
            } else {
                all.add(sumOf(source, row, next));
            }
            row = next;
        }
        // Data dropped by retention is not requested again.
        m_known.erase(m_known.lower_bound({place, 0}),
                      m_known.lower_bound({place, source.track.begin() / kChunk}));
    }
    Figures figures;
    figures.samples = all.samples;
    if (all.samples == 0)
        return figures;
    const double count = double(all.samples);
    figures.mean = all.sum / count;
    figures.rms = std::sqrt(all.squares / count);
    figures.low = double(all.low);
    figures.high = double(all.high);
    figures.rate = end > begin ? (count - 1) / (end - begin) : 0.0;
    return figures;
}
