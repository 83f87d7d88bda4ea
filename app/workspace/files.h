// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

/// Writes all of it or nothing. Errors: BadFile.
Result<void> writeFile(const QString &path, const QByteArray &bytes);
