// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/boardnaming.h"

#include "app/workspace/editjournal.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/roles.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"

using namespace Qt::StringLiterals;

BoardNaming::BoardNaming(DeviceClient &client, BoardHistory &history, EditJournal &journal,
                         Notifications &notifications)
    : m_client(client)
    , m_history(history)
    , m_journal(journal)
    , m_notifications(notifications)
{
    connect(&client, &DeviceClient::stateChanged, this, &BoardNaming::onState);
    connect(&client, &DeviceClient::statisticsChanged, this, &BoardNaming::onStatistics);
}

void BoardNaming::forgetWord()
{
    m_isSaid = false;
    m_passing.clear();
    m_history.forgetChoice();
}

void BoardNaming::onState(DeviceClient::State state)
{
    // Another one may answer at the same address after the shortest gap, and nothing that a board without a
    // number tells proves that it is the one before.
    const bool isOrdered = m_client.loss() == DeviceClient::Loss::OrderedRestart;
    if (state == DeviceClient::State::Connecting
        || (state == DeviceClient::State::Reconnecting && !isOrdered))
        forgetWord();
    if (state != DeviceClient::State::Connected || m_client.address().isReplay())
        return;
    m_sameSince = Clock::now();
    if (const auto names = m_history.checkNames(); !names)
        m_notifications.report(names.error());
    const auto known = m_history.meet(m_client.identity());
    // A simulated gimbal is always the same one.
    if (m_client.address().kind() == LinkAddress::Kind::Simulator)
        return;
    if (known == BoardHistory::Acquaintance::Unnamed && names().isEmpty()) {
        ask(tr("This board has no serial number. Give it a name once, so that its snapshots and unwritten "
               "changes are not mixed with those of another board that looks the same."));
    } else if (known == BoardHistory::Acquaintance::Unnamed) {
        ask(tr("This board has no serial number and looks like none that has a name here. It may be a new "
               "one, or one that was renamed elsewhere (known: %1).")
                .arg(names().join(u", "_s)));
    } else if (known == BoardHistory::Acquaintance::Ambiguous) {
        ask(tr("Several boards look like this one: %1. Say which one it is; until then its snapshots are "
               "kept apart.")
                .arg(names().join(u", "_s)));
    } else if (known == BoardHistory::Acquaintance::Named
               && m_client.identity().extra.value(u"name"_s).toString() != name()) {
        m_notifications.notify(tr("Taken for the board “%1”, which looks the same: it has no serial number. "
                                  "If it is another one, say so under Backups.")
                                   .arg(name()),
                               Notice::Hint);
    }
}

// Another network with the same address is joined within two seconds. A board that is armed still is the one
// that was armed.
void BoardNaming::onStatistics()
{
    const auto backAt = m_client.statistics().backAt;
    const int armed = m_client.roles().armed;
    if (!backAt || *backAt <= m_sameSince || !isNeeded())
        return;
    if (armed >= 0 && m_client.telemetry()->latestAt(armed) < *backAt)
        return;
    m_sameSince = *backAt;
    if (armed >= 0 && m_client.telemetry()->latest(armed) > 0.5F)
        return;
    m_isSaid = false;
    m_passing.clear();
    emit changed();
}

void BoardNaming::ask(const QString &text)
{
    const QString look = m_client.identity().serial;
    if (m_later.contains(look))
        return;
    Offer question;
    question.text = text;
    question.choices.append({tr("Name the board…"), [this] {
                                 m_asked = isNeeded();
                                 if (m_asked)
                                     emit asked();
                             }});
    question.choices.append({tr("Later"), [this, look] { m_later.insert(look); }});
    question.topic = Topic::Naming;
    m_notifications.ask(question);
}

bool BoardNaming::isNeeded() const
{
    return m_client.isConnected() && !m_client.address().isReplay()
        && m_history.acquaintance(m_client.identity()) != BoardHistory::Acquaintance::Numbered;
}

QString BoardNaming::name() const
{
    return m_history.nameOf(m_client.identity().serial);
}

// A simulated board within the program is always the same one.
bool BoardNaming::isCertain() const
{
    return m_isSaid || m_client.identity().isNumbered()
        || m_client.address().kind() == LinkAddress::Kind::Simulator;
}

QString BoardNaming::presumedKey() const
{
    const BoardIdentity &board = m_client.identity();
    const auto known = m_history.acquaintance(board);
    if (known == BoardHistory::Acquaintance::Numbered
        || m_client.address().kind() == LinkAddress::Kind::Simulator)
        return board.serial;
    return known == BoardHistory::Acquaintance::Named
        ? board.serial + u'-' + QString::fromLatin1(name().toUtf8().toHex())
        : QString();
}

QStringList BoardNaming::names() const
{
    return m_history.names(m_client.identity());
}

QString BoardNaming::storeAction() const
{
    return m_client.identity().extra.value(BoardHistory::kNameAction).toString();
}

QString BoardNaming::suggestion() const
{
    const QString own = m_client.identity().extra.value(u"name"_s).toString();
    return own.isEmpty() || names().contains(own) ? tr("Board %1").arg(names().size() + 1) : own;
}

Result<void> BoardNaming::choose(const QString &name)
{
    Result<void> chosen;
    m_journal.moveWith([&] { chosen = m_history.choose(m_client.identity(), name); });
    if (chosen) {
        m_isSaid = true;
        m_sameSince = Clock::now();
        emit changed();
    }
    return chosen;
}
