// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QChart;

/// The axes of this chart write their numbers as the rest of the screen does.
void writeNumbers(QChart &chart);

/// A printf format for labels of such a chart: Qt Charts writes nothing in a language where the format has no
/// precision.
[[nodiscard]] QString labelFormat(QString format);
