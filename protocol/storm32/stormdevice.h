// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/storm32/commands.h"

#include <atomic>
#include <map>

/// STorM32 (o323bgc) with the setup layouts 78, 89 and 95; others open read-only with raw words. A board
/// whose heartbeat has locked plain commands out of its serial port is reached by embedding them in MAVLink
/// (errata 6).
class StormDevice final : public Device
{
public:
    StormDevice();
    ~StormDevice() override;

    [[nodiscard]] std::unique_ptr<Framer> makeFramer() const override;
    [[nodiscard]] QList<LineSettings> lineCandidates() const override;
    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    void setReadOnly() override { m_identity.writable = false; }
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override { return m_parameters; }

    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    /// Changes volatile memory; endWrite() stores it.
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    Result<void> beginWrite(Channel &channel) override;
    Result<void> endWrite(Channel &channel) override;
    Result<void> selectProfile(Channel &channel, int profile) override;
    Result<int> activeProfile(Channel &channel) override;
    Result<QStringList> readProfileNames(Channel &channel) override;
    Result<void> writeProfileNames(Channel &channel, const QStringList &names) override;
    [[nodiscard]] int profileNameBytes() const override { return 0; }

    Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) override;
    Result<void> writeAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) override;
    [[nodiscard]] std::span<const AdjustableSpec> adjustables() const override { return m_adjustables; }
    [[nodiscard]] bool hasPidShape() const override { return true; }
    [[nodiscard]] bool hasDebugVariables() const override { return false; }
    Result<std::vector<DebugVariable>> debugVariables(Channel &channel) override;
    Result<std::vector<std::vector<double>>> readDebugVariables(Channel &channel) override;

    [[nodiscard]] std::span<const ActionSpec> actions() const override;
    [[nodiscard]] QString storeAction() const override;
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;

    [[nodiscard]] std::vector<NotchFilter> notchFilters(Axis) const override { return {}; }
    [[nodiscard]] ChannelTable channels() const override;
    [[nodiscard]] ChannelRoles roles() const override;
    [[nodiscard]] QList<int> fastChannels() const override { return {}; }
    [[nodiscard]] QList<StreamSpec> streams() const override { return {}; }
    [[nodiscard]] Result<StreamBudget> streamBudget(const TelemetryWish &wish,
                                                    std::optional<LineSettings> line) const override;
    Result<TelemetryPlan> startTelemetry(Channel &channel, const TelemetryWish &wish,
                                         std::optional<LineSettings> line) override;
    void stopTelemetry(Channel &) override { }
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] std::vector<BoardFault> faults(unsigned bits, unsigned detail) const override;
    [[nodiscard]] std::vector<BoardFact> facts(const std::function<double(int)> &latest) const override;
    [[nodiscard]] QString stateText(int state) const override;
    [[nodiscard]] QString spokenText(const FrameView &frame) const override;
    [[nodiscard]] std::optional<ConnectOffer> connectOffer() const override;

    [[nodiscard]] FrameText describeFrame(const FrameView &frame, bool fromBoard) const override;
    [[nodiscard]] FrameText describeSent(QByteArrayView bytes) const override;
    [[nodiscard]] bool isTelemetryFrame(int id) const override;
    [[nodiscard]] Result<RawCommand> parseCommand(const QString &text) const override;
    [[nodiscard]] QStringList commandNames() const override;

    [[nodiscard]] bool announcesReset(const FrameView &) const override { return false; }
    [[nodiscard]] Request motorsOffRequest() const override;
    [[nodiscard]] Request motorsOnRequest() const override;
    [[nodiscard]] std::span<const ControlMode> controlModes() const override;
    [[nodiscard]] ControlFrames controlFrames(const ControlSetpoint &setpoint) const override;

    /// Plain commands are locked out: everything goes through MAVLink.
    [[nodiscard]] bool isEmbedded() const { return m_way >= 0; }

private:
    friend class StormActions;
    friend class StormProcedures;

    /// A request as this board can be asked it: plain, or embedded.
    [[nodiscard]] Request simple(storm32::Simple id, QByteArrayView arguments = {}) const;
    [[nodiscard]] Request rc(storm32::Rc id, const QByteArray &payload = {}) const;
    [[nodiscard]] Request embed(Request plain, QByteArrayView content,
                                std::optional<storm32::Simple> id) const;
    Result<QByteArray> readStream(Channel &channel);
    Result<std::map<int, int>> listParameters(Channel &channel);
    Result<int> readWord(Channel &channel, int word);
    Result<void> writeWord(Channel &channel, int word, int raw);
    Result<void> findWay(Channel &channel, int heartbeat);
    void learnAddress(const QByteArray &stream);

    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<AdjustableSpec> m_adjustables;
    std::vector<QByteArray> m_adjustableKeys;  // what the specs point to
    // How the board is reached now: plainly (-1), or embedded at this system and component. The screen asks
    // for the motors-off request while the worker may change it.
    std::atomic<int> m_way{-1};
    int m_address = 71 << 8 | 67;  // where it would be reached
    int m_firmware = 0;  // 79, 90, 96
    int m_words = 0;
    std::optional<std::array<int, 5>> m_yawBefore;  // the input words of yaw while it is aligned
};

/// The row of this family in the program's table of families.
[[nodiscard]] Family stormFamily();
