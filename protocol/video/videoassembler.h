// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/video/videotypes.h"

#include <functional>

/// Puts the datagrams of a video port together to encoded frames (errata 10): one frame per write, and a
/// datagram of exactly 65000 bytes says that the frame goes on in the next one. Nothing numbers them: that
/// one was lost shows only in what the frames say of themselves (VideoInspector).
class VideoAssembler
{
public:
    static constexpr std::size_t kPiece = 65000;
    /// More than any picture has: what is longer is thrown away.
    static constexpr qsizetype kLargest = 8 * 1024 * 1024;

    using Sink = std::function<void(const EncodedFrame &)>;

    /// A frame whose last piece was lost ends where the next one begins.
    /// @param at when the datagram came; @param waited until it was read
    void take(Bytes datagram, TimePoint at, const Sink &frame, Duration waited = {});
    void reset();

private:
    EncodedFrame m_open;
    bool m_isTooLong = false;
};

/// Whether these bytes begin a picture: of H.264 with parameter sets, a delimiter or a first slice, or a
/// JPEG.
[[nodiscard]] bool beginsPicture(Bytes bytes);
