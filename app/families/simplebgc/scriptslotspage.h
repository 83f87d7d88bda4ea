// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/record/keptscripts.h"

#include <QElapsedTimer>

class Card;
class QBoxLayout;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;
class QTableWidget;

/// The slots in which a board keeps compiled scripts: copied into files and back, run, followed command by
/// command, stopped. What is in a slot is kept before it is replaced, and can be restored.
class ScriptSlotsPage final : public Page
{
    Q_OBJECT
public:
    explicit ScriptSlotsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] QTableWidget *table() const { return m_table; }
    [[nodiscard]] QMenu *copies() const { return m_copies; }
    [[nodiscard]] QString finding() const;
    /// What runs, in large letters, and what is known of it.
    [[nodiscard]] QString running() const;
    [[nodiscard]] QString about() const;
    /// The commands of a followed script, as the board told them.
    [[nodiscard]] QListWidget *commands() const { return m_commands; }
    [[nodiscard]] bool isUnderWay() const override { return m_isBusy; }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;
    void loadFrom(const QString &path);
    void saveTo(const QString &path);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    enum Column { SlotColumn, SizeColumn, CopyColumn, ColumnCount };
    /// What the board says of one.
    struct Slot
    {
        int bytes = 0;
        QString error;  ///< why it cannot be read
    };
    using Done = std::function<void(const Result<ActionOutcome> &)>;

    [[nodiscard]] QWidget *makeSlots();
    [[nodiscard]] QWidget *makeRun();
    void makeBody();
    void connectAll();
    void onState();
    void read();
    void showSlots();
    void showState();
    void offerCopies();
    void tellRunning(const QString &what, const QString &about);
    void tellNothing();
    void onProgress(const Progress &progress);
    void perform(const QString &key, const QVariantMap &arguments, const Done &done);
    void erase();
    void askToRun(bool isFollowed);
    void run();
    void follow();
    void onFollowed(int slot, const Result<ActionOutcome> &outcome);
    void stop();
    [[nodiscard]] KeptScripts kept() const;
    /// Chosen in the table, from 1; 0: none.
    [[nodiscard]] int slot() const;
    [[nodiscard]] QString replaced(int slot, const ActionReply &reply, const QString &what) const;

    QLabel *m_finding;
    QTableWidget *m_table;
    QPushButton *m_load;
    QPushButton *m_save;
    QPushButton *m_restore;
    QPushButton *m_erase;
    QPushButton *m_cancel;
    QMenu *m_copies;
    QLabel *m_running;
    QLabel *m_about;
    QListWidget *m_commands;
    QPushButton *m_run;
    QPushButton *m_follow;
    QPushButton *m_stop;
    QPushButton *m_refresh;
    QBoxLayout *m_cards;
    QList<Slot> m_slots;  // as they were read last
    QString m_result;  // of what was done last
    bool m_isBusy = false;
    bool m_isReading = false;
    int m_followed = 0;  // the slot whose script is
    int m_command = 0;  // that it carries out
    QElapsedTimer m_since;  // it was begun
};
