// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/luatext.h"

#include "protocol/bcflight/blocks.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

bool isWordLetter(char letter)
{
    return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_';
}

// Length of the opening of a long bracket, "[[" or "[==[", at this place; 0: there is none.
qsizetype longBracket(const QByteArray &text, qsizetype at)
{
    if (at >= text.size() || text[at] != '[')
        return 0;
    qsizetype end = at + 1;
    while (end < text.size() && text[end] == '=')
        ++end;
    return end < text.size() && text[end] == '[' ? end - at + 1 : 0;
}

void blank(QByteArray &code, qsizetype from, qsizetype to)
{
    for (qsizetype i = from; i < to; ++i) {
        if (code[i] != '\n')
            code[i] = ' ';
    }
}

// Behind a long bracket that opens here.
qsizetype endOfLong(const QByteArray &text, qsizetype at, qsizetype opening)
{
    const QByteArray closing = ']' + QByteArray(opening - 2, '=') + ']';
    const qsizetype end = text.indexOf(closing, at + opening);
    return end < 0 ? text.size() : end + closing.size();
}

// Behind a quoted string that opens here; an unfinished one ends with its line.
qsizetype endOfQuoted(const QByteArray &text, qsizetype at)
{
    for (qsizetype end = at + 1; end < text.size(); ++end) {
        if (text[end] == '\\')
            ++end;
        else if (text[end] == text[at])
            return end + 1;
        else if (text[end] == '\n')
            return end;
    }
    return text.size();
}

enum class Part { Comment, Long, Quoted };

// What is no code: comments, and strings in long brackets and in quotes.
template <typename F> void eachPart(const QByteArray &text, F &&take)
{
    for (qsizetype at = 0; at < text.size();) {
        const bool isComment = text[at] == '-' && at + 1 < text.size() && text[at + 1] == '-';
        const qsizetype from = isComment ? at + 2 : at;
        const bool isQuoted = text[at] == '"' || text[at] == '\'';
        const qsizetype opening = longBracket(text, from);
        if (!isComment && !isQuoted && opening == 0) {
            ++at;
            continue;
        }
        qsizetype end = text.size();
        if (opening > 0)
            end = endOfLong(text, from, opening);
        else if (isQuoted)
            end = endOfQuoted(text, at);
        else if (const qsizetype line = text.indexOf('\n', at); line >= 0)
            end = line;
        take(isComment ? Part::Comment : isQuoted ? Part::Quoted : Part::Long, at, end);
        at = end;
    }
}

void skipSpace(const QByteArray &code, qsizetype &at)
{
    while (at < code.size() && std::isspace(static_cast<unsigned char>(code[at])))
        ++at;
}

bool take(const QByteArray &code, qsizetype &at, char wanted)
{
    skipSpace(code, at);
    if (at >= code.size() || code[at] != wanted)
        return false;
    ++at;
    return true;
}

bool takeWord(const QByteArray &code, qsizetype &at, QByteArrayView wanted)
{
    skipSpace(code, at);
    if (!QByteArrayView(code).sliced(at).startsWith(wanted))
        return false;
    const qsizetype end = at + wanted.size();
    if (end < code.size() && isWordLetter(code[end]))
        return false;
    at = end;
    return true;
}

std::optional<Literal> takeNumber(const QByteArray &code, qsizetype &at)
{
    static const QRegularExpression number(uR"(\G-?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.]))"_s);
    skipSpace(code, at);
    const QString rest = QString::fromLatin1(
        QByteArrayView(code).sliced(at).first(std::min<qsizetype>(code.size() - at, 64)));
    const auto match = number.match(rest, 0, QRegularExpression::NormalMatch,
                                    QRegularExpression::AnchorAtOffsetMatchOption);
    if (!match.hasMatch())
        return {};
    bool ok = false;
    const double value = match.captured().toDouble(&ok);
    if (!ok || !std::isfinite(value))
        return {};
    const Literal literal{at, at + match.capturedLength(), value};
    at = literal.to;
    return literal;
}

// Where `name =` is set, each place behind the sign; of a table (`stabilizer.name =`) as well, because that
// may be the same.
std::vector<qsizetype> assignments(const QByteArray &code, const QByteArray &name)
{
    std::vector<qsizetype> places;
    for (qsizetype at = code.indexOf(name); at >= 0; at = code.indexOf(name, at + 1)) {
        if (at > 0 && isWordLetter(code[at - 1]))
            continue;
        qsizetype next = at;
        if (!takeWord(code, next, name))
            continue;
        if (take(code, next, '=') && !(next < code.size() && code[next] == '='))
            places.push_back(next);
    }
    return places;
}

QString lines(const QByteArray &text, const std::vector<qsizetype> &places)
{
    QStringList numbers;
    for (const qsizetype place : places)
        numbers.append(QString::number(lineAt(text, place)));
    return numbers.join(u", "_s);
}

// The operator mends it there.
Error textError(const QString &detail, int line)
{
    Error error{ErrorCode::ConditionUnmet, detail, 0};
    error.place = TextPlace{ConfigurationText, line};
    return error;
}

Error notFound(const QString &name)
{
    return textError(u"%1 is not set in the text"_s.arg(name), 0);
}

// The second one is what is too much.
Error ambiguous(const QByteArray &text, const QString &name, const std::vector<qsizetype> &places)
{
    return textError(u"%1 is set more than once, in lines %2"_s.arg(name, lines(text, places)),
                     lineAt(text, places[1]));
}

Error unlike(const QByteArray &text, const QString &name, qsizetype place, const QString &wanted)
{
    const int line = lineAt(text, place);
    return textError(u"line %1: %2 is no %3"_s.arg(QString::number(line), name, wanted), line);
}

// The end of a statement, or of an entry of a table.
bool endsThere(const QByteArray &code, qsizetype at)
{
    while (at < code.size() && (code[at] == ' ' || code[at] == '\t' || code[at] == '\r'))
        ++at;
    return at >= code.size() || code[at] == '\n' || code[at] == ',' || code[at] == ';' || code[at] == '}';
}

}  // namespace

QByteArray onlyCode(const QByteArray &text)
{
    QByteArray code = text;
    eachPart(text, [&code](Part part, qsizetype from, qsizetype to) {
        if (part == Part::Quoted)
            blank(code, from + 1, std::max(from + 1, to - 1));
        else
            blank(code, from, to);
    });
    return code;
}

qsizetype laterEscape(const QByteArray &text)
{
    qsizetype found = -1;
    eachPart(text, [&](Part part, qsizetype from, qsizetype to) {
        for (qsizetype at = from; part == Part::Quoted && found < 0 && at < to; ++at) {
            if (text[at] != '\\')
                continue;
            if (QByteArrayView(text).sliced(at).startsWith("\\u{"))
                found = at;
            ++at;  // what is escaped
        }
    });
    return found;
}

int lineAt(const QByteArray &text, qsizetype position)
{
    return int(std::count(text.begin(), text.begin() + std::min(position, text.size()), '\n')) + 1;
}

Result<GainLiterals> findGains(const QByteArray &text, const QString &name)
{
    const QByteArray code = onlyCode(text);
    const auto places = assignments(code, name.toLatin1());
    if (places.empty())
        return tl::unexpected(notFound(name));
    if (places.size() > 1)
        return tl::unexpected(ambiguous(text, name, places));
    qsizetype at = places.front();
    GainLiterals gains;
    bool isPlain = takeWord(code, at, "PID") && take(code, at, '(');
    for (std::size_t i = 0; i < gains.size() && isPlain; ++i) {
        const auto literal = takeNumber(code, at);
        isPlain = literal && take(code, at, i + 1 < gains.size() ? ',' : ')');
        if (literal)
            gains[i] = *literal;
    }
    if (!isPlain)
        return tl::unexpected(unlike(text, name, places.front(), u"PID( ... ) of three plain numbers"_s));
    return gains;
}

Result<double> findScale(const QByteArray &text, const QString &name)
{
    const QByteArray code = onlyCode(text);
    const auto places = assignments(code, name.toLatin1());
    if (places.empty())
        return 1.0;
    if (places.size() > 1)
        return tl::unexpected(ambiguous(text, name, places));
    qsizetype at = places.front();
    double product = 1;
    for (bool isMore = true; isMore; isMore = take(code, at, '*')) {
        const auto factor = takeNumber(code, at);
        if (!factor)
            break;
        product *= factor->value;
        if (endsThere(code, at))
            return product;
    }
    return tl::unexpected(unlike(text, name, places.front(), u"product of plain numbers"_s));
}

Result<std::array<double, 3>> findScales(const QByteArray &text)
{
    std::array<double, 3> scales{};
    const std::array names{u"PID.pscale"_s, u"PID.iscale"_s, u"PID.dscale"_s};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto scale = findScale(text, names[i]);
        if (!scale)
            return tl::unexpected(scale.error());
        scales[i] = *scale;
    }
    return scales;
}

// Single precision may come in at each step, or at the end.
static int waysToReach(double value, double scale, float gain)
{
    return int(float(value) * float(scale) == gain) + int(float(double(float(value)) * scale) == gain)
        + int(float(value * scale) == gain);
}

static double shortestFor(float gain, double scale, int ways)
{
    const double exact = double(gain) / scale;
    for (int wanted = ways; wanted > 0; --wanted) {
        for (int digits = 3; digits < 17; ++digits) {
            const double value = QByteArray::number(exact, 'g', digits).toDouble();
            if (waysToReach(value, scale, gain) >= wanted)
                return value;
        }
    }
    return exact;
}

bool isSameGain(float a, float b)
{
    return a == b || std::nextafter(a, b) == b;
}

double literalFor(float gain, double scale)
{
    return shortestFor(gain, scale, 3);
}

double figureFor(float gain, double scale)
{
    return shortestFor(gain, scale, 1);
}

QByteArray replaced(const QByteArray &text, const Literal &literal, double value)
{
    QByteArray number;
    for (int digits = 1; digits <= 9; ++digits) {
        number = QByteArray::number(value, 'g', digits);
        if (number.toFloat() == float(value))
            break;
    }
    return text.first(literal.from) + number + text.sliced(literal.to);
}

static std::vector<std::pair<qsizetype, MotorMix>> placedMotors(const QByteArray &text)
{
    const QByteArray code = onlyCode(text);
    std::vector<std::pair<qsizetype, MotorMix>> motors;
    for (qsizetype found = code.indexOf("Vector"); found >= 0; found = code.indexOf("Vector", found + 1)) {
        qsizetype at = found;
        if ((found > 0 && isWordLetter(code[found - 1])) || !takeWord(code, at, "Vector")
            || !take(code, at, '('))
            continue;
        MotorMix mix{};
        bool isPlain = true;
        for (std::size_t i = 0; i < mix.size() && isPlain; ++i) {
            const auto literal = takeNumber(code, at);
            isPlain = literal && take(code, at, i + 1 < mix.size() ? ',' : ')');
            mix[i] = literal ? literal->value : 0;
        }
        if (isPlain)
            motors.emplace_back(found, mix);
    }
    return motors;
}

std::vector<MotorMix> findMotors(const QByteArray &text)
{
    std::vector<MotorMix> motors;
    for (const auto &[place, mix] : placedMotors(text))
        motors.push_back(mix);
    return motors;
}

std::vector<qsizetype> motorRows(const QByteArray &text)
{
    std::vector<qsizetype> places;
    for (const auto &[place, mix] : placedMotors(text))
        places.push_back(place);
    return places;
}

std::optional<int> countEntries(const QByteArray &text, const QString &name)
{
    const QByteArray code = onlyCode(text);
    const auto places = assignments(code, name.toLatin1());
    qsizetype at = places.size() == 1 ? places.front() : code.size();
    if (!take(code, at, '{'))
        return {};
    int entries = 0;
    bool isEmpty = true;
    for (int depth = 1; at < code.size(); ++at) {
        const char letter = code[at];
        depth += letter == '{' || letter == '(' || letter == '[';
        depth -= letter == '}' || letter == ')' || letter == ']';
        if (depth == 0)
            return entries + (isEmpty ? 0 : 1);
        if (depth == 1 && (letter == ',' || letter == ';')) {
            entries += isEmpty ? 0 : 1;
            isEmpty = true;
        } else if (!std::isspace(static_cast<unsigned char>(letter))) {
            isEmpty = false;
        }
    }
    return {};
}

}  // namespace bcflight
