// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/trialnote.h"
#include "tests/support/setupbench.h"

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using State = SetupResult::State;

namespace {

constexpr int kNow = 2704;

/// A board in use, at whose pins there is a receiver.
Faults connected(int receiver = 1)
{
    Faults faults;
    faults.receiver = receiver;
    return faults;
}

}  // namespace

/// The step that finds which input a stick moves.
class TestSetupRemote final : public QObject
{
    Q_OBJECT
private slots:
    void sticksAreFound_data();
    void sticksAreFound();
    void channelsOfASerialReceiverAreFound();
    void whatFitsIsNotWritten();
    void aStickThatIsLeftOutStaysAsItIs();
    void aSharedInputIsTold();
    void aSwitchForCommandsIsFound();
    void twoAtOnceAreAskedAgain();
    void theSameStickTwiceIsAskedAgain();
    void withoutASignalItSaysSo_data();
    void withoutASignalItSaysSo();
    void aSignalThatIsLostEndsIt();
    void noiseAndLossAreBorne();
    void aStickThatIsNotFollowedIsTakenBack();
    void whatSwitchesTheMotorsOnEndsIt();
    void theLiveValuesAreTold();
    void nothingToAskIsAnError();
};

void TestSetupRemote::sticksAreFound_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<bool>("isYawUnmapped");
    QTest::newRow("asked") << kNow << false;
    QTest::newRow("asked, one was mapped to nothing") << kNow << true;
    QTest::newRow("by telemetry") << 2590 << false;
}

// Two are swapped, one is the wrong way round.
void TestSetupRemote::sticksAreFound()
{
    QFETCH(int, firmware);
    QFETCH(bool, isYawUnmapped);
    SetupBench bench(false, connected(), firmware);
    auto &board = bench.board.board();
    board.store(u"rc.map.roll"_s, 0, 2);
    board.store(u"rc.map.pitch"_s, 0, 1);
    board.store(u"rc.yaw.inverted"_s, 0, 1);
    if (isYawUnmapped)
        board.store(u"rc.map.yaw"_s, 0, 0);
    const auto result = bench.run("remote");
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QVERIFY2(result->remarks.contains(u"remote.set"_s), qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.roll"_s), 1);
    QCOMPARE(bench.stored(u"rc.map.pitch"_s), 2);
    QCOMPARE(bench.stored(u"rc.map.yaw"_s), 5);
    QCOMPARE(bench.stored(u"rc.map.cmd"_s), 0);
    for (const QString &axis : {u"roll"_s, u"pitch"_s, u"yaw"_s})
        QCOMPARE(bench.stored(u"rc.%1.inverted"_s.arg(axis)), 0);
    QVERIFY(std::abs(*result->figure(u"stick.high.roll"_s) - 96) < 2);
    QVERIFY(std::abs(*result->figure(u"stick.low.yaw"_s) + 96) < 2);
    QVERIFY(std::abs(*result->figure(u"stick.rest.pitch"_s)) < 2);
    QVERIFY(!result->snapshot.isEmpty() && result->hasChanged());
    QVERIFY(!board.stabilizer().motorsOn());
    QVERIFY(!keptTrial(bench.history, bench.board.device.identity()));
    // Done again, it knows what was before.
    const auto again = bench.run("remote");
    QVERIFY2(again && again->remarks.contains(u"remote.fits"_s) && !again->hasChanged(),
             qPrintable(why(again)));
    QVERIFY(bench.record.result(SetupStep::Remote).hasChanged());
}

void TestSetupRemote::channelsOfASerialReceiverAreFound()
{
    SetupBench bench(false, connected(3), kNow);
    bench.board.board().store(u"rc.input_mode"_s, 0, 2);
    bench.board.board().store(u"rc.map.roll"_s, 0, 68);
    bench.board.board().store(u"rc.map.yaw"_s, 0, 65);
    const auto result = bench.run("remote");
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.roll"_s), 65);
    QCOMPARE(bench.stored(u"rc.map.pitch"_s), 66);
    QCOMPARE(bench.stored(u"rc.map.yaw"_s), 68);
}

void TestSetupRemote::whatFitsIsNotWritten()
{
    SetupBench bench(false, connected(), kNow);
    const auto result = bench.run("remote");
    QVERIFY2(result && result->remarks.contains(u"remote.fits"_s), qPrintable(why(result)));
    QVERIFY(result->snapshot.isEmpty() && !result->hasChanged());
    QCOMPARE(setupChangeText(result->changes.first(), setupValueNames(bench.board.device.parameters())),
             u"RC_ROLL (PWM)"_s);
}

void TestSetupRemote::aStickThatIsLeftOutStaysAsItIs()
{
    SetupBench bench(false, connected(), kNow);
    bench.board.board().store(u"rc.map.pitch"_s, 0, 129);
    const auto result = bench.run("remote", {{u"pitch"_s, u"off"_s}});
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.pitch"_s), 129);
}

void TestSetupRemote::aSharedInputIsTold()
{
    SetupBench bench(false, connected(), kNow);
    bench.board.board().store(u"rc.map.roll"_s, 0, 2);
    bench.board.board().store(u"rc.map.pitch"_s, 0, 1);
    const auto result = bench.run("remote", {{u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}});
    QVERIFY2(result && result->state == State::Poor, qPrintable(why(result)));
    QVERIFY(result->remarks.contains(u"remote.shared"_s));
}

void TestSetupRemote::aSwitchForCommandsIsFound()
{
    SetupBench bench(false, connected(), kNow);
    const auto result = bench.run(
        "remote",
        {{u"command"_s, u"on"_s}, {u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}});
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.cmd"_s), 3);
}

void TestSetupRemote::twoAtOnceAreAskedAgain()
{
    SetupBench bench(false, connected(), kNow);
    int asked = 0;
    QString last;
    bench.board.channel.setOperator([&](const Progress &progress) {
        const bool isNew = std::exchange(last, progress.step) != progress.step;
        asked += isNew && progress.step == u"setup-stick-again"_s;
        if (progress.step == u"setup-stick-pitch"_s && asked == 0)
            bench.stick(9);
        else
            bench.obey(progress);
    });
    const auto result = bench.run("remote");
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QCOMPARE(asked, 1);
    QCOMPARE(bench.stored(u"rc.map.pitch"_s), 2);
}

void TestSetupRemote::theSameStickTwiceIsAskedAgain()
{
    SetupBench bench(false, connected(), kNow);
    bool isAsked = false;
    bench.board.channel.setOperator([&](const Progress &progress) {
        isAsked = isAsked || progress.step == u"setup-stick-taken"_s;
        if (progress.step == u"setup-stick-yaw"_s && !isAsked)
            bench.stick(1);
        else
            bench.obey(progress);
    });
    const auto result = bench.run("remote");
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QVERIFY(isAsked);
    QCOMPARE(bench.stored(u"rc.map.yaw"_s), 5);
}

void TestSetupRemote::withoutASignalItSaysSo_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("receiver");
    QTest::addColumn<QString>("says");
    QTest::newRow("no receiver") << kNow << 0 << u"no input has a signal"_s;
    QTest::newRow("another kind of receiver") << kNow << 3 << u"of the kind that is set"_s;
    // Older firmware tells the middle where there is none.
    QTest::newRow("older firmware") << 2590 << 0 << u"moved clearly"_s;
}

void TestSetupRemote::withoutASignalItSaysSo()
{
    QFETCH(int, firmware);
    QFETCH(int, receiver);
    QFETCH(QString, says);
    SetupBench bench(false, connected(receiver), firmware);
    const auto result = bench.run("remote");
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(result.error().detail.contains(says), qPrintable(result.error().detail));
}

void TestSetupRemote::aSignalThatIsLostEndsIt()
{
    SetupBench bench(false, connected(), kNow);
    bench.board.board().store(u"rc.map.roll"_s, 0, 2);
    bench.board.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"setup-stick-pitch"_s)
            bench.world(u"rc-loss=1"_s);
        bench.obey(progress);
    });
    const auto result = bench.run("remote");
    QVERIFY2(!result && result.error().detail.contains(u"no input has a signal"_s), qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.roll"_s), 2);
}

void TestSetupRemote::noiseAndLossAreBorne()
{
    Faults faults = connected();
    faults.rcNoise = 5;
    faults.rcLoss = 0.3;
    SetupBench bench(false, faults, kNow);
    bench.board.board().store(u"rc.map.roll"_s, 0, 2);
    bench.board.board().store(u"rc.map.pitch"_s, 0, 1);
    const auto result = bench.run("remote");
    QVERIFY2(result && result->state == State::Done, qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.roll"_s), 1);
}

// Whoever has another stick in his hand when it is checked, has not shown that the map is right.
void TestSetupRemote::aStickThatIsNotFollowedIsTakenBack()
{
    SetupBench bench(false, connected(), kNow);
    bench.board.board().store(u"rc.map.roll"_s, 0, 2);
    bench.board.board().store(u"rc.map.pitch"_s, 0, 1);
    bool isLate = false;
    bench.board.channel.setOperator([&](const Progress &progress) {
        isLate = isLate || progress.step == u"setup-stick-check"_s;
        if (isLate)  // another program has put the old map back
            bench.board.board().store(u"rc.map.roll"_s, 0, 2);
        bench.obey(progress);
    });
    const auto result = bench.run("remote");
    QVERIFY2(!result && result.error().code == ErrorCode::NotSeen, qPrintable(why(result)));
    QCOMPARE(bench.stored(u"rc.map.roll"_s), 2);
    QCOMPARE(bench.stored(u"rc.map.pitch"_s), 1);
    QVERIFY(!keptTrial(bench.history, bench.board.device.identity()));
}

void TestSetupRemote::whatSwitchesTheMotorsOnEndsIt()
{
    SetupBench bench(false, connected(), kNow);
    bench.board.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"setup-stick-pitch"_s)
            bench.board.board().stabilizer().setMotorsOn(true);
        bench.obey(progress);
    });
    const auto result = bench.run("remote");
    QVERIFY2(!result && result.error().detail.contains(u"switched on"_s), qPrintable(why(result)));
    QVERIFY(bench.board.channel.sleep(500ms));
    QVERIFY(!bench.board.board().stabilizer().motorsOn());
}

void TestSetupRemote::theLiveValuesAreTold()
{
    SetupBench bench(false, connected(), kNow);
    double most = 0;
    QString subject;
    bench.board.channel.setOperator([&](const Progress &progress) {
        most = std::max(most, progress.values.value(u"RC_PITCH (PWM)"_s));
        if (progress.step == u"setup-stick-back"_s && subject.isEmpty())
            subject = progress.subject;
        bench.obey(progress);
    });
    QVERIFY(bench.run("remote"));
    QVERIFY(most > 90);
    QCOMPARE(subject, u"RC_ROLL (PWM)"_s);
}

void TestSetupRemote::nothingToAskIsAnError()
{
    SetupBench bench(false, connected(), kNow);
    const auto result
        = bench.run("remote", {{u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}});
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::InvalidArgument);
}

QTEST_GUILESS_MAIN(TestSetupRemote)
#include "tst_setupremote.moc"
