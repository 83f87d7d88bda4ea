// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/holes.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr double kHole = 0.5;  // seconds between two samples
constexpr double kHolePeriods = 3.0;

}  // namespace

void Holes::take(double step, double period)
{
    if (step <= std::max(kHole, kHolePeriods * period))
        return;
    ++m_count;
    m_seconds += step;
}

QString Holes::words() const
{
    if (m_count == 0)
        return {};
    const QString seconds = QString::number(m_seconds, 'f', 1);
    return m_count == 1 ? u", nothing came once, for %1 s"_s.arg(seconds)
                        : u", nothing came %1 times, for %2 s in all"_s.arg(m_count).arg(seconds);
}

QJsonObject Holes::json() const
{
    return {{u"count"_s, m_count}, {u"seconds"_s, m_seconds}};
}
