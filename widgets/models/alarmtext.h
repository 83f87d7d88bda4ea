// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarmreport.h"
#include "protocol/supervisor/unwatched.h"
#include "widgets/models/errortext.h"

#include <vector>

class ParameterSet;

/// An alarm in the operator's words: what was seen, with figures and what was done about it; what it means;
/// what to do.
/// @param parameters of the board, to name values that were taken back; null: they are counted
[[nodiscard]] ErrorText describe(const AlarmReport &report, const ParameterSet *parameters);

/// The kind of an alarm as a heading: "Runaway".
[[nodiscard]] QString alarmName(AlarmKind kind);
/// That of its kind, or of its cause where the kind would say too much.
[[nodiscard]] QString alarmName(const Alarm &alarm);

/// What cannot be watched for, with the reasons; empty if there is nothing of the kind.
[[nodiscard]] QString unwatchedText(const std::vector<Unwatched> &missing);
