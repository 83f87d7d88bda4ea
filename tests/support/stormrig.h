// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/simulator/storm32/board.h"
#include "protocol/storm32/device.h"

using namespace Qt::StringLiterals;

inline SimulatorOptions stormOptions(int firmware, bool usb = true)
{
    SimulatorOptions o;
    o.firmware = firmware;
    o.usb = usb;
    return o;
}

/// A simulated STorM32 board and a virtual channel to it.
struct StormRig
{
    explicit StormRig(const SimulatorOptions &o = stormOptions(96), std::optional<LineSettings> line = {})
        : options(o)
        , port(std::make_unique<storm32::SimulatedBoard>(o), o, line)
        , channel(port, family.makeFramer(), family.timing)
    {
    }
    storm32::SimulatedBoard &board() { return static_cast<storm32::SimulatedBoard &>(port.board()); }
    /// The board's heartbeat has locked plain commands out of its UART.
    void lockOut() { board().set(112, 1); }
    /// The world around the board changes.
    void change(const QString &fault)
    {
        if (!options.faults.set(fault))
            qFatal("no such fault: %s", qPrintable(fault));
        board().setFaults(options.faults);
    }

    /// The operator lays the camera on these faces, the next one as soon as a step of the job is done.
    void layOn(QList<int> poses)
    {
        change(u"pose=%1"_s.arg(poses.takeFirst()));
        channel.setOperator([this, poses, done = 0](const Progress &progress) mutable {
            if (progress.done != std::exchange(done, progress.done) && !poses.isEmpty())
                change(u"pose=%1"_s.arg(poses.takeFirst()));
        });
    }

    SimulatorOptions options;
    const Family family = storm32::family();
    storm32::Device device;
    SimulatedPort port;
    VirtualChannel channel;
};
