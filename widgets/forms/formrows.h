// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QFormLayout;

/// Puts every label of the form on the base line of its field; call it when all rows are in. (A QFormLayout
/// gives a label 7/4 of its own height, which ends above the middle of a field.)
void alignLabels(QFormLayout &form);
