// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"

#include <QFrame>
#include <QTimer>

#include <vector>

class MessageRow;
class QVBoxLayout;

/// What the operator must know, over the page, a row for each: cause, meaning, cure; details folded; a button
/// that copies it all. A problem stays until its concern is settled or it is closed, whatever is told
/// meanwhile; only what is of no concern of its own gives way to the next problem. No success takes away what
/// asks for attention. Hiding the bar closes all of it.
class MessageBar final : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    /// @param circumstances what a supporter needs beside the text
    void showProblem(const ErrorText &text, Concern concern = Concern::None,
                     const QString &circumstances = {});
    /// Disappears by itself, unless it asks for attention.
    /// @param motors what the board's may do; taken out again when Concern::Motors is withdrawn
    void showNotice(const QString &text, Notice kind, Concern concern = Concern::None,
                    const QString &motors = {});
    /// Takes away what was told of this.
    void withdraw(Concern concern);
    /// Of what was told of an earlier link, only this stays.
    void keepOnly(const QList<Concern> &concerns);
    void closeNewest();
    struct Message
    {
        ErrorText text;
        Concern concern = Concern::None;
        QString circumstances;
        std::optional<Notice> notice;  // else a problem
    };
    /// What stands, the newest last.
    [[nodiscard]] QList<Message> messages() const;
    void show(const QList<Message> &messages);
    /// All that is shown, a line each.
    [[nodiscard]] QString text() const;

    void setVisible(bool visible) override;

private:
    struct Shown : Message
    {
        MessageRow *row = nullptr;
    };
    void add(const Message &message);
    void remove(const MessageRow *row);
    template <typename Predicate> void removeIf(Predicate predicate);
    void closeTransient();
    void update();

    QVBoxLayout *m_layout;
    std::vector<Shown> m_messages;  // the newest last
    QTimer m_hide;
};
