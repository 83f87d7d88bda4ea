// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <functional>

/// A question to a drone that nobody ordered: while something runs it waits until that is over, without a
/// word.
class QuietQuestion final : public QObject
{
    Q_OBJECT
public:
    using Told = std::function<void(const Result<ActionOutcome> &)>;

    /// @param action the key of the action that asks
    QuietQuestion(Workspace &workspace, const QString &action, Told told, QObject *parent);

    void ask();

private:
    void askIfDue();

    Workspace &m_workspace;
    QString m_action;
    Told m_told;
    bool m_isDue = false;
};
