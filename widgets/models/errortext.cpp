// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/errortext.h"

#include "protocol/base/filefault.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/configuration/writereport.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QCoreApplication>

#include <array>
#include <utility>

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
    const char *told = nullptr;  ///< in place of `what` where there is a detail, which it takes in
    const char *motors = nullptr;
};

// clang-format off
constexpr auto kErrors = std::to_array<ErrorRow>({
    {ErrorCode::Cancelled,
     QT_TRANSLATE_NOOP("ErrorText", "Cancelled.")},
    {ErrorCode::Timeout,
     QT_TRANSLATE_NOOP("ErrorText", "The board did not answer in time."),
     QT_TRANSLATE_NOOP("ErrorText", "It may be busy, restarting, or the cable or the network may be disturbed."),
     QT_TRANSLATE_NOOP("ErrorText", "Try again; if that does not help, check its cable or network, and its power.")},
    {ErrorCode::LinkClosed,
     QT_TRANSLATE_NOOP("ErrorText", "The link to the board broke."),
     QT_TRANSLATE_NOOP("ErrorText", "What the board does now is not known: it may go on as before, or have restarted and run its motors."),
     QT_TRANSLATE_NOOP("ErrorText", "Check its cable or network, and its power; the program connects again by itself.")},
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
     QT_TRANSLATE_NOOP("ErrorText", "Check that this is the board's address and port, that the board behind it has power, and that nobody else is connected to it.")},
    {ErrorCode::Garbage,
     QT_TRANSLATE_NOOP("ErrorText", "Bytes arrive, but they make no sense."),
     QT_TRANSLATE_NOOP("ErrorText", "It is another kind of device, or, on a cable, the rate is unknown or the cable is disturbed."),
     QT_TRANSLATE_NOOP("ErrorText", "Check that this is the board's port or address; on a cable, check it and its ground.")},
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
     QT_TRANSLATE_NOOP("ErrorText", "The line is disturbed: on a cable, check it, its ground and its rate; in a network, go nearer. Then try again.")},
    {ErrorCode::BoardError,
     QT_TRANSLATE_NOOP("ErrorText", "The board refused."),
     QT_TRANSLATE_NOOP("ErrorText", "It says that it has not carried out this command.")},
    {ErrorCode::BadReply,
     QT_TRANSLATE_NOOP("ErrorText", "The board's answer does not match its documentation."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Try again; if that does not help, the firmware is not supported.")},
    {ErrorCode::InvalidArgument,
     QT_TRANSLATE_NOOP("ErrorText", "What was entered cannot be used."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Correct it, then try again."),
     QT_TRANSLATE_NOOP("ErrorText", "What was entered cannot be used: %1.")},
    {ErrorCode::OutOfRange,
     QT_TRANSLATE_NOOP("ErrorText", "The value is outside its range."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was changed."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "The value is outside its range: %1.")},
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
     QT_TRANSLATE_NOOP("ErrorText", "The file cannot be used."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was taken from it or saved to it."),
     QT_TRANSLATE_NOOP("ErrorText", "Use another copy, or choose another file."),
     QT_TRANSLATE_NOOP("ErrorText", "The file cannot be used: %1.")},
    {ErrorCode::NotConnected,
     QT_TRANSLATE_NOOP("ErrorText", "No board is connected."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Connect one, or try the simulated gimbal.")},
    {ErrorCode::Incomplete,
     QT_TRANSLATE_NOOP("ErrorText", "Parts of the board could not be read."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing is known about the values in them; they are not shown, compared or saved."),
     QT_TRANSLATE_NOOP("ErrorText", "Read the board again; if parts keep missing, check its cable or network, and its power.")},
    {ErrorCode::NoBackup,
     QT_TRANSLATE_NOOP("ErrorText", "No safety copy could be made."),
     QT_TRANSLATE_NOOP("ErrorText", "Therefore nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Check that the disk has space and that the folder may be written.")},
    {ErrorCode::TooMuch,
     QT_TRANSLATE_NOOP("ErrorText", "The line cannot carry that much data."),
     QT_TRANSLATE_NOOP("ErrorText", "Samples would be lost; nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Ask for fewer channels or a lower rate; on a cable, set a faster serial speed.")},
    {ErrorCode::Unready,
     QT_TRANSLATE_NOOP("ErrorText", "The board is not ready for this."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was stored. A test needs running motors that hold the camera, and live data; comparing and storing need a board that has started."),
     QT_TRANSLATE_NOOP("ErrorText", "The details say what is missing. Let the board start and the camera settle, then try again.")},
    {ErrorCode::ConditionUnmet,
     QT_TRANSLATE_NOOP("ErrorText", "The board is not in the state that this action needs."),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "The details say which condition must be met first.")},
    {ErrorCode::NotSeen,
     QT_TRANSLATE_NOOP("ErrorText", "What the procedure waited for did not happen."),
     QT_TRANSLATE_NOOP("ErrorText", "This step was given up; nothing was stored."),
     QT_TRANSLATE_NOOP("ErrorText", "The details say what was missing. Correct it and repeat the step.")},
    {ErrorCode::NotRestored,
     QT_TRANSLATE_NOOP("ErrorText", "The values that were in use could not be put back."),
     QT_TRANSLATE_NOOP("ErrorText", "The board may use other values now; nothing that is stored was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "The details list what was in use and, where it could be read, what is now. Set it again if you want to keep it.")},
    {ErrorCode::Diverged,
     QT_TRANSLATE_NOOP("ErrorText", "The axis did not follow; the motors were switched off."),
     QT_TRANSLATE_NOOP("ErrorText", "It moved further than the test allows."),
     QT_TRANSLATE_NOOP("ErrorText", "Lower the gains or make the movement smaller, then start the motors again.")},
    {ErrorCode::NoSamples,
     QT_TRANSLATE_NOOP("ErrorText", "No live data come."),
     QT_TRANSLATE_NOOP("ErrorText", "The board sends none, none that can be read, or the same again and again; what came before is kept."),
     QT_TRANSLATE_NOOP("ErrorText", "Check its cable or network and its power, and that the board still answers; then start again.")},
    {ErrorCode::TooFewSamples,
     QT_TRANSLATE_NOOP("ErrorText", "There are too few samples."),
     QT_TRANSLATE_NOOP("ErrorText", "From so few nothing can be told that would be true."),
     QT_TRANSLATE_NOOP("ErrorText", "Record longer, or choose channels that were recorded.")},
    {ErrorCode::NoMotion,
     QT_TRANSLATE_NOOP("ErrorText", "The values do not change."),
     QT_TRANSLATE_NOOP("ErrorText", "Either nothing moved by as much as the board tells apart, or it sent old values again and again."),
     QT_TRANSLATE_NOOP("ErrorText", "Let the gimbal work while it is measured: walk with it, or shake its frame.")},
    {ErrorCode::NotProven,
     QT_TRANSLATE_NOOP("ErrorText", "The board did not confirm that the motors are off."),
     QT_TRANSLATE_NOOP("ErrorText", "They may still be running."),
     QT_TRANSLATE_NOOP("ErrorText", "Hold the camera and disconnect the power.")},
    {ErrorCode::NotInUse,
     QT_TRANSLATE_NOOP("ErrorText", "The board does not use the value that was set."),
     QT_TRANSLATE_NOOP("ErrorText", "It confirmed the value and reports another. Nothing that is stored was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "See whether a remote control, a script or another program sets it too, then try again.")},
    {ErrorCode::NotStored,
     QT_TRANSLATE_NOOP("ErrorText", "The board has not stored everything that it uses."),
     QT_TRANSLATE_NOOP("ErrorText", "A restart brings the stored values back."),
     QT_TRANSLATE_NOOP("ErrorText", "Store once more. If that does not help, save the values into a file.")},
    {ErrorCode::NoEffect,
     QT_TRANSLATE_NOOP("ErrorText", "The board acknowledged the command but did not carry it out."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "The details say what is missing, as far as the board tells.")},
    {ErrorCode::Disabled,
     QT_TRANSLATE_NOOP("ErrorText", "The motors are disabled in the board's volatile memory: it did not obey the ordinary stop."),
     QT_TRANSLATE_NOOP("ErrorText", "Stored now, they would stay disabled; so nothing was changed."),
     QT_TRANSLATE_NOOP("ErrorText", "Wait until the board reaches standby, or restart it.")},
    {ErrorCode::GoesOn,
     QT_TRANSLATE_NOOP("ErrorText", "The board goes on with what it was told to end."),
     QT_TRANSLATE_NOOP("ErrorText", "It may be moving the camera."),
     QT_TRANSLATE_NOOP("ErrorText", "Stop the motors.")},
    {ErrorCode::Restarted,
     QT_TRANSLATE_NOOP("ErrorText", "The board restarted by itself."),
     QT_TRANSLATE_NOOP("ErrorText", "What was in use without being stored is lost."),
     QT_TRANSLATE_NOOP("ErrorText", "Check its supply voltage and its cables."),
     nullptr,
     QT_TRANSLATE_NOOP("ErrorText", "Its motors may run again.")},
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
    for (const QString &part : {meaning, motors, cure}) {
        if (!part.isEmpty())
            parts.append(part);
    }
    QString text = parts.join(u' ');
    if (!detail.isEmpty())
        text += u" ("_s + detail + u')';
    return text;
}

// What an error means in general does not stand beside what was read, or could not be read.
static void tellAftermath(const Aftermath &after, ErrorText &text)
{
    constexpr int kTold = 12;
    QStringList told;
    for (const ParameterChange &change : after.changes()) {
        told.append(changePlace(after.before, change)
                    + u"%1 %2 -> %3"_s.arg(change.spec->key, change.spec->format(change.from),
                                           change.spec->format(change.to)));
    }
    for (const DataChange &change : after.dataChanges())
        told.append(QLatin1String(change.spec->data));
    const auto count = int(told.size());
    const QStringList lost = after.lost();
    if (!after.now)
        text.meaning = Words::tr("What the board holds now could not be read.");
    else if (count > 0)
        text.meaning
            = Words::tr("The board was read again: %n value(s) are not as they were before.", nullptr, count);
    else if (!lost.isEmpty())
        text.meaning = Words::tr("The board was read again, but not all of it: what was read is as before.");
    else if (after.isInUse)
        text.meaning = Words::tr("The board was read again: it uses the old values.");
    else
        text.meaning = Words::tr("The board was read again: it holds the old values.");
    if (after.now && after.now->activeProfile() != after.before.activeProfile())
        text.meaning += u' '
            + Words::tr("The active profile is now %1; before it was %2.")
                  .arg(after.now->activeProfile() + 1)
                  .arg(after.before.activeProfile() + 1);
    if (after.now && after.isStoring && count > 0)
        text.meaning = Words::tr("The board was read again: it has stored %n other value(s) than before.",
                                 nullptr, count);
    if (after.now && after.isStoreUntold)
        text.meaning
            = Words::tr("Whether the values in use are stored now shows only when the board has restarted.");
    if (count > 0 && after.isUnstored)
        text.meaning += u' ' + Words::tr("Where they are not stored, a restart brings the stored ones back.");
    if (after.now && after.isBlind)
        text.meaning += u' ' + Words::tr("Whether sensors were calibrated cannot be seen from that.");
    else if (after.now && after.isUnseen)
        text.meaning += u' ' + Words::tr("Whether it was carried out cannot be seen from that.");
    if (!after.snapshotPath.isEmpty() && (count > 0 || !after.now || !lost.isEmpty()))
        text.cure
            = Words::tr("The snapshot holds what was there before: compare, and restore it if need be.");
    QStringList details;
    if (!text.detail.isEmpty())
        details.append(text.detail);
    details += told.mid(0, kTold);
    if (count > kTold)
        details.append(Words::tr("and %n more", nullptr, count - kTold));
    if (!lost.isEmpty())
        details.append(Words::tr("not read: %1").arg(lost.join(u", "_s)));
    if (!after.snapshotPath.isEmpty())
        details.append(Words::tr("snapshot: %1").arg(after.snapshotPath));
    text.detail = details.join(u"; "_s);
}

ErrorText describe(const Error &error)
{
    const ErrorRow &row = kErrors.at(std::size_t(error.code));
    const auto words = [](const char *text) { return text ? Words::tr(text) : QString(); };
    if (error.file && error.code == ErrorCode::BadFile)
        return describe(*error.file);
    ErrorText text{words(row.what), words(row.meaning), words(row.cure),
                   withNumbers(detailText(error.detail)), words(row.motors)};
    if (error.file) {  // what the file prevented comes first, and what to do is about the file
        const ErrorText file = describe(*error.file);
        text.what += u' ' + file.what;
        text.cure = file.cure;
        text.detail = file.detail;
    } else if (row.told && !text.detail.isEmpty()) {
        while (text.detail.endsWith(u'.'))
            text.detail.chop(1);
        text.what = words(row.told).arg(std::exchange(text.detail, {}));
    }
    // The disk is not to blame for what the board did not deliver.
    if (error.code == ErrorCode::NoBackup && !error.file && !error.detail.isEmpty())
        text.cure = Words::tr(
            "Read the board again; if parts keep missing, check its cable or network, and its power.");
    if (error.after) {
        // What was stored before a restart is not lost.
        const bool isStored = error.after->isStoring && error.after->now && !error.after->changes().empty();
        const QString own = error.code == ErrorCode::Restarted && !isStored ? text.meaning + u' ' : QString();
        if (error.code == ErrorCode::LinkClosed && error.after->now)  // so there is a link again
            text.cure = Words::tr("Check its cable or network, and its power.");
        tellAftermath(*error.after, text);
        text.meaning.prepend(own);
    }
    return text;
}

static QString namesText(WriteState state)
{
    switch (state) {
    case WriteState::Verified: return Words::tr("profile names verified");
    case WriteState::Unknown: return Words::tr("profile names unknown");
    case WriteState::NotWritten: return Words::tr("profile names not written");
    case WriteState::Mismatch: return Words::tr("profile names different");
    case WriteState::RolledBack: return Words::tr("profile names put back");
    }
    return {};
}

// What is in use instead of what was before.
static QString inUseText(const UseReport &use)
{
    constexpr int kTold = 8;
    QStringList told;
    for (const ParameterChange &change : use.changes())
        told.append(
            Words::tr("%1 in use: %2, before %3")
                .arg(change.spec->key, change.spec->format(change.to), change.spec->format(change.from)));
    for (const DataChange &change : use.dataChanges())
        told.append(Words::tr("%1 in use: others").arg(QLatin1String(change.spec->data)));
    const auto count = int(told.size());
    told = told.mid(0, kTold);
    if (count > kTold)
        told.append(Words::tr("and %n more", nullptr, count - kTold));
    return told.join(u"; "_s);
}

// "Studio: motor.yaw.power 120 -> 0": what was not to be written.
static QString straysText(const WriteReport &report)
{
    constexpr int kTold = 8;
    QStringList told;
    for (const ParameterChange &change : report.strays) {
        told.append(changePlace(report.before, change)
                    + u"%1 %2 -> %3"_s.arg(change.spec->key, change.spec->format(change.from),
                                           change.spec->format(change.to)));
    }
    told += report.strayPlaces;
    const auto count = int(told.size());
    told = told.mid(0, kTold);
    if (count > kTold)
        told.append(Words::tr("and %n more", nullptr, count - kTold));
    return told.isEmpty() ? QString() : Words::tr("not to be written: %1").arg(told.join(u", "_s));
}

QString liveText(const Configuration &board, const LiveValues &values)
{
    constexpr qsizetype kTold = 6;
    QStringList texts;
    for (const LiveValue &value : values) {
        if (const ParameterSpec *spec = board.parameters().find(value.key))
            texts.append(u"%1 %2"_s.arg(parameterLabel(*spec), parameterQuantityText(*spec, value.inUse)));
    }
    const auto more = int(texts.size() - kTold);
    texts = texts.mid(0, kTold);
    if (more > 0)
        texts.append(Words::tr("and %n more", nullptr, more));
    return texts.join(u", "_s);
}

QString motorsNowText(bool run)
{
    return run ? Words::tr("The motors run now; before this they were off.")
               : Words::tr("The motors are off now; before this they were running.");
}

QString restartText(const WriteReport &report)
{
    const RestartSigns &signs = report.restart;
    if (signs.areProof())
        return Words::tr("The board was silent for %1 s during the write and its motors run now, which were "
                         "off before: it has restarted. What was in use without being stored is lost.")
            .arg(numberText(signs.silentSeconds, 1));
    if (signs.motorsStarted || signs.motorsStopped)
        return motorsNowText(signs.motorsStarted);
    if (signs.silentSeconds > 0)
        return Words::tr("The board was silent for %1 s during the write. If it has restarted, what was in "
                         "use without being stored is lost, and its motors may run.")
            .arg(numberText(signs.silentSeconds, 1));
    return {};
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
    if (report.namesWanted)
        counts.append(namesText(report.namesState));
    // Where nothing was to be written but names, their state stands for all of it.
    text.what = counts.isEmpty()
        ? Words::tr("The write is not complete.") + u' ' + text.what
        : Words::tr("The write is not complete: %1. ").arg(counts.join(u", "_s)) + text.what;
    if (report.holdsAll())
        text.what = Words::tr("The write was disturbed, but all of it is on the board: %1. ")
                        .arg(counts.join(u", "_s))
            + describe(report.error.value_or(Error{})).what;
    // Nothing that the error means in general stands beside what was read.
    const auto strayInUse
        = report.use ? int(report.use->changes().size() + report.use->dataChanges().size()) : 0;
    if (report.storedUntold)
        text.meaning = Words::tr("What was written is in use; whether it is stored could not be read.");
    else if (!report.wasSent)
        text.meaning = Words::tr("Nothing of it had been sent: the board holds the old values.");
    else if (const int unknown = report.count(WriteState::Unknown))
        text.meaning = Words::tr("What the board holds of %n value(s) could not be read.", nullptr, unknown);
    else if (report.areNamesUnknown())
        text.meaning = Words::tr("Which names the profiles have now could not be read.");
    else if (report.holdsAll())
        text.meaning = Words::tr("The board was read again: it holds what was wanted.");
    else if (const int other = report.countOther())
        text.meaning
            = Words::tr("The board was read again: %n value(s) are not as they were before.", nullptr, other);
    else if (report.namesWanted && report.onBoard.hasOtherNames(report.before))
        text.meaning = Words::tr("The board was read again: the profile names are not as they were before.");
    else if (report.use && (!report.use->now || strayInUse > 0))
        text.meaning = Words::tr("The board was read again: the old values are stored.");
    else
        text.meaning = Words::tr("The board was read again: it holds the old values.");
    if (report.use && !report.use->now)
        text.meaning += u' ' + Words::tr("Which values are in use now could not be read.");
    else if (strayInUse > 0)
        text.meaning
            += u' ' + Words::tr("%n value(s) in use are not as they were before.", nullptr, strayInUse);
    if (report.strayProfile == WriteReport::kUnread) {
        text.meaning += u' ' + Words::tr("Which profile is active now could not be read.");
    } else if (report.strayProfile) {
        text.meaning += u' '
            + Words::tr("The active profile is now %1 instead of %2: the gimbal uses its values.")
                  .arg(profileLabel(report.before, *report.strayProfile),
                       profileLabel(report.before, report.before.activeProfile()));
    }
    if (const QString restart = restartText(report); !restart.isEmpty())
        text.meaning += u' ' + restart;
    addDetail(text.detail, straysText(report));
    if (strayInUse > 0)
        addDetail(text.detail, inUseText(*report.use));
    if (report.namesWanted && !report.areNamesUnknown())
        addDetail(
            text.detail,
            Words::tr("profile names on the board: %1").arg(report.onBoard.profileNames().join(u", "_s)));
    return text;
}
