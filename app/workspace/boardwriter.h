// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"
#include "protocol/client/deviceclient.h"
#include "protocol/configuration/writereport.h"
#include "protocol/record/boardhistory.h"
#include "widgets/forms/editstack.h"
#include "widgets/models/livemodel.h"

/// Writes edits to the board, reports the result, and repairs writes that a lost link has interrupted.
class BoardWriter final : public QObject
{
    Q_OBJECT
public:
    BoardWriter(DeviceClient &client, ConfigurationModel &configuration, LiveModel &live, EditStack &edits,
                const BoardHistory &history, Notifications &notifications);

    /// Writes what differs between the board and this, verified, with a snapshot before the first write on
    /// this link.
    void write(const Configuration &wanted, OtherValues others = OtherValues::Keep);
    [[nodiscard]] bool isWriting() const { return m_writing; }
    [[nodiscard]] const std::optional<WriteReport> &lastReport() const { return m_lastReport; }
    /// The board is another one, or may have been changed meanwhile: the next write takes a snapshot of its
    /// own.
    void beginLink() { m_backupDone = false; }
    /// A write was interrupted, and what became of it is still to be decided.
    [[nodiscard]] bool isInterrupted() const { return m_pending.has_value(); }
    /// What the board holds of it has not been read since.
    [[nodiscard]] bool isUnknown() const;
    /// The interrupted write was to change this.
    [[nodiscard]] bool awaits(const ParameterChange &change) const;
    [[nodiscard]] bool awaits(BlockKey data) const;
    void forgetInterrupted();
    /// How the board is read, so that an interrupted write can be told from a complete one.
    [[nodiscard]] std::function<Result<Configuration>(Channel &, Device &)> reader();
    /// Called after the board was read: if a write was interrupted before, asks what to do about it.
    void offerRepair();

signals:
    /// Everything that was wanted is on the board, and stored.
    void completed();
    /// The board was changed by somebody else; nothing was written.
    void conflicted();
    void started();
    /// A write has ended, successfully or not.
    void finished();
    void snapshotTaken();

private:
    void onReport(const Result<WriteReport> &result);
    QSet<QString> restoreLive(const LiveValues &before);
    void tellReplaced(const WriteReport &report, const QSet<QString> &restored);
    void tellOthers(const WriteReport &report);
    void answer(const Configuration &wanted, const std::optional<Configuration> &again);

    DeviceClient &m_client;
    ConfigurationModel &m_configuration;
    LiveModel &m_live;
    EditStack &m_edits;
    const BoardHistory &m_history;
    Notifications &m_notifications;
    std::optional<WriteReport> m_lastReport;
    std::optional<Configuration> m_wantedAgain;  // becomes edits once an interrupted write is undone
    bool m_backupDone = false;
    bool m_writing = false;
    /// Why nobody can tell what is stored, as found by the last reading; written by the worker before it
    /// ends.
    std::shared_ptr<std::optional<Error>> m_untold = std::make_shared<std::optional<Error>>();
    /// The link broke during this write; told again once the board can be read, and only of that board.
    std::optional<WriteReport> m_pending;
};
