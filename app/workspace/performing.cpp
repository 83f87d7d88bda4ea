// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of a board, and what the models know of it afterwards.
#include "app/workspace/workspace.h"

#include <algorithm>

using namespace Qt::StringLiterals;

QFuture<Result<ActionOutcome>> Workspace::perform(const QString &key, const QVariantMap &arguments,
                                                  bool quiet)
{
    const auto actions = m_client.device() ? m_client.device()->actions() : std::span<const ActionSpec>();
    const auto it = std::find_if(actions.begin(), actions.end(),
                                 [&key](const ActionSpec &spec) { return key == QLatin1String(spec.key); });
    if (it != actions.end() && *it->confirm)
        return m_confirmations.ask(
            *it, [this, key, arguments, quiet] { return performNow(key, arguments, quiet); });
    return performNow(key, arguments, quiet);
}

QFuture<Result<ActionOutcome>> Workspace::performNow(const QString &key, const QVariantMap &arguments,
                                                     bool quiet)
{
    const auto actions = m_client.device() ? m_client.device()->actions() : std::span<const ActionSpec>();
    const auto it = std::find_if(actions.begin(), actions.end(),
                                 [&key](const ActionSpec &spec) { return key == QLatin1String(spec.key); });
    const ActionSpec action = it == actions.end() ? ActionSpec() : *it;
    const bool isWork = action.isProcedure || action.memory != MemoryEffect::None;
    m_works += isWork ? 1 : 0;
    return m_client
        .submit<ActionOutcome>(
            [key, arguments, history = m_history, live = m_live.unsaved(),
             latest = m_client.telemetry()](Channel &channel, Device &device) {
                return performSafely(channel, device, key, arguments, history, live, latest.get());
            },
            action.isProcedure ? DeviceClient::JobKind::Moving : DeviceClient::JobKind::Quiet)
        .then(this,
              [this, quiet, action, isWork, before = m_live.unsaved()](const Result<ActionOutcome> &outcome) {
                  if (isWork)
                      endWork();
                  if (!outcome && !quiet)
                      m_notifications.report(outcome.error());
                  if (outcome && !outcome->snapshotPath.isEmpty())
                      emit snapshotTaken();
                  // Live values are lost, even if only the reply went missing.
                  if (outcome || action.memory == MemoryEffect::Reloads)
                      readAfter(action, outcome.value_or(ActionOutcome()), before);
                  return outcome;
              });
}

LiveValues Workspace::storedWithAWrite() const
{
    return m_client.isConnected() && m_client.device()->wholeMemory() ? m_live.unsaved() : LiveValues();
}

// What is in use and what is stored after an action is what the board says.
void Workspace::readAfter(const ActionSpec &action, const ActionOutcome &outcome, const LiveValues &before)
{
    const bool isWhole = m_client.isConnected() && m_client.device()->wholeMemory();
    MemoryEffect effect = action.memory;
    if (outcome.reply.contains(u"unstored"_s))
        effect
            = outcome.reply.value(u"unstored"_s).toBool() ? MemoryEffect::ChangesInUse : MemoryEffect::Stores;
    if (!m_client.isConnected())
        return;
    if (effect == MemoryEffect::Reloads || effect == MemoryEffect::Stores) {
        setUnstored(false);
        m_live.forget();  // and read anew once it is known what is stored
        readKnowing(LiveValues());
        return;
    }
    if (effect == MemoryEffect::ChangesInUse || (isWhole && action.risk != ActionRisk::Safe))
        m_live.read();
    if (effect == MemoryEffect::ChangesInUse && isWhole)
        compareData();
    if (effect == MemoryEffect::None && action.risk == ActionRisk::Destroys)
        readKnowing(before);
}

// Values in use are known to the model of live values; scripts and texts are not.
void Workspace::compareData()
{
    m_client
        .submit<Configuration>(
            [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
        .then(this, [this](const Result<Configuration> &inUse) {
            const Configuration &board = std::as_const(m_configuration).board();
            if (inUse && !board.isEmpty())
                setUnstored(!board.dataChangesTo(*inUse).empty());
        });
}
