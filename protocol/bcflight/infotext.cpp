// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/infotext.h"

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr int kDeepest = 32;

/// A tolerant reader of table constructors.
class TableReader
{
public:
    explicit TableReader(const QString &text)
        : m_text(text)
    {
    }

    /// A whole text: one table, or nil.
    std::optional<QList<InfoNode>> read()
    {
        skipName();
        if (takeWord(u"nil"_s))
            return atEnd() ? std::optional(QList<InfoNode>()) : std::nullopt;
        QList<InfoNode> nodes;
        if (!readTable(nodes, 0) || !atEnd())
            return {};
        return nodes;
    }

private:
    void skipSpace()
    {
        while (m_at < m_text.size() && (m_text[m_at].isSpace() || m_text[m_at] == u'\0'))
            ++m_at;
    }
    bool take(QChar wanted)
    {
        skipSpace();
        if (m_at >= m_text.size() || m_text[m_at] != wanted)
            return false;
        ++m_at;
        return true;
    }
    bool atEnd()
    {
        skipSpace();
        return m_at >= m_text.size();
    }
    static bool isWordLetter(QChar letter) { return letter.isLetterOrNumber() || letter == u'_'; }
    QString word()
    {
        skipSpace();
        const qsizetype from = m_at;
        while (m_at < m_text.size() && isWordLetter(m_text[m_at]))
            ++m_at;
        return m_text.sliced(from, m_at - from);
    }
    bool takeWord(const QString &wanted)
    {
        const qsizetype from = m_at;
        if (word() == wanted)
            return true;
        m_at = from;
        return false;
    }
    // "Sensors = " (generation A).
    void skipName()
    {
        const qsizetype from = m_at;
        if (word().isEmpty() || !take(u'='))
            m_at = from;
    }
    // Quotes inside are not escaped, so it ends with the quote behind which something else can follow.
    std::optional<QString> quoted(QStringView ends)
    {
        skipSpace();
        if (m_at >= m_text.size() || (m_text[m_at] != u'"' && m_text[m_at] != u'\''))
            return {};
        const QChar quote = m_text[m_at];
        for (qsizetype end = m_text.indexOf(quote, m_at + 1); end >= 0;
             end = m_text.indexOf(quote, end + 1)) {
            qsizetype next = end + 1;
            while (next < m_text.size() && m_text[next].isSpace() && m_text[next] != u'\n')
                ++next;
            if (next < m_text.size() && m_text[next] != u'\n' && !ends.contains(m_text[next]))
                continue;
            const QString inner = m_text.sliced(m_at + 1, end - m_at - 1);
            m_at = end + 1;
            return inner;
        }
        return {};
    }
    bool readTable(QList<InfoNode> &nodes, int depth)
    {
        if (depth > kDeepest || !take(u'{'))
            return false;
        for (int number = 1;; ++number) {
            if (take(u'}'))
                return true;
            InfoNode node;
            if (!readKey(node, number) || !readValue(node, depth))
                return false;
            nodes.append(std::move(node));
            if (!take(u',') && !take(u';')) {
                return take(u'}');
            }
        }
    }
    bool readKey(InfoNode &node, int number)
    {
        const qsizetype from = m_at;
        if (take(u'[')) {
            const auto name = quoted(u"]");
            node.name = name ? *name : word();
            return take(u']') && take(u'=');
        }
        node.name = word();
        if (!node.name.isEmpty() && take(u'='))
            return true;
        m_at = from;  // an item of a list
        node.name = QString::number(number);
        return true;
    }
    bool readValue(InfoNode &node, int depth)
    {
        skipSpace();
        if (m_at < m_text.size() && m_text[m_at] == u'{')
            return readTable(node.children, depth + 1);
        if (const auto text = quoted(u",;}")) {
            node.value = *text;
            return true;
        }
        const qsizetype from = m_at;
        while (m_at < m_text.size() && !u",;}\n{"_s.contains(m_text[m_at]))
            ++m_at;
        node.value = m_text.sliced(from, m_at - from).trimmed();
        return !node.value.isEmpty();
    }

    QString m_text;
    qsizetype m_at = 0;
};

std::optional<QList<InfoNode>> readLines(const QString &text)
{
    QList<InfoNode> nodes;
    for (const QString &line : text.split(u'\n')) {
        const QString plain = line.trimmed();
        if (plain.isEmpty())
            continue;
        const qsizetype colon = plain.indexOf(u':');
        if (colon <= 0)
            return {};
        nodes.append({plain.first(colon).trimmed(), plain.sliced(colon + 1).trimmed()});
    }
    return nodes.isEmpty() ? std::nullopt : std::optional(nodes);
}

}  // namespace

std::optional<QList<InfoNode>> readInfo(const QByteArray &text)
{
    const QString plain = QString::fromUtf8(text);
    if (auto table = TableReader(plain).read())
        return table;
    return plain.contains(u'{') ? std::nullopt : readLines(plain);
}

QList<RecordingEntry> readRecordings(const QByteArray &text, int &damaged)
{
    QList<RecordingEntry> entries;
    damaged = 0;
    for (const QString &entry : QString::fromUtf8(text).split(u';', Qt::SkipEmptyParts)) {
        const QStringList parts = entry.split(u':');
        bool ok = false;
        const qint64 bytes = parts.value(1).toLongLong(&ok);
        if (!ok || parts.first().isEmpty()) {
            ++damaged;
            continue;
        }
        if (!parts.first().startsWith(u'.'))
            entries.append({parts.first(), bytes, parts.value(5)});
    }
    return entries;
}

}  // namespace bcflight
