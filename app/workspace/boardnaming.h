// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"
#include "protocol/record/boardhistory.h"

#include <utility>

/// Which board it is, where it has no serial number: asks the operator once for its name, and keeps its
/// snapshots and unsaved edits apart from those of boards that look the same.
class BoardNaming final : public QObject
{
    Q_OBJECT
public:
    BoardNaming(DeviceClient &client, BoardHistory &history, EditJournal &journal,
                Notifications &notifications);

    /// A board without a serial number is connected.
    [[nodiscard]] bool isNeeded() const;
    /// What the operator calls it; empty without a name.
    [[nodiscard]] QString name() const;
    /// The boards of its family that have a name, those that look like it first.
    [[nodiscard]] QStringList names() const;
    /// It is the board that it is taken for: by its number, or by the operator's word since this connection
    /// was made. Only a restart that was ordered from here leaves that as it is; no loss of the link does,
    /// nor a silence long enough for another one to answer after it, unless the board is armed as before.
    [[nodiscard]] bool isCertain() const;
    /// By what something that is dangerous with another board is kept about this one: its number, or its look
    /// and the name that the operator has given it. Empty: it may be any that looks like it.
    [[nodiscard]] QString lastingKey() const { return isCertain() ? presumedKey() : QString(); }
    /// The same for the board that it is taken for, certain or not; empty: it is taken for none.
    [[nodiscard]] QString presumedKey() const;
    /// What is kept about such a board: until another connection is made.
    [[nodiscard]] QHash<QByteArray, QByteArray> &untilReconnected() { return m_passing; }
    /// Key of the action that stores a name on the board; empty if it can keep none.
    [[nodiscard]] QString storeAction() const;
    /// Once for each question that the page which shows the board's snapshots has to ask.
    [[nodiscard]] bool takeQuestion() { return std::exchange(m_asked, false); }
    /// A name for it to begin with.
    [[nodiscard]] QString suggestion() const;
    /// It is the board of that name, a known or a new one. Errors: InvalidArgument, BadFile.
    Result<void> choose(const QString &name);

signals:
    /// The operator wants to say which board it is: the page of its snapshots is to be shown.
    void asked();
    /// Its history is another one now.
    void changed();

private:
    void onState(DeviceClient::State state);
    void onStatistics();
    void forgetWord();
    void ask(const QString &text);

    DeviceClient &m_client;
    BoardHistory &m_history;
    EditJournal &m_journal;
    Notifications &m_notifications;
    bool m_asked = false;
    bool m_isSaid = false;  // since this connection was made: which board it is
    TimePoint m_sameSince{};  // no other one can have come in between
    QHash<QByteArray, QByteArray> m_passing;
    QSet<QString> m_later;  // boards about which it is not asked again
};
