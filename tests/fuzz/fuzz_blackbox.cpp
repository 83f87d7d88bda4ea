// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recording.h"
#include "protocol/telemetry/blackbox.h"
#include "protocol/telemetry/blackboxwire.h"

// A black box from any drone, and from any disk.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    const auto box = BlackBox::read(bytes);
    if (!box)
        return 0;
    qint64 last = box->lines().front().at;
    for (const BlackBox::Line &line : box->lines()) {
        const bool isInside = line.from >= 0 && line.size >= 0 && line.from + line.size <= bytes.size();
        if (line.at < last || line.name < 0 || line.name >= box->names().size() || !isInside)
            __builtin_trap();
        if (int(BlackBox::numbers(box->value(line)).size()) > box->elements(line.name))
            __builtin_trap();
        last = line.at;
    }
    const Recording recording = recordingOf(*box);
    const auto names = blackboxwire::readNames(QByteArrayView(recording.pieces[1].bytes).chopped(1));
    if (!names || qsizetype(names->size()) != box->names().size())
        __builtin_trap();
    std::ignore = recording.leftOut();
    return 0;
}
