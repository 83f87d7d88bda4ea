// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

class ElidedLabel;
class MotorsKeys;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

/// A question with its answers as buttons; stays until one was chosen, and can be folded meanwhile. Questions
/// queue up.
class OfferBar final : public QFrame
{
    Q_OBJECT
public:
    explicit OfferBar(QWidget *parent = nullptr);
    void ask(const Offer &offer);
    void withdraw(Topic topic);
    /// Forgets all questions: they belonged to another board.
    void clear();
    [[nodiscard]] QString text() const;
    [[nodiscard]] QList<QPushButton *> buttons() const { return m_buttons; }
    /// Questions without an answer yet, the oldest first.
    [[nodiscard]] const QList<Offer> &open() const { return m_offers; }

private:
    void showFirst();
    void setFolded(bool folded);

    QList<Offer> m_offers;
    QLabel *m_text;
    QHBoxLayout *m_row;
    QToolButton *m_fold;
    QList<QPushButton *> m_buttons;
};

/// Shown only while something is unsaved.
class UnsavedBar final : public QFrame
{
    Q_OBJECT
public:
    explicit UnsavedBar(Workspace &workspace, QWidget *parent = nullptr);
    [[nodiscard]] QPushButton *writeButton() const { return m_write; }

signals:
    void reviewRequested();
    void saveFileRequested();

private:
    void refresh();
    void showCounts(int changes, int refused);

    Workspace &m_workspace;
    ElidedLabel *m_text;
    ElidedLabel *m_where;  // in which profiles
    QPushButton *m_undo;
    QPushButton *m_redo;
    QPushButton *m_discard;
    bool m_written = false;  // since the last step
    QPushButton *m_saveFile;
    QPushButton *m_write;
};

/// Shown only while the board uses values that it has not stored.
class UnstoredBar final : public QFrame
{
    Q_OBJECT
public:
    explicit UnstoredBar(Workspace &workspace, QWidget *parent = nullptr);
    [[nodiscard]] QPushButton *storeButton() const { return m_store; }
    [[nodiscard]] QPushButton *backButton() const { return m_back; }

private:
    void refresh();
    void goBack();
    [[nodiscard]] QString reloadAction() const;

    Workspace &m_workspace;
    ElidedLabel *m_text;
    QPushButton *m_back;
    QPushButton *m_store;
};

/// Link health, battery, temperature, errors.
class StatusStrip final : public QFrame
{
    Q_OBJECT
public:
    explicit StatusStrip(Workspace &workspace, QWidget *parent = nullptr);
    /// Says what the keys do while they are held.
    void follow(const MotorsKeys &keys);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void tell();
    void giveWay();
    [[nodiscard]] QString qualityText(const LinkStatistics &link) const;
    [[nodiscard]] QString weaknessText(const LinkStatistics &link) const;
    void tellSensor();

    Workspace &m_workspace;
    quint64 m_lastBad = 0;  // lost samples and damaged frames when they last changed
    QElapsedTimer m_badAt;
    QString m_linkText;  // all of it
    QLabel *m_link;
    QLabel *m_battery;
    QLabel *m_temperature;
    QLabel *m_faults;
    QLabel *m_sensor;
    QLabel *m_hint;
};
