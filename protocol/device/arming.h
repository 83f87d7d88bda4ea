// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <optional>

/// Why a machine that flies is not armed, or is armed no longer.
enum class ArmingBar {
    None,
    NoLink,
    Silent,  ///< nothing has come for a second
    NoState,  ///< it does not say whether it is armed
    Unchecked,  ///< nobody has checked its directions
    NoPropellerWord,  ///< nobody has said what its propellers can do
    NotCalibrated,
    Calibrating,
    ArmedElsewhere,  ///< it is armed, and not from here
    MotorsTurn,  ///< disarmed, and its outputs are not 0
    Busy,  ///< the board is at work
    Stopping,  ///< a stop is not proven yet
    Throttle,  ///< not at zero
    Pushed,  ///< another stick is not in its middle
    Unassigned,  ///< what it is steered with lacks a stick
    Shared,  ///< another ground station talks to it
    Battery,  ///< below the limit of its alarm
    Tilted,  ///< farther than a machine stands that is about to take off
    NoSticks,  ///< what it is steered with has told nothing for 250 ms
    // Only ends:
    Operator,  ///< who let go, pressed disarm or closed the session
    NotArmed,  ///< it was told to arm and did not say that it is
    Disarmed,  ///< it says that it is disarmed, and nobody told it so from here
    Focus,  ///< the window is not in front any more
    Hidden,  ///< the page is not seen any more
    Covered,  ///< something else lies over the sticks or takes the keyboard
    Locked,  ///< the screen was locked
    Idle,  ///< nobody has moved anything for a while
    Emergency,  ///< the motors were stopped
    CheckOver,  ///< the check of directions for which it was armed has ended
    Changed,  ///< values are being written
    Hung,  ///< the program did not send in time
    Unguarded,  ///< what stops it if this program dies is not there
    Failed,  ///< an error
};

/// The rules under which a machine is armed from here and stays so (BCFlight errata 9.2). Told what is known
/// and what the operator does; tells what may be sent. No clock, no thread, no screen.
class ArmingSession
{
public:
    static constexpr auto kHold = 1s;  ///< for which the key is held before it arms
    static constexpr auto kAnswer = 1500ms;  ///< in which it has to say that it is armed
    static constexpr auto kSilence = 1s;
    static constexpr auto kSticks = 250ms;
    /// Degrees. Steeper than any ground from which it is started: it lies on its side, is carried, or its
    /// calibration is wrong, and it would turn over or leave sideways. A stand may hold it as it likes.
    static constexpr double kMaxTilt = 15;
    static constexpr double kMiddle = 0.1;  ///< of a stick that is not pushed

    enum class Phase {
        Closed,  ///< nothing is sent
        Open,  ///< nothing is sent yet
        Holding,  ///< the key is held: controls are sent, disarmed
        Asked,  ///< armed controls are sent, and it has not confirmed
        Armed,
    };

    /// What is known of the machine and the program.
    struct Known
    {
        bool isLinked = false;
        TimePoint heardAt{};  ///< the last packet
        TimePoint toldAt{};  ///< its state
        TimePoint disarmedAt{};  ///< when it said last that it is disarmed, whatever it has said since
        std::optional<bool> isArmed{};
        std::optional<bool> isCalibrated{};
        std::optional<bool> isCalibrating{};
        std::optional<bool> isDriven{};  ///< an output is not 0; empty: it does not tell
        bool isBusy = false;  ///< a procedure runs
        bool isStopping = false;
        bool isChecked = false;
        bool isShared = false;  ///< another ground station talks to it
        bool isBatteryLow = false;  ///< below the limit of its alarm
        double tiltDeg = 0;  ///< roll or pitch, the larger
    };
    /// What the operator does, freshly read.
    struct Sticks
    {
        double throttle = 0;  ///< 0 to 1
        TimePoint at{};  ///< when they were read
        double pushed = 0;  ///< of the others, the one that is pushed farthest, 0 to 1
        bool isComplete = true;  ///< there is a stick for everything
    };
    enum class Send { Nothing, Disarmed, Armed };

    [[nodiscard]] Phase phase() const { return m_phase; }
    /// Armed controls are sent.
    [[nodiscard]] bool isArming() const { return m_phase >= Phase::Asked; }
    /// By the operator's word: nothing that its propellers reach can be hurt. @param held in a test stand
    void open(bool held);
    [[nodiscard]] bool isHeld() const { return m_isHeld; }
    /// Ends everything; nothing is sent any more. True if what was sent has to be stopped.
    bool close();

    /// The key that arms goes down or up.
    void press(TimePoint now);
    void release();
    /// What keeps it from being armed now, the most important first.
    [[nodiscard]] ArmingBar bar(const Known &known, const Sticks &sticks, TimePoint now) const;
    /// To be called for each set-point. Nothing: the stream ends (if it ran: stop).
    Send step(const Known &known, const Sticks &sticks, TimePoint now);
    /// It is disarmed for this reason; arming it again takes a new press. True if something was sent.
    bool end(ArmingBar why);
    /// Why it was disarmed last.
    [[nodiscard]] ArmingBar ended() const { return m_ended; }
    /// How much of the time for which the key is held is over, 0 to 1.
    [[nodiscard]] double held(TimePoint now) const;

private:
    [[nodiscard]] ArmingBar barBefore(const Known &known, const Sticks &sticks, TimePoint now) const;
    [[nodiscard]] ArmingBar barSince(const Known &known, const Sticks &sticks, TimePoint now) const;

    Phase m_phase = Phase::Closed;
    bool m_isHeld = false;
    TimePoint m_since{};  // of the phase
    TimePoint m_confirmedAt{};  // that it is armed
    ArmingBar m_ended = ArmingBar::None;
};
