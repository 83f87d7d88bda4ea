// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.h"
#include "widgets/plot/plotclock.h"
#include "widgets/plot/plotview.h"

#include <QApplication>
#include <QChart>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QLineSeries>
#include <QPainter>
#include <QProcess>
#include <QTimer>
#include <QValueAxis>

#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxSeries = 24;
constexpr double kRate = 1250.0;
constexpr int kFrames = 60;
constexpr int kColumns = 1200;

const std::array<ChannelSpec, kMaxSeries> &table()
{
    static const std::array<ChannelSpec, kMaxSeries> specs = [] {
        std::array<ChannelSpec, kMaxSeries> made;
        made.fill({"bench", "bench", "bench", "", 0, Axis::None, -1, 1});
        return made;
    }();
    return specs;
}

/// A store that is filled as a board would.
struct Feed
{
    explicit Feed(int series, double seconds)
        : store(std::make_shared<TelemetryStore>(series))
        , count(series)
    {
        QList<int> channels;
        for (int i = 0; i < series; ++i)
            channels.append(i);
        group = store->defineGroup(channels, 1.0 / kRate);
        run(int(seconds * kRate));
    }
    void run(int rows)
    {
        std::array<float, kMaxSeries> row{};
        for (int i = 0; i < rows; ++i, ++next) {
            for (int s = 0; s < count; ++s)
                row[std::size_t(s)]
                    = float(s + std::sin(double(next) * 0.003 * (s + 1)) + 0.1 * std::sin(double(next)));
            store->append(*group, store->origin() + durationFromSeconds(double(next) / kRate),
                          std::span(row).first(std::size_t(count)));
        }
    }
    [[nodiscard]] double now() const { return double(next) / kRate; }
    std::shared_ptr<TelemetryStore> store;
    std::shared_ptr<TelemetryGroup> group;
    int count;
    qint64 next = 0;
};

void expose()
{
    // Nothing is painted before the windows are exposed.
    for (int i = 0; i < 50; ++i)
        QApplication::processEvents(QEventLoop::AllEvents, 10);
}

/// Our plot on its feed.
struct Ours
{
    Ours(int series, double window)
        : feed(series, window)
        , view(theme)
    {
        QList<int> channels;
        for (int i = 0; i < series; ++i)
            channels.append(i);
        view.resize(1280, 720);
        view.setWindow(window);
        view.setChannels(table(), channels, feed.store);
        view.show();
    }
    // Processor time of one frame: 21 new samples each.
    double frame()
    {
        const double before = processMs();
        view.advance();
        view.viewport()->repaint();
        const double spent = processMs() - before;
        feed.run(21);
        return spent;
    }
    Theme theme;
    Feed feed;
    PlotView view;
};

/// The better of the plain ways: QLineSeries.replace with two points a pixel, and setRange.
struct Plain
{
    explicit Plain(int series)
    {
        view.resize(1280, 720);
        view.chart()->addAxis(x, Qt::AlignBottom);
        view.chart()->addAxis(y, Qt::AlignLeft);
        y->setRange(-1, series + 1);
        for (int i = 0; i < series; ++i) {
            auto *line = new QLineSeries(&view);
            view.chart()->addSeries(line);
            line->attachAxis(x);
            line->attachAxis(y);
            lines.append(line);
        }
        view.show();
    }
    double frame(double now, double window)
    {
        const double before = processMs();
        for (qsizetype i = 0; i < lines.size(); ++i) {
            QList<QPointF> points;
            points.reserve(2 * kColumns);
            for (int column = 0; column < kColumns; ++column) {
                const double time = now - window + window * column / kColumns;
                const double value = double(i) + std::sin(time * kRate * 0.003 * double(i + 1));
                points.append({time, value - 0.1});
                points.append({time, value + 0.1});
            }
            lines[i]->replace(points);
        }
        x->setRange(now - window, now);
        view.viewport()->repaint();
        return processMs() - before;
    }
    QChartView view;
    QValueAxis *x = new QValueAxis(&view);
    QValueAxis *y = new QValueAxis(&view);
    QList<QLineSeries *> lines;
};

double costOf(Ours &ours)
{
    std::vector<double> ms;
    for (int frame = 0; frame < kFrames + 10; ++frame) {
        const double spent = ours.frame();
        if (frame >= 10)
            ms.push_back(spent);
    }
    return median(ms);
}

/// A window that only fills itself: what showing 60 pictures a second costs at the least.
class Filled final : public QWidget
{
protected:
    void paintEvent(QPaintEvent *) override { QPainter(this).fillRect(rect(), Qt::white); }
};

/// Share of a core, in percent, that a window takes which only fills itself.
double fillingShare()
{
    constexpr int kMs = 3000;
    Filled window;
    window.resize(1280, 720);
    window.show();
    expose();
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, &window, qOverload<>(&QWidget::update));
    timer.start(16);
    const double before = processMs();
    waitFor(kMs);
    return (processMs() - before) / kMs * 100.0;
}

}  // namespace

/// P1-P3: cost of a frame against QLineSeries, against a longer window, against more series.
void benchPlots(Report &report)
{
    std::array<double, 2> cost{};
    int at = 0;
    for (const double window : {10.0, 600.0}) {
        Ours ours(12, window);
        Plain plain(12);
        expose();
        std::vector<double> mine;
        std::vector<double> theirs;
        for (int frame = 0; frame < kFrames + 10; ++frame) {
            const double spent = ours.frame();
            const double other = plain.frame(ours.feed.now(), window);
            if (frame < 10)
                continue;
            mine.push_back(spent);
            theirs.push_back(other);
        }
        cost[std::size_t(at)] = median(mine);
        report.atMost(u"P1"_s, u"our plot / QLineSeries.replace, 12 series, %1 s"_s.arg(window),
                      median(mine) / median(theirs), 0.05, {},
                      u"%1 and %2 ms a frame"_s.arg(median(mine), 0, 'f', 2).arg(median(theirs), 0, 'f', 1));
        ++at;
    }
    report.atMost(u"P2"_s, u"our plot, 600 s / 10 s"_s, cost[1] / cost[0], 1.5, {},
                  u"%1 ms at 10 s"_s.arg(cost[0], 0, 'f', 2));
    std::array<double, 2> bySeries{};
    at = 0;
    for (const int series : {6, 24}) {
        Ours ours(series, 10);
        expose();
        bySeries[std::size_t(at++)] = costOf(ours);
    }
    report.atMost(u"P3"_s, u"our plot, 24 / 6 series"_s, bySeries[1] / bySeries[0], 2, {},
                  u"%1 ms with 6"_s.arg(bySeries[0], 0, 'f', 2));
}

/// P4: frames a second and share of a core, 12 series, beside a window that only fills itself.
void benchPacedPlots(Report &report)
{
    constexpr int kMs = 10000;
    const double scale = qApp->devicePixelRatio();
    const QString at = scale > 1 ? u", at %1 %"_s.arg(scale * 100) : QString();
    const double floor = fillingShare();
    struct Case
    {
        double window;
        bool every;  // each picture, also where the window moves by less than a pixel from one to the next
    };
    for (const Case &each : {Case{1, false}, Case{10, false}, Case{600, true}, Case{600, false}}) {
        const auto window = each.window;
        const bool every = each.every;
        Ours ours(12, window);
        expose();
        // Samples come as from a link, many times a second.
        QTimer feeding;
        feeding.setTimerType(Qt::PreciseTimer);
        double fed = 0;
        QElapsedTimer clock;
        QObject::connect(&feeding, &QTimer::timeout, &feeding, [&] {
            const double due = double(clock.nsecsElapsed()) * 1e-9 * kRate;
            const double cost = processMs();
            ours.feed.run(int(due) - int(ours.feed.next - qint64(window * kRate)));
            fed += processMs() - cost;
        });
        PaintCounter paints;
        ours.view.viewport()->installEventFilter(&paints);
        PlotClock pace;
        QTimer sixty;
        sixty.setTimerType(Qt::PreciseTimer);
        QObject::connect(&sixty, &QTimer::timeout, &ours.view, [&] { ours.view.advance(); });
        clock.start();
        feeding.start(4);
        if (every) {
            sixty.start(16);
        } else {
            pace.setPlots({&ours.view});
            pace.start();
        }
        const double before = processMs();
        waitFor(kMs);
        const double share = (processMs() - before - fed) / kMs * 100.0;
        const double perSecond = paints.count * 1000.0 / kMs;
        // Left to itself, a window of ten minutes is painted ten times a second: it moves by two pixels.
        const int useful = ours.view.usefulRate();
        const QString what
            = u"12 series, %1 s%2%3"_s.arg(window).arg(every ? u", each picture painted"_s : QString(), at);
        report.atLeast(u"P4"_s, u"frames/s, "_s + what, perSecond,
                       every || useful >= 60 ? 58.0 : useful * 58.0 / 60.0, u"/s"_s,
                       u"%1/s are of use"_s.arg(useful));
        const QString filling = u"filling alone takes %1 %"_s.arg(floor, 0, 'f', 1);
        if (scale > 1)  // the goal is for 1280x720 pixels
            report.tell(u"share of a core, "_s + what, u"%1 %"_s.arg(share, 0, 'f', 1), filling);
        else
            report.atMost(u"P4"_s, u"share of a core, "_s + what, share, 10, u"%"_s, filling);
    }
    if (scale > 1)
        return;
    // The same at 200 %, which a program is told before it starts.
    QProcess twice;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_SCALE_FACTOR"_s, u"2"_s);
    twice.setProcessEnvironment(environment);
    twice.start(QCoreApplication::applicationFilePath(), {u"--only"_s, u"paced"_s, u"--rows"_s});
    twice.waitForFinished(120'000);
    report.takeRows(twice.readAllStandardOutput());
}
