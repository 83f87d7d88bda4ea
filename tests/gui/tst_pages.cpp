// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/consolepage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/program/helppage.h"
#include "app/pages/program/settingspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/tune/variablespage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/debugpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/device/abilities.h"
#include "protocol/device/steering.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/filtertable.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/plot/plotstack.h"
#include "widgets/plot/plotview.h"
#include "widgets/plot/spanstatistics.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTextTable>
#include <QTreeWidget>

#include <cmath>

using namespace Qt::StringLiterals;

/// Every page as an operator uses it, on simulated boards.
class TestPages : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void profileRenamedCopiedAndWritten();
    void profileNameTooLongIsRefused();
    void profileSavedAndLoaded();
    void profileMadeActive();
    void switchedProfileStays();
    void damagedFileIsExplained();
    void liveSliderIsHeardAtOnceAndForgotten();
    void savedValuesStay();
    void setsAAndB();
    void revertPutsEverythingBack();
    void aFastDragEndsAtTheLastValue();
    void unplugWhileTuning();
    void figuresTellTheError();
    void adjustableVariables();
    void debugVariablesOfOddTypes();
    void actionsAreSearchableAndReply();
    void actionThatLetsGoIsAskedFor();
    void actionThatDestroysTakesASnapshot();
    void consoleShowsAndSends();
    void consoleTellsLinksApart();
    void consoleGuardsDangerousCommands();
    void consoleAsksBeforeMotorsLetGo_data();
    void consoleAsksBeforeMotorsLetGo();
    void backupComparedAndRestored();
    void monitorZoomsMovesAndExports();
    void crashLosesNoEdit();
    void leftoverCanBeThrownAway();
    void newEditsKeepAnUndecidedLeftover();
    void offlineEditingOfASnapshot();
    void brokenWriteIsUndone();
    void paletteFindsEverything();
    void escHeldStopsTheMotors();
    void escTappedDoesNot();
    void settingsAreKept();
    void helpForEveryPage();
    void anotherFamilyFillsThePages();
    void openPageFollowsAnotherFamily_data();
    void openPageFollowsAnotherFamily();
    void modesOfAnotherFamilyBeginAnew();
    void incompleteBoardIsTold();
    void helpIsSearchable();
    void helpListsThePagesOfTheBoard_data();
    void helpListsThePagesOfTheBoard();
    void helpHasRuledTables();

private:
    Workspace &workspace() { return m_rig->workspace(); }
    MainWindow &window() { return m_rig->window(); }
    /// What the board uses now, asked past all models.
    int inUse(int variable)
    {
        std::optional<double> value;
        m_rig->client()
            .submit<std::vector<AdjustableValue>>([variable](Channel &channel, Device &device) {
                return device.live()->readAdjustables(channel, {variable});
            })
            .then(this, [&value](const Result<std::vector<AdjustableValue>> &read) {
                value = read ? read->front().value : std::nan("");
            });
        if (!QTest::qWaitFor([&value] { return value.has_value(); }, kPatience) || std::isnan(*value))
            return -1;
        return int(*value);
    }
    bool write()
    {
        QSignalSpy finished(&workspace(), &Workspace::writeFinished);
        workspace().write(m_rig->model().edited());
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kPatience)
            && workspace().lastReport()->isComplete();
    }
    bool readAgain()
    {
        QSignalSpy read(&workspace(), &Workspace::boardRead);
        workspace().readBoard();
        return QTest::qWaitFor([&read] { return read.count() == 1; }, kPatience);
    }
    TuningPage *tuning()
    {
        auto *page = m_rig->page<TuningPage>();
        const int p = m_rig->spec(u"pid.roll.p"_s).id;
        if (!QTest::qWaitFor([&] { return page->live().value(p).has_value(); }, kPatience))
            return nullptr;
        return page;
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestPages::profileRenamedCopiedAndWritten()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ProfilesPage>();
    const QAbstractItemModelTester tester(page->table()->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    m_rig->edit(u"pid.roll.p"_s, 0, 61);
    // Typed into the table, as the operator does.
    page->table()->setFocus();
    page->table()->setCurrentIndex(page->table()->model()->index(1, ProfileModel::NameColumn));
    QTest::keyClick(page->table(), Qt::Key_F2);
    auto *editor = page->table()->findChild<QLineEdit *>();
    QTRY_VERIFY(editor || (editor = page->table()->findChild<QLineEdit *>()));
    editor->selectAll();
    QTest::keyClicks(editor, u"Wedding"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(m_rig->model().edited().profileName(1), u"Wedding"_s);
    QVERIFY(page->hasChanges());
    QVERIFY(isMarked(window(), u"Profiles"_s));

    page->table()->selectRow(0);
    named<QComboBox>(page, u"Profile to copy onto"_s)
        ->setCurrentIndex(named<QComboBox>(page, u"Profile to copy onto"_s)->findData(1));
    QTest::mouseClick(named<QPushButton>(page, u"Copy onto"_s), Qt::LeftButton);
    const ParameterSpec &p = m_rig->spec(u"pid.roll.p"_s);
    QCOMPARE(m_rig->model().value(p, 1), 61);
    // One step back takes the whole copy away.
    workspace().edits().undoStack().undo();
    QVERIFY(m_rig->model().value(p, 1) != 61);
    workspace().edits().undoStack().redo();
    QVERIFY(write());
    QVERIFY(readAgain());
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s, 1), 61);
    QCOMPARE(std::as_const(m_rig->model()).board().profileName(1), u"Wedding"_s);
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(!isMarked(window(), u"Profiles"_s));
}

void TestPages::profileNameTooLongIsRefused()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ProfilesPage>();
    QVERIFY(!page->table()->model()->setData(page->table()->model()->index(0, ProfileModel::NameColumn),
                                             QString(25, QChar(0xE4))));
    QVERIFY2(window().messageBar()->text().contains(u"50 bytes"_s),
             qPrintable(window().messageBar()->text()));
    QVERIFY(page->table()->model()->setData(page->table()->model()->index(0, ProfileModel::NameColumn),
                                            QString(24, QChar(0xE4))));
}

void TestPages::profileSavedAndLoaded()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ProfilesPage>();
    m_rig->edit(u"pid.yaw.p"_s, 1, 77);
    const QString path = m_rig->filePath(u"studio.json"_s);
    page->saveTo(path);
    workspace().edits().discardAll();
    QCOMPARE(m_rig->model().changeCount(), 0);
    // Profile 2 of the file into profile 3 here, by the dialog that asks which.
    page->loadInto(path, 2);
    QTRY_VERIFY(window().panels()->isOpen());
    auto *dialog = window().panels()->findChild<QDialog *>();
    dialog->findChild<QListWidget *>()->setCurrentRow(1);
    QTRY_VERIFY(!window().findChild<ClickShield *>());
    QTest::keyClick(dialog->findChild<QListWidget *>(), Qt::Key_Return);
    QTRY_COMPARE(m_rig->model().value(m_rig->spec(u"pid.yaw.p"_s), 2), 77);
    QVERIFY(m_rig->model().value(m_rig->spec(u"pid.yaw.p"_s), 1) != 77);
    workspace().edits().undoStack().undo();
    QCOMPARE(m_rig->model().changeCount(), 0);
    // Everything at once.
    QVERIFY(workspace().applyFile(path));
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.yaw.p"_s), 1), 77);
    QCOMPARE(m_rig->model().changeCount(), 1);
}

void TestPages::profileMadeActive()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ProfilesPage>();
    page->table()->selectRow(2);
    QVERIFY(QTest::qWaitFor([this] { return m_rig->workspace().motorsRunning() == true; }, kPatience));
    QTest::mouseClick(named<QPushButton>(page, u"Make active"_s), Qt::LeftButton);
    // Motors run, so it asks.
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(std::as_const(m_rig->model()).board().activeProfile(), 0);
    QTest::mouseClick(named<QPushButton>(window().panels(), u"Switch profile"_s), Qt::LeftButton);
    QTRY_COMPARE(std::as_const(m_rig->model()).board().activeProfile(), 2);
    QVERIFY(!named<QPushButton>(page, u"Make active"_s)->isEnabled());
}

// The newest sample is from before the switch for a moment.
void TestPages::switchedProfileStays()
{
    QVERIFY(m_rig->open());
    const auto reported = [this] { return workspace().latest(workspace().roles().activeProfile); };
    QTRY_COMPARE(reported(), 0.0);
    QSignalSpy active(&m_rig->model(), &ConfigurationModel::activeProfileChanged);
    workspace().useProfile(1);
    QTRY_COMPARE(active.count(), 1);
    emit m_rig->client().statisticsChanged();
    QTRY_COMPARE(reported(), 1.0);
    QVERIFY(m_rig->boardGoesOn(1));
    QCOMPARE(active.count(), 1);
    QCOMPARE(active.first().first().toInt(), 1);
}

void TestPages::damagedFileIsExplained()
{
    QVERIFY(m_rig->open());
    const QString path = m_rig->filePath(u"broken.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"gimbaldesk-conf");
    file.close();
    m_rig->page<ProfilesPage>()->loadInto(path, 0);
    QVERIFY2(window().messageBar()->text().contains(u"“broken.json”, line 1, is cut off"_s),
             qPrintable(window().messageBar()->text()));
    QVERIFY(window().messageBar()->text().contains(u"byte"_s));
    QCOMPARE(m_rig->model().changeCount(), 0);
}

void TestPages::liveSliderIsHeardAtOnceAndForgotten()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    QVERIFY(page);
    const int before = inUse(0);
    QSlider *slider = page->control(u"pid.roll.p"_s)->slider();
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    const int after = slider->value();
    QVERIFY(after > before);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(0), after);
    QVERIFY(page->hasChanges());
    QVERIFY(isMarked(window(), u"Tuning"_s));
    // With Shift by single counts.
    QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(slider->value(), after - 1);
    // Nothing of it is stored: a restart of the board forgets it.
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().perform(u"reset"_s, {{u"delay"_s, 500}});
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), before);
    QCOMPARE(inUse(0), before);
    QTRY_VERIFY(!page->hasChanges());
    QTRY_COMPARE(page->control(u"pid.roll.p"_s)->slider()->value(),
                 before);  // made anew for the board that came back
}

void TestPages::savedValuesStay()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    const ParameterSpec &i = m_rig->spec(u"pid.pitch.i"_s);
    page->live().setValue(i.id, 44);
    QTRY_VERIFY(page->live().isSettled());
    QTest::mouseClick(named<QPushButton>(page, u"Store"_s), Qt::LeftButton);
    QTRY_COMPARE(m_rig->raw(u"pid.pitch.i"_s), 44);
    QTRY_VERIFY(!page->hasChanges());
    QVERIFY(!named<QPushButton>(page, u"Store"_s)->isEnabled());
    // The way back was kept.
    QVERIFY(
        !workspace().history().snapshots(std::as_const(m_rig->model()).board().identity().serial).isEmpty());
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().perform(u"reset"_s, {{u"delay"_s, 500}});
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(m_rig->raw(u"pid.pitch.i"_s), 44);
    QCOMPARE(inUse(4), 44);
}

void TestPages::setsAAndB()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    const int first = inUse(0);
    const int p = m_rig->spec(u"pid.roll.p"_s).id;
    QTest::mouseClick(page->slotButton(LiveModel::Slot::B), Qt::LeftButton);
    page->live().setValue(p, 90);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(page->live().slotDifference(), 1);
    QTest::mouseClick(page->slotButton(LiveModel::Slot::A), Qt::LeftButton);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(0), first);
    QTest::keyClick(page, Qt::Key_F6);
    QTRY_COMPARE(page->live().slot(), LiveModel::Slot::B);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(0), 90);
    page->live().copyToOther();
    QCOMPARE(page->live().slotDifference(), 0);
}

void TestPages::revertPutsEverythingBack()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    const int p = inUse(0);
    const int power = inUse(11);
    page->live().setValue(m_rig->spec(u"pid.roll.p"_s).id, 200);
    page->live().setValue(m_rig->spec(u"motor.yaw.power"_s).id, 255);
    QCOMPARE(page->live().changeCount(), 2);
    // At once, while the changes may still be on their way.
    QTest::keyClick(page, Qt::Key_F9);
    QCOMPARE(page->live().changeCount(), 0);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(0), p);
    QCOMPARE(inUse(11), power);
}

void TestPages::aFastDragEndsAtTheLastValue()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    QSlider *slider = page->control(u"pid.yaw.d"_s)->slider();
    for (int value = 20; value <= 220; ++value)
        slider->setValue(value);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(8), 220);
}

void TestPages::unplugWhileTuning()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    page->live().setValue(m_rig->spec(u"pid.roll.p"_s).id, 55);
    QTRY_VERIFY(page->live().isSettled());
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QVERIFY(!named<QPushButton>(page, u"Store"_s)->isEnabled());
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    QTRY_COMPARE(read.count(), 1);
    // The board was not restarted: it still uses the value, and the page says that it is not stored.
    QTRY_COMPARE(page->live().value(m_rig->spec(u"pid.roll.p"_s).id), 55);
    QVERIFY(page->hasChanges());
}

void TestPages::figuresTellTheError()
{
    QVERIFY(m_rig->open());
    TuningPage *page = tuning();
    const auto texts = [page] {
        QStringList list;
        for (const QLabel *label : page->findChildren<QLabel *>())
            list.append(label->text());
        return list.join(u'\n');
    };
    QTRY_VERIFY(texts().contains(QRegularExpression(u"\\n0\\.\\d{3}°"_s)));
    QVERIFY(!page->plots().first()->curves().isEmpty());
    QVERIFY(page->plots().first()->curves().first().minus >= 0);
}

void TestPages::adjustableVariables()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    AdjustableModel &model = page->model();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    QTRY_VERIFY(model.rowCount() == 48);
    const auto shown
        = [&](int id) { return model.index(id, AdjustableModel::ValueColumn).data().toString(); };
    QTRY_COMPARE(shown(0), u"35"_s);
    QVERIFY(model.index(0, AdjustableModel::MeaningColumn).data().toString().contains(u"35"_s));
    QVERIFY(model.setData(model.index(36, AdjustableModel::ValueColumn), 150));
    QTRY_COMPARE(shown(36), u"150"_s);
    QCOMPARE(inUse(36), 150);
    // Out of range: refused with the range, and not sent.
    QVERIFY(!model.setData(model.index(36, AdjustableModel::ValueColumn), 300));
    QVERIFY(window().messageBar()->text().contains(u"0 to 255"_s));
    QCOMPARE(inUse(36), 150);
    page->table()->setFilter(u"follow speed"_s);
    QCOMPARE(page->table()->model()->rowCount(), 3);
}

void TestPages::debugVariablesOfOddTypes()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.73.4"_s));
    auto *page = m_rig->page<DebugPage>();
    DebugModel &model = page->model();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    QTRY_VERIFY(model.rowCount() > 0);
    QStringList names;
    QStringList types;
    for (int row = 0; row < model.rowCount(); ++row) {
        names.append(model.index(row, DebugModel::NameColumn).data().toString());
        types.append(model.index(row, DebugModel::TypeColumn).data().toString());
    }
    // An array is one row for each element; every integer width and floats are there.
    QVERIFY(names.contains(u"MOTOR_OUT[0]"_s) && names.contains(u"MOTOR_OUT[2]"_s));
    for (const char *type : {"u8", "i8", "u16", "i16", "u32", "i32", "f32"})
        QVERIFY2(types.contains(QLatin1String(type)), type);
    const int uptime = int(names.indexOf(u"UPTIME_MS"_s));
    const auto value
        = [&] { return model.index(uptime, DebugModel::ValueColumn).data().toString().toDouble(); };
    QTRY_VERIFY(value() > 0);
    const double before = value();
    QTRY_VERIFY(value() > before);
    // What is chosen is plotted: one, then two with a scale each.
    page->table()->selectRow(uptime);
    QTRY_COMPARE(page->plots()->plots().size(), 1);
    QCOMPARE(page->plots()->plots().first()->curves().size(), 1);
    const TrackView track = model.store()->tracks(uptime).front();
    QTRY_VERIFY(model.store()->tracks(uptime).front().end() > 3);
    QVERIFY(track.group()->channels().size() == model.rowCount());
    page->table()->selectionModel()->select(model.index(int(names.indexOf(u"MOTOR_OUT[0]"_s)), 0),
                                            QItemSelectionModel::Select | QItemSelectionModel::Rows);
    QTRY_COMPARE(page->plots()->plots().first()->curves().size(), 2);
    QCOMPARE(page->plots()->plots().first()->rightAxes(), 1);
    QTRY_VERIFY(page->plots()->plots().first()->scale(0).high() >= 1.0
                || page->plots()->plots().first()->scale(1).high() > 10.0);
    QVERIFY(model.index(uptime, DebugModel::LowColumn).data().toDouble() < value());
    model.clearBounds();
    QVERIFY(model.index(uptime, DebugModel::LowColumn).data()
            == model.index(uptime, DebugModel::ValueColumn).data());
}

void TestPages::actionsAreSearchableAndReply()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ActionsPage>();
    page->search()->setText(u"melody"_s);
    int visible = 0;
    for (int g = 0; g < page->list()->topLevelItemCount(); ++g) {
        for (int i = 0; i < page->list()->topLevelItem(g)->childCount(); ++i)
            visible += !page->list()->topLevelItem(g)->child(i)->isHidden();
    }
    QCOMPARE(visible, 1);
    page->search()->clear();
    QVERIFY(page->showAction(u"angles"_s));
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QTRY_VERIFY(page->reply()->toPlainText().contains(u"imu.roll"_s)
                || page->reply()->toPlainText().contains(u"roll"_s));
    // A wrong argument is named, and nothing is sent.
    QVERIFY(page->showAction(u"beep"_s));
    page->form()->setText(u"sound"_s, u"32768"_s);
    page->form()->setText(u"notes"_s, u"loud"_s);
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u"loud"_s), qPrintable(page->reply()->toPlainText()));
    page->form()->setText(u"notes"_s, u"988,1175"_s);
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    // Nothing answers a sound: it is sent, and "done" would be a guess. A command that is confirmed is done.
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u": sent"_s),
                 qPrintable(page->reply()->toPlainText()));
    QVERIFY(!page->reply()->toPlainText().contains(u"done"_s));
    QVERIFY(page->showAction(u"motors.on"_s));
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u": done"_s),
                 qPrintable(page->reply()->toPlainText()));
    // Every action can be chosen and has a form.
    for (const ActionSpec &action : m_rig->client().device()->actions()) {
        QVERIFY(page->showAction(QString::fromLatin1(action.key)));
        QVERIFY(page->form());
        for (const ArgumentSpec &argument : action.arguments)
            QVERIFY2(page->form()->field(QString::fromLatin1(argument.key)), argument.key);
    }
}

// The camera falls when running motors lose their current.
void TestPages::actionThatLetsGoIsAskedFor()
{
    QVERIFY(m_rig->open());
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(true));
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"reset"_s));
    const auto question = [this] {
        const auto boxes = window().panels()->findChildren<QMessageBox *>();
        return boxes.isEmpty() ? nullptr : boxes.last();
    };
    page->runButton()->click();
    QTRY_VERIFY(question() && question()->isVisible());
    QVERIFY2(question()->text().contains(u"The motors are running"_s), qPrintable(question()->text()));
    QCOMPARE(question()->buttonRole(question()->defaultButton()), QMessageBox::RejectRole);
    question()->defaultButton()->click();
    QTRY_VERIFY(!question());
    QVERIFY(m_rig->boardGoesOn(2.0));
    QCOMPARE(workspace().motorsRunning(), std::optional(true));
    page->runButton()->click();
    QTRY_VERIFY(question() && question()->isVisible());
    for (QAbstractButton *button : question()->buttons()) {
        if (button != question()->defaultButton())
            button->click();
    }
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u": sent"_s),
                 qPrintable(page->reply()->toPlainText()));
    // With the motors off nothing falls: no question.
    QTRY_VERIFY(m_rig->client().isConnected());
    m_rig->client().motorsOff();
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(false));
    QVERIFY(page->showAction(u"reset"_s));
    page->runButton()->click();
    QVERIFY(!question());
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u": sent"_s),
                 qPrintable(page->reply()->toPlainText()));
    QVERIFY(m_rig->jobsAreDone());
}

void TestPages::actionThatDestroysTakesASnapshot()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 1, 99);
    QVERIFY(write());
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    const auto before = workspace().history().snapshots(serial).size();
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"defaults"_s));
    QCOMPARE(page->runButton()->objectName(), u"danger"_s);
    page->form()->setText(u"what"_s, u"1"_s);  // profile 2
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    // Running motors let go meanwhile.
    auto *question = window().panels()->findChild<QMessageBox *>();
    QVERIFY(question);
    for (QAbstractButton *button : question->buttons()) {
        if (button != question->defaultButton())
            button->click();
    }
    QTRY_VERIFY(read.count() >= 1 && m_rig->client().isConnected() && m_rig->raw(u"pid.roll.p"_s, 1) != 99);
    QCOMPARE(workspace().history().snapshots(serial).size(), before + 1);
}

void TestPages::consoleShowsAndSends()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ConsolePage>();
    FrameLogModel &model = page->model();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    const auto names = [&model] {
        QStringList list;
        for (int row = 0; row < model.rowCount(); ++row)
            list.append(model.index(row, FrameLogModel::NameColumn).data().toString());
        return list;
    };
    QTRY_VERIFY(names().contains(u"READ_PARAMS_3"_s));
    QVERIFY(names().contains(u"BOARD_INFO"_s));
    QVERIFY(model.index(0, FrameLogModel::TimeColumn).data().toString().toDouble()
            >= 0);  // counted from the first frame
    // Live data is left out unless asked for.
    QVERIFY(!names().contains(u"REALTIME_DATA_4"_s));
    model.clear();
    page->input()->setText(u"read_params_3 01"_s);
    QTest::keyClick(page->input(), Qt::Key_Return);
    QTRY_VERIFY(names().count(u"READ_PARAMS_3"_s) >= 2);
    const auto fields
        = [&model](int row) { return model.index(row, FrameLogModel::FieldsColumn).data().toString(); };
    const int answer = int(names().lastIndexOf(u"READ_PARAMS_3"_s));
    QVERIFY2(fields(answer).contains(u"profile 2"_s) && fields(answer).contains(u"pid.roll.p"_s),
             qPrintable(fields(answer)));
    // A whole frame in hex, and one with a wrong checksum.
    page->input()->setText(u"3E 56 00 56 00"_s);
    page->send();
    QTRY_VERIFY(names().contains(u"BOARD_INFO"_s));
    page->input()->setText(u"3E 56 00 57 00"_s);
    page->send();
    QVERIFY(window().messageBar()->text().contains(u"checksum"_s));
    page->input()->setText(u"NO_SUCH_THING"_s);
    page->send();
    QVERIFY(window().messageBar()->text().contains(u"NO_SUCH_THING"_s));
    const QString path = m_rig->filePath(u"frames.txt"_s);
    QVERIFY(page->saveText(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("READ_PARAMS_3") && text.contains("3e 56 00 56 00"));
}

// It begins with the link, whenever the page is opened, and tells one link's frames from another's.
void TestPages::consoleTellsLinksApart()
{
    QVERIFY(m_rig->open());
    QVERIFY(m_rig->boardGoesOn(4.0));  // live data push the first frames out of the log
    auto *page = m_rig->page<ConsolePage>();
    const FrameLogModel &model = page->model();
    const auto cell = [&model](int row, int column) { return model.index(row, column).data().toString(); };
    const auto find = [&](const QString &name, int from) {
        for (int row = from; row < model.rowCount(); ++row) {
            if (cell(row, FrameLogModel::NameColumn).contains(name))
                return row;
        }
        return -1;
    };
    QCOMPARE(find(u"New link"_s, 0), 0);
    QCOMPARE(cell(0, FrameLogModel::FieldsColumn), u"sim:simplebgc"_s);
    QVERIFY(find(u"BOARD_INFO"_s, 0) > 0);
    QVERIFY(find(u"Connected"_s, 0) > 0);
    page->hide();  // what comes while it is not seen belongs to its link as well
    window().showPage(u"dashboard"_s);
    const auto asked = m_rig->client().submit<bool>([](Channel &channel, Device &device) -> Result<bool> {
        return device.readConfiguration(channel).has_value();
    });
    QTRY_VERIFY(asked.isFinished());
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    m_rig->page<ConsolePage>();
    const int ended = find(u"Link ended"_s, 0);
    const int second = find(u"New link"_s, 1);
    QVERIFY(ended > 0 && second > ended);
    QCOMPARE(cell(second, FrameLogModel::FieldsColumn), u"sim:storm32"_s);
    for (int row = 0; row < ended; ++row)
        QVERIFY2(cell(row, FrameLogModel::NameColumn) != u"?"_s, qPrintable(QString::number(row)));
    QVERIFY(find(u"READ_PARAMS_3"_s, 0) < ended);
    QCOMPARE(find(u"READ_PARAMS_3"_s, second), -1);
}

void TestPages::consoleGuardsDangerousCommands()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ConsolePage>();
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    page->input()->setText(u"USE_DEFAULTS 01"_s);
    page->send();
    QVERIFY(window().messageBar()->text().contains(u"not sent"_s));
    QVERIFY(workspace().history().snapshots(serial).isEmpty());
    named<QCheckBox>(page, u"Allow commands that change something"_s)->setChecked(true);
    page->input()->setText(u"SAVE_PARAMS_3"_s);
    page->send();
    QTRY_COMPARE(workspace().history().snapshots(serial).size(), 1);
}

void TestPages::consoleAsksBeforeMotorsLetGo_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("typed");
    QTest::newRow("SimpleBGC, reset") << u"sim:simplebgc"_s << u"RESET 01F401"_s;
    QTest::newRow("SimpleBGC, menu") << u"sim:simplebgc"_s << u"EXECUTE_MENU 07"_s;
    QTest::newRow("SimpleBGC, calibration that restarts")
        << u"sim:simplebgc"_s << u"CALIB_GYRO 000200000000000000000000"_s;
    QTest::newRow("STorM32, restart") << u"sim:storm32"_s << u"xx"_s;
    QTest::newRow("STorM32, reset") << u"sim:storm32"_s << u"xX"_s;
    QTest::newRow("STorM32, use all motors") << u"sim:storm32"_s << u"xW"_s;
}

void TestPages::consoleAsksBeforeMotorsLetGo()
{
    QFETCH(QString, address);
    QFETCH(QString, typed);
    QVERIFY(m_rig->open(address));
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(true));
    auto *page = m_rig->page<ConsolePage>();
    named<QCheckBox>(page, u"Allow commands that change something"_s)->setChecked(true);
    const auto question = [this] {
        const auto boxes = window().panels()->findChildren<QMessageBox *>();
        return boxes.isEmpty() ? nullptr : boxes.last();
    };
    QSignalSpy lost(&m_rig->client(), &DeviceClient::connectionLost);
    page->input()->setText(typed);
    page->send();
    QVERIFY(question() && question()->isVisible());
    QVERIFY2(question()->text().contains(u"The motors are running"_s), qPrintable(question()->text()));
    question()->defaultButton()->click();
    QTRY_VERIFY(!question());
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), std::optional(true));
    QCOMPARE(lost.count(), 0);
    // With the motors off nothing falls.
    m_rig->client().motorsOff();
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(false));
    page->send();
    QVERIFY(!question());
    QVERIFY(m_rig->jobsAreDone() || !m_rig->client().isConnected());
}

void TestPages::backupComparedAndRestored()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<BackupsPage>();
    QCOMPARE(page->table()->rowCount(), 0);
    QTest::mouseClick(page->takeButton(), Qt::LeftButton);
    QTRY_COMPARE(page->table()->rowCount(), 1);
    const double before = m_rig->raw(u"pid.roll.p"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, before + 30);
    QVERIFY(write());
    QTRY_COMPARE(page->table()->rowCount(), 2);  // the automatic one
    page->table()->selectRow(1);
    QVERIFY(named<QPushButton>(page, u"Restore as edits"_s)->isEnabled());
    QTest::mouseClick(named<QPushButton>(page, u"Restore as edits"_s), Qt::LeftButton);
    QCOMPARE(m_rig->model().changeCount(), 1);
    QVERIFY(!named<QPushButton>(page, u"Restore as edits"_s)->isEnabled());
    QVERIFY(write());
    QVERIFY(readAgain());
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), before);
}

void TestPages::monitorZoomsMovesAndExports()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    QTRY_VERIFY(m_rig->client().telemetryPlan().rate == 1250.0);
    QVERIFY(m_rig->boardGoesOn(1.5));
    PlotView *plot = page->plots().first();
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_Space);
    QVERIFY(plot->isHeld());
    QVERIFY(page->pauseButton()->isChecked());
    const double end = plot->endTime();
    const double window = page->window();
    QTest::keyClick(plot, Qt::Key_Plus);
    QVERIFY(page->window() < window);
    QTest::keyClick(plot, Qt::Key_PageUp);
    QVERIFY(plot->endTime() < end);
    // The cursor reads the same time in every plot, and the values come from the store.
    QTest::keyClick(plot, Qt::Key_Right);
    QVERIFY(plot->cursorTime().has_value());
    QCOMPARE(page->plots().last()->cursorTime(), plot->cursorTime());
    emit plot->cursorMoved(end - 0.5);
    QCOMPARE(plot->cursorTexts().size(), plot->curves().size());
    QVERIFY2(plot->cursorTexts().first().contains(u"°"_s), qPrintable(plot->cursorTexts().first()));
    QTest::keyClick(plot, Qt::Key_End);
    QVERIFY(!plot->isHeld());
    QTRY_VERIFY(plot->endTime() > end);

    const QString path = m_rig->filePath(u"samples.csv"_s);
    const auto lines = page->exportCsv(path);
    QVERIFY(lines && *lines > 500);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> rows = file.readAll().trimmed().split('\n');
    QVERIFY(rows.first().startsWith("time_s,imu.angle.roll [°]"));
    QCOMPARE(rows.size(), *lines + 1);
    double last = -1;
    for (qsizetype i = 1; i < rows.size(); ++i) {
        const double time = rows[i].split(',').first().toDouble();
        QVERIFY(time >= last);
        last = time;
    }
}

void TestPages::crashLosesNoEdit()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 0, 71);
    m_rig->edit(u"pid.yaw.d"_s, 1, 12);
    workspace().edits().rename(2, u"Night"_s);
    m_rig->edit(u"pid.roll.p"_s, 2, 5);
    workspace().edits().undoStack().undo();
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    // The journal follows the last step, which was taken back.
    const auto written = [this, &serial] {
        const auto unsaved = workspace().history().unsaved(serial).value_or(QJsonObject());
        return unsaved.value(u"steps"_s).toArray().size() == 4 && unsaved.value(u"done"_s).toInt() == 3;
    };
    QTRY_VERIFY(written());
    m_rig->crash();
    m_rig->restart();
    QVERIFY(m_rig->open());
    QTRY_VERIFY(window().offerBar()->isVisible());
    QVERIFY(window().offerBar()->text().contains(u"3"_s));
    QTest::mouseClick(window().offerBar()->buttons().first(), Qt::LeftButton);
    QCOMPARE(m_rig->model().changeCount(), 3);
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), 71);
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.yaw.d"_s), 1), 12);
    QCOMPARE(m_rig->model().edited().profileName(2), u"Night"_s);
    // Undo and redo are there as before.
    QUndoStack &stack = workspace().edits().undoStack();
    QVERIFY(stack.canRedo());
    stack.redo();
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 2), 5);
    for (int i = 0; i < 4; ++i)
        stack.undo();
    QCOMPARE(m_rig->model().changeCount(), 0);
    // Nothing unsaved, nothing kept.
    QTRY_VERIFY(!workspace().history().unsaved(serial).has_value());
}

void TestPages::leftoverCanBeThrownAway()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 0, 71);
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    QTRY_VERIFY(workspace().history().unsaved(serial).has_value());
    m_rig->crash();
    m_rig->restart();
    // The first card offers them without a board as well.
    QVERIFY(!workspace().history().unsavedBases().isEmpty());
    QVERIFY(window().findChild<StartPage *>()->findChildren<QPushButton *>().size() > 3);
    QVERIFY(m_rig->open());
    QTRY_VERIFY(window().offerBar()->isVisible());
    QTest::mouseClick(window().offerBar()->buttons().at(1), Qt::LeftButton);
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(!workspace().history().unsaved(serial).has_value());
    QVERIFY(!window().offerBar()->isVisible());
}

void TestPages::newEditsKeepAnUndecidedLeftover()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 0, 71);
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    QTRY_VERIFY(workspace().history().unsaved(serial).has_value());
    m_rig->crash();
    m_rig->restart();
    QVERIFY(m_rig->open());
    QTRY_VERIFY(window().offerBar()->isVisible());
    m_rig->edit(u"pid.pitch.p"_s, 0, 72);
    // They are a snapshot now.
    QTRY_COMPARE(workspace().history().snapshots(serial).size(), 1);
    const auto file = workspace().loadFile(workspace().history().snapshots(serial).first());
    QVERIFY(file);
    QCOMPARE(file->configuration.raw(*file->configuration.parameters().find(u"pid.roll.p"_s), 0), 71);
}

void TestPages::offlineEditingOfASnapshot()
{
    QVERIFY(m_rig->open());
    workspace().takeSnapshot();
    const QString serial = std::as_const(m_rig->model()).board().identity().serial;
    const QString path = workspace().history().snapshots(serial).first();
    QTest::mouseClick(window().findChild<LinkBar *>()->connectButton(), Qt::LeftButton);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    m_rig->restart();
    QVERIFY(window().findChild<StartPage *>()->isVisible());
    window().openFile(path);
    QCOMPARE(workspace().offlineFile(), path);
    auto *parameters = m_rig->page<ParametersPage>();
    QVERIFY(parameters->isVisible());
    parameters->showParameter(u"pid.roll.p"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, 88);
    QTRY_VERIFY(window().unsavedBar()->isVisible());
    QVERIFY(!window().unsavedBar()->writeButton()->isEnabled());
    QVERIFY(named<QPushButton>(window().unsavedBar(), u"Save to file…"_s)->isVisible());
    const QString copy = m_rig->filePath(u"edited.json"_s);
    QVERIFY(workspace().saveFile(copy));
    QCOMPARE(workspace().loadFile(copy)->configuration.raw(m_rig->spec(u"pid.roll.p"_s), 0), 88);
    // The board comes: the edits stay edits, against what the board really holds.
    QVERIFY(m_rig->open());
    QTRY_VERIFY(workspace().offlineFile().isEmpty());
    QTRY_COMPARE(m_rig->model().changeCount(), 1);
    QVERIFY(write());
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 88);
}

void TestPages::brokenWriteIsUndone()
{
    const QString path = m_rig->filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--fault"_s, u"reset-on-write=3"_s});
    QVERIFY(m_rig->open(u"serial:"_s + path));
    std::array<int, 4> old{};
    for (int profile = 0; profile < 4; ++profile) {
        old[std::size_t(profile)] = m_rig->raw(u"pid.roll.p"_s, profile);
        m_rig->edit(u"pid.roll.p"_s, profile, 80 + profile);
    }
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    workspace().write(m_rig->model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QTRY_VERIFY(window().offerBar()->isVisible());
    QCOMPARE(window().offerBar()->buttons().size(), 3);
    QTest::mouseClick(window().offerBar()->buttons().at(1), Qt::LeftButton);
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY(workspace().lastReport()->isComplete());
    QVERIFY(readAgain());
    for (int profile = 0; profile < 4; ++profile)
        QCOMPARE(m_rig->raw(u"pid.roll.p"_s, profile), old[std::size_t(profile)]);
    // What was wanted is not lost: it is unsaved again.
    QCOMPARE(m_rig->model().changeCount(), 4);
}

void TestPages::paletteFindsEverything()
{
    QVERIFY(m_rig->open());
    const auto choose = [this](const QString &words) {
        window().activateWindow();
        if (!QTest::qWaitForWindowActive(&window()))
            return QString();
        QTest::keyClick(&window(), Qt::Key_K, Qt::ControlModifier);
        if (!window().commandPalette())
            return QString();
        QTest::keyClicks(window().commandPalette()->input(), words);
        const QString first = window().commandPalette()->list()->count()
            ? window().commandPalette()->list()->item(0)->text()
            : QString();
        if (!QTest::qWaitFor([this] { return !window().findChild<ClickShield *>(); }))
            return QString();
        QTest::keyClick(window().commandPalette()->input(), Qt::Key_Return);
        return first;
    };
    QVERIFY(choose(u"console"_s).contains(u"Console"_s));
    QVERIFY(window().page(u"console"_s)->isVisible());
    QTRY_VERIFY(!window().commandPalette());
    QVERIFY(choose(u"pid.yaw.d"_s).contains(u"pid.yaw.d"_s));
    QTRY_VERIFY(window().page(u"parameters"_s)->isVisible());
    QTRY_VERIFY(!window().commandPalette());
    QVERIFY(choose(u"acc.z"_s).contains(u"acc.z"_s));
    auto *monitor = static_cast<MonitorPage *>(window().page(u"monitor"_s));
    QTRY_VERIFY(monitor->isVisible());
    QVERIFY(
        monitor->channels().ticked().contains(findChannel(m_rig->client().device()->channels(), u"acc.z"_s)));
    QTRY_VERIFY(!window().commandPalette());
    QVERIFY(choose(u"restart board"_s).contains(u"reset"_s));
    QTRY_VERIFY(window().page(u"actions"_s)->isVisible());
    QTRY_VERIFY(!window().commandPalette());
    QCOMPARE(choose(u"qwertz"_s), u"Nothing was found."_s);
    QVERIFY(window().commandPalette());  // and nothing was chosen
}

void TestPages::escHeldStopsTheMotors()
{
    QVERIFY(m_rig->open());
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(true));
    // From a dialog that Esc itself closes.
    window().showPalette();
    QTRY_VERIFY(window().commandPalette());
    QTest::keyPress(window().commandPalette(), Qt::Key_Escape);
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(false));
    QTest::keyRelease(&window(), Qt::Key_Escape);
}

void TestPages::escTappedDoesNot()
{
    QVERIFY(m_rig->open());
    QTRY_VERIFY(workspace().motorsRunning() == std::optional(true));
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    QTest::keyPress(&window(), Qt::Key_Escape);
    QTest::keyRelease(&window(), Qt::Key_Escape);
    QVERIFY(m_rig->boardGoesOn(m_rig->settings().escapeHoldMs() / 1000.0 + 0.3));
    QCOMPARE(off.count(), 0);
    QCOMPARE(workspace().motorsRunning(), std::optional(true));
}

void TestPages::settingsAreKept()
{
    m_rig->page<SettingsPage>();
    QVERIFY(window().page(u"settings"_s)->isVisible());  // needs no board
    m_rig->settings().setTheme(Settings::ThemeChoice::Dark);
    QVERIFY(m_rig->theme().isDark());
    m_rig->settings().setRetentionMinutes(3);
    m_rig->settings().setFahrenheit(true);
    m_rig->settings().setEscapeHoldMs(10);  // too short to be meant
    QCOMPARE(m_rig->settings().escapeHoldMs(), 300);
    window().resize(1111, 700);
    window().close();
    m_rig->restart();
    QCOMPARE(m_rig->settings().theme(), Settings::ThemeChoice::Dark);
    QCOMPARE(m_rig->settings().retentionMinutes(), 3);
    QCOMPARE(temperatureText(20, m_rig->settings().fahrenheit()), u"68 °F"_s);
    QCOMPARE(window().width(), 1111);
    m_rig->settings().setTheme(Settings::ThemeChoice::Light);
}

void TestPages::helpForEveryPage()
{
    QVERIFY(m_rig->open());
    int seen = 0;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        QVERIFY2(key == u"help"_s || HelpPage::allTopics().contains(key), entry.key);
        if (key == u"help"_s || !window().showPage(key))
            continue;  // not offered with this board
        ++seen;
        QTest::keyClick(&window(), Qt::Key_F1);
        auto *help = static_cast<HelpPage *>(window().page(u"help"_s));
        QTRY_VERIFY(help->isVisible());
        QCOMPARE(help->topic(), key);
        QVERIFY2(named<QTextBrowser>(help, u"Help text"_s)->toPlainText().size() > 80, entry.key);
    }
    QVERIFY(seen > 14);
}

void TestPages::helpListsThePagesOfTheBoard_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("simplebgc") << u"sim:simplebgc"_s;
    QTest::newRow("storm32") << u"sim:storm32"_s;
}

void TestPages::helpListsThePagesOfTheBoard()
{
    QFETCH(const QString, address);
    QVERIFY(m_rig->open(address));
    auto *topics = named<QListWidget>(m_rig->page<HelpPage>(), u"Topics"_s);
    const QStringList keys = HelpPage::allTopics();
    int hidden = 0;
    for (int i = 0; i < topics->count(); ++i) {
        const QString key = keys.at(i);
        const bool offered = key == u"start"_s || window().navigation()->isOffered(key);
        QVERIFY2(topics->item(i)->isHidden() == !offered, qPrintable(key));
        hidden += !offered;
    }
    QVERIFY(hidden > 0);
}

void TestPages::helpHasRuledTables()
{
    auto *help = m_rig->page<HelpPage>();
    help->showTopic(u"start"_s);
    int tables = 0;
    for (QTextFrame *frame :
         named<QTextBrowser>(help, u"Help text"_s)->document()->rootFrame()->childFrames()) {
        if (auto *table = qobject_cast<QTextTable *>(frame)) {
            ++tables;
            QVERIFY(table->format().cellPadding() >= 4 && table->format().border() > 0);
        }
    }
    QVERIFY(tables > 0);
}

void TestPages::helpIsSearchable()
{
    auto *help = m_rig->page<HelpPage>();
    help->search()->setText(u"order does not matter"_s);
    int visible = 0;
    for (int i = 0; i < named<QListWidget>(help, u"Topics"_s)->count(); ++i)
        visible += !named<QListWidget>(help, u"Topics"_s)->item(i)->isHidden();
    QCOMPARE(visible, 1);
    QCOMPARE(help->topic(), u"calibration"_s);
}

// Pages fill themselves from the tables and capabilities of whatever family answers (STorM32 has one profile,
// other groups, no targets, no streams, no calibration commands).
void TestPages::anotherFamilyFillsThePages()
{
    m_rig->window().openLink(u"sim:storm32?firmware=0.90"_s);
    QTRY_VERIFY(m_rig->client().isConnected() && !m_rig->model().isEmpty());
    QCOMPARE(m_rig->client().identity().family, u"storm32"_s);
    for (const PageEntry &entry : pageTable()) {
        if (!m_rig->window().showPage(QLatin1String(entry.key)))
            continue;  // it has no use for that one
        QTRY_VERIFY2(m_rig->window().page(QLatin1String(entry.key))->isVisible(), entry.key);
        QVERIFY2(!m_rig->window().page(QLatin1String(entry.key))->grab().isNull(), entry.key);
    }
    // Live data, motors, and a change from edit to stored.
    QTRY_VERIFY(m_rig->workspace().motorsRunning().value_or(false));
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > 50);
    QVERIFY(!m_rig->workspace().hasAction(u"calibrate.gyro"_s));
    QVERIFY(m_rig->workspace().hasAction(u"store"_s));
    m_rig->edit(u"pid.yaw.p"_s, 0, 555);
    m_rig->edit(u"rc.pitch.min"_s, 0, -300);
    m_rig->window().review();
    QTRY_VERIFY(m_rig->window().reviewDialog());
    m_rig->window().reviewDialog()->accept();
    QTRY_COMPARE(m_rig->raw(u"pid.yaw.p"_s), 555);
    QCOMPARE(m_rig->raw(u"rc.pitch.min"_s), -300);
    QTRY_COMPARE(m_rig->model().changeCount(), 0);
}

void TestPages::openPageFollowsAnotherFamily_data()
{
    QTest::addColumn<QString>("page");
    for (const char *page : {"dashboard", "control", "tuning", "spectrum", "response"})
        QTest::newRow(page) << QString::fromLatin1(page);
}

// Channels are numbered by the family: a page that stays open asks the next board for that one's.
void TestPages::openPageFollowsAnotherFamily()
{
    QFETCH(QString, page);
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QVERIFY(m_rig->window().showPage(page));
    QVERIFY(m_rig->open(u"sim:simplebgc"_s));
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().identity().family == u"simplebgc"_s);
    QVERIFY(m_rig->window().page(page)->isVisible());
    // The first board told no targets.
    const QList<int> targets = ChannelRoles::present({m_rig->workspace().roles().target});
    QCOMPARE(targets.size(), 3);
    const auto isAsked = [&] {
        const QList<int> asked = m_rig->workspace().telemetry().with({}).channels;
        return std::all_of(targets.begin(), targets.end(), [&](int each) { return asked.contains(each); });
    };
    QTRY_VERIFY(isAsked());
    const auto newest = [&] {
        return valueAt(*m_rig->client().telemetry(), targets[0], -1, m_rig->client().telemetry()->now());
    };
    QTRY_VERIFY(!std::isnan(newest()));
}

// What is second in one family's list is another thing in the next one's.
void TestPages::modesOfAnotherFamilyBeginAnew()
{
    QVERIFY(m_rig->open(u"sim:simplebgc"_s));
    auto *control = m_rig->page<ControlPage>();
    auto *mode = named<QComboBox>(control, u"Mode of control"_s);
    mode->setCurrentIndex(1);
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().identity().family == u"storm32"_s);
    QTRY_COMPARE(mode->itemData(0).toInt(), m_rig->client().device()->steering()->modes().front().id);
    QCOMPARE(mode->currentIndex(), 0);
    // The same family again keeps what was chosen.
    mode->setCurrentIndex(1);
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QCOMPARE(mode->currentIndex(), 1);
}

// Nothing is shown or said about values that did not come, and no edit is lost because they did not come.
void TestPages::incompleteBoardIsTold()
{
    QSignalSpy problems(&m_rig->workspace().notifications(), &Notifications::problem);
    const auto told = [&problems] { return problems.takeFirst().first().value<ErrorText>().oneLine(); };
    const QString part = u"PARAMS_EXT2 of all profiles"_s;
    QVERIFY(m_rig->open(u"sim:simplebgc?fault=deaf%3D62"_s));  // READ_PARAMS_EXT2
    QTRY_COMPARE(problems.count(), 1);
    QVERIFY(told().contains(part));
    auto *parameters = m_rig->page<ParametersPage>();
    const auto box = [this, parameters](const QString &key) {
        std::ignore = m_rig->isSettled();  // the form gets its columns
        parameters->showParameter(key);
        return parameters->form()->findChild<QDoubleSpinBox *>(key);
    };
    const auto *unknown = box(u"motion.roll.acc_limit"_s);
    QVERIFY(!unknown || !unknown->isEnabled());
    QVERIFY(box(u"pid.roll.p"_s)->isEnabled());
    // The board's own live values are not compared with what is not known.
    const LiveModel &live = m_rig->workspace().live();
    QTRY_VERIFY(live.value(m_rig->spec(u"pid.roll.p"_s).id));
    QVERIFY(live.unsaved().empty());
    // It stays to be seen, and is told before a write.
    const auto labels = [](const QWidget *where) {
        QStringList texts;
        for (const QLabel *label : where->findChildren<QLabel *>())
            texts.append(label->isHidden() ? QString() : label->text());
        return texts.join(u'\n');
    };
    window().showPage(u"dashboard"_s);
    QTRY_VERIFY(labels(m_rig->page<DashboardPage>()).contains(part));
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    window().review();
    QTRY_VERIFY(window().reviewDialog());
    QVERIFY(labels(window().reviewDialog()).contains(part));
    window().reviewDialog()->reject();
    m_rig->workspace().edits().undoStack().undo();
    // A snapshot of it is marked.
    auto *backups = m_rig->page<BackupsPage>();
    const auto *table = backups->findChild<QTableWidget *>();
    QTest::mouseClick(named<QPushButton>(backups, u"Take a snapshot now"_s), Qt::LeftButton);
    QTRY_VERIFY(table->rowCount() == 1 && table->item(0, 1)->text().endsWith(u"(incomplete)"_s));
    QCOMPARE(problems.count(), 1);
    QVERIFY(told().contains(part));

    // Everything comes the second time, and an edit is made in it; then it does not come any more.
    QSignalSpy read(&m_rig->workspace(), &Workspace::boardRead);
    m_rig->workspace().changeWorld(u"deaf=-1"_s);
    m_rig->workspace().readBoard();
    QTRY_COMPARE(read.count(), 1);
    QVERIFY(box(u"motion.roll.acc_limit"_s)->isEnabled());
    m_rig->edit(u"motion.roll.acc_limit"_s, 0, 50);
    m_rig->workspace().changeWorld(u"deaf=62"_s);
    m_rig->workspace().readBoard();
    QTRY_COMPARE(read.count(), 2);
    QCOMPARE(m_rig->model().changeCount(), 1);
    QCOMPARE(problems.count(), 1);
    const QString again = told();
    QVERIFY2(again.contains(part) && again.contains(u"was read before"_s), qPrintable(again));
}

QTEST_MAIN(TestPages)
#include "tst_pages.moc"
