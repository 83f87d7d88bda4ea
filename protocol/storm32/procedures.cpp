// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/procedures.h"

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr Choice kImus[] = {{1, "Imu"}, {2, "Imu2"}};
constexpr ArgumentSpec kImu{
    .key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImus, .defaultText = "Imu"};
constexpr ArgumentSpec kAverage[]
    = {kImu, {.key = "readings", .label = "Readings", .min = 16, .max = 2048, .defaultText = "256"}};
constexpr ArgumentSpec kCalibrate[] = {
    kImu, {.key = "store", .label = "Store the result", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
// clang-format off
constexpr ArgumentSpec kWrite[] = {kImu,
    {.key = "zero.x", .label = "Zero X", .min = -32768, .max = 32767}, {.key = "zero.y", .label = "Zero Y", .min = -32768, .max = 32767},
    {.key = "zero.z", .label = "Zero Z", .min = -32768, .max = 32767}, {.key = "scale.x", .label = "Scale X", .min = 1, .max = 32767},
    {.key = "scale.y", .label = "Scale Y", .min = 1, .max = 32767}, {.key = "scale.z", .label = "Scale Z", .min = 1, .max = 32767}};
// clang-format on
constexpr ArgumentSpec kOffset[]
    = {{.key = "angle", .label = "Angle", .kind = ArgumentKind::Real, .min = -45, .max = 45, .unit = "°"}};
constexpr ArgumentSpec kTake[]
    = {{.key = "take", .label = "Take the position over", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
// clang-format off
constexpr ArgumentSpec kTakeMotors[] = {{.key = "directions", .label = "Directions", .kind = ArgumentKind::Toggle, .defaultText = "on"},
                                        {.key = "positions", .label = "Start positions", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kPoles[] = {{.key = "pitch", .label = "Pitch", .min = 12, .max = 28, .defaultText = "14"},
                                   {.key = "roll", .label = "Roll", .min = 12, .max = 28, .defaultText = "14"},
                                   {.key = "yaw", .label = "Yaw", .min = 12, .max = 28, .defaultText = "14"}};
// clang-format on
constexpr Choice kDirectionChoices[] = {{0, "normal"}, {1, "reversed"}, {2, "auto"}};
// clang-format off
constexpr ArgumentSpec kAllDirections[] = {{.key = "direction", .label = "Direction of all motors", .kind = ArgumentKind::Choice,
                                         .choices = kDirectionChoices, .defaultText = "auto"}};
// clang-format on

constexpr ReplyUnit kYawUnits[] = {{"angle", "°"}};
constexpr ReplyUnit kReadingUnits[] = {{"temperature", "°C"}, {"quality", "g"}};

constexpr ActionSpec kProcedures[] = {
    {.key = "sensors.average",
     .label = "Average of a sensor",
     .help = "What an accelerometer shows over many readings, in counts.",
     .group = "Read",
     .arguments = kAverage,
     .isProcedure = true,
     .units = kReadingUnits},
    {.key = "stored.compare",
     .label = "Compare with what is stored",
     .help = "Reloads what is stored for a moment, puts what is in use back and tells what differs.",
     .group = "Memory",
     .risk = ActionRisk::Writes},
    {.key = "calibrate.level",
     .label = "Calibrate an accelerometer, one position",
     .help = "Finds its zeros while it lies still on one face. Do it with the motors off, on USB power.",
     .group = "Calibration",
     .risk = ActionRisk::Writes,
     .arguments = kCalibrate,
     .isProcedure = true,
     .units = kReadingUnits},
    {.key = "calibrate.six",
     .label = "Calibrate an accelerometer, six positions",
     .help = "Finds zeros and scales; each face has to lie up once. Switches the motors off and leaves them "
             "off: hold the camera.",
     .group = "Calibration",
     .risk = ActionRisk::Writes,
     .arguments = kCalibrate,
     .isProcedure = true,
     .units = kReadingUnits,
     .letsGo = true},
    {.key = "calibration.write",
     .label = "Write a calibration",
     .help = "Zeros and scales of one accelerometer; stored at once.",
     .group = "Calibration",
     .risk = ActionRisk::Writes,
     .arguments = kWrite},
    {.key = "setup.motors_off",
     .label = "Set up: disable the motors",
     .help = "All three motor usages become disabled; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .memory = MemoryEffect::ChangesInUse,
     .switchesMotors = true},
    {.key = "setup.orientation",
     .label = "Set up: find the orientation of the sensors",
     .help = "Hold the camera level, then tilt it 45° down. Sets the orientation of each sensor; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .isProcedure = true,
     .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.poles",
     .label = "Set up: poles of the motors",
     .help = "Magnets in the bells, even numbers; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .arguments = kPoles,
     .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.directions",
     .label = "Set up: direction of all motors",
     .help = "Auto lets the board find it at the next start; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .arguments = kAllDirections,
     .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.start",
     .label = "Set up: enable the motors and start",
     .help = "Waits for the battery, starts the board and waits until it works normally.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .isProcedure = true,
     .memory = MemoryEffect::ChangesInUse,
     .switchesMotors = true},
    {.key = "setup.take_motors",
     .label = "Set up: take directions and start positions",
     .help = "Copies what the board has found and where the motors stand; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Writes,
     .arguments = kTakeMotors,
     .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.yaw_begin",
     .label = "Set up: begin to align yaw",
     .help = "Steers yaw by its offset only.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Moves,
     .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.yaw_move",
     .label = "Set up: turn yaw",
     .help = "Turns the camera to this angle.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Moves,
     .arguments = kOffset,
     .memory = MemoryEffect::ChangesInUse,
     .units = kYawUnits},
    {.key = "setup.yaw_end",
     .label = "Set up: end aligning yaw",
     .help = "Takes where yaw stands as its start position; in RAM.",
     .group = "Gimbal configuration",
     .risk = ActionRisk::Moves,
     .arguments = kTake,
     .memory = MemoryEffect::ChangesInUse},
};

}  // namespace

std::span<const ActionSpec> Procedures::all()
{
    return kProcedures;
}

// No command reads the EEPROM without changing the RAM: the stored values are loaded and read, then the
// values in use are restored.
Result<ActionReply> Procedures::compareStored()
{
    const auto both = m_device.readBoth(m_channel);
    if (!both)
        return tl::unexpected(both.error());
    const auto &[use, kept] = *both;
    ActionReply reply{{u"unstored"_s, kept.blocks() != use.blocks()}};
    for (const ParameterChange &change : kept.changesTo(use))
        reply.insert(
            change.spec->key,
            u"%1 in use, %2 stored"_s.arg(change.spec->format(change.to), change.spec->format(change.from)));
    for (const DataChange &change : kept.dataChangesTo(use))
        reply.insert(QLatin1String(change.spec->data), u"not stored"_s);
    return reply;
}

Result<ActionReply> Procedures::perform(const QString &key, const QVariantMap &arguments)
{
    const int imu = arguments.value(u"imu"_s).toInt();
    const auto nothing = [](const Result<void> &done) {
        return done ? Result<ActionReply>(ActionReply()) : tl::unexpected(done.error());
    };
    if (key == u"sensors.average"_s)
        return averaged(imu, arguments.value(u"readings"_s).toInt());
    if (key == u"stored.compare"_s)
        return compareStored();
    if (key == u"calibrate.level"_s || key == u"calibrate.six"_s)
        return calibrate(imu, key == u"calibrate.six"_s, arguments.value(u"store"_s).toBool());
    if (key == u"calibration.write"_s) {
        AccCalibration calibration;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            calibration.zero[axis]
                = arguments.value(u"zero.%1"_s.arg(QLatin1String(kSensorAxes[axis]))).toInt();
            calibration.scale[axis]
                = arguments.value(u"scale.%1"_s.arg(QLatin1String(kSensorAxes[axis]))).toInt();
        }
        if (const auto checked = checkPlausible(calibration); !checked)
            return tl::unexpected(checked.error());
        return nothing(writeCalibration(imu, calibration));
    }
    if (key == u"setup.motors_off"_s)
        return nothing(disableMotors());
    if (key == u"setup.orientation"_s)
        return findOrientation();
    if (key == u"setup.directions"_s)
        return nothing(setDirections(arguments.value(u"direction"_s).toInt()));
    if (key == u"setup.poles"_s)
        return setPoles({arguments.value(u"pitch"_s).toInt(), arguments.value(u"roll"_s).toInt(),
                         arguments.value(u"yaw"_s).toInt()});
    if (key == u"setup.start"_s)
        return restartAndWait();
    if (key == u"setup.take_motors"_s)
        return takeMotors(arguments.value(u"directions"_s).toBool(),
                          arguments.value(u"positions"_s).toBool());
    if (key == u"setup.yaw_begin"_s)
        return beginYaw();
    if (key == u"setup.yaw_move"_s)
        return moveYaw(arguments.value(u"angle"_s).toDouble());
    if (key == u"setup.yaw_end"_s)
        return endYaw(arguments.value(u"take"_s).toBool());
    return failure(ErrorCode::Unsupported, key);
}

}  // namespace storm32
