// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The commands themselves (document, errata 2 and 3). What is done with them: messages.cpp.
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/units.h"

namespace simplebgc {

// Many short names, which mean nothing elsewhere.
namespace commandtable {

using enum FieldType;

constexpr FieldSpec number(const char *name, FieldType type, const char *unit = "", double scale = 1,
                           std::span<const Choice> words = {})
{
    return {name, type, 1, Elements::One, unit, scale, words, {}};
}

constexpr FieldSpec word(const char *name, FieldType type, std::span<const Choice> words)
{
    return number(name, type, "", 1, words);
}

constexpr FieldSpec flags(const char *name, FieldType type, std::span<const Choice> bits)
{
    return {name, type, 1, Elements::One, "", 1, bits, {}, true};
}

constexpr FieldSpec axes(const char *name, FieldType type, const char *unit = "", double scale = 1)
{
    return {name, type, 3, Elements::Axes, unit, scale, {}, {}};
}

constexpr FieldSpec xyz(const char *name, FieldType type, const char *unit = "", double scale = 1)
{
    return {name, type, 3, Elements::Xyz, unit, scale, {}, {}};
}

// @param count 0: as often as they fit
constexpr FieldSpec list(const char *name, FieldType type, int count, const char *unit = "", double scale = 1,
                         std::span<const Choice> words = {})
{
    return {name, type, count, Elements::Numbered, unit, scale, words, {}};
}

constexpr FieldSpec bytes(const char *name, int count)
{
    return {name, Bytes, count, Elements::One, "", 1, {}, {}};
}

constexpr FieldSpec reserved(int count)
{
    return bytes("", count);
}

constexpr FieldSpec rest(const char *name)
{
    return bytes(name, 0);
}

constexpr FieldSpec text(const char *name, int size)
{
    return {name, Text, size, Elements::One, "", 1, {}, {}};
}

constexpr FieldSpec group(const char *name, std::span<const FieldSpec> inner, int count,
                          Elements elements = Elements::Numbered)
{
    return {name, Group, count, elements, "", 1, {}, inner};
}

constexpr FieldSpec perAxis(std::span<const FieldSpec> inner)
{
    return group("", inner, 3, Elements::Axes);
}

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
constexpr Choice kTune2Actions[] = {{1, "start"}, {2, "start and save"}, {3, "save"}, {5, "stop"}, {6, "read"}};
constexpr Choice kQuatModes[] = {{0, "off"}, {1, "speed"}, {2, "attitude"}, {5, "speed and attitude"}, {9, "limited speed"}};
constexpr Choice kMotorActions[] = {{1, "off, free"}, {2, "off, brake"}, {3, "off, safe"}, {4, "on"}, {5, "home"}, {6, "search home"}};
constexpr Choice kSetPoints[] = {{0, "32-bit set-point"}, {1, "16-bit parameter"}, {2, "32-bit parameter"}};
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
constexpr FieldSpec kRealtime4[] = {
    group("", kRealtime3, 1, Elements::One), axes("motor", S16, "°", kDegreesPerCount), reserved(1), axes("balance", S16),
    number("current", U16, "mA"), axes("mag", S16), number("temperature", S8, "°C"), number("frame.temperature", S8, "°C"),
    number("gravity.error", U8, "°", 0.1), number("heading.error", U8, "°", 0.1), axes("output", S16, "%", 0.01),
    word("calibration", U8, kCalibModes), number("can.error", U8), axes("actual", S16, "°", kDegreesPerCount),
    flags("state", U32, kStateFlags), reserved(18)};
constexpr FieldSpec kSelectImu[] = {word("imu", U8, kTwoImus), number("action", U8), number("time", U16, "ms"), reserved(8)};
constexpr FieldSpec kMotor[] = {word("motor", U8, kMotorNames)};
constexpr FieldSpec kFieldOffset[] = {axes("angle", S16, "°", kDegreesPerCount), axes("speed", S16, "°/s", kGyroUnit), number("flags", U16)};
constexpr FieldSpec kNames[] = {text("name1", 48), text("name2", 48), text("name3", 48), text("name4", 48), text("name5", 48)};
constexpr FieldSpec kVariable[] = {number("id", U8), number("value", S32)};
constexpr FieldSpec kVariables[] = {number("count", U8), group("variable", kVariable, 0)};
constexpr FieldSpec kVariableF[] = {number("id", U8), number("value", F32)};
constexpr FieldSpec kVariablesF[] = {number("count", U8), group("variable", kVariableF, 0)};
constexpr FieldSpec kVariableIds[] = {number("count", U8), list("id", U8, 0)};
constexpr FieldSpec kIds[] = {list("id", U8, 0)};
constexpr FieldSpec kAutoPid[] = {word("profile", U8, kProfiles), number("flags", U8), number("gain", U8), number("momentum", U8), number("action", U8), reserved(14)};
constexpr FieldSpec kTracking[] = {number("error", F32, "°"), reserved(6)};
constexpr FieldSpec kAutoPidTold[] = {
    axes("p", U8), axes("i", U8), axes("d", U8), axes("lpf", U16, "Hz"), number("iteration", U16), perAxis(kTracking), reserved(10)};
constexpr FieldSpec kServos[] = {list("servo", S16, 8, "µs")};
constexpr FieldSpec kBodeStart[] = {
    number("axis", U8), number("type", U8), number("gain", U16), number("end", U16, "Hz"), number("system", U8), number("samples", U32),
    number("mode", U8), number("start", U16, "Hz"), reserved(16)};
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
constexpr FieldSpec kAhrsAsk[] = {number("mode", U8), xyz("z", F32), xyz("h", F32), rest("more")};
constexpr FieldSpec kAhrs[] = {xyz("z", F32), xyz("h", F32)};
constexpr FieldSpec kRunScript[] = {word("mode", U8, kScriptModes), number("slot", U8), reserved(32)};
constexpr FieldSpec kScriptDebug[] = {number("command", U16), word("code", U8, kFileCodes)};
constexpr FieldSpec kCalibration[] = {word("imu", U8, kImus), word("action", U8, kCalibrations), number("time", U16, "ms"), reserved(8)};
constexpr FieldSpec kVoltage[] = {number("voltage", U16, "V", 0.01)};
constexpr FieldSpec kControlAxis[] = {number("speed", S16), number("angle", S16, "°", kDegreesPerCount)};
constexpr FieldSpec kControl[] = {axes("mode", U8), perAxis(kControlAxis)};
constexpr FieldSpec kConfirmed[] = {number("command", U8), rest("data")};
constexpr FieldSpec kMenu[] = {word("action", U8, kMenuActions), number("flags", U8)};
constexpr FieldSpec kDefaults[] = {number("scope", U8)};
constexpr FieldSpec kHelper[] = {
    xyz("acc", S16, "g", kAccUnit), number("roll", S16, "°", kDegreesPerCount), number("pitch", S16, "°", kDegreesPerCount),
    word("system", U8, kCoordinates), xyz("speed", S16, "°/s", kGyroUnit), number("heading", S16, "°", kDegreesPerCount), reserved(1)};
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
constexpr FieldSpec kAhrsDebug[] = {
    number("main.source", U8), number("frame.source", U8), list("error", U8, 4, "°", 0.1), number("status", U8), number("packets", U16),
    number("parse.errors", U16), number("heading.error", U8), number("z.error", U8), reserved(13), list("matrix", F32, 9), xyz("acc", F32)};
constexpr FieldSpec kTune2Axis[] = {
    number("flags", U8), number("gain", U8), number("stimulus", U16), number("effective", U8, "Hz"), number("problem", U8, "Hz"),
    number("margin", U8, "dB", 0.1), reserved(6)};
constexpr FieldSpec kTune2[] = {
    word("action", U8, kTune2Actions), number("command", U16), reserved(8), number("version", U8), perAxis(kTune2Axis),
    number("flags", U16), reserved(1), number("from", U8, "Hz", 0.1), number("to", U8), number("positions", U8), list("position", S8, 4, "°", 3),
    reserved(12)};
constexpr FieldSpec kMotorsOff[] = {word("how", U8, kStops)};
constexpr FieldSpec kCommandData[] = {number("command", U8), rest("data")};
constexpr FieldSpec kStateVars[] = {
    list("step", U8, 6), number("sub.error", U8), number("shock", U8, "g", 1.0 / 16), number("work", U32, "s"), number("starts", U16),
    number("current.max", U16, "mA"), list("temperature", S8, 4, "°C"), list("shocks", U8, 4), number("energy.time", U32, "s"),
    number("energy", F32, "Wh"), number("average.time", U32, "s"), number("average", F32, "A"), reserved(152)};
constexpr FieldSpec kReset[] = {number("notice", U8), number("delay", U16, "ms")};
constexpr FieldSpec kWriteSet[] = {word("action", U8, kParamsSet)};
constexpr FieldSpec kControlExt[] = {number("set", U16), rest("axes")};
constexpr FieldSpec kSync[] = {number("axis", U8), number("power", U8), number("time", U16, "ms"), number("angle", U16, "°", kDegreesPerCount)};
constexpr FieldSpec kDriver[] = {number("driver", U8), number("time", U16, "ms"), rest("data")};
constexpr FieldSpec kExtAction[] = {number("motors", U8), word("action", U8, kMotorActions)};
constexpr FieldSpec kExtControl[] = {number("motors", U8), word("set", U8, kSetPoints), rest("values")};
constexpr FieldSpec kExtConfig[] = {
    number("motors", U8), number("set", U16), number("mode", U8), number("speed", U16, "°/s", 2), number("acceleration", U16, "°/s²", 2),
    number("jerk", U16, "ms"), number("torque", U16)};
constexpr FieldSpec kExtAsk[] = {number("motors", U8), number("set", U32)};
constexpr FieldSpec kExtState[] = {number("motor", U8), number("set", U32), rest("fields")};
constexpr FieldSpec kFirst[] = {number("first", U8)};
constexpr FieldSpec kVariableInfo[] = {number("id", U8), {"name", Sized}, number("min", S16), number("max", S16), number("value", S32)};
constexpr FieldSpec kVariableInfos[] = {number("total", U8), group("variable", kVariableInfo, 0)};
constexpr FieldSpec kServoExt[] = {number("mask", U32), list("servo", S16, 0, "µs")};
constexpr FieldSpec kQuat[] = {word("mode", U8, kQuatModes), number("flags", U8), rest("values")};
constexpr FieldSpec kSet32[] = {number("set", U32)};
constexpr FieldSpec kSet32Fields[] = {number("set", U32), rest("fields")};
constexpr FieldSpec kQuatConfig[] = {number("set", U16), rest("fields")};
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
    {24, "SELECT_IMU_3", kSelectImu, kNo, kConfirm, kSafe, 0, 1, true, "Actions (imu.select)"},
    {25, "REALTIME_DATA_4", kNone, kRealtime4, kFrame, kSafe, 0, 0, true, "Monitor"},
    {26, "ENCODERS_CALIB_OFFSET_4", kMotor, kNo, kConfirm, kWrites, kLater, 0, true, "Actions (calibrate.encoder_offset)"},
    {27, "ENCODERS_CALIB_FLD_OFFSET_4", kFieldOffset, kNo, kConfirm, kWrites, kLater, 0, true, "Actions (calibrate.encoder_field)"},
    {28, "READ_PROFILE_NAMES", kNone, kNames, kFrame, kSafe, 0, 0, true, "Profiles"},
    {29, "WRITE_PROFILE_NAMES", kNames, kNo, kConfirm, kWrites, 0, 240, true, "Profiles"},
    {30, "GET_PARAMS_3", kNone, kNo, kNothing, kSafe, 0, 0},
    {31, "SET_ADJ_VARS_VAL", kVariables, kVariables, kConfirm, kMoves, 0, 1, true, "Tuning, Live variables"},
    {32, "SAVE_PARAMS_3", kIds, kNo, kConfirm, kWrites, 0, 0, true, "Tuning, Live variables"},
    {33, "READ_PARAMS_EXT", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    {34, "WRITE_PARAMS_EXT", kBlock, kNo, kConfirm, kWrites, 0, 104, true, "Parameters"},
    {35, "AUTO_PID", kAutoPid, kAutoPidTold, kConfirm, kWrites, 0, 19, true, "Auto-tune"},
    {36, "SERVO_OUT", kServos, kNo, kNothing, kMoves, 0, 16, true, "Actions (servo)"},
    {37, "BODE_TEST_START_STOP", kBodeStart, kNo, kConfirm, kMoves, kLater, 30},
    {38, "BODE_TEST_DATA", kNo, kBodeData, kNothing, kSafe, kLater},
    {39, "I2C_WRITE_REG_BUF", kI2cWrite, kNo, kConfirm, kDestroys, 0, 2, true, "Actions (i2c.write)"},
    {40, "I2C_READ_REG_BUF", kI2cRead, kData, kFrame, kWrites, 0, 3, true, "Actions (i2c.read)"},
    {41, "WRITE_EXTERNAL_DATA", kExternal, kNo, kConfirm, kWrites, 0, 128, true, "Actions (external.write)"},
    {42, "READ_EXTERNAL_DATA", kNone, kExternal, kFrame, kSafe, 0, 0, true, "Actions (external.read)"},
    {43, "READ_ADJ_VARS_CFG", kNone, kSlots, kFrame, kSafe, 0, 0, true, "Parameters"},
    {44, "WRITE_ADJ_VARS_CFG", kSlots, kNo, kConfirm, kWrites, 0, 128, true, "Parameters"},
    {45, "API_VIRT_CH_CONTROL", kChannels, kNo, kNothing, kMoves, 0, 2, true, "Actions (channel)"},
    {46, "ADJ_VARS_STATE", kSlotAsk, kSlotState, kFrame, kSafe, 0, 2, true, "Actions (slots.read)"},
    {47, "EEPROM_WRITE", kMemoryWrite, kNo, kConfirm, kDestroys, 0, 4, true, "Actions (memory.restore)"},
    {48, "EEPROM_READ", kMemoryRead, kMemoryWrite, kFrame, kSafe, 0, 6, true, "Actions (memory.save)"},
    {49, "CALIB_INFO", kCalibInfoAsk, kCalibInfo, kFrame, kSafe, kLater, 12},
    {50, "SIGN_MESSAGE", kSign, kSigned, kFrame, kSafe, kLater, 33},
    {51, "BOOT_MODE_3", kBoot, kNo, kNothing, kDestroys, 0, 0, true, "Actions (bootloader)"},
    hidden(52, "SYSTEM_STATE", 0),
    {53, "READ_FILE", kFileRead, kFileData, kFrame, kSafe, 0, 20, true, "Actions (file.save)"},
    {54, "WRITE_FILE", kFileWrite, kNo, kConfirm, kDestroys, 0, 6, true, "Actions (file.load, file.erase)"},
    {55, "FS_CLEAR_ALL", kNone, kNo, kConfirm, kDestroys, 0, 0},
    {56, "AHRS_HELPER", kAhrsAsk, kAhrs, kFrame, kMoves, 0, 1, true, "Monitor, Actions (attitude, feed)"},
    {57, "RUN_SCRIPT", kRunScript, kNo, kConfirm, kMoves, 0, 34, true, "Actions (script)"},
    {58, "SCRIPT_DEBUG", kNo, kScriptDebug, kNothing, kSafe, 0},
    {59, "CALIB_MAG", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Actions (calibrate.magnetometer)"},
    hidden(60, "UART_BYPASS"),
    {61, "GET_ANGLES_EXT", kNone, kAnglesExt, kFrame, kSafe, 0, 0, true, "Actions (angles)"},
    {62, "READ_PARAMS_EXT2", kProfile, kBlock, kFrame, kSafe, 0, 1, true, "Parameters"},
    {63, "WRITE_PARAMS_EXT2", kBlock, kNo, kConfirm, kWrites, 0, 151, true, "Parameters"},
    {64, "GET_ADJ_VARS_VAL", kVariableIds, kNo, kFrame, kSafe, 0, 1, true, "Tuning, Live variables", 31},
    {65, "CALIB_ACC", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Calibration"},
    {66, "CALIB_BAT", kVoltage, kNo, kConfirm, kWrites, 0, 2, true, "Actions (calibrate.battery)"},
    {67, "CONTROL", kControl, kConfirmed, kConfirm, kMoves, 0, 13, true, "Control"},
    {68, "REALTIME_DATA", kNone, kNo, kFrame, kSafe, 0, 0, true, "", 23},
    {69, "EXECUTE_MENU", kMenu, kNo, kConfirm, kWrites, 0, 1, true, "Control, Profiles, Actions (menu)"},
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
    {82, "READ_PARAMS", kProfile, kBlock, kFrame, kSafe, 0, 1},
    hidden(83, "MODULE_FLASH_FINISH"),
    {84, "TRIGGER_PIN", kPin, kNo, kConfirm, kMoves, 0, 2, true, "Actions (pin)"},
    {85, "DATA_STREAM_INTERVAL", kStream, kNo, kConfirm, kSafe, 2590, 21, true, "Monitor"},
    {86, "BOARD_INFO", kBoardInfoAsk, kBoardInfo, kFrame, kSafe, 0, 0, true, "connecting"},
    {87, "WRITE_PARAMS", kBlock, kNo, kConfirm, kWrites, 0, 134},
    {88, "REALTIME_DATA_CUSTOM", kCustomAsk, kCustom, kFrame, kSafe, 2590, 10, true, "Monitor"},
    {89, "BEEP_SOUND", kBeep, kNo, kNothing, kSafe, 2590, 12, true, "Actions (beep)"},
    {90, "CONTROL_CONFIG", kControlConfig, kNo, kConfirm, kMoves, kLater, 41},
    {91, "CALIB_ORIENT_CORR", kNothing16, kNo, kConfirm, kWrites, kLater, 16},
    hidden(92, "COGGING_CALIB_INFO"),
    {93, "CALIB_COGGING", kCogging, kNo, kConfirm, kWrites, kLater, 57},
    {94, "CALIB_ACC_EXT_REF", kAccReference, kNo, kConfirm, kWrites, kLater, 20},
    {95, "PROFILE_SET", kProfileSet, kNo, kConfirm, kDestroys, kLater, 10, true, "Actions (profile_set)"},
    {96, "CAN_DEVICE_SCAN", kNone, kCanDevices, kFrame, kSafe, kLater, 0},
    hidden(97, "CAN_DRV_HARD_PARAMS"),
    hidden(98, "CAN_DRV_STATE"),
    hidden(99, "CAN_DRV_CALIBRATE"),
    {100, "READ_RC_INPUTS", kRcAsk, kRcInputs, kFrame, kSafe, kLater, 3, true, "Actions (signals)"},
    hidden(101, "REALTIME_DATA_CAN_DRV"),
    {102, "EVENT", kNo, kEvent, kNothing, kSafe, 2657},
    {103, "CALIB_GYRO", kCalibration, kNo, kConfirm, kWrites, 0, 0, true, "Calibration"},
    {104, "READ_PARAMS_EXT3", kProfile, kBlock, kFrame, kSafe, kExt3Since, 1, true, "Parameters"},
    {105, "WRITE_PARAMS_EXT3", kBlock, kNo, kConfirm, kWrites, kExt3Since, 221, true, "Parameters"},
    {106, "EXT_IMU_DEBUG_INFO", kNone, kAhrsDebug, kFrame, kSafe, kLater, 0},
    hidden(107, "SET_DEVICE_ADDR"),
    {108, "AUTO_PID2", kTune2, kTune2, kConfirm, kWrites, 2730, 11},
    {109, "MOTORS_OFF", kMotorsOff, kNo, kConfirm, kSafe, 0, 0, true, "Stop motors"},
    {110, "EXT_IMU_CMD", kCommandData, kCommandData, kFrame, kDestroys, kLater, 1},
    {111, "READ_STATE_VARS", kNone, kStateVars, kFrame, kSafe, kLater, 0, true, "Actions (statistics)"},
    {112, "WRITE_STATE_VARS", kStateVars, kNo, kConfirm, kWrites, kLater, 192},
    hidden(113, "SERIAL_PROXY"),
    {114, "RESET", kReset, kNone, kFrame, kMoves, 0, 0, true, "Actions (reset)"},
    hidden(115, "IMU_ADVANCED_CALIB"),
    {116, "API_VIRT_CH_HIGH_RES", kChannels, kNo, kNothing, kMoves, 2687, 2},
    hidden(117, "CALIB_ENCODER_LUT"),
    hidden(118, "CALIB_ENCODER_LUT_RESULT"),
    {119, "WRITE_PARAMS_SET", kWriteSet, kNo, kConfirm, kWrites, 2704, 1, true, "Parameters"},
    hidden(120, "CALIB_CUR_SENS"),
    {121, "CONTROL_EXT", kControlExt, kNo, kConfirm, kMoves, 2680, 2},
    {123, "SYNC_MOTORS", kSync, kNo, kConfirm, kMoves, kLater, 6},
    {127, "CAN_DRV_TELEMETRY", kNo, kDriver, kNothing, kSafe, 2720},
    {128, "EXT_MOTORS_ACTION", kExtAction, kNo, kConfirm, kMoves, 2730, 2},
    {129, "EXT_MOTORS_CONTROL", kExtControl, kNo, kConfirm, kMoves, 2730, 2},
    {130, "EXT_MOTORS_CONTROL_CONFIG", kExtConfig, kNo, kConfirm, kMoves, 2730, 3},
    {131, "EXT_MOTORS_STATE", kExtAsk, kExtState, kFrame, kSafe, 2730, 5},
    {132, "ADJ_VARS_INFO", kFirst, kVariableInfos, kFrame, kSafe, kLater, 0},
    {133, "SERVO_OUT_EXT", kServoExt, kNo, kNothing, kMoves, 2732, 4},
    {134, "SET_ADJ_VARS_VAL_F", kVariablesF, kVariablesF, kConfirm, kMoves, 2734, 1},
    {135, "GET_ADJ_VARS_VAL_F", kVariableIds, kNo, kFrame, kSafe, 2734, 1, true, "", 134},
    hidden(136, "PASS_PROTECT_READ"),
    hidden(137, "PASS_PROTECT_WRITE"),
    {139, "REALTIME_DATA_CUSTOM2", kCustomAsk, kCustom, kFrame, kSafe, 2740, 10},
    {140, "CONTROL_QUAT", kQuat, kNo, kConfirm, kMoves, 2730, 2},
    {141, "CONTROL_QUAT_STATUS", kSet32, kSet32Fields, kFrame, kSafe, 2730, 4},
    {142, "CONTROL_QUAT_CONFIG", kQuatConfig, kNo, kConfirm, kMoves, 2730, 2},
    hidden(143, "SET_TRANSP_PROXY"),
    hidden(144, "UDRV_DEVICE_SCAN"),
    {150, "EXT_SENS_CMD", kSensorCommand, kCommandData, kFrame, kDestroys, 2687, 2},
    {151, "TRANSPARENT_SAPI", kTransparent, kData, kFrame, kDestroys, 2720, 1},
    {249, "SET_DEBUG_PORT", kDebugPort, kDebugPortTold, kConfirm, kSafe, kLater, 16},
    hidden(250, "MAVLINK_INFO", 0),
    hidden(251, "MAVLINK_DEBUG", 0),
    {253, "DEBUG_VARS_INFO_3", kFirst, kDebugInfo, kFrame, kSafe, 0, 0, true, "Debug variables"},
    {254, "DEBUG_VARS_3", kMasks, kData, kFrame, kSafe, 0, 0, true, "Debug variables"},
    {255, "ERROR", kNo, kError, kNothing, kSafe, 0},
};
// clang-format on

}  // namespace commandtable

std::span<const MessageSpec> messages()
{
    return commandtable::kMessages;
}

}  // namespace simplebgc
