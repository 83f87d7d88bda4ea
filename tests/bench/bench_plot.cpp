// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotview.h"

#include <QApplication>
#include <QChart>
#include <QEventLoop>
#include <QLineSeries>
#include <QTextStream>
#include <QValueAxis>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

namespace {

constexpr int kSeries = 12;
constexpr double kRate = 1250.0;
constexpr int kFrames = 60;

double cpuMs()
{
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::array<ChannelSpec, kSeries> makeTable()
{
    std::array<ChannelSpec, kSeries> table;
    for (ChannelSpec &spec : table)
        spec = {"bench", "bench", "bench", "", 0, Axis::None, -1, 1};
    return table;
}

struct Feed
{
    Feed() : store(std::make_shared<TelemetryStore>(kSeries))
    {
        QList<int> channels;
        for (int i = 0; i < kSeries; ++i)
            channels.append(i);
        group = store->defineGroup(channels, 1.0 / kRate);
    }
    void run(int rows)
    {
        std::array<float, kSeries> row{};
        for (int i = 0; i < rows; ++i, ++count) {
            for (int s = 0; s < kSeries; ++s)
                row[std::size_t(s)] = float(s + std::sin(double(count) * 0.003 * (s + 1)) + 0.1 * std::sin(double(count)));
            store->append(*group, store->origin() + durationFromSeconds(double(count) / kRate), row);
        }
    }
    std::shared_ptr<TelemetryStore> store;
    std::shared_ptr<TelemetryGroup> group;
    qint64 count = 0;
};

// CPU per frame of our plot: 20 new samples, advance, paint.
double ours(Feed &feed, PlotView &view)
{
    const double before = cpuMs();
    view.advance();
    view.viewport()->repaint();
    const double spent = cpuMs() - before;
    feed.run(21);
    return spent;
}

} // namespace

/// P1 and P2: our plot against QLineSeries.replace(min/max) and setRange, 12 series over 10 and 600 seconds.
int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    Theme theme;
    const auto table = makeTable();
    QTextStream out(stdout);
    std::array<double, 2> cost{};
    std::array<double, 2> baseline{};
    int at = 0;
    for (const double window : {10.0, 600.0}) {
        Feed feed;
        feed.run(int(window * kRate));
        PlotView view(theme);
        view.resize(1280, 720);
        view.setWindow(window);
        QList<int> channels;
        for (int i = 0; i < kSeries; ++i)
            channels.append(i);
        view.setChannels(table, channels, feed.store);
        view.show();
        QChartView plain;
        plain.resize(1280, 720);
        QList<QLineSeries *> lines;
        auto *x = new QValueAxis(&plain);
        auto *y = new QValueAxis(&plain);
        plain.chart()->addAxis(x, Qt::AlignBottom);
        plain.chart()->addAxis(y, Qt::AlignLeft);
        y->setRange(-1, kSeries + 1);
        for (int i = 0; i < kSeries; ++i) {
            auto *line = new QLineSeries(&plain);
            plain.chart()->addSeries(line);
            line->attachAxis(x);
            line->attachAxis(y);
            lines.append(line);
        }
        plain.show();
        // Nothing is painted before the windows are exposed.
        for (int i = 0; i < 50; ++i)
            QApplication::processEvents(QEventLoop::AllEvents, 10);
        std::vector<double> oursMs;
        std::vector<double> plainMs;
        for (int frame = 0; frame < kFrames + 10; ++frame) {
            const double mine = ours(feed, view);
            const double before = cpuMs();
            const double now = double(feed.count) / kRate;
            for (int i = 0; i < kSeries; ++i) {
                QList<QPointF> points;
                points.reserve(2400);
                for (int column = 0; column < 1200; ++column) {
                    const double time = now - window + window * column / 1200;
                    const double value = i + std::sin(time * kRate * 0.003 * (i + 1));
                    points.append({time, value - 0.1});
                    points.append({time, value + 0.1});
                }
                lines[i]->replace(points);
            }
            x->setRange(now - window, now);
            plain.viewport()->repaint();
            if (frame < 10)
                continue;
            oursMs.push_back(mine);
            plainMs.push_back(cpuMs() - before);
        }
        cost[std::size_t(at)] = median(oursMs);
        baseline[std::size_t(at)] = median(plainMs);
        out << window << " s: ours " << cost[std::size_t(at)] << " ms, QLineSeries.replace " << baseline[std::size_t(at)]
            << " ms, ratio " << cost[std::size_t(at)] / baseline[std::size_t(at)] << " (limit 0.05)\n";
        ++at;
    }
    out << "600 s against 10 s: " << cost[1] / cost[0] << " (limit 1.5)\n";
    return cost[0] / baseline[0] <= 0.05 * 1.15 && cost[1] / baseline[1] <= 0.05 * 1.15 && cost[1] / cost[0] <= 1.5 * 1.15
        ? 0
        : 1;
}
