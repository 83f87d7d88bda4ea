// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QIODevice>

#include <span>
#include <vector>

/// Input and output of a system, evenly spaced.
struct ResponseSamples
{
    double rate = 0;  ///< samples per second
    bool rateAssumed = false;  ///< the file does not state it
    std::vector<float> in;
    std::vector<float> out;
};

/// Two columns in;out as other tools read them, after a line with the rate. Errors: BadFile.
Result<void> writeResponseCsv(QIODevice &file, std::span<const float> in, std::span<const float> out,
                              double rate);

/// Reads in;out: a comma or a tab is accepted too, and a heading is skipped. "# 1000 samples/s" gives the
/// rate. Errors: BadFile, with the line.
/// @param assumedRate samples per second of a file that does not state its rate (see fullRate()); 0: such a
/// file is an error
[[nodiscard]] Result<ResponseSamples> readResponseCsv(const QByteArray &text, double assumedRate);
