// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>

/// The detail of an error (Error::detail) in the operator's language: each of our own sentences in it, and
/// the rest as it is.
[[nodiscard]] QString detailText(const QString &detail);

/// Our own sentences that details are made of, with their placeholders.
[[nodiscard]] std::span<const char *const> detailSentences();
