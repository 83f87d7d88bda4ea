// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace bcflight {

/// Gains are in use and not stored: the drone forgets them when it restarts. What is stored is the text.
enum Block : std::uint8_t { Gains, ConfigurationText };

}  // namespace bcflight
