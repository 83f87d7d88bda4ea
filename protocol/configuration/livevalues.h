// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// A value that is in use on the board, but not stored: set live, in volatile memory.
struct LiveValue
{
    QString key;
    double stored = 0;
    double inUse = 0;
};
using LiveValues = std::vector<LiveValue>;

/// A board answers queries about its active profile from volatile memory, so values set live look as if they
/// were stored. This puts the stored values back into what was read; a value is left alone if the board
/// reports something other than the live value.
[[nodiscard]] Configuration withoutLive(Configuration read, const LiveValues &live);
/// The same for one block of the active profile.
[[nodiscard]] QByteArray withoutLive(QByteArray bytes, int block, const ParameterSet &parameters,
                                     const LiveValues &live);
