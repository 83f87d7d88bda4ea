// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setupstep.h"

#include "protocol/device/device.h"
#include "protocol/procedure/motiontest.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// clang-format off
constexpr Choice kChemistries[] = {{0, "lipo"}, {1, "liion"}};
constexpr Choice kUses[] = {{0, "handheld"}, {1, "drone"}, {2, "vehicle"}, {3, "tripod"}};

constexpr ArgumentSpec kPowerArguments[] = {
    {.key = "cells", .label = "Cells of the battery (0 = find out)", .kind = ArgumentKind::Integer, .min = 0, .max = 14, .defaultText = "0"},
    {.key = "chemistry", .label = "Kind of battery", .kind = ArgumentKind::Choice, .choices = kChemistries, .defaultText = "lipo"}};
constexpr ArgumentSpec kGainArguments[] = {
    {.key = "search", .label = "Let the board search its gains (off: measure those that it has)", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kLimitArguments[] = {
    {.key = "seconds", .label = "Time for moving it", .kind = ArgumentKind::Real, .min = 5, .max = 120, .unit = "s", .defaultText = "20"},
    {.key = "margin", .label = "Margin at each end", .kind = ArgumentKind::Real, .min = 0, .max = 20, .unit = "°", .defaultText = "3"}};
constexpr ArgumentSpec kVibrationArguments[] = {
    {.key = "try", .label = "Try a notch where a line stands out", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kRemoteArguments[] = {
    {.key = "roll", .label = "A stick for roll", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "pitch", .label = "A stick for pitch", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "yaw", .label = "A stick for yaw", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "command", .label = "A switch for commands", .kind = ArgumentKind::Toggle, .defaultText = "off"}};
constexpr ArgumentSpec kUseArguments[] = {
    {.key = "use", .label = "What the gimbal is for", .kind = ArgumentKind::Choice, .choices = kUses, .defaultText = "handheld"},
    {.key = "apply", .label = "Write the values (off: only show what would change)", .kind = ArgumentKind::Toggle, .defaultText = "off"}};

constexpr SetupStepSpec kSteps[] = {
    {SetupStep::Power,
     {.key = "power", .label = "Battery", .help = "Measures the voltage, finds how many cells the battery has, and sets the alarm and the voltage below which motors are switched off.",
      .risk = ActionRisk::Writes, .arguments = kPowerArguments},
     "The battery that the gimbal is used with is connected, and full or nearly so. Where the gimbal runs wild, its motors are stopped first.", "parameters"},
    {SetupStep::Sensors,
     {.key = "sensors", .label = "Sensors found", .help = "Listens to the sensors that the board tells of, on the camera, on the frame, and at the motors, and says which of them measure."},
     "The camera lies or hangs still.", "calibration"},
    {SetupStep::Gyroscope,
     {.key = "gyroscope", .label = "Gyroscope", .help = "Measures the zero of the sensor of turn rate, and compares it with before.", .risk = ActionRisk::Writes,
      .confirm = "The camera lies or is held: its motors may let go"},
     "The camera lies or hangs absolutely still.", "calibration"},
    {SetupStep::Orientation,
     {.key = "orientation", .label = "Sensor", .help = "Finds which way the sensor sits on the camera: you hold the camera level, tilt its right side down, then its nose. Where the board takes the sensor to sit otherwise, that is set, and kept only where the board's angles follow the camera then.",
      .risk = ActionRisk::Writes, .confirm = "I hold the camera: its motors let go"},
     "The frame stands level and still. Right and nose are meant as seen from behind the camera.", "parameters"},
    {SetupStep::Level,
     {.key = "level", .label = "Horizon", .help = "Measures what the accelerometer takes for level, and compares it with before.", .risk = ActionRisk::Writes,
      .confirm = "The camera lies or is held: its motors may let go"},
     "The camera stands level and still.", "calibration"},
    {SetupStep::Balance,
     {.key = "balance", .label = "Balance", .help = "Switches the motors off, waits until the camera is held level, and measures how far it swings when it is let go and tipped lightly.",
      .risk = ActionRisk::Moves, .confirm = "I hold the camera"},
     "The camera is mounted as it will be used, with its lens and its cables. The frame stands still, best on a stand.", ""},
    {SetupStep::Motors,
     {.key = "motors", .label = "Motors", .help = "One motor at a time, all others off, with a fifth of its power: the board turns it to find its poles and its direction, and what turned tells whether it is plugged in at its place. Then it holds its axis alone. Where that runs away, it is stopped at once, and tried the other way round. In the end they all start.",
      .risk = ActionRisk::Writes, .confirm = "The camera is balanced and can turn freely"},
     "The gimbal is held or stands so that nothing is in the way of the camera.", "actions"},
    {SetupStep::MotorPower,
     {.key = "motor-power", .label = "Motor power", .help = "Moves one axis after the other a little, with less and with more power in use for the moment, and finds the lowest that holds it. It gets twice that: warm windings, an emptier battery and a gust take the rest. The old power is back at once where an axis turns wild or the step is left.",
      .risk = ActionRisk::Writes, .confirm = "The camera is balanced and can turn freely; my hands catch it if it sags"},
     "The gimbal is held in the hand as in use, and the motors run.", "parameters"},
    {SetupStep::Gains,
     {.key = "gains", .label = "Gains", .help = "Measures how well the camera is held and how each axis follows a small step, lets the board search its gains, and measures again. Where it is held worse than before, the old gains are written back.",
      .risk = ActionRisk::Writes, .arguments = kGainArguments},
     "The gimbal is held in the hand as in use, and the motors run.", "autotune"},
    {SetupStep::Vibration,
     {.key = "vibration", .label = "Vibration", .help = "Measures how the camera vibrates while it is held. Where a line of its own stands out, a notch is tried, and kept only where the axis vibrates less with it.",
      .risk = ActionRisk::Writes, .arguments = kVibrationArguments},
     "The gimbal is held in the hand as in use, and the motors run.", "spectrum"},
    {SetupStep::Limits,
     {.key = "limits", .label = "Range", .help = "Switches the motors off, watches how far the camera is moved by hand, and sets the range that steering may reach. Where the board has limits of the axes themselves, they lie half of the margin further.",
      .risk = ActionRisk::Writes, .arguments = kLimitArguments, .confirm = "I hold the camera"},
     "The frame stands level and still while the camera is moved as far as it may go.", "parameters"},
    {SetupStep::Remote,
     {.key = "remote", .label = "Remote control", .help = "Switches the motors off and has you move one stick after the other: finds the input that it moves, its direction and its ends. The map is written, and kept only where the board's own signal follows the stick.",
      .risk = ActionRisk::Writes, .arguments = kRemoteArguments, .confirm = "I hold the camera: its motors let go"},
     "Transmitter and receiver are on. What is moved by no stick is left out below; without a remote control, leave out the step.", "signals"},
    {SetupStep::Use,
     {.key = "use", .label = "Use", .help = "Shows which values follow from what the gimbal is for, and writes them if they are wanted.", .risk = ActionRisk::Writes, .arguments = kUseArguments},
     "", "parameters"},
};
static_assert(std::size(kSteps) == kSetupSteps);

constexpr SetupFigureSpec kFigures[] = {
    {"voltage", "Voltage", "V", 2}, {"cells", "Cells", "", 0}, {"percell", "Voltage of a cell", "V", 2},
    {"alarm", "Alarm below", "V", 2}, {"off", "Motors off below", "V", 2},
    {"spread", "Turn rate varies by", "°/s RMS", 3}, {"bias", "Zero of the gyroscope", "°/s", 3}, {"askew", "Sensor off the camera's level", "°", 1}, {"acc", "Error of the accelerometer", "g", 4},
    {"drift", "Swings when let go", "°", 1}, {"poles", "Poles", "", 0}, {"gentle", "Power that turned it", "/ 255", 0},     {"strays", "Strays from its target", "°", 1},
    {"motorpower", "Power", "/ 255", 0}, {"need", "Still held with a power of", "/ 255", 0}, {"settles", "Off its target after a move", "° RMS", 2},
    {"current", "Current of the gimbal", "A", 2}, {"heat", "Temperature of the motor", "°C", 0},
    {"holds", "Held to", "° RMS", 3}, {"rises", "Follows a step in", "ms", 0}, {"overshoots", "Overshoots a step by", "%", 0},
    {"line", "Strongest line", "Hz", 1},
    {"shakes", "Vibrates", "°/s RMS", 2}, {"lowest", "Lowest angle", "°", 0}, {"highest", "Highest angle", "°", 0},
    {"stopslow", "Stops at, lower end", "°", 0}, {"stopshigh", "Stops at, upper end", "°", 0},
    {"stick.low", "Stick at its lower end", "%", 0}, {"stick.rest", "Stick let go", "%", 0}, {"stick.high", "Stick at its upper end", "%", 0},
};

constexpr SetupRemarkSpec kRemarks[] = {
    {"power.set", "The thresholds fit the battery now."},
    {"power.fits", "The thresholds fitted the battery already."},
    {"sensors.imu", "The sensor on the camera measures."},
    {"sensors.noimu", "The sensor on the camera does not measure: see its cable. Without it nothing is held.", false},
    {"sensors.frame", "The frame's angles are measured, too."},
    {"sensors.noframe", "Nothing measures the frame, and nothing has to."},
    {"sensors.deadframe", "A sensor on the frame is set up and does not measure: see its cable, or set up none.", false},
    {"sensors.magnetometer", "The board can have a magnetometer: one that is connected is calibrated on the page Calibration."},
    {"sensors.nomagnetometer", "Without a magnetometer the heading drifts slowly."},
    {"sensors.encoders", "Each motor has an encoder."},
    {"sensors.someencoders", "Some motors have an encoder set up, others have none."},
    {"sensors.unsetencoders", "The board can read encoders; none is set up."},
    {"sensors.noencoders", "This board reads no encoders: where its motors stand it does not measure."},
    {"calibrated.good", "That is good."},
    {"calibrated.usable", "That is usable; in a steadier place it gets better.", false},
    {"calibrated.poor", "That is poor: do it again in a steadier place.", false},
    {"up.x", "The sensor's axis X points up."},
    {"up.-x", "The sensor's axis X points down."},
    {"up.y", "The sensor's axis Y points up."},
    {"up.-y", "The sensor's axis Y points down."},
    {"up.z", "The sensor's axis Z points up."},
    {"up.-z", "The sensor's axis Z points down."},
    {"right.x", "Its axis X points to the right."},
    {"right.-x", "Its axis X points to the left."},
    {"right.y", "Its axis Y points to the right."},
    {"right.-y", "Its axis Y points to the left."},
    {"right.z", "Its axis Z points to the right."},
    {"right.-z", "Its axis Z points to the left."},
    {"orientation.set", "The board took it to sit otherwise; now its angles follow the camera."},
    {"orientation.fits", "The board takes it so, and its angles follow the camera."},
    {"motors.off", "The motors are off until the step “Motors” has found what they are."},
    {"balance.good", "It is balanced."},
    {"balance.bad", "It is not balanced on the axis that swings: move the camera on its plate against it, and measure again. Motors that carry weight get hot and hold badly.", false},
    {"motors.changed", "The board has found other poles or directions than were set."},
    {"motors.same", "The motors are as they were set."},
    {"motors.outputs", "Motors are plugged in otherwise than was set: each axis has the output now that turns it. Outputs of other profiles are as they were."},
    {"motors.turned", "An axis ran away with little power and was stopped; the other way round it holds."},
    {"motors.hold", "No axis runs away. The motors run."},
    {"motorpower.set", "Each motor has twice the power that its axis needs, and holds it with that."},
    {"motorpower.fits", "The motors had the right power already, and hold the camera with it."},
    {"motorpower.scarce", "An axis needs more than half of what its motor can bear: balance the camera, and see whether a cable pulls at it.", false},
    {"motorpower.hot", "A motor is hot: let it cool, and see on the page Monitor how warm it gets with the power that it has now.", false},
    {"motorpower.warms", "Motors get warm in minutes: see on the page Monitor how warm these are after ten."},
    {"motorpower.untold", "This board does not tell how warm its motors are: touch them after ten minutes. What is too hot to touch has too much power."},
    {"gains.better", "It is held better than before."},
    {"gains.same", "It is held about as before."},
    {"gains.shakes", "An axis vibrates strongly with these gains: lower them (page Tuning), or try a notch (step Vibration).", false},
    {"gains.measured", "Nothing was searched: that is how the gains hold that it has."},
    {"gains.overshoots", "An axis overshoots far before it rests: more D or less P calms it (page Tuning)."},
    {"gains.axisback", "An axis was held worse with the gains that were found: it has its old ones again, the others the new ones."},
    {"gains.takenback", "It was held worse than before: the old gains were written back.", false},
    {"gains.worse", "It is held worse than before, and the old gains could not be written back: see Backups.", false},
    {"vibration.calm", "Nothing vibrates in a line of its own."},
    {"vibration.lines", "Some lines stand out: the page Spectrum says whether a notch helps, and tries it."},
    {"vibration.notch", "A notch helps, and is written."},
    {"vibration.nonotch", "A notch was tried and did not help: the board holds what it held."},
    {"vibration.strong", "An axis vibrates strongly: lower its gains (page Tuning), and measure again.", false},
    {"limits.set", "Steering reaches what you have shown, less the margin."},
    {"limits.joint", "The axes themselves stop half of the margin further."},
    {"limits.kept", "An axis was hardly moved: its range stays as it was.", false},
    {"remote.set", "The sticks are mapped, and the board follows them."},
    {"remote.fits", "They were mapped so already, and the board follows them."},
    {"remote.short", "A stick reaches less than 80 % of its way: widen its travel at the transmitter.", false},
    {"remote.offset", "A stick does not come back to the middle when it is let go: trim it at the transmitter.", false},
    {"remote.shared", "Something that was left out has the same input as one of them: map it otherwise, or to none.", false},
    {"remote.off", "The motors are off. In angle mode the camera turns to where the sticks stand when they are switched on."},
    {"changed.since", "The board holds other values since: do it again.", false},
    {"use.shown", "Nothing is written yet."},
    {"use.set", "The values are written."},
    {"use.same", "All values are so already."},
};
// clang-format on

template <typename Row> const Row *longestOf(std::span<const Row> rows, const QString &key)
{
    const auto it = std::find_if(rows.begin(), rows.end(), [&key](const Row &row) {
        const QString name = QLatin1String(row.key);
        return key == name || key.startsWith(name + u'.');
    });
    return it == rows.end() ? nullptr : &*it;
}

bool canTryPower(const Device &device, const SetupKeys &keys)
{
    const ParameterSpec *power
        = keys.motorPower.isEmpty() ? nullptr : device.parameters()->find(keys.motorPower.arg(u"roll"_s));
    return power && device.live() && device.live()->variableOf(*power) >= 0 && device.steering();
}

}  // namespace

std::span<const SetupStepSpec> setupSteps()
{
    return kSteps;
}

const SetupStepSpec &setupStep(SetupStep step)
{
    return kSteps[std::size_t(step)];
}

const SetupStepSpec *findSetupStep(const QString &key)
{
    const auto it = std::find_if(std::begin(kSteps), std::end(kSteps), [&key](const SetupStepSpec &spec) {
        return key == QLatin1String(spec.action.key)
            || key.compare(QLatin1String(spec.action.label), Qt::CaseInsensitive) == 0;
    });
    return it == std::end(kSteps) ? nullptr : &*it;
}

std::vector<SetupStep> stepsOf(const Device &device)
{
    std::vector<SetupStep> steps;
    const SetupFacts *facts = device.setupFacts();
    if (!facts)
        return steps;
    const SetupKeys keys = facts->setupKeys();
    const ChannelRoles roles = rolesOf(device);
    const bool hasAngles = roles.angle[0] >= 0 && roles.angle[1] >= 0;
    const auto parameters = device.parameters();
    const auto knows = [&parameters](const QString &key) {
        return !key.isEmpty() && parameters->find(key.contains(u'%') ? key.arg(u"roll"_s) : key);
    };
    const auto offers = [&device](const QString &key) {
        const auto actions = device.actions();
        return std::any_of(actions.begin(), actions.end(),
                           [&key](const ActionSpec &action) { return key == QLatin1String(action.key); });
    };
    const std::array<bool, kSetupSteps> isThere{
        knows(keys.batteryAlarm) && roles.battery >= 0,
        roles.gyro[0] >= 0,
        offers(keys.calibrateGyro),
        knows(keys.axisUp) && knows(keys.axisRight) && device.motorSwitch() && hasAngles && roles.acc[0] >= 0,
        offers(keys.calibrateLevel),
        device.motorSwitch() && hasAngles && roles.gyro[0] >= 0 && roles.gyro[1] >= 0,
        offers(keys.findPoles) && knows(keys.motorOutput) && knows(keys.motorPower) && device.motorSwitch()
            && device.steering() && hasAngles && roles.gyro[0] >= 0,
        canTryPower(device, keys) && device.motorSwitch() && hasAngles && tellsTargets(device),
        offers(keys.autoTune) && hasAngles && roles.target[0] >= 0,
        roles.gyro[0] >= 0,
        std::ranges::any_of(keys.ranges, [&](const SetupRange &range) { return knows(range.lowest); })
            && device.motorSwitch() && hasAngles,
        knows(keys.inputMap) && offers(keys.readInputs) && device.motorSwitch() && roles.outputs >= 0,
        !keys.uses.empty(),
    };
    for (const SetupStepSpec &spec : kSteps) {
        if (isThere[std::size_t(spec.step)])
            steps.push_back(spec.step);
    }
    return steps;
}

std::span<const SetupFigureSpec> setupFigures()
{
    return kFigures;
}

const SetupFigureSpec *findSetupFigure(const QString &key)
{
    return longestOf(setupFigures(), key);
}

std::span<const SetupRemarkSpec> setupRemarks()
{
    return kRemarks;
}

const SetupRemarkSpec *findSetupRemark(const QString &key)
{
    return longestOf(setupRemarks(), key);
}
