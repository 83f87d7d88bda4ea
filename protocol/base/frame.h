// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"

/// View of one intact frame in the framer's buffer. Valid only during the call that delivers it.
struct FrameView
{
    int id = 0;  ///< the family's own command or message number
    Bytes payload;
    int version = 1;  ///< frame format, where a family has more than one
    Bytes raw = {};  ///< the whole frame, first byte to checksum; empty if it was never on a wire
};

/// A frame that owns its payload.
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
