// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/payloads.h"
#include "protocol/device/abilities.h"
#include "protocol/device/family.h"
#include "protocol/session/request.h"

namespace bcflight {

/// A drone with BCFlight. Nothing on the wire names the generation of its protocol; where it is not the
/// current one (F or G), the drone is looked at and nothing is changed (errata 1). No controls are ever sent,
/// but for the one that disarms.
class Device final : public ::Device, public LiveAccess, public FrameInspector, public StatusWords
{
public:
    Device();

    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    void setReadOnly() override { m_identity.writable = false; }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override { return m_parameters; }
    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    /// Gains: only those that differ, each proven by its echo. The text: the drone restarts. Errors:
    /// ConditionUnmet (it is armed or calibrating), Unsupported (the link cannot carry it whole).
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    [[nodiscard]] std::span<const ActionSpec> actions() const override;
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;
    [[nodiscard]] ChannelTable channels() const override;
    Result<TelemetryPlan> subscribe(Channel &channel, const Subscription &subscription,
                                    std::optional<LineSettings> line) override;
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] StopPlan stopPlan() const override;

    LiveAccess *live() override { return this; }
    [[nodiscard]] const LiveAccess *live() const override { return this; }
    [[nodiscard]] std::span<const AdjustableSpec> adjustables() const override;
    Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) override;
    [[nodiscard]] QString storeAction() const override;
    [[nodiscard]] Result<void> checkAdjustable(const AdjustableValue &wanted) const override;

    [[nodiscard]] const FrameInspector *inspector() const override { return this; }
    [[nodiscard]] FrameText describeFrame(const FrameView &frame, bool fromBoard) const override;
    [[nodiscard]] FrameText describeSent(QByteArrayView bytes) const override;
    [[nodiscard]] bool isTelemetryFrame(int id) const override;
    /// A name with numbers, or payload in hex. What steers, and what generation F or G does not know, is
    /// refused.
    [[nodiscard]] Result<RawCommand> parseCommand(const QString &text) const override;
    [[nodiscard]] QStringList commandNames() const override;

    [[nodiscard]] const StatusWords *statusWords() const override { return this; }
    [[nodiscard]] std::vector<BoardFact> facts(const std::function<double(int)> &latest) const override;
    [[nodiscard]] QString statusText(int state) const override;
    [[nodiscard]] bool isStabilising(int state) const override;
    [[nodiscard]] QString messageText(const FrameView &frame) const override;
    [[nodiscard]] std::optional<ConnectOffer> connectOffer() const override { return {}; }

protected:
    Result<void> putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) override;

private:
    /// One value of the block of gains; NaN where it is too short.
    [[nodiscard]] static float gainAt(const QByteArray &gains, int variable);
    /// Which generation answers, found without side effects (errata 1).
    Result<Generation> detect(Channel &channel);
    [[nodiscard]] Request ask(Message id, const QByteArray &payload = {}) const;
    /// What is answered by nothing.
    [[nodiscard]] Request order(Message id, const QByteArray &payload = {}) const;
    Result<Status> status(Channel &channel) const;
    /// Errors: ConditionUnmet, those of the channel.
    Result<void> checkDisarmed(Channel &channel) const;
    Result<QByteArray> readGains(Channel &channel);
    Result<void> writeGains(Channel &channel, const QByteArray &bytes);
    Result<QByteArray> readText(Channel &channel);
    Result<void> writeText(Channel &channel, const QByteArray &text);
    Result<void> setGain(Channel &channel, int variable, const QByteArray &gains);

    /// Waits until a drone that was told to restart has gone and come back. Errors: NotSeen.
    Result<void> awaitReturn(Channel &channel);

    // actions.cpp
    Result<ActionReply> calibrate(Channel &channel, bool isFull);
    Result<ActionReply> storeGains(Channel &channel);
    Result<ActionReply> stopMotors(Channel &channel);
    Result<ActionReply> testMotor(Channel &channel, int motor);
    Result<ActionReply> calibrateEscs(Channel &channel);
    Result<ActionReply> transmitter(Channel &channel, const Request &request) const;
    Result<ActionReply> tellStatus(Channel &channel);
    Result<ActionReply> tellInfo(Channel &channel, Message id);
    Result<ActionReply> tellRecordings(Channel &channel);
    Result<ActionReply> tellCamera(Channel &channel);
    /// Sends what makes it deaf, sends nothing meanwhile, and waits until it hears again.
    Result<ActionReply> waitDeaf(Channel &channel, const Request &request, milliseconds deaf,
                                 const QString &step);

    Generation m_generation = Generation::Unknown;
    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<QByteArray> m_adjustableKeys;
    std::vector<AdjustableSpec> m_adjustables;
};

/// The row of this family in the table of families.
[[nodiscard]] Family family();

}  // namespace bcflight
