// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

/// One page of the program, before it is made.
struct PageEntry
{
    const char *key;
    const char *title;  ///< translated in the context "Pages"
    const char *group;  ///< heading of the navigation
    Page *(*make)(Workspace &workspace);
    bool (*fits)(const Workspace &workspace) = nullptr;  ///< null: every board has a use for it
    const char *family = "";  ///< only for boards of this family
    const char *after = "";  ///< of a family's own page: the page that it follows in the navigation
};

/// For PageEntry::make.
template <typename P> Page *makePage(Workspace &workspace)
{
    return new P(workspace);
}
