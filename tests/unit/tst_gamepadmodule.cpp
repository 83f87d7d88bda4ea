// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The module that reads gamepads, with a joystick that SDL simulates: from the device to a snapshot.
#include "widgets/gamepad/gamepad.h"
#include "widgets/gamepad/gamepadmodule.h"

#include <QSignalSpy>
#include <QTest>

#include <SDL2/SDL.h>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kAxes = 4;
constexpr int kButtons = 6;
constexpr Sint16 kFull = 32767;

/// A joystick of SDL's own. SDL has to be started before.
class VirtualJoystick
{
public:
    VirtualJoystick()
        : m_index(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, kAxes, kButtons, 1))
        , m_id(SDL_JoystickGetDeviceInstanceID(m_index))
    {
    }
    ~VirtualJoystick() { unplug(); }
    VirtualJoystick(const VirtualJoystick &) = delete;
    VirtualJoystick &operator=(const VirtualJoystick &) = delete;

    [[nodiscard]] bool isThere() const { return m_index >= 0; }
    void unplug()
    {
        for (int at = 0; m_id >= 0 && at < SDL_NumJoysticks(); ++at) {
            if (SDL_JoystickGetDeviceInstanceID(at) == m_id)
                SDL_JoystickDetachVirtual(at);
        }
        m_id = -1;
    }
    void move(int axis, Sint16 position)
    {
        SDL_JoystickSetVirtualAxis(SDL_JoystickFromInstanceID(m_id), axis, position);
    }
    void press(int button, bool down)
    {
        SDL_JoystickSetVirtualButton(SDL_JoystickFromInstanceID(m_id), button, down ? 1 : 0);
    }
    void turnHat(Uint8 direction)
    {
        SDL_JoystickSetVirtualHat(SDL_JoystickFromInstanceID(m_id), 0, direction);
    }

private:
    int m_index;
    SDL_JoystickID m_id;
};

}  // namespace

class TestGamepadModule : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void aJoystickArrives();
    void aHatIsFourButtons();
    void anOrdinaryPadHasADefault();
    void pluggingInAndOutIsNoticed();

private:
    QByteArray m_kept;
    std::unique_ptr<QObject> m_user;
    std::unique_ptr<Gamepad> m_gamepad;
};

void TestGamepadModule::init()
{
    m_kept.clear();
    m_user = std::make_unique<QObject>();
    m_gamepad = std::make_unique<Gamepad>(
        Gamepad::Store{[this](const QByteArray &) { return m_kept; },
                       [this](const QByteArray &, const QByteArray &json) { m_kept = json; }},
        loadGamepadModule);
    m_gamepad->use(*m_user);
    QTRY_VERIFY(m_gamepad->snapshot().at != TimePoint() || m_gamepad->error());
    QVERIFY2(!m_gamepad->error(), qPrintable(m_gamepad->error().value_or(Error()).detail));
    QVERIFY(SDL_WasInit(SDL_INIT_JOYSTICK));
    QVERIFY(!SDL_WasInit(SDL_INIT_VIDEO));
}

void TestGamepadModule::cleanup()
{
    m_gamepad.reset();
    QVERIFY(!SDL_WasInit(SDL_INIT_JOYSTICK));
}

void TestGamepadModule::aJoystickArrives()
{
    VirtualJoystick stick;
    QVERIFY(stick.isThere());
    QTRY_VERIFY(m_gamepad->snapshot().isAlive(Clock::now()));
    QVERIFY(!m_gamepad->snapshot().name.isEmpty());
    QCOMPARE(m_gamepad->reading()->axes.size(), std::size_t(kAxes));
    QCOMPARE(m_gamepad->reading()->guid.size(), 32);
    GamepadMapping mapping;
    mapping.assign(GamepadStick::Pitch, 1, true);
    mapping.assign(GamepadStick::Throttle, 2, false);
    mapping.assign(GamepadButton::Disarm, 3);
    m_gamepad->setMapping(mapping);
    QCOMPARE(GamepadMapping::fromJson(m_kept), mapping);
    stick.move(1, -kFull - 1);
    stick.move(2, kFull);
    QTRY_COMPARE(m_gamepad->snapshot()[GamepadStick::Pitch], 1.0);
    QTRY_COMPARE(m_gamepad->snapshot()[GamepadStick::Throttle], 1.0);
    stick.move(1, kFull / 2);
    QTRY_VERIFY(std::abs(m_gamepad->snapshot()[GamepadStick::Pitch] + (0.5 - 0.05) / 0.95) < 0.001);
    stick.press(3, true);
    QTRY_VERIFY(m_gamepad->snapshot().isHeld(GamepadButton::Disarm));
    QCOMPARE(m_gamepad->snapshot().pressesOf(GamepadButton::Disarm), 1u);
}

void TestGamepadModule::aHatIsFourButtons()
{
    VirtualJoystick stick;
    QTRY_VERIFY(m_gamepad->reading().has_value());
    QCOMPARE(m_gamepad->reading()->buttons.size(), std::size_t(kButtons) + 4);
    stick.turnHat(SDL_HAT_RIGHTDOWN);
    QTRY_VERIFY(m_gamepad->reading()->buttons == (std::vector<bool>{0, 0, 0, 0, 0, 0, 0, 1, 1, 0}));
}

// SDL knows which axis is which.
void TestGamepadModule::anOrdinaryPadHasADefault()
{
    m_gamepad->setUse(GamepadUse::Flight);
    VirtualJoystick stick;
    QTRY_VERIFY(m_gamepad->reading().has_value());
    QVERIFY2(m_gamepad->isStandard(), m_gamepad->reading()->layout.constData());
    stick.move(1, -kFull - 1);
    QTRY_COMPARE(m_gamepad->snapshot()[GamepadStick::Throttle], 1.0);
    stick.move(2, kFull);
    QTRY_COMPARE(m_gamepad->snapshot()[GamepadStick::Roll], 1.0);
    QCOMPARE(m_gamepad->snapshot()[GamepadStick::Yaw], 0.0);
}

void TestGamepadModule::pluggingInAndOutIsNoticed()
{
    QVERIFY(!m_gamepad->snapshot().connected);
    QSignalSpy lost(m_gamepad.get(), &Gamepad::lost);
    quint64 session = 0;
    for (int turn = 1; turn <= 3; ++turn) {
        QSignalSpy changed(m_gamepad.get(), &Gamepad::changed);
        VirtualJoystick stick;
        QTRY_VERIFY(!changed.isEmpty());
        QTRY_VERIFY(m_gamepad->snapshot().isAlive(Clock::now()));
        QVERIFY(m_gamepad->snapshot().session > session);
        session = m_gamepad->snapshot().session;
        stick.unplug();
        QTRY_COMPARE(lost.size(), turn);
        QVERIFY(!m_gamepad->snapshot().connected);
    }
}

QTEST_GUILESS_MAIN(TestGamepadModule)
#include "tst_gamepadmodule.moc"
