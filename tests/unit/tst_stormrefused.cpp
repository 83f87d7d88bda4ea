// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/aftermath.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"

#include <QTemporaryDir>
#include <QTest>

namespace {

/// From one writing of all values in use on, each is refused.
class Refusing final : public ChannelProxy
{
public:
    Refusing(Channel &channel, int from)
        : ChannelProxy(channel)
        , m_left(from)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        if (request.name == u"p"_s && --m_left <= 0)
            return failure(ErrorCode::BoardError, request.name);
        return ChannelProxy::transact(request);
    }

private:
    int m_left;
};

/// The board answers that it has done it, and has not.
class Pretending final : public ChannelProxy
{
public:
    Pretending(Channel &channel, QString name)
        : ChannelProxy(channel)
        , m_name(std::move(name))
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        return request.name == m_name ? Result<Frame>(Frame{}) : ChannelProxy::transact(request);
    }

private:
    QString m_name;
};

}  // namespace

/// A STorM32 board that is not ready, or refuses to have values back in use: nothing is half done, and each
/// value is told as the board has it.
class TestStormRefused : public QObject
{
    Q_OBJECT
private slots:
    void confirmedIsNotDone_data();
    void confirmedIsNotDone();
    void nameWithoutAnAnswerIsLookedAt();
    void startingBoardIsNotHalfWritten_data();
    void startingBoardIsNotHalfWritten();
    void refusedKeepIsToldByValue();
    void storingIsProven();
    void motorThatIsNotStoredIsTold();
    void comparingProvesWhatIsInUse();
    void storingAllIsProven_data();
    void storingAllIsProven();

private:
    Result<WriteReport> write(Channel &channel, Device &device, const QString &key, double raw,
                              OtherValues others = OtherValues::Keep)
    {
        const BoardHistory history(m_dir.path());
        const auto base = device.readConfiguration(channel);
        Configuration edited = *base;
        [&] { QVERIFY(edited.setRaw(*edited.parameters().find(key), 0, raw)); }();
        WriteOptions options;
        options.history = &history;
        options.named = {key};
        options.others = others;
        return writeConfiguration(channel, device, *base, edited, options);
    }

    QTemporaryDir m_dir;
};

void TestStormRefused::confirmedIsNotDone_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("command");
    QTest::newRow("restart") << u"restart"_s << u"xx"_s;
    QTest::newRow("hardware reset") << u"reset"_s << u"xX"_s;
    QTest::newRow("all motors, restart") << u"motors.normal"_s << u"xW"_s;
    QTest::newRow("defaults") << u"defaults"_s << u"xd"_s;
    QTest::newRow("directions") << u"directions.take"_s << u"xm"_s;
    QTest::newRow("directions of the setup") << u"setup.take_motors"_s << u"xm"_s;
}

// What the board says of itself afterwards counts.
void TestStormRefused::confirmedIsNotDone()
{
    QFETCH(QString, key);
    QFETCH(QString, command);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(6, 555);
    rig.board().set(21, 2);  // on auto
    Pretending pretending(rig.channel, command);
    const QVariantMap arguments = key == u"setup.take_motors"_s
        ? QVariantMap{{u"directions"_s, true}, {u"positions"_s, true}}
        : QVariantMap();
    const auto done = rig.device.perform(pretending, key, arguments);
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NoEffect);
    QVERIFY2(!done.error().detail.isEmpty(), qPrintable(key));
    QVERIFY2(rig.device.perform(rig.channel, key, arguments), qPrintable(key));
}

// Only its answer was lost: the board has the new name, and that is what counts.
void TestStormRefused::nameWithoutAnAnswerIsLookedAt()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const QVariantMap arguments{{u"name"_s, u"Foo"_s}};
    Altering losing(rig.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"xn"_s ? failure(ErrorCode::Timeout, request.name) : answer;
    });
    QVERIFY(rig.device.perform(losing, u"name"_s, arguments));
    Altering deaf(rig.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"xn"_s ? failure(ErrorCode::Timeout, request.name) : pass(request);
    });
    const auto done = rig.device.perform(deaf, u"name"_s, {{u"name"_s, u"Bar"_s}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Timeout);
    QVERIFY2(done.error().detail.contains(u"calls itself Foo"_s), qPrintable(done.error().detail));
}

void TestStormRefused::startingBoardIsNotHalfWritten_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("seconds");
    for (const int firmware : {79, 90, 96}) {
        for (const int seconds : {1, 5, 7})
            QTest::addRow("0.%d after %d s", firmware, seconds) << firmware << seconds;
    }
}

void TestStormRefused::startingBoardIsNotHalfWritten()
{
    QFETCH(int, firmware);
    QFETCH(int, seconds);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    for (const int motor : {79, 80})
        rig.board().set(motor, 3);
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    QVERIFY(rig.channel.sleep(std::chrono::seconds(seconds)));
    QVERIFY(rig.board().state() < 5);
    // Motors that are all disabled cannot be told from stopped ones meanwhile; some of them can.
    const auto last = write(rig.channel, rig.device, u"motor.pitch.usage"_s, 3);
    QVERIFY(!last);
    QCOMPARE(last.error().code, ErrorCode::Unready);
    QCOMPARE(rig.board().stored(78), 0);
    QCOMPARE(rig.board().inUse(78), 0);
    const auto usage = write(rig.channel, rig.device, u"motor.roll.usage"_s, 0);
    QVERIFY(usage && usage->isComplete());
    QCOMPARE(rig.board().stored(79), 0);
    // Everything else is written whole.
    const auto gain = write(rig.channel, rig.device, u"pid.pitch.p"_s, 444);
    QVERIFY(gain && gain->isComplete());
    QCOMPARE(rig.board().stored(0), 444);
    QCOMPARE(rig.board().inUse(0), 444);
    const BoardHistory history(m_dir.path());
    rig.board().set(0, 500);
    QVERIFY(performSafely(rig.channel, rig.device, u"retrieve"_s, {}, history));
    QCOMPARE(rig.board().inUse(0), 444);
    rig.board().set(0, 500);
    QVERIFY(performSafely(rig.channel, rig.device, u"store"_s, {}, history));
    QCOMPARE(rig.board().stored(0), 500);
    QVERIFY(rig.channel.sleep(30s));
    const auto later = write(rig.channel, rig.device, u"motor.yaw.usage"_s, 3);
    QVERIFY(later && later->isComplete());
}

void TestStormRefused::refusedKeepIsToldByValue()
{
    int told = 0;
    for (int from = 2; from < 8; ++from) {
        StormRig rig;
        QVERIFY(rig.device.identify(rig.channel));
        rig.board().set(6, 450);
        Refusing channel(rig.channel, from);
        const auto report = write(channel, rig.device, u"pid.pitch.p"_s, 444);
        QVERIFY(report);
        for (const WriteLine &line : report->lines) {
            QVERIFY(line.state != WriteState::Unknown);
            QCOMPARE(int(line.found), rig.board().stored(0));
        }
        if (report->isComplete()) {
            QCOMPARE(rig.board().inUse(6), 450);
            continue;
        }
        if (rig.board().inUse(6) == 450)
            continue;
        ++told;
        QCOMPARE(report->others.size(), std::size_t(1));
        QVERIFY(report->others.front().now.has_value());
        QCOMPARE(int(*report->others.front().now), rig.board().inUse(6));
        QVERIFY2(report->error->detail.contains(u"pid.roll.p=4.50"_s), qPrintable(report->error->detail));
    }
    QVERIFY2(told > 0, qPrintable(QString::number(told)));
}

void TestStormRefused::storingIsProven()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const BoardHistory history(m_dir.path());
    rig.board().set(0, 1120);
    Pretending channel(rig.channel, u"xs"_s);
    const auto refused = performSafely(channel, rig.device, u"store"_s, {}, history);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NotStored);
    QCOMPARE(refused.error().detail, u"pid.pitch.p is 11.20 in use and 4.00 where it is stored"_s);
    QVERIFY(refused.error().after && refused.error().after->now);
    QVERIFY(refused.error().after->changes().empty());
    QCOMPARE(rig.board().inUse(0), 1120);
    QCOMPARE(rig.board().stored(0), 400);
    const auto stored = performSafely(rig.channel, rig.device, u"store"_s, {}, history);
    QVERIFY(stored && stored->answered);
    QCOMPARE(rig.board().inUse(0), 1120);
    QCOMPARE(rig.board().stored(0), 1120);
}

// It must not fall while what is stored is looked at, so it is asked alone.
void TestStormRefused::motorThatIsNotStoredIsTold()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.channel.sleep(30s));
    const BoardHistory history(m_dir.path());
    rig.board().set(80, 1);
    Pretending channel(rig.channel, u"xs"_s);
    const auto refused = performSafely(channel, rig.device, u"store"_s, {}, history);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NotStored);
    QVERIFY(refused.error().detail.contains(u"motor.yaw.usage"_s));
    QCOMPARE(rig.board().inUse(80), 1);
    QVERIFY(performSafely(rig.channel, rig.device, u"store"_s, {}, history));
    QCOMPARE(rig.board().stored(80), 1);
}

void TestStormRefused::comparingProvesWhatIsInUse()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const BoardHistory history(m_dir.path());
    rig.board().set(0, 1120);
    Pretending channel(rig.channel, u"p"_s);
    const auto compared = performSafely(channel, rig.device, u"stored.compare"_s, {}, history);
    QVERIFY(!compared);
    QCOMPARE(compared.error().code, ErrorCode::NotRestored);
    QCOMPARE(compared.error().detail, u"pid.pitch.p=11.20 (4.00 is in use now)"_s);
    QCOMPARE(rig.board().inUse(0), 400);
}

void TestStormRefused::storingAllIsProven_data()
{
    QTest::addColumn<int>("yawUsage");
    QTest::newRow("what is stored can be told") << 0;
    QTest::newRow("it cannot") << 3;
}

// "Store everything in use" is proven by what is stored, not by what is in use.
void TestStormRefused::storingAllIsProven()
{
    QFETCH(int, yawUsage);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.channel.sleep(30s));
    rig.board().set(80, yawUsage);
    Pretending channel(rig.channel, u"xs"_s);
    const auto refused = write(channel, rig.device, u"pid.pitch.p"_s, 444, OtherValues::Store);
    QVERIFY(refused && !refused->isComplete());
    QCOMPARE(refused->count(WriteState::Verified), 0);
    QCOMPARE(rig.board().stored(0), 400);
    QCOMPARE(rig.board().inUse(0), 400);
    const auto stored = write(rig.channel, rig.device, u"pid.pitch.p"_s, 444, OtherValues::Store);
    QVERIFY(stored && stored->isComplete());
    QCOMPARE(stored->othersUnknown.has_value(), yawUsage == 3);
    QCOMPARE(stored->count(WriteState::Verified), 1);
    QCOMPARE(rig.board().stored(0), 444);
    QCOMPARE(rig.board().stored(80), yawUsage);
}

QTEST_GUILESS_MAIN(TestStormRefused)
#include "tst_stormrefused.moc"
