// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/rotation.h"
#include "protocol/simulator/simplebgc/autopidsearch.h"
#include "protocol/simulator/simplebgc/receiver.h"
#include "protocol/simulator/world/simulatedboard.h"
#include "protocol/simulator/world/stabilizer.h"

#include <QHash>
#include <QMap>

#include <deque>
#include <map>
#include <set>
#include <span>

namespace simplebgc {

/// Codes of ERROR (errata 3.18).
enum Refusal {
    kWrongSize = 1,
    kWrongParameters = 2,
    kUnknownCommand = 6,
    kWrongState = 8,
    kNotSupported = 9,
    kOperationFailed = 10
};

inline constexpr int kMostSources = 127;  ///< whose values fit into one frame
inline constexpr int kMemorySize = 32768;
inline constexpr int kFcRollPin = 3;  ///< as signal sources count them (errata 4.3)
inline constexpr int kFcPitchPin = 4;
inline constexpr int kMainImu = 1;
inline constexpr int kFrameImu = 2;  ///< of SELECT_IMU_3 and calibrations
inline constexpr int kOnce = 1;  ///< action of CALIB_ACC and CALIB_GYRO
inline constexpr int kMiddleStability = 128;  ///< of AUTO_PID, where nobody tells it
inline constexpr double kResetNotice = 1.0;  ///< document CMD_RESET: 1000 ms between notice and restart

/// A SimpleBGC 32-bit controller on a simulated gimbal: memory per profile, volatile variables, streams,
/// calibrations, automatic tuning, resets. Behaves as described in the document and errata 7.
class SimulatedBoard final : public ::SimulatedBoard
{
public:
    explicit SimulatedBoard(const SimulatorOptions &options);
    ~SimulatedBoard() override;

    void receive(Bytes bytes) override;
    void cycle() override;
    QByteArray takeOutput(qsizetype max) override;
    [[nodiscard]] bool isRunning() const override { return m_bootLeft <= 0 && !m_isInBootLoader; }
    /// From 2.41 on both parities are accepted (document "Message format").
    [[nodiscard]] std::optional<Parity> onlyParity() const override
    {
        return m_options.firmware < 2410 ? std::optional(Parity::Even) : std::nullopt;
    }
    [[nodiscard]] StreamCount streamCount() const override { return m_streamCount; }
    void setFaults(const Faults &faults) override { m_options.faults = faults; }

    // For tests and the demo: the board's surroundings.
    Stabilizer &stabilizer() { return m_stabilizer; }
    [[nodiscard]] int activeProfile() const { return m_active; }
    /// A stored value, as it would be loaded at start-up.
    [[nodiscard]] int stored(const QString &key, int profile) const;
    /// The value in use.
    [[nodiscard]] int inUse(const QString &key) const;
    void store(const QString &key, int profile, int raw);
    /// Simulated time in seconds.
    [[nodiscard]] double now() const { return m_now; }
    [[nodiscard]] bool isCalibrating() const { return m_calibration.left > 0; }
    [[nodiscard]] const ControlCommand &lastControl() const { return m_control; }
    /// What comes out of a servo's pin, in µs: 0 it is held low, below 0 it floats.
    [[nodiscard]] int servoPulse(std::size_t servo) const { return m_servos[servo]; }

private:
    using Block = std::array<QByteArray, BlockCount>;

    // memory (board.cpp)
    void loadDefaults(int profile);
    void unpack();
    void loadProfile(int profile);
    void applyParameters();
    void shareBoardValues(int from);
    /// What is in use goes to the active profile.
    void storeAll();
    [[nodiscard]] double value(const QString &key) const;
    [[nodiscard]] double axisValue(const char *pattern, Axis axis) const;
    /// How gains are stored (errata 3.3); the search of gains counts as the linear scale does.
    [[nodiscard]] bool isLogarithmic() const { return m_options.firmware >= 2731; }
    [[nodiscard]] const ParameterSpec *spec(const QString &key) const { return m_parameters.find(key); }
    void restart(double afterSeconds);
    void boot();

    // world (board.cpp)
    void updateFaults();
    void updateTargets();
    // signals (signals.cpp)
    void setChannels(const Frame &frame);
    void updateSlots();
    void runRcCommand();
    /// A remote control or virtual channels can steer it.
    [[nodiscard]] bool isSignalled() const { return m_signals.isAny || m_receiver.isReceiving(); }
    /// The board looks at a pin because something uses it, or because it was asked to.
    [[nodiscard]] bool isWatched(int pin) const;
    /// -1 to 1; empty: nobody gives it.
    [[nodiscard]] std::optional<double> signal(int source) const;
    [[nodiscard]] std::optional<double> rcInput(const QString &name) const;
    [[nodiscard]] std::optional<double> rcTarget(Axis axis);
    [[nodiscard]] QByteArray slotState(const Frame &frame) const;
    [[nodiscard]] QByteArray rcData() const;
    [[nodiscard]] QByteArray rcChannels() const;
    [[nodiscard]] QByteArray rcInputs(const Frame &frame);
    // menu commands and what they switch (menu.cpp); each tells the code with which it is refused, 0 = done
    struct MenuEntry;
    enum Switch { SwitchOff, SwitchOn, SwitchOver };
    enum Event { MenuButtonEvent = 1, MotorEvent, EmergencyEvent, CameraEvent, ScriptEvent, RetractedEvent };
    enum EventType { EventOff = 1, EventOn = 2 };
    [[nodiscard]] static std::span<const MenuEntry> menuEntries();
    void menu(const Frame &frame);
    void updateMenu();
    int runMenu(int action);
    int doNothing(int argument);
    int useProfile(int profile);
    int swapSticks(int axis);
    int invertStick(int axis);
    int trimSticks(int argument);
    int calibrateSensor(int which);
    int calibrateNorth(int argument);
    int resetEstimate(int argument);
    int announceReset(int argument);
    int takeAnglesByHand(int isStored);
    int switchMotors(int how);
    int switchMotorsSafely(int how);
    int turnFrameOver(int argument);
    int tuneAll(int argument);
    int lookDown(int argument);
    int goHome(int argument);
    int takeHome(int argument);
    int level(int axes);
    int centerMotors(int axes);
    int untwist(int argument);
    int retract(int argument);
    int turnYaw(int isFromFrame);
    int switchYaw(int argument);
    int switchRoll(int argument);
    int pressButton(int argument);
    int triggerCamera(int type);
    int startScript(int slot);
    int stopScript(int argument);
    int loadProfileSet(int index);
    int forceFollow(int argument);
    int disableFollow(int argument);
    int setTripod(int how);
    int setShake(int how);
    int setServoMode(int how);
    void stopMotors();
    [[nodiscard]] double powerLeft() const;
    [[nodiscard]] bool follows(Axis axis) const;
    [[nodiscard]] quint32 systemState() const;
    void updateModes();
    void tellEvent(Event event, int type);
    void tellChanges();
    // the rest of its memory (memory.cpp)
    bool handleMemory(const Frame &frame);
    [[nodiscard]] QByteArray memory() const;
    void setMemory(const QByteArray &bytes);
    void profileSet(const Frame &frame);
    void sendFile(const Frame &frame);
    void takeFile(const Frame &frame);
    [[nodiscard]] int scriptSlots() const;
    void runScript(int slot, bool isDebugged, int version);
    void updateScript();
    void keepCalibration(int imu);
    void bootCalibrations();
    [[nodiscard]] SimulatedImu &sensor(int imu) { return imu == kFrameImu ? m_frameImu : m_stabilizer.imu(); }
    // motors and pins (mounting.cpp)
    bool handleMotors(const Frame &frame);
    bool startMotorCalibration(const Frame &frame, double seconds);
    /// The board is measuring something, and begins nothing else.
    [[nodiscard]] bool isBusy() const;
    /// It turns the motors itself, step by step.
    [[nodiscard]] bool isStepping() const;
    int finishMotorCalibration();
    void watchEncoders();
    void watchSignals();
    void startEncoderCalibration(const Frame &frame);
    void startGainCalibration(const Frame &frame);
    void startRippleCalibration(const Frame &frame);
    void storeRipple();
    void useRipple();
    void turnMotors();
    [[nodiscard]] int encoderFailure() const;
    void storeMotors();
    void startPoleCalibration(const Frame &frame);
    [[nodiscard]] bool turnsMotor(Axis axis);
    void turnForPoles();
    int storePoles();
    void storeEncoders();
    int storeGains();
    /// What CALIB_MODE says (errata 4.6).
    [[nodiscard]] int calibrationMode() const;
    // what it is equipped with (sensors.cpp)
    void fitSensors();
    void bootSensors();
    void believeAxes();
    [[nodiscard]] double ownAcc(std::size_t axis) const;
    void updateSensors();
    [[nodiscard]] bool isFitted(const char *option) const
    {
        return m_options.own.value(QLatin1String(option)) != 0;
    }
    /// A parameter of an axis names the encoder that is there.
    [[nodiscard]] bool isRead(Axis axis) const;
    /// Degrees, as the board reads them.
    [[nodiscard]] double encoderReading(Axis axis) const;
    /// Between frame and camera, as the board knows it.
    [[nodiscard]] double motorAngle(Axis axis) const;
    [[nodiscard]] bool isFrameSensor() const;
    void updateFrameSensor();
    [[nodiscard]] double frameAngle(Axis axis) const;
    void updateMagnetometer();
    [[nodiscard]] std::array<double, 3> fieldAtCamera() const;
    [[nodiscard]] Stabilizer::Hand handOnCamera() const;
    [[nodiscard]] std::array<double, 3> earthField(double roll, double pitch, double yaw) const;
    void startMagCalibration(const Frame &frame);
    void updateMagCalibration();
    // other sensors, buses, the boot loader (expert.cpp)
    bool handleExpert(const Frame &frame);
    void correctGyro(const Frame &frame);
    bool takeAttitude(const Frame &frame);
    [[nodiscard]] std::optional<QByteArray> busBytes(int address, int reg, int length) const;
    void takeBusBytes(int address, int reg, const QByteArray &bytes);
    void updateMotorCalibration();
    void updateCalibration();
    // other ways to steer (finesteering.cpp)
    bool handleSteering(const Frame &frame);
    void controlFinely(const Frame &frame);
    void stopSteering();
    void limitSteering(const Frame &frame);
    void controlAttitude(const Frame &frame);
    void limitAttitude(const Frame &frame);
    [[nodiscard]] QByteArray attitudeState(quint32 set) const;
    void steerAxis(std::size_t axis, const ControlAxis &wanted, double speed, double destination);
    void updateSteering();
    void turnAttitude();
    /// The next target of an axis that turns towards a goal, or at its speed.
    [[nodiscard]] double nextTarget(std::size_t axis, std::optional<double> goal);
    // a frequency response (frequencytest.cpp)
    void startFrequencyTest(const Frame &frame);
    void updateFrequencyTest();
    [[nodiscard]] double stimulus();
    void sendFrequencySamples();
    void endFrequencyTest(int code);
    // what its sensors know of themselves (sensorinfo.cpp)
    bool handleSensorInfo(const Frame &frame);
    [[nodiscard]] QByteArray calibrationInfo(int imu) const;
    void noteTemperatures(CommandId command, int imu, int action);
    void startReference(const Frame &frame);
    void levelByReference(const std::array<double, kAxisCount> &mean);
    /// To the camera's right, front and top, of what is told in the sensor's own axes.
    [[nodiscard]] std::array<double, kAxisCount> fromSensor(const std::array<double, kAxisCount> &own) const;
    // what later firmware has beside that (later.cpp)
    bool handleLater(const Frame &frame);
    [[nodiscard]] bool isStreamed(CommandId id) const;
    void setServos(const Frame &frame);
    [[nodiscard]] QByteArray realtimeCustom2(quint32 flags) const;
    void tune2(const Frame &frame);
    [[nodiscard]] QByteArray referenceInfo() const;
    void forget();
    /// @param refusal code of ERROR; 0: it went well
    void sendEnd(CommandId command, int version, int refusal);
    void autoPid(const Frame &frame);
    void startAutoPid(CommandId command, int flags, int filters,
                      const std::array<int, kAxisCount> &gainVsStability);
    void updateAutoPid();

    // commands that have grown (generations.cpp)
    bool handleGrown(const Frame &frame);
    void tellVariables(const Frame &frame);
    void tellValues(const Frame &frame);
    void saveVariables(const Frame &frame);
    void useDefaults(const Frame &frame);
    void bracketWrites(const Frame &frame);
    void motorsOff(const Frame &frame);

    // commands (commands.cpp)
    void handle(const Frame &frame);
    bool handleRead(const Frame &frame);
    bool handleWrite(const Frame &frame);
    bool handleAction(const Frame &frame);
    void readParams(const Frame &frame, int block);
    void writeParams(const Frame &frame, int block);
    void setAdjVars(const Frame &frame);
    void getAdjVars(const Frame &frame);
    void registerStream(const Frame &frame);
    void control(const Frame &frame);
    void startCalibration(const Frame &frame);
    void beginCalibration(CommandId command, int imu, int action, int version);
    void reply(const Frame &to, CommandId id, const QByteArray &payload);
    void confirm(const Frame &to, const QByteArray &data = {});
    void refuse(const Frame &to, int code);
    [[nodiscard]] bool hasSize(const Frame &frame, qsizetype size);
    [[nodiscard]] QByteArray realtime(bool extended) const;
    [[nodiscard]] int motorOutput(Axis axis) const;
    [[nodiscard]] bool isTooLong(quint32 flags) const;
    [[nodiscard]] QByteArray realtimeCustom(quint32 flags) const;
    [[nodiscard]] QByteArray laterFields(quint32 flags) const;
    [[nodiscard]] double volts() const;
    [[nodiscard]] int celsius(int normal) const;
    /// Gravity and heading in vector form, 24 bytes.
    [[nodiscard]] QByteArray attitudeVectors(bool ofFrame = false) const;
    [[nodiscard]] Angles angles() const;
    [[nodiscard]] std::vector<std::vector<double>> debugValues() const;
    void sendStreams();
    [[nodiscard]] QByteArray polled(CommandId id, const QByteArray &payload);
    void send(CommandId id, const QByteArray &payload, int version, bool isStream = false);
    [[nodiscard]] std::optional<qint32> adjVar(int id) const;
    bool setAdjVar(int id, qint32 value);

    struct Stream
    {
        DataStream request;
        int version = 1;
        double next = 0;
        double interval = 0;
        QByteArray sent = {};  // the newest payload
    };
    struct Calibration
    {
        CommandId command{};
        double left = 0;
        double total = 0;
        int action = 1;
        int version = 1;
        std::array<double, kAxisCount> sum{};
        std::array<double, kAxisCount> low{};
        std::array<double, kAxisCount> high{};
        int samples = 0;
        bool motorsWereOn = false;
        int imu = 1;
    };
    void finishAccCalibration(const std::array<double, kAxisCount> &mean);

    struct Delayed
    {
        double at = 0;
        QByteArray frame;
    };

    SimulatorOptions m_options;
    ParameterSet m_parameters;
    Stabilizer m_stabilizer;
    Framer m_framer;
    std::deque<Frame> m_commands;
    qsizetype m_queuedBytes = 0;
    std::deque<Delayed> m_replies;
    QByteArray m_output;
    std::array<Block, kProfileCount> m_eeprom;
    Block m_ram;
    QStringList m_names;
    QMap<int, qint32> m_otherVars;  // adjustable variables without a corresponding parameter
    int m_active = 0;
    int m_imu = 1;
    double m_now = 0;
    double m_nextCommandAt = 0;
    double m_streamsAt = 0;  // nothing is streamed before
    double m_bootLeft = 0;
    double m_restartAt = -1;
    double m_bootLoaderAt = -1;
    bool m_isInBootLoader = false;  // until the power goes off and on, which is the restart of the world
    double m_voltageOffset = 0;
    quint64 m_serialErrors = 0;
    std::vector<Stream> m_streams;
    std::map<CommandId, QByteArray> m_polled;  // the newest answers
    StreamCount m_streamCount;
    Calibration m_calibration;
    std::array<std::array<std::optional<double>, 2>, kAxisCount>
        m_accLimits;  // readings with the axis down, up
    std::unique_ptr<AutoPidSearch> m_autoPid;
    CommandId m_autoPidCommand = CommandId::AutoPid;
    int m_autoPidVersion = 1;
    bool m_autoPidReports = false;
    bool m_autoPidStores = false;
    ControlCommand m_control{};
    /// What comes in over API_VIRT_CH_CONTROL.
    struct Signals
    {
        std::array<std::optional<double>, 32> channels{};  // -1 to 1
        std::array<int, kTriggerSlots> fifths{};  // 0 none, 1 to 5
        int third = 0;  // of the input of commands: 0 none, 1 to 3
        bool isAny = false;
    };
    Signals m_signals;
    SimulatedReceiver m_receiver;
    std::set<int> m_initialized;  // pins
    // What else it keeps.
    QByteArray m_restOfMemory;
    QByteArray m_external;
    QMap<int, QByteArray> m_files;  // by type and, in the high byte, number
    std::array<std::vector<Block>, 6> m_sets;  // the last one is the backup
    struct Script
    {
        int slot = -1;
        bool isDebugged = false;
        double next = 0;
        int line = 0;
        int version = 1;
    };
    Script m_script;
    enum class Follow { AsSet, Forced, Off };
    /// What commands have switched, until the next start.
    struct Modes
    {
        Follow follow = Follow::AsSet;
        bool isTripod = false;
        bool isShaking = false;
        bool isServo = false;
        bool isRetracted = false;
        double safeStopLeft = 0;  // seconds
        double byHandUntil = -1;
        bool isByHandStored = false;
        bool motorsWereOn = false;
        std::array<double, kAxisCount> frame{};  // where it was one cycle ago
        std::array<double, kAxisCount> shake{};  // part of the target
    };
    Modes m_modes;
    std::array<double, kAxisCount> m_home{};
    std::array<bool, 4> m_told{};  // by EVENT
    struct MotorCalibration
    {
        CommandId command{};
        double until = -1;
        int version = 1;
        bool motorsWereOn = false;
        double seconds = 0;
        std::array<bool, kAxisCount> axes{};
        std::array<double, kAxisCount> from{};  // where the camera stands
        std::array<double, kAxisCount> turn{};  // how far it is turned
        std::array<double, kAxisCount> turned{};  // how far it really was
        std::array<double, kAxisCount> low{};
        std::array<double, kAxisCount> high{};
        std::array<double, 6> sums{};  // of signals and angles
        int samples = 0;
        bool trustsAnything = false;
        int iterations = 0;
    };
    MotorCalibration m_motorCalibration;
    // What others tell of its attitude.
    std::array<double, kAxisCount> m_frameTold{};
    double m_frameToldUntil = -1;
    std::array<double, kAxisCount> m_gyroTold{};
    QHash<int, int> m_sensorRegisters;
    int m_starts = 0;
    double m_mostCurrent = 0;
    double m_countedFrom = 0;  // seconds of work
    // CONTROL_CONFIG, CONTROL_QUAT and its settings.
    struct SteeringLimits
    {
        double timeout = 0;  // seconds, 0: none
        bool isSilent = false;  // CONTROL is not confirmed
        std::array<double, kAxisCount> acceleration{};  // 0: none
    };
    SteeringLimits m_steeringLimits;
    double m_steeredAt = 0;
    struct AttitudeControl
    {
        int mode = 0;
        int flags = 0;
        Orientation target{1, 0, 0, 0};
        Orientation setpoint{1, 0, 0, 0};
        std::array<double, kAxisCount> speed{};  // told, degrees per second about the camera's axes
        std::array<double, kAxisCount> turning{};  // of the set-point
        std::array<double, kAxisCount> maxSpeed{};  // 0: as fast as it may
        std::array<double, kAxisCount> maxAcceleration{};
        bool isTask = false;
        int version = 1;
    };
    AttitudeControl m_attitude;
    struct FrequencyTest
    {
        int axis = -1;  // none
        int system = 0;
        int type = 0;
        double gain = 0;
        double from = 0;  // Hz
        double to = 0;
        quint32 total = 0;
        quint32 done = 0;
        int counter = 0;  // of its frames
        int version = 1;
        double phase = 0;
        double target = 0;  // where the axis stood
        double given = 0;  // the newest stimulus
        Biquad upper;
        Biquad lower;
        double level = 1;  // of the noise that is left
        std::vector<std::array<double, 2>> samples{};
    };
    FrequencyTest m_frequencyTest;
    std::array<int, 4> m_servos{-1, -1, -1, -1};
    // What its sensors know of the temperatures that they were calibrated at.
    struct Temperatures
    {
        bool isUsed = false;
        std::optional<std::pair<int, int>> range{};
        std::array<int, 6> positions{};  // how often: right, front, top, and their opposites
    };
    std::array<double, kAxisCount> m_reference{};  // of the accelerometer, in g
    std::map<std::pair<CommandId, int>, Temperatures> m_temperatures;  // by calibration and sensor
    QByteArray m_tune2;  // settings of AUTO_PID2
    std::array<double, kAxisCount> m_moveSpeed{};
    std::array<double, kAxisCount> m_turnSpeed{};  // at which a target turns that may only speed up so fast
    bool m_hasFrameSensor = false;  // according to the parameters
    std::array<double, kAxisCount> m_targetSpeed{};  // at which CONTROL turns the targets now
    std::array<double, kAxisCount> m_destination{};
    bool m_taskRunning = false;
    int m_lastVersion = 1;
    bool m_emergency = false;
    int m_emergencyCause = 9;  // errata 4.5
    // Sensors that only some boards have. They have noise of their own, so that the others stay as they are.
    SimulatedNoise m_sensorNoise;
    SimulatedImu m_frameImu;
    std::array<double, kAxisCount> m_frameRawGyro{};
    std::array<double, kAxisCount> m_frameRawAcc{};
    std::array<double, 3> m_magRaw{210, -40, 380};  // counts; without the sensor they say nothing
    std::array<double, 3> m_magZero{};  // found by calibration
    std::array<double, 3> m_magScale{1, 1, 1};  // the same
    double m_headingError = 0;  // degrees
    struct MagCalibration
    {
        double until = -1;
        int version = 1;
        bool motorsWereOn = false;
        std::array<double, 3> low{};
        std::array<double, 3> high{};
    };
    MagCalibration m_magCalibration;
    int m_mount = 0;
    bool m_isWriteSet = false;  // between the two WRITE_PARAMS_SET
    std::optional<int> m_writtenProfile;  // to be loaded at its end
    int m_menuVersion = 0;  // of the command whose end is told; 0: none
    int m_writesSeen = 0;
    int m_resetOnWrite = 0;  ///< of which write they are counted
    bool m_otherClientDone = false;
    double m_resetDone = -1;  // the time of the last restart that the world made
};

}  // namespace simplebgc
