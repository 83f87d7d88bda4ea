// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "widgets/plot/curvechart.h"
#include "widgets/plot/iterationchart.h"
#include "widgets/plot/plotlegend.h"
#include "widgets/plot/plotview.h"

#include <QFontMetricsF>
#include <QGraphicsTextItem>
#include <QSignalSpy>
#include <QTest>

#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRate = 100.0;

// Where nothing lies over anything else, and all of it inside.
bool isTidy(const PlotLegend &legend, const QStringList &names, const QRectF &room)
{
    const auto &placed = legend.placed();
    if (placed.size() != names.size())
        return false;
    for (qsizetype i = 0; i < placed.size(); ++i) {
        if (placed[i].text.isEmpty() || !room.contains(placed[i].box))
            return false;
        for (qsizetype other = 0; other < i; ++other) {
            if (placed[i].box.intersects(placed[other].box))
                return false;
        }
    }
    return true;
}

constexpr std::array<ChannelSpec, 3> kChannels{{
    {.key = "a", .label = "Fehler der Kamera, Rollen", .group = "", .unit = "°", .axis = Axis::Roll},
    {.key = "b", .label = "Fehler der Kamera, Nicken", .group = "", .unit = "°", .axis = Axis::Pitch},
    {.key = "c", .label = "Fehler der Kamera, Gieren", .group = "", .unit = "°", .axis = Axis::Yaw},
}};

/// The words in the chart's own pictures, such as its scales' labels, that are really seen.
QStringList seenIn(const QChartView &view)
{
    QStringList texts;
    const auto items = view.scene()->items();
    for (const QGraphicsItem *item : items) {
        const auto *label = qgraphicsitem_cast<const QGraphicsTextItem *>(item);
        if (label && label->isVisible() && view.sceneRect().contains(label->sceneBoundingRect().center()))
            texts.append(label->toPlainText());
    }
    return texts;
}

/// A plot of three channels, the last ten seconds of which follow a function.
struct Bench
{
    explicit Bench(const std::function<double(double)> &signal, double total = 12.0)
    {
        theme.apply();
        auto group = store->defineGroup({0, 1, 2}, 1.0 / kRate);
        for (int i = 0; i < int(total * kRate); ++i) {
            const double time = i / kRate;
            const auto value = float(signal(total - time));
            const std::array<float, 3> row{value, -value, value / 2};
            store->append(*group, store->origin() + durationFromSeconds(time), row);
        }
        view.setCurves(kChannels, {{0, -1, {}}, {1, -1, {}}, {2, -1, {}}}, store);
        view.setWindow(10);
        view.resize(560, 200);
        view.show();
    }

    Theme theme;
    std::shared_ptr<TelemetryStore> store = std::make_shared<TelemetryStore>(3);
    PlotView view{theme};
};

}  // namespace

/// Plots without a program around them: legends, labels, scales.
class TestPlots : public QObject
{
    Q_OBJECT
private slots:
    void legendHoldsEveryName_data();
    void legendHoldsEveryName();
    void legendOfALivePlot_data();
    void legendOfALivePlot();
    void legendHidesATrace();
    void legendOfACurveChart();
    void legendOfManyIterations();
    void transientDoesNotFlatten();
    void stepStaysInSight();
    void heldPlotShowsAll();
    void allPeaksAreLabelled();
    void scalesKeepTheirLabels();
    void lowPlotsHaveFewerLabelsInFull_data();
    void lowPlotsHaveFewerLabelsInFull();
};

void TestPlots::lowPlotsHaveFewerLabelsInFull_data()
{
    QTest::addColumn<double>("size");
    QTest::addColumn<double>("middle");
    for (const double size : {0.07, 1.3, 90.0}) {
        for (const double middle : {0.0, 11.7, -300.0})
            QTest::addRow("%g around %g", size, middle) << size << middle;
    }
}

// Where an axis has no room for its labels, Qt writes dots in their place.
void TestPlots::lowPlotsHaveFewerLabelsInFull()
{
    QFETCH(const double, size);
    QFETCH(const double, middle);
    Bench bench([size, middle](double age) { return middle + size * std::sin(3 * age); });
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    for (const int height : {260, 150, 120, 111, 260}) {
        bench.view.resize(400, height);
        bench.view.autoScale();
        bench.view.advance();
        QCoreApplication::processEvents();
        const QStringList seen = seenIn(bench.view);
        QVERIFY2(seen.filter(u"..."_s).isEmpty() && seen.filter(u"…"_s).isEmpty(),
                 qPrintable(u"%1 px: %2"_s.arg(height).arg(seen.join(u"; "_s))));
        QVERIFY2(seen.size() >= 5, qPrintable(seen.join(u"; "_s)));
    }
}

void TestPlots::legendHoldsEveryName_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("width");
    for (const int count : {1, 3, 8}) {
        for (const int width : {160, 300, 440, 900})
            QTest::addRow("%d in %d", count, width) << count << width;
    }
}

void TestPlots::legendHoldsEveryName()
{
    QFETCH(int, count);
    QFETCH(int, width);
    PlotLegend legend;
    QList<PlotLegend::Entry> entries;
    QStringList names;
    for (int i = 0; i < count; ++i) {
        names.append(u"Winkelabweichung der Kamera vom Ziel, Achse %1"_s.arg(i));
        entries.append({names.last(), Qt::red});
    }
    legend.setEntries(entries);
    QFont font;
    const double height = legend.layOut(font, 70, 8, width, 3, 60);
    const QRectF room(70, 8, width + 0.01, height);
    const bool isNarrow = count == 8 && width == 160;  // not even the shortest names fit into three rows
    QVERIFY(isTidy(legend, names, room));
    QVERIFY(isNarrow || height <= 3 * (QFontMetricsF(font).height() + 2));
    for (const auto &placed : legend.placed())
        QVERIFY(QFontMetricsF(font).horizontalAdvance(placed.text) <= placed.box.width());
    // The first row leaves room for what stands beside it.
    QVERIFY(legend.placed().first().box.right() <= 70 + width - 60 + 0.01);
}

void TestPlots::legendOfALivePlot_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {360, 480, 560, 700, 1200})
        QTest::addRow("%d", width) << width;
}

// At 1024 pixels Tuning gives a plot 560; two of three German names were shown there.
void TestPlots::legendOfALivePlot()
{
    QFETCH(int, width);
    Bench bench([](double) { return 0.5; });
    bench.view.resize(width, 120);
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    QTRY_VERIFY(bench.view.advance() || !bench.view.accessibleDescription().isEmpty());
    QVERIFY(!bench.view.accessibleDescription().isEmpty());  // the rate beside the names
    const QRectF area = bench.view.chart()->plotArea();
    QStringList names;
    for (int i = 0; i < 3; ++i)
        names.append(bench.view.curveName(i));
    QVERIFY(isTidy(bench.view.legend(), names, {area.left() - 1, 0, width - area.left(), area.top()}));
    QVERIFY(area.height() > 40);
    if (width >= 560) {
        for (const auto &placed : bench.view.legend().placed())
            QVERIFY2(names.contains(placed.text), qPrintable(placed.text));
    }
}

void TestPlots::legendHidesATrace()
{
    Bench bench([](double) { return 0.5; });
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    bench.view.advance();
    const QColor before = bench.view.grab().toImage().pixelColor(
        bench.view.legend().placed()[1].box.topLeft().toPoint() + QPoint(4, 8));
    const QPoint name = bench.view.legend().placed()[1].box.center().toPoint();
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, name);
    const QColor after = bench.view.grab().toImage().pixelColor(
        bench.view.legend().placed()[1].box.topLeft().toPoint() + QPoint(4, 8));
    QVERIFY(before != after);
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, name);
    QCOMPARE(bench.view.grab().toImage().pixelColor(bench.view.legend().placed()[1].box.topLeft().toPoint()
                                                    + QPoint(4, 8)),
             before);
}

void TestPlots::legendOfACurveChart()
{
    Theme theme;
    theme.apply();
    CurveChart chart(theme, u"chart"_s);
    QList<ChartCurve> curves;
    QStringList names;
    for (int i = 0; i < 6; ++i) {
        names.append(u"Messung von heute, Achse Rollen, %1. Versuch"_s.arg(i));
        curves.append({names.last(), {{0, 0}, {1, 1}}, Axis::None, i, Qt::SolidLine, 1, 1});
    }
    curves.append({{}, {{0, 0}, {1, 1}}, Axis::None, 6, Qt::SolidLine, 1, 1});  // not in the legend
    chart.resize(520, 260);
    chart.setCurves(curves);
    chart.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chart));
    QVERIFY(isTidy(chart.legend(), names, {0, 0, 520, chart.chart()->plotArea().top()}));
}

void TestPlots::legendOfManyIterations()
{
    Theme theme;
    theme.apply();
    IterationChart chart(theme, u"gains"_s);
    QStringList names;
    for (const Axis axis : kAxes) {
        for (const char *gain : {"P", "I", "D"}) {
            names.append(u"%1, %2"_s.arg(QLatin1String(gain), QLatin1String(axisKey(axis))));
            chart.addPoint(names.last(), axis, 1, 1.0, Qt::SolidLine);
        }
    }
    chart.resize(300, 220);
    chart.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chart));
    QVERIFY(isTidy(chart.legend(), names, {0, chart.chart()->plotArea().bottom(), 300, 220}));
}

// A jolt 6 s ago, calm since: 0.05 is still to be seen.
void TestPlots::transientDoesNotFlatten()
{
    Bench bench([](double ago) {
        return ago > 6.0 && ago < 6.8 ? 10.0 * std::sin(20 * ago) : 0.05 * std::sin(9 * ago);
    });
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    bench.view.advance();
    const auto high = [&] {
        bench.view.autoScale();
        return bench.view.scale(0).high();
    };
    QTRY_VERIFY2(high() <= 0.25, qPrintable(QString::number(bench.view.scale(0).high())));
}

// It lasted: the camera was elsewhere before.
void TestPlots::stepStaysInSight()
{
    Bench bench([](double ago) { return ago > 5.0 ? 30.0 : 0.05 * std::sin(9 * ago); });
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    bench.view.advance();
    bench.view.autoScale();
    QVERIFY(bench.view.scale(0).high() >= 30.0 && bench.view.scale(0).low() <= -30.0);
}

void TestPlots::heldPlotShowsAll()
{
    Bench bench([](double ago) {
        return ago > 6.0 && ago < 6.8 ? 10.0 * std::sin(20 * ago) : 0.05 * std::sin(9 * ago);
    });
    QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
    bench.view.hold(11.9);
    bench.view.autoScale();
    QVERIFY(bench.view.scale(0).high() >= 9.0);
}

void TestPlots::allPeaksAreLabelled()
{
    Theme theme;
    theme.apply();
    CurveChart chart(theme, u"spectrum"_s);
    chart.setScales({{}, 1, 600, true, u"%g Hz"_s}, {{}, -60, 0, false, u"%.0f"_s, 3});
    chart.setCurves({{u"Roll"_s, {{1, -40}, {600, -40}}, Axis::Roll}});
    const QList<ChartLabel> labels{{{45.9, -10}, u"45.9 Hz"_s}, {{47.2, -30}, u"47.2 Hz"_s},
                                   {{50.3, -31}, u"50.3 Hz"_s}, {{51.8, -30}, u"51.8 Hz"_s},
                                   {{90.8, -50}, u"90.8 Hz"_s}, {{93.0, -50}, u"93.0 Hz"_s}};
    chart.setLabels(labels);
    chart.resize(700, 240);
    chart.show();
    QVERIFY(QTest::qWaitForWindowExposed(&chart));
    const QList<QRectF> boxes = chart.labelBoxes();
    QCOMPARE(boxes.size(), labels.size());
    for (qsizetype i = 0; i < boxes.size(); ++i) {
        QVERIFY2(chart.chart()->plotArea().contains(boxes[i]), qPrintable(labels[i].text));
        for (qsizetype other = 0; other < i; ++other)
            QVERIFY2(!boxes[i].intersects(boxes[other]), qPrintable(labels[i].text));
    }
}

void TestPlots::scalesKeepTheirLabels()
{
    Theme theme;
    theme.apply();
    CurveChart curves(theme, u"curves"_s);
    curves.setScales({{}, 1, 600, true, u"%g Hz"_s}, {{}, -60, 0, false, u"%.0f"_s, 3});
    curves.setCurves({{u"Roll"_s, {{1, -40}, {600, -40}}, Axis::Roll}});
    IterationChart steps(theme, u"gains"_s);
    steps.addPoint(u"P, Roll"_s, Axis::Roll, 4, 40.0, Qt::SolidLine);
    IterationChart empty(theme, u"gains"_s);
    for (QChartView *view : QList<QChartView *>{&curves, &steps, &empty}) {
        view->resize(500, 200);
        view->show();
        QVERIFY(QTest::qWaitForWindowExposed(view));
        const QStringList wanted = view == &curves ? QStringList{u"1 Hz"_s, u"100 Hz"_s, u"-60"_s, u"-20"_s}
            : view == &steps                       ? QStringList{u"0"_s, u"4"_s, u"40"_s}
                                                   : QStringList{u"0"_s, u"2"_s, u"3"_s, u"5"_s};
        for (const QSize &size : {QSize(500, 200), QSize(900, 420), QSize(460, 170)}) {
            view->resize(size);
            QCoreApplication::processEvents();
            for (const QString &text : wanted)
                QVERIFY2(seenIn(*view).contains(text),
                         qPrintable(text + u" is not in "_s + seenIn(*view).join(u' ')));
        }
    }
}

QTEST_MAIN(TestPlots)
#include "tst_plots.moc"
