// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/gamepad/gamepadsource.h"

#include <QObject>

/// Gamepads by SDL.
class SdlGamepadModule final : public QObject, public GamepadModule
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID GIMBAL_GAMEPAD_MODULE)
    Q_INTERFACES(GamepadModule)
public:
    [[nodiscard]] std::unique_ptr<GamepadSource> makeSource() const override;
};
