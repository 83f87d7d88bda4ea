// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/blackbox.h"

#include "protocol/base/filefault.h"

#include <QHash>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kLongestLine = 4096;
constexpr qsizetype kLongestTime = 15;  // digits: thirty years
constexpr int kLinesToJudge = 4;
constexpr qint64 kLongestPause = 3'600'000'000;  // µs; a time farther away is a damaged one
constexpr int kStraysBelieved = 8;  // as many in a row are no damage

struct Parts
{
    qint64 at = 0;
    QByteArrayView name;
    QByteArrayView value;
};

bool isNameLetter(char letter)
{
    return letter > ' ' && letter < 0x7F && letter != '"';
}

std::optional<Parts> partsOf(QByteArrayView line)
{
    const qsizetype first = line.indexOf(',');
    const qsizetype second = first < 0 ? -1 : line.indexOf(',', first + 1);
    if (first < 1 || first > kLongestTime || second < 0 || line.size() > kLongestLine)
        return {};
    Parts parts;
    for (const char digit : line.first(first)) {
        if (digit < '0' || digit > '9')
            return {};
        parts.at = parts.at * 10 + (digit - '0');
    }
    parts.name = line.sliced(first + 1, second - first - 1);
    if (parts.name.isEmpty() || parts.name.startsWith('#') || parts.name.size() > BlackBox::kLongestName
        || !std::all_of(parts.name.begin(), parts.name.end(), isNameLetter))
        return {};
    parts.value = line.sliced(second + 1);
    if (parts.value.contains('\0'))
        return {};
    if (parts.value.size() >= 2 && parts.value.startsWith('"') && parts.value.endsWith('"'))
        parts.value = parts.value.sliced(1, parts.value.size() - 2);
    return parts;
}

QByteArrayView withoutReturn(QByteArrayView line)
{
    return line.endsWith('\r') ? line.chopped(1) : line;
}

// The words over the columns that other programs put there: "time,name,value".
bool isHeading(QByteArrayView line)
{
    const auto isOfWord = [](char letter) {
        const char small = char(letter | 0x20);
        return (small >= 'a' && small <= 'z') || letter == '_' || letter == ' ' || letter == '"';
    };
    return line.count(',') == 2 && !line.startsWith(',') && !line.endsWith(',') && !line.contains(",,")
        && std::all_of(line.begin(), line.end(),
                       [&](char letter) { return letter == ',' || isOfWord(letter); });
}

}  // namespace

class BlackBox::Reader
{
public:
    explicit Reader(const QByteArray &bytes) { m_box.m_bytes = bytes; }

    Result<BlackBox> read()
    {
        const QByteArrayView bytes(m_box.m_bytes);
        for (qsizetype from = 0; from < bytes.size();) {
            const qsizetype end = bytes.indexOf('\n', from);
            const qsizetype next = end < 0 ? bytes.size() : end + 1;
            const QByteArrayView line = withoutReturn(bytes.sliced(from, (end < 0 ? next : end) - from));
            // What the end of the file has cut off may be a number that is another one.
            const bool isHead = from == 0 && end >= 0 && isHeading(line);
            if (end < 0 || (!line.isEmpty() && !isHead && !take(line)))
                leaveOut(from, next, end < 0);
            from = next;
        }
        if (m_box.m_lines.empty())
            return fileFailure({.problem = bytes.isEmpty() ? FileProblem::Empty : FileProblem::OtherKind,
                                .kind = FileKind::Recording});
        std::ranges::stable_sort(m_box.m_lines, {}, &Line::at);  // several threads of the drone write it
        return std::move(m_box);
    }

private:
    bool take(QByteArrayView text)
    {
        const auto parts = partsOf(text);
        if (!parts || !isPlausible(parts->at))
            return false;
        const int name = nameOf(parts->name);
        if (name < 0)
            return false;
        m_box.m_lines.push_back(
            {parts->at, name, parts->value.data() - m_box.m_bytes.constData(), int(parts->value.size())});
        int &elements = m_box.m_elements[std::size_t(name)];
        elements = std::max(elements, int(numbers(parts->value).size()));
        return true;
    }

    bool isPlausible(qint64 at)
    {
        const bool isNear = m_box.m_lines.empty() || std::abs(at - m_last) <= kLongestPause;
        m_strays = isNear ? 0 : m_strays + 1;
        if (!isNear && m_strays < kStraysBelieved)
            return false;
        m_last = at;
        return true;
    }

    int nameOf(QByteArrayView name)
    {
        const QByteArray key = name.toByteArray();
        if (const auto known = m_numbers.constFind(key); known != m_numbers.constEnd())
            return *known;
        if (m_box.m_names.size() >= kMostNames)
            return -1;
        m_numbers.insert(key, int(m_box.m_names.size()));
        m_box.m_names.append(key);
        m_box.m_elements.push_back(0);
        return int(m_box.m_names.size()) - 1;
    }

    void leaveOut(qint64 from, qint64 to, bool isEnd)
    {
        auto &damage = m_box.m_damage;
        if (!damage.empty() && damage.back().offset + damage.back().bytes == from
            && damage.back().line == m_box.m_lines.size()) {
            damage.back().bytes += to - from;
            damage.back().isEnd = isEnd;
            return;
        }
        damage.push_back({from, to - from, m_box.m_lines.size(), isEnd});
    }

    BlackBox m_box;
    QHash<QByteArray, int> m_numbers;
    qint64 m_last = 0;
    int m_strays = 0;
};

bool BlackBox::isBegunBy(QByteArrayView bytes)
{
    int lines = 0;
    for (qsizetype from = 0; from < bytes.size() && lines < kLinesToJudge; ++lines) {
        const qsizetype end = bytes.indexOf('\n', from);
        if (end < 0)
            return false;
        if (partsOf(withoutReturn(bytes.sliced(from, end - from))))
            return true;
        from = end + 1;
    }
    return false;
}

Result<BlackBox> BlackBox::read(const QByteArray &bytes)
{
    return Reader(bytes).read();
}

std::vector<float> BlackBox::numbers(QByteArrayView value)
{
    if (value == "true" || value == "false")
        return {value == "true" ? 1.0F : 0.0F};
    std::vector<float> numbers;
    for (qsizetype from = 0; from < value.size();) {
        const qsizetype comma = value.indexOf(',', from);
        const qsizetype end = comma < 0 ? value.size() : comma;
        bool ok = false;
        const float number = value.sliced(from, end - from).trimmed().toFloat(&ok);
        if (!ok || numbers.size() >= kMostNumbers)
            return {};
        // Not finite: nothing was measured.
        numbers.push_back(std::isfinite(number) ? number : std::numeric_limits<float>::quiet_NaN());
        from = end + 1;
    }
    return numbers;
}
