// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/device/abilities.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/simulator/world/plant.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/named.h"
#include "tests/support/windowrig.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/plot/spectrumchart.h"

#include <QGraphicsTextItem>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QUndoStack>

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
    void peakBecomesANotch();
    void notchTakesTheResonanceAway();
    void recordingsFromTheScreen();

private:
    std::unique_ptr<WindowRig> m_rig;
};

void TestMonitor::scalesStayInsideWhenThePlotsShrink()
{
    QVERIFY(m_rig->open());
    auto *monitor = m_rig->page<MonitorPage>();
    QTRY_COMPARE(monitor->plots().size(), 2);
    QTRY_VERIFY(monitor->plots().first()->height() > 100);
    const int before = monitor->plots().first()->height();
    // Messages and the unsaved bar take room from the plots, and give it back.
    m_rig->workspace().notifications().notify(u"a message"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, 60);
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
    QTRY_COMPARE_WITH_TIMEOUT(page->chart()->curves().size(), qsizetype(3), 10000);
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
    QTRY_VERIFY_WITH_TIMEOUT(rollPeakAt(), 20000);
    // The error by band, and how it changes against what was kept.
    QTRY_VERIFY_WITH_TIMEOUT(page->bands()->item(1, 1)->text().contains(u"RMS"_s), 10000);
    QVERIFY(!page->bands()->item(1, 1)->text().contains(u'%'));
    QTest::mouseClick(named<QPushButton>(page, u"Compare"_s), Qt::LeftButton);
    QVERIFY(page->bands()->item(1, 1)->text().contains(u'%'));
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    const QString held = page->bands()->item(1, 1)->text();
    const quint64 rows = m_rig->client().telemetry()->rows();
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > rows + 1500);
    QCOMPARE(page->bands()->item(1, 1)->text(), held);
}

void TestMonitor::peakBecomesANotch()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<SpectrumPage>();
    QVERIFY(!named<QPushButton>(page, u"Put a notch here…"_s)->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(page->peaks()->rowCount() > 0, 20000);
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    page->peaks()->selectRow(0);
    QVERIFY(named<QPushButton>(page, u"Put a notch here…"_s)->isEnabled());
    const QString axis = page->peaks()->item(0, 0)->text();
    const double hz = page->peaks()->item(0, 1)->text().section(u' ', 0, 0).toDouble();
    const QString key = axis == axisLabel(Axis::Roll) ? u"roll"_s
        : axis == axisLabel(Axis::Pitch)              ? u"pitch"_s
                                                      : u"yaw"_s;
    const auto edited = [&](const QString &name) {
        const ParameterSpec &spec = m_rig->spec(u"filter."_s + key + u'.' + name);
        return spec.toDisplay(std::as_const(m_rig->model()).edited().raw(spec, 0).value());
    };
    // Declined: nothing is changed. Taken: the values of one filter, one step to undo.
    QTest::mouseClick(named<QPushButton>(page, u"Put a notch here…"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->window().findChild<QMessageBox *>());
    QVERIFY(m_rig->window().findChild<QMessageBox *>()->text().contains(u"delays"_s));
    QTest::keyClick(m_rig->window().findChild<QMessageBox *>(), Qt::Key_Escape);
    QTRY_VERIFY(!m_rig->window().findChild<QMessageBox *>());
    QCOMPARE(m_rig->model().changeCount(), 0);
    QTest::mouseClick(named<QPushButton>(page, u"Put a notch here…"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->window().findChild<QMessageBox *>());
    QTest::keyClick(m_rig->window().findChild<QMessageBox *>(), Qt::Key_Return);
    QTRY_VERIFY(m_rig->model().changeCount() > 0);
    QVERIFY(std::abs(edited(u"notch1.frequency"_s) - hz) <= 1.1);  // the board counts in steps of two
    QVERIFY(edited(u"notch1.width"_s) >= hz / 4 - 1);
    QCOMPARE(edited(u"notch1.gain"_s), 20.0);
    QCOMPARE(int(edited(u"enabled"_s)) & 1, 1);
    // The next one goes into the next filter.
    QTRY_VERIFY(!m_rig->window().findChild<QMessageBox *>());
    QTest::mouseClick(named<QPushButton>(page, u"Put a notch here…"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->window().findChild<QMessageBox *>());
    QTest::keyClick(m_rig->window().findChild<QMessageBox *>(), Qt::Key_Return);
    QTRY_COMPARE(int(edited(u"enabled"_s)) & 3, 3);
    m_rig->workspace().edits().undoStack().undo();
    QCOMPARE(int(edited(u"enabled"_s)) & 3, 1);
    m_rig->workspace().edits().undoStack().undo();
    QCOMPARE(m_rig->model().changeCount(), 0);
}

void TestMonitor::notchTakesTheResonanceAway()
{
    QVERIFY(m_rig->open());
    const double resonance = simulatedMechanics(Axis::Roll).resonanceHz;
    const auto writeEdits = [this] {
        QSignalSpy written(&m_rig->workspace(), &Workspace::writeFinished);
        m_rig->workspace().write(std::as_const(m_rig->model()).edited());
        return written.wait(15000);
    };
    // Gains that make the structure ring.
    m_rig->edit(u"pid.roll.p"_s, 0, 100);
    m_rig->edit(u"pid.roll.d"_s, 0, 60);
    QVERIFY(writeEdits());
    auto *page = m_rig->page<SpectrumPage>();
    // Strength of the line at the resonance, 0 without one; its row.
    int row = -1;
    const auto strength = [&] {
        for (row = 0; row < page->peaks()->rowCount(); ++row) {
            const double hz = page->peaks()->item(row, 1)->text().section(u' ', 0, 0).toDouble();
            if (page->peaks()->item(row, 0)->text() == axisLabel(Axis::Roll)
                && std::abs(hz / resonance - 1.0) < 0.2)
                return page->peaks()->item(row, 2)->text().section(u' ', 0, 0).toDouble();
        }
        return 0.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(strength() > 0.0, 25000);
    const double before = strength();
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    QVERIFY(strength() > 0.0);
    page->peaks()->selectRow(row);
    QTest::mouseClick(named<QPushButton>(page, u"Put a notch here…"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->window().findChild<QMessageBox *>());
    QTest::keyClick(m_rig->window().findChild<QMessageBox *>(), Qt::Key_Return);
    QTRY_VERIFY(m_rig->model().changeCount() > 0);
    QVERIFY(writeEdits());
    QCOMPARE(m_rig->model().changeCount(), 0);
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    // What was measured before the notch leaves the span; then a third is left at most.
    QTRY_VERIFY_WITH_TIMEOUT(strength() < before / 3, 25000);
}

void TestMonitor::recordingsFromTheScreen()
{
    QVERIFY(m_rig->open());
    auto *monitor = m_rig->page<MonitorPage>();
    LinkRecorder &recorder = m_rig->workspace().recorder();
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().telemetry()->rows() > 500, 10000);
    // From now on, ended with the button.
    const QString now = m_rig->filePath(u"now.gimbalrec"_s);
    QSignalSpy finished(&recorder, &LinkRecorder::finished);
    QVERIFY(recorder.start(now));
    QVERIFY(!recorder.start(m_rig->filePath(u"second"_s)));
    QCOMPARE(named<QPushButton>(monitor, u"Stop recording"_s)->menu(), nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(recorder.size() > 50'000, 10000);
    QTest::mouseClick(named<QPushButton>(monitor, u"Stop recording"_s), Qt::LeftButton);
    QVERIFY(!recorder.isRecording());
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 10000);
    QVERIFY(named<QPushButton>(monitor, u"Record"_s)->menu());
    // The last minutes, after the fact.
    const QString past = m_rig->filePath(u"past.gimbalrec"_s);
    QVERIFY(recorder.savePast(past));
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 2, 10000);
    QVERIFY(QFileInfo(past).size() > QFileInfo(now).size());
    // A disk without room.
    if (QFileInfo::exists(u"/dev/full"_s))
        QVERIFY(!recorder.start(u"/dev/full"_s));
    // Opened like the board, with its values and its live data, read-only.
    m_rig->client().disconnectFromBoard();
    for (const QString &file : {now, past}) {
        m_rig->window().openFile(file);
        QVERIFY(QTest::qWaitFor([this] { return m_rig->client().isConnected() && !m_rig->model().isEmpty(); },
                                15000));
        QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 35);
        QVERIFY(!m_rig->client().identity().writable);
        m_rig->window().showPage(u"monitor"_s);
        QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().telemetry()->rows() > 300, 10000);
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
    QTRY_COMPARE_WITH_TIMEOUT(problems.count(), 1, 15000);
    const auto problem = problems.first().first().value<ErrorText>();
    QVERIFY2(problem.what.contains(u"damaged"_s) && problem.meaning.startsWith(u"1 part"_s)
                 && problem.detail == u"a checksum is wrong"_s,
             qPrintable(problem.oneLine()));
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().telemetry() && m_rig->client().telemetry()->rows() > 300, 10000);
    m_rig->client().disconnectFromBoard();
    QCOMPARE(problems.count(), 1);
    // Unplugging ends a recording properly.
    QVERIFY(m_rig->open());
    QVERIFY(recorder.start(now));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 3, 10000);
    QVERIFY(Recording::load(now));
}

QTEST_MAIN(TestMonitor)
#include "tst_monitor.moc"
