// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/notchadviser.h"

#include "app/workspace/boardwriter.h"
#include "app/workspace/linkmarks.h"
#include "app/workspace/notifications.h"
#include "app/workspace/telemetrysubscriptions.h"
#include "protocol/client/deviceclient.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/record/boardhistory.h"
#include "widgets/forms/editstack.h"
#include "widgets/models/livemodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<double, 3> kCostHz{5, 10, 20};
constexpr double kCostShare = 0.7;  // of the notch's frequency: nearer it, the lag says little
constexpr double kTrialSeconds = 6.0;

}  // namespace

NotchAdviser::NotchAdviser(DeviceClient &client, ConfigurationModel &configuration, LiveModel &live,
                           EditStack &edits, BoardWriter &writer, const BoardHistory &history,
                           Notifications &notifications, TelemetrySubscriptions &telemetry, LinkMarks &marks)
    : m_client(client)
    , m_configuration(configuration)
    , m_live(live)
    , m_edits(edits)
    , m_writer(writer)
    , m_history(history)
    , m_notifications(notifications)
    , m_telemetry(telemetry)
    , m_marks(marks)
{
    connect(&m_live, &LiveModel::modelReset, this, &NotchAdviser::forgetLoops);
    connect(&m_live, &LiveModel::valueChanged, this, &NotchAdviser::forgetLoops);
}

NotchAdviser::~NotchAdviser() = default;

std::optional<NotchAdviser::Plan> NotchAdviser::plan(Axis axis, const SpectrumPeak &peak) const
{
    const Device *device = m_client.device();
    if (!device || m_configuration.isEmpty())
        return {};
    const ConfigurationModel &model = m_configuration;
    return planNotch(*device, model.board(), model.edited(), axis, peak);
}

NotchAdvice NotchAdviser::advise(const Plan &plan, double wholeRms, double commandedRms) const
{
    const auto &loop = m_loops[std::size_t(plan.axis)];
    return adviseNotch({plan.peak, wholeRms, commandedRms, plan.shape, loop ? &*loop : nullptr});
}

QString NotchAdviser::name(const Plan &plan) const
{
    return tr("Notch %1 of %2").arg(plan.filter.bit + 1).arg(axisLabel(plan.axis));
}

QString NotchAdviser::inWords(const Plan &plan, const NotchAdvice &advice) const
{
    const QString line = tr("%1, %2 Hz").arg(axisLabel(plan.axis)).arg(numberText(plan.peak.frequency, 1));
    switch (advice.finding) {
    case NotchAdvice::Finding::TooWeak:
        return tr("%1: no notch is offered. Without this line the axis would vibrate %2 % less; the delay "
                  "would cost more.")
            .arg(line)
            .arg(numberText(100.0 * advice.gain, 0));
    case NotchAdvice::Finding::TooBroad:
        return tr("%1: no notch is offered. The line is too broad for a resonance: it is what shakes the "
                  "gimbal, or how the loop reacts to it.")
            .arg(line);
    case NotchAdvice::Finding::Commanded:
        return tr("%1: no notch is offered. The target itself moves like that.").arg(line);
    case NotchAdvice::Finding::OwnLoop:
        return tr("%1: no notch is offered. The loop itself amplifies there, as measured on Response: lower "
                  "P or D of this axis.")
            .arg(line);
    case NotchAdvice::Finding::CostsMargin:
        return tr("%1: no notch is offered. It would leave the loop a phase margin of %2° of the %3° "
                  "measured.")
            .arg(line)
            .arg(numberText(advice.after->phaseDeg.value_or(0.0), 0))
            .arg(numberText(advice.before->phaseDeg.value_or(0.0), 0));
    case NotchAdvice::Finding::TryIt: break;
    }
    return tr("%1: may be a resonance or a motor, %2 % of the vibration. A trial shows whether a notch "
              "helps.")
        .arg(line)
        .arg(numberText(100.0 * advice.gain, 0));
}

QString NotchAdviser::question(const Plan &plan, const NotchAdvice &advice) const
{
    QStringList parts{tr("%1, notch %2: %3 Hz, width %4 Hz, depth %5 dB.")
                          .arg(axisLabel(plan.axis))
                          .arg(plan.filter.bit + 1)
                          .arg(shortNumberText(plan.shape.hz))
                          .arg(shortNumberText(plan.shape.width))
                          .arg(shortNumberText(plan.shape.depthDb))};
    QStringList costs;
    for (const double hz : kCostHz) {
        if (hz < plan.shape.hz * kCostShare)
            costs.append(tr("%1° at %2 Hz")
                             .arg(numberText(lagDeg(notchResponse(plan.shape, hz)), 0))
                             .arg(shortNumberText(hz)));
    }
    if (!costs.isEmpty())
        parts.append(tr("It delays the loop: %1. Every degree is taken from the phase margin.")
                         .arg(costs.join(u", "_s)));
    if (advice.before && advice.before->phaseDeg && advice.after->phaseDeg) {
        parts.append(tr("The loop as measured has a phase margin of %1° at %2 Hz; with the notch it has %3°.")
                         .arg(numberText(*advice.before->phaseDeg, 0))
                         .arg(numberText(*advice.before->phaseHz, 1))
                         .arg(numberText(*advice.after->phaseDeg, 0)));
    } else {
        parts.append(
            tr("How much phase this loop can spare has not been measured (a sweep on Response does), "
               "so only the trial shows whether it bears the notch."));
    }
    parts.append(
        tr("This board cannot use a notch without storing it. The trial measures for %1 s, writes the "
           "notch to profile %2, measures for %1 s again and writes the old values back in any "
           "case, at once if an axis begins to oscillate. Leave gimbal and sticks as they are "
           "meanwhile.")
            .arg(kTrialSeconds)
            .arg(plan.profile + 1));
    return parts.join(u"\n\n"_s);
}

QString NotchAdviser::obstacle() const
{
    if (m_live.isHeld())
        return tr("A search, measurement or calibration is running.");
    if (m_live.changeCount() > 0)
        return tr("Values in use are not stored; a trial would replace them. Store or revert them on Tuning "
                  "first.");
    return {};
}

void NotchAdviser::start(const Plan &plan)
{
    if (isRunning())
        return;
    if (const QString why = obstacle(); !why.isEmpty()) {
        m_notifications.notify(why, Notice::Attention);
        return;
    }
    const Configuration board = std::as_const(m_configuration).board();
    NotchTrialPlan trial;
    trial.axis = plan.axis;
    trial.hz = plan.peak.frequency;
    trial.width = plan.peak.width;
    trial.seconds = kTrialSeconds;
    trial.base = board;
    trial.wanted = plan.appliedTo(board);
    m_stop = std::make_shared<std::atomic<bool>>(false);
    m_live.hold();
    // The samples must come whether a page shows them or not.
    m_telemetry.subscribe(this, [this] {
        const ChannelRoles &roles = m_client.roles();
        return ChannelRoles::present({roles.gyro, roles.angle, roles.target});
    });
    m_marks.add(PlotMark::Kind::Note, tr("Trial of a notch begins"));
    m_client
        .submit<NotchTrialResult>([trial, stop = m_stop, store = m_client.telemetry(),
                                   history = m_history](Channel &channel, Device &device) {
            WriteOptions options;
            options.history = &history;
            return tryNotch(channel, device, *store, trial, options, *stop);
        })
        .then(this, [this, plan](const Result<NotchTrialResult> &result) { onResult(plan, result); });
    emit changed();
}

void NotchAdviser::stop()
{
    if (m_stop)
        *m_stop = true;
}

void NotchAdviser::onResult(const Plan &plan, const Result<NotchTrialResult> &result)
{
    m_stop = nullptr;
    m_live.release();
    m_telemetry.subscribe(this, [] { return QList<int>(); });
    m_marks.add(PlotMark::Kind::Note, tr("Trial of a notch is over"));
    if (!result) {
        m_outcome = tr("%1 was not tried; nothing was changed on the board.").arg(name(plan));
        if (result.error().code == ErrorCode::Cancelled)
            m_notifications.notify(m_outcome, Notice::Hint);
        else if (!isEndOfLink(result.error()))
            m_notifications.report(result.error());
    } else {
        tell(plan, *result);
    }
    emit changed();
}

void NotchAdviser::tell(const Plan &plan, const NotchTrialResult &result)
{
    using Verdict = NotchTrialResult::Verdict;
    const QString back = result.isTakenBack
        ? tr("The values from before are back on the board.")
        : tr("The notch could not be taken back; that is done when this board is read again.");
    const Vibration &before = result.before;
    const Vibration &after = result.after;
    const QString figures
        = tr("Before and with it, %1 s each: the line %2 and %3 °/s RMS, all vibration %4 and %5 °/s, angle "
             "error %6° and %7°.")
              .arg(kTrialSeconds)
              .arg(numberText(before.line, 2))
              .arg(numberText(after.line, 2))
              .arg(numberText(before.whole, 2))
              .arg(numberText(after.whole, 2))
              .arg(std::isnan(before.error) ? u"–"_s : numberText(before.error, 3),
                   std::isnan(after.error) ? u"–"_s : numberText(after.error, 3));
    Notice kind = Notice::Attention;
    switch (result.verdict) {
    case Verdict::Better:
        m_outcome = tr("%1 helps.").arg(name(plan)) + u' ' + figures + u' ' + back;
        if (result.isTakenBack) {
            m_notifications.ask({m_outcome,
                                 {{tr("Take over as an edit"),
                                   [this, plan] {
                                       const Configuration &edited = std::as_const(m_configuration).edited();
                                       if (edited.parameters().find(plan.filter.enabled))
                                           m_edits.apply(plan.appliedTo(edited), name(plan));
                                   }},
                                  {tr("Leave it"), [] {}}}});
            return;
        }
        break;
    case Verdict::NoBetter:
        m_outcome = tr("%1 is not worth its delay.").arg(name(plan)) + u' ' + figures + u' ' + back;
        kind = Notice::Hint;
        break;
    case Verdict::Worse:
        m_outcome = tr("%1 makes it worse.").arg(name(plan)) + u' ' + figures + u' ' + back;
        break;
    case Verdict::Oscillates:
        m_outcome
            = tr("%1 makes %2 oscillate (%3 °/s RMS within a quarter of a second; all vibration before: "
                 "%4 °/s on %5). The trial was ended at once.")
                  .arg(name(plan), axisLabel(result.peakAxis))
                  .arg(numberText(result.peak, 1))
                  .arg(numberText(before.whole, 2))
                  .arg(axisLabel(plan.axis))
            + u' ' + back;
        break;
    case Verdict::Ended:
        m_outcome
            = tr("The trial of %1 was ended before it could show anything.").arg(name(plan)) + u' ' + back;
        if (result.isTakenBack && result.ended && result.ended->code == ErrorCode::Cancelled)
            kind = Notice::Hint;
        else if (result.ended && !isEndOfLink(*result.ended))
            m_outcome += u' ' + describe(*result.ended).oneLine();
        break;
    }
    m_notifications.notify(m_outcome, kind);
    if (!result.isTakenBack && m_client.isConnected())
        emit readWanted();
}

// After the board was read: values of a trial that was cut off give way to those from before.
void NotchAdviser::makeGood()
{
    if (m_live.isHeld() || !m_client.isConnected() || !m_client.identity().writable || m_writer.isWriting())
        return;
    const auto note = keptTrial(m_history, m_client.identity());
    if (!note)
        return;
    const Configuration &board = std::as_const(m_configuration).board();
    const Configuration old = note->madeGood(board);
    const auto left = board.changesTo(old);
    if (left.empty()) {
        dropTrial(m_history, m_client.identity());
        return;
    }
    m_notifications.notify(
        tr("A trial was cut off, and what was tried is still on the board (%1): the values "
           "from before are written back.")
            .arg(parameterLabel(*left.front().spec)),
        Notice::Attention);
    m_writer.write(old);
}
