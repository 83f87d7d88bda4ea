// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/luadoubts.h"

#include "protocol/bcflight/luatext.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

// How far from zero the shares of an axis may add up, of the sum of their amounts: arms of unequal lengths
// are balanced by their numbers all the same.
constexpr double kUnbalanced = 0.1;
constexpr double kMostShare = 1.0;
// As alike as this, two axes cannot be told apart by the motors.
constexpr double kAlike = 0.95;
constexpr qsizetype kLookBack = 60;  // characters
constexpr std::array<const char *, 3> kSteered{"roll", "pitch", "yaw"};

using Doubts = std::vector<ScriptMistake>;

QString figure(double value)
{
    return QString::number(value, 'g', 4);
}

void doubtRows(const QByteArray &text, const std::vector<MotorMix> &motors, Doubts &doubts)
{
    const std::vector<qsizetype> rows = motorRows(text);
    for (std::size_t i = 0; i < motors.size(); ++i) {
        const int line = lineAt(text, rows[i]);
        const QString number = QString::number(i + 1);
        const auto most = std::max_element(motors[i].begin(), motors[i].end(),
                                           [](double a, double b) { return std::abs(a) < std::abs(b); });
        if (std::abs(*most) > kMostShare)
            doubts.push_back({0,
                              line,
                              QT_TRANSLATE_NOOP("Tables", "a share of motor %1 is beyond 1: %2"),
                              {number, figure(*most)}});
        if (motors[i].back() <= 0)
            doubts.push_back({0, line, QT_TRANSLATE_NOOP("Tables", "motor %1 does not lift"), {number}});
    }
}

void doubtAxes(const std::vector<MotorMix> &motors, int line, Doubts &doubts)
{
    const auto product = [&motors](std::size_t a, std::size_t b) {
        double sum = 0;
        for (const MotorMix &mix : motors)
            sum += mix[a] * mix[b];
        return sum;
    };
    for (std::size_t axis = 0; axis < kSteered.size(); ++axis) {
        const QString name = QLatin1String(kSteered[axis]);
        double sum = 0;
        double amount = 0;
        for (const MotorMix &mix : motors) {
            sum += mix[axis];
            amount += std::abs(mix[axis]);
        }
        // Where nothing turns by its motors' drag, a servo does.
        if (amount == 0 && axis < 2)
            doubts.push_back({0, line, QT_TRANSLATE_NOOP("Tables", "no motor has a share in %1"), {name}});
        if (std::abs(sum) > kUnbalanced * amount)
            doubts.push_back(
                {0,
                 line,
                 QT_TRANSLATE_NOOP(
                     "Tables", "the motors' shares in %1 add up to %2, not to 0: more thrust would turn it"),
                 {name, figure(sum)}});
        for (std::size_t other = 0; other < axis; ++other) {
            const double both = std::sqrt(product(axis, axis) * product(other, other));
            if (both > 0 && std::abs(product(axis, other)) > kAlike * both)
                doubts.push_back({0,
                                  line,
                                  QT_TRANSLATE_NOOP("Tables", "%1 and %2 drive the motors alike"),
                                  {QLatin1String(kSteered[other]), name}});
        }
    }
}

void doubtMixing(const QByteArray &text, Doubts &doubts)
{
    const std::vector<MotorMix> motors = findMotors(text);
    if (motors.empty())
        return;
    const int line = lineAt(text, motorRows(text).front());
    // Rows that are computed are not found here: what stands in a table of its own is counted there.
    const int rows = countEntries(text, u"matrix"_s).value_or(int(motors.size()));
    const std::optional<int> outputs = countEntries(text, u"motors"_s);
    if (outputs && *outputs != rows)
        doubts.push_back({0,
                          line,
                          QT_TRANSLATE_NOOP("Tables", "mixing has %1 rows for %2 motors"),
                          {QString::number(rows), QString::number(*outputs)}});
    doubtRows(text, motors, doubts);
    if (rows == int(motors.size()))
        doubtAxes(motors, line, doubts);
}

/// Follows blocks through the code, word by word.
class BlockReader
{
public:
    explicit BlockReader(const QByteArray &code)
        : m_code(QString::fromLatin1(code))
    {
    }

    void read(const QByteArray &text, Doubts &doubts)
    {
        static const QRegularExpression word(u"(?<!\\w)[A-Za-z_]\\w*"_s);
        for (auto words = word.globalMatch(m_code); words.hasNext();) {
            const auto found = words.next();
            const QString name = found.captured();
            if (name == u"function"_s || name == u"if"_s || name == u"do"_s || name == u"repeat"_s) {
                m_blocks.push_back(
                    {name, found.capturedStart(), name == u"do"_s && opensEndless(found.capturedStart())});
            } else if ((name == u"end"_s || name == u"until"_s) && !m_blocks.empty()) {
                const Block block = m_blocks.back();
                m_blocks.pop_back();
                const bool isEndless
                    = block.isEndless || (name == u"until"_s && isNever(found.capturedEnd()));
                if (isEndless && !block.isLeft && !isInFunction())
                    doubts.push_back(
                        {0,
                         lineAt(text, block.at),
                         QT_TRANSLATE_NOOP("Tables", "this loop never ends: the drone would not start"),
                         {}});
            } else if (name == u"break"_s || name == u"goto"_s) {
                leaveLoop();
            } else if (name == u"return"_s) {
                for (Block &block : m_blocks)
                    block.isLeft = true;
            } else if (name == u"error"_s && m_blocks.empty() && isCall(found.capturedEnd())
                       && !before(found.capturedStart()).endsWith(u'.')) {
                doubts.push_back(
                    {0,
                     lineAt(text, found.capturedStart()),
                     QT_TRANSLATE_NOOP("Tables", "this ends the loading: the drone would not start"),
                     {}});
            }
            doubtCall(text, found, doubts);
        }
    }

private:
    struct Block
    {
        QString word;
        qsizetype at = 0;
        bool isEndless = false;
        bool isLeft = false;  // by a way out of it
    };

    [[nodiscard]] bool isInFunction() const
    {
        return std::any_of(m_blocks.begin(), m_blocks.end(),
                           [](const Block &block) { return block.word == u"function"_s; });
    }

    void leaveLoop()
    {
        const auto loop = std::find_if(m_blocks.rbegin(), m_blocks.rend(), [](const Block &block) {
            return block.word == u"do"_s || block.word == u"repeat"_s;
        });
        if (loop != m_blocks.rend())
            loop->isLeft = true;
    }

    // `while true do`, with any number or text for true.
    [[nodiscard]] bool opensEndless(qsizetype at) const
    {
        static const QRegularExpression always(
            u"(?<!\\w)while\\s*\\(?\\s*(?:true|\\d+|\"[^\"]*\"|'[^']*')\\s*\\)?\\s*$"_s);
        return always.match(before(at)).hasMatch();
    }

    // `until false`
    [[nodiscard]] bool isNever(qsizetype at) const
    {
        static const QRegularExpression never(
            u"^\\s*\\(?\\s*(?:false|nil)\\b\\s*\\)?\\s*(?!\\s*(?:or|and|==|~=)\\b)"_s);
        return never.match(m_code.mid(at, kLookBack)).hasMatch();
    }

    [[nodiscard]] QString before(qsizetype at) const
    {
        return m_code.mid(std::max<qsizetype>(0, at - kLookBack), std::min(at, kLookBack));
    }

    [[nodiscard]] bool isCall(qsizetype at) const
    {
        static const QRegularExpression arguments(u"^\\s*[({\"'\\[]"_s);
        return arguments.match(m_code.mid(at, kLookBack)).hasMatch();
    }

    // By its name alone: it may be called by another.
    void doubtCall(const QByteArray &text, const QRegularExpressionMatch &word, Doubts &doubts) const
    {
        static const QRegularExpression acting(
            u"^(?:os\\s*\\.\\s*(?:execute|exit|remove|rename)\\b|os\\s*\\[|"
            "io\\s*\\.\\s*popen\\b|ffi\\s*\\.\\s*C\\b)"_s);
        static const QRegularExpression named(u"^(?:reboot|shutdown|poweroff|halt|exit|restart)$"_s);
        const QString rest = m_code.mid(word.capturedStart(), kLookBack);
        const auto found = acting.match(rest);
        static const QRegularExpression told(u"(?:\\bfunction|\\bos\\s*\\.)\\s*$"_s);
        const bool isNamed = named.match(word.captured()).hasMatch() && isCall(word.capturedEnd())
            && !told.match(before(word.capturedStart())).hasMatch();
        if (!found.hasMatch() && !isNamed)
            return;
        const QString name = isNamed ? word.captured() : found.captured().simplified().remove(u' ');
        doubts.push_back(
            {0,
             lineAt(text, word.capturedStart()),
             isInFunction()
                 ? QT_TRANSLATE_NOOP("Tables", "%1 acts on the drone's computer when this function is called")
                 : QT_TRANSLATE_NOOP("Tables", "%1 acts on the drone's computer whenever the text is loaded"),
             {name}});
    }

    QString m_code;
    std::vector<Block> m_blocks;
};

// Names that are set where a line begins, and at any depth.
QSet<QString> setIn(const QByteArray &text, bool isOutermost)
{
    static const QRegularExpression outermost(u"^([A-Za-z_][\\w.]*)[ \\t]*=(?!=)"_s,
                                              QRegularExpression::MultilineOption);
    static const QRegularExpression any(u"(?<![\\w.])([A-Za-z_][\\w.]*)\\s*=(?!=)"_s);
    QSet<QString> names;
    for (auto found = (isOutermost ? outermost : any).globalMatch(QString::fromLatin1(onlyCode(text)));
         found.hasNext();)
        names.insert(found.next().captured(1));
    return names;
}

// Where it is listened at, in the order of the text.
QStringList portsIn(const QByteArray &text)
{
    static const QRegularExpression port(u"(?<!\\w)port\\s*=\\s*(\\d+)"_s);
    QStringList ports;
    for (auto found = port.globalMatch(QString::fromLatin1(onlyCode(text))); found.hasNext();)
        ports.append(found.next().captured(1));
    return ports;
}

void doubtLosses(const QByteArray &text, const QByteArray &before, Doubts &doubts)
{
    QStringList lost = (setIn(before, true) - setIn(text, false)).values();
    lost.sort();
    if (!lost.isEmpty())
        doubts.push_back({0,
                          0,
                          QT_TRANSLATE_NOOP("Tables",
                                            "set in the drone's text, and no more in this one: %1. "
                                            "Without what it needs the drone does not start, or is "
                                            "never heard again"),
                          {lost.join(u", "_s)}});
    const QStringList now = portsIn(before);
    const QStringList next = portsIn(text);
    if (lost.isEmpty() && !now.isEmpty() && now != next)
        doubts.push_back({0,
                          0,
                          QT_TRANSLATE_NOOP("Tables",
                                            "ports change from %1 to %2: the drone may not be heard at "
                                            "its present address any more"),
                          {now.join(u", "_s), next.isEmpty() ? u"–"_s : next.join(u", "_s)}});
}

}  // namespace

std::vector<ScriptMistake> findDoubts(const QByteArray &text, const QByteArray &before)
{
    Doubts doubts;
    doubtMixing(text, doubts);
    if (!before.isEmpty())
        doubtLosses(text, before, doubts);
    BlockReader(onlyCode(text)).read(text, doubts);
    std::stable_sort(doubts.begin(), doubts.end(),
                     [](const ScriptMistake &a, const ScriptMistake &b) { return a.line < b.line; });
    return doubts;
}

}  // namespace bcflight
