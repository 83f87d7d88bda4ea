// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/livevalues.h"

#include <tuple>

Configuration withoutLive(Configuration read, const LiveValues &live)
{
    for (const LiveValue &value : live) {
        const ParameterSpec *spec = read.parameters().find(value.key);
        if (spec && sameValue(read.raw(*spec, read.activeProfile()), value.inUse))
            std::ignore = read.restoreRaw(*spec, read.activeProfile(), value.stored);
    }
    return read;
}

QByteArray withoutLive(QByteArray bytes, int block, const ParameterSet &parameters, const LiveValues &live)
{
    for (const LiveValue &value : live) {
        const ParameterSpec *spec = parameters.find(value.key);
        if (spec && spec->row->block == block && sameValue(spec->read(bytes), value.inUse))
            spec->write(bytes, value.stored);
    }
    return bytes;
}
