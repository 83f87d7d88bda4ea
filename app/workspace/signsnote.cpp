// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/signsnote.h"

#include "app/workspace/flightstate.h"
#include "app/workspace/workspace.h"
#include "widgets/models/parametermodel.h"

using namespace Qt::StringLiterals;

SignsNote::SignsNote(Workspace &workspace, QWidget *parent)
    : QLabel(parent)
    , m_workspace(workspace)
{
    setObjectName(u"muted"_s);
    setWordWrap(true);
    hide();
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &SignsNote::refresh);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &SignsNote::refresh);
    connect(&workspace.naming(), &BoardNaming::changed, this, &SignsNote::refresh);
}

void SignsNote::refresh()
{
    QStringList turned;
    const auto signs = shownSigns(m_workspace);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (signs[axis] < 0 && m_workspace.roles().angle[axis] >= 0)
            turned.append(axisLabel(kAxes[axis]));
    }
    setText(turned.isEmpty() ? QString()
                             : tr("Signs as the drone counts them. On “Flight” they are as the check of "
                                  "directions has found them, the other way round: %1.")
                                   .arg(turned.join(u", "_s)));
    setVisible(!turned.isEmpty());
}
