// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/families/storm32/sensorpage.h"
#include "app/families/storm32/setuppage.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/tune/responsepage.h"
#include "app/workspace/question.h"
#include "tests/support/measure.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/keyboard.h"
#include "widgets/forms/panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QToolButton>

using namespace Qt::StringLiterals;

/// Where the keyboard is after whatever goes on by itself: where the work goes on, never on a button that
/// acts.
class TestFocus : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void connectingLeadsIntoThePage_data();
    void connectingLeadsIntoThePage();
    void numbersLeadIntoThePage_data();
    void numbersLeadIntoThePage();
    void paletteLeadsIntoThePage();
    void pageKeepsItsPlace();
    void writingLeadsBack_data();
    void writingLeadsBack();
    void measuringLeadsOn();
    void autoTuneLeadsOn();
    void calibrationLeadsOn();
    void setupLeadsOn();
    void sensorResultStoresNothing();
    void enterPressesTheButton();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    LinkBar *bar() { return window().findChild<LinkBar *>(); }
    QWidget *shown()
    {
        return window().navigation()->parentWidget()->findChild<QStackedWidget *>()->currentWidget();
    }
    static void addFamilies()
    {
        QTest::addColumn<QString>("family");
        QTest::newRow("simplebgc") << u"simplebgc"_s;
        QTest::newRow("storm32") << u"storm32"_s;
    }
    bool open(const QString &family)
    {
        return m_rig->open(u"sim:"_s + family)
            && QTest::qWaitFor([this] { return workspace().motorsRunning().has_value(); }, kPatience)
            && m_rig->jobsAreDone() && QTest::qWaitForWindowActive(&window());
    }
    /// What is wrong with where the keyboard is now that nothing moves any more; empty if nothing is.
    QString wrong()
    {
        if (!m_rig->isSettled())
            return u"nothing settles"_s;
        const QWidget *focus = QApplication::focusWidget();
        if (!focus)
            return u"nothing has the keyboard"_s;
        QString what = QLatin1String(focus->metaObject()->className()) + u' ' + focus->accessibleName();
        const auto *button = qobject_cast<const QAbstractButton *>(focus);
        if (button)
            what += u' ' + button->text();
        const QWidget *place = window().panels()->isOpen() ? window().panels()->newest() : shown();
        if (focus != place && !place->isAncestorOf(focus))
            return u"outside: "_s + what;
        const bool acts = button
            && (button->objectName() == u"primary"_s || button->objectName() == u"danger"_s
                || button->objectName() == u"motors"_s);
        return acts && !mayTakeKeyboard(*focus) ? u"it acts: "_s + what : QString();
    }

    std::unique_ptr<WindowRig> m_rig;
};

#define VERIFY_FOCUS(when)                                                                                   \
    do {                                                                                                     \
        const QString wrongFocus = wrong();                                                                  \
        QVERIFY2(wrongFocus.isEmpty(), qPrintable(QString(when) + u": "_s + wrongFocus));                    \
    } while (false)

void TestFocus::connectingLeadsIntoThePage_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("way");
    for (const char *family : {"simplebgc", "storm32"}) {
        for (const char *way : {"enter", "click", "program"})
            QTest::addRow("%s, %s", family, way) << QString::fromLatin1(family) << QString::fromLatin1(way);
    }
}

void TestFocus::connectingLeadsIntoThePage()
{
    QFETCH(QString, family);
    QFETCH(QString, way);
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    bar()->setAddress(u"sim:"_s + family);
    QLineEdit *address = bar()->addressBox()->lineEdit();
    if (way == u"enter"_s) {
        address->setFocus();
        QTest::keyClick(address, Qt::Key_Return);
    } else if (way == u"click"_s) {
        QTest::mouseClick(bar()->connectButton(), Qt::LeftButton);
    } else {
        window().openLink(u"sim:"_s + family);
    }
    QTRY_VERIFY(m_rig->client().isConnected() && !m_rig->model().isEmpty());
    QVERIFY(m_rig->jobsAreDone());
    VERIFY_FOCUS(way);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->client().isConnected() && !window().panels()->isOpen());
}

void TestFocus::numbersLeadIntoThePage_data()
{
    addFamilies();
}

void TestFocus::numbersLeadIntoThePage()
{
    QFETCH(QString, family);
    QVERIFY(open(family));
    for (int number = 1; number <= 9; ++number) {
        const QString key = window().navigation()->pageOfNumber(number);
        // From the link bar, from the navigation and from the page before.
        if (number % 3 == 1)
            bar()->connectButton()->setFocus();
        else if (number % 3 == 2)
            window().navigation()->setFocus();
        QTest::keyClick(&window(), Qt::Key(Qt::Key_0 + number), Qt::ControlModifier);
        QCOMPARE(window().navigation()->currentPage(), key);
        VERIFY_FOCUS(key);
    }
    // And from a question that nobody has answered yet.
    workspace().notifications().ask({u"Which?"_s, {{u"This"_s, [] {}}, {u"That"_s, [] {}}}});
    QVERIFY(m_rig->isSettled());
    for (int number = 1; number <= 9; ++number) {
        const QString key = window().navigation()->pageOfNumber(number);
        window().offerBar()->buttons().first()->setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key(Qt::Key_0 + number), Qt::ControlModifier);
        QCOMPARE(window().navigation()->currentPage(), key);
        VERIFY_FOCUS(key);
    }
}

void TestFocus::paletteLeadsIntoThePage()
{
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QVERIFY(open(family));
        for (const PageEntry &entry : pageTable()) {
            const QString key = QLatin1String(entry.key);
            if (!window().navigation()->isOffered(key))
                continue;
            window().navigation()->setFocus();
            window().showPalette();
            VERIFY_FOCUS(key + u", palette"_s);
            auto *list = window().commandPalette()->findChild<QListWidget *>();
            window().commandPalette()->input()->setText(u"page "_s + key);
            QVERIFY2(list->count() > 0, entry.key);
            for (int row = 0; row < list->count() && window().navigation()->currentPage() != key; ++row) {
                if (list->item(row)->text().contains(u":  "_s + pageText(entry.title) + u"   "_s))
                    list->setCurrentRow(row);
            }
            QTRY_VERIFY(!window().findChild<ClickShield *>());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            QCOMPARE(window().navigation()->currentPage(), key);
            VERIFY_FOCUS(key);
        }
        m_rig->client().disconnectFromBoard();
        QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    }
}

void TestFocus::pageKeepsItsPlace()
{
    QVERIFY(open(u"simplebgc"_s));
    QVERIFY(window().enterPage(u"parameters"_s));
    auto *field = window().page(u"parameters"_s)->findChild<QWidget *>(u"pid.roll.p"_s);
    field->setFocus();
    QVERIFY(window().enterPage(u"help"_s));
    VERIFY_FOCUS(u"help"_s);
    QVERIFY(window().enterPage(u"parameters"_s));
    QVERIFY(m_rig->isSettled());
    QVERIFY2(field == QApplication::focusWidget(), qPrintable(wrong()));
}

void TestFocus::writingLeadsBack_data()
{
    addFamilies();
}

void TestFocus::writingLeadsBack()
{
    QFETCH(QString, family);
    QVERIFY(open(family));
    QVERIFY(window().enterPage(u"parameters"_s));
    m_rig->edit(u"pid.roll.p"_s, 0, m_rig->raw(u"pid.roll.p"_s) + 1);
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    QTest::mouseClick(window().unsavedBar()->writeButton(), Qt::LeftButton);
    QVERIFY(window().reviewDialog());
    window().reviewDialog()->accept();
    QTRY_COMPARE(finished.count(), 1);
    VERIFY_FOCUS(u"written"_s);
    const auto *button = qobject_cast<const QAbstractButton *>(QApplication::focusWidget());
    QVERIFY2(!button, qPrintable(button ? button->text() : QString()));
}

void TestFocus::measuringLeadsOn()
{
    QVERIFY(open(u"simplebgc"_s));
    QTRY_VERIFY(workspace().motorsRunning() == true);
    auto *page = m_rig->page<ResponsePage>();
    named<QComboBox>(page, u"Axis"_s)->setCurrentIndex(2);
    QVERIFY(measure(*page));
    VERIFY_FOCUS(u"measured"_s);
}

void TestFocus::autoTuneLeadsOn()
{
    QVERIFY(open(u"simplebgc"_s));
    QTRY_VERIFY(workspace().motorsRunning() == true);
    auto *page = m_rig->page<AutoTunePage>();
    QTRY_VERIFY(page->startButton()->isEnabled());
    page->form()->setText(u"pitch"_s, u"off"_s);
    page->form()->setText(u"yaw"_s, u"off"_s);
    page->startButton()->setFocus();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QCOMPARE(page->state(), AutoTunePage::State::Running);
    VERIFY_FOCUS(u"running"_s);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    VERIFY_FOCUS(u"finished"_s);
}

void TestFocus::calibrationLeadsOn()
{
    QVERIFY(open(u"simplebgc"_s));
    auto *page = m_rig->page<CalibrationPage>();
    page->start(CalibrationPage::Kind::Gyroscope);
    VERIFY_FOCUS(u"place"_s);
    workspace().changeWorld(u"pose=1"_s);
    QTRY_VERIFY(page->isSatisfied() && page->continueButton()->isEnabled());
    QTest::keyClick(page->continueButton(), Qt::Key_Return);
    QCOMPARE(page->step(), CalibrationPage::Step::Measure);
    VERIFY_FOCUS(u"measure"_s);
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Result);
    VERIFY_FOCUS(u"result"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(page->step(), CalibrationPage::Step::Choose);
    VERIFY_FOCUS(u"chooser"_s);
}

// The motors start when the operator presses that button, not when he presses a key for the step before.
void TestFocus::setupLeadsOn()
{
    QVERIFY(open(u"storm32"_s));
    auto *page = m_rig->page<SetupPage>();
    using Task = SetupPage::Task;
    for (const Task task : {Task::Orientation, Task::AutoDirections, Task::AlignYaw})
        page->box(task)->setChecked(false);
    page->continueButton()->setFocus();
    QTest::keyClick(page->continueButton(), Qt::Key_Return);
    QTRY_COMPARE(page->step(), SetupPage::Step::Poles);
    VERIFY_FOCUS(u"poles"_s);
    QTest::keyClick(page->continueButton(), Qt::Key_Space);
    QTRY_COMPARE(page->step(), SetupPage::Step::AskStart);
    VERIFY_FOCUS(u"before the start"_s);
    QVERIFY(QApplication::focusWidget() != page->continueButton());
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), SetupPage::Step::AskFinish);
    VERIFY_FOCUS(u"before the end"_s);
    QVERIFY(QApplication::focusWidget() != page->continueButton());
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), SetupPage::Step::Done);
    QVERIFY(m_rig->jobsAreDone());
    VERIFY_FOCUS(u"done"_s);
    QVERIFY(QApplication::focusWidget() != page->continueButton());
}

void TestFocus::sensorResultStoresNothing()
{
    QVERIFY(open(u"storm32"_s));
    auto *page = m_rig->page<SensorPage>();
    VERIFY_FOCUS(u"chooser"_s);
    const QString path = m_rig->filePath(u"imu.cal"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("IMUNAME: Imu\nAXZERO: 1\nAYZERO: 2\nAZZERO: 3\nAXSCALE: 8190\nAYSCALE: 8191\nAZSCALE: "
               "8200\nCALIBRATIONMETHOD: 1 point\n");
    file.close();
    QVERIFY(page->loadFile(path));
    VERIFY_FOCUS(u"result"_s);
    QVERIFY(QApplication::focusWidget() != page->storeButton());
    page->storeButton()->setFocus();
    QTest::keyClick(page->storeButton(), Qt::Key_Return);
    QTRY_COMPARE(page->step(), SensorPage::Step::Choose);
    VERIFY_FOCUS(u"stored"_s);
}

void TestFocus::enterPressesTheButton()
{
    QVERIFY(open(u"simplebgc"_s));
    QVERIFY(window().enterPage(u"parameters"_s));
    m_rig->edit(u"pid.roll.p"_s, 0, m_rig->raw(u"pid.roll.p"_s) + 1);
    auto *discard = named<QPushButton>(window().unsavedBar(), u"Discard"_s);
    discard->setFocus();
    QTest::keyClick(discard, Qt::Key_Return);
    QCOMPARE(m_rig->model().changeCount(), 0);
    VERIFY_FOCUS(u"discarded"_s);
    // A tool button and the keypad as well.
    workspace().notifications().notify(u"Closed by Enter."_s, Notice::Attention);
    auto *close = named<QToolButton>(window().messageBar(), u"Close message"_s);
    close->setFocus();
    QTest::keyClick(close, Qt::Key_Enter, Qt::KeypadModifier);
    QVERIFY(!window().messageBar()->isVisible());
    VERIFY_FOCUS(u"closed"_s);
    // In a dialog its default button has the key.
    bool chosen = false;
    QDialog *asked = askInPanel(
        {u"Which?"_s, u"Text."_s, {{u"This"_s, [&chosen] { chosen = true; }}}, u"None"_s}, &window());
    QVERIFY(asked);
    QTRY_VERIFY(!window().findChild<ClickShield *>());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(!window().panels()->isOpen());
    QVERIFY(!chosen);
}

QTEST_MAIN(TestFocus)
#include "tst_focus.moc"
