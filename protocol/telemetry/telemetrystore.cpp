// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/telemetrystore.h"

#include <algorithm>
#include <cmath>

namespace {

// Fraction of the error corrected per sample.
constexpr double kDiscipline = 0.02;

}  // namespace

TelemetryGroup::TelemetryGroup(QList<int> channels, double period)
    : m_channels(std::move(channels))
    , m_period(period)
{
}

void TelemetryGroup::append(double time, std::span<const float> values, double retention)
{
    const std::size_t row = m_end.load(std::memory_order_relaxed);
    const std::size_t inChunk = row % kRowsPerChunk;
    if (inChunk == 0) {
        auto chunk = std::make_shared<Chunk>();
        chunk->firstRow = row;
        chunk->values.resize(kRowsPerChunk * static_cast<std::size_t>(m_channels.size()));
        chunk->blocks.resize(kBlocksPerChunk * static_cast<std::size_t>(m_channels.size()));
        const std::lock_guard lock(m_mutex);
        while (m_chunks.size() > 1 && m_chunks.front()->times.back() < time - retention)
            m_chunks.pop_front();
        m_chunks.push_back(std::move(chunk));
    }
    Chunk &chunk = *m_chunks.back();
    chunk.times[inChunk] = time;
    for (std::size_t column = 0; column < values.size(); ++column)
        chunk.values[column * kRowsPerChunk + inChunk] = values[column];
    if (inChunk % kRowsPerBlock == kRowsPerBlock - 1)
        closeBlock(chunk, inChunk + 1 - kRowsPerBlock);
    m_end.store(row + 1, std::memory_order_release);
}

double TelemetryGroup::lastTime() const
{
    return m_chunks.back()->times[(end() - 1) % kRowsPerChunk];
}

void TelemetryGroup::closeBlock(Chunk &chunk, std::size_t firstRow)
{
    const std::size_t columns = chunk.values.size() / kRowsPerChunk;
    for (std::size_t column = 0; column < columns; ++column) {
        const float *rows = chunk.values.data() + column * kRowsPerChunk + firstRow;
        Extent extent{rows[0], rows[0]};
        for (std::size_t i = 0; i < kRowsPerBlock && !std::isnan(extent.low); ++i) {
            if (std::isnan(rows[i]))
                extent = {rows[i], rows[i]};
            else
                extent = {std::min(extent.low, rows[i]), std::max(extent.high, rows[i])};
        }
        chunk.blocks[column * kBlocksPerChunk + firstRow / kRowsPerBlock] = extent;
    }
}

TrackView::TrackView(std::shared_ptr<const TelemetryGroup> group, int column)
    : m_group(std::move(group))
    , m_column(column)
{
    refresh();
}

void TrackView::refresh()
{
    std::size_t end = m_group->end();
    const std::size_t known
        = m_chunks.empty() ? 0 : m_chunks.back()->firstRow + TelemetryGroup::kRowsPerChunk;
    if (end > known || (m_chunks.empty() && end > 0)) {
        const std::lock_guard lock(m_group->m_mutex);
        m_chunks.assign(m_group->m_chunks.begin(), m_group->m_chunks.end());
        // The writer may have dropped everything up to the previously known end.
        end = m_group->end();
    }
    m_end = end;
    m_begin = m_chunks.empty() ? end : m_chunks.front()->firstRow;
}

const TelemetryGroup::Chunk &TrackView::chunkOf(std::size_t row) const
{
    return *m_chunks[(row - m_begin) / TelemetryGroup::kRowsPerChunk];
}

double TrackView::time(std::size_t row) const
{
    return chunkOf(row).times[row % TelemetryGroup::kRowsPerChunk];
}

float TrackView::value(std::size_t row) const
{
    return chunkOf(row).values[static_cast<std::size_t>(m_column) * TelemetryGroup::kRowsPerChunk
                               + row % TelemetryGroup::kRowsPerChunk];
}

std::optional<TelemetryGroup::Extent> TrackView::block(std::size_t row) const
{
    if (row % TelemetryGroup::kRowsPerBlock != 0 || row + TelemetryGroup::kRowsPerBlock > m_end)
        return {};
    const TelemetryGroup::Extent extent
        = chunkOf(row).blocks[static_cast<std::size_t>(m_column) * TelemetryGroup::kBlocksPerChunk
                              + row % TelemetryGroup::kRowsPerChunk / TelemetryGroup::kRowsPerBlock];
    return std::isnan(extent.low) ? std::nullopt : std::optional(extent);
}

std::size_t TrackView::rowAt(double time) const
{
    std::size_t low = m_begin;
    std::size_t high = m_end;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (this->time(middle) < time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

TelemetryStore::TelemetryStore(int channelCount, TimePoint origin)
    : m_origin(origin)
    , m_latest(static_cast<std::size_t>(channelCount))
    , m_latestAt(static_cast<std::size_t>(channelCount))
    , m_invalid(static_cast<std::size_t>(channelCount))
{
    for (auto &value : m_latest)
        value.store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
}

std::shared_ptr<TelemetryGroup> TelemetryStore::defineGroup(QList<int> channels, double period)
{
    auto group = std::make_shared<TelemetryGroup>(std::move(channels), period);
    {
        const std::lock_guard lock(m_mutex);
        m_groups.push_back(group);
    }
    m_generation.fetch_add(1, std::memory_order_release);
    return group;
}

void TelemetryStore::append(TelemetryGroup &group, TimePoint at, std::span<const float> values)
{
    group.append(secondsAt(at), values, m_retention.load(std::memory_order_relaxed));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto channel = static_cast<std::size_t>(group.channels()[static_cast<qsizetype>(i)]);
        m_latest[channel].store(values[i], std::memory_order_relaxed);
        m_latestAt[channel].store(at.time_since_epoch().count(), std::memory_order_relaxed);
    }
    m_rows.fetch_add(1, std::memory_order_relaxed);
    m_newest.store(std::max(m_newest.load(std::memory_order_relaxed), secondsAt(at)),
                   std::memory_order_relaxed);
}

void TelemetryStore::appendGap(TelemetryGroup &group, TimePoint at)
{
    const std::vector<float> nothing(static_cast<std::size_t>(group.channels().size()),
                                     std::numeric_limits<float>::quiet_NaN());
    group.append(secondsAt(at), nothing, m_retention.load(std::memory_order_relaxed));
}

void TelemetryStore::interrupt()
{
    std::vector<std::shared_ptr<TelemetryGroup>> groups;
    {
        const std::lock_guard lock(m_mutex);
        groups = m_groups;
    }
    for (const auto &group : groups) {
        if (group->end() > 0)
            appendGap(*group, m_origin + durationFromSeconds(group->lastTime() + 1e-6));
    }
}

void TelemetryStore::appendArray(int channel, TimePoint at, std::vector<float> values)
{
    const double time = secondsAt(at);
    {
        const std::lock_guard lock(m_mutex);
        std::deque<ArraySample> &kept = m_arrays[channel];
        kept.push_back({time, std::make_shared<const std::vector<float>>(std::move(values))});
        while (kept.front().time < time - m_retention.load(std::memory_order_relaxed))
            kept.pop_front();
    }
    m_rows.fetch_add(1, std::memory_order_relaxed);
    m_newest.store(std::max(m_newest.load(std::memory_order_relaxed), time), std::memory_order_relaxed);
}

ArraySample TelemetryStore::latestArray(int channel) const
{
    const std::lock_guard lock(m_mutex);
    const auto it = m_arrays.find(channel);
    return it == m_arrays.end() || it->second.empty() ? ArraySample() : it->second.back();
}

std::vector<ArraySample> TelemetryStore::arraysAfter(int channel, double time) const
{
    const std::lock_guard lock(m_mutex);
    const auto it = m_arrays.find(channel);
    if (it == m_arrays.end())
        return {};
    const auto first = std::find_if(it->second.begin(), it->second.end(),
                                    [time](const ArraySample &sample) { return sample.time > time; });
    return {first, it->second.end()};
}

void TelemetryStore::countSilence(double seconds)
{
    m_silences.fetch_add(1, std::memory_order_relaxed);
    m_silentSeconds.store(silentSeconds() + seconds, std::memory_order_relaxed);  // one writer
}

float TelemetryStore::latest(int channel) const
{
    if (channel < 0 || channel >= channelCount())
        return std::numeric_limits<float>::quiet_NaN();
    return m_latest[static_cast<std::size_t>(channel)].load(std::memory_order_relaxed);
}

TimePoint TelemetryStore::latestAt(int channel) const
{
    if (channel < 0 || channel >= channelCount())
        return {};
    return TimePoint(Duration(m_latestAt[static_cast<std::size_t>(channel)].load(std::memory_order_relaxed)));
}

std::vector<TrackView> TelemetryStore::tracks(int channel) const
{
    std::vector<TrackView> views;
    const std::lock_guard lock(m_mutex);
    for (const auto &group : m_groups) {
        const qsizetype column = group->channels().indexOf(channel);
        if (column >= 0)
            views.emplace_back(group, static_cast<int>(column));
    }
    return views;
}

double SampleClock::next(double arrival, int missing)
{
    if (!m_last || m_period <= 0.0) {
        m_last = arrival;
        return arrival;
    }
    double time = *m_last + m_period * (1 + missing);
    const double error = arrival - time;
    if (std::abs(error) > m_resync)
        time = std::max(arrival, *m_last);
    else
        time = std::max(time + kDiscipline * error, *m_last);
    m_last = time;
    return time;
}
