// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/latestvalues.h"

#include <QDateTime>
#include <QList>

#include <array>
#include <atomic>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

/// Rows of one kind of telemetry frame: a time and one float per channel. Append-only chunks; one writer (the
/// I/O thread), any number of readers that hold no lock while they read values.
class TelemetryGroup
{
public:
    static constexpr std::size_t kRowsPerChunk = 1024;
    /// Rows per block. The lowest and highest value of each block are kept, so that long spans are drawn
    /// without reading each row.
    static constexpr std::size_t kRowsPerBlock = 16;
    static constexpr std::size_t kBlocksPerChunk = kRowsPerChunk / kRowsPerBlock;
    struct Extent
    {
        float low = 0;
        float high = 0;
    };

    struct Chunk
    {
        std::size_t firstRow = 0;
        std::array<double, kRowsPerChunk> times;  // seconds since the store's origin
        std::vector<float> values;  // channel after channel, kRowsPerChunk each
        std::vector<Extent> blocks;  // channel after channel, kBlocksPerChunk each; NaN where a row is lost
    };

    TelemetryGroup(QList<int> channels, double period);

    [[nodiscard]] const QList<int> &channels() const { return m_channels; }
    /// Nominal time between rows in seconds; 0 = irregular.
    [[nodiscard]] double period() const { return m_period; }
    /// Number of rows ever appended.
    [[nodiscard]] std::size_t end() const { return m_end.load(std::memory_order_acquire); }

private:
    friend class TelemetryStore;
    friend class TrackView;
    void append(double time, std::span<const float> values, double retention);
    [[nodiscard]] double lastTime() const;
    static void closeBlock(Chunk &chunk, std::size_t firstRow);

    QList<int> m_channels;
    double m_period;
    std::atomic<std::size_t> m_end = 0;
    mutable std::mutex m_mutex;  // guards the list of chunks, not their contents
    std::deque<std::shared_ptr<Chunk>> m_chunks;
};

/// A reader's view of one channel in one group. Cheap to refresh; reading takes no lock.
class TrackView
{
public:
    TrackView(std::shared_ptr<const TelemetryGroup> group, int column);

    /// Takes in new rows, and rows that retention has dropped.
    void refresh();
    [[nodiscard]] std::size_t begin() const { return m_begin; }  ///< first row still kept
    [[nodiscard]] std::size_t end() const { return m_end; }
    [[nodiscard]] double time(std::size_t row) const;
    [[nodiscard]] float value(std::size_t row) const;
    /// Lowest and highest value of the kRowsPerBlock rows from this one on (a multiple of kRowsPerBlock);
    /// empty while the block is incomplete or if a row in it is lost.
    [[nodiscard]] std::optional<TelemetryGroup::Extent> block(std::size_t row) const;
    /// First row at or after this time (rows are in order of time).
    [[nodiscard]] std::size_t rowAt(double time) const;
    [[nodiscard]] double period() const { return m_group->period(); }
    [[nodiscard]] const TelemetryGroup *group() const { return m_group.get(); }

private:
    [[nodiscard]] const TelemetryGroup::Chunk &chunkOf(std::size_t row) const;

    std::shared_ptr<const TelemetryGroup> m_group;
    int m_column;
    std::vector<std::shared_ptr<const TelemetryGroup::Chunk>> m_chunks;
    std::size_t m_begin = 0;
    std::size_t m_end = 0;
};

/// One sample of a channel that is an array. Copies share the values.
struct ArraySample
{
    double time = 0;  ///< seconds since the store's origin
    std::shared_ptr<const std::vector<float>> values = std::make_shared<std::vector<float>>();
};

/// Lossless column store of everything that arrived. Missing rows are appended as NaN, so plots show gaps.
class TelemetryStore final : public LatestValues
{
public:
    /// @param origin the instant from which times are counted
    explicit TelemetryStore(int channelCount, TimePoint origin = Clock::now());

    // Writer (the I/O thread).
    /// Adds a new kind of frame or a new set of channels; later rows of these channels belong to it.
    std::shared_ptr<TelemetryGroup> defineGroup(QList<int> channels, double period);
    void append(TelemetryGroup &group, TimePoint at, std::span<const float> values);
    void appendGap(TelemetryGroup &group, TimePoint at);
    /// Everything is interrupted here: a gap in each group that has rows.
    void interrupt();
    /// A whole array (ChannelSpec::elements) at one instant, e.g. a spectrum; its length is up to what the
    /// board sends.
    void appendArray(int channel, TimePoint at, std::vector<float> values);

    // Readers.
    [[nodiscard]] int channelCount() const { return static_cast<int>(m_latest.size()); }
    [[nodiscard]] float latest(int channel) const override;
    [[nodiscard]] TimePoint latestAt(int channel) const override;
    /// The newest array of a channel; empty before the first.
    [[nodiscard]] ArraySample latestArray(int channel) const;
    /// The kept arrays of a channel that are later than this time, oldest first.
    [[nodiscard]] std::vector<ArraySample> arraysAfter(int channel, double time) const;
    /// All groups that carry a channel, oldest first, as views.
    [[nodiscard]] std::vector<TrackView> tracks(int channel) const;
    /// Changes when a group was added: tracks() must be called again.
    [[nodiscard]] int generation() const { return m_generation.load(std::memory_order_acquire); }
    [[nodiscard]] TimePoint origin() const { return m_origin; }
    /// A point in time as seconds since the origin.
    [[nodiscard]] double secondsAt(TimePoint time) const { return seconds(time - m_origin); }
    /// The present of this store, in seconds since its origin: by the clock, or the newest sample while a
    /// recording is played in its own time.
    [[nodiscard]] double now() const
    {
        return m_replayed ? m_newest.load(std::memory_order_relaxed) : secondsAt(Clock::now());
    }
    void setReplayed(bool replayed) { m_replayed = replayed; }
    /// Date and time at a time of this store.
    [[nodiscard]] QDateTime wallClockAt(double time) const
    {
        return m_wallOrigin.addMSecs(qint64(time * 1000.0));
    }
    /// Rows appended in all groups, and rows that were found missing.
    [[nodiscard]] quint64 rows() const { return m_rows.load(std::memory_order_relaxed); }
    [[nodiscard]] quint64 lost() const { return m_lost.load(std::memory_order_relaxed); }
    void countLost(quint64 rows) { m_lost.fetch_add(rows, std::memory_order_relaxed); }
    /// A value that came and is none: not a number, beyond anything that can be measured. It is a gap.
    void countInvalid(int channel)
    {
        m_invalid[std::size_t(channel)].fetch_add(1, std::memory_order_relaxed);
    }
    [[nodiscard]] quint64 invalid(int channel) const
    {
        return m_invalid[std::size_t(channel)].load(std::memory_order_relaxed);
    }
    /// A sample came at this time that is new by the board's own clock, whatever its values are.
    void noteStamp(TimePoint at)
    {
        m_stampedAt.store(at.time_since_epoch().count(), std::memory_order_relaxed);
    }
    /// When that was last; TimePoint{} = never.
    [[nodiscard]] TimePoint stampedAt() const
    {
        return TimePoint(Duration(m_stampedAt.load(std::memory_order_relaxed)));
    }
    /// A frame came at this time, but what it tells is no new sample: the board sends the same again and
    /// again.
    void noteRepeat(TimePoint at)
    {
        m_repeatedAt.store(at.time_since_epoch().count(), std::memory_order_relaxed);
    }
    /// When that was last; TimePoint{} = never.
    [[nodiscard]] TimePoint repeatedAt() const
    {
        return TimePoint(Duration(m_repeatedAt.load(std::memory_order_relaxed)));
    }
    /// Rows that counted as lost have come after all.
    void countFound(quint64 rows) { m_lost.fetch_sub(rows, std::memory_order_relaxed); }
    /// How often nothing at all came from the board, and for how long altogether: it was busy, or the cable
    /// was out.
    [[nodiscard]] quint64 silences() const { return m_silences.load(std::memory_order_relaxed); }
    [[nodiscard]] double silentSeconds() const { return m_silentSeconds.load(std::memory_order_relaxed); }
    void countSilence(double seconds);
    void setRetention(double seconds) { m_retention = seconds; }

private:
    TimePoint m_origin;
    QDateTime m_wallOrigin = QDateTime::currentDateTime();
    std::atomic<bool> m_replayed = false;
    std::atomic<double> m_newest = 0;
    std::atomic<double> m_retention = 600.0;
    std::vector<std::atomic<float>> m_latest;
    std::vector<std::atomic<Duration::rep>> m_latestAt;  // ticks of the clock
    std::vector<std::atomic<quint64>> m_invalid;
    std::atomic<int> m_generation = 0;
    std::atomic<quint64> m_rows = 0;
    std::atomic<quint64> m_lost = 0;
    std::atomic<Duration::rep> m_stampedAt = TimePoint{}.time_since_epoch().count();
    std::atomic<Duration::rep> m_repeatedAt = TimePoint{}.time_since_epoch().count();
    std::atomic<quint64> m_silences = 0;
    std::atomic<double> m_silentSeconds = 0;
    mutable std::mutex m_mutex;
    std::vector<std::shared_ptr<TelemetryGroup>> m_groups;
    std::map<int, std::deque<ArraySample>> m_arrays;
};

/// Assigns times to samples: index times nominal period, slowly corrected by arrival, so that a reader that
/// was busy for 80 ms draws no steps.
class SampleClock
{
public:
    /// @param resync deviation in seconds that starts a new time line
    explicit SampleClock(double period, double resync = 0.25)
        : m_period(period)
        , m_resync(resync)
    {
    }

    /// Time of the next sample, from its arrival and the number of samples missing before it.
    double next(double arrival, int missing = 0);

private:
    double m_period;
    double m_resync;
    std::optional<double> m_last;
};
