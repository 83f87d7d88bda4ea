// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/pidshape.h"
#include "protocol/base/clock.h"
#include "protocol/base/frame.h"
#include "protocol/base/result.h"
#include "protocol/configuration/configuration.h"
#include "protocol/device/actionspec.h"

#include <functional>
#include <mutex>

class Channel;
class Framer;
struct LineSettings;
struct Request;
struct StreamBudget;
struct StreamSpec;
struct Subscription;

// Features that only some boards have, each as an interface that a device provides or does not. A page is
// listed if the interface it needs is there.

/// Profiles that the board can switch between.
class ProfileAccess
{
public:
    virtual ~ProfileAccess() = default;
    virtual Result<void> selectProfile(Channel &channel, int profile) = 0;
    virtual Result<int> activeProfile(Channel &channel) = 0;
    virtual Result<QStringList> readProfileNames(Channel &channel) = 0;
    virtual Result<void> writeProfileNames(Channel &channel, const QStringList &names) = 0;
    /// Longest name in UTF-8 bytes.
    [[nodiscard]] virtual int profileNameBytes() const = 0;
};

/// Boards that take a series of Device::writeBlock() as one change, or have to be told when it is complete.
class WriteBracket
{
public:
    virtual ~WriteBracket() = default;
    virtual Result<void> beginWrite(Channel &channel) = 0;
    virtual Result<void> endWrite(Channel &channel) = 0;
};

/// What is known about a live variable before a board is asked. Values are in the board's own numbers; if the
/// variable belongs to a parameter (ParameterSpec::adjustable), that gives unit and scale.
struct AdjustableSpec
{
    int id = 0;
    const char *key = "";
    const char *label = "";
    const char *group = "";
    Axis axis = Axis::None;
    double min = 0;
    double max = 255;
    int since = 0;  ///< firmware that introduced it
};

/// A variable whose changes take effect at once, in the board's volatile memory.
struct AdjustableValue
{
    int id = 0;
    double value = 0;
    friend bool operator==(const AdjustableValue &, const AdjustableValue &) = default;
};

/// Live variables that were changed: one write, or several in quick succession (a slider that is dragged).
struct LiveChange
{
    TimePoint from{};  ///< of the first write, as its channel tells the time
    TimePoint until{};  ///< of the last one
    std::vector<AdjustableValue> before;  ///< what the board used before the first write
    std::vector<AdjustableValue> after;  ///< what it was told to use, variable by variable as in `before`
};

/// Variables whose changes take effect at once, without touching what is stored. What was changed last can be
/// taken back by whoever notices that it did harm. Reading and writing may happen on two threads.
class LiveAccess
{
public:
    virtual ~LiveAccess() = default;
    [[nodiscard]] virtual std::span<const AdjustableSpec> adjustables() const = 0;
    virtual Result<std::vector<AdjustableValue>> readAdjustables(Channel &channel, const QList<int> &ids) = 0;
    /// What is in use of all of them.
    Result<std::vector<AdjustableValue>> readAllAdjustables(Channel &channel);
    /// Proven by reading back. Errors: those of checkAdjustable(), before anything is written; NotInUse with
    /// what the board uses instead. What was in use before is noted first.
    Result<void> writeAdjustables(Channel &channel, const std::vector<AdjustableValue> &values);
    /// Puts back what was in use before the program replaced it, proven by reading back. That is no change
    /// which somebody made and which could be taken back.
    Result<void> restoreAdjustables(Channel &channel, const std::vector<AdjustableValue> &values);
    /// Whether an operator may set it. What the board uses already may be set again. Errors: OutOfRange.
    [[nodiscard]] virtual Result<void> checkAdjustable(const AdjustableValue &) const { return {}; }
    /// The action that stores the values in use.
    [[nodiscard]] virtual QString storeAction() const = 0;
    /// What the board would hold once it has stored what is in use, where that rewrites a text which it
    /// keeps; nothing where it stores values. @param inUse the board as it was read, with the values in use.
    /// Errors: why the text cannot take them.
    [[nodiscard]] virtual std::optional<Result<Configuration>> storedAs(const Configuration &inUse) const
    {
        Q_UNUSED(inUse)
        return {};
    }
    /// The variable behind a parameter, -1 = none: what the board can change in volatile memory, whether or
    /// not it is among adjustables(), the ones to tune with.
    [[nodiscard]] virtual int variableOf(const ParameterSpec &spec) const { return spec.adjustable; }

    /// A board tunes itself, or what it made of its values could not be read since: nobody knows what is in
    /// use.
    [[nodiscard]] bool isChanging() const;
    /// What was changed last; empty before the first change and once it was taken back.
    [[nodiscard]] std::optional<LiveChange> lastChange() const;
    /// Puts the values from before the last change into use again, proven by reading back. Errors: Conflict
    /// if the board uses others than were written, so that somebody else changed them since (nothing is
    /// written then); NoEffect if there is no change to take back; those of writing.
    Result<LiveChange> takeBack(Channel &channel);
    /// Runs what may change variables without writing them here: a board that tunes itself. What it changed
    /// counts as a live change afterwards. Returns what the job does.
    bool noteChangesBy(Channel &channel, const std::function<bool()> &job);

protected:
    /// What writeAdjustables() does on the wire.
    virtual Result<void> putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values) = 0;

private:
    void note(TimePoint now, const std::vector<AdjustableValue> &before,
              const std::vector<AdjustableValue> &after);

    /// A change by the board itself that is not known yet.
    struct OpenChange
    {
        bool isRunning = false;
        std::vector<AdjustableValue> before = {};
    };
    void close();

    mutable std::mutex m_mutex;
    std::optional<LiveChange> m_change;
    OpenChange m_open;
};

/// Boards that stream the data they are asked for.
class StreamControl
{
public:
    virtual ~StreamControl() = default;
    [[nodiscard]] virtual QList<StreamSpec> streams() const = 0;
    /// Channels available at full rate with this firmware.
    [[nodiscard]] virtual QList<int> fastChannels() const = 0;
    /// The line capacity that a subscription needs, computed without asking the board. Errors:
    /// InvalidArgument (no such stream or rate).
    [[nodiscard]] virtual Result<StreamBudget> streamBudget(const Subscription &subscription,
                                                            std::optional<LineSettings> line) const = 0;
};

/// Boards that can only store everything in use at once, whoever has set it, and that tell what is stored
/// only by putting it into use for a moment.
class WholeMemory
{
public:
    virtual ~WholeMemory() = default;
    struct Contents
    {
        Configuration inUse;
        Configuration stored;
    };
    /// Both; what was in use is in use again afterwards. Errors: Unsupported (not over this link), Unready
    /// (the board is starting with motors disabled, perhaps by a stop), ConditionUnmet (motors would start,
    /// or let the camera fall), NotRestored (what was in use is not; the detail lists it), those of the link.
    virtual Result<Contents> readBoth(Channel &channel) = 0;
    /// What the last readBoth() found stored, also where it could not put back what was in use.
    [[nodiscard]] virtual std::optional<Configuration> lastStored() const = 0;
    /// Whether readBoth() could tell the two apart with this in use. Errors: Unready.
    virtual Result<void> checkUse(Channel &channel, const Configuration &whole) = 0;
    /// Puts all blocks of a configuration into use.
    virtual Result<void> use(Channel &channel, const Configuration &whole) = 0;
    /// What on the board itself sets parameters, by their keys: "script 2".
    [[nodiscard]] virtual QMap<QString, QString> movedBy(const Configuration &inUse) const = 0;
};

/// An internal variable of the firmware that can be watched.
struct DebugVariable
{
    QString name;
    QString type;  ///< "i16", "f32[3]"; "?" for a type we do not know
    int elements = 1;
    Axis axis = Axis::None;

    friend bool operator==(const DebugVariable &, const DebugVariable &) = default;
};

/// Boards that expose internal variables of their firmware.
class InnerVariables
{
public:
    virtual ~InnerVariables() = default;
    virtual Result<std::vector<DebugVariable>> debugVariables(Channel &channel) = 0;
    /// Values in the order of debugVariables(), arrays element by element.
    virtual Result<std::vector<std::vector<double>>> readDebugVariables(Channel &channel) = 0;
};

/// Boards whose motors are switched on by a command.
class MotorSwitch
{
public:
    virtual ~MotorSwitch() = default;
    /// Switches them on and waits until the board reports it. Errors: NoEffect with the cause as far as it is
    /// known, those of the channel.
    virtual Result<void> switchMotorsOn(Channel &channel) const = 0;
    /// Whether they run, asked now. Errors: Unsupported (nothing answers that), those of the channel.
    virtual Result<bool> areMotorsOn(Channel &) const { return failure(ErrorCode::Unsupported); }
    /// Whether another value of it starts or stops motors by itself.
    [[nodiscard]] virtual bool isSwitchedBy(const ParameterSpec &) const { return false; }
};

/// A frame in readable form, for the console.
struct FrameText
{
    QString name;  ///< "READ_PARAMS_3"
    QString fields;  ///< "profile 1, pid.roll.p 15"
    bool isRefusal = false;  ///< the board does not do what it was told
};

/// A command typed by hand.
struct RawCommand
{
    QString name;
    QByteArray bytes;  ///< the complete frame
    ActionRisk risk = ActionRisk::Destroys;
};

/// Describes frames in readable form and builds frames from text.
class FrameInspector
{
public:
    virtual ~FrameInspector() = default;
    /// @param fromBoard its direction; the same number means different things each way
    [[nodiscard]] virtual FrameText describeFrame(const FrameView &frame, bool fromBoard) const = 0;
    /// The same for bytes that were sent to the board, which may be several frames in one write.
    [[nodiscard]] virtual FrameText describeSent(QByteArrayView bytes) const = 0;
    /// True for frames that carry live data, so that a log may leave them out.
    [[nodiscard]] virtual bool isTelemetryFrame(int id) const = 0;
    /// A name with payload bytes in hex ("EXECUTE_MENU 0B") or a complete frame in hex. Errors:
    /// InvalidArgument.
    [[nodiscard]] virtual Result<RawCommand> parseCommand(const QString &text) const = 0;
    /// Names that parseCommand() understands.
    [[nodiscard]] virtual QStringList commandNames() const = 0;

protected:
    /// Describes what was sent, for protocols with the same frames in both directions.
    [[nodiscard]] FrameText describeFrames(QByteArrayView bytes, Framer &framer) const;
};

/// A fault the board reports: its name; cause and remedy are worded in widgets/.
struct BoardFault
{
    QString key;  ///< "no-sensor"
    QString name;  ///< "No IMU"
    QString meaning;
    QString cure;
    bool severe = true;
};

/// Boards that report faults by themselves (channels with the roles "faults" and "fault_detail").
class FaultWords
{
public:
    virtual ~FaultWords() = default;
    [[nodiscard]] virtual std::vector<BoardFault> faults(unsigned bits, unsigned detail) const = 0;
};

/// Something the board reports about one of its components: a name, and words shown side by side. All of it
/// is in the tables' catalogue.
struct BoardFact
{
    const char *name = "";
    std::vector<const char *> words;
};

/// A decision for the operator when a board was found: a sentence, and the action that makes the change.
struct ConnectOffer
{
    const char *text = "";
    const char *choice = "";  ///< text of the button
    const char *action = "";
};

/// Boards that report in words what they are doing.
class StatusWords
{
public:
    virtual ~StatusWords() = default;
    /// What the status words say about the board's components. @param latest newest value of a channel, NaN
    /// if none
    [[nodiscard]] virtual std::vector<BoardFact> facts(const std::function<double(int)> &latest) const = 0;
    /// The value of the channel with the role "state" in words.
    [[nodiscard]] virtual QString statusText(int state) const = 0;
    /// In that state the board holds what it stabilises; in the others it starts up, levels or stands by.
    [[nodiscard]] virtual bool isStabilising(int state) const = 0;
    /// In that state motors that are off are about to run, without being told to.
    [[nodiscard]] virtual bool isStarting(int) const { return false; }
    /// Text of a message that the board sends to the operator; empty for other frames.
    [[nodiscard]] virtual QString messageText(const FrameView &frame) const = 0;
    [[nodiscard]] virtual std::optional<ConnectOffer> connectOffer() const = 0;
};

/// The parameters of one notch filter: their keys, and the bit that enables it.
struct NotchFilter
{
    QString frequency;  ///< Hz
    QString width;  ///< Hz
    QString depth;  ///< dB, positive attenuates
    QString enabled;
    int bit = 0;
};

/// Boards with notch filters.
class NotchFilters
{
public:
    virtual ~NotchFilters() = default;
    [[nodiscard]] virtual std::vector<NotchFilter> notchesOf(Axis axis) const = 0;
};

/// Boards whose three gains form a PID with a particular shape, so that two sliders can represent them. Has
/// no state; may outlive the device.
class GainShape
{
public:
    virtual ~GainShape() = default;
    [[nodiscard]] virtual PidShape shapeOf(const PidGains &gains) const = 0;
    /// @param damping 0 to 100 @param stability 0 to 100
    [[nodiscard]] virtual PidGains gainsFor(double damping, double stability) const = 0;
    /// Damping and stability that correspond to these gains, each 0 to 100.
    [[nodiscard]] virtual std::pair<double, double> slidersFor(const PidGains &gains) const = 0;
};

/// Boards whose restart can be told from what they send.
class RestartNotice
{
public:
    virtual ~RestartNotice() = default;
    /// The board is about to restart.
    [[nodiscard]] virtual bool announcesReset(const FrameView &frame) const = 0;
    /// Whether bytes that were sent tell the board to restart, and after which time.
    [[nodiscard]] virtual std::optional<milliseconds> ordersReset(QByteArrayView sent) const = 0;
    /// A board is in that state (role "state") only for a while after its start.
    [[nodiscard]] virtual bool isFreshlyStarted(int) const { return false; }
    /// Answered by every board that runs and changes nothing.
    [[nodiscard]] virtual Request harmlessQuestion() const = 0;
};
