// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/record/recordedboard.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/models/changemodel.h"

#include <QLabel>
#include <QSignalSpy>

#include <csignal>

using namespace Qt::StringLiterals;

namespace {

enum class Loss { Cable, Restart };

/// Notes that a command was sent.
class SentWatch final : public FrameListener
{
public:
    explicit SentWatch(QByteArray command)
        : m_command(std::move(command))
    {
    }
    void frameReceived(const FrameView &, TimePoint, bool) override { }
    void bytesSent(QByteArrayView bytes, TimePoint) override
    {
        if (bytes.startsWith(m_command))
            isSent = true;
    }

    std::atomic<bool> isSent = false;

private:
    QByteArray m_command;
};

/// Stops a simulator as soon as this command goes out: the board gets it once it
/// goes on.
class Silencer final : public FrameListener
{
public:
    Silencer(SimProcess &board, int command)
        : m_board(pid_t(board.process().processId()))
        , m_command(command)
    {
    }
    ~Silencer() override { goOn(); }
    Silencer(const Silencer &) = delete;
    Silencer &operator=(const Silencer &) = delete;
    void frameReceived(const FrameView &, TimePoint, bool) override { }
    void bytesSent(QByteArrayView bytes, TimePoint) override
    {
        if (bytes.size() > 1 && quint8(bytes[1]) == m_command && !isSilent.exchange(true))
            ::kill(m_board, SIGSTOP);
    }
    void goOn() { ::kill(m_board, SIGCONT); }

    std::atomic<bool> isSilent = false;

private:
    pid_t m_board;
    int m_command;
};

}  // namespace

/// The link is lost, or the board restarts, in the middle of an action: what is known is told.
class TestInterrupted : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<WindowRig>();
        listen();
    }
    void cleanup() { m_rig.reset(); }
    void anActionIsToldAsItIs_data();
    void anActionIsToldAsItIs();
    void whatHadNotBegunIsToldSo();
    void motorsThatRunAgainAreToldOf_data();
    void motorsThatRunAgainAreToldOf();
    void whatIsStoredIsRead();
    void aSilentBoardIsReadWhenItAnswers();
    void liveValuesAreReadWhenItAnswers();
    void lostLiveValuesAreNamed();
    void recordingsEndWithTheirBoard();
    void recordingsGoOnWithTheirBoard();
    void snapshotsSayWhatTheyHold();

private:
    [[nodiscard]] Workspace &workspace() { return m_rig->workspace(); }
    [[nodiscard]] DeviceClient &client() { return m_rig->client(); }
    [[nodiscard]] QString told() const { return m_told.join(u'\n'); }
    /// Connects to the board at this port and waits until its values in use are known.
    bool openLive(const QString &port)
    {
        if (!m_rig->open(u"serial:%1?family=simplebgc"_s.arg(port)) || !m_rig->jobsAreDone())
            return false;
        const int gain = m_rig->spec(u"pid.roll.p"_s).id;
        return QTest::qWaitFor([&] { return workspace().live().value(gain).has_value(); }, kPatience);
    }
    void listen()
    {
        connect(&workspace().notifications(), &Notifications::problem, this,
                [this](const ErrorText &text) { m_told.append(text.oneLine()); });
        connect(&workspace().notifications(), &Notifications::notice, this,
                [this](const QString &text) { m_told.append(text); });
    }
    /// Performs it, and loses the link once it has got on.
    Result<ActionOutcome> lose(const QString &key, Loss loss)
    {
        std::optional<Result<ActionOutcome>> outcome;
        bool goesOn = false;
        const auto watched
            = connect(&client(), &DeviceClient::progressChanged, this, [&goesOn, key](const Progress &now) {
                  goesOn |= key.startsWith(now.step) && now.done > 2;
              });
        const auto actions = client().device()->actions();
        const auto action = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &each) {
            return key == QLatin1String(each.key);
        });
        const auto arguments = parseArguments(*action, {});
        if (!arguments)
            return tl::unexpected(arguments.error());
        workspace().perform(key, *arguments).then(this, [&outcome](const Result<ActionOutcome> &result) {
            outcome = result;
        });
        const bool runs = QTest::qWaitFor([&] { return goesOn || outcome.has_value(); }, kPatience);
        disconnect(watched);
        m_told.clear();
        if (runs)
            workspace().changeWorld(loss == Loss::Cable ? u"unplug=0"_s : u"reset=0"_s);
        if (!QTest::qWaitFor([&outcome] { return outcome.has_value(); }, kPatience))
            qFatal("no result");
        return *outcome;
    }

    std::unique_ptr<WindowRig> m_rig;
    QStringList m_told;
};

void TestInterrupted::anActionIsToldAsItIs_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("label");
    QTest::addColumn<int>("loss");
    QTest::addColumn<bool>("isBlind");
    for (const auto &[name, loss] : {std::pair("cable", Loss::Cable), std::pair("restart", Loss::Restart)}) {
        QTest::addRow("calibration, %s", name)
            << u"calibrate.gyro"_s << u"Calibrate gyroscope"_s << int(loss) << true;
        QTest::addRow("auto-tune, %s", name) << u"autotune"_s << u"Auto-tune PID"_s << int(loss) << false;
    }
}

void TestInterrupted::anActionIsToldAsItIs()
{
    QFETCH(QString, action);
    QFETCH(QString, label);
    QFETCH(int, loss);
    QFETCH(bool, isBlind);
    // At a rate of its own, a restart does not break the link.
    QVERIFY(m_rig->open(Loss(loss) == Loss::Cable ? u"sim:simplebgc?fault=replug=2"_s
                                                  : u"sim:simplebgc?rate=115200"_s));
    QTRY_VERIFY(client().telemetryPlan().streaming);
    const auto outcome = lose(action, Loss(loss));
    QVERIFY(!outcome);
    QVERIFY(outcome.error().code
            == (Loss(loss) == Loss::Cable ? ErrorCode::LinkClosed : ErrorCode::Restarted));
    QVERIFY(outcome.error().after);
    QVERIFY2(told().contains(u"“%1” was interrupted."_s.arg(label)), qPrintable(told()));
    QVERIFY2(told().contains(u"What the board holds now could not be read."_s), qPrintable(told()));
    QVERIFY2(told().contains(outcome.error().after->snapshotPath), qPrintable(told()));
    QVERIFY2(!told().contains(u"Cancelled."_s), qPrintable(told()));
    QVERIFY2(Loss(loss) == Loss::Cable || !told().contains(u"may go on as before"_s), qPrintable(told()));
    QTRY_VERIFY2(told().contains(u"The board was read again"_s), qPrintable(told()));
    QCOMPARE(told().contains(u"Whether sensors were calibrated cannot be seen from that."_s), isBlind);
    // What was not known before is not said any more.
    QVERIFY(!m_rig->window().messageBar()->text().contains(u"could not be read"_s));
}

void TestInterrupted::motorsThatRunAgainAreToldOf_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<bool>("restarts");
    QTest::addColumn<bool>("wereOff");
    QTest::newRow("restart behind a broken link") << u"sim:simplebgc"_s << true << true;
    QTest::newRow("restart that is noticed") << u"sim:simplebgc?rate=115200"_s << true << true;
    QTest::newRow("they ran before") << u"sim:simplebgc"_s << true << false;
    QTest::newRow("the cable alone") << u"sim:simplebgc?fault=replug=2"_s << false << true;
    QTest::newRow("restart of a STorM32") << u"sim:storm32"_s << true << true;
}

// A board that restarts drives its motors, whoever has switched them off, and forgets what was set live.
void TestInterrupted::motorsThatRunAgainAreToldOf()
{
    QFETCH(QString, address);
    QFETCH(bool, restarts);
    QFETCH(bool, wereOff);
    QVERIFY(m_rig->open(address));
    QTRY_VERIFY(workspace().motorsRunning() == true && !workspace().isStarting());
    LiveModel &live = workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    QTRY_VERIFY(live.value(gain));
    live.setValue(gain, m_rig->raw(u"pid.roll.p"_s) + 5);
    QTRY_VERIFY(live.isSettled() && live.changeCount() == 1);
    if (wereOff) {
        workspace().setMotors(false);
        QTRY_VERIFY(workspace().motorsRunning() == false && !workspace().isStarting());
        QVERIFY(m_rig->boardGoesOn(0.5));
    }
    m_told.clear();
    const QSignalSpy lost(&client(), &DeviceClient::connectionLost);  // a new link may be there at once
    workspace().changeWorld(restarts ? u"reset=0"_s : u"unplug=0"_s);
    QTRY_VERIFY(!lost.isEmpty());
    QTRY_VERIFY(client().isConnected());
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(restarts || !wereOff));
    QVERIFY(m_rig->jobsAreDone());
    if (client().loss() == DeviceClient::Loss::Link)
        QVERIFY2(told().contains(u"What the board does now is not known"_s), qPrintable(told()));
    const QString again = u"The motors run again."_s;
    if (restarts && wereOff)
        QTRY_VERIFY2(told().contains(again), qPrintable(told()));
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(told().contains(again), restarts && wereOff);
    QCOMPARE(told().count(again), restarts && wereOff ? 1 : 0);
    QCOMPARE(told().contains(u"are lost: the board restarted"_s)
                 || told().contains(u"is lost: the board restarted"_s),
             restarts);
    QVERIFY2(!told().contains(u"differ"_s), qPrintable(told()));
    QTRY_COMPARE(live.changeCount(), restarts ? 0 : 1);
    workspace().setMotors(false);
    QTRY_VERIFY(!m_rig->window().messageBar()->text().contains(again));
}

// The board was to be read before, for the snapshot.
void TestInterrupted::whatHadNotBegunIsToldSo()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?fault=replug=-1"_s));
    QVERIFY(m_rig->jobsAreDone());
    std::optional<Result<ActionOutcome>> outcome;
    workspace()
        .perform(u"calibrate.battery"_s, {{u"voltage"_s, 12.0}})
        .then(this, [&outcome](const Result<ActionOutcome> &result) { outcome = result; });
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(outcome);
    QVERIFY(!*outcome && !outcome->error().after);
    QVERIFY2(told().contains(u"It had not begun: nothing was changed."_s), qPrintable(told()));
}

// A board that stores everything in use at once says what is stored only when it is compared.
void TestInterrupted::whatIsStoredIsRead()
{
    QVERIFY(m_rig->open(u"sim:storm32?fault=replug=2"_s));
    QTRY_VERIFY(!workspace().isStarting());
    QVERIFY(m_rig->jobsAreDone());
    LiveModel &live = workspace().live();
    const int gain = m_rig->spec(u"pid.pitch.p"_s).id;
    live.setValue(gain, m_rig->raw(u"pid.pitch.p"_s) + 10);
    QTRY_VERIFY(live.isSettled() && live.changeCount() == 1);
    SentWatch watch("xs"_ba);
    client().addListener(watch);
    std::optional<Result<ActionOutcome>> outcome;
    workspace().perform(u"store"_s, {}).then(this, [&outcome](const Result<ActionOutcome> &result) {
        outcome = result;
    });
    QTRY_VERIFY(watch.isSent);
    m_told.clear();
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(outcome);
    client().removeListener(watch);
    QVERIFY(!*outcome && outcome->error().after && !outcome->error().after->isInUse);
    QVERIFY2(told().contains(u"“Store” was interrupted."_s), qPrintable(told()));
    QTRY_VERIFY2(told().contains(u"it has stored 1 other value"_s), qPrintable(told()));
    QVERIFY2(told().contains(u"pid.pitch.p"_s), qPrintable(told()));
}

// The link stays open all the time: nothing is lost but the answers.
void TestInterrupted::aSilentBoardIsReadWhenItAnswers()
{
    const QString port = m_rig->filePath(u"gimbal"_s);
    SimProcess board({u"--pty"_s, port}, u"simplebgc"_s);
    QVERIFY(m_rig->open(u"serial:%1?family=simplebgc"_s.arg(port)));
    QVERIFY(m_rig->jobsAreDone());
    const QString roll = u"pid.roll.p"_s;
    const QString pitch = u"pid.pitch.p"_s;
    const double before = m_rig->raw(roll);
    const double wanted = before + 9;
    QVERIFY(workspace().edits().edit(m_rig->spec(roll).id, m_rig->model().shownProfile(), wanted));
    QVERIFY(workspace().edits().edit(m_rig->spec(pitch).id, m_rig->model().shownProfile(),
                                     m_rig->raw(pitch) + 9));
    Silencer silencer(board, int(simplebgc::CommandId::WriteParams3));
    client().addListener(silencer);
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    workspace().write(m_rig->model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(silencer.isSilent);
    QVERIFY(client().isConnected());
    QVERIFY(workspace().lastReport()->hasUnknown());
    // What nobody knows is not told.
    const auto shown = [this] {
        const ChangeModel changes(std::as_const(m_rig->model()).board(), m_rig->model().edited());
        return changes.rowCount() > 0 ? changes.index(0, ChangeModel::BoardColumn).data().toString()
                                      : QString();
    };
    QCOMPARE(shown(), u"not known"_s);
    silencer.goOn();
    QTRY_VERIFY2(told().contains(u"The interrupted write was complete"_s)
                     || m_rig->window().offerBar()->text().contains(u"was interrupted"_s),
                 qPrintable(told()));
    client().removeListener(silencer);
    QVERIFY2(shown() != u"not known"_s, qPrintable(shown()));
    const double now = m_rig->raw(roll);
    const auto found = client().submit<Configuration>(
        [](Channel &channel, Device &device) { return device.readConfiguration(channel); });
    QTRY_VERIFY(found.isFinished());
    QVERIFY(found.result());
    QCOMPARE(std::optional(now), found.result()->raw(m_rig->spec(roll), m_rig->model().shownProfile()));
    QVERIFY(!m_rig->window().messageBar()->text().contains(u"could not be read"_s));
}

void TestInterrupted::liveValuesAreReadWhenItAnswers()
{
    const QString port = m_rig->filePath(u"gimbal"_s);
    SimProcess board({u"--pty"_s, port}, u"simplebgc"_s);
    QVERIFY(openLive(port));
    LiveModel &live = workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    Silencer silencer(board, int(simplebgc::CommandId::SetAdjVarsVal));
    client().addListener(silencer);
    live.setValue(gain, m_rig->raw(u"pid.roll.p"_s) + 5);
    QTRY_VERIFY(live.isDoubted() && m_rig->jobsAreDone());
    QVERIFY(client().isConnected());
    silencer.goOn();
    QTRY_VERIFY(!live.isDoubted());
    client().removeListener(silencer);
    QVERIFY(live.value(gain));
}

// Nothing of what was sent has arrived.
void TestInterrupted::lostLiveValuesAreNamed()
{
    const QString port = m_rig->filePath(u"gimbal"_s);
    SimProcess board({u"--pty"_s, port}, u"simplebgc"_s);
    QVERIFY(openLive(port));
    LiveModel &live = workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    const double before = *live.value(gain);
    board.process().write("lose=1\n");
    QTRY_VERIFY(workspace().freshness().staleSince());
    live.setValue(gain, before + 5);
    QTRY_VERIFY(live.isDoubted());
    const auto *bar = m_rig->window().findChild<UnstoredBar *>();
    const auto said = [bar] {
        QStringList texts;
        for (const QLabel *label : bar->findChildren<QLabel *>())
            texts.append(label->text() + label->toolTip());
        return texts.join(u' ');
    };
    QTRY_VERIFY2(bar->isVisible() && said().contains(u"is not known"_s), qPrintable(said()));
    QVERIFY(client().isConnected());
    board.process().write("lose=0\n");
    QTRY_VERIFY(!live.isDoubted());
    QCOMPARE(*live.value(gain), before);
    QTRY_VERIFY(!bar->isVisible());
    const QString told = m_rig->window().messageBar()->text();
    QVERIFY2(told.contains(u"did not get what was set"_s), qPrintable(told));
}

void TestInterrupted::recordingsEndWithTheirBoard()
{
    const QString port = m_rig->filePath(u"gimbal"_s);
    auto board = std::make_unique<SimProcess>(QStringList{u"--pty"_s, port}, u"simplebgc"_s);
    QVERIFY(m_rig->open(u"serial:%1?family=simplebgc"_s.arg(port)));
    const QString path = m_rig->filePath(u"first.gdrec"_s);
    QVERIFY(workspace().recorder().start(path));
    QVERIFY(m_rig->boardGoesOn(0.5));
    AlarmReport report;
    report.number = 1;
    report.action = AlarmAction::MotorsOff;
    emit client().alarmChanged(report);
    QCOMPARE(workspace().alarms().all().size(), 1);
    const std::shared_ptr<const TelemetryStore> first = client().telemetry();
    const QString serial = client().identity().serial;
    board.reset();
    QTRY_VERIFY(!client().isConnected());
    const quint64 rows = first->rows();
    board = std::make_unique<SimProcess>(QStringList{u"--pty"_s, port, u"--seed"_s, u"7"_s}, u"simplebgc"_s);
    QTRY_VERIFY(client().isConnected());
    QVERIFY(client().identity().serial != serial);
    QVERIFY(m_rig->boardGoesOn(0.5));
    QVERIFY(client().telemetry() != first);
    QCOMPARE(first->rows(), rows);
    QVERIFY(workspace().alarms().all().isEmpty());
    QVERIFY(!workspace().recorder().isRecording());
    QTRY_VERIFY2(told().contains(u"another board answers on this link"_s), qPrintable(told()));
    QTRY_VERIFY2(told().contains(u"Recording saved to"_s), qPrintable(told()));
    const auto recording = Recording::load(path);
    QVERIFY(recording);
    QCOMPARE(recording->description.value(u"serial"_s).toString(), serial);
    // Nor do the minutes that are held begin with the board before.
    const QString second = m_rig->filePath(u"second.gdrec"_s);
    m_told.clear();
    QVERIFY(workspace().recorder().savePast(second));
    QTRY_VERIFY2(told().contains(u"Recording saved to"_s), qPrintable(told()));
    const auto past = Recording::load(second);
    QVERIFY(past);
    for (const Family &family : allFamilies()) {
        if (family.key != u"simplebgc"_s)
            continue;
        const auto identity = identifyRecorded(*past, family, *family.makeDevice());
        QVERIFY(identity);
        QCOMPARE(identity->serial, client().identity().serial);
    }
}

void TestInterrupted::recordingsGoOnWithTheirBoard()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?fault=replug=1"_s));
    const QString path = m_rig->filePath(u"whole.gdrec"_s);
    QVERIFY(workspace().recorder().start(path));
    QVERIFY(m_rig->boardGoesOn(0.5));
    const std::shared_ptr<const TelemetryStore> store = client().telemetry();
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(!client().isConnected());
    const qint64 size = workspace().recorder().size();
    QTRY_VERIFY(client().isConnected());
    QVERIFY(client().telemetry() == store);
    QVERIFY(workspace().recorder().isRecording());
    QTRY_VERIFY(workspace().recorder().size() > size + 2000);
    workspace().recorder().stop();
    QTRY_VERIFY2(told().contains(u"Recording saved to"_s), qPrintable(told()));
    QVERIFY(Recording::load(path));
}

void TestInterrupted::snapshotsSayWhatTheyHold()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QVERIFY(m_rig->jobsAreDone());
    workspace().takeSnapshot();
    QVERIFY2(told().contains(u"Snapshot taken of what is in use"_s), qPrintable(told()));
    QTRY_VERIFY(!workspace().isStarting());
    bool isCompared = false;
    workspace().compareStored().then(
        this, [&isCompared](const Result<WholeMemory::Contents> &both) { isCompared = both.has_value(); });
    QTRY_VERIFY(isCompared);
    m_told.clear();
    workspace().takeSnapshot();
    QVERIFY2(told().contains(u"Snapshot taken."_s), qPrintable(told()));
    QVERIFY2(!told().contains(u"in use"_s), qPrintable(told()));
}

QTEST_MAIN(TestInterrupted)
#include "tst_interrupted.moc"
