// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/simplebgc/commands.h"

#include <QStringList>

#include <array>
#include <vector>

/// Payloads of the serial API as plain structs, for both directions (errata 3). Decoders take the part they
/// know and ignore what later firmware adds; a payload that is too short is BadReply.
namespace simplebgc {

/// Reply of BOARD_INFO (errata 3.1).
struct BoardInfo
{
    int boardVersion = 0;  ///< x10: 30 = 3.0
    int firmware = 0;  ///< 2590 = 2.59b0
    bool debugMode = false;
    quint32 features = 0;  ///< low word BOARD_FEATURES, high word its extension (later firmware)
    bool usb = false;
    quint32 extraId = 0;
    int baseFirmware = 0;  ///< of an experimental build, 0 = none

    static Result<BoardInfo> decode(Bytes payload);
    [[nodiscard]] QByteArray encode() const;
    /// "SimpleBGC 3.0".
    [[nodiscard]] QString modelText() const;
    /// "2.59b0"; from 2.73 on the last digit is a release: "2.73.8".
    [[nodiscard]] QString firmwareText() const;
    friend bool operator==(const BoardInfo &, const BoardInfo &) = default;
};

enum BoardFeature : quint32 {
    ThreeAxis = 1U << 0,
    BatteryMonitor = 1U << 1,
    Encoders = 1U << 2,
    BodeTest = 1U << 3,
    Scripting = 1U << 4,
    CurrentSensor = 1U << 5,
    Magnetometer = 1U << 6,
    CanPort = 1U << 10,
};

/// Reply of BOARD_INFO_3 (errata 3.2).
struct BoardInfo3
{
    QByteArray deviceId;  ///< 9 bytes
    QByteArray mcuId;  ///< 12 bytes
    quint32 eepromSize = 0;
    std::array<quint16, 5> scriptSizes{};

    static Result<BoardInfo3> decode(Bytes payload);
    [[nodiscard]] QByteArray encode() const;
    friend bool operator==(const BoardInfo3 &, const BoardInfo3 &) = default;
};

inline constexpr int kProfileCount = 5;
inline constexpr int kProfileNameSize = 48;

/// Five names of 48 bytes, UTF-8, zero padded; a character is never split (errata 3.18).
Result<QStringList> decodeProfileNames(Bytes payload);
[[nodiscard]] QByteArray encodeProfileNames(const QStringList &names);

/// GET_ANGLES (errata 3.11). Degrees and degrees per second.
struct AxisAngles
{
    double imu = 0;
    double target = 0;
    double targetSpeed = 0;  ///< GET_ANGLES only
    double rotor = 0;  ///< GET_ANGLES_EXT only; does not wrap
    friend bool operator==(const AxisAngles &, const AxisAngles &) = default;
};
using Angles = std::array<AxisAngles, 3>;
Result<Angles> decodeAngles(Bytes payload);
Result<Angles> decodeAnglesExt(Bytes payload);
[[nodiscard]] QByteArray encodeAngles(const Angles &angles);
[[nodiscard]] QByteArray encodeAnglesExt(const Angles &angles);

/// One adjustable variable: number and its 32-bit value (errata 3.15).
struct AdjVar
{
    int id = 0;
    qint32 value = 0;
    friend bool operator==(const AdjVar &, const AdjVar &) = default;
};
inline constexpr int kAdjVarsPerCommand = 40;
Result<std::vector<AdjVar>> decodeAdjVars(Bytes payload);
[[nodiscard]] QByteArray encodeAdjVars(const std::vector<AdjVar> &values);

/// Declaration of a debug variable (errata 3.17).
struct DebugVar
{
    enum Type : quint8 { U8 = 1, I8, U16, I16, U32, I32, F32 };
    QString name;
    int type = U8;  ///< as sent; unknown numbers are kept, but their values cannot be read
    int axis = 0;  ///< 0 none, 1 roll, 2 pitch, 3 yaw
    bool isAngle = false;  ///< 14-bit angle
    int count = 1;  ///< array size, 0 counts as 1
    [[nodiscard]] int size() const;  ///< bytes of all elements, 0 for an unknown type
    friend bool operator==(const DebugVar &, const DebugVar &) = default;
};
/// Declarations in one DEBUG_VARS_INFO_3 frame: the total that the board states, and those in this frame.
struct DebugVarList
{
    int total = 0;
    std::vector<DebugVar> vars;
};
Result<DebugVarList> decodeDebugVarsInfo(Bytes payload);
[[nodiscard]] QByteArray encodeDebugVarsInfo(int total, std::span<const DebugVar> vars);
/// Values in the order of the declarations, arrays element by element; angles in degrees.
Result<std::vector<std::vector<double>>> decodeDebugVars(std::span<const DebugVar> vars, Bytes payload);
[[nodiscard]] QByteArray encodeDebugVars(std::span<const DebugVar> vars,
                                         const std::vector<std::vector<double>> &values);

/// Progress of AUTO_PID (errata 3.16). Raw gains as in PARAMS_3.
struct AutoPidProgress
{
    std::array<int, 3> p{};
    std::array<int, 3> i{};
    std::array<int, 3> d{};
    std::array<int, 3> lpf{};
    int iteration = 0;
    std::array<float, 3> trackingError{};
    static Result<AutoPidProgress> decode(Bytes payload);
    [[nodiscard]] QByteArray encode() const;
    friend bool operator==(const AutoPidProgress &, const AutoPidProgress &) = default;
};

enum AutoPidFlag {
    AutoPidRoll = 1,
    AutoPidPitch = 2,
    AutoPidYaw = 4,
    AutoPidReport = 8,
    AutoPidKeepCurrent = 16,
    AutoPidTuneLpf = 32
};

/// One axis of CONTROL (errata 3.12). Raw units, see units.h.
struct ControlAxis
{
    int mode = 0;  ///< low nibble mode, high nibble flags
    int speed = 0;
    int angle = 0;
    friend bool operator==(const ControlAxis &, const ControlAxis &) = default;
};
using ControlCommand = std::array<ControlAxis, 3>;
enum ControlModeId {
    NoControl,
    Speed,
    Angle,
    SpeedAngle,
    Rc,
    AngleRelFrame,
    RcHighRes,
    Ignore,
    AngleShortest
};
enum ControlFlag {
    ControlMixFollow = 0x10,
    ControlPrecise = 0x20,
    ControlAutoTask = 0x40,
    ControlHighResSpeed = 0x80
};
/// The 13-byte form (one mode for all axes); the three modes must be equal.
[[nodiscard]] QByteArray encodeControlShort(const ControlCommand &command);
/// The 15-byte form (firmware 2.55b5): a mode per axis.
[[nodiscard]] QByteArray encodeControl(const ControlCommand &command);
/// Accepts both forms.
Result<ControlCommand> decodeControl(Bytes payload);

/// DATA_STREAM_INTERVAL (errata 3.10): 21 bytes; 23 are accepted when decoding.
struct DataStream
{
    int command = 0;
    int intervalMs = 0;  ///< 0 = stop, 1 = every 0.8 ms cycle
    QByteArray config;  ///< 8 bytes
    [[nodiscard]] QByteArray encode() const;
    static Result<DataStream> decode(Bytes payload);
    friend bool operator==(const DataStream &, const DataStream &) = default;
};

/// Extended form of CALIB_ACC and CALIB_GYRO, 12 bytes (errata 3.19).
[[nodiscard]] QByteArray encodeCalibration(int imu, int action);

/// BEEP_SOUND (errata 3.20): 12 bytes, plus two per note.
[[nodiscard]] QByteArray encodeBeep(int mode, int noteLength, int decay, const QList<int> &notes);

/// Channels of API_VIRT_CH_CONTROL in percent of their way (errata 3.23); those that are NaN or behind the
/// last one are given by nobody. 31 are sent: of 32 the last cannot be a source (errata 4.3).
[[nodiscard]] QByteArray encodeChannels(const std::vector<double> &percents, bool isFine = false);

}  // namespace simplebgc
