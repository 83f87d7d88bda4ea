// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/deviceclient.h"
#include "protocol/device/uniformsamples.h"

/// A small movement that is made on purpose, to see how an axis follows.
struct MotionTestPlan
{
    enum class Kind { Steps, Sweep };

    static constexpr double kMostDegrees = 10;

    Kind kind = Kind::Steps;
    Axis axis = Axis::Pitch;
    double degrees = 2;  ///< height of a step, or half of the swing; 0.2 to kMostDegrees
    int steps = 6;  ///< there and back counts two; 2 to 40
    double rest = 1.0;  ///< seconds from step to step, 0.3 to 5
    double fromHz = 0.5;  ///< of a sweep, 0.1 to toHz
    double toHz = 12;  ///< up to 20: set-points go out 50 times a second
    double sweepSeconds = 20;  ///< 5 to 120
    double limit = 4;  ///< degrees the axis may be off beyond the movement itself; more ends the test

    /// Errors: OutOfRange.
    [[nodiscard]] Result<void> check() const;
    /// Degrees from the middle at a time since the beginning.
    [[nodiscard]] double offsetAt(double seconds) const;
    [[nodiscard]] double duration() const;
};

/// What was seen of it: both sides at the same instants.
struct MotionTestResult
{
    MotionTestPlan plan;
    UniformSamples target;
    UniformSamples angle;
};

/// Runs a motion test: steers one axis through the client's control stream (so that the dead-man's rule and
/// "motors off" hold), watches telemetry all the while, and stops when the axis does not follow. Where a
/// board tells its targets, the test begins from the one in force. Where it does not, the camera is brought
/// to its middle first, and what was sent stands for the target; the line's delay cannot be told from the
/// board's own then, so that only steps are measured. Lives on the screen's thread.
class MotionTest final : public QObject
{
    Q_OBJECT
public:
    explicit MotionTest(DeviceClient &client, QObject *parent = nullptr);

    /// The axis' angle, and where the board tells it the target, must come as telemetry. Errors:
    /// NotConnected, ReadOnly, Unsupported (no way to steer by angle, no telemetry, a sweep without targets),
    /// OutOfRange, Busy, Unready (motors are off, or the axis does not hold still).
    Result<void> start(const MotionTestPlan &plan);
    /// Ends it, gives control back. failed() tells Cancelled.
    void stop();
    [[nodiscard]] bool isRunning() const { return m_timer.isActive(); }
    /// Whether the board tells where it wants an axis to be.
    [[nodiscard]] static bool tellsTargets(const Device &device);
    /// Channels that have to come.
    [[nodiscard]] static QList<int> channels(const Device &device, Axis axis);

signals:
    void progressed(double share);
    void measured(const MotionTestResult &result);
    /// Errors besides those of the link: Diverged (the motors were switched off), Unready (telemetry stopped,
    /// motors off), Cancelled, InvalidArgument (the samples have too many holes).
    void failed(const Error &error);

private:
    void tick();
    void center();
    void steer(double offset);
    void end(const Result<MotionTestResult> &result, bool release);
    [[nodiscard]] std::optional<Error> danger();
    [[nodiscard]] double latest(int channel) const;
    [[nodiscard]] Result<MotionTestResult> collect() const;
    [[nodiscard]] UniformSamples sentTarget(const UniformSamples &angle) const;

    DeviceClient &m_client;
    QTimer m_timer;
    MotionTestPlan m_plan;
    int m_mode = 0;
    double m_speed = 0;
    std::array<double, kAxisCount> m_middle{};  // set-points without the movement
    double m_rest = 0;  // where the axis stands then
    bool m_centering = false;
    double m_quietAngle = 0;  // near which the axis has been since then
    TimePoint m_quietSince{};
    std::vector<std::pair<TimePoint, double>> m_sent;  // offsets, each until the next
    TimePoint m_startedAt{};
    quint64 m_lastRows = 0;
    TimePoint m_lastNewsAt{};
};
