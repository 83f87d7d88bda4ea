// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"

/// One intact frame as it lies in the framer's buffer. Valid during the call that hands it out.
struct FrameView
{
    int id = 0;  ///< the family's own command or message number
    Bytes payload;
    int version = 1;  ///< frame format, where a family has more than one
    Bytes raw = {};  ///< all of the frame, first byte to checksum; empty where it was not on a wire
};

/// A frame that is kept.
struct Frame
{
    int id = 0;
    QByteArray payload;
    int version = 1;

    Frame() = default;
    Frame(int frameId, QByteArray data, int frameVersion = 1)
        : id(frameId)
        , payload(std::move(data))
        , version(frameVersion)
    {
    }
    explicit Frame(const FrameView &view)
        : id(view.id)
        , payload(toByteArray(view.payload))
        , version(view.version)
    {
    }

    friend bool operator==(const Frame &, const Frame &) = default;
};
