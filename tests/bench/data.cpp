// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/spectrum.h"
#include "protocol/base/responsecsv.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/bench/report.h"
#include "tests/support/virtualboard.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

#include <array>
#include <cmath>
#include <malloc.h>
#include <random>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRate = 1250;

double residentMb()
{
    QFile file(u"/proc/self/statm"_s);
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toDouble() * double(::sysconf(_SC_PAGESIZE)) / 1e6;
}

double heapMb()
{
    const auto info = ::mallinfo2();
    return double(info.uordblks + info.hblkhd) / 1e6;
}

void fill(TelemetryStore &store, TelemetryGroup &group, qint64 &next, double seconds)
{
    std::array<float, 24> row{};
    for (const qint64 end = next + qint64(seconds * kRate); next < end; ++next) {
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = float(std::sin(double(next) * 0.001 * double(i + 1)));
        store.append(group, store.origin() + durationFromSeconds(double(next) / kRate), row);
    }
}

// The plain way to read two columns.
std::size_t readPlainly(const QByteArray &text)
{
    QTextStream stream(text);
    std::vector<float> in;
    std::vector<float> out;
    for (QString line = stream.readLine(); !line.isNull(); line = stream.readLine()) {
        const QStringList cells = line.split(u';');
        if (cells.size() != 2)
            continue;
        bool ok = false;
        const float value = cells[0].toFloat(&ok);
        if (!ok)
            continue;
        in.push_back(value);
        out.push_back(cells[1].toFloat());
    }
    return in.size();
}

}  // namespace

/// P10: bytes a sample takes with its index, and what ten more minutes add.
void benchStore(Report &report)
{
    const double before = heapMb();
    TelemetryStore store(24);
    store.setRetention(600);
    QList<int> channels;
    for (int i = 0; i < 24; ++i)
        channels.append(i);
    const auto group = store.defineGroup(channels, 1 / kRate);
    qint64 next = 0;
    fill(store, *group, next, 600);
    const double used = (heapMb() - before) * 1e6 / (600 * kRate * 24);
    report.atMost(u"P10"_s, u"stored bytes per sample, index and times included"_s, used, 6, u"B"_s,
                  u"24 channels, 10 min, %1 MB"_s.arg(heapMb() - before, 0, 'f', 0));
    const double full = residentMb();
    fill(store, *group, next, 600);
    report.atMost(u"P10"_s, u"memory that ten more minutes add"_s, std::max(0.0, residentMb() - full), 10,
                  u"MB"_s, u"resident %1 MB"_s.arg(residentMb(), 0, 'f', 0));
}

/// P11: reading a log against a plain QTextStream reader.
void benchImport(Report &report)
{
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    QByteArray text = "# 1250 samples/s\nin;out\n";
    constexpr int kLines = 1'000'000;
    for (int i = 0; i < kLines; ++i)
        text += QByteArray::number(double(normal(random)), 'g', 8) + ';'
            + QByteArray::number(double(normal(random)), 'g', 8) + '\n';
    std::vector<double> ours;
    std::vector<double> plain;
    for (int run = 0; run < 5; ++run) {
        QElapsedTimer timer;
        timer.start();
        const auto read = readResponseCsv(text, 1000);
        ours.push_back(double(timer.nsecsElapsed()) / 1e6);
        timer.restart();
        const std::size_t lines = readPlainly(text);
        plain.push_back(double(timer.nsecsElapsed()) / 1e6);
        if (!read || read->in.size() != lines)
            qFatal("the two readers do not agree");
    }
    report.atMost(u"P11"_s, u"log import / plain QTextStream reader, 1 M lines"_s,
                  median(ours) / median(plain), 0.2, {},
                  u"%1 and %2 ms"_s.arg(median(ours), 0, 'f', 0).arg(median(plain), 0, 'f', 0));
}

/// P13: six spectra of 4096 samples, thirty times a second.
void benchSpectra(Report &report)
{
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    std::vector<float> samples(4096);
    for (float &sample : samples)
        sample = normal(random);
    std::vector<double> ms;
    for (int run = 0; run < 60; ++run) {
        const double before = threadMs();
        for (int i = 0; i < 6; ++i) {
            if (!spectrum(samples, kRate, {4096, 0.5, WindowShape::Hann}))
                qFatal("no spectrum");
        }
        ms.push_back(threadMs() - before);
    }
    report.atMost(u"P13"_s, u"spectra of 6 x 4096 at 30/s"_s, median(ms) * 30 / 1000 * 100, 1,
                  u"% of a core"_s, u"%1 ms each time"_s.arg(median(ms), 0, 'f', 3));
}

/// P14: reading the whole configuration against the time its bytes take and the pause the document asks for.
void benchReading(Report &report)
{
    constexpr double kPause = 0.010;  // document, "Message format": 10-20 ms after each command
    SimulatorOptions options;
    options.usb = false;
    const LineSettings line{115200, Parity::None};
    VirtualBoard bench(options, line);
    std::ignore = bench.channel.setLine(line);
    if (!bench.identify())
        qFatal("no board");
    qint64 bytes = 0;
    int frames = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint) {
        bytes += qint64(frame.payload.size()) + 5;
        ++frames;
    });
    const TimePoint start = bench.channel.now();
    const auto configuration = bench.device.readConfiguration(bench.channel);
    const double took = seconds(bench.channel.now() - start);
    if (!configuration || configuration->blocks().size() != 15)
        qFatal("not everything was read");
    constexpr qint64 kRequest = 6;
    const double wire = line.secondsFor(bytes + frames * kRequest);
    report.atMost(u"P14"_s, u"configuration read at 115200 / wire time and pauses"_s,
                  took / (wire + frames * kPause), 1.15, {},
                  u"%1 ms, wire alone %2 ms, %3 commands"_s.arg(took * 1000, 0, 'f', 0)
                      .arg(wire * 1000, 0, 'f', 0)
                      .arg(frames));
}
