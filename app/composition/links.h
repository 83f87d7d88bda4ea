// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

/// Every kind of link, and the way to change the world around the simulated gimbals among them.
struct Links
{
    /// The family whose pages are shown before the first board, and whose simulated board is the demo.
    QString defaultFamily;
    TransportFactory transports;
    /// A fault as NAME=VALUE for a `sim:` address that was connected to. Errors: InvalidArgument,
    /// NotConnected.
    std::function<Result<void>(const LinkAddress &, const QString &)> changeWorld;
    /// The port on the loopback interface to which a viewer of a simulated board's camera writes. Errors:
    /// NotConnected, Unsupported.
    std::function<Result<quint16>(const LinkAddress &)> offerVideo;
};
