// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/faults.h"

using namespace Qt::StringLiterals;

namespace simplebgc {

std::vector<BoardFault> faultsOf(unsigned bits, unsigned detail)
{
    struct Row
    {
        const char *key, *name, *meaning, *cure;
        bool severe;
    };
    // SYSTEM_ERROR bits (document REALTIME_DATA_3).
    // clang-format off
    static constexpr Row rows[] = {
        {"no-sensor", "No IMU", "The board does not see its motion sensor, so it cannot stabilize.",
         "Check the sensor cable and its connectors, then restart the board.", true},
        {"calib-acc", "Accelerometer not calibrated", "The horizon will be tilted.",
         "Run the accelerometer calibration.", false},
        {"set-power", "Motor power is not set", "The motors have no power and the camera hangs free.",
         "Set the power of each motor on the Parameters page.", true},
        {"calib-poles", "Poles are not calibrated", "The motors may turn the wrong way.",
         "Set poles and direction of each motor.", true},
        {"protection", "Protection is active", "The motor drivers switch off to save themselves.",
         "Let the motors cool, then lower the power.", true},
        {"serial", "Serial error", "The board received damaged commands.", "Check the cable and its ground.", false},
        {"low-battery", "Battery is low", "The alarm threshold is reached.", "Change the battery soon.", false},
        {"battery-empty", "Battery is empty", "The board says that it switches the motors off then.", "Change the battery.", true},
        {"tool-version", "Firmware and tool differ", "The board expects another version of its configuration tool.",
         "Check the values before writing any.", false},
        {"missed-steps", "Motor lost steps", "A motor could not hold the camera.",
         "Balance the camera, or raise the power of that motor.", true},
        {"system", "System error", "The firmware found a fault in itself.", "Restart the board.", true},
        {"emergency-stop", "Emergency stop", "The board says that it switches the motors off then.",
         "Remove the cause, then restart the board.", true},
    };
    // clang-format on
    // SYSTEM_SUB_ERROR (errata 4.5).
    static constexpr const char *causes[] = {"",
                                             "I2C errors",
                                             "driver too hot",
                                             "driver fault",
                                             "encoder and IMU disagree",
                                             "calibration failed",
                                             "internal fault",
                                             "encoder scale",
                                             "too hot",
                                             "motor poles or inversion",
                                             "memory",
                                             "IMU lost",
                                             "CAN hardware",
                                             "motor too hot",
                                             "motor blocked",
                                             "bad IMU",
                                             "endless restarts",
                                             "wrong start position",
                                             "overload too long",
                                             "CAN driver: over-current",
                                             "CAN driver: under-voltage",
                                             "CAN driver: emergency pin",
                                             "CAN driver: field-oriented control",
                                             "CAN driver: controller too hot",
                                             "CAN driver: motor too hot",
                                             "CAN driver: lasting over-current",
                                             "CAN driver: several faults",
                                             "CAN bus off, outside",
                                             "CAN bus off, inside",
                                             "encoder missing",
                                             "CAN driver does not answer",
                                             "CAN driver: parameters",
                                             "over-current",
                                             "unsafe voltage",
                                             "battery setting",
                                             "stored parameters",
                                             "encoder type",
                                             "type of the external IMU",
                                             "external IMU lost",
                                             "parameters of the external IMU",
                                             "start of the motor driver",
                                             "stored variables",
                                             "watchdog",
                                             "analogue inputs",
                                             "calibration with motors off",
                                             "time-out",
                                             "calibration of the driver",
                                             "magnetometer lost",
                                             "over-speed",
                                             "self-calibration of the encoder",
                                             "version on the CAN bus",
                                             "serial number on the CAN bus",
                                             "serial numbers on the CAN bus differ",
                                             "stage of the driver's start",
                                             "data of the encoder too late",
                                             "link on the CAN bus lost",
                                             "clock crystal",
                                             "frame IMU lost",
                                             "parameters were changed",
                                             "not in its normal position",
                                             "driver licence"};
    std::vector<BoardFault> faults;
    for (std::size_t bit = 0; bit < std::size(rows); ++bit) {
        if (!(bits & (1U << bit)))
            continue;
        const Row &row = rows[bit];
        BoardFault fault{QLatin1String(row.key), QLatin1String(row.name), QLatin1String(row.meaning),
                         QLatin1String(row.cure), row.severe};
        if (bit == 11 && detail > 0) {
            fault.name += detail < std::size(causes) ? u": "_s + QLatin1String(causes[detail])
                                                     : u" (cause %1)"_s.arg(detail);
        }
        faults.push_back(fault);
    }
    return faults;
}

}  // namespace simplebgc
