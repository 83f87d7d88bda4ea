// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/linediff.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMostSteps = 1500;  // beyond, two texts have hardly anything in common

using Lines = std::vector<QByteArray>;

// Each with its end.
Lines split(const QByteArray &text)
{
    Lines lines;
    for (qsizetype from = 0; from < text.size();) {
        const qsizetype end = text.indexOf('\n', from);
        const qsizetype next = end < 0 ? text.size() : end + 1;
        lines.push_back(text.sliced(from, next - from));
        from = next;
    }
    return lines;
}

// A changed line shows an end that cannot be seen otherwise.
QString shown(const QByteArray &line, bool isChanged)
{
    QByteArray plain = line;
    const bool isEnded = plain.endsWith('\n');
    if (isEnded)
        plain.chop(1);
    const bool hasReturn = plain.endsWith('\r');
    if (hasReturn)
        plain.chop(1);
    QString text = QString::fromUtf8(plain);
    if (isChanged && hasReturn)
        text += u'␍';
    if (isChanged && !isEnded)
        text += u'␄';
    return text;
}

/// Myers' comparison: from one corner to the other in as few steps as possible, each of which removes or adds
/// a line.
class Comparison
{
public:
    Comparison(const Lines &before, const Lines &after)
        : m_before(before)
        , m_after(after)
    {
    }

    std::vector<DiffLine> lines()
    {
        const int prefix = commonPrefix();
        const int suffix = commonSuffix(prefix);
        m_from = prefix;
        m_beforeEnd = int(m_before.size()) - suffix;
        m_afterEnd = int(m_after.size()) - suffix;
        for (int i = 0; i < prefix; ++i)
            same(i, i);
        compareMiddle();
        for (int i = 0; i < suffix; ++i)
            same(m_beforeEnd + i, m_afterEnd + i);
        return std::move(m_lines);
    }

private:
    using Reached = std::vector<int>;  // how far in the first text, for each diagonal

    [[nodiscard]] int commonPrefix() const
    {
        const auto end = std::mismatch(m_before.begin(), m_before.end(), m_after.begin(), m_after.end());
        return int(end.first - m_before.begin());
    }
    [[nodiscard]] int commonSuffix(int prefix) const
    {
        const auto limit = std::min(m_before.size(), m_after.size()) - std::size_t(prefix);
        int count = 0;
        while (std::size_t(count) < limit
               && m_before[m_before.size() - 1 - std::size_t(count)]
                   == m_after[m_after.size() - 1 - std::size_t(count)])
            ++count;
        return count;
    }

    void same(int before, int after)
    {
        m_lines.push_back(
            {DiffLine::Kind::Same, before + 1, after + 1, shown(m_after[std::size_t(after)], false)});
    }
    void removed(int before)
    {
        m_lines.push_back(
            {DiffLine::Kind::Removed, before + 1, 0, shown(m_before[std::size_t(before)], true)});
    }
    void added(int after)
    {
        m_lines.push_back({DiffLine::Kind::Added, 0, after + 1, shown(m_after[std::size_t(after)], true)});
    }

    // How far equal lines lead from there.
    [[nodiscard]] int slide(int x, int diagonal) const
    {
        while (x < m_beforeEnd - m_from && x - diagonal < m_afterEnd - m_from
               && m_before[std::size_t(m_from + x)] == m_after[std::size_t(m_from + x - diagonal)])
            ++x;
        return x;
    }
    [[nodiscard]] static bool isDown(const Reached &reached, int diagonal, int step, int offset)
    {
        return diagonal == -step
            || (diagonal != step
                && reached[std::size_t(offset + diagonal - 1)] < reached[std::size_t(offset + diagonal + 1)]);
    }

    void compareMiddle()
    {
        const int width = m_beforeEnd - m_from;
        const int height = m_afterEnd - m_from;
        const int most = std::min(width + height, kMostSteps);
        const int offset = most + 1;
        Reached reached(std::size_t(2 * offset + 1), 0);
        std::vector<Reached> trace;
        for (int step = 0; step <= most; ++step) {
            trace.push_back(reached);
            for (int diagonal = -step; diagonal <= step; diagonal += 2) {
                const int from = isDown(reached, diagonal, step, offset)
                    ? reached[std::size_t(offset + diagonal + 1)]
                    : reached[std::size_t(offset + diagonal - 1)] + 1;
                const int x = slide(from, diagonal);
                reached[std::size_t(offset + diagonal)] = x;
                if (x >= width && x - diagonal >= height) {
                    goBack(trace, offset, width, height);
                    return;
                }
            }
        }
        for (int x = m_from; x < m_beforeEnd; ++x)
            removed(x);
        for (int y = m_from; y < m_afterEnd; ++y)
            added(y);
    }

    // From the end to the beginning, along the steps that led there.
    void goBack(const std::vector<Reached> &trace, int offset, int width, int height)
    {
        struct Step
        {
            DiffLine::Kind kind;
            int x;
            int y;
        };
        std::vector<Step> steps;
        int x = width;
        int y = height;
        for (int step = int(trace.size()) - 1; step >= 0; --step) {
            const Reached &reached = trace[std::size_t(step)];
            const int diagonal = x - y;
            const bool down = isDown(reached, diagonal, step, offset);
            const int before = down ? diagonal + 1 : diagonal - 1;
            const int startX = step == 0 ? 0 : reached[std::size_t(offset + before)];
            const int startY = step == 0 ? 0 : startX - before;
            while (x > startX && y > startY)
                steps.push_back({DiffLine::Kind::Same, --x, --y});
            if (step > 0)
                down ? steps.push_back({DiffLine::Kind::Added, x, --y})
                     : steps.push_back({DiffLine::Kind::Removed, --x, y});
        }
        for (auto it = steps.rbegin(); it != steps.rend(); ++it) {
            if (it->kind == DiffLine::Kind::Same)
                same(m_from + it->x, m_from + it->y);
            else if (it->kind == DiffLine::Kind::Added)
                added(m_from + it->y);
            else
                removed(m_from + it->x);
        }
    }

    const Lines &m_before;
    const Lines &m_after;
    std::vector<DiffLine> m_lines;
    int m_from = 0;
    int m_beforeEnd = 0;
    int m_afterEnd = 0;
};

}  // namespace

std::vector<DiffLine> lineDiff(const QByteArray &before, const QByteArray &after)
{
    const Lines first = split(before);
    const Lines second = split(after);
    return Comparison(first, second).lines();
}

std::vector<DiffLine> aroundChanges(const std::vector<DiffLine> &lines, int context)
{
    const int count = int(lines.size());
    std::vector<bool> isKept(lines.size(), false);
    for (int i = 0; i < count; ++i) {
        if (lines[std::size_t(i)].kind == DiffLine::Kind::Same)
            continue;
        for (int near = std::max(0, i - context); near <= std::min(count - 1, i + context); ++near)
            isKept[std::size_t(near)] = true;
    }
    std::vector<DiffLine> kept;
    if (std::find(isKept.begin(), isKept.end(), true) == isKept.end())
        return kept;
    for (int i = 0; i < count; ++i) {
        if (isKept[std::size_t(i)]) {
            kept.push_back(lines[std::size_t(i)]);
            continue;
        }
        if (kept.empty() || kept.back().kind != DiffLine::Kind::Gap)
            kept.push_back({.kind = DiffLine::Kind::Gap});
        ++kept.back().left;
    }
    return kept;
}

std::pair<int, int> countChanges(const std::vector<DiffLine> &lines)
{
    const auto count = [&lines](DiffLine::Kind kind) {
        return int(std::count_if(lines.begin(), lines.end(),
                                 [kind](const DiffLine &line) { return line.kind == kind; }));
    };
    return {count(DiffLine::Kind::Added), count(DiffLine::Kind::Removed)};
}
