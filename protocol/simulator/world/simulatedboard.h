// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/clock.h"
#include "protocol/simulator/world/cameraview.h"
#include "protocol/simulator/world/faults.h"
#include "protocol/transport/linkaddress.h"

#include <QMap>

#include <memory>
#include <optional>

/// A simulated controller without its cable: bytes in, bytes out, and time passing. One per family.
class SimulatedBoard
{
public:
    virtual ~SimulatedBoard() = default;

    /// True for boards on a network: they receive and send packets, not a stream of bytes.
    [[nodiscard]] virtual bool isPacketBased() const { return false; }
    /// Bytes that reached the board's input buffer, or one packet.
    virtual void receive(Bytes bytes) = 0;
    /// One firmware cycle of 0.8 ms.
    virtual void cycle() = 0;
    /// Takes at most `max` bytes from the output buffer; from a packet-based board the next packet, empty if
    /// there is none left.
    virtual QByteArray takeOutput(qsizetype max) = 0;
    /// False while the controller restarts and, on native USB, is absent from the bus.
    [[nodiscard]] virtual bool isRunning() const = 0;
    /// The only parity that its UART accepts; empty: it detects the one the host uses.
    [[nodiscard]] virtual std::optional<Parity> onlyParity() const { return {}; }
    /// Frames of data streams that were sent, and those skipped because the output buffer was not emptied.
    struct StreamCount
    {
        quint64 sent = 0;
        quint64 skipped = 0;
    };
    [[nodiscard]] virtual StreamCount streamCount() const { return {}; }
    /// What its camera sees now; empty while there is none, or nothing is sent.
    [[nodiscard]] virtual std::optional<CameraView> cameraView() const { return {}; }
    /// Somebody connects to it, or is gone, on a link where that can be noticed (TCP).
    virtual void clientCame() { }
    virtual void clientWent() { }
    /// What another station on the same network asks now (Faults::otherGround); empty: nothing.
    [[nodiscard]] virtual QByteArray askedByOthers() { return {}; }
    /// Changes the board's surroundings at run time.
    virtual void setFaults(const Faults &faults) = 0;
};

/// Options from which a simulated board is made.
struct SimulatorOptions
{
    unsigned seed = 1;
    int firmware = 0;  ///< as the family numbers it; 0 = its default
    bool usb = true;  ///< native USB port: not throttled, vanishes during a restart
    Faults faults;
    QString memoryFile;  ///< holds what the board stores, where its family can; empty: it is forgotten
    QMap<QString, int> own;  ///< options of its family only, see SimulatedFamily::options
};
