// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/page.h"

#include <span>

/// One page of the program, before it is made.
struct PageEntry
{
    const char *key;
    const char *title;  ///< translated in the context "Pages"
    const char *group;  ///< heading of the navigation
    Page *(*make)(Workspace &workspace);
    bool (*fits)(const Workspace &workspace) = nullptr;  ///< null: every board has a use for it
};

/// All pages in the order of the navigation.
[[nodiscard]] std::span<const PageEntry> pageTable();
[[nodiscard]] QString pageText(const char *text);
