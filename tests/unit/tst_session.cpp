// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/session.h"
#include "tests/support/patience.h"

#include <QCoreApplication>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

/// Each byte is a frame.
class ByteFramer final : public Framer
{
public:
    void feed(Bytes bytes, const FrameSink &sink) override
    {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            ++m_statistics.frames;
            sink(FrameView{std::to_integer<int>(bytes[i]), {}, 1, bytes.subspan(i, 1)});
        }
    }
    void flush(const FrameSink &) override { }
    [[nodiscard]] bool isWaiting() const override { return false; }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    FramerStatistics m_statistics;
};

/// A board in a few lines: what was written to it is kept, what it answers is up to the test.
class ScriptedTransport final : public Transport
{
public:
    void open() override { emit opened(); }
    void close() override { }
    void write(QByteArrayView bytes) override
    {
        written.append(bytes);
        emit bytesWritten(bytes.size());
        for (const char byte : bytes) {
            if (answering)
                answering(byte);
        }
    }
    void answer(char byte, milliseconds after)
    {
        QTimer::singleShot(after, Qt::PreciseTimer, this,
                           [this, byte] { emit received(QByteArrayView(&byte, 1), Clock::now()); });
    }

    QByteArray written;
    std::function<void(char)> answering;
};

/// How often timers have fired in this thread.
class TimerCount final : public QObject
{
public:
    bool eventFilter(QObject *, QEvent *event) override
    {
        count += event->type() == QEvent::Timer ? 1 : 0;
        return false;
    }
    int count = 0;
};

AnswerMatcher answeredBy(char id)
{
    return [id](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id == id)
            return Frame(frame);
        return {};
    };
}

// As on a STorM32: one acknowledgement answers whatever was commanded.
constexpr int kAcknowledged = 1;

Request command(char letter, char answer)
{
    Request request;
    request.name = QString(QLatin1Char(letter));
    request.bytes = QByteArray(1, letter);
    request.answer = answeredBy(answer);
    request.kind = kAcknowledged;
    return request;
}

ControlFrames setpoints()
{
    ControlFrames frames;
    frames.setpoint = frames.stop = frames.release = "s";
    frames.answer = answeredBy('a');
    frames.kind = kAcknowledged;
    return frames;
}

// A board that goes on moving until it is told otherwise, and can be asked.
ControlFrames movement()
{
    ControlFrames frames;
    frames.setpoint = "m";
    frames.stop = "h";
    frames.release = "r";
    frames.question = command('q', 'd');
    frames.fromAnswer = [](const Frame &) { return Proof::Proven; };
    return frames;
}

StopPlan stopPlan()
{
    StopPlan plan;
    plan.means.push_back({{command('o', 'd')}, 10ms, 2});
    plan.fromAnswer = [](const Frame &) { return Proof::Proven; };
    return plan;
}

}  // namespace

class TestSession : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void pollingTakesTurnsWithSetpoints();
    void pollingGivesWayToRequests();
    void pollingTakesItsTurnAmongRequests();
    void lateAcknowledgementIsNobodyElses();
    void lostAcknowledgementDoesNotBlockTheQueue();
    void waitingSleeps();
    void closingOnPurposeEndsSteering();
    void steeringThatALinkCutOffIsEndedOnTheNext();
    void endThatWasNotProvenIsToldAgainOnTheNext();
    void stopEndsWhatIsSteered();
    void setpointsDoNotWaitForAnswers();
    void restartedBoardIsStoppedBeforeItIsLeft();
    void brokenLinkTellsThatItWasSteered();
    void withoutASetpointNothingIsSteered();
    void unprovenStopIsRepeated();
    void startingMotorsEndsARepeatedStop();
    void quietIsKept();
    void silenceIsMeasured();

private:
    std::unique_ptr<Session> m_session;
    QPointer<ScriptedTransport> m_transport;
};

void TestSession::init()
{
    m_session = std::make_unique<Session>([this](const LinkAddress &) -> Result<std::unique_ptr<Transport>> {
        auto transport = std::make_unique<ScriptedTransport>();
        m_transport = transport.get();
        return transport;
    });
    LinkTiming timing;
    timing.controlPeriod = 20ms;
    m_session->open(*LinkAddress::parse(u"tcp://127.0.0.1:1"_s), std::make_unique<ByteFramer>(), timing);
    QVERIFY(m_transport);
}

void TestSession::cleanup()
{
    m_session.reset();
}

// A board that needs longer for each set-point than the time to the next one is watched all the same.
void TestSession::pollingTakesTurnsWithSetpoints()
{
    m_transport->answering = [this](char byte) {
        if (byte == 's')
            m_transport->answer('a', 30ms);
        if (byte == 'p')
            m_transport->answer('d', 1ms);
    };
    m_session->setPoll(command('p', 'd'), 50ms);
    QTimer refresh;
    connect(&refresh, &QTimer::timeout, m_session.get(), [this] { m_session->refreshControl(setpoints()); });
    refresh.start(20);
    QTRY_VERIFY(m_transport->written.count('s') >= 20);
    QVERIFY2(m_transport->written.count('p') >= 10, m_transport->written.constData());
}

void TestSession::pollingGivesWayToRequests()
{
    m_transport->answering = [this](char byte) {
        if (byte == 'r')
            m_transport->answer('d', 5ms);
    };
    int done = 0;
    for (int i = 0; i < 10; ++i)
        m_session->submit(command('r', 'd'),
                          [&done](const Result<Frame> &result) { done += result ? 1 : 0; });
    m_session->setPoll(command('p', 'd'), 1ms);
    QTRY_COMPARE(done, 10);
    QTRY_VERIFY(m_transport->written.contains('p'));
    QVERIFY2(m_transport->written.startsWith("rrrrrrrrrr"), m_transport->written.constData());
}

// A job that asks back to back leaves the queue at no time empty: the board is watched all the same.
void TestSession::pollingTakesItsTurnAmongRequests()
{
    m_transport->answering = [this](char byte) { m_transport->answer(byte == 'r' ? 'd' : 'e', 1ms); };
    int done = 0;
    int open = 0;
    std::function<void()> ask = [&] {
        ++open;
        m_session->submit(command('r', 'd'), [&](const Result<Frame> &result) {
            --open;
            done += result ? 1 : 0;
            if (done < 3000 && m_transport->written.count('p') < 4)
                ask();
        });
    };
    m_session->setPoll(command('p', 'e'), 5ms);
    // Two at a time, so that one is always waiting.
    ask();
    ask();
    QTRY_VERIFY(m_transport->written.count('p') >= 4);
    // Most of the time belongs to the requests.
    const bool mostIsRequests = done > 3 * m_transport->written.count('p');
    // Those that still wait have not been written, and would answer to a test that is over.
    QTRY_COMPARE(open, 0);
    QVERIFY2(mostIsRequests, m_transport->written.constData());
}

// It would prove a stop that nobody has carried out.
void TestSession::lateAcknowledgementIsNobodyElses()
{
    QTimer refresh;
    connect(&refresh, &QTimer::timeout, m_session.get(), [this] { m_session->refreshControl(setpoints()); });
    refresh.start(20);
    QTRY_COMPARE(m_session->statistics().timeouts, 1U);
    m_transport->written.clear();
    bool answered = false;
    m_session->submit(command('x', 'a'),
                      [&answered](const Result<Frame> &result) { answered = result.has_value(); });
    QVERIFY(!m_transport->written.contains('x'));
    m_transport->answer('a', 0ms);
    QTRY_VERIFY(m_transport->written.contains('x'));
    QVERIFY(!answered);
    m_transport->answer('a', 0ms);
    QTRY_VERIFY(answered);
}

// Other kinds of requests need not wait until the answer can no longer come.
void TestSession::lostAcknowledgementDoesNotBlockTheQueue()
{
    m_transport->answering = [this](char byte) {
        if (byte == 'q')
            m_transport->answer('d', 0ms);
    };
    int refreshes = 0;
    QTimer refresh;
    connect(&refresh, &QTimer::timeout, m_session.get(), [&] {
        m_session->refreshControl(setpoints());
        ++refreshes;
    });
    refresh.start(20);
    QTRY_COMPARE(m_session->statistics().timeouts, 1U);
    const int before = refreshes;
    QTRY_VERIFY(refreshes > before + 2);  // set-points are due, and held
    Request other = command('q', 'd');
    other.kind = kAcknowledged + 1;
    bool answered = false;
    m_session->submit(other, [&answered](const Result<Frame> &result) { answered = result.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(answered, 250);  // less than what a late answer is waited for
    QCOMPARE(m_transport->written, "sq");
}

// Waiting for an answer, for the end of its late window and for a poll's turn wakes the thread no more often
// than something is due.
void TestSession::waitingSleeps()
{
    TimerCount timers;
    qApp->installEventFilter(&timers);
    m_session->setPoll(command('p', 'd'), 1ms);
    const auto isQuiet = [&](auto isOver) {
        const int before = timers.count;
        return QTest::qWaitFor(isOver, kPatience) && timers.count - before < 30;
    };
    const auto done = std::make_shared<int>(0);  // the session ends later
    const auto count = [done](const Result<Frame> &) { ++*done; };
    Request slow = command('x', 'a');
    slow.timeout = 400ms;
    m_session->submit(slow, count);
    QVERIFY2(isQuiet([&] { return *done == 1; }), qPrintable(QString::number(timers.count)));
    m_session->submit(command('y', 'a'), count);  // held: the answer to the first may still come
    QVERIFY2(isQuiet([&] { return m_transport->written.contains('y'); }),
             qPrintable(QString::number(timers.count)));
}

// The link stays open until the board was seen to stand still; one that says nothing is not waited for for
// ever, and that is told.
void TestSession::closingOnPurposeEndsSteering()
{
    for (const bool answers : {true, false}) {
        init();
        QSignalSpy ended(m_session.get(), &Session::steeringEnded);
        QByteArray written;
        m_transport->answering = [&](char byte) {
            written.append(byte);
            if (byte == 'q' && answers)
                m_transport->answer('d', 20ms);
        };
        m_session->refreshControl(movement());
        QTRY_VERIFY(written.contains('m'));
        bool isClosed = false;
        m_session->finish([&isClosed] { isClosed = true; });
        QVERIFY(!isClosed);
        m_session->refreshControl(movement());  // too late
        QTRY_VERIFY(isClosed);
        QCOMPARE(ended.count(), 1);
        QCOMPARE(ended.first().first().toBool(), answers);
        QVERIFY2(written.contains('h') && written.endsWith('r'), written.constData());
        QVERIFY2(written.count('r') == ControlStream::kReleases, written.constData());  // one may get lost
        QVERIFY(!written.mid(written.indexOf('h')).contains('m'));
    }
}

// A board that moves until it is told otherwise still does when it answers again.
void TestSession::steeringThatALinkCutOffIsEndedOnTheNext()
{
    QSignalSpy ended(m_session.get(), &Session::steeringEnded);
    QByteArray written;
    const auto listen = [&] {
        m_transport->answering = [&](char byte) {
            written.append(byte);
            if (byte == 'q')
                m_transport->answer('d', 5ms);
        };
    };
    const auto reopen = [&] {
        m_session->close({ErrorCode::LinkClosed, {}});
        QVERIFY(ended.count() == 1 && !ended.takeFirst().first().toBool());
        m_session->open(*LinkAddress::parse(u"tcp://127.0.0.1:1"_s), std::make_unique<ByteFramer>());
        QVERIFY(m_transport);
        listen();
        written.clear();
    };
    listen();
    m_session->refreshControl(movement());
    QTRY_VERIFY(written.contains('m'));
    reopen();
    m_session->endLeftSteering();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(ended.takeFirst().first().toBool());
    QVERIFY(!m_session->isSteering());  // nobody waits for control to be given back
    QTRY_VERIFY(written.endsWith('r'));
    QVERIFY2(written.contains('h') && !written.contains('m'), written.constData());
    m_session->refreshControl(movement());
    QTRY_VERIFY(written.contains('m'));
    reopen();
    m_session->forgetLeftSteering();
    m_session->endLeftSteering();
    QVERIFY(!m_session->isSteering());
}

// As long as nobody has seen it stand.
void TestSession::endThatWasNotProvenIsToldAgainOnTheNext()
{
    QSignalSpy ended(m_session.get(), &Session::steeringEnded);
    m_session->refreshControl(movement());
    QTRY_VERIFY(m_transport->written.contains('m'));
    m_session->endControl();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!ended.takeFirst().first().toBool());
    QTRY_VERIFY(m_transport->written.endsWith("rr"));
    m_session->close({ErrorCode::LinkClosed, {}});
    m_session->open(*LinkAddress::parse(u"tcp://127.0.0.1:1"_s), std::make_unique<ByteFramer>());
    QVERIFY(m_transport);
    m_session->endLeftSteering();
    QTRY_VERIFY(m_transport->written.contains('h'));
    QVERIFY(!m_transport->written.contains('m'));
}

void TestSession::stopEndsWhatIsSteered()
{
    m_session->refreshControl(movement());
    QTRY_VERIFY(m_transport->written.contains('m'));
    m_session->stopMotors(stopPlan(), [](const Result<void> &) {});
    // What comes from a page that has not noticed yet is not taken.
    m_session->refreshControl(movement());
    QTRY_VERIFY(m_transport->written.contains('h'));
    m_session->refreshControl(movement());
    QTRY_VERIFY(m_transport->written.count('o') > 1);
    const QByteArray after = m_transport->written.mid(m_transport->written.indexOf('o'));
    QVERIFY2(!after.contains('m'), after.constData());
}

// BCFlight errata 9.2, 10: while a question waits for its answer, steering and its end go out as ever.
void TestSession::setpointsDoNotWaitForAnswers()
{
    Request question = command('x', 'y');
    question.timeout = 10s;
    const auto isAnswered = std::make_shared<bool>(false);
    m_session->submit(question, [isAnswered](const Result<Frame> &) { *isAnswered = true; });
    QTRY_VERIFY(m_transport->written.contains('x'));
    QTimer refresh;
    connect(&refresh, &QTimer::timeout, m_session.get(), [this] { m_session->refreshControl(movement()); });
    refresh.start(10ms);
    QTRY_VERIFY(m_transport->written.count('m') >= 10);
    refresh.stop();
    m_session->endControl();
    QTRY_VERIFY(m_transport->written.contains('h'));
    QVERIFY(!*isAnswered);
}

// It has taken set-points since, as long as nobody knew.
void TestSession::restartedBoardIsStoppedBeforeItIsLeft()
{
    QSignalSpy ended(m_session.get(), &Session::steeringEnded);
    QSignalSpy closed(m_session.get(), &Session::closed);
    QByteArray written;
    m_transport->answering = [&](char byte) {
        written.append(byte);
        if (byte == 'q')
            m_transport->answer('d', 20ms);
    };
    m_session->refreshControl(movement());
    QTRY_VERIFY(written.contains('m'));
    m_session->leaveRestarted({ErrorCode::Restarted, {}});
    QTRY_COMPARE(closed.count(), 1);
    QVERIFY(ended.count() == 1 && ended.first().first().toBool());
    QVERIFY2(written.contains('h') && written.endsWith('r'), written.constData());
    init();
    QSignalSpy left(m_session.get(), &Session::closed);
    m_session->leaveRestarted({ErrorCode::Restarted, {}});
    QCOMPARE(left.count(), 1);  // at once: nothing was steered
}

void TestSession::brokenLinkTellsThatItWasSteered()
{
    QSignalSpy ended(m_session.get(), &Session::steeringEnded);
    m_session->refreshControl(movement());
    emit m_transport->closed({ErrorCode::LinkClosed, {}});
    QCOMPARE(ended.count(), 1);
    QVERIFY(!ended.first().first().toBool());
}

void TestSession::withoutASetpointNothingIsSteered()
{
    QSignalSpy ended(m_session.get(), &Session::steeringEnded);
    m_session->refreshControl({});
    m_session->endControl();
    m_session->refreshControl({});
    emit m_transport->closed({ErrorCode::LinkClosed, {}});
    QCOMPARE(ended.count(), 0);
    QVERIFY(m_transport.isNull() || m_transport->written.isEmpty());
    // What was steered before ends with it.
    init();
    QSignalSpy later(m_session.get(), &Session::steeringEnded);
    m_session->refreshControl(setpoints());
    QTRY_VERIFY(m_transport->written.contains('s'));
    m_session->refreshControl({});
    QTRY_COMPARE(later.count(), 1);
    QVERIFY(later.first().first().toBool());
}

void TestSession::unprovenStopIsRepeated()
{
    QSignalSpy late(m_session.get(), &Session::motorsStoppedLate);
    int outcomes = 0;
    m_session->stopMotors(stopPlan(), [&outcomes](const Result<void> &stopped) {
        QVERIFY(!stopped);
        ++outcomes;
    });
    QTRY_COMPARE(outcomes, 1);
    const auto sent = m_transport->written.count('o');
    QTRY_VERIFY(m_transport->written.count('o') >= sent + 3);
    // An answer that takes nearly a second is a proof all the same.
    m_transport->answering = [this](char byte) {
        if (byte == 'o')
            m_transport->answer('d', 900ms);
    };
    QTRY_COMPARE(late.count(), 1);
    QCOMPARE(outcomes, 1);
}

void TestSession::startingMotorsEndsARepeatedStop()
{
    QSignalSpy forgone(m_session.get(), &Session::stopForgone);
    bool isOver = false;
    m_session->stopMotors(stopPlan(), [&isOver](const Result<void> &) { isOver = true; });
    m_session->allowMotors();  // still being stopped: nothing is given up
    QCOMPARE(forgone.count(), 0);
    QTRY_VERIFY(isOver);
    m_session->allowMotors();
    QCOMPARE(forgone.count(), 1);
    bool isProven = false;
    m_transport->answering = [this](char byte) {
        if (byte == 'o')
            m_transport->answer('d', 0ms);
    };
    m_session->stopMotors(stopPlan(), [&isProven](const Result<void> &stopped) { isProven = bool(stopped); });
    QTRY_VERIFY(isProven);
}

// A board that is deaf for a while would carry everything out in a burst afterwards: neither heartbeat nor
// poll is sent, what the job itself sends is.
void TestSession::quietIsKept()
{
    constexpr auto kQuiet = 300ms;
    m_session->setPoll({});
    LinkTiming timing;
    timing.heartbeatPeriod = 20ms;
    timing.heartbeat = [] { return QByteArray("h"); };
    m_session->open({}, std::make_unique<ByteFramer>(), timing);
    m_transport->answering = [this](char byte) {
        if (byte == 'p')
            m_transport->answer('p', 0ms);
    };
    Request poll;
    poll.bytes = "p";
    poll.answer = answeredBy('p');
    poll.timeout = 10ms;
    m_session->setPoll(poll, 20ms);
    QTRY_VERIFY(m_transport->written.count('h') > 2 && m_transport->written.count('p') > 1);
    const TimePoint since = Clock::now();
    m_session->keepQuiet(kQuiet);
    m_transport->written.clear();
    Request own;
    own.bytes = "o";
    m_session->submit(own, {});
    bool wasEarly = false;
    QTRY_VERIFY([&] {
        const bool isLoud = m_transport->written.contains('h') || m_transport->written.contains('p');
        wasEarly |= isLoud && Clock::now() - since < kQuiet;
        return isLoud;
    }());
    QVERIFY(!wasEarly);
    QVERIFY(Clock::now() - since >= kQuiet);
    QVERIFY(m_transport->written.startsWith('o'));
    QTRY_VERIFY(m_transport->written.contains('h') && m_transport->written.contains('p'));
}

// Where a link ends by silence it is degraded before, and what was announced does not count.
void TestSession::silenceIsMeasured()
{
    LinkTiming timing;
    timing.silenceLimit = 60s;
    m_session->open({}, std::make_unique<ByteFramer>(), timing);
    QVERIFY(!m_session->statistics().isDegraded());
    QTRY_VERIFY(m_session->statistics().isDegraded());
    QVERIFY(!m_session->statistics().backAt);
    const TimePoint silent = Clock::now();
    m_transport->answer('x', 0ms);
    QTRY_VERIFY(!m_session->statistics().isDegraded());
    QVERIFY(m_session->statistics().backAt >= silent);
    m_session->expectSilence(10s);
    QTRY_VERIFY(m_session->statistics().silence == Duration{});
}

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
