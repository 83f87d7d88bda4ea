// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"
#include "widgets/theme/theme.h"

#include <QImage>

/// All values of one profile as one picture, group by group, to share; what differs from
/// the default is bold. @param scale device pixels per pixel @param note stands on it, beneath the board's
/// name
[[nodiscard]] QImage settingsPicture(const Configuration &configuration, int profile, const Theme &theme,
                                     double scale, const QString &note = {});
