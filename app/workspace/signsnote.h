// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

class Workspace;

/// Says which angles the page Flight shows with the other sign than whatever shows them as the board tells
/// them; hidden where all agree.
class SignsNote final : public QLabel
{
    Q_OBJECT
public:
    explicit SignsNote(Workspace &workspace, QWidget *parent = nullptr);
    /// To be called when it may be others since: the directions are checked on another page.
    void refresh();

private:
    Workspace &m_workspace;
};
