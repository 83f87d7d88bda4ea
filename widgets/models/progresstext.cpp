// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/errortext.h"
#include "widgets/models/parametermodel.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class ProgressWords
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

constexpr QLatin1String kTextBlock("CONFIG_FILE");

// Parts of a board whose names are of its protocol; where there are no words, the name says it.
QString subjectText(const QString &subject)
{
    if (subject == kTextBlock)
        return ProgressWords::tr("configuration text");
    if (subject == QLatin1String("GAINS"))
        return ProgressWords::tr("gains");
    if (subject == QLatin1String("PARAMETERS"))
        return ProgressWords::tr("parameters");
    return subject;
}

struct StepWords
{
    const char *step;
    const char *text;  // %1: what it is done to
    bool counts = false;  // %1: how often it is done so far
};

QString stickName(const QString &function)
{
    return function == u"roll"_s ? ProgressWords::tr("the stick for roll")
        : function == u"pitch"_s ? ProgressWords::tr("the stick for pitch")
        : function == u"yaw"_s   ? ProgressWords::tr("the stick for yaw")
                                 : ProgressWords::tr("the switch for commands");
}

// clang-format off
constexpr StepWords kStepWords[] = {
    {"probe", QT_TRANSLATE_NOOP("ErrorText", "Looking for a board at %1")},
    {"read-block", QT_TRANSLATE_NOOP("ErrorText", "Reading %1")},
    {"write-block", QT_TRANSLATE_NOOP("ErrorText", "Writing %1")},
    {"await-restart", QT_TRANSLATE_NOOP("ErrorText", "%1 is written; waiting for the board to restart")},
    {"verify-block", QT_TRANSLATE_NOOP("ErrorText", "Reading back %1")},
    {"roll-back", QT_TRANSLATE_NOOP("ErrorText", "Putting back %1")},
    {"calibrate", QT_TRANSLATE_NOOP("ErrorText", "Calibrating: keep the camera absolutely still")},
    {"setup-hold", QT_TRANSLATE_NOOP("ErrorText", "Hold the camera level and still")},
    {"setup-let-go", QT_TRANSLATE_NOOP("ErrorText", "Take your hands off the camera, keep them beneath it, and tip it lightly")},
    {"setup-tilt-level", QT_TRANSLATE_NOOP("ErrorText", "Hold the camera level and still, until you are asked for something else")},
    {"setup-tilt-right", QT_TRANSLATE_NOOP("ErrorText", "Tilt the right side of the camera down by about 45° and hold it there")},
    {"setup-tilt-down", QT_TRANSLATE_NOOP("ErrorText", "Tilt the nose of the camera down by about 45° and hold it there")},
    {"setup-move", QT_TRANSLATE_NOOP("ErrorText", "Move the camera slowly as far as it may go, each axis both ways")},
    {"setup-stick-roll", QT_TRANSLATE_NOOP("ErrorText", "Roll: move its stick to the end at which the camera is to tip to the right, and hold it there")},
    {"setup-stick-pitch", QT_TRANSLATE_NOOP("ErrorText", "Pitch: move its stick to the end at which the camera is to look down, and hold it there")},
    {"setup-stick-yaw", QT_TRANSLATE_NOOP("ErrorText", "Yaw: move its stick to the end at which the camera is to turn to the right, and hold it there")},
    {"setup-stick-command", QT_TRANSLATE_NOOP("ErrorText", "Commands: move their switch to another position and leave it there")},
    {"setup-stick-back", QT_TRANSLATE_NOOP("ErrorText", "%1 moves: now to the other end, and hold it there")},
    {"setup-stick-again", QT_TRANSLATE_NOOP("ErrorText", "Two moved: let go of both, then move one alone")},
    {"setup-stick-taken", QT_TRANSLATE_NOOP("ErrorText", "That one steers something else already: let go, then move another one")},
    {"setup-stick-check", QT_TRANSLATE_NOOP("ErrorText", "Does the board follow? Move %1 to an end once more")},
    {"setup-stick-rest", QT_TRANSLATE_NOOP("ErrorText", "Let go of all sticks")},
    {"setup-motor-roll", QT_TRANSLATE_NOOP("ErrorText", "Roll alone, with little power: watching whether it runs away")},
    {"setup-motor-pitch", QT_TRANSLATE_NOOP("ErrorText", "Pitch alone, with little power: watching whether it runs away")},
    {"setup-motor-yaw", QT_TRANSLATE_NOOP("ErrorText", "Yaw alone, with little power: watching whether it runs away")},
    {"setup-run", QT_TRANSLATE_NOOP("ErrorText", "The motors run: watching whether an axis runs away")},
    {"setup-response", QT_TRANSLATE_NOOP("ErrorText", "Measuring how each axis follows a small step")},
    {"setup-measure", QT_TRANSLATE_NOOP("ErrorText", "Measuring")},
    {"calibrate-motors", QT_TRANSLATE_NOOP("ErrorText", "The board turns the motors and measures them")},
    {"calibrate-encoders", QT_TRANSLATE_NOOP("ErrorText", "The board reads its encoders: leave the camera as it stands")},
    {"calibrate-frame", QT_TRANSLATE_NOOP("ErrorText", "Tilt the frame by hand to all sides")},
    {"calibrate-magnetometer", QT_TRANSLATE_NOOP("ErrorText", "Turn the camera in all directions: %1 of 26 are seen"), true},
    {"read-memory", QT_TRANSLATE_NOOP("ErrorText", "Reading the board's memory")},
    {"write-memory", QT_TRANSLATE_NOOP("ErrorText", "Writing the board's memory")},
    {"read-files", QT_TRANSLATE_NOOP("ErrorText", "Searching the board's files")},
    {"read-file", QT_TRANSLATE_NOOP("ErrorText", "Reading a file of the board")},
    {"write-file", QT_TRANSLATE_NOOP("ErrorText", "Writing a file of the board")},
    {"search-bus", QT_TRANSLATE_NOOP("ErrorText", "Asking each address of the bus")},
    {"feed", QT_TRANSLATE_NOOP("ErrorText", "Sending the rows of the file, each at its time")},
    {"calibrate-drone", QT_TRANSLATE_NOOP("ErrorText", "Calibrating: leave the drone alone")},
    {"motor-test", QT_TRANSLATE_NOOP("ErrorText", "The motor is tested; the drone hears nothing meanwhile")},
    {"escs-off", QT_TRANSLATE_NOOP("ErrorText", "Motor controllers: no signal; the drone hears nothing for 26 s")},
    {"escs-full", QT_TRANSLATE_NOOP("ErrorText", "Motor controllers: FULL THROTTLE; the drone hears nothing")},
    {"escs-zero", QT_TRANSLATE_NOOP("ErrorText", "Motor controllers: zero; the drone hears nothing")},
    {"firmware-upload", QT_TRANSLATE_NOOP("ErrorText", "Uploading the firmware")},
    {"firmware-restart", QT_TRANSLATE_NOOP("ErrorText", "The firmware is on the drone; waiting for its restart. Do not switch it off")},
    {"place-sensor", QT_TRANSLATE_NOOP("ErrorText", "Lay the sensor still on one of its faces")},
    {"level-camera", QT_TRANSLATE_NOOP("ErrorText", "Hold the camera level and still")},
    {"tilt-camera", QT_TRANSLATE_NOOP("ErrorText", "Tilt the camera about 45° down, without rolling it")},
    {"wait-battery", QT_TRANSLATE_NOOP("ErrorText", "Connect the battery")},
    {"wait-start", QT_TRANSLATE_NOOP("ErrorText", "The board starts; keep the camera still")},
    {"autotune", QT_TRANSLATE_NOOP("ErrorText", "Auto-tune, iteration %1"), true},
    {"motion-test", QT_TRANSLATE_NOOP("ErrorText", "Measuring how the axis follows")},
    {"measure-before", QT_TRANSLATE_NOOP("ErrorText", "Measuring without the notch")},
    {"measure-after", QT_TRANSLATE_NOOP("ErrorText", "Measuring with the notch")},
    {"steer", QT_TRANSLATE_NOOP("ErrorText", "Steering")},
    {"frequency-test", QT_TRANSLATE_NOOP("ErrorText", "Measuring the frequency response")},
    {"tune-by-axis", QT_TRANSLATE_NOOP("ErrorText", "Searching gains by axis")},
    {"events", QT_TRANSLATE_NOOP("ErrorText", "Waiting for events")},
};
// clang-format on

}  // namespace

QString describe(const Progress &progress)
{
    const QString part = progress.step == u"setup-stick-check"_s ? stickName(progress.subject)
        : progress.step == u"setup-stick-back"_s
        ? QCoreApplication::translate("Tables", progress.subject.toUtf8().constData())
        : subjectText(progress.subject);
    const QString subject = progress.profile < 0
        ? part
        : ProgressWords::tr("%1 of profile %2").arg(part).arg(progress.profile + 1);
    if (progress.step == u"probe"_s && subject.isEmpty())
        return ProgressWords::tr("Looking for a board");
    if (progress.step == u"await-restart"_s && progress.subject == kTextBlock)
        return ProgressWords::tr("The configuration text is written; waiting for the drone to restart");
    if (progress.step == u"script"_s)
        return ProgressWords::tr("Script %1 runs: command %2")
            .arg(subject)
            .arg(int(progress.values.value(u"command"_s)));
    if (progress.step == u"setup-power"_s) {
        const auto axis = std::ranges::find_if(
            kAxes, [&](Axis each) { return progress.subject == QLatin1String(axisKey(each)); });
        return ProgressWords::tr("%1: is it held with a power of %2?")
            .arg(axis == kAxes.end() ? progress.subject : axisLabel(*axis))
            .arg(int(progress.values.value(u"power"_s)));
    }
    const auto words = std::ranges::find_if(
        kStepWords, [&](const StepWords &each) { return progress.step == QLatin1String(each.step); });
    if (words == std::end(kStepWords))
        return progress.step;
    const QString text = ProgressWords::tr(words->text);
    if (words->counts)
        return text.arg(progress.done);
    return text.contains(u"%1"_s) ? text.arg(subject) : text;
}
