// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>
#include <QtPlugin>

#include <memory>
#include <vector>

/// A gamepad as it is at one moment, before anything is made of it.
struct GamepadReading
{
    int id = -1;  ///< of this device since it was plugged in; never used again
    QByteArray guid;  ///< of its kind, as text: what was set up for one holds for the next of its kind
    QString name;
    std::vector<double> axes;  ///< -1 to 1
    std::vector<bool> buttons;  ///< the directions of hats follow the buttons, four each
    /// Which of them is which on an ordinary pad, as SDL writes it ("leftx:a0,b:b1"); empty: nobody knows.
    QByteArray layout = {};
};

/// Where gamepads are read. All of it is called on the thread that polls.
class GamepadSource
{
public:
    virtual ~GamepadSource() = default;
    /// Errors: Unsupported, with what the system says in the detail.
    virtual Result<void> open() = 0;
    /// Those that are plugged in now, in the order in which they came.
    virtual std::vector<GamepadReading> poll() = 0;
};

/// What a loadable module offers. It is loaded when somebody uses a gamepad, so that nobody else pays for it.
class GamepadModule
{
public:
    virtual ~GamepadModule() = default;
    [[nodiscard]] virtual std::unique_ptr<GamepadSource> makeSource() const = 0;
};

#define GIMBAL_GAMEPAD_MODULE "gimbaldesk.GamepadModule/1"
Q_DECLARE_INTERFACE(GamepadModule, GIMBAL_GAMEPAD_MODULE)
