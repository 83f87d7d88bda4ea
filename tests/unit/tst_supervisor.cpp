// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/supervisedstore.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

/// A supervisor beside a simulated board, in virtual time.
class Watched
{
public:
    Watched(VirtualChannel &channel, Device &device, double rate)
        : m_channel(channel)
        , m_device(device)
        , m_store(std::make_shared<TelemetryStore>(int(device.channels().size()), channel.now()))
        , m_origin(channel.now())
    {
        const ChannelRoles roles = rolesOf(device);
        Subscription wanted;
        wanted.rate = rate;
        if (device.streamControl())
            wanted.channels = ChannelRoles::present({roles.angle, roles.target, roles.gyro});
        const auto plan = device.subscribe(channel, wanted, {});
        if (!plan)
            qFatal("no telemetry: %s", qPrintable(plan.error().detail));
        m_decoder = plan->decoder;
        m_poll = plan->poll;
        m_period = 1.0 / plan->rate;
        channel.setTap(
            [this](const FrameView &frame, TimePoint at) { m_decoder->decode(frame, at, *m_store); });
        // The store's own present is that of the real clock; the board lives in virtual time.
        m_watched = std::make_unique<SupervisedStore>(
            m_store, std::shared_ptr<const Device>(&device, [](auto *) {}), roles);
        supervisor.setRules(SupervisorRules());
    }
    ~Watched() { m_channel.setTap({}); }
    Watched(const Watched &) = delete;
    Watched &operator=(const Watched &) = delete;

    [[nodiscard]] double now() const { return seconds(m_channel.now() - m_origin); }
    /// Lets the board go on until there is an alarm, at most for so long.
    std::optional<Alarm> run(double length)
    {
        const double end = now() + length;
        double nextLook = now();
        while (now() < end) {
            if (m_poll)
                m_channel.transact(*m_poll);
            else
                static_cast<void>(m_channel.sleep(20ms));
            if (now() < nextLook)
                continue;
            nextLook = now() + 0.02;
            SupervisedSituation situation = m_watched->situation();
            situation.period = m_period;
            situation.isSteered = isSteered;
            situation.steeredTo = steeredTo;
            situation.isProcedure = isProcedure;
            supervisor.setSituation(situation);
            m_watched->feed(supervisor);
            supervisor.look(now());
            for (const Alarm &alarm : supervisor.takeEnded())
                ended.push_back(alarm);
            const auto raised = supervisor.takeRaised();
            if (!raised.empty())
                return raised.front();
        }
        return {};
    }
    [[nodiscard]] const TelemetryStore &store() const { return *m_store; }

    Supervisor supervisor;
    std::vector<Alarm> ended;
    bool isSteered = false;
    SupervisedSample::Axes steeredTo{SupervisedSample::kNone, SupervisedSample::kNone,
                                     SupervisedSample::kNone};
    bool isProcedure = false;

private:
    VirtualChannel &m_channel;
    Device &m_device;
    std::shared_ptr<TelemetryStore> m_store;
    TimePoint m_origin;
    std::shared_ptr<TelemetryDecoder> m_decoder;
    std::optional<Request> m_poll;
    double m_period = 0;
    std::unique_ptr<SupervisedStore> m_watched;
};

/// What an alarm says, for a failed test.
QByteArray told(const std::optional<Alarm> &alarm)
{
    if (!alarm)
        return "no alarm";
    return u"kind %1 cause %2 axis %3 other %4 value %5 hz %6 at %7"_s.arg(int(alarm->kind))
        .arg(int(alarm->cause))
        .arg(QLatin1String(axisKey(alarm->axis)), QLatin1String(axisKey(alarm->other)))
        .arg(alarm->value)
        .arg(alarm->hertz)
        .arg(alarm->time)
        .toUtf8();
}

constexpr double kMargin = 0.75;
// The sanitizers look at what is done, not at how often, and take many times as long.
#if defined(__SANITIZE_ADDRESS__)
constexpr int kShorter = 10;
#else
constexpr int kShorter = 1;
#endif
constexpr double kStart = 3.0;  // seconds in which nothing is wrong
constexpr std::array<double, 3> kRates{1250, 100, 25};

/// A SimpleBGC board that holds its camera.
struct Bench : VirtualBoard
{
    explicit Bench(unsigned seed = 1, double rate = 1250)
        : VirtualBoard(withSeed(seed))
    {
        if (!identify())
            qFatal("no board");
        watched = std::make_unique<Watched>(channel, device, rate);
    }
    static SimulatorOptions withSeed(unsigned seed)
    {
        SimulatorOptions options;
        options.seed = seed;
        return options;
    }
    void change(const QString &fault)
    {
        if (!faults.set(fault))
            qFatal("no such fault: %s", qPrintable(fault));
        board().setFaults(faults);
    }
    [[nodiscard]] double now() const { return watched->now(); }

    Faults faults;
    std::unique_ptr<Watched> watched;
};

struct StormBench : StormRig
{
    explicit StormBench(unsigned seed = 1)
        : StormRig([seed] {
            SimulatorOptions wanted = stormOptions(96);
            wanted.seed = seed;
            return wanted;
        }())
    {
        if (!device.identify(channel))
            qFatal("no board");
        watched = std::make_unique<Watched>(channel, device, 0);
    }
    std::unique_ptr<Watched> watched;
};

}  // namespace

/// The supervisor on simulated boards of both families.
class TestSupervisor : public QObject
{
    Q_OBJECT
private slots:
    void swappedAxesAreNamed_data();
    void swappedAxesAreNamed();
    void whatRanAwayBeforeIsToldToo_data();
    void whatRanAwayBeforeIsToldToo();
    void wrongDirectionIsNamed_data();
    void wrongDirectionIsNamed();
    void stormRunsAway_data();
    void stormRunsAway();
    void tooMuchGainIsNamed_data();
    void tooMuchGainIsNamed();
    void unreadTuningIsAChange();
    void changeIsTakenBackOnce_data();
    void changeIsTakenBackOnce();
    void thereAndBackIsNoChange();
    void silenceIsNotOverBecauseNobodySteers();
    void stormTooMuchGainIsNamed_data();
    void stormTooMuchGainIsNamed();
    void blamelessChangeIsNotNamed();
    void resonanceIsNamed();
    void outgrownOscillationIsNoWrongDirection();
    void blockedAxisIsTold();
    void boardsFaultsAreTold_data();
    void boardsFaultsAreTold();
    void stormsFaultsAreTold();
    void heatIsTold();
    void limitIsTold();
    void staleDataAreToldWhileSteering();
    void whatTellsNoMotionIsStale_data();
    void whatTellsNoMotionIsStale();
    void slowDataAreNotStale();
    void alarmIsOverAndToldAgain();
    void boardsOwnVoltageCounts();
    void alarmOfAnotherBatteryIsTold_data();
    void alarmOfAnotherBatteryIsTold();
    void whatABoardLacksIsNotWatched();
    void ordinaryDayHasNoAlarm_data();
    void ordinaryDayHasNoAlarm();
    void hourWithoutAlarm_data();
    void hourWithoutAlarm();
};

void TestSupervisor::swappedAxesAreNamed_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<unsigned>("seed");
    for (const double rate : kRates) {
        for (unsigned seed = 1; seed <= 5; ++seed)
            QTest::addRow("%g/s, seed %u", rate, seed) << rate << seed;
    }
}

void TestSupervisor::swappedAxesAreNamed()
{
    QFETCH(double, rate);
    QFETCH(unsigned, seed);
    Bench bench(seed, rate);
    const auto calm = bench.watched->run(kStart);
    QVERIFY2(!calm, told(calm));
    bench.change(u"swapped-axes=1"_s);
    const auto alarm = bench.watched->run(3);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Runaway);
    QVERIFY2(alarm->cause == AlarmCause::SwappedAxes, told(alarm));
    QVERIFY(alarm->value < 90);
}

void TestSupervisor::whatRanAwayBeforeIsToldToo_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 3; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

// A board that was wired wrongly before it was connected: it stands at its stops.
void TestSupervisor::whatRanAwayBeforeIsToldToo()
{
    QFETCH(unsigned, seed);
    Bench bench(seed);
    bench.watched.reset();
    bench.change(u"swapped-axes=1"_s);
    QVERIFY(bench.channel.sleep(5s));
    Watched late(bench.channel, bench.device, 1250);
    const auto alarm = late.run(20);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Runaway);
    QVERIFY2(alarm->cause == AlarmCause::SwappedAxes, told(alarm));
    QVERIFY(alarm->isStanding);
}

void TestSupervisor::wrongDirectionIsNamed_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("axis");
    for (const double rate : kRates) {
        for (int axis = 0; axis < 3; ++axis)
            QTest::addRow("%g/s, %s", rate, axisKey(kAxes[std::size_t(axis)])) << rate << axis;
    }
}

void TestSupervisor::wrongDirectionIsNamed()
{
    QFETCH(double, rate);
    QFETCH(int, axis);
    Bench bench(3, rate);
    QVERIFY(!bench.watched->run(kStart));
    bench.board().store(u"motor.%1.invert"_s.arg(QLatin1String(axisKey(kAxes[std::size_t(axis)]))), 0, 1);
    const auto alarm = bench.watched->run(3);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Runaway);
    QCOMPARE(alarm->axis, kAxes[std::size_t(axis)]);
    QVERIFY2(alarm->cause == AlarmCause::WrongDirection, told(alarm));
    QVERIFY(alarm->other == Axis::None);
}

void TestSupervisor::stormRunsAway_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 4; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

void TestSupervisor::stormRunsAway()
{
    QFETCH(unsigned, seed);
    StormBench bench(seed);
    const auto calm = bench.watched->run(15);
    QVERIFY2(!calm, told(calm));
    bench.change(u"swapped-axes=1"_s);
    const auto alarm = bench.watched->run(3);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Runaway);
    QVERIFY2(alarm->cause == AlarmCause::SwappedAxes, told(alarm));
}

void TestSupervisor::tooMuchGainIsNamed_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("p");
    QTest::addColumn<int>("i");
    QTest::addColumn<int>("d");
    for (const double rate : {1250.0, 400.0}) {
        QTest::addRow("D at %g/s", rate) << rate << 30 << 12 << 255;
        QTest::addRow("P at %g/s", rate) << rate << 255 << 12 << 5;
        QTest::addRow("I at %g/s", rate) << rate << 30 << 255 << 25;
    }
    QTest::addRow("P, polled") << 25.0 << 255 << 12 << 5;
}

void TestSupervisor::tooMuchGainIsNamed()
{
    QFETCH(double, rate);
    QFETCH(int, p);
    QFETCH(int, i);
    QFETCH(int, d);
    Bench bench(7, rate);
    QVERIFY(!bench.watched->run(kStart));
    const double began = bench.now();
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{1, double(p)}, {4, double(i)}, {7, double(d)}}));
    const auto alarm = bench.watched->run(5);

    QVERIFY(alarm);
    QVERIFY(bench.now() - began < 1.5);  // that begins to swing within half a second
    QCOMPARE(alarm->kind, AlarmKind::Oscillation);
    QCOMPARE(alarm->axis, Axis::Pitch);
    QVERIFY2(alarm->cause == AlarmCause::TooMuchGain, told(alarm));
    QVERIFY(alarm->isAfterChange);
    // What was in use before is known, and put back; what was set to what it was is no change.
    const auto back = bench.device.takeBack(bench.channel);
    QVERIFY(back);
    QCOMPARE(int(back->before.size()), (p != 30) + (i != 12) + (d != 25));
    QCOMPARE(bench.board().inUse(u"pid.pitch.d"_s), 25);
    QVERIFY(!bench.watched->run(5));
    QCOMPARE(bench.watched->ended.size(), 1U);
}

// A board that was tuning itself and does not answer since: its gains may be to blame.
void TestSupervisor::unreadTuningIsAChange()
{
    Bench bench;
    const int before = bench.board().inUse(u"pid.pitch.d"_s);
    bool isDeaf = false;
    Altering lossy(bench.channel, [&isDeaf](const Request &request, const Altering::Pass &pass) {
        return isDeaf ? failure(ErrorCode::Timeout, request.name) : pass(request);
    });
    QVERIFY(!bench.device.isChanging());
    bench.device.noteChangesBy(lossy, [&] {
        QTest::qVerify(bench.device.isChanging(), "isChanging", "while it searches", __FILE__, __LINE__);
        const auto back = bench.device.takeBack(bench.channel);
        QTest::qVerify(!back && back.error().code == ErrorCode::Busy, "Busy", "", __FILE__, __LINE__);
        bench.board().store(u"pid.pitch.d"_s, 0, 70);
        isDeaf = true;
        return false;
    });
    QVERIFY(bench.device.isChanging());
    QCOMPARE(bench.board().inUse(u"pid.pitch.d"_s), 70);
    QVERIFY(bench.device.takeBack(bench.channel));
    QCOMPARE(bench.board().inUse(u"pid.pitch.d"_s), before);
    QVERIFY(!bench.device.isChanging());
}

void TestSupervisor::changeIsTakenBackOnce_data()
{
    QTest::addColumn<bool>("others");
    QTest::newRow("ours") << false;
    QTest::newRow("somebody else's meanwhile") << true;
}

// A slider that is dragged is one change; what somebody else has set since is kept.
void TestSupervisor::changeIsTakenBackOnce()
{
    QFETCH(bool, others);
    Bench bench;
    QCOMPARE(bench.device.takeBack(bench.channel).error().code, ErrorCode::NoEffect);
    const int before = bench.board().inUse(u"pid.pitch.d"_s);
    for (const double value : {60.0, 90.0, 120.0}) {
        QVERIFY(bench.device.writeAdjustables(bench.channel, {{7, value}}));
        QVERIFY(bench.channel.sleep(500ms));
    }
    QCOMPARE(bench.device.lastChange()->before.front().value, double(before));
    if (others)
        bench.board().store(u"pid.pitch.d"_s, 0, 70);
    const auto back = bench.device.takeBack(bench.channel);
    QCOMPARE(back.has_value(), !others);
    if (others)
        QCOMPARE(back.error().code, ErrorCode::Conflict);
    QCOMPARE(bench.board().inUse(u"pid.pitch.d"_s), others ? 70 : before);
}

// What went there and back within a second is in use as before.
void TestSupervisor::thereAndBackIsNoChange()
{
    Bench bench;
    const double before = bench.board().inUse(u"pid.pitch.d"_s);
    const auto set = [&bench](int variable, double value) {
        return bench.device.writeAdjustables(bench.channel, {{variable, value}}).has_value();
    };
    QVERIFY(set(7, before + 40));
    QVERIFY(bench.device.lastChange());
    QVERIFY(set(7, before));
    QVERIFY(!bench.device.lastChange());
    QCOMPARE(bench.device.takeBack(bench.channel).error().code, ErrorCode::NoEffect);
    // Of two, the other one is left.
    const double gain = bench.board().inUse(u"pid.pitch.p"_s);
    QVERIFY(set(7, before + 40) && set(1, gain + 5) && set(7, before));
    const auto change = bench.device.lastChange();
    QVERIFY(change);
    QCOMPARE(change->before, (std::vector<AdjustableValue>{{1, gain}}));
    QCOMPARE(change->after, (std::vector<AdjustableValue>{{1, gain + 5}}));
    QVERIFY(bench.device.takeBack(bench.channel));
    QCOMPARE(bench.board().inUse(u"pid.pitch.p"_s), gain);
}

void TestSupervisor::stormTooMuchGainIsNamed_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("within");  // seconds
    QTest::newRow("D") << u"pid.pitch.d"_s << 2000.0 << 1.0;
    QTest::newRow("more D") << u"pid.pitch.d"_s << 8000.0 << 1.0;
    QTest::newRow("I") << u"pid.pitch.i"_s << 20000.0 << 4.0;  // it swings up slowly
}

// Although it is polled, and what swings is faster than can be told.
void TestSupervisor::stormTooMuchGainIsNamed()
{
    QFETCH(QString, key);
    QFETCH(double, value);
    QFETCH(double, within);
    StormBench bench(7);
    QVERIFY(!bench.watched->run(15));
    const double began = bench.watched->now();
    const int variable = bench.device.parameters()->find(key)->adjustable;
    QVERIFY(bench.device.live()->writeAdjustables(bench.channel, {{variable, value}}));
    const auto alarm = bench.watched->run(10);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Oscillation);
    QCOMPARE(alarm->axis, Axis::Pitch);
    QVERIFY2(alarm->cause == AlarmCause::TooMuchGain, told(alarm));
    QVERIFY(alarm->isAfterChange);
    QVERIFY2(alarm->time - began < within, told(alarm));
    QVERIFY(bench.device.live()->takeBack(bench.channel));
    QVERIFY(!bench.watched->run(5));
    QCOMPARE(bench.watched->ended.size(), 1U);
}

// A change that was made, and is not to blame, is not named.
void TestSupervisor::blamelessChangeIsNotNamed()
{
    Alarm alarm;
    alarm.kind = AlarmKind::Oscillation;
    alarm.cause = AlarmCause::TooMuchGain;
    alarm.isAfterChange = true;
    for (const auto &[hertz, cause] :
         {std::pair(8.0, AlarmCause::TooMuchGain), std::pair(52.0, AlarmCause::Resonance)}) {
        alarm.hertz = hertz;
        const Alarm told = Supervisor::withoutChange(alarm);
        QVERIFY(!told.isAfterChange);
        QCOMPARE(told.cause, cause);
    }
}

void TestSupervisor::resonanceIsNamed()
{
    Bench bench(7, 1250);
    QVERIFY(!bench.watched->run(kStart));
    bench.board().store(u"pid.pitch.d"_s, 0, 255);
    const auto alarm = bench.watched->run(5);
    QVERIFY(alarm);
    QCOMPARE(alarm->kind, AlarmKind::Oscillation);
    QVERIFY(!alarm->isAfterChange);
    QCOMPARE(alarm->cause, AlarmCause::Resonance);
    // The plant's own mode, shifted by the loop.
    QVERIFY(alarm->hertz > 50 && alarm->hertz < 110);
    QVERIFY(!alarm->isHertzVague);
}

/// Samples of one axis, made up.
SupervisedSample sampleOf(double time, double angle, double rate, double target = 0)
{
    SupervisedSample sample;
    sample.time = time;
    sample.angle = {angle, 0, 0};
    sample.target = {target, 0, 0};
    sample.rate = {rate, 0, 0};
    sample.outputs = 1;
    return sample;
}

void TestSupervisor::outgrownOscillationIsNoWrongDirection()
{
    Supervisor supervisor;
    std::vector<Alarm> runaways;
    for (double time = 0; time < 6; time += 0.005) {
        const double swing = 0.5 * std::exp(1.2 * time);
        supervisor.add(sampleOf(time, swing * std::sin(8 * time), swing * 8 * std::cos(8 * time)));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised()) {
            if (alarm.kind == AlarmKind::Runaway)
                runaways.push_back(alarm);
        }
    }
    for (const Alarm &alarm : runaways)
        QCOMPARE(alarm.cause, AlarmCause::TooMuchGain);
}

void TestSupervisor::blockedAxisIsTold()
{
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    for (double time = 0; time < 12; time += 0.02) {
        supervisor.add(sampleOf(time, 0, 0, time > 2 && time < 8 ? 12 : 0));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Saturation);
    QVERIFY(alarms.front().time > 4.9 && alarms.front().time < 5.3);
    QCOMPARE(supervisor.takeEnded().size(), 1U);
}

void TestSupervisor::boardsFaultsAreTold_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<AlarmKind>("kind");
    QTest::newRow("sensor") << u"no-imu=1"_s << AlarmKind::Sensor;
    QTest::newRow("battery") << u"battery=9.9"_s << AlarmKind::Battery;
}

void TestSupervisor::boardsFaultsAreTold()
{
    QFETCH(QString, fault);
    QFETCH(AlarmKind, kind);
    Bench bench(2, 100);
    QVERIFY(!bench.watched->run(kStart));
    bench.change(fault);
    const auto alarm = bench.watched->run(8);
    QVERIFY2(alarm && alarm->kind == kind, told(alarm));
    bench.change(fault.section(u'=', 0, 0) + (kind == AlarmKind::Battery ? u"=12.3"_s : u"=0"_s));
    QVERIFY(!bench.watched->run(8));
    QCOMPARE(bench.watched->ended.size(), 1U);
}

void TestSupervisor::stormsFaultsAreTold()
{
    for (const auto &[fault, kind] :
         {std::pair(u"no-imu=1"_s, AlarmKind::Sensor), {u"battery=9.9"_s, AlarmKind::Battery}}) {
        StormBench bench;
        QVERIFY(!bench.watched->run(15));
        bench.change(fault);
        const auto alarm = bench.watched->run(8);
        QVERIFY2(alarm && alarm->kind == kind, told(alarm));
    }
}

void TestSupervisor::heatIsTold()
{
    Supervisor supervisor;
    SupervisorRules rules;
    rules.hotCelsius = 60;
    supervisor.setRules(rules);
    std::vector<Alarm> alarms;
    for (double time = 0; time < 20; time += 0.1) {
        SupervisedSample sample;
        sample.time = time;
        sample.temperature = time < 5 ? 40 : 61;
        supervisor.add(sample);
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Heat);
    QCOMPARE(alarms.front().value, 61.0);
}

void TestSupervisor::limitIsTold()
{
    Supervisor supervisor;
    SupervisorRules rules;
    rules.angles[0] = {-30.0, 30.0};
    supervisor.setRules(rules);
    std::vector<Alarm> alarms;
    for (double time = 0; time < 12; time += 0.02) {
        // First steered beyond, which is somebody's wish; then it creeps there by itself.
        const double angle = time < 4 ? 36 : 28 + std::min(8.0, 4 * (time - 4));
        supervisor.add(sampleOf(time, angle, 0, time < 4 ? 36 : 29));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Limit);
    QVERIFY(alarms.front().time > 6);
    QCOMPARE(alarms.front().limit, 30.0);
}

void TestSupervisor::staleDataAreToldWhileSteering()
{
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    SupervisedSituation situation;
    situation.period = 0.01;
    for (double time = 0; time < 9; time += 0.02) {
        situation.isSteered = time > 4;
        supervisor.setSituation(situation);
        if (time < 2 || (time > 3.5 && time < 6) || time > 8)
            supervisor.add(sampleOf(time, 0, 0));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Stale);
    QVERIFY(alarms.front().time > 6.45 && alarms.front().time < 6.7);
}

void TestSupervisor::silenceIsNotOverBecauseNobodySteers()
{
    Supervisor supervisor;
    std::optional<double> ended;
    SupervisedSituation situation;
    situation.period = 0.02;
    for (double time = 0; time < 12; time += 0.02) {
        situation.isSteered = time > 1 && time < 4;
        supervisor.setSituation(situation);
        if (time < 2 || time > 8)
            supervisor.add(sampleOf(time, 0, 0));
        supervisor.look(time);
        if (!supervisor.takeEnded().empty())
            ended = time;
    }
    QVERIFY(ended && *ended > 8);
}

// Status that goes on, and values that come again and again, do not show how the camera moves.
void TestSupervisor::whatTellsNoMotionIsStale_data()
{
    QTest::addColumn<bool>("repeats");
    QTest::newRow("only status comes") << false;
    QTest::newRow("the same values come") << true;
}

void TestSupervisor::whatTellsNoMotionIsStale()
{
    QFETCH(bool, repeats);
    Supervisor supervisor;
    std::vector<Alarm> alarms;
    int ended = 0;
    SupervisedSituation situation;
    situation.period = 0.02;
    situation.tellsMotion = true;
    situation.isSteered = true;
    for (double time = 0; time < 20; time += 0.02) {
        const bool isFrozen = time > 5 && time < 12;
        situation.unchangedSince = repeats && isFrozen && time > 10 ? std::optional(5.0) : std::nullopt;
        supervisor.setSituation(situation);
        SupervisedSample status;
        status.time = time;
        status.battery = 12.3;
        supervisor.add(status);
        if (repeats || !isFrozen)
            supervisor.add(sampleOf(time, 0, 0));
        supervisor.look(time);
        for (const Alarm &alarm : supervisor.takeRaised())
            alarms.push_back(alarm);
        ended += int(supervisor.takeEnded().size());
    }
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms.front().kind, AlarmKind::Stale);
    const double told = repeats ? 10.0 : 5.5;
    QVERIFY(alarms.front().time > told && alarms.front().time < told + 0.2);
    QCOMPARE(ended, 1);
}

// A slow board's data are not late as long as they come as often as they were arranged.
void TestSupervisor::slowDataAreNotStale()
{
    Supervisor supervisor;
    int raised = 0;
    int ended = 0;
    SupervisedSituation situation;
    situation.period = 1.0;
    situation.tellsMotion = true;
    situation.isSteered = true;
    supervisor.setSituation(situation);
    double next = 0;
    for (double time = 0; time < 40; time += 0.02) {
        if (time >= next && (time < 10 || time > 20)) {
            supervisor.add(sampleOf(time, 0, 0));
            next = time + 1.0;
        }
        supervisor.look(time);
        raised += int(supervisor.takeRaised().size());
        ended += int(supervisor.takeEnded().size());
    }
    QCOMPARE(raised, 1);
    QCOMPARE(ended, 1);
}

void TestSupervisor::alarmIsOverAndToldAgain()
{
    Supervisor supervisor;
    int raised = 0;
    int ended = 0;
    for (double time = 0; time < 30; time += 0.1) {
        SupervisedSample sample;
        sample.time = time;
        sample.battery = std::fmod(time, 10.0) < 5 ? 12.3 : 9.6;
        supervisor.add(sample);
        supervisor.look(time);
        raised += int(supervisor.takeRaised().size());
        ended += int(supervisor.takeEnded().size());
    }
    QCOMPARE(raised, 3);
    QCOMPARE(ended, 2);
}

// Whichever comes first: what the board is set to, or what the program takes for low.
void TestSupervisor::boardsOwnVoltageCounts()
{
    const auto alarmAt = [](double volts, const BatteryThresholds &board) {
        Supervisor supervisor;
        SupervisorRules rules;
        rules.battery = board;
        supervisor.setRules(rules);
        for (double time = 0; time < 6; time += 0.1) {
            SupervisedSample sample;
            sample.time = time;
            sample.battery = time < 1 ? 12.3 : volts;
            supervisor.add(sample);
            supervisor.look(time);
        }
        const std::vector<Alarm> raised = supervisor.takeRaised();
        return raised.size() == 1 && raised.front().kind == AlarmKind::Battery ? raised.front().limit : 0.0;
    };
    QCOMPARE(alarmAt(10.5, {}), 0.0);
    QCOMPARE(alarmAt(10.5, {.alarm = 11.0, .motorsOff = {}}), 11.0);
    QCOMPARE(alarmAt(11.2, {.alarm = 11.0, .motorsOff = {}}), 0.0);
    QCOMPARE(alarmAt(9.9, {.alarm = 9.0, .motorsOff = {}}), 3 * SupervisorRules().cellVolts);
    QCOMPARE(alarmAt(10.7, {.alarm = 3.6, .motorsOff = {}, .perCell = true}), 3 * 3.6);
}

// An unpacked board's alarm belongs to another battery: nobody is told to change one that is full.
void TestSupervisor::alarmOfAnotherBatteryIsTold_data()
{
    QTest::addColumn<double>("highest");
    QTest::addColumn<double>("volts");
    QTest::addColumn<double>("alarm");
    QTest::addColumn<bool>("isReported");
    QTest::addColumn<AlarmCause>("cause");
    QTest::addColumn<int>("cells");
    QTest::newRow("full, another's alarm") << 12.3 << 12.3 << 14.0 << false << AlarmCause::OtherBattery << 3;
    QTest::newRow("the board says so too") << 12.3 << 12.3 << 14.0 << true << AlarmCause::OtherBattery << 3;
    QTest::newRow("only the board says so") << 12.3 << 12.3 << 11.0 << true << AlarmCause::OtherBattery << 3;
    QTest::newRow("it was full before") << 16.6 << 12.3 << 14.0 << false << AlarmCause::Unknown << 4;
    QTest::newRow("low by any alarm") << 12.3 << 9.9 << 14.0 << false << AlarmCause::Unknown << 3;
    QTest::newRow("low by its own alarm") << 12.3 << 10.9 << 11.1 << true << AlarmCause::Fault << 3;
}

void TestSupervisor::alarmOfAnotherBatteryIsTold()
{
    QFETCH(double, highest);
    QFETCH(double, volts);
    QFETCH(double, alarm);
    QFETCH(bool, isReported);
    Supervisor supervisor;
    SupervisorRules rules;
    rules.battery.alarm = alarm;
    supervisor.setRules(rules);
    for (double time = 0; time < 6; time += 0.1) {
        SupervisedSituation situation;
        if (isReported && time >= 1)
            situation.faults.append(u"low-battery"_s);
        supervisor.setSituation(situation);
        SupervisedSample sample;
        sample.time = time;
        sample.battery = time < 1 ? highest : volts;
        supervisor.add(sample);
        supervisor.look(time);
    }
    const std::vector<Alarm> raised = supervisor.takeRaised();
    QCOMPARE(raised.size(), 1U);
    QTEST(raised.front().cause, "cause");
    QTEST(raised.front().cells, "cells");
}

void TestSupervisor::whatABoardLacksIsNotWatched()
{
    const simplebgc::Device full;
    const storm32::Device without;
    const auto all = Supervisor::possible(rolesOf(full));
    QCOMPARE(all.size(), qsizetype(kAlarmKinds) - 1);
    QVERIFY(!all.contains(AlarmKind::Disarmed));  // only of what is armed and disarmed
    const auto some = Supervisor::possible(rolesOf(without));
    QVERIFY(some.contains(AlarmKind::Runaway) && some.contains(AlarmKind::Oscillation));
    QVERIFY(!some.contains(AlarmKind::Saturation) && !some.contains(AlarmKind::Limit));
    QVERIFY(!some.contains(AlarmKind::Heat));
}

void TestSupervisor::ordinaryDayHasNoAlarm_data()
{
    QTest::addColumn<double>("rate");
    QTest::addColumn<unsigned>("seed");
    for (const double rate : kRates) {
        for (const unsigned seed : {11U, 12U})
            QTest::addRow("%g/s, seed %u", rate, seed) << rate << seed;
    }
}

// Motors off and on, another profile, a calibration, a camera that is held, moved by hand, a restart.
void TestSupervisor::ordinaryDayHasNoAlarm()
{
    QFETCH(double, rate);
    QFETCH(unsigned, seed);
    Bench bench(seed, rate);
    Stabilizer &gimbal = bench.board().stabilizer();
    const auto quiet = [&](double length) {
        const auto alarm = bench.watched->run(length);
        if (alarm)
            qWarning() << told(alarm);
        return !alarm;
    };
    QVERIFY(quiet(2));
    for (int round = 0; round < 3; ++round) {
        gimbal.setMotorsOn(false);
        QVERIFY(quiet(4));  // it falls
        gimbal.setMotorsOn(true);
        QVERIFY(quiet(3));
        QVERIFY(bench.device.selectProfile(bench.channel, round));
        QVERIFY(quiet(3));
    }
    gimbal.setMotorsOn(false);
    for (double angle = 0; angle < 170; angle += 4) {
        gimbal.plant(Axis::Pitch).setAngle(angle);
        QVERIFY(quiet(0.04));
    }
    gimbal.plant(Axis::Pitch).setAngle(40);
    QVERIFY(quiet(2));
    gimbal.setMotorsOn(true);
    QVERIFY(quiet(5));
    const auto calibrated = bench.device.perform(bench.channel, u"calibrate.gyro"_s,
                                                 argumentsFor(bench.device, "calibrate.gyro"));
    QVERIFY(calibrated);
    QVERIFY(quiet(10));
}

void TestSupervisor::hourWithoutAlarm_data()
{
    QTest::addColumn<bool>("storm");
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<bool>("tuned");
    QTest::newRow("simplebgc") << false << 1U << false;
    QTest::newRow("storm32") << true << 1U << false;
    QTest::newRow("simplebgc-shortly") << false << 2U << false;  // another hand, and not at the full rate
    QTest::newRow("simplebgc-tuned") << false << 3U << true;
    QTest::newRow("storm32-shortly") << true << 2U << false;
}

// Shaken, and steered the whole time: to places, and by rate.
void TestSupervisor::hourWithoutAlarm()
{
    QFETCH(bool, storm);
    QFETCH(unsigned, seed);
    QFETCH(bool, tuned);
    SimulatedNoise operatorsHand(seed);
    const int minutes = (seed == 1 ? 60 : 10) / kShorter;
    const auto hour = [&](auto &bench, const auto &steer) {
        // With margin: limits that are closer than those by default raise none either.
        SupervisorRules strict;
        strict.oscillation *= kMargin;
        strict.runawayDeg *= kMargin;
        bench.watched->supervisor.setRules(strict);
        bench.change(u"shake=2"_s);
        // Calibrated: otherwise yaw drifts until it is at its stop, and that is told rightly.
        SimulatedImu &imu = bench.board().stabilizer().imu();
        imu.gyroCorrection = imu.gyroBias;
        QVERIFY(!bench.watched->run(15));
        for (int minute = 0; minute < minutes; ++minute) {
            bench.change(u"shake=%1"_s.arg(minute % 3 == 0 ? 8 : 1 + minute % 5));
            for (int move = 0; move < 20; ++move) {
                bench.watched->isSteered = true;
                steer(bench, kAxes[std::size_t(move) % 3]);
                const auto alarm = bench.watched->run(3);
                QVERIFY2(!alarm, told(alarm));
            }
        }
    };
    if (storm) {
        StormBench bench(seed);
        hour(bench, [&](StormBench &b, Axis axis) {
            const double angle = operatorsHand.uniform() * 40 - 20;
            SteeringSetpoint wanted;
            const SteeringMode &mode = b.device.modes().front();
            wanted.mode = mode.id;
            wanted.inputs.assign(mode.inputs.size(), SupervisedSample::kNone);
            if (const int input = mode.inputOf(axis); input >= 0)
                wanted.inputs[std::size_t(input)] = std::clamp(angle, mode.inputs[std::size_t(input)].min,
                                                               mode.inputs[std::size_t(input)].max);
            const ControlFrames frames = b.device.controlFrames(wanted);
            b.watched->steeredTo = frames.angles;
            b.channel.steer(frames);
        });
        return;
    }
    Bench bench(seed, seed == 1 ? 1250 : 200);
    if (tuned) {
        // What auto-tune finds on the simulated gimbal.
        const std::array<std::array<int, 3>, kAxisCount> gains{{{84, 14, 51}, {84, 19, 52}, {38, 8, 88}}};
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const QString prefix = u"pid.%1."_s.arg(QLatin1String(axisKey(kAxes[axis])));
            for (std::size_t gain = 0; gain < 3; ++gain)
                bench.board().store(prefix + u"pid"_s[qsizetype(gain)], 0, gains[axis][gain]);
        }
    }
    hour(bench, [&](Bench &b, Axis axis) {
        // Jumps, as an angle mode without limits makes them.
        b.board().stabilizer().setTarget(axis, operatorsHand.uniform() * 80 - 40);
    });
}

QTEST_APPLESS_MAIN(TestSupervisor)
#include "tst_supervisor.moc"
