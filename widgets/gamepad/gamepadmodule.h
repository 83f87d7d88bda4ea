// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/gamepad/gamepadsource.h"

/// Loads the module that reads gamepads, from beside the program or where it was installed.
/// Errors: Unsupported, with what the loader says; the module is not part of every installation.
[[nodiscard]] Result<std::unique_ptr<GamepadSource>> loadGamepadModule();
