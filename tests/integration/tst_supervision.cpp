// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/base/framelistener.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/device/steering.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"
#include "protocol/supervisor/alarmreport.h"
#include "protocol/supervisor/unwatched.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"
#include "tests/support/boardtime.h"
#include "tests/support/patience.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace {

/// When certain bytes went out. Filled on the I/O thread.
class SentWatch final : public FrameListener
{
public:
    void frameReceived(const FrameView &, TimePoint, bool) override { }
    void bytesSent(QByteArrayView bytes, TimePoint at) override
    {
        const std::lock_guard lock(m_mutex);
        if (!m_at && !m_wanted.isEmpty() && bytes.indexOf(m_wanted) >= 0)
            m_at = at;
    }
    void expect(const QByteArray &wanted)
    {
        const std::lock_guard lock(m_mutex);
        m_wanted = wanted;
        m_at.reset();
    }
    [[nodiscard]] std::optional<TimePoint> at() const
    {
        const std::lock_guard lock(m_mutex);
        return m_at;
    }

private:
    mutable std::mutex m_mutex;
    QByteArray m_wanted;
    std::optional<TimePoint> m_at;
};

}  // namespace

/// The supervisor of a client, on simulated boards in real time.
class TestSupervision : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void runawayIsStopped_data();
    void runawayIsStopped();
    void oscillationIsTakenBack();
    void operatorChoosesToBeWarnedOnly();
    void chosenReactionIsTaken_data();
    void chosenReactionIsTaken();
    void reactionFollowsTheChange_data();
    void reactionFollowsTheChange();
    void whatDiesAwayIsToldToBeQuiet();
    void newStreamsAreNoSilence_data();
    void newStreamsAreNoSilence();
    void stopMayBeOpenAtTheEnd();
    void steeredBoardsAreWatched_data();
    void steeredBoardsAreWatched();
    void whatIsNotWatchedIsNamed_data();
    void whatIsNotWatchedIsNamed();

private:
    [[nodiscard]] bool isStabilising() const;
    void open(const QString &address);
    void subscribe();
    /// Runs code on the worker and waits for its end.
    template <typename T> Result<T> ask(std::function<Result<T>(Channel &, Device &)> job);
    double inUse(int variable);
    /// A setpoint by angle that holds it; see m_pitch.
    SteeringSetpoint whereItIs();

    std::unique_ptr<DeviceClient> m_client;
    std::unique_ptr<SentWatch> m_sent;
    QList<AlarmReport> m_reports;
    Links m_links = allLinks();
    LinkAddress m_address;
    int m_pitch = -1;  // which of its inputs turns that axis
};

void TestSupervision::init()
{
    m_reports.clear();
    m_sent = std::make_unique<SentWatch>();
    m_client = std::make_unique<DeviceClient>(m_links.transports, allFamilies());
    m_client->addListener(*m_sent);
    connect(m_client.get(), &DeviceClient::alarmChanged, this,
            [this](const AlarmReport &report) { m_reports.append(report); });
}

void TestSupervision::cleanup()
{
    m_client->shutDown();
    m_client.reset();
}

// A board of its own for each test: simulated boards keep what happened to them.
void TestSupervision::open(const QString &address)
{
    static int seed = 100;
    const QChar separator = address.contains(u'?') ? u'&' : u'?';
    m_address = LinkAddress::parse(u"%1%2seed=%3"_s.arg(address).arg(separator).arg(++seed)).value();
    m_client->connectTo(m_address);
    QTRY_VERIFY(m_client->isConnected());
    subscribe();
    QTRY_VERIFY(m_client->telemetry()->rows() > 0);
    QVERIFY(m_client->roles().outputs >= 0);
    QTRY_VERIFY(m_client->telemetry()->latest(m_client->roles().outputs) > 0);
}

void TestSupervision::subscribe()
{
    const ChannelRoles &roles = m_client->roles();
    Subscription wanted;
    if (m_client->device()->streamControl())
        wanted.channels = ChannelRoles::present({roles.angle, roles.target, roles.gyro});
    m_client->subscribe(wanted);
}

template <typename T> Result<T> TestSupervision::ask(std::function<Result<T>(Channel &, Device &)> job)
{
    auto future = m_client->submit<T>(std::move(job));
    if (!QTest::qWaitFor([&] { return future.isFinished(); }, kPatience))
        qFatal("no answer");
    return future.result();
}

double TestSupervision::inUse(int variable)
{
    const auto values = ask<std::vector<AdjustableValue>>([variable](Channel &channel, Device &device) {
        return device.live()->readAdjustables(channel, {variable});
    });
    return values ? values->front().value : -1;
}

void TestSupervision::runawayIsStopped_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<double>("limit");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s << 25.0;
    QTest::newRow("STorM32") << u"sim:storm32"_s << 50.0;  // it has no targets
}

// With a worker that is busy and a screen that hangs.
void TestSupervision::runawayIsStopped()
{
    QFETCH(QString, address);
    QFETCH(double, limit);
    open(address);
    // The simulated STorM32 levels first; its supervisor waits until it holds.
    const StatusWords *words = m_client->device()->statusWords();
    QTRY_VERIFY(!words || words->isStabilising(int(m_client->telemetry()->latest(m_client->roles().state))));
    QVERIFY(boardGoesOn(*m_client, 1.5));
    QVERIFY(m_reports.isEmpty());
    auto busy = m_client->submit<bool>([](Channel &channel, Device &) -> Result<bool> {
        static_cast<void>(channel.sleep(6s));
        return true;
    });
    m_sent->expect(m_client->device()->stopPlan().means.front().requests.front().bytes);
    const auto store = m_client->telemetry();
    const std::array<int, 3> angles = m_client->roles().angle;
    const double began = store->now();
    QVERIFY(m_links.changeWorld(m_address, u"swapped-axes=1"_s));
    // Nothing of this thread's event loop runs meanwhile.
    const TimePoint patience = Clock::now() + 5s;
    while (!m_sent->at() && Clock::now() < patience)
        QThread::msleep(5);
    QVERIFY(m_sent->at());
    QVERIFY(!busy.isFinished());
    // From the first sample beyond the limit until the stop was on the wire.
    std::optional<double> beyond;
    for (const int channel : {angles[0], angles[1]}) {
        for (TrackView &track : store->tracks(channel)) {
            track.refresh();
            for (std::size_t row = track.rowAt(began); row < track.end(); ++row) {
                if (std::abs(track.value(row)) > float(limit)) {
                    beyond = std::min(beyond.value_or(1e9), track.time(row));
                    break;
                }
            }
        }
    }
    QVERIFY(beyond);
    const double reaction = store->secondsAt(*m_sent->at()) - *beyond;
    qInfo() << "stopped" << reaction << "s after the limit was passed";
    QVERIFY(reaction < 0.5);
    // And it is told as soon as the screen is back.
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().outcome == AlarmOutcome::Done);
    QCOMPARE(m_reports.first().alarm.kind, AlarmKind::Runaway);
    QCOMPARE(m_reports.first().alarm.cause, AlarmCause::SwappedAxes);
    QCOMPARE(m_reports.last().action, AlarmAction::MotorsOff);
    QTRY_VERIFY(m_client->telemetry()->latest(m_client->roles().outputs) == 0);
    m_client->cancelJobs();
}

void TestSupervision::oscillationIsTakenBack()
{
    open(u"sim:simplebgc"_s);
    QVERIFY(boardGoesOn(*m_client, 1.5));
    constexpr int kPitchD = 7;  // PID_D, pitch: adjustable variable
    const double before = inUse(kPitchD);
    const auto done = ask<bool>([](Channel &channel, Device &device) -> Result<bool> {
        const auto written = device.live()->writeAdjustables(channel, {{kPitchD, 255}});
        return written ? Result<bool>(true) : tl::unexpected(written.error());
    });
    QVERIFY(done);
    auto busy = m_client->submit<bool>([](Channel &channel, Device &) -> Result<bool> {
        static_cast<void>(channel.sleep(4s));
        return true;
    });
    const double began = m_client->telemetry()->now();
    QThread::msleep(2000);  // the screen hangs
    QVERIFY(!busy.isFinished());
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().outcome == AlarmOutcome::Done);
    const AlarmReport &report = m_reports.last();
    QCOMPARE(report.alarm.kind, AlarmKind::Oscillation);
    QCOMPARE(report.alarm.axis, Axis::Pitch);
    QCOMPARE(report.alarm.cause, AlarmCause::TooMuchGain);
    QVERIFY(report.change.has_value());
    QCOMPARE(report.change->before.front().value, before);
    qInfo() << "noticed" << report.alarm.time - began << "s after the change," << report.alarm.value
            << "deg/s at" << report.alarm.hertz << "Hz";
    m_client->cancelJobs();
    QTRY_VERIFY(busy.isFinished());
    QCOMPARE(inUse(kPitchD), before);
    QTRY_VERIFY(m_reports.last().isOver);
}

void TestSupervision::operatorChoosesToBeWarnedOnly()
{
    SupervisorRules rules;
    rules.actions.fill(AlarmAction::Warn);
    m_client->setSupervisorRules(rules);
    open(u"sim:simplebgc"_s);
    QVERIFY(boardGoesOn(*m_client, 1.0));
    QVERIFY(m_links.changeWorld(m_address, u"swapped-axes=1"_s));
    QTRY_VERIFY(!m_reports.isEmpty());
    QCOMPARE(m_reports.first().action, AlarmAction::Warn);
    QVERIFY(boardGoesOn(*m_client, 1.0));
    QVERIFY(m_client->telemetry()->latest(m_client->roles().outputs) > 0);
}

bool TestSupervision::isStabilising() const
{
    const StatusWords *words = m_client->device()->statusWords();
    return QTest::qWaitFor(
        [this, words] {
            return !words
                || words->isStabilising(int(m_client->telemetry()->latest(m_client->roles().state)));
        },
        kPatience);
}

void TestSupervision::chosenReactionIsTaken_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("fault");
    QTest::addColumn<AlarmKind>("kind");
    QTest::addColumn<AlarmAction>("wanted");
    QTest::addColumn<bool>("ends");  // motors off
    QTest::addColumn<AlarmOutcome>("outcome");
    const std::pair<const char *, AlarmKind> faults[]{{"battery=10.1", AlarmKind::Battery},
                                                      {"no-imu=1", AlarmKind::Sensor},
                                                      {"heat=95", AlarmKind::Heat},
                                                      {"swapped-axes=1", AlarmKind::Runaway}};
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        for (const auto &[fault, kind] : faults) {
            const auto add = [&](const char *name, AlarmAction wanted, bool ends, AlarmOutcome outcome) {
                QTest::addRow("%s, %s, %s", qPrintable(family), fault, name)
                    << u"sim:"_s + family << QString::fromLatin1(fault) << kind << wanted << ends << outcome;
            };
            if (kind == AlarmKind::Heat && family == u"storm32"_s)
                continue;  // it does not tell
            add("warn", AlarmAction::Warn, false, AlarmOutcome::Told);
            add("motors off", AlarmAction::MotorsOff, true, AlarmOutcome::Done);
            if (!SupervisorRules::offers(kind, AlarmAction::TakeBack))
                continue;
            add("revert, nothing to", AlarmAction::TakeBack, false, AlarmOutcome::NoChange);
            add("revert or off", AlarmAction::TakeBackElseOff, true, AlarmOutcome::Done);
        }
    }
}

// Each kind that a fault of the simulated board brings about, with each reaction that the settings offer.
void TestSupervision::chosenReactionIsTaken()
{
    QFETCH(QString, address);
    QFETCH(QString, fault);
    QFETCH(AlarmKind, kind);
    QFETCH(AlarmAction, wanted);
    QFETCH(bool, ends);
    QFETCH(AlarmOutcome, outcome);
    SupervisorRules rules;
    rules.actions[std::size_t(kind)] = wanted;
    m_client->setSupervisorRules(rules);
    open(address);
    QVERIFY(isStabilising());
    QVERIFY(boardGoesOn(*m_client, 1.5));
    QVERIFY(m_reports.isEmpty());
    QVERIFY(m_links.changeWorld(m_address, fault));
    const auto report = [&]() -> const AlarmReport * {
        const auto it = std::find_if(m_reports.rbegin(), m_reports.rend(),
                                     [kind](const AlarmReport &each) { return each.alarm.kind == kind; });
        return it == m_reports.rend() ? nullptr : &*it;
    };
    QTRY_VERIFY(report() && report()->outcome == outcome);
    QCOMPARE(report()->action, ends ? AlarmAction::MotorsOff : AlarmAction::Warn);
    const double outputs = m_client->roles().outputs;
    if (ends) {
        QTRY_COMPARE(m_client->telemetry()->latest(int(outputs)), 0.0F);
        return;
    }
    QVERIFY(boardGoesOn(*m_client, 1.0));
    if (kind != AlarmKind::Sensor)  // without it some boards stop by themselves
        QVERIFY(m_client->telemetry()->latest(int(outputs)) > 0);
}

void TestSupervision::reactionFollowsTheChange_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<AlarmAction>("wanted");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        for (const auto &[name, wanted] : {std::pair("warn", AlarmAction::Warn),
                                           {"revert", AlarmAction::TakeBack},
                                           {"revert or off", AlarmAction::TakeBackElseOff},
                                           {"motors off", AlarmAction::MotorsOff}})
            QTest::addRow("%s, %s", qPrintable(family), name) << u"sim:"_s + family << wanted;
    }
}

// Too much gain, set live: what is chosen for oscillations is done, and nothing else.
void TestSupervision::reactionFollowsTheChange()
{
    QFETCH(QString, address);
    QFETCH(AlarmAction, wanted);
    SupervisorRules rules;
    rules.actions[std::size_t(AlarmKind::Oscillation)] = wanted;
    m_client->setSupervisorRules(rules);
    open(address);
    QVERIFY(isStabilising());
    QVERIFY(boardGoesOn(*m_client, 1.5));
    QVERIFY(m_reports.isEmpty());
    const auto gain = [this](const char *key) {
        const auto all = m_client->device()->parameters()->all();
        return std::find_if(all.begin(), all.end(),
                            [key](const ParameterSpec &spec) { return spec.key == QLatin1String(key); })
            ->adjustable;
    };
    const int variable = gain("pid.pitch.d");
    const double most = address.contains(u"storm32"_s) ? 8000.0 : 255.0;
    const double before = inUse(variable);
    const auto done = ask<bool>([variable, most](Channel &channel, Device &device) -> Result<bool> {
        const auto written = device.live()->writeAdjustables(channel, {{variable, most}});
        return written ? Result<bool>(true) : tl::unexpected(written.error());
    });
    QVERIFY(done);
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().outcome != AlarmOutcome::Acting);
    const AlarmReport report = m_reports.last();
    QCOMPARE(report.alarm.kind, AlarmKind::Oscillation);
    QCOMPARE(report.alarm.cause, AlarmCause::TooMuchGain);
    QCOMPARE(report.alarm.axis, Axis::Pitch);
    const bool isBack = wanted == AlarmAction::TakeBack || wanted == AlarmAction::TakeBackElseOff;
    QCOMPARE(report.action, wanted);
    QCOMPARE(report.outcome, wanted == AlarmAction::Warn ? AlarmOutcome::Told : AlarmOutcome::Done);
    QCOMPARE(inUse(variable) == before, isBack);
    if (wanted == AlarmAction::MotorsOff)
        QTRY_VERIFY(m_client->telemetry()->latest(m_client->roles().outputs) == 0);
    else
        QVERIFY(m_client->telemetry()->latest(m_client->roles().outputs) > 0);
    if (isBack)
        QTRY_VERIFY(m_reports.last().isOver);
}

// Much P and no damping: once the damping is back it takes a second to die away, which is no going on.
void TestSupervision::whatDiesAwayIsToldToBeQuiet()
{
    SupervisorRules rules;
    rules.actions[std::size_t(AlarmKind::Oscillation)] = AlarmAction::TakeBack;
    m_client->setSupervisorRules(rules);
    open(u"sim:simplebgc"_s);
    QVERIFY(isStabilising());
    QVERIFY(boardGoesOn(*m_client, 1.5));
    constexpr int kRollP = 0;
    constexpr int kRollD = 6;
    for (const auto &[variable, value] : {std::pair(kRollP, 255.0), {kRollD, 3.0}}) {
        const auto done = ask<bool>([variable, value](Channel &channel, Device &device) -> Result<bool> {
            const auto written = device.live()->writeAdjustables(channel, {{variable, value}});
            return written ? Result<bool>(true) : tl::unexpected(written.error());
        });
        QVERIFY(done);
    }
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().change.has_value());
    QTRY_VERIFY(m_reports.last().isOver);
    for (const AlarmReport &report : m_reports)
        QVERIFY(report.outcome != AlarmOutcome::GoesOn);
    QVERIFY(m_reports.last().wasSeenToEnd);
    QCOMPARE(m_reports.last().outcome, AlarmOutcome::Done);
}

SteeringSetpoint TestSupervision::whereItIs()
{
    const Steering *steering = m_client->device()->steering();
    const auto modes = steering->modes();
    const auto byAngle = std::find_if(modes.begin(), modes.end(), std::mem_fn(&SteeringMode::isPositional));
    if (byAngle == modes.end() || byAngle->inputOf(Axis::Pitch) < 0)
        qFatal("pitch cannot be steered by angle");
    m_pitch = byAngle->inputOf(Axis::Pitch);
    SteeringSetpoint wanted
        = steering->holdingSetpoint(byAngle->id, *m_client->telemetry(), SteeredBefore::Never);
    for (double &input : wanted.inputs)
        input = std::isnan(input) ? 0.0 : input;
    return wanted;
}

void TestSupervision::newStreamsAreNoSilence_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("streams") << u"sim:simplebgc"_s;
    QTest::newRow("asked for") << u"sim:simplebgc?firmware=2.40"_s;
    QTest::newRow("slow line") << u"sim:simplebgc?rate=9600"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

// Another page wants other channels while the gimbal is steered.
void TestSupervision::newStreamsAreNoSilence()
{
    QFETCH(QString, address);
    open(address);
    QVERIFY(isStabilising());
    const SteeringSetpoint wanted = whereItIs();
    QTimer repeat;
    connect(&repeat, &QTimer::timeout, this, [&] { m_client->setControl(wanted); });
    repeat.start(50);
    // Where the machine stood still, data were late indeed, and not only this thread may have stood still;
    // new streams that count as silence do so each time.
    for (int attempt = 1;; ++attempt) {
        m_reports.clear();
        for (int i = 0; i < 8; ++i) {
            const std::array<int, 3> &more = i % 2 ? m_client->roles().motorPower : m_client->roles().gyro;
            m_client->subscribe({.channels = ChannelRoles::present({m_client->roles().angle, more}),
                                 .rate = i % 4 < 2 ? 10.0 : 100.0});
            QVERIFY(boardGoesOn(*m_client, 0.8));
        }
        if (m_reports.isEmpty() || attempt == 3)
            break;
    }
    m_client->releaseControl();
    QVERIFY2(m_reports.isEmpty(), qPrintable(QString::number(int(m_reports.value(0).alarm.kind))));
}

// Its stop is told of by the link, which ends after it: with the sanitizers, what came then hit freed memory.
void TestSupervision::stopMayBeOpenAtTheEnd()
{
    open(u"sim:simplebgc"_s);
    QVERIFY(boardGoesOn(*m_client, 1.5));
    QVERIFY(m_links.changeWorld(m_address, u"runs-on=1"_s));
    QVERIFY(m_links.changeWorld(m_address, u"swapped-axes=1"_s));
    QTRY_VERIFY(!m_reports.isEmpty() && m_reports.last().action == AlarmAction::MotorsOff);
    QVERIFY(m_reports.last().outcome != AlarmOutcome::Done);
    m_client->shutDown();
}

void TestSupervision::steeredBoardsAreWatched_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("fault");
    QTest::addColumn<AlarmKind>("kind");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QTest::addRow("%s, swapped", qPrintable(family))
            << u"sim:"_s + family << u"swapped-axes=1"_s << AlarmKind::Runaway;
        QTest::addRow("%s, blocked", qPrintable(family))
            << u"sim:"_s + family << u"blocked=2"_s << AlarmKind::Saturation;
        QTest::addRow("%s, frozen data", qPrintable(family))
            << u"sim:"_s + family << u"frozen=1"_s << AlarmKind::Stale;
    }
    QTest::addRow("simplebgc without streams, frozen data")
        << u"sim:simplebgc?firmware=2.40"_s << u"frozen=1"_s << AlarmKind::Stale;
}

// While this program steers, a board without targets is judged by what it is steered to.
void TestSupervision::steeredBoardsAreWatched()
{
    QFETCH(QString, address);
    QFETCH(QString, fault);
    QFETCH(AlarmKind, kind);
    open(address);
    QVERIFY(isStabilising());
    SteeringSetpoint wanted = whereItIs();
    QTimer repeat;
    connect(&repeat, &QTimer::timeout, this, [&] { m_client->setControl(wanted); });
    repeat.start(50);
    QVERIFY(boardGoesOn(*m_client, 2));
    QVERIFY(m_reports.isEmpty());
    QVERIFY(m_links.changeWorld(m_address, fault));
    if (kind == AlarmKind::Saturation)
        wanted.inputs[std::size_t(m_pitch)] += 18;
    QTRY_VERIFY(!m_reports.isEmpty());
    QCOMPARE(m_reports.first().alarm.kind, kind);
    if (kind == AlarmKind::Saturation)
        QCOMPARE(m_reports.first().alarm.axis, Axis::Pitch);
    m_client->releaseControl();
}

void TestSupervision::whatIsNotWatchedIsNamed_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<bool>("targets");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s << true;
    QTest::newRow("STorM32") << u"sim:storm32"_s << false;
}

void TestSupervision::whatIsNotWatchedIsNamed()
{
    QFETCH(QString, address);
    QFETCH(bool, targets);
    open(address);
    QSignalSpy changed(m_client.get(), &DeviceClient::unwatchedChanged);
    QVERIFY(changed.count() > 0 || changed.wait(kPatience));
    const auto isNamed = [this](AlarmKind kind) {
        const auto &list = m_client->unwatched();
        return std::any_of(list.begin(), list.end(),
                           [kind](const Unwatched &each) { return each.kind == kind; });
    };
    QVERIFY(!isNamed(AlarmKind::Runaway) && !isNamed(AlarmKind::Sensor) && !isNamed(AlarmKind::Battery));
    QCOMPARE(isNamed(AlarmKind::Saturation), !targets);
    QCOMPARE(isNamed(AlarmKind::Limit), !targets);
    QVERIFY(isNamed(AlarmKind::Heat));  // of the motors at least
    // Of a board that is gone, nothing is said.
    m_client->disconnectFromBoard();
    QTRY_VERIFY(m_client->unwatched().empty());
}

QTEST_GUILESS_MAIN(TestSupervision)
#include "tst_supervision.moc"
