// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QTextStream>

#include <algorithm>
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
    while (!output.contains("first paint") && process.state() != QProcess::NotRunning && process.waitForReadyRead(10000))
        output += process.readAll();
    const double ms = double(timer.nsecsElapsed()) / 1e6;
    process.kill();
    process.waitForFinished();
    return ms;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

/// P12: start to first paint of the main window against a minimal Qt window, interleaved, medians. Limit 3.
int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    constexpr int kRuns = 15;
    std::vector<double> ours;
    std::vector<double> minimal;
    for (int i = 0; i < kRuns; ++i) {
        ours.push_back(startOf(QStringLiteral(GIMBAL_BIN_DIR "/gimbaldesk")));
        minimal.push_back(startOf(QStringLiteral(GIMBAL_BIN_DIR "/minimalwindow")));
    }
    const double ratio = median(ours) / median(minimal);
    QTextStream(stdout) << "start to first paint: " << median(ours) << " ms, minimal window " << median(minimal)
                        << " ms, ratio " << ratio << " (limit 3)\n";
    return ratio <= 3.0 * 1.15 ? 0 : 1;
}
