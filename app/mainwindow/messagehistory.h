// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class Notifications;

/// What was told since the program began, with its time, the newest on top.
class MessageHistory final : public QDialog
{
    Q_OBJECT
public:
    explicit MessageHistory(const Notifications &notifications, QWidget *parent = nullptr);
};
