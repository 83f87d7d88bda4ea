// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/video/videotypes.h"

/// A file of its own for a picture or a recording, named by date and time. Makes the folder if need be.
/// @param suffix "png"
/// Errors: BadFile.
[[nodiscard]] Result<QString> newVideoFile(const QString &folder, const QString &suffix);
/// Saves a picture as PNG. Errors: BadFile.
[[nodiscard]] Result<void> saveStill(const VideoPicture &picture, const QString &path);
/// The operator's folder for pictures.
[[nodiscard]] QString defaultVideoFolder();
