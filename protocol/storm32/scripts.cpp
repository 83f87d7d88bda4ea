// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/scripts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr int kEnd = 0xFF;
constexpr int kStop = 0x00;
constexpr int kRestart = 0x01;
constexpr int kRepeat = 0x02;
constexpr int kFirstCase = 0x03;
constexpr int kLastCase = 0x06;
constexpr int kOffsets = kScriptCount;
constexpr double kAnglesPerDegree = 100.0;
constexpr double kSameAngle = 1e-6;  // steps: what a decimal fraction is not exact by

/// An argument of a statement, in the text and on the wire.
struct Argument
{
    enum Kind { None, Parameter, Value, Angle, Byte, Signed, Word } kind = None;
    int min = 0;
    int max = 255;
};

constexpr Argument kParameter{Argument::Parameter};
constexpr Argument kValue{Argument::Value, -32768, 65535};
constexpr Argument kAngle{Argument::Angle, -325, 325};
constexpr Argument kByte{Argument::Byte, 0, 255};
constexpr Argument kSteps{Argument::Signed, -128, 127};
constexpr Argument kPulseArgument{Argument::Word, 700, 2300};

struct Statement
{
    int code;
    const char *word;
    std::array<Argument, 3> arguments{};
    int since = 0;
    bool offset = false;  ///< a byte that the compiler fills in
    bool compiles = true;  ///< false: shown by the original tool, but not compiled
};

// Errata 8.
// clang-format off
constexpr Statement kStatements[] = {
    {kStop, "STOP"},
    {kRestart, "RESTART"},
    {kRepeat, "REPEAT", {}, 0, true},
    {0x03, "CASE#DEFAULT", {}, 0, true},
    {0x04, "CASE#1", {}, 0, true},
    {0x05, "CASE#2", {}, 0, true},
    {0x06, "CASE#3", {}, 0, true},
    {0x07, "JUMP", {kByte}, 0, false, false},
    {0x08, "RESTOREALL"},
    {0x09, "WAIT", {kByte}},
    {0x0A, "SET", {kParameter, kValue}},
    {0x0B, "SETMINMAX", {kParameter, kValue, kValue}},
    {0x0C, "RESTORE", {kParameter}},
    {0x0D, "SETANGLEPITCH", {kAngle}, 76},
    {0x0E, "SETANGLEROLL", {kAngle}, 76},
    {0x0F, "SETANGLEYAW", {kAngle}, 76},
    {0x10, "SETANGLE", {kAngle, kAngle, kAngle}, 76},
    {0x11, "SETPITCH", {kPulseArgument}, 76, false, false},
    {0x12, "SETROLL", {kPulseArgument}, 76, false, false},
    {0x13, "SETYAW", {kPulseArgument}, 76, false, false},
    {0x14, "SETPITCHROLLYAW", {kPulseArgument, kPulseArgument, kPulseArgument}, 76, false, false},
    {0x15, "SETSTANDBY", {Argument{Argument::Byte, 0, 1}}, 76},
    {0x16, "DOCAMERA", {Argument{Argument::Byte, 0, 4}}, 76},
    {0x17, "DORECENTER", {}, 76},
    {0x18, "SETPWM", {kPulseArgument}, 76},
    {0x19, "SETPANOWAITS", {kByte, kByte, kByte}, 91},
    {0x1A, "SETPANORANGE", {Argument{Argument::Word, 0, 720}}, 91},
    {0x1B, "DOPANO", {kSteps, kSteps}, 91},
    {0x1C, "SETANGLEPITCH_W", {kAngle, kByte}, 91},
    {0x1D, "SETANGLEROLL_W", {kAngle, kByte}, 91},
    {0x1E, "SETANGLEYAW_W", {kAngle, kByte}, 91},
    {0x1F, "REMOTEENABLE", {}, 95},
    {0x20, "REMOTEDISABLE", {}, 95},
};
// clang-format on

constexpr int wireBytes(Argument::Kind kind)
{
    switch (kind) {
    case Argument::None: return 0;
    case Argument::Parameter:
    case Argument::Byte:
    case Argument::Signed: return 1;
    case Argument::Value:
    case Argument::Angle:
    case Argument::Word: return 2;
    }
    return 0;
}

int sizeOf(const Statement &statement)
{
    int size = 1 + (statement.offset ? 1 : 0);
    for (const Argument &argument : statement.arguments)
        size += wireBytes(argument.kind);
    return size;
}

const Statement *findCode(int code)
{
    const auto it = std::find_if(std::begin(kStatements), std::end(kStatements),
                                 [code](const Statement &statement) { return statement.code == code; });
    return it == std::end(kStatements) ? nullptr : it;
}

const Statement *findWord(const QString &word)
{
    const auto it
        = std::find_if(std::begin(kStatements), std::end(kStatements), [&word](const Statement &statement) {
              return word.compare(QLatin1String(statement.word), Qt::CaseInsensitive) == 0;
          });
    return it == std::end(kStatements) ? nullptr : it;
}

bool isCase(int code)
{
    return code >= kFirstCase && code <= kLastCase;
}

bool endsCase(int code)
{
    return code == kStop || code == kRestart || code == kRepeat;
}

// Words separated by spaces; a quoted name is one word, without its quotes. Empty: a quote is not closed.
std::optional<QStringList> tokensOf(const QString &line)
{
    QStringList words;
    for (qsizetype at = 0; at < line.size();) {
        if (line[at].isSpace()) {
            ++at;
            continue;
        }
        const bool quoted = line[at] == u'"';
        qsizetype end = at + 1;
        while (end < line.size() && (quoted ? line[end] != u'"' : !line[end].isSpace()))
            ++end;
        if (quoted && end == line.size())
            return {};
        words.append(quoted ? line.mid(at + 1, end - at - 1) : line.mid(at, end - at));
        at = quoted ? end + 1 : end;
    }
    return words;
}

/// Compiles the text of one script into code.
class Compiler
{
public:
    Compiler(const ScriptContext &context, int script, bool isHeld)
        : m_context(context)
        , m_script(script)
        , m_isHeld(isHeld)
    {
    }

    CompiledScripts compile(const QString &text)
    {
        const QStringList lines = text.split(u'\n');
        for (m_line = 1; m_line <= lines.size(); ++m_line) {
            const QString line = lines[m_line - 1].trimmed();
            if (line.isEmpty() || line.startsWith(u"//"_s) || line.startsWith(u';'))
                continue;
            if (const auto done = statement(line); !done)
                return tl::unexpected(done.error());
        }
        if (m_code.isEmpty())
            return QByteArray();
        closeCase();
        m_code.append(char(kEnd));
        if (m_code.size() > kScriptArea) {
            m_line = 0;
            return wrong(QT_TRANSLATE_NOOP("Tables", "it is too long"));
        }
        return m_code;
    }

private:
    using Done = tl::expected<void, ScriptMistake>;

    tl::unexpected<ScriptMistake> wrong(const char *what, const QStringList &values = {}) const
    {
        return tl::unexpected(ScriptMistake{m_script, int(m_line), what, values});
    }

    Done statement(const QString &line)
    {
        const auto words = tokensOf(line);
        if (!words)
            return wrong(QT_TRANSLATE_NOOP("Tables", "a quote is not closed"));
        const Statement *known = findWord(words->first());
        if (!known)
            return wrong(QT_TRANSLATE_NOOP("Tables", "'%1' is not a statement"), {words->first()});
        const QString word = QLatin1String(known->word);
        if (!known->compiles)
            return wrong(QT_TRANSLATE_NOOP("Tables", "%1 is shown only; use %2"), {word, u"SETANGLE"_s});
        if (known->since > m_context.firmware)
            return wrong(QT_TRANSLATE_NOOP("Tables", "firmware 0.%1 does not know %2"),
                         {QString::number(m_context.firmware), word});
        const auto wanted
            = std::count_if(known->arguments.begin(), known->arguments.end(),
                            [](const Argument &argument) { return argument.kind != Argument::None; });
        if (words->size() - 1 != wanted)
            return wrong(QT_TRANSLATE_NOOP("Tables", "%1 takes %2 values, not %3"),
                         {word, QString::number(wanted), QString::number(words->size() - 1)});
        if (isCase(known->code)) {
            if (const auto begun = beginCase(*known); !begun)
                return begun;
        }
        m_code.append(char(known->code));
        m_last = known->code;
        if (known->offset)  // a case gets its end later
            m_code.append(char(known->code == kRepeat ? std::max(m_case, 0) : 0));
        const ScriptParameter *parameter = nullptr;
        for (qsizetype i = 0; i < wanted; ++i) {
            const auto written = argument(known->arguments[std::size_t(i)], words->at(i + 1), parameter);
            if (!written)
                return written;
        }
        return {};
    }

    // Cases occur once each and without gaps, the default one first.
    Done beginCase(const Statement &known)
    {
        const QString word = QLatin1String(known.word);
        if (known.code < kFirstCase + m_cases)
            return wrong(QT_TRANSLATE_NOOP("Tables", "%1 is there already"), {word});
        if (known.code > kFirstCase + m_cases)
            return wrong(QT_TRANSLATE_NOOP("Tables", "%1 has to come before %2"),
                         {QLatin1String(findCode(kFirstCase + m_cases)->word), word});
        closeCase();
        ++m_cases;
        m_case = int(m_code.size());
        return {};
    }

    // A case that would run into the next one ends with a stop; its offset is set to where the next one
    // begins.
    void closeCase()
    {
        if (!m_code.isEmpty() && !endsCase(m_last)) {
            m_code.append(char(kStop));
            m_last = kStop;
        }
        if (m_case >= 0)
            m_code[m_case + 1] = char(std::min<qsizetype>(m_code.size(), 255));
    }

    Done argument(const Argument &wanted, const QString &text, const ScriptParameter *&parameter)
    {
        if (wanted.kind == Argument::Parameter) {
            const auto it = std::find_if(m_context.parameters.begin(), m_context.parameters.end(),
                                         [&text](const ScriptParameter &each) {
                                             return each.name.compare(text, Qt::CaseInsensitive) == 0;
                                         });
            parameter = it == m_context.parameters.end() ? nullptr : &*it;
            bool numbered = false;
            const int index = parameter ? parameter->index
                : text.startsWith(u'#') ? text.mid(1).toInt(&numbered)
                                        : -1;
            // A number is as good as a name, but only of a parameter that there is.
            for (const ScriptParameter &each : m_context.parameters) {
                if (numbered && each.index == index)
                    parameter = &each;
            }
            const bool isThere = parameter || (numbered && index >= 0 && index < 256);
            if (!isThere || (!m_isHeld && index >= m_context.words))
                return wrong(QT_TRANSLATE_NOOP("Tables", "there is no parameter “%1”"), {text});
            m_code.append(char(index));
            return {};
        }
        bool ok = false;
        const double number = text.toDouble(&ok);
        if (!ok || !std::isfinite(number))
            return wrong(QT_TRANSLATE_NOOP("Tables", "'%1' is not a number"), {text});
        if (wanted.kind != Argument::Angle && number != std::floor(number))
            return wrong(QT_TRANSLATE_NOOP("Tables", "'%1' has to be a whole number"), {text});
        int min = wanted.min;
        int max = wanted.max;
        if (wanted.kind == Argument::Value && parameter) {
            min = std::max(parameter->isSigned ? -32768 : 0, m_isHeld ? wanted.min : parameter->min);
            max = std::min(parameter->isSigned ? 32767 : 65535, m_isHeld ? wanted.max : parameter->max);
        }
        if (number < min || number > max)
            return wrong(QT_TRANSLATE_NOOP("Tables", "%1 is outside %2 to %3"),
                         {text, QString::number(min), QString::number(max)});
        const bool isStepped = wanted.kind == Argument::Value && parameter && !m_isHeld;
        if (isStepped && !parameter->choices.isEmpty() && !parameter->choices.contains(int(number)))
            return wrong(QT_TRANSLATE_NOOP("Tables", "“%1” cannot be %2"), {parameter->name, text});
        if (isStepped && (int(number) - min) % parameter->step != 0)
            return wrong(QT_TRANSLATE_NOOP("Tables", "“%1” cannot be %2"), {parameter->name, text});
        const double steps = wanted.kind == Argument::Angle ? number * kAnglesPerDegree : number;
        const int raw = int(std::lround(steps));
        if (std::abs(steps - raw) > kSameAngle)
            return wrong(QT_TRANSLATE_NOOP("Tables", "a board cannot hold %1: the nearest is %2"),
                         {text, QString::number(raw / kAnglesPerDegree)});
        if (wireBytes(wanted.kind) == 1)
            m_code.append(char(raw));
        else
            m_code.append(ByteWriter().u16(raw & 0xFFFF).take());
        return {};
    }

    const ScriptContext &m_context;
    int m_script;
    bool m_isHeld;
    qsizetype m_line = 0;
    QByteArray m_code;
    int m_cases = 0;
    int m_case = -1;  // offset of the present case
    int m_last = kStop;
};

QString argumentText(const Argument &argument, ByteReader &reader, const ScriptContext &context,
                     const ScriptParameter *&parameter)
{
    switch (argument.kind) {
    case Argument::None: break;
    case Argument::Parameter: {
        const int index = reader.u8();
        const auto it = std::find_if(context.parameters.begin(), context.parameters.end(),
                                     [index](const ScriptParameter &each) { return each.index == index; });
        parameter = it == context.parameters.end() ? nullptr : &*it;
        return u" \"%1\""_s.arg(parameter ? parameter->name : u"#%1"_s.arg(index));
    }
    case Argument::Value:
        return u' '
            + (parameter && parameter->isSigned ? QString::number(reader.i16())
                                                : QString::number(reader.u16()));
    case Argument::Angle: return u' ' + QString::number(reader.i16() / kAnglesPerDegree);
    case Argument::Byte: return u' ' + QString::number(reader.u8());
    case Argument::Signed: return u' ' + QString::number(reader.i8());
    case Argument::Word: return u' ' + QString::number(reader.u16());
    }
    return {};
}

}  // namespace

std::vector<ScriptLine> disassemble(QByteArrayView area, int script, const ScriptContext &context)
{
    std::vector<ScriptLine> lines;
    if (script < 0 || script >= kScriptCount || area.size() < kOffsets)
        return lines;
    const int start = std::uint8_t(area[script]);
    if (start == kEnd || start < kOffsets || start >= area.size())
        return lines;
    const QByteArrayView code = area.sliced(start);
    for (qsizetype at = 0; at < code.size();) {
        const int op = std::uint8_t(code[at]);
        if (op == kEnd)
            break;
        const Statement *known = findCode(op);
        const qsizetype size = known ? sizeOf(*known) : 1;
        ScriptLine line{int(at), int(size), {}};
        if (!known || at + size > code.size()) {
            line.size = 1;
            line.text = u"?? %1"_s.arg(op, 2, 16, QChar(u'0')).toUpper();
            lines.push_back(line);
            ++at;
            continue;
        }
        ByteReader reader(code.sliced(at + 1, size - 1));
        if (known->offset)
            reader.u8();
        line.text = QString::fromLatin1(known->word);
        const ScriptParameter *parameter = nullptr;
        for (const Argument &argument : known->arguments)
            line.text += argumentText(argument, reader, context, parameter);
        lines.push_back(line);
        at += size;
    }
    return lines;
}

ScriptEffect scriptEffect(QByteArrayView area, int script, const ScriptContext &context)
{
    constexpr int kRestoreAll = 0x08;
    constexpr std::array kChanging{0x0A, 0x0B, 0x0C};  // SET, SETMINMAX, RESTORE
    ScriptEffect effect;
    for (const ScriptLine &line : disassemble(area, script, context)) {
        const qsizetype at = std::uint8_t(area[script]) + line.offset;
        const int op = std::uint8_t(area[at]);
        effect.all |= op == kRestoreAll;
        if (line.size > 1 && std::find(kChanging.begin(), kChanging.end(), op) != kChanging.end())
            effect.parameters.push_back(std::uint8_t(area[at + 1]));
    }
    return effect;
}

QString scriptText(QByteArrayView area, int script, const ScriptContext &context)
{
    QString text;
    for (const ScriptLine &line : disassemble(area, script, context)) {
        const bool label = line.text.startsWith(u"CASE#"_s);
        text += (label ? QString() : u"  "_s) + line.text + u'\n';
    }
    return text;
}

CompiledScripts compileScripts(const std::array<QString, kScriptCount> &texts, const ScriptContext &context,
                               const std::array<bool, kScriptCount> &held)
{
    QByteArray area(kOffsets, char(kEnd));
    for (int script = 0; script < kScriptCount; ++script) {
        const auto code
            = Compiler(context, script, held[std::size_t(script)]).compile(texts[std::size_t(script)]);
        if (!code)
            return code;
        if (code->isEmpty())
            continue;
        if (area.size() + code->size() > kScriptArea) {
            return tl::unexpected(
                ScriptMistake{script,
                              0,
                              QT_TRANSLATE_NOOP("Tables", "with it the scripts need %1 bytes; there are %2"),
                              {QString::number(area.size() + code->size()), QString::number(kScriptArea)}});
        }
        area[script] = char(area.size());
        area.append(*code);
    }
    area.append(kScriptArea - area.size(), char(kEnd));
    return area;
}

QStringList scriptWords(int firmware)
{
    QStringList words;
    for (const Statement &statement : kStatements) {
        if (statement.compiles && statement.since <= firmware)
            words.append(QString::fromLatin1(statement.word));
    }
    return words;
}

}  // namespace storm32
