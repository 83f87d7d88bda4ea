// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/pages/watch/streamsdialog.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/device/steering.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/transport/replay.h"
#include "tests/support/loopmath.h"
#include "tests/support/measure.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/curvechart.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/plot/waterfallview.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardItemModel>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// The range of a value axis stays where it is, whatever there is to be seen.
bool standsStill(ValueScale scale)
{
    return !scale.fit(-1e6, 1e6);
}

}  // namespace

/// The plot as an instrument, streams by hand, tests that move an axis, and recordings that are steered.
class TestTelemetry : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void plotsTakeAnyChannels();
    void ownScalesForEachChannel();
    void figuresAreThoseOfTheVisibleSpan();
    void differencesBoxesAndKeys();
    void eventsAreMarked();
    void layoutsAreKeptByName();
    void pictureIsWhatIsSeen();
    void streamsByHand();
    void streamsThatDoNotFitAreNotOffered();
    void heldSpanIsMeasuredOnTheSpectrum();
    void waterfallShowsWhatRings();
    void stepTestFindsWhatThePlantDoes();
    void ownMotionIsMeasured();
    void testsAreGuarded();
    void divergenceSwitchesTheMotorsOff();
    void responsesAreExchangedAsText();
    void recordingIsPausedAndGoneThrough();

private:
    int channel(const char *key)
    {
        return findChannel(m_rig->client().device()->channels(), QString::fromLatin1(key));
    }
    PlotView *plot(int index) { return m_rig->page<MonitorPage>()->plots()[index]; }
    void drop(PlotView *view, const QList<int> &channels);
    QPoint at(PlotView *view, double share, double height);
    void waitForSamples(quint64 rows = 1500) { QTRY_VERIFY(m_rig->client().telemetry()->rows() > rows); }
    // The camera is held, and telemetry tells so.
    void waitForMotors()
    {
        QTRY_VERIFY(m_rig->workspace().motorsRunning() == std::optional(true));
        QTRY_VERIFY(!std::isnan(m_rig->workspace().latest(channel("target.angle.yaw"))));
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestTelemetry::drop(PlotView *view, const QList<int> &channels)
{
    QStringList numbers;
    for (const int each : channels)
        numbers.append(QString::number(each));
    QMimeData data;
    data.setData(ChannelModel::kMimeType, numbers.join(u',').toLatin1());
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view->viewport(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view->viewport(), &event);
}

// A point of the plot area, as shares of its width and height.
QPoint TestTelemetry::at(PlotView *view, double share, double height)
{
    const QRectF area = view->chart()->plotArea();
    return QPointF(area.left() + share * area.width(), area.top() + height * area.height()).toPoint();
}

void TestTelemetry::plotsTakeAnyChannels()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    QTRY_COMPARE(page->plots().size(), 2);
    // Dragged into the gyro plot: another unit, so another axis; ticked as well, and asked for.
    const int power = channel("power.roll");
    drop(plot(1), {power});
    QTRY_COMPARE(plot(1)->rightAxes(), 1);
    QVERIFY(page->channels().ticked().contains(power));
    QCOMPARE(plot(0)->chart()->plotArea().width(),
             plot(1)->chart()->plotArea().width());  // they still line up
    // The same channel in two plots, and rubbish is refused.
    drop(plot(0), {power, 9999, -1});
    QTRY_COMPARE(plot(0)->curves().size(), 4);
    // Unticked, it leaves both; the plots stay.
    QList<int> ticked = page->channels().ticked();
    ticked.removeAll(power);
    page->channels().setTicked(ticked);
    QTRY_COMPARE(plot(0)->curves().size(), 3);
    QCOMPARE(plot(1)->rightAxes(), 0);
    // By the menus: a new plot, a channel taken out, a plot removed.
    page->stack()->addChannels(-1, {power, channel("battery")});
    QCOMPARE(page->plots().size(), 3);
    emit page->stack()->panels()[2]->removeChannelRequested(power);
    QTRY_COMPARE(plot(2)->curves().size(), 1);
    emit page->stack()->panels()[2]->removeRequested();
    QTRY_COMPARE(page->plots().size(), 2);
    QVERIFY(!page->channels().ticked().contains(channel("battery")));
    QMenu *menu = page->stack()->panels()[0]->menu();
    emit menu->aboutToShow();
    QVERIFY(menu->actions().size() >= 8);
}

void TestTelemetry::ownScalesForEachChannel()
{
    QVERIFY(m_rig->open());
    m_rig->page<MonitorPage>();
    waitForSamples();
    QTRY_COMPARE(plot(1)->rightAxes(), 0);
    plot(1)->setOwnScales(true);
    QCOMPARE(plot(1)->rightAxes(), 2);
    QTRY_VERIFY(plot(1)->scale(0).low() != plot(1)->scale(1).low()
                || plot(1)->scale(0).high() != plot(1)->scale(1).high());
}

void TestTelemetry::figuresAreThoseOfTheVisibleSpan()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    waitForSamples(4000);
    PlotPanel *panel = page->stack()->panels()[1];
    page->stack()->setSeconds(2);
    page->pauseButton()->setChecked(true);
    panel->setFiguresVisible(true);
    const SpanStatistics wanted = spanStatistics(*m_rig->client().telemetry(), channel("gyro.roll"), -1,
                                                 plot(1)->startTime(), plot(1)->endTime());
    const auto number = [panel](int column) {
        return panel->figures()->item(0, column)->text().section(u' ', 0, 0).toDouble();
    };
    QVERIFY(std::abs(number(1) - wanted.mean) < 0.01);
    QVERIFY(std::abs(number(2) - wanted.rms) < 0.01);
    QVERIFY(number(3) > 0.0);
    QVERIFY(std::abs(number(4) - 1250.0) < 15.0);
}

void TestTelemetry::differencesBoxesAndKeys()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    waitForSamples(3000);
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    PlotView *view = plot(1);
    QTRY_VERIFY(view->accessibleDescription().contains(u"625"_s));
    // A click sets the line that differences count from, in all plots.
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at(view, 0.9, 0.5));
    QVERIFY(view->referenceTime() && plot(0)->referenceTime());
    QTest::mouseMove(view->viewport(), at(view, 0.95, 0.5));
    QTRY_VERIFY(view->cursorTime());
    QVERIFY2(view->cursorTexts().first().contains(u"Δ"_s), qPrintable(view->cursorTexts().first()));
    QVERIFY(std::abs((*view->cursorTime() - *view->referenceTime()) - 0.05 * page->window()) < 0.05);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at(view, 0.9, 0.3));  // on it: gone
    QVERIFY(!view->referenceTime());
    QTest::keyClick(view, Qt::Key_R);
    QVERIFY(view->referenceTime());
    QTest::keyClick(view, Qt::Key_R);
    QVERIFY(!view->referenceTime());
    // A box with Shift: its time and its values.
    const double seconds = page->window();
    const double end = view->endTime();
    QTest::mousePress(view->viewport(), Qt::LeftButton, Qt::ShiftModifier, at(view, 0.8, 0.25));
    QTest::mouseMove(view->viewport(), at(view, 0.85, 0.4));
    QTest::mouseRelease(view->viewport(), Qt::LeftButton, Qt::ShiftModifier, at(view, 0.9, 0.5));
    QVERIFY(std::abs(page->window() - 0.1 * seconds) < 0.02 * seconds);
    QVERIFY(std::abs(view->endTime() - (end - 0.1 * seconds)) < 0.02 * seconds);
    QVERIFY(standsStill(view->scale(0)));
    QVERIFY(page->pauseButton()->isChecked());
    QTest::keyClick(view, Qt::Key_A);
    QVERIFY(!standsStill(view->scale(0)));
    // A box drawn by accident changes nothing.
    QTest::mousePress(view->viewport(), Qt::LeftButton, Qt::ShiftModifier, at(view, 0.5, 0.5));
    QTest::mouseRelease(view->viewport(), Qt::LeftButton, Qt::ShiftModifier,
                        at(view, 0.5, 0.5) + QPoint(2, 2));
    QVERIFY(!standsStill(view->scale(0)));
}

void TestTelemetry::eventsAreMarked()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    waitForSamples();
    const PlotMarks &marks = m_rig->workspace().marks();
    const auto marked = [&marks](const QString &text) {
        return std::any_of(marks.all().begin(), marks.all().end(),
                           [&](const PlotMark &mark) { return mark.text.contains(text); });
    };
    QTRY_VERIFY(!m_rig->workspace().live().parameters().isEmpty()
                && m_rig->workspace().live().value(m_rig->spec(u"pid.roll.p"_s).id));
    m_rig->workspace().live().setValue(m_rig->spec(u"pid.roll.p"_s).id, 41);
    QTRY_VERIFY(marked(u"41"_s));
    m_rig->workspace().useProfile(2);
    QTRY_VERIFY(marked(u"Profile 3"_s));
    m_rig->edit(u"pid.roll.p"_s, 2, 50);
    m_rig->workspace().write(std::as_const(m_rig->model()).edited());
    QTRY_VERIFY(marked(u"written"_s));
    // A calibration is silence, not loss.
    const auto calibrated = m_rig->workspace().perform(u"calibrate.gyro"_s, {});
    QTRY_VERIFY(calibrated.isFinished());
    QVERIFY2(calibrated.result(), qPrintable(calibrated.result().error().detail));
    QTRY_VERIFY(marked(u"silent"_s));
    QCOMPARE(m_rig->client().telemetry()->lost(), quint64(0));
    m_rig->client().motorsOff();
    QTRY_VERIFY(marked(u"Motors"_s));
    // Ctrl and arrows go from event to event.
    QTest::mouseClick(page->pauseButton(), Qt::LeftButton);
    PlotView *view = plot(0);
    emit view->cursorMoved(view->endTime());
    const double before = *view->cursorTime();
    QTest::keyClick(view, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(*view->cursorTime() < before);
    QVERIFY(marks.near(*view->cursorTime(), 1e-9));
    // Times are in order.
    for (std::size_t i = 1; i < marks.all().size(); ++i)
        QVERIFY(marks.all()[i].time >= marks.all()[i - 1].time);
}

void TestTelemetry::layoutsAreKeptByName()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    page->stack()->addChannels(-1, {channel("battery"), channel("current")});
    page->stack()->setSeconds(30);
    page->saveLayout(u"Power / battery"_s);
    page->channels().setTicked({channel("gyro.yaw")});
    QTRY_COMPARE(page->plots().size(), 1);
    page->useLayout(u"Power / battery"_s);
    QCOMPARE(page->plots().size(), 3);
    QCOMPARE(plot(2)->curves().size(), 2);
    QCOMPARE(page->window(), 30.0);
    emit named<QPushButton>(page, u"Layout"_s)->menu()->aboutToShow();
    const auto isOffered = [page](const QString &name) {
        const QList<QAction *> actions = named<QPushButton>(page, u"Layout"_s)->menu()->actions();
        return std::any_of(actions.begin(), actions.end(),
                           [&](QAction *action) { return action->text() == name; });
    };
    QVERIFY(isOffered(u"Power / battery"_s));
    // The last arrangement and the kept one are there after a restart.
    m_rig->restart();
    QVERIFY(m_rig->open());
    page = m_rig->page<MonitorPage>();
    QCOMPARE(page->plots().size(), 3);
    QCOMPARE(m_rig->settings().plotLayouts(), QStringList{u"Power / battery"_s});
    m_rig->settings().setPlotLayout(u"Power / battery"_s, {});
    QVERIFY(m_rig->settings().plotLayouts().isEmpty());
    // A layout of another kind of board, or a damaged one, is told and harmless.
    m_rig->settings().setPlotLayout(u"foreign"_s,
                                    R"({"plots":[{"channels":["no.such"]},{"channels":7},5],"seconds":"x"})");
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::notice);
    page->useLayout(u"foreign"_s);
    QCOMPARE(told.count(), 1);
    QCOMPARE(page->plots().size(), 3);
}

void TestTelemetry::pictureIsWhatIsSeen()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    waitForSamples();
    const QString path = m_rig->filePath(u"plots.png"_s);
    QVERIFY(page->exportPicture(path));
    const QImage image(path);
    QCOMPARE(image.size(), page->stack()->size() * 2);
    // The traces are on it.
    const QColor wanted = plot(1)->curveColor(0);
    int found = 0;
    for (int y = image.height() / 2; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            found += image.pixelColor(x, y) == wanted;
    }
    QVERIFY2(found > 500, qPrintable(QString::number(found)));
    QVERIFY(!page->exportPicture(u"/no/such/folder/plots.png"_s));
}

void TestTelemetry::streamsByHand()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<MonitorPage>();
    QTRY_VERIFY(m_rig->client().telemetryPlan().rate == 1250.0);
    QTest::mouseClick(page->streamsButton(), Qt::LeftButton);
    auto *dialog = m_rig->window().findChild<StreamsDialog *>();
    QVERIFY(dialog);
    dialog->byHand()->setChecked(true);
    QVERIFY(!named<QPushButton>(dialog, u"Use"_s)->isEnabled());  // nothing is chosen
    dialog->check(u"realtime4"_s)->setChecked(true);
    dialog->rate(u"realtime4"_s)->setValue(200);
    dialog->check(u"custom"_s)->setChecked(true);
    dialog->rate(u"custom"_s)->setValue(500);
    QVERIFY(named<QPushButton>(dialog, u"Use"_s)->isEnabled());
    QVERIFY2(dialog->verdict()->text().contains(u"%"_s), qPrintable(dialog->verdict()->text()));
    QTest::mouseClick(named<QPushButton>(dialog, u"Use"_s), Qt::LeftButton);
    QTRY_COMPARE(m_rig->client().telemetryPlan().rate, 500.0);
    QCOMPARE(m_rig->client().telemetryPlan().budget.streams.size(), std::size_t(2));
    QTRY_VERIFY(plot(1)->accessibleDescription().contains(u"500"_s)
                && !plot(1)->accessibleDescription().contains(u"1250"_s));
    // What is ticked later joins the stream.
    page->channels().setTicked(page->channels().ticked() << channel("acc.x"));
    QTRY_VERIFY(m_rig->client().telemetryPlan().budget.streams[1].channels.contains(channel("acc.x")));
    m_rig->workspace().telemetry().setStreams({});
    QTRY_COMPARE(m_rig->client().telemetryPlan().rate, 1250.0);
}

void TestTelemetry::streamsThatDoNotFitAreNotOffered()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?rate=115200"_s));
    auto *page = m_rig->page<MonitorPage>();
    QTRY_VERIFY(m_rig->client().telemetryPlan().streaming);
    const double before = m_rig->client().telemetryPlan().rate;
    QTest::mouseClick(page->streamsButton(), Qt::LeftButton);
    auto *dialog = m_rig->window().findChild<StreamsDialog *>();
    dialog->byHand()->setChecked(true);
    dialog->check(u"realtime4"_s)->setChecked(true);
    dialog->rate(u"realtime4"_s)->setValue(200);
    QVERIFY(!named<QPushButton>(dialog, u"Use"_s)->isEnabled());
    QVERIFY2(dialog->verdict()->text().contains(u"11520"_s), qPrintable(dialog->verdict()->text()));
    dialog->rate(u"realtime4"_s)->setValue(0);  // as fast as possible always fits
    QVERIFY(named<QPushButton>(dialog, u"Use"_s)->isEnabled());
    dialog->reject();
    // The same by code: told with numbers, and what ran goes on.
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::problem);
    m_rig->workspace().telemetry().setStreams({{u"realtime4"_s, 200, {}}});
    QTRY_COMPARE(told.count(), 1);
    QCOMPARE(m_rig->client().telemetryPlan().rate, before);
    const quint64 rows = m_rig->client().telemetry()->rows();
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > rows + 100);
}

void TestTelemetry::heldSpanIsMeasuredOnTheSpectrum()
{
    QVERIFY(m_rig->open());
    auto *monitor = m_rig->page<MonitorPage>();
    waitForSamples(6000);
    monitor->stack()->setSeconds(3);
    monitor->pauseButton()->setChecked(true);
    auto *page = m_rig->page<SpectrumPage>();
    QCOMPARE(named<QComboBox>(page, u"Span"_s)->count(), 5);
    named<QComboBox>(page, u"Span"_s)->setCurrentIndex(4);
    emit named<QComboBox>(page, u"Span"_s)->activated(4);
    QCOMPARE(page->chart()->curves().size(), qsizetype(3));
    // Compared with another span, the earlier lines stay, faint.
    QTest::mouseClick(named<QPushButton>(page, u"Compare"_s), Qt::LeftButton);
    named<QComboBox>(page, u"Span"_s)->setCurrentIndex(0);
    emit named<QComboBox>(page, u"Span"_s)->activated(0);
    QCOMPARE(page->chart()->curves().size(), qsizetype(6));
    QVERIFY(page->chart()->curves().first().strength < 1.0);
    QVERIFY(page->bands()->item(1, 1)->text().contains(u'%'));
    // Running again, there is no such span.
    m_rig->page<MonitorPage>()->pauseButton()->setChecked(false);
    m_rig->page<SpectrumPage>();
    QCOMPARE(named<QComboBox>(page, u"Span"_s)->count(), 4);
    // The other ways to draw it.
    for (QAction *action : page->viewMenu()->actions()) {
        if (action->isCheckable() && !action->text().startsWith(u"Waterfall"_s))
            action->trigger();
    }
    QCOMPARE(page->chart()->yScale().low, 0.0);  // RMS of each line
    QVERIFY(!page->chart()->xScale().logarithmic);
    QVERIFY(page->chart()->xScale().high <= 625.0);
}

void TestTelemetry::waterfallShowsWhatRings()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<SpectrumPage>();
    waitForSamples(3000);
    for (QAction *action : page->viewMenu()->actions()) {
        if (action->text() == u"Waterfall, Roll"_s)
            action->trigger();
    }
    QTRY_VERIFY(page->waterfall()->columnCount() >= 3);
    QVERIFY(page->waterfall()->isVisible());
    // A tone stands in its row, and in no other.
    WaterfallView view(m_rig->theme());
    std::vector<float> samples(2048);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i]
            = float(std::sin(2.0 * std::numbers::pi * 80.0 * double(i) / 1250.0)) + 0.001F * float(i % 7);
    const auto tone = spectrum(samples, 1250, {1024, 0.5, WindowShape::Hann});
    QVERIFY(tone);
    for (int i = 0; i < WaterfallView::kColumns + 20; ++i)
        view.add(*tone);
    QCOMPARE(view.columnCount(), WaterfallView::kColumns);
    QVERIFY(view.level(0, 80) > view.level(0, 40) + 30);
    view.resize(700, 300);
    const QImage image = view.grab().toImage();
    QVERIFY(!image.isNull());
    view.setLogarithmic(false);
    QVERIFY(view.grab().toImage() != image);
}

void TestTelemetry::stepTestFindsWhatThePlantDoes()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ResponsePage>();
    waitForMotors();
    named<QComboBox>(page, u"Axis"_s)->setCurrentIndex(2);  // yaw has nothing that pulls it
    QVERIFY(!page->startButton()->isEnabled());
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(page->startButton()->isEnabled());
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(!page->startButton()->isEnabled());
    QVERIFY(measure(*page));
    const ResponseRecord &record = page->records().front();
    QCOMPARE(record.steps.runs.response.size(), std::size_t(6));
    AxisGains gains;
    const auto raw = [this](const char *key) { return double(m_rig->raw(QString::fromLatin1(key))); };
    gains.p = raw("pid.yaw.p");
    gains.i = raw("pid.yaw.i");
    gains.d = raw("pid.yaw.d");
    gains.dLpfHz = 200;
    const auto wanted
        = stepMetrics(LoopMath{simulatedMechanics(Axis::Yaw), gains}.step(1250, 0.95), 1250, 0, 1);
    QVERIFY(wanted && wanted->riseSeconds && record.steps.metrics.riseSeconds);
    qInfo("rise %.1f ms, mathematics %.1f ms; overshoot %.1f %%, mathematics %.1f %%",
          *record.steps.metrics.riseSeconds * 1000, *wanted->riseSeconds * 1000,
          record.steps.metrics.overshoot, wanted->overshoot);
    // The hand trembles and the joint has friction: a fifth of the time, ten points of overshoot.
    QVERIFY(std::abs(*record.steps.metrics.riseSeconds / *wanted->riseSeconds - 1.0) < 0.2);
    QVERIFY(std::abs(record.steps.metrics.overshoot - wanted->overshoot) < 10.0);
    QCOMPARE(page->table()->model()->rowCount(), 1);
    QVERIFY(!page->armButton()->isChecked());
    // A second one lies over the first; unticked, it goes.
    QVERIFY(measure(*page));
    const auto curves = named<CurveChart>(page, u"Step response"_s)->curves().size();
    auto *model = static_cast<QStandardItemModel *>(page->table()->model());
    model->item(1, 0)->setCheckState(Qt::Unchecked);
    QCOMPARE(named<CurveChart>(page, u"Step response"_s)->curves().size(), curves - 1);
    // The events stand in the plots.
    QVERIFY(m_rig->workspace().marks().all().size() >= 4);
    // They are this board's: on another one they are put aside, and named after it.
    model->item(1, 0)->setCheckState(Qt::Checked);
    const QString before = m_rig->client().identity().serial;
    m_rig->client().disconnectFromBoard();
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=7"_s));
    QVERIFY(m_rig->client().identity().serial != before);
    QVERIFY(named<CurveChart>(page, u"Step response"_s)->curves().isEmpty());
    QCOMPARE(page->records().size(), std::size_t(2));
    QVERIFY(page->records().front().name.contains(before));
}

void TestTelemetry::ownMotionIsMeasured()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ResponsePage>();
    waitForMotors();
    page->wayChoice()->setCurrentIndex(2);
    named<QComboBox>(page, u"Axis"_s)->setCurrentIndex(2);
    // Nothing was steered: nothing can be told, and that is said.
    waitForSamples(9000);
    named<QDoubleSpinBox>(page, u"Duration"_s)->setValue(6);
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QCOMPARE(told.count(), 1);
    QVERIFY(page->records().empty());
    // The operator sways the camera, as a hand controller would.
    const auto modes = m_rig->client().device()->steering()->modes();
    const auto mode = std::find_if(modes.begin(), modes.end(), [](const SteeringMode &each) {
        return each.isPositional() && each.find("speed") >= 0;
    });
    QTimer hand;
    QElapsedTimer clock;
    connect(&hand, &QTimer::timeout, this, [&] {
        // From 1 to 7 Hz in three seconds, over and over: whatever six seconds are measured, all of it is in
        // them.
        const double t = std::fmod(double(clock.elapsed()) / 1000.0, 3.0);
        SteeringSetpoint setpoint{mode->id, {0, 0, 0, 1000}, {}};
        setpoint.inputs[2] = 3.0 * std::sin(2.0 * std::numbers::pi * (1.0 + t) * t);
        m_rig->client().setControl(setpoint);
    });
    clock.start();
    hand.start(20);
    QTRY_VERIFY(clock.elapsed() > 7500);
    hand.stop();
    m_rig->client().releaseControl();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QCOMPARE(page->records().size(), std::size_t(1));
    const auto &margins = page->records().front().margins;
    QVERIFY(margins.phaseDeg);
    AxisGains gains;
    gains.p = m_rig->raw(u"pid.yaw.p"_s);
    gains.i = m_rig->raw(u"pid.yaw.i"_s);
    gains.d = m_rig->raw(u"pid.yaw.d"_s);
    gains.dLpfHz = 200;
    const Margins wanted
        = ::margins(LoopMath{simulatedMechanics(Axis::Yaw), gains}.openLoop(20), 0.7, 0.3, 20);
    QVERIFY2(std::abs(*margins.phaseDeg - *wanted.phaseDeg) < 12.0,
             qPrintable(u"%1, mathematics %2"_s.arg(*margins.phaseDeg).arg(*wanted.phaseDeg)));
}

void TestTelemetry::testsAreGuarded()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ResponsePage>();
    waitForMotors();
    // Leaving the page ends the test and disarms.
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(page->isRunning());
    m_rig->window().showPage(u"monitor"_s);
    QTRY_VERIFY(!page->isRunning());
    m_rig->page<ResponsePage>();
    QVERIFY(!page->armButton()->isChecked() && !page->startButton()->isEnabled());
    // "Motors off" ends it; without motors none begins.
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    m_rig->client().motorsOff();
    QTRY_VERIFY(!page->isRunning());
    QTRY_VERIFY(m_rig->workspace().motorsRunning() == std::optional(false));
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    // The worker refuses it.
    QTRY_COMPARE(told.count(), 1);
    QVERIFY(!page->isRunning());
    QVERIFY(page->records().empty());
    // A plan that asks too much is refused before anything moves.
    MotionTestPlan plan;
    plan.degrees = 30;
    QVERIFY(!plan.check());
    plan = {};
    plan.toHz = 45;
    QVERIFY(!plan.check());
    plan = {};
    QVERIFY(plan.check());
    QCOMPARE(plan.offsetAt(0.5), 0.0);
    QCOMPARE(plan.offsetAt(1.5), plan.degrees);
    QCOMPARE(plan.offsetAt(2.5), 0.0);
    plan.kind = MotionTestPlan::Kind::Sweep;
    for (double t = 0; t < plan.duration(); t += 0.01)
        QVERIFY(std::abs(plan.offsetAt(t)) <= plan.degrees);
}

void TestTelemetry::divergenceSwitchesTheMotorsOff()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ResponsePage>();
    waitForMotors();
    // A tight limit: the overshoot of a large step is beyond it.
    named<QDoubleSpinBox>(page, u"Movement"_s)->setValue(10);
    named<QDoubleSpinBox>(page, u"Stop beyond"_s)->setValue(0.5);
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(!page->isRunning());
    QTRY_COMPARE(told.count(), 1);
    QTRY_VERIFY(m_rig->workspace().motorsRunning() == std::optional(false));
    QVERIFY(page->records().empty());
}

void TestTelemetry::responsesAreExchangedAsText()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ResponsePage>();
    // A first-order lag of 50 ms as another tool may have measured it.
    const QString path = m_rig->filePath(u"lag.csv"_s);
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("in;out\n");
        double state = 0;
        unsigned noise = 1;
        double input = 0;
        for (int i = 0; i < 60000; ++i) {
            if (i % 20 == 0) {
                noise = noise * 1664525U + 1013904223U;
                input = double(noise >> 16) / 65536.0 - 0.5;
            }
            state += (input - state) * 0.0008 / 0.05;
            file.write(QByteArray::number(input) + ';' + QByteArray::number(state) + '\n');
        }
    }
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::notice);
    QVERIFY(page->importCsv(path));
    QCOMPARE(told.count(), 1);  // its rate was assumed
    QCOMPARE(page->records().size(), std::size_t(1));
    const ResponseRecord &record = page->records().front();
    QCOMPARE(record.name, u"lag"_s);
    const auto bin = std::size_t(std::lround(10.0 / record.closed.resolution));
    const double hz = record.closed.frequency(bin);
    QVERIFY(std::abs(record.closed.gainDb(bin)
                     + 10.0 * std::log10(1.0 + std::pow(2 * std::numbers::pi * hz * 0.05, 2)))
            < 0.7);
    QVERIFY(!named<CurveChart>(page, u"Gain"_s)->curves().isEmpty());
    // Out and in again: the same.
    const QString copy = m_rig->filePath(u"copy.csv"_s);
    QVERIFY(page->exportCsv(copy));
    QVERIFY(page->importCsv(copy));
    QCOMPARE(told.count(), 1);
    QCOMPARE(page->records().back().target, page->records().front().target);
    QCOMPARE(page->records().back().rate, 1250.0);
    // Files that are none.
    QVERIFY(!page->importCsv(u"/no/such/file"_s));
    QFile bad(m_rig->filePath(u"bad.csv"_s));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write("in;out\n1;2\n3;x\n");
    bad.close();
    QVERIFY(!page->importCsv(bad.fileName()));
    QVERIFY(page->importCsv(bad.fileName()).error().detail.contains(u"line 3"_s));
}

void TestTelemetry::recordingIsPausedAndGoneThrough()
{
    QVERIFY(m_rig->open());
    m_rig->page<MonitorPage>();
    const QString path = m_rig->filePath(u"seek.gimbalrec"_s);
    QSignalSpy finished(&m_rig->workspace().recorder(), &LinkRecorder::finished);
    waitForSamples(12000);
    QVERIFY(m_rig->workspace().recorder().savePast(path));
    QTRY_COMPARE(finished.count(), 1);
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->window().replayBar()->isVisible());
    QVERIFY(m_rig->open(u"replay:"_s + path));
    ReplayBar *bar = m_rig->window().replayBar();
    QTRY_VERIFY(bar->isVisible());
    waitForSamples(500);
    QTest::mouseClick(bar->pauseButton(), Qt::LeftButton);
    const auto state = [this] { return m_rig->client().replay().state().value_or(ReplayState()); };
    QTRY_VERIFY(state().paused);
    const quint64 rows = m_rig->client().telemetry()->rows();
    const double position = state().position;
    const double length = state().length;
    QVERIFY(length > 8.0);
    // Forward: what lies between is there at once, although it is paused.
    m_rig->client().replay().seek(position + 4.0);
    QTRY_VERIFY(state().position >= position + 3.9);
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > rows + 4500);
    QVERIFY(state().paused);
    QVERIFY(m_rig->client().telemetry()->lost() == 0);
    // Back: opened anew, with everything before that place, and still paused.
    m_rig->client().replay().seek(position + 1.0);
    QTRY_VERIFY(m_rig->client().isConnected() && state().paused
                && std::abs(state().position - position - 1.0) < 0.3);
    QTRY_VERIFY(m_rig->client().telemetry()->rows() > 1000);
    QVERIFY(m_rig->client().telemetry()->rows() < rows + 3500);
    // Faster, to the end, which is told.
    m_rig->client().replay().setSpeed(10);
    QTest::mouseClick(bar->pauseButton(), Qt::LeftButton);
    QTRY_VERIFY(state().hasEnded());
    QTRY_VERIFY2(bar->text().contains(u"the end"_s), qPrintable(bar->text()));
    QVERIFY(m_rig->client().isConnected());
    // The slider goes there as well, by keyboard too.
    bar->place()->setValue(10);
    QTRY_VERIFY(m_rig->client().isConnected() && !state().hasEnded() && state().position >= 0.9);
}

QTEST_MAIN(TestTelemetry)
#include "tst_telemetry.moc"
