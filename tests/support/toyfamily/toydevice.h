// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/device/steering.h"
#include "protocol/session/channel.h"

/// The toy's knowledge: what every board has, and steering. Nothing else.
class ToyDevice : public Device, public Steering
{
public:
    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    void setReadOnly() override { m_identity.writable = false; }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override { return m_parameters; }
    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    [[nodiscard]] std::span<const ActionSpec> actions() const override;
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;
    [[nodiscard]] ChannelTable channels() const override;
    Result<TelemetryPlan> subscribe(Channel &channel, const Subscription &subscription,
                                    std::optional<LineSettings> line) override;
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] StopPlan stopPlan() const override;

    [[nodiscard]] const Steering *steering() const override { return this; }
    [[nodiscard]] std::span<const SteeringMode> modes() const override;
    [[nodiscard]] std::span<const SteeringSwitch> switches() const override;
    [[nodiscard]] SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest,
                                                   SteeredBefore steeredBefore) const override;
    [[nodiscard]] ControlFrames controlFrames(const SteeringSetpoint &setpoint) const override;

private:
    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
};

/// The row of this family in a table of families.
[[nodiscard]] Family toyFamily();
