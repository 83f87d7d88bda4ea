// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QByteArray>
#include <QHostAddress>
#include <QObject>
#include <QProcess>

/// What a program that steers something flying leaves behind for the case that it dies: over UDP silence
/// disarms nothing (BCFlight errata 9.1). A second process holds the bytes that stop it, and sends them when
/// the first one is gone without having taken leave, or has said nothing for a second.
namespace FlightGuard {

inline constexpr auto kSilence = 1s;
inline constexpr auto kPeriod = 20ms;
inline constexpr auto kStops = 1500ms;  ///< for which the stop is repeated
/// What is written to the guard: it goes on watching, or is not needed any more.
inline constexpr char kAlive = '.';
inline constexpr char kLeave = 'q';

/// The guard's own program: waits at standard input, sends, ends.
/// @param arguments host, port, and the packet that stops, in hex
/// @return its exit code: 0 it was not needed, 3 it has sent the stop, 2 wrong arguments
int run(const QStringList &arguments);

}  // namespace FlightGuard

/// The program's side of it: started before something is armed, told that all is well while it is, and left
/// when it stands.
class FlightGuardian final : public QObject
{
    Q_OBJECT
public:
    explicit FlightGuardian(QObject *parent = nullptr);
    ~FlightGuardian() override;

    /// @param stop one datagram
    void start(const QString &host, quint16 port, const QByteArray &stop);
    /// To be called several times a second while it has to watch.
    void tell();
    /// All stands: it is not needed any more.
    void leave();
    [[nodiscard]] bool isWatching() const;

signals:
    /// It could not be started, or has ended: nobody would stop the machine if this program died.
    void lost();

private:
    QProcess *m_process = nullptr;
};
