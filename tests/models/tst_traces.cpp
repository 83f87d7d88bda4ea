// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotlayout.h"
#include "widgets/plot/plotmarks.h"
#include "widgets/plot/spanmeter.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/plot/tracecolumns.h"
#include "widgets/plot/valuescale.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRate = 1250.0;

// A store with a random walk, lost rows and a long hole.
std::shared_ptr<TelemetryStore> someStore(int rows, unsigned seed, bool lossy)
{
    auto store = std::make_shared<TelemetryStore>(2);
    auto group = store->defineGroup({0, 1}, 1.0 / kRate);
    std::mt19937 generator(seed);
    std::normal_distribution<float> step(0.0F, 1.0F);
    std::array<float, 2> values{};
    double time = 0.0;
    for (int i = 0; i < rows; ++i, time += 1.0 / kRate) {
        values[0] += step(generator);
        values[1] = step(generator);
        const TimePoint at = store->origin() + durationFromSeconds(time);
        if (lossy && i % 997 == 500) {
            store->appendGap(*group, at);
            continue;
        }
        if (lossy && i % 5000 == 4000)
            time += 2.0;
        store->append(*group, at, values);
    }
    return store;
}

}  // namespace

/// What the plot draws, against a plain reading of every sample.
class TestTraces : public QObject
{
    Q_OBJECT
private slots:
    void columnsHoldEverySample_data();
    void columnsHoldEverySample();
    void columnsGrowAsTheyWouldAtOnce();
    void blocksTellWhatTheirRowsTell();
    void blocksFollowRetention();
    void storeKeepsWithinItsBytes();
    void meterSaysWhatEachSampleSays_data();
    void meterSaysWhatEachSampleSays();
    void meterFollowsRetention();
    void statisticsAroundTheMean();
    void anglesGoRound();
    void scaleFollowsWithHysteresis();
    void scaleStandsStillWhereItWasPut();
    void marksAreInOrderAndFound();
    void layoutsSurviveTheirFile();
};

void TestTraces::meterSaysWhatEachSampleSays_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<int>("minus");
    QTest::newRow("all") << -1.0 << 1e9 << -1;
    QTest::newRow("inside one chunk") << 1.0 << 1.2 << -1;
    QTest::newRow("over chunks") << 0.7 << 6.3 << -1;
    QTest::newRow("difference") << 0.7 << 6.3 << 1;
    QTest::newRow("nothing") << 500.0 << 600.0 << -1;
}

void TestTraces::meterSaysWhatEachSampleSays()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(int, minus);
    const auto store = someStore(12000, 3, true);
    const SpanStatistics wanted = spanStatistics(*store, 0, minus, from, to);
    SpanMeter meter(store, 0, minus);
    for (int i = 0; i < 2; ++i) {  // the second time from what is kept
        const SpanMeter::Figures figures = meter.measure(from, to);
        QCOMPARE(figures.samples, wanted.samples);
        if (wanted.samples == 0)
            continue;
        QVERIFY(std::abs(figures.mean - wanted.mean) < 1e-6 * (1 + std::abs(wanted.mean)));
        QVERIFY(std::abs(figures.rms - wanted.rms) < 1e-6 * (1 + wanted.rms));
        QCOMPARE(std::max(std::abs(figures.low), std::abs(figures.high)), wanted.peak);
        QVERIFY(figures.low <= figures.mean && figures.mean <= figures.high);
    }
}

void TestTraces::meterFollowsRetention()
{
    auto store = std::make_shared<TelemetryStore>(1);
    store->setRetention(2.0);
    auto group = store->defineGroup({0}, 1.0 / kRate);
    SpanMeter meter(store, 0, -1);
    for (int i = 0; i < 20000; ++i) {
        const float value = float(i);
        store->append(*group, store->origin() + durationFromSeconds(i / kRate), std::span(&value, 1));
        if (i % 3000 == 2999) {
            const SpanMeter::Figures figures = meter.measure(i / kRate - 1.0, i / kRate + 1.0);
            QCOMPARE(figures.high, double(i));
            QVERIFY(figures.samples >= 1249 && figures.samples <= 1251);
            QVERIFY(std::abs(figures.rate - kRate) < 1.0);
        }
    }
}

void TestTraces::statisticsAroundTheMean()
{
    auto store = std::make_shared<TelemetryStore>(1);
    auto group = store->defineGroup({0}, 1.0 / kRate);
    const std::array<float, 4> values{9, 10, 10, 7};  // mean 9; it strays further down than up
    for (std::size_t i = 0; i < values.size(); ++i)
        store->append(*group, store->origin() + durationFromSeconds(double(i) / kRate),
                      std::span(&values[i], 1));
    const SpanStatistics all = spanStatistics(*store, 0, -1, -1.0, 1.0);
    QCOMPARE(all.samples, values.size());
    QCOMPARE(all.mean, 9.0);
    QCOMPARE(all.peak, 10.0);
    const SpanStatistics strays = all.aroundMean();
    QCOMPARE(strays.mean, 0.0);
    QCOMPARE(strays.peak, 2.0);
    QVERIFY(std::abs(strays.rms - std::sqrt(1.5)) < 1e-9);
    QVERIFY(
        std::isnan(spanStatistics(*store, 0, -1, 5.0, 6.0).aroundMean().rms));  // nothing is not stillness
}

// Whoever turns from 180 to -180 degrees has hardly moved, and the way to a target is the shorter one.
void TestTraces::anglesGoRound()
{
    auto store = std::make_shared<TelemetryStore>(2);
    auto group = store->defineGroup({0, 1}, 1.0 / kRate);
    const std::array<std::array<float, 2>, 4> values{{{179, -179}, {-179, -179}, {-178, 180}, {178, 180}}};
    for (std::size_t i = 0; i < values.size(); ++i)
        store->append(*group, store->origin() + durationFromSeconds(double(i) / kRate), std::span(values[i]));
    QCOMPARE(spanStatistics(*store, 0, -1, -1.0, 1.0, true).aroundMean().peak, 2.0);
    QCOMPARE(spanStatistics(*store, 0, 1, -1.0, 1.0, true).peak, 2.0);
    QVERIFY(spanStatistics(*store, 0, -1, -1.0, 1.0).aroundMean().peak > 100);
}

void TestTraces::scaleFollowsWithHysteresis()
{
    ValueScale scale;
    QVERIFY(scale.fit(-37, 12));
    QVERIFY(scale.low() <= -37 && scale.high() >= 12);
    const double step = (scale.high() - scale.low()) / scale.steps();
    QVERIFY(std::abs(std::remainder(scale.low(), step)) < 1e-9);  // labels are round numbers
    QVERIFY(!scale.fit(-35, 10));  // fits: nothing moves
    QVERIFY(!scale.fit(-1, 1));  // much smaller, but only just now
    QVERIFY(scale.fit(-80, 10));  // greater: at once
    QVERIFY(scale.low() <= -80);
    for (const int most : {1, 2, 3, 4, 5, 6}) {
        for (const auto &[low, high] :
             {std::pair(-0.3, 0.4), {9.0, 11.0}, {-0.02, 5.0}, {-7.0, -6.9}, {0.0, 0.0}}) {
            ValueScale small;
            small.setMostSteps(most);
            small.fit(low, high);
            QVERIFY(small.low() <= low && small.high() >= high);
            QVERIFY(small.steps() >= 1 && small.steps() <= most);
            const double part = (small.high() - small.low()) / small.steps();
            QVERIFY(small.steps() == 1 || std::abs(std::remainder(small.low(), part)) < 1e-9);
        }
    }
    QVERIFY(ValueScale().fit(5, 5) || ValueScale().low() <= 5);  // a single value is no crash
}

void TestTraces::scaleStandsStillWhereItWasPut()
{
    ValueScale scale;
    scale.fix(0.011, 0.029);
    QVERIFY(scale.low() <= 0.011 && scale.high() >= 0.029 && scale.high() - scale.low() < 0.04);
    QVERIFY(!scale.fit(-100, 100));
    scale.release();
    QVERIFY(scale.fit(-100, 100));
    scale.fix(3, 3);  // no height at all
    QVERIFY(scale.high() > scale.low());
}

void TestTraces::marksAreInOrderAndFound()
{
    PlotMarks marks;
    for (const double time : {5.0, 1.0, 3.0})
        marks.add({time, PlotMark::Kind::Note, QString::number(time)});
    QCOMPARE(marks.between(0.5, 3.5).size(), std::size_t(2));
    QCOMPARE(marks.near(2.8, 0.5)->text, u"3"_s);
    QVERIFY(!marks.near(2.0, 0.5));
    QCOMPARE(marks.next(1.0, true), std::optional(3.0));
    QCOMPARE(marks.next(3.0, false), std::optional(1.0));
    QCOMPARE(marks.next(5.0, true), std::optional<double>());
    QCOMPARE(marks.next(1.0, false), std::optional<double>());
    for (int i = 0; i < 5000; ++i)
        marks.add({double(i), PlotMark::Kind::Note, {}});
    QCOMPARE(marks.all().size(), std::size_t(2000));  // the oldest went
    marks.clear();
    QVERIFY(marks.between(0, 1e9).empty());
}

void TestTraces::layoutsSurviveTheirFile()
{
    const std::array<ChannelSpec, 3> table{
        {{"a", "A", "", "V", 0}, {"b", "B", "", "A", 0}, {"c", "C", "", "V", 0}}};
    const PlotLayout layout{{{{0, 1}, true, false}, {{2}, false, true}}, 30};
    const PlotLayout read = PlotLayout::fromJson(layout.toJson(table), table);
    QVERIFY(read.plots == layout.plots);
    QCOMPARE(read.seconds, 30.0);
    // On a board without the third channel.
    const PlotLayout fewer = PlotLayout::fromJson(layout.toJson(table), std::span(table).first(2));
    QCOMPARE(fewer.plots.size(), 1);
    for (const char *bad :
         {"", "{", "[]", R"({"plots":3})", R"({"plots":[3,{"channels":"a"}],"seconds":-7})"})
        QVERIFY(PlotLayout::fromJson(bad, table).plots.isEmpty());
    const PlotLayout byUnit = PlotLayout::byUnit(table, {0, 1, 2});
    QCOMPARE(byUnit.plots.size(), 2);
    QCOMPARE(byUnit.plots[0].channels, (QList<int>{0, 2}));
}

void TestTraces::columnsHoldEverySample_data()
{
    QTest::addColumn<double>("pitch");
    QTest::addColumn<bool>("lossy");
    for (const double pitch : {0.0004, 0.008, 0.013, 0.1, 0.5}) {
        QTest::addRow("%g s", pitch) << pitch << false;
        QTest::addRow("%g s, lossy", pitch) << pitch << true;
    }
}

void TestTraces::columnsHoldEverySample()
{
    QFETCH(double, pitch);
    QFETCH(bool, lossy);
    const auto store = someStore(20000, 3, lossy);
    auto sources = TraceSource::find(*store, 0, -1);
    sources.front().refresh();
    const TrackView &track = sources.front().track;
    const qint64 columns = qint64(track.time(track.end() - 1) / pitch) + 1;
    TraceColumns drawn;
    drawn.reset(int(columns), pitch, 0);
    drawn.update(sources);
    std::vector<TraceColumns::Span> wanted{std::size_t(columns)};
    for (std::size_t row = track.begin(); row < track.end(); ++row) {
        const float value = track.value(row);
        if (std::isnan(value))
            continue;
        TraceColumns::Span &span = wanted[std::size_t(drawn.columnOf(track.time(row)))];
        span = span.isEmpty() ? TraceColumns::Span{value, value}
                              : TraceColumns::Span{std::min(span.low, value), std::max(span.high, value)};
    }
    for (qint64 column = 0; column < columns; ++column) {
        const TraceColumns::Span &samples = wanted[std::size_t(column)];
        const TraceColumns::Span span = drawn.span(column);
        if (samples.isEmpty())
            continue;  // a line between samples may pass through
        QVERIFY(!span.isEmpty());
        QVERIFY(span.low <= samples.low && span.high >= samples.high);
        // Beyond its samples a column reaches only to where the line crosses its edges.
        float low = samples.low;
        float high = samples.high;
        for (const qint64 next : {column - 1, column + 1}) {
            if (next >= 0 && next < columns && !wanted[std::size_t(next)].isEmpty()) {
                low = std::min(low, wanted[std::size_t(next)].low);
                high = std::max(high, wanted[std::size_t(next)].high);
            }
        }
        if (pitch > 1.0 / kRate)
            QVERIFY(span.low >= low && span.high <= high);
    }
}

void TestTraces::columnsGrowAsTheyWouldAtOnce()
{
    // In one go against in odd pieces: the same picture.
    auto store = std::make_shared<TelemetryStore>(1);
    auto group = store->defineGroup({0}, 1.0 / kRate);
    auto liveSources = TraceSource::find(*store, 0, -1);
    TraceColumns live;
    live.reset(400, 0.1, 0);
    std::mt19937 generator(5);
    std::normal_distribution<float> normal(0.0F, 1.0F);
    for (int i = 0; i < 30000; ++i) {
        store->append(*group, store->origin() + durationFromSeconds(i / kRate),
                      std::array<float, 1>{normal(generator)});
        if (i % 37 == 0)
            live.update(liveSources);
    }
    live.update(liveSources);
    auto sources = TraceSource::find(*store, 0, -1);
    TraceColumns whole;
    whole.reset(400, 0.1, 0);
    whole.update(sources);
    for (qint64 column = 0; column < 240; ++column) {
        QCOMPARE(live.span(column).low, whole.span(column).low);
        QCOMPARE(live.span(column).high, whole.span(column).high);
        QVERIFY(!whole.span(column).isEmpty());
    }
}

void TestTraces::blocksTellWhatTheirRowsTell()
{
    const auto store = someStore(5000, 7, true);
    std::size_t complete = 0;
    for (TrackView track : store->tracks(1)) {
        track.refresh();
        QVERIFY(!track.block(1));
        QVERIFY(!track.block(track.end() - track.end() % 16));
        for (std::size_t row = 0; row + 16 <= track.end(); row += 16) {
            float low = track.value(row);
            float high = low;
            bool lost = false;
            for (std::size_t i = row; i < row + 16; ++i) {
                lost = lost || std::isnan(track.value(i));
                low = std::min(low, track.value(i));
                high = std::max(high, track.value(i));
            }
            const auto block = track.block(row);
            QCOMPARE(block.has_value(), !lost);
            if (lost)
                continue;
            QCOMPARE(block->low, low);
            QCOMPARE(block->high, high);
            ++complete;
        }
    }
    QVERIFY(complete > 290);
}

void TestTraces::blocksFollowRetention()
{
    auto store = std::make_shared<TelemetryStore>(1);
    store->setRetention(2.0);
    auto group = store->defineGroup({0}, 1.0 / kRate);
    for (int i = 0; i < 20000; ++i)
        store->append(*group, store->origin() + durationFromSeconds(i / kRate),
                      std::array<float, 1>{float(i)});
    TrackView track = store->tracks(0).front();
    track.refresh();
    QVERIFY(track.begin() > 10000);
    const auto block = track.block(track.begin());
    QVERIFY(block);
    QCOMPARE(block->low, float(track.begin()));
    QCOMPARE(block->high, float(track.begin() + 15));
}

void TestTraces::storeKeepsWithinItsBytes()
{
    // Goal: 6 bytes a sample, times and index included, with 12 channels in a row.
    constexpr double channels = 12;
    constexpr double rows = TelemetryGroup::kRowsPerChunk;
    const double bytes = rows * (sizeof(double) + channels * sizeof(float))
        + TelemetryGroup::kBlocksPerChunk * channels * sizeof(TelemetryGroup::Extent);
    QVERIFY(bytes / (rows * channels) < 6.0);
}

QTEST_GUILESS_MAIN(TestTraces)
#include "tst_traces.moc"
