// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/telemetrystore.h"

#include <QTest>

#include <cmath>
#include <random>
#include <thread>

namespace {

constexpr std::size_t kChunk = TelemetryGroup::kRowsPerChunk;
constexpr std::size_t kBlock = TelemetryGroup::kRowsPerBlock;

void append(TelemetryStore &store, TelemetryGroup &group, double time, std::initializer_list<float> values)
{
    const std::vector<float> row(values);
    store.append(group, store.origin() + durationFromSeconds(time), row);
}

}  // namespace

/// The column store of what arrived, against a plain list of it.
class TestTelemetryStore : public QObject
{
    Q_OBJECT
private slots:
    void keepsEverySample();
    void isReadWhileItIsWritten();
    void everyRowIsWholeWhileItIsWritten();
    void forgetsWhatIsTooOld();
    void retentionMayChange();
    void viewsKeepWhatTheyHold();
    void gapsAreNoRowsButPlaces();
    void interruptionIsAGapInEachGroup();
    void groupsFollowOneAnother();
    void rowAtIsTheFirstNotBefore();
    void extentsAreThoseOfTheirRows();
    void latestIsOfAnyGroup();
    void countsAreKept();
    void presentOfARecordingIsItsNewestSample();
    void wallClockFollows();
    void sampleClockIgnoresLateArrival();
    void sampleClockCountsWhatIsMissing();
    void sampleClockBeginsAnewAfterAHole();
    void sampleClockNeverGoesBack();
    void sampleClockWithoutAPeriodTakesArrivals();
};

void TestTelemetryStore::keepsEverySample()
{
    TelemetryStore store(4);
    const auto group = store.defineGroup({1, 3}, 0.001);
    for (int i = 0; i < 5000; ++i)
        store.append(*group, store.origin() + std::chrono::milliseconds(i), std::array{float(i), float(-i)});
    auto tracks = store.tracks(3);
    QCOMPARE(tracks.size(), std::size_t(1));
    QCOMPARE(tracks[0].end(), std::size_t(5000));
    QCOMPARE(tracks[0].period(), 0.001);
    for (std::size_t i = 0; i < 5000; ++i) {
        QCOMPARE(tracks[0].value(i), -float(i));
        QVERIFY(std::abs(tracks[0].time(i) - double(i) * 0.001) < 1e-9);
    }
    QCOMPARE(tracks[0].rowAt(2.5), std::size_t(2500));
    QCOMPARE(tracks[0].rowAt(-1), std::size_t(0));
    QCOMPARE(tracks[0].rowAt(99), std::size_t(5000));
    QCOMPARE(store.latest(1), 4999.0F);
    QVERIFY(std::isnan(store.latest(0)));
    QVERIFY(std::isnan(store.latest(77)));
    QVERIFY(store.tracks(0).empty());
    store.appendGap(*group, store.origin() + 6s);
    tracks[0].refresh();
    QVERIFY(std::isnan(tracks[0].value(5000)));
}

void TestTelemetryStore::isReadWhileItIsWritten()
{
    TelemetryStore store(1);
    const auto group = store.defineGroup({0}, 0.001);
    constexpr int kRows = 200000;
    std::thread writer([&] {
        for (int i = 0; i < kRows; ++i) {
            const float row[] = {float(i)};
            store.append(*group, store.origin() + std::chrono::microseconds(i), row);
        }
    });
    auto tracks = store.tracks(0);
    std::size_t next = 0;
    bool right = true;
    while (next < kRows) {
        tracks[0].refresh();
        for (; next < tracks[0].end(); ++next)
            right &= tracks[0].value(next) == float(next);
    }
    writer.join();
    QVERIFY(right);
}

// Retention drops chunks below readers of several channels: what a view shows is still what was written.
void TestTelemetryStore::everyRowIsWholeWhileItIsWritten()
{
    TelemetryStore store(3);
    store.setRetention(0.002);
    const auto group = store.defineGroup({0, 1, 2}, 1e-6);
    constexpr std::size_t kRows = 100000;
    std::thread writer([&] {
        for (std::size_t i = 0; i < kRows; ++i) {
            const auto value = float(i);
            const float row[] = {value, 2 * value, -value};
            store.append(*group, store.origin() + std::chrono::microseconds(i), row);
        }
    });
    std::array tracks{store.tracks(0).front(), store.tracks(1).front(), store.tracks(2).front()};
    bool right = true;
    for (std::size_t seen = 0; seen < kRows; seen = tracks[2].end()) {
        for (TrackView &track : tracks)
            track.refresh();
        for (std::size_t row = tracks[2].begin(); row < tracks[0].end(); row += 97) {
            const auto value = float(row);
            right &= tracks[2].value(row) == -value
                && std::abs(tracks[2].time(row) - double(row) * 1e-6) < 1e-8;
            if (row >= tracks[1].begin())
                right &= tracks[1].value(row) == 2 * value;
            if (row >= tracks[0].begin())
                right &= tracks[0].value(row) == value;
        }
    }
    writer.join();
    QVERIFY(right);
    QVERIFY(store.tracks(0).front().begin() > 0);
}

void TestTelemetryStore::forgetsWhatIsTooOld()
{
    TelemetryStore store(1);
    store.setRetention(10.0);
    const auto group = store.defineGroup({0}, 0.01);
    for (int i = 0; i < 6000; ++i)
        append(store, *group, i * 0.01, {float(i)});
    const auto tracks = store.tracks(0);
    QVERIFY(tracks[0].begin() > 0);
    QVERIFY(tracks[0].time(tracks[0].begin()) <= 50.0);
    QVERIFY(tracks[0].time(tracks[0].begin()) > 35.0);
    QCOMPARE(tracks[0].value(tracks[0].begin()), float(tracks[0].begin()));
}

void TestTelemetryStore::retentionMayChange()
{
    TelemetryStore store(1);
    store.setRetention(1e6);
    const auto group = store.defineGroup({0}, 0.01);
    std::size_t i = 0;
    for (; i < 10 * kChunk; ++i)
        append(store, *group, double(i) * 0.01, {float(i)});
    QCOMPARE(store.tracks(0).front().begin(), std::size_t(0));
    store.setRetention(0.0);
    for (; i < 11 * kChunk; ++i)
        append(store, *group, double(i) * 0.01, {float(i)});
    // Whole chunks only, and never the one before the last.
    const auto begin = store.tracks(0).front().begin();
    QCOMPARE(begin, 9 * kChunk);
    QCOMPARE(store.tracks(0).front().end(), 11 * kChunk);
}

void TestTelemetryStore::viewsKeepWhatTheyHold()
{
    TelemetryStore store(1);
    store.setRetention(1.0);
    const auto group = store.defineGroup({0}, 0.01);
    for (std::size_t i = 0; i < kChunk; ++i)
        append(store, *group, double(i) * 0.01, {float(i)});
    TrackView old = store.tracks(0).front();
    for (std::size_t i = kChunk; i < 6 * kChunk; ++i)
        append(store, *group, double(i) * 0.01, {float(i)});
    QVERIFY(store.tracks(0).front().begin() > kChunk);
    // Not refreshed: nothing has changed for this reader.
    QCOMPARE(old.begin(), std::size_t(0));
    QCOMPARE(old.end(), kChunk);
    for (std::size_t i = 0; i < kChunk; ++i)
        QCOMPARE(old.value(i), float(i));
    old.refresh();
    QCOMPARE(old.begin(), store.tracks(0).front().begin());
    QCOMPARE(old.end(), 6 * kChunk);
    QCOMPARE(old.value(old.begin()), float(old.begin()));
}

void TestTelemetryStore::gapsAreNoRowsButPlaces()
{
    TelemetryStore store(2);
    const auto group = store.defineGroup({0, 1}, 0.001);
    append(store, *group, 0.000, {1.0F, 2.0F});
    store.appendGap(*group, store.origin() + 1ms);
    store.countLost(1);
    append(store, *group, 0.002, {3.0F, 4.0F});
    const TrackView track = store.tracks(1).front();
    QCOMPARE(track.end(), std::size_t(3));
    QCOMPARE(track.value(0), 2.0F);
    QVERIFY(std::isnan(track.value(1)));
    QVERIFY(std::abs(track.time(1) - 0.001) < 1e-9);
    QCOMPARE(track.value(2), 4.0F);
    QCOMPARE(store.rows(), quint64(2));
    QCOMPARE(store.lost(), quint64(1));
    QCOMPARE(store.latest(1), 4.0F);
}

void TestTelemetryStore::groupsFollowOneAnother()
{
    TelemetryStore store(3);
    QCOMPARE(store.generation(), 0);
    const auto first = store.defineGroup({0, 1}, 0.01);
    const int before = store.generation();
    append(store, *first, 0.0, {1.0F, 2.0F});
    QCOMPARE(store.generation(), before);  // rows alone change nothing
    const auto second = store.defineGroup({2, 1}, 0.001);
    QVERIFY(store.generation() != before);
    append(store, *second, 1.0, {3.0F, 4.0F});
    const auto tracks = store.tracks(1);
    QCOMPARE(tracks.size(), std::size_t(2));
    QCOMPARE(tracks[0].group(), first.get());  // oldest first
    QCOMPARE(tracks[1].group(), second.get());
    QCOMPARE(tracks[0].value(0), 2.0F);
    QCOMPARE(tracks[1].value(0), 4.0F);
    QCOMPARE(store.tracks(0).size(), std::size_t(1));
    QCOMPARE(store.tracks(2).size(), std::size_t(1));
    QCOMPARE(store.channelCount(), 3);
}

void TestTelemetryStore::rowAtIsTheFirstNotBefore()
{
    TelemetryStore store(1);
    store.setRetention(20.0);
    const auto group = store.defineGroup({0}, 0.0);
    std::mt19937 random(5);
    std::uniform_int_distribution<int> step(0, 20);  // milliseconds; several rows at one time are allowed
    int time = 0;
    for (std::size_t i = 0; i < 5 * kChunk; ++i) {
        append(store, *group, time * 0.001, {float(i)});
        time += step(random);
    }
    const TrackView track = store.tracks(0).front();
    QVERIFY(track.begin() > 0);
    std::uniform_real_distribution<double> anyTime(-1.0, time * 0.001 + 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double wanted
            = i % 2 ? anyTime(random) : track.time(track.begin() + random() % (track.end() - track.begin()));
        std::size_t row = track.begin();
        while (row < track.end() && track.time(row) < wanted)
            ++row;
        QCOMPARE(track.rowAt(wanted), row);
    }
}

void TestTelemetryStore::interruptionIsAGapInEachGroup()
{
    TelemetryStore store(3);
    const auto fast = store.defineGroup({0}, 0.001);
    const auto polled = store.defineGroup({1}, 0.0);
    store.defineGroup({2}, 0.0);  // nothing came in it
    append(store, *fast, 0.5, {1.0F});
    append(store, *polled, 0.3, {2.0F});
    store.interrupt();
    append(store, *fast, 0.501, {3.0F});
    append(store, *polled, 0.502, {4.0F});
    for (const int channel : {0, 1}) {
        const TrackView track = store.tracks(channel).front();
        QCOMPARE(track.end(), std::size_t(3));
        QVERIFY(std::isnan(track.value(1)));
        QVERIFY(track.time(1) > track.time(0) && track.time(1) < track.time(2));
    }
    QCOMPARE(store.tracks(2).front().end(), std::size_t(0));
    QCOMPARE(store.rows(), quint64(4));
}

void TestTelemetryStore::extentsAreThoseOfTheirRows()
{
    TelemetryStore store(2);
    const auto group = store.defineGroup({0, 1}, 0.001);
    std::mt19937 random(6);
    std::normal_distribution<float> noise;
    for (std::size_t i = 0; i < 3 * kChunk + 5; ++i) {
        if (i % 700 == 33)
            store.appendGap(*group, store.origin() + durationFromSeconds(double(i) * 0.001));
        else
            append(store, *group, double(i) * 0.001, {noise(random), -1000.0F});
        // A block is there with its last row and not before.
        const TrackView track = store.tracks(0).front();
        const std::size_t block = i - i % kBlock;
        if (i % kBlock != kBlock - 1)
            QVERIFY(!track.block(block));
    }
    for (const int channel : {0, 1}) {
        const TrackView track = store.tracks(channel).front();
        int lost = 0;
        for (std::size_t row = 0; row + kBlock <= track.end(); row += kBlock) {
            float low = std::numeric_limits<float>::infinity();
            float high = -low;
            bool whole = true;
            for (std::size_t i = row; i < row + kBlock; ++i) {
                whole &= !std::isnan(track.value(i));
                low = std::min(low, track.value(i));
                high = std::max(high, track.value(i));
            }
            const auto extent = track.block(row);
            QCOMPARE(extent.has_value(), whole);
            lost += !whole;
            if (whole) {
                QCOMPARE(extent->low, low);
                QCOMPARE(extent->high, high);
            }
            QVERIFY(!track.block(row + 1));
        }
        QCOMPARE(lost, 5);
        QVERIFY(!track.block(track.end() - track.end() % kBlock));
        QVERIFY(!track.block(track.end() + kBlock));
    }
}

void TestTelemetryStore::latestIsOfAnyGroup()
{
    TelemetryStore store(2);
    const auto slow = store.defineGroup({0}, 0.1);
    const auto fast = store.defineGroup({0, 1}, 0.01);
    append(store, *fast, 0.0, {1.0F, 2.0F});
    append(store, *slow, 0.1, {3.0F});
    QCOMPARE(store.latest(0), 3.0F);
    QCOMPARE(store.latest(1), 2.0F);
    append(store, *fast, 0.2, {4.0F, std::numeric_limits<float>::quiet_NaN()});
    QCOMPARE(store.latest(0), 4.0F);
    QVERIFY(std::isnan(store.latest(1)));
    QVERIFY(std::isnan(store.latest(-1)) && std::isnan(store.latest(2)));
}

void TestTelemetryStore::countsAreKept()
{
    TelemetryStore store(1);
    const auto group = store.defineGroup({0}, 0.01);
    for (int i = 0; i < 10; ++i)
        append(store, *group, i * 0.01, {0.0F});
    store.countLost(3);
    store.countLost(4);
    store.countSilence(0.5);
    store.countSilence(1.25);
    QCOMPARE(store.rows(), quint64(10));
    QCOMPARE(store.lost(), quint64(7));
    QCOMPARE(store.silences(), quint64(2));
    QCOMPARE(store.silentSeconds(), 1.75);
}

void TestTelemetryStore::presentOfARecordingIsItsNewestSample()
{
    TelemetryStore store(1);
    const auto group = store.defineGroup({0}, 0.01);
    append(store, *group, 500.0, {1.0F});
    append(store, *group, 499.0, {1.0F});  // of another stream, say
    QVERIFY(store.now() < 100.0);  // a live link: the clock's
    store.setReplayed(true);
    QCOMPARE(store.now(), 500.0);
}

void TestTelemetryStore::wallClockFollows()
{
    const TelemetryStore store(1);
    const QDateTime begin = store.wallClockAt(0.0);
    QVERIFY(std::abs(begin.secsTo(QDateTime::currentDateTime())) < 60);
    QCOMPARE(begin.msecsTo(store.wallClockAt(12.345)), qint64(12345));
    QCOMPARE(store.secondsAt(store.origin() + 1500ms), 1.5);
}

void TestTelemetryStore::sampleClockIgnoresLateArrival()
{
    SampleClock clock(0.001);
    double worst = 0;
    double last = clock.next(0.0);
    for (int i = 1; i < 3000; ++i) {
        // A reader that was busy gets 80 samples at once, each 80 ms.
        const double time = clock.next(std::ceil(i / 80.0) * 0.080);
        worst = std::max(worst, std::abs(time - last - 0.001));
        last = time;
    }
    QVERIFY2(worst < 0.002, qPrintable(QString::number(worst)));
    QVERIFY(std::abs(last - 3.0) < 0.1);
}

void TestTelemetryStore::sampleClockCountsWhatIsMissing()
{
    SampleClock clock(0.01);
    QCOMPARE(clock.next(5.0), 5.0);
    QVERIFY(std::abs(clock.next(5.01) - 5.01) < 1e-12);
    QVERIFY(std::abs(clock.next(5.05, 3) - 5.05) < 1e-12);
    QVERIFY(std::abs(clock.next(5.06) - 5.06) < 1e-12);
}

void TestTelemetryStore::sampleClockBeginsAnewAfterAHole()
{
    SampleClock clock(0.01);
    clock.next(0.0);
    QCOMPARE(clock.next(7.0), 7.0);  // further off than anything that disciplining would make good
    QVERIFY(std::abs(clock.next(7.01) - 7.01) < 1e-12);
    SampleClock patient(0.01, 10.0);
    patient.next(0.0);
    QVERIFY(patient.next(7.0) < 1.0);
}

void TestTelemetryStore::sampleClockNeverGoesBack()
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> late(0.0, 0.4);
    SampleClock clock(0.005);
    double last = clock.next(0.0);
    for (int i = 1; i < 20000; ++i) {
        const double time = clock.next(i * 0.005 + late(random) - (i % 1000 == 0 ? 3.0 : 0.0));
        QVERIFY(time >= last);
        last = time;
    }
}

void TestTelemetryStore::sampleClockWithoutAPeriodTakesArrivals()
{
    SampleClock clock(0.0);
    for (const double arrival : {1.0, 1.5, 1.5, 9.0})
        QCOMPARE(clock.next(arrival), arrival);
}

QTEST_APPLESS_MAIN(TestTelemetryStore)
#include "tst_telemetrystore.moc"
