// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/faults.h"

#include "protocol/simplebgc/choices.h"

using namespace Qt::StringLiterals;

namespace simplebgc {

std::vector<BoardFault> faultsOf(unsigned bits, unsigned detail)
{
    struct Row
    {
        const char *key, *meaning, *cure;
        bool severe;
    };
    // clang-format off
    static constexpr Row rows[] = {
        {"no-sensor", "The board does not see its motion sensor, so it cannot stabilize.",
         "Check the sensor cable and its connectors, then restart the board.", true},
        {"calib-acc", "The horizon will be tilted.",
         "Run the accelerometer calibration.", false},
        {"set-power", "The motors have no power and the camera hangs free.",
         "Set the power of each motor on the Parameters page.", true},
        {"calib-poles", "The motors may turn the wrong way.",
         "Set poles and direction of each motor.", true},
        {"protection", "The motor drivers switch off to save themselves.",
         "Let the motors cool, then lower the power.", true},
        {"serial", "The board received damaged commands.", "Check the cable and its ground.", false},
        {"low-battery", "Its voltage is below the alarm that is set in the board.",
         "Charge or change the battery; if it is full, correct the alarm.", false},
        {"battery-empty", "The board says that it switches the motors off then.",
         "Charge or change the battery; if it is full, correct the voltage at which motors are switched off.", true},
        {"tool-version", "The board expects another version of its configuration tool.",
         "Check the values before writing any.", false},
        {"missed-steps", "A motor could not hold the camera.",
         "Balance the camera, or raise the power of that motor.", true},
        {"system", "The firmware found a fault in itself.", "Restart the board.", true},
        {"emergency-stop", "The board says that it switches the motors off then.",
         "Remove the cause, then restart the board.", true},
    };
    // clang-format on
    static_assert(std::size(rows) == std::size(kFaultNames));
    std::vector<BoardFault> faults;
    for (std::size_t bit = 0; bit < std::size(rows); ++bit) {
        if (!(bits & (1U << bit)))
            continue;
        const Row &row = rows[bit];
        BoardFault fault{QLatin1String(row.key), QLatin1String(kFaultNames[bit].name),
                         QLatin1String(row.meaning), QLatin1String(row.cure), row.severe};
        if (bit == 11 && detail > 0) {
            fault.name += detail < std::size(kStopCauses) ? u": "_s + QLatin1String(kStopCauses[detail].name)
                                                          : u" (cause %1)"_s.arg(detail);
        }
        faults.push_back(fault);
    }
    return faults;
}

}  // namespace simplebgc
