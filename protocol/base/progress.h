// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>

/// Progress of a job, for display.
struct Progress
{
    int done = 0;
    int total = 0;  ///< 0 = unknown
    QString step;  ///< key of the step ("read-block"), worded in widgets/
    QString subject;  ///< what it works on ("PARAMS_3")
    int profile = -1;  ///< from 0, where the board keeps the subject for each profile, else -1
    QMap<QString, double> values;  ///< live figures of a procedure, by key
};
