// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

/// A serial port the operator can choose. Listing ports opens none of them.
struct PortInfo
{
    QString path;  ///< /dev/ttyUSB0, COM3
    QString description;  ///< name reported by the adapter
    quint16 vendorId = 0;  ///< 0 = not a USB port
    quint16 productId = 0;

    /// "/dev/ttyUSB0 – CP2102 – 10C4:EA60"
    [[nodiscard]] QString label() const;

    friend bool operator==(const PortInfo &, const PortInfo &) = default;
};

/// All serial ports, USB adapters first. Takes about 14 ms: do not call it on the GUI thread.
[[nodiscard]] QList<PortInfo> listSerialPorts();
