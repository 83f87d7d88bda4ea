// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/luacheck.h"

#include "protocol/bcflight/blocks.h"
#include "protocol/bcflight/luatext.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <luajit-2.1/lua.hpp>
#include <memory>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

ScriptMistake mistakeAt(const QByteArray &text, qsizetype position, const char *what)
{
    return {0, lineAt(text, position), what, {}};
}

// "line:12: '=' expected near 'x'".
ScriptMistake compilerMistake(const QString &message)
{
    static const QRegularExpression form(u"^line:(\\d+): (.*)$"_s,
                                         QRegularExpression::DotMatchesEverythingOption);
    const auto match = form.match(message);
    return {0,
            match.hasMatch() ? match.captured(1).toInt() : 0,
            "%1",
            {match.hasMatch() ? match.captured(2) : message}};
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
    // An escape of later versions, which can only stand in a string: where it is one, the text without
    // strings does not have it.
    const QByteArray code = onlyCode(text);
    if (code.trimmed().isEmpty())
        return ScriptMistake{
            0, 0, QT_TRANSLATE_NOOP("Tables", "it sets nothing; the drone would not start with it"), {}};
    for (qsizetype at = text.indexOf("\\u{"); at >= 0; at = text.indexOf("\\u{", at + 1)) {
        const bool isEscaped = at > 0 && text.at(at - 1) == '\\';
        const bool isComment = text.lastIndexOf("--", at) > text.lastIndexOf('\n', at);
        if (code.mid(at, 3) != "\\u{" && !isEscaped && !isComment)
            return mistakeAt(text, at, QT_TRANSLATE_NOOP("Tables", "the drone's Lua does not know \\u{}"));
    }
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
