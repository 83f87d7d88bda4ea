// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/restartwatch.h"

#include <QTest>

using Step = RestartWatch::Step;

namespace {

constexpr auto kLook = 250ms;
constexpr auto kAnswer = 10ms;
constexpr auto kTimeout = 300ms;

/// A board on a link, in virtual time: when it streams and when it answers.
struct WatchedBoard
{
    RestartWatch watch;
    TimePoint now = TimePoint() + 1h;
    Duration period = 100ms;
    bool isThere = true;
    bool isStreaming = true;
    TimePoint silentUntil = {};  // as announced
    std::optional<TimePoint> answer = {};  // to what was asked, or its timeout

    WatchedBoard() { watch.begin(now, seconds(period)); }
    /// Everything that it is found to be meanwhile, apart from waiting and asking.
    std::vector<Step> run(Duration time)
    {
        std::vector<Step> found;
        const TimePoint until = now + time;
        TimePoint nextSample = now;
        TimePoint nextLook = now;
        for (; now < until; now += 1ms) {
            if (now >= nextSample) {
                nextSample += period;
                if (isThere && isStreaming)
                    watch.heard(now, true);
            }
            if (answer && now >= *answer) {
                answer.reset();
                watch.answered(isThere, now);
                if (isThere)
                    watch.heard(now, false);
            }
            if (now < nextLook)
                continue;
            nextLook += kLook;
            const Step step = watch.look(now, silentUntil);
            if (step == Step::Ask)
                answer = now + (isThere ? kAnswer : kTimeout);
            else if (step != Step::Wait)
                found.push_back(step);
        }
        return found;
    }
};

}  // namespace

class TestRestartWatch : public QObject
{
    Q_OBJECT
private slots:
    void silenceThenNoStreamsIsARestart();
    void streamsThatGoOnAreNone();
    void aCalibrationIsNone_data();
    void aCalibrationIsNone();
    void aRestartInACalibrationIsOne();
    void streamsThatEndAreNone();
    void aSlowStreamIsWaitedFor();
    void nothingIsLookedForWithoutStreams();
    void aStartThatIsGoneThroughAgain();
    void anOrderIsTakenOnce();
};

void TestRestartWatch::silenceThenNoStreamsIsARestart()
{
    WatchedBoard board;
    QVERIFY(board.run(5s).empty());
    board.isThere = board.isStreaming = false;
    QVERIFY(board.run(1200ms).empty());
    board.isThere = true;
    QCOMPARE(board.run(3s), std::vector{Step::Restarted});
    QVERIFY(board.run(60s).empty());  // told once
}

// The cable was loose, or the machine was suspended.
void TestRestartWatch::streamsThatGoOnAreNone()
{
    for (const Duration silence : {300ms, 900ms, 1500ms, 30000ms}) {
        WatchedBoard board;
        QVERIFY(board.run(5s).empty());
        board.isThere = false;
        QVERIFY(board.run(silence).empty());
        board.isThere = true;
        QVERIFY(board.run(10s).empty());
    }
}

void TestRestartWatch::aCalibrationIsNone_data()
{
    QTest::addColumn<int>("announcedMs");
    QTest::addColumn<int>("lateMs");
    QTest::newRow("streams go on at once") << 8000 << 0;
    QTest::newRow("streams go on late") << 8000 << 1500;
    QTest::newRow("streams go on very late") << 8000 << 3500;
    QTest::newRow("begun by a button of the board") << 0 << 900;
}

// It answers nothing meanwhile.
void TestRestartWatch::aCalibrationIsNone()
{
    QFETCH(int, announcedMs);
    QFETCH(int, lateMs);
    WatchedBoard board;
    QVERIFY(board.run(5s).empty());
    board.silentUntil = board.now + milliseconds(announcedMs);
    board.isThere = board.isStreaming = false;
    QVERIFY(board.run(4s).empty());
    board.isThere = true;
    QVERIFY(board.run(milliseconds(lateMs)).empty());
    board.isStreaming = true;
    QVERIFY(board.run(20s).empty());
}

void TestRestartWatch::aRestartInACalibrationIsOne()
{
    WatchedBoard board;
    QVERIFY(board.run(5s).empty());
    board.silentUntil = board.now + 8s;
    board.isThere = board.isStreaming = false;
    QVERIFY(board.run(1200ms).empty());
    board.isThere = true;
    QVERIFY(board.run(6s).empty());
    QCOMPARE(board.run(4s), std::vector{Step::Restarted});
}

void TestRestartWatch::streamsThatEndAreNone()
{
    WatchedBoard board;
    QVERIFY(board.run(5s).empty());
    board.isStreaming = false;
    QCOMPARE(board.run(3s), std::vector{Step::StreamsEnded});
}

void TestRestartWatch::aSlowStreamIsWaitedFor()
{
    WatchedBoard board;
    board.period = 2s;
    board.watch.begin(board.now, 2.0);
    QVERIFY(board.run(60s).empty());
}

void TestRestartWatch::nothingIsLookedForWithoutStreams()
{
    WatchedBoard board;
    board.watch.begin(board.now, 0);
    board.isThere = board.isStreaming = false;
    QVERIFY(board.run(10s).empty());
    board.isThere = true;
    QVERIFY(board.run(10s).empty());
}

void TestRestartWatch::aStartThatIsGoneThroughAgain()
{
    RestartWatch watch;
    watch.meet(false);
    QVERIFY(!watch.takeState(true));  // it was found starting
    QVERIFY(!watch.takeState(true));
    QVERIFY(!watch.takeState(false));
    QVERIFY(watch.takeState(true));
    QVERIFY(!watch.takeState(true));
}

void TestRestartWatch::anOrderIsTakenOnce()
{
    RestartWatch watch;
    const TimePoint now = TimePoint() + 1h;
    watch.order(now + 1s);
    QCOMPARE(watch.takeOrder(now + 2s), now + 1s);
    QVERIFY(!watch.takeOrder(now + 2s));
    watch.order(now + 1s);
    QVERIFY(!watch.takeOrder(now + 60s));  // it has not restarted then
    watch.order(now + 1s);
    watch.meet(false);  // another board
    QVERIFY(!watch.takeOrder(now + 2s));
}

QTEST_GUILESS_MAIN(TestRestartWatch)
#include "tst_restartwatch.moc"
