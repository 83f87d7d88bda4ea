// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.h"

#include <QApplication>
#include <QCommandLineParser>

#include <algorithm>
#include <functional>

using namespace Qt::StringLiterals;

/// Measures every goal of speed and prints one table. Exit code 1: a goal was missed by more than 15 %.
int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption seconds(u"seconds"_s, u"length of the end-to-end run"_s, u"n"_s, u"60"_s);
    const QCommandLineOption only(
        u"only"_s,
        u"framing, plots, paced, link, store, import, spectra, reading, start, video, stop, end-to-end"_s,
        u"case"_s);
    const QCommandLineOption rows(u"rows"_s, u"print the rows as plain data"_s);
    parser.addOptions({seconds, only, rows});
    parser.addHelpOption();
    parser.process(application);
    const int length = std::clamp(parser.value(seconds).toInt(), 5, 3600);

    Report report;
    const std::vector<std::pair<QString, std::function<void()>>> cases{
        {u"framing"_s, [&] { benchFraming(report); }},
        {u"plots"_s, [&] { benchPlots(report); }},
        {u"paced"_s, [&] { benchPacedPlots(report); }},
        {u"link"_s, [&] { benchLink(report); }},
        {u"store"_s, [&] { benchStore(report); }},
        {u"import"_s, [&] { benchImport(report); }},
        {u"spectra"_s, [&] { benchSpectra(report); }},
        {u"reading"_s, [&] { benchReading(report); }},
        {u"start"_s, [&] { benchStart(report); }},
        {u"video"_s, [&] { benchVideo(report); }},
        {u"stop"_s, [&] { benchStop(report); }},
        {u"end-to-end"_s, [&] { benchEndToEnd(report, length); }},
    };
    const QStringList wanted = parser.values(only);
    for (const auto &[name, run] : cases) {
        if (wanted.isEmpty() || wanted.contains(name))
            run();
    }
    QTextStream out(stdout);
    if (parser.isSet(rows))
        report.printRows(out);
    else
        report.print(out);
    return report.passed() ? 0 : 1;
}
