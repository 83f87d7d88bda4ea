// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <ctime>

using namespace Qt::StringLiterals;

namespace {

const QString kMissed = u"MISSED"_s;

double clockMs(clockid_t id)
{
    timespec time{};
    ::clock_gettime(id, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

QString number(double value, const QString &unit)
{
    return (QString::number(value, 'g', 3) + u' ' + unit).trimmed();
}

}  // namespace

void Report::add(Row row)
{
    QTextStream(stderr) << row.goal.leftJustified(5) << row.what << ": " << row.value << '\n';
    m_rows.push_back(std::move(row));
}

void Report::atMost(const QString &goal, const QString &what, double value, double limit, const QString &unit,
                    const QString &baseline)
{
    const bool bad = !(value <= limit * kTolerance);
    add({goal, what, number(value, unit), u"≤ "_s + number(limit, unit), baseline,
         bad                  ? kMissed
             : value <= limit ? u"reached"_s
                              : u"just missed"_s,
         bad});
}

void Report::atLeast(const QString &goal, const QString &what, double value, double limit,
                     const QString &unit, const QString &baseline)
{
    const bool bad = !(value >= limit / kTolerance);
    add({goal, what, number(value, unit), u"≥ "_s + number(limit, unit), baseline,
         bad                  ? kMissed
             : value >= limit ? u"reached"_s
                              : u"just missed"_s,
         bad});
}

void Report::tell(const QString &what, const QString &value, const QString &baseline)
{
    add({{}, what, value, {}, baseline, {}, false});
}

bool Report::passed() const
{
    return std::none_of(m_rows.begin(), m_rows.end(), [](const Row &row) { return row.bad; });
}

void Report::print(QTextStream &out) const
{
    qsizetype what = 0;
    qsizetype value = 0;
    qsizetype limit = 0;
    for (const Row &row : m_rows) {
        what = std::max(what, row.what.size());
        value = std::max(value, row.value.size());
        limit = std::max(limit, row.limit.size());
    }
    out << "\nGoal  " << u"What"_s.leftJustified(what) << "  " << u"Value"_s.leftJustified(value) << "  "
        << u"Limit"_s.leftJustified(limit) << "  " << u"Verdict"_s.leftJustified(11)
        << "  Baseline in the same run\n";
    for (const Row &row : m_rows) {
        out << row.goal.leftJustified(4) << "  " << row.what.leftJustified(what) << "  "
            << row.value.leftJustified(value) << "  " << row.limit.leftJustified(limit) << "  "
            << row.verdict.leftJustified(11) << "  " << row.baseline << '\n';
    }
    out.flush();
}

void Report::printRows(QTextStream &out) const
{
    for (const Row &row : m_rows)
        out << QStringList{row.goal, row.what, row.value, row.limit, row.baseline, row.verdict}.join(u'\t')
            << '\n';
    out.flush();
}

void Report::takeRows(const QByteArray &printed)
{
    if (printed.isEmpty())
        add({{}, u"a part of the measurement"_s, u"nothing"_s, {}, {}, kMissed, true});
    const QStringList lines = QString::fromUtf8(printed).split(u'\n', Qt::SkipEmptyParts);
    for (const QString &line : lines) {
        const QStringList part = line.split(u'\t');
        if (part.size() == 6)
            add({part[0], part[1], part[2], part[3], part[4], part[5], part[5] == kMissed});
    }
}

void waitFor(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

double processMs()
{
    return clockMs(CLOCK_PROCESS_CPUTIME_ID);
}

double threadMs()
{
    return clockMs(CLOCK_THREAD_CPUTIME_ID);
}

double median(std::vector<double> values)
{
    return quantile(std::move(values), 0.5);
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty())
        return NAN;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}
