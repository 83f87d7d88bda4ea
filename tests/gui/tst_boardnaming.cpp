// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/boardnamedialog.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

using namespace Qt::StringLiterals;

/// Boards without a serial number in the window: the operator is asked once.
class TestBoardNaming : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<WindowRig>();
        m_questions.clear();
        listen();
    }
    void cleanup() { m_rig.reset(); }
    void isAskedOnce();
    void renamedElsewhereIsAsked();
    void editsGoWithTheName();
    void simulatedGimbalIsNotAsked();

private:
    void listen()
    {
        connect(&m_rig->workspace().notifications(), &Notifications::offer, this,
                [this](const Offer &offer) { m_questions.append(offer); });
    }
    std::unique_ptr<SimProcess> plugIn(const QString &name)
    {
        auto board
            = std::make_unique<SimProcess>(QStringList{u"--pty"_s, m_rig->filePath(name)}, u"storm32"_s);
        m_questions.clear();
        return m_rig->open(u"serial:%1?family=storm32"_s.arg(m_rig->filePath(name))) ? std::move(board)
                                                                                     : nullptr;
    }
    bool leave()
    {
        m_rig->client().disconnectFromBoard();
        m_rig->workspace().configuration().reset({});
        return QTest::qWaitFor(
            [this] { return m_rig->client().state() == DeviceClient::State::Disconnected; });
    }
    BoardNameDialog *dialog()
    {
        if (m_questions.size() == 1)
            m_questions.first().choices.first().chosen();
        return m_rig->window().findChild<BoardNameDialog *>();
    }
    int snapshots()
    {
        return int(m_rig->workspace().history().snapshots(m_rig->client().identity().serial).size());
    }

    std::unique_ptr<WindowRig> m_rig;
    QList<Offer> m_questions;
};

void TestBoardNaming::isAskedOnce()
{
    const auto first = plugIn(u"first"_s);
    QVERIFY(first);
    QCOMPARE(m_questions.size(), 1);
    QVERIFY2(m_questions.first().text.contains(u"no serial number"_s), qPrintable(m_questions.first().text));
    BoardNameDialog *asked = dialog();
    QVERIFY(asked && !asked->isWindow());  // the motors can be switched off meanwhile
    asked->findChild<QLineEdit *>()->setText(u"Studio A"_s);
    QVERIFY(asked->findChild<QCheckBox *>()->isChecked());
    QSignalSpy taken(&m_rig->workspace(), &Workspace::snapshotTaken);
    named<QPushButton>(asked, u"Use this name"_s)->click();
    QTRY_COMPARE(taken.size(), 1);
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(m_rig->workspace().naming().name(), u"Studio A"_s);
    QCOMPARE(snapshots(), 1);
    auto *page = m_rig->page<BackupsPage>();
    QVERIFY(page);
    QCOMPARE(page->table()->rowCount(), 1);
    // The board carries the name: no question, and the same history.
    QVERIFY(leave());
    m_questions.clear();
    QVERIFY(m_rig->open(u"serial:%1?family=storm32"_s.arg(m_rig->filePath(u"first"_s))));
    QCOMPARE(m_rig->client().identity().extra.value(u"name"_s), u"Studio A"_s);
    QCOMPARE(m_questions.size(), 0);
    QCOMPARE(m_rig->workspace().naming().name(), u"Studio A"_s);
    QCOMPARE(snapshots(), 1);
    // Another one, as the first was when it came, is no other one's.
    QVERIFY(leave());
    const auto second = plugIn(u"second"_s);
    QVERIFY(second);
    QCOMPARE(m_questions.size(), 1);
    QVERIFY2(m_questions.first().text.contains(u"Studio A"_s), qPrintable(m_questions.first().text));
    QVERIFY(m_rig->workspace().naming().name().isEmpty());
    QCOMPARE(snapshots(), 0);
}

void TestBoardNaming::renamedElsewhereIsAsked()
{
    const auto board = plugIn(u"board"_s);
    QVERIFY(board);
    QVERIFY(m_rig->workspace().naming().choose(u"Studio"_s));
    m_rig->workspace().takeSnapshot();
    QCOMPARE(snapshots(), 1);
    // Another program renames it.
    const auto renamed = m_rig->client().submit<ActionReply>([](Channel &channel, Device &device) {
        return device.perform(channel, u"name"_s, {{u"name"_s, u"Elsewhere"_s}});
    });
    QTRY_VERIFY(renamed.isFinished());
    QVERIFY(leave());
    m_questions.clear();
    QVERIFY(m_rig->open(u"serial:%1?family=storm32"_s.arg(m_rig->filePath(u"board"_s))));
    QCOMPARE(m_questions.size(), 1);
    QVERIFY2(m_questions.first().text.contains(u"renamed elsewhere"_s), qPrintable(m_questions.first().text));
    QCOMPARE(snapshots(), 0);
    BoardNameDialog *asked = dialog();
    QVERIFY(asked);
    auto *known = named<QAbstractButton>(asked, u"It is “Studio”"_s);
    QVERIFY(known);
    known->click();
    asked->findChild<QCheckBox *>()->setChecked(false);
    named<QPushButton>(asked, u"It is this one"_s)->click();
    QCOMPARE(snapshots(), 1);
    QVERIFY(leave());
    m_questions.clear();
    QVERIFY(m_rig->open(u"serial:%1?family=storm32"_s.arg(m_rig->filePath(u"board"_s))));
    QCOMPARE(m_questions.size(), 0);
    QCOMPARE(snapshots(), 1);
}

// Unsaved edits belong to the board, whatever it is called meanwhile.
void TestBoardNaming::editsGoWithTheName()
{
    const auto board = plugIn(u"board"_s);
    QVERIFY(board);
    QVERIFY(m_rig->workspace().naming().choose(u"One"_s));
    QVERIFY(m_rig->workspace().naming().choose(u"Two"_s));
    m_rig->edit(u"pid.pitch.p"_s, 0, m_rig->raw(u"pid.pitch.p"_s) + 20);
    m_rig->workspace().journal().flush();
    const QString serial = m_rig->client().identity().serial;
    QVERIFY(m_rig->workspace().history().unsaved(serial));
    QVERIFY(m_rig->workspace().naming().choose(u"One"_s));
    m_rig->workspace().journal().flush();
    QVERIFY(m_rig->workspace().history().unsaved(serial));
    QCOMPARE(m_rig->model().changeCount(), 1);
    QVERIFY(m_rig->workspace().history().choose(m_rig->client().identity(), u"Two"_s));
    QVERIFY(!m_rig->workspace().history().unsaved(serial));
}

void TestBoardNaming::simulatedGimbalIsNotAsked()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QCOMPARE(m_questions.size(), 0);
}

QTEST_MAIN(TestBoardNaming)
#include "tst_boardnaming.moc"
