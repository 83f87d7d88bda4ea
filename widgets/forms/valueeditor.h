// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

#include <QWidget>

class FlagsButton;
class ParameterBox;
class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class LateButton;

/// The control for one parameter: number box, choice, tick or flags, made from its declaration. Shows what
/// the board holds when that differs, with a button that goes back to it.
class ValueEditor final : public QWidget
{
    Q_OBJECT
public:
    ValueEditor(const ParameterSpec &spec, int firmware, QWidget *parent = nullptr);

    [[nodiscard]] const ParameterSpec &spec() const { return m_spec; }
    /// Shows a value and what the board has; empty = the board did not deliver it.
    /// @param isKnown the board has it now, by all that is known
    void show(std::optional<double> value, std::optional<double> onBoard, bool isKnown = true);
    /// The number that stands for the value in a text of the board (ParameterRow::textFigure), beneath it;
    /// empty: the text does not tell. Without such numbers there is no place for one.
    void showFigure(std::optional<double> figure);
    /// What was typed and is no value, for as long as it stands there.
    [[nodiscard]] std::optional<QString> refusedText() const;
    /// Puts such a text back, or the value in the place of one.
    void showRefused(const std::optional<QString> &text);
    /// What is being typed and is not finished yet.
    [[nodiscard]] std::optional<QString> unfinishedText() const;
    void goOnTyping(const QString &text);
    /// What is not finished was meant for something else.
    void forgetTyping();
    /// Why it has no effect now; it can be edited all the same, for when it has.
    void setInactive(const QString &reason);
    /// What its value contradicts; empty: nothing.
    void setContradiction(const QString &text);
    /// The control that takes keys.
    [[nodiscard]] QWidget *control() const { return m_control; }

signals:
    void edited(double raw);
    /// By what is typed: refusedText() is another one, or none.
    void refusedChanged();
    void focused();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeNumber();
    QWidget *makeChoice(int firmware);
    QWidget *makeToggle();
    QWidget *makeFlags(int firmware);
    void showValue(double raw);
    void updateFlagsText(double raw);

    const ParameterSpec &m_spec;
    QWidget *m_control = nullptr;
    ParameterBox *m_number = nullptr;
    QComboBox *m_choice = nullptr;
    QCheckBox *m_toggle = nullptr;
    FlagsButton *m_flags = nullptr;
    QMenu *m_flagsMenu = nullptr;
    LateButton *m_reset;
    QLabel *m_figure = nullptr;
    QString m_inactive;
    QString m_contradiction;
    double m_raw = 0;
    double m_boardRaw = 0;
    bool m_shown = false;  // there has been a value
    bool m_updating = false;
};
