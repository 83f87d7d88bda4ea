// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/unwatchednote.h"

#include "protocol/client/deviceclient.h"
#include "widgets/models/alarmtext.h"

#include <algorithm>
#include <iterator>

using namespace Qt::StringLiterals;

UnwatchedNote::UnwatchedNote(const DeviceClient &client, const QSet<AlarmKind> &kinds, QWidget *parent)
    : QLabel(parent)
    , m_client(client)
    , m_kinds(kinds)
{
    setObjectName(u"muted"_s);
    setWordWrap(true);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // Its place is kept: what is dragged meanwhile does not move when it comes or goes.
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    setSizePolicy(policy);
    setMinimumHeight(2 * fontMetrics().lineSpacing());
    connect(&client, &DeviceClient::unwatchedChanged, this, &UnwatchedNote::update);
    update();
}

void UnwatchedNote::update()
{
    std::vector<Unwatched> missing;
    std::copy_if(m_client.unwatched().begin(), m_client.unwatched().end(), std::back_inserter(missing),
                 [this](const Unwatched &each) { return m_kinds.contains(each.kind); });
    setText(missing.empty() ? QString() : tr("Not watched: %1.").arg(unwatchedText(missing)));
    // Shown before it has its place it would be a window, which takes the focus from the program's own.
    if (parentWidget() || missing.empty())
        setHidden(missing.empty());
}
