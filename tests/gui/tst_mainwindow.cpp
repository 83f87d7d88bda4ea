// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/tour/tour.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/latebutton.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/plot/plotview.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSet>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

double textContrast(const Theme &theme, ColorRole a, ColorRole b)
{
    return Theme::contrast(theme.color(a), theme.color(b));
}

QSet<QRgb> colorsOf(const QImage &image)
{
    QSet<QRgb> colors;
    for (int y = 0; y < image.height(); y += 3) {
        for (int x = 0; x < image.width(); x += 3)
            colors.insert(image.pixel(x, y));
    }
    return colors;
}

}  // namespace

/// The operator's job in the real window on simulated boards.
class TestMainWindow : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void startCardLeadsToTheSimulator();
    void connectByKeyboard();
    void badAddressIsExplained();
    void givingUpTakesItsMessageAway();
    void onlySuccessHasATick();
    void editReviewWriteByMouse();
    void editReviewWriteByKeyboard();
    void untickedChangesStayUnsaved();
    void undoRedoAndDiscard();
    void boardsValueIsOneClickAway();
    void clickThenTypeReplacesTheNumber();
    void profileSwitch();
    void motorsOffByMouse();
    void motorsOffByF12FromADialog();
    void searchAndFilters();
    void enterAloneWritesNoRisk();
    void tableShowsEverythingAndEdits();
    void everyGroupOpens();
    void nothingIsCutAtTheSmallestSize();
    void monitorDrawsTraces();
    void monitorPauses();
    void dashboardShowsFaults();
    void readOnlyBoardCannotBeEdited();
    void unplugKeepsEdits();
    void interruptedWriteIsFinishedAfterReconnecting();
    void conflictIsTold();
    void everyControlHasAName();
    void contrastIsEnough_data();
    void contrastIsEnough();
    void tourMakesEveryPicture_data();
    void tourMakesEveryPicture();

private:
    static void checkNames(QWidget *root);
    bool open(const QString &address = u"sim:simplebgc"_s) { return m_rig->open(address); }
    ConfigurationModel &model() { return m_rig->model(); }
    DeviceClient &client() { return m_rig->client(); }
    template <typename P> P *page() { return m_rig->page<P>(); }
    int raw(const QString &key, int profile = 0) { return m_rig->raw(key, profile); }
    QString filePath(const QString &name) { return m_rig->filePath(name); }
    void answerQuestion(const QString &answer)
    {
        for (QPushButton *button : m_window->panels()->findChildren<QPushButton *>()) {
            if (button->text().remove(u'&') == answer)
                return button->click();
        }
        QFAIL("nothing was asked");
    }
    QDoubleSpinBox *numberBox(const QString &key)
    {
        auto *parameters = page<ParametersPage>();
        std::ignore = m_rig->isSettled();  // the page gets its size, and the form its columns
        parameters->showParameter(key);
        return parameters->form()->findChild<QDoubleSpinBox *>(key);
    }

    std::unique_ptr<WindowRig> m_rig;
    MainWindow *m_window = nullptr;
};

void TestMainWindow::init()
{
    m_rig = std::make_unique<WindowRig>();
    m_window = &m_rig->window();
}

void TestMainWindow::cleanup()
{
    m_rig.reset();
}

void TestMainWindow::startCardLeadsToTheSimulator()
{
    auto *start = m_window->findChild<StartPage *>();
    QVERIFY(start->isVisible());
    const auto buttons = start->findChildren<QPushButton *>();
    QCOMPARE(buttons.size(), 3);
    QTest::mouseClick(buttons.last(), Qt::LeftButton);
    QTRY_VERIFY(client().isConnected() && !model().isEmpty());
    QVERIFY(!start->isVisible());
    QVERIFY(page<DashboardPage>()->isVisible());
}

void TestMainWindow::connectByKeyboard()
{
    QComboBox *box = m_window->findChild<LinkBar *>()->addressBox();
    box->setFocus();
    box->lineEdit()->selectAll();
    QTest::keyClicks(box->lineEdit(), u"sim:simplebgc?seed=4"_s);
    QTest::keyClick(box->lineEdit(), Qt::Key_Return);
    QTRY_VERIFY(client().isConnected());
    QTRY_VERIFY(!model().isEmpty());
    // Ctrl+2 is the second page.
    QTest::keyClick(m_window, Qt::Key_2, Qt::ControlModifier);
    QTRY_VERIFY(m_window->page(QLatin1String(pageTable()[1].key))->isVisible());
    QTest::mouseClick(m_window->findChild<LinkBar *>()->connectButton(), Qt::LeftButton);
    QTRY_COMPARE(client().state(), DeviceClient::State::Disconnected);
}

void TestMainWindow::badAddressIsExplained()
{
    m_window->openLink(u"nonsense"_s);
    QVERIFY(m_window->messageBar()->isVisible());
    QVERIFY(m_window->messageBar()->text().contains(u"nonsense"_s));
    m_window->openLink(u"serial:/dev/nonexistent"_s);
    QTRY_VERIFY(m_window->messageBar()->text().contains(u"no such port"_s));
}

// The program does not go on connecting, so the message that it does is gone.
void TestMainWindow::givingUpTakesItsMessageAway()
{
    QVERIFY(open());
    m_window->workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(client().state(), DeviceClient::State::Reconnecting);
    QVERIFY(m_window->messageBar()->isVisible());
    QVERIFY(m_window->messageBar()->text().contains(u"connects again by itself"_s));
    QTest::mouseClick(m_window->findChild<LinkBar *>()->connectButton(), Qt::LeftButton);
    QTRY_COMPARE(client().state(), DeviceClient::State::Disconnected);
    QTRY_VERIFY(!m_window->messageBar()->isVisible());
}

void TestMainWindow::onlySuccessHasATick()
{
    const auto shown = [this] { return m_window->messageBar()->findChild<QLabel *>()->text(); };
    Notifications &told = m_window->workspace().notifications();
    for (const auto &[kind, sign] :
         {std::pair(Notice::Done, u"✓"_s), {Notice::Hint, u"ℹ"_s}, {Notice::Attention, u"⚠"_s}}) {
        told.notify(u"this"_s, kind);
        QCOMPARE(shown(), sign + u" this"_s);
    }
    // A stop that was kept and never sent is no success.
    QStringList problems;
    connect(&told, &Notifications::problem, this,
            [&problems](const ErrorText &text) { problems.append(text.what); });
    m_window->openLink(u"sim:simplebgc?fault=deaf=86"_s);
    m_window->workspace().setMotors(false);
    m_window->findChild<LinkBar *>()->connectOrDisconnect();
    QTRY_VERIFY2(!problems.filter(u"No board was reached"_s).isEmpty(), qPrintable(problems.join(u"; "_s)));
}

void TestMainWindow::editReviewWriteByMouse()
{
    QVERIFY(open());
    QVERIFY(!m_window->unsavedBar()->isVisible());
    QDoubleSpinBox *box = numberBox(u"pid.roll.p"_s);
    QVERIFY(box);
    box->setValue(47);
    QTRY_VERIFY(m_window->unsavedBar()->isVisible());
    QVERIFY(box->property("changed").toBool());
    QVERIFY(page<ParametersPage>()->hasChanges());
    QTest::mouseClick(m_window->unsavedBar()->writeButton(), Qt::LeftButton);
    QTRY_VERIFY(m_window->reviewDialog());
    QCOMPARE(m_window->reviewDialog()->table()->model()->rowCount(), 1);
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    QTest::mouseClick(m_window->reviewDialog()->writeButton(), Qt::LeftButton);
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(raw(u"pid.roll.p"_s), 47);
    QVERIFY(m_window->workspace().lastReport()->isComplete());
    QCOMPARE(model().changeCount(), 0);
    QVERIFY(m_window->messageBar()->text().contains(u"read back"_s));
    // The snapshot lies in this board's history.
    QVERIFY(QFile::exists(m_window->workspace().lastReport()->snapshotPath));
    // A second write on this connection needs no second snapshot.
    box->setValue(48);
    m_window->review();
    QTRY_VERIFY(m_window->reviewDialog());
    m_window->reviewDialog()->accept();
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY(m_window->workspace().lastReport()->snapshotPath.isEmpty());
}

void TestMainWindow::editReviewWriteByKeyboard()
{
    QVERIFY(open());
    QDoubleSpinBox *box = numberBox(u"pid.pitch.d"_s);
    QTRY_VERIFY(box->hasFocus());
    box->selectAll();
    QTest::keyClicks(box, u"61"_s);
    QTest::keyClick(box, Qt::Key_Tab);
    QTRY_COMPARE(model().changeCount(), 1);
    QTest::keyClick(m_window, Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(m_window->reviewDialog());
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    QTRY_VERIFY(!m_window->findChild<ClickShield *>());
    QTest::keyClick(m_window->reviewDialog(), Qt::Key_Return);
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(raw(u"pid.pitch.d"_s), 61);
    // Undo by keyboard makes an edit back, also while a field has the focus.
    m_window->activateWindow();
    QTRY_VERIFY(m_window->isActiveWindow());
    numberBox(u"pid.pitch.d"_s)->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(model().changeCount(), 1);
}

void TestMainWindow::untickedChangesStayUnsaved()
{
    QVERIFY(open());
    numberBox(u"pid.roll.p"_s)->setValue(47);
    numberBox(u"motor.roll.power"_s)->setValue(99);
    m_window->review();
    QTRY_VERIFY(m_window->reviewDialog());
    QAbstractItemModel *changes = m_window->reviewDialog()->table()->model();
    QCOMPARE(changes->rowCount(), 2);
    QVERIFY(changes->setData(changes->index(0, 0), Qt::Unchecked, Qt::CheckStateRole));  // the risky one
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    m_window->reviewDialog()->accept();
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(raw(u"pid.roll.p"_s), 47);
    QCOMPARE(raw(u"motor.roll.power"_s), 150);
    QCOMPARE(model().changeCount(), 1);
}

void TestMainWindow::undoRedoAndDiscard()
{
    QVERIFY(open());
    numberBox(u"pid.roll.p"_s)->setValue(47);
    numberBox(u"pid.roll.d"_s)->setValue(48);
    QCOMPARE(model().changeCount(), 2);
    QTest::mouseClick(named<QPushButton>(m_window->unsavedBar(), u"Undo"_s), Qt::LeftButton);
    QCOMPARE(model().changeCount(), 1);
    QTest::mouseClick(named<QPushButton>(m_window->unsavedBar(), u"Redo"_s), Qt::LeftButton);
    QCOMPARE(model().changeCount(), 2);
    QTest::mouseClick(named<QPushButton>(m_window->unsavedBar(), u"Discard"_s), Qt::LeftButton);
    QCOMPARE(model().changeCount(), 0);
    QCOMPARE(numberBox(u"pid.roll.p"_s)->value(), 35.0);
}

void TestMainWindow::clickThenTypeReplacesTheNumber()
{
    QVERIFY(open());
    QDoubleSpinBox *box = numberBox(u"pid.roll.p"_s);
    auto *line = box->findChild<QLineEdit *>();
    QVERIFY(line);
    QTRY_COMPARE(line->selectedText(), line->text());  // pointed at by the program
    numberBox(u"pid.roll.d"_s)->setFocus();
    QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(line->width() - 4, line->height() - 1));
    QTRY_COMPARE(line->selectedText(), line->text());
    QTest::keyClicks(box, u"77"_s);
    QTest::keyClick(box, Qt::Key_Tab);
    QTRY_COMPARE(model().changeCount(), 1);
    QCOMPARE(box->value(), 77.0);
}

void TestMainWindow::boardsValueIsOneClickAway()
{
    QVERIFY(open());
    QDoubleSpinBox *box = numberBox(u"pid.roll.p"_s);
    box->setValue(47);
    auto *editor = qobject_cast<ValueEditor *>(box->parentWidget());
    QVERIFY(editor);
    auto *reset = editor->findChild<LateButton *>(u"reset"_s);
    QTRY_VERIFY(reset->isVisible());
    // Not for a click that was meant for what was there before.
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(model().changeCount(), 1);
    QTRY_VERIFY(reset->takesClicks());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(model().changeCount(), 0);
    QVERIFY(!reset->isVisible());
}

void TestMainWindow::profileSwitch()
{
    QVERIFY(open());
    QComboBox *box = named<QComboBox>(m_window->findChild<LinkBar *>(), u"Active profile"_s);
    QCOMPARE(box->count(), 5);
    QVERIFY(box->itemText(1).contains(u"Studio"_s));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    answerQuestion(u"Switch profile"_s);
    QTRY_COMPARE(model().board().activeProfile(), 1);
    QTRY_COMPARE(numberBox(u"pid.roll.p"_s)->value(), 45.0);
    // The board really changed: its telemetry says so.
    QTRY_COMPARE(m_window->workspace().latest(m_window->workspace().roles().activeProfile), 1.0);
}

void TestMainWindow::motorsOffByMouse()
{
    QVERIFY(open());
    QTRY_COMPARE(m_window->workspace().motorsRunning().value_or(false), true);
    QPushButton *motors = m_window->findChild<LinkBar *>()->findChild<QPushButton *>(u"motors"_s);
    QTRY_VERIFY(motors->property("running").toBool());
    QTest::mouseClick(motors, Qt::LeftButton);
    QTRY_COMPARE(m_window->workspace().motorsRunning().value_or(true), false);
    QTRY_VERIFY(!motors->property("running").toBool());
    QTRY_VERIFY(motors->isEnabled());  // not at once: pressed twice in a hurry they stay off
    QTest::mouseClick(motors, Qt::LeftButton);
    answerQuestion(u"Start motors"_s);
    QTRY_COMPARE(m_window->workspace().motorsRunning().value_or(false), true);
}

void TestMainWindow::motorsOffByF12FromADialog()
{
    QVERIFY(open());
    QTRY_COMPARE(m_window->workspace().motorsRunning().value_or(false), true);
    numberBox(u"pid.roll.p"_s)->setValue(47);
    m_window->review();
    QTRY_VERIFY(m_window->reviewDialog() && m_window->reviewDialog()->isVisible());
    QTest::keyClick(m_window->reviewDialog()->table(), Qt::Key_F12);
    QTRY_COMPARE(m_window->workspace().motorsRunning().value_or(true), false);
    m_window->reviewDialog()->reject();
}

void TestMainWindow::searchAndFilters()
{
    QVERIFY(open());
    auto *parameters = page<ParametersPage>();
    const auto chips = parameters->findChildren<QPushButton *>(u"chip"_s);
    QCOMPARE(chips.size(), 4);
    parameters->search()->setText(u"poles"_s);
    QTRY_COMPARE(parameters->form()->count(), 3);
    parameters->search()->setText(u"no such thing"_s);
    QCOMPARE(parameters->form()->count(), 0);
    parameters->search()->clear();
    chips[0]->setChecked(true);  // changed
    QCOMPARE(parameters->form()->count(), 0);
    const ParameterSpec *spec = model().edited().parameters().find(u"battery.alarm"_s);
    QVERIFY(m_window->workspace().edits().edit(spec->id, 0, 1100));
    chips[0]->setChecked(false);
    chips[0]->setChecked(true);
    QCOMPARE(parameters->form()->count(), 1);
    chips[0]->setChecked(false);
    chips[2]->setChecked(true);  // risk class
    QVERIFY(parameters->form()->count() > 20);
}

// One key too many is pressed easily.
void TestMainWindow::enterAloneWritesNoRisk()
{
    QVERIFY(open());
    m_rig->edit(u"motor.roll.power"_s, 0, 99);
    m_window->review();
    QTRY_VERIFY(m_window->reviewDialog());
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    QTRY_VERIFY(!m_window->findChild<ClickShield *>());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTest::keyClick(m_window->reviewDialog(), Qt::Key_Return);
    QVERIFY(m_rig->isSettled());
    QVERIFY(m_window->reviewDialog());
    QVERIFY(!m_window->workspace().isWriting());
    QCOMPARE(finished.count(), 0);
}

void TestMainWindow::tableShowsEverythingAndEdits()
{
    QVERIFY(open());
    auto *parameters = page<ParametersPage>();
    parameters->search()->setText(u"pid."_s);
    parameters->findChildren<QPushButton *>(u"chip"_s).last()->setChecked(true);
    QTRY_VERIFY(parameters->table()->isVisible());
    QAbstractItemModel *rows = parameters->table()->model();
    QVERIFY(rows->rowCount() >= 9);
    QVERIFY(rows->setData(rows->index(0, ParameterModel::ValueColumn), u"39"_s));
    QCOMPARE(model().changeCount(), 1);
}

void TestMainWindow::everyGroupOpens()
{
    QVERIFY(open(u"sim:simplebgc?firmware=2.70b4"_s));
    auto *parameters = page<ParametersPage>();
    auto *groups = parameters->findChild<QListWidget *>();
    parameters->findChild<QComboBox *>()->setCurrentIndex(2);
    QVERIFY(groups->count() > 14);
    qsizetype shown = 0;
    for (int i = 0; i < groups->count(); ++i) {
        parameters->showGroup(i);
        QVERIFY2(parameters->form()->count() > 0, qPrintable(groups->item(i)->text()));
        shown += parameters->form()->count();
    }
    QVERIFY(shown > 300);
}

void TestMainWindow::nothingIsCutAtTheSmallestSize()
{
    QVERIFY(open(u"sim:simplebgc?firmware=2.70b4"_s));
    auto *parameters = page<ParametersPage>();
    m_window->resize(m_window->minimumSize());
    QVERIFY(m_rig->isSettled());
    auto *groups = parameters->findChild<QListWidget *>();
    parameters->findChild<QComboBox *>()->setCurrentIndex(2);
    for (int i = 0; i < groups->count(); ++i) {
        parameters->showGroup(i);
        QVERIFY(m_rig->isSettled());
        for (const QWidget *editor : parameters->form()->findChildren<ValueEditor *>()) {
            const int right = editor->mapTo(m_window, QPoint(editor->width(), 0)).x();
            const QWidget *view = parameters->form()->parentWidget()->parentWidget();
            const int edge = view->mapTo(m_window, QPoint(view->width(), 0)).x();
            QVERIFY2(right <= edge,
                     qPrintable(u"%1: %2 > %3"_s.arg(groups->item(i)->text()).arg(right).arg(edge)));
        }
    }
}

void TestMainWindow::monitorDrawsTraces()
{
    QVERIFY(open());
    auto *monitor = page<MonitorPage>();
    QTRY_VERIFY(client().telemetryPlan().rate == 1250.0);
    QCOMPARE(monitor->plots().size(), 2);  // degrees, and degrees per second
    // The colours of all three axes are in the picture once samples have come.
    QTRY_VERIFY([&] {
        const QSet<QRgb> colors = colorsOf(monitor->plots().last()->grab().toImage());
        int found = 0;
        for (const Axis axis : kAxes)
            found += colors.contains(m_rig->theme().axisColor(axis).rgb());
        return found == 3;
    }());
    // Ticking another unit makes another plot; the stream is arranged anew.
    QList<int> ticked = monitor->channels().ticked();
    ticked.append(findChannel(client().device()->channels(), u"acc.x"_s));
    monitor->channels().setTicked(ticked);
    QCOMPARE(monitor->plots().size(), 3);
    QTRY_VERIFY(!std::isnan(m_window->workspace().latest(ticked.last())));
}

void TestMainWindow::monitorPauses()
{
    QVERIFY(open());
    auto *monitor = page<MonitorPage>();
    QTRY_VERIFY(client().telemetryPlan().rate == 1250.0);
    QVERIFY(m_rig->boardGoesOn(0.5));
    PlotView *plot = monitor->plots().first();
    monitor->pauseButton()->setChecked(true);
    const QImage still = plot->grab().toImage();
    QVERIFY(m_rig->boardGoesOn(0.3));
    QVERIFY(plot->grab().toImage() == still);
    monitor->pauseButton()->setChecked(false);
    QTRY_VERIFY(plot->grab().toImage() != still);
    QVERIFY(plot->usefulRate() <= 60 && plot->usefulRate() >= 10);
}

void TestMainWindow::dashboardShowsFaults()
{
    QVERIFY(open(u"sim:simplebgc?fault=no-imu=1,battery=9"_s));
    auto *dashboard = page<DashboardPage>();
    QTRY_VERIFY([&] {
        QString text;
        for (const QLabel *label : dashboard->findChildren<QLabel *>())
            text += label->text();
        return text.contains(u"No IMU"_s) && text.contains(u"Check the sensor cable"_s)
            && text.contains(u"Battery below its cut-off"_s);
    }());
}

void TestMainWindow::readOnlyBoardCannotBeEdited()
{
    QVERIFY(open(u"sim:simplebgc?fault=unknown-firmware=1"_s));
    QVERIFY(m_window->messageBar()->isVisible());
    QVERIFY(m_window->messageBar()->text().contains(u"reading only"_s));
    QDoubleSpinBox *box = numberBox(u"pid.roll.p"_s);
    QVERIFY(!box->isEnabled());
    QCOMPARE(raw(u"pid.roll.p"_s), 35);  // shown all the same
}

void TestMainWindow::unplugKeepsEdits()
{
    const QString path = filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--fault"_s, u"unplug=6"_s, u"--fault"_s, u"replug=1"_s});
    QVERIFY(open(u"serial:"_s + path));
    numberBox(u"pid.roll.p"_s)->setValue(47);
    QTRY_COMPARE(client().state(), DeviceClient::State::Reconnecting);
    QCOMPARE(model().changeCount(), 1);
    QVERIFY(!m_window->unsavedBar()->writeButton()->isEnabled());
    QSignalSpy read(&m_window->workspace(), &Workspace::boardRead);
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(model().changeCount(), 1);
    QCOMPARE(numberBox(u"pid.roll.p"_s)->value(), 47.0);
    QVERIFY(m_window->unsavedBar()->writeButton()->isEnabled());
}

void TestMainWindow::interruptedWriteIsFinishedAfterReconnecting()
{
    const QString path = filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--fault"_s, u"reset-on-write=2"_s});
    QVERIFY(open(u"serial:"_s + path));
    for (int profile = 0; profile < 4; ++profile)
        QVERIFY(m_window->workspace().edits().edit(model().edited().parameters().find(u"pid.roll.p"_s)->id,
                                                   profile, 80 + profile));
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    m_window->workspace().write(model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(!m_window->workspace().lastReport()->isComplete());
    QTRY_VERIFY(m_window->offerBar()->text().contains(u"was interrupted"_s));
    QVERIFY(m_window->offerBar()->isVisible());
    // What was not known when it broke is known now.
    const QString told = m_window->messageBar()->text();
    QVERIFY2(!told.contains(u"The write is not complete"_s), qPrintable(told));
    // What the question says is so, and the rest is still there to be written.
    int missing = 0;
    for (int profile = 0; profile < 4; ++profile)
        missing += raw(u"pid.roll.p"_s, profile) != 80 + profile;
    QVERIFY(missing > 0);
    QCOMPARE(model().changeCount(), missing);
    QVERIFY(m_window->offerBar()->text().contains(u"%1 of 4"_s.arg(missing)));
    // The first answer finishes the write.
    QTest::mouseClick(m_window->offerBar()->buttons().first(), Qt::LeftButton);
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY(m_window->workspace().lastReport()->isComplete());
    QCOMPARE(raw(u"pid.roll.p"_s, 3), 83);
}

void TestMainWindow::conflictIsTold()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    QVERIFY(open(simulator.address()));
    QCOMPARE(raw(u"pid.roll.p"_s), 35);
    numberBox(u"pid.roll.p"_s)->setValue(60);
    // Somebody else changes the value; the simulator answers when it has taken notice.
    simulator.process().write("other-client=0\n");
    std::ignore = simulator.streams();
    QVERIFY(m_rig->boardGoesOn(0.2));
    QSignalSpy finished(&m_window->workspace(), &Workspace::writeFinished);
    m_window->workspace().write(model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY2(m_window->messageBar()->text().contains(u"Somebody else"_s),
             qPrintable(m_window->messageBar()->text()));
    // It is read anew: the board's 45 shows against our 60.
    QTRY_COMPARE(raw(u"pid.roll.p"_s), 45);
    QCOMPARE(model().changeCount(), 1);
}

void TestMainWindow::everyControlHasAName()
{
    QVERIFY(open());
    for (const PageEntry &entry : pageTable()) {
        m_window->showPage(QLatin1String(entry.key));
        checkNames(m_window);
    }
}

void TestMainWindow::checkNames(QWidget *root)
{
    for (QWidget *widget : root->findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible()
            || qobject_cast<QScrollArea *>(widget) || widget->objectName().startsWith(u"qt_"_s))
            continue;
        QString name = widget->accessibleName();
        if (auto *button = qobject_cast<QAbstractButton *>(widget))
            name += button->text();
        if (auto *label = qobject_cast<QLabel *>(widget))
            name += label->text().isEmpty() ? u"(text)"_s : label->text();
        if (auto *line = qobject_cast<QLineEdit *>(widget))
            name += line->parentWidget()->accessibleName();
        QVERIFY2(!name.isEmpty(),
                 qPrintable(QString::fromLatin1(widget->metaObject()->className()) + u" in "_s
                            + QString::fromLatin1(widget->parentWidget()->metaObject()->className()) + u' '
                            + widget->objectName()));
    }
}

void TestMainWindow::contrastIsEnough_data()
{
    QTest::addColumn<int>("mode");
    QTest::newRow("light") << int(Theme::Mode::Light);
    QTest::newRow("dark") << int(Theme::Mode::Dark);
}

void TestMainWindow::contrastIsEnough()
{
    QFETCH(int, mode);
    Theme theme;
    theme.setMode(Theme::Mode(mode));
    for (const ColorRole ground : {ColorRole::Background, ColorRole::Surface, ColorRole::SurfaceRaised}) {
        for (const ColorRole text : {ColorRole::Text, ColorRole::Muted, ColorRole::Changed,
                                     ColorRole::Warning, ColorRole::Danger, ColorRole::Ok}) {
            const double ratio = textContrast(theme, text, ground);
            QVERIFY2(ratio >= 4.5,
                     qPrintable(u"role %1 on %2: %3"_s.arg(int(text)).arg(int(ground)).arg(ratio)));
        }
    }
    QVERIFY(textContrast(theme, ColorRole::AccentText, ColorRole::Accent) >= 4.5);
    QVERIFY(textContrast(theme, ColorRole::DangerText, ColorRole::Danger) >= 4.5);
    for (const Axis axis : kAxes)
        QVERIFY(Theme::contrast(theme.axisColor(axis), theme.color(ColorRole::Surface)) >= 4.5);
    for (int i = 0; i < 8; ++i)
        QVERIFY(Theme::contrast(theme.seriesColor(i), theme.color(ColorRole::Surface)) >= 4.5);
}

void TestMainWindow::tourMakesEveryPicture_data()
{
    QTest::addColumn<bool>("everything");
    QTest::addColumn<QStringList>("names");
    const QStringList pages{
        u"start"_s,   u"dashboard"_s,    u"parameters"_s, u"monitor"_s,     u"review"_s,
        u"written"_s, u"profiles"_s,     u"backups"_s,    u"calibration"_s, u"calibration-six"_s,
        u"tuning"_s,  u"variables"_s,    u"control"_s,    u"actions"_s,     u"console"_s,
        u"gamepad"_s, u"settings"_s,     u"help"_s,       u"palette"_s,     u"signals"_s,
        u"guide"_s,   u"guide-remote"_s, u"wholeboard"_s, u"scriptslots"_s};
    QTest::newRow("pages") << false << pages;
    QTest::newRow("everything") << true
                                << (pages
                                    + QStringList{u"debug"_s, u"calibration-waiting"_s,
                                                  u"calibration-measuring"_s, u"calibration-result"_s,
                                                  u"autotune-ready"_s, u"autotune-running"_s, u"autotune"_s,
                                                  u"guide-power"_s, u"offer"_s, u"quit"_s});
}

void TestMainWindow::tourMakesEveryPicture()
{
    QFETCH(bool, everything);
    QFETCH(QStringList, names);
    const QString folder = filePath(u"tour"_s);
    Tour tour(*m_window, folder, u"-light"_s, everything ? Tour::Extent::Everything : Tour::Extent::Pages,
              u"simplebgc"_s);
    QSignalSpy finished(&tour, &Tour::finished);
    tour.start();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 240000);
    QCOMPARE(finished.first().at(1).toString(), QString());
    const QStringList pictures = finished.first().at(0).toStringList();
    for (const QString &name : names) {
        const QString path = folder + u'/' + name + u"-light.png"_s;
        QVERIFY2(pictures.contains(path), qPrintable(name));
        const QImage image(path);
        QVERIFY(!image.isNull());
        QVERIFY2(colorsOf(image).size() > 8, qPrintable(name));  // not blank
    }
}

QTEST_MAIN(TestMainWindow)
#include "tst_mainwindow.moc"
