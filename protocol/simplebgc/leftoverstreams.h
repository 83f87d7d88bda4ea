// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <vector>

class Channel;

namespace simplebgc {

/// A data stream that a program has left behind: what the board sends, and how often.
struct LeftoverStream
{
    int command = 0;
    int size = 0;  ///< payload in bytes
    double rate = 0;  ///< frames per second
};

/// How the board is spoken to.
struct Speech
{
    int firmware = 0;
    int frameVersion = 1;
};

/// Listens for streams that this connection did not order and stops them; to be called before anything is
/// requested that they could be taken for. A stream is stopped by naming its command and its configuration
/// (errata 3.10); that of CUSTOM is not in what it sends, so those that fit its size are named one after the
/// other. Whether it stopped is told by what arrives. Returns what goes on all the same. Errors: Cancelled,
/// LinkClosed.
Result<std::vector<LeftoverStream>> stopLeftoverStreams(Channel &channel, const Speech &speech);

/// The fields that a frame of CUSTOM with this payload may consist of, the likely ones first; at most
/// `limit`.
[[nodiscard]] std::vector<quint32> customFlagsOfSize(int size, int firmware, std::size_t limit);

}  // namespace simplebgc
