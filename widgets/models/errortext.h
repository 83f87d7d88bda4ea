// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/progress.h"
#include "protocol/base/result.h"
#include "protocol/configuration/livevalues.h"

struct FileFault;
struct WriteReport;

/// An error in the operator's words: what happened, what it means for the gimbal, what to do.
struct ErrorText
{
    QString what;
    QString meaning;
    QString cure;
    QString detail;  ///< the system's or the board's own message, for support
    QString motors = {};  ///< what its motors may do, as long as that is not known

    /// All of it in one paragraph.
    [[nodiscard]] QString oneLine() const;
};

[[nodiscard]] ErrorText describe(const Error &error);

/// What happened to which file in which line, what it means, what to do.
[[nodiscard]] ErrorText describe(const FileFault &fault);

/// A write that was not completed: why, how many values are how, and what the board holds now.
[[nodiscard]] ErrorText describe(const WriteReport &report);

/// "P, roll 62, P, pitch 55 and 3 more".
[[nodiscard]] QString liveText(const Configuration &board, const LiveValues &values);
/// Motors that run, or do not, otherwise than before something that was not to switch them.
[[nodiscard]] QString motorsNowText(bool run);
/// What was noticed of a restart of the board during a write; empty if nothing.
[[nodiscard]] QString restartText(const WriteReport &report);

/// A progress report as a sentence: "Reading PARAMS_3, profile 2".
[[nodiscard]] QString describe(const Progress &progress);
