// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/luacheck.h"

#include "protocol/bcflight/blocks.h"
#include "protocol/bcflight/luatext.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>
#include <luajit-2.1/lua.hpp>
#include <memory>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

ScriptMistake mistakeAt(const QByteArray &text, qsizetype position, const char *what)
{
    return {0, lineAt(text, position), what, {}};
}

// What the compiler says (LuaJIT 2.1, lj_errmsg.h), with or without the place: "… near 'x'". What is not here
// stays in its own words.
struct Saying
{
    const char *form;  // a regular expression for the whole
    const char *plain;
    const char *near;  // with the place as the last value
};

constexpr std::array kSayings{
    Saying{"'(.+)' expected \\(to close '(.+)' at line (\\d+)\\)",
           QT_TRANSLATE_NOOP("Tables", "'%1' is missing, which closes '%2' of line %3"),
           QT_TRANSLATE_NOOP("Tables", "'%1' is missing before '%4', which closes '%2' of line %3")},
    Saying{"<name> or '...' expected", QT_TRANSLATE_NOOP("Tables", "a name or '...' is missing"),
           QT_TRANSLATE_NOOP("Tables", "a name or '...' is missing before '%1'")},
    Saying{"'=' or 'in' expected", QT_TRANSLATE_NOOP("Tables", "'=' or 'in' is missing"),
           QT_TRANSLATE_NOOP("Tables", "'=' or 'in' is missing before '%1'")},
    Saying{"function arguments expected", QT_TRANSLATE_NOOP("Tables", "the arguments of a call are missing"),
           QT_TRANSLATE_NOOP("Tables", "the arguments of a call are missing before '%1'")},
    Saying{"'(.+)' expected", QT_TRANSLATE_NOOP("Tables", "'%1' is missing"),
           QT_TRANSLATE_NOOP("Tables", "'%1' is missing before '%2'")},
    Saying{"unexpected symbol", QT_TRANSLATE_NOOP("Tables", "a symbol that cannot stand here"),
           QT_TRANSLATE_NOOP("Tables", "'%1' cannot stand here")},
    Saying{"syntax error", QT_TRANSLATE_NOOP("Tables", "this is not a statement"),
           QT_TRANSLATE_NOOP("Tables", "this is not a statement: '%1'")},
    Saying{"malformed number", QT_TRANSLATE_NOOP("Tables", "this is not a number"),
           QT_TRANSLATE_NOOP("Tables", "this is not a number: '%1'")},
    Saying{"unfinished (?:long )?string", QT_TRANSLATE_NOOP("Tables", "a string does not end"),
           QT_TRANSLATE_NOOP("Tables", "a string does not end: '%1'")},
    Saying{"unfinished long comment", QT_TRANSLATE_NOOP("Tables", "a comment does not end"),
           QT_TRANSLATE_NOOP("Tables", "a comment does not end: '%1'")},
    Saying{"invalid escape sequence", QT_TRANSLATE_NOOP("Tables", "an escape that this Lua does not know"),
           QT_TRANSLATE_NOOP("Tables", "an escape that this Lua does not know: '%1'")},
};

// 'line:12: '=' expected near 'x''.
ScriptMistake compilerMistake(const QString &message)
{
    static const QRegularExpression form(u"^line:(\\d+): (.*?)(?: near '(.*)')?$"_s,
                                         QRegularExpression::DotMatchesEverythingOption);
    const auto match = form.match(message);
    if (!match.hasMatch())
        return {0, 0, "%1", {message}};
    for (const Saying &saying : kSayings) {
        const auto said = QRegularExpression(QRegularExpression::anchoredPattern(QLatin1String(saying.form)))
                              .match(match.captured(2));
        if (!said.hasMatch())
            continue;
        QStringList values = said.capturedTexts().mid(1);
        if (!match.hasCaptured(3) || match.captured(3) == u"<eof>"_s)
            return {0, match.captured(1).toInt(), saying.plain, values};
        values.append(match.captured(3).replace(u'\n', u' '));
        return {0, match.captured(1).toInt(), saying.near, values};
    }
    return {0, match.captured(1).toInt(), "%1", {message.mid(match.capturedStart(2))}};
}

}  // namespace

std::optional<ScriptMistake> findMistake(const QByteArray &text)
{
    if (const qsizetype zero = text.indexOf('\0'); zero >= 0)
        return mistakeAt(text, zero, QT_TRANSLATE_NOOP("Tables", "a zero byte"));
    const std::unique_ptr<lua_State, decltype(&lua_close)> state(luaL_newstate(), lua_close);
    if (!state)
        return ScriptMistake{0, 0, QT_TRANSLATE_NOOP("Tables", "there is no memory to check the text"), {}};
    // "t": text alone; what is compiled beforehand could be anything.
    if (luaL_loadbufferx(state.get(), text.constData(), size_t(text.size()), "=line", "t") != 0) {
        const char *said = lua_tostring(state.get(), -1);
        return compilerMistake(QString::fromUtf8(said ? said : "?"));
    }
    const QByteArray code = onlyCode(text);
    if (code.trimmed().isEmpty())
        return ScriptMistake{
            0, 0, QT_TRANSLATE_NOOP("Tables", "it sets nothing; the drone would not start with it"), {}};
    if (const qsizetype at = laterEscape(text); at >= 0)
        return mistakeAt(text, at, QT_TRANSLATE_NOOP("Tables", "the drone's Lua does not know \\u{}"));
    // Those of later versions of LuaJIT, which checks here.
    static const QRegularExpression binary(u"(?<![\\w.])0[bB][01]"_s);
    if (const auto match = binary.match(QString::fromLatin1(code)); match.hasMatch())
        return mistakeAt(text, match.capturedStart(),
                         QT_TRANSLATE_NOOP("Tables", "the drone's Lua does not know binary numbers"));
    return {};
}

Result<void> checkSyntax(const QByteArray &text)
{
    const auto mistake = findMistake(text);
    if (!mistake)
        return {};
    const QString sentence = mistake->sentence(QString::fromUtf8(mistake->what));
    Error error{ErrorCode::InvalidArgument,
                mistake->line > 0 ? u"line %1: %2"_s.arg(QString::number(mistake->line), sentence) : sentence,
                0};
    error.place = TextPlace{ConfigurationText, mistake->line};
    return tl::unexpected(error);
}

}  // namespace bcflight
