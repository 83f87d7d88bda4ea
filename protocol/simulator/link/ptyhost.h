// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"

/// A pseudo-terminal, reachable through a symbolic link at a path that the caller chooses.
class PtyHost final : public SimulatorHost
{
    Q_OBJECT
public:
    PtyHost(std::unique_ptr<SimulatedPort> port, QString path, QObject *parent = nullptr);
    ~PtyHost() override;

    Result<void> start() override;
    [[nodiscard]] QString address() const override { return m_path; }

protected:
    void deliver(const QByteArray &bytes) override;
    void plugged(bool in) override;
    void poll() override;

private:
    Result<void> openTerminal();
    void drain();
    void closeTerminal();

    QString m_path;
    QString m_slave;
    int m_master = -1;
    QByteArray m_unsent;
};
