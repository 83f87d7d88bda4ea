// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/drafts.h"
#include "protocol/record/boardhistory.h"
#include "widgets/forms/editstack.h"

#include <QTimer>

#include <functional>

/// A file that names no board has edits and texts of its own, and shares them with no other such file.
[[nodiscard]] Configuration withOwnSerial(Configuration file, const QString &path);
/// As it was read; a copy that is saved belongs to no file.
[[nodiscard]] Configuration withoutOwnSerial(Configuration file);

/// Keeps the undo stack, and texts that are no edits yet, in a file beside the board's snapshots while
/// anything is unsaved, so that a crash loses nothing.
class EditJournal final : public QObject
{
    Q_OBJECT
public:
    EditJournal(ConfigurationModel &configuration, EditStack &edits, const BoardHistory &history,
                QObject *parent = nullptr);
    ~EditJournal() override;

    /// What an earlier run has left concerns parts of the board that could not be read: it is kept, and found
    /// again once they are there.
    [[nodiscard]] bool leftoverWaits() const { return m_leftover && m_edits.concernsMissing(*m_leftover); }
    /// Puts the edits that an earlier run has left back on the stack. Nothing is restored while they wait.
    EditStack::Restored restoreLeftover();
    void dropLeftover();
    /// Tells again of what an earlier run has left, if nobody has decided about it: a new link has begun.
    void remind();
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
    /// Pending edits are safe.
    void written();
    /// The edits of an earlier run cannot be read; they were put into this folder.
    void unreadable(const Error &error, const QString &folder);
    /// New edits took the place of edits of an earlier run that concern parts which could not be read; those
    /// were put into this folder.
    void setAside(const QString &folder);
    /// New edits took the place of those of an earlier run; those were put into this snapshot.
    void keptAside(const QString &path);
    /// There is nothing to decide about any more, or another board is shown.
    void leftoverGone();

private:
    void onBoard();
    void write();
    void keepUndecided();
    void tellLeftover();
    [[nodiscard]] int leftSteps() const;
    [[nodiscard]] int leftTexts() const;

    ConfigurationModel &m_configuration;
    EditStack &m_edits;
    const BoardHistory &m_history;
    Drafts m_drafts;
    std::optional<QJsonObject> m_leftover;
    QString m_serial;
    QTimer m_timer;
    bool m_hasFile = false;
    bool m_isAwaited = false;  // the leftover, by the operator
    bool m_isTold = false;  // on this link
};
