// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/composition/links.h"
#include "protocol/device/family.h"

// The program as it would be with this family alone.
[[nodiscard]] QList<Family> toyFamilies();
[[nodiscard]] Links toyLinks();
