// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/decision.h"

class QDialog;
struct ParameterChange;
class QWidget;
class Workspace;

/// Asks in a panel of that widget's window. @return the panel, which destroys itself; whoever asks rejects
/// it when there is nothing left to decide
QDialog *askInPanel(const Question &question, QWidget *parent);

/// Why nothing is armed there now: a question or a list is open over it, which a gamepad reaches behind.
/// @return empty where nothing is open
[[nodiscard]] QString whyNotBehind(const QWidget &page);

/// Goes on with a value that is a leap (isLeap()) once the operator has said so again. Of something that is
/// armed from here it is refused, and told: a panel would lie over what disarms it.
void askAboutLeap(Workspace &workspace, const ParameterChange &change, QWidget *parent,
                  const std::function<void()> &goOn);

/// Starts the motors once the operator has said so again: the gimbal moves at once.
void askToStartMotors(Workspace &workspace, QWidget *parent);

/// Goes on once the motors are known to be off, after asking where they run or may run: whoever turns a
/// sensor over in his hands needs it limp. They stay off until the operator starts them.
void askForMotorsOff(Workspace &workspace, QWidget *parent, const std::function<void()> &goOn);

/// Goes on with what makes motors let go (ActionSpec::letsGo, a restart) at once where they are known to be
/// off, else after asking. @param what its name
void askToLetGo(Workspace &workspace, const QString &what, QWidget *parent,
                const std::function<void()> &goOn);

/// Goes on with what puts stored values into use (MemoryEffect::Reloads), after asking where motors run or
/// may run, or where values in use that are not stored would be lost: they can be stored first.
/// @param what its button @param otherwise done when the operator stays where he is
void askToReload(Workspace &workspace, const QString &title, const QString &what, const QString &stay,
                 QWidget *parent, const std::function<void()> &goOn,
                 const std::function<void()> &otherwise = {});

/// Makes a profile the active one, after asking (askToReload).
/// @param otherwise done when the operator stays where he is
void askToUseProfile(Workspace &workspace, int profile, QWidget *parent,
                     const std::function<void()> &otherwise = {});
