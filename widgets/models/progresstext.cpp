// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/errortext.h"

#include <QCoreApplication>

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

}  // namespace

QString describe(const Progress &progress)
{
    const QString part = subjectText(progress.subject);
    const QString subject = progress.profile < 0
        ? part
        : ProgressWords::tr("%1 of profile %2").arg(part).arg(progress.profile + 1);
    if (progress.step == u"probe"_s) {
        return subject.isEmpty() ? ProgressWords::tr("Looking for a board")
                                 : ProgressWords::tr("Looking for a board at %1").arg(subject);
    }
    if (progress.step == u"read-block"_s)
        return ProgressWords::tr("Reading %1").arg(subject);
    if (progress.step == u"write-block"_s)
        return ProgressWords::tr("Writing %1").arg(subject);
    if (progress.step == u"await-restart"_s && progress.subject == kTextBlock)
        return ProgressWords::tr("The configuration text is written; waiting for the drone to restart");
    if (progress.step == u"await-restart"_s)
        return ProgressWords::tr("%1 is written; waiting for the board to restart").arg(subject);
    if (progress.step == u"verify-block"_s)
        return ProgressWords::tr("Reading back %1").arg(subject);
    if (progress.step == u"roll-back"_s)
        return ProgressWords::tr("Putting back %1").arg(subject);
    if (progress.step == u"calibrate"_s)
        return ProgressWords::tr("Calibrating: keep the camera absolutely still");
    if (progress.step == u"setup-hold"_s)
        return ProgressWords::tr("Hold the camera level and still");
    if (progress.step == u"setup-let-go"_s)
        return ProgressWords::tr("Take your hands off the camera, keep them beneath it, and tip it lightly");
    if (progress.step == u"setup-tilt-level"_s)
        return ProgressWords::tr("Hold the camera level and still, until you are asked for something else");
    if (progress.step == u"setup-tilt-right"_s)
        return ProgressWords::tr("Tilt the right side of the camera down by about 45° and hold it there");
    if (progress.step == u"setup-tilt-down"_s)
        return ProgressWords::tr("Tilt the nose of the camera down by about 45° and hold it there");
    if (progress.step == u"setup-move"_s)
        return ProgressWords::tr("Move the camera slowly as far as it may go, each axis both ways");
    if (progress.step == u"setup-run"_s)
        return ProgressWords::tr("The motors run: watching whether an axis runs away");
    if (progress.step == u"setup-measure"_s)
        return ProgressWords::tr("Measuring");
    if (progress.step == u"calibrate-motors"_s)
        return ProgressWords::tr("The board turns the motors and measures them");
    if (progress.step == u"calibrate-encoders"_s)
        return ProgressWords::tr("The board reads its encoders: leave the camera as it stands");
    if (progress.step == u"calibrate-frame"_s)
        return ProgressWords::tr("Tilt the frame by hand to all sides");
    if (progress.step == u"calibrate-magnetometer"_s)
        return ProgressWords::tr("Turn the camera in all directions: %1 of 8 are seen").arg(progress.done);
    if (progress.step == u"read-memory"_s)
        return ProgressWords::tr("Reading the board's memory");
    if (progress.step == u"write-memory"_s)
        return ProgressWords::tr("Writing the board's memory");
    if (progress.step == u"read-file"_s)
        return ProgressWords::tr("Reading a file of the board");
    if (progress.step == u"write-file"_s)
        return ProgressWords::tr("Writing a file of the board");
    if (progress.step == u"script"_s)
        return ProgressWords::tr("Script %1 runs: command %2")
            .arg(subject)
            .arg(int(progress.values.value(u"command"_s)));
    if (progress.step == u"search-bus"_s)
        return ProgressWords::tr("Asking each address of the bus");
    if (progress.step == u"feed"_s)
        return ProgressWords::tr("Sending the rows of the file, each at its time");
    if (progress.step == u"calibrate-drone"_s)
        return ProgressWords::tr("Calibrating: leave the drone alone");
    if (progress.step == u"motor-test"_s)
        return ProgressWords::tr("The motor is tested; the drone hears nothing meanwhile");
    if (progress.step == u"escs-off"_s)
        return ProgressWords::tr("Motor controllers: no signal; the drone hears nothing for 26 s");
    if (progress.step == u"escs-full"_s)
        return ProgressWords::tr("Motor controllers: FULL THROTTLE; the drone hears nothing");
    if (progress.step == u"escs-zero"_s)
        return ProgressWords::tr("Motor controllers: zero; the drone hears nothing");
    if (progress.step == u"firmware-upload"_s)
        return ProgressWords::tr("Uploading the firmware");
    if (progress.step == u"firmware-restart"_s)
        return ProgressWords::tr(
            "The firmware is on the drone; waiting for its restart. Do not switch it off");
    if (progress.step == u"place-sensor"_s)
        return ProgressWords::tr("Lay the sensor still on one of its faces");
    if (progress.step == u"level-camera"_s)
        return ProgressWords::tr("Hold the camera level and still");
    if (progress.step == u"tilt-camera"_s)
        return ProgressWords::tr("Tilt the camera about 45° down, without rolling it");
    if (progress.step == u"wait-battery"_s)
        return ProgressWords::tr("Connect the battery");
    if (progress.step == u"wait-start"_s)
        return ProgressWords::tr("The board starts; keep the camera still");
    if (progress.step == u"autotune"_s)
        return ProgressWords::tr("Auto-tune, iteration %1").arg(progress.done);
    if (progress.step == u"motion-test"_s)
        return ProgressWords::tr("Measuring how the axis follows");
    if (progress.step == u"measure-before"_s)
        return ProgressWords::tr("Measuring without the notch");
    if (progress.step == u"measure-after"_s)
        return ProgressWords::tr("Measuring with the notch");
    if (progress.step == u"steer"_s)
        return ProgressWords::tr("Steering");
    return progress.step;
}
