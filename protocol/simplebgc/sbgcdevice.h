// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/simplebgc/payloads.h"

/// SimpleBGC 32-bit over the serial API 2.5x; later firmware where the errata describes it.
class SbgcDevice final : public Device
{
public:
    /// Firmware numbers this program has tables for; others open read-only.
    static constexpr int kOldestFirmware = 2400;
    static constexpr int kNewestFirmware = 2749;

    SbgcDevice();
    ~SbgcDevice() override;

    [[nodiscard]] std::unique_ptr<Framer> makeFramer() const override;
    [[nodiscard]] QList<LineSettings> lineCandidates() const override;
    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    void setReadOnly() override { m_identity.writable = false; }
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override { return m_parameters; }

    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    Result<void> beginWrite(Channel &channel) override;
    Result<void> endWrite(Channel &channel) override;
    Result<void> selectProfile(Channel &channel, int profile) override;
    Result<int> activeProfile(Channel &channel) override;
    Result<QStringList> readProfileNames(Channel &channel) override;
    Result<void> writeProfileNames(Channel &channel, const QStringList &names) override;
    [[nodiscard]] int profileNameBytes() const override { return sbgc::kProfileNameSize; }

    Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) override;
    Result<void> writeAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) override;

    [[nodiscard]] std::span<const AdjustableSpec> adjustables() const override;
    Result<std::vector<DebugVariable>> debugVariables(Channel &channel) override;
    Result<std::vector<std::vector<double>>> readDebugVariables(Channel &channel) override;

    [[nodiscard]] std::span<const ActionSpec> actions() const override;
    [[nodiscard]] QString storeAction() const override;
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;

    [[nodiscard]] std::vector<NotchFilter> notchFilters(Axis axis) const override;
    [[nodiscard]] ChannelTable channels() const override;
    [[nodiscard]] ChannelRoles roles() const override;
    [[nodiscard]] QList<int> fastChannels() const override;
    [[nodiscard]] QList<StreamSpec> streams() const override;
    [[nodiscard]] Result<StreamBudget> streamBudget(const TelemetryWish &wish,
                                                    std::optional<LineSettings> line) const override;
    Result<TelemetryPlan> startTelemetry(Channel &channel, const TelemetryWish &wish,
                                         std::optional<LineSettings> line) override;
    void stopTelemetry(Channel &channel) override;
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] std::vector<BoardFault> faults(unsigned bits, unsigned detail) const override;

    [[nodiscard]] FrameText describeFrame(const FrameView &frame, bool fromBoard) const override;
    [[nodiscard]] bool isTelemetryFrame(int id) const override;
    [[nodiscard]] Result<RawCommand> parseCommand(const QString &text) const override;
    [[nodiscard]] QStringList commandNames() const override;

    [[nodiscard]] bool announcesReset(const FrameView &frame) const override;
    [[nodiscard]] Request motorsOffRequest() const override;
    [[nodiscard]] Request motorsOnRequest() const override;
    [[nodiscard]] std::span<const ControlMode> controlModes() const override { return m_controlModes; }
    [[nodiscard]] ControlFrames controlFrames(const ControlSetpoint &setpoint) const override;

private:
    friend class SbgcActions;

    [[nodiscard]] bool canStream() const { return m_identity.firmwareNumber >= 2590; }
    [[nodiscard]] sbgc::ControlCommand encodeSetpoint(const ControlSetpoint &setpoint) const;
    Result<TelemetryPlan> startPolling(Channel &channel);
    Result<void> findCustomFields(Channel &channel);
    Result<void> setStream(Channel &channel, const sbgc::DataStream &stream);

    static constexpr int kVersion = 1;  // frame version: never mixed on one connection (errata 1.3)
    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<ControlMode> m_controlModes;
    std::vector<ActionSpec> m_actions;
    quint32 m_customFlags = 0;  // of CUSTOM, that this firmware answers
    std::vector<sbgc::DataStream> m_streams;  // registered with the board
    std::vector<sbgc::DebugVar> m_debugVars;  // as the board declared them; used on the worker thread only
};

/// The row of this family in the program's table of families.
[[nodiscard]] Family sbgcFamily();
