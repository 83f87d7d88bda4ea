// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.h"

#include <QElapsedTimer>
#include <QProcess>

#include <vector>

using namespace Qt::StringLiterals;

namespace {

// Milliseconds from starting the program to its first paint.
double startOf(const QString &program)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_LOGGING_RULES"_s, u"gimbal.start.debug=true"_s);
    process.setProcessEnvironment(environment);
    QElapsedTimer timer;
    timer.start();
    process.start(program, QStringList());
    QByteArray output;
    while (!output.contains("first paint") && process.state() != QProcess::NotRunning
           && process.waitForReadyRead(10000))
        output += process.readAll();
    const double ms = double(timer.nsecsElapsed()) / 1e6;
    process.kill();
    process.waitForFinished();
    return ms;
}

}  // namespace

/// P12: start to first paint of the main window against a minimal Qt window, interleaved.
void benchStart(Report &report)
{
    constexpr int kRuns = 15;
    std::vector<double> ours;
    std::vector<double> minimal;
    for (int i = 0; i < kRuns; ++i) {
        ours.push_back(startOf(QStringLiteral(GIMBAL_BIN_DIR "/gimbaldesk")));
        minimal.push_back(startOf(QStringLiteral(GIMBAL_BIN_DIR "/minimalwindow")));
    }
    report.atMost(u"P12"_s, u"start to first paint / minimal window"_s, median(ours) / median(minimal), 3, {},
                  u"%1 and %2 ms"_s.arg(median(ours), 0, 'f', 0).arg(median(minimal), 0, 'f', 0));
}
