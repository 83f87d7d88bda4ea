// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/connector.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/toyfamily/toyboard.h"
#include "tests/support/toyfamily/toydevice.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using toy::Command;

namespace {

constexpr double kHuge = 4294967295.0;

/// The toy in virtual time, with its telemetry running.
class ToyRig
{
public:
    explicit ToyRig(const QMap<QString, int> &options = {}, const Faults &faults = {})
        : m_port(makePort(options, faults))
        , channel(*m_port, toyFamily().makeFramer(), toyFamily().timing)
    {
        channel.setTap([this](const FrameView &frame, TimePoint at) {
            if (m_plan.decoder)
                m_plan.decoder->decode(frame, at, *store);
        });
        channel.setLatestValues(store);
    }

    Result<BoardIdentity> identify() { return device.identify(channel); }
    Configuration read()
    {
        const auto configuration = device.readConfiguration(channel);
        return configuration ? *configuration : Configuration();
    }
    /// Lets time pass while telemetry is asked for, as the session does.
    void run(milliseconds time)
    {
        if (!m_plan.decoder)
            m_plan = *device.subscribe(channel, {}, {});
        const TimePoint end = channel.now() + time;
        while (channel.now() < end) {
            std::ignore = channel.transact(*m_plan.poll);
            std::ignore = channel.sleep(m_plan.pollInterval);
        }
    }
    /// Steers for so long.
    void steer(const SteeringSetpoint &setpoint, milliseconds time)
    {
        const TimePoint end = channel.now() + time;
        while (channel.now() < end) {
            channel.steer(device.controlFrames(setpoint));
            run(50ms);
        }
    }
    ToyBoard &board() { return static_cast<ToyBoard &>(m_port->board()); }
    BoardHistory history() const { return BoardHistory(m_dir.filePath(u"history"_s)); }

private:
    static std::unique_ptr<SimulatedPort> makePort(const QMap<QString, int> &own, const Faults &faults)
    {
        SimulatorOptions options;
        options.own = own;
        options.faults = faults;
        return std::make_unique<SimulatedPort>(std::make_unique<ToyBoard>(options), options,
                                               std::optional<LineSettings>());
    }

    std::unique_ptr<SimulatedPort> m_port;
    TelemetryPlan m_plan;
    QTemporaryDir m_dir;

public:
    std::shared_ptr<TelemetryStore> store
        = std::make_shared<TelemetryStore>(int(toy::channels().size()), TimePoint() + 1h);
    VirtualChannel channel;
    ToyDevice device;
};

WriteOptions options(const BoardHistory &history)
{
    WriteOptions write;
    write.history = &history;
    return write;
}

const SteeringSetpoint kFly{1, {30, 10, 0.5}, {1}};

}  // namespace

/// A family unlike ours, on the floors below the screen, in virtual time.
class TestToyDevice : public QObject
{
    Q_OBJECT
private slots:
    void isFoundAndIdentified();
    void saysNothingWithoutHeartbeat();
    void frameInHalvesOfTwoPacketsIsNone();
    void valuesAreReadExactly();
    void floatsAreWrittenExactly();
    void noNumberIsKept();
    void documentIsWrittenThroughARestart();
    void documentThatDidNotArriveIsToldAndPutBack();
    void boardThatDoesNotComeBackIsTold();
    void valuesComeBeforeTheRestart();
    void telemetryHasValuesAndArrays();
    void rolesOfTwoAxesAndFiveMotors();
    void steersWithNamedInputs();
    void stopIsRepeatedUntilProven();
    void stopPlan_data();
    void stopPlan();
    void conditionsOfActions();
    void deafnessIsNoLoss();
    void silenceIsLoss();
};

void TestToyDevice::isFoundAndIdentified()
{
    ToyRig rig;
    const auto address = LinkAddress::parse(u"udp://127.0.0.1:1"_s);
    const QList<Family> known{toyFamily()};
    const auto found = findBoard(rig.channel, known.first(), rig.device, known, *address);
    QVERIFY(found);
    QCOMPARE(found->identity.model, u"Toy with five motors"_s);
    QCOMPARE(found->identity.serial, u"f00d0001"_s);
    QVERIFY(!found->line);
    QCOMPARE(rig.device.parameters()->all().size(), 7U);
}

void TestToyDevice::saysNothingWithoutHeartbeat()
{
    ToyRig rig;
    VirtualChannel &spoken = rig.channel;
    QVERIFY(rig.identify());
    QVERIFY(rig.board().heard(Command::Heartbeat) > 0);
    SimulatorOptions options;
    SimulatedPort port(std::make_unique<ToyBoard>(options), options, {});
    LinkTiming mute = toyFamily().timing;
    mute.heartbeat = {};
    VirtualChannel silent(port, toyFamily().makeFramer(), mute);
    ToyDevice device;
    const auto answer = device.probe(silent);
    QVERIFY(answer && !*answer);
    QVERIFY(!spoken.cancelled());
}

void TestToyDevice::frameInHalvesOfTwoPacketsIsNone()
{
    toy::ToyFramer framer;
    int frames = 0;
    const FrameSink sink = [&frames](const FrameView &) { ++frames; };
    const QByteArray frame = toy::encode(Command::Blink, "ab");
    framer.feed(asBytes(QByteArrayView(frame).first(6)), sink);
    framer.packetEnded(sink);
    framer.feed(asBytes(QByteArrayView(frame).sliced(6)), sink);
    framer.packetEnded(sink);
    QCOMPARE(frames, 0);
    framer.feed(asBytes(frame + frame), sink);
    framer.packetEnded(sink);
    QCOMPARE(frames, 2);
}

void TestToyDevice::valuesAreReadExactly()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    const Configuration read = rig.read();
    const auto raw = [&read](const char *key) {
        return read.raw(*read.parameters().find(QLatin1String(key)), 0).value();
    };
    QCOMPARE(raw("rate.gain"), double(2e-6F));
    QCOMPARE(read.parameters().find(u"rate.gain"_s)->format(raw("rate.gain")), u"2e-06"_s);
    QVERIFY(std::isnan(raw("hover.trim")));
    QCOMPARE(raw("flight.limit"), 4e9);
    QCOMPARE(raw("home.height"), -430000.0);
    QCOMPARE(raw("lights"), 3.0);
    QCOMPARE(read.block({0, toy::Mission}), QByteArray("-- nothing yet\n"));
}

void TestToyDevice::floatsAreWrittenExactly()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    const Configuration base = rig.read();
    const ParameterSet &set = base.parameters();
    Configuration edited = base;
    QVERIFY(edited.setRaw(*set.find(u"rate.gain"_s), 0, double(3.25e-6F)));
    QVERIFY(edited.setRaw(*set.find(u"flight.limit"_s), 0, kHuge));
    QVERIFY(edited.setRaw(*set.find(u"home.height"_s), 0, -2147483648.0));
    const BoardHistory history = rig.history();
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, options(history));
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->lines.size(), 3U);
    QCOMPARE(rig.board().block(toy::Settings).first(4), toy::pack([](QDataStream &out) { out << 3.25e-6F; }));
    QCOMPARE(rig.board().block(toy::Settings), edited.block({0, toy::Settings}));
    QCOMPARE(rig.board().restarts(), 0);
}

void TestToyDevice::noNumberIsKept()
{
    ToyRig rig;
    // A quiet NaN with a payload of its own, which no arithmetic would give back.
    QByteArray settings = toy::defaultSettings();
    settings.replace(4, 4, QByteArray::fromHex("7fc01234"));
    rig.board().setBlock(toy::Settings, settings);
    QVERIFY(rig.identify());
    const Configuration base = rig.read();
    const ParameterSpec &trim = *base.parameters().find(u"hover.trim"_s);
    Configuration edited = base;
    QVERIFY(!edited.setRaw(trim, 0, std::nan("")));
    QVERIFY(edited.setRaw(*base.parameters().find(u"esc.protocol"_s), 0, 2));
    const BoardHistory history = rig.history();
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, options(history));
    QVERIFY(report && report->isComplete());
    QCOMPARE(rig.board().block(toy::Settings).mid(4, 4), QByteArray::fromHex("7fc01234"));
}

void TestToyDevice::documentIsWrittenThroughARestart()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    const Configuration base = rig.read();
    Configuration edited = base;
    const QByteArray text = "climb(10)\nturn(90)\nland() -- über den Bäumen\n";
    edited.setBlock({0, toy::Mission}, text);
    const TimePoint begun = rig.channel.now();
    const BoardHistory history = rig.history();
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, options(history));
    QVERIFY(report);
    QVERIFY2(report->isComplete(), report->error ? qPrintable(report->error->detail) : "");
    QCOMPARE(rig.board().restarts(), 1);
    QCOMPARE(report->data.size(), 1U);
    QCOMPARE(report->data.front().state, WriteState::Verified);
    QCOMPARE(report->onBoard.block({0, toy::Mission}), text);
    QVERIFY(rig.channel.now() - begun > 1500ms);  // its absence was waited for
}

void TestToyDevice::documentThatDidNotArriveIsToldAndPutBack()
{
    /// Writes more than it was told to.
    class Careless final : public ToyDevice
    {
    public:
        Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override
        {
            const bool once = std::exchange(m_once, false);
            return ToyDevice::writeBlock(channel, key, once ? bytes + "rubbish" : bytes);
        }

    private:
        bool m_once = true;
    };
    ToyRig rig;
    Careless device;
    QVERIFY(device.identify(rig.channel));
    const auto base = device.readConfiguration(rig.channel);
    QVERIFY(base);
    Configuration edited = *base;
    edited.setBlock({0, toy::Mission}, "land()\n");
    const BoardHistory history = rig.history();
    const auto report = writeConfiguration(rig.channel, device, *base, edited, options(history));
    QVERIFY(report && report->error);
    QCOMPARE(report->error->code, ErrorCode::VerifyFailed);
    QCOMPARE(report->data.front().state, WriteState::Mismatch);
    QCOMPARE(rig.board().block(toy::Mission), base->block({0, toy::Mission}));
    QCOMPARE(rig.board().restarts(), 2);
}

void TestToyDevice::boardThatDoesNotComeBackIsTold()
{
    Faults faults;
    faults.unplugAfter = 2;
    faults.replugAfter = -1;
    ToyRig rig({}, faults);
    QVERIFY(rig.identify());
    const Configuration base = rig.read();
    Configuration edited = base;
    edited.setBlock({0, toy::Mission}, "land()\n");
    const BoardHistory history = rig.history();
    QVERIFY(rig.channel.now() - TimePoint() - 1h < 500ms);
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, options(history));
    QVERIFY(report && report->error);
    QVERIFY(report->error->code == ErrorCode::Timeout || report->error->code == ErrorCode::LinkClosed);
    QCOMPARE(report->data.front().state, WriteState::Unknown);
}

void TestToyDevice::valuesComeBeforeTheRestart()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    const Configuration base = rig.read();
    Configuration edited = base;
    edited.setBlock({0, toy::Mission}, "land()\n");
    QVERIFY(edited.setRaw(*base.parameters().find(u"log.enabled"_s), 0, 1));
    const BoardHistory history = rig.history();
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, options(history));
    QVERIFY(report && report->isComplete());
    QCOMPARE(rig.board().restarts(), 1);
    QStringList written;
    for (const Progress &progress : rig.channel.progressReports()) {
        if (progress.step == u"write-block"_s)
            written.append(progress.subject);
    }
    QCOMPARE(written, (QStringList{u"SETTINGS"_s, u"MISSION"_s}));
}

void TestToyDevice::telemetryHasValuesAndArrays()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    rig.run(500ms);
    QCOMPARE(rig.store->latest(toy::Pitch), 5.0F);
    QCOMPARE(rig.store->latest(toy::Outputs), 0.0F);
    QCOMPARE(rig.store->latest(toy::Battery), 12.6F);
    const ArraySample spectrum = rig.store->latestArray(toy::Spectrum);
    QCOMPARE(spectrum.values->size(), std::size_t(toy::kSpectrumBins));
    QCOMPARE(spectrum.values->at(64), -10.0F);
    QVERIFY(rig.store->arraysAfter(toy::Spectrum, 0).size() > 1);
}

void TestToyDevice::rolesOfTwoAxesAndFiveMotors()
{
    ToyRig rig;
    const ChannelRoles roles = rolesOf(rig.device);
    QCOMPARE(roles.angle, (std::array{-1, int(toy::Pitch), int(toy::Yaw)}));
    QCOMPARE(roles.gyro, (std::array{-1, int(toy::PitchRate), int(toy::YawRate)}));
    QCOMPARE(roles.motors, (QList<int>{toy::Motor1, toy::Motor2, toy::Motor3, toy::Motor4, toy::Motor5}));
    QCOMPARE(roles.motorPower, (std::array{-1, -1, -1}));
    QCOMPARE(roles.armed, int(toy::Armed));
    QCOMPARE(roles.calibrated, int(toy::Calibrated));
    QCOMPARE(roles.outputs, int(toy::Outputs));
}

void TestToyDevice::steersWithNamedInputs()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    rig.run(100ms);
    const float yaw = rig.store->latest(toy::Yaw);
    rig.steer(kFly, 1s);
    QCOMPARE(rig.store->latest(toy::Armed), 1.0F);
    QCOMPARE(rig.store->latest(toy::YawRate), 30.0F);
    QCOMPARE(rig.store->latest(toy::PitchRate), 10.0F);
    QCOMPARE(rig.store->latest(toy::Motor1), 55.0F);
    QVERIFY(rig.store->latest(toy::Yaw) - yaw > 25);
    // Beyond its range an input is at its end; what nobody has told is in its centre.
    rig.steer({1, {500, std::nan(""), 2}, {1}}, 200ms);
    QCOMPARE(rig.board().control(), (std::array{90.0F, 0.0F, 1.0F}));
    rig.channel.releaseControl();
    rig.run(500ms);
    QVERIFY(!rig.board().areOutputsOn());
    QCOMPARE(rig.board().heard(Command::Release), ControlStream::kReleases);
    // Arming alone moves nothing.
    rig.steer(rig.device.holdingSetpoint(1, *rig.store, SteeredBefore::Unknown), 200ms);
    QCOMPARE(rig.board().control(), (std::array{0.0F, 0.0F, 0.0F}));
    QVERIFY(!rig.board().areOutputsOn());
}

void TestToyDevice::stopIsRepeatedUntilProven()
{
    ToyRig rig({{u"deaf-halt"_s, 4}});
    QVERIFY(rig.identify());
    rig.steer(kFly, 500ms);
    QVERIFY(rig.board().areOutputsOn());
    // Nobody refreshes the set-points: the dead-man rule.
    rig.run(400ms);
    QVERIFY(rig.board().areOutputsOn());
    rig.run(1000ms);
    QVERIFY(!rig.board().areOutputsOn());
    QVERIFY2(rig.board().heard(Command::Halt) >= 5,
             qPrintable(QString::number(rig.board().heard(Command::Halt))));
    QCOMPARE(rig.board().heard(Command::Release), ControlStream::kReleases);
}

void TestToyDevice::stopPlan_data()
{
    QTest::addColumn<int>("deaf");
    QTest::addColumn<bool>("proven");
    QTest::addColumn<int>("firstMeans");
    QTest::addColumn<int>("secondMeans");
    QTest::newRow("obeys") << 0 << true << 1 << 0;
    QTest::newRow("deaf to the first means") << 1 << true << 3 << 1;
    QTest::newRow("deaf to both") << 2 << false << 3 << 3;
}

void TestToyDevice::stopPlan()
{
    QFETCH(const int, deaf);
    QFETCH(const bool, proven);
    ToyRig rig({{u"deaf-stop"_s, deaf}});
    QVERIFY(rig.identify());
    rig.steer(kFly, 500ms);
    QVERIFY(rig.board().areOutputsOn());
    rig.channel.stopMotors(rig.device.stopPlan());
    rig.run(50ms);
    if (deaf > 0)
        QVERIFY(!rig.channel.stopResult());  // it has answered, and that proves nothing
    rig.run(1500ms);
    QVERIFY(rig.channel.stopResult());
    QCOMPARE(rig.channel.stopResult()->has_value(), proven);
    QCOMPARE(rig.board().areOutputsOn(), !proven);
    QTEST(rig.board().heard(Command::MotorsOff), "firstMeans");
    QTEST(rig.board().heard(Command::Kill), "secondMeans");
    if (!proven) {
        QCOMPARE(rig.channel.stopResult()->error().code, ErrorCode::NotProven);
        return;
    }
    // What the second means locked can be used again.
    QCOMPARE(rig.board().heard(Command::Unlock), 1);
    QVERIFY(!rig.board().isLocked());
    rig.steer(kFly, 200ms);
    QVERIFY(rig.board().areOutputsOn());
}

void TestToyDevice::conditionsOfActions()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    const BoardHistory history = rig.history();
    const auto perform = [&](const QString &key) {
        return performSafely(rig.channel, rig.device, key, {}, history, {}, rig.store.get());
    };
    // Nothing tells it: refused.
    auto done = performSafely(rig.channel, rig.device, u"calibrate.level"_s, {}, history, {}, nullptr);
    QVERIFY(!done && done.error().code == ErrorCode::ConditionUnmet);
    rig.run(100ms);
    done = perform(u"home"_s);
    QVERIFY(!done && done.error().detail.contains(u"not calibrated"_s));
    rig.steer(kFly, 200ms);
    done = perform(u"calibrate.level"_s);
    QVERIFY(!done && done.error().detail.contains(u"armed"_s));
    QCOMPARE(rig.board().heard(Command::Level), 0);
    rig.channel.releaseControl();
    rig.run(500ms);
    done = perform(u"calibrate.level"_s);
    QVERIFY(done);
    QVERIFY(QFile::exists(done->snapshotPath));
    rig.run(4s);
    QVERIFY(perform(u"home"_s));
    // What was told long ago tells nothing of now.
    QVERIFY(rig.channel.sleep(500ms));
    QVERIFY(perform(u"home"_s));
    rig.channel.expectSilence(5s);
    QVERIFY(rig.channel.sleep(3s));
    done = perform(u"home"_s);
    QVERIFY(!done && done.error().code == ErrorCode::ConditionUnmet);
}

void TestToyDevice::deafnessIsNoLoss()
{
    ToyRig rig;
    QVERIFY(rig.identify());
    rig.run(200ms);
    const BoardHistory history = rig.history();
    QVERIFY(performSafely(rig.channel, rig.device, u"calibrate.level"_s, {}, history, {}, rig.store.get()));
    const TimePoint begun = rig.channel.now();
    rig.run(1500ms);  // longer than the silence limit
    Request once = toy::request(Command::Identify);
    once.retries = 0;
    const auto deaf = rig.channel.transact(once);
    QVERIFY(!deaf);
    QCOMPARE(deaf.error().code, ErrorCode::Timeout);
    rig.run(2s);
    QVERIFY(rig.channel.transact(toy::request(Command::Identify)));
    QVERIFY(rig.channel.now() - begun > 3500ms);
}

void TestToyDevice::silenceIsLoss()
{
    Faults faults;
    faults.unplugAfter = 1;
    faults.replugAfter = -1;
    ToyRig rig({}, faults);
    QVERIFY(rig.identify());
    rig.run(1s);
    const auto slept = rig.channel.sleep(3s);
    QVERIFY(!slept);
    QCOMPARE(slept.error().code, ErrorCode::LinkClosed);
    QVERIFY(rig.channel.now() - TimePoint() - 1h < 2500ms);
}

QTEST_GUILESS_MAIN(TestToyDevice)
#include "tst_toydevice.moc"
