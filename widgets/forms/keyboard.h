// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

class QAbstractButton;
class QWidget;

/// Marks a button that only leads on, opens or ends something. Code gives the keyboard to no other button: a
/// key meant for what was there before must not act on the gimbal.
void setHarmless(QAbstractButton &button, bool harmless = true);
/// Whether code may give the keyboard to this: a field, a list, a box to tick or a harmless button, that is
/// seen and can be used.
[[nodiscard]] bool mayTakeKeyboard(const QWidget &widget);
/// Gives the keyboard to a page or a dialog: to what had it there last, else to its first field, else to its
/// first harmless button, else to the place itself, whose first widget Tab reaches.
void giveKeyboard(QWidget &place, Qt::FocusReason reason = Qt::OtherFocusReason);
