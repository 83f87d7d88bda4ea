// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/choice.h"

#include <QString>

#include <span>

/// The declaration of a telemetry quantity: one row of a family's table; its id is its position there.
struct ChannelSpec
{
    const char *key = "";  ///< "imu.angle.roll": files, command line
    const char *label = "";
    const char *group = "";
    const char *unit = "";
    int decimals = 0;
    Axis axis = Axis::None;
    double min = 0;  ///< usual range, for gauges and fixed scales
    double max = 0;
    /// Meaning of the channel, independent of the family: "attitude.roll", "motor.3.output", "armed"; several
    /// separated by spaces. See roles.h.
    const char *role = "";
    const char *capability = "";  ///< required of the board; without it the channel has no meaning
    int elements
        = 1;  ///< more than 1: an array, like a spectrum with 257 bins; kept whole, not plotted over time
    std::span<const Choice> choices{};  ///< what its values mean
    bool areBits = false;  ///< the choices are the bits of its values
};

using ChannelTable = std::span<const ChannelSpec>;

/// Position of a channel in the table, or -1.
inline int findChannel(ChannelTable table, const QString &key)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (key == QLatin1String(table[i].key))
            return static_cast<int>(i);
    }
    return -1;
}
