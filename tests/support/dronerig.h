// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/decoder.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/tables.h"
#include "protocol/simulator/bcflight/board.h"
#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/telemetry/telemetrystore.h"

/// A simulated drone that does not shake.
[[nodiscard]] inline SimulatorOptions droneOptions(bcflight::Generation generation,
                                                   QMap<QString, int> own = {}, const Faults &faults = {})
{
    SimulatorOptions options;
    own.insert(QLatin1String(bcflight::SimulatedBoard::kGeneration), int(generation));
    options.own = own;
    options.faults = faults;
    options.faults.shake = 0;
    return options;
}

/// A simulated drone and a channel to it in virtual time, whose telemetry is kept.
struct DroneRig
{
    explicit DroneRig(const SimulatorOptions &droneOptions)
        : DroneRig(droneOptions, std::make_unique<bcflight::SimulatedBoard>(droneOptions))
    {
    }
    /// @param board the drone, or one that watches it
    DroneRig(const SimulatorOptions &droneOptions, std::unique_ptr<SimulatedBoard> board)
        : options(droneOptions)
        , port(std::move(board), options, {})
        , channel(port, family.makeFramer(), family.timing)
        , store(std::make_shared<TelemetryStore>(int(bcflight::channels().size())))
    {
        channel.setTap([this](const FrameView &frame, TimePoint at) {
            decoder.decode(frame, at, *store);
            if (heard)
                heard(frame);
        });
        channel.setLatestValues(store);
    }
    Q_DISABLE_COPY_MOVE(DroneRig)
    bool identify() { return device.identify(channel).has_value(); }
    Result<ActionReply> perform(const char *key, const QVariantMap &arguments = {})
    {
        return device.perform(channel, QString::fromLatin1(key), arguments);
    }
    bool calibrate() { return identify() && perform("calibrate.all").has_value(); }

    SimulatorOptions options;
    const Family family = bcflight::family();
    bcflight::Device device;
    SimulatedPort port;
    VirtualChannel channel;
    std::shared_ptr<TelemetryStore> store;
    bcflight::Decoder decoder;
    std::function<void(const FrameView &)> heard;
};
