// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bannerarea.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/windowplace.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/boardnamedialog.h"
#include "app/pages/board/sharedialog.h"
#include "app/pages/setup/scriptspage.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/panel.h"
#include "widgets/views/scripteditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QWheelEvent>

using namespace Qt::StringLiterals;

/// What the hand does by mistake acts on nothing, and what is shown is what the board holds.
class TestGuards : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void theWheelSwitchesNoProfile();
    void theProfileInUseIsShownWhileItIsAsked();
    void aSwitchLosesNoValueUnasked();
    void actionsThatLoadAskToo();
    void aClickForAGoneBannerReachesNothing();
    void windowsAreKeptOnTheScreen_data();
    void windowsAreKeptOnTheScreen();
    void theNameIsTypedAtOnce();
    void backupsCompareWithTheBoard();
    void editsInPicturesAndFilesAreMarked();
    void discardedScriptsComeBack();

private:
    [[nodiscard]] Workspace &workspace() { return m_rig->workspace(); }
    [[nodiscard]] QComboBox *profiles() { return named<QComboBox>(&m_rig->window(), u"Active profile"_s); }
    [[nodiscard]] int active() { return std::as_const(m_rig->model()).board().activeProfile(); }

    std::unique_ptr<WindowRig> m_rig;
};

void TestGuards::theWheelSwitchesNoProfile()
{
    QVERIFY(m_rig->open());
    workspace().setMotors(false);  // with them it would be asked
    QTRY_VERIFY(workspace().motorsRunning() == false);
    QVERIFY(profiles() && profiles()->isVisible());
    QCOMPARE(active(), 0);
    const QPoint at = profiles()->rect().center();
    QWheelEvent notch(at, profiles()->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(profiles(), &notch);
    QCOMPARE(profiles()->currentIndex(), 0);
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(active(), 0);
    QVERIFY(profiles()->focusPolicy() != Qt::WheelFocus);
}

void TestGuards::theProfileInUseIsShownWhileItIsAsked()
{
    QVERIFY(m_rig->open());
    workspace().setMotors(true);
    QTRY_VERIFY(workspace().motorsRunning() == true);
    profiles()->setCurrentIndex(1);
    emit profiles()->activated(1);
    QVERIFY(m_rig->window().panels()->isOpen());
    QCOMPARE(profiles()->currentIndex(), 0);
    m_rig->window().panels()->newest()->reject();
    QCOMPARE(profiles()->currentIndex(), 0);
    QCOMPARE(active(), 0);
}

void TestGuards::aSwitchLosesNoValueUnasked()
{
    QVERIFY(m_rig->open());
    workspace().setMotors(false);
    QTRY_VERIFY(workspace().motorsRunning() == false);
    const int p = m_rig->spec(u"pid.roll.p"_s).id;
    QTRY_VERIFY(workspace().live().value(p));
    workspace().live().setValue(p, 62);
    QTRY_VERIFY(workspace().live().isSettled() && workspace().live().changeCount() == 1);
    const auto choose = [this](int profile) {
        // Where nothing tells that they are off, it is asked as well.
        [this] { QTRY_VERIFY(workspace().motorsRunning() == false); }();
        profiles()->setCurrentIndex(profile);
        emit profiles()->activated(profile);
        return m_rig->window().panels()->isOpen();
    };
    const auto press = [this](const QString &text) {
        auto *button = named<QPushButton>(m_rig->window().panels()->newest(), text);
        return button && (QTest::mouseClick(button, Qt::LeftButton), true);
    };
    QVERIFY(choose(1));
    const auto *box = qobject_cast<QMessageBox *>(m_rig->window().panels()->newest());
    QVERIFY(box && box->text().contains(u"not stored"_s) && box->text().contains(u"62"_s));
    m_rig->window().panels()->newest()->reject();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(active(), 0);
    QCOMPARE(workspace().live().changeCount(), 1);
    QVERIFY(choose(1));
    QVERIFY(press(u"Store, then go on"_s));
    QTRY_COMPARE(active(), 1);
    // It was stored, so nothing is lost on the way back, and nothing is asked.
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!choose(0));
    QTRY_COMPARE(active(), 0);
    QTRY_VERIFY(workspace().live().value(p) && *workspace().live().value(p) == 62);
    workspace().live().setValue(p, 63);
    QTRY_VERIFY(workspace().live().isSettled() && workspace().live().changeCount() == 1);
    QVERIFY(choose(1));
    QVERIFY(press(u"Switch profile without storing"_s));
    QTRY_COMPARE(active(), 1);
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!choose(0));
    QTRY_COMPARE(active(), 0);
    QTRY_VERIFY(workspace().live().value(p) && *workspace().live().value(p) == 62);
}

void TestGuards::actionsThatLoadAskToo()
{
    QVERIFY(m_rig->open());
    workspace().setMotors(true);
    QTRY_VERIFY(workspace().motorsRunning() == true);
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"profile.select"_s));
    page->form()->setText(u"profile"_s, u"2"_s);
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QVERIFY(m_rig->window().panels()->isOpen());
    m_rig->window().panels()->newest()->reject();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(active(), 0);
}

void TestGuards::aClickForAGoneBannerReachesNothing()
{
    QVERIFY(m_rig->open());
    MessageBar *bar = m_rig->window().messageBar();
    workspace().notifications().report(ErrorText{u"Something"_s, {}, {}, {}}, Concern::Recording);
    QVERIFY(bar->isVisible() && m_rig->isSettled());
    auto *area = m_rig->window().findChild<BannerArea *>();
    const auto *pages = area->findChild<QStackedWidget *>();
    const QPoint at = bar->mapTo(area, bar->rect().center());
    workspace().notifications().settle(Concern::Recording);
    QVERIFY(!bar->isVisible());
    const auto reachesPage = [&] {
        const QWidget *hit = area->childAt(at);
        return hit == pages || pages->isAncestorOf(hit);
    };
    QVERIFY(!reachesPage());
    QTRY_VERIFY(reachesPage());
}

void TestGuards::windowsAreKeptOnTheScreen_data()
{
    QTest::addColumn<QRect>("frame");
    QTest::addColumn<QRect>("kept");
    QTest::newRow("too large") << QRect(100, 50, 1264, 760) << QRect(0, 0, 1024, 640);
    QTest::newRow("off to the right") << QRect(900, 10, 600, 400) << QRect(424, 10, 600, 400);
    QTest::newRow("above") << QRect(10, -30, 600, 400) << QRect(10, 0, 600, 400);
    QTest::newRow("fits") << QRect(10, 20, 600, 400) << QRect(10, 20, 600, 400);
}

void TestGuards::windowsAreKeptOnTheScreen()
{
    QFETCH(const QRect, frame);
    QFETCH(const QRect, kept);
    QCOMPARE(keptOnScreen(frame, QRect(0, 0, 1024, 640)), kept);
}

void TestGuards::theNameIsTypedAtOnce()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    auto *dialog = new BoardNameDialog(workspace(), &m_rig->window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    openPanel(*dialog);
    auto *name = dialog->findChild<QLineEdit *>();
    QVERIFY(name && name->hasFocus());
    const QString own = m_rig->client().identity().extra.value(u"name"_s).toString();
    QCOMPARE(name->text(), own);
    const auto warned = [dialog] {
        for (const QLabel *label : dialog->findChildren<QLabel *>()) {
            if (label->isVisible() && label->text().contains(u"left the factory"_s))
                return true;
        }
        return false;
    };
    QVERIFY(warned());
    QTest::keyClicks(name, u"rig A"_s);
    QCOMPARE(name->text(), u"rig A"_s);  // it replaces the suggestion
    QVERIFY(!warned());
    dialog->reject();
}

void TestGuards::backupsCompareWithTheBoard()
{
    QVERIFY(m_rig->open());
    workspace().takeSnapshot();
    auto *page = m_rig->page<BackupsPage>();
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    workspace().write(m_rig->model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QTRY_VERIFY(page->table()->rowCount() > 0);
    page->table()->selectRow(page->table()->rowCount() - 1);
    const auto *differences = named<QTableWidget>(page, u"Differences between the snapshot and now"_s);
    QVERIFY(differences);
    QCOMPARE(differences->rowCount(), 1);
    auto *restore = named<QPushButton>(page, u"Restore as edits"_s);
    restore->click();
    QCOMPARE(m_rig->model().changeCount(), 1);
    QCOMPARE(differences->rowCount(), 1);  // the board holds what it held
    QVERIFY(!restore->isEnabled());
    workspace().edits().undo();
    QVERIFY(restore->isEnabled());
}

void TestGuards::editsInPicturesAndFilesAreMarked()
{
    QVERIFY(m_rig->open());
    const QString path = m_rig->filePath(u"mine.json"_s);
    QVERIFY(workspace().saveFile(path));
    QVERIFY(!workspace().loadFile(path)->reason.contains(u"unwritten"_s));
    const QImage plain = ShareDialog(workspace()).image();
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    QVERIFY(workspace().saveFile(path));
    QVERIFY(workspace().loadFile(path)->reason.contains(u"1 unwritten"_s));
    QVERIFY(m_rig->window().messageBar()->text().contains(u"not what the board holds"_s));
    ShareDialog dialog(workspace());
    const QImage edited = dialog.image();
    dialog.findChild<QCheckBox *>()->setChecked(false);
    QVERIFY(dialog.image() != edited);
    // The words that mark it stand in the second line, where nothing else has changed.
    const QRect line(0, 60, edited.width(), 60);
    QVERIFY(edited.copy(line) != dialog.image().copy(line));
}

void TestGuards::discardedScriptsComeBack()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    auto *page = m_rig->page<ScriptsPage>();
    const auto says = [page](const QString &text) {
        for (const QLabel *label : page->findChildren<QLabel *>()) {
            if (label->text().contains(text))
                return true;
        }
        return false;
    };
    QTRY_VERIFY(page->editor()->isEnabled() && says(u"bytes used"_s));
    page->editor()->setText(u"nonsense\n"_s);
    QTRY_VERIFY2(page->message().contains(u"nonsense"_s), qPrintable(page->message()));
    QVERIFY(!says(u"bytes used"_s));
    QVERIFY(!page->editor()->annotation(0).isEmpty());
    page->editor()->setText(u"WAIT 5\n"_s);
    QVERIFY(page->editor()->annotation(0).isEmpty());
    QVERIFY(!page->message().contains(u"nonsense"_s));
    QTRY_VERIFY(says(u"bytes used"_s));
    page->revertButton()->click();
    QVERIFY(page->editor()->text().isEmpty());
    QTRY_VERIFY(page->editor()->hasFocus());
    QTest::keyClick(page->editor(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(page->editor()->text(), u"WAIT 5\n"_s);
    QVERIFY(page->hasChanges());
}

QTEST_MAIN(TestGuards)
#include "tst_guards.moc"
