// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"

#include <QJsonArray>
#include <QSignalSpy>

using namespace Qt::StringLiterals;

/// What belongs to one board is neither done to nor offered for another one that answers in its place.
class TestOtherBoard : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<WindowRig>();
        listen();
    }
    void cleanup() { m_rig.reset(); }
    void anInterruptedWriteStaysWithItsBoard();
    void lostMemoryIsTold();
    void aBoardThatLooksTheSameIsAsked();
    void writtenStepsAreNoLeftover();
    void newEditsTellOfTheOffer();
    void anUnansweredOfferComesAgain();

private:
    [[nodiscard]] Workspace &workspace() { return m_rig->workspace(); }
    [[nodiscard]] ConfigurationModel &model() { return m_rig->model(); }
    [[nodiscard]] QString told() { return m_told.join(u'\n'); }
    void listen()
    {
        m_told.clear();
        m_questions.clear();
        connect(&workspace().notifications(), &Notifications::notice, this,
                [this](const QString &text) { m_told.append(text); });
        connect(&workspace().notifications(), &Notifications::offer, this,
                [this](const Offer &offer) { m_questions.append(offer); });
    }
    [[nodiscard]] std::optional<Offer> open(Topic topic)
    {
        for (const Offer &offer : m_rig->window().offerBar()->open()) {
            if (offer.topic == topic)
                return offer;
        }
        return {};
    }
    std::unique_ptr<SimProcess> plugIn(const QStringList &more = {}, const QString &family = u"simplebgc"_s)
    {
        return std::make_unique<SimProcess>(QStringList{u"--pty"_s, m_rig->filePath(u"gimbal"_s)} + more,
                                            family);
    }
    bool connectSerial(const QString &family)
    {
        return m_rig->open(u"serial:%1?family=%2"_s.arg(m_rig->filePath(u"gimbal"_s), family));
    }
    bool write()
    {
        QSignalSpy finished(&workspace(), &Workspace::writeFinished);
        workspace().write(model().edited());
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kPatience);
    }
    bool leaveSomething()
    {
        if (!m_rig->open())
            return false;
        m_rig->edit(u"pid.roll.p"_s, 0, 44);
        workspace().journal().flush();
        m_rig->crash();
        m_rig->restart();
        listen();
        return m_rig->open() && QTest::qWaitFor([this] { return open(Topic::Leftover).has_value(); });
    }

    std::unique_ptr<WindowRig> m_rig;
    QStringList m_told;
    QList<Offer> m_questions;
};

void TestOtherBoard::anInterruptedWriteStaysWithItsBoard()
{
    auto first = plugIn({u"--fault"_s, u"reset-on-write=1"_s});
    QVERIFY(connectSerial(u"simplebgc"_s));
    const QString serial = std::as_const(model()).board().identity().serial;
    m_rig->edit(u"pid.roll.p"_s, 0, 81);
    m_rig->edit(u"pid.roll.p"_s, 1, 82);
    QVERIFY(write());
    QTRY_VERIFY(open(Topic::Write).has_value());
    const Offer finish = *open(Topic::Write);
    const int edits = model().changeCount();
    QVERIFY(edits > 0);
    first.reset();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_told.clear();
    const auto second = plugIn({u"--seed"_s, u"7"_s});
    QTRY_VERIFY(std::as_const(model()).board().identity().serial != serial);
    QVERIFY(!open(Topic::Write));
    QVERIFY2(told().contains(u"Another board answers"_s), qPrintable(told()));
    QVERIFY2(told().contains(u"interrupted write belongs to the board before"_s), qPrintable(told()));
    QVERIFY2(told().contains(u"%1 unwritten change(s) belong to the board before"_s.arg(edits)),
             qPrintable(told()));
    QVERIFY2(!told().contains(u"Connected again"_s), qPrintable(told()));
    QCOMPARE(model().changeCount(), 0);
    // Its answer, pressed before it went, writes nothing.
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    finish.choices.first().chosen();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!workspace().isWriting());
    QCOMPARE(finished.count(), 0);
    QVERIFY(workspace().history().unsaved(serial).has_value());
}

void TestOtherBoard::lostMemoryIsTold()
{
    auto board = plugIn();
    QVERIFY(connectSerial(u"simplebgc"_s));
    m_rig->edit(u"pid.roll.p"_s, 0, 50);
    m_rig->edit(u"pid.roll.i"_s, 0, 51);
    QVERIFY(write());
    board.reset();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_told.clear();
    board = plugIn();  // with the values of the factory
    QTRY_VERIFY(told().contains(u"2 value(s) on the board differ from what was read before"_s));
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 35.0);
}

void TestOtherBoard::aBoardThatLooksTheSameIsAsked()
{
    auto board = plugIn({}, u"storm32"_s);
    QVERIFY(connectSerial(u"storm32"_s));
    m_rig->edit(u"pid.roll.p"_s, 0, 1234);
    QVERIFY(write());
    QVERIFY(workspace().lastReport()->isComplete());
    m_rig->edit(u"pid.yaw.p"_s, 0, 777);
    board.reset();
    QTRY_VERIFY(!m_rig->client().isConnected());
    board = plugIn({}, u"storm32"_s);
    QTRY_VERIFY(open(Topic::Board).has_value());
    QVERIFY2(open(Topic::Board)->text.contains(u"looks like the one before"_s),
             qPrintable(open(Topic::Board)->text));
    QCOMPARE(model().changeCount(), 1);
    const auto snapshots = workspace().history().snapshots(m_rig->client().identity().serial).size();
    open(Topic::Board)->choices.last().chosen();
    QCOMPARE(model().changeCount(), 0);
    QCOMPARE(workspace().history().snapshots(m_rig->client().identity().serial).size(), snapshots + 1);
    QVERIFY2(told().contains(u"are kept in"_s), qPrintable(told()));
}

void TestOtherBoard::writtenStepsAreNoLeftover()
{
    QVERIFY(m_rig->open());
    for (int profile = 0; profile < 4; ++profile)
        m_rig->edit(u"pid.roll.p"_s, profile, 60 + profile);
    const QJsonObject before = workspace().edits().toJson();
    QCOMPARE(before.value(u"done"_s).toInt(), 4);
    QVERIFY(write());
    QCOMPARE(model().changeCount(), 0);
    QCOMPARE(workspace().edits().opened(before).value(u"done"_s).toInt(), 0);
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    const QJsonObject open = workspace().edits().toJson();
    QCOMPARE(open.value(u"done"_s).toInt(), 1);
    QCOMPARE(open.value(u"steps"_s).toArray().size(), 1);
    // Set from outside since it was written: no edit of ours.
    Configuration board = std::as_const(model()).board();
    QVERIFY(board.setRaw(m_rig->spec(u"pid.roll.p"_s), 1, 12));
    model().setBoard(board);
    QCOMPARE(model().changeCount(), 1);
    QCOMPARE(workspace().edits().toJson().value(u"done"_s).toInt(), 1);
    // What was written and undone again is open, and comes back as it was.
    workspace().edits().undo();
    workspace().edits().undo();
    QCOMPARE(model().value(m_rig->spec(u"pid.roll.p"_s), 3), std::optional(35.0));
    const QJsonObject undone = workspace().edits().toJson();
    model().reset(board);
    QVERIFY(workspace().edits().restore(undone).any);
    QCOMPARE(model().value(m_rig->spec(u"pid.roll.p"_s), 3), std::optional(35.0));
    QCOMPARE(model().changeCount(), 1);
}

void TestOtherBoard::newEditsTellOfTheOffer()
{
    QVERIFY(leaveSomething());
    m_rig->edit(u"pid.roll.i"_s, 0, 33);
    workspace().journal().flush();
    QVERIFY2(told().contains(u"New edits take the place of edits of an earlier run"_s), qPrintable(told()));
    QVERIFY(!open(Topic::Leftover));
    const QStringList kept = workspace().history().snapshots(m_rig->client().identity().serial);
    QVERIFY(!kept.isEmpty());
    const auto file = workspace().loadFile(kept.first());
    QVERIFY(file);
    QCOMPARE(file->configuration.raw(*file->configuration.parameters().find(u"pid.roll.p"_s), 0),
             std::optional(44.0));
}

void TestOtherBoard::anUnansweredOfferComesAgain()
{
    QVERIFY(leaveSomething());
    for (int round = 0; round < 2; ++round) {
        m_rig->client().disconnectFromBoard();
        QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
        const QString address = round == 0 ? u"sim:simplebgc"_s : u"sim:storm32"_s;
        QSignalSpy read(&workspace(), &Workspace::boardRead);
        QVERIFY(m_rig->open(address));
        QTRY_VERIFY(read.count() > 0);
        QCOMPARE(open(Topic::Leftover).has_value(), round == 0);
    }
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open());
    QTRY_VERIFY(open(Topic::Leftover).has_value());
    open(Topic::Leftover)->choices.first().chosen();
    QCOMPARE(model().value(m_rig->spec(u"pid.roll.p"_s), 0), std::optional(44.0));
}

QTEST_MAIN(TestOtherBoard)
#include "tst_otherboard.moc"
