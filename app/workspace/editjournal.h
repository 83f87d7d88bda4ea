// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/drafts.h"
#include "protocol/record/boardhistory.h"
#include "widgets/forms/editstack.h"

#include <QTimer>

#include <functional>

/// Keeps the undo stack, and texts that are no edits yet, in a file beside the board's snapshots while
/// anything is unsaved, so that a crash loses nothing.
class EditJournal final : public QObject
{
    Q_OBJECT
public:
    EditJournal(ConfigurationModel &configuration, EditStack &edits, const BoardHistory &history,
                QObject *parent = nullptr);
    ~EditJournal() override;

    /// Puts the edits that an earlier run has left back on the stack. False if none of them fits this board.
    bool restoreLeftover();
    void dropLeftover();
    /// Texts that were typed for this board and are no edits yet.
    [[nodiscard]] Drafts &drafts() { return m_drafts; }
    [[nodiscard]] const Drafts &drafts() const { return m_drafts; }
    /// Writes pending edits now.
    void flush();
    /// The board's history becomes another one by what is done here: pending edits go with it.
    void moveWith(const std::function<void()> &change);

signals:
    /// The board now shown has edits from an earlier run, or texts.
    void leftoverFound(int steps, int texts);
    void failed(const Error &error);

private:
    void onBoard();
    void write();
    void keepUndecided();

    ConfigurationModel &m_configuration;
    EditStack &m_edits;
    const BoardHistory &m_history;
    Drafts m_drafts;
    std::optional<QJsonObject> m_leftover;
    QString m_serial;
    QTimer m_timer;
    bool m_hasFile = false;
};
