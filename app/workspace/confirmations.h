// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/decision.h"
#include "app/workspace/notifications.h"
#include "protocol/procedure/safeaction.h"

#include <QFuture>
#include <QObject>
#include <QPromise>
#include <QVariantMap>

#include <functional>

/// Asks the operator before an action with ActionSpec::confirm, each time; nothing is remembered. Who asks
/// for another meanwhile no longer wants the first, and nobody does once the board is not as the action needs
/// it.
class Confirmations final : public QObject
{
    Q_OBJECT
public:
    using Outcome = Result<ActionOutcome>;

    Confirmations(DeviceClient &client, Notifications &notifications);
    /// Performs it once the operator has confirmed; Cancelled without that. What is asked names the arguments
    /// that are given, e.g. which motor.
    QFuture<Outcome> ask(const ActionSpec &action, const QVariantMap &arguments,
                         std::function<QFuture<Outcome>()> perform);
    /// Nobody wants that any more which he was asked about: it ends with Cancelled.
    void withdraw();
    /// Ends all of them with Cancelled, those under way too: they belonged to another link.
    void forget();

signals:
    /// @param over to be called once the question has closed, whatever closed it
    void asked(const Question &question, const std::function<void()> &over);
    void withdrawn();

private:
    using Promise = QPromise<Outcome>;
    void followBoard();
    void answer(const std::shared_ptr<Promise> &question, const Outcome &outcome);

    DeviceClient &m_client;
    Notifications &m_notifications;
    ActionSpec m_action;  // asked about
    std::vector<std::shared_ptr<Promise>> m_questions;  // asked, or under way
    std::shared_ptr<Promise> m_asked;
};
