// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QObject>
#include <QString>
#include <QTextStream>

#include <vector>

/// The table of goals: what was reached, against which limit and which baseline of the same run.
class Report
{
public:
    /// A value that must not be greater than its limit, or not smaller. Past the limit by 15 % is a failure;
    /// machines are noisy. @param baseline what it was measured against, in words
    void atMost(const QString &goal, const QString &what, double value, double limit, const QString &unit,
                const QString &baseline);
    void atLeast(const QString &goal, const QString &what, double value, double limit, const QString &unit,
                 const QString &baseline);
    /// A figure without a limit.
    void tell(const QString &what, const QString &value, const QString &baseline = {});
    void print(QTextStream &out) const;
    /// The rows as plain data, for the process that asked for them.
    void printRows(QTextStream &out) const;
    void takeRows(const QByteArray &printed);
    [[nodiscard]] bool passed() const;

private:
    static constexpr double kTolerance = 1.15;
    struct Row
    {
        QString goal, what, value, limit, baseline, verdict;
        bool bad = false;
    };
    void add(Row row);
    std::vector<Row> m_rows;
};

/// Processor time of this process, of all its threads or of this one, in milliseconds.
[[nodiscard]] double processMs();
[[nodiscard]] double threadMs();
[[nodiscard]] double median(std::vector<double> values);
/// The value that a share of all values does not exceed.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Runs the event loop, asleep between events.
void waitFor(int milliseconds);

/// Counts the pictures that a widget paints.
class PaintCounter final : public QObject
{
public:
    bool eventFilter(QObject *, QEvent *event) override
    {
        count += event->type() == QEvent::Paint;
        return false;
    }
    int count = 0;
};

// The cases, one for each group of goals.
void benchFraming(Report &report);
void benchPlots(Report &report);
void benchPacedPlots(Report &report);
void benchLink(Report &report);
void benchStore(Report &report);
void benchImport(Report &report);
void benchSpectra(Report &report);
void benchReading(Report &report);
void benchStart(Report &report);
void benchVideo(Report &report);
/// From the red button to the wire, while the window has much to do.
void benchStop(Report &report);
/// The whole way from a simulated board through a pseudo-terminal to the screen.
void benchEndToEnd(Report &report, int seconds);
