// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/watch/monitorpage.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;

}  // namespace

/// Dialogs lie over the content of the window and leave the button that switches the motors off in reach.
class TestPanels : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void motorsGoOffBeneathEachDialog_data();
    void motorsGoOffBeneathEachDialog();
    void windowsWouldBlockThem();
    void contentIsOutOfReach();
    void focusComesBack();
    void smallWindowHoldsThem();
    void closingTheWindowAsksOnceMore();
    void stopIsKeptUntilThereIsALink();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    QPushButton *motors() { return window().findChild<QPushButton *>(u"motors"_s); }
    bool motorsAre(bool running)
    {
        return QTest::qWaitFor([&] { return workspace().motorsRunning() == running; }, 15000);
    }
    /// A click as the window system sends it: a window that is blocked gets none.
    void click(QWidget *widget)
    {
        QTest::mouseClick(window().windowHandle(), Qt::LeftButton, {},
                          widget->mapTo(&window(), widget->rect().center()));
    }
    /// Opens that dialog the operator's way; null if none came.
    QDialog *open(const QString &name);

    std::unique_ptr<WindowRig> m_rig;
};

QDialog *TestPanels::open(const QString &name)
{
    if (name == u"review"_s || name == u"unsaved"_s)
        m_rig->edit(u"pid.roll.p"_s, 0, 44);
    if (name == u"review"_s)
        window().review();
    else if (name == u"palette"_s)
        window().showPalette();
    else if (name == u"unsaved"_s)
        window().close();
    else if (name == u"streams"_s && window().showPage(u"monitor"_s))
        m_rig->page<MonitorPage>()->streamsButton()->click();
    else if (name == u"share"_s && window().showPage(u"backups"_s))
        m_rig->page<BackupsPage>()->findChild<QPushButton *>(u"share"_s)->click();
    if (!QTest::qWaitFor([this] { return window().panels()->isOpen(); }, 5000))
        return nullptr;
    return window().panels()->findChild<QDialog *>();
}

void TestPanels::motorsGoOffBeneathEachDialog_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"review", "palette", "unsaved", "streams", "share"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestPanels::motorsGoOffBeneathEachDialog()
{
    QFETCH(QString, name);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    const QDialog *dialog = open(name);
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY(motors()->isEnabled());
    QVERIFY(!motors()->geometry().isEmpty());
    click(motors());
    // In a hurry twice: they stay off, and the keyboard stays in the dialog.
    click(motors());
    QVERIFY(motorsAre(false));
    click(motors());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), false);
    QVERIFY(dialog->isVisible());
    QVERIFY(dialog->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTRY_VERIFY(!window().panels()->isOpen());
    QTRY_VERIFY_WITH_TIMEOUT(motors()->isEnabled(), 5000);  // to switch them on
}

// What a dialog with a window of its own would do, and that the click of these tests is one that can be
// blocked.
void TestPanels::windowsWouldBlockThem()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QDialog dialog(&window());
    dialog.open();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    click(motors());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), true);
}

void TestPanels::contentIsOutOfReach()
{
    QVERIFY(m_rig->open(kDemo));
    QDialog *dialog = open(u"review"_s);
    QVERIFY(dialog);
    const QString page = window().navigation()->currentPage();
    click(window().navigation());
    QTest::keyClick(dialog, Qt::Key_4, Qt::ControlModifier);
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(dialog, Qt::Key_K, Qt::ControlModifier);
    QCOMPARE(window().navigation()->currentPage(), page);
    QCOMPARE(workspace().configuration().changeCount(), 1);
    QVERIFY(!window().commandPalette());
    // The link as well: what is reviewed belongs to this board and this profile.
    QVERIFY(!window().findChild<LinkBar *>()->connectButton()->isEnabled());
    // Tab goes round in the dialog, with the motors button as the one thing outside.
    for (int i = 0; i < 20; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QWidget *focus = QApplication::focusWidget();
        QVERIFY(focus && (dialog->isAncestorOf(focus) || focus == motors()));
    }
    dialog->reject();
    QVERIFY(window().findChild<LinkBar *>()->connectButton()->isEnabled());
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(workspace().configuration().changeCount(), 0);
}

void TestPanels::focusComesBack()
{
    QVERIFY(m_rig->open(kDemo));
    window().showPage(u"monitor"_s);
    QWidget *button = m_rig->page<MonitorPage>()->streamsButton();
    button->setFocus();
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    const QDialog *dialog = open(u"streams"_s);
    QVERIFY(dialog);
    QVERIFY(dialog->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(QApplication::focusWidget(), button);
    // After a review, the field that was edited.
    window().showPage(u"parameters"_s);
    QWidget *field = window().page(u"parameters"_s)->findChild<QWidget *>(u"pid.roll.p"_s);
    QVERIFY(field);
    field->setFocus();
    QVERIFY(open(u"review"_s));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(QApplication::focusWidget(), field);
}

void TestPanels::smallWindowHoldsThem()
{
    QVERIFY(m_rig->open(kDemo));
    window().resize(window().minimumSize());
    const QDialog *dialog = open(u"share"_s);
    QVERIFY(dialog);
    QVERIFY(m_rig->isSettled());
    const QRect place(dialog->mapTo(window().panels(), QPoint()), dialog->size());
    QVERIFY(window().panels()->rect().contains(place));
    QCOMPARE(window().size(), window().minimumSize());
    for (const QPushButton *button : dialog->findChildren<QPushButton *>())
        QVERIFY(dialog->rect().contains(QRect(button->mapTo(dialog, QPoint()), button->size())));
}

// The window's own close button, with a dialog open: that goes, and the question comes.
void TestPanels::closingTheWindowAsksOnceMore()
{
    QVERIFY(m_rig->open(kDemo));
    const QPointer<QDialog> review = open(u"review"_s);
    QVERIFY(review);
    window().close();
    QTRY_VERIFY(!review);
    QVERIFY(window().isVisible());
    QVERIFY(window().panels()->isOpen());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(workspace().configuration().changeCount(), 1);
}

void TestPanels::stopIsKeptUntilThereIsALink()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    workspace().changeWorld(u"replug=2"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, 10000);
    QTRY_VERIFY(motors()->isEnabled());
    click(motors());
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 20000);
    QVERIFY(motorsAre(false));
}

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
