// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/pageentry.h"

/// The pages and wizards that only one family's boards have, in the order in which they are put into the
/// navigation.
[[nodiscard]] QList<PageEntry> familyPages();
