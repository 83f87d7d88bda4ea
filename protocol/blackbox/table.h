// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/blackboxwire.h"
#include "protocol/telemetry/channelspec.h"

#include <deque>
#include <map>

namespace blackbox {

/// The channels of a black box. Made once for each set of names and kept, so that it is as constant as other
/// families' tables.
struct Table
{
    /// The channels of one name, in the order of its list.
    struct Columns
    {
        QList<int> channels;
    };

    std::vector<ChannelSpec> channels;
    std::map<QByteArray, Columns, std::less<>> columns;
    std::deque<QByteArray> words;  // that the channels point to

    [[nodiscard]] const Columns *find(QByteArrayView name) const;
};

/// What is known of a name counts ("IMU:rate" is an angular rate); others become channels by their name.
[[nodiscard]] const Table &tableOf(const std::vector<blackboxwire::Name> &names);

}  // namespace blackbox
