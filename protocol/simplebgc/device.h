// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/device/bearings.h"
#include "protocol/device/family.h"
#include "protocol/device/firmwareadvice.h"
#include "protocol/device/setupfacts.h"
#include "protocol/device/steering.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/telemetry/telemetryplan.h"

namespace simplebgc {

/// SimpleBGC 32-bit over the serial API 2.5x; later firmware where the errata describes it.
class Device final : public ::Device,
                     public ProfileAccess,
                     public WriteBracket,
                     public LiveAccess,
                     public InnerVariables,
                     public StreamControl,
                     public Steering,
                     public MotorSwitch,
                     public FrameInspector,
                     public FaultWords,
                     public Bearings,
                     public NotchFilters,
                     public RestartNotice,
                     public SetupFacts,
                     public FirmwareAdvice
{
public:
    /// Firmware numbers that this program has tables for; others open read-only.
    static constexpr int kOldestFirmware = 2400;
    static constexpr int kNewestFirmware = 2749;
    /// Key in BoardIdentity::extra, true: BOARD_INFO names a special or experimental build.
    static inline const QString kSpecialBuild = QStringLiteral("special_build");

    Device();
    ~Device() override;

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

    ProfileAccess *profiles() override { return this; }
    [[nodiscard]] const ProfileAccess *profiles() const override { return this; }
    Result<void> selectProfile(Channel &channel, int profile) override;
    Result<int> activeProfile(Channel &channel) override;
    Result<QStringList> readProfileNames(Channel &channel) override;
    Result<void> writeProfileNames(Channel &channel, const QStringList &names) override;
    [[nodiscard]] int profileNameBytes() const override { return kProfileNameSize; }

    WriteBracket *writeBracket() override { return this; }
    Result<void> beginWrite(Channel &channel) override;
    Result<void> endWrite(Channel &channel) override;

    LiveAccess *live() override { return this; }
    [[nodiscard]] const LiveAccess *live() const override { return this; }
    [[nodiscard]] std::span<const AdjustableSpec> adjustables() const override;
    [[nodiscard]] Result<void> checkAdjustable(const AdjustableValue &wanted) const override;
    Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) override;
    [[nodiscard]] QString storeAction() const override;

    InnerVariables *innerVariables() override { return this; }
    [[nodiscard]] const InnerVariables *innerVariables() const override { return this; }
    Result<std::vector<DebugVariable>> debugVariables(Channel &channel) override;
    Result<std::vector<std::vector<double>>> readDebugVariables(Channel &channel) override;

    /// Null for firmware that has to be polled.
    [[nodiscard]] const StreamControl *streamControl() const override { return canStream() ? this : nullptr; }
    [[nodiscard]] QList<StreamSpec> streams() const override;
    /// Of firmware that can stream.
    [[nodiscard]] static QStringList streamKeys();
    [[nodiscard]] QList<int> fastChannels() const override;
    [[nodiscard]] Result<StreamBudget> streamBudget(const Subscription &subscription,
                                                    std::optional<LineSettings> line) const override;

    [[nodiscard]] const Steering *steering() const override { return this; }
    [[nodiscard]] std::span<const SteeringMode> modes() const override { return m_steeringModes; }
    [[nodiscard]] std::span<const SteeringSwitch> switches() const override { return {}; }
    [[nodiscard]] SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest,
                                                   SteeredBefore steeredBefore) const override;
    [[nodiscard]] ControlFrames controlFrames(const SteeringSetpoint &setpoint) const override;
    /// @param isFine as API_VIRT_CH_HIGH_RES takes them
    [[nodiscard]] static ControlFrames channelFrames(const std::vector<double> &percents,
                                                     bool isFine = false);

    [[nodiscard]] const MotorSwitch *motorSwitch() const override { return this; }
    Result<void> switchMotorsOn(Channel &channel) const override;
    Result<bool> areMotorsOn(Channel &channel) const override;

    /// Which profile, from 0, an entry of the board's menu makes the active one; -1 = none.
    [[nodiscard]] static int profileOf(int menuCommand);
    /// Asks for REALTIME_DATA_3.
    [[nodiscard]] Request statusRequest() const;
    /// What the answer to it says; nothing for another frame.
    [[nodiscard]] static std::optional<bool> areMotorsRunning(const Frame &frame);

    [[nodiscard]] const Bearings *bearings() const override { return this; }
    [[nodiscard]] AxisBearing bearing(Axis axis, const Configuration &active,
                                      const Latest &latest) const override;
    [[nodiscard]] std::optional<bool> isFrameMeasured(const Configuration &active,
                                                      const Latest &latest) const override;
    [[nodiscard]] BatteryThresholds batteryThresholds(const Configuration &active) const override;

    [[nodiscard]] const FrameInspector *inspector() const override { return this; }
    [[nodiscard]] FrameText describeFrame(const FrameView &frame, bool fromBoard) const override;
    [[nodiscard]] FrameText describeSent(QByteArrayView bytes) const override;
    [[nodiscard]] bool isTelemetryFrame(int id) const override;
    [[nodiscard]] Result<RawCommand> parseCommand(const QString &text) const override;
    [[nodiscard]] QStringList commandNames() const override;

    [[nodiscard]] const FaultWords *faultWords() const override { return this; }
    [[nodiscard]] std::vector<BoardFault> faults(unsigned bits, unsigned detail) const override;

    [[nodiscard]] const NotchFilters *notchFilters() const override { return this; }
    [[nodiscard]] std::vector<NotchFilter> notchesOf(Axis axis) const override;

    [[nodiscard]] const RestartNotice *restartNotice() const override { return this; }
    [[nodiscard]] bool announcesReset(const FrameView &frame) const override;
    [[nodiscard]] std::optional<milliseconds> ordersReset(QByteArrayView sent) const override;
    [[nodiscard]] Request harmlessQuestion() const override;

    [[nodiscard]] const SetupFacts *setupFacts() const override { return this; }
    [[nodiscard]] SetupKeys setupKeys() const override;

    [[nodiscard]] const FirmwareAdvice *firmwareAdvice() const override { return this; }
    [[nodiscard]] std::vector<FirmwareRemark> firmwareRemarks() const override;
    [[nodiscard]] std::vector<FirmwareStep> firmwareSteps() const override;

    /// One axis of CONTROL, as the board understands it.
    struct AxisControl
    {
        int mode = 0;
        double speed = 0;  ///< degrees per second
        double angle = 0;  ///< degrees, or the mode's own unit
    };
    using Control = std::array<AxisControl, kAxisCount>;
    /// Each axis may be steered in its own mode. @param isFine by CONTROL_EXT
    [[nodiscard]] ControlFrames controlFrames(const Control &control, bool isFine = false) const;
    /// Ranges of a mode of CONTROL with this firmware; null if it does not have that mode.
    [[nodiscard]] const SteeringMode *steeringMode(int mode) const { return Steering::mode(mode); }

private:
    friend class Actions;

    Result<void> putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) override;

    [[nodiscard]] static std::vector<Request> adjustableRequests(const std::vector<AdjustableValue> &values);
    Result<void> sendAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) const;
    Result<QByteArray> askBlock(Channel &channel, BlockKey key, int retries);
    [[nodiscard]] Result<bool> isOfTheFirst(Channel &channel) const;
    Result<void> addProfileNames(Channel &channel, Configuration &configuration);
    [[nodiscard]] CommandId readCommand(int block) const;
    [[nodiscard]] CommandId writeCommand(int block) const;
    Result<void> checkIdentity(Channel &channel) const;
    [[nodiscard]] static Error otherIdentity(const BoardInfo &now, const QString &model,
                                             const QString &firmware);
    /// CONTROL has one mode for all axes (its 15-byte form came with 2.55b5): none can be left alone.
    [[nodiscard]] bool steersTogether() const { return m_identity.firmwareNumber < 2555; }
    [[nodiscard]] bool canStream() const { return m_identity.firmwareNumber >= 2590; }
    [[nodiscard]] ControlCommand encodeControl(const Control &control) const;
    [[nodiscard]] static QByteArray encodeControlExt(const Control &control);
    [[nodiscard]] static Request probeRequest();
    Result<TelemetryPlan> startPolling(Channel &channel, std::optional<LineSettings> line);
    void stopStreams(Channel &channel);
    Result<void> endLeftovers(Channel &channel);
    Result<void> findCustomFields(Channel &channel);
    Result<void> setStream(Channel &channel, const DataStream &stream);

    static constexpr int kVersion = 1;  // frame version: never mixed on one connection (errata 1.3)
    bool m_isFirst = false;  // it knows only the first boards' commands
    std::optional<BoardInfo> m_probed;  // what it said before it was identified
    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<SteeringMode> m_steeringModes = simplebgc::steeringModes(0);  // those that every board has
    std::vector<ActionSpec> m_actions;
    quint32 m_customFlags = 0;  // fields of CUSTOM that this firmware delivers
    std::vector<DataStream> m_streams;  // registered with the board
    std::vector<DebugVar> m_debugVars;  // as the board declared them; used on the worker thread only
};

/// The row of this family in the program's table of families.
[[nodiscard]] Family family();

}  // namespace simplebgc
