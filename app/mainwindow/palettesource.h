// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow/commandpalette.h"

class MainWindow;

/// Everything the palette can find in this window: pages, parameters, channels and actions of the board.
[[nodiscard]] QList<PaletteEntry> paletteEntries(MainWindow &window);
