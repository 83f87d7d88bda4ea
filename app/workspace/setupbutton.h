// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/guide/setupstep.h"

#include <QToolButton>

class DeviceClient;

/// Leads from a page to the steps of the guided set-up that belong to it; hidden where the board has none.
class SetupButton final : public QToolButton
{
    Q_OBJECT
public:
    /// @param page its key, see SetupStepSpec::elsewhere
    SetupButton(DeviceClient &client, const QString &page, QWidget &parent);

signals:
    void stepWanted(SetupStep step);

private:
    void update();

    DeviceClient &m_client;
    QString m_page;
};
