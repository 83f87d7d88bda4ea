// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QMap>
#include <QString>

#include <optional>

/// Parity of a serial line. The supported boards use these two only (SimpleBGC errata 1.6).
enum class Parity { None, Even };

/// What the two ends of a serial line must agree on.
struct LineSettings
{
    int baud = 115200;
    Parity parity = Parity::None;

    friend bool operator==(const LineSettings &, const LineSettings &) = default;

    /// Time on the wire for this many bytes: start bit, 8 data bits, parity if any, stop bit.
    [[nodiscard]] double secondsFor(qint64 bytes) const
    {
        const double bits = parity == Parity::Even ? 11.0 : 10.0;
        return baud > 0 ? static_cast<double>(bytes) * bits / baud : 0.0;
    }
};

/// How a board is reached. The same spelling is used everywhere:
/// `serial:/dev/ttyUSB0?baud=115200&parity=none`, `tcp://host:port`, `udp://host:port` (without a port:
/// 2020), `sim:simplebgc?seed=1`, `replay:FILE?speed=4`.
class LinkAddress
{
public:
    enum class Kind { None, Serial, Tcp, Udp, Simulator, Replay };

    /// Parses the spellings above; a bare device path (`/dev/ttyUSB0`, `COM3`) means a serial port. Errors:
    /// InvalidArgument with the reason.
    static Result<LinkAddress> parse(const QString &text);
    static LinkAddress replay(const QString &path);
    static LinkAddress serial(const QString &port, std::optional<int> baud = {},
                              std::optional<Parity> parity = {});

    [[nodiscard]] Kind kind() const { return m_kind; }
    /// Device path, host name, simulated family or recording.
    [[nodiscard]] const QString &target() const { return m_target; }
    /// A recording: nothing can be changed on it.
    [[nodiscard]] bool isReplay() const { return m_kind == Kind::Replay; }
    [[nodiscard]] quint16 port() const { return m_port; }
    [[nodiscard]] QString option(const QString &name) const { return m_options.value(name); }
    [[nodiscard]] const QMap<QString, QString> &options() const { return m_options; }
    /// Rate and parity if the address names them; missing parts are found by trying.
    [[nodiscard]] std::optional<int> baud() const;
    [[nodiscard]] std::optional<Parity> parity() const;
    [[nodiscard]] QString toString() const;

    friend bool operator==(const LinkAddress &, const LinkAddress &) = default;

private:
    Kind m_kind = Kind::None;
    QString m_target;
    quint16 m_port = 0;
    QMap<QString, QString> m_options;
};
