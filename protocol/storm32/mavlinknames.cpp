// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/mavlinknames.h"

#include <algorithm>
#include <array>

namespace storm32 {

namespace {

// clang-format off
constexpr const char *kNames95[] = {
    "PID_PITCH_P", "PID_PITCH_I", "PID_PITCH_D", "PID_PITCH_VMAX", "PAN_PITCH_PAN", "PAN_PITCH_DBND", "PID_ROLL_P",
    "PID_ROLL_I", "PID_ROLL_D", "PID_ROLL_VMAX", "PAN_ROLL_PAN", "PAN_ROLL_DBND", "PID_YAW_P", "PID_YAW_I", "PID_YAW_D",
    "PID_YAW_VMAX", "PAN_YAW_PAN", "PAN_YAW_DBND", "PID_LOW_VOLT_LMT", "PID_VOLT_CORR", "CNF_PITCH_MOTPOL",
    "CNF_PITCH_MOTDIR", "CNF_PITCH_OFFSET", "CNF_PITCH_MOTPOS", "NU_1", "NU_2", "CNF_ROLL_MOTPOL", "CNF_ROLL_MOTDIR",
    "CNF_ROLL_OFFSET", "CNF_ROLL_MOTPOS", "NU_3", "NU_4", "CNF_YAW_MOTPOL", "CNF_YAW_MOTDIR", "CNF_YAW_OFFSET",
    "CNF_YAW_MOTPOS", "NU_5", "NU_6", "EXP_IMU3_CONFIG", "CNF_IMU_ORIENT", "EXP_MOTOR_MAP", "STP_VIRT_CONFIG",
    "STP_PWM_CONFIG", "RC_DEADBAND", "RC_PITCH_CNTRL", "RC_PITCH_MODE", "RC_PITCH_TRM", "RC_PITCH_MIN", "RC_PITCH_MAX",
    "RC_PITCH_SPDLIM", "RC_PITCH_ACCLIM", "RC_ROLL_CNTRL", "RC_ROLL_MODE", "RC_ROLL_TRIM", "RC_ROLL_MIN", "RC_ROLL_MAX",
    "RC_ROLL_SPDLIM", "RC_ROLL_ACCLIM", "RC_YAW_CNTRL", "RC_YAW_MODE", "RC_YAW_TRIM", "RC_YAW_MIN", "RC_YAW_MAX",
    "RC_YAW_SPDLIM", "RC_YAW_ACCLIM", "PAN_MODE_CNTRL", "PAN_MODE_DEFLT", "PAN_MODE_1", "PAN_MODE_2", "PAN_MODE_3",
    "FNC_STANDBY", "FNC_IR_CAMCNTRL", "FNC_IR_CAMMODEL", "FNC_IR_SETTING1", "FNC_IR_SETTING2", "FNC_IR_TIMEINTVL",
    "FNC_RECENTER_CAM", "EXP_NTLOGGING", "STP_PITCH_MOTUSG", "STP_ROLL_MOTUSG", "STP_YAW_MOTUSG", "STP_AHRS", "NU_10",
    "EXP_IMU3_ORIENT", "EXP_IMU_ACCTHRH", "EXP_ACC_LPF", "EXP_IMU_DLPF", "EXP_PANHOLD_TIME", "STP_ACC_COMPMTHD",
    "EXP_ACC_NOISELVL", "EXP_ACC_THRESHLD", "EXP_ACC_VERT", "EXP_ACC_ZENTRIFL", "EXP_ACC_REVCOVER", "STP_IMU2_CONFIG",
    "STP_IMU2_ORIENT", "EXP_RC_ADCLPF", "PAN_DBND_HYST", "STP_BEEPS", "PID_IMU2_FFLPF", "PID_GYRO_LPF", "EXP_ADC_CALIB",
    "PAN_PITCH_LIMIT", "PAN_ROLL_LIMIT", "PAN_YAW_LIMIT", "RC_HYSTERESIS", "STP_RC_PITCH_OFS", "STP_RC_ROLL_OFS",
    "STP_RC_YAW_OFS", "EXP_IMU_MAP", "MAV_SYSTEM_ID", "MAV_COMPONENT_ID", "MAV_CONFIG", "FNC_PWM_CNTRL", "FNC_PWM_MID",
    "FNC_PWM_MIN", "FNC_PWM_MAX", "FNC_PWM_SPDLIM", "PAN_YAW_LPF", "NU_14", "SCR_SCRPT1_CNTRL", "SCR_SCRPT2_CNTRL",
    "SCR_SCRPT3_CNTRL", "SCR_SCRPT4_CNTRL", "NU_99",
};
// clang-format on
static_assert(std::size(kNames95) == 125);

struct Other
{
    int word;
    const char *name;
};

// Where layout 78 differs; it has one word less.
// clang-format off
constexpr Other kNames78[] = {
    {38, "NU_7"}, {63, "RC_YAW_MAX"}, {72, "FNC_IR_CAMCNTRL"}, {76, "FNC_IR_TIMEINTVL"}, {77, "NU_9"}, {78, "NU_9"},
    {83, "NU_11"}, {85, "EXP_IMU_ACCTHRH"}, {87, "EXP_HOLDPAN_TIME"}, {95, "STP_IMU2_CONFIG"}, {99, "EXP_IMU2_FFLPF"},
    {100, "STP_GYRO_LPF"}, {118, "NU_14"}, {119, "SCR_SCRPT1_CNTRL"}, {120, "SCR_SCRPT2_CNTRL"}, {121, "SCR_SCRPT3_CNTRL"},
    {122, "SCR_SCRPT4_CNTRL"}, {123, "NU_12"},
};
// clang-format on

}  // namespace

QString mavlinkName(int layout, int word)
{
    if (word < 0 || word >= (layout == 78 ? 124 : 125))
        return {};
    if (layout == 78) {
        const auto it = std::find_if(std::begin(kNames78), std::end(kNames78),
                                     [word](const Other &other) { return other.word == word; });
        if (it != std::end(kNames78))
            return QString::fromLatin1(it->name);
    }
    return QString::fromLatin1(kNames95[word]);
}

}  // namespace storm32
