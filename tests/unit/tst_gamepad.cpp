// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fakegamepads.h"
#include "widgets/gamepad/gamepad.h"
#include "widgets/gamepad/gamepaddetector.h"

#include <QMap>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

constexpr double kNear = 1e-9;

GamepadReading pad(std::vector<double> axes, std::vector<bool> buttons = {false, false, false})
{
    return {1, "pad", u"Test pad"_s, std::move(axes), std::move(buttons)};
}

TimePoint after(milliseconds time)
{
    return TimePoint() + 1h + time;
}

/// The service over pads of the test, with settings in memory.
struct Rig
{
    FakeGamepads pads;
    QMap<QByteArray, QByteArray> kept;
    QObject user;
    Gamepad gamepad{{[this](const QByteArray &guid) { return kept.value(guid); },
                     [this](const QByteArray &guid, const QByteArray &json) { kept[guid] = json; }},
                    pads.maker()};

    void assign(GamepadStick stick, int axis, bool inverted = false)
    {
        GamepadMapping mapping = gamepad.mapping();
        mapping.assign(stick, axis, inverted);
        mapping[stick].deadBand = 0;
        gamepad.setMapping(mapping);
    }
    [[nodiscard]] bool isAlive() const { return gamepad.snapshot().isAlive(Clock::now()); }
};

}  // namespace

class TestGamepad : public QObject
{
    Q_OBJECT
private slots:
    void aStickBeginsBehindItsDeadBand_data();
    void aStickBeginsBehindItsDeadBand();
    void anAxisSteersOneThing();
    void aMappingSurvivesTheSettings();
    void aMappingThatWasEditedByHandIsHarmless();
    void withoutAnAxisNothingIsSteered();
    void theMovedAxisIsFound();
    void nothingIsFoundBeforeEverythingRests();
    void twoAxesAtOnceAreNoAnswer();
    void aPressedButtonIsFound();
    void itIsReadOnlyWhileUsed();
    void sticksAndButtonsArriveMapped();
    void aShortPressIsCounted();
    void aPadThatIsPulledOutIsLost();
    void aPadThatComesAgainIsAnotherSession();
    void aThreadThatHangsIsADeadMan();
    void theProgramEndsWhileTheDriverHangs();
    void anotherPadDoesNotTakeOver();
    void theChosenOfTwoIsUsed();
    void whatIsMissingIsSaid();
    void anOrdinaryPadHasADefault();
    void anUnusualLayoutIsFollowed_data();
    void anUnusualLayoutIsFollowed();
    void theChosenOneIsRemembered();
};

void TestGamepad::aStickBeginsBehindItsDeadBand_data()
{
    QTest::addColumn<GamepadAxisUse>("use");
    QTest::addColumn<bool>("atStop");
    QTest::addColumn<double>("position");
    QTest::addColumn<double>("meant");
    const auto row = [](const char *name, GamepadAxisUse use, bool atStop, double position, double meant) {
        QTest::newRow(name) << use << atStop << position << meant;
    };
    const GamepadAxisUse plain{0, false, 0.1, 0.0};
    row("rest", plain, false, 0.0, 0.0);
    row("inside", plain, false, 0.1, 0.0);
    row("inside, below", plain, false, -0.09, 0.0);
    row("half of what is left", plain, false, 0.55, 0.5);
    row("below", plain, false, -0.55, -0.5);
    row("end", plain, false, 1.0, 1.0);
    row("beyond", plain, false, -1.2, -1.0);
    row("inverted", {0, true, 0.1, 0.0}, false, 0.55, -0.5);
    row("expo", {0, false, 0.0, 0.5}, false, 0.5, 0.3125);
    row("expo at the end", {0, false, 0.0, 1.0}, false, -1.0, -1.0);
    row("no number", plain, false, std::numeric_limits<double>::quiet_NaN(), 0.0);
    row("stop", plain, true, -1.0, -1.0);
    row("near the stop", plain, true, -0.8, -1.0);
    row("middle of a throttle", plain, true, 0.1, 0.0);
    row("full throttle", plain, true, 1.0, 1.0);
    row("inverted throttle", {0, true, 0.0, 0.0}, true, 1.0, -1.0);
    row("no number for a throttle", plain, true, std::numeric_limits<double>::infinity(), -1.0);
}

void TestGamepad::aStickBeginsBehindItsDeadBand()
{
    QFETCH(const GamepadAxisUse, use);
    QFETCH(const bool, atStop);
    QFETCH(const double, position);
    QFETCH(const double, meant);
    QVERIFY2(std::abs(use.shaped(position, atStop) - meant) < kNear,
             qPrintable(QString::number(use.shaped(position, atStop))));
}

void TestGamepad::anAxisSteersOneThing()
{
    GamepadMapping mapping;
    QVERIFY(!mapping.isSetUp());
    mapping.assign(GamepadStick::Pitch, 3, true);
    mapping.assign(GamepadStick::Yaw, 3, false);
    QCOMPARE(mapping[GamepadStick::Pitch].axis, -1);
    QCOMPARE(mapping[GamepadStick::Yaw].axis, 3);
    mapping.assign(GamepadButton::ArmHold, 2);
    mapping.assign(GamepadButton::Disarm, 2);
    QCOMPARE(mapping[GamepadButton::ArmHold], -1);
    QCOMPARE(mapping[GamepadButton::Disarm], 2);
}

void TestGamepad::aMappingSurvivesTheSettings()
{
    GamepadMapping mapping;
    mapping.assign(GamepadStick::Throttle, 1, true);
    mapping.assign(GamepadStick::Roll, 3, false);
    mapping[GamepadStick::Roll].deadBand = 0.12;
    mapping[GamepadStick::Roll].expo = 0.4;
    mapping.assign(GamepadButton::Disarm, 5);
    QCOMPARE(GamepadMapping::fromJson(mapping.toJson()), mapping);
    QCOMPARE(GamepadMapping::fromJson({}), GamepadMapping());
}

void TestGamepad::aMappingThatWasEditedByHandIsHarmless()
{
    const auto mapping = GamepadMapping::fromJson(
        R"({"roll":{"axis":2,"deadBand":7,"expo":-3},"pitch":{"axis":2},"yaw":"x","disarm":1,"centre":1})");
    QCOMPARE(mapping[GamepadStick::Roll].axis, -1);  // it cannot steer two
    QCOMPARE(mapping[GamepadStick::Pitch].axis, 2);
    QCOMPARE(mapping[GamepadStick::Roll].deadBand, GamepadMapping::kMaxDeadBand);
    QCOMPARE(mapping[GamepadStick::Roll].expo, 0.0);
    QCOMPARE(mapping[GamepadButton::Disarm], -1);
    QCOMPARE(GamepadMapping::fromJson("{broken"), GamepadMapping());
}

void TestGamepad::withoutAnAxisNothingIsSteered()
{
    GamepadMapping mapping;
    mapping.assign(GamepadStick::Roll, 9, false);  // a pad of this kind that has fewer
    mapping.assign(GamepadButton::Disarm, 9);
    GamepadSnapshot snapshot;
    applyMapping(mapping, pad({1, 1}, {true}), snapshot);
    QCOMPARE(snapshot[GamepadStick::Throttle], -1.0);
    QCOMPARE(snapshot[GamepadStick::Roll], 0.0);
    QVERIFY(!snapshot.has(GamepadStick::Roll));
    QVERIFY(!snapshot.isHeld(GamepadButton::Disarm));
}

void TestGamepad::theMovedAxisIsFound()
{
    GamepadDetector detector(GamepadDetector::Wanted::Axis);
    QVERIFY(!detector.look(pad({0, 0, -1}), after(0ms)));
    QVERIFY(!detector.look(pad({0.02, 0, -1}), after(200ms)));
    QVERIFY(!detector.look(pad({0, 0, -1}), after(310ms)));
    QVERIFY(detector.isReady());
    QVERIFY(!detector.look(pad({0, -0.5, -1}), after(320ms)));  // not far enough
    const auto found = detector.look(pad({0.2, -0.9, -1}), after(330ms));
    QCOMPARE(found, (GamepadDetector::Found{1, true}));
}

// A trigger that is held, or a stick on its way back, is not what is meant.
void TestGamepad::nothingIsFoundBeforeEverythingRests()
{
    GamepadDetector detector(GamepadDetector::Wanted::Axis);
    QVERIFY(!detector.look(pad({1, 0}), after(0ms)));
    QVERIFY(!detector.look(pad({0.5, 0}), after(100ms)));
    QVERIFY(!detector.look(pad({0, 0}), after(350ms)));
    QVERIFY(!detector.isReady());
    QVERIFY(!detector.look(pad({0, 0}), after(640ms)));
    QVERIFY(!detector.isReady());
    QVERIFY(!detector.look(pad({0, 0}), after(660ms)));
    QVERIFY(detector.isReady());
    QCOMPARE(detector.look(pad({0, 1}), after(700ms)), (GamepadDetector::Found{1, false}));
}

void TestGamepad::twoAxesAtOnceAreNoAnswer()
{
    GamepadDetector detector(GamepadDetector::Wanted::Axis);
    detector.look(pad({0, 0}), after(0ms));
    detector.look(pad({0, 0}), after(400ms));
    QVERIFY(!detector.look(pad({0.9, 0.7}), after(410ms)));
    QVERIFY(detector.look(pad({0.9, 0.3}), after(420ms)).has_value());
}

void TestGamepad::aPressedButtonIsFound()
{
    GamepadDetector detector(GamepadDetector::Wanted::Button);
    detector.look(pad({0}, {false, true}), after(0ms));  // a switch that is on
    detector.look(pad({0}, {false, true}), after(400ms));
    QVERIFY(!detector.look(pad({0}, {false, false}), after(410ms)));
    QCOMPARE(detector.look(pad({1}, {true, true}), after(420ms)), (GamepadDetector::Found{0, false}));
}

void TestGamepad::itIsReadOnlyWhileUsed()
{
    Rig rig;
    rig.pads.plug();
    QCOMPARE(rig.pads.polls(), 0u);
    QVERIFY(!rig.isAlive());
    auto second = std::make_unique<QObject>();
    rig.gamepad.use(rig.user);
    rig.gamepad.use(*second);
    QTRY_VERIFY(rig.isAlive());
    rig.gamepad.letGo(rig.user);
    QVERIFY(rig.isAlive());
    second.reset();
    QVERIFY(!rig.gamepad.isUsed());
    QVERIFY(!rig.isAlive());
    QVERIFY(!rig.gamepad.reading());
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
}

void TestGamepad::sticksAndButtonsArriveMapped()
{
    Rig rig;
    rig.pads.plug();
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    QVERIFY(!rig.gamepad.snapshot().isSetUp);
    rig.assign(GamepadStick::Pitch, 1, true);
    rig.pads.move(1, -0.75);
    QTRY_COMPARE(rig.gamepad.snapshot()[GamepadStick::Pitch], 0.75);
    QVERIFY(rig.gamepad.snapshot().isSetUp);
    QCOMPARE(rig.gamepad.snapshot().name, u"Test pad"_s);
    GamepadMapping mapping = rig.gamepad.mapping();
    mapping.assign(GamepadButton::ArmHold, 4);
    rig.gamepad.setMapping(mapping);
    rig.pads.press(4, true);
    QTRY_VERIFY(rig.gamepad.snapshot().isHeld(GamepadButton::ArmHold));
    QCOMPARE(GamepadMapping::fromJson(rig.kept["pad"]), mapping);
}

void TestGamepad::aShortPressIsCounted()
{
    Rig rig;
    rig.pads.plug();
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    GamepadMapping mapping;
    mapping.assign(GamepadButton::Disarm, 2);
    rig.gamepad.setMapping(mapping);
    for (quint32 press = 1; press <= 3; ++press) {
        rig.pads.press(2, true);
        const quint64 polled = rig.pads.polls();
        QTRY_VERIFY(rig.pads.polls() >= polled + 2);
        rig.pads.press(2, false);
        QTRY_COMPARE(rig.gamepad.snapshot().isHeld(GamepadButton::Disarm), false);
        QCOMPARE(rig.gamepad.snapshot().pressesOf(GamepadButton::Disarm), press);
    }
}

void TestGamepad::aPadThatIsPulledOutIsLost()
{
    Rig rig;
    const int id = rig.pads.plug();
    QSignalSpy lost(&rig.gamepad, &Gamepad::lost);
    QSignalSpy changed(&rig.gamepad, &Gamepad::changed);
    rig.gamepad.use(rig.user);
    QTRY_COMPARE(changed.size(), 1);
    rig.pads.unplug(id);
    QTRY_COMPARE(lost.size(), 1);
    QCOMPARE(lost[0][0].value<Gamepad::Loss>(), Gamepad::Loss::Unplugged);
    QVERIFY(!rig.isAlive());
    QVERIFY(!rig.gamepad.snapshot().connected);
}

void TestGamepad::aPadThatComesAgainIsAnotherSession()
{
    Rig rig;
    const int id = rig.pads.plug();
    QSignalSpy lost(&rig.gamepad, &Gamepad::lost);
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    QTRY_VERIFY(rig.gamepad.isUsed());
    const quint64 session = rig.gamepad.snapshot().session;
    QVERIFY(rig.pads.arePolled(10));  // so that it was looked at
    rig.pads.unplug(id);
    rig.pads.plug();
    QTRY_COMPARE(lost.size(), 1);
    QTRY_VERIFY(rig.isAlive());
    QVERIFY(rig.gamepad.snapshot().session != session);
}

void TestGamepad::aThreadThatHangsIsADeadMan()
{
    Rig rig;
    rig.pads.plug();
    QSignalSpy lost(&rig.gamepad, &Gamepad::lost);
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    rig.pads.setHanging(true);
    QTRY_COMPARE(lost.size(), 1);
    QCOMPARE(lost[0][0].value<Gamepad::Loss>(), Gamepad::Loss::Silent);
    const GamepadSnapshot last = rig.gamepad.snapshot();
    QVERIFY(last.connected);
    QVERIFY(last.isAlive(last.at + GamepadSnapshot::kDeadMan));
    QVERIFY(!last.isAlive(last.at + GamepadSnapshot::kDeadMan + 1ms));
    QVERIFY(!rig.isAlive());
    rig.pads.setHanging(false);
    QTRY_VERIFY(rig.isAlive());
    QCOMPARE(lost.size(), 1);
}

void TestGamepad::theProgramEndsWhileTheDriverHangs()
{
    FakeGamepads pads;
    pads.plug();
    QObject user;
    auto gamepad = std::make_unique<Gamepad>(Gamepad::Store{[](const QByteArray &) { return QByteArray(); },
                                                            [](const QByteArray &, const QByteArray &) {}},
                                             pads.maker());
    gamepad->use(user);
    QTRY_VERIFY(gamepad->snapshot().connected);
    pads.setHanging(true);
    QTRY_VERIFY(!gamepad->snapshot().isAlive(Clock::now()));
    gamepad.reset();
    pads.setHanging(false);
    // The thread ends by itself; it must not be polling when the pads go.
    QTRY_COMPARE(pads.readers(), 0);
}

void TestGamepad::anotherPadDoesNotTakeOver()
{
    Rig rig;
    rig.pads.plug("first");
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    const quint64 session = rig.gamepad.snapshot().session;
    rig.pads.plug("second");
    QTRY_COMPARE(rig.gamepad.pads().size(), 2);
    QCOMPARE(rig.gamepad.snapshot().session, session);
    QCOMPARE(rig.gamepad.reading()->guid, QByteArray("first"));
}

void TestGamepad::theChosenOfTwoIsUsed()
{
    Rig rig;
    rig.pads.plug("first");
    rig.pads.plug("second", u"Other"_s);
    QSignalSpy lost(&rig.gamepad, &Gamepad::lost);
    rig.gamepad.use(rig.user);
    QTRY_COMPARE(rig.gamepad.pads().size(), 2);
    QTRY_VERIFY(rig.gamepad.reading().has_value());
    QCOMPARE(rig.gamepad.reading()->guid, QByteArray("first"));
    QVERIFY(rig.pads.arePolled(10));
    rig.gamepad.prefer({"second", {}});
    QTRY_COMPARE(rig.gamepad.snapshot().name, u"Other"_s);
    QTRY_COMPARE(lost.size(), 1);  // whoever steered with the first stops
}

void TestGamepad::whatIsMissingIsSaid()
{
    Rig rig;
    rig.pads.setError(Error{ErrorCode::Unsupported, u"no driver"_s});
    QSignalSpy changed(&rig.gamepad, &Gamepad::changed);
    rig.gamepad.use(rig.user);
    QTRY_COMPARE(changed.size(), 1);
    QCOMPARE(rig.gamepad.error()->detail, u"no driver"_s);
    rig.gamepad.letGo(rig.user);
    rig.pads.setError({});
    rig.pads.plug();
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    QVERIFY(!rig.gamepad.error());
}

// Mode 2 for a drone, pan and tilt for a camera, and each is set up by itself.
void TestGamepad::anOrdinaryPadHasADefault()
{
    Rig rig;
    rig.pads.plug("xbox", u"Pad"_s,
                  "03,Pad,a:b0,b:b1,leftx:a0,lefty:a1,lefttrigger:a2,rightx:a3,righty:a4,righttrigger:a5,"
                  "start:b7,rightstick:b6,platform:Linux,");
    rig.gamepad.setUse(GamepadUse::Flight);
    rig.gamepad.use(rig.user);
    QTRY_VERIFY(rig.isAlive());
    QVERIFY(rig.gamepad.isStandard() && rig.gamepad.hasStandard());
    QVERIFY(rig.gamepad.snapshot().isSetUp && rig.gamepad.snapshot().isStandard);
    const GamepadMapping flight = rig.gamepad.mapping();
    QCOMPARE(flight[GamepadStick::Yaw].axis, 0);
    QCOMPARE(flight[GamepadStick::Throttle].axis, 1);
    QCOMPARE(flight[GamepadStick::Roll].axis, 3);
    QCOMPARE(flight[GamepadStick::Pitch].axis, 4);
    QCOMPARE(flight[GamepadStick::Speed].axis, -1);
    QCOMPARE(flight[GamepadButton::ArmHold], 7);
    QCOMPARE(flight[GamepadButton::Disarm], 1);
    // The stick springs back to its middle: that is no throttle, and pulled down it is none either.
    QCOMPARE(rig.gamepad.snapshot()[GamepadStick::Throttle], -1.0);
    rig.pads.move(1, -1);
    QTRY_COMPARE(rig.gamepad.snapshot()[GamepadStick::Throttle], 1.0);
    rig.pads.move(1, 1);
    QTRY_COMPARE(rig.gamepad.snapshot()[GamepadStick::Throttle], -1.0);
    rig.pads.move(4, -1);
    QTRY_COMPARE(rig.gamepad.snapshot()[GamepadStick::Pitch], 1.0);
    QCOMPARE(GamepadMapping::fromJson(flight.toJson()), flight);

    QSignalSpy changed(&rig.gamepad, &Gamepad::changed);
    rig.gamepad.setUse(GamepadUse::Camera);
    QCOMPARE(changed.count(), 1);
    QVERIFY(rig.gamepad.isStandard());
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Yaw].axis, 3);
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Pitch].axis, 4);
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Roll].axis, -1);
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Throttle].axis, -1);
    rig.assign(GamepadStick::Yaw, 0);
    QVERIFY(!rig.gamepad.isStandard() && !rig.gamepad.snapshot().isStandard);
    rig.gamepad.setUse(GamepadUse::Flight);
    QVERIFY(rig.gamepad.isStandard());
    rig.gamepad.setUse(GamepadUse::Camera);
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Yaw].axis, 0);
    rig.gamepad.useStandard();
    QVERIFY(rig.gamepad.isStandard());
    QCOMPARE(rig.gamepad.mapping()[GamepadStick::Yaw].axis, 3);
}

void TestGamepad::anUnusualLayoutIsFollowed_data()
{
    QTest::addColumn<QByteArray>("layout");
    QTest::addColumn<bool>("isSetUp");
    QTest::addColumn<bool>("isThrottleInverted");
    QTest::newRow("upside down") << QByteArray("leftx:a0,lefty:a1~,rightx:a2,righty:a3") << true << false;
    QTest::newRow("no right stick") << QByteArray("leftx:a0,lefty:a1,a:b0") << false << false;
    QTest::newRow("halves") << QByteArray("leftx:a0,-lefty:-a1,+lefty:+a1,rightx:a2,righty:a3") << false
                            << false;
    QTest::newRow("buttons for sticks")
        << QByteArray("leftx:b0,lefty:b1,rightx:a2,righty:a3") << false << false;
    QTest::newRow("nonsense") << QByteArray("leftx,lefty:,rightx:a,righty:a-3,:,,") << false << false;
    QTest::newRow("nothing") << QByteArray() << false << false;
}

void TestGamepad::anUnusualLayoutIsFollowed()
{
    QFETCH(QByteArray, layout);
    QFETCH(bool, isSetUp);
    const GamepadMapping mapping = GamepadMapping::standard(layout, GamepadUse::Flight);
    QCOMPARE(mapping.isSetUp(), isSetUp);
    if (isSetUp)
        QTEST(mapping[GamepadStick::Throttle].inverted, "isThrottleInverted");
}

// Two of one kind differ by their names.
void TestGamepad::theChosenOneIsRemembered()
{
    Gamepad::Kind kept;
    const auto make = [&kept](FakeGamepads &pads) {
        return std::make_unique<Gamepad>(Gamepad::Store{[](const QByteArray &) { return QByteArray(); },
                                                        [](const QByteArray &, const QByteArray &) {},
                                                        [&kept] { return kept; },
                                                        [&kept](const Gamepad::Kind &kind) { kept = kind; }},
                                         pads.maker());
    };
    FakeGamepads pads;
    pads.plug("kind", u"One"_s);
    pads.plug("kind", u"Two words"_s);
    QObject user;
    auto gamepad = make(pads);
    gamepad->use(user);
    QTRY_COMPARE(gamepad->snapshot().name, u"One"_s);
    gamepad->prefer({"kind", u"Two words"_s});
    QTRY_COMPARE(gamepad->snapshot().name, u"Two words"_s);
    QCOMPARE(kept, (Gamepad::Kind{"kind", u"Two words"_s}));
    gamepad = make(pads);
    gamepad->use(user);
    QTRY_COMPARE(gamepad->snapshot().name, u"Two words"_s);
}

QTEST_GUILESS_MAIN(TestGamepad)
#include "tst_gamepad.moc"
