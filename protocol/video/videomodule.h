// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/codecs.h"

/// Names another folder with the module, for packages and tests.
inline constexpr const char *kVideoModuleFolder = "GIMBALDESK_MODULES";

/// The module with libav, from beside the programs; loaded by the first call, and kept. The programs do not
/// link libav: it would cost every start time and memory. Errors: Unsupported, saying where it was looked
/// for.
[[nodiscard]] Result<const VideoCodecs *> loadVideoCodecs();
