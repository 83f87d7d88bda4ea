// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

class QWidget;

/// Dialogs for files, without blocking: called back once one was chosen. They are the only ones with a window
/// of their own (compare widgets/forms/panel.h), beside a main window that still stops the motors.
using PathChosen = std::function<void(const QString &path)>;

/// Asks again before a file is replaced. @param name the suggested name, whose suffix is added where none is
/// typed; @param filter as QFileDialog has it
void askSavePath(QWidget *owner, const QString &title, const QString &name, const QString &filter,
                 const PathChosen &chosen);
/// @param folder where to begin; empty = the working directory
void askOpenPath(QWidget *owner, const QString &title, const QString &filter, const PathChosen &chosen,
                 const QString &folder = {});
