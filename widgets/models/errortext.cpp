// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/errortext.h"

#include "protocol/configuration/writereport.h"
#include "widgets/models/numbertext.h"

#include <QCoreApplication>

#include <array>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class Words
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)
};

/// What the operator reads of one code.
struct ErrorRow
{
    ErrorCode code;
    const char *what;
    const char *meaning = nullptr;  ///< for the gimbal
    const char *cure = nullptr;
};

// clang-format off
constexpr auto kErrors = std::to_array<ErrorRow>({
    {ErrorCode::Cancelled,
     QT_TRANSLATE_NOOP("ErrorText", "Cancelled.")},
    {ErrorCode::Timeout,
     QT_TRANSLATE_NOOP("ErrorText", "The board did not answer in time."),
     QT_TRANSLATE_NOOP("ErrorText", "It may be busy, restarting, or the cable may be disturbed."),
     QT_TRANSLATE_NOOP("ErrorText", "Try again; if that does not help, check cable and power.")},
    {ErrorCode::LinkClosed,
     QT_TRANSLATE_NOOP("ErrorText", "The link to the board broke."),
     QT_TRANSLATE_NOOP("ErrorText", "The board keeps doing what it did."),
     QT_TRANSLATE_NOOP("ErrorText", "Check cable and power; the program connects again by itself.")},
    {ErrorCode::PortNotFound,
     QT_TRANSLATE_NOOP("ErrorText", "There is no such port."),
     QT_TRANSLATE_NOOP("ErrorText", "The adapter is not plugged in, or it has another name now."),
     QT_TRANSLATE_NOOP("ErrorText", "Plug it in and choose it from the list.")},
    {ErrorCode::NoPermission,
     QT_TRANSLATE_NOOP("ErrorText", "You may not open this port."),
     QT_TRANSLATE_NOOP("ErrorText", "On Linux, serial ports belong to the group dialout."),
     QT_TRANSLATE_NOOP("ErrorText", "Run “sudo usermod -aG dialout $USER”, then log in again.")},
    {ErrorCode::PortBusy,
     QT_TRANSLATE_NOOP("ErrorText", "Another program holds this port."),
     QT_TRANSLATE_NOOP("ErrorText", "Only one program can talk to a board at a time."),
     QT_TRANSLATE_NOOP("ErrorText", "Close the other program (ModemManager is a usual suspect), then connect again.")},
    {ErrorCode::HostUnreachable,
     QT_TRANSLATE_NOOP("ErrorText", "Nothing answers at this network address."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Check address and port, and that the bridge or simulator is running.")},
    {ErrorCode::Silent,
     QT_TRANSLATE_NOOP("ErrorText", "The port is open, but no board answers."),
     QT_TRANSLATE_NOOP("ErrorText", "Not one byte came back; the details say what was tried."),
     QT_TRANSLATE_NOOP("ErrorText", "Check that the board has power, that RX and TX are crossed, and that this is the right port.")},
    {ErrorCode::SilentPeer,
     QT_TRANSLATE_NOOP("ErrorText", "The connection stands, but no board answers."),
     QT_TRANSLATE_NOOP("ErrorText", "Not one byte came back."),
     QT_TRANSLATE_NOOP("ErrorText", "Check that this is the gimbal's address and port, that the board behind it has power, and that nobody else is connected to it.")},
    {ErrorCode::Garbage,
     QT_TRANSLATE_NOOP("ErrorText", "Bytes arrive, but they make no sense."),
     QT_TRANSLATE_NOOP("ErrorText", "The rate is unknown, the cable is disturbed, or it is another kind of device."),
     QT_TRANSLATE_NOOP("ErrorText", "Check cable and ground, and that this is the gimbal's port.")},
    {ErrorCode::WrongProtocol,
     QT_TRANSLATE_NOOP("ErrorText", "This device speaks another protocol."),
     QT_TRANSLATE_NOOP("ErrorText", "It is not a board of the chosen family."),
     QT_TRANSLATE_NOOP("ErrorText", "Choose the right family, or another port.")},
    {ErrorCode::ReadOnly,
     QT_TRANSLATE_NOOP("ErrorText", "This board is open for reading only."),
     QT_TRANSLATE_NOOP("ErrorText", "It is a recording, or its firmware or this value must not be written by this version of the program."),
     QT_TRANSLATE_NOOP("ErrorText", "Connect the board itself, update the program, or change the value with the board maker's tool.")},
    {ErrorCode::Damaged,
     QT_TRANSLATE_NOOP("ErrorText", "The command reached the board damaged."),
     QT_TRANSLATE_NOOP("ErrorText", "The board discarded it, even when it was repeated; it changed nothing."),
     QT_TRANSLATE_NOOP("ErrorText", "The line is disturbed: check cable, ground and rate, then try again.")},
    {ErrorCode::BoardError,
     QT_TRANSLATE_NOOP("ErrorText", "The board refused."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was changed by this command.")},
    {ErrorCode::BadReply,
     QT_TRANSLATE_NOOP("ErrorText", "The board's answer does not match its documentation."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Try again; if that does not help, the firmware is not supported.")},
    {ErrorCode::InvalidArgument,
     QT_TRANSLATE_NOOP("ErrorText", "That does not make sense.")},
    {ErrorCode::OutOfRange,
     QT_TRANSLATE_NOOP("ErrorText", "The value is outside its range."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was changed.")},
    {ErrorCode::Contradiction,
     QT_TRANSLATE_NOOP("ErrorText", "Two values exclude each other."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was written."),
     QT_TRANSLATE_NOOP("ErrorText", "Change one of the two so that both can hold, then write again.")},
    {ErrorCode::Unsupported,
     QT_TRANSLATE_NOOP("ErrorText", "This board cannot do that.")},
    {ErrorCode::Conflict,
     QT_TRANSLATE_NOOP("ErrorText", "Somebody else changed the board since it was read."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was written."),
     QT_TRANSLATE_NOOP("ErrorText", "Read the board again, look at the differences, then write.")},
    {ErrorCode::VerifyFailed,
     QT_TRANSLATE_NOOP("ErrorText", "The board does not hold what was written."),
     QT_TRANSLATE_NOOP("ErrorText", "The old values were put back as far as the board let us."),
     QT_TRANSLATE_NOOP("ErrorText", "Look at the report; try again, or restore the snapshot.")},
    {ErrorCode::BadFile,
     QT_TRANSLATE_NOOP("ErrorText", "The file cannot be used.")},
    {ErrorCode::NotConnected,
     QT_TRANSLATE_NOOP("ErrorText", "No board is connected."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Connect one, or try the simulated gimbal.")},
    {ErrorCode::Incomplete,
     QT_TRANSLATE_NOOP("ErrorText", "Parts of the board could not be read."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing is known about the values in them; they are not shown, compared or saved."),
     QT_TRANSLATE_NOOP("ErrorText", "Read the board again; if parts keep missing, check cable and power.")},
    {ErrorCode::NoBackup,
     QT_TRANSLATE_NOOP("ErrorText", "No safety copy could be made."),
     QT_TRANSLATE_NOOP("ErrorText", "Therefore nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Check that the disk has space and that the folder may be written.")},
    {ErrorCode::TooMuch,
     QT_TRANSLATE_NOOP("ErrorText", "The line cannot carry that much data."),
     QT_TRANSLATE_NOOP("ErrorText", "Samples would be lost; nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Ask for fewer channels, a lower rate, or set a faster serial speed.")},
    {ErrorCode::Unready,
     QT_TRANSLATE_NOOP("ErrorText", "The test could not be made."),
     QT_TRANSLATE_NOOP("ErrorText", "The camera has to be held by running motors, and live data has to come."),
     QT_TRANSLATE_NOOP("ErrorText", "Switch the motors on, let the camera settle, then try again.")},
    {ErrorCode::ConditionUnmet,
     QT_TRANSLATE_NOOP("ErrorText", "The board is not in the state that this action needs."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was sent to it."),
     QT_TRANSLATE_NOOP("ErrorText", "The details say which condition must be met first.")},
    {ErrorCode::NotSeen,
     QT_TRANSLATE_NOOP("ErrorText", "What the procedure waited for did not happen."),
     QT_TRANSLATE_NOOP("ErrorText", "This step was given up; nothing was stored."),
     QT_TRANSLATE_NOOP("ErrorText", "The details say what was missing. Correct it and repeat the step.")},
    {ErrorCode::NotRestored,
     QT_TRANSLATE_NOOP("ErrorText", "The values that were in use could not be put back."),
     QT_TRANSLATE_NOOP("ErrorText", "The board uses its stored values now; nothing that is stored was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "The details list what was in use. Set it again if you want to keep it.")},
    {ErrorCode::Diverged,
     QT_TRANSLATE_NOOP("ErrorText", "The axis did not follow; the motors were switched off."),
     QT_TRANSLATE_NOOP("ErrorText", "It moved further than the test allows."),
     QT_TRANSLATE_NOOP("ErrorText", "Lower the gains or make the movement smaller, then switch the motors on again.")},
    {ErrorCode::NoSamples,
     QT_TRANSLATE_NOOP("ErrorText", "No live data come."),
     QT_TRANSLATE_NOOP("ErrorText", "The board sends none, or none that can be read; what came before is kept."),
     QT_TRANSLATE_NOOP("ErrorText", "Check cable and power, and that the board still answers; then start again.")},
    {ErrorCode::TooFewSamples,
     QT_TRANSLATE_NOOP("ErrorText", "There are too few samples."),
     QT_TRANSLATE_NOOP("ErrorText", "From so few nothing can be told that would be true."),
     QT_TRANSLATE_NOOP("ErrorText", "Record longer, or choose channels that were recorded.")},
    {ErrorCode::NotProven,
     QT_TRANSLATE_NOOP("ErrorText", "The board did not confirm that the motors are off."),
     QT_TRANSLATE_NOOP("ErrorText", "They may still be running."),
     QT_TRANSLATE_NOOP("ErrorText", "Hold the camera and disconnect the power.")},
    {ErrorCode::NotInUse,
     QT_TRANSLATE_NOOP("ErrorText", "The board does not use the value that was set."),
     QT_TRANSLATE_NOOP("ErrorText", "It confirmed the value and reports another. Nothing that is stored was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "See whether a remote control, a script or another program sets it too, then try again.")},
    {ErrorCode::NoEffect,
     QT_TRANSLATE_NOOP("ErrorText", "The board acknowledged the command but did not carry it out."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "The details say what is missing, as far as the board tells.")},
    {ErrorCode::Busy,
     QT_TRANSLATE_NOOP("ErrorText", "Another job is still running."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Wait for it or cancel it.")},
});
// clang-format on

constexpr bool everyCodeHasItsRow()
{
    if (kErrors.size() != kErrorCodes)
        return false;
    for (std::size_t i = 0; i < kErrors.size(); ++i) {
        if (std::size_t(kErrors[i].code) != i)
            return false;
    }
    return true;
}
static_assert(everyCodeHasItsRow(), "one row for each code, in the order of ErrorCode");

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
    const ErrorRow &row = kErrors.at(std::size_t(error.code));
    const auto words = [](const char *text) { return text ? Words::tr(text) : QString(); };
    return {words(row.what), words(row.meaning), words(row.cure), withNumbers(error.detail)};
}

ErrorText describe(const WriteReport &report)
{
    ErrorText text = describe(report.error.value_or(Error{}));
    QStringList counts;
    const auto count = [&](WriteState state, const char *words) {
        if (const int n = report.count(state))
            counts.append(Words::tr(words, nullptr, n));
    };
    count(WriteState::Verified, QT_TRANSLATE_N_NOOP("ErrorText", "%n verified"));
    count(WriteState::RolledBack, QT_TRANSLATE_N_NOOP("ErrorText", "%n put back"));
    count(WriteState::Unknown, QT_TRANSLATE_N_NOOP("ErrorText", "%n unknown"));
    count(WriteState::NotWritten, QT_TRANSLATE_N_NOOP("ErrorText", "%n not written"));
    count(WriteState::Mismatch, QT_TRANSLATE_N_NOOP("ErrorText", "%n different"));
    text.what = Words::tr("The write is not complete: %1. ").arg(counts.join(u", "_s)) + text.what;
    // Nothing that the error means in general stands beside what was read.
    if (const int unknown = report.count(WriteState::Unknown))
        text.meaning = Words::tr("What the board holds of %n value(s) could not be read.", nullptr, unknown);
    else if (const int other = report.countOther())
        text.meaning
            = Words::tr("The board was read again: %n value(s) are not as they were before.", nullptr, other);
    else
        text.meaning = Words::tr("The board was read again: it holds the old values.");
    return text;
}

QString describe(const Progress &progress)
{
    const QString subject = progress.profile < 0
        ? progress.subject
        : Words::tr("%1 of profile %2").arg(progress.subject).arg(progress.profile + 1);
    if (progress.step == u"probe"_s) {
        return subject.isEmpty() ? Words::tr("Looking for a board")
                                 : Words::tr("Looking for a board at %1").arg(subject);
    }
    if (progress.step == u"read-block"_s)
        return Words::tr("Reading %1").arg(subject);
    if (progress.step == u"write-block"_s)
        return Words::tr("Writing %1").arg(subject);
    if (progress.step == u"await-restart"_s)
        return Words::tr("%1 is written; waiting for the board to restart").arg(subject);
    if (progress.step == u"verify-block"_s)
        return Words::tr("Reading back %1").arg(subject);
    if (progress.step == u"roll-back"_s)
        return Words::tr("Putting back %1").arg(subject);
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
    if (progress.step == u"measure-before"_s)
        return Words::tr("Measuring without the notch");
    if (progress.step == u"measure-after"_s)
        return Words::tr("Measuring with the notch");
    if (progress.step == u"steer"_s)
        return Words::tr("Steering");
    return progress.step;
}
