// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/configurationfile.h"

#include <QJsonObject>

/// Snapshots of all boards that were connected to this computer, one folder per board, named by its serial
/// number. Boards without a number of their own look alike: the operator names them, and the names stand in
/// `boards.json` beside the folders. What a family gives as the serial number of such a board (its look) then
/// leads to the folder of the board that looks so now.
class BoardHistory
{
public:
    /// BoardIdentity::extra: key of the action that stores a name (its argument "name") on the board.
    static inline const QString kNameAction = QStringLiteral("name.action");
    /// ActionReply: how the board looks after the action, as a serial number.
    static inline const QString kLook = QStringLiteral("look");

    /// How well a board is known when it connects.
    enum class Acquaintance {
        Numbered,  ///< by its own number
        Named,  ///< one named board looks so
        Unnamed,  ///< no named board looks so
        Ambiguous,  ///< several do, and none was chosen
    };

    /// Snapshots live below this folder; by default in the user's application data.
    explicit BoardHistory(QString root = defaultRoot());
    [[nodiscard]] static QString defaultRoot();

    /// Saves a snapshot, reads it back and compares; returns its path. Errors: NoBackup.
    Result<QString> save(const Configuration &configuration, const QString &reason) const;
    /// Paths of a board's snapshots, newest first.
    [[nodiscard]] QStringList snapshots(const QString &serial) const;
    /// When a snapshot was taken, from its file name (UTC).
    [[nodiscard]] static QDateTime timeOf(const QString &path);

    /// Where it is kept how far the set-up of a board has come.
    [[nodiscard]] QString setupFile(const QString &serial) const;
    /// Where it is kept what a board holds on trial.
    [[nodiscard]] QString trialFile(const QString &serial) const;

    /// Edits that never reached the board, kept beside its snapshots to survive a crash: any JSON the program
    /// makes of them, and the configuration they started from. Errors: BadFile.
    Result<void> saveUnsaved(const Configuration &base, const QJsonObject &edits) const;
    void dropUnsaved(const QString &serial) const;
    /// Errors: BadFile, with FileProblem::Missing if there are none.
    [[nodiscard]] Result<QJsonObject> unsaved(const QString &serial) const;
    /// Keeps what cannot be read out of the way of new edits, in place of what was put there before. Returns
    /// the folder.
    QString setAsideUnsaved(const QString &serial) const;
    /// Files with the configuration that unsaved edits of any board started from, newest first.
    [[nodiscard]] QStringList unsavedBases() const;

    /// Whether the names that boards were given can be read. Errors: BadFile.
    [[nodiscard]] Result<void> checkNames() const;
    /// A board has connected: from here on its look is that of no board that was renamed away from it.
    Acquaintance meet(const BoardIdentity &identity) const;
    [[nodiscard]] Acquaintance acquaintance(const BoardIdentity &identity) const;
    /// Names of this family's boards without a number, those that look so first.
    [[nodiscard]] QStringList names(const BoardIdentity &identity) const;
    /// What the operator called the board; empty if it has no name.
    [[nodiscard]] QString nameOf(const QString &serial) const;
    /// The board connected now is the one of that name: a known one, which looks otherwise from now on, or a
    /// new one, which takes over what was kept under its look. Errors: InvalidArgument (no name, or a board
    /// with a number), BadFile.
    Result<void> choose(const BoardIdentity &identity, const QString &name);
    /// Another board may connect: which of several alike the last one was is no longer known.
    void forgetChoice() { m_chosen.clear(); }
    /// The board has been given another look: its history goes with it. A board that nobody has named gets
    /// this name. Errors: BadFile.
    Result<void> follow(const BoardIdentity &identity, const QString &look, const QString &name) const;

private:
    struct Named
    {
        QString name;
        QString family;
        QString folder;
        QString look;
        QString before;  ///< its look when it connected, if it was renamed since
    };
    [[nodiscard]] QString folder(const QString &serial) const;
    [[nodiscard]] QList<Named> named() const;
    [[nodiscard]] const Named *find(const QList<Named> &all, const QString &serial) const;
    [[nodiscard]] static QString freeFolder(const QList<Named> &all, const QString &serial);
    [[nodiscard]] QString folderName(const QList<Named> &all, const QString &serial) const;
    Result<void> save(const QList<Named> &all) const;
    [[nodiscard]] QString namesPath() const;

    QString m_root;
    QString m_chosen;  ///< the board that is connected, where several look the same
};
