// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The channel of production and its stand-in of the tests keep the same promises.
#include "app/composition/composition.h"
#include "protocol/session/sessionchannel.h"
#include "protocol/simulator/link/simulatorsetup.h"
#include "protocol/simulator/link/virtualchannel.h"
#if GIMBAL_WITH_SIMPLEBGC
#include "protocol/simplebgc/commands.h"
#endif
#if GIMBAL_WITH_STORM32
#include "protocol/storm32/commands.h"
#endif

#include <QTest>
#include <QThread>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

Family familyNamed(const QString &key)
{
    const QList<Family> families = allFamilies();
    return *std::find_if(families.begin(), families.end(),
                         [&key](const Family &each) { return each.key == key; });
}

/// A channel to a simulated board whose cable can be pulled and whose job can be cancelled.
class Bench
{
public:
    virtual ~Bench() = default;
    virtual Channel &channel() = 0;
    virtual void pullCable() = 0;
    virtual void cancel() = 0;
};

class VirtualBench final : public Bench
{
public:
    explicit VirtualBench(const Family &family)
        : m_port(findSimulatedFamily(allSimulatedFamilies(), family.key)->makeBoard({}), {}, {})
        , m_channel(m_port, family.makeFramer(), family.timing)
    {
    }
    Channel &channel() override { return m_channel; }
    void pullCable() override { std::ignore = m_port.change(u"unplug=0"_s); }
    void cancel() override { m_channel.cancelAfter(0s); }

private:
    SimulatedPort m_port;
    VirtualChannel m_channel;
};

class SessionBench final : public Bench
{
public:
    explicit SessionBench(const Family &family)
        : m_address(LinkAddress::parse(u"sim:%1?seed=77"_s.arg(family.key)).value())
        , m_links(allLinks())
        , m_session(new Session(m_links.transports))
    {
        m_session->moveToThread(&m_thread);
        QObject::connect(&m_thread, &QThread::finished, m_session, &QObject::deleteLater);
        m_thread.start();
        m_channel = std::make_unique<SessionChannel>(*m_session, m_control,
                                                     SessionChannel::Hooks{[](const Progress &) {}, {}},
                                                     SessionChannel::Link::NotYet);
        if (!m_channel->open(m_address, family.makeFramer(), family.timing))
            qFatal("no link");
    }
    ~SessionBench() override
    {
        m_channel.reset();
        m_thread.quit();
        m_thread.wait();
    }
    Channel &channel() override { return *m_channel; }
    // For good: back after three seconds, a drone would not have been missed for long enough.
    void pullCable() override
    {
        std::ignore = m_links.changeWorld(m_address, u"replug=-1"_s);
        std::ignore = m_links.changeWorld(m_address, u"unplug=0"_s);
    }
    void cancel() override { m_control->cancel(); }

private:
    const LinkAddress m_address;
    Links m_links;
    QThread m_thread;
    Session *m_session;
    std::shared_ptr<JobControl> m_control = std::make_shared<JobControl>();
    std::unique_ptr<SessionChannel> m_channel;
};

/// A question that every board of this family answers.
Request question(const QString &family)
{
#if GIMBAL_WITH_SIMPLEBGC
    if (family == u"simplebgc"_s)
        return simplebgc::replyRequest(simplebgc::CommandId::BoardInfo, {}, simplebgc::CommandId::BoardInfo,
                                       18, 1);
#endif
#if GIMBAL_WITH_STORM32
    if (family == u"storm32"_s)
        return storm32::simpleRequest(storm32::Simple::Version);
#endif
#if GIMBAL_WITH_BCFLIGHT
    if (family == u"bcflight"_s) {
        Request request;
        request.name = u"PING"_s;
        request.bytes = QByteArray::fromHex("8100000000");
        request.answer = [](const FrameView &frame) -> std::optional<Result<Frame>> {
            return frame.id == 0x81 ? std::optional(Result<Frame>(Frame(frame))) : std::nullopt;
        };
        request.retries = 5;  // it throws the first packet away
        request.idempotent = true;
        return request;
    }
#endif
    qFatal("no question for %s", qPrintable(family));
}

}  // namespace

class TestChannels : public QObject
{
    Q_OBJECT
private slots:
    void transactsAndWaits_data() { kinds(); }
    void transactsAndWaits();
    void everyWaitEndsWithTheLink_data() { kinds(); }
    void everyWaitEndsWithTheLink();
    void everyWaitEndsWithTheJob_data() { kinds(); }
    void everyWaitEndsWithTheJob();

private:
    static void kinds()
    {
        QTest::addColumn<QString>("family");
        QTest::addColumn<bool>("production");
        for (const Family &family : allFamilies()) {
            QTest::addRow("session, %s", qPrintable(family.key)) << family.key << true;
            QTest::addRow("virtual, %s", qPrintable(family.key)) << family.key << false;
        }
    }
    static std::unique_ptr<Bench> make()
    {
        QFETCH(QString, family);
        QFETCH(bool, production);
        if (production)
            return std::make_unique<SessionBench>(familyNamed(family));
        return std::make_unique<VirtualBench>(familyNamed(family));
    }
    static Request askBoard()
    {
        QFETCH(QString, family);
        return question(family);
    }
};

void TestChannels::transactsAndWaits()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(askBoard()));
    const TimePoint before = bench->channel().now();
    QVERIFY(bench->channel().sleep(120ms));
    QVERIFY(bench->channel().now() - before >= 120ms);
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    QCOMPARE(mailbox->next(50ms).error().code, ErrorCode::Timeout);
}

void TestChannels::everyWaitEndsWithTheLink()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(askBoard()));
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    bench->pullCable();
    const TimePoint before = bench->channel().now();
    const auto slept = bench->channel().sleep(60s);
    QVERIFY(!slept);
    QCOMPARE(slept.error().code, ErrorCode::LinkClosed);
    QVERIFY(bench->channel().now() - before < 30s);
    QCOMPARE(bench->channel().sleep(10ms).error().code, ErrorCode::LinkClosed);  // and stays so
    QCOMPARE(bench->channel().transact(askBoard()).error().code, ErrorCode::LinkClosed);
    QCOMPARE(mailbox->next(60s).error().code, ErrorCode::LinkClosed);
}

void TestChannels::everyWaitEndsWithTheJob()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(askBoard()));
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    QVERIFY(!bench->channel().cancelled());
    bench->cancel();
    QVERIFY(bench->channel().cancelled());
    QCOMPARE(bench->channel().sleep(60s).error().code, ErrorCode::Cancelled);
    QCOMPARE(bench->channel().transact(askBoard()).error().code, ErrorCode::Cancelled);
    QCOMPARE(mailbox->next(60s).error().code, ErrorCode::Cancelled);
}

QTEST_GUILESS_MAIN(TestChannels)
#include "tst_channels.moc"
