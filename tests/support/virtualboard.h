// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/sbgcdevice.h"
#include "protocol/simulator/sbgcboard.h"
#include "protocol/simulator/virtualchannel.h"

/// A simulated SimpleBGC board, its cable and a virtual channel to it: family code in one thread, in
/// microseconds.
struct VirtualBoard
{
    explicit VirtualBoard(const SimulatorOptions &options = {}, std::optional<LineSettings> line = {})
        : port(std::make_unique<SbgcBoard>(options), options, line)
        , channel(port, device.makeFramer())
    {
    }

    SbgcBoard &board() { return static_cast<SbgcBoard &>(port.board()); }
    /// Identifies the board; most of the device's tables exist only afterwards.
    bool identify() { return device.identify(channel).has_value(); }

    SbgcDevice device;
    SimulatedPort port;
    VirtualChannel channel;
};

/// Bytes from hex text with blanks.
inline QByteArray hex(const char *text)
{
    return QByteArray::fromHex(QByteArray(text));
}

/// A payload whose byte i has the value i: shows a decoder's offsets (errata section 8, "ramp frames").
inline QByteArray ramp(int size)
{
    QByteArray bytes(size, '\0');
    for (int i = 0; i < size; ++i)
        bytes[i] = static_cast<char>(i);
    return bytes;
}
