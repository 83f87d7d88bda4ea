// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/responsecsv.h"

// A text of two columns from any tool.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const auto samples
        = readResponseCsv(QByteArray(reinterpret_cast<const char *>(data), qsizetype(size)), 1000);
    if (samples && (samples->in.empty() || samples->in.size() != samples->out.size() || !(samples->rate > 0)))
        __builtin_trap();
    return 0;
}
