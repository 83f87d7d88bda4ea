// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/benchcards.h"
#include "app/families/bcflight/benchpage.h"
#include "app/families/bcflight/camerapage.h"
#include "app/families/bcflight/recordingspage.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/program/gamepadpage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/flightstate.h"
#include "protocol/base/filefault.h"
#include "protocol/bcflight/blocks.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/configuration/writereport.h"
#include "protocol/simulator/bcflight/board.h"
#include "protocol/simulator/video/cameraserver.h"
#include "protocol/simulator/video/scene.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/video/videomodule.h"
#include "tests/support/boardhost.h"
#include "tests/support/fakegamepads.h"
#include "tests/support/filedialog.h"
#include "tests/support/named.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/panel.h"
#include "widgets/views/codeeditor.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/motordiagram.h"
#include "widgets/views/videoview.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTimer>
#include <QTreeView>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;
using Board = bcflight::SimulatedBoard;
using Phase = ArmingSession::Phase;

/// A day with a drone, from the screen, over a network that loses one packet of twenty on each way: by clicks
/// and keys, and what has become of it seen on the drone. Where nothing answers a command and it is lost, the
/// program says so, and the operator tries again.
class TestBcflightDay final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase();
    void fromConnectingToLeaving();

private:
    // The day, in this order.
    void connectFromTheStartPage();
    void calibrate();
    void watch();
    void tuneAndStore();
    void editTheText();
    void testAMotor();
    void watchTheVideo();
    void assignTheGamepad();
    void beginToRecord();
    void checkDirections();
    void flyAndStop();
    void endTheRecording();
    void uploadFirmware();
    void listRecordings();
    void leave();
    void playTheRecording();

    static constexpr int kAttempts = 5;
    // Of the gamepad: throttle, and behind it roll, pitch and yaw.
    static constexpr int kThrottleAxis = 0;
    static constexpr int kArmButton = 4;
    static constexpr int kDisarmButton = 5;

    MainWindow &window() { return m_rig->window(); }
    /// What this says of the drone, asked where it lives.
    template <typename Ask> auto drone(Ask ask) { return m_drone->with<Board>(ask); }
    void pose(int number) { QVERIFY(m_drone->change(u"pose=%1"_s.arg(number))); }
    [[nodiscard]] bool isArmed()
    {
        return drone([](Board &board) { return board.isArmed(); });
    }
    [[nodiscard]] bool isCalibrated()
    {
        return drone([](Board &board) { return board.status().calibrated; });
    }
    [[nodiscard]] double output(int motor)
    {
        return drone([motor](Board &board) { return board.outputs().at(std::size_t(motor - 1)); });
    }
    [[nodiscard]] double mostOutput()
    {
        return drone([](Board &board) { return std::ranges::max(board.outputs()); });
    }
    [[nodiscard]] QByteArray text()
    {
        return drone([](Board &board) { return board.configuration(); });
    }
    [[nodiscard]] double gain()
    {
        return drone([](Board &board) { return board.gains()[0][0]; });
    }
    /// The text as the program has read it last.
    [[nodiscard]] QByteArray readText()
    {
        return std::as_const(m_rig->model()).board().block({0, bcflight::ConfigurationText});
    }
    /// Off screen, what popped up leaves no window active.
    bool isActive()
    {
        window().activateWindow();
        return QTest::qWaitForWindowActive(&window());
    }
    static void click(QWidget *widget) { QTest::mouseClick(widget, Qt::LeftButton); }
    /// Goes there by the navigation.
    template <typename P> P &go();
    bool answerPanel(const QString &answer);
    bool confirm(const QString &words);
    bool perform(const QString &label);
    bool chooseInMenu(QPushButton *button, int entry);
    bool arm();
    /// Pushes the stick of an axis to the right, forward or to the right, as far as it goes, or lets it go.
    void push(int axis, bool on) { m_pads.move(1 + axis, on ? 1 : 0); }
    void setThrottle(double percent) { m_pads.move(kThrottleAxis, percent / 50 - 1); }

    std::unique_ptr<DatagramBoardHost> m_drone;
    std::unique_ptr<CameraServer> m_camera;
    FakeGamepads m_pads;
    std::unique_ptr<WindowRig> m_rig;
    QString m_recording;
};

void TestBcflightDay::initTestCase()
{
    SimulatorOptions options;
    options.seed = 1700;
    options.faults.loseByte = 0.05;
    options.faults.pose = 1;
    options.faults.shake = 0;
    m_drone = std::make_unique<DatagramBoardHost>(
        std::make_unique<SimulatedPort>(std::make_unique<Board>(options), options, std::nullopt));
    QVERIFY(m_drone->start());
    const auto feed = std::make_shared<CameraFeed>();
    m_drone->setCameraFeed(feed);
    m_camera = std::make_unique<CameraServer>(feed);
    QVERIFY(m_camera->start(0));
    m_rig = std::make_unique<WindowRig>();
    m_rig->workspace().gamepad().setMaker(m_pads.maker());
}

void TestBcflightDay::cleanupTestCase()
{
    m_rig.reset();
    m_camera.reset();
    m_drone.reset();
}

void TestBcflightDay::fromConnectingToLeaving()
{
    using Step = void (TestBcflightDay::*)();
    for (const Step step :
         {&TestBcflightDay::connectFromTheStartPage, &TestBcflightDay::calibrate, &TestBcflightDay::watch,
          &TestBcflightDay::tuneAndStore, &TestBcflightDay::editTheText, &TestBcflightDay::testAMotor,
          &TestBcflightDay::watchTheVideo, &TestBcflightDay::assignTheGamepad,
          &TestBcflightDay::beginToRecord, &TestBcflightDay::checkDirections, &TestBcflightDay::flyAndStop,
          &TestBcflightDay::endTheRecording, &TestBcflightDay::uploadFirmware,
          &TestBcflightDay::listRecordings, &TestBcflightDay::leave, &TestBcflightDay::playTheRecording}) {
        (this->*step)();
        if (QTest::currentTestFailed())
            return;
    }
    // Nothing that it was sent was no message to it.
    QCOMPARE(drone([](Board &board) { return board.unknownMessages(); }), 0);
}

template <typename P> P &TestBcflightDay::go()
{
    if (!isActive())
        qFatal("the window is not active");
    Navigation *list = window().navigation();
    for (const PageEntry &entry : pageTable()) {
        const QString key = QString::fromLatin1(entry.key);
        if (key + u"page"_s != QString::fromLatin1(P::staticMetaObject.className()).toLower())
            continue;
        for (int row = 0; row < list->count(); ++row) {
            if (!list->item(row)->text().startsWith(list->titleOf(key)))
                continue;
            list->scrollToItem(list->item(row));
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                              list->visualItemRect(list->item(row)).center());
        }
        if (list->currentPage() == key)
            return *qobject_cast<P *>(window().page(key));
    }
    qFatal("%s is not reached", P::staticMetaObject.className());
}

bool TestBcflightDay::answerPanel(const QString &answer)
{
    if (!QTest::qWaitFor([this] { return window().panels()->isOpen(); }, kPatience))
        return false;
    click(named<QPushButton>(window().panels()->newest(), answer));
    return QTest::qWaitFor([this] { return !window().panels()->isOpen(); }, kPatience);
}

bool TestBcflightDay::confirm(const QString &words)
{
    const auto asked = [this] { return qobject_cast<QMessageBox *>(window().panels()->newest()); };
    if (!QTest::qWaitFor([&] { return asked() && asked()->text().contains(words); }, kPatience))
        return false;
    click(asked()->findChild<QPushButton *>(u"danger"_s));
    return true;
}

/// On the page of all actions, until it is over.
bool TestBcflightDay::perform(const QString &label)
{
    auto &page = go<ActionsPage>();
    const auto items = page.list()->findItems(label, Qt::MatchExactly | Qt::MatchRecursive);
    if (items.isEmpty())
        return false;
    page.list()->scrollToItem(items.first());
    QTest::mouseClick(page.list()->viewport(), Qt::LeftButton, {},
                      page.list()->visualItemRect(items.first()).center());
    if (!QTest::qWaitFor([&] { return page.runButton()->isEnabled(); }, kPatience))
        return false;
    click(page.runButton());
    return QTest::qWaitFor([&] { return !page.isUnderWay(); }, kPatience);
}

bool TestBcflightDay::chooseInMenu(QPushButton *button, int entry)
{
    QMenu *menu = button->menu();
    if (!menu)
        return false;
    // The click returns when the menu is closed.
    QObject context;
    connect(menu, &QMenu::aboutToShow, &context, [menu, entry, &context] {
        QTimer::singleShot(0, &context, [menu, entry] {
            for (int i = 0; i <= entry; ++i)
                QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
    });
    click(button);
    return true;
}

void TestBcflightDay::connectFromTheStartPage()
{
    auto *start = window().findChild<StartPage *>();
    QVERIFY(start && start->isVisible());
    click(named<QPushButton>(start, u"Choose a port"_s));
    QComboBox *box = window().findChild<LinkBar *>()->addressBox();
    QTRY_VERIFY(box->view()->isVisible());
    QTest::keyClick(box->view(), Qt::Key_Escape);
    QVERIFY(isActive());
    QTRY_VERIFY(box->lineEdit()->hasFocus());
    QTest::keyClick(box->lineEdit(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box->lineEdit(), m_drone->address());
    QTest::keyClick(box->lineEdit(), Qt::Key_Return);
    QTRY_VERIFY(m_rig->client().isConnected() && !m_rig->model().isEmpty());
    QTRY_VERIFY(!start->isVisible());
    QCOMPARE(readText(), text());
    QVERIFY(!isArmed() && !isCalibrated());
}

void TestBcflightDay::calibrate()
{
    for (int attempt = 0; attempt < kAttempts && !isCalibrated(); ++attempt)
        QVERIFY(perform(u"Calibrate gyroscope"_s));
    QVERIFY(isCalibrated());
    const int calibrated = m_rig->workspace().roles().calibrated;
    QTRY_VERIFY(m_rig->workspace().latest(calibrated) == 1);
}

void TestBcflightDay::watch()
{
    auto &page = go<MonitorPage>();
    auto *tree = page.findChild<QTreeView *>();
    QVERIFY(tree);
    const QModelIndexList found = tree->model()->match(
        tree->model()->index(0, 0), Qt::DisplayRole, u"Battery"_s, 1, Qt::MatchExactly | Qt::MatchRecursive);
    QVERIFY(!found.isEmpty());
    tree->scrollTo(found.first());
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(found.first()).center());
    const qsizetype before = page.plots().size();
    QTest::keyClick(tree, Qt::Key_Space);
    QTRY_COMPARE(page.plots().size(), before + 1);
    const QModelIndex shown = found.first().siblingAtColumn(ChannelModel::ValueColumn);
    const auto volts = [&] { return drone([](Board &board) { return board.quadcopter().voltage(); }); };
    QTRY_VERIFY2(std::abs(shown.data().toString().toDouble() - volts()) < 0.3,
                 qPrintable(shown.data().toString()));
    // Somebody tilts it.
    const int roll = m_rig->workspace().roles().angle[0];
    const auto tilted = [&] { return drone([](Board &board) { return board.quadcopter().attitude().x; }); };
    pose(2);
    QTRY_VERIFY(std::abs(tilted()) > 25
                && std::abs(std::abs(m_rig->workspace().latest(roll)) - std::abs(tilted())) < 6);
    pose(1);
    QTRY_VERIFY(std::abs(m_rig->workspace().latest(roll)) < 6);
}

// In use at once, then in the text, and in use again after the restart.
void TestBcflightDay::tuneAndStore()
{
    auto &page = go<TuningPage>();
    const double before = gain();
    QVERIFY(before > 0);
    QSlider *slider = page.control(u"pid.roll.p"_s)->slider();
    QTRY_VERIFY(slider->isEnabled());
    QTest::keyClick(slider, Qt::Key_Right);
    QTRY_VERIFY(page.live().isSettled() && gain() > before * 1.0001);
    const double tuned = gain();
    QVERIFY(text().contains("pid_roll = PID( 90, 25, 80 )"));
    auto *bar = window().findChild<UnstoredBar *>();
    QTRY_VERIFY(bar->isVisible() && bar->storeButton()->isEnabled());
    click(bar->storeButton());
    // What changes in its text is seen before.
    ReviewDialog *review = nullptr;
    QTRY_VERIFY((review = window().findChild<ReviewDialog *>()));
    QVERIFY(review->lines() && review->lines()->toPlainText().contains(u"pid_roll"_s));
    QVERIFY(text().contains("pid_roll = PID( 90, 25, 80 )"));
    click(review->writeButton());
    QTRY_VERIFY(!text().contains("pid_roll = PID( 90, 25, 80 )"));
    QTRY_VERIFY(!isCalibrated());  // it has restarted
    QTRY_VERIFY(!bar->isVisible() && m_rig->client().isConnected() && readText() == text());
    const auto written = bcflight::findGains(text(), u"pid_roll"_s);
    const auto scales = bcflight::findScales(text());
    QVERIFY(written && scales);
    QVERIFY(std::abs((*written)[0].value * (*scales)[0] - tuned) < tuned * 1e-4);
    QVERIFY(std::abs(gain() - tuned) < tuned * 1e-4);
    QVERIFY(std::abs(m_rig->raw(u"pid.roll.p"_s) - gain()) < tuned * 1e-6);
}

void TestBcflightDay::editTheText()
{
    auto &page = go<DocumentsPage>();
    QVERIFY(text().contains("rate_speed = 300"));
    QTest::keyClick(&page, Qt::Key_F, Qt::ControlModifier);
    auto *field = named<QLineEdit>(&page, u"Search in the text"_s);
    QTRY_VERIFY(field->hasFocus());
    QTest::keyClicks(field, u"rate_speed = 300"_s);
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(page.editor()->hasFocus());
    QCOMPARE(page.editor()->selectedText(), u"rate_speed = 300"_s);
    QTest::keyClicks(page.editor(), u"rate_speed = 250"_s);
    UnsavedBar *bar = window().unsavedBar();
    QTRY_VERIFY(bar->isVisible() && bar->writeButton()->isEnabled());
    QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
    click(bar->writeButton());
    QTRY_VERIFY(window().reviewDialog());
    click(window().reviewDialog()->writeButton());
    QTRY_VERIFY(!finished.isEmpty());
    QVERIFY(m_rig->workspace().lastReport()->isComplete());
    QVERIFY(text().contains("rate_speed = 250") && !text().contains("rate_speed = 300"));
    QTRY_VERIFY(m_rig->client().isConnected() && readText() == text() && !bar->isVisible());
}

void TestBcflightDay::testAMotor()
{
    calibrate();  // which the restart has undone
    auto &page = go<BenchPage>();
    bool hasTurned = false;
    for (int attempt = 0; attempt < kAttempts && !hasTurned; ++attempt) {
        QTRY_VERIFY2(page.obstacle().isEmpty() && !page.isUnderWay(), qPrintable(page.obstacle()));
        QTest::mouseClick(page.motors(), Qt::LeftButton, {}, page.motors()->placeOf(2).toPoint());
        QTRY_VERIFY(page.turnButton()->isEnabled());
        click(page.turnButton());
        QVERIFY(confirm(u"The propellers are off"_s));
        const auto turns = [&] { return output(2) > 0; };
        QVERIFY(QTest::qWaitFor([&] { return turns() || !page.isUnderWay(); }, kPatience));
        hasTurned = turns();
    }
    QVERIFY(hasTurned);
    QVERIFY(std::abs(output(2) - 0.05) < 0.001);
    QVERIFY(output(1) == 0 && output(3) == 0 && output(4) == 0);
    QTRY_VERIFY(!page.isUnderWay());
    QTRY_COMPARE(mostOutput(), 0.0);
}

void TestBcflightDay::beginToRecord()
{
    m_recording = m_rig->filePath(u"flight.gimbalrec"_s);
    QVERIFY(chooseInMenu(named<QPushButton>(&go<MonitorPage>(), u"Record"_s), 0));
    QVERIFY(fileDialog());
    typePath(m_recording);
    QTRY_VERIFY(m_rig->workspace().recorder().isRecording());
}

// The picture is the drone's own, and so is what was recorded of it: each frame bears its number.
void TestBcflightDay::watchTheVideo()
{
    auto &page = go<CameraPage>();
    const auto type = [](QLineEdit *field, const QString &text) {
        click(field);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    };
    type(page.addressField(), u":%1"_s.arg(m_camera->port()));
    const QString folder = m_rig->filePath(u"videos"_s);
    type(page.folderField(), folder);
    const auto shown = [&page] {
        const auto picture = page.view()->picture();
        return picture && page.staleText().isEmpty() ? readNumber(*picture) : std::nullopt;
    };
    QTRY_VERIFY_WITH_TIMEOUT(shown(), kPatience);
    const std::uint32_t first = *shown();
    QTRY_VERIFY(shown().value_or(0) > first + 10);
    click(page.recordButton());
    QTRY_VERIFY(page.video().recordingState().length > 1s);
    click(page.recordButton());
    QTRY_VERIFY(!page.isUnderWay());
    const QStringList files = QDir(folder).entryList(QDir::Files);
    QCOMPARE(files.size(), 1);
    const VideoCodecs &codecs = *loadVideoCodecs().value();
    const auto reader = codecs.openFile(QDir(folder).filePath(files.first()));
    QVERIFY(reader);
    const auto decoder = codecs.makeDecoder((*reader)->track().format);
    QVERIFY(decoder);
    std::vector<std::uint32_t> numbers;
    while (const auto packet = (*reader)->next()) {
        (*decoder)->decode(asBytes(packet->bytes), packet->isKey);
        VideoPicture picture;
        QVERIFY((*decoder)->convert(picture, (*decoder)->size()));
        const auto number = readNumber(picture);
        if (number)  // a computer that is too busy to receive loses some
            numbers.push_back(*number);
    }
    QVERIFY(numbers.size() > 10);
    QVERIFY(numbers.front() > first);
    QVERIFY(std::ranges::is_sorted(numbers));
}

// By moving it, as the page asks.
void TestBcflightDay::assignTheGamepad()
{
    m_pads.plug();
    auto &page = go<GamepadPage>();
    const auto asks = [&page](const QString &words) {
        const auto labels = page.findChildren<QLabel *>();
        return std::ranges::any_of(labels,
                                   [&](const QLabel *label) { return label->text().contains(words); });
    };
    auto *all = named<QPushButton>(&page, u"Assign all sticks"_s);
    QTRY_VERIFY(all->isEnabled());
    click(all);
    for (int axis = kThrottleAxis; axis <= kThrottleAxis + 3; ++axis) {
        QTRY_VERIFY_WITH_TIMEOUT(asks(u"Push the stick"_s), kPatience);
        m_pads.move(axis, 1);
        QTRY_VERIFY_WITH_TIMEOUT(!asks(u"Push the stick"_s), kPatience);
        m_pads.move(axis, 0);
    }
    QTRY_VERIFY(!page.isUnderWay());
    for (const auto &[name, button] : {std::pair(u"Assign Arm (held for a second)"_s, kArmButton),
                                       std::pair(u"Assign Disarm"_s, kDisarmButton)}) {
        click(named<QPushButton>(&page, name));
        QTRY_VERIFY_WITH_TIMEOUT(asks(u"Press the button"_s), kPatience);
        m_pads.press(button, true);
        QTRY_VERIFY_WITH_TIMEOUT(!page.isUnderWay(), kPatience);
        m_pads.press(button, false);
    }
    setThrottle(0);
    QVERIFY(m_pads.arePolled(5));
    QCheckBox *choice = go<FlightPage>().padChoice();
    QTRY_VERIFY(choice->isEnabled());
    QTest::mouseClick(choice, Qt::LeftButton, {}, {choice->height() / 2, choice->height() / 2});
    QVERIFY(choice->isChecked());
}

bool TestBcflightDay::arm()
{
    auto &page = go<FlightPage>();
    // A computer that is too busy to send in time does not arm it.
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const auto isReady
            = [&page] { return page.stateText().contains(u"Ready"_s) && page.armButton()->isEnabled(); };
        if (!QTest::qWaitFor(isReady, kPatience))
            break;
        m_pads.press(kArmButton, true);
        bool wasHeld = false;
        std::ignore = QTest::qWaitFor(
            [&] {
                const Phase phase = page.session().phase();
                wasHeld |= phase == Phase::Holding;
                return phase == Phase::Armed || (wasHeld && phase == Phase::Open);
            },
            kPatience);
        m_pads.press(kArmButton, false);
        if (page.session().phase() == Phase::Armed)
            return QTest::qWaitFor([this] { return isArmed(); }, kPatience);
    }
    qInfo().noquote() << "not armed:" << page.stateText();
    return false;
}

// As the operator is led: tilt, push, arm without propellers, look, answer.
void TestBcflightDay::checkDirections()
{
    auto &page = go<FlightPage>();
    DirectionCard *card = page.directions();
    QVERIFY(m_rig->boardGoesOn(1));
    click(card->beginButton());
    QVERIFY(card->isChecking());
    const auto step = [card] { return card->check() ? card->check()->stepNumber() : -1; };
    const auto ready = [card] { return card->check() && card->check()->isReady(); };
    const auto seen
        = [card] { return card->check() && card->check()->sight() == DirectionCheck::Sight::Seen; };
    constexpr std::array kTilted{2, 4, 6};
    for (const int tilted : kTilted) {
        const int before = step();
        pose(tilted);
        QTRY_VERIFY(seen());
        pose(1);
        QTRY_COMPARE(step(), before + 1);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int before = step();
        push(axis, true);
        QTRY_VERIFY(seen());
        push(axis, false);
        QTRY_COMPARE(step(), before + 1);
    }
    QVERIFY(card->wantsArmed());
    click(page.sessionButton());
    QVERIFY(answerPanel(u"The propellers are off"_s));
    QVERIFY(arm());
    setThrottle(60);
    for (const int tilted : kTilted) {
        const int before = step();
        QTRY_VERIFY2_WITH_TIMEOUT(
            ready(), qPrintable(u"step %1: %2 %3"_s.arg(before).arg(page.stateText(), card->instruction())),
            kPatience);
        pose(tilted);
        QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        click(card->yesButton());
        QTRY_COMPARE(step(), before + 1);
        pose(1);
        QVERIFY(m_rig->boardGoesOn(1.2));
        setThrottle(before % 2 ? 58 : 60);  // somebody is there
    }
    for (int axis = 0; axis < 3; ++axis) {
        QTRY_VERIFY_WITH_TIMEOUT(ready(), kPatience);
        push(axis, true);
        QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        // On this drone yaw is counted the other way round: the stick is reversed, then it is right.
        if (axis == 2) {
            click(card->noButton());
            QTRY_VERIFY(!card->check() || card->check()->found().sticks[2] == -1);
            push(axis, false);
            QTRY_VERIFY_WITH_TIMEOUT(ready(), kPatience);
            push(axis, true);
            QTRY_VERIFY_WITH_TIMEOUT(card->yesButton()->isVisible(), kPatience);
        }
        click(card->yesButton());
        push(axis, false);
        QVERIFY(m_rig->boardGoesOn(0.3));
    }
    QTRY_VERIFY(!card->isChecking());
    QCOMPARE(card->found().level, CheckedDirections::Level::All);
    setThrottle(0);
    // It is disarmed with the end of the check.
    QTRY_VERIFY(!isArmed() && mostOutput() == 0);
    // The page knows it from the next status.
    QTRY_COMPARE(flightState(m_rig->workspace()), ArmedState::State::Disarmed);
    click(page.sessionButton());
    QCOMPARE(page.session().phase(), Phase::Closed);
}

// The drone goes where the stick of the gamepad is pushed; the red button stops it.
void TestBcflightDay::flyAndStop()
{
    auto &page = go<FlightPage>();
    pose(0);
    click(page.sessionButton());
    QVERIFY(answerPanel(u"It is held in a test stand"_s));
    QVERIFY(arm());
    setThrottle(40);
    QTRY_VERIFY(mostOutput() > 0.2);
    const auto roll = [this] { return drone([](Board &board) { return board.quadcopter().attitude().x; }); };
    push(0, true);
    QTRY_VERIFY(roll() > 12);
    push(0, false);
    QTRY_VERIFY(std::abs(roll()) < 6);
    QVERIFY(isArmed());
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    click(window().findChild<LinkBar *>()->motorsButton());
    QTRY_VERIFY(!isArmed() && mostOutput() == 0);
    QTRY_VERIFY(!stopped.isEmpty());
    QVERIFY(stopped.first().first().toBool());
    QTRY_VERIFY(drone([](Board &board) { return std::ranges::max(board.quadcopter().speeds()); }) < 0.01);
    QVERIFY(page.session().phase() <= Phase::Open);
    setThrottle(0);
    pose(1);
}

void TestBcflightDay::endTheRecording()
{
    QSignalSpy finished(&m_rig->workspace().recorder(), &LinkRecorder::finished);
    click(named<QPushButton>(&go<MonitorPage>(), u"Stop recording"_s));
    QTRY_VERIFY(!finished.isEmpty());
    QVERIFY(finished.first().at(2).toBool());
}

void TestBcflightDay::uploadFirmware()
{
    FirmwareCard *card = go<BenchPage>().firmware();
    QByteArray image = "version 7.7\n";
    image.resize(20000, '\x01');
    const QString path = m_rig->filePath(u"new.bin"_s);
    QVERIFY(writeWhole(path, image));
    click(named<QPushButton>(card, u"Choose a file…"_s));
    QVERIFY(fileDialog());
    typePath(path);
    QTRY_VERIFY2(card->uploadButton()->isEnabled(), qPrintable(card->said()));
    click(card->uploadButton());
    QVERIFY(confirm(u"The file was made for this drone"_s));
    QTRY_VERIFY(drone([](Board &board) { return board.firmware(); }) == image);
    QTRY_VERIFY(!card->isRunning());
    QVERIFY2(card->said().startsWith(u'✓') && card->said().contains(u"7.7"_s), qPrintable(card->said()));
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().identity().firmware == u"7.7"_s);
}

void TestBcflightDay::listRecordings()
{
    auto &page = go<RecordingsPage>();
    QTRY_COMPARE(page.table()->rowCount(), 2);
    QCOMPARE(page.table()->item(0, 0)->text(), u"video_0.h264"_s);
}

// From then on it hears nothing from here.
void TestBcflightDay::leave()
{
    click(window().findChild<LinkBar *>()->connectButton());
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    const auto now = [this] { return drone([](Board &board) { return board.now(); }); };
    const auto heard = [this] {
        return drone([](Board &board) { return board.handled().empty() ? 0 : board.handled().back().at; });
    };
    const double left = now() + 0.2;  // what was on its way
    QTRY_VERIFY(now() > left + 2);
    QVERIFY(heard() < left);
    QVERIFY(!isArmed() && mostOutput() == 0);
}

void TestBcflightDay::playTheRecording()
{
    QTest::keyClick(&window(), Qt::Key_O, Qt::ControlModifier);
    QVERIFY(fileDialog());
    typePath(m_recording);
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().address().isReplay());
    const auto play = m_rig->client().telemetry();
    const int roll = m_rig->client().roles().angle[0];
    QTRY_VERIFY(!std::isnan(play->latest(roll)));
    click(window().findChild<LinkBar *>()->connectButton());
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
}

QTEST_MAIN(TestBcflightDay)
#include "tst_bcflightday.moc"
