// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "widgets/views/card.h"

class QScrollArea;

/// Actions of the board that belong to steering: each with its fields and a button.
class FunctionsCard final : public Card
{
    Q_OBJECT
public:
    explicit FunctionsCard(Workspace &workspace, QWidget *parent = nullptr);
    /// Offers what the present board can do; hidden if that is nothing.
    void fill();

private:
    Workspace &m_workspace;
    QScrollArea *m_scroll;
};
