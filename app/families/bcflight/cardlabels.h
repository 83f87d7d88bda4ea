// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QLabel;

/// A paragraph in a card. @param look the name of its style
[[nodiscard]] QLabel *wrappedLabel(const QString &text = {}, const char *look = "");
/// What has come of something; without a text the label is gone.
void sayIn(QLabel &label, const QString &text, const char *look);
