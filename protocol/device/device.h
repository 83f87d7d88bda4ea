// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/actionspec.h"
#include "protocol/device/configuration.h"
#include "protocol/device/foreignfile.h"
#include "protocol/device/scriptlanguage.h"
#include "protocol/device/telemetry.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"

/// How one axis is to be steered.
struct AxisSetpoint
{
    int mode = 0;  ///< number of one of Device::controlModes()
    double speed = 0;  ///< degrees per second
    double angle = 0;  ///< degrees (or the mode's own unit, see ControlMode)
};

/// Set-points of roll, pitch, yaw.
using ControlSetpoint = std::array<AxisSetpoint, kAxisCount>;

/// A way of steering that the board offers.
struct ControlMode
{
    int id = 0;
    const char *key = "";
    const char *label = "";
    bool usesSpeed = false;
    bool usesAngle = false;
    double maxSpeed = 0;
    double minAngle = 0;
    double maxAngle = 0;
    const char *unit = "°";  ///< of what stands in for the angle
    double padReach = 0;  ///< where the rim of a pad points; 0: 45 and 90 degrees
};

/// A variable that the board changes at once, in its volatile memory.
struct AdjustableValue
{
    int id = 0;
    double value = 0;
};

/// What is known of such a variable before any board is asked. Values are the board's own numbers; where a
/// parameter stands behind it (ParameterSpec::adjustable), that tells unit and scale.
struct AdjustableSpec
{
    int id = 0;
    const char *key = "";
    const char *label = "";
    const char *group = "";
    Axis axis = Axis::None;
    int min = 0;
    int max = 255;
    int since = 0;  ///< firmware that introduced it
};

/// An inner variable of the firmware that can be watched.
struct DebugVariable
{
    QString name;
    QString type;  ///< "i16", "f32[3]"; "?" for a type we do not know
    int elements = 1;
    Axis axis = Axis::None;

    friend bool operator==(const DebugVariable &, const DebugVariable &) = default;
};

/// A frame in words, for the console.
struct FrameText
{
    QString name;  ///< "READ_PARAMS_3"
    QString fields;  ///< "profile 1, pid.roll.p 15"
};

/// A command typed by hand.
struct RawCommand
{
    QString name;
    QByteArray bytes;  ///< the complete frame
    ActionRisk risk = ActionRisk::Destroys;
};

/// A fault the board reports: what it is called; cause and cure are worded in widgets/.
struct BoardFault
{
    QString key;  ///< "no-sensor"
    QString name;  ///< "No IMU"
    QString meaning;
    QString cure;
    bool severe = true;
};

/// Something the board tells of its parts: a name, and words that stand side by side. All of it is in the
/// tables' catalogue.
struct BoardFact
{
    const char *name = "";
    std::vector<const char *> words;
};

/// Roles that pages need to find channels by meaning, whatever the family calls them.
struct ChannelRoles
{
    std::array<int, 3> angle{-1, -1, -1};
    std::array<int, 3> target{-1, -1, -1};
    std::array<int, 3> gyro{-1, -1, -1};
    std::array<int, 3> acc{-1, -1, -1};  ///< x, y, z
    std::array<int, 3> frameAngle{-1, -1, -1};
    std::array<int, 3> motorPower{-1, -1, -1};
    int battery = -1;
    int temperature = -1;
    int current = -1;
    int motorsOn = -1;
    int faults = -1;  ///< bit set, see Device::faults()
    int faultDetail = -1;
    int activeProfile = -1;
    int cycleTime = -1;
    int busErrors = -1;
    int state = -1;  ///< what the board is doing, see Device::stateText()
};

/// What the operator should decide when a board was found: a sentence, and the action that changes it.
struct ConnectOffer
{
    const char *text = "";
    const char *choice = "";  ///< what the button says
    const char *action = "";
};

/// Where the parameters of one notch filter are: their keys, and the bit that switches it on.
struct NotchFilter
{
    QString frequency;  ///< Hz
    QString width;  ///< Hz
    QString depth;  ///< dB, positive takes out
    QString enabled;
    int bit = 0;
};

/// A family's knowledge as plain sequential code against a Channel. Constant once identified, so the screen
/// may read the tables while the worker thread uses the rest.
class Device
{
public:
    virtual ~Device() = default;

    [[nodiscard]] virtual std::unique_ptr<Framer> makeFramer() const = 0;
    /// Rate and parity pairs worth trying on a serial line, most likely first.
    [[nodiscard]] virtual QList<LineSettings> lineCandidates() const = 0;
    /// One harmless question; true if a board of this family answered it.
    virtual Result<bool> probe(Channel &channel) = 0;
    /// Finds out who is there. Errors: Timeout, BadReply, LinkClosed.
    virtual Result<BoardIdentity> identify(Channel &channel) = 0;
    [[nodiscard]] virtual const BoardIdentity &identity() const = 0;
    /// From now on nothing is written: a recording, or a board that somebody else is in charge of.
    virtual void setReadOnly() = 0;
    [[nodiscard]] virtual std::shared_ptr<const ParameterSet> parameters() const = 0;

    /// Reads everything; a missing part is left out, not an error.
    virtual Result<Configuration> readConfiguration(Channel &channel) = 0;
    virtual Result<QByteArray> readBlock(Channel &channel, BlockKey key) = 0;
    /// Writes one block to permanent memory. May make its profile the active one.
    virtual Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) = 0;
    /// Brackets a series of writeBlock() so that the board takes them as one change, where it can.
    virtual Result<void> beginWrite(Channel &channel) = 0;
    virtual Result<void> endWrite(Channel &channel) = 0;
    virtual Result<void> selectProfile(Channel &channel, int profile) = 0;
    virtual Result<int> activeProfile(Channel &channel) = 0;
    virtual Result<QStringList> readProfileNames(Channel &channel) = 0;
    virtual Result<void> writeProfileNames(Channel &channel, const QStringList &names) = 0;
    /// Longest profile name in UTF-8 bytes.
    [[nodiscard]] virtual int profileNameBytes() const = 0;

    virtual Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) = 0;
    virtual Result<void> writeAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) = 0;

    /// The three gains are those of a PID whose shape follows from them (protocol/analysis/pidshape.h).
    [[nodiscard]] virtual bool hasPidShape() const { return false; }

    /// The live-adjustable variables that this board has.
    [[nodiscard]] virtual std::span<const AdjustableSpec> adjustables() const = 0;

    [[nodiscard]] virtual bool hasDebugVariables() const { return true; }
    virtual Result<std::vector<DebugVariable>> debugVariables(Channel &channel) = 0;
    /// Values in the order of debugVariables(), arrays element by element.
    virtual Result<std::vector<std::vector<double>>> readDebugVariables(Channel &channel) = 0;

    [[nodiscard]] virtual std::span<const ActionSpec> actions() const = 0;
    /// Performs an action with arguments from parseArguments(). Errors: InvalidArgument, Unsupported, the
    /// board's own.
    virtual Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments)
        = 0;
    /// The action that stores the values in use; empty where there is none.
    [[nodiscard]] virtual QString storeAction() const = 0;

    /// The notch filters that an axis has; none where the firmware has none.
    [[nodiscard]] virtual std::vector<NotchFilter> notchFilters(Axis axis) const = 0;

    [[nodiscard]] virtual ChannelTable channels() const = 0;
    [[nodiscard]] virtual ChannelRoles roles() const = 0;
    /// Channels that can be had at full rate with this firmware.
    [[nodiscard]] virtual QList<int> fastChannels() const = 0;
    /// The streams that this board can be asked for; none where it has to be polled.
    [[nodiscard]] virtual QList<StreamSpec> streams() const = 0;
    /// What a wish takes of the line, without asking the board. Errors: InvalidArgument (no such stream or
    /// rate).
    [[nodiscard]] virtual Result<StreamBudget> streamBudget(const TelemetryWish &wish,
                                                            std::optional<LineSettings> line) const = 0;
    /// Errors: those of streamBudget(), TooMuch (the line cannot carry the streams), the board's own.
    virtual Result<TelemetryPlan> startTelemetry(Channel &channel, const TelemetryWish &wish,
                                                 std::optional<LineSettings> line)
        = 0;
    virtual void stopTelemetry(Channel &channel) = 0;
    /// For a recording: a decoder that learns from what was sent which streams the board was asked for.
    [[nodiscard]] virtual std::shared_ptr<TelemetryDecoder> replayDecoder() const = 0;
    /// The faults behind the value of the faults channel.
    [[nodiscard]] virtual std::vector<BoardFault> faults(unsigned bits, unsigned detail) const = 0;
    /// What its status words say of its parts. @param latest the newest value of a channel, NaN without one
    [[nodiscard]] virtual std::vector<BoardFact> facts(const std::function<double(int)> &) const
    {
        return {};
    }
    /// A state in words; empty where the board tells none.
    [[nodiscard]] virtual QString stateText(int) const { return {}; }
    /// A text that the board sends for the operator's eyes; empty for other frames.
    [[nodiscard]] virtual QString spokenText(const FrameView &) const { return {}; }
    [[nodiscard]] virtual std::optional<ConnectOffer> connectOffer() const { return {}; }

    /// A frame in words. @param fromBoard its direction; numbers mean other things each way
    [[nodiscard]] virtual FrameText describeFrame(const FrameView &frame, bool fromBoard) const = 0;
    /// The same for bytes that left for the board, which may be several frames in one go.
    [[nodiscard]] virtual FrameText describeSent(QByteArrayView bytes) const;
    /// True for frames that carry live data, so that a log may leave them out.
    [[nodiscard]] virtual bool isTelemetryFrame(int id) const = 0;
    /// A name with payload bytes in hex ("EXECUTE_MENU 0B") or a complete frame in hex. Errors:
    /// InvalidArgument.
    [[nodiscard]] virtual Result<RawCommand> parseCommand(const QString &text) const = 0;
    /// Names that parseCommand() understands.
    [[nodiscard]] virtual QStringList commandNames() const = 0;

    /// True for the board's notice that it is about to restart.
    [[nodiscard]] virtual bool announcesReset(const FrameView &frame) const = 0;
    [[nodiscard]] virtual Request motorsOffRequest() const = 0;
    [[nodiscard]] virtual Request motorsOnRequest() const = 0;
    [[nodiscard]] virtual std::span<const ControlMode> controlModes() const = 0;
    [[nodiscard]] virtual ControlFrames controlFrames(const ControlSetpoint &setpoint) const = 0;
};

/// A family of controllers as the program's table of families lists it.
struct Family
{
    QString key;  ///< "simplebgc"
    QString name;  ///< "SimpleBGC 32-bit"
    std::function<std::unique_ptr<Device>()> makeDevice;
    /// The parameters that a board with this identity has, to understand a file without the board.
    std::function<std::shared_ptr<const ParameterSet>(const BoardIdentity &)> makeParameters;
    /// What recognizeProtocol() calls its bytes, when another family was asked for.
    QStringList speaks = {};
    /// Programs that its boards keep; null where there are none.
    std::shared_ptr<const ScriptLanguage> scripts = nullptr;
    /// The settings files of its own original program.
    std::optional<ForeignFile> settingsFile = {};
    /// Files with the calibration of a sensor.
    std::optional<CalibrationFile> calibrationFile = {};
};
