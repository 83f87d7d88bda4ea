// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/accelerometer.h"
#include "protocol/storm32/device.h"

namespace storm32 {

inline constexpr int kAutoDirection = 2;  ///< of a motor's direction: not found yet

/// The family's jobs with many steps: calibration of the accelerometers (errata 9.2), the gimbal
/// configuration tasks (errata 9.3), and comparing the values in use with the stored ones.
class Procedures
{
public:
    Procedures(Device &device, Channel &channel)
        : m_device(device)
        , m_channel(channel)
    {
    }

    [[nodiscard]] static std::span<const ActionSpec> all();
    /// Errors of all: NotSeen (what it waited for did not happen), BoardError, those of the link.
    Result<ActionReply> perform(const QString &key, const QVariantMap &arguments);

private:
    struct Sensor
    {
        AccReading acc{};  ///< counts
        double temperature = 0;  ///< degrees Celsius
        [[nodiscard]] bool isPresent() const;
    };
    struct Average
    {
        AccReading acc{};
        double deviation = 0;  ///< counts: mean of the three axes' mean absolute deviations
        double temperature = 0;
        int face = -1;
    };
    struct Status
    {
        int state = 0;
        int status = 0;
        int motors = 0;  ///< bits of those that are active
        int busErrors = 0;
    };

    static constexpr std::array<const char *, 3> kSensorAxes{"x", "y", "z"};
    using Sensors = std::array<Sensor, 2>;  ///< camera, frame; a missing one reads about zero
    using Directions = std::array<std::array<int, 3>, 2>;

    // calibration.cpp
    Result<Sensors> sensors();
    /// Errors: NotSeen when there is none.
    Result<Sensor> sensor(int imu);
    Result<Average> average(int imu, int readings, Progress &progress);
    /// Proves that the motors are off, and switches them off where they are not. Errors: NotProven,
    /// NotRestored, those of the link.
    Result<void> keepMotorsOff();
    /// Waits until the sensor lies still on one of the wanted faces, then measures.
    /// @param byHand it is turned over by hand: the motors are kept off
    Result<Average> face(int imu, unsigned wanted, bool byHand, Progress &progress);
    /// Errors: OutOfRange where no sensor is like that.
    [[nodiscard]] Result<void> checkPlausible(const AccCalibration &calibration) const;
    Result<void> writeCalibration(int imu, const AccCalibration &calibration);
    [[nodiscard]] double oneG() const;
    /// NotSeen, with what it measured: !isGravity().
    [[nodiscard]] Error notGravity(const AccReading &acc) const;
    [[nodiscard]] static ActionReply replyOf(const AccCalibration &calibration, double oneG,
                                             double temperature);

    Result<ActionReply> averaged(int imu, int readings);
    Result<ActionReply> calibrate(int imu, bool six, bool store);

    // setup.cpp
    Result<Status> status();
    Result<void> writeWords(const std::array<int, 3> &words, int raw);
    Result<void> disableMotors();
    Result<ActionReply> findOrientation();
    /// Which axes of the first `count` sensors point up (or forward, if `up` is given), once all have been
    /// clear for a second.
    Result<Directions> holdAxes(std::size_t count, const Directions *up, milliseconds limit,
                                Progress &progress);
    Result<ActionReply> restartAndWait();
    Result<ActionReply> takeMotors(bool directions, bool positions);
    Result<void> setDirections(int direction);
    Result<ActionReply> setPoles(const std::array<int, 3> &poles);
    Result<ActionReply> beginYaw();
    Result<ActionReply> moveYaw(double degrees);
    Result<ActionReply> endYaw(bool take);

    Result<ActionReply> compareStored();

    Device &m_device;
    Channel &m_channel;
    bool m_switchedOff = false;  ///< keepMotorsOff() had to stop motors that were running
};

}  // namespace storm32
