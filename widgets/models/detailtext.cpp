// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/detailtext.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class DetailWords
{
    Q_DECLARE_TR_FUNCTIONS(ErrorDetail)
};

// clang-format off
constexpr const char *kDetails[] = {
    QT_TRANSLATE_NOOP("ErrorDetail", "a segment has 16 to 65536 samples, an even number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the overlap is 0 to 0.9"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sample rate is not known"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 samples are fewer than one segment of %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 samples are too few for a step"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the samples end where they began: no step to measure"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no samples"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the target did not step: another control source may hold it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the command did not step"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: '%2' is not a whole number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: %2 is not within %3 .. %4"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: '%2' is not a number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: '%2' is not a series of bytes in hex"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes are too few"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no field '%1'"),
    QT_TRANSLATE_NOOP("ErrorDetail", "only generations F and G are told to do anything"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone says that it is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone drives its motors though disarmed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this generation does not tell it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "only generations F and G are asked for their recordings"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the transmitter sends with power %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the transmitter sends in the band %1 on channel %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the transmitter has %1 steps of power"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera was not held as asked for a minute, or its sensor sits at no right angle to it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "one of the two tilts went the other way: the right side down, seen from behind the camera, then its nose"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board's angles do not follow the camera"),
    QT_TRANSLATE_NOOP("ErrorDetail", "motors are turned over UDP only"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no answer came; whether the camera has switched is not known"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the scale of a gain in the text is %1, which gives no number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone has no video transmitter"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone does not say that it is calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone did not begin to calibrate"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone had taken it up already, and has carried it out"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone does not answer any more; only switching it off and on helps"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone is not calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone does not stream its outputs, so nobody knows how many motors it has; switch full telemetry on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone has %1 motors"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone is calibrating"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone holds another text than was uploaded"),
    QT_TRANSLATE_NOOP("ErrorDetail", "after its restart the drone uses other gains"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone has not come back after its restart; what it was given may not start, and then only a login on its computer helps"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone has not restarted"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone refuses to calibrate"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone has no camera"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no camera answers"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: another value came back"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a gain is no number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes; less than %2 are allowed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the configuration text is uploaded over UDP only"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone confirmed the text, and has not restarted"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone answers, and does not take the text"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the text did not arrive whole; it was not written"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a drone decides by itself what it streams"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the battery is low: %1 V, %2 %. A drone that loses its power while its program is replaced does not start any more; charge or change the battery first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "firmware is uploaded over UDP only"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a piece of the firmware"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone did not take a piece of the firmware, and may have taken its bytes for commands; look whether it is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the drone runs the firmware that it had; its stream stays silent until it is restarted: switch it off and on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "nothing to send"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is not sent from here"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is not sent from here: %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "nobody uses it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it moves the drone whether or not it is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no message '%1'"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is no number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 fields are needed, not %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: %2 is no number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the text has no checksum"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the text of %1 bytes does not fit its checksum"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a black box has no streams"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no streams; it is asked for each sample"),
    QT_TRANSLATE_NOOP("ErrorDetail", "say which family it is with ?family= and one of %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is not reached that way"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 counts in whole steps"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is tuning itself"),
    QT_TRANSLATE_NOOP("ErrorDetail", "nothing was changed live"),
    QT_TRANSLATE_NOOP("ErrorDetail", "variable %1: %2 was written, %3 is in use"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 has control characters, such as a line break"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2 is neither on nor off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2 is none of: %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2 is not a %3 from %4 to %5"),
    QT_TRANSLATE_NOOP("ErrorDetail", "whole number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2 may mean %3 or the number of another; give the name: %4"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 has no argument '%2'"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board lacks something for that step"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no telemetry"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board has not told yet whether its motors run"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors are off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "motors off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 V: that is no battery, only USB feeds the board. Connect the battery"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 V fits no number of cells: charge the battery, or say how many it has"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 V fits %2 cells: say how many it has"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 V at %2 cells is %3 V for each: charge the battery, or correct the number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera was not held level for a minute: hold it level, then begin again"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no input has a signal: switch the transmitter on, and see that its receiver is connected and of the kind that is set"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no input alone moved clearly for a minute: the transmitter is off, its receiver is not connected, or the board does not look at that input"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors were switched on meanwhile, as a stick or a switch can command: they are stopped"),
    QT_TRANSLATE_NOOP("ErrorDetail", "every stick is left out: choose one at least"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board's own signal of %1 does not follow the stick"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera did not move at all, so it was not let go: let go, and tip it lightly"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is %2° away from its target"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no axis has a motor output: set them first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motor of %1 does not turn the camera: see whether it is connected, and nothing is in its way"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board does not tell the power of its motors"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is not held with any power that its motor can bear: balance the camera, and see whether a cable pulls at it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is not held with the power that was found for it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it turns with %1°/s"),
    QT_TRANSLATE_NOOP("ErrorDetail", "not a record of a set-up that this version reads"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the notch that was tried is still on the board"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera was not moved by more than some degrees: move it by hand as far as it may go"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 of %2 bytes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes in %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is %2, allowed are %3 to %4"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board cannot be steered to an angle"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board does not tell its targets, so the line's delay would be taken for its own; steps can be measured"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no telemetry of the angles"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the axis is %1° away from its target"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the axis does not come to rest in its middle"),
    QT_TRANSLATE_NOOP("ErrorDetail", "target and angle do not come in the same rows"),
    QT_TRANSLATE_NOOP("ErrorDetail", "only %1 of %2 s arrived without a hole"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no telemetry for %1 s"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors went off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1° from the middle, %2° are allowed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has one profile, without a name"),
    QT_TRANSLATE_NOOP("ErrorDetail", "profile names; the board takes all of them at once, so those that were not read would be erased: nothing was written"),
    QT_TRANSLATE_NOOP("ErrorDetail", "profile names: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board sends no angular rate of this axis"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 could not be read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "nothing tells %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "profile %1 is in use now, and was profile %2 when the board was read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the active profile is another than before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: each answer is another"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 does not hold what was saved"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has a serial number, which names it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a board without a serial number needs a name"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the recording has ended"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2 is not a number from %3 to %4"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not an address; one looks like 127.0.0.1:%2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "sent %1 times"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not a whole number from %2 to %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board does not see its motion sensor"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board reports that its motors are off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board reports that its motors are running"),
    QT_TRANSLATE_NOOP("ErrorDetail", "steering in that mode"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2: in the mode '%3' it goes from %4 to %5%6"),
    QT_TRANSLATE_NOOP("ErrorDetail", "steer needs roll=, pitch= or yaw="),
    QT_TRANSLATE_NOOP("ErrorDetail", "firmware before 2.55b5 steers all axes at once and cannot leave one alone: name roll, pitch and yaw"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors are off, so nothing would move"),
    QT_TRANSLATE_NOOP("ErrorDetail", "as the board tells it, neither the camera nor its target has turned"),
    QT_TRANSLATE_NOOP("ErrorDetail", "control was given back before the camera was there, %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera did not get where it was steered to, %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the limits of the sticks may hold it back, which limited=off lifts"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a melody has at most %1 notes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "variable %1 was not told"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: whether the values in use are stored now shows only when the board has restarted"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board has no frame sensor that works"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board goes on with its frame sensor"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no function of this profile has a signal"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board tells that the slot is %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "still in use"),
    QT_TRANSLATE_NOOP("ErrorDetail", "data needs up to %1 bytes in hex"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board holds other data"),
    QT_TRANSLATE_NOOP("ErrorDetail", "READ_FILE at page %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board holds another file"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board still has the file"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no slot has a signal"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board shows the sensor of its frame, and this step is about the camera's: select that one first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board shows its other sensor, so nobody would see what the calibration does: imu.select imu=%1 first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor does not lie level and the motors are running; six=on switches them off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: it was not confirmed, and motors that were off run now"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the end was not confirmed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: neither start nor end was confirmed; nobody can tell whether the board calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor moves (%1 °/s): let it lie still"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor measures %1 g instead of 1 g, which none at rest does: something moves it, it is defective, or an earlier calibration is wrong, which action=reset-all removes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the gyroscope shows %1 °/s at rest, and showed %2 °/s before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the accelerometer is off by %1 g, and was by %2 g before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board repeats the same figures: they are not measured"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it measures %1 V"),
    QT_TRANSLATE_NOOP("ErrorDetail", "AUTO_PID: it searches on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no axis to tune"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no axis is chosen"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera is %1° away from the attitude that it was steered to"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what came out has nothing to do with what went in: the stimulus is too weak"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board was told to stop shaking the axis, without proof: switch the motors off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the highest frequency has to be above the lowest"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 of the frames with samples were lost"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a sensor at rest measures 1 g in all, and the reference has %1 g"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor does not stand still"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the accelerometer is %1 g away from the reference"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board still counts %1 starts"),
    QT_TRANSLATE_NOOP("ErrorDetail", "AUTO_PID: the board says that the search has ended, with %1=%2, and still uses %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board was told to stop searching, and reports no search any more"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board may be searching; it was told to stop, without proof (%1): switch the motors off"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the gains from before could not be put back (%1)"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the search has ended; which gains are in use could not be read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 with %2 bytes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "profile %1 was to be used, profile %2 is"),
    QT_TRANSLATE_NOOP("ErrorDetail", "data needs 1 to %1 bytes in hex"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this is the memory with the board's calibrations and its licence; memory.restore writes it with a copy, and compares"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board goes on as before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "mode asks for an attitude and sets none"),
    QT_TRANSLATE_NOOP("ErrorDetail", "stopped at command %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "after %1 come payload bytes in hex%2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "these bytes are not one complete frame with valid checksums"),
    QT_TRANSLATE_NOOP("ErrorDetail", "these bytes are not one whole message"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no command '%1'"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is what the board sends"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 payload bytes, a frame holds 255"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board does not tell the size of its memory"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this is the memory of another board (%1, firmware %2), with its calibrations and its licence; part=settings takes its settings alone, other=on all of it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no number, so nobody can tell whether the calibrations and the licence in the copy are its own; part=settings takes the settings alone, other=on all of it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board keeps no files"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes were read before; the same again goes on from there"),
    QT_TRANSLATE_NOOP("ErrorDetail", "each time it is read, the memory holds something else"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: %2 files were changed before; the same again goes on from there"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the board holds another file (%2)"),
    QT_TRANSLATE_NOOP("ErrorDetail", "none of the board's settings was found in its memory"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is there already: the copy that is made before needs a file of its own"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board tells nothing of its calibrations"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no calibration in this file"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it was read from firmware %1, and nobody tells where %2 keeps what"),
    QT_TRANSLATE_NOOP("ErrorDetail", "from address %1 on the board holds other bytes than were written"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 holds %2 bytes, the board's memory has %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes were written before; the same again goes on from there"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 has room for %2 bytes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not name=value; the fields are %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is given twice"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: %2 is not within 0 .. %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the length of a rotation is 1, not %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no field '%1' here; the fields are %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a frame holds %1 payload bytes"),
    QT_TRANSLATE_NOOP("ErrorDetail", "debug variable %1 has the unknown type %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: nothing has changed, and the board was not seen to calibrate"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: nothing has changed, and the end was not confirmed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this firmware turns the motors by %1 at a speed of its own"),
    QT_TRANSLATE_NOOP("ErrorDetail", "an angle and"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this angle"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this firmware takes the position of all motors at once"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motor of %1 stands at %2°, as before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "fc.map.roll and fc.map.pitch name no input that carries a flight controller's signal"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the magnetometer repeats the same figures: they are not measured"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the magnetometer has seen %1 of 26 directions: turn the camera over while it is calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the heading is off by %1°, and was off by %2° before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it had begun on the board"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it had begun; what is stored now could not be read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it had begun; what is stored is as before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "it had begun, and what is stored has changed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 of 26 directions were seen"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no stream %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 samples/s, 0 to %2 are possible"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 without a channel that the board can send"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 of %2 bytes, %3 fit into a frame"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this firmware has no streams; it is asked for each sample"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1=%2, allowed %3 to %4 µs, or 0 for the middle"),
    QT_TRANSLATE_NOOP("ErrorDetail", "sticks needs pitch=, roll= or yaw="),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is off, so script %2 never runs; choose an input for it first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a name has up to 16 letters, not %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board has no letter “%1” for its name"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board calls itself %1, not %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board has not answered since it was told to restart"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board has not restarted; its state is “%1”"),
    QT_TRANSLATE_NOOP("ErrorDetail", "nothing has changed, and these are no defaults: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "still on auto: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "word=%1, allowed 0 to %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no sensor Imu%1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no further face lay still for %1 s"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no sensor is like that: zeros %1 %2 %3, scales %4 %5 %6"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 was written, %2 read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1': the board does not know this command"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1': the command arrived in pieces"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1': the command arrived damaged"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the command arrived in pieces"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the board does not know this command"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: access denied"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: this firmware does not know it"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: the command arrived damaged"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: wrong length"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1: value out of range"),
    QT_TRANSLATE_NOOP("ErrorDetail", "another parameter than %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "word %1: %2 was written, %3 read"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this firmware has the slots 1 to %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "slot %1 holds no script"),
    QT_TRANSLATE_NOOP("ErrorDetail", "slot %1 holds again what it held before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what slot %1 holds now is not known"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what it held is in %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the script goes on: it tells command %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no command of it was told: whether it runs is not known"),
    QT_TRANSLATE_NOOP("ErrorDetail", "scripts cannot be written while the heartbeat is on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "only parameters with names can be saved in this file"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no parameter %1, its last is %2; it would confirm the command and do nothing"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a name that this board does not know would set its first parameter, and its names are not known for certain: use PARAM_SET2 with the number"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no parameter '%1' and would set its first one"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no parameter %1 and would set its first one"),
    QT_TRANSLATE_NOOP("ErrorDetail", "after %1 come %2 bytes in hex"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no live value %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is starting, with motors disabled; what is stored can be read once it works normally"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board does not go into standby"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board answers no plain commands"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board confirms that it loads what is stored, and what was in use stays"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is in standby"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board stays in standby"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board's memory is not known"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what is stored cannot be read while the heartbeat is on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 is %2 in use and %3 where it is stored"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is starting; all motors can be stored as disabled once it works normally"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor Imu%1 was lost"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the camera was not tilted 45° down, without roll, for one second"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no axis of the sensor pointed up for one second"),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no sensor"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 errors on the sensor's bus: check its cable"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors are running; setup.motors_off disables them first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "these directions do not belong to a sensor"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the battery is low"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no battery was connected"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board could not level: hold the camera still"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensor was lost"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 errors on the sensor's bus"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what was set up before the restart"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board works normally, but has not restarted"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board did not reach normal working"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the direction of %1 is still on auto"),
    QT_TRANSLATE_NOOP("ErrorDetail", "magnets come in pairs: %1 is odd"),
    QT_TRANSLATE_NOOP("ErrorDetail", "begin to align yaw first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is not in standby yet"),
    QT_TRANSLATE_NOOP("ErrorDetail", "every motor is disabled: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is starting; its motors start by themselves then"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no motor became active, though none is disabled"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no motor became active; disabled are %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors are disabled in volatile memory; in use before: %1. Restart the board, or set these again, to use the motors, and store nothing before"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not a stream; one looks like realtime4@100"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no samples in this span of time"),
    QT_TRANSLATE_NOOP("ErrorDetail", "too few samples to tell their rate"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the option '%1' has no value"),
    QT_TRANSLATE_NOOP("ErrorDetail", "baud=%1 is not a rate between 300 and 4000000"),
    QT_TRANSLATE_NOOP("ErrorDetail", "parity=%1 is neither none nor even"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not %2://host:port"),
    QT_TRANSLATE_NOOP("ErrorDetail", "'%1' is not an address; use serial:/dev/ttyUSB0, tcp://host:port, udp://host[:port], sim:simplebgc or replay:FILE"),
    QT_TRANSLATE_NOOP("ErrorDetail", "an address of video is HOST:PORT, not '%1'"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a port is 1 to 65535, not %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the host of the video is missing"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the video module is missing or does not fit this program: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no video is received"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a recording runs"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the size of the pictures has changed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors may run, or start yet"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board may have carried it out: the camera may be moving"),
    QT_TRANSLATE_NOOP("ErrorDetail", "what was in use before is not in use again: %1"),
    QT_TRANSLATE_NOOP("ErrorDetail", "libav has no decoder for this video"),
    QT_TRANSLATE_NOOP("ErrorDetail", "a picture of another size"),
    QT_TRANSLATE_NOOP("ErrorDetail", "libav has no encoder for H.264 or JPEG"),
    QT_TRANSLATE_NOOP("ErrorDetail", "no measurement"),
    QT_TRANSLATE_NOOP("ErrorDetail", "at no frequency does the axis follow the target clearly enough to tell"),
    QT_TRANSLATE_NOOP("ErrorDetail", "another board"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has no command that switches its motors on"),
    QT_TRANSLATE_NOOP("ErrorDetail", "disconnect first"),
    QT_TRANSLATE_NOOP("ErrorDetail", "this board has one profile"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1; tried: %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 bytes: %2"),
    QT_TRANSLATE_NOOP("ErrorDetail", "for %1 add ?family=%2 to the address"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the port %1 disappeared"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 = %2, allowed %3"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 = %2, allowed %3..%4"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the board is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the sensors are not calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "the motors are running"),
    QT_TRANSLATE_NOOP("ErrorDetail", "whether the board is armed"),
    QT_TRANSLATE_NOOP("ErrorDetail", "whether the sensors are calibrated"),
    QT_TRANSLATE_NOOP("ErrorDetail", "whether the motors are running"),
    QT_TRANSLATE_NOOP("ErrorDetail", "%1 needs %2=..."),
    QT_TRANSLATE_NOOP("ErrorDetail", "there is no %1"),
};
// clang-format on

/// A sentence as it is written, with what its placeholders stand for.
struct DetailPattern
{
    const char *source;
    QRegularExpression form;
    QList<int> places;  // the number of each placeholder, from 1
    qsizetype letters;  // that are not placeholders
};

DetailPattern patternOf(const char *source)
{
    static const QRegularExpression place(u"%(\\d)"_s);
    const QString text = QString::fromUtf8(source);
    DetailPattern pattern{source, {}, {}, 0};
    QString form;
    qsizetype from = 0;
    const auto literal = [&](qsizetype to) {
        form += QRegularExpression::escape(text.mid(from, to - from));
        pattern.letters += to - from;
    };
    for (const QRegularExpressionMatch &found : place.globalMatch(text)) {
        literal(found.capturedStart());
        form += u"((?:(?!; ).)*?)"_s;  // not beyond the end of its sentence
        pattern.places.append(found.captured(1).toInt());
        from = found.capturedEnd();
    }
    literal(text.size());
    pattern.form = QRegularExpression(QRegularExpression::anchoredPattern(form),
                                      QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

// Those that say most come first: others may fit the same text.
const std::vector<DetailPattern> &patterns()
{
    static const std::vector<DetailPattern> list = [] {
        std::vector<DetailPattern> all;
        for (const char *source : kDetails)
            all.push_back(patternOf(source));
        std::stable_sort(all.begin(), all.end(), [](const DetailPattern &a, const DetailPattern &b) {
            return a.letters > b.letters;
        });
        return all;
    }();
    return list;
}

std::optional<QString> translated(const QString &sentence)
{
    for (const DetailPattern &pattern : patterns()) {
        const QRegularExpressionMatch match = pattern.form.match(sentence);
        if (!match.hasMatch())
            continue;
        // In one go: what stands in for a placeholder may look like one.
        const QString words = DetailWords::tr(pattern.source);
        QString text;
        for (qsizetype i = 0; i < words.size(); ++i) {
            const int number = words[i] == u'%' ? words.mid(i + 1, 1).toInt() : 0;
            const qsizetype which = pattern.places.indexOf(number);
            if (which < 0) {
                text += words[i];
                continue;
            }
            text += detailText(match.captured(int(which) + 1));
            ++i;
        }
        return text;
    }
    return {};
}

}  // namespace

std::span<const char *const> detailSentences()
{
    return kDetails;
}

QString detailText(const QString &detail)
{
    // A sentence may have the mark that stands between two of them.
    const QStringList parts = detail.split(u"; "_s);
    QStringList told;
    for (qsizetype from = 0; from < parts.size();) {
        qsizetype count = parts.size() - from;
        std::optional<QString> text;
        while (!(text = translated(parts.mid(from, count).join(u"; "_s))) && count > 1)
            --count;
        told.append(text.value_or(parts[from]));
        from += count;
    }
    return told.join(u"; "_s);
}
