// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/jsonplace.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>
#include <optional>

using namespace Qt::StringLiterals;

namespace {

/// Where an entry stands, and where another one with its name stands before it.
struct DoubledEntry
{
    QString name;
    qsizetype first = 0;
    qsizetype second = 0;
};

/// Walks through a text that is known to be valid JSON.
class JsonWalk
{
public:
    explicit JsonWalk(QByteArrayView json)
        : m_json(json)
    {
    }

    /// Where the value at this path begins; -1 if there is none. Of two entries with the same name the last
    /// one counts, as it does for Qt.
    qsizetype find(const QStringList &path)
    {
        skipBlanks();
        if (path.isEmpty())
            return m_at;
        const char opening = here();
        if (opening != '{' && opening != '[')
            return -1;
        qsizetype found = -1;
        ++m_at;
        for (int number = 0; !isOver(); ++number) {
            skipBlanks();
            if (here() == '}' || here() == ']')
                break;
            const QString name = opening == '{' ? takeName() : QString::number(number);
            skipBlanks();
            if (name == path.first()) {
                const qsizetype before = m_at;
                found = find(path.mid(1));
                m_at = before;
            }
            skipValue();
            skipBlanks();
            if (here() == ',')
                ++m_at;
        }
        return found;
    }

    /// The second of two entries with the same name in the value here; the walk ends there, or behind the
    /// value.
    std::optional<DoubledEntry> findDoubled()
    {
        skipBlanks();
        const char opening = here();
        if (opening != '{' && opening != '[') {
            skipValue();
            return {};
        }
        QHash<QString, qsizetype> seen;
        for (++m_at; !isOver();) {
            skipBlanks();
            if (here() == '}' || here() == ']') {
                ++m_at;
                break;
            }
            const qsizetype at = m_at;
            const QString name = opening == '{' ? takeName() : QString();
            if (opening == '{' && seen.contains(name))
                return DoubledEntry{name, seen.value(name), at};
            seen.insert(name, at);
            if (const auto inside = findDoubled())
                return inside;
            skipBlanks();
            if (here() == ',')
                ++m_at;
        }
        return {};
    }

private:
    [[nodiscard]] bool isOver() const { return m_at >= m_json.size(); }
    [[nodiscard]] char here() const { return isOver() ? '\0' : m_json[m_at]; }

    void skipBlanks()
    {
        while (!isOver() && (here() == ' ' || here() == '\t' || here() == '\n' || here() == '\r'))
            ++m_at;
    }

    void skipText()
    {
        for (++m_at; !isOver() && here() != '"'; ++m_at) {
            if (here() == '\\')
                ++m_at;
        }
        ++m_at;
    }

    QString takeName()
    {
        const qsizetype begin = m_at + 1;
        skipText();
        const qsizetype length = std::max<qsizetype>(0, std::min(m_at, m_json.size()) - 1 - begin);
        skipBlanks();
        ++m_at;  // the colon
        return QString::fromUtf8(m_json.sliced(std::min(begin, m_json.size()), length));
    }

    void skipValue()
    {
        for (int depth = 0; !isOver();) {
            const char c = here();
            if (depth == 0 && (c == ',' || c == '}' || c == ']'))
                return;
            if (c == '"') {
                skipText();
                continue;
            }
            depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
            ++m_at;
        }
    }

    QByteArrayView m_json;
    qsizetype m_at = 0;
};

// The name before that byte, if the text there ends in one: a number as large as 1e999 is not valid JSON.
QString entryBefore(const QByteArray &json, int offset)
{
    static const QRegularExpression key(u"\"([^\"]*)\"\\s*:[^\":,]*$"_s);
    const auto match = key.match(QString::fromUtf8(json.left(offset)));
    return match.hasMatch() ? match.captured(1) : QString();
}

}  // namespace

int lineOfJson(QByteArrayView json, const QStringList &path)
{
    const qsizetype at = JsonWalk(json).find(path);
    return at < 0 ? 0 : lineOfByte(json, at);
}

Result<void> checkOnce(QByteArrayView json, FileKind kind)
{
    const auto doubled = JsonWalk(json).findDoubled();
    if (!doubled)
        return {};
    return fileFailure({.problem = FileProblem::Doubled,
                        .kind = kind,
                        .line = lineOfByte(json, doubled->second),
                        .key = doubled->name,
                        .expected = QString::number(lineOfByte(json, doubled->first))});
}

FileFault jsonFault(const QByteArray &json, const QJsonParseError &error, FileKind kind, char opening)
{
    const QByteArray text = json.trimmed();
    FileFault fault{.problem = FileProblem::Damaged, .kind = kind};
    if (text.isEmpty()) {
        fault.problem = FileProblem::Empty;
        return fault;
    }
    if (!text.startsWith(opening)) {
        fault.problem = FileProblem::OtherKind;
        fault.said = opening == '{' ? u"not a JSON object"_s : u"not a JSON array"_s;
        return fault;
    }
    fault.said = u"JSON: %1 at byte %2"_s.arg(error.errorString()).arg(error.offset);
    const qsizetype end = json.indexOf(opening) + text.size();
    // Qt also says "unterminated" where something else than a comma follows a value.
    if (error.offset + 1 >= end || !text.endsWith(opening == '{' ? '}' : ']')) {
        fault.problem = FileProblem::Truncated;
        fault.line = lineOfByte(json, end);
        return fault;
    }
    fault.line = lineOfByte(json, error.offset);
    fault.key = entryBefore(json, error.offset);
    return fault;
}

Result<QJsonDocument> readJson(const QString &path, FileKind kind, qint64 largest, char opening)
{
    const auto bytes = readWhole(path, kind, largest);
    if (!bytes)
        return tl::unexpected(bytes.error());
    QJsonParseError parse;
    QJsonDocument document = QJsonDocument::fromJson(*bytes, &parse);
    if (opening == '{' ? !document.isObject() : !document.isArray())
        return tl::unexpected(inFile(jsonFault(*bytes, parse, kind, opening).error(), path));
    if (const auto once = checkOnce(*bytes, kind); !once)
        return tl::unexpected(inFile(once.error(), path));
    return document;
}
