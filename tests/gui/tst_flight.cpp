// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/board/stickstepcard.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/workspace/flightstate.h"
#include "app/workspace/question.h"
#include "protocol/base/framelistener.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/fakegamepads.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/panel.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/motordiagram.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QTcpSocket>
#include <QThread>
#include <QTimer>

#include <mutex>
#include <thread>

using namespace Qt::StringLiterals;
using Phase = ArmingSession::Phase;

namespace {

constexpr int kAttempts = 4;

/// The controls among what leaves for the drone.
class ControlsTap final : public FrameListener
{
public:
    explicit ControlsTap(DeviceClient &client)
        : m_client(client)
    {
        m_client.addListener(*this);
    }
    ~ControlsTap() override { m_client.removeListener(*this); }
    void frameReceived(const FrameView &, TimePoint, bool) override { }
    void bytesSent(QByteArrayView bytes, TimePoint) override
    {
        if (bytes.startsWith(char(0x85)))  // asked in the same packet
            bytes = bytes.sliced(1);
        if (bytes.size() < 7 || quint8(bytes[0]) != 0x83)
            return;
        const auto controls
            = bcflight::Controls::decode(asBytes(bytes.sliced(1, 6)), bcflight::Generation::G);
        const std::lock_guard lock(m_mutex);
        m_sent.push_back(*controls);
        m_stops += bytes.size() > 7 ? 1 : 0;
    }
    std::vector<bcflight::Controls> take()
    {
        const std::lock_guard lock(m_mutex);
        m_stops = 0;
        return std::exchange(m_sent, {});
    }
    int count()
    {
        const std::lock_guard lock(m_mutex);
        return int(m_sent.size());
    }
    int stops()
    {
        const std::lock_guard lock(m_mutex);
        return m_stops;
    }

private:
    DeviceClient &m_client;
    std::mutex m_mutex;
    std::vector<bcflight::Controls> m_sent;
    int m_stops = 0;
};

}  // namespace

class TestFlight;
using Change = void (*)(TestFlight &);

/// Flying from the window: what is required before, and everything that ends it, seen on a simulated drone.
class TestFlight final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void nothingIsSentBeforeTheKey();
    void directionsAreCheckedThenItFlies();
    void sessionIsOpenedByTheOperatorsWord();
    void pressIsRefusedMeanwhile();
    void whatItTellsKeepsItDisarmed();
    void lateNewsAreNoDisarming();
    void unknownIsDisarmedAndNotArmed();
    void everythingEndsIt_data();
    void everythingEndsIt();
    void sticksReachTheDrone();
    void horizonIsDrawnAsFound();
    void armedTheKeysAreForTheSticks();
    void heldSpaceBarArms();
    void gamepadSteersAndItsLossDisarms();
    void spaceDisarmsWhereverTheKeyboardIs();
    void disarmStopsWhatSomebodyElseHasArmed();
    void gainsDisarmFirst();
    void stepIsMeasuredInAStand();
    void closingIsRefusedWhileArmed();
    void closingWaitsUntilItIsSeenToStand();
    void disarmedIsNotStanding();
    void whoeverLeavesTheLinkDisarms_data();
    void whoeverLeavesTheLinkDisarms();
    void guardStandsBy();
    void foundAgainItIsDisarmed();
    void silenceInTheAirIsTold();
    void lostLinkIsLeftAllTheSame();  // the program ends, and begins again
    void lostLinkIsWarnedOf();  // the cable stays pulled

private:
    MainWindow &window() { return m_rig->window(); }
    FlightPage &page() { return *m_page; }
    [[nodiscard]] double told(int channel) const { return m_rig->client().telemetry()->latest(channel); }
    [[nodiscard]] bool isArmed() const { return told(m_rig->client().roles().armed) == 1; }
    /// As the drone has told since this call.
    bool isSoon(int channel, double value)
    {
        const TimePoint asked = Clock::now();
        return QTest::qWaitFor(
            [&] {
                const auto store = m_rig->client().telemetry();
                return store->latestAt(channel) > asked && store->latest(channel) == value;
            },
            kPatience);
    }
    /// Says that all directions were found right.
    void trust()
    {
        CheckedDirections all;
        all.level = CheckedDirections::Level::All;
        keepDirections(m_rig->workspace(), all);
    }
    [[nodiscard]] bool says(const QString &words)
    {
        const auto labels = page().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
                           [&words](const QLabel *label) { return label->text().contains(words); });
    }
    [[nodiscard]] bool isReady()
    {
        return page().stateText().contains(u"Ready"_s) && page().armButton()->isEnabled();
    }
    bool calibrate();
    bool arm(bool held = true);
    /// Connects to another drone, calibrates and arms it, and gives it throttle.
    bool fly(const QString &address);
    /// A press of the key does nothing, and that is why.
    bool isRefused(const QString &why);
    /// Another ground posts it: nobody here waits for anything.
    void post(const QByteArray &packet);
    void pose(int number) { m_rig->workspace().changeWorld(u"pose=%1"_s.arg(number)); }

    std::unique_ptr<WindowRig> m_rig;
    FlightPage *m_page = nullptr;
    FakeGamepads m_pads;
};

void TestFlight::initTestCase()
{
    m_rig = std::make_unique<WindowRig>();
    m_rig->workspace().gamepad().setMaker(m_pads.maker());
    QVERIFY(m_rig->open(u"sim:bcflight?stand=1&seed=41"_s));
    m_page = m_rig->page<FlightPage>();
    QVERIFY(m_page);
    QVERIFY(calibrate());
}

bool TestFlight::calibrate()
{
    if (!isSoon(m_rig->client().roles().armed, 0))
        return false;
    m_rig->workspace().changeWorld(u"shake=0"_s);
    pose(1);  // held still: in the stand it turns freely
    const auto done = m_rig->workspace().perform(u"calibrate.all"_s, {});
    return QTest::qWaitFor([&] { return done.isFinished(); }, kPatience)
        && isSoon(m_rig->client().roles().calibrated, 1);
}

void TestFlight::init()
{
    if (!m_rig->client().isConnected()) {
        QVERIFY(m_rig->open(u"sim:bcflight?stand=1&seed=41"_s));
        QVERIFY(calibrate());
    }
    window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    m_page = m_rig->page<FlightPage>();
    pose(0);
    trust();
}

void TestFlight::cleanup()
{
    page().directions()->cancel();
    page().padChoice()->setChecked(false);
    if (page().session().phase() != Phase::Closed)
        page().sessionButton()->click();
    if (m_rig->client().isConnected())
        QVERIFY(isSoon(m_rig->client().roles().armed, 0));
}

bool TestFlight::arm(bool held)
{
    // A computer that is too busy to send in time does not arm it.
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        page().open(held);
        if (!QTest::qWaitFor([this] { return isReady(); }, kPatience))
            break;
        QTest::mousePress(page().armButton(), Qt::LeftButton);
        const auto isDecided = [this] {
            return page().session().phase() == Phase::Armed || page().session().phase() == Phase::Open;
        };
        std::ignore = QTest::qWaitFor(isDecided, kPatience);
        QTest::mouseRelease(page().armButton(), Qt::LeftButton);
        if (page().session().phase() == Phase::Armed)
            return true;
        if (page().session().ended() != ArmingBar::Hung)
            break;
    }
    qInfo().noquote() << "not armed:" << page().stateText();
    return false;
}

bool TestFlight::fly(const QString &address)
{
    if (!m_rig->open(address))
        return false;
    m_page = m_rig->page<FlightPage>();
    const auto calibrated = m_rig->workspace().perform(u"calibrate.all"_s, {});
    if (!QTest::qWaitFor([&] { return calibrated.isFinished(); }, kPatience)
        || !isSoon(m_rig->client().roles().calibrated, 1))
        return false;
    trust();
    if (!arm())
        return false;
    page().throttle()->setValue(20);
    return isSoon(m_rig->client().roles().outputs, 1);
}

void TestFlight::nothingIsSentBeforeTheKey()
{
    ControlsTap tap(m_rig->client());
    QVERIFY(m_rig->boardGoesOn(0.5));
    page().open(false);
    QVERIFY(m_rig->boardGoesOn(0.5));
    QVERIFY(tap.take().empty());
    // A short press arms nothing.
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(tap.count() > 0, kPatience);
    QTest::mouseRelease(page().armButton(), Qt::LeftButton);
    QVERIFY(m_rig->boardGoesOn(1.5));
    for (const bcflight::Controls &controls : tap.take())
        QVERIFY(!controls.arm);
    QVERIFY(!isArmed());
    // Nor one that is let go of beside the button, without a move of the pointer.
    const QPoint place = page().armButton()->mapTo(&window(), QPoint());
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Holding, kPatience);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(page().armButton()->mapTo(&window(), QPoint()), place);
    QTest::mouseRelease(page().armButton(), Qt::LeftButton, {}, QPoint(-40, -40));
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Open, kPatience);
    QVERIFY(m_rig->boardGoesOn(1.5));
    for (const bcflight::Controls &controls : tap.take())
        QVERIFY(!controls.arm);
}

// As an operator does it: tilt, push, arm without propellers, look, answer.
void TestFlight::directionsAreCheckedThenItFlies()
{
    // Of another drone, and with another configuration.
    const QByteArray key = m_rig->client().device()->flight()->axesKey(std::as_const(m_rig->model()).board());
    m_rig->settings().setCheckedDirections(m_rig->client().identity().serial, "other", "2++++++");
    m_rig->settings().setCheckedDirections(u"another"_s, key, "2++++++");
    page().open(false);
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    QVERIFY(m_rig->boardGoesOn(1.5));
    QTest::mouseRelease(page().armButton(), Qt::LeftButton);
    QVERIFY(!isArmed());
    QVERIFY(page().stateText().contains(u"directions"_s));

    DirectionCard *card = page().directions();
    // Whoever tilts it by hand knows before what its motors do then.
    const QString full = u"drives motors up to full throttle"_s;
    QVERIFY(says(full));
    pose(1);
    QVERIFY(m_rig->boardGoesOn(1));
    QTest::mouseClick(card->beginButton(), Qt::LeftButton);
    QVERIFY(card->isChecking());
    const auto step = [card] { return card->check() ? card->check()->stepNumber() : -1; };
    const auto seen
        = [card] { return card->check() && card->check()->sight() == DirectionCheck::Sight::Seen; };
    for (const int tilted : {2, 4, 6}) {
        const int before = step();
        pose(tilted);
        QTRY_VERIFY_WITH_TIMEOUT(seen(), kPatience);
        pose(1);
        QTRY_COMPARE_WITH_TIMEOUT(step(), before + 1, kPatience);
    }
    const auto push = [this](int axis, int percent) {
        if (axis == 2) {
            page().yaw()->setValue(percent);
            return;
        }
        // The pad is held with the mouse, as far as it goes.
        const QPoint middle = page().pad()->rect().center();
        const QPoint edge
            = axis == 0 ? QPoint(page().pad()->width() / 3, 0) : QPoint(0, -page().pad()->height() / 3);
        if (percent > 0)
            QTest::mousePress(page().pad(), Qt::LeftButton, {}, middle + edge);
        else
            QTest::mouseRelease(page().pad(), Qt::LeftButton, {}, middle + edge);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int before = step();
        push(axis, 100);
        QTRY_VERIFY_WITH_TIMEOUT(seen(), kPatience);
        push(axis, 0);
        QTRY_COMPARE_WITH_TIMEOUT(step(), before + 1, kPatience);
    }
    QVERIFY(card->wantsArmed());
    QVERIFY(says(full));
    // In a stand the propellers are on: not for this.
    page().sessionButton()->click();
    page().open(true);
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    QVERIFY(m_rig->boardGoesOn(1.5));
    QTest::mouseRelease(page().armButton(), Qt::LeftButton);
    QVERIFY(!isArmed() && page().session().phase() == Phase::Open);
    page().sessionButton()->click();
    ControlsTap tap(m_rig->client());
    const auto ready = [card] { return card->check() && card->check()->isReady(); };
    QVERIFY(arm(false));
    const QPoint place = card->yesButton()->mapTo(card, QPoint());
    QList<int> onTheRight;
    QList<int> inFront;
    page().throttle()->setValue(60);  // no more than is allowed for the check
    for (const int tilted : {2, 4, 6}) {
        const int before = step();
        QTRY_VERIFY_WITH_TIMEOUT(ready() && says(u"compared once it is turned that way by 15"_s), kPatience);
        pose(tilted);
        QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        // The picture marks the motors that are asked about.
        QCOMPARE(card->asked().size(), 2);
        if (tilted == 2)
            onTheRight = card->asked();
        else if (tilted == 4)
            inFront = card->asked();
        QTRY_COMPARE_WITH_TIMEOUT(page().findChild<MotorDiagram *>()->asked(), card->asked(), kPatience);
        QTest::mouseClick(card->yesButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(step(), before + 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(page().findChild<MotorDiagram *>()->asked().isEmpty(), kPatience);
        pose(1);
        QVERIFY(m_rig->boardGoesOn(1.2));
        page().throttle()->setValue(page().throttle()->value() == 60 ? 59 : 60);
    }
    for (const bcflight::Controls &controls : tap.take())
        QVERIFY(controls.thrust <= DirectionCheck::kMostThrottle + 0.001);
    for (int axis = 0; axis < 3; ++axis) {
        QTRY_VERIFY_WITH_TIMEOUT(ready() && says(u"compared once the stick is pushed"_s), kPatience);
        push(axis, 100);
        QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        QCOMPARE(card->yesButton()->mapTo(card, QPoint()), place);
        // On this drone yaw is counted the other way round: the stick is reversed, then it is right.
        if (axis == 2) {
            QTest::mouseClick(card->noButton(), Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(!card->check() || card->check()->found().sticks[2] == -1, kPatience);
            push(axis, 0);
            QTRY_VERIFY_WITH_TIMEOUT(ready(), kPatience);
            push(axis, 100);
            QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        }
        QTest::mouseClick(card->yesButton(), Qt::LeftButton);
        push(axis, 0);
        QVERIFY(m_rig->boardGoesOn(0.3));
    }
    QTRY_VERIFY_WITH_TIMEOUT(!card->isChecking(), kPatience);
    QCOMPARE(card->found().level, CheckedDirections::Level::All);
    QCOMPARE(card->found().sticks, (std::array{1, 1, -1}));
    // From now on the picture shows where they are.
    QVERIFY(m_rig->boardGoesOn(0.3));
    const auto *picture = page().findChild<MotorDiagram *>();
    QVERIFY(picture->areSidesKnown());
    for (const int motor : std::as_const(onTheRight))
        QVERIFY(picture->placeOf(motor).x() > QRectF(picture->rect()).center().x());
    for (const int motor : std::as_const(inFront))
        QVERIFY(picture->placeOf(motor).y() < QRectF(picture->rect()).center().y());
    // It was armed for the check, with little throttle: what comes after begins with the key.
    QCOMPARE(page().session().phase(), Phase::Open);
    QCOMPARE(page().session().ended(), ArmingBar::CheckOver);
    QCOMPARE(page().throttle()->value(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(!isArmed(), kPatience);
}

// Never by itself, and not while somebody else has it armed.
void TestFlight::sessionIsOpenedByTheOperatorsWord()
{
    page().sessionButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<QMessageBox *>(), kPatience);
    QCOMPARE(page().session().phase(), Phase::Closed);
    window().findChild<QMessageBox *>()->reject();
    QTRY_VERIFY_WITH_TIMEOUT(!window().findChild<QMessageBox *>(), kPatience);
    QCOMPARE(page().session().phase(), Phase::Closed);
    // Over and over: the end of what was flown before may still be on its way.
    const auto armsIt = [](Channel &channel, Device &) -> Result<void> {
        Request another;
        another.bytes = encode(bcflight::Message::Controls,
                               bcflight::Controls{.arm = true}.encode(bcflight::Generation::G),
                               bcflight::Generation::G);
        channel.post(another);
        return {};
    };
    QTimer another;
    connect(&another, &QTimer::timeout, this, [&] { m_rig->client().submit<void>(armsIt); });
    another.start(50ms);
    QTRY_VERIFY_WITH_TIMEOUT(isArmed(), kPatience);
    QVERIFY(m_rig->boardGoesOn(1));
    QVERIFY(isSoon(m_rig->client().roles().armed, 1));
    page().sessionButton()->click();
    QVERIFY(!window().findChild<QMessageBox *>());
    QCOMPARE(page().session().phase(), Phase::Closed);
    another.stop();
    QVERIFY(m_rig->jobsAreDone());
    m_rig->workspace().setMotors(false);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
}

bool TestFlight::isRefused(const QString &why)
{
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    const bool isOpen = page().session().phase() == Phase::Open;
    QTest::mouseRelease(page().armButton(), Qt::LeftButton);
    return isOpen && page().stateText().contains(why);
}

void TestFlight::post(const QByteArray &packet)
{
    m_rig->client().submit<void>([packet](Channel &channel, Device &) -> Result<void> {
        Request order;
        order.bytes = packet;
        channel.post(order);
        return {};
    });
}

void TestFlight::pressIsRefusedMeanwhile()
{
    page().open(true);
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), kPatience);
    pose(1);
    const auto done = m_rig->workspace().perform(u"calibrate.gyro"_s, {});
    QVERIFY2(isRefused(u"at work"_s), qPrintable(page().stateText()));
    QTRY_VERIFY_WITH_TIMEOUT(done.isFinished(), kPatience);
    QVERIFY(isSoon(m_rig->client().roles().calibrated, 1));
    pose(0);
    m_rig->edit(u"pid.roll.p"_s, 0, double(float(m_rig->raw(u"pid.roll.p"_s) * 1.1)));
    m_rig->workspace().write(std::as_const(m_rig->model()).edited());
    QVERIFY(m_rig->workspace().isWriting());
    QVERIFY2(isRefused(u"at work"_s), qPrintable(page().stateText()));
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->workspace().isWriting() && m_rig->jobsAreDone(), kPatience);
    // A stop that nothing has proven yet.
    QVERIFY(arm());
    m_rig->workspace().changeWorld(u"runs-on=1"_s);
    QVERIFY(m_rig->boardGoesOn(0.2));
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    m_rig->workspace().setMotors(false);
    QTRY_VERIFY_WITH_TIMEOUT(stopped.count() > 0, kPatience);
    QVERIFY(!stopped.first().first().toBool());
    QVERIFY2(isRefused(u"being stopped"_s), qPrintable(page().stateText()));
    m_rig->workspace().changeWorld(u"runs-on=0"_s);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->client().isStopUnproven(), kPatience);
}

// Whatever is done here: somebody else may be at it, and a drone that was just switched on knows nothing.
void TestFlight::whatItTellsKeepsItDisarmed()
{
    page().open(true);
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), kPatience);
    pose(1);
    post(encode(bcflight::Message::Calibrate, bcflight::bigU32(0) + bcflight::bigF32(0)));
    QVERIFY(isSoon(m_rig->client().roles().calibrating, 1));
    QVERIFY2(isRefused(u"it is calibrating"_s), qPrintable(page().stateText()));
    QVERIFY(isSoon(m_rig->client().roles().calibrated, 1));
    QVERIFY(m_rig->open(u"sim:bcflight?stand=1&seed=42"_s));
    trust();
    page().open(true);
    QVERIFY(isSoon(m_rig->client().roles().calibrated, 0));
    QVERIFY2(isRefused(u"it is not calibrated"_s), qPrintable(page().stateText()));
    m_rig->client().disconnectFromBoard();
}

// What comes late says nothing yet of what was ordered: until then it is shown as neither disarmed nor safe.
void TestFlight::lateNewsAreNoDisarming()
{
    page().open(true);
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), kPatience);
    const auto *tile = page().findChild<ArmedState *>();
    QTRY_COMPARE(tile->state(), ArmedState::State::Disarmed);
    QVERIFY(page().armButton()->isEnabled() && !page().disarmButton()->isEnabled());
    QTest::mousePress(page().armButton(), Qt::LeftButton);
    bool wasAsked = false;
    bool wasCalm = false;
    const auto isOver = [&] {
        if (page().session().phase() == Phase::Asked) {
            wasAsked = true;
            wasCalm |= ArmedState::isDisarmed(tile->state()) || page().armButton()->isEnabled()
                || !page().disarmButton()->isEnabled() || m_rig->workspace().motorsRunning() == false;
        }
        return page().session().phase() == Phase::Armed || page().session().phase() == Phase::Open;
    };
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Holding, kPatience);
    m_rig->workspace().changeWorld(u"late=400"_s);
    QTRY_VERIFY_WITH_TIMEOUT(isOver(), kPatience);
    QTest::mouseRelease(page().armButton(), Qt::LeftButton);
    QVERIFY(wasAsked && !wasCalm);
    page().disarmButton()->click();
    m_rig->workspace().changeWorld(u"late=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(tile->state(), ArmedState::State::Disarmed, kPatience);
    QTRY_VERIFY(!page().disarmButton()->isEnabled());
}

// Where nothing is told, the key that disarms works, and the one that arms does not.
void TestFlight::unknownIsDisarmedAndNotArmed()
{
    page().open(true);
    QTRY_VERIFY_WITH_TIMEOUT(page().armButton()->isEnabled(), kPatience);
    m_rig->workspace().changeWorld(u"replug=2"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    const auto *tile = page().findChild<ArmedState *>();
    bool isRight = false;
    QTRY_VERIFY_WITH_TIMEOUT((isRight |= tile->state() == ArmedState::State::Unknown
                                  && !page().armButton()->isEnabled() && page().disarmButton()->isEnabled()),
                             kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected() && tile->state() == ArmedState::State::Disarmed,
                             kPatience);
}

void TestFlight::everythingEndsIt_data()
{
    QTest::addColumn<int>("why");
    QTest::addColumn<Change>("end");
    const auto row
        = [](const char *name, ArmingBar why, Change end) { QTest::newRow(name) << int(why) << end; };
    row("disarm", ArmingBar::Operator, [](TestFlight &test) { test.page().disarmButton()->click(); });
    row("space", ArmingBar::Operator,
        [](TestFlight &test) { QTest::keyClick(test.page().throttle(), Qt::Key_Space); });
    row("escape", ArmingBar::Operator,
        [](TestFlight &test) { QTest::keyClick(test.page().throttle(), Qt::Key_Escape); });
    row("another page", ArmingBar::Hidden, [](TestFlight &test) { test.window().showPage(u"dashboard"_s); });
    row("another window", ArmingBar::Focus, [](TestFlight &test) {
        QEvent away(QEvent::WindowDeactivate);
        QCoreApplication::sendEvent(&test.page(), &away);
    });
    row("minimised", ArmingBar::Hidden, [](TestFlight &test) { test.page().hide(); });
    row("a list", ArmingBar::Covered, [](TestFlight &test) { test.window().showPalette(); });
    row("a question", ArmingBar::Covered, [](TestFlight &test) {
        askInPanel({u"Which?"_s, {}, {}, u"None"_s}, &test.window());
    });
    row("a question about values", ArmingBar::Covered,
        [](TestFlight &test) { test.page().tuneChoice()->click(); });
    row("a field of the window", ArmingBar::Covered, [](TestFlight &test) {
        auto *field = new QLineEdit(&test.window());
        field->show();
        field->setFocus();
    });
    row("locked", ArmingBar::Locked, [](TestFlight &test) { test.page().onScreenLocked(true); });
    row("session locked", ArmingBar::Locked, [](TestFlight &test) { test.page().onSessionLocked(); });
    row("red button", ArmingBar::Emergency,
        [](TestFlight &test) { test.m_rig->workspace().setMotors(false); });
    row("control released", ArmingBar::Operator,
        [](TestFlight &test) { test.m_rig->workspace().releaseControl(); });
    row("a gamepad is taken up", ArmingBar::Operator,
        [](TestFlight &test) { test.page().padChoice()->setChecked(true); });
    row("another program", ArmingBar::Focus,
        [](TestFlight &) { emit qApp->applicationStateChanged(Qt::ApplicationInactive); });
    row("nobody moves anything", ArmingBar::Idle,
        [](TestFlight &test) { test.m_rig->settings().setDisarmSeconds(2); });
    // For longer than the I/O thread waits for the next set-point.
    row("the window hangs", ArmingBar::Hung, [](TestFlight &) { QThread::sleep(1); });
    row("session closed", ArmingBar::Operator,
        [](TestFlight &test) { test.page().sessionButton()->click(); });
    row("live data fail", ArmingBar::Failed, [](TestFlight &test) {
        emit test.m_rig->client().telemetryFailed({ErrorCode::Timeout, {}, 0});
    });
    row("another client's disarm", ArmingBar::Disarmed, [](TestFlight &test) {
        // What the drone says counts, whoever it was.
        test.m_rig->client().submit<void>([](Channel &channel, Device &device) -> Result<void> {
            return device.perform(channel, u"motors.off"_s, {}).map([](const ActionReply &) {});
        });
    });
    // One packet, and the next set-point from here arms it again: it has said so in between.
    row("another ground's disarm", ArmingBar::Disarmed, [](TestFlight &test) {
        test.m_rig->client().submit<void>([](Channel &channel, Device &device) -> Result<void> {
            Request order;
            order.bytes = device.steering()->controlFrames({1, {0, 0, 0, 0}, {0}}).stop;
            channel.post(order);
            return {};
        });
    });
}

void TestFlight::everythingEndsIt()
{
    QFETCH(int, why);
    QFETCH(Change, end);
    QVERIFY(arm());
    page().throttle()->setValue(20);
    const int outputs = m_rig->client().roles().outputs;
    QVERIFY(isSoon(outputs, 1));
    ControlsTap tap(m_rig->client());
    QSignalSpy hung(&m_rig->client(), &DeviceClient::failsafeActed);
    end(*this);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(isSoon(outputs, 0));
    QTRY_VERIFY_WITH_TIMEOUT(page().session().phase() <= Phase::Open, kPatience);
    QCOMPARE(int(page().session().ended()), why);
    QCOMPARE(hung.count(), ArmingBar(why) == ArmingBar::Hung ? 1 : 0);
    m_rig->settings().setDisarmSeconds(20);
    window().panels()->rejectAll();
    // Repeated at full rate, with the message that stops motors, and never armed again.
    QTRY_VERIFY_WITH_TIMEOUT(tap.stops() >= 15, kPatience);
    std::ignore = tap.take();
    QVERIFY(m_rig->boardGoesOn(1));
    for (const bcflight::Controls &controls : tap.take())
        QVERIFY(!controls.arm);
    QVERIFY(!isArmed());
    QCOMPARE(page().throttle()->value(), 0);
    page().show();
}

void TestFlight::sticksReachTheDrone()
{
    QVERIFY(arm());
    ControlsTap tap(m_rig->client());
    page().throttle()->setValue(30);
    page().yaw()->setValue(50);
    QVERIFY(QTest::qWaitFor([&] {
        const auto sent = tap.take();
        return !sent.empty() && sent.back().arm && std::abs(sent.back().thrust - 0.3) < 0.01
            && std::abs(sent.back().yaw - 0.5) < 0.01 && sent.back().roll == 0;
    }));
    // As it was found to be right for this drone.
    m_rig->settings().setCheckedDirections(
        m_rig->client().identity().serial,
        m_rig->client().device()->flight()->axesKey(std::as_const(m_rig->model()).board()), "2+++++-");
    QVERIFY(QTest::qWaitFor([&] {
        const auto sent = tap.take();
        return !sent.empty() && std::abs(sent.back().yaw + 0.5) < 0.01;
    }));
    trust();
    QTest::keyClick(&page(), Qt::Key_W);
    QCOMPARE(page().throttle()->value(), 32);
    QTest::keyPress(&page(), Qt::Key_A);
    QCOMPARE(page().yaw()->value(), -50);
    QTest::keyRelease(&page(), Qt::Key_A);
    QCOMPARE(page().yaw()->value(), 0);
    // Held, it climbs by time, however often the keyboard repeats it.
    QTest::keyPress(&page(), Qt::Key_W);
    QCOMPARE(page().throttle()->value(), 34);
    for (int i = 0; i < 50; ++i) {
        QKeyEvent again(QEvent::KeyPress, Qt::Key_W, {}, u"w"_s, true);
        QCoreApplication::sendEvent(&page(), &again);
    }
    QCOMPARE(page().throttle()->value(), 34);
    QTRY_VERIFY_WITH_TIMEOUT(page().throttle()->value() > 38, kPatience);
    QTest::keyRelease(&page(), Qt::Key_W);
    const int held = page().throttle()->value();
    QVERIFY(m_rig->boardGoesOn(0.6));
    QCOMPARE(page().throttle()->value(), held);
}

// As its directions were found: the drone counts pitch, and may count it either way.
void TestFlight::horizonIsDrawnAsFound()
{
    auto *view = page().findChild<AttitudeView *>();
    QVERIFY(view);
    const int pitch = m_rig->client().roles().angle[1];
    pose(4);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(m_rig->workspace().latest(pitch)) > 20, kPatience);
    const bool isNegative = m_rig->workspace().latest(pitch) < 0;
    const auto drawn = [view] {
        const QString said = view->accessibleDescription();
        return said.section(u"pitch "_s, 1).section(u'°', 0, 0).replace(u'−', u'-').toDouble();
    };
    // The figures beneath it say the same.
    const auto told = [this] {
        static const QRegularExpression row(u"Pitch</td><td[^>]*>([^ ]+)"_s);
        for (const QLabel *label : page().findChildren<QLabel *>()) {
            if (const auto found = row.match(label->text()); found.hasMatch())
                return found.captured(1).replace(u'−', u'-').toDouble();
        }
        return 0.0;
    };
    for (const bool growsDown : {true, false}) {
        keepDirections(m_rig->workspace(), CheckedDirections::decode(growsDown ? "2++++++" : "2+-++++"));
        // What grows with the nose down and has grown: the nose is down.
        const bool isDown = growsDown != isNegative;
        QTRY_VERIFY2_WITH_TIMEOUT(isDown ? drawn() < -20 : drawn() > 20,
                                  qPrintable(view->accessibleDescription()), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isDown ? told() < -20 : told() > 20, kPatience);
    }
    pose(1);
    trust();
}

// The button that was held leaves the keyboard to the sticks; what was said of the session before is over.
void TestFlight::armedTheKeysAreForTheSticks()
{
    QVERIFY(arm());
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), page().pad(), kPatience);
    QVERIFY(!page().armButton()->isDown());
    // Armed with motors that stand, it can be stopped, and that shows.
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<LinkBar *>()->motorsButton()->property("running").toBool(),
                             kPatience);
    ControlsTap tap(m_rig->client());
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Right);
    QVERIFY(QTest::qWaitFor([&] {
        const auto sent = tap.take();
        return !sent.empty() && sent.back().roll > 0.2;
    }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Right);
    // Wherever the keyboard was.
    page().disarmButton()->setFocus();
    QTest::keyPress(page().disarmButton(), Qt::Key_Left);
    QCOMPARE(QApplication::focusWidget(), page().pad());
    QVERIFY(QTest::qWaitFor([&] {
        const auto sent = tap.take();
        return !sent.empty() && sent.back().roll < -0.2;
    }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Left);
    m_rig->settings().setDisarmSeconds(2);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    m_rig->settings().setDisarmSeconds(20);
    QTRY_VERIFY_WITH_TIMEOUT(window().messageBar()->text().contains(u"Control has ended"_s), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->client().isStopUnproven(), kPatience);
    QVERIFY(arm());
    QVERIFY2(!window().messageBar()->text().contains(u"Control has ended"_s),
             qPrintable(window().messageBar()->text()));
}

// Without a mouse, with a keyboard that repeats what is held.
void TestFlight::heldSpaceBarArms()
{
    bool isArmed = false;
    for (int attempt = 0; attempt < kAttempts && !isArmed; ++attempt) {
        page().open(true);
        QVERIFY(QTest::qWaitFor([this] { return isReady(); }, kPatience));
        page().armButton()->setFocus();
        QTest::keyPress(page().armButton(), Qt::Key_Space);
        QCOMPARE(page().session().phase(), Phase::Holding);
        const auto isDecidedAfterRepeating = [this] {
            for (const QEvent::Type type : {QEvent::KeyRelease, QEvent::KeyPress}) {
                QKeyEvent repeated(type, Qt::Key_Space, Qt::NoModifier, u" "_s, true);
                QApplication::sendEvent(QApplication::focusWidget(), &repeated);
            }
            return page().session().phase() == Phase::Armed || page().session().phase() == Phase::Open;
        };
        std::ignore = QTest::qWaitFor(isDecidedAfterRepeating, kPatience);
        isArmed = page().session().phase() == Phase::Armed;
        QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Space);
        if (!isArmed && page().session().ended() != ArmingBar::Hung)
            break;
    }
    QVERIFY2(isArmed, qPrintable(page().stateText()));
    QTRY_VERIFY_WITH_TIMEOUT(this->isArmed(), kPatience);
    // Let go, it stays armed; pressed again, it is disarmed.
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
}

void TestFlight::gamepadSteersAndItsLossDisarms()
{
    const int pad = m_pads.plug();
    page().padChoice()->setChecked(true);
    Gamepad &gamepad = m_rig->workspace().gamepad();
    QTRY_VERIFY_WITH_TIMEOUT(gamepad.reading().has_value(), kPatience);
    GamepadMapping mapping;
    mapping.assign(GamepadStick::Throttle, 0, false);
    mapping.assign(GamepadStick::Roll, 1, false);
    mapping.assign(GamepadStick::Pitch, 2, false);
    mapping.assign(GamepadStick::Yaw, 3, false);
    mapping.assign(GamepadButton::ArmHold, 0);
    mapping.assign(GamepadButton::Disarm, 1);
    gamepad.setMapping(mapping);
    m_pads.move(0, -1);
    page().open(true);
    // What was checked with the sticks on the screen says nothing of a gamepad's.
    QTRY_VERIFY(says(u"directions have not been checked"_s));
    trust();
    QTRY_VERIFY(says(u"Ready"_s));
    m_pads.move(3, -1);
    QTRY_VERIFY(says(u"not in its middle"_s));
    m_pads.move(3, 0);
    QTRY_VERIFY(says(u"Ready"_s));
    mapping[GamepadStick::Roll].inverted = true;
    gamepad.setMapping(mapping);
    QTRY_VERIFY(says(u"directions have not been checked"_s));
    // What was found of the drone itself stays.
    QVERIFY(page().findChild<MotorDiagram *>()->areSidesKnown());
    mapping[GamepadStick::Roll].inverted = false;
    mapping[GamepadStick::Throttle].axis = -1;
    gamepad.setMapping(mapping);
    QTRY_VERIFY(says(u"has no stick for throttle"_s));
    mapping[GamepadStick::Throttle].axis = 0;
    mapping[GamepadButton::Disarm] = -1;
    gamepad.setMapping(mapping);
    m_pads.press(0, true);
    QVERIFY(m_rig->boardGoesOn(1.5));
    m_pads.press(0, false);
    QVERIFY(!isArmed());
    QCOMPARE(page().session().phase(), Phase::Open);
    mapping[GamepadButton::Disarm] = 1;
    gamepad.setMapping(mapping);
    QTRY_VERIFY(says(u"Ready"_s));
    // Nor does it arm behind a list or a question.
    window().showPalette();
    QTRY_VERIFY(window().commandPalette()->isVisible());
    ControlsTap tap(m_rig->client());
    const auto armsNothing = [&] {
        m_pads.press(0, true);
        const bool isTime = m_rig->boardGoesOn(1.5);
        m_pads.press(0, false);
        const auto sent = tap.take();
        const auto arms = [](const bcflight::Controls &controls) { return controls.arm; };
        return isTime && std::none_of(sent.begin(), sent.end(), arms);
    };
    QVERIFY(armsNothing());
    QCOMPARE(page().session().phase(), Phase::Open);
    QTest::keyClick(window().commandPalette()->input(), Qt::Key_Escape);
    QTRY_VERIFY(!window().commandPalette() || !window().commandPalette()->isVisible());
    // Nor while another window is in front, which a gamepad does not care for.
    QWidget other;
    other.show();
    other.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&other));
    QVERIFY(armsNothing());
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Open, kPatience);
    other.close();
    window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    const auto armByPad = [&] {
        m_pads.press(0, true);
        const bool armed
            = QTest::qWaitFor([&] { return page().session().phase() == Phase::Armed; }, kPatience);
        m_pads.press(0, false);
        return armed;
    };
    m_pads.move(0, 0);  // half throttle: not at zero
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_pads.press(0, true);
    QVERIFY(m_rig->boardGoesOn(1.5));
    m_pads.press(0, false);
    QVERIFY(!isArmed());
    m_pads.move(0, -1);
    QVERIFY(m_rig->boardGoesOn(0.3));
    // Held for too short a time.
    m_pads.press(0, true);
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Holding, kPatience);
    m_pads.press(0, false);
    QTRY_COMPARE_WITH_TIMEOUT(page().session().phase(), Phase::Open, kPatience);
    QCOMPARE(page().session().ended(), ArmingBar::Operator);
    // So short that the page sees it only when it is over: it was not held.
    const auto arePolledUnseen = [this] {
        for (const quint64 before = m_pads.polls(); m_pads.polls() < before + 3;)
            std::this_thread::yield();
    };
    m_pads.press(0, true);
    arePolledUnseen();
    m_pads.press(0, false);
    arePolledUnseen();
    QVERIFY(m_rig->boardGoesOn(1.5));
    QVERIFY(!isArmed());
    QVERIFY(page().session().phase() == Phase::Open);
    QVERIFY(armByPad());
    std::ignore = tap.take();
    m_pads.move(0, -0.4);
    m_pads.move(1, 1);
    QVERIFY(QTest::qWaitFor([&] {
        const auto sent = tap.take();
        return !sent.empty() && sent.back().roll > 0.9 && sent.back().thrust > 0.2;
    }));
    // And are seen on the screen.
    QTRY_VERIFY(page().pad()->value().x() > 0.9);
    QTRY_VERIFY(page().throttle()->value() > 20);
    m_pads.press(1, true);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::Operator);
    m_pads.press(1, false);
    m_pads.move(0, -1);
    m_pads.move(1, 0);
    QVERIFY(m_rig->boardGoesOn(0.7));
    QVERIFY(armByPad());
    m_pads.setHanging(true);  // the thread that reads it
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::NoSticks);
    m_pads.setHanging(false);
    QVERIFY(m_rig->boardGoesOn(1));
    QVERIFY(!isArmed());
    QVERIFY(armByPad());
    m_pads.unplug(pad);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::NoSticks);
    // Plugged in again it is another session: it arms nothing.
    m_pads.plug();
    m_pads.move(0, -1);
    QVERIFY(m_rig->boardGoesOn(1));
    QVERIFY(!isArmed());
}

// The program disarms, sets the value, and waits for a new arming.
// A palette or a question has the keyboard while it is armed.
void TestFlight::spaceDisarmsWhereverTheKeyboardIs()
{
    QVERIFY(arm());
    auto *list = window().findChild<Navigation *>();
    QVERIFY(list);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Space);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::Operator);
}

void TestFlight::disarmStopsWhatSomebodyElseHasArmed()
{
    const bcflight::Controls armed{.thrust = 0.3, .arm = true};
    // Again, while a stop that goes on from before disarms it.
    const auto isArmedByAnother = [&] {
        post(encode(bcflight::Message::Controls, armed.encode(bcflight::Generation::G),
                    bcflight::Generation::G));
        return m_rig->workspace().latest(m_rig->client().roles().armed) == 1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isArmedByAnother(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(page().disarmButton()->isEnabled(), kPatience);
    QTest::mouseClick(page().disarmButton(), Qt::LeftButton);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(isSoon(m_rig->client().roles().outputs, 0));
}

void TestFlight::gainsDisarmFirst()
{
    LiveModel &live = m_rig->workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    QTRY_VERIFY_WITH_TIMEOUT(live.value(gain).has_value(), kPatience);
    const double before = *live.value(gain);
    QVERIFY(arm());
    live.setValue(gain, double(float(before * 1.5)));
    QTRY_VERIFY_WITH_TIMEOUT(live.isSettled(), kPatience);
    QCOMPARE(live.value(gain), std::optional(double(float(before * 1.5))));
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::Changed);
    // A write from the form is refused while it is armed, and so is whatever else is wanted of it.
    QVERIFY(arm());
    m_rig->edit(u"pid.roll.p"_s, 0, double(float(before * 2)));
    m_rig->workspace().write(std::as_const(m_rig->model()).edited());
    QVERIFY(!m_rig->workspace().isWriting());
    const auto wanted = m_rig->workspace().perform(u"clock"_s, {});
    QVERIFY(wanted.isFinished());
    QCOMPARE(wanted.result().error().code, ErrorCode::Cancelled);
    QVERIFY(isArmed());
    m_rig->workspace().discardUnsaved();
}

// With a gain that is set while it is armed, as only in a stand.
void TestFlight::stepIsMeasuredInAStand()
{
    StickStepCard *card = page().steps();
    QVERIFY(arm());
    QVERIFY(card->isVisible());
    page().throttle()->setValue(30);
    QVERIFY(m_rig->boardGoesOn(1));
    QTRY_VERIFY_WITH_TIMEOUT(card->startButton()->isEnabled(), kPatience);
    QTest::mouseClick(card->startButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!card->isRunning(), kPatience);
    QVERIFY(card->measured().has_value());
    const StepMetrics first = card->measured()->metrics;
    QVERIFY(first.riseSeconds.has_value());
    QVERIFY(*first.riseSeconds > 0.005 && *first.riseSeconds < 0.6);
    QVERIFY(page().session().isArming());
    QTest::mouseClick(page().tuneChoice(), Qt::LeftButton, {}, QPoint(8, page().tuneChoice()->height() / 2));
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<QMessageBox *>(), kPatience);
    // It is asked with the motors standing, and no answer says that it would stop them.
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    for (const QAbstractButton *button : window().findChild<QMessageBox *>()->buttons())
        QVERIFY2(!button->text().contains(u"isarm"_s), qPrintable(button->text()));
    for (QAbstractButton *button : window().findChild<QMessageBox *>()->buttons()) {
        if (window().findChild<QMessageBox *>()->buttonRole(button) == QMessageBox::DestructiveRole)
            QTest::mouseClick(button, Qt::LeftButton);
    }
    QTRY_VERIFY_WITH_TIMEOUT(page().tuneChoice()->isChecked(), kPatience);
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(arm());
    page().throttle()->setValue(30);
    const double before = card->gains()[0]->value();
    QVERIFY(before > 0);
    // The keys that fly fly, also where a gain has the keyboard.
    NumberBox *box = card->gains()[0];
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_PageUp, Qt::Key_W}) {
        box->setFocus();
        QCOMPARE(QApplication::focusWidget(), box);
        QTest::keyPress(box, key);
        QTest::keyRelease(QApplication::focusWidget(), key);
        QCOMPARE(box->value(), before);
        QVERIFY2(!box->text().contains(u'w', Qt::CaseInsensitive), qPrintable(box->text()));
    }
    QVERIFY(page().throttle()->value() > 30);
    page().throttle()->setValue(30);
    box->setValue(before * 0.5);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->workspace().live().isSettled(), kPatience);
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(isArmed());
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    QVERIFY(std::abs(*m_rig->workspace().live().value(gain) - before * 0.5) < 1e-6);
    QTest::mouseClick(card->startButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!card->isRunning(), kPatience);
    QVERIFY(card->measured().has_value());
    page().tuneChoice()->setChecked(false);
}

void TestFlight::closingIsRefusedWhileArmed()
{
    QVERIFY(arm());
    window().close();
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(window().isVisible());
    QVERIFY(isArmed());
    page().disarmButton()->click();
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(window().isVisible());
}

// Disarmed here, the drone has not said so yet; one that does not obey is not left.
void TestFlight::closingWaitsUntilItIsSeenToStand()
{
    QVERIFY(arm());
    page().throttle()->setValue(20);
    QVERIFY(isSoon(m_rig->client().roles().outputs, 1));
    m_rig->workspace().changeWorld(u"runs-on=1"_s);
    QVERIFY(m_rig->boardGoesOn(0.2));
    QSignalSpy ended(&m_rig->client(), &DeviceClient::steeringEnded);
    page().disarmButton()->click();
    window().close();
    QVERIFY(window().isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QVERIFY(!ended.first().first().toBool());
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(window().isVisible());
    window().close();
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(window().isVisible());
    QVERIFY(m_rig->workspace().mayStillFly());
    // Where it says that it is disarmed all the same, its alarm offers to stop it.
    AlarmReport driven;
    driven.alarm.kind = AlarmKind::Disarmed;
    QVERIFY(m_rig->workspace().alarms().offersMotorsOff(driven));
    m_rig->workspace().changeWorld(u"runs-on=0"_s);
    m_rig->workspace().setMotors(false);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->workspace().mayStillFly(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->client().isStopUnproven(), kPatience);
    QVERIFY(window().isVisible());
}

// Errata 9.1, 9.2 (8): a client over TCP that goes makes it call itself disarmed, and its motors run on.
void TestFlight::disarmedIsNotStanding()
{
    m_rig->client().disconnectFromBoard();
    SimProcess drone({u"--udp"_s, u"0"_s, u"--tcp"_s, u"0"_s}, u"bcflight"_s);
    QTRY_VERIFY_WITH_TIMEOUT(drone.process().canReadLine(), kPatience);
    const QByteArray tcp = drone.process().readLine().trimmed();
    QVERIFY(fly(drone.address()));
    drone.process().write("runs-on=1\n");
    QVERIFY(m_rig->boardGoesOn(0.3));
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    page().disarmButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(stopped.count() > 0, kPatience);
    // It is armed still, and it was nobody else.
    QVERIFY(isArmed());
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, this,
            [&told](const QString &text) { told.append(text); });
    page().sessionButton()->click();  // closes it
    page().sessionButton()->click();
    QVERIFY2(told.join(u' ').contains(u"does not say that it is disarmed"_s), qPrintable(told.join(u' ')));
    disconnect(&m_rig->workspace().notifications(), nullptr, this, nullptr);
    QTcpSocket other;
    other.connectToHost(QHostAddress::LocalHost, tcp.split(':').last().toUShort());
    QTRY_COMPARE_WITH_TIMEOUT(other.state(), QAbstractSocket::ConnectedState, kPatience);
    other.disconnectFromHost();
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(isSoon(m_rig->client().roles().outputs, 1));
    QVERIFY(m_rig->workspace().mayStillFly());
    window().close();
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(window().isVisible());
    m_rig->client().submit<void>([](Channel &channel, Device &) -> Result<void> {
        channel.allowMotors();
        return {};
    });
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->client().isStopUnproven(), kPatience);
    page().open(true);
    QVERIFY2(isRefused(u"its motors are driven"_s), qPrintable(page().stateText()));
    drone.process().write("runs-on=0\n");
    m_rig->workspace().setMotors(false);
    QVERIFY(isSoon(m_rig->client().roles().outputs, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->workspace().mayStillFly(), kPatience);
    m_rig->client().disconnectFromBoard();
}

// It has gone on as it was told last, all the time.
void TestFlight::foundAgainItIsDisarmed()
{
    QVERIFY(arm());
    page().throttle()->setValue(20);
    QVERIFY(isSoon(m_rig->client().roles().outputs, 1));
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    m_rig->workspace().changeWorld(u"replug=5"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY_WITH_TIMEOUT(page().session().phase() == Phase::Closed, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), kPatience);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(isSoon(m_rig->client().roles().outputs, 0));
    QCOMPARE(page().session().phase(), Phase::Closed);
    // By the stop that was not proven before. Without one its steering is ended: see tst_bcflightbenchlink.
    QTRY_VERIFY_WITH_TIMEOUT(!stopped.isEmpty() && stopped.last().first().toBool(), kPatience);
}

void TestFlight::lostLinkIsWarnedOf()
{
    QVERIFY(arm());
    page().throttle()->setValue(20);
    QVERIFY(isSoon(m_rig->client().roles().outputs, 1));
    m_rig->workspace().changeWorld(u"replug=-1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY_WITH_TIMEOUT(page().session().phase() == Phase::Closed, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    window().close();
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<QMessageBox *>(), kPatience);
    QVERIFY(window().findChild<QMessageBox *>()->text().contains(u"armed"_s));
    window().findChild<QMessageBox *>()->reject();
    QVERIFY(window().isVisible());
    m_rig->client().disconnectFromBoard();
}

// It does not hear that it is disarmed, and nobody says that it is.
void TestFlight::silenceInTheAirIsTold()
{
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(fly(drone.address()));
    const QObject listener;
    QList<ErrorText> told;
    connect(&m_rig->workspace().notifications(), &Notifications::problem, &listener,
            [&told](const ErrorText &text) { told.append(text); });
    drone.process().write("silent-armed=86400\n");
    QTRY_VERIFY_WITH_TIMEOUT(page().session().phase() == Phase::Closed, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    QVERIFY(std::any_of(told.begin(), told.end(), [](const ErrorText &text) {
        return text.what == u"The drone did not confirm that it is disarmed."_s
            && text.meaning.contains(u"its last throttle"_s);
    }));
    QStringList good;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, &listener,
            [&good](const QString &text) { good.append(text); });
    drone.process().write("silent-armed=0\n");
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), kPatience);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QVERIFY(isSoon(m_rig->client().roles().outputs, 0));
    // Whichever of the two stops was proven first.
    const auto isTold = [&good] {
        return good.contains(u"The drone is disarmed, and its outputs stand."_s)
            || good.contains(u"The motors were switched off."_s);
    };
    QTRY_VERIFY2_WITH_TIMEOUT(isTold(), qPrintable(good.join(u'|')), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->workspace().mayStillFly(), kPatience);
    m_rig->client().disconnectFromBoard();
}

// Once nothing was told to it any more, the guard has sent its stop, which was lost as well. What the
// operator was warned of is so: the drone goes on.
void TestFlight::lostLinkIsLeftAllTheSame()
{
    m_rig->client().disconnectFromBoard();
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(fly(drone.address()));
    QVERIFY(page().guardian().isWatching());
    const auto *guard = page().guardian().findChild<QProcess *>();
    drone.process().write("replug=-1\nunplug=0\n");
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    QCOMPARE(page().session().phase(), Phase::Closed);
    QTRY_VERIFY_WITH_TIMEOUT(!page().guardian().isWatching(), kPatience);
    QCOMPARE(guard->exitStatus(), QProcess::NormalExit);
    constexpr int kHasStopped = 3;
    QCOMPARE(guard->exitCode(), kHasStopped);
    window().close();
    QTRY_VERIFY_WITH_TIMEOUT(window().findChild<QMessageBox *>(), kPatience);
    QVERIFY(window().isVisible());
    auto *question = window().findChild<QMessageBox *>();
    QVERIFY2(question->text().contains(u"goes on with its last throttle"_s), qPrintable(question->text()));
    QTest::mouseClick(named<QPushButton>(question, u"Quit all the same"_s), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!window().isVisible(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Disconnected, kPatience);
    drone.process().write("unplug=86400\n");
    DeviceClient other(allLinks().transports, allFamilies());
    other.connectTo(*LinkAddress::parse(drone.address()), u"bcflight"_s);
    QTRY_VERIFY_WITH_TIMEOUT(other.isConnected(), kPatience);
    const ChannelRoles roles = other.roles();
    const auto isTold = [&](double value) {
        return other.telemetry()->latest(roles.armed) == value
            && other.telemetry()->latest(roles.outputs) == value;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isTold(1), kPatience);
    other.motorsOff();
    QTRY_VERIFY_WITH_TIMEOUT(isTold(0), kPatience);
    other.shutDown();
    m_rig->restart();
    m_rig->workspace().gamepad().setMaker(m_pads.maker());
    m_page = m_rig->page<FlightPage>();
}

// Over UDP it does not notice that nobody steers it any more.
void TestFlight::whoeverLeavesTheLinkDisarms_data()
{
    QTest::addColumn<bool>("toAnother");
    QTest::newRow("disconnected") << false;
    QTest::newRow("another link") << true;
}

void TestFlight::whoeverLeavesTheLinkDisarms()
{
    QFETCH(bool, toAnother);
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(fly(drone.address()));
    if (toAnother)
        QVERIFY(m_rig->open(u"sim:simplebgc"_s));
    else
        m_rig->client().disconnectFromBoard();
    QTRY_VERIFY_WITH_TIMEOUT(!page().guardian().isWatching(), kPatience);
    DeviceClient other(allLinks().transports, allFamilies());
    other.connectTo(*LinkAddress::parse(drone.address()), u"bcflight"_s);
    QTRY_VERIFY_WITH_TIMEOUT(other.isConnected(), kPatience);
    const ChannelRoles roles = other.roles();
    const auto told = [&other](int channel) { return other.telemetry()->latest(channel); };
    QTRY_VERIFY_WITH_TIMEOUT(told(roles.armed) == 0 && told(roles.outputs) == 0, kPatience);
    other.shutDown();
    m_rig->client().disconnectFromBoard();
}

// Over UDP, where a drone does not notice that this program died.
void TestFlight::guardStandsBy()
{
    m_rig->client().disconnectFromBoard();
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(m_rig->open(drone.address()));
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    const auto calibrated = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(calibrated.isFinished(), kPatience);
    QVERIFY(isSoon(m_rig->client().roles().calibrated, 1));
    trust();
    QVERIFY(!page().guardian().isWatching());
    QVERIFY(arm());
    QVERIFY(page().guardian().isWatching());
    // It is told that all is well, for longer than it waits without a word.
    QVERIFY(m_rig->boardGoesOn(1.6));
    QVERIFY(isArmed() && page().guardian().isWatching());
    // Without it nothing flies.
    page().guardian().findChild<QProcess *>()->kill();
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QCOMPARE(page().session().ended(), ArmingBar::Unguarded);
    // It is left when the drone is seen to stand, and does nothing.
    QVERIFY(arm());
    QSignalSpy gone(&page().guardian(), &FlightGuardian::lost);
    page().disarmButton()->click();
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!page().guardian().isWatching(), kPatience);
    QCOMPARE(gone.count(), 0);
    // And not before: as long as nobody knows, it stops it as well.
    QVERIFY(arm());
    drone.process().write("runs-on=1\n");
    QVERIFY(m_rig->boardGoesOn(0.3));
    page().disarmButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(gone.count() > 0, kPatience);
    drone.process().write("runs-on=0\n");
    m_rig->workspace().setMotors(false);
    QVERIFY(isSoon(m_rig->client().roles().armed, 0));
    m_rig->client().disconnectFromBoard();
}

QTEST_MAIN(TestFlight)
#include "tst_flight.moc"
