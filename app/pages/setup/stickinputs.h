// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QWidget>

class InputBars;
class Workspace;

/// What the sticks of a remote control do at the board's inputs, beside the step that finds them; and the
/// sticks themselves where they are simulated.
class StickInputs final : public QWidget
{
    Q_OBJECT
public:
    static constexpr milliseconds kAsk{200};

    explicit StickInputs(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] InputBars *bars() const { return m_bars; }
    /// What comes in now, while no step runs that tells it. The last question is waited for.
    void ask();

private:
    Workspace &m_workspace;
    InputBars *m_bars;
    bool m_isAsking = false;
};
