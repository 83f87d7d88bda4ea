// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/session.h"

#include <QPointer>
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

}  // namespace

class TestSession : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void pollingTakesTurnsWithSetpoints();
    void pollingGivesWayToRequests();
    void lateAcknowledgementIsNobodyElses();
    void lostAcknowledgementDoesNotBlockTheQueue();

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

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
