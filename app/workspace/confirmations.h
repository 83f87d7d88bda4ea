// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"
#include "protocol/procedure/safeaction.h"

#include <QFuture>
#include <QObject>
#include <QPromise>
#include <QVariantMap>

/// Asks the operator before an action with ActionSpec::confirm, each time; nothing is remembered.
class Confirmations final : public QObject
{
    Q_OBJECT
public:
    using Outcome = Result<ActionOutcome>;

    explicit Confirmations(Notifications &notifications);
    /// Performs it once the operator has confirmed; Cancelled without that. What is asked names the arguments
    /// that are given, e.g. which motor.
    QFuture<Outcome> ask(const ActionSpec &action, const QVariantMap &arguments,
                         std::function<QFuture<Outcome>()> perform);
    /// Ends open questions with Cancelled: they belonged to another link.
    void forget();

private:
    using Promise = QPromise<Outcome>;
    void answer(const std::shared_ptr<Promise> &question, const Outcome &outcome);

    Notifications &m_notifications;
    std::vector<std::shared_ptr<Promise>> m_questions;
};
