// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/deviceclient.h"
#include "protocol/procedure/writeconfiguration.h"
#include "tests/support/ctlrun.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/toyfamily/toycomposition.h"

#include <QJsonArray>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace {

/// A family, and a firmware of it, as this test meets it.
struct Tried
{
    QString key;
    QStringList options;
    int deaf;  // the number of the command that reads, none of which is answered
    QString simulator;
    QString program;
    QString value;  // a parameter
    QString wanted;  // a value of it that no board holds at first
    bool isNetwork = false;  // reached by UDP
};

const QList<Tried> &families()
{
    static const QList<Tried> all{
        {u"simplebgc"_s, {}, 21, u"gimbalsim"_s, u"gimbalctl"_s, u"pid.roll.p"_s, u"44"_s},
        {u"storm32"_s,
         {u"--firmware"_s, u"0.79"_s},
         'g',
         u"gimbalsim"_s,
         u"gimbalctl"_s,
         u"pid.pitch.p"_s,
         u"4.50"_s},
        {u"storm32"_s,
         {u"--firmware"_s, u"0.90"_s},
         'g',
         u"gimbalsim"_s,
         u"gimbalctl"_s,
         u"pid.pitch.p"_s,
         u"4.50"_s},
        {u"storm32"_s,
         {u"--firmware"_s, u"0.96"_s},
         'g',
         u"gimbalsim"_s,
         u"gimbalctl"_s,
         u"pid.pitch.p"_s,
         u"4.50"_s},
        {u"bcflight"_s,
         {u"--generation"_s, u"G"_s},
         0x23,
         u"gimbalsim"_s,
         u"gimbalctl"_s,
         u"pid.roll.p"_s,
         u"0.0018"_s,
         true},
        {u"toy"_s, {}, -1, u"toysim"_s, u"toyctl"_s, u"flight.limit"_s, u"1234"_s, true},
    };
    return all;
}

QString nameOf(const Tried &tried)
{
    return tried.options.isEmpty() ? tried.key : tried.key + u' ' + tried.options.last();
}

/// A way to misbehave, and whether the board can be read and written all the same.
struct Kind
{
    const char *name;
    QStringList faults;
    bool mustWork;
    QStringList ofPackets = {};  // instead of these, where whole packets are hit; what UDP keeps out is none
};

const QList<Kind> &kinds()
{
    static const QList<Kind> all{
        {"well", {}, true},
        {"late", {u"late=150"_s}, true},
        {"at any time", {u"delay=60"_s}, true},
        {"twice", {u"double=0.001"_s}, false, {u"double=0.2"_s}},
        {"wrong lengths", {u"lose=0.001"_s}, false, {u"lose=0.05"_s}},
        {"errors", {u"flip=0.001"_s}, false, {u"reorder=0.2"_s}},
        {"resets", {u"reset-on-write=1"_s}, false},
    };
    return all;
}

}  // namespace

bool isRestartedDrone(const Tried &tried, const Kind &kind)
{
    return tried.key == u"bcflight"_s && kind.faults.contains(u"reset-on-write=1"_s);
}

template <typename T> Result<T> wait(QFuture<Result<T>> future)
{
    if (!QTest::qWaitFor([&future] { return future.isFinished(); }, kPatience))
        return failure(ErrorCode::Timeout, u"the test waited too long"_s);
    return future.result();
}

QStringList simulatorOptions(const Tried &tried, const Kind &kind, const QString &path)
{
    QStringList options
        = tried.options + (tried.isNetwork ? QStringList{u"--udp"_s, u"0"_s} : QStringList{u"--pty"_s, path});
    const bool hitsPackets = tried.key == u"bcflight"_s && !kind.ofPackets.isEmpty();
    for (const QString &fault : hitsPackets ? kind.ofPackets : kind.faults)
        options += {u"--fault"_s, fault};
    return options;
}

QString linkTo(const Tried &tried, const SimProcess &board, const QString &path)
{
    return tried.isNetwork ? board.address() : u"serial:%1?family=%2"_s.arg(path, tried.key);
}

/// Boards that misbehave, in each family: what gimbalctl says of values is so, or it says that it failed.
class TestMisbehaving : public QObject
{
    Q_OBJECT
private slots:
    void nothingFalseIsSaid_data();
    void nothingFalseIsSaid();
    void clientSaysNothingFalse_data() { nothingFalseIsSaid_data(); }
    void clientSaysNothingFalse();
    void unansweredIsNoValue_data();
    void unansweredIsNoValue();
    void slowBoardInANetwork_data();
    void slowBoardInANetwork();
    void lockedOutBoardInANetwork();
};

void TestMisbehaving::nothingFalseIsSaid_data()
{
    QTest::addColumn<int>("family");
    QTest::addColumn<int>("kind");
    for (int family = 0; family < int(families().size()); ++family) {
        for (int kind = 0; kind < int(kinds().size()); ++kind) {
            // The toy's simulator has no faults of its own.
            if (families()[family].key == u"toy"_s && kinds()[kind].faults.contains(u"reset-on-write=1"_s))
                continue;
            QTest::addRow("%s: %s", qPrintable(nameOf(families()[family])), kinds()[kind].name)
                << family << kind;
        }
    }
}

void TestMisbehaving::nothingFalseIsSaid()
{
    QFETCH(int, family);
    QFETCH(int, kind);
    const Tried &tried = families()[family];
    const Kind &misbehaves = kinds()[kind];
    const QTemporaryDir dir;
    const SimProcess board(simulatorOptions(tried, misbehaves, dir.filePath(u"board"_s)), tried.key,
                           tried.simulator);
    const QString link = linkTo(tried, board, dir.filePath(u"board"_s));
    const auto ctl = [&](const QStringList &arguments) {
        return Running(dir.path(), QStringList{u"--link"_s, link} + arguments, tried.program).finish(60000);
    };
    const auto fails = [&](const Run &run) {
        return run.exitCode == 1 && !run.err.trimmed().isEmpty() && !misbehaves.mustWork;
    };

    const Run before = ctl({u"get"_s, tried.value});
    QVERIFY2(before.exitCode == 0 || fails(before), qPrintable(before.err));
    QVERIFY2(before.exitCode == 0 || before.out.isEmpty(), qPrintable(before.out));

    const Run set = ctl({u"--json"_s, u"set"_s, tried.value + u'=' + tried.wanted});
    QVERIFY2(set.exitCode == 0 || fails(set), qPrintable(set.err));
    // What a board that keeps two memories apart is told to hold is what it has stored.
    bool isRetrieved = set.exitCode == 0 || tried.key != u"storm32"_s;
    for (int i = 0; i < 10 && !isRetrieved; ++i)
        isRetrieved = ctl({u"do"_s, u"retrieve"_s, u"--confirmed"_s}).exitCode == 0;
    QVERIFY(isRetrieved);
    // What the board holds, told by itself: asked until it is told.
    Run after;
    for (int i = 0; i < 10 && after.exitCode != 0; ++i)
        after = ctl({u"get"_s, tried.value});
    QVERIFY2(after.exitCode == 0, qPrintable(after.err));
    const double holds = after.out.trimmed().toDouble();
    if (set.exitCode == 0)
        QCOMPARE(holds, tried.wanted.toDouble());
    // It has restarted, and flies with what stands in its text.
    if (isRestartedDrone(tried, misbehaves)) {
        QCOMPARE(set.exitCode, 1);
        QVERIFY(holds != tried.wanted.toDouble());
    }
    const QJsonArray written = set.json().value(u"written"_s).toArray();
    for (const QJsonValue value : written) {
        const QJsonObject line = value.toObject();
        if (line.contains(u"onBoard"_s))
            QCOMPARE(holds, line.value(u"onBoard"_s).toString().toDouble());
        if (line.value(u"state"_s) == u"verified"_s)
            QCOMPARE(holds, tried.wanted.toDouble());
    }
    // Before anything was written the board as it was has been kept, and the path is told.
    if (!written.isEmpty())
        QVERIFY(QFile::exists(set.json().value(u"snapshot"_s).toString()));
}

// The same through the client that window and programs share: each line of the report is so.
void TestMisbehaving::clientSaysNothingFalse()
{
    QFETCH(int, family);
    QFETCH(int, kind);
    const Tried &tried = families()[family];
    const Kind &misbehaves = kinds()[kind];
    const QTemporaryDir dir;
    const bool isToy = tried.key == u"toy"_s;
    const SimProcess board(simulatorOptions(tried, misbehaves, dir.filePath(u"board"_s)), tried.key,
                           tried.simulator);
    const QString link = linkTo(tried, board, dir.filePath(u"board"_s));
    std::optional<Result<WriteReport>> report;
    {
        DeviceClient client(isToy ? toyLinks().transports : allLinks().transports,
                            isToy ? toyFamilies() : allFamilies());
        client.connectTo(*LinkAddress::parse(link), tried.key);
        const bool isConnected = QTest::qWaitFor([&client] { return client.isConnected(); }, kPatience);
        QVERIFY(isConnected || !misbehaves.mustWork);
        if (isConnected) {
            const BoardHistory history(dir.filePath(u"kept"_s));
            report = wait(
                client.submit<WriteReport>([&](Channel &channel, Device &device) -> Result<WriteReport> {
                    const auto base = device.readConfiguration(channel);
                    if (!base)
                        return tl::unexpected(base.error());
                    const ParameterSpec *spec = base->parameters().find(tried.value);
                    Configuration edited = *base;
                    const auto raw = spec->parse(tried.wanted);
                    if (!raw || !edited.setRaw(*spec, edited.activeProfile(), *raw))
                        return failure(ErrorCode::InvalidArgument, tried.wanted);
                    WriteOptions options;
                    options.history = &history;
                    return writeConfiguration(channel, device, *base, edited, options);
                }));
        }
        client.shutDown();
    }
    // A board that was reset is absent from its bus for a while.
    QTRY_VERIFY(tried.isNetwork || QFile::exists(dir.filePath(u"board"_s)));
    Run after;
    bool isRetrieved = tried.key != u"storm32"_s;
    for (int i = 0; i < 10 && !isRetrieved; ++i) {
        const QStringList retrieve{u"--link"_s, link, u"do"_s, u"retrieve"_s, u"--confirmed"_s};
        isRetrieved = Running(dir.path(), retrieve, tried.program).finish(60000).exitCode == 0;
    }
    QVERIFY(isRetrieved);
    for (int i = 0; i < 10 && after.exitCode != 0; ++i)
        after = Running(dir.path(), {u"--link"_s, link, u"get"_s, tried.value}, tried.program).finish(60000);
    QVERIFY2(after.exitCode == 0, qPrintable(after.err));
    const double holds = after.out.trimmed().toDouble();
    const bool isDone = report && report->has_value() && (*report)->isComplete();
    QVERIFY(isDone || !misbehaves.mustWork);
    if (isRestartedDrone(tried, misbehaves))
        QVERIFY(!isDone && holds != tried.wanted.toDouble());
    if (isDone)
        QCOMPARE(holds, tried.wanted.toDouble());
    if (!report || !report->has_value())
        return;
    for (const WriteLine &line : (*report)->lines) {
        if (line.state != WriteState::Unknown)
            QVERIFY2(qFuzzyCompare(line.spec->format(line.found).toDouble(), holds),
                     qPrintable(u"said to be %1, holds %2; state %3, %4"_s.arg(line.spec->format(line.found))
                                    .arg(holds)
                                    .arg(int(line.state))
                                    .arg((*report)->error ? (*report)->error->detail : QString())));
    }
}

void TestMisbehaving::unansweredIsNoValue_data()
{
    QTest::addColumn<int>("family");
    for (int family = 0; family < int(families().size()); ++family) {
        if (families()[family].deaf >= 0)
            QTest::addRow("%s", qPrintable(nameOf(families()[family]))) << family;
    }
}

// The question for the values is never answered: nothing is said of them, and nothing is written.
void TestMisbehaving::unansweredIsNoValue()
{
    QFETCH(int, family);
    const Tried &tried = families()[family];
    const QTemporaryDir dir;
    const Kind never{"never", {u"deaf=%1"_s.arg(tried.deaf)}, false};
    const SimProcess board(simulatorOptions(tried, never, dir.filePath(u"board"_s)), tried.key,
                           tried.simulator);
    const QString link = linkTo(tried, board, dir.filePath(u"board"_s));
    for (const QStringList &command :
         {QStringList{u"get"_s, tried.value}, QStringList{u"set"_s, tried.value + u'=' + tried.wanted},
          QStringList{u"--json"_s, u"dump"_s, dir.filePath(u"all.json"_s)}}) {
        const Run run
            = Running(dir.path(), QStringList{u"--link"_s, link} + command, tried.program).finish(120000);
        QVERIFY2(run.exitCode == 1 && !run.err.trimmed().isEmpty(),
                 qPrintable(command.first() + u": "_s + run.out + run.err));
        QVERIFY2(!run.out.contains(u"verified"_s), qPrintable(run.out));
    }
}

void TestMisbehaving::slowBoardInANetwork_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("late");
    QTest::addColumn<bool>("isUsable");
    for (const int late : {0, 300, 700, 1500})
        QTest::addRow("simplebgc %d ms", late) << u"simplebgc"_s << late << (late < 500);
    for (const int late : {0, 300, 800})
        QTest::addRow("storm32 %d ms", late) << u"storm32"_s << late << (late <= 300);
}

// Nobody says which family it is: what it answers too late is credited to no other one.
void TestMisbehaving::slowBoardInANetwork()
{
    QFETCH(QString, family);
    QFETCH(int, late);
    QFETCH(bool, isUsable);
    const QTemporaryDir dir;
    const SimProcess board({u"--tcp"_s, u"0"_s, u"--fault"_s, u"late=%1"_s.arg(late)}, family);
    const Run info = Running(dir.path(), {u"--link"_s, board.address(), u"info"_s}).finish(60000);
    const QString name = family == u"simplebgc"_s ? u"SimpleBGC"_s : u"STorM32"_s;
    if (isUsable)
        QVERIFY2(info.exitCode == 0, qPrintable(info.err));
    if (info.exitCode == 0) {
        QVERIFY2(info.out.contains(name), qPrintable(info.out));
        return;
    }
    QCOMPARE(info.exitCode, 1);
    if (family == u"simplebgc"_s)
        QVERIFY2(!info.err.contains(u"(v)"_s), qPrintable(info.err));
}

void TestMisbehaving::lockedOutBoardInANetwork()
{
    const QTemporaryDir dir;
    const SimProcess board({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s}, u"storm32"_s);
    const auto ctl = [&](const QStringList &arguments) {
        return Running(dir.path(), QStringList{u"--link"_s, board.address()} + arguments).finish(60000);
    };
    const Run set = ctl({u"set"_s, u"--no-save"_s, u"mavlink.heartbeat=1"_s});
    QVERIFY2(set.exitCode == 0, qPrintable(set.err));
    const Run info = ctl({u"info"_s});
    QVERIFY2(info.exitCode == 0 && info.out.contains(u"STorM32"_s), qPrintable(info.err));
}

QTEST_GUILESS_MAIN(TestMisbehaving)
#include "tst_misbehaving.moc"
