// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/device.h"
#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/simulator/simplebgc/board.h"

/// A simulated SimpleBGC board, its cable and a virtual channel to it: family code in one thread, in
/// microseconds.
struct VirtualBoard
{
    explicit VirtualBoard(const SimulatorOptions &options = {}, std::optional<LineSettings> line = {})
        : port(std::make_unique<simplebgc::SimulatedBoard>(options), options, line)
        , channel(port, family.makeFramer(), family.timing)
    {
    }

    simplebgc::SimulatedBoard &board() { return static_cast<simplebgc::SimulatedBoard &>(port.board()); }
    /// Identifies the board; most of the device's tables exist only afterwards.
    bool identify() { return device.identify(channel).has_value(); }

    const Family family = simplebgc::family();
    simplebgc::Device device;
    SimulatedPort port;
    VirtualChannel channel;
};

/// A board with this firmware, e.g. 2663.
inline SimulatorOptions withFirmware(int firmware)
{
    SimulatorOptions options;
    options.firmware = firmware;
    return options;
}

/// Arguments of an action as an operator types them; the others as they are at first.
inline QVariantMap argumentsFor(const Device &device, const char *key,
                                const QMap<QString, QString> &texts = {})
{
    for (const ActionSpec &action : device.actions()) {
        if (qstrcmp(action.key, key) == 0)
            return parseArguments(action, texts).value();
    }
    return {};
}

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
