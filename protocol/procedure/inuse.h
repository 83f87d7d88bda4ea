// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/writereport.h"

class Channel;
class Device;

/// Whether reading back proves that a value is in use, and not that it is stored: it can be set live, and the
/// board does not tell the two apart.
[[nodiscard]] bool answersWithUse(const Device &device);
/// What is in use in the active profile otherwise than stored, on a board that loads what is written: a write
/// replaces it. Nothing on a board that stores everything in use at once (WholeMemory), or that answers
/// questions for what is stored with what is in use: there nobody can tell.
/// @param stored what the board answered for what is stored
[[nodiscard]] std::vector<OtherValue> readReplaceable(Channel &channel, Device &device,
                                                      const Configuration &stored);
/// These of them the board does not use any more.
[[nodiscard]] std::vector<OtherValue> findReplaced(Channel &channel, Device &device,
                                                   std::vector<OtherValue> before);
/// The same configuration with what is in use in the active profile, where the board answers for that apart
/// from what it answers for its parameters.
[[nodiscard]] Configuration withInUse(Channel &channel, Device &device, Configuration answered);
