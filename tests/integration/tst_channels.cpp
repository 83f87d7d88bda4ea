// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The channel of production and its stand-in of the tests keep the same promises.
#include "app/composition/composition.h"
#include "protocol/session/sessionchannel.h"
#include "protocol/simplebgc/commands.h"
#include "tests/support/virtualboard.h"

#include <QTest>
#include <QThread>

using namespace sbgc;
using namespace Qt::StringLiterals;

namespace {

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
    Channel &channel() override { return m_board.channel; }
    void pullCable() override { std::ignore = m_board.port.change(u"unplug=0"_s); }
    void cancel() override { m_board.channel.cancelAfter(0s); }

private:
    VirtualBoard m_board;
};

class SessionBench final : public Bench
{
public:
    SessionBench()
        : m_links(allLinks())
        , m_session(new Session(m_links.transports))
    {
        m_session->moveToThread(&m_thread);
        QObject::connect(&m_thread, &QThread::finished, m_session, &QObject::deleteLater);
        m_thread.start();
        m_channel = std::make_unique<SessionChannel>(*m_session, m_control,
                                                     SessionChannel::Hooks{[](const Progress &) {}, {}},
                                                     SessionChannel::Link::NotYet);
        const Family family = sbgcFamily();
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
    void pullCable() override { std::ignore = m_links.changeWorld(m_address, u"unplug=0"_s); }
    void cancel() override { m_control->cancel(); }

private:
    const LinkAddress m_address = LinkAddress::parse(u"sim:simplebgc?seed=77"_s).value();
    Links m_links;
    QThread m_thread;
    Session *m_session;
    std::shared_ptr<JobControl> m_control = std::make_shared<JobControl>();
    std::unique_ptr<SessionChannel> m_channel;
};

Request boardInfo()
{
    return replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, 1);
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
        QTest::addColumn<bool>("production");
        QTest::newRow("session") << true;
        QTest::newRow("virtual") << false;
    }
    static std::unique_ptr<Bench> make()
    {
        QFETCH(bool, production);
        if (production)
            return std::make_unique<SessionBench>();
        return std::make_unique<VirtualBench>();
    }
};

void TestChannels::transactsAndWaits()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(boardInfo()));
    const TimePoint before = bench->channel().now();
    QVERIFY(bench->channel().sleep(120ms));
    QVERIFY(bench->channel().now() - before >= 120ms);
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    QCOMPARE(mailbox->next(50ms).error().code, ErrorCode::Timeout);
}

void TestChannels::everyWaitEndsWithTheLink()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(boardInfo()));
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    bench->pullCable();
    const TimePoint before = bench->channel().now();
    const auto slept = bench->channel().sleep(60s);
    QVERIFY(!slept);
    QCOMPARE(slept.error().code, ErrorCode::LinkClosed);
    QVERIFY(bench->channel().now() - before < 30s);
    QCOMPARE(bench->channel().sleep(10ms).error().code, ErrorCode::LinkClosed);  // and stays so
    QCOMPARE(bench->channel().transact(boardInfo()).error().code, ErrorCode::LinkClosed);
    QCOMPARE(mailbox->next(60s).error().code, ErrorCode::LinkClosed);
}

void TestChannels::everyWaitEndsWithTheJob()
{
    const auto bench = make();
    QVERIFY(bench->channel().transact(boardInfo()));
    const auto mailbox = bench->channel().listen([](const FrameView &) { return false; });
    QVERIFY(!bench->channel().cancelled());
    bench->cancel();
    QVERIFY(bench->channel().cancelled());
    QCOMPARE(bench->channel().sleep(60s).error().code, ErrorCode::Cancelled);
    QCOMPARE(bench->channel().transact(boardInfo()).error().code, ErrorCode::Cancelled);
    QCOMPARE(mailbox->next(60s).error().code, ErrorCode::Cancelled);
}

QTEST_GUILESS_MAIN(TestChannels)
#include "tst_channels.moc"
