// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <QByteArray>
#include <QList>

#include <array>
#include <optional>

/// How far the directions of a machine that flies have been checked, and what was found.
struct CheckedDirections
{
    enum class Level {
        Nothing,
        Signs,  ///< angles and sticks: it may be armed without propellers, to check the rest
        All,
    };
    Level level = Level::Nothing;
    /// 1, or -1 where its angle grows when it is tilted to the left, nose up or turned to the left.
    std::array<int, kAxisCount> angles{1, 1, 1};
    /// 1, or -1 where it goes the wrong way when a stick is sent as it is pushed.
    std::array<int, kAxisCount> sticks{1, 1, 1};
    /// 1, or -1 where the mixing has the motors on the right, in front or turning clockwise with the other
    /// sign; known with All.
    std::array<int, kAxisCount> motors{1, 1, 1};

    [[nodiscard]] QByteArray encode() const;
    /// What encode() has made; nothing is checked where it is something else.
    [[nodiscard]] static CheckedDirections decode(const QByteArray &text);
    friend bool operator==(const CheckedDirections &, const CheckedDirections &) = default;
};

/// Leads through the check of directions, which no protocol tells (BCFlight errata 12): tilt it each way,
/// push each stick, and, armed without propellers, look which motors answer. Pure; told what is measured.
class DirectionCheck
{
public:
    enum class Kind {
        Tilt,  ///< by hand: to the right, nose down, turned to the right
        Stick,  ///< here: to the right, forward, turned to the right
        TiltAnswer,  ///< armed: the motors that bring it back turn faster
        StickAnswer,  ///< armed: the motors that take it there turn faster
    };
    struct Step
    {
        Kind kind = Kind::Tilt;
        Axis axis = Axis::Roll;
        friend bool operator==(const Step &, const Step &) = default;
    };
    enum class Sight {
        Waiting,
        Other,  ///< something else moves more
        Seen,  ///< it has to go back to the middle, or the question be answered
    };
    using Axes = std::array<double, kAxisCount>;

    static constexpr double kTilt = 15;  ///< degrees
    static constexpr double kLevel = 6;
    static constexpr double kPush = 0.35;  ///< share of full deflection; a key gives a half
    static constexpr double kStickLevel = 0.1;
    static constexpr int kIdleCount = 4;  ///< looks at outputs, held level
    static constexpr int kSeenCount = 3;  ///< looks in a row at the same motors
    static constexpr double kMostThrottle = 0.15;  ///< while it is armed for the check

    /// @param known what was found before; checking begins with what is missing
    explicit DirectionCheck(const CheckedDirections &known = {});

    /// Nothing: it is done, or has failed.
    [[nodiscard]] std::optional<Step> step() const;
    [[nodiscard]] int stepNumber() const { return m_step; }
    [[nodiscard]] static int stepCount();
    [[nodiscard]] Sight sight() const { return m_sight; }
    /// It has to be armed for this step.
    [[nodiscard]] bool isArmedStep() const;
    /// Angles as the board tells them, in degrees; NaN: not known.
    void feedAngles(const Axes &angles);
    /// As the operator pushes, -1 to 1.
    void feedSticks(const Axes &sticks);
    /// How many motors answer an axis together, e.g. two of four; 0: half of them.
    void setSizes(const std::array<int, kAxisCount> &sizes) { m_sizes = sizes; }
    /// Shares of full output, motor by motor; empty: they are not driven. It has to be held level, with the
    /// sticks let go, until they are steady: what changes is judged against that.
    void feedOutputs(const QList<double> &outputs);
    /// The throttle has to be at zero for a moment, so that what the controller has summed up in the step
    /// before is gone.
    [[nodiscard]] bool wantsIdle() const { return isArmedStep() && m_idleCount < kIdleCount; }
    /// The outputs were steady: now it may be tilted, or the stick pushed.
    [[nodiscard]] bool isReady() const { return m_isReady; }
    /// It is tilted, or the stick pushed, as far as is wanted, and no other axis further. Until then the
    /// outputs are not compared, however much they differ.
    [[nodiscard]] bool isStimulated() const { return m_isStimulated; }
    /// The stick of this step is sent the other way round since it was answered for the wrong motors.
    [[nodiscard]] bool isReversed() const;
    /// The motors that turned faster than the others when it was tilted, or the stick pushed; from 1. They
    /// stay what they were when they were seen until the question is answered.
    [[nodiscard]] const QList<int> &faster() const { return m_faster; }
    /// The motors that turn faster are those that should, or are not. A stick that answers the wrong way is
    /// reversed once, and the step comes again. An answer that contradicts an earlier one begins both axes
    /// again.
    void answer(bool isRight);
    /// The last answer contradicted an earlier one.
    [[nodiscard]] bool isContradicted() const { return m_isContradicted; }
    /// The motors, from 1, on the right, in front, turning clockwise, as was answered.
    [[nodiscard]] const std::array<QList<int>, kAxisCount> &named() const { return m_named; }
    /// It brings itself the wrong way: it must not fly.
    [[nodiscard]] std::optional<Axis> failed() const { return m_failed; }
    [[nodiscard]] const CheckedDirections &found() const { return m_found; }

private:
    void look(const Axes &values, double enough, double level);
    void await();
    void next();
    void rest(const QList<double> &outputs);
    [[nodiscard]] bool isUntouched() const;
    [[nodiscard]] QList<int> compare(const QList<double> &outputs) const;
    void repeat(std::size_t axis);
    [[nodiscard]] bool isAlike(const QList<int> &motors, const QList<int> &others) const;
    [[nodiscard]] std::optional<std::size_t> contradicted(Step step, bool isRight) const;

    CheckedDirections m_found;
    int m_step = 0;
    Sight m_sight = Sight::Waiting;
    Axes m_start{};
    int m_idleCount = 0;
    bool m_isStarted = false;
    bool m_isStimulated = false;
    QList<int> m_faster;
    QList<int> m_candidates;  // seen so often in a row
    int m_seenCount = 0;
    Axes m_angles{};
    Axes m_sticks{};
    bool m_isReady = false;
    QList<double> m_rest;  // outputs before it is tilted, or the stick pushed
    double m_noise = 0;  // of them
    int m_restCount = 0;
    std::array<int, kAxisCount> m_sizes{};
    std::array<bool, 4 * kAxisCount> m_isDone{};
    std::array<QList<int>, kAxisCount> m_named;  // on the right, in front, clockwise, as was answered
    bool m_isContradicted = false;
    std::array<bool, kAxisCount> m_isReversed{};
    std::optional<Axis> m_failed;
};
