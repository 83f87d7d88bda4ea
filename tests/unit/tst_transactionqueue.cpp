// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/controlstream.h"
#include "protocol/session/transactionqueue.h"

#include <QTest>

using namespace Qt::StringLiterals;

namespace {

Request request(const QString &name, int replyId, bool idempotent = true, int retries = 1)
{
    Request r;
    r.name = name;
    r.bytes = name.toLatin1();
    r.kind = replyId;
    r.replyBytes = 20;
    r.timeout = 100ms;
    r.idempotent = idempotent;
    r.retries = retries;
    r.answer = [replyId](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id == replyId)
            return Frame(frame);
        if (frame.id == 255)
            return failure(ErrorCode::BoardError);
        if (frame.id == 254)
            return failure(ErrorCode::Damaged);
        return {};
    };
    return r;
}

/// A queue, virtual time and a record of what was written and completed.
struct Bench
{
    Bench()
        : queue([this](QByteArrayView bytes) { written.append(QString::fromLatin1(bytes)); })
    {
        queue.setPause(10ms);
    }

    TransactionQueue::Id submit(const Request &r,
                                TransactionQueue::Lane lane = TransactionQueue::Lane::Normal)
    {
        return queue.submit(
            r,
            [this, name = r.name](const Result<Frame> &result) {
                completed.append(name + (result ? u":ok"_s : u":%1"_s.arg(int(result.error().code))));
            },
            now, lane);
    }
    void pass(milliseconds time)
    {
        const TimePoint end = now + time;
        while (now < end) {
            now += 1ms;
            queue.bytesTaken(1 << 20, now);
            queue.advance(now);
        }
    }
    bool arrive(int id) { return queue.frameArrived({id, {}, 1}, now); }

    TimePoint now = TimePoint() + 1h;
    QStringList written;
    QStringList completed;
    TransactionQueue queue;
};

QString failed(const char *name, ErrorCode code)
{
    return u"%1:%2"_s.arg(QLatin1String(name)).arg(int(code));
}

}  // namespace

class TestTransactionQueue : public QObject
{
    Q_OBJECT
private slots:
    void oneRequestInFlight();
    void keepsAPauseBetweenCommands();
    void retriesOnceThenReportsTimeout();
    void doesNotRetryWhatIsNotIdempotent();
    void completesExactlyOnce();
    void boardRefusalIsAnError();
    void damagedCommandIsSentAgain();
    void lateAnswerIsNotTakenForTheNextRequest();
    void otherKindsAreNotHeldByALateAnswer();
    void whatIsRepeatedWaitsForNoLateAnswer();
    void answerToARetriedRequestLeavesOneToCome();
    void furtherAnswersComeAsLateAsTheFirst_data();
    void furtherAnswersComeAsLateAsTheFirst();
    void urgentGoesOutAtOnce();
    void cancelInFlightAndWaiting();
    void closingTheLinkEndsEverything();
    void timerStartsWhenTheLastByteHasLeft();
    void heartbeatsDoNotPutOffTheTimeout();
    void timeoutGrowsWithASlowLine();
    void unansweredIsDoneWhenSent();
    void deadlineIsReported();
    void controlStreamRepeatsAndStops();
    void controlStreamDeadMan();
    void controlStreamEndsOnPurpose();
    void setpointsLeaveRoom_data();
    void setpointsLeaveRoom();
};

void TestTransactionQueue::oneRequestInFlight()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.submit(request(u"b"_s, 2));
    bench.pass(50ms);
    QCOMPARE(bench.written, QStringList{u"a"_s});
    QVERIFY(bench.arrive(1));
    bench.pass(1ms);
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"b"_s}));
    QVERIFY(bench.arrive(2));
    QCOMPARE(bench.completed, (QStringList{u"a:ok"_s, u"b:ok"_s}));
    QVERIFY(bench.queue.isIdle());
}

void TestTransactionQueue::keepsAPauseBetweenCommands()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.submit(request(u"b"_s, 2));
    bench.now += 1ms;
    bench.arrive(1);
    QCOMPARE(bench.written.size(), 1);
    bench.pass(8ms);
    QCOMPARE(bench.written.size(), 1);
    bench.pass(2ms);
    QCOMPARE(bench.written.size(), 2);
}

void TestTransactionQueue::retriesOnceThenReportsTimeout()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.pass(350ms);
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"a"_s}));
    QCOMPARE(bench.completed, QStringList{failed("a", ErrorCode::Timeout)});
    QCOMPARE(bench.queue.timeouts(), quint64(1));
}

void TestTransactionQueue::doesNotRetryWhatIsNotIdempotent()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, false, 5));
    bench.pass(500ms);
    QCOMPARE(bench.written, QStringList{u"a"_s});
    QCOMPARE(bench.completed.size(), 1);
}

void TestTransactionQueue::completesExactlyOnce()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.arrive(1);
    bench.arrive(1);
    bench.pass(1000ms);
    bench.queue.cancelAll({ErrorCode::LinkClosed, {}, 0});
    QCOMPARE(bench.completed, QStringList{u"a:ok"_s});
}

void TestTransactionQueue::boardRefusalIsAnError()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.arrive(255);
    QCOMPARE(bench.completed, QStringList{failed("a", ErrorCode::BoardError)});
}

void TestTransactionQueue::damagedCommandIsSentAgain()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, true, 2));
    QVERIFY(bench.arrive(254));
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"a"_s}));
    QVERIFY(bench.completed.isEmpty());
    QVERIFY(bench.arrive(1));
    QCOMPARE(bench.completed, QStringList{u"a:ok"_s});
    // Each sending was answered: nothing late is to be waited for.
    bench.submit(request(u"b"_s, 1, true, 1));
    bench.pass(11ms);
    QCOMPARE(bench.written.size(), 3);
    bench.arrive(254);
    bench.arrive(254);
    QCOMPARE(bench.completed, (QStringList{u"a:ok"_s, failed("b", ErrorCode::Damaged)}));
    // What must not be done twice is not repeated, even so.
    Bench once;
    once.submit(request(u"c"_s, 1, false, 2));
    once.arrive(254);
    QCOMPARE(once.completed, QStringList{failed("c", ErrorCode::Damaged)});
}

void TestTransactionQueue::lateAnswerIsNotTakenForTheNextRequest()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, false));
    bench.pass(110ms);
    bench.submit(request(u"b"_s, 1, false));
    bench.pass(20ms);
    QCOMPARE(bench.written, QStringList{u"a"_s});  // held back
    QVERIFY(bench.arrive(1));  // the late answer of a goes to nobody
    QCOMPARE(bench.completed, QStringList{failed("a", ErrorCode::Timeout)});
    bench.pass(10ms);
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"b"_s}));
    bench.arrive(1);
    QCOMPARE(bench.completed.last(), u"b:ok"_s);
}

void TestTransactionQueue::otherKindsAreNotHeldByALateAnswer()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, false));
    bench.pass(110ms);
    bench.submit(request(u"b"_s, 2, false));
    bench.pass(5ms);
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"b"_s}));
}

// A board that is polled is lost sight of for no longer than one answer takes.
void TestTransactionQueue::whatIsRepeatedWaitsForNoLateAnswer()
{
    Bench bench;
    Request poll = request(u"p"_s, 1, false);
    poll.repeated = true;
    bench.submit(poll);
    bench.pass(110ms);
    bench.submit(poll);
    bench.submit(request(u"b"_s, 1, false));  // something else is held back all the same
    bench.pass(5ms);
    QCOMPARE(bench.written, (QStringList{u"p"_s, u"p"_s}));
    bench.arrive(1);
    QCOMPARE(bench.completed, (QStringList{failed("p", ErrorCode::Timeout), u"p:ok"_s}));
    bench.pass(20ms);
    QCOMPARE(bench.written.size(), 2);
    bench.arrive(1);
    bench.pass(1ms);
    QCOMPARE(bench.written.last(), u"b"_s);
}

void TestTransactionQueue::answerToARetriedRequestLeavesOneToCome()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.pass(150ms);  // sent twice by now
    bench.arrive(1);
    QCOMPARE(bench.completed, QStringList{u"a:ok"_s});
    // It may be the answer to the first time.
    QVERIFY(bench.queue.roundTrip() >= 150ms);
    bench.submit(request(u"b"_s, 1));
    bench.pass(20ms);
    QCOMPARE(bench.written.size(), 2);  // the second answer of a may still come
    bench.arrive(1);
    bench.pass(20ms);
    QCOMPARE(bench.written.size(), 3);
    QCOMPARE(bench.completed.size(), 1);
}

void TestTransactionQueue::furtherAnswersComeAsLateAsTheFirst_data()
{
    QTest::addColumn<int>("late");
    for (const int late : {350, 700, 900, 1500, 2500, 3000})
        QTest::addRow("%d ms", late) << late;
}

// What proves something is no answer to what was asked before.
void TestTransactionQueue::furtherAnswersComeAsLateAsTheFirst()
{
    QFETCH(int, late);
    Bench bench;
    Request slow = request(u"g"_s, 1, true, 5);
    slow.timeout = 300ms;
    bench.submit(slow);
    bench.submit(request(u"proof"_s, 1, false));
    QList<TimePoint> due;
    for (int asked = 0; bench.written.count(u"proof"_s) == 0;) {
        for (; asked < bench.written.count(u"g"_s); ++asked)
            due.append(bench.now + milliseconds(late));
        bench.pass(1ms);
        QVERIFY(bench.now < TimePoint() + 1h + 20s);
        while (!due.isEmpty() && due.first() <= bench.now) {
            due.removeFirst();
            bench.arrive(1);
        }
    }
    QVERIFY(due.isEmpty());
    bench.arrive(1);
    QCOMPARE(bench.completed.last(), u"proof:ok"_s);
}

void TestTransactionQueue::urgentGoesOutAtOnce()
{
    Bench bench;
    for (int i = 0; i < 20; ++i)
        bench.submit(request(u"job%1"_s.arg(i), 1));
    bench.submit(request(u"off"_s, 9), TransactionQueue::Lane::Urgent);
    QCOMPARE(bench.written, (QStringList{u"job0"_s, u"off"_s}));
    bench.arrive(9);
    QCOMPARE(bench.completed, QStringList{u"off:ok"_s});
    bench.arrive(1);
    QCOMPARE(bench.completed.last(), u"job0:ok"_s);
}

void TestTransactionQueue::cancelInFlightAndWaiting()
{
    Bench bench;
    const auto a = bench.submit(request(u"a"_s, 1));
    const auto b = bench.submit(request(u"b"_s, 2));
    bench.submit(request(u"c"_s, 3));
    bench.queue.cancel(b);
    bench.queue.cancel(a);
    bench.pass(15ms);
    QCOMPARE(bench.completed,
             (QStringList{failed("b", ErrorCode::Cancelled), failed("a", ErrorCode::Cancelled)}));
    QCOMPARE(bench.written, (QStringList{u"a"_s, u"c"_s}));
    bench.queue.cancel(12345);
}

void TestTransactionQueue::closingTheLinkEndsEverything()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1));
    bench.submit(request(u"b"_s, 2));
    bench.queue.cancelAll({ErrorCode::LinkClosed, {}, 0});
    QCOMPARE(bench.completed,
             (QStringList{failed("a", ErrorCode::LinkClosed), failed("b", ErrorCode::LinkClosed)}));
    QVERIFY(bench.queue.isIdle());
}

void TestTransactionQueue::timerStartsWhenTheLastByteHasLeft()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, false));
    // The system does not take the bytes: the answer cannot be late yet.
    for (int i = 0; i < 400; ++i) {
        bench.now += 1ms;
        bench.queue.advance(bench.now);
    }
    QVERIFY(bench.completed.isEmpty());
    bench.queue.bytesTaken(1, bench.now);
    bench.pass(99ms);
    QVERIFY(bench.completed.isEmpty());
    bench.pass(3ms);
    QCOMPARE(bench.completed.size(), 1);
}

// What is sent meanwhile is not what is waited for.
void TestTransactionQueue::heartbeatsDoNotPutOffTheTimeout()
{
    Bench bench;
    bench.submit(request(u"a"_s, 1, false));
    for (int beat = 0; beat < 6; ++beat) {
        bench.pass(50ms);
        bench.queue.sendUnanswered(QByteArrayView("beat"), bench.now);
    }
    QCOMPARE(bench.completed, QStringList{failed("a", ErrorCode::Timeout)});
}

void TestTransactionQueue::timeoutGrowsWithASlowLine()
{
    Bench bench;
    bench.queue.setLine(LineSettings{9600, Parity::Even});
    Request slow = request(u"aaaaaaaaaa"_s, 1, false);
    slow.replyBytes = 139;
    bench.submit(slow);
    // 10 bytes out and twice 139 bytes back at 11 bits: 11 + 319 ms beside the board's own 100.
    bench.pass(420ms);
    QVERIFY(bench.completed.isEmpty());
    bench.pass(20ms);
    QCOMPARE(bench.completed.size(), 1);
}

void TestTransactionQueue::unansweredIsDoneWhenSent()
{
    Bench bench;
    Request silent;
    silent.name = u"beep"_s;
    silent.bytes = "beep";
    bench.submit(silent);
    QCOMPARE(bench.completed, QStringList{u"beep:ok"_s});
}

void TestTransactionQueue::deadlineIsReported()
{
    Bench bench;
    QVERIFY(!bench.queue.nextDeadline(bench.now));
    bench.submit(request(u"a"_s, 1));
    QCOMPARE(*bench.queue.nextDeadline(bench.now), bench.now + 100ms);
}

void TestTransactionQueue::controlStreamRepeatsAndStops()
{
    ControlStream stream;
    TimePoint now = TimePoint() + 1h;
    int setpoints = 0;
    QVERIFY(!stream.nextDeadline());
    for (int ms = 0; ms < 1000; ++ms, now += 1ms) {
        if (ms % 50 == 0)
            stream.refresh({"go", "stop", "free"}, now);
        while (const auto frame = stream.advance(now)) {
            QCOMPARE(*frame, QByteArray("go"));
            ++setpoints;
        }
    }
    // 50 per second, as the document allows.
    QVERIFY2(setpoints >= 48 && setpoints <= 51, qPrintable(QString::number(setpoints)));
    QCOMPARE(stream.failsafeCount(), 0);
}

void TestTransactionQueue::controlStreamDeadMan()
{
    ControlStream stream;
    TimePoint now = TimePoint() + 1h;
    stream.refresh({"go", "stop", "free"}, now);
    QList<QByteArray> sent;
    QList<qint64> at;
    for (int ms = 0; ms < 1000; ++ms, now += 1ms) {
        while (const auto frame = stream.advance(now)) {
            sent.append(*frame);
            at.append(ms);
        }
    }
    QCOMPARE(sent.count("stop"), 1);
    QCOMPARE(sent.count("free"), ControlStream::kReleases);
    QCOMPARE(sent.last(), QByteArray("free"));
    const qint64 stopAt = at[sent.indexOf("stop")];
    QVERIFY2(stopAt >= 250 && stopAt <= 252, qPrintable(QString::number(stopAt)));
    QCOMPARE(stream.failsafeCount(), 1);
    QVERIFY(!stream.isActive());
}

void TestTransactionQueue::controlStreamEndsOnPurpose()
{
    ControlStream stream;
    TimePoint now = TimePoint() + 1h;
    stream.refresh({"go", "stop", "free"}, now);
    QCOMPARE(*stream.advance(now), QByteArray("go"));
    stream.end(now);
    QCOMPARE(*stream.advance(now), QByteArray("stop"));
    QVERIFY(!stream.advance(now));
    QCOMPARE(*stream.advance(now + 101ms), QByteArray("free"));
    QCOMPARE(stream.failsafeCount(), 0);
    stream.refresh({"go", "stop", "free"}, now);
    stream.drop();
    QVERIFY(!stream.advance(now + 1s));
}

void TestTransactionQueue::setpointsLeaveRoom_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("fewest");  // set-points per second beside requests
    QTest::newRow("9600") << 9600 << 12;
    QTest::newRow("19200") << 19200 << 20;
    QTest::newRow("115200") << 115200 << 40;
    QTest::newRow("without a rate") << 0 << 40;
}

// Steering takes what is left of a slow line: requests go out, and nothing piles up before a stop.
void TestTransactionQueue::setpointsLeaveRoom()
{
    QFETCH(int, baud);
    QFETCH(int, fewest);
    Bench bench;
    bench.queue.setPause(10ms);
    if (baud > 0)
        bench.queue.setLine(LineSettings{baud, Parity::None});
    ControlStream stream;
    int setpoints = 0;
    int answered = 0;
    for (int ms = 0; ms < 4000; ++ms) {
        stream.refresh({QByteArray(20, 's'), "stop", "free"}, bench.now);
        while (const auto frame = stream.advance(bench.now)) {
            if (bench.queue.isCrowded(bench.now))
                continue;
            bench.queue.sendUnanswered(*frame, bench.now);
            ++setpoints;
        }
        if (bench.queue.isIdle())
            bench.submit(request(u"abcdefgh"_s, 1, false));
        bench.pass(1ms);
        if (ms % 40 == 39)
            answered += int(bench.arrive(1));
    }
    QVERIFY2(setpoints >= 4 * fewest, qPrintable(QString::number(setpoints)));
    QVERIFY2(answered > 40, qPrintable(QString::number(answered)));
    // The line is free as soon as the last frames have left.
    bench.arrive(1);
    bench.pass(50ms);
    QVERIFY(!bench.queue.isCrowded(bench.now));
}

QTEST_APPLESS_MAIN(TestTransactionQueue)
#include "tst_transactionqueue.moc"
