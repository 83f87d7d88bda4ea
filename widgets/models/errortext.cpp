// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/errortext.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class Words
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

}  // namespace

QString ErrorText::oneLine() const
{
    QStringList parts{what};
    for (const QString &part : {meaning, cure}) {
        if (!part.isEmpty())
            parts.append(part);
    }
    QString text = parts.join(u' ');
    if (!detail.isEmpty())
        text += u" ("_s + detail + u')';
    return text;
}

ErrorText describe(const Error &error)
{
    ErrorText text;
    text.detail = error.detail;
    switch (error.code) {
    case ErrorCode::Cancelled: text.what = Words::tr("Cancelled."); break;
    case ErrorCode::Timeout:
        text.what = Words::tr("The board did not answer in time.");
        text.meaning = Words::tr("It may be busy, restarting, or the cable may be disturbed.");
        text.cure = Words::tr("Try again; if it stays so, check cable and power.");
        break;
    case ErrorCode::LinkClosed:
        text.what = Words::tr("The link to the board broke.");
        text.meaning = Words::tr("The board keeps doing what it did.");
        text.cure = Words::tr("Check cable and power; the program connects again by itself.");
        break;
    case ErrorCode::PortNotFound:
        text.what = Words::tr("There is no such port.");
        text.meaning = Words::tr("The adapter is not plugged in, or it has another name now.");
        text.cure = Words::tr("Plug it in and choose it from the list.");
        break;
    case ErrorCode::NoPermission:
        text.what = Words::tr("You may not open this port.");
        text.meaning = Words::tr("On Linux, serial ports belong to the group dialout.");
        text.cure = Words::tr("Run “sudo usermod -aG dialout $USER”, then log in anew.");
        break;
    case ErrorCode::PortBusy:
        text.what = Words::tr("Another program holds this port.");
        text.meaning = Words::tr("Only one program can talk to a board at a time.");
        text.cure
            = Words::tr("Close the other program (ModemManager is a usual suspect), then connect again.");
        break;
    case ErrorCode::HostUnreachable:
        text.what = Words::tr("Nothing answers at this network address.");
        text.cure = Words::tr("Check address and port, and that the bridge or simulator is running.");
        break;
    case ErrorCode::Silent:
        text.what = Words::tr("The port is open, but no board answers.");
        text.meaning = Words::tr("All rates and parities were tried.");
        text.cure = Words::tr(
            "Check that the board has power, that RX and TX are crossed, and that this is the right port.");
        break;
    case ErrorCode::Garbage:
        text.what = Words::tr("Bytes arrive, but they make no sense.");
        text.meaning
            = Words::tr("The rate is unknown, the cable is disturbed, or it is another kind of device.");
        text.cure = Words::tr("Check cable and ground, and that this is the gimbal's port.");
        break;
    case ErrorCode::WrongProtocol:
        text.what = Words::tr("This device speaks another protocol.");
        text.meaning = Words::tr("It is not a board of the chosen family.");
        text.cure = Words::tr("Choose the right family, or another port.");
        break;
    case ErrorCode::ReadOnly:
        text.what = Words::tr("This board is open for reading only.");
        text.meaning = Words::tr("It is a recording, or its firmware or this value must not be written by "
                                 "this version of the program.");
        text.cure = Words::tr(
            "Connect the board itself, update the program, or change the value with the board maker's tool.");
        break;
    case ErrorCode::Damaged:
        text.what = Words::tr("The command reached the board damaged.");
        text.meaning
            = Words::tr("The board threw it away, also when it was repeated; nothing was changed by it.");
        text.cure = Words::tr("The line is disturbed: check cable, ground and rate, then try again.");
        break;
    case ErrorCode::BoardError:
        text.what = Words::tr("The board refused.");
        text.meaning = Words::tr("Nothing was changed by this command.");
        break;
    case ErrorCode::BadReply:
        text.what = Words::tr("The board's answer is not what its document promises.");
        text.cure = Words::tr("Try again; if it stays so, the firmware is not supported.");
        break;
    case ErrorCode::InvalidArgument: text.what = Words::tr("That does not make sense."); break;
    case ErrorCode::OutOfRange:
        text.what = Words::tr("The value is outside its range.");
        text.meaning = Words::tr("Nothing was changed.");
        break;
    case ErrorCode::Unsupported: text.what = Words::tr("This board cannot do that."); break;
    case ErrorCode::Conflict:
        text.what = Words::tr("Somebody else changed the board since it was read.");
        text.meaning = Words::tr("Nothing was written.");
        text.cure = Words::tr("Read the board again, look at the differences, then write.");
        break;
    case ErrorCode::VerifyFailed:
        text.what = Words::tr("The board does not hold what was written.");
        text.meaning = Words::tr("The old values were put back as far as the board let us.");
        text.cure = Words::tr("Look at the report; try again, or restore the snapshot.");
        break;
    case ErrorCode::BadFile: text.what = Words::tr("The file cannot be used."); break;
    case ErrorCode::NotConnected:
        text.what = Words::tr("No board is connected.");
        text.cure = Words::tr("Connect one, or try the simulated gimbal.");
        break;
    case ErrorCode::NoBackup:
        text.what = Words::tr("No safety copy could be made.");
        text.meaning = Words::tr("Therefore nothing was changed.");
        text.cure = Words::tr("Check that the disk has space and that the folder may be written.");
        break;
    case ErrorCode::TooMuch:
        text.what = Words::tr("The line cannot carry so much.");
        text.meaning = Words::tr("Samples would be lost; nothing was changed.");
        text.cure = Words::tr("Ask for fewer channels, a lower rate, or set a faster serial speed.");
        break;
    case ErrorCode::Unready:
        text.what = Words::tr("The test could not be made.");
        text.meaning = Words::tr("The camera has to be held by running motors, and live data has to come.");
        text.cure = Words::tr("Switch the motors on, let the camera settle, then try again.");
        break;
    case ErrorCode::ConditionUnmet:
        text.what = Words::tr("The board is not in the state that this action needs.");
        text.meaning = Words::tr("Nothing was sent to it.");
        text.cure = Words::tr("The details say what has to be so first.");
        break;
    case ErrorCode::NotSeen:
        text.what = Words::tr("What was waited for did not come.");
        text.meaning = Words::tr("This step was given up; nothing was stored.");
        text.cure = Words::tr("The details say what was missing. Put it right and do the step again.");
        break;
    case ErrorCode::NotRestored:
        text.what = Words::tr("The values that were in use could not be put back.");
        text.meaning = Words::tr("The board uses its stored values now; nothing that is stored was changed.");
        text.cure = Words::tr("The details list what was in use. Set it again if you want to keep it.");
        break;
    case ErrorCode::Diverged:
        text.what = Words::tr("The axis did not follow; the motors were switched off.");
        text.meaning = Words::tr("It moved further than the test allows.");
        text.cure
            = Words::tr("Lower the gains or make the movement smaller, then switch the motors on again.");
        break;
    case ErrorCode::NotProven:
        text.what = Words::tr("The board did not confirm that the motors are off.");
        text.meaning = Words::tr("They may still be running.");
        text.cure = Words::tr("Hold the camera and disconnect the power.");
        break;
    case ErrorCode::Busy:
        text.what = Words::tr("Another job is still running.");
        text.cure = Words::tr("Wait for it or cancel it.");
        break;
    }
    return text;
}

QString describe(const Progress &progress)
{
    if (progress.step == u"probe"_s) {
        return progress.subject.isEmpty() ? Words::tr("Looking for a board")
                                          : Words::tr("Looking for a board at %1").arg(progress.subject);
    }
    if (progress.step == u"read-block"_s)
        return Words::tr("Reading %1").arg(progress.subject);
    if (progress.step == u"write-block"_s)
        return Words::tr("Writing %1").arg(progress.subject);
    if (progress.step == u"await-restart"_s)
        return Words::tr("%1 is written; waiting for the board to restart").arg(progress.subject);
    if (progress.step == u"verify-block"_s)
        return Words::tr("Reading back %1").arg(progress.subject);
    if (progress.step == u"roll-back"_s)
        return Words::tr("Putting back %1").arg(progress.subject);
    if (progress.step == u"calibrate"_s)
        return Words::tr("Calibrating: keep the camera absolutely still");
    if (progress.step == u"place-sensor"_s)
        return Words::tr("Lay the sensor still on one of its faces");
    if (progress.step == u"level-camera"_s)
        return Words::tr("Hold the camera level and still");
    if (progress.step == u"tilt-camera"_s)
        return Words::tr("Tilt the camera about 45° down, without rolling it");
    if (progress.step == u"wait-battery"_s)
        return Words::tr("Connect the battery");
    if (progress.step == u"wait-start"_s)
        return Words::tr("The board starts; keep the camera still");
    if (progress.step == u"autotune"_s)
        return Words::tr("Auto-tune, iteration %1").arg(progress.done);
    if (progress.step == u"motion-test"_s)
        return Words::tr("Measuring how the axis follows");
    if (progress.step == u"steer"_s)
        return Words::tr("Steering");
    return progress.step;
}
