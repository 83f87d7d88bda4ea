// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The gamepad on the screen: assigned by moving it, steering a gimbal, and lost.
#include "app/mainwindow/mainwindow.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/board/gamepadsteering.h"
#include "app/pages/program/gamepadpage.h"
#include "tests/support/fakegamepads.h"
#include "tests/support/windowrig.h"
#include "widgets/views/controlpad.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kYawAxis = 0;
constexpr int kPitchAxis = 1;
constexpr int kRollAxis = 3;
constexpr int kArmButton = 2;
constexpr int kDisarmButton = 4;
constexpr int kCentreButton = 5;

}  // namespace

class TestGamepadSteering : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void sticksAreAssignedByMovingThem_data();
    void sticksAreAssignedByMovingThem();
    void aButtonIsAssignedByPressingIt();
    void whatIsHalfAssignedIsTakenBack();
    void aSkippedStickStaysUnassigned();
    void whatIsMissingIsSaidOnThePage();
    void theStickSteersWhileArmed();
    void anAngleStaysWhereTheStickLetsGo_data();
    void anAngleStaysWhereTheStickLetsGo();
    void aHeldStickIsNoIdleOperator();
    void aPushedStickRefusesToArm();
    void thePulledPadDisarms();
    void theSilentPadDisarms();
    void aPadThatComesLaterSteersNothing();
    void buttonsArmAndDisarm();
    void withoutTheTickNothingIsRead();

private:
    void assignAll();
    bool showControl(const QString &family, bool positional);
    [[nodiscard]] QString told() const;
    Workspace &workspace() { return m_rig->workspace(); }

    std::unique_ptr<FakeGamepads> m_pads;
    std::unique_ptr<WindowRig> m_rig;
    ControlPage *m_control = nullptr;
    QStringList m_told;
};

void TestGamepadSteering::init()
{
    m_pads = std::make_unique<FakeGamepads>();
    m_rig = std::make_unique<WindowRig>();
    workspace().gamepad().setMaker(m_pads->maker());
    m_told.clear();
    connect(&workspace().notifications(), &Notifications::notice, this,
            [this](const QString &text) { m_told.append(text); });
}

void TestGamepadSteering::cleanup()
{
    m_pads->setHanging(false);
    m_rig.reset();
    m_pads.reset();
    m_control = nullptr;
}

QString TestGamepadSteering::told() const
{
    return m_told.join(u'\n');
}

void TestGamepadSteering::assignAll()
{
    GamepadMapping mapping;
    mapping.assign(GamepadStick::Yaw, kYawAxis, false);
    mapping.assign(GamepadStick::Pitch, kPitchAxis, true);
    mapping.assign(GamepadStick::Roll, kRollAxis, false);
    mapping.assign(GamepadButton::ArmHold, kArmButton);
    mapping.assign(GamepadButton::Disarm, kDisarmButton);
    mapping.assign(GamepadButton::Centre, kCentreButton);
    m_rig->settings().setGamepad("pad", mapping.toJson());
    m_rig->settings().setGamepadSteers(true);
}

// On a board of that family whose motors run, in the first mode of that kind.
bool TestGamepadSteering::showControl(const QString &family, bool positional)
{
    if (!m_rig->open(u"sim:"_s + family))
        return false;
    workspace().setMotors(true);
    if (!QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience))
        return false;
    m_control = m_rig->page<ControlPage>();
    const Steering *steering = m_rig->client().device()->steering();
    for (const SteeringMode &mode : steering->modes()) {
        if (mode.isPositional() == positional && mode.inputOf(Axis::Pitch) >= 0
            && (!positional || qstrcmp(mode.inputs.front().unit, "°") == 0)) {
            for (auto *box : m_control->findChildren<QComboBox *>()) {
                if (box->findData(mode.id) >= 0 && box->isVisible()
                    && box->count() == int(steering->modes().size()))
                    box->setCurrentIndex(box->findData(mode.id));
            }
            return true;
        }
    }
    return false;
}

void TestGamepadSteering::sticksAreAssignedByMovingThem_data()
{
    QTest::addColumn<GamepadUse>("use");
    QTest::addColumn<GamepadStick>("without");
    QTest::newRow("gimbal") << GamepadUse::Camera << GamepadStick::Throttle;
    QTest::newRow("drone") << GamepadUse::Flight << GamepadStick::Speed;
}

void TestGamepadSteering::sticksAreAssignedByMovingThem()
{
    QFETCH(GamepadUse, use);
    QFETCH(GamepadStick, without);
    m_pads->plug();
    workspace().gamepad().setUse(use);
    auto *page = m_rig->page<GamepadPage>();
    QTRY_VERIFY(workspace().gamepad().reading().has_value());
    const auto texts = [page] {
        QString all;
        for (const auto *label : page->findChildren<QLabel *>())
            all += label->text() + u'\n';
        return all;
    };
    QTRY_VERIFY(texts().contains(u"until they are assigned"_s));
    page->assignAll();
    QVERIFY(texts().contains(u"Let go of all"_s));
    // Throttle, roll, pitch, yaw, speed.
    const std::array<std::pair<int, double>, kGamepadSticks> moves{
        {{1, -1.0}, {2, 1.0}, {3, -1.0}, {0, 0.9}, {5, 1.0}}};
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        if (GamepadStick(i) == without)
            continue;
        const auto [axis, way] = moves[i];
        QTRY_VERIFY(texts().contains(u"Push the stick"_s));
        // Let go of late: the way back of the stick before is not meant.
        for (std::size_t other = 0; other < FakeGamepads::kAxes; ++other)
            m_pads->move(int(other), int(other) == axis ? way : 0);
        QTRY_VERIFY(!texts().contains(u"Push the stick"_s));
    }
    for (std::size_t other = 0; other < FakeGamepads::kAxes; ++other)
        m_pads->move(int(other), 0);
    QVERIFY(!page->isUnderWay());
    const GamepadMapping mapping = workspace().gamepad().mapping();
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        if (GamepadStick(i) == without) {
            QCOMPARE(mapping.sticks[i].axis, -1);
            continue;
        }
        QCOMPARE(mapping.sticks[i].axis, moves[i].first);
        QCOMPARE(mapping.sticks[i].inverted, moves[i].second < 0);
    }
    const QByteArray key = use == GamepadUse::Flight ? "pad-flight" : "pad";
    QCOMPARE(GamepadMapping::fromJson(m_rig->settings().gamepad(key)), mapping);
    QVERIFY(texts().contains(u"is ready"_s));
    // Another start of the program knows it.
    m_rig->restart();
    QCOMPARE(GamepadMapping::fromJson(m_rig->settings().gamepad(key)), mapping);
}

void TestGamepadSteering::aButtonIsAssignedByPressingIt()
{
    m_pads->plug();
    auto *page = m_rig->page<GamepadPage>();
    QTRY_VERIFY(workspace().gamepad().reading().has_value());
    page->assign(GamepadButton::Disarm);
    QVERIFY(page->isUnderWay());
    QTest::keyClick(page, Qt::Key_Escape);
    QVERIFY(!page->isUnderWay());
    page->assign(GamepadButton::Disarm);
    const auto asks = [page] {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
                           [](const QLabel *label) { return label->text().contains(u"Press the button"_s); });
    };
    QTRY_VERIFY(asks());
    m_pads->press(6, true);
    QTRY_VERIFY(!page->isUnderWay());
    QCOMPARE(workspace().gamepad().mapping()[GamepadButton::Disarm], 6);
}

void TestGamepadSteering::whatIsHalfAssignedIsTakenBack()
{
    assignAll();
    m_pads->plug();
    auto *page = m_rig->page<GamepadPage>();
    QTRY_VERIFY(workspace().gamepad().reading().has_value());
    const GamepadMapping before = workspace().gamepad().mapping();
    page->assignAll();
    const auto labels = page->findChildren<QLabel *>();
    QTRY_VERIFY(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel *label) { return label->text().contains(u"Push the stick"_s); }));
    m_pads->move(kYawAxis, 1);  // for roll
    QTRY_VERIFY(workspace().gamepad().mapping() != before);
    for (auto *button : page->findChildren<QPushButton *>()) {
        if (button->text() == u"Cancel"_s)
            button->click();
    }
    QVERIFY(!page->isUnderWay());
    QCOMPARE(workspace().gamepad().mapping(), before);
}

void TestGamepadSteering::aSkippedStickStaysUnassigned()
{
    m_pads->plug();
    auto *page = m_rig->page<GamepadPage>();
    QTRY_VERIFY(workspace().gamepad().reading().has_value());
    page->assignAll();
    for (std::size_t i = 1; i < kGamepadSticks; ++i) {  // a camera has no throttle
        QVERIFY(page->isUnderWay());
        for (auto *button : page->findChildren<QPushButton *>()) {
            if (button->text() == u"Skip"_s)
                button->click();
        }
    }
    QVERIFY(!page->isUnderWay());
    QVERIFY(!workspace().gamepad().mapping().isSetUp());
}

void TestGamepadSteering::whatIsMissingIsSaidOnThePage()
{
    m_pads->setError(Error{ErrorCode::Unsupported, u"there is no module"_s});
    auto *page = m_rig->page<GamepadPage>();
    QTRY_VERIFY([page] {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->text().contains(u"cannot be read: there is no module"_s);
        });
    }());
}

void TestGamepadSteering::anAngleStaysWhereTheStickLetsGo_data()
{
    QTest::addColumn<QString>("family");
    for (const Family &family : allFamilies()) {
        if (family.key != u"bcflight"_s)
            QTest::newRow(qPrintable(family.key)) << family.key;
    }
}

void TestGamepadSteering::theStickSteersWhileArmed()
{
    assignAll();
    m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    m_pads->move(kPitchAxis, -1);
    QTRY_COMPARE(workspace().gamepad().snapshot()[GamepadStick::Pitch], 1.0);
    QCOMPARE(m_control->pad()->value(), QPointF());  // not before it is armed
    m_pads->move(kPitchAxis, 0);
    QTRY_COMPARE(workspace().gamepad().snapshot()[GamepadStick::Pitch], 0.0);
    m_control->setArmed(true);
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    m_pads->move(kPitchAxis, -1);
    QTRY_COMPARE(m_control->pad()->value(), QPointF(0, 1));
    const Steering *steering = m_rig->client().device()->steering();
    const int pitch = steering->mode(m_control->setpoint().mode)->inputOf(Axis::Pitch);
    QVERIFY(m_control->setpoint().inputs[std::size_t(pitch)]
            > steering->mode(m_control->setpoint().mode)->inputs[std::size_t(pitch)].centre);
    const auto angle = [this] { return workspace().latest(workspace().roles().angle[1]); };
    const double before = angle();
    QTRY_VERIFY(std::abs(angle() - before) > 3);  // the camera itself
    m_pads->move(kPitchAxis, 0);
    QTRY_COMPARE(m_control->pad()->value(), QPointF());
    m_control->setArmed(false);
}

void TestGamepadSteering::anAngleStaysWhereTheStickLetsGo()
{
    assignAll();
    m_pads->plug();
    QFETCH(const QString, family);
    QVERIFY(showControl(family, true));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    m_control->setArmed(true);
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    const Steering *steering = m_rig->client().device()->steering();
    const auto pitch = std::size_t(steering->mode(m_control->setpoint().mode)->inputOf(Axis::Pitch));
    m_pads->press(kCentreButton, true);  // one of the boards does not know where its targets are
    QTRY_COMPARE(m_control->setpoint().inputs[pitch], 0.0);
    const double before = 0.0;
    m_pads->move(kPitchAxis, -1);
    QTRY_VERIFY(m_control->setpoint().inputs[pitch] > before + 2);
    m_pads->move(kPitchAxis, 0);
    QTRY_COMPARE(workspace().gamepad().snapshot()[GamepadStick::Pitch], 0.0);
    QVERIFY(m_pads->arePolled(15));  // more than two ticks with what was sent before
    const double held = m_control->setpoint().inputs[pitch];
    QVERIFY(m_pads->arePolled(20));
    QCOMPARE(m_control->setpoint().inputs[pitch], held);
    m_control->setArmed(false);
}

void TestGamepadSteering::aHeldStickIsNoIdleOperator()
{
    assignAll();
    m_rig->settings().setDisarmSeconds(2);
    m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    // On a machine that stands still for a quarter of a second the board is stopped, as it should be.
    QSignalSpy stoppedLate(&m_rig->client(), &DeviceClient::failsafeActed);
    for (int attempt = 1; attempt <= 3; ++attempt) {
        m_pads->move(kYawAxis, 0);
        QTRY_COMPARE(workspace().gamepad().snapshot()[GamepadStick::Yaw], 0.0);
        QTRY_VERIFY(workspace().motorsRunning().value_or(false));
        m_control->setArmed(true);
        QVERIFY2(m_control->isArmed(), qPrintable(told()));
        m_pads->move(kYawAxis, 0.5);
        const TimePoint since = Clock::now();
        QTRY_VERIFY_WITH_TIMEOUT(Clock::now() - since > 2500ms, 5000);
        if (m_control->isArmed() || stoppedLate.isEmpty())
            break;
        stoppedLate.clear();
        workspace().setMotors(true);
    }
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    m_pads->move(kYawAxis, 0);
    QTRY_VERIFY_WITH_TIMEOUT(!m_control->isArmed(), 6000);
}

void TestGamepadSteering::aPushedStickRefusesToArm()
{
    assignAll();
    m_pads->plug();
    m_pads->move(kRollAxis, 0.4);
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot()[GamepadStick::Roll] > 0.3);
    m_control->setArmed(true);
    QVERIFY(!m_control->isArmed());
    QVERIFY2(told().contains(u"not at rest"_s), qPrintable(told()));
}

void TestGamepadSteering::thePulledPadDisarms()
{
    assignAll();
    const int id = m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    m_control->setArmed(true);
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    m_pads->move(kYawAxis, 1);
    QTRY_COMPARE(m_control->pad()->value(), QPointF(1, 0));
    m_pads->unplug(id);
    QTRY_VERIFY(!m_control->isArmed());
    QVERIFY2(told().contains(u"the gamepad is gone"_s), qPrintable(told()));
    QCOMPARE(m_control->pad()->value(), QPointF());
    m_pads->plug();
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    QVERIFY(!m_control->isArmed());  // never by itself
}

void TestGamepadSteering::theSilentPadDisarms()
{
    assignAll();
    m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    m_control->setArmed(true);
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    m_pads->setHanging(true);
    QTRY_VERIFY(!m_control->isArmed());
    QVERIFY2(told().contains(u"quarter of a second"_s), qPrintable(told()));
}

void TestGamepadSteering::aPadThatComesLaterSteersNothing()
{
    assignAll();
    QVERIFY(showControl(u"simplebgc"_s, false));
    m_control->setArmed(true);
    QVERIFY2(m_control->isArmed(), qPrintable(told()));
    m_pads->plug();
    m_pads->move(kYawAxis, 1);
    QTRY_COMPARE(workspace().gamepad().snapshot()[GamepadStick::Yaw], 1.0);
    QVERIFY(m_pads->arePolled(15));
    QVERIFY(m_control->isArmed());
    QCOMPARE(m_control->pad()->value(), QPointF());
    m_control->setArmed(false);
}

void TestGamepadSteering::buttonsArmAndDisarm()
{
    assignAll();
    m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    m_pads->press(kArmButton, true);
    QTRY_VERIFY(workspace().gamepad().snapshot().isHeld(GamepadButton::ArmHold));
    QVERIFY(m_pads->arePolled(30));
    QVERIFY(!m_control->isArmed());  // not by a short press
    m_pads->press(kArmButton, false);
    QTRY_VERIFY(!workspace().gamepad().snapshot().isHeld(GamepadButton::ArmHold));
    // Nor behind a list or a question.
    m_rig->window().showPalette();
    QTRY_VERIFY(m_rig->window().commandPalette()->isVisible());
    m_pads->press(kArmButton, true);
    QTRY_VERIFY2(told().contains(u"open over this page"_s), qPrintable(told()));
    QVERIFY(!m_control->isArmed());
    m_pads->press(kArmButton, false);
    QTest::keyClick(m_rig->window().commandPalette()->input(), Qt::Key_Escape);
    QTRY_VERIFY(!workspace().gamepad().snapshot().isHeld(GamepadButton::ArmHold));
    QTRY_VERIFY(!m_rig->window().commandPalette() || !m_rig->window().commandPalette()->isVisible());
    m_pads->press(kArmButton, true);
    QTRY_VERIFY(m_control->isArmed());
    m_pads->press(kDisarmButton, true);
    QTRY_VERIFY(!m_control->isArmed());
    QVERIFY(m_pads->arePolled(30));
    QVERIFY(!m_control->isArmed());  // though the button to arm is still held
}

void TestGamepadSteering::withoutTheTickNothingIsRead()
{
    assignAll();
    m_rig->settings().setGamepadSteers(false);
    m_pads->plug();
    QVERIFY(showControl(u"simplebgc"_s, false));
    QCOMPARE(m_pads->polls(), 0u);
    auto *tick = m_control->findChild<GamepadSteering *>()->choice();
    tick->click();
    QTRY_VERIFY(workspace().gamepad().snapshot().isAlive(Clock::now()));
    QVERIFY(m_rig->settings().gamepadSteers());
    m_rig->window().showPage(u"dashboard"_s);
    QVERIFY(!workspace().gamepad().isUsed());
}

QTEST_MAIN(TestGamepadSteering)
#include "tst_gamepadsteering.moc"
