// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/workspace.h"

#include <QFrame>
#include <QTimer>

class QLabel;
class QPushButton;
class QToolButton;

/// What the operator must know, below the link bar: cause, meaning, cure; details folded; a button that copies it all.
class MessageBar final : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    void showProblem(const ErrorText &text);
    /// Goes away by itself.
    void showNotice(const QString &text);
    [[nodiscard]] QString text() const;

private:
    void setSevere(bool severe);

    QLabel *m_text;
    QToolButton *m_copy;
    QToolButton *m_close;
    QTimer m_hide;
    QString m_full;
};

/// Only there while something is unsaved.
class UnsavedBar final : public QFrame
{
    Q_OBJECT
public:
    explicit UnsavedBar(Workspace &workspace, QWidget *parent = nullptr);
    [[nodiscard]] QPushButton *writeButton() const { return m_write; }
    [[nodiscard]] QPushButton *undoButton() const { return m_undo; }
    [[nodiscard]] QPushButton *redoButton() const { return m_redo; }
    [[nodiscard]] QPushButton *discardButton() const { return m_discard; }

signals:
    void reviewRequested();

private:
    void refresh();

    Workspace &m_workspace;
    QLabel *m_text;
    QPushButton *m_undo;
    QPushButton *m_redo;
    QPushButton *m_discard;
    QPushButton *m_write;
};

/// Link health, battery, temperature, errors.
class StatusStrip final : public QFrame
{
    Q_OBJECT
public:
    explicit StatusStrip(Workspace &workspace, QWidget *parent = nullptr);

private:
    void refresh();

    Workspace &m_workspace;
    QLabel *m_link;
    QLabel *m_battery;
    QLabel *m_temperature;
    QLabel *m_faults;
};
