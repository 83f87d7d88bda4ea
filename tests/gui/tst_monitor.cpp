// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/device/abilities.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/simulator/world/plant.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/filterrows.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/plot/spectrumchart.h"

#include <QCheckBox>
#include <QGraphicsTextItem>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QUndoStack>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

/// Watching and recording, as an operator does it.
class TestMonitor : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void scalesStayInsideWhenThePlotsShrink();
    void spectrumFindsTheResonance();
    void tunedGimbalIsOfferedNoNotch();
    void harmfulTrialEndsWithoutItsPage();
    void cutTrialIsMadeGood();
    void notchTakesTheResonanceAway();
    void filtersAreShownAsFilters();
    void recordingsFromTheScreen();
    void recordingThatFallsSilentIsTold();
    void slowLineIsTold();

private:
    bool openTuned();
    bool writeEdits();
    [[nodiscard]] int rowOf(const SpectrumPage &page, Axis axis, double hz) const;
    /// The board's first notch of that axis is in use, as last read.
    [[nodiscard]] bool hasNotch(Axis axis);

    std::unique_ptr<WindowRig> m_rig;
};

void TestMonitor::scalesStayInsideWhenThePlotsShrink()
{
    QVERIFY(m_rig->open());
    auto *monitor = m_rig->page<MonitorPage>();
    QTRY_COMPARE(monitor->plots().size(), 2);
    QTRY_VERIFY(monitor->plots().first()->height() > 100);
    const int before = monitor->plots().first()->height();
    // Messages and the unsaved bar take no room from the plots; a smaller window does.
    m_rig->workspace().notifications().notify(u"a message"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, 60);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(monitor->plots().first()->height(), before);
    m_rig->window().resize(m_rig->window().minimumSize());
    QTRY_VERIFY(monitor->plots().first()->height() < before);
    for (PlotView *plot : monitor->plots()) {
        const auto items = plot->scene()->items();
        int labels = 0;
        for (QGraphicsItem *item : items) {
            const auto *label = qgraphicsitem_cast<QGraphicsTextItem *>(item);
            if (!label || !label->toPlainText().endsWith(u" s"_s))
                continue;
            ++labels;
            QVERIFY(label->isVisible());
            QVERIFY(label->scenePos().y() + 10 < plot->viewport()->height());
        }
        QVERIFY(labels >= 4);
    }
}

void TestMonitor::spectrumFindsTheResonance()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<SpectrumPage>();
    QVERIFY(page);
    QTRY_COMPARE(page->chart()->curves().size(), qsizetype(3));
    QCOMPARE(page->chart()->xScale().high, 625.0);  // half the rate, not a hertz more
    // Gains that make the structure ring show where it rings.
    auto set = m_rig->client().submit<bool>([](Channel &channel, Device &device) -> Result<bool> {
        std::vector<AdjustableValue> values;
        for (const AdjustableSpec &spec : device.live()->adjustables()) {
            if (QByteArray(spec.key) == "p.roll")
                values.push_back({spec.id, 100});
            if (QByteArray(spec.key) == "d.roll")
                values.push_back({spec.id, 60});
        }
        const auto done = device.live()->writeAdjustables(channel, values);
        return done ? Result<bool>(values.size() == 2) : tl::unexpected(done.error());
    });
    QTRY_VERIFY(set.isFinished());
    QVERIFY(set.result() && *set.result());
    const double resonance = simulatedMechanics(Axis::Roll).resonanceHz;
    const auto rollPeakAt = [page, resonance] {
        for (int row = 0; row < page->peaks()->rowCount(); ++row) {
            const double hz = page->peaks()->item(row, 1)->text().section(u' ', 0, 0).toDouble();
            if (page->peaks()->item(row, 0)->text() == axisLabel(Axis::Roll)
                && std::abs(hz / resonance - 1.0) < 0.2)
                return true;
        }
        return false;
    };
    QTRY_VERIFY(rollPeakAt());
    // The error by band, and how it changes against what was kept.
    QTRY_VERIFY(page->bands()->item(1, 1)->text().contains(u"RMS"_s));
    QVERIFY(!page->bands()->item(1, 1)->text().contains(u'%'));
    QTest::mouseClick(named<QPushButton>(page, u"Compare"_s), Qt::LeftButton);
    QVERIFY(page->bands()->item(1, 1)->text().contains(u'%'));
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    const QString held = page->bands()->item(1, 1)->text();
    const quint64 rows = m_rig->client().telemetry()->rows();
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > rows + 1500);
    QCOMPARE(page->bands()->item(1, 1)->text(), held);
}

bool TestMonitor::writeEdits()
{
    QSignalSpy written(&m_rig->workspace(), &Workspace::writeFinished);
    m_rig->workspace().write(std::as_const(m_rig->model()).edited());
    return written.wait(kPatience) && m_rig->model().changeCount() == 0;
}

// What auto-tune finds on the simulated gimbal in a hand that shakes.
bool TestMonitor::openTuned()
{
    if (!m_rig->open())
        return false;
    m_rig->workspace().changeWorld(u"shake=8"_s);
    const QHash<QString, int> gains{{u"roll.p"_s, 84},  {u"roll.i"_s, 14},  {u"roll.d"_s, 51},
                                    {u"pitch.p"_s, 84}, {u"pitch.i"_s, 19}, {u"pitch.d"_s, 52},
                                    {u"yaw.p"_s, 38},   {u"yaw.i"_s, 8},    {u"yaw.d"_s, 88}};
    for (auto it = gains.begin(); it != gains.end(); ++it)
        m_rig->edit(u"pid."_s + it.key(), 0, it.value());
    return writeEdits();
}

int TestMonitor::rowOf(const SpectrumPage &page, Axis axis, double hz) const
{
    for (int row = 0; row < page.peaks()->rowCount(); ++row) {
        const double found = page.peaks()->item(row, 1)->text().section(u' ', 0, 0).toDouble();
        if (page.peaks()->item(row, 0)->text() == axisLabel(axis) && std::abs(found / hz - 1.0) < 0.1)
            return row;
    }
    return -1;
}

bool TestMonitor::hasNotch(Axis axis)
{
    const QString key = u"filter.%1.enabled"_s.arg(QLatin1String(axisKey(axis)));
    return flagBits(m_rig->raw(key)) & 1U;
}

void TestMonitor::tunedGimbalIsOfferedNoNotch()
{
    QVERIFY(openTuned());
    auto *page = m_rig->page<SpectrumPage>();
    QVERIFY(!page->notchButton()->isEnabled());
    QTRY_VERIFY(rowOf(*page, Axis::Yaw, 51.8) >= 0);
    QVERIFY(m_rig->boardGoesOn(10));
    QTRY_VERIFY(rowOf(*page, Axis::Yaw, 51.8) >= 0);
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    page->peaks()->selectRow(rowOf(*page, Axis::Yaw, 51.8));
    QVERIFY2(page->advice()->text().contains(u"no notch is offered"_s), qPrintable(page->advice()->text()));
    QVERIFY(!page->notchButton()->isEnabled());
}

// Nobody looks on: the operator has left the page.
void TestMonitor::harmfulTrialEndsWithoutItsPage()
{
    QVERIFY(openTuned());
    m_rig->page<SpectrumPage>();
    NotchAdviser &adviser = m_rig->workspace().notches();
    QVERIFY(m_rig->boardGoesOn(2));
    const auto plan = adviser.plan(Axis::Yaw, {51.8, 0.17, 1.4, 22});
    QVERIFY(plan);
    QSignalSpy notices(&m_rig->workspace().notifications(), &Notifications::notice);
    adviser.start(*plan);
    QVERIFY(adviser.isRunning());
    QVERIFY(m_rig->workspace().live().isHeld());
    m_rig->window().showPage(u"dashboard"_s);
    QTRY_VERIFY(!adviser.isRunning());
    QVERIFY(!m_rig->workspace().live().isHeld());
    QVERIFY2(adviser.outcome().contains(u"oscillate"_s), qPrintable(adviser.outcome()));
    QVERIFY(adviser.outcome().contains(u"back on the board"_s));
    QCOMPARE(notices.last().at(0).toString(), adviser.outcome());
    QCOMPARE(notices.last().at(1).value<Notice>(), Notice::Attention);
    QCOMPARE(m_rig->model().changeCount(), 0);
    // The board says so as well, and holds still.
    m_rig->workspace().readBoard();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!hasNotch(Axis::Yaw));
    QCOMPARE(m_rig->raw(u"filter.yaw.notch1.frequency"_s), 0.0);
}

void TestMonitor::cutTrialIsMadeGood()
{
    QVERIFY(m_rig->open());
    QVERIFY(m_rig->boardGoesOn(2));
    NotchAdviser &adviser = m_rig->workspace().notches();
    const auto plan = adviser.plan(Axis::Pitch, {150, 0.1, 2, 20});
    QVERIFY(plan);
    bool cut = false;
    const auto onProgress
        = connect(&m_rig->client(), &DeviceClient::progressChanged, this, [&](const Progress &p) {
              if (p.step == u"measure-after"_s && !std::exchange(cut, true))
                  m_rig->client().disconnectFromBoard();
          });
    adviser.start(*plan);
    QTRY_VERIFY(!adviser.isRunning());
    QVERIFY(cut);
    disconnect(onProgress);
    QVERIFY2(adviser.outcome().contains(u"could not be taken back"_s), qPrintable(adviser.outcome()));
    // The program starts anew, and the same board is connected again.
    QSignalSpy notices(&m_rig->workspace().notifications(), &Notifications::notice);
    QSignalSpy written(&m_rig->workspace(), &Workspace::writeFinished);
    QVERIFY(m_rig->open());
    QTRY_COMPARE(written.count(), 1);
    QVERIFY(std::any_of(notices.begin(), notices.end(), [](const QList<QVariant> &notice) {
        return notice.at(0).toString().contains(u"was cut off"_s);
    }));
    m_rig->workspace().readBoard();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!hasNotch(Axis::Pitch));
    QVERIFY(!keptTrial(m_rig->workspace().history(), m_rig->client().identity()));
}

void TestMonitor::notchTakesTheResonanceAway()
{
    QVERIFY(m_rig->open());
    m_rig->workspace().changeWorld(u"shake=0.3"_s);  // what vibrates is mostly the structure
    const double resonance = simulatedMechanics(Axis::Roll).resonanceHz;
    // Gains that make the structure ring.
    m_rig->edit(u"pid.roll.p"_s, 0, 100);
    m_rig->edit(u"pid.roll.d"_s, 0, 60);
    QVERIFY(writeEdits());
    auto *page = m_rig->page<SpectrumPage>();
    const auto strength = [&] {
        const int row = rowOf(*page, Axis::Roll, 1.06 * resonance);
        return row < 0 ? 0.0 : page->peaks()->item(row, 2)->text().section(u' ', 0, 0).toDouble();
    };
    QTRY_VERIFY(strength() > 0.0);
    QVERIFY(m_rig->boardGoesOn(10));
    QTRY_VERIFY(strength() > 0.0);
    const double before = strength();
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    page->peaks()->selectRow(rowOf(*page, Axis::Roll, 1.06 * resonance));
    QVERIFY2(page->notchButton()->isEnabled(), qPrintable(page->advice()->text()));
    // Declined: nothing happens.
    const auto question = [this] { return m_rig->window().findChild<QMessageBox *>(); };
    QTest::mouseClick(page->notchButton(), Qt::LeftButton);
    QTRY_VERIFY(question());
    QVERIFY(question()->text().contains(u"delays"_s) && question()->text().contains(u"not been measured"_s));
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(!question());
    QVERIFY(!m_rig->workspace().notches().isRunning());
    // Tried: measured, and nothing stays before the operator wants it to.
    QSignalSpy offers(&m_rig->workspace().notifications(), &Notifications::offer);
    QTest::mouseClick(page->notchButton(), Qt::LeftButton);
    QTRY_VERIFY(question());
    QTRY_VERIFY(!m_rig->window().findChild<ClickShield *>());
    QTest::keyClick(question(), Qt::Key_Return);
    QVERIFY(m_rig->workspace().notches().isRunning());
    QTRY_COMPARE(page->notchButton()->text(), u"End the trial"_s);
    QTRY_VERIFY(!m_rig->workspace().notches().isRunning());
    QVERIFY2(offers.count() == 1, qPrintable(m_rig->workspace().notches().outcome()));
    QCOMPARE(m_rig->model().changeCount(), 0);
    m_rig->workspace().readBoard();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(!hasNotch(Axis::Roll));
    QTest::mouseClick(named<QPushButton>(&m_rig->window(), u"Take over as an edit"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->model().changeCount() > 0);
    m_rig->workspace().edits().undoStack().undo();  // one step
    QCOMPARE(m_rig->model().changeCount(), 0);
    m_rig->workspace().edits().undoStack().redo();
    QVERIFY(writeEdits());
    QVERIFY(hasNotch(Axis::Roll));
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    // What was measured before the notch leaves the span; then a third is left at most.
    QTRY_VERIFY(strength() < before / 3);
}

void TestMonitor::filtersAreShownAsFilters()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ParametersPage>();
    page->showParameter(u"filter.pitch.notch2.frequency"_s);
    const auto curves = [page] { return page->form()->findChildren<FilterCurve *>(); };
    QTRY_COMPARE(curves().size(), qsizetype(9));  // three axes with three notches each
    FilterCurve *curve = curves()[4];
    QVERIFY(!curve->isInUse() && curve->toolTip() == u"Not in use"_s);
    const auto editor = [&](const char *name) {
        return page->form()->editor(m_rig->spec(u"filter.pitch.notch2.%1"_s.arg(QLatin1String(name))).id);
    };
    QVERIFY(editor("gain")->control()->property("inactive").toBool());
    // All of a filter stands in one row.
    auto *use = named<QCheckBox>(page, u"Pitch, notch 2"_s);
    for (QWidget *part : QList<QWidget *>{editor("frequency"), editor("width"), editor("gain"), curve}) {
        const int middle = part->mapTo(page, part->rect().center()).y();
        QVERIFY(std::abs(middle - use->mapTo(page, use->rect().center()).y()) < use->height());
    }
    QTest::mouseClick(use, Qt::LeftButton, {}, QPoint(8, use->height() / 2));
    const ParameterSpec &enabled = m_rig->spec(u"filter.pitch.enabled"_s);
    const auto bits
        = [&] { return flagBits(std::as_const(m_rig->model()).edited().raw(enabled, 0).value()); };
    QCOMPARE(bits() & 7U, 2U);
    QVERIFY(curve->isInUse() && use->isChecked());
    QVERIFY(!editor("gain")->control()->property("inactive").toBool());
    m_rig->edit(u"filter.pitch.notch2.frequency"_s, 0, 40);
    QCOMPARE(curve->shape().hz, 80.0);
    m_rig->edit(u"filter.pitch.notch2.gain"_s, 0, 20);
    QVERIFY2(curve->toolTip().contains(u"20 dB at 80 Hz"_s), qPrintable(curve->toolTip()));
    for (int step = 0; step < 3; ++step)
        m_rig->workspace().edits().undoStack().undo();
    QVERIFY(!curve->isInUse() && !use->isChecked());
    QCOMPARE(m_rig->model().changeCount(), 0);
}

void TestMonitor::recordingsFromTheScreen()
{
    QVERIFY(m_rig->open());
    auto *monitor = m_rig->page<MonitorPage>();
    LinkRecorder &recorder = m_rig->workspace().recorder();
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > 500);
    // From now on, ended with the button.
    const QString now = m_rig->filePath(u"now.gimbalrec"_s);
    QSignalSpy finished(&recorder, &LinkRecorder::finished);
    QVERIFY(recorder.start(now));
    QVERIFY(!recorder.start(m_rig->filePath(u"second"_s)));
    QCOMPARE(named<QPushButton>(monitor, u"Stop recording"_s)->menu(), nullptr);
    QTRY_VERIFY(recorder.size() > 50'000);
    QTest::mouseClick(named<QPushButton>(monitor, u"Stop recording"_s), Qt::LeftButton);
    QVERIFY(!recorder.isRecording());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(named<QPushButton>(monitor, u"Record"_s)->menu());
    // The last minutes, after the fact.
    const QString past = m_rig->filePath(u"past.gimbalrec"_s);
    QVERIFY(recorder.savePast(past));
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY(QFileInfo(past).size() > QFileInfo(now).size());
    // A disk without room.
    if (QFileInfo::exists(u"/dev/full"_s))
        QVERIFY(!recorder.start(u"/dev/full"_s));
    // Opened like the board, with its values and its live data, read-only.
    m_rig->client().disconnectFromBoard();
    for (const QString &file : {now, past}) {
        m_rig->window().openFile(file);
        QVERIFY(QTest::qWaitFor([this] { return m_rig->client().isConnected() && !m_rig->model().isEmpty(); },
                                kPatience));
        QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 35);
        QVERIFY(!m_rig->client().identity().writable);
        m_rig->window().showPage(u"monitor"_s);
        QTRY_VERIFY(m_rig->client().telemetry()->rows() > 300);
        QVERIFY(!named<QPushButton>(monitor, u"Record"_s)->isEnabled());
        m_rig->client().disconnectFromBoard();
    }
    // A damaged one too, and that something is missing is told, once.
    QFile stored(now);
    QVERIFY(stored.open(QIODevice::ReadWrite));
    const QByteArray byte = QByteArray(1, char(~stored.readAll().at(stored.size() * 3 / 4)));
    QVERIFY(stored.seek(stored.size() * 3 / 4) && stored.write(byte) == 1);
    stored.close();
    QSignalSpy problems(&m_rig->workspace().notifications(), &Notifications::problem);
    m_rig->window().openFile(now);
    QTRY_COMPARE(problems.count(), 1);
    const auto problem = problems.first().first().value<ErrorText>();
    QVERIFY2(problem.what.contains(u"damaged"_s) && problem.meaning.startsWith(u"1 part"_s)
                 && problem.detail == u"A checksum is wrong."_s,
             qPrintable(problem.oneLine()));
    QTRY_VERIFY(m_rig->client().telemetry() && m_rig->client().telemetry()->rows() > 300);
    m_rig->client().disconnectFromBoard();
    QCOMPARE(problems.count(), 1);
    // Unplugging ends a recording properly.
    QVERIFY(m_rig->open());
    QVERIFY(recorder.start(now));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(finished.count(), 3);
    QVERIFY(Recording::load(now));
}

// Few samples are no fault of the board: the line carries no more.
void TestMonitor::slowLineIsTold()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?rate=9600"_s));
    auto *monitor = m_rig->page<MonitorPage>();
    const auto tells = [](const QWidget &where, const QString &words) {
        const auto labels = where.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel *label) {
            return (label->text() + label->toolTip()).contains(words);
        });
    };
    QTRY_VERIFY(tells(*monitor, u"The line is slow"_s));
    QTRY_VERIFY(tells(m_rig->window(), u"thinned out: slow line"_s));
    // The status comes twice a second: that is not late.
    QTRY_VERIFY(!std::isnan(m_rig->workspace().latest(m_rig->workspace().roles().battery)));
    for (int i = 0; i < 5; ++i) {
        QVERIFY(m_rig->boardGoesOn(0.5));
        QVERIFY(!m_rig->workspace().freshness().staleSince({m_rig->workspace().roles().battery}));
    }
}

// The link lives on, live data do not come: what is recorded meanwhile is not what the operator expects.
void TestMonitor::recordingThatFallsSilentIsTold()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    LinkRecorder &recorder = m_rig->workspace().recorder();
    MessageBar &messages = *m_rig->window().messageBar();
    QVERIFY(m_rig->boardGoesOn(0.5));
    QSignalSpy finished(&recorder, &LinkRecorder::finished);
    QVERIFY(recorder.start(m_rig->filePath(u"silent.gimbalrec"_s)));
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->workspace().changeWorld(u"deaf=100"_s);
    QTRY_VERIFY(messages.text().contains(u"Live data have stopped"_s));
    m_rig->workspace().changeWorld(u"deaf=-1"_s);
    QTRY_VERIFY(!messages.isVisible() || !messages.text().contains(u"Live data have stopped"_s));
    recorder.stop();
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(finished.front().at(2).toBool());
    QTRY_VERIFY(messages.text().contains(u"Recording saved"_s));
    // Nothing at all came: no success.
    m_rig->workspace().changeWorld(u"deaf=100"_s);
    QTRY_VERIFY(m_rig->workspace().freshness().staleSince());
    QVERIFY(recorder.start(m_rig->filePath(u"empty.gimbalrec"_s)));
    recorder.stop();
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY(!finished.back().at(2).toBool());
    QTRY_VERIFY(messages.text().contains(u"holds no live data"_s));
}

QTEST_MAIN(TestMonitor)
#include "tst_monitor.moc"
