// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/trialnote.h"
#include "tests/support/setupbench.h"

#include <QTest>

#include <algorithm>
#include <map>

using namespace Qt::StringLiterals;

namespace {

enum class Fault { Unplugged, Silent, Restarted, WritesUnheard, WriteBreaks, Cancelled, Idle };

constexpr std::array kFaults{std::pair(Fault::Unplugged, "the cable is pulled"),
                             std::pair(Fault::Silent, "live data stop"),
                             std::pair(Fault::Restarted, "the board restarts"),
                             std::pair(Fault::WritesUnheard, "writes are not answered"),
                             std::pair(Fault::WriteBreaks, "the board restarts while it is written"),
                             std::pair(Fault::Cancelled, "it is cancelled"),
                             std::pair(Fault::Idle, "the operator does nothing")};

/// Where in a step a fault comes: at the first report of that kind.
struct Moment
{
    QLatin1String step;
    QLatin1String when;
    std::vector<Fault> harmless = {};  ///< it does not need what fails
};

const std::vector<Moment> &moments()
{
    using enum Fault;
    static const std::vector<Moment> all{
        {"power"_L1, "setup-measure"_L1, {Idle}},
        {"sensors"_L1, "setup-measure"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"gyroscope"_L1, "calibrate"_L1, {Silent, WritesUnheard, WriteBreaks, Idle}},
        {"orientation"_L1, "setup-tilt-level"_L1},
        {"orientation"_L1, "setup-tilt-right"_L1},
        {"orientation"_L1, "setup-tilt-down"_L1},
        {"orientation"_L1, "written"_L1, {WritesUnheard, WriteBreaks}},
        {"level"_L1, "calibrate"_L1, {Silent, WritesUnheard, WriteBreaks, Idle}},
        {"balance"_L1, "setup-hold"_L1, {WritesUnheard, WriteBreaks}},
        {"balance"_L1, "setup-let-go"_L1, {WritesUnheard, WriteBreaks}},
        {"motors"_L1, "calibrate-motors"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"motors"_L1, "setup-motor-pitch"_L1, {Idle}},
        {"motors"_L1, "setup-run"_L1, {Idle}},
        {"motor-power"_L1, "setup-power"_L1, {Idle}},
        {"motor-power"_L1, "written"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"gains"_L1, "setup-measure"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"gains"_L1, "setup-response"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"gains"_L1, "autotune"_L1, {WritesUnheard, WriteBreaks, Idle}},
        {"vibration"_L1, "setup-measure"_L1, {Idle}},
        {"vibration"_L1, "measure-after"_L1, {WriteBreaks, Idle}},
        {"limits"_L1, "setup-move"_L1},
        {"use"_L1, "read-block"_L1, {Silent, Idle}},
        {"remote"_L1, "setup-stick-roll"_L1},
        {"remote"_L1, "setup-stick-check"_L1, {WritesUnheard, WriteBreaks}},
    };
    return all;
}

std::vector<ErrorCode> expectedOf(Fault fault)
{
    using enum ErrorCode;
    switch (fault) {
    case Fault::Unplugged: return {LinkClosed, NotRestored};
    case Fault::Silent: return {NoSamples, Unready, TooFewSamples};
    case Fault::Restarted: return {LinkClosed, NoSamples, Unready, TooFewSamples, Timeout, NotRestored};
    case Fault::WriteBreaks: return {LinkClosed, Timeout, NotRestored};
    case Fault::WritesUnheard: return {Timeout, NotRestored};
    case Fault::Cancelled: return {Cancelled};
    case Fault::Idle: break;
    }
    return {ConditionUnmet};
}

/// What the board holds for good.
std::map<QString, int> memoryOf(SetupBench &bench)
{
    std::map<QString, int> values;
    for (const ParameterSpec &spec : bench.board.device.parameters()->all()) {
        if (!spec.row->state)
            values[spec.key] = bench.stored(spec.key);
    }
    return values;
}

}  // namespace

/// Each step of the guided set-up meets each fault, and leaves the board as it was.
class TestSetupFaults final : public QObject
{
    Q_OBJECT
private slots:
    void aFaultEndsAStep_data();
    void aFaultEndsAStep();
    void anUnansweredQuestionIsNoAnswer();
};

void TestSetupFaults::aFaultEndsAStep_data()
{
    QTest::addColumn<int>("moment");
    QTest::addColumn<int>("fault");
    for (std::size_t i = 0; i < moments().size(); ++i) {
        const Moment &at = moments()[i];
        for (const auto &[fault, name] : kFaults) {
            if (std::find(at.harmless.begin(), at.harmless.end(), fault) == at.harmless.end())
                QTest::addRow("%s at %s: %s", at.step.data(), at.when.data(), name) << int(i) << int(fault);
        }
    }
}

void TestSetupFaults::aFaultEndsAStep()
{
    QFETCH(int, moment);
    QFETCH(int, fault);
    const Moment &at = moments()[std::size_t(moment)];
    Faults world;
    if (at.step == "orientation"_L1)
        world.mount = 2;  // so that it has something to write
    if (at.step == "vibration"_L1)
        world.shake = 0.3;
    if (at.step == "remote"_L1)
        world.receiver = 1;
    SetupBench bench(at.step == "motors"_L1, world);
    if (at.step == "remote"_L1) {
        bench.board.board().store(u"rc.map.roll"_s, 0, 2);
        bench.board.board().store(u"rc.map.pitch"_s, 0, 1);
    }
    if (at.step == "motors"_L1) {
        bench.knowSensor();
        bench.world(u"imbalance=5"_s);
    }
    if (at.step == "power"_L1)
        bench.board.board().store(u"battery.alarm"_s, 0, 1400);
    if (at.step == "vibration"_L1) {  // a structure that rings
        bench.board.board().store(u"pid.roll.p"_s, 0, 100);
        bench.board.board().store(u"pid.roll.d"_s, 0, 60);
        QVERIFY(bench.board.channel.sleep(6s));
    }
    if (at.step == "limits"_L1)
        bench.hand(2);
    if (at.step == "balance"_L1)
        bench.hand(1);
    const auto before = memoryOf(bench);
    const int write = number(at.step == "vibration"_L1 ? simplebgc::CommandId::WriteParamsExt
                                                       : simplebgc::CommandId::WriteParams3);
    const int power = bench.stored(u"motor.roll.power"_s);
    bool hasCome = false;
    bench.board.channel.setOperator([&](const Progress &progress) {
        const bool isWritten = at.when == "written"_L1
            && (at.step == "orientation"_L1 ? bench.stored(u"imu.main.axis_right"_s) == -1
                                            : bench.stored(u"motor.roll.power"_s) != power);
        if ((isWritten || progress.step == at.when) && !std::exchange(hasCome, true)) {
            switch (Fault(fault)) {
            case Fault::Unplugged: bench.world(u"unplug=0"_s); break;
            case Fault::Silent: bench.board.channel.setTap({}); break;
            case Fault::Restarted: bench.world(u"reset=0"_s); break;
            case Fault::WritesUnheard: bench.world(u"deaf=%1"_s.arg(write)); break;
            case Fault::WriteBreaks: bench.world(u"reset-on-write=1"_s); break;
            case Fault::Cancelled: bench.board.channel.cancelAfter(0ms); break;
            case Fault::Idle:
                bench.hand(at.step == "balance"_L1 && progress.step == "setup-hold"_L1 ? 0 : 1);
                break;
            }
        }
        if (!hasCome || Fault(fault) != Fault::Idle)
            bench.obey(progress);
    });
    const bool isUse = at.step == "use"_L1;
    const auto result = isUse ? bench.run("use", {{u"use"_s, u"vehicle"_s}, {u"apply"_s, u"on"_s}})
                              : bench.run(at.step.data());
    QVERIFY(hasCome);
    QVERIFY2(!result, qPrintable(why(result)));
    const auto expected = expectedOf(Fault(fault));
    QVERIFY2(std::find(expected.begin(), expected.end(), result.error().code) != expected.end(),
             qPrintable(u"%1 %2"_s.arg(int(result.error().code)).arg(result.error().detail)));
    QVERIFY(!bench.record.result(findSetupStep(at.step)->step).isOver());
    // Nor is anything left in use, unless the board cannot be told any more.
    if (at.step == "motor-power"_L1 && result.error().code != ErrorCode::NotRestored)
        QCOMPARE(bench.board.board().inUse(u"motor.roll.power"_s), power);
    if (at.step == "motors"_L1 && (Fault(fault) == Fault::Silent || Fault(fault) == Fault::Cancelled))
        QVERIFY(!bench.board.board().stabilizer().motorsOn());
    // As it was; or it is noted how it was, for the next connection.
    auto after = memoryOf(bench);
    if (result.error().code == ErrorCode::NotRestored) {
        const auto note = keptTrial(bench.history, bench.board.device.identity());
        QVERIFY(note);
        for (const TrialNote::Value &value : note->values)
            after[value.key] = int(value.old);
    }
    for (const auto &[key, value] : before)
        QVERIFY2(after[key] == value,
                 qPrintable(u"%1: %2 instead of %3 after %4 %5"_s.arg(key)
                                .arg(after[key])
                                .arg(value)
                                .arg(int(result.error().code))
                                .arg(result.error().detail)));
}

// What needs running motors asks for them first. That it was cancelled then, or the link breaks, does
// not mean that they are off.
void TestSetupFaults::anUnansweredQuestionIsNoAnswer()
{
    for (const char *step : {"balance", "vibration", "gains", "limits"}) {
        SetupBench bench(false, {});
        bench.board.channel.cancelAfter(0ms);
        const auto cancelled = bench.run(step);
        QVERIFY2(!cancelled && cancelled.error().code == ErrorCode::Cancelled, step);
        SetupBench gone(false, {});
        gone.world(u"unplug=0"_s);
        const auto unheard = gone.run(step);
        QVERIFY2(!unheard && !unheard.error().detail.contains(u"motors"_s), step);
    }
}

QTEST_GUILESS_MAIN(TestSetupFaults)
#include "tst_setupfaults.moc"
