// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

/// The wheel scrolls what lies beneath the pointer and changes nothing on the way: a list of choices hears it
/// only while it is open, a number or a slider only while it has the keyboard, which the wheel does not give.
class WheelGuard final : public QObject
{
    Q_OBJECT
public:
    explicit WheelGuard(QObject *parent = nullptr);

    bool eventFilter(QObject *watched, QEvent *event) override;
};
