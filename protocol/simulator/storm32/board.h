// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "protocol/mavlink/frame.h"
#include "protocol/simulator/world/simulatedboard.h"
#include "protocol/simulator/world/stabilizer.h"
#include "protocol/storm32/commands.h"
#include "protocol/storm32/parametertables.h"

#include <deque>

namespace storm32 {

/// A STorM32 controller on a simulated gimbal: its three command sets byte by byte as in the errata, EEPROM
/// and RAM, the start-up states, the heartbeat that locks out plain commands. What the firmware does not
/// check is not checked here either, unless the strict option is on.
class SimulatedBoard final : public ::SimulatedBoard
{
public:
    /// One unit of Kp, Ki and Kd in the units of the plant's controller, chosen so that the factory gains
    /// hold the simulated camera.
    static constexpr double kUnitP = 8.75;
    static constexpr double kUnitI = 0.13;
    static constexpr double kUnitD = 600.0;
    static constexpr double kCountsPerDegree = 65.5;  ///< of the gyroscope, per second

    explicit SimulatedBoard(const SimulatorOptions &options);
    ~SimulatedBoard() override;

    void receive(Bytes bytes) override;
    void cycle() override;
    QByteArray takeOutput(qsizetype max) override;
    [[nodiscard]] bool isRunning() const override
    {
        return true;
    }  // its USB port stays while the program restarts
    [[nodiscard]] std::optional<Parity> onlyParity() const override { return Parity::None; }
    void setFaults(const Faults &faults) override;

    // For tests: the board's surroundings and its memory.
    Stabilizer &stabilizer() { return m_stabilizer; }
    [[nodiscard]] int layout() const { return m_layout; }
    [[nodiscard]] int inUse(int word) const { return wordOf(m_ram, word); }
    [[nodiscard]] int stored(int word) const { return wordOf(m_eeprom, word); }
    void set(int word, int raw);
    [[nodiscard]] int state() const;
    [[nodiscard]] double now() const { return m_now; }

private:
    // memory and world (board.cpp)
    [[nodiscard]] static int wordOf(const QByteArray &stream, int word);
    [[nodiscard]] double value(const QString &key) const;
    [[nodiscard]] double axisValue(const char *pattern, Axis axis) const;
    [[nodiscard]] QByteArray factoryStream() const;
    void applyParameters();
    void applyCalibration();
    enum class Memory { Keep, Reload };
    void restart(Memory memory);
    void updateWorld();
    void updateTargets();
    [[nodiscard]] double volts() const;
    [[nodiscard]] bool isPanning(Axis axis) const;
    /// Its motor is not disabled by its parameter.
    [[nodiscard]] bool isUsed(Axis axis) const;
    /// Nor is it off.
    [[nodiscard]] bool isDriven(Axis axis) const;

    // reports (reports.cpp)
    [[nodiscard]] QByteArray versionData() const;
    [[nodiscard]] std::array<int, 32> liveWords() const;
    [[nodiscard]] QByteArray liveData(int words) const;
    [[nodiscard]] QByteArray liveFields(int mask) const;
    [[nodiscard]] QByteArray rawSensors();
    using Vector = std::array<double, 3>;
    /// Gravity in the frame's axes forward, left and up, in g.
    [[nodiscard]] Vector frameGravity() const;
    /// The frame sensor's reading of it in its own axes, in g, before calibration and without noise.
    [[nodiscard]] Vector frameReading() const;
    /// The board's estimate of pitch, roll and yaw of the frame, in degrees.
    [[nodiscard]] Vector frameAngles() const;
    [[nodiscard]] double oneG() const
    {
        return m_options.firmware >= 94 ? 8192.0 : 16384.0;
    }  ///< counts (errata 3.9)
    [[nodiscard]] int status() const;
    [[nodiscard]] int status2() const;

    // commands (commands.cpp)
    bool serve();
    [[nodiscard]] bool isLockedOut() const;
    /// The answer to a complete simple command.
    QByteArray simple(Simple id, QByteArrayView arguments);
    bool failsHalfway(const QByteArray &stored);
    /// The answer's number and payload.
    std::pair<int, QByteArray> rc(int id, QByteArrayView payload);
    void takeStartPositions(std::initializer_list<Axis> axes);
    QByteArray writeCalibration(QByteArrayView arguments);
    bool steer(std::size_t axis, int pulse);
    void setPanMode(int mode);
    void usePanSetting(int setting);
    void reply(const QByteArray &bytes);

    // scripts (scripts.cpp)
    struct ScriptRun
    {
        int at = -1;  ///< next statement, from the start of the script; -1 = it has ended
        int input = 0;  ///< its Script Control, and the case, when it began
        int chosen = 0;
        double wakeAt = 0;
    };
    void runScripts();
    void step(int script, ScriptRun &run);
    [[nodiscard]] int caseOffset(int script, int chosen) const;

    // MAVLink (mavlink.cpp)
    /// A frame that the firmware takes: of a known message, with its checksum; it may be too long (errata
    /// 13).
    [[nodiscard]] static std::optional<mavlink::Packet> packetOf(Bytes frame);
    [[nodiscard]] int decode(float value) const;
    [[nodiscard]] bool isSigned(int index) const;
    void message(const mavlink::Packet &packet);
    void sendMessage(mavlink::MessageId id, const QVariantMap &values);
    void sendParameter(int index);
    void sendParameter2(int index, const mavlink::Address &to);
    /// Code of the COMMAND_ACK.
    int command(int id, const std::array<float, 7> &parameters);
    void embedded(QByteArrayView content, const mavlink::Address &from);
    void mountControl(const std::array<double, 3> &values, unsigned flags);
    void beat();
    [[nodiscard]] mavlink::ValueCoding coding() const;
    [[nodiscard]] mavlink::Address address() const;
    [[nodiscard]] int parameterIndex(const QString &id) const;

    SimulatorOptions m_options;
    int m_layout;
    int m_words;
    ParameterSet m_parameters;
    Stabilizer m_stabilizer;
    QByteArray m_ram;  // parameter words and scripts, as `g` delivers them
    QByteArray m_eeprom;
    int m_writesSeen = 0;
    QByteArray m_name;  // 16 bytes
    std::array<int, 18> m_calibration{};
    int m_baudCode = 4;
    double m_now = 0;
    double m_started = 0;  // time at which the program started
    double m_relevelUntil = 0;
    std::optional<std::array<int, 32>> m_frozen;  // live data that stand still
    double m_resetDone = -1;  // the time of the last restart that the world made
    bool m_standby = false;
    QByteArray m_input;
    double m_lastByteAt = 0;
    double m_busyUntil = 0;
    struct Delayed
    {
        double at = 0;
        QByteArray bytes;
    };
    std::deque<Delayed> m_replies;
    QByteArray m_output;
    SimulatedNoise m_latency;
    SimulatedNoise m_frameNoise;
    // Steering: roll, pitch, yaw with the firmware's signs; angle and pulse add up.
    std::array<double, kAxisCount> m_setAngle{};
    std::array<int, kAxisCount> m_pulse{};  // us from the middle
    std::array<double, kAxisCount> m_moved{};  // position reached so far within the speed limit
    std::array<double, kAxisCount> m_pan{};  // offset added by following
    std::optional<int> m_panMode;
    std::array<int, kScriptCount> m_scriptCase{};
    std::array<ScriptRun, kScriptCount> m_scriptRuns{};
    QByteArray m_scriptArea;  ///< what they run
    std::array<std::vector<ScriptLine>, kScriptCount> m_scriptLines;
    int m_pwmOut = 0;
    int m_sequence = 0;
    double m_nextBeat = 0;
    double m_nextAttitude = 0;
    bool m_attitudeAsked = false;
    bool m_heardBeat = false;
    bool m_isBeating = false;
    bool m_isDeaf = false;  // to the command that is served (fault "deaf")
};

}  // namespace storm32
