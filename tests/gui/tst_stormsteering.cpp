// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/controlpage.h"
#include "protocol/base/framelistener.h"
#include "protocol/storm32/commands.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/stormwindow.h"
#include "widgets/models/parametermodel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <mutex>

using namespace Qt::StringLiterals;

namespace {

constexpr int kLimitedAngle = 1;
constexpr int kUnlimitedAngle = 2;
constexpr int kPulse = 3;
constexpr int kHoldHoldHold = 2;  // pan modes
constexpr int kPanPanPan = 3;
constexpr double kMiddlePulse = 1500.0;
constexpr double kTolerance = 0.5;  // degrees

using PerAxis = std::array<double, kAxisCount>;

/// A set-point as it left: angles in degrees or pulses in microseconds from the middle.
struct Sent
{
    bool pulses = false;
    PerAxis values{};
};

/// The set-points among the frames that leave for the board.
class SetpointTap final : public FrameListener
{
public:
    explicit SetpointTap(DeviceClient &client)
        : m_client(client)
    {
        m_client.addListener(*this);
    }
    ~SetpointTap() override { m_client.removeListener(*this); }
    SetpointTap(const SetpointTap &) = delete;
    SetpointTap &operator=(const SetpointTap &) = delete;

    void frameReceived(const FrameView &, TimePoint, bool) override { }
    void bytesSent(QByteArrayView bytes, TimePoint) override
    {
        constexpr int kHead = 3;  // start sign, length, command
        if (bytes.size() < kHead || quint8(bytes[0]) != 0xFA)
            return;
        const int command = quint8(bytes[2]);
        Sent sent;
        sent.pulses = command == int(storm32::Rc::SetPitchRollYaw);
        if (!sent.pulses && command != int(storm32::Rc::SetAngle))
            return;
        ByteReader reader(asBytes(bytes).subspan(kHead));
        for (const std::size_t axis : {1, 0, 2})  // pitch, roll, yaw
            sent.values[axis] = sent.pulses ? reader.u16() - kMiddlePulse : double(reader.f32());
        const std::lock_guard lock(m_mutex);
        m_sent.push_back(sent);
    }
    std::vector<Sent> take()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_sent, {});
    }

private:
    DeviceClient &m_client;
    std::mutex m_mutex;
    std::vector<Sent> m_sent;
};

QString text(const PerAxis &values)
{
    return u"roll %1 pitch %2 yaw %3"_s.arg(values[0]).arg(values[1]).arg(values[2]);
}

bool isNear(const PerAxis &a, const PerAxis &b, double tolerance)
{
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (!(std::abs(a[axis] - b[axis]) < tolerance))
            return false;
    }
    return true;
}

}  // namespace

/// Arming the control page on a STorM32 moves nothing, whatever was steered before and however.
class TestStormSteering : public StormWindowTest
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<WindowRig>();
        QVERIFY(openStorm());
        workspace().changeWorld(u"shake=0"_s);
        m_tap = std::make_unique<SetpointTap>(m_rig->client());
        m_page = m_rig->page<ControlPage>();
        m_rig->settings().setDisarmSeconds(60);
    }
    void cleanup()
    {
        m_tap.reset();
        m_rig.reset();
    }

    void armingMovesNothing_data();
    void armingMovesNothing();
    void pulledBeforeAnythingWasSent();

private:
    [[nodiscard]] PerAxis angles() { return latest(workspace().roles().angle); }
    [[nodiscard]] PerAxis inputs()
    {
        const ChannelTable table = m_rig->client().device()->channels();
        return latest({findChannel(table, u"input.roll"_s), findChannel(table, u"input.pitch"_s),
                       findChannel(table, u"input.yaw"_s)});
    }
    PerAxis latest(const std::array<int, kAxisCount> &channels)
    {
        PerAxis values{};
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            values[axis] = workspace().latest(channels[axis]);
        return values;
    }
    void choose(int mode)
    {
        auto *modes = named<QComboBox>(m_page, u"Mode of control"_s);
        modes->setCurrentIndex(modes->findData(mode));
    }
    bool holdFromTheStart();
    bool reconnect();
    bool comesToRest();
    bool steerTo(const PerAxis &where);
    QString arm(bool known);
    QString steerAndArm(int mode, const PerAxis &where, bool pans);

    std::unique_ptr<SetpointTap> m_tap;
    ControlPage *m_page = nullptr;
};

/// The board starts again as one whose axes never pan. Of one that has panned it is not known what its angles
/// are counted from.
bool TestStormSteering::holdFromTheStart()
{
    m_rig->edit(u"pan.mode.default"_s, 0, kHoldHoldHold - 1);
    if (!writeAll())
        return false;
    workspace().perform(u"restart"_s, {});
    return m_rig->jobsAreDone() && reconnect()
        && QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience);
}

/// The cable is pulled and plugged in again.
bool TestStormSteering::reconnect()
{
    QSignalSpy lost(&m_rig->client(), &DeviceClient::connectionLost);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    return QTest::qWaitFor([&lost] { return lost.count() == 1; }, kPatience)
        && QTest::qWaitFor([this] { return m_rig->client().isConnected() && m_rig->boardGoesOn(0.2); },
                           kPatience);
}

bool TestStormSteering::comesToRest()
{
    for (int i = 0; i < 40; ++i) {
        const PerAxis before = angles();
        if (!m_rig->boardGoesOn(1.0))
            return false;
        if (isNear(before, angles(), 0.1))
            return true;
    }
    return false;
}

/// Steers the camera there and waits until it has come to rest.
bool TestStormSteering::steerTo(const PerAxis &where)
{
    const PerAxis before = angles();
    m_page->setArmed(true);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        named<QDoubleSpinBox>(m_page, u"Angle, %1"_s.arg(axisLabel(kAxes[axis])))->setValue(where[axis]);
    if (!QTest::qWaitFor([&] { return std::abs(angles()[1] - before[1]) > 3.0; }, kPatience))
        return false;
    if (!comesToRest())
        return false;
    m_page->setArmed(false);
    return m_rig->boardGoesOn(0.5);
}

/// Arms and disarms; what was wrong, or nothing. @param known it is known where to hold the camera, so that
/// set-points are sent
QString TestStormSteering::arm(bool known)
{
    const PerAxis before = angles();
    const PerAxis sticks = inputs();
    m_tap->take();
    m_page->setArmed(true);
    if (!m_page->isArmed())
        return u"cannot be armed"_s;
    if (!m_rig->boardGoesOn(1.0))
        return u"no telemetry"_s;
    const PerAxis armed = angles();
    const auto labels = m_page->findChildren<QLabel *>();
    const bool saysSo = std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
        return label->text().startsWith(u"Armed, but nothing is sent yet"_s);
    });
    m_page->setArmed(false);
    if (!m_rig->boardGoesOn(0.5))
        return u"no telemetry"_s;
    if (!isNear(before, armed, kTolerance) || !isNear(before, angles(), kTolerance))
        return u"moved from %1 over %2 to %3"_s.arg(text(before), text(armed), text(angles()));
    const std::vector<Sent> all = m_tap->take();
    if (known == all.empty() || known == saysSo)
        return u"%1 set-points, the page says %2"_s.arg(all.size()).arg(saysSo);
    for (const Sent &sent : all) {
        if (!isNear(sent.values, sent.pulses ? sticks : before, kTolerance))
            return u"at %1, sticks %2, sent %3"_s.arg(text(before), text(sticks), text(sent.values));
    }
    return {};
}

void TestStormSteering::armingMovesNothing_data()
{
    QTest::addColumn<bool>("pans");
    QTest::newRow("all axes hold") << false;
    QTest::newRow("all axes pan") << true;
}

void TestStormSteering::armingMovesNothing()
{
    QFETCH(const bool, pans);
    if (pans)
        workspace().perform(u"pan.mode"_s, {{u"mode"_s, kPanPanPan}});
    else
        QVERIFY(holdFromTheStart());
    QVERIFY(comesToRest());
    std::vector<std::pair<int, PerAxis>> ways{{kUnlimitedAngle, {3, -8, 40}}};
    if (!pans)
        ways = {{kLimitedAngle, {4, 11, -14}}, {kUnlimitedAngle, {-3, -9, 50}}, {kPulse, {60, 180, -210}}};
    for (const auto &[mode, where] : ways) {
        const QString wrong = steerAndArm(mode, where, pans);
        QVERIFY2(wrong.isEmpty(), qPrintable(u"steered by mode %1: %2"_s.arg(mode).arg(wrong)));
    }
}

/// Arms before and after steering, in each mode, and after the cable was pulled while armed; what was wrong,
/// or nothing.
QString TestStormSteering::steerAndArm(int mode, const PerAxis &where, bool pans)
{
    // Angles and stick positions add up, and an axis that pans counts from the frame: then it is not known
    // what angle is to be held, and nothing is sent before one is chosen.
    bool watched = true;  // since the board's start
    const auto isKnown = [mode, pans, &watched](int steered) {
        return steered == kPulse || (mode != kPulse && !pans && watched);
    };
    const auto inEachMode = [this, mode, isKnown] {
        for (const int other : {kLimitedAngle, kUnlimitedAngle, kPulse, mode}) {
            choose(other);
            if (const QString wrong = arm(isKnown(other)); !wrong.isEmpty())
                return u"then armed in mode %1: %2"_s.arg(other).arg(wrong);
        }
        return QString();
    };
    choose(mode);
    if (const QString wrong = arm(isKnown(mode)); !wrong.isEmpty())
        return u"before: "_s + wrong;
    if (!steerTo(where))
        return u"cannot be steered"_s;
    if (const QString wrong = inEachMode(); !wrong.isEmpty())
        return wrong;
    // What the board was steered to, it holds.
    m_page->setArmed(true);
    if (!reconnect() || m_page->isArmed())
        return u"the cable was pulled"_s;
    // Nobody knows what happened to it meanwhile, until the operator says so.
    auto *word = named<QCheckBox>(m_page, u"Not in pan mode since it started"_s);
    for (const bool given : {false, true}) {
        const bool isAsked = !pans && mode != kPulse;
        if (!QTest::qWaitFor([&] { return word->isVisible() == isAsked; }, kPatience) || word->isChecked())
            return u"the operator's word"_s;
        word->setChecked(given && isAsked);
        watched = given;
        if (const QString wrong = inEachMode(); !wrong.isEmpty())
            return u"after the cable was pulled, word %1, "_s.arg(given) + wrong;
    }
    return {};
}

// Nobody knows what holds the camera after the cable was pulled; so nothing is sent, and there is nothing to
// confirm.
void TestStormSteering::pulledBeforeAnythingWasSent()
{
    QVERIFY(reconnect());
    choose(kUnlimitedAngle);
    QSignalSpy ended(&m_rig->client(), &DeviceClient::steeringEnded);
    m_tap->take();
    m_page->setArmed(true);
    QVERIFY(m_rig->boardGoesOn(1.0));
    QVERIFY(m_page->isArmed() && m_tap->take().empty());
    QVERIFY(reconnect());
    QVERIFY(!m_page->isArmed());
    QCOMPARE(ended.count(), 0);
}

QTEST_MAIN(TestStormSteering)
#include "tst_stormsteering.moc"
