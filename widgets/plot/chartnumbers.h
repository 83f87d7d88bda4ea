// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QChart;

/// The axes of this chart write their numbers as the rest of the screen does.
void writeNumbers(QChart &chart);
