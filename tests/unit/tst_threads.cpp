// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the I/O thread writes and others read, driven by plain threads without a Qt event loop: it passes in
// every build, and the thread sanitizer finds hand-offs that only happen to work.
#include "protocol/client/framelog.h"
#include "protocol/record/recorder.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <atomic>
#include <barrier>
#include <thread>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kReaders = 3;

/// One writer and several readers that begin together. Looks are counted without ordering anything, so that
/// they hide no race from the sanitizer.
class Race
{
public:
    /// Waits until every reader has looked once more: whatever the scheduler does, readers see states in
    /// between and not only the last one.
    void letReadersLook() const
    {
        std::array<std::size_t, kReaders> before;
        for (std::size_t i = 0; i < kReaders; ++i)
            before[i] = m_looks[i].load(std::memory_order_relaxed);
        for (std::size_t i = 0; i < kReaders; ++i) {
            while (m_looks[i].load(std::memory_order_relaxed) == before[i] && !m_failed.test())
                std::this_thread::yield();
        }
    }

    /// @param write runs to its end on one thread
    /// @param look a reader's look; returns what is wrong, empty when nothing is. Its argument: the number of
    /// the reader. Each reader looks a last time after the writer has ended.
    template <typename Write, typename Look> QString run(Write write, Look look)
    {
        std::array<QString, kReaders> wrong;
        std::barrier start(kReaders + 1);
        std::vector<std::thread> readers;
        for (std::size_t i = 0; i < kReaders; ++i) {
            readers.emplace_back([&, i] {
                start.arrive_and_wait();
                for (bool last = false; wrong[i].isEmpty() && !last;) {
                    last = m_ended.load(std::memory_order_acquire);
                    wrong[i] = look(i);
                    m_looks[i].fetch_add(1, std::memory_order_relaxed);
                }
                if (!wrong[i].isEmpty())
                    m_failed.test_and_set();
            });
        }
        std::thread writer([&] {
            start.arrive_and_wait();
            write();
            m_ended.store(true, std::memory_order_release);
        });
        writer.join();
        for (std::thread &reader : readers)
            reader.join();
        return wrong[0] + wrong[1] + wrong[2];
    }

private:
    std::array<std::atomic<std::size_t>, kReaders> m_looks{};
    std::atomic<bool> m_ended = false;
    std::atomic_flag m_failed;
};

/// A row of the writer: both channels and its time tell its number.
constexpr std::size_t kRows = 40 * TelemetryGroup::kRowsPerChunk;
constexpr auto kPeriod = 1ms;

QString wrongRow(const TrackView &view, std::size_t row, float sign)
{
    if (view.value(row) != sign * float(row))
        return u"row %1 holds %2; "_s.arg(row).arg(view.value(row));
    if (std::abs(view.time(row) - double(row) * seconds(kPeriod)) > 1e-6)
        return u"row %1 is of %2 s; "_s.arg(row).arg(view.time(row));
    return {};
}

QString wrongView(const TrackView &view, float sign)
{
    if (view.begin() > view.end())
        return u"begins at %1 and ends at %2; "_s.arg(view.begin()).arg(view.end());
    if (view.begin() == view.end())
        return {};
    // Both ends, where chunks come and go, and rows all over.
    for (std::size_t row = view.begin(); row < view.end(); row += 61) {
        if (const QString wrong = wrongRow(view, row, sign); !wrong.isEmpty())
            return wrong;
    }
    if (const QString wrong = wrongRow(view, view.end() - 1, sign); !wrong.isEmpty())
        return wrong;
    constexpr auto kBlock = TelemetryGroup::kRowsPerBlock;
    for (std::size_t row = view.begin(); row + kBlock <= view.end(); row += kBlock) {
        const auto extent = view.block(row);
        if (!extent || extent->high - extent->low != float(kBlock - 1))
            return u"the block at row %1 has a wrong extent; "_s.arg(row);
    }
    return {};
}

QByteArray numbered(quint64 number)
{
    return QByteArray::number(number).rightJustified(40, '.');
}

}  // namespace

class TestThreads : public QObject
{
    Q_OBJECT
private slots:
    void storeIsReadWhileItGrowsAndForgets();
    void storeGainsGroupsWhileItIsRead();
    void frameLogIsReadWhileItTurnsOver();
    void recorderIsReadWhileItTurnsOver();
    void recordingIsWrittenWhileTheRecorderHears();
};

void TestThreads::storeIsReadWhileItGrowsAndForgets()
{
    TelemetryStore store(2);
    store.setRetention(3 * double(TelemetryGroup::kRowsPerChunk) * seconds(kPeriod));
    const auto group = store.defineGroup({0, 1}, seconds(kPeriod));
    std::vector<TrackView> kept{TrackView(group, 0), TrackView(group, 1), TrackView(group, 0)};

    Race race;
    const QString wrong = race.run(
        [&] {
            for (std::size_t row = 0; row < kRows; ++row) {
                const std::array<float, 2> values{float(row), -float(row)};
                store.append(*group, store.origin() + row * kPeriod, values);
                if (row % 700 == 0)
                    race.letReadersLook();
            }
        },
        [&](std::size_t reader) -> QString {
            TrackView &view = kept[reader];
            view.refresh();
            if (const QString found = wrongView(view, reader == 1 ? -1.0F : 1.0F); !found.isEmpty())
                return found;
            const float latest = store.latest(int(reader % 2));
            return std::abs(latest) < float(kRows) || std::isnan(latest) ? QString()
                                                                         : u"latest %1; "_s.arg(latest);
        });
    QCOMPARE(wrong, QString());
    for (const TrackView &view : kept) {
        QCOMPARE(view.end(), kRows);
        QVERIFY(view.begin() > 30 * TelemetryGroup::kRowsPerChunk);
    }
    QCOMPARE(store.rows(), quint64(kRows));
}

void TestThreads::storeGainsGroupsWhileItIsRead()
{
    constexpr std::size_t kGroups = 60;
    constexpr std::size_t kRowsOfEach = 50;
    TelemetryStore store(1);
    Race race;
    const QString wrong = race.run(
        [&] {
            for (std::size_t i = 0; i < kGroups; ++i) {
                const auto group = store.defineGroup({0}, seconds(kPeriod));
                for (std::size_t row = 0; row < kRowsOfEach; ++row) {
                    const std::array<float, 1> values{float(row)};
                    store.append(*group, store.origin() + row * kPeriod, values);
                }
                store.countLost(1);
                store.countSilence(0.5);
                race.letReadersLook();
            }
        },
        [&](std::size_t) -> QString {
            const int generation = store.generation();
            const auto tracks = store.tracks(0);
            if (int(tracks.size()) < generation)
                return u"%1 groups in generation %2; "_s.arg(tracks.size()).arg(generation);
            for (const TrackView &view : tracks) {
                if (const QString found = wrongView(view, 1.0F); !found.isEmpty())
                    return found;
            }
            return store.lost() <= kGroups && store.silentSeconds() <= 0.5 * kGroups ? QString()
                                                                                     : u"counters; "_s;
        });
    QCOMPARE(wrong, QString());
    QCOMPARE(store.tracks(0).size(), kGroups);
    QCOMPARE(store.silences(), quint64(kGroups));
}

void TestThreads::frameLogIsReadWhileItTurnsOver()
{
    constexpr quint64 kFrames = 20000;
    FrameLog log(300);
    std::array<quint64, kReaders> seen{};
    Race race;
    const QString wrong = race.run(
        [&] {
            for (quint64 number = 1; number <= kFrames; ++number) {
                const QByteArray bytes = numbered(number);
                const TimePoint at = TimePoint() + number * kPeriod;
                if (number % 2 == 0)
                    log.bytesSent(bytes, at);
                else
                    log.frameReceived({int(number), asBytes(bytes), 1}, at, true);
                if (number % 250 == 0)
                    race.letReadersLook();
            }
        },
        [&](std::size_t reader) -> QString {
            for (const LoggedFrame &frame : log.after(seen[reader])) {
                if (frame.bytes != numbered(frame.number) || frame.fromBoard != (frame.number % 2 == 1)
                    || frame.number <= seen[reader])
                    return u"frame %1 after %2; "_s.arg(frame.number).arg(seen[reader]);
                seen[reader] = frame.number;
            }
            return log.newest() >= seen[reader] ? QString() : u"newest; "_s;
        });
    QCOMPARE(wrong, QString());
    for (const quint64 number : seen)
        QCOMPARE(number, kFrames);
}

void TestThreads::recorderIsReadWhileItTurnsOver()
{
    constexpr quint64 kPieces = 20000;
    constexpr qsizetype kLimit = 40'000;
    Recorder recorder(600, kLimit);
    std::array<quint64, kReaders> seen{};
    Race race;
    const QString wrong = race.run(
        [&] {
            for (quint64 number = 1; number <= kPieces; ++number) {
                recorder.bytesReceived(numbered(number), TimePoint() + number * kPeriod);
                if (number % 250 == 0)
                    race.letReadersLook();
            }
        },
        [&](std::size_t reader) -> QString {
            const auto [pieces, number] = recorder.after(seen[reader]);
            quint64 of = number - pieces.size();
            for (const RecordedPiece &piece : pieces) {
                if (piece.bytes != numbered(++of))
                    return u"piece %1; "_s.arg(of);
            }
            seen[reader] = number;
            if (recorder.heldBytes() > kLimit || recorder.heldSeconds() > 600.0)
                return u"holds %1 bytes; "_s.arg(recorder.heldBytes());
            return recorder.newest() >= number ? QString() : u"newest; "_s;
        });
    QCOMPARE(wrong, QString());
    for (const quint64 number : seen)
        QCOMPARE(number, kPieces);
}

void TestThreads::recordingIsWrittenWhileTheRecorderHears()
{
    constexpr quint64 kPieces = 6000;
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"threads.rec"_s);
    Recorder recorder;
    auto task = RecordingTask::start(recorder, path, {{u"family"_s, u"test"_s}}, true);
    QVERIFY(task);

    Race race;
    const QString wrong = race.run(
        [&] {
            for (quint64 number = 1; number <= kPieces; ++number) {
                const QByteArray bytes = numbered(number);
                const TimePoint at = TimePoint() + number * kPeriod;
                if (number % 10 == 0) {
                    recorder.bytesSent(bytes, at);
                } else if (number % 10 == 1) {
                    FrameView frame{1, {}, 1};
                    frame.raw = asBytes(bytes);
                    recorder.frameReceived(frame, at, true);
                } else {
                    recorder.bytesReceived(bytes, at);
                }
                if (number % 250 == 0)
                    race.letReadersLook();
            }
        },
        [&](std::size_t) -> QString {
            return (*task)->hasFailed() || (*task)->bytesWritten() <= 0 ? u"not written; "_s : QString();
        });
    QCOMPARE(wrong, QString());
    QVERIFY((*task)->finish());

    const auto recording = Recording::load(path);
    QVERIFY(recording);
    QCOMPARE(recording->pieces.size(), std::size_t(kPieces));
    for (quint64 number = 1; number <= kPieces; ++number)
        QCOMPARE(recording->pieces[number - 1].bytes, numbered(number));
}

QTEST_APPLESS_MAIN(TestThreads)
#include "tst_threads.moc"
