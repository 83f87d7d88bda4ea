// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

/// Bytes from hex digits; blanks are allowed anywhere. Empty for any other character or an odd number of
/// digits.
[[nodiscard]] std::optional<QByteArray> bytesFromHex(QString digits);
