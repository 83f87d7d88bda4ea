// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/alarmtext.h"

#include "protocol/configuration/parameterspec.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class AlarmText
{
    Q_DECLARE_TR_FUNCTIONS(AlarmText)
};

QString hertzOf(const Alarm &alarm)
{
    return alarm.isHertzVague ? AlarmText::tr("about %1 Hz (or more: the samples come too slowly to tell)")
                                    .arg(numberText(alarm.hertz, 0))
                              : AlarmText::tr("%1 Hz").arg(numberText(alarm.hertz, 0));
}

/// "Roll P 90 → 35".
QString wayBackText(const LiveChange &change, const ParameterSet *parameters)
{
    QStringList texts;
    for (std::size_t i = 0; parameters && i < change.before.size() && i < change.after.size(); ++i) {
        for (const ParameterSpec &spec : parameters->all()) {
            if (spec.adjustable != change.before[i].id)
                continue;
            const auto text
                = [&spec](double variable) { return parameterValueText(spec, spec.rawOf(variable)); };
            texts.append(u"%1 %2 → %3"_s.arg(parameterLabel(spec), text(change.after[i].value),
                                             text(change.before[i].value)));
            break;
        }
    }
    if (texts.size() != qsizetype(change.before.size()))
        return AlarmText::tr("%n value(s)", nullptr, int(change.before.size()));
    return texts.join(u", "_s);
}

QString seen(const Alarm &alarm)
{
    const QString axis = axisLabel(alarm.axis);
    const QString second = axisLabel(alarm.other);
    switch (alarm.kind) {
    case AlarmKind::Runaway:
        if (alarm.isTurning && alarm.cause != AlarmCause::SwappedAxes)
            return AlarmText::tr("%1 turns on and on: %2° without a stop, and nothing is steered from here.")
                .arg(axis, numberText(alarm.value, 0));
        if (alarm.isStanding && alarm.other != Axis::None)
            return AlarmText::tr("%1 and %2 have run away: %1 is %3° from its target and does not come back.")
                .arg(axis, second, numberText(alarm.value, 0));
        if (alarm.isStanding)
            return AlarmText::tr("%1 is %2° from its target and does not come back.")
                .arg(axis, numberText(alarm.value, 0));
        if (alarm.cause == AlarmCause::SwappedAxes)
            return AlarmText::tr("%1 and %2 run away together: %1 is %3° from its target and moves on.")
                .arg(axis, second, numberText(alarm.value, 0));
        return AlarmText::tr("%1 runs away: it is %2° from its target and moves on.")
            .arg(axis, numberText(alarm.value, 0));
    case AlarmKind::Oscillation:
        return AlarmText::tr("%1 oscillates at %2, with %3 °/s RMS.")
            .arg(axis, hertzOf(alarm), numberText(alarm.value, 1));
    case AlarmKind::Limit:
        return AlarmText::tr("%1 stands at %2°, beyond its limit of %3°, where it was not steered to.")
            .arg(axis, numberText(alarm.value, 0), numberText(alarm.limit, 0));
    case AlarmKind::Saturation:
        return AlarmText::tr("%1 does not reach its target: %2° are missing for seconds.")
            .arg(axis, numberText(alarm.value, 0));
    case AlarmKind::Sensor:
        return alarm.fault == u"no-sensor"_s ? AlarmText::tr("The board does not see its motion sensor.")
                                             : AlarmText::tr("A motion sensor does not work as it should.");
    case AlarmKind::Heat:
        return alarm.cause == AlarmCause::Fault
            ? AlarmText::tr("The motor drivers protect themselves: they are too hot or overloaded.")
            : alarm.axis != Axis::None
            ? AlarmText::tr("The motor of %1 is at %2 °C, the limit is %3 °C.")
                  .arg(axis, numberText(alarm.value, 0), numberText(alarm.limit, 0))
            : AlarmText::tr("The board's sensor is at %1 °C, the limit is %2 °C.")
                  .arg(numberText(alarm.value, 0), numberText(alarm.limit, 0));
    case AlarmKind::Battery:
        if (std::isnan(alarm.value))
            return AlarmText::tr("The battery is low.");
        if (alarm.cause == AlarmCause::OtherBattery && alarm.limit > alarm.value)
            return AlarmText::tr(
                       "The battery's voltage of %1 V is below the alarm of %2 V that is set in the board.")
                .arg(numberText(alarm.value, 1), numberText(alarm.limit, 1));
        // A board that reports it has a limit of its own.
        return alarm.fault.isEmpty() && alarm.limit > alarm.value
            ? AlarmText::tr("The battery is low: %1 V, the limit is %2 V.")
                  .arg(numberText(alarm.value, 1), numberText(alarm.limit, 1))
            : AlarmText::tr("The board reports a low battery: %1 V.").arg(numberText(alarm.value, 1));
    case AlarmKind::Stale:
        return AlarmText::tr("No new live data for more than %1 s while it is steered.")
            .arg(numberText(alarm.value, 1));
    case AlarmKind::Disarmed:
        return AlarmText::tr("The motors are driven although the drone says that it is disarmed.");
    case AlarmKind::Count: break;
    }
    return {};
}

QString meant(const Alarm &alarm)
{
    switch (alarm.cause) {
    case AlarmCause::SwappedAxes:
        return AlarmText::tr(
            "Each is driven by the other's error: the axes are swapped, in the wiring, in the "
            "motor outputs or in how the sensor is mounted. If they are not, both motors turn in "
            "the wrong direction.");
    case AlarmCause::WrongDirection:
        return alarm.other == Axis::None
            ? AlarmText::tr(
                "It is pushed away from its target: the motor turns in the wrong direction, or the "
                "sensor sees it the wrong way round.")
            : AlarmText::tr("%1 does so as well, on its own: both motors turn in the wrong direction, or the "
                            "sensor's axes are set up wrongly.")
                  .arg(axisLabel(alarm.other));
    case AlarmCause::TooMuchGain:
        if (alarm.isAfterChange)
            return AlarmText::tr(
                "It began after values were changed live: there is too much gain, or a filter "
                "takes the loop's reserve.");
        return alarm.kind == AlarmKind::Runaway
            ? AlarmText::tr("It swung to and fro before: there is too much gain.")
            : AlarmText::tr("There is too much gain: P or I is too high, or D is too low for them.");
    case AlarmCause::Resonance:
        return AlarmText::tr(
                   "A part of the structure resonates at %1 Hz and the motor drives it; too high a D "
                   "can do the same.")
            .arg(numberText(alarm.hertz, 0));
    case AlarmCause::OtherBattery:
        return AlarmText::tr(
                   "By its voltage it has %n cell(s) of %1 V, which are not low: the alarm is meant "
                   "for a battery with more cells. If it has more, it is nearly empty.",
                   nullptr, alarm.cells)
            .arg(numberText(alarm.value / alarm.cells, 2));
    case AlarmCause::Fault:
    case AlarmCause::Unknown: break;
    }
    switch (alarm.kind) {
    case AlarmKind::Runaway:
        if (alarm.mayBeMeant)
            return AlarmText::tr("It may follow whoever turns the frame, or be steered by a remote control: "
                                 "the motors were left on. If neither is so, it runs away.");
        if (alarm.isTurning)
            return AlarmText::tr(
                "Nobody is known to steer it: its motor drives it, in the wrong direction or "
                "by a sensor that does not see where it points.");
        return AlarmText::tr(
            "The motor cannot hold it: something blocks it, the load is not balanced, the power "
            "is too low, or the direction is wrong.");
    case AlarmKind::Oscillation: return AlarmText::tr("Too much gain or a resonance of the structure.");
    case AlarmKind::Limit:
        return AlarmText::tr("Something turned it there, or the board lost its orientation.");
    case AlarmKind::Saturation:
        return AlarmText::tr(
            "The motor does all it can: something blocks or holds the axis, it is at its stop, "
            "or it has too little power.");
    case AlarmKind::Sensor: return AlarmText::tr("Without it nothing is stabilised.");
    case AlarmKind::Heat: return AlarmText::tr("Motors that work hard all the time end like this.");
    case AlarmKind::Battery:
        return AlarmText::tr("When it is empty the motors let go, and what they hold falls.");
    case AlarmKind::Stale: return AlarmText::tr("Nobody sees where it moves.");
    case AlarmKind::Disarmed:
        return AlarmText::tr(
            "Something has let its outputs go on: a link that closed while it was armed, or a motor test.");
    case AlarmKind::Count: break;
    }
    return {};
}

QString cure(const Alarm &alarm)
{
    switch (alarm.cause) {
    case AlarmCause::SwappedAxes:
        return AlarmText::tr("Check which motor is plugged in where, and the axes of the sensor, before the "
                             "motors are switched on again.");
    case AlarmCause::WrongDirection:
        return AlarmText::tr("Invert that motor, or check the sensor's orientation and the number of poles.");
    case AlarmCause::TooMuchGain:
        return alarm.isAfterChange ? AlarmText::tr("Go in smaller steps, and back at the first humming.")
                                   : AlarmText::tr("Lower P, then D, of that axis.");
    case AlarmCause::Resonance:
        return AlarmText::tr("Stiffen the camera's mount, lower D, or place a notch filter there.");
    case AlarmCause::OtherBattery:
        return AlarmText::tr(
            "Count its cells: if it has %n, correct the battery's alarm in the board; if it has "
            "more, change it.",
            nullptr, alarm.cells);
    case AlarmCause::Fault:
    case AlarmCause::Unknown: break;
    }
    switch (alarm.kind) {
    case AlarmKind::Runaway:
        if (alarm.mayBeMeant)
            return AlarmText::tr("If nobody turns it, stop the motors.");
        return AlarmText::tr("Check balance, power and direction of that motor.");
    case AlarmKind::Oscillation:
        return AlarmText::tr("Lower the gains of that axis, or look for the resonance.");
    case AlarmKind::Limit: return AlarmText::tr("Move it back by hand with the motors off.");
    case AlarmKind::Saturation: return AlarmText::tr("Free the axis, balance the load, or raise the power.");
    case AlarmKind::Sensor:
        return AlarmText::tr("Check the sensor's cable and connectors, then restart the board.");
    case AlarmKind::Heat: return AlarmText::tr("Let it cool, balance the load, and lower the power.");
    case AlarmKind::Battery: return AlarmText::tr("Change the battery.");
    case AlarmKind::Stale: return AlarmText::tr("Stop steering, then check the link and the board.");
    case AlarmKind::Disarmed: return AlarmText::tr("Stop the motors, and keep clear of the propellers.");
    case AlarmKind::Count: break;
    }
    return {};
}

QString done(const AlarmReport &report, const ParameterSet *parameters)
{
    const QString change = report.change ? wayBackText(*report.change, parameters) : QString();
    if (report.action == AlarmAction::MotorsOff) {
        switch (report.outcome) {
        case AlarmOutcome::Done: return AlarmText::tr("The motors were switched off.");
        case AlarmOutcome::NotProven:
            return AlarmText::tr("The motors were told to stop, but nothing proves that they did: hold the "
                                 "camera and disconnect the power.");
        default: return AlarmText::tr("The motors are being switched off.");
        }
    }
    switch (report.outcome) {
    case AlarmOutcome::Acting: return AlarmText::tr("The last live change is being reverted.");
    case AlarmOutcome::Done:
        return report.wasSeenToEnd
            ? AlarmText::tr("The last live change was reverted (%1); it has been quiet since.").arg(change)
            : AlarmText::tr("The last live change was reverted (%1).").arg(change);
    case AlarmOutcome::GoesOn:
        if (report.wasSeenToEnd)
            return AlarmText::tr("The last live change was reverted (%1); it went on for a while after that.")
                .arg(change);
        return AlarmText::tr("The last live change was reverted (%1), and it goes on all the same.")
            .arg(change);
    case AlarmOutcome::Conflict:
        return AlarmText::tr("The last live change was not reverted: the board uses other values meanwhile.");
    case AlarmOutcome::Failed: return AlarmText::tr("Reverting the last live change failed.");
    case AlarmOutcome::NoChange:
        return AlarmText::tr("Nothing was changed live just before, so nothing was reverted.");
    case AlarmOutcome::Told:
    case AlarmOutcome::NotProven: break;
    }
    return {};
}

}  // namespace

ErrorText describe(const AlarmReport &report, const ParameterSet *parameters)
{
    const QString action = done(report, parameters);
    ErrorText text;
    text.what = action.isEmpty() ? seen(report.alarm) : seen(report.alarm) + u' ' + action;
    // What is over threatens nothing any more; but why the program had to act is needed before going on.
    if (!report.isOver || report.hasActed()) {
        text.meaning = meant(report.alarm);
        text.cure = cure(report.alarm);
    }
    return text;
}

QString alarmName(AlarmKind kind)
{
    switch (kind) {
    case AlarmKind::Runaway: return AlarmText::tr("Runaway");
    case AlarmKind::Oscillation: return AlarmText::tr("Oscillation");
    case AlarmKind::Limit: return AlarmText::tr("Beyond a limit");
    case AlarmKind::Saturation: return AlarmText::tr("Target not reached");
    case AlarmKind::Sensor: return AlarmText::tr("Sensor missing");
    case AlarmKind::Heat: return AlarmText::tr("Overheating");
    case AlarmKind::Battery: return AlarmText::tr("Low battery");
    case AlarmKind::Stale: return AlarmText::tr("No data while steering");
    case AlarmKind::Disarmed: return AlarmText::tr("Motors driven while disarmed");
    case AlarmKind::Count: break;
    }
    return {};
}

QString alarmName(const Alarm &alarm)
{
    return alarm.cause == AlarmCause::OtherBattery ? AlarmText::tr("Battery below the alarm")
                                                   : alarmName(alarm.kind);
}

QString unwatchedText(const std::vector<Unwatched> &missing)
{
    QStringList texts;
    for (const Unwatched &each : missing) {
        const QString name
            = each.isMotors ? AlarmText::tr("Overheating of the motors") : alarmName(each.kind);
        QString reason;
        switch (each.reason) {
        case Unwatched::Reason::NotTold: reason = AlarmText::tr("the board does not tell it"); break;
        case Unwatched::Reason::NotComing: reason = AlarmText::tr("no data for it come"); break;
        case Unwatched::Reason::TooSlow:
            reason = AlarmText::tr("above %1 Hz: data come too slowly").arg(numberText(each.hertz, 0));
            break;
        case Unwatched::Reason::OnlySteered:
            reason = AlarmText::tr("except while it is steered to an angle from here");
            break;
        case Unwatched::Reason::ByRate:
            reason = AlarmText::tr("while it is steered otherwise than to angles");
            break;
        case Unwatched::Reason::NoBattery:
            reason = AlarmText::tr("the board measures no battery's voltage");
            break;
        }
        texts.append(u"%1 (%2)"_s.arg(name, reason));
    }
    return texts.join(u", "_s);
}
