// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/clock.h"
#include "protocol/simulator/world/faults.h"
#include "protocol/transport/linkaddress.h"

#include <QMap>

#include <memory>
#include <optional>

/// A simulated controller without its cable: bytes in, bytes out, time in between. One per family.
class SimulatedBoard
{
public:
    virtual ~SimulatedBoard() = default;

    /// True for boards behind a network: what they get and give are packets, not a stream of bytes.
    [[nodiscard]] virtual bool isPacketBased() const { return false; }
    /// Bytes that reached the board's input buffer, or one packet.
    virtual void receive(Bytes bytes) = 0;
    /// One firmware cycle of 0.8 ms.
    virtual void cycle() = 0;
    /// Takes at most so many bytes out of the output buffer; from a board that works in packets the next
    /// packet, empty when there is none left.
    virtual QByteArray takeOutput(qsizetype max) = 0;
    /// False while the controller restarts and, on native USB, is gone from the bus.
    [[nodiscard]] virtual bool isRunning() const = 0;
    /// The only parity that its UART understands; nothing: it finds out which one the host uses.
    [[nodiscard]] virtual std::optional<Parity> onlyParity() const { return {}; }
    /// Frames of data streams that went out, and those that were skipped because nobody took them off.
    struct StreamCount
    {
        quint64 sent = 0;
        quint64 skipped = 0;
    };
    [[nodiscard]] virtual StreamCount streamCount() const { return {}; }
    /// The world around the board changes while it runs.
    virtual void setFaults(const Faults &faults) = 0;
};

/// What a simulated board is made from.
struct SimulatorOptions
{
    unsigned seed = 1;
    int firmware = 0;  ///< as the family counts it; 0 = its default
    bool usb = true;  ///< native USB port: not throttled, vanishes during a restart
    Faults faults;
    QMap<QString, int> own;  ///< what only its family understands, see SimulatedFamily::options
};
