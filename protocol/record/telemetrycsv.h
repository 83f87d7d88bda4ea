// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/telemetry/channelspec.h"
#include "protocol/telemetry/telemetrystore.h"

class QIODevice;

/// Writes samples as CSV: a heading "time_s,key [unit],...", then a line for each row of each stream in order
/// of time; channels that are not in that row are left empty, and so are lost samples. Numbers have a decimal
/// point.
/// @param from,to seconds since the store's origin. Returns the number of lines. Errors: BadFile.
Result<qint64> writeTelemetryCsv(QIODevice &file, const TelemetryStore &store, ChannelTable table,
                                 const QList<int> &channels, double from, double to);
