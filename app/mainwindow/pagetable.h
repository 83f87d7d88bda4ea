// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/pageentry.h"

#include <span>

/// All pages in the order of the navigation.
[[nodiscard]] std::span<const PageEntry> pageTable();
/// The board shown has a use for that page.
[[nodiscard]] bool isOffered(const PageEntry &entry, const Workspace &workspace);
[[nodiscard]] QString pageText(const char *text);
