// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/record/configurationfile.h"

#include <tuple>

// Any file: understood or refused, never a crash.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray json(reinterpret_cast<const char *>(data), qsizetype(size));
    if (const auto file = ConfigurationFile::fromJson(json, parametersFor)) {
        QStringList skipped;
        std::ignore = applied(file->configuration, file->configuration, skipped);
    }
    return 0;
}
