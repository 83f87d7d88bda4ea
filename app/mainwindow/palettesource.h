// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow/commandpalette.h"

class Navigation;
class Page;
class Workspace;

/// What choosing an entry does to the window.
struct PaletteTargets
{
    std::function<Page *(const QString &key)> showPage;  ///< shows a page and returns it
    std::function<void(const QString &key)> showAction;
    std::function<void()> review;
    std::function<void()> startMotors;
    std::function<void()> showMessages;
    std::function<void()> openFile;
};

/// Everything the palette can find: the pages that are offered, parameters, channels and actions of the
/// board.
[[nodiscard]] QList<PaletteEntry> paletteEntries(Workspace &workspace, const Navigation &navigation,
                                                 const PaletteTargets &targets);
