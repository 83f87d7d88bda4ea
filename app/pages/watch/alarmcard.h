// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class Alarms;
struct AlarmReport;

/// An alarm on the dashboard, until it is acknowledged: what it is, when it was, what it means and what to
/// do.
class AlarmCard final : public QFrame
{
    Q_OBJECT
public:
    AlarmCard(Alarms &alarms, const AlarmReport &report);
};
