// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/aftermath.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"
#include "widgets/models/errortext.h"

#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

enum class Wrong {
    AnswerLost,
    AnswersLost,  // of it and of everything after it
    Refused,
    NotTaken,
    LinkBroken,  // once the board has taken it
    LinkBrokenBefore,
};

/// Something goes wrong the first time that a request with this name is sent, and for the last kinds from
/// then on.
class Meddler final : public ChannelProxy
{
public:
    Meddler(Channel &channel, QString name, Wrong wrong)
        : ChannelProxy(channel)
        , m_name(std::move(name))
        , m_wrong(wrong)
    {
    }
    void mend() { m_isMended = true; }
    Result<Frame> transact(const Request &request) override
    {
        const Error silence{ErrorCode::Timeout, request.name, 0};
        const Error broken{ErrorCode::LinkClosed, {}, 0};
        const bool isFirst = !m_isMet && request.name == m_name;
        if (m_isMended || !(isFirst || m_isMet))
            return ChannelProxy::transact(request);
        const bool wasMet = std::exchange(m_isMet, true);
        const bool isBroken = m_wrong == Wrong::LinkBroken || m_wrong == Wrong::LinkBrokenBefore;
        if (wasMet && !isBroken && m_wrong != Wrong::AnswersLost)
            return ChannelProxy::transact(request);
        if (wasMet || m_wrong == Wrong::LinkBrokenBefore)
            return tl::unexpected(isBroken ? broken : silence);
        if (m_wrong == Wrong::Refused)
            return failure(ErrorCode::BoardError, u"wrong parameters"_s);
        if (m_wrong == Wrong::NotTaken)
            return Frame{};
        std::ignore = ChannelProxy::transact(request);
        return tl::unexpected(isBroken ? broken : silence);
    }

private:
    QString m_name;
    Wrong m_wrong;
    bool m_isMet = false;
    bool m_isMended = false;
};

/// Requests with this name stay without an answer; something happens instead.
class SilentAt final : public ChannelProxy
{
public:
    SilentAt(Channel &channel, QString name, std::function<void()> instead)
        : ChannelProxy(channel)
        , m_name(std::move(name))
        , m_instead(std::move(instead))
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        if (request.name != m_name)
            return ChannelProxy::transact(request);
        m_instead();
        return failure(ErrorCode::Timeout, request.name);
    }

private:
    QString m_name;
    std::function<void()> m_instead;
};

/// A board that was read, an edited copy of it, and a history in a temporary folder.
struct Bench
{
    explicit Bench(const SimulatorOptions &options = {})
        : board(options)
        , history(dir.path())
    {
        if (!board.identify())
            qFatal("not identified");
        base = *board.device.readConfiguration(board.channel);
        edited = base;
    }
    void rename(int profile, const QString &name)
    {
        QStringList names = edited.profileNames();
        names.resize(base.identity().profileCount);
        names[profile] = name;
        edited.setProfileNames(names);
    }
    Result<WriteReport> write(Channel &channel)
    {
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(channel, board.device, base, edited, options);
    }
    QStringList names() { return *board.device.readProfileNames(board.channel); }

    QTemporaryDir dir;
    VirtualBoard board;
    BoardHistory history;
    Configuration base;
    Configuration edited;
};

}  // namespace

/// What is said after something failed is what the board holds.
class TestAftermath : public QObject
{
    Q_OBJECT
private slots:
    void namesThatWereNotReadAreNotErased();
    void namesOfSomebodyElseAreAConflict();
    void failedRenameIsToldTruly_data();
    void failedRenameIsToldTruly();
    void failedActionTellsWhatDiffers_data();
    void failedActionTellsWhatDiffers();
    void restartDuringAnActionIsNamed_data();
    void restartDuringAnActionIsNamed();
    void linkLostBeforeStoringIsUnknown();
};

void TestAftermath::namesThatWereNotReadAreNotErased()
{
    SimulatorOptions options;
    Bench bench(options);
    const QStringList before = bench.names();
    options.faults.deaf = 28;  // READ_PROFILE_NAMES
    bench.board.board().setFaults(options.faults);
    bench.base = *bench.board.device.readConfiguration(bench.board.channel);
    QCOMPARE(bench.base.missingNames(), QStringList{u"profile names"_s});
    bench.board.board().setFaults({});
    bench.edited = bench.base;
    bench.rename(1, u"Studio"_s);
    const auto report = bench.write(bench.board.channel);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Incomplete);
    QVERIFY2(describe(report.error()).cure.contains(u"Read the board again"_s),
             qPrintable(describe(report.error()).oneLine()));
    QCOMPARE(bench.names(), before);
}

void TestAftermath::namesOfSomebodyElseAreAConflict()
{
    Bench bench;
    bench.rename(0, u"Mine"_s);
    QStringList theirs = bench.names();
    theirs[3] = u"Theirs"_s;
    QVERIFY(bench.board.device.writeProfileNames(bench.board.channel, theirs));
    const auto report = bench.write(bench.board.channel);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Conflict);
    QVERIFY2(report.error().detail.contains(u"Theirs"_s), qPrintable(report.error().detail));
    QCOMPARE(bench.names(), theirs);
}

void TestAftermath::failedRenameIsToldTruly_data()
{
    QTest::addColumn<int>("wrong");
    QTest::addColumn<WriteState>("state");
    QTest::newRow("answer lost") << int(Wrong::AnswerLost) << WriteState::RolledBack;
    QTest::newRow("answers lost") << int(Wrong::AnswersLost) << WriteState::Unknown;
    QTest::newRow("refused") << int(Wrong::Refused) << WriteState::NotWritten;
    QTest::newRow("not taken") << int(Wrong::NotTaken) << WriteState::Mismatch;
    QTest::newRow("link broken") << int(Wrong::LinkBroken) << WriteState::Unknown;
}

void TestAftermath::failedRenameIsToldTruly()
{
    QFETCH(int, wrong);
    QFETCH(WriteState, state);
    Bench bench;
    const QStringList before = bench.names();
    bench.rename(0, u"Mine"_s);
    Meddler meddler(bench.board.channel, u"WRITE_PROFILE_NAMES"_s, Wrong(wrong));
    const auto report = bench.write(meddler);
    QVERIFY(report && !report->isComplete());
    QVERIFY(!report->areNamesWritten());
    QCOMPARE(report->namesState, state);
    const QString text = describe(*report).oneLine();
    if (state == WriteState::Unknown) {
        QVERIFY2(text.contains(u"could not be read"_s), qPrintable(text));
        QVERIFY2(!text.contains(u"old values"_s), qPrintable(text));
        // Once the board can be asked, what it holds is known.
        WriteReport later = *report;
        later.learn(*bench.board.device.readConfiguration(bench.board.channel));
        QCOMPARE(later.namesState, bench.names() == before ? WriteState::NotWritten : WriteState::Verified);
        return;
    }
    QCOMPARE(bench.names(), before);
    QVERIFY2(text.contains(before.first()), qPrintable(text));
}

void TestAftermath::failedActionTellsWhatDiffers_data()
{
    QTest::addColumn<int>("wrong");
    QTest::addColumn<bool>("isChanged");
    QTest::addColumn<bool>("isKnown");
    QTest::newRow("answer lost") << int(Wrong::AnswerLost) << true << true;
    QTest::newRow("refused") << int(Wrong::Refused) << false << true;
    QTest::newRow("answers lost") << int(Wrong::AnswersLost) << true << false;
    QTest::newRow("link broken") << int(Wrong::LinkBroken) << true << false;
}

void TestAftermath::failedActionTellsWhatDiffers()
{
    QFETCH(int, wrong);
    QFETCH(bool, isChanged);
    QFETCH(bool, isKnown);
    Bench bench;
    Meddler meddler(bench.board.channel, u"USE_DEFAULTS"_s, Wrong(wrong));
    const auto done
        = performSafely(meddler, bench.board.device, u"defaults"_s, {{u"what"_s, 1}}, bench.history);
    QVERIFY(!done);
    Error error = done.error();
    QVERIFY(error.after);
    QVERIFY(QFile::exists(error.after->snapshotPath));
    QCOMPARE(error.after->now.has_value(), isKnown);
    QString text = describe(error).oneLine();
    QVERIFY2(text.contains(error.after->snapshotPath), qPrintable(text));
    QVERIFY2(!text.contains(u"Nothing was changed"_s), qPrintable(text));
    if (!isKnown) {
        QVERIFY2(text.contains(u"What the board holds now could not be read"_s), qPrintable(text));
        error = settled(error, *bench.board.device.readConfiguration(bench.board.channel));
        text = describe(error).oneLine();
    }
    QCOMPARE(!error.after->changes().empty(), isChanged);
    QCOMPARE(text.contains(u"it holds the old values"_s), !isChanged);
    QCOMPARE(text.contains(u"pid.roll.p 45 -> 35"_s), isChanged);
}

void TestAftermath::restartDuringAnActionIsNamed_data()
{
    QTest::addColumn<bool>("ranBefore");
    QTest::addColumn<bool>("runAfter");
    QTest::newRow("started by themselves") << false << true;
    QTest::newRow("off all the time") << false << false;
    QTest::newRow("on all the time") << true << true;
}

// It stays without an answer, and motors that were off run.
void TestAftermath::restartDuringAnActionIsNamed()
{
    QFETCH(bool, ranBefore);
    QFETCH(bool, runAfter);
    Bench bench;
    Faults lying;
    lying.pose = 1;  // the sensor does not move, whether the motors hold it or not
    bench.board.board().setFaults(lying);
    auto &stabilizer = bench.board.board().stabilizer();
    stabilizer.setMotorsOn(ranBefore);
    SilentAt silent(bench.board.channel, u"CALIB_GYRO"_s, [&] { stabilizer.setMotorsOn(runAfter); });
    const auto done = performSafely(silent, bench.board.device, u"calibrate.gyro"_s, {}, bench.history);
    QVERIFY(!done);
    QCOMPARE(done.error().code, runAfter && !ranBefore ? ErrorCode::Restarted : ErrorCode::Timeout);
    QVERIFY(done.error().after);
    if (done.error().code == ErrorCode::Restarted)
        QVERIFY(describe(done.error()).oneLine().contains(u"motors may run again"_s));
}

// A board that stores everything in use at once uses the new value already, and has not stored it.
void TestAftermath::linkLostBeforeStoringIsUnknown()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const auto base = rig.device.readConfiguration(rig.channel);
    QVERIFY(base);
    Configuration edited = *base;
    const ParameterSpec *gain = base->parameters().find(u"pid.pitch.p"_s);
    QVERIFY(gain && edited.setRaw(*gain, 0, *base->raw(*gain, 0) + 5));
    const QTemporaryDir dir;
    const BoardHistory history(dir.path());
    WriteOptions options;
    options.history = &history;
    Meddler meddler(rig.channel, u"xs"_s, Wrong::LinkBrokenBefore);
    const auto report = writeConfiguration(meddler, rig.device, *base, edited, options);
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->lines.front().state, WriteState::Unknown);
    QVERIFY(rig.board().stored(gain->offset / 2) == int(*base->raw(*gain, 0)));

    const auto both = rig.device.wholeMemory()->readBoth(rig.channel);
    QVERIFY(both);
    WriteReport later = *report;
    later.learn(both->stored);
    QCOMPARE(later.lines.front().state, WriteState::NotWritten);
    QVERIFY(both->inUse.raw(*gain, 0) != base->raw(*gain, 0));
}

QTEST_GUILESS_MAIN(TestAftermath)
#include "tst_aftermath.moc"
