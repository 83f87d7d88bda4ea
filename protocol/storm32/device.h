// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/device/bearings.h"
#include "protocol/device/family.h"
#include "protocol/device/steering.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/storm32/commands.h"
#include "protocol/storm32/motorstop.h"
#include "protocol/storm32/telemetrytables.h"
#include "protocol/telemetry/telemetryplan.h"

#include <atomic>
#include <map>

namespace storm32 {

/// STorM32 (o323bgc) with the setup layouts 78, 89 and 95; others open read-only with raw words. A board
/// whose heartbeat has locked plain commands out of its serial port is reached by embedding them in MAVLink
/// (errata 6).
class Device final : public ::Device,
                     public WriteBracket,
                     public LiveAccess,
                     public WholeMemory,
                     public Steering,
                     public MotorSwitch,
                     public FrameInspector,
                     public FaultWords,
                     public Bearings,
                     public StatusWords,
                     public RestartNotice
{
public:
    Device();
    ~Device() override;

    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    void setReadOnly() override { m_identity.writable = false; }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override { return m_parameters; }
    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    /// Changes volatile memory; endWrite() stores it.
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    [[nodiscard]] std::span<const ActionSpec> actions() const override;
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;
    [[nodiscard]] ChannelTable channels() const override;
    Result<TelemetryPlan> subscribe(Channel &channel, const Subscription &subscription,
                                    std::optional<LineSettings> line) override;
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] StopPlan stopPlan() const override;

    /// A write needs no opening; storing ends it.
    WriteBracket *writeBracket() override { return this; }
    Result<void> beginWrite(Channel &) override { return checkNotStopping(); }
    Result<void> endWrite(Channel &channel) override;

    LiveAccess *live() override { return this; }
    [[nodiscard]] const LiveAccess *live() const override { return this; }
    [[nodiscard]] std::span<const AdjustableSpec> adjustables() const override { return m_adjustables; }
    Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) override;
    [[nodiscard]] QString storeAction() const override;
    /// Its word: all of them can be set in RAM (errata 4, number 4).
    [[nodiscard]] int variableOf(const ParameterSpec &spec) const override;
    [[nodiscard]] Result<void> checkAdjustable(const AdjustableValue &wanted) const override;

    WholeMemory *wholeMemory() override { return this; }
    [[nodiscard]] const WholeMemory *wholeMemory() const override { return this; }
    Result<Contents> readBoth(Channel &channel) override;
    [[nodiscard]] std::optional<Configuration> lastStored() const override { return m_lastStored; }
    Result<void> checkUse(Channel &channel, const Configuration &whole) override;
    Result<void> use(Channel &channel, const Configuration &whole) override;
    [[nodiscard]] QMap<QString, QString> movedBy(const Configuration &inUse) const override;

    [[nodiscard]] const Steering *steering() const override { return this; }
    [[nodiscard]] std::span<const SteeringMode> modes() const override;
    [[nodiscard]] std::span<const SteeringSwitch> switches() const override { return {}; }
    [[nodiscard]] SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest,
                                                   SteeredBefore steeredBefore) const override;
    [[nodiscard]] ControlFrames controlFrames(const SteeringSetpoint &setpoint) const override;
    [[nodiscard]] std::array<double, kAxisCount> levelAngles(const LatestValues &latest) const override;

    [[nodiscard]] const MotorSwitch *motorSwitch() const override { return this; }
    Result<void> switchMotorsOn(Channel &channel) const override;
    Result<bool> areMotorsOn(Channel &channel) const override;
    [[nodiscard]] bool isSwitchedBy(const ParameterSpec &spec) const override;

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

    [[nodiscard]] const StatusWords *statusWords() const override { return this; }
    [[nodiscard]] std::vector<BoardFact> facts(const std::function<double(int)> &latest) const override;
    [[nodiscard]] QString statusText(int state) const override;
    [[nodiscard]] bool isStabilising(int state) const override;
    [[nodiscard]] bool isStarting(int state) const override;
    [[nodiscard]] QString messageText(const FrameView &frame) const override;
    [[nodiscard]] std::optional<ConnectOffer> connectOffer() const override;

    [[nodiscard]] const RestartNotice *restartNotice() const override { return this; }
    [[nodiscard]] bool announcesReset(const FrameView &) const override { return false; }
    [[nodiscard]] std::optional<milliseconds> ordersReset(QByteArrayView sent) const override;
    [[nodiscard]] bool isFreshlyStarted(int state) const override;
    [[nodiscard]] Request harmlessQuestion() const override { return simple(Simple::Status); }

    [[nodiscard]] std::shared_ptr<const GainShape> gainShape() const override;

    /// Plain commands are locked out: everything goes through MAVLink.
    [[nodiscard]] bool isEmbedded() const { return m_way >= 0; }

private:
    static constexpr int kPlain = -1;  // of m_way
    friend class Actions;
    friend class Procedures;

    Result<void> putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) override;

    /// A request in the form this board accepts: plain, or embedded.
    [[nodiscard]] Request simple(Simple id, QByteArrayView arguments = {}) const;
    [[nodiscard]] Request rc(Rc id, const QByteArray &payload = {}) const;
    [[nodiscard]] Request standbyRequest(bool standby) const;
    /// Carries out the stop plan. An error lists what it has left in use, and how to put that back.
    Result<void> stopMotors(Channel &channel);
    /// Errors: Busy while the motors are disabled because they were stopped during the start.
    [[nodiscard]] Result<void> checkNotStopping() const;
    /// The motors that are disabled in use, by parameter and value.
    Result<QStringList> disabledMotors(Channel &channel) const;
    /// The same for a board that is reached in a given way (see m_way).
    [[nodiscard]] static Request rcAt(int way, Rc id, const QByteArray &payload);
    [[nodiscard]] static Request embed(int way, const Request &plain, QByteArrayView content,
                                       std::optional<Simple> id);
    Result<QByteArray> readStream(Channel &channel);
    /// Words as they were read: with those of the operator where the board holds others for a while, and what
    /// they say noted.
    void takeIn(QByteArray &words);
    Result<std::map<int, int>> listParameters(Channel &channel);
    Result<int> readWord(Channel &channel, int word);
    Result<void> writeWord(Channel &channel, int word, int raw);
    Result<void> findWay(Channel &channel, int heartbeat);
    void learnAddress(const QByteArray &stream);
    /// Also the address that it has while it is embedded.
    void learnAddressWord(int word, int raw);
    /// The board's state (errata 3.7).
    Result<int> readState(Channel &channel);
    /// The same, once the board is through its last state before the normal one.
    Result<int> settledState(Channel &channel);
    /// If all motors are disabled in use, they stay so while stored values are: in standby, which the board
    /// may have been in before. True if it has to be ended. Errors: Unready (the board is starting).
    Result<bool> enterStandby(Channel &channel, const QByteArray &inUse);
    /// Whether the board goes into standby, or out of it, in time.
    Result<bool> comesToStandby(Channel &channel, bool wanted);
    /// What is stored, read while it is in use for a moment; then `inUse` is in use again.
    Result<QByteArray> readStored(Channel &channel, const QByteArray &inUse);
    Result<QByteArray> retrieve(Channel &channel);
    [[nodiscard]] int markableWord(const Configuration &inUse) const;
    /// Loading that is confirmed and not done would show what is in use as if it were stored: a word is
    /// marked before, and the mark has to go. @param word -1: nothing can be marked, and nothing proven
    /// @param load loads, and returns that word. Errors: VerifyFailed, those of loading.
    Result<void> proveLoading(Channel &channel, int word, const std::function<Result<int>()> &load);
    /// What is stored is in use afterwards, proven. Errors: those of proveLoading().
    Result<void> loadStored(Channel &channel);
    /// @param heartbeat what is in use, where it is switched off only for this
    Result<Contents> readBothPlain(Channel &channel, std::optional<int> heartbeat);
    Result<void> putStream(Channel &channel, const QByteArray &stream);
    [[nodiscard]] Configuration configurationOf(const QByteArray &stream) const;
    [[nodiscard]] QString inUseText(const QByteArray &inUse, const Result<QByteArray> &stored,
                                    int marked) const;
    [[nodiscard]] QString lostText(const QByteArray &inUse, const QByteArray &now) const;
    /// What a word says about m_history; most words say nothing.
    void learnShift(int word, int raw);

    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<AdjustableSpec> m_adjustables;
    std::vector<QByteArray> m_adjustableKeys;  // storage for the keys in the specs
    // How the board is currently reached: plainly (-1), or embedded at this system and component. The GUI
    // requests the stop plan while the worker may change it.
    std::atomic<int> m_way{-1};
    int m_address = 71 << 8 | 67;  // where it would be reached through MAVLink
    int m_firmware = 0;  // 79, 90, 96
    int m_words = 0;
    std::optional<Configuration> m_lastStored;
    std::shared_ptr<MotorStop> m_stop = std::make_shared<MotorStop>();
    std::shared_ptr<PanHistory> m_history = std::make_shared<PanHistory>();
    std::array<int, 4> m_shiftWords{-1, -1, -1, -1};  // offsets of roll, pitch and yaw, default pan mode
    std::optional<std::array<int, 5>> m_yawBefore;  // the input words of yaw while it is aligned
};

/// The row of this family in the program's table of families.
[[nodiscard]] Family family();

}  // namespace storm32
