// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

#include <map>

class Card;
class InputBars;
class ParameterForm;
class QBoxLayout;
class QGridLayout;
class QLabel;
class StickBar;

/// Which input steers what, and beside it what comes in at all inputs, so that an operator sees the stick
/// that he moves: the map of inputs, what each function gets, and the slots of menu commands and adjustable
/// variables that are in use.
class SignalsPage final : public Page
{
    Q_OBJECT
public:
    explicit SignalsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] ParameterForm *form() const { return m_form; }
    [[nodiscard]] InputBars *inputs() const { return m_inputs; }
    /// The signal of a function ("rc.map.pitch") or a slot ("trigger2") in percent; NaN: none comes.
    [[nodiscard]] double signal(const QString &key) const;
    /// What the slot does at this moment.
    [[nodiscard]] QString effect(const QString &key) const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Row
    {
        QLabel *name;
        StickBar *bar;
        QLabel *percent;
        QLabel *effect;
    };
    [[nodiscard]] QWidget *makeMap();
    [[nodiscard]] QWidget *makeLive();
    Row &row(const QString &key, const QString &name);
    void removeRows(const std::function<bool(const QString &)> &isGone);
    void onState();
    void ask();
    void showSignals(const ActionReply &told);
    void showInputs(const ActionReply &told);
    void showSlots(const ActionReply &told);
    void showRow(const QString &key, const QString &name, const QVariant &percent, const QString &effect);
    [[nodiscard]] QVariant reported(std::size_t function) const;

    ParameterForm *m_form;
    InputBars *m_inputs;
    QBoxLayout *m_map;
    QGridLayout *m_live;
    QLabel *m_note;
    std::map<QString, Row> m_rows;
    int m_open = 0;  // questions
};
