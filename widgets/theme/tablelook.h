// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

/// Rows without lines and numbers; Tab goes on to the next widget, not to the next cell.
void setPlainRows(QTableView &table);

/// The same, and a click chooses a whole row; titles stand at the left and do not follow what is chosen.
void setSelectableRows(QTableView &table);
