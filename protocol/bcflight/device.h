// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/payloads.h"
#include "protocol/device/abilities.h"
#include "protocol/device/family.h"
#include "protocol/device/flight.h"
#include "protocol/device/motorlayout.h"
#include "protocol/device/steering.h"
#include "protocol/session/request.h"

#include <atomic>

namespace bcflight {

/// A drone with BCFlight. Nothing on the wire names the generation of its protocol; where it is not the
/// current one (F or G), the drone is looked at and nothing is changed (errata 1). Controls are sent only
/// where what is sent arrives whole, and only while somebody steers.
class Device final : public ::Device,
                     public LiveAccess,
                     public FrameInspector,
                     public StatusWords,
                     public Steering,
                     public FlyingMachine,
                     public MotorLayout
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
    /// ConditionUnmet (it is armed or calibrating), ReadOnly, Unsupported (the link cannot carry it whole).
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
    [[nodiscard]] std::optional<Result<Configuration>> storedAs(const Configuration &inUse) const override;
    [[nodiscard]] Result<void> checkAdjustable(const AdjustableValue &wanted) const override;

    [[nodiscard]] const Steering *steering() const override { return *refusal() ? nullptr : this; }
    [[nodiscard]] std::span<const SteeringMode> modes() const override;
    [[nodiscard]] std::span<const SteeringSwitch> switches() const override;
    /// Disarmed, throttle at zero.
    [[nodiscard]] SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest,
                                                   SteeredBefore steeredBefore) const override;
    [[nodiscard]] ControlFrames controlFrames(const SteeringSetpoint &setpoint) const override;

    [[nodiscard]] FlyingMachine *flight() override { return this; }
    [[nodiscard]] const FlyingMachine *flight() const override { return this; }
    [[nodiscard]] const char *refusal() const override;
    [[nodiscard]] QByteArray axesKey(const Configuration &configuration) const override;
    [[nodiscard]] std::vector<ScriptMistake> doubts(const Configuration &wanted,
                                                    const Configuration &board) const override;
    [[nodiscard]] const char *calibration() const override { return "calibrate.all"; }
    [[nodiscard]] const char *doubt(const QString &action, const QVariantMap &arguments) const override;
    Result<void> checkMayTake(Channel &channel, const RawCommand &command) override;
    Result<bool> askArmed(Channel &channel) override;
    void setHeld(bool held) override { m_isHeld = held; }

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

    /// What the drone tells of its board, its sensors or its cameras, as it came (errata 7.5). Errors:
    /// Unsupported (its generation), those of the channel.
    Result<QString> readInformation(Channel &channel, Message id);
    /// The list of what it has recorded, as it came (errata 7.6). Errors: Unsupported (its generation), those
    /// of decodeChecked().
    Result<QByteArray> readRecordingsList(Channel &channel);

    [[nodiscard]] const MotorLayout *motorLayout() const override { return this; }
    /// From the rows of its text (errata 7.2). What the signs mean in the world is not established (12).
    [[nodiscard]] std::vector<MotorShare> motorShares(const Configuration &configuration) const override;

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
    /// STATUS or TELEMETRY, by what brings it in this generation.
    [[nodiscard]] Request askState(Message id) const;
    Result<Status> status(Channel &channel) const;
    /// Errors: ReadOnly (its generation), ConditionUnmet, those of the channel.
    Result<void> checkDisarmed(Channel &channel) const;
    /// The same; one that is just being disarmed gets the time for it, and one in a test stand may stay
    /// armed. True if it is armed.
    Result<bool> checkTunable(Channel &channel) const;
    /// By its row (MessageSpec::maySend). Errors: ConditionUnmet, those of the channel.
    Result<void> checkMaySend(Channel &channel, Message id) const;
    [[nodiscard]] Request statusQuestion() const;
    Result<QByteArray> readGains(Channel &channel);
    Result<void> writeGains(Channel &channel, const QByteArray &bytes);
    Result<QByteArray> readText(Channel &channel);
    /// Uploads it and waits until the drone has restarted with it. Errors: InvalidArgument (no valid Lua),
    /// TooMuch, Unsupported (the link cannot carry it whole), ConditionUnmet, BoardError (it did not arrive
    /// whole), NoEffect (confirmed, and no restart), NotSeen (it has not come back), Timeout.
    Result<void> writeText(Channel &channel, const QByteArray &text);
    Result<void> upload(Channel &channel, const QByteArray &text);
    Result<void> setGain(Channel &channel, int variable, const QByteArray &gains);

    /// Whether a drone that was told to restart has gone, within `leaves`, and come back. Errors: NotSeen (it
    /// has gone, and not come back), those of the channel.
    Result<bool> goesAndReturns(Channel &channel, milliseconds leaves, milliseconds comesBack);
    /// Waits until a drone that was told to restart has gone, within `leaves`, and come back. Errors:
    /// NotSeen.
    Result<void> awaitReturn(Channel &channel, milliseconds leaves, milliseconds comesBack);

    // firmware.cpp
    /// Errors: BadFile, Unsupported (not over this link), ConditionUnmet, BoardError (the drone did not take
    /// a piece: stopped at once), Timeout, Cancelled; of all but the first three the detail says what is left
    /// behind. NotSeen: it did not restart, or has not come back.
    Result<ActionReply> uploadFirmware(Channel &channel, const QString &path);
    Result<void> sendPieces(Channel &channel, const QByteArray &image);
    Result<void> replaceProgram(Channel &channel, std::uint32_t crc);
    Result<QString> firmwareVersion(Channel &channel);

    // actions.cpp
    /// Whether the drone was seen not to be calibrated, or at it, since it was told.
    /// The number that an answer consists of; the largest one where it has none.
    [[nodiscard]] static std::uint32_t codeOf(const Frame &frame);
    Result<bool> beginCalibration(Channel &channel, bool isFull);
    Result<ActionReply> calibrate(Channel &channel, bool isFull);
    Result<ActionReply> storeGains(Channel &channel);
    /// The text with these gains, one literal each. Errors: those of findGains() and findScales(),
    /// OutOfRange, ConditionUnmet (a scale that gives no number).
    /// @param changes of each literal that is another one, by the key of the gain: "90 > 112.5"
    [[nodiscard]] Result<QByteArray> withGains(const QByteArray &text, const QByteArray &gains,
                                               ActionReply &changes) const;
    Result<ActionReply> stopMotors(Channel &channel);
    /// Errors: Unsupported over a stream.
    [[nodiscard]] Result<void> checkMayTurn() const;
    Result<ActionReply> testMotor(Channel &channel, int motor);
    Result<ActionReply> calibrateEscs(Channel &channel);
    Result<ActionReply> transmitter(Channel &channel) const;
    Result<ActionReply> setTransmitter(Channel &channel, Message id, int wanted) const;
    Result<ActionReply> tellStatus(Channel &channel);
    Result<ActionReply> tellInfo(Channel &channel, Message id);
    Result<ActionReply> tellRecordings(Channel &channel);

    // cameraactions.cpp
    Result<ActionReply> performCamera(Channel &channel, const QString &key, const QVariantMap &arguments);
    /// The question for an ACK_ID of that number.
    [[nodiscard]] Request acknowledgement(int number) const;
    /// Numbered, so that the drone does it once however often it hears it (errata 5). Errors: those of the
    /// channel.
    Result<Request> once(Channel &channel, Request request);
    Result<ActionReply> switchCamera(Channel &channel, Message id, const QString &figure);
    Result<ActionReply> tellCamera(Channel &channel);
    Result<ActionReply> tellLens(Channel &channel);
    Result<ActionReply> setLens(Channel &channel, const QVariantMap &arguments);

    /// One of the times of a command during which nothing is heard.
    struct DeafPhase
    {
        const char *step = "";
        milliseconds time{};
    };
    /// Sends what makes it deaf, sends nothing meanwhile, and waits until it hears again, cancelled or not.
    /// Progress counts in tenths of a second; `figures` come along. Errors: Cancelled (afterwards), NotSeen
    /// (it does not answer any more).
    Result<ActionReply> beDeaf(Channel &channel, const Request &request, std::span<const DeafPhase> phases,
                               const QMap<QString, double> &figures);
    Result<void> waitDeaf(Channel &channel, const Request &request, std::span<const DeafPhase> phases,
                          QMap<QString, double> figures);

    Generation m_generation = Generation::Unknown;
    bool m_isWhole = false;  // what is sent arrives in one piece
    std::atomic<bool> m_isHeld = false;
    int m_operation = 0;  // number of the last one that must not be done twice; 0: none over this link
    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    [[nodiscard]] QString adjustableKey(int variable) const;

    std::vector<QByteArray> m_adjustableKeys;
    std::vector<AdjustableSpec> m_adjustables;
};

/// The row of this family in the table of families.
[[nodiscard]] Family family();

}  // namespace bcflight
