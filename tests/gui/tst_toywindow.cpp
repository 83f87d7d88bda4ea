// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/flightoverview.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/toyfamily/toycomposition.h"
#include "tests/support/toyfamily/toytables.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/plot/curvechart.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/codeeditor.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/motordiagram.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTextBrowser>
#include <QTreeWidget>

using namespace Qt::StringLiterals;

namespace {

bool says(const QWidget *page, const QString &text)
{
    const QList<QLabel *> labels = page->findChildren<QLabel *>();
    return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
        return label->isVisible() && label->text().contains(text);
    });
}

}  // namespace

/// The program with a family that it does not know: each page fills itself or is not listed.
class TestToyWindow : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void pagesAreListedOrFillThemselves();
    void startsWithoutABoard();
    void parametersOfEachKind();
    void floatIsEditedReviewedAndWritten();
    void documentIsEditedReviewedAndWritten();
    void documentIsLoadedSavedAndLimited();
    void dashboardHasAxesAndMotors();
    void monitorPlotsValuesAndArrays();
    void isSteeredAndStopped();
    void actionIsConfirmedEachTime();
    void motorsAreNeverSwitchedOn();

private:
    template <typename P> P *page() { return m_rig->page<P>(); }
    MainWindow &window() { return m_rig->window(); }
    ConfigurationModel &model() { return m_rig->model(); }
    double latest(int channel) { return m_rig->workspace().latest(channel); }
    ValueEditor *editor(const char *key)
    {
        auto *parameters = page<ParametersPage>();
        parameters->showParameter(QLatin1String(key));
        return parameters->form()->editor(m_rig->spec(QLatin1String(key)).id);
    }
    /// Reviews and writes by mouse; true when all of it is on the board.
    bool write()
    {
        QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
        QTest::mouseClick(window().unsavedBar()->writeButton(), Qt::LeftButton);
        if (!QTest::qWaitFor([this] { return window().reviewDialog() != nullptr; }, kPatience))
            return false;
        QTest::mouseClick(window().reviewDialog()->writeButton(), Qt::LeftButton);
        return QTest::qWaitFor([&finished] { return finished.count() > 0; }, kPatience)
            && m_rig->workspace().lastReport()->isComplete();
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestToyWindow::init()
{
    m_rig = std::make_unique<WindowRig>(toyLinks(), toyFamilies());
    window().resize(1280, 800);
    if (QByteArray(QTest::currentTestFunction()) != "startsWithoutABoard")
        QVERIFY(m_rig->open(u"sim:toy"_s));
}

void TestToyWindow::startsWithoutABoard()
{
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!window().navigation()->isOffered(key))
            continue;
        QVERIFY2(window().showPage(key), entry.key);
        QVERIFY2(window().page(key)->isVisible() || window().findChild<StartPage *>()->isVisible(),
                 entry.key);
    }
}

void TestToyWindow::pagesAreListedOrFillThemselves()
{
    QStringList listed;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!window().navigation()->isOffered(key))
            continue;
        listed.append(key);
        QVERIFY2(window().showPage(key), entry.key);
        QTRY_VERIFY2(window().page(key)->isVisible(), entry.key);
    }
    QCOMPARE(listed,
             (QStringList{u"dashboard"_s, u"monitor"_s, u"parameters"_s, u"documents"_s, u"spectrum"_s,
                          u"control"_s, u"actions"_s, u"backups"_s, u"gamepad"_s, u"settings"_s, u"help"_s}));
    QVERIFY(window().messageBar()->text().isEmpty() || !window().messageBar()->isVisible());
}

void TestToyWindow::parametersOfEachKind()
{
    auto *gain = qobject_cast<QDoubleSpinBox *>(editor("rate.gain")->control());
    QVERIFY(gain);
    QCOMPARE(float(gain->value()), 2e-6F);
    QVERIFY(qobject_cast<QDoubleSpinBox *>(editor("flight.limit")->control()));
    QCOMPARE(qobject_cast<QDoubleSpinBox *>(editor("flight.limit")->control())->value(), 4e9);
    QCOMPARE(qobject_cast<QDoubleSpinBox *>(editor("home.height")->control())->value(), -430000.0);
    auto *trim = qobject_cast<QDoubleSpinBox *>(editor("hover.trim")->control());
    QVERIFY2(trim->text().contains(u"no number"_s), qPrintable(trim->text()));
    QCOMPARE(qobject_cast<QComboBox *>(editor("esc.protocol")->control())->currentText(), u"DShot300"_s);
    QVERIFY(!qobject_cast<QCheckBox *>(editor("log.enabled")->control())->isChecked());
    auto *lights = qobject_cast<QPushButton *>(editor("lights")->control());
    QCOMPARE(lights->text(), u"Front, Rear"_s);
}

void TestToyWindow::floatIsEditedReviewedAndWritten()
{
    auto *gain = qobject_cast<QDoubleSpinBox *>(editor("rate.gain")->control());
    gain->setFocus();
    gain->selectAll();
    QTest::keyClicks(gain, u"0.0000035"_s);
    QTest::keyClick(gain, Qt::Key_Tab);
    QTRY_COMPARE(model().changeCount(), 1);
    QVERIFY(write());
    QCOMPARE(m_rig->raw(u"rate.gain"_s), double(3.5e-6F));
    QVERIFY(std::isnan(m_rig->raw(u"hover.trim"_s)));
    QCOMPARE(model().changeCount(), 0);
}

void TestToyWindow::documentIsEditedReviewedAndWritten()
{
    auto *documents = page<DocumentsPage>();
    auto *list = named<QListWidget>(documents, u"Documents of this board"_s);
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->text(), u"Mission"_s);
    auto *text = named<TextEditor>(documents, u"Text of the document"_s);
    QCOMPARE(text->bytes(), QByteArray("-- nothing yet\n"));
    QVERIFY(says(documents, u"restarts"_s));
    text->setFocus();
    text->selectAll();
    QTest::keyClicks(text, u"climb(10)"_s);
    QTRY_COMPARE(model().changeCount(), 1);
    QTRY_VERIFY(documents->hasChanges());
    // One step, also by the keyboard and within the editor.
    QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(text->bytes(), QByteArray("-- nothing yet\n"));
    QTRY_COMPARE(model().changeCount(), 0);
    QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(text->bytes(), QByteArray("climb(10)"));
    QSignalSpy lost(&m_rig->client(), &DeviceClient::connectionLost);
    QVERIFY(write());
    QCOMPARE(std::as_const(model()).board().block({0, toy::Mission}), QByteArray("climb(10)"));
    QCOMPARE(model().changeCount(), 0);
    QCOMPARE(lost.count(), 0);  // the restart was no loss
    // From another page, a step leads back.
    m_rig->window().showPage(u"dashboard"_s);
    m_rig->workspace().edits().undo();
    QCOMPARE(m_rig->window().navigation()->currentPage(), u"documents"_s);
    QTRY_VERIFY(text->hasFocus());
}

void TestToyWindow::documentIsLoadedSavedAndLimited()
{
    auto *documents = page<DocumentsPage>();
    auto *text = named<TextEditor>(documents, u"Text of the document"_s);
    const QString path = m_rig->filePath(u"mission.lua"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("land()\r\n-- über\r\n");
    file.close();
    documents->loadFrom(path);
    QCOMPARE(model().changeCount(), 1);
    QCOMPARE(std::as_const(model()).edited().block({0, toy::Mission}), QByteArray("land()\r\n-- über\r\n"));
    // Lines end as they ended before.
    text->setCursorPosition(0, 0);
    QTest::keyClicks(text, u"x"_s);
    const QString saved = m_rig->filePath(u"saved.lua"_s);
    documents->saveTo(saved);
    QFile back(saved);
    QVERIFY(back.open(QIODevice::ReadOnly));
    QCOMPARE(back.readAll(), QByteArray("xland()\r\n-- über\r\n"));
    const QByteArray before = std::as_const(model()).edited().block({0, toy::Mission});
    text->setText(QString(5000, u'a'));
    QTRY_VERIFY(says(documents, u"5000"_s));
    QTRY_VERIFY(documents->findChild<QLabel *>(u"error"_s));
    QCOMPARE(std::as_const(model()).edited().block({0, toy::Mission}), before);
    QSignalSpy problem(&m_rig->workspace().notifications(), &Notifications::problem);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(5000, 'a'));
    file.close();
    documents->loadFrom(path);
    QCOMPARE(problem.count(), 1);
}

void TestToyWindow::dashboardHasAxesAndMotors()
{
    // It flies: there is no camera to be drawn.
    auto *dashboard = page<DashboardPage>();
    for (const AxisDial *dial : dashboard->findChildren<AxisDial *>())
        QVERIFY(!dial->isVisible());
    const auto *overview = dashboard->findChild<FlightOverview *>();
    QVERIFY(overview && overview->isVisible());
    QTRY_COMPARE(overview->motors()->count(), toy::kMotors);
    QVERIFY(!overview->motors()->hasPlaces());  // nobody knows where they are
    QTRY_COMPARE(overview->motors()->outputText(5), u"stands"_s);
    QTRY_VERIFY(overview->state()->state() != ArmedState::State::Unknown);
}

void TestToyWindow::monitorPlotsValuesAndArrays()
{
    auto *monitor = page<MonitorPage>();
    ChannelModel &channels = monitor->channels();
    auto *arrays = named<CurveChart>(monitor, u"Newest values of the arrays"_s);
    QStringList names;
    for (int group = 0; group < channels.rowCount(); ++group) {
        const QModelIndex parent = channels.index(group, 0);
        for (int row = 0; row < channels.rowCount(parent); ++row)
            names.append(channels.index(row, 0, parent).data().toString());
    }
    QCOMPARE(names.size(), qsizetype(toy::channels().size()));
    QVERIFY(names.contains(u"Motor 5"_s) && names.contains(u"Vibration"_s));
    QVERIFY(!monitor->plots().isEmpty());
    QVERIFY(!arrays->isVisible());
    QVERIFY(!monitor->streamsButton()->isEnabled());
    channels.setTicked({toy::Pitch, toy::Motor3, toy::Spectrum});
    QTRY_VERIFY(arrays->isVisible());
    QTRY_VERIFY(!arrays->curves().isEmpty());
    QTRY_COMPARE(arrays->curves().first().points.size(), toy::kSpectrumBins);
    QCOMPARE(arrays->curves().first().points.at(64).y(), -10.0);
    QCOMPARE(channels.ticked(), (QList<int>{toy::Pitch, toy::Motor3, toy::Spectrum}));
    QCOMPARE(monitor->stack()->channels(), (QList<int>{toy::Pitch, toy::Motor3}));
    QVERIFY(monitor->exportCsv(m_rig->filePath(u"samples.csv"_s)));
    channels.setTicked({toy::Pitch});
    QTRY_VERIFY(!arrays->isVisible());
}

void TestToyWindow::isSteeredAndStopped()
{
    auto *control = page<ControlPage>();
    QVERIFY(control->pad()->isVisible());
    auto *throttle = named<QDoubleSpinBox>(control, u"Throttle"_s);
    auto *arm = named<QComboBox>(control, u"Arm"_s);
    QCOMPARE(throttle->maximum(), 1.0);
    QTRY_COMPARE(m_rig->workspace().motorsRunning().value_or(true), false);
    QTest::mouseClick(control->armButton(), Qt::LeftButton);
    QVERIFY(control->isArmed());
    // Arming alone moves nothing.
    QCOMPARE(control->setpoint().inputs, (std::vector<double>{0, 0, 0}));
    throttle->setValue(0.5);
    arm->setCurrentIndex(1);
    QTRY_COMPARE(latest(toy::Motor1), 55.0);
    QTest::keyPress(control->pad(), Qt::Key_Right);
    QTRY_VERIFY(latest(toy::YawRate) > 0);
    QTest::keyRelease(control->pad(), Qt::Key_Right);
    QTRY_COMPARE(m_rig->workspace().motorsRunning().value_or(false), true);
    auto *motors = window().findChild<QPushButton *>(u"motors"_s);
    QTRY_VERIFY(motors->property("running").toBool());
    QTest::mouseClick(motors, Qt::LeftButton);
    QTRY_COMPARE(latest(toy::Outputs), 0.0);
    QTRY_VERIFY(!control->isArmed());
    QCOMPARE(throttle->value(), 0.0);
    QCOMPARE(arm->currentIndex(), 0);
    QTRY_COMPARE(window().messageBar()->text().contains(u"switched off"_s), true);
}

void TestToyWindow::actionIsConfirmedEachTime()
{
    auto *actions = page<ActionsPage>();
    QVERIFY(actions->showAction(u"calibrate.level"_s));
    QTRY_COMPARE(latest(toy::Armed), 0.0);
    const auto asked = [this] { return qobject_cast<QMessageBox *>(window().panels()->newest()); };
    for (int time = 0; time < 2; ++time) {
        QTest::mouseClick(actions->runButton(), Qt::LeftButton);
        QTRY_VERIFY(asked());
        QVERIFY2(asked()->text().contains(u"The propellers are off"_s), qPrintable(asked()->text()));
        QVERIFY(latest(toy::Calibrated) == double(time));
        if (time == 1)
            break;
        QTest::mouseClick(named<QPushButton>(asked(), u"Calibrate"_s), Qt::LeftButton);
        QTRY_COMPARE(latest(toy::Calibrated), 1.0);
        QTRY_VERIFY(actions->runButton()->isEnabled());
        QVERIFY(actions->reply()->toPlainText().contains(u"done"_s));
        QTRY_VERIFY(!m_rig->client().isBusy());
    }
    // Without the answer nothing happens.
    QTest::mouseClick(asked()->defaultButton(), Qt::LeftButton);
    QTRY_VERIFY(actions->runButton()->isEnabled());
    QVERIFY(actions->reply()->toPlainText().contains(u"Cancelled"_s));
    // Nor on another link.
    QTest::mouseClick(actions->runButton(), Qt::LeftButton);
    QTRY_VERIFY(asked());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(actions->reply()->toPlainText().contains(u"Cancelled"_s));
    QTRY_VERIFY(!asked());
}

void TestToyWindow::motorsAreNeverSwitchedOn()
{
    auto *motors = window().findChild<QPushButton *>(u"motors"_s);
    QTRY_COMPARE(m_rig->workspace().motorsRunning().value_or(true), false);
    QTRY_VERIFY(!motors->property("running").toBool());
    QVERIFY2(motors->text().contains(u"STOP MOTORS"_s), qPrintable(motors->text()));
    QVERIFY(motors->isEnabled());
}

QTEST_MAIN(TestToyWindow)
#include "tst_toywindow.moc"
