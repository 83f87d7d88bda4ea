// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/actiontable.h"

#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>

namespace simplebgc {

namespace {

constexpr Choice kImuChoices[] = {{0, "selected"}, {1, "main"}, {2, "frame"}};
constexpr Choice kForms[] = {{0, "extended"}, {1, "simple"}};
// clang-format off
constexpr Choice kCalibrationActions[] = {
    {1, "normal"}, {2, "reset-all"}, {3, "temperature"}, {4, "temperature-on"}, {5, "temperature-off"},
    {6, "restore-factory"}, {7, "copy-to-sensor"}};
constexpr Choice kSteerModes[] = {{Speed, "speed"}, {Angle, "angle"}, {SpeedAngle, "speed-angle"}, {Rc, "rc"},
                                  {AngleRelFrame, "angle-frame"}};
// What they mean, and how far they go, the mode says.
constexpr double kMostSteered = 4000;
constexpr Choice kSounds[] = {{1, "calibrate"}, {2, "confirm"}, {4, "error"}, {16, "click"}, {32, "complete"},
                              {64, "intro"}, {32768, "melody"}};
constexpr Choice kDefaultsScope[] = {{0, "profile1"}, {1, "profile2"}, {2, "profile3"}, {3, "profile4"},
                                     {4, "profile5"}, {253, "erase-eeprom"}};

constexpr ArgumentSpec kMenuArguments[] = {
    {.key = "command", .label = "Command", .kind = ArgumentKind::Choice, .choices = kMenuActions}};

// The argument of "menu" with the commands of this firmware only. It stays: an action may outlive its device.
std::span<const ArgumentSpec> menuArguments(int firmware)
{
    struct Menu
    {
        std::vector<Choice> choices;
        ArgumentSpec argument = kMenuArguments[0];
    };
    static std::mutex mutex;
    static std::map<std::size_t, Menu> menus;  // by size: commands are only ever added
    std::vector<Choice> known;
    std::copy_if(std::begin(kMenuActions), std::end(kMenuActions), std::back_inserter(known),
                 [firmware](const Choice &choice) { return choice.since <= firmware; });
    const std::lock_guard lock(mutex);
    Menu &menu = menus[known.size()];
    if (menu.choices.empty()) {
        menu.choices = std::move(known);
        menu.argument.choices = menu.choices;
    }
    return {&menu.argument, 1};
}
constexpr int kProfileEntries[] = {1, 2, 3, 14, 15};
constexpr int kMotorEntries[] = {kMenuMotorsSwitch, kMenuMotorsOn, kMenuMotorsOff};
constexpr int kSwitchEntries[] = {22, 60, 66};  // the button, safe stop, safe toggle
constexpr int kMenuReset = 7;
constexpr auto kMenuEntries = [] {
    std::array<EntryEffect,
               std::size(kMenuEffects) + std::size(kProfileEntries) + std::size(kMotorEntries)
                   + std::size(kSwitchEntries) + 1>
        entries{};
    std::size_t count = 0;
    for (const MenuEffect &effect : kMenuEffects)
        entries[count++] = {effect.action, effect.destroys ? ActionRisk::Destroys : ActionRisk::Writes,
                            MemoryEffect::None, false};
    for (const int profile : kProfileEntries)
        entries[count++] = {profile, ActionRisk::Moves, MemoryEffect::Reloads, true};
    for (const int motors : kMotorEntries)
        entries[count++] = {motors, ActionRisk::Moves, MemoryEffect::ChangesInUse, true, false, "", true};
    for (const int motors : kSwitchEntries)
        entries[count++] = {motors, ActionRisk::Moves, MemoryEffect::ChangesInUse, false, false, "", true};
    entries[count] = {kMenuReset, ActionRisk::Moves, MemoryEffect::ChangesInUse, false, true};
    return entries;
}();
constexpr ArgumentSpec kProfileArguments[] = {
    {.key = "profile", .label = "Profile", .kind = ArgumentKind::Integer, .min = 1, .max = 5}};
constexpr ArgumentSpec kSteerArguments[] = {
    {.key = "mode", .label = "Mode", .kind = ArgumentKind::Choice, .choices = kSteerModes, .defaultText = "angle"},
    {.key = "roll", .label = "Roll (°, °/s or RC, by mode)", .kind = ArgumentKind::Real, .min = -kMostSteered, .max = kMostSteered,
     .defaultText = "nan"},
    {.key = "pitch", .label = "Pitch (°, °/s or RC, by mode)", .kind = ArgumentKind::Real, .min = -kMostSteered, .max = kMostSteered,
     .defaultText = "nan"},
    {.key = "yaw", .label = "Yaw (°, °/s or RC, by mode)", .kind = ArgumentKind::Real, .min = -kMostSteered, .max = kMostSteered,
     .defaultText = "nan"},
    {.key = "speed", .label = "Speed", .kind = ArgumentKind::Real, .min = 0, .max = 1000, .unit = "°/s",
     .defaultText = "30"},
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 0.1, .max = 600, .unit = "s",
     .defaultText = "3"},
    {.key = "release", .label = "Release control at the end", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "fine", .label = "In finer steps", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ArgumentSpec kAttitudeTarget[] = {
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Real, .min = -180, .max = 180, .unit = "°", .defaultText = "0"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Real, .min = -90, .max = 90, .unit = "°", .defaultText = "0"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Real, .min = -180, .max = 180, .unit = "°", .defaultText = "0"},
    {.key = "speed", .label = "Speed", .kind = ArgumentKind::Real, .min = 1, .max = 360, .unit = "°/s", .defaultText = "30"},
    {.key = "acceleration", .label = "Acceleration (0 = no limit)", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "°/s²",
     .defaultText = "100"},
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 0.1, .max = 600, .unit = "s", .defaultText = "3"},
    {.key = "release", .label = "Release control at the end", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kSteeringLimits[] = {
    {.key = "timeout", .label = "Without a command, steering ends after (0 = never)", .kind = ArgumentKind::Real, .min = 0, .max = 60, .unit = "s",
     .defaultText = "0"},
    {.key = "roll", .label = "Roll: acceleration (0 = no limit)", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "°/s²", .defaultText = "0"},
    {.key = "pitch", .label = "Pitch: acceleration (0 = no limit)", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "°/s²", .defaultText = "0"},
    {.key = "yaw", .label = "Yaw: acceleration (0 = no limit)", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "°/s²", .defaultText = "0"}};
constexpr Choice kAxisChoices[] = {{0, "roll"}, {1, "pitch"}, {2, "yaw"}};
constexpr ArgumentSpec kResponseArguments[] = {
    {.key = "axis", .label = "Axis", .kind = ArgumentKind::Choice, .choices = kAxisChoices},
    {.key = "system", .label = "What is measured", .kind = ArgumentKind::Choice, .choices = kTestedSystems, .defaultText = "whole-loop"},
    {.key = "stimulus", .label = "Stimulus", .kind = ArgumentKind::Choice, .choices = kStimuli, .defaultText = "noise"},
    {.key = "gain", .label = "Strength of the stimulus", .kind = ArgumentKind::Integer, .min = 1, .max = 65535, .defaultText = "300"},
    {.key = "from", .label = "Lowest frequency", .kind = ArgumentKind::Integer, .min = 1, .max = 600, .unit = "Hz", .defaultText = "2"},
    {.key = "to", .label = "Highest frequency", .kind = ArgumentKind::Integer, .min = 2, .max = 600, .unit = "Hz", .defaultText = "150"},
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 4, .max = 60, .unit = "s", .defaultText = "20"},
    {.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kReferenceArguments[] = {
    {.key = "x", .label = "X", .kind = ArgumentKind::Real, .min = -1.5, .max = 1.5, .unit = "g", .defaultText = "0"},
    {.key = "y", .label = "Y", .kind = ArgumentKind::Real, .min = -1.5, .max = 1.5, .unit = "g", .defaultText = "0"},
    {.key = "z", .label = "Z", .kind = ArgumentKind::Real, .min = -1.5, .max = 1.5, .unit = "g", .defaultText = "1"}};
constexpr ArgumentSpec kBeepArguments[] = {
    {.key = "sound", .label = "Sound", .kind = ArgumentKind::Choice, .choices = kSounds, .defaultText = "confirm"},
    {.key = "notes", .label = "Notes of a melody (Hz, comma between)", .kind = ArgumentKind::Text,
     .defaultText = "988,1175,1568"},
    {.key = "length", .label = "Length of a note", .kind = ArgumentKind::Integer, .min = 8, .max = 2040, .unit = "ms",
     .defaultText = "120"},
    {.key = "decay", .label = "Decay", .kind = ArgumentKind::Integer, .min = 0, .max = 15, .defaultText = "3"}};
constexpr ArgumentSpec kReadVariables[] = {
    {.key = "ids", .label = "Numbers (comma between)", .kind = ArgumentKind::Text,
     .defaultText = "0,1,2,3,4,5,6,7,8,9,10,11"},
    {.key = "real", .label = "As real numbers", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ArgumentSpec kWriteVariable[] = {
    {.key = "id", .label = "Number", .kind = ArgumentKind::Integer, .min = 0, .max = 255},
    {.key = "value", .label = "Value", .kind = ArgumentKind::Integer, .min = -2147483648.0, .max = 2147483647.0}};
constexpr ArgumentSpec kSensor{
    .key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImuChoices, .defaultText = "selected"};
constexpr ArgumentSpec kKind{
    .key = "action", .label = "Kind", .kind = ArgumentKind::Choice, .choices = kCalibrationActions,
    .defaultText = "normal"};
constexpr ArgumentSpec kForm{
    .key = "form", .label = "Form of the command", .kind = ArgumentKind::Choice, .choices = kForms,
    .defaultText = "extended"};
constexpr ArgumentSpec kGyroArguments[] = {kSensor, kKind, kForm};
constexpr ArgumentSpec kAccArguments[] = {
    kSensor, kKind, kForm,
    {.key = "six", .label = "One of six positions, motors off", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
// Some kinds restart the board (errata 3.19), and for six positions the motors are switched off.
constexpr EntryEffect kCalibrationEntries[] = {
    {.value = 2, .risk = ActionRisk::Writes, .letsGo = true, .argument = "action"},
    {.value = 4, .risk = ActionRisk::Writes, .letsGo = true, .argument = "action"},
    {.value = 5, .risk = ActionRisk::Writes, .letsGo = true, .argument = "action"},
    {.value = 1, .risk = ActionRisk::Writes, .letsGo = true, .argument = "six"}};
constexpr Choice kImuUsed[] = {{1, "main"}, {2, "frame"}};
constexpr Choice kSetSlots[] = {{1, "1"}, {2, "2"}, {3, "3"}, {4, "4"}, {5, "5"}, {6, "backup"}};
constexpr ArgumentSpec kSelectArguments[] = {
    {.key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImuUsed}};
constexpr ArgumentSpec kPinArguments[] = {
    {.key = "pin", .label = "Pin", .kind = ArgumentKind::Choice, .choices = kPinNames},
    {.key = "state", .label = "State", .kind = ArgumentKind::Choice, .choices = kPinStates}};
constexpr ArgumentSpec kServoArguments[] = {
    {.key = "servo1", .label = "Servo 1 (FC_ROLL)", .kind = ArgumentKind::Integer, .min = -1, .max = 20000, .unit = "µs", .defaultText = "-1"},
    {.key = "servo2", .label = "Servo 2 (FC_PITCH)", .kind = ArgumentKind::Integer, .min = -1, .max = 20000, .unit = "µs", .defaultText = "-1"},
    {.key = "servo3", .label = "Servo 3 (RC_PITCH)", .kind = ArgumentKind::Integer, .min = -1, .max = 20000, .unit = "µs", .defaultText = "-1"},
    {.key = "servo4", .label = "Servo 4 (AUX1)", .kind = ArgumentKind::Integer, .min = -1, .max = 20000, .unit = "µs", .defaultText = "-1"}};
constexpr ArgumentSpec kChannelArguments[] = {
    {.key = "channel", .label = "Channel", .kind = ArgumentKind::Integer, .min = 1, .max = 31},
    {.key = "value", .label = "Signal", .kind = ArgumentKind::Real, .min = -100, .max = 100, .unit = "%"},
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 0.1, .max = 600, .unit = "s", .defaultText = "1"},
    {.key = "fine", .label = "In finer steps", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ArgumentSpec kEventArguments[] = {
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 1, .max = 3600, .unit = "s", .defaultText = "30"}};
constexpr Choice kServoOutputs[] = {
    {0, "FC_ROLL"}, {1, "FC_PITCH"}, {2, "RC_PITCH"}, {3, "AUX1"}, {4, "CAN1-1"}, {5, "CAN1-2"}, {6, "CAN2-1"}, {7, "CAN2-2"}, {8, "CAN3-1"},
    {9, "CAN3-2"}, {10, "CAN4-1"}, {11, "CAN4-2"}, {12, "CAN5-1"}, {13, "CAN5-2"}, {14, "CAN6-1"}, {15, "CAN6-2"}, {16, "CAN7-1"}, {17, "CAN7-2"}};
constexpr ArgumentSpec kSingleServo[] = {
    {.key = "servo", .label = "Output", .kind = ArgumentKind::Choice, .choices = kServoOutputs},
    {.key = "pulse", .label = "Pulse", .kind = ArgumentKind::Integer, .min = -1, .max = 20000, .unit = "µs"}};
constexpr Choice kRippleActions[] = {{1, "learn"}, {2, "forget"}};
constexpr ArgumentSpec kRippleArguments[] = {
    {.key = "action", .label = "What to do", .kind = ArgumentKind::Choice, .choices = kRippleActions, .defaultText = "learn"},
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "angle", .label = "Turn by", .kind = ArgumentKind::Integer, .min = 20, .max = 360, .unit = "°", .defaultText = "40"},
    {.key = "smooth", .label = "Smoothing", .kind = ArgumentKind::Integer, .min = 0, .max = 100, .unit = "%", .defaultText = "50"},
    {.key = "iterations", .label = "Passes", .kind = ArgumentKind::Integer, .min = 2, .max = 20, .defaultText = "3"}};
constexpr EntryEffect kRippleEntries[] = {{.value = 2, .risk = ActionRisk::Writes, .isShown = false, .argument = "action"}};
constexpr ArgumentSpec kTuneArguments[] = {
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "gain", .label = "Gain against stability", .kind = ArgumentKind::Integer, .min = 0, .max = 255, .defaultText = "128"},
    {.key = "stimulus", .label = "Strength of the stimulus", .kind = ArgumentKind::Integer, .min = 1, .max = 65535, .defaultText = "300"},
    {.key = "notches", .label = "Notch filters to find", .kind = ArgumentKind::Integer, .min = 0, .max = 3, .defaultText = "0"},
    {.key = "lpf", .label = "Tune the low-pass filter", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "keep", .label = "Start from current gains", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "save", .label = "Store the result", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
// The last argument of these came with later firmware than the action.
constexpr std::pair<std::span<const ArgumentSpec>, int> kLaterArguments[] = {
    {kSteerArguments, 2680}, {kChannelArguments, 2687}, {kReadVariables, 2734}};
constexpr ArgumentSpec kSetArguments[] = {
    {.key = "action", .label = "What to do", .kind = ArgumentKind::Choice, .choices = kSetActions},
    {.key = "slot", .label = "Slot", .kind = ArgumentKind::Choice, .choices = kSetSlots}};
// Of a slot that was in use before, and of what is loaded, the board tells nothing.
constexpr EntryEffect kSetEntries[] = {
    {.value = 1, .risk = ActionRisk::Destroys, .isShown = false, .argument = "action"},
    {.value = 3, .risk = ActionRisk::Destroys, .memory = MemoryEffect::Reloads, .isShown = false, .letsGo = true, .argument = "action"}};
constexpr ArgumentSpec kDataArguments[] = {{.key = "data", .label = "Bytes (hex)", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kPathArguments[] = {{.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kSaveArguments[] = {
    {.key = "file", .label = "File", .kind = ArgumentKind::Text},
    {.key = "files", .label = "With the board's files", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr Choice kMemoryParts[] = {{kWholeMemory, "all"}, {1, "settings"}};
constexpr ArgumentSpec kRestoreArguments[] = {
    {.key = "file", .label = "File", .kind = ArgumentKind::Text},
    {.key = "part", .label = "What of it", .kind = ArgumentKind::Choice, .choices = kMemoryParts, .defaultText = "all"},
    {.key = "other", .label = "Also from another board", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ArgumentSpec kCalibrationFile[] = {kRestoreArguments[0], kRestoreArguments[2]};
constexpr ArgumentSpec kFileArguments[] = {
    {.key = "type", .label = "Kind", .kind = ArgumentKind::Choice, .choices = kFileTypes},
    {.key = "number", .label = "Number", .kind = ArgumentKind::Integer, .min = 0, .max = 255},
    {.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kScriptArguments[] = {
    {.key = "mode", .label = "What to do", .kind = ArgumentKind::Choice, .choices = kScriptModes, .defaultText = "start"},
    {.key = "slot", .label = "Slot", .kind = ArgumentKind::Integer, .min = 1, .max = 10, .defaultText = "1"}};
constexpr ArgumentSpec kSlotArguments[] = {
    {.key = "slot", .label = "Slot", .kind = ArgumentKind::Integer, .min = 1, .max = 10},
    {.key = "keep", .label = "New file for what is in the slot", .kind = ArgumentKind::Text},
    {.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kSlotFile[] = {kSlotArguments[0], kSlotArguments[2]};
constexpr Choice kBuses[] = {{0, "sensors"}, {1, "internal"}};
constexpr ArgumentSpec kBusArguments[] = {
    {.key = "bus", .label = "Bus", .kind = ArgumentKind::Choice, .choices = kBuses, .defaultText = "sensors"},
    {.key = "device", .label = "Address (7 bits)", .kind = ArgumentKind::Integer, .min = 8, .max = 119},
    {.key = "register", .label = "Register", .kind = ArgumentKind::Integer, .min = 0, .max = 255},
    {.key = "length", .label = "Bytes", .kind = ArgumentKind::Integer, .min = 1, .max = kMostI2c, .defaultText = "1"}};
constexpr ArgumentSpec kBusWriteArguments[] = {
    kBusArguments[0], kBusArguments[1], kBusArguments[2], {.key = "data", .label = "Bytes (hex)", .kind = ArgumentKind::Text}};
constexpr Choice kFed[] = {{72, "helper"}, {75, "gyro"}, {56, "attitude"}};
constexpr ArgumentSpec kFeedArguments[] = {
    {.key = "what", .label = "What the file holds", .kind = ArgumentKind::Choice, .choices = kFed},
    {.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kAttitudeArguments[] = {
    {.key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImuUsed, .defaultText = "main"}};
constexpr ArgumentSpec kBatteryArguments[] = {
    {.key = "voltage", .label = "Measured voltage", .kind = ArgumentKind::Real, .min = 3, .max = 60, .unit = "V"}};
constexpr ArgumentSpec kAutoTuneArguments[] = {
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "profile", .label = "Profile (0 = active)", .kind = ArgumentKind::Integer, .min = 0, .max = 5,
     .defaultText = "0"},
    {.key = "gain", .label = "Gain against stability", .kind = ArgumentKind::Integer, .min = 0, .max = 255,
     .defaultText = "128"},
    {.key = "keep", .label = "Start from current gains", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "lpf", .label = "Tune the low-pass filter", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "save", .label = "Store the result", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kResetArguments[] = {
    {.key = "delay", .label = "Delay", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "ms",
     .defaultText = "1000"}};
constexpr ArgumentSpec kDefaultsArguments[] = {
    {.key = "what", .label = "What", .kind = ArgumentKind::Choice, .choices = kDefaultsScope}};

constexpr ArgumentSpec kEncoderArguments[] = {
    {.key = "motor", .label = "Motor", .kind = ArgumentKind::Choice, .choices = kMotorNames, .defaultText = "all"}};
constexpr ArgumentSpec kFieldArguments[] = {
    {.key = "angle", .label = "Turn by", .kind = ArgumentKind::Real, .min = 5, .max = 170, .unit = "°", .defaultText = "40"},
    {.key = "speed", .label = "Speed", .kind = ArgumentKind::Real, .min = 1, .max = 60, .unit = "°/s", .defaultText = "6"}};

constexpr ReplyUnit kAngleUnits[] = {{"speed", "°/s"}, {"imu", "°"}, {"target", "°"}, {"motor", "°"}};
constexpr ReplyUnit kStillnessUnits[] = {{"gyro", "°/s"}, {"acc", "g"}};
constexpr ReplyUnit kEncoderUnits[] = {{"offset", "°"}, {"field_offset", "°"}, {"motor", "°"}};
constexpr ReplyUnit kMagUnits[] = {{"heading.error", "°"}, {"roughness", "%"}};
constexpr ReplyUnit kBatteryUnits[] = {{"voltage", "V"}};
constexpr ReplyUnit kSignalUnits[] = {{"map", "%"}};
constexpr ReplyUnit kInputUnits[] = {{"input", "%"}};
constexpr ArgumentSpec kInputArguments[] = {
    {.key = "initialize", .label = "Make inputs of pins that nothing uses", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ReplyUnit kSlotUnits[] = {{"signal", "%"}};
constexpr ReplyUnit kStatisticsUnits[] = {
    {"shock", "g"}, {"work", "s"}, {"max", "mA"}, {"temperature1", "°C"}, {"temperature2", "°C"}, {"temperature3", "°C"}, {"temperature4", "°C"},
    {"time", "s"}, {"energy", "Wh"}, {"average", "A"}};
constexpr ReplyUnit kByteUnits[] = {{"bytes", "bytes"}, {"written", "bytes"}, {"differing", "bytes"}};
constexpr ReplyUnit kResetUnits[] = {{"restarts_in", "ms"}};
constexpr ReplyUnit kReferenceUnits[] = {{"acc", "g"}};
constexpr ReplyUnit kKnownUnits[] = {{"progress", "%"}, {"acc", "g"}, {"temperature", "°C"}};
constexpr ReplyUnit kResponseUnits[] = {{"frequency", "Hz"}, {"gain", "dB"}};
constexpr ReplyUnit kLiveUnits[] = {{"gyro", "°/s"}, {"acc", "g"}, {"magnetometer", ""}, {"frame", "°"}, {"error", "°"}};
constexpr ReplyUnit kErrorUnits[] = {{"error", "°"}};
constexpr ReplyUnit kTuningUnits[] = {{"error", "°"}, {"lpf", "Hz"}};

constexpr ActionSpec kActions[] = {
    {.key = "angles", .label = "Read angles", .help = "Camera, target and motor angles.", .group = "Read",
     .units = kAngleUnits},
    {.key = "debug.list", .label = "List debug variables", .help = "Names and types of the board's inner variables.",
     .group = "Read"},
    {.key = "debug.read", .label = "Read debug variables", .help = "Values of the board's inner variables.",
     .group = "Read"},
    {.key = "state", .label = "Read state", .help = "What the board is calibrating, and which of its modes are on.", .group = "Read",
     .since = 2600},
    {.key = "variables.read", .label = "Read adjustable variables", .help = "Live values in the board's memory.",
     .group = "Read", .arguments = kReadVariables},
    {.key = "beep", .label = "Make a sound", .help = "Standard sound or melody; helps to find the right board.",
     .group = "Board", .arguments = kBeepArguments, .since = 2590, .answered = false},
    {.key = "motors.on", .label = "Start motors", .help = "Starts stabilization.", .group = "Motion",
     .risk = ActionRisk::Moves, .switchesMotors = true},
    {.key = "motors.off", .label = "Stop motors", .help = "Switches all motors off at once.", .group = "Motion", .stopsMotors = true},
    {.key = "menu", .label = "Menu command", .help = "Runs a command of the board's menu.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kMenuArguments, .memory = MemoryEffect::ChangesInUse,
     .entries = kMenuEntries, .isShown = false},
    {.key = "steer", .label = "Steer", .help = "Moves the camera for a time, then gives control back.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kSteerArguments, .isProcedure = true,
     .units = kAngleUnits},
    {.key = "steer.attitude", .label = "Steer to an attitude",
     .help = "Turns the camera to an attitude about one axis in space, the short way, then gives control back.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kAttitudeTarget, .isProcedure = true, .since = 2730, .units = kAngleUnits},
    {.key = "steer.state", .label = "Read control of the attitude", .help = "Where the attitude is steered to, how far it is, and at what speed.",
     .group = "Read", .since = 2730, .units = kAngleUnits},
    {.key = "steer.limits", .label = "Limit steering",
     .help = "How fast steering may speed up, and whether it ends where no command comes any more. Until the next start.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kSteeringLimits, .since = 2600, .isShown = false},
    {.key = "response", .label = "Measure frequency response",
     .help = "The board shakes an axis and tells what went in and what came out; the file opens on the page Response.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kResponseArguments, .isProcedure = true, .since = 2600, .capability = "bode",
     .confirm = "The camera is balanced and can turn freely", .units = kResponseUnits, .endedBy = "motors.off"},
    {.key = "profile.select", .label = "Use profile", .help = "Makes a profile the active one.", .group = "Profiles",
     .risk = ActionRisk::Moves, .arguments = kProfileArguments, .memory = MemoryEffect::Reloads},
    {.key = "variables.write", .label = "Set adjustable variable",
     .help = "Changes a value in volatile memory; lost at the next start unless stored.", .group = "Variables",
     .risk = ActionRisk::Moves, .arguments = kWriteVariable, .memory = MemoryEffect::ChangesInUse},
    {.key = "variables.save", .label = "Store variables", .help = "Stores the live values in the active profile.",
     .group = "Variables", .risk = ActionRisk::Writes, .memory = MemoryEffect::Stores},
    {.key = "calibrate.gyro", .label = "Calibrate gyroscope",
     .help = "Measures the zero of the gyroscope. The camera must stand absolutely still.", .group = "Calibration",
     .risk = ActionRisk::Writes, .arguments = kGyroArguments, .isProcedure = true,
     .units = kStillnessUnits, .entries = kCalibrationEntries},
    {.key = "calibrate.acc", .label = "Calibrate accelerometer",
     .help = "Measures the accelerometer in this position. The sensor must be still, and level unless it is one "
             "of six positions: for those the motors are switched off and left off, so hold the camera.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kAccArguments, .isProcedure = true,
     .units = kStillnessUnits, .entries = kCalibrationEntries},
    {.key = "calibrate.acc_reference", .label = "Accelerometer by reference",
     .help = "Tells the board what its accelerometer measures in this position, which another sensor knows.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kReferenceArguments, .isProcedure = true, .since = 2600,
     .units = kReferenceUnits},
    {.key = "calibration", .label = "Read calibration of a sensor",
     .help = "What a sensor measures, in which positions it was calibrated, and at which temperatures.", .group = "Read",
     .arguments = std::span(kAccArguments).first(1), .since = 2600, .units = kKnownUnits},
    {.key = "references", .label = "Read references of the sensors", .help = "What holds attitude and heading of each sensor, and how far off it is.",
     .group = "Read", .since = 2600, .units = kErrorUnits},
    {.key = "live", .label = "Read further live data", .help = "Angles and motion of the frame, and how far each axis is off its target.",
     .group = "Read", .since = 2740, .units = kLiveUnits},
    {.key = "events", .label = "Follow events", .help = "What the board tells of by itself: motors, emergency stops, scripts, buttons, the camera.",
     .group = "Read", .arguments = kEventArguments, .isProcedure = true, .since = 2657},
    {.key = "variables.list", .label = "List adjustable variables", .help = "The board's own names, with range and value in use.",
     .group = "Read", .since = 2700},
    {.key = "calibrate.battery", .label = "Calibrate voltage sensor",
     .help = "Tells the board the true battery voltage.", .group = "Calibration", .risk = ActionRisk::Writes,
     .arguments = kBatteryArguments, .capability = "battery", .units = kBatteryUnits},
    {.key = "calibrate.offset", .label = "Calibrate follow offset",
     .help = "Takes the present position as the neutral point of following.", .group = "Calibration",
     .risk = ActionRisk::Writes, .isProcedure = true, .isShown = false},
    {.key = "autotune", .label = "Auto-tune PID", .help = "The board searches gains by moving the camera.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kAutoTuneArguments, .isProcedure = true,
     .memory = MemoryEffect::ChangesInUse, .units = kTuningUnits, .endedBy = "autotune.stop"},
    {.key = "autotune.by_axis", .label = "Auto-tune by axis",
     .help = "The newer search of gains: its settings stay in the board. It moves the camera, and reports nothing on its way.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kTuneArguments, .isProcedure = true, .since = 2730,
     .memory = MemoryEffect::ChangesInUse, .confirm = "The camera is balanced and can turn freely", .endedBy = "autotune.stop"},
    {.key = "autotune.stop", .label = "Stop auto-tune",
     .help = "Ends a search of gains that may still be going on, and proves it.", .group = "Calibration"},
    {.key = "calibrate.poles", .label = "Find poles and direction",
     .help = "The board turns each motor to find its number of poles and its direction.", .group = "Calibration",
     .risk = ActionRisk::Writes, .isProcedure = true,
     .confirm = "The camera is balanced and can turn freely"},
    {.key = "calibrate.magnetic_link", .label = "Measure magnetic link",
     .help = "The board moves each motor to measure how stiffly its magnets hold.", .group = "Calibration",
     .risk = ActionRisk::Writes, .isProcedure = true, .since = 2560,
     .confirm = "The camera is balanced and can turn freely"},
    {.key = "calibrate.cogging", .label = "Learn cogging of motors",
     .help = "The board turns each motor slowly and learns the ripple of its magnets, which it then takes out; or it forgets it.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kRippleArguments, .isProcedure = true, .since = 2600,
     .confirm = "The camera is balanced and can turn freely", .entries = kRippleEntries, .endedBy = "motors.off"},
    {.key = "calibrate.encoder_field", .label = "Find fields of encoders",
     .help = "The board turns each motor there and back to find where its magnets stand against the encoder. A wrong value makes the "
             "motor weak, or it runs away.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kFieldArguments, .isProcedure = true, .since = 2600,
     .capability = "encoders", .confirm = "The camera is balanced and can turn freely", .units = kEncoderUnits, .endedBy = "motors.off"},
    {.key = "calibrate.encoder_offset", .label = "Take position as zero of encoders",
     .help = "What the encoders read now becomes the zero of the motors' angles. Nothing is turned.", .group = "Calibration",
     .risk = ActionRisk::Writes, .arguments = kEncoderArguments, .isProcedure = true, .since = 2600, .capability = "encoders",
     .confirm = "The camera is level and looks straight ahead, as in its normal position", .units = kEncoderUnits},
    {.key = "calibrate.fc_gain", .label = "Match flight controller",
     .help = "Tilt the frame by hand to all sides until it ends: the board compares its angle with the signal of the flight controller.",
     .group = "Calibration", .risk = ActionRisk::Writes, .isProcedure = true},
    {.key = "calibrate.magnetometer", .label = "Calibrate magnetometer",
     .help = "Turn the camera in all directions until it ends. Motors are off meanwhile, so hold it, and keep away from iron and cables.",
     .group = "Calibration", .risk = ActionRisk::Writes, .isProcedure = true, .since = 2600, .capability = "magnetometer",
     .confirm = "The camera is held in the hand", .units = kMagUnits, .letsGo = true},
    {.key = "imu.select", .label = "Select sensor", .help = "Which sensor calibrations and readings are about.", .group = "Board",
     .arguments = kSelectArguments},
    {.key = "pin", .label = "Set pin", .help = "Sets an output pin. A pin that is an input is not set.", .group = "Signals",
     .risk = ActionRisk::Moves, .arguments = kPinArguments, .isShown = false},
    {.key = "servo", .label = "Set servo outputs", .help = "Pulses at the servo pins; 0 holds a pin low, -1 frees it.",
     .group = "Signals", .risk = ActionRisk::Moves, .arguments = kServoArguments, .answered = false},
    {.key = "servo.single", .label = "Set one servo output", .help = "A pulse at one output, also of a CAN driver; 0 holds it low, -1 frees it.",
     .group = "Signals", .risk = ActionRisk::Moves, .arguments = kSingleServo, .since = 2732, .answered = false},
    {.key = "signals", .label = "Read signals", .help = "What comes in at the inputs that functions are mapped to.",
     .group = "Signals", .since = 2600, .units = kSignalUnits},
    {.key = "inputs", .label = "Read inputs", .help = "What comes in at all inputs, whether a function is mapped to them or not. Firmware before 2.60 tells of those alone that have one.",
     .group = "Signals", .arguments = kInputArguments, .units = kInputUnits},
    {.key = "channel", .label = "Give a signal", .help = "Gives a signal at a virtual channel for a time; then it counts as lost.",
     .group = "Signals", .risk = ActionRisk::Moves, .arguments = kChannelArguments, .isProcedure = true,
     .memory = MemoryEffect::ChangesInUse, .answered = false},
    {.key = "statistics", .label = "Read statistics", .help = "Hours of work, starts, shocks, currents and temperatures that the board counts.",
     .group = "Read", .since = 2600, .units = kStatisticsUnits},
    {.key = "statistics.reset", .label = "Reset statistics", .help = "What the board counts begins at zero again.",
     .group = "Board", .risk = ActionRisk::Writes, .since = 2600, .units = kStatisticsUnits},
    {.key = "profile_set", .label = "Profile sets", .help = "Stores all five profiles in a slot of the board, loads or clears it.",
     .group = "Profiles", .risk = ActionRisk::Destroys, .arguments = kSetArguments, .since = 2620, .entries = kSetEntries},
    {.key = "external.read", .label = "Read user data", .help = "128 bytes that the board keeps for others.", .group = "Memory"},
    {.key = "external.write", .label = "Write user data", .help = "Replaces the 128 bytes that the board keeps for others.",
     .group = "Memory", .risk = ActionRisk::Writes, .arguments = kDataArguments},
    {.key = "memory.save", .label = "Copy the whole board",
     .help = "Copies the board's memory and its files into a file, byte for byte, and reads all twice. Of each kind files 0 to 15 are asked for: no command lists them.",
     .group = "Memory", .arguments = kSaveArguments, .isProcedure = true, .units = kByteUnits},
    {.key = "memory.compare", .label = "Compare the whole board",
     .help = "Compares the board's memory and files with a copy. Parameters are named where their place can be found; no document tells it.",
     .group = "Memory", .arguments = kPathArguments, .isProcedure = true, .units = kByteUnits},
    {.key = "memory.restore", .label = "Restore the whole board",
     .help = "Writes a copy of memory and files back and compares. Settings alone leave calibrations, licence and all that no document describes as it is. "
             "It is in use after a restart.",
     .group = "Memory", .risk = ActionRisk::Destroys, .arguments = kRestoreArguments, .isProcedure = true, .memory = MemoryEffect::Erases,
     .confirm = "What the board keeps is replaced by what is in the copy", .units = kByteUnits},
    {.key = "calibration.save", .label = "Copy the calibrations", .help = "Copies the calibrations that the board keeps in files, and what it tells of the others.",
     .group = "Calibration", .arguments = kPathArguments, .isProcedure = true},
    {.key = "calibration.compare", .label = "Compare the calibrations", .help = "Compares the board's calibrations with a copy.",
     .group = "Calibration", .arguments = kPathArguments, .isProcedure = true},
    {.key = "calibration.restore", .label = "Restore the calibrations",
     .help = "Writes the calibrations that are in a copy back and compares. They are in use after a restart.",
     .group = "Calibration", .risk = ActionRisk::Destroys, .arguments = kCalibrationFile, .isProcedure = true,
     .confirm = "The sensors and motors are those from which the copy was made"},
    {.key = "file.save", .label = "Save a file of the board", .help = "Copies a file of the board's file system.", .group = "Memory",
     .arguments = kFileArguments, .isProcedure = true, .units = kByteUnits},
    {.key = "file.load", .label = "Load a file into the board", .help = "Writes a file into the board's file system and compares it.",
     .group = "Memory", .risk = ActionRisk::Destroys, .arguments = kFileArguments, .isProcedure = true, .units = kByteUnits},
    {.key = "file.erase", .label = "Erase a file of the board", .help = "Takes a file out of the board's file system.",
     .group = "Memory", .risk = ActionRisk::Destroys, .arguments = std::span(kFileArguments).first(2)},
    {.key = "file.erase_all", .label = "Erase all files of the board",
     .help = "Copies the whole board into a new file first. Then scripts, calibrations and everything else in the board's file system are gone.",
     .group = "Memory", .risk = ActionRisk::Destroys, .arguments = kPathArguments, .isProcedure = true,
     .confirm = "Scripts and calibrations are to be erased"},
    {.key = "script", .label = "Run script", .help = "Starts or stops a script that is in the board.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kScriptArguments, .isShown = false},
    {.key = "script.stop", .label = "Stop script", .help = "Stops the script that runs. The motors go on.", .group = "Motion",
     .arguments = std::span(kScriptArguments).subspan(1), .isShown = false},
    {.key = "script.list", .label = "List scripts", .help = "The slots for scripts and how many bytes each holds.", .group = "Read",
     .units = kByteUnits},
    {.key = "script.save", .label = "Save a script", .help = "Copies the compiled script in a slot into a file.", .group = "Memory",
     .arguments = kSlotFile, .isProcedure = true, .units = kByteUnits},
    {.key = "script.load", .label = "Load a script",
     .help = "Writes a compiled script into a slot and compares. What is in the slot is copied into a file first.", .group = "Memory",
     .risk = ActionRisk::Destroys, .arguments = kSlotArguments, .isProcedure = true, .units = kByteUnits},
    {.key = "script.erase", .label = "Erase a script", .help = "Empties a slot. What is in it is copied into a file first.", .group = "Memory",
     .risk = ActionRisk::Destroys, .arguments = std::span(kSlotArguments).first(2), .isProcedure = true, .units = kByteUnits},
    {.key = "script.follow", .label = "Run script and follow it",
     .help = "Starts a script and tells each command that the board carries out. Cancel stops the script.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = std::span(kScriptArguments).subspan(1), .isProcedure = true},
    {.key = "slots.read", .label = "Read slots", .help = "What comes in at the slots of adjustable variables and menu commands, and what it sets.",
     .group = "Signals", .units = kSlotUnits},
    {.key = "attitude", .label = "Read attitude vectors", .help = "Where gravity and north are, as a sensor sees them.", .group = "Read",
     .arguments = kAttitudeArguments},
    {.key = "feed", .label = "Feed from a file",
     .help = "Sends rows of a CSV file at their time: what a flight controller tells of the frame (helper), a correction of the gyroscope "
             "(gyro), or the attitude of another sensor (attitude).",
     .group = "Signals", .risk = ActionRisk::Moves, .arguments = kFeedArguments, .isProcedure = true, .answered = false},
    {.key = "i2c.scan", .label = "Search a bus", .help = "Finds the devices on an I2C bus of the board.", .group = "Buses",
     .arguments = std::span(kBusArguments).first(1), .isProcedure = true},
    {.key = "i2c.read", .label = "Read registers", .help = "Reads registers of a device on an I2C bus. Some devices change by being read.",
     .group = "Buses", .risk = ActionRisk::Writes, .arguments = kBusArguments},
    {.key = "i2c.write", .label = "Write registers",
     .help = "Writes registers of a device on an I2C bus. A sensor that was set up otherwise misleads the board.", .group = "Buses",
     .risk = ActionRisk::Destroys, .arguments = kBusWriteArguments,
     .confirm = "I know this device and what the register does"},
    {.key = "bootloader", .label = "Start the boot loader",
     .help = "Motors go off, and the board waits for firmware from the maker's program. This program has none and cannot end it: only "
             "switching the board off and on does.",
     .group = "Board", .risk = ActionRisk::Destroys, .confirm = "The board can be switched off and on", .letsGo = true},
    {.key = "reset", .label = "Restart board", .help = "Restarts the controller; motors go off, and may start by themselves afterwards.",
     .group = "Board", .risk = ActionRisk::Moves, .arguments = kResetArguments, .units = kResetUnits,
     .isShown = false, .letsGo = true},
    {.key = "defaults", .label = "Factory defaults", .help = "Overwrites a profile, or everything, with defaults.",
     .group = "Board", .risk = ActionRisk::Destroys, .arguments = kDefaultsArguments, .isShown = false, .letsGo = true},
};
// clang-format on

}  // namespace

std::vector<ActionSpec> availableActions(const BoardIdentity &identity)
{
    std::vector<ActionSpec> list;
    for (const ActionSpec &action : kActions) {
        if (identity.firmwareNumber < action.since)
            continue;
        if (*action.capability && !identity.capabilities.contains(QLatin1String(action.capability)))
            continue;
        list.push_back(action);
        if (action.arguments.data() == kMenuArguments)
            list.back().arguments = menuArguments(identity.firmwareNumber);
        for (const auto &[arguments, since] : kLaterArguments) {
            if (action.arguments.data() == arguments.data() && identity.firmwareNumber < since)
                list.back().arguments = arguments.first(arguments.size() - 1);
        }
    }
    return list;
}

}  // namespace simplebgc
