// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/supervisor.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

constexpr double kSampleStep = 0.02;

SupervisedSample sampleAt(double time, double angle, double rate)
{
    SupervisedSample sample;
    sample.time = time;
    sample.angle = {angle, 0, 0};
    sample.rate = {rate, 0, 0};
    sample.outputs = 1;
    return sample;
}

using Motion = std::function<double(double time)>;  // the rate of roll in deg/s

/// All alarms while roll moves at that rate, whatever follows from its angle.
std::vector<Alarm> alarmsOf(const Motion &rate, double length, bool targets)
{
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    double angle = 0;
    for (double time = 0; time < length; time += kSampleStep) {
        angle += rate(time) * kSampleStep;
        SupervisedSample sample = sampleAt(time, angle, rate(time));
        if (targets)
            sample.target = {0, 0, 0};
        supervisor.add(sample);
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    return alarms;
}

double swing(double hertz, double time)
{
    return std::sin(2 * std::numbers::pi * hertz * time);
}

}  // namespace

/// What the supervisor sees beside spectra and targets, and what it says that it cannot see.
class TestUnwatched : public QObject
{
    Q_OBJECT
private slots:
    void slowSwingsAreTold_data();
    void slowSwingsAreTold();
    void growingSwingsAreToldEarly();
    void noSwingIsSeenInOrdinaryMotion();
    void hotMotorsAreTold();
    void whatIsSteeredFromHereIsItsTarget();
    void whatTurnsAwayFromIt();
    void steeringElsewhereIsNoRunaway();
    void turnsOnAndOn_data();
    void turnsOnAndOn();
    void whatMayBeMeantIsOnlyTold();
    void ordinaryTurnsAreNoRunaway();
    void steadyTurnIsNoSwing_data();
    void steadyTurnIsNoSwing();
    void missingDataAreNamed();
    void onlySteeredIsNamed();
};

void TestUnwatched::slowSwingsAreTold_data()
{
    QTest::addColumn<double>("hertz");
    QTest::addColumn<bool>("targets");
    for (const double hertz : {0.25, 0.5, 0.9, 1.6}) {
        for (const bool targets : {true, false})
            QTest::addRow("%g Hz, %s", hertz, targets ? "targets" : "none") << hertz << targets;
    }
}

void TestUnwatched::slowSwingsAreTold()
{
    QFETCH(double, hertz);
    QFETCH(bool, targets);
    const auto alarms = alarmsOf([hertz](double time) { return time < 4 ? 0 : 16 * swing(hertz, time); },
                                 5 + 5 / hertz, targets);
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Oscillation);
    QCOMPARE(alarms.front().axis, Axis::Roll);
    QCOMPARE(alarms.front().cause, AlarmCause::TooMuchGain);
    QVERIFY(std::abs(alarms.front().hertz / hertz - 1) < 0.15);
}

void TestUnwatched::growingSwingsAreToldEarly()
{
    const auto alarms = alarmsOf(
        [](double time) { return time < 4 ? 0 : std::exp(0.35 * (time - 4)) * swing(0.8, time); }, 20, true);
    QVERIFY(!alarms.empty());
    QCOMPARE(alarms.front().kind, AlarmKind::Oscillation);
    QVERIFY2(alarms.front().value < 8.0, qPrintable(QString::number(alarms.front().value)));
}

void TestUnwatched::noSwingIsSeenInOrdinaryMotion()
{
    // Small; one that dies away; and two that are no single swing.
    QVERIFY(alarmsOf([](double time) { return 3 * swing(0.4, time); }, 30, true).empty());
    QVERIFY(alarmsOf([](double time) { return 25 * std::exp(-0.5 * time) * swing(0.8, time); }, 30, true)
                .empty());
    QVERIFY(
        alarmsOf([](double time) { return 5 * swing(0.31, time) + 5 * swing(0.83, time + 0.3); }, 60, true)
            .empty());
}

void TestUnwatched::hotMotorsAreTold()
{
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    for (double time = 0; time < 20; time += 0.1) {
        SupervisedSample sample = sampleAt(time, 0, 0);
        sample.temperature = 40;
        sample.motorTemperature = {40, time > 5 && time < 12 ? 92.0 : 45.0, 40};
        supervisor.add(sample);
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Heat);
    QCOMPARE(alarms.front().axis, Axis::Pitch);
    QCOMPARE(alarms.front().value, 92.0);
    QCOMPARE(supervisor.takeEnded().size(), 1U);
}

/// Roll is steered to 20 degrees from the third second on; where it goes is up to the motion.
std::vector<Alarm> steered(const Motion &angle, double length)
{
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    double before = 0;
    for (double time = 0; time < length; time += kSampleStep) {
        SupervisedSituation situation;
        situation.isSteered = time > 3;
        situation.steeredTo
            = {time > 3 ? 20.0 : SupervisedSample::kNone, SupervisedSample::kNone, SupervisedSample::kNone};
        supervisor.setSituation(situation);
        const double now = angle(time);
        supervisor.add(sampleAt(time, now, (now - std::exchange(before, now)) / kSampleStep));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    return alarms;
}

void TestUnwatched::whatIsSteeredFromHereIsItsTarget()
{
    QVERIFY(steered([](double time) { return std::clamp(20 * (time - 3.2), 0.0, 20.0); }, 20).empty());
    // Something holds it.
    const auto alarms = steered([](double) { return 0.0; }, 20);
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Saturation);
    QCOMPARE(alarms.front().axis, Axis::Roll);
}

void TestUnwatched::whatTurnsAwayFromIt()
{
    const auto alarms = steered([](double time) { return time < 3.1 ? 0.0 : -80 * (time - 3.1); }, 4);
    QVERIFY(!alarms.empty());
    QCOMPARE(alarms.front().kind, AlarmKind::Runaway);
    QCOMPARE(alarms.front().cause, AlarmCause::WrongDirection);
    QVERIFY2(alarms.front().time < 3.6, qPrintable(QString::number(alarms.front().time)));
}

// It may be steered by others as well, and stop short of what was wanted.
void TestUnwatched::steeringElsewhereIsNoRunaway()
{
    for (const Alarm &alarm : steered([](double) { return -10.0; }, 20))
        QCOMPARE(alarm.kind, AlarmKind::Saturation);
}

/// Roll turns on a board without targets that nobody steers from here.
std::vector<Alarm> turning(const Motion &rate, double length, const SupervisorRules &rules,
                           const SupervisedSituation &situation = {},
                           const std::function<void(SupervisedSample &)> &adapt = {})
{
    Supervisor supervisor;
    supervisor.setRules(rules);
    supervisor.setSituation(situation);
    std::vector<Alarm> alarms;
    double angle = 0;
    for (double time = 0; time < length; time += kSampleStep) {
        angle += rate(time) * kSampleStep;
        SupervisedSample sample = sampleAt(time, std::remainder(angle, 360.0), rate(time));
        if (adapt)
            adapt(sample);
        supervisor.add(sample);
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised()) {
            if (alarm.kind == AlarmKind::Runaway)
                alarms.push_back(alarm);
        }
    }
    return alarms;
}

SupervisorRules unsteered()
{
    SupervisorRules rules;
    rules.isRemote = {false, false, false};
    return rules;
}

void TestUnwatched::turnsOnAndOn_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("from");
    for (const double rate : {20.0, 60.0, 90.0, -90.0, 120.0, 150.0, 300.0}) {
        QTest::addRow("%g deg/s, later", rate) << rate << 4.0;
        QTest::addRow("%g deg/s, from the start", rate) << rate << 0.0;
    }
}

void TestUnwatched::turnsOnAndOn()
{
    QFETCH(double, rate);
    QFETCH(double, from);
    const auto alarms = turning([&](double time) { return time < from ? 0 : rate; }, from + 5, unsteered());
    QCOMPARE(alarms.size(), 1U);
    QVERIFY(!alarms.front().mayBeMeant);
    QVERIFY2(alarms.front().time - from < 0.5 + 62 / std::abs(rate),
             qPrintable(QString::number(alarms.front().time)));
}

// A handle that is turned and sticks must not switch a sane gimbal off; nor must what is not read yet.
void TestUnwatched::whatMayBeMeantIsOnlyTold()
{
    const Motion steady = [](double time) { return time < 4 ? 0 : 60; };
    SupervisorRules remote = unsteered();
    remote.isRemote[0] = true;
    SupervisedSituation following;
    following.follows[0] = true;
    for (const auto &alarms : {turning(steady, 9, remote), turning(steady, 9, SupervisorRules()),
                               turning(steady, 9, unsteered(), following)}) {
        QCOMPARE(alarms.size(), 1U);
        QVERIFY(alarms.front().mayBeMeant);
    }
    // No stick goes beyond the limits.
    remote.angles[0] = {-120.0, 120.0};
    const auto alarms = turning(steady, 9, remote);
    QCOMPARE(alarms.size(), 2U);
    QVERIFY(alarms.front().mayBeMeant && !alarms.back().mayBeMeant);
}

void TestUnwatched::ordinaryTurnsAreNoRunaway()
{
    // Pushed to and fro, a drift, and the way back to level once the motors are on.
    QVERIFY(turning([](double time) { return 50 * swing(0.5, time); }, 60, unsteered()).empty());
    QVERIFY(turning([](double) { return 3.0; }, 60, unsteered()).empty());
    const Motion levelling = [](double time) { return time > 4 && time < 6 ? 45 : 0; };
    const auto later = [](SupervisedSample &sample) { sample.outputs = sample.time < 3.9 ? 0 : 1; };
    QVERIFY(turning(levelling, 12, unsteered(), {}, later).empty());
    QVERIFY(!turning(levelling, 12, unsteered()).empty());
    // An axis without a motor turns with its frame; so does one that is steered from here.
    SupervisedSituation situation;
    situation.isDriven[0] = false;
    QVERIFY(turning([](double) { return 60; }, 9, unsteered(), situation).empty());
    situation = {};
    situation.isSteered = true;
    QVERIFY(turning([](double) { return 60; }, 9, unsteered(), situation).empty());
}

void TestUnwatched::steadyTurnIsNoSwing_data()
{
    QTest::addColumn<double>("rate");
    QTest::newRow("400 deg/s") << 400.0;
    QTest::newRow("1000 deg/s") << 1000.0;
}

// Its error passes half a circle again and again, and is no swing.
void TestUnwatched::steadyTurnIsNoSwing()
{
    QFETCH(double, rate);
    for (const double from : {0.0, 2.0}) {
        // Motors that are on for long; the board keeps them off at first.
        const auto late = [from](SupervisedSample &sample) {
            sample.target = {0, 0, 0};
            sample.outputs = sample.time < 1.5 && from == 0 ? 0 : 1;
        };
        const auto alarms
            = turning([&](double time) { return time < from ? 0 : rate; }, from + 5, unsteered(), {}, late);
        QCOMPARE(alarms.size(), 1U);
        QCOMPARE(alarms.front().cause, AlarmCause::WrongDirection);
    }
}

void TestUnwatched::missingDataAreNamed()
{
    Supervisor supervisor;
    QSet<AlarmKind> all;
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind)
        all.insert(AlarmKind(kind));
    SupervisedSituation situation;
    situation.tellsFaults = situation.tellsMotorHeat = true;
    supervisor.setSituation(situation);
    const auto go
        = [&](double from, double to, double step, const std::function<void(SupervisedSample &)> &adapt) {
              for (double time = from; time < to; time += step) {
                  SupervisedSample sample = sampleAt(time, 0, 0);
                  sample.target = {0, 0, 0};
                  sample.battery = 12;
                  sample.temperature = 30;
                  sample.motorTemperature = {30, 30, 30};
                  adapt(sample);
                  supervisor.add(sample);
                  supervisor.look(time);
              }
              return supervisor.unwatched(all, to);
          };
    using Reason = Unwatched::Reason;
    QVERIFY(go(0, 5, 0.005, [](auto &) {}).empty());
    const auto without = go(5, 10, 0.005, [](SupervisedSample &sample) {
        sample.rate = {SupervisedSample::kNone, SupervisedSample::kNone, SupervisedSample::kNone};
        sample.motorTemperature = sample.rate;
    });
    const std::vector<Unwatched> expected{{AlarmKind::Oscillation, Reason::NotComing},
                                          {AlarmKind::Heat, Reason::NotComing, 0, true}};
    QVERIFY(without == expected);
    const auto slow = go(10, 40, 0.1, [](auto &) {});
    QCOMPARE(slow.size(), 1U);
    QCOMPARE(slow.front().kind, AlarmKind::Oscillation);
    QCOMPARE(slow.front().reason, Reason::TooSlow);
    QCOMPARE(slow.front().hertz, 5.0);
    // Nothing comes at all.
    QCOMPARE(supervisor.unwatched(all, 60).size(), kAlarmKinds - 3);
}

void TestUnwatched::onlySteeredIsNamed()
{
    Supervisor supervisor;
    const QSet<AlarmKind> possible{AlarmKind::Runaway, AlarmKind::Oscillation, AlarmKind::Stale};
    const auto reasonOf = [&](AlarmKind kind) -> std::optional<Unwatched::Reason> {
        for (const Unwatched &each : supervisor.unwatched(possible, 5)) {
            if (each.kind == kind)
                return each.reason;
        }
        return {};
    };
    for (double time = 0; time < 5; time += 0.005)
        supervisor.add(sampleAt(time, 0, 0));
    QVERIFY(!reasonOf(AlarmKind::Runaway));
    QCOMPARE(reasonOf(AlarmKind::Saturation), Unwatched::Reason::OnlySteered);
    QCOMPARE(reasonOf(AlarmKind::Battery), Unwatched::Reason::NotTold);
    // Steered by rate, nothing tells where it should be.
    SupervisedSituation situation;
    situation.isSteered = true;
    supervisor.setSituation(situation);
    supervisor.add(sampleAt(5, 0, 0));
    QCOMPARE(reasonOf(AlarmKind::Runaway), Unwatched::Reason::ByRate);
    situation.steeredTo = {0, 0, 0};
    supervisor.setSituation(situation);
    supervisor.add(sampleAt(5.005, 0, 0));
    QVERIFY(!reasonOf(AlarmKind::Runaway));
}

QTEST_APPLESS_MAIN(TestUnwatched)
#include "tst_unwatched.moc"
