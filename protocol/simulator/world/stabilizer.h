// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/plant.h"

/// The gains and filters of one axis as the simulated controller uses them.
struct AxisGains
{
    double p = 0;
    double i = 0;
    double d = 0;
    double gain = 1.0;  ///< multiplies all three
    double power = 0;  ///< 0..1
    bool inverted = false;  ///< relative to how the motor is wired
    int poles = 14;
    double lpfHz = 0;  ///< 0 = off
    double dLpfHz = 0;
    struct Notch
    {
        double hz = 0, width = 0, gainDb = 0;
    };
    std::array<Notch, 3> notches{};
};

/// Second-order filter section.
class Biquad
{
public:
    static Biquad lowPass(double hz, double sampleRate);
    static Biquad notch(double hz, double width, double depthDb, double sampleRate);
    double process(double input);

private:
    double m_b0 = 1, m_b1 = 0, m_b2 = 0, m_a1 = 0, m_a2 = 0;
    double m_x1 = 0, m_x2 = 0, m_y1 = 0, m_y2 = 0;
};

/// The inertial sensor: noise, a gyroscope bias and an accelerometer error, both removed by calibration.
struct SimulatedImu
{
    std::array<double, kAxisCount> gyroBias{1.7, -2.4, 0.4};  ///< deg/s; nothing corrects yaw
    std::array<double, kAxisCount> accError{0.035, -0.028, 0.02};  ///< g
    std::array<double, kAxisCount> gyroCorrection{};  ///< found by calibration
    std::array<double, kAxisCount> accScaleError{1.03, 0.975, 1.02};  ///< reading per true g
    std::array<double, kAxisCount> accCorrection{};
    std::array<double, kAxisCount> accScale{1.0, 1.0, 1.0};  ///< found by calibration in both directions
    double gyroNoise = 0.06;  ///< deg/s per sample
    double accNoise = 0.004;  ///< g
};

/// The firmware's control loop on the plant: sensors, attitude estimate, PID, filters, limits. One step takes
/// 0.8 ms.
class Stabilizer
{
public:
    static constexpr double kCycle = 0.0008;

    explicit Stabilizer(unsigned seed);

    void setGains(Axis axis, const AxisGains &gains);
    void setGyroTrust(double trust) { m_gyroTrust = trust; }
    void setMotorsOn(bool on);
    [[nodiscard]] bool motorsOn() const { return m_motorsOn; }
    void setImuPresent(bool present) { m_imuPresent = present; }
    [[nodiscard]] bool imuPresent() const { return m_imuPresent; }
    /// The camera is held still or lies on the table: the sensors see no motion.
    void setHeld(bool held) { m_held = held; }
    /// The camera lies still on one of its faces: 1-6 with Z, -Z, X, -X, Y, -Y up; 7 tilted 45 degrees down;
    /// 0 = in the gimbal.
    void setPose(int pose);
    [[nodiscard]] int pose() const { return m_pose; }
    /// What a hand does with the camera in the gimbal.
    enum class Hand { None, HoldsLevel, Moves, NoseDown, RightDown, TurnsOver, TurnsUpright };
    void setHandOnCamera(Hand hand);
    /// True gravity, in g, in the camera's axes right, forward and up.
    [[nodiscard]] const std::array<double, kAxisCount> &gravity() const { return m_gravity; }
    /// The accelerometer before calibration, in g.
    [[nodiscard]] double rawAcc(std::size_t axis) const { return m_rawAcc[axis]; }
    /// The axes that the firmware takes for forward, left and up, in terms of the true ones: rows of a
    /// rotation matrix. Not the identity if the sensor is mounted differently from what the firmware is
    /// configured for.
    using Rotation = std::array<std::array<int, 3>, 3>;
    void setBelievedAxes(const Rotation &axes);
    /// Which plug of a motor that axis drives: its own, unless told otherwise.
    void setOutput(Axis axis, Axis plug) { m_axes[index(axis)].plug = plug; }
    /// The axis whose motor is plugged in there.
    [[nodiscard]] Axis motorAt(Axis plug) const;
    [[nodiscard]] Axis motorOf(Axis axis) const { return motorAt(m_axes[index(axis)].plug); }
    /// Roll and pitch motors are swapped.
    void setSwappedMotors(bool swapped) { m_swapped = swapped; }
    void setVoltage(double volts) { m_voltage = volts; }
    /// Share of the motor's torque that its field gives: 1 where it is led as the magnets stand, 0 across
    /// them, below 0 the motor pulls the wrong way.
    void setField(Axis axis, double share) { m_axes[index(axis)].field = share; }
    void step();

    [[nodiscard]] double target(Axis axis) const { return m_axes[index(axis)].target; }
    void setTarget(Axis axis, double degrees) { m_axes[index(axis)].target = degrees; }
    /// Attitude as estimated by the board.
    [[nodiscard]] double estimate(Axis axis) const { return m_axes[index(axis)].estimate; }
    /// Something else than its sensors tells the board where it is.
    void setEstimate(Axis axis, double degrees) { m_axes[index(axis)].estimate = degrees; }
    /// True attitude.
    [[nodiscard]] double trueAngle(Axis axis) const { return m_axes[index(axis)].plant.angle(); }
    [[nodiscard]] double jointAngle(Axis axis) const { return m_axes[index(axis)].plant.jointAngle(); }
    [[nodiscard]] double gyro(Axis axis) const { return m_axes[index(axis)].gyro; }
    [[nodiscard]] double rawGyro(Axis axis) const { return m_axes[index(axis)].rawGyro; }
    /// Accelerometer, x y z in g, with calibration applied.
    [[nodiscard]] const std::array<double, kAxisCount> &acc() const { return m_acc; }
    /// The same to the camera's right, forward and up, wherever the firmware takes those to be.
    [[nodiscard]] double calibratedAcc(std::size_t axis) const
    {
        return m_imuPresent ? (m_rawAcc[axis] - m_imu.accCorrection[axis]) / m_imu.accScale[axis] : 0.0;
    }
    [[nodiscard]] double motorCelsius(Axis axis) const { return m_axes[index(axis)].plant.celsius(); }
    /// Motor effort 0..1 of full power.
    [[nodiscard]] double effort(Axis axis) const { return m_axes[index(axis)].effort; }
    [[nodiscard]] double torque(Axis axis) const { return m_axes[index(axis)].torque; }
    /// What the controller asks of the motor, 1 is all of its torque.
    [[nodiscard]] double command(Axis axis) const { return m_axes[index(axis)].command; }
    /// Added to that, to see what the plant answers.
    void setStimulus(Axis axis, double torque) { m_axes[index(axis)].stimulus = torque; }
    /// Share of the ripple of the motor's magnets that is known and taken out.
    void setRippleKnown(Axis axis, double share) { m_axes[index(axis)].rippleKnown = share; }
    [[nodiscard]] double current() const { return m_current; }
    SimulatedImu &imu() { return m_imu; }
    HandShake &hand() { return m_hand; }
    [[nodiscard]] const HandShake &hand() const { return m_hand; }
    AxisPlant &plant(Axis axis) { return m_axes[index(axis)].plant; }
    /// Sets the estimate to the attitude that is measured, as the board does at start-up.
    void resetEstimate();

private:
    struct AxisState
    {
        explicit AxisState(Axis axis)
            : plant(simulatedMechanics(axis))
            , plug(axis)
        {
        }
        AxisPlant plant;
        Axis plug;
        AxisGains gains;
        std::array<Biquad, 4> filters{};
        Biquad dFilter;
        double target = 0;
        double estimate = 0;
        double integral = 0;
        double gyro = 0;
        double rawGyro = 0;
        double gyroFiltered = 0;
        double command = 0;  // computed in the last cycle, takes effect now: the loop's delay
        double stimulus = 0;  // added to it
        double rippleKnown = 0;
        double effort = 0;
        double torque = 0;
        double field = 1;
    };
    static std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
    void sense();
    void moveByHand();
    void turnByHand();
    void misjudge();
    void updateEstimate();
    void control(AxisState &axis);

    SimulatedNoise m_noise;
    HandShake m_hand;
    SimulatedImu m_imu;
    std::array<AxisState, kAxisCount> m_axes{AxisState(Axis::Roll), AxisState(Axis::Pitch),
                                             AxisState(Axis::Yaw)};
    std::array<double, kAxisCount> m_gravity{0, 0, 1};
    std::array<double, kAxisCount> m_acc{0, 0, 1};
    std::array<double, kAxisCount> m_rawAcc{0, 0, 1};
    static constexpr Rotation kAsMounted{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Rotation m_believed = kAsMounted;
    bool m_believesAnew = false;
    double m_gyroTrust = 120;
    double m_voltage = 12.3;
    double m_current = 0;
    bool m_motorsOn = false;
    bool m_imuPresent = true;
    bool m_held = false;
    int m_pose = 0;
    Hand m_handOnCamera = Hand::None;
    double m_moved = 0;  // seconds since a hand has begun to move it
    bool m_swapped = false;
};
