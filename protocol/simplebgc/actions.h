// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/vector3.h"
#include "protocol/configuration/memoryimage.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/rotation.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace simplebgc {

/// The actions of the family, as table and code: everything in the serial API that is neither a parameter nor
/// telemetry.
class Actions
{
public:
    Actions(Device &device, Channel &channel)
        : m_device(device)
        , m_channel(channel)
    {
    }

    Result<ActionReply> perform(const QString &key, const QVariantMap &arguments);

    /// A board that calibrates may answer nothing meanwhile, and stream again a while later.
    static constexpr milliseconds kBusyCalibrating{8000};

private:
    using Handler = Result<ActionReply> (Actions::*)(const QVariantMap &);
    struct Entry
    {
        const char *key;
        Handler handler;
    };
    static const Entry kHandlers[];

    Result<ActionReply> confirm(CommandId id, const QByteArray &payload = {});

    Result<ActionReply> readAngles(const QVariantMap &arguments);
    Result<ActionReply> listDebugVariables(const QVariantMap &arguments);
    Result<ActionReply> readDebugVariables(const QVariantMap &arguments);
    Result<ActionReply> motorsOn(const QVariantMap &arguments);
    Result<ActionReply> motorsOff(const QVariantMap &arguments);
    Result<ActionReply> menu(const QVariantMap &arguments);
    Result<ActionReply> selectProfile(const QVariantMap &arguments);
    Result<ActionReply> steer(const QVariantMap &arguments);
    Result<ActionReply> beep(const QVariantMap &arguments);
    Result<ActionReply> readVariables(const QVariantMap &arguments);
    Result<ActionReply> writeVariable(const QVariantMap &arguments);
    Result<ActionReply> saveVariables(const QVariantMap &arguments);
    Result<ActionReply> calibrateGyro(const QVariantMap &arguments);
    Result<ActionReply> calibrateAcc(const QVariantMap &arguments);
    Result<ActionReply> calibrateBattery(const QVariantMap &arguments);
    Result<ActionReply> calibrateOffset(const QVariantMap &arguments);
    Result<ActionReply> autoTune(const QVariantMap &arguments);
    Result<ActionReply> stopAutoTune(const QVariantMap &arguments);
    Result<ActionReply> reset(const QVariantMap &arguments);
    // sensoractions.cpp
    Result<ActionReply> calibratePoles(const QVariantMap &arguments);
    Result<ActionReply> calibrateMagLink(const QVariantMap &arguments);
    Result<ActionReply> calibrateEncoderOffsets(const QVariantMap &arguments);
    Result<ActionReply> calibrateEncoderFields(const QVariantMap &arguments);
    Result<ActionReply> readState(const QVariantMap &arguments);
    Result<ActionReply> calibrateFcGain(const QVariantMap &arguments);
    Result<ActionReply> calibrateMagnetometer(const QVariantMap &arguments);
    // inputactions.cpp
    Result<ActionReply> readSignals(const QVariantMap &arguments);
    Result<ActionReply> readInputs(const QVariantMap &arguments);
    Result<ActionReply> readReportedInputs();
    /// READ_RC_INPUTS: a signal for each of so many inputs.
    Result<Frame> askInputs(const QByteArray &question, int count);
    // boardactions.cpp
    Result<ActionReply> selectImu(const QVariantMap &arguments);
    Result<ActionReply> setPin(const QVariantMap &arguments);
    Result<ActionReply> setServo(const QVariantMap &arguments);
    Result<ActionReply> setChannel(const QVariantMap &arguments);
    Result<ActionReply> readStatistics(const QVariantMap &arguments);
    Result<ActionReply> profileSet(const QVariantMap &arguments);
    Result<ActionReply> readExternal(const QVariantMap &arguments);
    Result<ActionReply> writeExternal(const QVariantMap &arguments);
    Result<ActionReply> saveFile(const QVariantMap &arguments);
    Result<ActionReply> loadFile(const QVariantMap &arguments);
    Result<ActionReply> eraseFile(const QVariantMap &arguments);
    Result<ActionReply> readSlots(const QVariantMap &arguments);
    // memoryactions.cpp
    Result<ActionReply> saveMemory(const QVariantMap &arguments);
    Result<ActionReply> restoreMemory(const QVariantMap &arguments);
    Result<ActionReply> compareMemory(const QVariantMap &arguments);
    Result<ActionReply> eraseAllFiles(const QVariantMap &arguments);
    Result<ActionReply> saveCalibrations(const QVariantMap &arguments);
    Result<ActionReply> compareCalibrations(const QVariantMap &arguments);
    Result<ActionReply> restoreCalibrations(const QVariantMap &arguments);
    // expertactions.cpp
    Result<ActionReply> i2cScan(const QVariantMap &arguments);
    Result<ActionReply> i2cReadRegisters(const QVariantMap &arguments);
    Result<ActionReply> i2cWriteRegisters(const QVariantMap &arguments);
    Result<ActionReply> enterBootLoader(const QVariantMap &arguments);
    Result<ActionReply> readAttitude(const QVariantMap &arguments);
    Result<ActionReply> feed(const QVariantMap &arguments);
    Result<ActionReply> listScripts(const QVariantMap &arguments);
    Result<ActionReply> saveScript(const QVariantMap &arguments);
    Result<ActionReply> loadScript(const QVariantMap &arguments);
    Result<ActionReply> eraseScript(const QVariantMap &arguments);
    Result<ActionReply> runScript(const QVariantMap &arguments);
    Result<ActionReply> stopScript(const QVariantMap &arguments);
    Result<ActionReply> followScript(const QVariantMap &arguments);
    Result<ActionReply> useDefaults(const QVariantMap &arguments);
    // attitudeactions.cpp
    Result<ActionReply> steerAttitude(const QVariantMap &arguments);
    Result<ActionReply> readAttitudeControl(const QVariantMap &arguments);
    Result<ActionReply> limitSteering(const QVariantMap &arguments);
    // responseactions.cpp
    Result<ActionReply> measureFrequencies(const QVariantMap &arguments);
    // lateractions.cpp
    Result<ActionReply> readCalibration(const QVariantMap &arguments);
    Result<ActionReply> calibrateByReference(const QVariantMap &arguments);
    Result<ActionReply> describeVariables(const QVariantMap &arguments);
    Result<ActionReply> resetStatistics(const QVariantMap &arguments);
    Result<ActionReply> setSingleServo(const QVariantMap &arguments);
    Result<ActionReply> readFurtherData(const QVariantMap &arguments);
    Result<ActionReply> readReferences(const QVariantMap &arguments);
    Result<ActionReply> followEvents(const QVariantMap &arguments);
    Result<ActionReply> tuneByAxis(const QVariantMap &arguments);
    Result<ActionReply> calibrateRipple(const QVariantMap &arguments);

    /// A question whose answer has the same number.
    Result<Frame> ask(CommandId id, const QByteArray &question, int replySize);
    Result<ActionReply> readRealVariables(const QList<int> &ids);
    static Request stopTuningByAxisRequest();
    static QByteArray frequencyTestPayload(const QVariantMap &arguments, quint32 samples);
    /// Stops what shakes the axis, and says in the error what became of that.
    Error afterFrequencyTest(const Error &error, const QVariantMap &arguments);
    /// What CONTROL_QUAT_STATUS tells.
    struct AttitudeState
    {
        int mode = 0;
        std::array<Orientation, 3> attitudes{};  ///< target, set-point, actual
        std::array<std::array<double, kAxisCount>, 3> speeds{};  ///< deg/s, of the same
    };
    static constexpr std::size_t kActual = 2;
    Result<AttitudeState> attitudeState();
    static ActionReply told(const AttitudeState &state);

    /// A calibration that the board makes by itself, and the parameters that it finds; "%1" in their keys is
    /// the axis.
    struct SelfCalibration
    {
        CommandId id{};
        int mode = 0;  ///< of CALIB_MODE while it goes on (errata 4.6)
        Block block{};
        std::vector<const char *> keys;
        QByteArray payload = {};
        const char *step = "calibrate-motors";  ///< of its progress
        Duration length = 12s;  ///< after reception, where the board does not tell that it goes on
    };
    struct SelfCalibrated
    {
        ActionReply reply;  ///< what it found, and in ".before" what was there where that is something else
        bool isProven = false;  ///< something has changed, or the board was seen to calibrate
    };
    struct Watched
    {
        bool hasBegun = false;  ///< it was confirmed, or seen
        bool hasRun = false;  ///< the board was seen to calibrate
        bool isOver = false;
        bool isConfirmed = false;  ///< its end was
        std::optional<Error> refusal;
    };
    using Watcher = std::function<Result<void>(Duration since)>;
    /// Starts it and waits for its end. Errors: Timeout where nothing is heard, those of the link and of the
    /// watcher, who is called all the while.
    Result<Watched> watchCalibration(const SelfCalibration &calibration, const Watcher &meanwhile);
    using Values = QMap<QString, double>;
    Result<Values> parametersOf(int profile, Block block, const std::vector<const char *> &keys);
    /// Errors: the board's refusal, Timeout, those of the link.
    Result<SelfCalibrated> calibrateByItself(const SelfCalibration &calibration);
    /// The same, and what is found is told. Errors: NoEffect where nothing shows that it was carried out.
    Result<ActionReply> calibrateProven(const SelfCalibration &calibration);
    /// REALTIME_DATA_4, asked once.
    Result<Frame> fullStatus();
    Result<std::array<double, kAxisCount>> motorAngles();
    /// Whether the board is in this mode of calibration; nothing where it does not tell.
    Result<std::optional<bool>> isCalibrating(int mode);
    /// The newest error of the heading, in degrees, after a sample was added.
    Result<double> sampleMagnetometer(std::vector<Vector3> &samples);
    Result<double> headingError(std::vector<Vector3> &samples);
    Result<QByteArray> externalData();
    /// Registers of a device on a bus; asked once. Errors: Timeout or BoardError where nobody is there, those
    /// of the link.
    Result<QByteArray> i2cRead(int bus, int device, int reg, int length);
    /// Of this board, without contents.
    [[nodiscard]] MemoryImage blankImage() const;
    /// Errors: Unsupported where the board does not tell it.
    [[nodiscard]] Result<int> memorySize() const;
    /// Adds what is missing at the end. Errors: BadReply, Cancelled, those of the link; what was read by then
    /// is there.
    Result<void> readMemory(QByteArray &image, int size);
    /// Adds those that are missing. Errors: Unsupported where the board keeps none, BoardError, and as above.
    Result<void> readFiles(MemoryImage::Files &files, const std::function<bool(int kind)> &isWanted);
    /// Both.
    Result<void> readBoard(MemoryImage &image, int size, bool withFiles);
    /// Into a file. Errors: BadFile, and as above.
    Result<MemoryImage> copyBoard(const QString &path, bool withFiles);
    /// Errors: ConditionUnmet where a copy is of another board or firmware.
    [[nodiscard]] Result<void> checkFits(const MemoryImage &image, bool isForeignMeant) const;
    [[nodiscard]] static Error otherSize(const QString &path, const MemoryImage &image, int size);
    /// How many bytes were written. Errors: NoEffect, those of the board and of the link.
    Result<int> writeMemory(const QByteArray &now, const QByteArray &wanted);
    /// How many were written or erased. @param isMeant the kinds that are in both; errors as above
    Result<int> writeFiles(const MemoryImage::Files &now, const MemoryImage::Files &wanted,
                           const std::function<bool(int kind)> &isMeant);
    /// The memory with a copy's settings in it, as far as their place is found. Errors: ConditionUnmet.
    Result<QByteArray> withSettings(const QByteArray &now, const MemoryImage &image, ActionReply &reply);
    Result<MemoryImage> readCalibrations();
    /// A file of the board. Errors: BoardError with the board's code, BadReply, those of the link.
    Result<QByteArray> readFile(int type, int index);
    Result<void> putFile(int type, int index, const QByteArray &content);
    static Error fileRefusal(int code);
    [[nodiscard]] int scriptSlots() const;
    /// Errors: OutOfRange. @param slot from 0, as everywhere below
    [[nodiscard]] Result<void> checkSlot(int slot) const;
    /// Bytes, 0 = empty. Errors: BoardError where it cannot be read, those of the link.
    Result<int> scriptSize(int slot);
    /// The same of its bytes.
    Result<QByteArray> scriptIn(int slot);
    /// Whether there is one that can run. Errors: ConditionUnmet, and as above.
    Result<void> checkScript(int slot);
    /// Writes a script into a slot, or erases it, with a copy of what is there before.
    /// Errors: InvalidArgument, BadFile, NoBackup before anything is sent; then those of the board, NoEffect.
    Result<ActionReply> replaceScript(int slot, const QByteArray &wanted, const QString &keep);
    /// Proven by reading back. Errors: NoEffect, those of the board and of the link.
    Result<void> putScript(int slot, const QByteArray &content);
    bool takeScriptBack(int slot, const QByteArray &old);
    Result<ActionReply> orderScript(int mode, int slot);
    class ScriptEvents;
    Result<ActionReply> endScript(int slot, ScriptEvents &events);

    /// The angles, once the camera is where its target is; it is steered until then.
    /// Errors: NotSeen, those of the link.
    [[nodiscard]] static double turned(const Device::Control &setpoint, Duration since);
    [[nodiscard]] bool hasTurned(const Device::Control &setpoint, const ActionReply &before);
    Result<ActionReply> arrived(const Device::Control &setpoint, const ControlFrames &frames);
    Result<ActionReply> calibrate(CommandId id, const QVariantMap &arguments);
    struct Stillness
    {
        double gyroBias = 0;
        double gyroNoise = 0;
        double accError = 0;  ///< g, from 1 g along the face that points up; of its length where motors run
        std::array<double, 3> acc{};  ///< g, mean
        bool isUpright = false;  ///< Z points up
        bool motorsRun = false;
        int imu = 0;  ///< whose figures they are: 1 main, 2 frame
    };
    /// Errors: ConditionUnmet (no sensor), NoSamples, those of the link.
    Result<Stillness> measureStillness();
    /// Whether a sensor that lies like that can be measured. Errors: ConditionUnmet.
    static Result<void> checkStill(CommandId id, const Stillness &stillness);
    /// Whether the sensor is better than before a calibration. Errors: NoEffect.
    static Result<void> checkBetter(CommandId id, const Stillness &before, const Stillness &after);
    /// Whether the board says that it has no sensor.
    [[nodiscard]] static bool isBlind(const Frame &status);
    /// Errors: ConditionUnmet.
    Result<void> needSensor();
    static Request stopSearchRequest();
    /// Whether the board searches gains at this moment; watches it for some seconds.
    Result<bool> isSearching();
    Result<QMap<QString, double>> gainsInUse(int profile, bool isActive);
    /// The same answer, once the board's status agrees. Errors: NoEffect.
    Result<ActionReply> motorsAre(bool on);
    /// What a search may change and the board uses now.
    Result<std::vector<AdjustableValue>> searchedValues();
    /// Stops a search that may be going on, and says in the error what became of that.
    Error afterSearch(Error error);
    /// The same, and the values from before are in use again.
    Error afterSearch(const Error &error, const std::vector<AdjustableValue> &before);
    /// Proves that the motors are off. Errors: NotProven, those of the link.
    Result<void> stopMotors();

    Device &m_device;
    Channel &m_channel;
};

}  // namespace simplebgc
