// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"

/// The board's action with this key; null if it has none.
[[nodiscard]] const ActionSpec *actionNamed(const Device &device, const QString &key);
/// "safe", "moves", "writes" or "destroys".
[[nodiscard]] QString riskName(ActionRisk risk);
/// Whether it, or one of its entries, cuts the motors' current.
[[nodiscard]] bool mayLetGo(const ActionSpec &action);
/// What a command says of an action that was performed. One that no board answers is sent; whether it was
/// done nobody can tell.
[[nodiscard]] CommandOutcome doneOutcome(const QString &key, const ActionReply &reply, bool answered = true,
                                         const ActionSpec *action = nullptr);

/// Performs one of the board's actions.
class ActionCommand : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    QList<CommandOption> options() override;

protected:
    /// The action and its arguments.
    [[nodiscard]] virtual QString actionKey() const = 0;
    [[nodiscard]] virtual QStringList given() const = 0;
    [[nodiscard]] QList<int> awaits(const Device &device) const override;
    Result<CommandOutcome> run(Channel &channel, Device &device) override;

private:
    bool m_confirmed = false;
};
