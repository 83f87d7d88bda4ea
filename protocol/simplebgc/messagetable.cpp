// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The commands themselves (document, errata 2 and 3). What is done with them: messages.cpp.
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/fieldmakers.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/units.h"

namespace simplebgc {

namespace commandtable {

// clang-format off

// ---- words ----
constexpr Choice kImus[] = {{0, "selected"}, {1, "main"}, {2, "frame"}};
constexpr Choice kTwoImus[] = {{1, "main"}, {2, "frame"}};
constexpr Choice kImusFromZero[] = {{0, "main"}, {1, "frame"}};
constexpr Choice kCalibrations[] = {{1, "normal"}, {2, "reset all"}, {3, "temperature"}, {4, "temperature on"}, {5, "temperature off"},
    {6, "restore factory"}, {7, "copy to sensor"}};
constexpr Choice kParamsSet[] = {{0, "finish"}, {1, "start"}};
constexpr Choice kStops[] = {{0, "free"}, {1, "brake"}, {2, "safe stop"}};
constexpr Choice kRunDelete[] = {{1, "run"}, {2, "delete"}};
constexpr Choice kTune2Actions[] = {{1, "start"}, {2, "start-and-save"}, {3, "save"}, {5, "stop"}, {6, "read"}};
constexpr Choice kQuatModes[] = {{0, "off"}, {1, "speed"}, {2, "attitude"}, {5, "speed-and-attitude"}, {9, "limited-speed"}};
constexpr Choice kControlModes[] = {{0, "none"}, {1, "speed"}, {2, "angle"}, {3, "speed-and-angle"}, {4, "rc"}, {5, "frame-angle"},
    {6, "fine-rc"}, {7, "ignore"}, {8, "shortest-angle"}};
constexpr Choice kReferences[] = {{0, "none"}, {1, "internal"}, {2, "external"}, {3, "translated"}};
constexpr Choice kExternalStates[] = {{0, "off"}, {1, "not connected"}, {2, "unknown"}, {3, "error"}, {4, "bad"}, {5, "coarse"}, {6, "good"}, {7, "fine"}};
constexpr Choice kExtModes[] = {{0, "position"}, {1, "speed"}, {2, "torque"}};
constexpr Choice kExtStates[] = {{0, "off, brake"}, {1, "on"}, {2, "off, free"}, {3, "off, safe"}};
constexpr Choice kMotorActions[] = {{1, "off, free"}, {2, "off, brake"}, {3, "off, safe"}, {4, "on"}, {5, "home"}, {6, "search home"}};
constexpr Choice kEvents[] = {{1, "menu button"}, {2, "motor state"}, {3, "emergency stop"}, {4, "camera"}, {5, "script"}, {6, "retracted"}};
constexpr Choice kCoordinates[] = {{1, "ground, turned by yaw"}, {2, "ground"}, {3, "frame"}};
constexpr Choice kDebugTypes[] = {{1, "u8"}, {2, "i8"}, {3, "u16"}, {4, "i16"}, {5, "u32"}, {6, "i32"}, {7, "f32"}};
constexpr Choice kProfiles[] = {{0, "profile 1"}, {1, "profile 2"}, {2, "profile 3"}, {3, "profile 4"}, {4, "profile 5"}, {255, "active"}};

// ---- payloads ----
constexpr FieldSpec kBoardInfoAsk[] = {number("gap", U16, "ms"), rest("password")};
constexpr FieldSpec kBoardInfo[] = {
    number("board", U8, "", 0.1), number("firmware", U16), number("state", U8), number("features", U16), number("connection", U8),
    number("extra", U32), number("features.ext", U16), number("imu.main", U8), number("imu.frame", U8), number("build", U8),
    number("base", U16)};
constexpr FieldSpec kBoardInfo3[] = {
    bytes("device", 9), bytes("mcu", 12), number("eeprom", U32, "bytes"), list("script", U16, 5, "bytes"), number("sets.used", U8),
    number("set", U8), number("flash", U8, "pages"), bytes("imu.calibration", 2), list("script.more", U16, 5, "bytes"),
    number("hardware", U16), number("features.ext2", U32), number("can.main", U8), number("can.aux", U8), number("variables", U8),
    reserved(10)};
constexpr FieldSpec kProfile[] = {word("profile", U8, kProfiles)};
constexpr FieldSpec kBlock[] = {word("profile", U8, kProfiles), rest("values")};
constexpr FieldSpec kAccGyro[] = {number("acc", S16, "g", kAccUnit), number("gyro", S16, "°/s", kGyroUnit)};
constexpr FieldSpec kRealtime3[] = {
    perAxis(kAccGyro), number("serial.errors", U16), number("system.error", U16), number("sub.error", U8), reserved(3), axes("rc", S16),
    number("rc.cmd", S16), number("fc.roll", S16), number("fc.pitch", S16), axes("imu", S16, "°", kDegreesPerCount),
    axes("frame", S16, "°", kDegreesPerCount), axes("target", S16, "°", kDegreesPerCount), number("cycle", U16, "µs"),
    number("i2c.errors", U16), number("error", U8), number("battery", U16, "V", 0.01), number("flags", U8), word("imu.used", U8, kTwoImus),
    word("profile", U8, kProfiles), axes("power", U8)};
constexpr BitsSpec kStateBits[] = {{"debug", 0}, {"frame_inverted", 1}, {"start.step1", 2}, {"start.step2", 3}, {"started", 4}, {"power_manager", 5},
    {"shake", 8}, {"servo", 9}, {"follow.roll", 10}, {"follow.pitch", 11}, {"follow.yaw", 12}, {"tripod", 13}, {"retracted", 14}};
constexpr FieldSpec kRealtime4Later[] = {
    axes("output", S16, "%", 0.01), word("calibration", U8, kCalibModes), number("can.error", U8),
    axes("actual", S16, "°", kDegreesPerCount), parts("state", U32, kStateBits)};
constexpr FieldSpec kRealtime4[] = {
    group("", kRealtime3, 1, Elements::One), axes("motor", S16, "°", kDegreesPerCount), reserved(1), axes("balance", S16),
    number("current", U16, "mA"), axes("mag", S16), number("temperature", S8, "°C"), number("frame.temperature", S8, "°C"),
    number("gravity.error", U8, "°", 0.1), number("heading.error", U8, "°", 0.1), group("", kRealtime4Later, 1, Elements::One), reserved(18)};
constexpr FieldSpec kSelectImuOld[] = {word("imu", U8, kTwoImus)};
constexpr FieldSpec kSelectImu[] = {word("imu", U8, kTwoImus), number("action", U8), number("time", U16, "ms"), reserved(8)};
constexpr FieldSpec kMotor[] = {word("motor", U8, kMotorNames)};
constexpr FieldSpec kFieldOffset[] = {axes("angle", S16, "°", kDegreesPerCount), axes("speed", S16, "°/s", kGyroUnit), number("flags", U16)};
constexpr FieldSpec kFieldOffsetOld[] = {axes("angle", S16, "°", kDegreesPerCount)};
constexpr FieldSpec kNames[] = {text("name1", 48), text("name2", 48), text("name3", 48), text("name4", 48), text("name5", 48)};
constexpr FieldSpec kVariable[] = {number("id", U8), number("value", S32)};
constexpr FieldSpec kVariables[] = {number("count", U8), group("variable", kVariable, 0)};
constexpr FieldSpec kVariableF[] = {number("id", U8), number("value", F32)};
constexpr FieldSpec kVariablesF[] = {number("count", U8), group("variable", kVariableF, 0)};
constexpr FieldSpec kVariableIds[] = {number("count", U8), list("id", U8, 0)};
constexpr FieldSpec kIds[] = {list("id", U8, 0)};
constexpr FieldSpec kAutoPidOld[] = {word("profile", U8, kProfiles), number("flags", U8), number("gain", U8), reserved(16)};
constexpr FieldSpec kAutoPid[] = {word("profile", U8, kProfiles), number("flags", U8), number("gain", U8), number("momentum", U8), number("action", U8), reserved(14)};
constexpr FieldSpec kTracking[] = {number("error", F32, "°"), reserved(6)};
constexpr FieldSpec kAutoPidTold[] = {
    axes("p", U8), axes("i", U8), axes("d", U8), axes("lpf", U16, "Hz"), number("iteration", U16), perAxis(kTracking), reserved(10)};
constexpr FieldSpec kServos[] = {list("servo", S16, 8, "µs")};
constexpr FieldSpec kBodeStart[] = {
    number("axis", U8), number("type", U8), number("gain", U16), number("end", U16, "Hz"), number("system", U8), number("samples", U32),
    number("mode", U8), number("start", U16, "Hz"), reserved(16)};
constexpr FieldSpec kBodeEnd[] = {number("samples", U32), number("code", U16), number("mode", U8), reserved(15)};
constexpr FieldSpec kPair[] = {number("in", U16), number("out", U16)};
constexpr FieldSpec kBodeData[] = {
    number("counter", U8), number("in.min", F32), number("out.min", F32), number("in.max", F32), number("out.max", F32),
    group("sample", kPair, 0)};
constexpr FieldSpec kI2cWrite[] = {number("address", U8), number("register", U8), rest("data")};
constexpr FieldSpec kI2cRead[] = {number("address", U8), number("register", U8), number("length", U8)};
constexpr FieldSpec kData[] = {rest("data")};
constexpr FieldSpec kExternal[] = {bytes("data", 128)};
constexpr FieldSpec kTrigger[] = {word("source", U8, kSignalSources), list("action", U8, 5, "", 1, kMenuActions)};
constexpr FieldSpec kAnalog[] = {word("source", U8, kSignalSources), number("variable", U8), number("min", U8), number("max", U8)};
constexpr FieldSpec kSlots[] = {group("trigger", kTrigger, 10), group("analog", kAnalog, 15), reserved(8)};
constexpr FieldSpec kChannels[] = {list("channel", S16, 0)};
constexpr FieldSpec kSlotAsk[] = {number("trigger", U8), number("analog", U16), number("variable", U8), number("table", U16), number("table.variable", U8)};
constexpr FieldSpec kSlotState[] = {
    number("trigger", S16), word("action", U8, kMenuActions), number("analog", S16), number("value", F32), number("table", S16),
    number("table.value", F32)};
constexpr FieldSpec kSlotAskOld[] = {number("trigger", U8), number("analog", U8)};
constexpr FieldSpec kSlotStateOld[] = {
    number("trigger", S16), word("action", U8, kMenuActions), number("analog", S16), number("value", S32), reserved(6)};
constexpr FieldSpec kMemoryWrite[] = {number("address", U32), rest("data")};
constexpr FieldSpec kMemoryRead[] = {number("address", U32), number("size", U16, "bytes")};
constexpr FieldSpec kCalibInfoAsk[] = {word("imu", U8, kImus), reserved(11)};
constexpr FieldSpec kCalibInfo[] = {
    number("progress", U8, "%"), word("imu", U8, kImus), xyz("acc", S16, "g", kAccUnit), number("gyro", U16), number("axis", U8),
    number("limits", U8), number("temperature", S8, "°C"), number("gyro.temp", U8), number("gyro.min", S8, "°C"), number("gyro.max", S8, "°C"),
    number("acc.temp", U8), list("slots", U8, 6), number("acc.min", S8, "°C"), number("acc.max", S8, "°C"), number("heading.error", U8, "", 0.01),
    reserved(7)};
constexpr FieldSpec kSign[] = {number("type", U8), bytes("data", 32)};
constexpr FieldSpec kSigned[] = {bytes("data", 32)};
constexpr FieldSpec kBoot[] = {number("notice", U8), number("delay", U16, "ms")};
constexpr FieldSpec kFileRead[] = {word("type", U8, kFileTypes), number("number", U8), number("page", U16), number("size", U16, "bytes"), reserved(14)};
constexpr FieldSpec kFileData[] = {number("size", U16, "bytes"), number("page", U16), rest("data")};
constexpr FieldSpec kFileWrite[] = {word("type", U8, kFileTypes), number("number", U8), number("size", U16, "bytes"), number("page", U16), rest("data")};
constexpr FieldSpec kAhrsAsk[] = {number("mode", U16), xyz("z", F32), xyz("h", F32), rest("more")};
constexpr FieldSpec kAhrsAskOld[] = {number("mode", U8), xyz("z", F32), xyz("h", F32), rest("more")};
constexpr FieldSpec kAhrs[] = {xyz("z", F32), xyz("h", F32)};
constexpr FieldSpec kRunScript[] = {word("mode", U8, kScriptModes), number("slot", U8), reserved(32)};
constexpr FieldSpec kScriptDebug[] = {number("command", U16), word("code", U8, kFileCodes)};
constexpr FieldSpec kCalibrationOld[] = {word("imu", U8, kImus), word("action", U8, kCalibrations), reserved(10)};
constexpr FieldSpec kCalibration[] = {word("imu", U8, kImus), word("action", U8, kCalibrations), number("time", U16, "ms"), reserved(8)};
constexpr FieldSpec kVoltage[] = {number("voltage", U16, "V", 0.01)};
constexpr FieldSpec kControlAxis[] = {number("speed", S16), number("angle", S16, "°", kDegreesPerCount)};
constexpr FieldSpec kControl[] = {axes("mode", U8), perAxis(kControlAxis)};
constexpr FieldSpec kControlOld[] = {number("mode", U8), perAxis(kControlAxis)};
constexpr FieldSpec kConfirmed[] = {number("command", U8), rest("data")};
constexpr FieldSpec kMenuOld[] = {word("action", U8, kMenuActions)};
constexpr FieldSpec kMenu[] = {word("action", U8, kMenuActions), number("flags", U8)};
constexpr FieldSpec kDefaults[] = {number("scope", U8)};
constexpr FieldSpec kHelperOld[] = {
    xyz("acc", S16, "g", kAccUnit), number("roll", S16, "°", kDegreesPerCount), number("pitch", S16, "°", kDegreesPerCount)};
constexpr FieldSpec kHelper[] = {
    group("", kHelperOld, 1, Elements::One), word("system", U8, kCoordinates), xyz("speed", S16, "°/s", kGyroUnit), number("heading", S16, "°", kDegreesPerCount), reserved(1)};
constexpr FieldSpec kAngleOf[] = {number("imu", S16, "°", kDegreesPerCount), number("target", S16, "°", kDegreesPerCount), number("speed", S16, "°/s", kControlSpeedUnit)};
constexpr FieldSpec kAngles[] = {perAxis(kAngleOf)};
constexpr FieldSpec kAngleExtOf[] = {number("imu", S16, "°", kDegreesPerCount), number("target", S16, "°", kDegreesPerCount), number("motor", S32, "°", kDegreesPerCount), reserved(10)};
constexpr FieldSpec kAnglesExt[] = {perAxis(kAngleExtOf)};
constexpr FieldSpec kGyroCorrection[] = {word("imu", U8, kImusFromZero), xyz("zero", S16, "", 0.001), number("heading", S16, "", 0.001)};
constexpr FieldSpec kModule[] = {number("id", U8), number("board", U16), number("bootloader", U16), number("firmware", U16), reserved(6)};
constexpr FieldSpec kModules[] = {number("count", U8), group("module", kModule, 0)};
constexpr FieldSpec kPin[] = {word("pin", U8, kPinNames), word("state", U8, kPinStates)};
constexpr FieldSpec kStream[] = {number("command", U8), number("interval", U16, "ms"), bytes("config", 8), number("sync", U8), reserved(9)};
constexpr FieldSpec kCustomAsk[] = {number("flags", U32), reserved(6)};
constexpr FieldSpec kCustom[] = {number("time", U16, "ms"), rest("fields")};
constexpr FieldSpec kBeep[] = {number("sound", U16), number("length", U8, "ms", 8), number("decay", U8), reserved(8), list("note", U16, 0, "Hz")};
constexpr FieldSpec kControlFilter[] = {
    number("lpf.angle", U8), number("lpf.speed", U8), number("lpf.rc", U8), number("acceleration", U16, "°/s²"), number("jerk", U8, "ms", 20), reserved(1)};
constexpr FieldSpec kControlConfig[] = {
    number("timeout", U16, "ms"), number("uart1", U8), number("rc.serial", U8), number("uart2", U8), number("usb", U8), number("here", U8),
    perAxis(kControlFilter), number("expo", U8), number("flags", U16), number("euler", U8), reserved(9)};
constexpr FieldSpec kNothing16[] = {reserved(16)};
constexpr FieldSpec kCoggingAxis[] = {number("angle", U16, "°"), number("smooth", U8, "%"), number("speed", U8), number("period", U16, "°"), reserved(9)};
constexpr FieldSpec kCogging[] = {word("action", U8, kRunDelete), number("axes", U8), perAxis(kCoggingAxis), number("iterations", U8), reserved(9)};
constexpr FieldSpec kAccReference[] = {xyz("acc", S16, "g", kAccUnit), reserved(14)};
constexpr FieldSpec kProfileSet[] = {number("slot", U8), word("action", U8, kSetActions), reserved(8)};
constexpr FieldSpec kCanDevice[] = {bytes("uid", 12), number("id", U8), number("type", U8)};
constexpr FieldSpec kCanDevices[] = {group("device", kCanDevice, 0)};
constexpr FieldSpec kRcAsk[] = {number("flags", U16), list("source", U8, 0, "", 1, kSignalSources)};
constexpr FieldSpec kRcInputs[] = {list("input", S16, 0)};
constexpr FieldSpec kEvent[] = {word("event", U8, kEvents), number("type", U8), bytes("parameter", 2), rest("more")};
constexpr BitsSpec kSourceBits[] = {{"attitude", 0, 3, kReferences}, {"heading", 3, 3, kReferences}, {"present", 6}, {"processing", 7}};
constexpr BitsSpec kExternalBits[] = {{"state", 0, 3, kExternalStates}, {"bad_magnetometer", 6}, {"no_gps", 7}};
constexpr FieldSpec kAhrsDebug[] = {
    parts("main.source", U8, kSourceBits), parts("frame.source", U8, kSourceBits), number("main.z.error", U8, "°", 0.1),
    number("main.h.error", U8, "°", 0.1), number("frame.z.error", U8, "°", 0.1), number("frame.h.error", U8, "°", 0.1),
    parts("external", U8, kExternalBits), number("packets", U16), number("parse.errors", U16), number("heading.error", U8),
    number("z.error", U8), reserved(13), list("matrix", F32, 9), xyz("acc", F32)};
constexpr BitsSpec kTune2AxisBits[] = {{"enabled", 0}, {"lpf", 1}, {"notches", 2, 2}};
constexpr BitsSpec kTune2Bits[] = {
    {"from_current", 0}, {"all_profiles", 1}, {"gain_only", 2}, {"save", 4}, {"at_start", 14}, {"gain_at_start", 15}};
constexpr BitsSpec kTune2CommandBits[] = {{"send", 0}};
constexpr BitsSpec kTune2PositionBits[] = {{"first", 0}, {"second", 1}, {"third", 2}, {"fourth", 3}};
constexpr FieldSpec kTune2Axis[] = {
    parts("flags", U8, kTune2AxisBits), number("gain", U8), number("stimulus", U16), number("effective", U8, "Hz"), number("problem", U8, "Hz"),
    number("margin", U8, "dB", 0.1), reserved(6)};
// The unit of the upper end is not established: 1 or 2 Hz (errata 9).
constexpr FieldSpec kTune2Settings[] = {
    number("version", U8), perAxis(kTune2Axis), parts("flags", U16, kTune2Bits), reserved(1), number("from", U8, "Hz", 0.1), number("to", U8),
    parts("positions", U8, kTune2PositionBits), list("position", S8, 4, "°", 3), reserved(12)};
constexpr bool isTune2Set(std::uint32_t action, int)
{
    return action >= 1 && action <= 3;
}
constexpr FieldSpec kTune2[] = {
    word("action", U8, kTune2Actions), parts("command", U16, kTune2CommandBits), reserved(8), when("action", isTune2Set, kTune2Settings)};
// That it answers "read" in the same layout is assumed: no text tells.
constexpr FieldSpec kTune2Told[] = {
    word("action", U8, kTune2Actions), parts("command", U16, kTune2CommandBits), reserved(8), group("", kTune2Settings, 1, Elements::One)};
constexpr FieldSpec kMotorsOff[] = {word("how", U8, kStops)};
constexpr FieldSpec kCommandData[] = {number("command", U8), rest("data")};
constexpr FieldSpec kStateVars[] = {
    list("step", U8, 6), number("sub.error", U8), number("shock", U8, "g", 1.0 / 16), number("work", U32, "s"), number("starts", U16),
    number("current.max", U16, "mA"), list("temperature", S8, 4, "°C"), list("shocks", U8, 4), number("energy.time", U32, "s"),
    number("energy", F32, "Wh"), number("average.time", U32, "s"), number("average", F32, "A"), reserved(152)};
constexpr FieldSpec kReset[] = {number("notice", U8), number("delay", U16, "ms")};
constexpr FieldSpec kWriteSet[] = {word("action", U8, kParamsSet)};
// CONTROL_EXT: five bits of "set" for each axis (errata 3.14).
template <unsigned Bit> constexpr bool hasAxisBit(std::uint32_t set, int axis)
{
    return set >> (5U * unsigned(axis) + Bit) & 1U;
}
template <unsigned Bit> constexpr bool lacksAxisBit(std::uint32_t set, int axis)
{
    return !hasAxisBit<Bit>(set, axis);
}
constexpr bool isAxisSet(std::uint32_t set, int axis)
{
    return hasAxisBit<0>(set, axis) || hasAxisBit<1>(set, axis);
}
constexpr bool isSignal(std::uint32_t mode, int)
{
    return (mode & 0x0FU) == 4 || (mode & 0x0FU) == 6;
}
constexpr bool isAngle(std::uint32_t mode, int)
{
    return !isSignal(mode, 0);
}
constexpr double kFineAngleUnit = 360.0 / (1 << 20);
constexpr BitsSpec kControlExtBits[] = {
    {"roll.speed", 0}, {"roll.angle", 1}, {"roll.fine_angle", 2}, {"roll.fine_speed", 3}, {"pitch.speed", 5}, {"pitch.angle", 6},
    {"pitch.fine_angle", 7}, {"pitch.fine_speed", 8}, {"yaw.speed", 10}, {"yaw.angle", 11}, {"yaw.fine_angle", 12}, {"yaw.fine_speed", 13}};
constexpr BitsSpec kControlModeBits[] = {{"kind", 0, 4, kControlModes}, {"follow", 4}, {"precise", 5}, {"task", 6}, {"fine", 7}};
constexpr BitsSpec kControlFlagBits[] = {{"uncorrected", 0}};
constexpr FieldSpec kWideSpeed[] = {
    when("set", hasAxisBit<3>, number("speed", S32, "°/s", kFineSpeedUnit))};
constexpr FieldSpec kNarrowSpeed[] = {
    when("mode", hasBit<7>, number("speed", S16, "°/s", kFineSpeedUnit)), when("mode", lacksBit<7>, number("speed", S16, "°/s", kControlSpeedUnit))};
constexpr FieldSpec kSpeedForm[] = {
    group("", kWideSpeed, 1, Elements::One), when("set", lacksAxisBit<3>, kNarrowSpeed)};
// In the modes of RC it is a signal, not an angle (errata 3.12).
constexpr FieldSpec kWideAngle[] = {
    when("mode", isAngle, number("angle", S32, "°", kFineAngleUnit)), when("mode", isSignal, number("signal", S32))};
constexpr FieldSpec kNarrowAngle[] = {
    when("mode", isAngle, number("angle", S16, "°", kDegreesPerCount)), when("mode", isSignal, number("signal", S16))};
constexpr FieldSpec kAngleForm[] = {when("set", hasAxisBit<2>, kWideAngle), when("set", lacksAxisBit<2>, kNarrowAngle)};
constexpr FieldSpec kControlExtAxis[] = {
    parts("mode", U8, kControlModeBits), parts("flags", U8, kControlFlagBits), when("set", hasAxisBit<0>, kSpeedForm),
    when("set", hasAxisBit<1>, kAngleForm)};
constexpr FieldSpec kControlExt[] = {parts("set", U16, kControlExtBits), when("set", isAxisSet, perAxis(kControlExtAxis))};
constexpr FieldSpec kSync[] = {number("axis", U8), number("power", U8), number("time", U16, "ms"), number("angle", U16, "°", kDegreesPerCount)};
constexpr FieldSpec kDriver[] = {number("driver", U8), number("time", U16, "ms"), rest("data")};
constexpr BitsSpec kExtMotorBits[] = {{"first", 0}, {"second", 1}, {"third", 2}, {"fourth", 3}, {"fifth", 4}, {"sixth", 5}, {"seventh", 6}, {"confirm", 7}};
constexpr FieldSpec kExtAction[] = {parts("motors", U8, kExtMotorBits), word("action", U8, kMotorActions)};
// The errata (3.23) name what EXT_MOTORS_x and CONTROL_QUAT_x hold in the order of the bits; which bit is which, and the fields of the two
// that tell a state, are after the public rendering of the specification of 2025 that they cite.
constexpr BitsSpec kExtControlBits[] = {{"wide_target", 0}, {"parameter", 1}, {"wide_parameter", 2}};
constexpr FieldSpec kExtTarget[] = {
    when("set", hasBit<0>, number("target", S32)), when("set", lacksBit<0>, number("target", S16)), when("set", hasBit<1>, number("parameter", S16)),
    when("set", hasBit<2>, number("wide_parameter", S32))};
constexpr FieldSpec kExtControl[] = {
    parts("motors", U8, kExtMotorBits), parts("set", U8, kExtControlBits), group("motor", kExtTarget, 0)};
constexpr BitsSpec kExtConfigBits[] = {{"mode", 0}, {"speed", 1}, {"acceleration", 2}, {"jerk", 3}, {"torque", 4}};
constexpr FieldSpec kExtConfig[] = {
    parts("motors", U8, kExtMotorBits), parts("set", U16, kExtConfigBits), when("set", hasBit<0>, word("mode", U8, kExtModes)),
    when("set", hasBit<1>, number("speed", U16, "°/s", 2)), when("set", hasBit<2>, number("acceleration", U16, "°/s²", 2)),
    when("set", hasBit<3>, number("jerk", U16, "ms")), when("set", hasBit<4>, number("torque", U16))};
constexpr BitsSpec kExtStateBits[] = {
    {"mode", 0}, {"torque", 1}, {"torque.target", 2}, {"speed", 3}, {"speed.target", 4}, {"fine_speed", 5}, {"fine_speed.target", 6}, {"angle", 7},
    {"angle.target", 8}, {"fine_angle", 9}, {"fine_angle.target", 10}, {"state", 11}, {"speed.max", 12}, {"acceleration.max", 13}, {"jerk", 14},
    {"torque.max", 15}, {"current", 16}, {"voltage", 17}, {"temperature", 18}, {"driver.temperature", 19}};
constexpr BitsSpec kExtMotorStateBits[] = {{"motor", 0, 2, kExtStates}, {"index_pin", 2}};
constexpr double kMicroRadian = 180e-6 / 3.14159265358979323846;
constexpr FieldSpec kExtAsk[] = {parts("motors", U8, kExtMotorBits), parts("set", U32, kExtStateBits)};
constexpr FieldSpec kExtState[] = {
    number("motor", U8), parts("set", U32, kExtStateBits), when("set", hasBit<0>, word("mode", U8, kExtModes)),
    when("set", hasBit<1>, number("torque", S16)), when("set", hasBit<2>, number("torque.target", S16)),
    when("set", hasBit<3>, number("speed", S16, "°/s", kControlSpeedUnit)), when("set", hasBit<4>, number("speed.target", S16, "°/s", kControlSpeedUnit)),
    when("set", hasBit<5>, number("fine_speed", S32, "°/s", kMicroRadian)), when("set", hasBit<6>, number("fine_speed.target", S32, "°/s", kMicroRadian)),
    when("set", hasBit<7>, number("angle", S16, "°", kDegreesPerCount)), when("set", hasBit<8>, number("angle.target", S16, "°", kDegreesPerCount)),
    when("set", hasBit<9>, number("fine_angle", S32, "°", kFineAngleUnit)), when("set", hasBit<10>, number("fine_angle.target", S32, "°", kFineAngleUnit)),
    when("set", hasBit<11>, parts("state", U16, kExtMotorStateBits)), when("set", hasBit<12>, number("speed.max", U16, "°/s", 2)),
    when("set", hasBit<13>, number("acceleration.max", U16, "°/s²", 2)), when("set", hasBit<14>, number("jerk", U16, "ms")),
    when("set", hasBit<15>, number("torque.max", U16)), when("set", hasBit<16>, number("current", U16, "mA")),
    when("set", hasBit<17>, number("voltage", U16, "mV")), when("set", hasBit<18>, number("temperature", S8, "°C")),
    when("set", hasBit<19>, number("driver.temperature", S8, "°C"))};
constexpr FieldSpec kFirst[] = {number("first", U8)};
constexpr FieldSpec kVariableInfo[] = {number("id", U8), {"name", Sized}, number("min", S16), number("max", S16), number("value", S32)};
constexpr FieldSpec kVariableInfos[] = {number("total", U8), group("variable", kVariableInfo, 0)};
constexpr FieldSpec kServoExt[] = {number("mask", U32), list("servo", S16, 0, "µs")};
constexpr bool hasAttitude(std::uint32_t mode, int)
{
    return mode == 2 || mode == 5;
}
constexpr bool hasSpeed(std::uint32_t mode, int)
{
    return mode == 1 || mode == 5 || mode == 9;
}
constexpr BitsSpec kQuatBits[] = {{"confirm", 0}, {"packed", 1}, {"limited", 2}, {"drop_axes", 3}, {"task", 6}};
constexpr FieldSpec kQuatAttitude[] = {when("flags", lacksBit<1>, quaternion("attitude")), when("flags", hasBit<1>, packed("attitude"))};
// What a mode has no use for is believed to be left out (errata 3.23).
constexpr FieldSpec kQuat[] = {
    word("mode", U8, kQuatModes), parts("flags", U8, kQuatBits), when("mode", hasAttitude, kQuatAttitude),
    when("mode", hasSpeed, xyz("speed", F32, "rad/s"))};
constexpr BitsSpec kQuatStateBits[] = {
    {"mode", 0}, {"target", 1}, {"setpoint", 2}, {"actual", 3}, {"target.speed", 4}, {"setpoint.speed", 5}, {"actual.speed", 6}, {"target.packed", 7},
    {"setpoint.packed", 8}, {"actual.packed", 9}};
constexpr FieldSpec kQuatAsk[] = {parts("set", U32, kQuatStateBits)};
constexpr FieldSpec kQuatModeTold[] = {word("mode", U8, kQuatModes), parts("flags", U16, kQuatBits)};
constexpr FieldSpec kQuatState[] = {
    parts("set", U32, kQuatStateBits), when("set", hasBit<0>, kQuatModeTold), when("set", hasBit<1>, quaternion("target")),
    when("set", hasBit<2>, quaternion("setpoint")), when("set", hasBit<3>, quaternion("actual")),
    when("set", hasBit<4>, xyz("target.speed", S16, "°/s", kGyroUnit)), when("set", hasBit<5>, xyz("setpoint.speed", S16, "°/s", kGyroUnit)),
    when("set", hasBit<6>, xyz("actual.speed", S16, "°/s", kGyroUnit)), when("set", hasBit<7>, packed("target.packed")),
    when("set", hasBit<8>, packed("setpoint.packed")), when("set", hasBit<9>, packed("actual.packed"))};
constexpr BitsSpec kQuatConfigBits[] = {{"speed", 0}, {"acceleration", 1}, {"jerk", 2}, {"flags", 3}, {"attitude.lpf", 4}, {"speed.lpf", 5}};
constexpr BitsSpec kQuatConfigFlags[] = {{"split_axes", 0}};
constexpr FieldSpec kQuatConfig[] = {
    parts("set", U16, kQuatConfigBits), when("set", hasBit<0>, xyz("speed", U16, "°/s", kControlSpeedUnit)),
    when("set", hasBit<1>, xyz("acceleration", U16, "°/s²")), when("set", hasBit<2>, xyz("jerk", U16, "ms")),
    when("set", hasBit<3>, parts("flags", U16, kQuatConfigFlags)), when("set", hasBit<4>, number("attitude.lpf", U8, "Hz")),
    when("set", hasBit<5>, number("speed.lpf", U8, "Hz"))};
constexpr FieldSpec kSensorCommand[] = {number("sensor", U8), number("command", U8), rest("data")};
constexpr FieldSpec kTransparent[] = {number("target", U8), rest("data")};
constexpr FieldSpec kDebugPort[] = {number("on", U8), number("filter", U32), reserved(11)};
constexpr FieldSpec kDebugPortTold[] = {number("time", U16, "ms"), number("port", U8), number("command", U8), rest("data")};
constexpr FieldSpec kDebugVar[] = {{"name", Sized}, word("type", U8, kDebugTypes), number("size", U16)};
constexpr FieldSpec kDebugInfo[] = {number("count", U8), group("variable", kDebugVar, 0)};
constexpr FieldSpec kMasks[] = {list("mask", U32, 0)};
constexpr FieldSpec kError[] = {number("command", U8), number("code", U8), bytes("data", 4)};
constexpr Fields kNone{};

constexpr auto kSafe = ActionRisk::Safe;
constexpr auto kMoves = ActionRisk::Moves;
constexpr auto kWrites = ActionRisk::Writes;
constexpr auto kDestroys = ActionRisk::Destroys;
constexpr std::optional<Fields> kNo{};
constexpr auto kFrame = Reply::Frame;
constexpr auto kConfirm = Reply::Confirm;
constexpr auto kNothing = Reply::None;

constexpr MessageSpec hidden(int id, const char *name, int since = kLater)
{
    return {id, name, kNo, kNo, kNothing, kDestroys, since, -1, false};
}

// number, name, towards the board, from it, answer, risk, since, least bytes, layout known, where
constexpr MessageSpec kMessages[] = {
    {20, "BOARD_INFO_3", kNone, kBoardInfo3, kFrame, kSafe, 0, 0, true, "connecting"},
    {21, "READ_PARAMS_3", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    {22, "WRITE_PARAMS_3", kBlock, kNo, kConfirm, kWrites, 0, 134, true, "Parameters"},
    {23, "REALTIME_DATA_3", kNone, kRealtime3, kFrame, kSafe, 0, 0, true, "Monitor"},
    {24, "SELECT_IMU_3", kSelectImu, kNo, kConfirm, kSafe, 0, 1, true, "Calibration, Actions (imu.select)"},
    {25, "REALTIME_DATA_4", kNone, kRealtime4, kFrame, kSafe, 0, 0, true, "Monitor"},
    {26, "ENCODERS_CALIB_OFFSET_4", kMotor, kNo, kConfirm, kWrites, kLater, 0, true, "Actions (calibrate.encoder_offset)"},
    {27, "ENCODERS_CALIB_FLD_OFFSET_4", kFieldOffset, kNo, kConfirm, kWrites, kLater, 0, true, "Actions (calibrate.encoder_field)"},
    {28, "READ_PROFILE_NAMES", kNone, kNames, kFrame, kSafe, 0, 0, true, "Profiles"},
    {29, "WRITE_PROFILE_NAMES", kNames, kNo, kConfirm, kWrites, 0, 240, true, "Profiles"},
    {30, "GET_PARAMS_3", kNone, kNo, kNothing, kSafe, 0, 0},
    {31, "SET_ADJ_VARS_VAL", kVariables, kVariables, kConfirm, kMoves, 0, 1, true, "Tuning, Adjustable variables, Actions (variables.write)"},
    {32, "SAVE_PARAMS_3", kIds, kNo, kConfirm, kWrites, 0, 0, true, "Tuning, Adjustable variables, Actions (variables.save)"},
    {33, "READ_PARAMS_EXT", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    {34, "WRITE_PARAMS_EXT", kBlock, kNo, kConfirm, kWrites, 0, 104, true, "Parameters"},
    {35, "AUTO_PID", kAutoPid, kAutoPidTold, kConfirm, kWrites, 0, 19, true, "Auto-tune"},
    {36, "SERVO_OUT", kServos, kNo, kNothing, kMoves, 0, 16, true, "Actions (servo)"},
    {37, "BODE_TEST_START_STOP", kBodeStart, kBodeEnd, kConfirm, kMoves, kLater, 30, true, "Actions (response)"},
    {38, "BODE_TEST_DATA", kNo, kBodeData, kNothing, kSafe, kLater, -1, true, "Actions (response)"},
    {39, "I2C_WRITE_REG_BUF", kI2cWrite, kNo, kConfirm, kDestroys, 0, 2, true, "Actions (i2c.write)"},
    {40, "I2C_READ_REG_BUF", kI2cRead, kData, kFrame, kWrites, 0, 3, true, "Actions (i2c.read)"},
    {41, "WRITE_EXTERNAL_DATA", kExternal, kNo, kConfirm, kWrites, 0, 128, true, "Actions (external.write)"},
    {42, "READ_EXTERNAL_DATA", kNone, kExternal, kFrame, kSafe, 0, 0, true, "Actions (external.read)"},
    {43, "READ_ADJ_VARS_CFG", kNone, kSlots, kFrame, kSafe, 0, 0, true, "Parameters"},
    {44, "WRITE_ADJ_VARS_CFG", kSlots, kNo, kConfirm, kWrites, 0, 128, true, "Parameters"},
    {45, "API_VIRT_CH_CONTROL", kChannels, kNo, kNothing, kMoves, 0, 2, true, "Actions (channel)"},
    {46, "ADJ_VARS_STATE", kSlotAsk, kSlotState, kFrame, kSafe, 0, 7, true, "Actions (slots.read)"},
    {47, "EEPROM_WRITE", kMemoryWrite, kNo, kConfirm, kDestroys, 0, 4, true, "Whole board, Actions (memory.restore)"},
    {48, "EEPROM_READ", kMemoryRead, kMemoryWrite, kFrame, kSafe, 0, 6, true, "Whole board, Actions (memory.save, memory.compare)"},
    {49, "CALIB_INFO", kCalibInfoAsk, kCalibInfo, kFrame, kSafe, kLater, 12, true, "Calibration, Actions (calibration, calibration.save, calibration.compare)"},
    {50, "SIGN_MESSAGE", kSign, kSigned, kFrame, kSafe, kLater, 33},
    {51, "BOOT_MODE_3", kBoot, kNo, kNothing, kDestroys, 0, 0, true, "Actions (bootloader)"},
    hidden(52, "SYSTEM_STATE", 0),
    {53, "READ_FILE", kFileRead, kFileData, kFrame, kSafe, 0, 20, true, "Whole board, Calibration, Actions (file.save)"},
    {54, "WRITE_FILE", kFileWrite, kNo, kConfirm, kDestroys, 0, 6, true, "Whole board, Calibration, Actions (file.load, file.erase)"},
    {55, "FS_CLEAR_ALL", kNone, kNo, kConfirm, kDestroys, 0, 0, true, "Whole board, Actions (file.erase_all)"},
    {56, "AHRS_HELPER", kAhrsAsk, kAhrs, kFrame, kMoves, 0, 2, true, "Monitor, Actions (attitude, feed)"},
    {57, "RUN_SCRIPT", kRunScript, kNo, kConfirm, kMoves, 0, 34, true, "Scripts, Actions (script, script.stop)"},
    {58, "SCRIPT_DEBUG", kNo, kScriptDebug, kNothing, kSafe, 0, -1, true, "Scripts, Actions (script.follow)"},
    {59, "CALIB_MAG", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Calibration, Actions (calibrate.magnetometer)"},
    hidden(60, "UART_BYPASS"),
    {61, "GET_ANGLES_EXT", kNone, kAnglesExt, kFrame, kSafe, 0, 0, true, "Actions (angles)"},
    {62, "READ_PARAMS_EXT2", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    {63, "WRITE_PARAMS_EXT2", kBlock, kNo, kConfirm, kWrites, 0, 151, true, "Parameters"},
    {64, "GET_ADJ_VARS_VAL", kVariableIds, kNo, kFrame, kSafe, 0, 1, true, "Tuning, Adjustable variables, Actions (variables.read)", 31},
    {65, "CALIB_ACC", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Calibration, Actions (calibrate.acc)"},
    {66, "CALIB_BAT", kVoltage, kNo, kConfirm, kWrites, 0, 2, true, "Actions (calibrate.battery)"},
    {67, "CONTROL", kControl, kConfirmed, kConfirm, kMoves, 0, 15, true, "Control"},
    {68, "REALTIME_DATA", kNone, kNo, kFrame, kSafe, 0, 0, true, "Monitor", 23},
    {69, "EXECUTE_MENU", kMenu, kNo, kConfirm, kWrites, 0, 1, true, "Control, Profiles, Actions (menu, profile.select)"},
    {70, "USE_DEFAULTS", kDefaults, kNo, kConfirm, kDestroys, 0, 1, true, "Actions (defaults)"},
    {71, "CALIB_EXT_GAIN", kNone, kNo, kConfirm, kWrites, 0, 0, true, "Actions (calibrate.fc_gain)"},
    {72, "HELPER_DATA", kHelper, kNo, kNothing, kMoves, 0, 10, true, "Actions (feed)"},
    {73, "GET_ANGLES", kNone, kAngles, kFrame, kSafe, 0, 0, true, "Actions (angles)"},
    {74, "CALIB_MOTOR_MAG_LINK", kNone, kNo, kConfirm, kWrites, 0, 0, true, "Actions (calibrate.magnetic_link)"},
    {75, "GYRO_CORRECTION", kGyroCorrection, kNo, kNothing, kMoves, 0, 9, true, "Actions (feed)"},
    {76, "MODULE_LIST", kNone, kModules, kFrame, kSafe, kLater, 0},
    {77, "MOTORS_ON", kNone, kNo, kConfirm, kMoves, 0, 0, true, "Start motors"},
    hidden(78, "MODULE_FLASH_START"),
    {79, "CALIB_OFFSET", kNone, kNo, kConfirm, kWrites, 0, 0, true, "Actions (calibrate.offset)"},
    {80, "CALIB_POLES", kNone, kNo, kConfirm, kWrites, 0, 0, true, "Actions (calibrate.poles)"},
    hidden(81, "MODULE_FLASH_WRITE"),
    {82, "READ_PARAMS", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    hidden(83, "MODULE_FLASH_FINISH"),
    {84, "TRIGGER_PIN", kPin, kNo, kConfirm, kMoves, 0, 2, true, "Actions (pin)"},
    {85, "DATA_STREAM_INTERVAL", kStream, kNo, kConfirm, kSafe, 2590, 21, true, "Monitor"},
    {86, "BOARD_INFO", kBoardInfoAsk, kBoardInfo, kFrame, kSafe, 0, 0, true, "connecting"},
    {87, "WRITE_PARAMS", kBlock, kNo, kConfirm, kWrites, 0, 134, true, "Parameters"},
    {88, "REALTIME_DATA_CUSTOM", kCustomAsk, kCustom, kFrame, kSafe, 2590, 10, true, "Monitor"},
    {89, "BEEP_SOUND", kBeep, kNo, kNothing, kSafe, 2590, 12, true, "Actions (beep)"},
    {90, "CONTROL_CONFIG", kControlConfig, kNo, kConfirm, kMoves, kLater, 41, true, "Actions (steer.limits)"},
    {91, "CALIB_ORIENT_CORR", kNothing16, kNo, kConfirm, kWrites, kLater, 16},
    hidden(92, "COGGING_CALIB_INFO"),
    {93, "CALIB_COGGING", kCogging, kNo, kConfirm, kWrites, kLater, 57, true, "Actions (calibrate.cogging)"},
    {94, "CALIB_ACC_EXT_REF", kAccReference, kNo, kConfirm, kWrites, kLater, 20, true, "Actions (calibrate.acc_reference)"},
    {95, "PROFILE_SET", kProfileSet, kNo, kConfirm, kDestroys, kLater, 10, true, "Actions (profile_set)"},
    {96, "CAN_DEVICE_SCAN", kNone, kCanDevices, kFrame, kSafe, kLater, 0},
    hidden(97, "CAN_DRV_HARD_PARAMS"),
    hidden(98, "CAN_DRV_STATE"),
    hidden(99, "CAN_DRV_CALIBRATE"),
    {100, "READ_RC_INPUTS", kRcAsk, kRcInputs, kFrame, kSafe, kLater, 3, true, "Actions (signals)"},
    hidden(101, "REALTIME_DATA_CAN_DRV"),
    {102, "EVENT", kNo, kEvent, kNothing, kSafe, 2657, -1, true, "Actions (events)"},
    {103, "CALIB_GYRO", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Calibration, Actions (calibrate.gyro)"},
    {104, "READ_PARAMS_EXT3", kProfile, kBlock, kFrame, kSafe, kExt3Since, 1, true, "Parameters"},
    {105, "WRITE_PARAMS_EXT3", kBlock, kNo, kConfirm, kWrites, kExt3Since, 221, true, "Parameters"},
    {106, "EXT_IMU_DEBUG_INFO", kNone, kAhrsDebug, kFrame, kSafe, kLater, 0, true, "Actions (references)"},
    hidden(107, "SET_DEVICE_ADDR"),
    {108, "AUTO_PID2", kTune2, kTune2Told, kConfirm, kWrites, 2730, 11, true, "Actions (autotune.by_axis)"},
    {109, "MOTORS_OFF", kMotorsOff, kNo, kConfirm, kSafe, 0, 0, true, "Stop motors"},
    {110, "EXT_IMU_CMD", kCommandData, kCommandData, kFrame, kDestroys, kLater, 1},
    {111, "READ_STATE_VARS", kNone, kStateVars, kFrame, kSafe, kLater, 0, true, "Actions (statistics)"},
    {112, "WRITE_STATE_VARS", kStateVars, kNo, kConfirm, kWrites, kLater, 192, true, "Actions (statistics.reset)"},
    hidden(113, "SERIAL_PROXY"),
    {114, "RESET", kReset, kNone, kFrame, kMoves, 0, 0, true, "Actions (reset)"},
    hidden(115, "IMU_ADVANCED_CALIB"),
    {116, "API_VIRT_CH_HIGH_RES", kChannels, kNo, kNothing, kMoves, 2687, 2, true, "Actions (channel)"},
    hidden(117, "CALIB_ENCODER_LUT"),
    hidden(118, "CALIB_ENCODER_LUT_RESULT"),
    {119, "WRITE_PARAMS_SET", kWriteSet, kNo, kConfirm, kWrites, 2704, 1, true, "Parameters"},
    hidden(120, "CALIB_CUR_SENS"),
    {121, "CONTROL_EXT", kControlExt, kNo, kConfirm, kMoves, 2680, 2, true, "Actions (steer)"},
    {123, "SYNC_MOTORS", kSync, kNo, kConfirm, kMoves, kLater, 6},
    {127, "CAN_DRV_TELEMETRY", kNo, kDriver, kNothing, kSafe, 2720},
    {128, "EXT_MOTORS_ACTION", kExtAction, kNo, kConfirm, kMoves, 2730, 2},
    {129, "EXT_MOTORS_CONTROL", kExtControl, kNo, kConfirm, kMoves, 2730, 2},
    {130, "EXT_MOTORS_CONTROL_CONFIG", kExtConfig, kNo, kConfirm, kMoves, 2730, 3},
    {131, "EXT_MOTORS_STATE", kExtAsk, kExtState, kFrame, kSafe, 2730, 5},
    {132, "ADJ_VARS_INFO", kFirst, kVariableInfos, kFrame, kSafe, kLater, 0, true, "Actions (variables.list)"},
    {133, "SERVO_OUT_EXT", kServoExt, kNo, kNothing, kMoves, 2732, 4, true, "Actions (servo.single)"},
    {134, "SET_ADJ_VARS_VAL_F", kVariablesF, kVariablesF, kConfirm, kMoves, 2734, 1},
    {135, "GET_ADJ_VARS_VAL_F", kVariableIds, kNo, kFrame, kSafe, 2734, 1, true, "Actions (variables.read)", 134},
    hidden(136, "PASS_PROTECT_READ"),
    hidden(137, "PASS_PROTECT_WRITE"),
    {139, "REALTIME_DATA_CUSTOM2", kCustomAsk, kCustom, kFrame, kSafe, 2740, 10, true, "Actions (live)"},
    {140, "CONTROL_QUAT", kQuat, kNo, kConfirm, kMoves, 2730, 2, true, "Actions (steer.attitude)"},
    {141, "CONTROL_QUAT_STATUS", kQuatAsk, kQuatState, kFrame, kSafe, 2730, 4, true, "Actions (steer.attitude, steer.state)"},
    {142, "CONTROL_QUAT_CONFIG", kQuatConfig, kNo, kConfirm, kMoves, 2730, 2, true, "Actions (steer.attitude)"},
    hidden(143, "SET_TRANSP_PROXY"),
    hidden(144, "UDRV_DEVICE_SCAN"),
    {150, "EXT_SENS_CMD", kSensorCommand, kCommandData, kFrame, kDestroys, 2687, 2},
    {151, "TRANSPARENT_SAPI", kTransparent, kData, kFrame, kDestroys, 2720, 1},
    {249, "SET_DEBUG_PORT", kDebugPort, kDebugPortTold, kConfirm, kSafe, kLater, 16},
    hidden(250, "MAVLINK_INFO", 0),
    hidden(251, "MAVLINK_DEBUG", 0),
    {253, "DEBUG_VARS_INFO_3", kFirst, kDebugInfo, kFrame, kSafe, 0, 0, true, "Debug variables, Actions (debug.list)"},
    {254, "DEBUG_VARS_3", kMasks, kData, kFrame, kSafe, 0, 0, true, "Debug variables, Actions (debug.read)"},
    {255, "ERROR", kNo, kError, kNothing, kSafe, 0, -1, true, "everywhere"},
};

/// What a command was before a firmware.
struct OlderLayout
{
    int id;
    int before;
    Fields toBoard;
    std::optional<Fields> fromBoard;
    int least;
};

// Of one command the oldest first.
constexpr OlderLayout kOlder[] = {
    {24, kLater, kSelectImuOld, kNo, 1},
    {26, 2687, kNone, kNo, 0},
    {27, 2626, kNone, kNo, 0},
    {27, 2711, kFieldOffsetOld, kNo, 0},
    {32, 2689, kNone, kNo, 0},
    {35, kLater, kAutoPidOld, kAutoPidTold, 19},
    {46, 2625, kSlotAskOld, kSlotStateOld, 2},
    {56, 2695, kAhrsAskOld, kAhrs, 1},
    {59, kLater, kCalibrationOld, kNo, 0},
    {65, kLater, kCalibrationOld, kNo, 0},
    {67, 2555, kControlOld, kConfirmed, 13},
    {69, 2738, kMenuOld, kNo, 1},
    {72, 2590, kHelperOld, kNo, 10},
    {103, kLater, kCalibrationOld, kNo, 0},
    {109, 2687, kNone, kNo, 0},
    {253, 2720, kNone, kDebugInfo, 0},
    {254, 2720, kNone, kData, 0},
};
// clang-format on

}  // namespace commandtable

std::span<const MessageSpec> messages()
{
    return commandtable::kMessages;
}

MessageSpec asOf(const MessageSpec &message, int firmware)
{
    MessageSpec older = message;
    for (const commandtable::OlderLayout &layout : commandtable::kOlder) {
        if (layout.id != message.id || firmware <= 0 || firmware >= layout.before)
            continue;
        older.toBoard = layout.toBoard;
        older.fromBoard = layout.fromBoard;
        older.least = layout.least;
        break;
    }
    return older;
}

Fields realtime4Later()
{
    return commandtable::kRealtime4Later;
}

}  // namespace simplebgc
