// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/luacheck.h"

#include "protocol/bcflight/luatext.h"

#include <luajit-2.1/lua.hpp>
#include <memory>

using namespace Qt::StringLiterals;

namespace bcflight {

Result<void> checkSyntax(const QByteArray &text)
{
    if (const qsizetype zero = text.indexOf('\0'); zero >= 0)
        return failure(ErrorCode::InvalidArgument, u"line %1: a zero byte"_s.arg(lineAt(text, zero)));
    const std::unique_ptr<lua_State, decltype(&lua_close)> state(luaL_newstate(), lua_close);
    if (!state)
        return failure(ErrorCode::TooMuch, u"there is no memory to check the text"_s);
    // "t": text alone; what is compiled beforehand could be anything.
    if (luaL_loadbufferx(state.get(), text.constData(), size_t(text.size()), "=line", "t") != 0) {
        const char *said = lua_tostring(state.get(), -1);
        QString message = QString::fromUtf8(said ? said : "?");
        message.replace(u"line:"_s, u"line "_s);
        return failure(ErrorCode::InvalidArgument, message);
    }
    // An escape of later versions, which can only stand in a string: where it is one, the text without
    // strings does not have it.
    const QByteArray code = onlyCode(text);
    for (qsizetype at = text.indexOf("\\u{"); at >= 0; at = text.indexOf("\\u{", at + 1)) {
        const bool isEscaped = at > 0 && text.at(at - 1) == '\\';
        const bool isComment = text.lastIndexOf("--", at) > text.lastIndexOf('\n', at);
        if (code.mid(at, 3) != "\\u{" && !isEscaped && !isComment)
            return failure(ErrorCode::InvalidArgument,
                           u"line %1: the drone's Lua does not know \\u{}"_s.arg(lineAt(text, at)));
    }
    return {};
}

}  // namespace bcflight
