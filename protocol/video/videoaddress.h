// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

/// Where a drone sends its video from.
struct VideoAddress
{
    static constexpr quint16 kPort = 2021;  ///< of the shipped drones (errata 2.1)

    QString host;  ///< a name, IPv4 or IPv6
    quint16 port = kPort;

    friend bool operator==(const VideoAddress &, const VideoAddress &) = default;

    /// HOST, HOST:PORT, [HOST]:PORT or :PORT; what is left out is that of `usual`. Errors: InvalidArgument
    /// (also if no host is known then).
    static Result<VideoAddress> parse(const QString &text, const VideoAddress &usual);
    /// HOST:PORT.
    [[nodiscard]] QString toString() const;
};
