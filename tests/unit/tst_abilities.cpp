// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "protocol/device/abilities.h"
#include "protocol/device/bearings.h"
#include "protocol/device/motorlayout.h"
#include "protocol/device/steering.h"
#include "protocol/session/stopplan.h"
#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/supervisor/boardlimits.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/toyfamily/toyboard.h"
#include "tests/support/toyfamily/toydevice.h"

#include <QTemporaryFile>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

/// A board of a family, found on a link.
struct Board
{
    explicit Board(const QString &key)
    {
        QList<Family> families = allFamilies();
        QList<SimulatedFamily> simulated = allSimulatedFamilies();
        families.append(toyFamily());
        simulated.append(simulatedToy());
        const auto is = [&key](const auto &each) { return each.key == key; };
        const Family family = *std::find_if(families.begin(), families.end(), is);
        port = std::make_unique<SimulatedPort>(
            std::find_if(simulated.begin(), simulated.end(), is)->makeBoard({}), SimulatorOptions(),
            std::optional<LineSettings>());
        channel = std::make_unique<VirtualChannel>(*port, family.makeFramer(), family.timing);
        device = family.makeDevice();
        found = findBoard(*channel, family, *device, families, *LinkAddress::parse(u"sim:"_s + key))
                    .has_value();
    }

    std::unique_ptr<SimulatedPort> port;
    std::unique_ptr<VirtualChannel> channel;
    std::unique_ptr<Device> device;
    bool found = false;
};

/// A board that takes everything and says nothing more.
class MuteChannel final : public Channel
{
public:
    explicit MuteChannel(Channel &channel)
        : m_channel(channel)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        return request.answer ? failure(ErrorCode::Timeout, request.name) : Result<Frame>(Frame());
    }
    void post(const Request &) override { }
    Result<void> sleep(milliseconds duration) override { return m_channel.sleep(duration); }
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)>) override
    {
        return m_channel.listen([](const FrameView &) { return false; });
    }
    Result<void> setLine(const LineSettings &line) override { return m_channel.setLine(line); }
    void steer(const ControlFrames &) override { }
    void releaseControl() override { }
    void stopMotors(const StopPlan &) override { }
    void expectSilence(milliseconds duration) override { m_channel.expectSilence(duration); }
    [[nodiscard]] bool cancelled() const override { return false; }
    void progress(const Progress &) override { }
    [[nodiscard]] TimePoint now() const override { return m_channel.now(); }
    [[nodiscard]] LinkObservation observation() const override { return m_channel.observation(); }

private:
    Channel &m_channel;
};

/// Arguments that the action takes: its defaults, otherwise the lowest.
/// One that can be read: what it is told to send by it is no reason to fail.
QString someFile()
{
    static QTemporaryFile file;
    if (file.open()) {
        file.write("time,acc.x,acc.y,acc.z,roll,pitch\n0,0,0,1,0,0\n");
        file.close();
    }
    return file.fileName();
}

QMap<QString, QString> someArguments(const ActionSpec &action)
{
    QMap<QString, QString> texts;
    for (const ArgumentSpec &argument : action.arguments) {
        if (*argument.defaultText)
            continue;
        if (qstrcmp(argument.key, "file") == 0)
            texts.insert(u"file"_s, someFile());
        else
            texts.insert(QLatin1String(argument.key),
                         argument.kind == ArgumentKind::Choice
                             ? QString::fromUtf8(argument.choices.front().name)
                             : QString::number(argument.min, 'f', 3).remove(u".000"_s));
    }
    return texts;
}

}  // namespace

/// What a device hands out answers with something: nothing is overridden only to return nothing.
class TestAbilities : public QObject
{
    Q_OBJECT
private slots:
    void everyBoardHas_data() { families(); }
    void everyBoardHas();
    void whatIsHandedOutAnswers_data() { families(); }
    void whatIsHandedOutAnswers();
    void steeringAnswers_data() { families(); }
    void steeringAnswers();
    void eachAbilityIsAbsentSomewhere();
    void nothingIsDoneOnASilentBoard_data() { families(); }
    void nothingIsDoneOnASilentBoard();

private:
    static void families()
    {
        QTest::addColumn<QString>("family");
        for (const Family &family : allFamilies())
            QTest::newRow(qPrintable(family.key)) << family.key;
        QTest::newRow("toy") << u"toy"_s;
    }
    /// The names of what a device hands out.
    static QSet<QByteArray> abilities(Device &device)
    {
        QSet<QByteArray> names;
        const auto add = [&names](const char *name, bool there) {
            if (there)
                names.insert(name);
        };
        add("profiles", device.profiles());
        add("write bracket", device.writeBracket());
        add("live values", device.live());
        add("inner variables", device.innerVariables());
        add("streams", device.streamControl());
        add("motor switch", device.motorSwitch());
        add("frame inspector", device.inspector());
        add("fault words", device.faultWords());
        add("bearings", device.bearings());
        add("status words", device.statusWords());
        add("notch filters", device.notchFilters());
        add("gain shape", device.gainShape() != nullptr);
        add("restart notice", device.restartNotice());
        add("motor layout", device.motorLayout());
        return names;
    }
};

void TestAbilities::everyBoardHas()
{
    QFETCH(const QString, family);
    const Board board(family);
    QVERIFY(board.found);
    QVERIFY(!board.device->channels().empty());
    QVERIFY(!board.device->actions().empty());
    QVERIFY(!board.device->parameters()->all().empty());
    const StopPlan plan = board.device->stopPlan();
    QVERIFY(!plan.means.empty());
    QVERIFY(plan.fromAnswer || plan.fromTelemetry);
    for (const StopPlan::Means &means : plan.means)
        QVERIFY(!means.requests.empty() && means.maxRounds > 0);
    QVERIFY(board.device->replayDecoder());
    const auto configuration = board.device->readConfiguration(*board.channel);
    QVERIFY(configuration && !configuration->isEmpty());
    const auto arranged = board.device->subscribe(*board.channel, {}, {});
    QVERIFY(arranged && arranged->decoder);
    QVERIFY(arranged->streaming || arranged->poll);
}

void TestAbilities::whatIsHandedOutAnswers()
{
    QFETCH(const QString, family);
    const Board board(family);
    QVERIFY(board.found);
    Device &device = *board.device;
    Channel &channel = *board.channel;
    if (ProfileAccess *profiles = device.profiles()) {
        QVERIFY(device.identity().profileCount > 1);
        QVERIFY(profiles->activeProfile(channel));
        QVERIFY(profiles->readProfileNames(channel));
        QVERIFY(profiles->profileNameBytes() > 0);
    } else {
        QCOMPARE(device.identity().profileCount, 1);
    }
    if (LiveAccess *live = device.live()) {
        QVERIFY(!live->adjustables().empty());
        const auto values = live->readAdjustables(channel, {live->adjustables().front().id});
        QVERIFY(values && values->size() == 1);
        QVERIFY(!live->storeAction().isEmpty());
    }
    if (InnerVariables *variables = device.innerVariables()) {
        const auto names = variables->debugVariables(channel);
        QVERIFY(names && !names->empty());
    }
    if (const StreamControl *streams = device.streamControl()) {
        QVERIFY(!streams->streams().isEmpty());
        QVERIFY(!streams->fastChannels().isEmpty());
    }
    if (const MotorSwitch *motors = device.motorSwitch())
        QVERIFY(motors->switchMotorsOn(channel));
    if (const FrameInspector *inspector = device.inspector())
        QVERIFY(!inspector->commandNames().isEmpty());
    if (const FaultWords *words = device.faultWords()) {
        QVERIFY(rolesOf(device).faults >= 0);
        bool any = false;
        for (unsigned bit = 0; bit < 32; ++bit)
            any |= !words->faults(1U << bit, 0).empty();
        QVERIFY(any);
    }
    if (const Bearings *bearings = device.bearings()) {
        const auto active = device.readConfiguration(channel);
        QVERIFY(active);
        const auto nothing = [](int) { return qQNaN(); };
        const auto something = [](int) { return 65535.0; };
        for (const Axis axis : kAxes) {
            const AxisBearing bearing = bearings->bearing(axis, *active, something);
            QVERIFY(bearing.limits && bearing.limits->first < bearing.limits->second);
            QVERIFY(bearing.follows);
        }
        QVERIFY(bearings->isFrameMeasured(*active, something));
        QVERIFY(bearings->batteryThresholds(*active).alarm);
        SupervisorRules rules;
        setBoardLimits(rules, device, *active);
        QCOMPARE(rules.battery, bearings->batteryThresholds(*active));
        // Nothing is made up.
        const Configuration empty(active->identity(), active->parameterSet());
        QVERIFY(!bearings->bearing(Axis::Roll, empty, nothing).limits);
        QVERIFY(!bearings->bearing(Axis::Roll, empty, nothing).follows);
        QVERIFY(!bearings->isFrameMeasured(empty, nothing));
        QVERIFY(!bearings->batteryThresholds(empty).alarm);
    }
    if (const StatusWords *words = device.statusWords()) {
        QStringList told;
        for (int state = 0; state < 16; ++state)
            told.append(words->statusText(state));
        QVERIFY(!told.join(QString()).isEmpty() || !words->facts([](int) { return 1.0; }).empty());
    }
    if (const NotchFilters *notches = device.notchFilters()) {
        QVERIFY(std::any_of(kAxes.begin(), kAxes.end(),
                            [notches](Axis axis) { return !notches->notchesOf(axis).empty(); }));
    }
    if (const MotorLayout *layout = device.motorLayout()) {
        const auto active = device.readConfiguration(channel);
        QVERIFY(active);
        QCOMPARE(qsizetype(layout->motorShares(*active).size()), 4);
        QVERIFY(layout->motorShares(Configuration(active->identity(), active->parameterSet())).empty());
    }
    if (const auto shape = device.gainShape()) {
        const PidGains gains = shape->gainsFor(50, 50);
        QVERIFY(gains.kp > 0);
    }
}

void TestAbilities::steeringAnswers()
{
    QFETCH(const QString, family);
    const Board board(family);
    QVERIFY(board.found);
    const Steering *steering = board.device->steering();
    if (!steering)
        return;
    QVERIFY(!steering->modes().empty());
    const TelemetryStore nothing(int(board.device->channels().size()));
    for (const SteeringMode &mode : steering->modes()) {
        QVERIFY2(!mode.inputs.empty(), mode.key);
        const SteeringSetpoint hold = steering->holdingSetpoint(mode.id, nothing, SteeredBefore::Never);
        QCOMPARE(hold.mode, mode.id);
        QCOMPARE(hold.inputs.size(), mode.inputs.size());
        SteeringSetpoint centre{mode.id, {}, hold.switches};
        for (const SteeringInput &input : mode.inputs) {
            QVERIFY2(input.min < input.max && input.centre >= input.min && input.centre <= input.max,
                     input.key);
            centre.inputs.push_back(input.centre);
        }
        const ControlFrames frames = steering->controlFrames(centre);
        QVERIFY2(!frames.setpoint.isEmpty() && !frames.stop.isEmpty(), mode.key);
    }
}

// What all boards have belongs to the core.
void TestAbilities::eachAbilityIsAbsentSomewhere()
{
    const Board toy(u"toy"_s);
    QVERIFY(toy.found);
    QVERIFY(abilities(*toy.device).isEmpty());
    QSet<QByteArray> seen;
    for (const Family &family : allFamilies()) {
        const Board board(family.key);
        QVERIFY(board.found);
        seen += abilities(*board.device);
    }
    if (allFamilies().size() > 1)
        QCOMPARE(seen.size(), 14);  // and each is there somewhere
}

// Where a board says nothing, an action fails, or it is one that no board answers.
void TestAbilities::nothingIsDoneOnASilentBoard()
{
    QFETCH(const QString, family);
    Board board(family);
    QVERIFY(board.found);
    MuteChannel mute(*board.channel);
    for (const ActionSpec &action : board.device->actions()) {
        const auto arguments = parseArguments(action, someArguments(action));
        QVERIFY2(arguments, action.key);
        const auto done = board.device->perform(mute, QString::fromLatin1(action.key), *arguments);
        QVERIFY2(done.has_value() == !action.answered, action.key);
    }
}

QTEST_GUILESS_MAIN(TestAbilities)
#include "tst_abilities.moc"
