// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/setupbutton.h"

#include "protocol/client/deviceclient.h"
#include "widgets/models/parametermodel.h"

#include <QMenu>

using namespace Qt::StringLiterals;

SetupButton::SetupButton(DeviceClient &client, const QString &page, QWidget &parent)
    : QToolButton(&parent)
    , m_client(client)
    , m_page(page)
{
    // Headers have no room for words where the window is small.
    setIcon(QIcon(u":/icons/guide.svg"_s));
    setObjectName(u"plotMenu"_s);
    setPopupMode(InstantPopup);
    setAccessibleName(tr("Gimbal setup"));
    setToolTip(tr("Steps of the guided set-up that belong to this page."));
    setMenu(new QMenu(this));
    connect(&client, &DeviceClient::stateChanged, this, &SetupButton::update);
    update();
}

void SetupButton::update()
{
    menu()->clear();
    const Device *device = m_client.isConnected() ? m_client.device() : nullptr;
    for (const SetupStep step : device ? stepsOf(*device) : std::vector<SetupStep>()) {
        const SetupStepSpec &spec = setupStep(step);
        if (m_page == QLatin1String(spec.elsewhere))
            menu()->addAction(tableText(spec.action.label), this, [this, step] { emit stepWanted(step); });
    }
    setVisible(!menu()->isEmpty());
}
