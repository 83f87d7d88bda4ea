// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"
#include "protocol/simulator/video/cameraserver.h"
#include "protocol/simulator/world/simulatedfamily.h"

#include <QSocketNotifier>

class QCommandLineParser;

/// gimbalsim: creates a simulated board, offers it on a link, and injects faults on request.
class Sim final : public QObject
{
    Q_OBJECT
public:
    explicit Sim(QList<SimulatedFamily> families, QObject *parent = nullptr);

    /// Understands the arguments and starts. Empty: running, finished() follows; otherwise the exit code.
    std::optional<int> start(const QStringList &arguments);

signals:
    void finished();

private:
    [[nodiscard]] QString helpText() const;
    [[nodiscard]] QString optionsText() const;
    [[nodiscard]] QStringList keys() const;
    Result<std::unique_ptr<SimulatedPort>> makePort(const SimulatedFamily &family,
                                                    const QCommandLineParser &parser) const;
    Result<void> offerVideo(const QString &port);
    void listenToCommands();
    void onTyped();
    void onCommand(const QString &line);

    QList<SimulatedFamily> m_families;
    std::unique_ptr<SimulatorHost> m_host;
    std::unique_ptr<CameraServer> m_camera;
    std::unique_ptr<QSocketNotifier> m_input;
    QByteArray m_typed;
};
