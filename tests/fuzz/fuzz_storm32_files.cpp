// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/files.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/scriptlanguage.h"

// Files of the original program, and texts of scripts. What was read can be written and read again; what
// compiles can be shown, and what is shown compiles to the same.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    if (const auto settings = storm32::readSettings(bytes)) {
        const auto text = storm32::writeSettings(settings->configuration);
        const auto again = text ? storm32::readSettings(*text) : tl::unexpected(text.error());
        if (!again || !settings->configuration.changesTo(again->configuration).empty())
            __builtin_trap();
    }
    if (const auto calibration = storm32::readCalibration(bytes)) {
        const auto again = storm32::readCalibration(storm32::writeCalibration(*calibration));
        if (!again || again->zero != calibration->zero || again->scale != calibration->scale)
            __builtin_trap();
    }
    static const Configuration board = [] {
        const auto set = std::make_shared<ParameterSet>(storm32::parameterRows(), storm32::blocksOf(95), 95,
                                                        Capabilities());
        Configuration made(BoardIdentity{}, set);
        made.setBlock({0, storm32::Scripts}, QByteArray(storm32::kScriptArea, char(0xFF)));
        return made;
    }();
    const auto language = storm32::scriptLanguage();
    if (const auto code = language->compile(board, {QString::fromLatin1(bytes)})) {
        Configuration with = board;
        with.setBlock({0, storm32::Scripts}, *code);
        const auto again = language->compile(board, {language->text(with, 0)});
        if (!again || *again != *code)
            __builtin_trap();
    }
    Configuration any = board;
    any.setBlock({0, storm32::Scripts},
                 bytes.left(storm32::kScriptArea).leftJustified(storm32::kScriptArea, '\0'));
    for (int script = 0; script < language->count(); ++script)
        std::ignore = language->text(any, script);
    return 0;
}
