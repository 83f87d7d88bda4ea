// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

/// A window's frame with all of it on the screen: no larger than the room there, and moved no farther than
/// need be.
[[nodiscard]] QRect keptOnScreen(const QRect &frame, const QRect &room);
