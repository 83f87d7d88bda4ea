// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

/// Bytes out of hex digits, with blanks wherever somebody likes them. Nothing: other characters, or half a
/// byte.
[[nodiscard]] std::optional<QByteArray> bytesFromHex(QString digits);
