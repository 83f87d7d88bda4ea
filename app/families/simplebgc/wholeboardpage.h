// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class CopyCard;

/// The board as a whole, byte for byte: its memory and the files of its flash, copied, compared and restored.
class WholeBoardPage final : public Page
{
    Q_OBJECT
public:
    enum Way { Save, Compare, RestoreSettings, RestoreAll, EraseFiles };

    explicit WholeBoardPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] CopyCard *card() const { return m_card; }
    [[nodiscard]] bool isUnderWay() const override;

private:
    CopyCard *m_card;
};
