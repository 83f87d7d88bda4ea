// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "protocol/simulator/link/tcphost.h"
#include "protocol/simulator/simplebgc/board.h"
#include "protocol/simulator/storm32/board.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/reviewdialog.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QUndoStack>

using namespace Qt::StringLiterals;

/// After every kind of operation the screen says of the board what the board holds: what is in use, what is
/// stored, and whether the two differ. Both memories are read past all models and past the link.
class TestAgreement : public QObject
{
    Q_OBJECT
private slots:
    void cleanup();
    void storm_data();
    void storm();
    void stormReviewOffersEveryWay_data();
    void stormReviewOffersEveryWay();
    void simplebgc_data();
    void simplebgc();

private:
    /// Screen and board agree at first and after each operation of the row.
    void agreeAfterEach();
    bool openStorm();
    bool openSimplebgc();
    bool open(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options);
    storm32::SimulatedBoard &storm32Board()
    {
        return static_cast<storm32::SimulatedBoard &>(m_host->port().board());
    }
    simplebgc::SimulatedBoard &simplebgcBoard()
    {
        return static_cast<simplebgc::SimulatedBoard &>(m_host->port().board());
    }
    // The first thing that the screen says otherwise than the board; empty if it agrees in all.
    QString stormDisagreement();
    QString simplebgcDisagreement();
    QString disagreement() { return m_isStorm ? stormDisagreement() : simplebgcDisagreement(); }
    void perform(const QString &operation);

    LiveModel &live() { return m_rig->workspace().live(); }
    bool setLive(const QString &key, double raw)
    {
        live().setValue(m_rig->spec(key).id, raw);
        return QTest::qWaitFor([this] { return live().isSettled(); }, 5000);
    }
    bool write(OtherValues others = OtherValues::Keep)
    {
        QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
        m_rig->window().review();
        ReviewDialog *review = m_rig->window().reviewDialog();
        if (!review)
            return false;
        review->othersChoice()->setCurrentIndex(review->othersChoice()->findData(int(others)));
        review->accept();
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, 20000)
            && m_rig->workspace().lastReport()->isComplete();
    }
    bool act(const QString &key, const QVariantMap &arguments = {})
    {
        const auto done = std::make_shared<std::optional<bool>>();
        m_rig->workspace()
            .perform(key, arguments)
            .then(&m_rig->window(),
                  [done](const Result<ActionOutcome> &outcome) { *done = outcome.has_value(); });
        return QTest::qWaitFor([done] { return done->has_value(); }, 15000) && **done;
    }
    bool reconnect()
    {
        m_rig->client().disconnectFromBoard();
        if (!QTest::qWaitFor([this] { return !m_rig->client().isConnected(); }, 5000))
            return false;
        m_rig->window().openLink(m_host->address());
        return QTest::qWaitFor([this] { return m_rig->client().isConnected(); }, 15000);
    }

    std::unique_ptr<TcpHost> m_host;
    std::unique_ptr<WindowRig> m_rig;
    bool m_isStorm = false;
};

void TestAgreement::cleanup()
{
    m_rig.reset();
    m_host.reset();
}

bool TestAgreement::open(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options)
{
    m_host = std::make_unique<TcpHost>(
        std::make_unique<SimulatedPort>(std::move(board), options, std::nullopt), 0);
    if (!m_host->start())
        return false;
    m_rig = std::make_unique<WindowRig>();
    return m_rig->open(m_host->address());
}

bool TestAgreement::openStorm()
{
    m_isStorm = true;
    SimulatorOptions options;
    options.firmware = 96;
    return open(std::make_unique<storm32::SimulatedBoard>(options), options);
}

bool TestAgreement::openSimplebgc()
{
    m_isStorm = false;
    SimulatorOptions options;
    return open(std::make_unique<simplebgc::SimulatedBoard>(options), options);
}

QString TestAgreement::stormDisagreement()
{
    const Configuration &board = std::as_const(m_rig->model()).board();
    int differs = 0;
    for (const ParameterSpec &spec : board.parameters().all()) {
        const int word = spec.offset / 2;
        const auto raw
            = [&spec](int bits) { return spec.row->wire == WireType::I16 ? std::int16_t(bits) : bits; };
        const double inUse = raw(storm32Board().inUse(word));
        const double stored = raw(storm32Board().stored(word));
        differs += inUse != stored;
        if (board.raw(spec, 0) != stored)
            return u"%1: stored %2, said to be %3"_s.arg(spec.key).arg(stored).arg(
                board.raw(spec, 0).value_or(-1));
        if (live().value(spec.id) != inUse)
            return u"%1: %2 in use, said to be %3"_s.arg(spec.key).arg(inUse).arg(
                live().value(spec.id).value_or(-1));
    }
    const bool said = m_rig->window().findChild<UnstoredBar *>()->isVisible();
    if (said != (differs > 0) || live().changeCount() != differs)
        return u"%1 differ, said to be %2, bar %3"_s.arg(differs).arg(live().changeCount()).arg(said);
    return {};
}

QString TestAgreement::simplebgcDisagreement()
{
    const Configuration &board = std::as_const(m_rig->model()).board();
    const int active = simplebgcBoard().activeProfile();
    if (board.activeProfile() != active)
        return u"profile %1, said to be %2"_s.arg(active).arg(board.activeProfile());
    int differs = 0;
    for (const ParameterSpec &spec : board.parameters().all()) {
        if (spec.row->wire == WireType::F32 || spec.row->state)
            continue;
        for (int profile = 0; profile < board.identity().profileCount; ++profile) {
            const double stored = simplebgcBoard().stored(spec.key, profile);
            if (board.raw(spec, profile).has_value() && board.raw(spec, profile) != stored)
                return u"%1 of profile %2: stored %3, said to be %4"_s.arg(spec.key)
                    .arg(profile + 1)
                    .arg(stored)
                    .arg(*board.raw(spec, profile));
        }
        if (!live().parameters().contains(spec.id))
            continue;
        const double inUse = simplebgcBoard().inUse(spec.key);
        differs += inUse != simplebgcBoard().stored(spec.key, active);
        if (live().value(spec.id) != inUse)
            return u"%1: %2 in use, said to be %3"_s.arg(spec.key).arg(inUse).arg(
                live().value(spec.id).value_or(-1));
    }
    const bool said = m_rig->window().findChild<UnstoredBar *>()->isVisible();
    if (said != (differs > 0))
        return u"%1 differ, bar %2"_s.arg(differs).arg(said);
    return {};
}

void TestAgreement::perform(const QString &operation)
{
    if (operation == u"live"_s)
        QVERIFY(setLive(u"pid.roll.p"_s, 45));
    else if (operation == u"live other"_s)
        QVERIFY(setLive(u"pid.yaw.p"_s, 55));
    else if (operation == u"revert"_s)
        live().revert();
    else if (operation == u"edit"_s)
        m_rig->edit(u"pid.pitch.p"_s, m_rig->model().shownProfile(), 47);
    else if (operation == u"edit the same"_s)
        m_rig->edit(u"pid.roll.p"_s, m_rig->model().shownProfile(), 48);
    else if (operation == u"undo"_s)
        m_rig->workspace().edits().undoStack().undo();
    else if (operation == u"redo"_s)
        m_rig->workspace().edits().undoStack().redo();
    else if (operation == u"write"_s)
        QVERIFY(write());
    else if (operation == u"reconnect"_s)
        QVERIFY(reconnect());
    else if (operation == u"read"_s)
        m_rig->workspace().readBoard();
    else if (operation == u"save live"_s)
        m_rig->workspace().saveLive();
    else if (operation == u"slot"_s)
        live().useSlot(live().slot() == LiveModel::Slot::A ? LiveModel::Slot::B : LiveModel::Slot::A);
    else if (operation.startsWith(u"profile "_s))
        m_rig->workspace().useProfile(operation.mid(8).toInt() - 1);
    else if (operation.startsWith(u"poles"_s))
        QVERIFY(act(u"setup.poles"_s, {{u"pitch"_s, 16}, {u"roll"_s, 16}, {u"yaw"_s, 16}}));
    else if (operation == u"restore one"_s)
        QVERIFY(act(u"restore"_s, {{u"word"_s, 6}}));
    else if (operation == u"set a variable"_s)
        QVERIFY(act(u"variables.write"_s, {{u"id"_s, 0}, {u"value"_s, 33}}));
    else if (operation == u"defaults of the profile"_s)
        QVERIFY(act(u"defaults"_s, {{u"what"_s, 0}}));
    else
        QVERIFY2(act(operation), qPrintable(operation));
}

void TestAgreement::storm_data()
{
    QTest::addColumn<QStringList>("operations");
    // The one that failed first: Roll P live, then Pitch P written.
    QTest::newRow("write over a live change") << QStringList{u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("write the live value") << QStringList{u"live"_s, u"edit the same"_s, u"write"_s};
    QTest::newRow("write, then revert") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"revert"_s};
    QTest::newRow("live, store") << QStringList{u"live"_s, u"save live"_s};
    QTest::newRow("store by the action") << QStringList{u"live"_s, u"store"_s};
    QTest::newRow("retrieve") << QStringList{u"live"_s, u"poles"_s, u"retrieve"_s};
    QTest::newRow("restore one") << QStringList{u"live"_s, u"live other"_s, u"restore one"_s};
    QTest::newRow("defaults") << QStringList{u"live"_s, u"defaults"_s, u"edit"_s, u"store"_s};
    QTest::newRow("setup") << QStringList{u"poles"_s, u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("trims") << QStringList{u"trim"_s, u"start.take"_s, u"directions.take"_s};
    QTest::newRow("restart") << QStringList{u"live"_s, u"restart"_s};
    QTest::newRow("compare") << QStringList{u"live"_s, u"stored.compare"_s};
    QTest::newRow("reconnect") << QStringList{u"live"_s, u"poles"_s, u"reconnect"_s};
    QTest::newRow("read") << QStringList{u"live"_s, u"poles"_s, u"read"_s};
    QTest::newRow("undo") << QStringList{u"live"_s,  u"edit"_s, u"write"_s, u"undo"_s,
                                         u"write"_s, u"redo"_s, u"write"_s};
    QTest::newRow("slots") << QStringList{u"live"_s, u"slot"_s, u"live other"_s,
                                          u"slot"_s, u"edit"_s, u"write"_s};
}

void TestAgreement::agreeAfterEach()
{
    QFETCH(QStringList, operations);
    QTRY_COMPARE_WITH_TIMEOUT(disagreement(), QString(), 10000);
    for (const QString &operation : operations) {
        perform(operation);
        if (QTest::currentTestFailed())
            return;
        // What an operation leads to may itself ask the board again.
        for (int round = 0; round < 3; ++round)
            QVERIFY(m_rig->jobsAreDone());
        QTRY_COMPARE_WITH_TIMEOUT(operation + u' ' + disagreement(), operation + u' ', 10000);
    }
}

void TestAgreement::storm()
{
    QVERIFY(openStorm());
    agreeAfterEach();
}

void TestAgreement::stormReviewOffersEveryWay_data()
{
    QTest::addColumn<int>("others");
    QTest::addColumn<int>("inUse");
    QTest::addColumn<int>("stored");
    QTest::newRow("keep") << int(OtherValues::Keep) << 450 << 400;
    QTest::newRow("store") << int(OtherValues::Store) << 450 << 450;
    QTest::newRow("put back") << int(OtherValues::PutBack) << 400 << 400;
}

void TestAgreement::stormReviewOffersEveryWay()
{
    QFETCH(int, others);
    QFETCH(int, inUse);
    QFETCH(int, stored);
    QVERIFY(openStorm());
    QTRY_COMPARE_WITH_TIMEOUT(disagreement(), QString(), 10000);
    perform(u"edit"_s);
    m_rig->window().review();
    QVERIFY(!m_rig->window().reviewDialog()->othersChoice()->isVisible());  // nothing else is in use
    m_rig->window().reviewDialog()->reject();
    QTRY_VERIFY(!m_rig->window().reviewDialog());
    QVERIFY(setLive(u"pid.roll.p"_s, 450));
    m_rig->window().review();
    QVERIFY(m_rig->window().reviewDialog()->othersChoice()->isVisible());
    m_rig->window().reviewDialog()->reject();
    QTRY_VERIFY(!m_rig->window().reviewDialog());
    QVERIFY(write(OtherValues(others)));
    QTRY_COMPARE_WITH_TIMEOUT(disagreement(), QString(), 10000);
    QCOMPARE(storm32Board().inUse(6), inUse);
    QCOMPARE(storm32Board().stored(6), stored);
    QCOMPARE(storm32Board().stored(0), 47);
}

void TestAgreement::simplebgc_data()
{
    QTest::addColumn<QStringList>("operations");
    QTest::newRow("write over a live change") << QStringList{u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("write the live value") << QStringList{u"live"_s, u"edit the same"_s, u"write"_s};
    QTest::newRow("write, then revert") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"revert"_s};
    QTest::newRow("live, store") << QStringList{u"live"_s, u"save live"_s};
    QTest::newRow("store by the action") << QStringList{u"live"_s, u"variables.save"_s};
    QTest::newRow("profile and back")
        << QStringList{u"live"_s, u"profile 2"_s, u"live other"_s, u"profile 1"_s};
    QTest::newRow("write another profile")
        << QStringList{u"live"_s, u"profile 2"_s, u"edit"_s, u"profile 1"_s, u"live"_s, u"write"_s};
    QTest::newRow("variable by the action")
        << QStringList{u"set a variable"_s, u"live other"_s, u"edit"_s, u"write"_s};
    QTest::newRow("defaults") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"defaults of the profile"_s};
    QTest::newRow("reconnect") << QStringList{u"live"_s, u"reconnect"_s};
    QTest::newRow("read") << QStringList{u"live"_s, u"read"_s};
    QTest::newRow("undo") << QStringList{u"live"_s,  u"edit"_s, u"write"_s, u"undo"_s,
                                         u"write"_s, u"redo"_s, u"write"_s};
    QTest::newRow("slots") << QStringList{u"live"_s, u"slot"_s, u"live other"_s,
                                          u"slot"_s, u"edit"_s, u"write"_s};
}

void TestAgreement::simplebgc()
{
    QVERIFY(openSimplebgc());
    agreeAfterEach();
}

QTEST_MAIN(TestAgreement)
#include "tst_agreement.moc"
