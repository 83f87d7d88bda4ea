// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/parametertables.h"
#include "tests/support/virtualboard.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

constexpr LineSettings kLine{115200, Parity::None};
const QString kHere = u"pid.roll.p"_s;  // PARAMS_3
const QString kRestarting = u"motion.roll.acc_limit"_s;  // PARAMS_EXT2

/// A board that restarts when PARAMS_EXT2 is written, as its parameter set says; the test does it for it.
class Bench
{
public:
    explicit Bench(bool usb = false, milliseconds restartTime = 0ms)
        : m_board(optionsFor(usb), usb ? std::nullopt : std::optional(kLine))
        , m_history(m_dir.path())
    {
        if (!m_board.identify())
            qFatal("not identified");
        std::copy(std::begin(kBlocks), std::end(kBlocks), m_blocks.begin());
        m_blocks[ParamsExt2].effect = WriteEffect::Restarts;
        m_blocks[ParamsExt2].restartTime = restartTime;
        const auto read = m_board.device.readConfiguration(m_board.channel);
        const BoardIdentity &identity = read->identity();
        m_base
            = Configuration(identity,
                            std::make_shared<ParameterSet>(parameterRows(), m_blocks, identity.firmwareNumber,
                                                           identity.capabilities));
        for (const auto &[key, bytes] : read->blocks())
            m_base.setBlock(key, bytes);
        m_base.setActiveProfile(read->activeProfile());
        m_base.setProfileNames(read->profileNames());
        m_edited = m_base;
        edit(kHere, 44);
        edit(kRestarting, 50);
    }

    void edit(const QString &key, double raw)
    {
        if (!m_edited.setRaw(*m_base.parameters().find(key), 0, raw))
            qFatal("not edited");
    }
    /// Done each time that the restart of the board is waited for.
    template <typename Function> void whenRestarting(Function then)
    {
        m_board.channel.setOperator([then](const Progress &progress) {
            if (progress.step == u"await-restart"_s)
                then();
        });
    }
    /// The board goes down after so long.
    void restart(milliseconds after = 0ms)
    {
        const auto delay = quint16(after.count());
        m_board.port.hostWrites(
            asBytes(encodeFrame(int(CommandId::Reset), ByteWriter().u8(0).write(delay).take(), 1)));
    }
    Result<WriteReport> write()
    {
        WriteOptions options;
        options.history = &m_history;
        return writeConfiguration(m_board.channel, m_board.device, m_base, m_edited, options);
    }
    [[nodiscard]] int stored(const QString &key) { return m_board.board().stored(key, 0); }
    VirtualBoard &virtualBoard() { return m_board; }
    [[nodiscard]] QStringList steps() const
    {
        QStringList steps;
        for (const Progress &progress : m_board.channel.progressReports())
            steps.append(progress.step + u' ' + progress.subject);
        return steps;
    }

private:
    static SimulatorOptions optionsFor(bool usb)
    {
        SimulatorOptions options;
        options.usb = usb;
        return options;
    }

    QTemporaryDir m_dir;
    VirtualBoard m_board;
    BoardHistory m_history;
    std::array<BlockSpec, BlockCount> m_blocks;
    Configuration m_base;
    Configuration m_edited;
};

}  // namespace

/// Blocks whose writing restarts the board.
class TestRestart : public QObject
{
    Q_OBJECT
private slots:
    void isWaitedFor_data();
    void isWaitedFor();
    void comesLast();
    void mayNotHappen();
    void tooLongIsReportedTruly();
    void aClosedLinkIsReportedTruly();
    void canBeCancelled();
    void lostValuesAreRolledBack();
};

void TestRestart::isWaitedFor_data()
{
    QTest::addColumn<int>("afterMs");
    QTest::newRow("at once") << 0;
    QTest::newRow("after its confirmation") << 400;
    QTest::newRow("while it is asked whether it is back") << 990;
    QTest::newRow("after it has answered once more") << 1020;
}

void TestRestart::isWaitedFor()
{
    QFETCH(int, afterMs);
    Bench bench;
    bench.whenRestarting([&] { bench.restart(milliseconds(afterMs)); });
    const auto report = bench.write();
    QVERIFY(report);
    QVERIFY2(report->isComplete(), report->error ? qPrintable(report->error->detail) : "");
    QCOMPARE(report->count(WriteState::Verified), 2);
    QCOMPARE(bench.stored(kHere), 44);
    QCOMPARE(bench.stored(kRestarting), 50);
    for (const Progress &progress : bench.virtualBoard().channel.progressReports())
        QVERIFY(progress.done < progress.total);
}

void TestRestart::comesLast()
{
    Bench bench;
    bench.whenRestarting([&] { bench.restart(); });
    QVERIFY(bench.write()->isComplete());
    QStringList steps = bench.steps();
    steps.erase(std::remove_if(steps.begin(), steps.end(),
                               [](const QString &step) { return step.startsWith(u"read-block"_s); }),
                steps.end());
    const QStringList expected{u"write-block PARAMS_3"_s, u"write-block PARAMS_EXT2"_s,
                               u"await-restart PARAMS_EXT2"_s, u"verify-block PARAMS_3"_s,
                               u"verify-block PARAMS_EXT2"_s};
    QCOMPARE(steps, expected);
}

void TestRestart::mayNotHappen()
{
    Bench bench;
    const TimePoint before = bench.virtualBoard().channel.now();
    QVERIFY(bench.write()->isComplete());
    QVERIFY(bench.virtualBoard().channel.now() - before < 5s);  // it answers, so nothing is waited for
}

void TestRestart::tooLongIsReportedTruly()
{
    Bench bench(false, 4s);
    // The board loses everything that it hears.
    bench.whenRestarting([&] { QVERIFY(bench.virtualBoard().port.change(u"lose=1"_s)); });
    const TimePoint before = bench.virtualBoard().channel.now();
    const auto report = bench.write();
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->error->code, ErrorCode::Timeout);
    QCOMPARE(report->count(WriteState::Unknown), 2);
    const Duration waited = bench.virtualBoard().channel.now() - before;
    QVERIFY2(waited > 4s && waited < 12s, qPrintable(QString::number(seconds(waited))));
    QVERIFY(!bench.steps().contains(u"roll-back PARAMS_3"_s));
}

// On USB the link goes with the board: the reconnection decides, not this job.
void TestRestart::aClosedLinkIsReportedTruly()
{
    Bench bench(true);
    bench.whenRestarting([&] {
        bench.restart();
        bench.virtualBoard().port.advance(100ms);
        QVERIFY(!bench.virtualBoard().port.isPlugged());
    });
    const auto report = bench.write();
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->error->code, ErrorCode::LinkClosed);
    QCOMPARE(report->count(WriteState::Unknown), 2);
    QCOMPARE(bench.stored(kRestarting), 50);
}

void TestRestart::canBeCancelled()
{
    Bench bench;
    bench.whenRestarting([&] {
        bench.restart();
        bench.virtualBoard().channel.cancelAfter(500ms);
    });
    const auto report = bench.write();
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->error->code, ErrorCode::Cancelled);
    QCOMPARE(report->count(WriteState::Unknown), 2);
}

// The board comes back with what it had before: the rest is put back, and it does not restart again for
// what it holds already.
void TestRestart::lostValuesAreRolledBack()
{
    Bench bench;
    const int before = bench.stored(kHere);
    const int restartingBefore = bench.stored(kRestarting);
    QVERIFY(before != 44 && restartingBefore != 50);
    int restarts = 0;
    bench.whenRestarting([&] {
        if (++restarts == 1)
            bench.virtualBoard().board().store(kRestarting, 0, restartingBefore);
        bench.restart();
    });
    const auto report = bench.write();
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->error->code, ErrorCode::VerifyFailed);
    QCOMPARE(restarts, 1);
    QCOMPARE(bench.stored(kHere), before);
    QCOMPARE(bench.stored(kRestarting), restartingBefore);
    QCOMPARE(report->count(WriteState::RolledBack), 1);
    QCOMPARE(report->count(WriteState::Mismatch), 1);  // what the board made of the write
}

QTEST_GUILESS_MAIN(TestRestart)
#include "tst_restart.moc"
