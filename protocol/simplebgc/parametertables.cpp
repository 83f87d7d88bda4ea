// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/parametertables.h"

#include "protocol/simplebgc/choices.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace simplebgc {

namespace {

// As signal sources count the pulse inputs (errata 4.3).
constexpr int kPinRcRoll = 1;
constexpr int kPinRcPitch = 2;
constexpr int kPinFcRoll = 3;
constexpr int kPinFcPitch = 4;

}  // namespace

std::span<const ParameterRow> parameterRows()
{
    static const std::vector<ParameterRow> rows = [] {
        std::vector<ParameterRow> all;
        for (const auto part :
             {params3Rows(), paramsExtRows(), paramsExt2Rows(), paramsExt3Rows(), slotRows()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return rows;
}

namespace {

bool isSameDirection(double a, double b)
{
    return std::abs(a) == std::abs(b);
}

bool isSameOutput(double a, double b)
{
    return a == b && a != 0;
}

// A pin that puts out a servo's signal cannot take in another (document, SERVOx_OUT and SERVO_OUT).
template <int Pin> bool isServoPin(double source, double servo)
{
    return source == Pin && servo != 0;
}

// RC_VIRT_MODE: CPPM, S-bus or Spektrum.
bool isSerialPin(double source, double mode)
{
    return source == kPinRcRoll && mode >= 1 && mode <= 3;
}

// ENCODER_CFG is the clock of an encoder on SPI: one of four (errata 3.4).
bool isNoClock(double config, double type)
{
    constexpr int kSpiTypes[] = {1, 4, 14};  // AS5048A, AMT203, RLS Orbis
    return config > 3
        && std::find(std::begin(kSpiTypes), std::end(kSpiTypes), int(type)) != std::end(kSpiTypes);
}

bool isForTwoAxes(double order, double)
{
    return order == 2 || order == 3;
}

}  // namespace

std::span<const ValueRule> valueRules()
{
    static constexpr const char *kSensor = "one axis of a sensor cannot point both up and to the right";
    static constexpr const char *kPort = "two motors cannot be at the same output";
    static constexpr const char *kServo = "this pin puts out a servo's signal, so it cannot be an input";
    static constexpr const char *kClock = "an encoder on SPI has one of four speeds, and none inside";
    static constexpr const char *kSerial = "this pin carries a receiver's serial signal, and no pulses";
    static constexpr ValueRule kFixed[] = {
        {"imu.main.axis_top", "imu.main.axis_right", isSameDirection, kSensor},
        {"imu.frame.axis_top", "imu.frame.axis_right", isSameDirection, kSensor},
        {"imu.mag.axis_top", "imu.mag.axis_right", isSameDirection, kSensor},
        {"motor.roll.output", "motor.pitch.output", isSameOutput, kPort},
        {"motor.roll.output", "motor.yaw.output", isSameOutput, kPort},
        {"motor.pitch.output", "motor.yaw.output", isSameOutput, kPort},
        {"encoder.roll.config", "encoder.roll.type", isNoClock, kClock, "encoders"},
        {"encoder.pitch.config", "encoder.pitch.type", isNoClock, kClock, "encoders"},
        {"encoder.yaw.config", "encoder.yaw.type", isNoClock, kClock, "encoders"},
        // The document of 2.5x; later ones know these orders for three axes.
        {"imu.euler_order", "", isForTwoAxes, "this order is for boards with two axes", "yaw-axis", 2599},
    };
    // clang-format off
    static constexpr ValueRule kPins[] = {
        {"", "service.servo1.source", isServoPin<kPinFcRoll>, kServo},
        {"", "service.servo2.source", isServoPin<kPinFcPitch>, kServo},
        {"", "service.servo3.source", isServoPin<kPinRcPitch>, kServo},
        {"", "rc.input_mode", isSerialPin, kSerial},
    };
    // clang-format on
    static const std::vector<ValueRule> rules = [] {
        std::vector<ValueRule> all(std::begin(kFixed), std::end(kFixed));
        for (const char *input : kSignalKeys) {
            for (ValueRule rule : kPins) {
                rule.first = input;
                all.push_back(rule);
            }
        }
        return all;
    }();
    return rules;
}

std::span<const Choice> menuActions()
{
    return kMenuActions;
}

std::span<const Choice> signalSources()
{
    return kSignalSources;
}

}  // namespace simplebgc
