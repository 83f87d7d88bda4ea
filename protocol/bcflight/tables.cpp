// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/tables.h"

#include "protocol/bcflight/luacheck.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/messages.h"
#include "protocol/bcflight/transmitter.h"
#include "protocol/configuration/configuration.h"

namespace bcflight {

namespace {

// What is in use is the number of the text times its scale (errata 7.2).
std::optional<double> gainInText(const Configuration &configuration, const ParameterSpec &spec, double raw)
{
    const QByteArray text = configuration.block({0, ConfigurationText});
    if (text.isEmpty())
        return {};
    const auto scales = findScales(text);
    const double scale = scales ? (*scales)[std::size_t(spec.adjustable % 3)] : 0;
    return scale != 0 ? std::optional(figureFor(float(raw), scale)) : std::nullopt;
}

// One of three numbers times its scale, as the drone computes it.
std::optional<double> gainAtStart(const Configuration &configuration, const ParameterSpec &spec)
{
    const QByteArray text = configuration.block({0, ConfigurationText});
    const auto axis = std::size_t(spec.adjustable / 3);
    if (text.isEmpty() || axis >= kGainNames.size())
        return {};
    const auto scales = findScales(text);
    const auto gains = findGains(text, QString::fromLatin1(kGainNames[axis]));
    if (!scales || !gains)
        return {};
    const auto term = std::size_t(spec.adjustable % 3);
    const float gain = float((*gains)[term].value * (*scales)[term]);
    const auto used = configuration.raw(spec, 0);
    return used && isSameGain(float(*used), gain) ? *used : double(gain);
}

// clang-format off
constexpr const char *kRateGroup = "Rate controller";
constexpr const char *kHorizonGroup = "Horizon";

// The drone accepts gains of either sign up to 1 (errata 7.2). A negative one turns each correction into its opposite, so none can be
// entered here; one that the drone holds is shown and kept.
constexpr ParameterRow kParameters[] = {
    {.key = "pid.%a.p", .label = "P", .group = kRateGroup, .help = "How hard the motors work against an error of the rate. In the drone's own numbers: the value of the configuration text times its scale.",
     .block = Gains, .offset = 0, .wire = WireType::F32, .order = ByteOrder::Big, .axes = 3, .axisStride = 12, .min = 0, .max = 1, .decimals = 8,
     .level = ViewLevel::Basic, .scope = Scope::Board, .risk = Risk::Red, .adjustable = 0, .adjustableStride = 3, .textFigure = gainInText, .startsWith = gainAtStart},
    {.key = "pid.%a.i", .label = "I", .group = kRateGroup, .help = "How hard they work against an error that stays. In the drone's own numbers.",
     .block = Gains, .offset = 4, .wire = WireType::F32, .order = ByteOrder::Big, .axes = 3, .axisStride = 12, .min = 0, .max = 1, .decimals = 8,
     .level = ViewLevel::Basic, .scope = Scope::Board, .risk = Risk::Red, .adjustable = 1, .adjustableStride = 3, .textFigure = gainInText, .startsWith = gainAtStart},
    {.key = "pid.%a.d", .label = "D", .group = kRateGroup, .help = "How hard they work against a change of the rate. In the drone's own numbers.",
     .block = Gains, .offset = 8, .wire = WireType::F32, .order = ByteOrder::Big, .axes = 3, .axisStride = 12, .min = 0, .max = 1, .decimals = 8,
     .level = ViewLevel::Basic, .scope = Scope::Board, .risk = Risk::Red, .adjustable = 2, .adjustableStride = 3, .textFigure = gainInText, .startsWith = gainAtStart},
    {.key = "horizon.%a.offset", .label = "Offset", .group = kHorizonGroup, .help = "What the drone takes for level is turned by this. It forgets it when it restarts.",
     .block = Gains, .offset = 4 * kRateGains, .wire = WireType::F32, .order = ByteOrder::Big, .axes = 2, .axisStride = 4, .unit = "°", .min = -45, .max = 45, .decimals = 2,
     .level = ViewLevel::Basic, .scope = Scope::Board, .risk = Risk::Red, .adjustable = kRateGains, .adjustableStride = 1},
    {.key = "outer.p", .label = "Outer P", .group = kHorizonGroup, .help = "The drone confirms these gains, and does not apply them: today's firmware always reports 0. They stand in the configuration text.",
     .block = Gains, .offset = 4 * (kRateGains + kOffsets), .wire = WireType::F32, .order = ByteOrder::Big, .min = -50, .max = 50, .decimals = 4, .level = ViewLevel::Expert, .scope = Scope::Board, .state = true},
    {.key = "outer.i", .label = "Outer I", .group = kHorizonGroup, .help = "Confirmed by the drone, and not applied.",
     .block = Gains, .offset = 4 * (kRateGains + kOffsets + 1), .wire = WireType::F32, .order = ByteOrder::Big, .min = -50, .max = 50, .decimals = 4, .level = ViewLevel::Expert, .scope = Scope::Board, .state = true},
    {.key = "outer.d", .label = "Outer D", .group = kHorizonGroup, .help = "Confirmed by the drone, and not applied.",
     .block = Gains, .offset = 4 * (kRateGains + kOffsets + 2), .wire = WireType::F32, .order = ByteOrder::Big, .min = -50, .max = 50, .decimals = 4, .level = ViewLevel::Expert, .scope = Scope::Board, .state = true},
};
static_assert(rangesFit(kParameters));
static_assert(coversBlock<kGainsSize>(kParameters, Gains, {}));

constexpr BlockSpec kBlocks[] = {
    {.id = Gains, .name = "GAINS", .size = kGainsSize, .effect = WriteEffect::Volatile},
    {.id = ConfigurationText, .name = "CONFIG_FILE", .data = "Configuration text", .maxSize = kLargestText, .kind = DataKind::Text, .language = "lua",
     .effect = WriteEffect::Restarts, .restartTime = 30s, .check = findMistake},
};

constexpr Choice kNoYes[] = {{0, "no"}, {1, "yes"}};
constexpr Choice kStateBits[] = {{0, "armed"}, {1, "calibrated"}, {2, "calibrating"}, {7, "night mode"}};
constexpr ChannelSpec kChannels[] = {
    {"attitude.roll", "Roll", "Attitude", "°", 1, Axis::Roll, -180, 180, "attitude.roll"},
    {"attitude.pitch", "Pitch", "Attitude", "°", 1, Axis::Pitch, -90, 90, "attitude.pitch"},
    {"attitude.yaw", "Yaw", "Attitude", "°", 1, Axis::Yaw, -180, 180, "attitude.yaw"},
    {"rate.roll", "Roll rate", "Rates", "°/s", 1, Axis::Roll, -300, 300, "rate.roll"},
    {"rate.pitch", "Pitch rate", "Rates", "°/s", 1, Axis::Pitch, -300, 300, "rate.pitch"},
    {"rate.yaw", "Yaw rate", "Rates", "°/s", 1, Axis::Yaw, -300, 300, "rate.yaw"},
    {"gyro.x", "Gyro x", "Sensors", "°/s", 1, Axis::Roll, -300, 300},
    {"gyro.y", "Gyro y", "Sensors", "°/s", 1, Axis::Pitch, -300, 300},
    {"gyro.z", "Gyro z", "Sensors", "°/s", 1, Axis::Yaw, -300, 300},
    {"acc.x", "Acceleration x", "Sensors", "m/s²", 2, Axis::Roll, -20, 20, "acceleration.x"},
    {"acc.y", "Acceleration y", "Sensors", "m/s²", 2, Axis::Pitch, -20, 20, "acceleration.y"},
    {"acc.z", "Acceleration z", "Sensors", "m/s²", 2, Axis::Yaw, -20, 20, "acceleration.z"},
    {"magnetometer.x", "Magnetometer x", "Sensors", "", 1, Axis::Roll, -100, 100},
    {"magnetometer.y", "Magnetometer y", "Sensors", "", 1, Axis::Pitch, -100, 100},
    {"magnetometer.z", "Magnetometer z", "Sensors", "", 1, Axis::Yaw, -100, 100},
    {"rate.slow.roll", "Roll rate for D", "Rates", "°/s", 1, Axis::Roll, -300, 300},
    {"rate.slow.pitch", "Pitch rate for D", "Rates", "°/s", 1, Axis::Pitch, -300, 300},
    {"rate.slow.yaw", "Yaw rate for D", "Rates", "°/s", 1, Axis::Yaw, -300, 300},
    {"acc.length", "Acceleration", "Sensors", "m/s²", 2, Axis::None, 0, 20},
    {"height", "Height", "Attitude", "m", 1, Axis::None, 0, 100},
    {"thrust", "Thrust", "Motors", "", 3, Axis::None, 0, 1},
    {"motor.1", "Motor 1", "Motors", "%", 1, Axis::None, 0, 100, "motor.1.output"},
    {"motor.2", "Motor 2", "Motors", "%", 1, Axis::None, 0, 100, "motor.2.output"},
    {"motor.3", "Motor 3", "Motors", "%", 1, Axis::None, 0, 100, "motor.3.output"},
    {"motor.4", "Motor 4", "Motors", "%", 1, Axis::None, 0, 100, "motor.4.output"},
    {"motor.5", "Motor 5", "Motors", "%", 1, Axis::None, 0, 100, "", "hexacopter"},
    {"motor.6", "Motor 6", "Motors", "%", 1, Axis::None, 0, 100, "", "hexacopter"},
    {"motor.7", "Motor 7", "Motors", "%", 1, Axis::None, 0, 100, "", "octocopter"},
    {"motor.8", "Motor 8", "Motors", "%", 1, Axis::None, 0, 100, "", "octocopter"},
    {"battery", "Battery", "State", "V", 2, Axis::None, 0, 30, "battery"},
    {"battery.charge", "Charge drawn", "State", "mAh", 0, Axis::None, 0, 5000, "battery.charge"},
    {"battery.current", "Current", "State", "A", 1, Axis::None, 0, 60, "current"},
    {"battery.level", "Battery level", "State", "%", 0, Axis::None, 0, 100, "battery.level"},
    {"cpu.load", "Processor load", "State", "%", 0, Axis::None, 0, 100, "cpu.load"},
    {"cpu.temperature", "Processor temperature", "State", "°C", 0, Axis::None, 0, 100, "cpu.temperature"},
    {"rx.quality", "Receive quality", "Link", "%", 0, Axis::None, 0, 100, "rx.quality"},
    {"rx.level", "Receive level", "Link", "dBm", 0, Axis::None, -120, 0, "rx.level"},
    {"link.round_trip", "Round trip", "Link", "ms", 0, Axis::None, 0, 200},
    {"loops", "Control loop", "State", "/s", 0, Axis::None, 0, 10000, "loops"},
    {"state", "State", "State", "", 0, Axis::None, 0, 255, "state", "", 1, kStateBits, true},
    {"armed", "Armed", "State", "", 0, Axis::None, 0, 1, "armed", "", 1, kNoYes},
    {"calibrated", "Calibrated", "State", "", 0, Axis::None, 0, 1, "calibrated", "", 1, kNoYes},
    {"calibrating", "Calibrating", "State", "", 0, Axis::None, 0, 1, "calibrating", "", 1, kNoYes},
    {"outputs", "Motors driven", "State", "", 0, Axis::None, 0, 1, "outputs", "", 1, kNoYes},
    {.key = "spectrum.roll", .label = "Notch spectrum roll", .group = "Spectrum", .unit = "°/s", .decimals = 3, .axis = Axis::Roll, .max = 10, .role = "spectrum.roll", .elements = kSpectrumBins},
    {.key = "spectrum.pitch", .label = "Notch spectrum pitch", .group = "Spectrum", .unit = "°/s", .decimals = 3, .axis = Axis::Pitch, .max = 10, .role = "spectrum.pitch", .elements = kSpectrumBins},
    {.key = "spectrum.yaw", .label = "Notch spectrum yaw", .group = "Spectrum", .unit = "°/s", .decimals = 3, .axis = Axis::Yaw, .max = 10, .role = "spectrum.yaw", .elements = kSpectrumBins},
    {"battery.cells", "Battery cells", "State", "", 0, Axis::None, 0, 12, "battery.cells"},
};
static_assert(std::size(kChannels) == ChannelCount);

constexpr Choice kModes[] = {{0, "rate"}, {1, "stabilised"}};
constexpr auto kBandChoices = [] {
    std::array<Choice, kTransmitterBands.size()> choices{};
    for (std::size_t band = 0; band < choices.size(); ++band)
        choices[band] = {int(band), kTransmitterBands[band].name};
    return choices;
}();
constexpr Choice kStepChoices[] = {{0, "brightness.up"}, {1, "brightness.down"}, {2, "contrast.up"}, {3, "contrast.down"}, {4, "saturation.up"},
                             {5, "saturation.down"}, {6, "iso.up"}, {7, "iso.down"}, {8, "shutter.up"}, {9, "shutter.down"}};
constexpr ArgumentSpec kModeChoice[] = {{.key = "mode", .label = "Mode", .kind = ArgumentKind::Choice, .choices = kModes}};
constexpr ArgumentSpec kOn[] = {{.key = "on", .label = "On", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
// How many it has the drone tells (Device::testMotor()).
constexpr ArgumentSpec kMotorNumber[] = {{.key = "motor", .label = "Motor", .kind = ArgumentKind::Integer, .min = 1, .max = 99}};
constexpr ArgumentSpec kChannelNumber[] = {{.key = "band", .label = "Band", .kind = ArgumentKind::Choice, .choices = kBandChoices},
                                           {.key = "channel", .label = "Channel", .kind = ArgumentKind::Integer, .min = 1, .max = kBandChannels}};
constexpr ArgumentSpec kPowerNumber[] = {{.key = "power", .label = "Power", .kind = ArgumentKind::Integer, .min = 1, .max = 8}};
constexpr ArgumentSpec kStep[] = {{.key = "step", .label = "Step", .kind = ArgumentKind::Choice, .choices = kStepChoices}};
constexpr ArgumentSpec kFirmwareFile[] = {{.key = "file", .label = "File", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kLens[] = {
    {.key = "red.base", .label = "Red, base", .kind = ArgumentKind::Integer, .max = 255}, {.key = "red.radius", .label = "Red, radius", .kind = ArgumentKind::Integer, .max = 255},
    {.key = "red.strength", .label = "Red, strength", .kind = ArgumentKind::Integer, .min = -128, .max = 127},
    {.key = "green.base", .label = "Green, base", .kind = ArgumentKind::Integer, .max = 255}, {.key = "green.radius", .label = "Green, radius", .kind = ArgumentKind::Integer, .max = 255},
    {.key = "green.strength", .label = "Green, strength", .kind = ArgumentKind::Integer, .min = -128, .max = 127},
    {.key = "blue.base", .label = "Blue, base", .kind = ArgumentKind::Integer, .max = 255}, {.key = "blue.radius", .label = "Blue, radius", .kind = ArgumentKind::Integer, .max = 255},
    {.key = "blue.strength", .label = "Blue, strength", .kind = ArgumentKind::Integer, .min = -128, .max = 127}};
constexpr Condition kDisarmed[] = {Condition::Disarmed};
constexpr Condition kForMotors[] = {Condition::Disarmed, Condition::Calibrated};
constexpr ReplyUnit kUnits[] = {{"voltage", "V"}, {"charge", "mAh"}, {"current", "A"}, {"level", "%"}, {"quality", "%"}, {"load", "%"}, {"temperature", "°C"},
                                {"dbm", "dBm"}, {"frequency", "MHz"}};
constexpr const char *kPropellers = "The propellers are off";
constexpr int kFrom = int(Generation::F);

// What is not confirmed, or confirmed with a constant, proves nothing (errata 6): answered and isShown say so.
constexpr ActionSpec kActions[] = {
    {.key = "status", .label = "Status", .help = "Armed, calibrated, battery, link.", .group = "Drone", .units = kUnits},
    {.key = "motors.off", .label = "Stop motors", .help = "Disarms and stops all motors, in flight as well: it falls.", .group = "Drone", .stopsMotors = true},
    {.key = "calibrate.gyro", .label = "Calibrate gyroscope", .help = "Let it lie still. A drone without a full calibration does that one instead.", .group = "Sensors", .risk = ActionRisk::Writes,
     .isProcedure = true, .since = kFrom, .needs = kDisarmed},
    {.key = "calibrate.all", .label = "Calibrate all sensors", .help = "Let it lie level and still.", .group = "Sensors", .risk = ActionRisk::Writes, .isProcedure = true, .since = kFrom, .needs = kDisarmed},
    {.key = "mode", .label = "Flight mode", .help = "Stabilised also starts the attitude anew.", .group = "Drone", .risk = ActionRisk::Writes, .arguments = kModeChoice, .since = kFrom, .needs = kDisarmed, .isShown = false},
    {.key = "gains.store", .label = "Store gains", .help = "Writes the gains in use into the configuration text, one number each, and uploads it: the drone restarts.",
     .group = "Configuration", .risk = ActionRisk::Writes, .isProcedure = true, .since = kFrom, .memory = MemoryEffect::Stores, .needs = kDisarmed, .provesStore = true},
    {.key = "motors.beep", .label = "Beep with the motors", .help = "Until it is switched off.", .group = "Test bench", .risk = ActionRisk::Moves, .arguments = kOn, .since = kFrom, .needs = kDisarmed, .isShown = false},
    {.key = "motor.test", .label = "Turn one motor", .help = "At 5 % for 5 s. The drone hears nothing for 8 s, also no stop.", .group = "Test bench", .risk = ActionRisk::Moves, .arguments = kMotorNumber,
     .isProcedure = true, .since = kFrom, .needs = kForMotors, .confirm = kPropellers, .silence = 9s, .isShown = false},
    {.key = "escs.calibrate", .label = "Calibrate motor controllers", .help = "All motors get full throttle for 8 s. The drone hears nothing for 26 s, also no stop.", .group = "Test bench", .risk = ActionRisk::Moves,
     .isProcedure = true, .since = kFrom, .needs = kForMotors, .confirm = kPropellers, .silence = 28s, .isShown = false},
    {.key = "battery.reset", .label = "New battery", .help = "Counts the charge from 0 and the cells anew.", .group = "Drone", .risk = ActionRisk::Writes, .since = kFrom, .needs = kDisarmed, .isShown = false},
    {.key = "clock", .label = "Set clock", .help = "To the time of this computer.", .group = "Drone", .risk = ActionRisk::Writes, .since = kFrom, .needs = kDisarmed, .isShown = false},
    {.key = "telemetry.full", .label = "Full telemetry", .help = "Attitude and sensors in each packet.", .group = "Drone", .arguments = kOn, .since = kFrom, .answered = false},
    {.key = "vtx", .label = "Video transmitter", .help = "Channel and power.", .group = "Video transmitter", .since = kFrom, .units = kUnits},
    {.key = "vtx.channel", .label = "Set channel", .help = "Band and channel.", .group = "Video transmitter", .risk = ActionRisk::Writes, .arguments = kChannelNumber, .since = kFrom, .needs = kDisarmed, .units = kUnits},
    {.key = "vtx.power", .label = "Set power", .help = "A step of its own table, from 1.", .group = "Video transmitter", .risk = ActionRisk::Writes, .arguments = kPowerNumber, .since = kFrom, .needs = kDisarmed, .units = kUnits},
    {.key = "camera", .label = "Camera settings", .help = "Sensitivity and shutter.", .group = "Camera", .since = kFrom},
    {.key = "camera.step", .label = "Change the picture", .help = "By one step; what it is cannot be read. Today's driver does nothing for the shutter.", .group = "Camera", .arguments = kStep, .since = kFrom, .answered = false},
    {.key = "camera.white_balance", .label = "Next white balance", .help = "Switches to the next one and tells which.", .group = "Camera", .since = kFrom},
    {.key = "camera.lock", .label = "Lock white balance", .help = "Keeps the present one.", .group = "Camera", .since = kFrom},
    {.key = "camera.exposure", .label = "Next exposure mode", .help = "Switches to the next one and tells which. Today's driver tells nothing.", .group = "Camera", .since = kFrom},
    {.key = "camera.night", .label = "Night mode", .help = "Runs the drone's own script for it, if there is one. The drone repeats what it was told, which proves nothing.", .group = "Camera", .arguments = kOn, .since = kFrom, .isShown = false},
    {.key = "camera.record", .label = "Record on the drone", .help = "The drone confirms whatever it does.", .group = "Camera", .arguments = kOn, .since = kFrom, .isShown = false},
    {.key = "camera.picture", .label = "Take a picture on the drone", .help = "Today's driver does nothing.", .group = "Camera", .since = kFrom, .answered = false},
    {.key = "camera.lens", .label = "Lens shading", .help = "What today's driver tells means nothing.", .group = "Camera", .since = kFrom},
    {.key = "camera.lens.set", .label = "Set lens shading", .help = "Base and strength count in 32nds. Kept only if all six of them are other than 0. Today's driver does nothing.", .group = "Camera", .arguments = kLens, .since = kFrom, .answered = false},
    {.key = "recordings", .label = "Recordings", .help = "Names and sizes of what the drone has recorded.", .group = "Camera", .since = kFrom},
    {.key = "firmware.upload", .label = "Upload firmware", .help = "Replaces the drone's program by a file, and restarts it. Broken off, its stream is silent until it is switched off and on.", .group = "System", .risk = ActionRisk::Destroys,
     .arguments = kFirmwareFile, .isProcedure = true, .since = kFrom, .memory = MemoryEffect::Reloads, .needs = kDisarmed, .confirm = "The file was made for this drone, and its battery lasts"},
    {.key = "board", .label = "Board", .help = "What the drone tells of its board.", .group = "System", .since = kFrom},
    {.key = "sensors", .label = "Sensors", .help = "What the drone tells of its sensors.", .group = "System", .since = kFrom},
    {.key = "cameras", .label = "Cameras", .help = "What the drone tells of its cameras.", .group = "System", .since = kFrom},
};
// clang-format on

}  // namespace

std::span<const ParameterRow> parameterRows()
{
    return kParameters;
}

std::span<const BlockSpec> blocks()
{
    return kBlocks;
}

ChannelTable channels()
{
    return kChannels;
}

std::span<const ActionSpec> actions()
{
    return kActions;
}

}  // namespace bcflight
