// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/allocationcount.h"
#include "tests/support/patience.h"
#include "widgets/plot/plotstack.h"
#include "widgets/plot/plotview.h"

#include <QChartView>
#include <QPainter>
#include <QTest>

#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRate = 1250.0;
constexpr int kSeries = 6;
// clang-format off
constexpr std::array<ChannelSpec, kSeries> kChannels{{
    {"a", "a", "bench", "", 0, Axis::None, -1, 1},
    {"b", "b", "bench", "", 0, Axis::None, -1, 1},
    {"c", "c", "bench", "", 0, Axis::None, -1, 1},
    {"d", "d", "bench", "", 0, Axis::None, -1, 1},
    {"e", "e", "bench", "", 0, Axis::None, -1, 1},
    {"f", "f", "bench", "", 0, Axis::None, -1, 1},
}};
// clang-format on

/// A plot and the board behind it.
struct Rig
{
    explicit Rig(double window, int series = kSeries)
        : store(std::make_shared<TelemetryStore>(kSeries))
        , group(store->defineGroup({0, 1, 2, 3, 4, 5}, 1.0 / kRate))
        , view(theme)
    {
        QList<int> channels;
        for (int i = 0; i < series; ++i)
            channels.append(i);
        view.resize(900, 400);
        view.setWindow(window);
        view.setChannels(kChannels, channels, store);
    }
    bool show()
    {
        view.show();
        return QTest::qWaitForWindowExposed(&view);
    }
    void feed(int rows)
    {
        for (int i = 0; i < rows; ++i, ++next) {
            std::array<float, kSeries> row{};
            for (int s = 0; s < kSeries; ++s)
                row[std::size_t(s)] = value(s);
            store->append(*group, store->origin() + durationFromSeconds(double(next) / kRate), row);
        }
    }
    // Each second holds the whole range of values, so that no scale changes on the way.
    [[nodiscard]] float value(int series) const
    {
        return steady
            ? *steady
            : float(series + std::sin(double(next) * 0.02 * (series + 1)) + 0.2 * std::sin(double(next)));
    }
    [[nodiscard]] QImage picture()
    {
        return view.viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    // The plot area in the picture.
    [[nodiscard]] QRect pixels() const
    {
        const QRectF area = view.chart()->plotArea();
        const double ratio = view.devicePixelRatioF();
        return QRectF(area.topLeft() * ratio, area.size() * ratio).toRect();
    }

    Theme theme;
    std::shared_ptr<TelemetryStore> store;
    std::shared_ptr<TelemetryGroup> group;
    PlotView view;
    std::optional<float> steady;
    qint64 next = 0;
};

/// What Qt itself takes for a frame of one image.
class Plain final : public QChartView
{
public:
    QImage image{900, 400, QImage::Format_RGB32};

protected:
    void paintEvent(QPaintEvent *) override { QPainter(viewport()).drawImage(0, 0, image); }
};

// The usual number of allocations of one frame.
template <typename Frame> long allocationsOf(Frame frame)
{
    std::array<long, 41> counts{};
    for (int i = 0; i < 20; ++i)
        frame();
    for (long &count : counts) {
        const long before = AllocationCount::now();
        frame();
        count = AllocationCount::now() - before;
    }
    std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
    return counts[counts.size() / 2];
}

}  // namespace

/// One frame of a live plot: what it costs and what it shows.
class TestPlotFrame : public QObject
{
    Q_OBJECT
private slots:
    void allocationsAreCounted();
    void liveFrameAllocatesNothing_data();
    void liveFrameAllocatesNothing();
    void scrolledPictureIsTheOneDrawnAtOnce_data();
    void scrolledPictureIsTheOneDrawnAtOnce();
    void tracesPassOverTheGrid();
    void themeReachesTheWholePicture();
    void hiddenPlotsDoNothing();
};

void TestPlotFrame::allocationsAreCounted()
{
    const long before = AllocationCount::now();
    auto *number = new int(3);
    QList<int> list(100);
    QVERIFY(AllocationCount::now() - before >= 2);
    list[0] = *number;
    delete number;
    QCOMPARE(list.first(), 3);
}

void TestPlotFrame::liveFrameAllocatesNothing_data()
{
    QTest::addColumn<double>("window");
    QTest::newRow("1 s") << 1.0;
    QTest::newRow("10 s") << 10.0;
    QTest::newRow("600 s") << 600.0;
}

// Besides what Qt takes for painting any picture at all.
void TestPlotFrame::liveFrameAllocatesNothing()
{
    QFETCH(double, window);
    Plain plain;
    plain.resize(900, 400);
    plain.setFrameShape(QFrame::NoFrame);
    plain.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plain));
    const long floor = allocationsOf([&] {
        plain.viewport()->update(QRect(76, 34, 800, 300));
        plain.viewport()->repaint();
    });
    plain.hide();

    Rig rig(window);
    rig.feed(int(window * kRate) + 100);
    QVERIFY(rig.show());
    QVERIFY(rig.view.advance());
    PlotMarks marks;
    marks.add({rig.view.endTime() - 0.3 * window, PlotMark::Kind::Change, u"something"_s});
    marks.add({rig.view.endTime() - 0.5 * window, PlotMark::Kind::Fault, u"something else"_s});
    rig.view.setMarks(&marks);
    long advancing = 0;
    const long whole = allocationsOf([&] {
        const long feeding = AllocationCount::now();
        rig.feed(21);
        AllocationCount::counter() = feeding;  // the store grows, which is not the plot's
        const long before = AllocationCount::now();
        rig.view.advance();
        advancing = AllocationCount::now() - before;
        rig.view.viewport()->repaint();
    });
    QVERIFY2(
        whole <= floor,
        qPrintable(u"%1 allocations in a frame, %2 of them before painting; Qt alone takes %3"_s.arg(whole)
                       .arg(advancing)
                       .arg(floor)));
}

void TestPlotFrame::scrolledPictureIsTheOneDrawnAtOnce_data()
{
    QTest::addColumn<double>("window");
    QTest::addColumn<int>("rows");
    QTest::newRow("many columns a frame") << 1.0 << 21;
    QTest::newRow("several rows a column") << 20.0 << 21;
    QTest::newRow("a turn of the ring and more") << 2.0 << 400;
}

void TestPlotFrame::scrolledPictureIsTheOneDrawnAtOnce()
{
    QFETCH(double, window);
    QFETCH(int, rows);
    Rig rig(window, 2);
    rig.feed(int(window * kRate) + 5);
    QVERIFY(rig.show());
    for (int i = 0; i < 50; ++i) {
        rig.view.advance();
        rig.feed(rows);
    }
    rig.view.advance();
    const QImage scrolled = rig.picture().copy(rig.pixels());
    // The same range of values and the same time, built from nothing.
    rig.view.resize(901, 400);
    rig.view.resize(900, 400);
    rig.view.advance();
    QCOMPARE(scrolled, rig.picture().copy(rig.pixels()));
    QVERIFY(!scrolled.allGray());  // there is something in it
}

void TestPlotFrame::tracesPassOverTheGrid()
{
    Rig rig(4, 1);
    rig.steady = 1.3F;
    rig.feed(6000);
    QVERIFY(rig.show());
    rig.view.advance();
    const QImage picture = rig.picture();
    const double ratio = rig.view.devicePixelRatioF();
    const QRect pixels = rig.pixels();
    const QRgb trace = rig.view.curveColor(0).rgb();
    const QRgb grid = rig.theme.color(ColorRole::SurfaceRaised).rgb();
    const QRgb surface = rig.theme.color(ColorRole::Surface).rgb();
    int row = -1;
    for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
        if (picture.pixel(pixels.center().x() + 7, y) == trace)
            row = y;
    }
    QVERIFY(row > 0);
    for (int x = pixels.left(); x <= pixels.right(); ++x)
        QCOMPARE(picture.pixel(x, row), trace);  // unbroken where the grid's lines stand
    int lines = 0;
    int between = 0;
    for (int x = pixels.left(); x <= pixels.right(); ++x) {
        const QRgb pixel = picture.pixel(x, row - int(12 * ratio));
        lines += pixel == grid;
        between += pixel == surface;
    }
    QCOMPARE(lines + between, pixels.width());
    QCOMPARE(lines, ratio < 2 ? 5 : 10);  // of two pixels each at 200 %, half of the outer ones is outside
}

void TestPlotFrame::themeReachesTheWholePicture()
{
    Rig rig(4, 2);
    rig.feed(6000);
    rig.theme.setMode(Theme::Mode::Light);
    QVERIFY(rig.show());
    rig.view.advance();
    const QImage light = rig.picture().copy(rig.pixels());
    rig.theme.setMode(Theme::Mode::Dark);
    rig.view.advance();
    const QImage dark = rig.picture().copy(rig.pixels());
    for (int y = 0; y < dark.height(); ++y) {
        for (int x = 0; x < dark.width(); ++x)
            QVERIFY(dark.pixel(x, y) != light.pixel(x, y));
    }
}

// A plot that is not to be seen, or in a minimised window, takes no notice of its data; shown again it is up
// to date.
void TestPlotFrame::hiddenPlotsDoNothing()
{
    const Theme theme;
    Rig rig(2);
    const auto make = [&] {
        auto stack = std::make_unique<PlotStack>(theme);
        stack->setSource(kChannels, rig.store);
        stack->setPlots({{{0, 1}, false, false}});
        stack->resize(600, 300);
        stack->show();
        return stack;
    };
    const auto seen = make();
    const auto hidden = make();
    const auto minimised = make();
    QVERIFY(QTest::qWaitForWindowExposed(seen.get()));
    const auto end
        = [](const std::unique_ptr<PlotStack> &stack) { return stack->panels()[0]->view()->endTime(); };
    // The clock of the one that is seen tells that time enough has gone by for the others.
    const auto live = [&](double seconds) {
        const double until = end(seen) + seconds;
        return QTest::qWaitFor(
            [&] {
                rig.feed(50);
                return end(seen) > until;
            },
            kPatience);
    };
    QVERIFY(live(1.0));
    QTRY_VERIFY(end(hidden) > 0 && end(minimised) > 0);
    hidden->hide();
    minimised->showMinimized();
    QTRY_VERIFY(minimised->isMinimized());
    const double before = end(hidden);
    const double alsoBefore = end(minimised);
    QVERIFY(live(3.0));
    QCOMPARE(end(hidden), before);
    QCOMPARE(end(minimised), alsoBefore);
    hidden->show();
    QVERIFY(live(0.5));
    QTRY_VERIFY(end(hidden) > before + 3.0);
}

QTEST_MAIN(TestPlotFrame)
#include "tst_plotframe.moc"
