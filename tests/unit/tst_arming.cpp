// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/arming.h"
#include "protocol/procedure/directioncheck.h"
#include "protocol/session/controlstream.h"
#include "protocol/supervisor/supervisor.h"
#include "tests/support/dronerig.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;
using Bar = ArmingBar;
using Phase = ArmingSession::Phase;
using Send = ArmingSession::Send;
using Drone = bcflight::SimulatedBoard;

namespace {

constexpr TimePoint kStart = TimePoint() + 1h;

/// All is well with a drone that stands on the ground; time goes on with step().
struct Pilot
{
    ArmingSession session;
    ArmingSession::Known known{.isLinked = true,
                               .isArmed = false,
                               .isCalibrated = true,
                               .isCalibrating = false,
                               .isDriven = false,
                               .isChecked = true};
    ArmingSession::Sticks sticks;
    TimePoint now = kStart;
    bool isHeard = true;
    bool isFresh = true;  // the sticks
    Send sent = Send::Nothing;

    Bar bar()
    {
        tell();
        return session.bar(known, sticks, now);
    }
    void tell()
    {
        if (isHeard)
            known.heardAt = known.toldAt = now;
        if (isFresh)
            sticks.at = now;
    }
    Send step(milliseconds time = 20ms)
    {
        now += time;
        tell();
        return sent = session.step(known, sticks, now);
    }
    void steps(milliseconds time)
    {
        for (const TimePoint until = now + time; now < until;)
            step();
    }
    /// Opened, the key held, armed and confirmed.
    bool arm()
    {
        session.open(false);
        session.press(now);
        steps(ArmingSession::kHold + 40ms);
        known.isArmed = true;
        step();
        return session.phase() == Phase::Armed && sent == Send::Armed;
    }
};

using Change = void (*)(Pilot &);

/// A simulated drone that is steered in virtual time.
struct Flown : DroneRig
{
    explicit Flown(bcflight::Generation generation = bcflight::Generation::G)
        : DroneRig(droneOptions(generation, {{QLatin1String(Drone::kStand), 1}}))
    {
    }
    Drone &board() { return static_cast<Drone &>(port.board()); }
    ControlFrames frames(double throttle, bool isArmed, std::optional<TimePoint> begun = {})
    {
        SteeringSetpoint wanted{1, {throttle, 0, 0, 0}, {isArmed ? 1 : 0}};
        wanted.begun = begun;
        return device.steering()->controlFrames(wanted);
    }
    /// Steers for so long, refreshed as a page does.
    void steer(double throttle, bool isArmed, milliseconds time, std::optional<TimePoint> begun = {})
    {
        for (const TimePoint until = channel.now() + time; channel.now() < until;) {
            channel.steer(frames(throttle, isArmed, begun));
            std::ignore = channel.sleep(20ms);
        }
    }
    [[nodiscard]] double output()
    {
        const auto &outputs = board().outputs();
        return outputs.empty() ? 0 : *std::max_element(outputs.begin(), outputs.end());
    }
};

}  // namespace

/// The rules under which something that flies is armed from here (BCFlight errata 9.2).
class TestArming final : public QObject
{
    Q_OBJECT
private slots:
    void nothingIsSentWithoutASession();
    void theKeyIsHeldForASecond();
    void eachConditionKeepsItDisarmed_data();
    void eachConditionKeepsItDisarmed();
    void eachConditionDisarms_data();
    void eachConditionDisarms();
    void standMayHoldItTilted();
    void reArmingTakesANewPress();
    void aDisarmingInBetweenEndsIt();
    void eachSetpointAsksBeforeItArms();
    void itHasToSayThatItIsArmed();
    void oldStateProvesNothing();

    void setpointsAreWhatTheErrataSay();
    void deadManDisarmsAndStops();
    void endIsSentAtFullRate();
    void endIsSentInFullThoughItStands();
    void endedIsNotResumed();
    void stopEndsWhatHadBegun();
    void nothingSteersWhereItIsDangerous_data();
    void nothingSteersWhereItIsDangerous();
    void gainsWaitForTheDisarming();
    void gainsAreSetArmedOnlyInAStand();

    void directionsAreFoundStepByStep();
    void whatTumblesIsNoAnswer();
    void wrongAnswerForbidsFlight();
    void stickIsReversedOnce();
    void answersBindEachOther();
    void whatIsAskedStays();
    void oneLookIsNoAnswer();
    void driftIsNoAnswer();
    void foundIsKept();
    void configurationDecidesWhetherItIsKnown();

    void drivenThoughDisarmedIsAnAlarm();
};

void TestArming::nothingIsSentWithoutASession()
{
    Pilot pilot;
    QCOMPARE(pilot.bar(), Bar::NoPropellerWord);
    pilot.session.press(pilot.now);
    QCOMPARE(pilot.step(), Send::Nothing);
    pilot.session.open(false);
    QCOMPARE(pilot.step(), Send::Nothing);  // opened alone sends nothing either
    QCOMPARE(pilot.bar(), Bar::None);
}

void TestArming::theKeyIsHeldForASecond()
{
    Pilot pilot;
    pilot.session.open(false);
    pilot.session.press(pilot.now);
    pilot.steps(980ms);
    QCOMPARE(pilot.sent, Send::Disarmed);
    pilot.session.release();
    QCOMPARE(pilot.step(), Send::Nothing);
    QCOMPARE(pilot.session.phase(), Phase::Open);
    pilot.session.press(pilot.now);
    pilot.steps(980ms);
    QCOMPARE(pilot.sent, Send::Disarmed);  // the first press does not count
    pilot.steps(40ms);
    QCOMPARE(pilot.sent, Send::Armed);
    QCOMPARE(pilot.session.phase(), Phase::Asked);
}

void TestArming::eachConditionKeepsItDisarmed_data()
{
    QTest::addColumn<int>("wanted");
    QTest::addColumn<Change>("change");
    const auto row
        = [](const char *name, Bar bar, Change change) { QTest::newRow(name) << int(bar) << change; };
    row("no link", Bar::NoLink, [](Pilot &pilot) { pilot.known.isLinked = false; });
    row("silent", Bar::Silent, [](Pilot &pilot) { pilot.isHeard = false; });
    row("state unknown", Bar::NoState, [](Pilot &pilot) { pilot.known.isArmed.reset(); });
    row("not calibrated", Bar::NotCalibrated, [](Pilot &pilot) { pilot.known.isCalibrated = false; });
    row("calibration unknown", Bar::NotCalibrated, [](Pilot &pilot) { pilot.known.isCalibrated.reset(); });
    row("calibrating", Bar::Calibrating, [](Pilot &pilot) { pilot.known.isCalibrating = true; });
    row("armed by another", Bar::ArmedElsewhere, [](Pilot &pilot) { pilot.known.isArmed = true; });
    row("motors turn", Bar::MotorsTurn, [](Pilot &pilot) { pilot.known.isDriven = true; });
    row("unchecked", Bar::Unchecked, [](Pilot &pilot) { pilot.known.isChecked = false; });
    row("throttle", Bar::Throttle, [](Pilot &pilot) { pilot.sticks.throttle = 0.01; });
    row("at work", Bar::Busy, [](Pilot &pilot) { pilot.known.isBusy = true; });
    row("being stopped", Bar::Stopping, [](Pilot &pilot) { pilot.known.isStopping = true; });
    row("pushed", Bar::Pushed, [](Pilot &pilot) { pilot.sticks.pushed = 0.2; });
    row("no stick for it", Bar::Unassigned, [](Pilot &pilot) { pilot.sticks.isComplete = false; });
    row("another ground", Bar::Shared, [](Pilot &pilot) { pilot.known.isShared = true; });
    row("low battery", Bar::Battery, [](Pilot &pilot) { pilot.known.isBatteryLow = true; });
    row("tilted", Bar::Tilted, [](Pilot &pilot) { pilot.known.tiltDeg = 22; });
    row("dead sticks", Bar::NoSticks, [](Pilot &pilot) { pilot.isFresh = false; });
}

void TestArming::eachConditionKeepsItDisarmed()
{
    QFETCH(int, wanted);
    QFETCH(Change, change);
    // Before the key is pressed, and while it is held.
    for (const bool isHeldBefore : {false, true}) {
        Pilot pilot;
        pilot.session.open(false);
        pilot.tell();
        if (isHeldBefore) {
            pilot.session.press(pilot.now);
            pilot.steps(500ms);
            QCOMPARE(pilot.sent, Send::Disarmed);
        }
        change(pilot);
        if (!isHeldBefore)
            pilot.session.press(pilot.now);
        bool wasArmed = false;
        for (int i = 0; i < 200; ++i)
            wasArmed |= pilot.step() == Send::Armed;
        // Half a second of silence is none yet.
        QVERIFY(!wasArmed || (isHeldBefore && Bar(wanted) == Bar::Silent));
        QCOMPARE(pilot.sent, Send::Nothing);
        QCOMPARE(int(pilot.session.ended()), wanted);
        QCOMPARE(pilot.session.phase(), Phase::Open);
    }
}

void TestArming::eachConditionDisarms_data()
{
    eachConditionKeepsItDisarmed_data();
}

void TestArming::eachConditionDisarms()
{
    QFETCH(int, wanted);
    QFETCH(Change, change);
    Pilot pilot;
    QVERIFY(pilot.arm());
    // What concerns only the moment of arming disarms nothing that flies.
    if (Bar(wanted) == Bar::ArmedElsewhere || Bar(wanted) == Bar::MotorsTurn || Bar(wanted) == Bar::Unchecked
        || Bar(wanted) == Bar::Throttle || Bar(wanted) == Bar::Pushed || Bar(wanted) == Bar::Unassigned
        || Bar(wanted) == Bar::Shared || Bar(wanted) == Bar::Battery || Bar(wanted) == Bar::Tilted) {
        change(pilot);
        pilot.steps(2s);
        QCOMPARE(pilot.sent, Send::Armed);
        return;
    }
    change(pilot);
    pilot.steps(1100ms);
    QCOMPARE(pilot.sent, Send::Nothing);
    QCOMPARE(int(pilot.session.ended()), wanted);
}

void TestArming::standMayHoldItTilted()
{
    Pilot pilot;
    pilot.known.tiltDeg = 28;
    pilot.session.open(false);
    QCOMPARE(pilot.bar(), Bar::Tilted);
    pilot.session.close();
    pilot.session.open(true);
    QCOMPARE(pilot.bar(), Bar::None);
    pilot.known.isBatteryLow = true;
    QCOMPARE(pilot.bar(), Bar::Battery);
}

void TestArming::reArmingTakesANewPress()
{
    Pilot pilot;
    QVERIFY(pilot.arm());
    pilot.known.isArmed = false;  // it says so by itself
    QCOMPARE(pilot.step(), Send::Nothing);
    QCOMPARE(pilot.session.ended(), Bar::Disarmed);
    pilot.known.isArmed = true;
    pilot.steps(3s);
    QCOMPARE(pilot.sent, Send::Nothing);
    QCOMPARE(pilot.bar(), Bar::ArmedElsewhere);
}

// Within the time in which its state is looked at, the next set-point has armed it again.
void TestArming::aDisarmingInBetweenEndsIt()
{
    Pilot pilot;
    pilot.known.disarmedAt = pilot.now;  // before it was armed
    QVERIFY(pilot.arm());
    pilot.steps(2s);
    QCOMPARE(pilot.sent, Send::Armed);
    pilot.known.disarmedAt = pilot.now - 10ms;
    QCOMPARE(pilot.step(), Send::Nothing);
    QCOMPARE(pilot.session.ended(), Bar::Disarmed);
}

// Whoever disarms it: what steers it hears so from the very next set-point, before that arms it again.
void TestArming::eachSetpointAsksBeforeItArms()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    flown.steer(0.3, true, 500ms);
    const auto states = flown.channel.listen(
        [](const FrameView &frame) { return frame.id == int(bcflight::Message::Status); });
    Request foreign;
    foreign.bytes = flown.frames(0, false).stop;
    flown.channel.post(foreign);
    flown.steer(0.3, true, 100ms);
    QVERIFY(flown.board().isArmed());
    int disarmed = 0;
    while (const auto state = states->next(1ms))
        disarmed += bcflight::Status::decode(asBytes(state->payload))->armed ? 0 : 1;
    QCOMPARE(disarmed, 1);
}

void TestArming::itHasToSayThatItIsArmed()
{
    Pilot pilot;
    pilot.session.open(false);
    pilot.session.press(pilot.now);
    pilot.steps(ArmingSession::kHold + 40ms);
    QCOMPARE(pilot.sent, Send::Armed);
    pilot.steps(ArmingSession::kAnswer + 40ms);
    QCOMPARE(pilot.sent, Send::Nothing);
    QCOMPARE(pilot.session.ended(), Bar::NotArmed);
    // What it had said before it was told proves nothing.
    Pilot early;
    early.session.open(false);
    early.session.press(early.now);
    early.steps(ArmingSession::kHold);
    QCOMPARE(early.session.phase(), Phase::Asked);
    early.known.isArmed = true;
    early.isHeard = false;
    early.step();
    QCOMPARE(early.session.phase(), Phase::Asked);
    early.isHeard = true;
    early.step();
    QCOMPARE(early.session.phase(), Phase::Armed);
}

void TestArming::oldStateProvesNothing()
{
    Pilot pilot;
    QVERIFY(pilot.arm());
    pilot.isHeard = false;
    pilot.known.heardAt = pilot.now + 10s;  // something comes, but no state
    pilot.steps(980ms);
    QCOMPARE(pilot.sent, Send::Armed);
    pilot.steps(60ms);
    QCOMPARE(pilot.sent, Send::Nothing);
    QCOMPARE(pilot.session.ended(), Bar::NoState);
}

// Errata 4.3, 6.4, 13.
void TestArming::setpointsAreWhatTheErrataSay()
{
    Flown flown;
    QVERIFY(flown.device.identify(flown.channel));
    QCOMPARE(flown.frames(1, false).setpoint.toHex(), QByteArray("83ff0100000000"));
    QCOMPARE(flown.frames(0, true).setpoint.toHex(), QByteArray("8583000000000001"));
    const SteeringSetpoint junk{1, {std::nan(""), 7, -7, std::nan("")}, {}};
    const SteeringSetpoint least{1, {0, 1, -1, 0}, {0}};
    QCOMPARE(flown.device.steering()->controlFrames(junk).setpoint,
             flown.device.steering()->controlFrames(least).setpoint);
    QCOMPARE(flown.frames(0.5, true).stop.toHex(), QByteArray("830000000000000047"));
    QCOMPARE(flown.frames(0.5, true).release.toHex(), QByteArray("0047"));
}

// Without a refresh for 250 ms: what hangs must not keep it flying. The drone itself does nothing (9.1).
void TestArming::deadManDisarmsAndStops()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    flown.steer(0.3, true, 500ms);
    QVERIFY(flown.board().isArmed());
    QVERIFY(flown.output() > 0.2);
    std::ignore = flown.channel.sleep(ControlStream::kDeadMan + 100ms);
    QVERIFY(!flown.board().isArmed());
    QCOMPARE(flown.output(), 0.0);
    std::ignore = flown.channel.sleep(2s);
    QCOMPARE(flown.channel.stoodStill(), true);
}

// At the rate of the set-points for half a second, and until it is proven.
void TestArming::endIsSentAtFullRate()
{
    Flown flown;
    QVERIFY(flown.device.identify(flown.channel));
    ControlStream stream(20ms);
    const TelemetryStore silent(int(bcflight::channels().size()));
    TimePoint now = kStart;
    stream.refresh(flown.frames(0.3, true), now);
    QVERIFY(stream.advance(now));
    stream.end(now);
    int stops = 0;
    const QByteArray stop = flown.frames(0, false).stop;
    for (; now < kStart + 480ms; now += 10ms) {
        const auto frame = stream.advance(now, &silent);
        stops += frame && *frame == stop ? 1 : 0;
    }
    QVERIFY2(stops >= 24, qPrintable(QString::number(stops)));
    QVERIFY(stream.isSteering());
    // Nothing proves it: it goes on to the limit, and says so.
    for (; now < kStart + 3s; now += 10ms) {
        const auto frame = stream.advance(now, &silent);
        stops += frame && *frame == stop ? 1 : 0;
    }
    QVERIFY2(stops >= 98, qPrintable(QString::number(stops)));
    QCOMPARE(stream.takeOutcome(), std::optional(false));
}

// Errata 9.2, 2: half a second, however soon it says that it stands.
void TestArming::endIsSentInFullThoughItStands()
{
    Flown flown;
    QVERIFY(flown.device.identify(flown.channel));
    ControlStream stream(20ms);
    TelemetryStore told(int(bcflight::channels().size()));
    const auto group = told.defineGroup({bcflight::Armed, bcflight::Outputs}, 0);
    TimePoint now = kStart;
    const ControlFrames frames = flown.frames(0.3, true);
    stream.refresh(frames, now);
    QVERIFY(stream.advance(now));
    stream.end(now);
    int stops = 0;
    for (; now < kStart + 480ms; now += 20ms) {
        const auto frame = stream.advance(now, &told);
        stops += frame == frames.stop ? 1 : 0;
        told.append(*group, now + 10ms, std::array{0.F, 0.F});
    }
    QCOMPARE(stops, 24);
    QVERIFY(stream.isSteering());
    for (; now < kStart + 600ms; now += 20ms)
        std::ignore = stream.advance(now, &told);
    QCOMPARE(stream.takeOutcome(), std::optional(true));
    QVERIFY(!stream.isSteering());
}

void TestArming::endedIsNotResumed()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    const TimePoint begun = flown.channel.now();
    flown.steer(0, true, 300ms, begun);
    QVERIFY(flown.board().isArmed());
    std::ignore = flown.channel.sleep(1s);  // the dead-man acts
    QVERIFY(!flown.board().isArmed());
    flown.steer(0, true, 500ms, begun);
    QVERIFY(!flown.board().isArmed());
    flown.steer(0, true, 500ms, flown.channel.now());
    QVERIFY(flown.board().isArmed());
}

// The last set-point of an armed session may be on its way when the red button is pressed.
void TestArming::stopEndsWhatHadBegun()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    const TimePoint begun = flown.channel.now();
    flown.steer(0.2, true, 300ms, begun);
    flown.channel.stopMotors(flown.device.stopPlan());
    std::ignore = flown.channel.sleep(500ms);
    QVERIFY(!flown.board().isArmed());
    QCOMPARE(flown.output(), 0.0);
    flown.steer(0.2, true, 500ms, begun);
    QVERIFY(!flown.board().isArmed());
    QCOMPARE(flown.output(), 0.0);
}

void TestArming::nothingSteersWhereItIsDangerous_data()
{
    QTest::addColumn<int>("generation");
    for (const auto generation :
         {bcflight::Generation::A, bcflight::Generation::B, bcflight::Generation::C, bcflight::Generation::E})
        QTest::newRow(qPrintable(bcflight::generationText(generation))) << int(generation);
}

void TestArming::nothingSteersWhereItIsDangerous()
{
    QFETCH(int, generation);
    Flown flown{bcflight::Generation(generation)};
    QVERIFY(!flown.device.steering());  // before it is known
    QVERIFY(flown.device.identify(flown.channel));
    QVERIFY(!flown.device.steering());
    QVERIFY(*flown.device.flight()->refusal());
}

void TestArming::gainsWaitForTheDisarming()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    flown.steer(0.2, true, 300ms);
    QVERIFY(flown.board().isArmed());
    const double before = flown.board().gains()[0][0];
    flown.channel.releaseControl();
    QVERIFY(flown.device.live()->writeAdjustables(flown.channel, {{0, before * 2}}));
    QVERIFY(!flown.board().isArmed());
    QVERIFY(std::abs(flown.board().gains()[0][0] - before * 2) < 1e-6);
}

void TestArming::gainsAreSetArmedOnlyInAStand()
{
    Flown flown;
    QVERIFY(flown.calibrate());
    // Armed for good, by somebody whose set-points are not refreshed from here.
    const auto keepArmed = [&flown] {
        Request request;
        request.bytes = flown.frames(0.2, true).setpoint;
        flown.channel.post(request);
        std::ignore = flown.channel.sleep(20ms);
    };
    keepArmed();
    QVERIFY(flown.board().isArmed());
    const double before = flown.board().gains()[1][0];
    const auto refused = flown.device.live()->writeAdjustables(flown.channel, {{3, before * 2}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
    QVERIFY(flown.board().gains()[1][0] == before);
    flown.device.flight()->setHeld(true);
    QVERIFY(flown.device.live()->writeAdjustables(flown.channel, {{3, before * 2}}));
    QVERIFY(flown.board().isArmed());
    QVERIFY(std::abs(flown.board().gains()[1][0] - before * 2) < 1e-6);
    // The offset is never set in flight, and a new drone is no one's word.
    QVERIFY(!flown.device.live()->writeAdjustables(flown.channel, {{9, 1.5}}));
    QVERIFY(flown.device.identify(flown.channel));
    QVERIFY(!flown.device.live()->writeAdjustables(flown.channel, {{3, before}}));
}

namespace {

using Sight = DirectionCheck::Sight;

void tilt(DirectionCheck &check, const DirectionCheck::Axes &angles)
{
    check.feedAngles({0, 0, 0});
    check.feedAngles(angles);
}

/// Through the first six steps, as on a drone that counts roll the other way round.
DirectionCheck withSigns()
{
    DirectionCheck check;
    for (const DirectionCheck::Axes &angles :
         {DirectionCheck::Axes{-20, 1, 1}, DirectionCheck::Axes{1, 20, 1}, DirectionCheck::Axes{1, 1, -20}}) {
        tilt(check, angles);
        check.feedAngles({0, 0, 0});
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        DirectionCheck::Axes push{};
        push[axis] = 0.9;
        check.feedSticks(push);
        check.feedSticks({});
    }
    return check;
}

using Motors = QList<double>;

/// As often as it takes to be seen.
void look(DirectionCheck &check, const Motors &outputs)
{
    for (int i = 0; i < DirectionCheck::kSeenCount; ++i)
        check.feedOutputs(outputs);
}

const std::array<Motors, 3> kAnswers{Motors{0.1, 0.12, 0.1, 0.12}, Motors{0.12, 0.12, 0.1, 0.1},
                                     Motors{0.12, 0.1, 0.1, 0.12}};

void settle(DirectionCheck &check)
{
    check.feedSticks({});
    check.feedAngles({});
    // First with the throttle at zero: what was summed up before is gone then.
    for (int i = 0; check.wantsIdle(); ++i) {
        QVERIFY(i < DirectionCheck::kIdleCount && !check.isReady());
        check.feedOutputs({0, 0, 0, 0});
    }
    for (int i = 0; i < 8; ++i)
        check.feedOutputs({0.1, 0.1, 0.1, 0.1});
}

/// Tilted as far as it is asked for; roll and yaw of the drone of withSigns() are counted the other way
/// round.
void tiltArmed(DirectionCheck &check, std::size_t axis, const Motors &outputs)
{
    settle(check);
    DirectionCheck::Axes angles{};
    angles[axis] = 20 * check.found().angles[axis];
    check.feedAngles(angles);
    look(check, outputs);
}

void answerTilt(DirectionCheck &check, std::size_t axis, bool isRight)
{
    tiltArmed(check, axis, kAnswers[axis]);
    check.answer(isRight);
}

void answerStick(DirectionCheck &check, std::size_t axis, bool isRight)
{
    settle(check);
    DirectionCheck::Axes push{};
    push[axis] = 0.4;
    check.feedSticks(push);
    Motors outputs = kAnswers[axis];
    for (double &output : outputs)
        output = isRight ? 0.22 - output : output;
    look(check, outputs);
    check.answer(isRight);
}

}  // namespace

void TestArming::directionsAreFoundStepByStep()
{
    DirectionCheck check;
    tilt(check, {4, 0, 0});
    QCOMPARE(check.sight(), Sight::Waiting);
    tilt(check, {4, 22, 0});
    QCOMPARE(check.sight(), Sight::Other);
    QCOMPARE(check.stepNumber(), 0);
    // Turned on the spot and held level, it begins from there.
    check = DirectionCheck();
    check.feedAngles({0, 0, 0});
    check.feedAngles({0, 0, 40});
    check.feedAngles({20, 0, 40});
    QCOMPARE(check.sight(), Sight::Seen);
    check = DirectionCheck({CheckedDirections::Level::Nothing, {}, {}});
    for (int axis = 0; axis < 3; ++axis) {
        DirectionCheck::Axes angles{};
        angles[std::size_t(axis)] = 20;
        tilt(check, angles);
        check.feedAngles({0, 0, 0});
    }
    QCOMPARE(check.stepNumber(), 3);
    check.feedSticks({-0.9, 0, 0});  // the other way
    QCOMPARE(check.sight(), Sight::Other);
    check.feedSticks({});
    QCOMPARE(check.stepNumber(), 3);
    check = withSigns();
    QCOMPARE(check.stepNumber(), 6);
    QVERIFY(check.isArmedStep());
    QCOMPARE(check.found().level, CheckedDirections::Level::Signs);
    QCOMPARE(check.found().angles, (std::array{-1, 1, -1}));
    check.feedOutputs({0.1, 0.2, 0.1, 0.2});  // without a tilt they say nothing
    QCOMPARE(check.sight(), Sight::Waiting);
    settle(check);
    for (const DirectionCheck::Axes &angles : {DirectionCheck::Axes{-12, 0, 0}, {-20, 24, 0}, {-20, 0, 0}}) {
        check.feedAngles(angles);
        QCOMPARE(check.isStimulated(), angles == (DirectionCheck::Axes{-20, 0, 0}));
    }
    check = withSigns();
    check.answer(true);
    QCOMPARE(check.stepNumber(), 6);
    for (std::size_t axis = 0; axis < 3; ++axis)
        answerTilt(check, axis, true);
    for (std::size_t axis = 0; axis < 3; ++axis)
        answerStick(check, axis, true);
    QVERIFY(!check.step());
    QVERIFY(!check.failed());
    QCOMPARE(check.found().level, CheckedDirections::Level::All);
}

// Nobody holds it level and tilts it: it turns by itself, about all axes, beyond whole turns.
void TestArming::whatTumblesIsNoAnswer()
{
    DirectionCheck check;
    for (int i = 0; i < 2000; ++i)
        check.feedAngles({3.1 * i - 45, 4.3 * i - 68, 1.9 * i});
    QCOMPARE(check.stepNumber(), 0);
    check = DirectionCheck();
    tilt(check, {20, 12, 0});
    QCOMPARE(check.sight(), Sight::Waiting);
    // It has to begin level, the direction of its nose does not matter.
    check = DirectionCheck();
    check.feedAngles({-45, 0, 0});
    check.feedAngles({-20, 0, 0});
    QCOMPARE(check.sight(), Sight::Waiting);
    check = DirectionCheck();
    check.feedAngles({362, 0, 170});
    check.feedAngles({20, 0, 170});
    QCOMPARE(check.sight(), Sight::Seen);
}

void TestArming::wrongAnswerForbidsFlight()
{
    DirectionCheck check = withSigns();
    answerTilt(check, 0, true);
    answerTilt(check, 1, false);
    QVERIFY(!check.step());
    QCOMPARE(check.failed(), std::optional(Axis::Pitch));
    QCOMPARE(check.found().level, CheckedDirections::Level::Nothing);
}

void TestArming::stickIsReversedOnce()
{
    DirectionCheck check = withSigns();
    for (std::size_t axis = 0; axis < 3; ++axis)
        answerTilt(check, axis, true);
    QVERIFY(!check.isReversed());
    answerStick(check, 0, false);
    QVERIFY(check.isReversed());
    QCOMPARE(check.stepNumber(), 9);  // once more, the other way
    QCOMPARE(check.found().sticks, (std::array{-1, 1, 1}));
    answerStick(check, 0, true);
    answerStick(check, 1, false);
    answerStick(check, 1, false);
    QCOMPARE(check.failed(), std::optional(Axis::Pitch));
}

void TestArming::answersBindEachOther()
{
    DirectionCheck check = withSigns();
    for (std::size_t axis = 0; axis < 3; ++axis)
        answerTilt(check, axis, true);
    answerStick(check, 0, true);
    answerStick(check, 1, true);
    // The same motors turn clockwise and counter-clockwise.
    settle(check);
    check.feedSticks({0, 0, 0.9});
    look(check, kAnswers[2]);
    check.answer(true);
    QVERIFY(check.isContradicted());
    QCOMPARE(check.stepNumber(), 8);
    QCOMPARE(check.found().level, CheckedDirections::Level::Signs);
    answerTilt(check, 2, true);
    QVERIFY(!check.isContradicted());
    QCOMPARE(check.stepNumber(), 11);
    answerStick(check, 2, true);
    QCOMPARE(check.found().level, CheckedDirections::Level::All);
    // Nor are those on the right those in front.
    check = withSigns();
    answerTilt(check, 0, true);
    tiltArmed(check, 1, kAnswers[0]);
    check.answer(true);
    QVERIFY(check.isContradicted());
    QCOMPARE(check.stepNumber(), 6);
}

void TestArming::whatIsAskedStays()
{
    DirectionCheck check = withSigns();
    tiltArmed(check, 0, kAnswers[0]);
    QCOMPARE(check.faster(), (QList<int>{2, 4}));
    check.feedAngles({20, 0, 0});
    check.feedOutputs({0.12, 0.1, 0.12, 0.1});
    QCOMPARE(check.faster(), (QList<int>{2, 4}));
    check.answer(true);
    // Before it is steady again nothing counts, and one motor alone is no answer.
    check.feedAngles({0, 20, 0});
    check.feedOutputs(kAnswers[1]);
    QCOMPARE(check.sight(), Sight::Waiting);
    tiltArmed(check, 1, {0.1, 0.12, 0.1, 0.1});
    QCOMPARE(check.sight(), Sight::Waiting);
    tiltArmed(check, 1, kAnswers[1]);
    QCOMPARE(check.faster(), (QList<int>{1, 2}));
}

// What was read between two of the drone's answers named motors that had not even turned.
void TestArming::oneLookIsNoAnswer()
{
    DirectionCheck check = withSigns();
    settle(check);
    check.feedAngles({20 * double(check.found().angles[0]), 0, 0});
    check.feedOutputs(kAnswers[1]);
    check.feedOutputs(kAnswers[1]);
    QCOMPARE(check.sight(), Sight::Waiting);
    look(check, kAnswers[0]);
    QCOMPARE(check.faster(), (QList<int>{2, 4}));
}

// A controller sums up what it cannot move: at rest, its outputs drift apart.
void TestArming::driftIsNoAnswer()
{
    DirectionCheck check = withSigns();
    settle(check);
    for (int i = 1; i <= 20; ++i)
        check.feedOutputs({0.1 + 0.004 * i, 0.1 + 0.004 * i, 0.1, 0.1});
    check.feedAngles({20 * double(check.found().angles[0]), 0, 0});
    look(check, {0.18, 0.2, 0.1, 0.12});
    QCOMPARE(check.faster(), (QList<int>{2, 4}));
}

void TestArming::foundIsKept()
{
    const CheckedDirections found{CheckedDirections::Level::Signs, {1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    QCOMPARE(CheckedDirections::decode(found.encode()), found);
    // As earlier versions kept it.
    QCOMPARE(CheckedDirections::decode("2+-+--+"),
             (CheckedDirections{CheckedDirections::Level::All, {1, -1, 1}, {-1, -1, 1}, {1, 1, 1}}));
    QCOMPARE(DirectionCheck(found).stepNumber(), 6);
    for (const char *junk : {"", "3++++++", "2+++", "x++++++", "2+++++++"})
        QCOMPARE(CheckedDirections::decode(junk).level, CheckedDirections::Level::Nothing);
}

void TestArming::configurationDecidesWhetherItIsKnown()
{
    Flown flown;
    QVERIFY(flown.device.identify(flown.channel));
    auto whole = flown.device.readConfiguration(flown.channel);
    QVERIFY(whole);
    const QByteArray key = flown.device.axesKey(*whole);
    QVERIFY(!key.isEmpty());
    QByteArray text = whole->block({0, bcflight::ConfigurationText});
    const auto with = [&](const QByteArray &from, const QByteArray &to) {
        Configuration changed = *whole;
        changed.setBlock({0, bcflight::ConfigurationText}, QByteArray(text).replace(from, to));
        return flown.device.axesKey(changed);
    };
    QVERIFY(text.contains("PID( 90, 25, 80 )"));
    QCOMPARE(with("PID( 90, 25, 80 )", "PID( 95, 20, 81.5 )"), key);
    QVERIFY(with("PID( 90, 25, 80 )", "PID( -90, 25, 80 )") != key);
    QVERIFY(with("Vector( 1.0, -1.0, -1.0, 1.0 )", "Vector( -1.0, -1.0, -1.0, 1.0 )") != key);
    BoardIdentity newer = whole->identity();
    newer.firmware = u"7.7"_s;
    Configuration updated(newer, flown.device.parameters());
    updated.setBlock({0, bcflight::ConfigurationText}, text);
    QVERIFY(flown.device.axesKey(updated) != key);
    QVERIFY(
        flown.device.axesKey(Configuration(flown.device.identity(), flown.device.parameters())).isEmpty());
}

// Errata 9.2, 8.
void TestArming::drivenThoughDisarmedIsAnAlarm()
{
    const bcflight::Device drone;
    QVERIFY(Supervisor::possible(rolesOf(drone)).contains(AlarmKind::Disarmed));
    Supervisor supervisor;
    double now = 0;
    const auto feed = [&](double armed, double outputs, double seconds) {
        for (const double until = now + seconds; now < until; now += 0.05) {
            SupervisedSample sample;
            sample.time = now;
            sample.armed = armed;
            sample.outputs = outputs;
            supervisor.add(sample);
            supervisor.look(now);
        }
    };
    feed(1, 1, 5);
    feed(0, 1, 0.4);  // the outputs are told later than the state
    feed(0, 0, 5);
    QVERIFY(supervisor.takeRaised().empty());
    feed(0, 1, 2);
    const auto raised = supervisor.takeRaised();
    QCOMPARE(raised.size(), std::size_t(1));
    QCOMPARE(raised.front().kind, AlarmKind::Disarmed);
    QVERIFY(!raised.front().isUnwantedMotion());  // seen to stand, nothing is left to be looked at
    feed(0, 0, 3);
    QCOMPARE(supervisor.takeEnded().size(), std::size_t(1));
    SupervisedSituation procedure;
    procedure.isProcedure = true;
    supervisor.setSituation(procedure);
    feed(0, 1, 3);  // a motor test
    QVERIFY(supervisor.takeRaised().empty());
}

QTEST_GUILESS_MAIN(TestArming)
#include "tst_arming.moc"
