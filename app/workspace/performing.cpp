// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of a board, and what the models know of it afterwards.
#include "app/workspace/flightstate.h"
#include "app/workspace/workspace.h"
#include "protocol/base/linkloss.h"
#include "protocol/configuration/aftermath.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/errortext.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/parametermodel.h"

#include <QTimer>

#include <algorithm>
#include <iterator>
#include <utility>

using namespace Qt::StringLiterals;

QFuture<Result<ActionOutcome>> Workspace::perform(const QString &key, const QVariantMap &arguments,
                                                  bool quiet)
{
    const auto actions = m_client.device() ? m_client.device()->actions() : std::span<const ActionSpec>();
    const auto it = std::find_if(actions.begin(), actions.end(),
                                 [&key](const ActionSpec &spec) { return key == QLatin1String(spec.key); });
    if (it != actions.end() && it->stopsMotors && !m_client.address().isReplay()
        && m_client.state() != DeviceClient::State::Disconnected)
        return stopMotors().then([](bool isProven) {
            return isProven ? Result<ActionOutcome>(ActionOutcome()) : failure(ErrorCode::NotProven);
        });
    // Whatever leads here: while a page sets the gimbal up, only its own steps do more than ask.
    const bool isStep = !m_guidedSteps.isEmpty() && key.startsWith(m_guidedSteps);
    if (m_guided && !isStep && it != actions.end() && it->risk != ActionRisk::Safe) {
        tellGuided();
        return QtFuture::makeReadyFuture(Result<ActionOutcome>(failure(ErrorCode::Cancelled)));
    }
    if (m_propellersOn && it != actions.end() && it->risk == ActionRisk::Moves && *it->confirm) {
        m_notifications.report(
            {tr("“%1” is not begun: a control session is open in which the propellers are on.")
                 .arg(tableText(it->label)),
             tr("It turns motors, and may only do so without propellers."),
             tr("Close the session on the page “Flight”, and take the propellers off."),
             {}});
        return QtFuture::makeReadyFuture(Result<ActionOutcome>(failure(ErrorCode::Cancelled)));
    }
    if (it != actions.end() && *it->confirm)
        return m_confirmations.ask(
            *it, arguments, [this, key, arguments, quiet] { return performNow(key, arguments, quiet); });
    return performNow(key, arguments, quiet);
}

QFuture<Result<ActionOutcome>> Workspace::performNow(const QString &key, const QVariantMap &arguments,
                                                     bool quiet)
{
    const auto actions = m_client.device() ? m_client.device()->actions() : std::span<const ActionSpec>();
    const auto it = std::find_if(actions.begin(), actions.end(),
                                 [&key](const ActionSpec &spec) { return key == QLatin1String(spec.key); });
    const ActionSpec action = it == actions.end() ? ActionSpec() : chosenAction(*it, arguments);
    const bool isStep = m_guided && !m_guidedSteps.isEmpty() && key.startsWith(m_guidedSteps);
    if (!isStep && (action.isProcedure ? refusesToBegin() : refusesMeanwhile()))
        return QtFuture::makeReadyFuture(Result<ActionOutcome>(failure(ErrorCode::Cancelled)));
    const bool isWork = action.isProcedure || action.memory != MemoryEffect::None;
    m_works += isWork ? 1 : 0;
    m_unstoppable = action.silence > 0ms ? &*it : m_unstoppable;
    if (action.risk != ActionRisk::Safe)
        forgetStop();
    if (action.silence > 0ms)
        m_notifications.settle(Concern::Stopped);  // what was proven is past
    // From then on it may run another program; whether that comes to its end may never be known.
    const auto dropsDirections
        = connect(&m_client, &DeviceClient::progressChanged, this, [this](const Progress &progress) {
              if (progress.step == u"firmware-restart"_s)
                  dropDirections(*this);
          });
    if (action.isProcedure)
        m_live.hold();
    return endWhatGoesOn(
               action,
               m_client.submit<ActionOutcome>(
                   [key, arguments, history = m_history, live = m_live.unsaved(),
                    latest = m_client.telemetry()](Channel &channel, Device &device) {
                       return performSafely(channel, device, key, arguments, history, live, latest.get());
                   },
                   action.isProcedure ? DeviceClient::JobKind::Moving : DeviceClient::JobKind::Quiet))
        .then(this,
              [this, quiet, action, isWork, dropsDirections,
               before = m_live.unsaved()](const Result<ActionOutcome> &outcome) {
                  disconnect(dropsDirections);
                  if (action.isProcedure)
                      m_live.release();
                  if (action.silence > 0ms)
                      m_unstoppable = nullptr;
                  if (isWork)
                      endWork();
                  const Aftermath *after = outcome ? nullptr : outcome.error().after.get();
                  // Of what was cancelled is told once the board has been read.
                  const bool isToldLater = after && !after->now && m_client.isConnected()
                      && outcome.error().code == ErrorCode::Cancelled;
                  if (!outcome && !quiet && !isToldLater)
                      tellFailure(action, outcome.error());
                  if (after)
                      readAfterFailure(outcome.error(), before, quiet);
                  if (outcome && !outcome->snapshotPath.isEmpty())
                      emit snapshotTaken();
                  if (outcome && outcome->motorsNow)
                      m_notifications.notify(motorsNowText(*outcome->motorsNow), Notice::Attention);
                  // Live values are lost, even if only the reply went missing.
                  if (outcome || action.memory == MemoryEffect::Reloads)
                      readAfter(action, outcome.value_or(ActionOutcome()), before);
                  return outcome;
              });
}

// Broken off here, it goes on on the board until that is told to end it, and proves it.
QFuture<Result<ActionOutcome>> Workspace::endWhatGoesOn(const ActionSpec &action,
                                                        QFuture<Result<ActionOutcome>> done)
{
    if (!*action.endedBy)
        return done;
    return done
        .then(
            this,
            [this, key = QString::fromLatin1(action.endedBy)](const Result<ActionOutcome> &outcome) {
                if (outcome || outcome.error().code != ErrorCode::Cancelled || !m_client.isConnected())
                    return QtFuture::makeReadyFuture(outcome);
                return m_client.submit<ActionOutcome>(
                    [key, why = outcome.error()](Channel &channel, Device &device) -> Result<ActionOutcome> {
                        Error error = why;
                        if (const auto ended = device.perform(channel, key, {}); !ended) {
                            error = ended.error();
                            error.after = why.after;
                        }
                        return tl::unexpected(error);
                    });
            })
        .unwrap();
}

// The red button, or Esc, while the board was deaf: what it did is no error.
void Workspace::tellStopped(const ActionSpec &action, const Error &error)
{
    QStringList said{tr("You stopped “%1”.").arg(tableText(action.label))};
    if (!error.detail.isEmpty())
        said.append(tr("It had begun, and the board heard nothing until it was over."));
    if (motorsRunning() == false && !m_client.isStopUnproven())
        said.append(tr("The motors are proven to stand."));
    else
        said.append(tr("That the motors stand is not proven yet."));
    m_notifications.notify(said.join(u' '), Notice::Attention, Concern::Stopped);
}

// What would be written is copied before: without the copy nothing was sent yet.
void Workspace::tellFailure(const ActionSpec &action, const Error &error)
{
    if (error.code == ErrorCode::Cancelled && action.silence > 0ms && !isLinkLoss(error)) {
        tellStopped(action, error);
        return;
    }
    ErrorText text = describe(error);
    if (isLinkLoss(error) && action.risk != ActionRisk::Safe) {
        text.what = tr("“%1” was interrupted.").arg(tableText(action.label)) + u' ' + text.what;
        if (!error.after)
            text.meaning = action.risk == ActionRisk::Moves
                ? tr("Whether the board has carried it out is not known.")
                : tr("It had not begun: nothing was changed.");
    } else if (error.code == ErrorCode::Timeout && action.risk == ActionRisk::Moves) {
        text.what = tr("The board did not answer to “%1”.").arg(tableText(action.label));
        text.meaning = tr("It may carry it out yet, at any moment.");
        text.cure = m_notifications.flies()
            ? tr("Keep clear of the propellers, or have the motors stopped (F12).")
            : tr("Keep your hands off the gimbal, or have the motors stopped (F12).");
    }
    if (error.place)
        offerPlace(action, error);
    else
        m_notifications.report(text, error.after ? Concern::Interrupted : Concern::None);
}

// What can be mended in a text is shown there.
void Workspace::offerPlace(const ActionSpec &action, const Error &error)
{
    const TextPlace place = *error.place;
    m_notifications.ask(
        {tr("“%1” is not possible with the text that the board has: %2. Nothing was changed. Mend the text "
            "there, "
            "write it, then try again.")
             .arg(tableText(action.label), detailText(error.detail)),
         {{place.line > 0 ? tr("Open the text at line %1").arg(place.line) : tr("Open the text"),
           [this, place] { emit textWanted(place); }},
          {tr("Not now"), [] {}}},
         Topic::Text});
}

QString Workspace::lacking() const
{
    const Configuration &board = std::as_const(m_configuration).board();
    return missingText(board, board.missing());
}

// What it has changed all the same is shown; where it could not be read at once, it is told when it is.
void Workspace::readAfterFailure(const Error &error, const LiveValues &before, bool quiet)
{
    if (!error.after->snapshotPath.isEmpty())
        emit snapshotTaken();
    if (!error.after->now) {
        m_unsettled = error;
        m_unsettledQuietly = quiet;
        // After those who began it have put back what they wanted to.
        if (m_client.isConnected())
            QTimer::singleShot(0, this, [this, before] { readKnowing(before); });
        return;
    }
    if (error.after->changes().empty() && error.after->dataChanges().empty())
        return;
    m_live.forget();
    LiveValues live = before;
    std::ranges::copy(changedInUse(*error.after, *error.after->now), std::back_inserter(live));
    readKnowing(live);
}

// What something that failed has put into use and was yet to store: by all that is known, it is not stored.
LiveValues Workspace::changedInUse(const Aftermath &after, const Configuration &now) const
{
    LiveValues values;
    const LiveAccess *live = m_client.device() ? m_client.device()->live() : nullptr;
    if (!live || !after.isUnstored || after.before.activeProfile() != now.activeProfile())
        return values;
    for (const ParameterChange &change : after.before.changesTo(now)) {
        const bool isActive
            = change.spec->row->scope != Scope::Profile || change.profile == now.activeProfile();
        if (isActive && live->variableOf(*change.spec) >= 0)
            values.push_back({change.spec->key, change.from, change.to});
    }
    return values;
}

void Workspace::settle(const Configuration &board)
{
    if (!m_unsettled || board.identity().serial != m_unsettled->after->before.identity().serial)
        return;
    const Error error = *std::exchange(m_unsettled, std::nullopt);
    m_notifications.settle(Concern::Interrupted);
    const Error now = settled(error, board);
    if (error.after->isInUse || !m_client.device()->wholeMemory()) {
        // Who ended it, and tells so, hears nothing new.
        const bool isAsBefore = now.after->changes().empty() && now.after->dataChanges().empty()
            && now.after->lost().isEmpty() && !error.after->isBlind;
        if (!m_unsettledQuietly || error.code != ErrorCode::Cancelled || !isAsBefore)
            m_notifications.report(now, Concern::Interrupted);
        return;
    }
    // What such a board answers says nothing about what is stored.
    compareStored().then(this, [this, error](const Result<WholeMemory::Contents> &both) {
        if (both)
            m_notifications.report(settled(error, both->stored), Concern::Interrupted);
        if (!both && !isEndOfLink(both.error()))
            m_notifications.report(error, Concern::Interrupted);
        if (!both && (isEndOfLink(both.error()) || both.error().code == ErrorCode::Timeout))
            m_unsettled = error;
    });
}

LiveValues Workspace::storedWithAWrite() const
{
    return m_client.isConnected() && m_client.device()->wholeMemory() ? m_live.unsaved() : LiveValues();
}

LiveValues Workspace::replacedByAWrite() const
{
    if (!m_client.isConnected() || m_client.device()->wholeMemory())
        return {};
    const LiveValues own = m_live.ownUnsaved();
    LiveValues values = m_live.unsaved();
    std::erase_if(values, [&own](const LiveValue &value) {
        return std::any_of(own.begin(), own.end(),
                           [&value](const LiveValue &kept) { return kept.key == value.key; });
    });
    return values;
}

// What is in use and what is stored after an action is what the board says.
void Workspace::readAfter(const ActionSpec &action, const ActionOutcome &outcome, const LiveValues &before)
{
    const bool isWhole = m_client.isConnected() && m_client.device()->wholeMemory();
    MemoryEffect effect = action.memory;
    if (outcome.reply.contains(u"unstored"_s))
        effect
            = outcome.reply.value(u"unstored"_s).toBool() ? MemoryEffect::ChangesInUse : MemoryEffect::Stores;
    else if (outcome.reply.contains(u"stored"_s))
        effect = MemoryEffect::Stores;
    if (!m_client.isConnected())
        return;
    if (effect == MemoryEffect::Erases)
        m_storedKnown = false;
    if (isWhole && outcome.reply.contains(u"unstored"_s)) {
        learnLastStored();
        return;
    }
    // Not known to be stored: it stays marked as in use only.
    if (effect == MemoryEffect::Stores && !outcome.answered)
        return;
    if (effect == MemoryEffect::Reloads || effect == MemoryEffect::Stores) {
        m_storedKnown |= isWhole && outcome.answered;
        setUnstored(false);
        m_live.forget();  // and read anew once it is known what is stored
        readKnowing(LiveValues());
        return;
    }
    if (effect == MemoryEffect::ChangesInUse || (isWhole && action.risk != ActionRisk::Safe))
        m_live.read();
    if (effect == MemoryEffect::ChangesInUse && isWhole) {
        // Values in use are known to the model of live values; scripts and texts are not.
        m_client
            .submit<Configuration>(
                [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
            .then(this, [this](const Result<Configuration> &inUse) {
                const Configuration &board = std::as_const(m_configuration).board();
                if (inUse && !board.isEmpty())
                    setUnstored(!board.dataChangesTo(*inUse).empty());
            });
    }
    if (effect == MemoryEffect::None && action.risk == ActionRisk::Destroys)
        readKnowing(before);
}
