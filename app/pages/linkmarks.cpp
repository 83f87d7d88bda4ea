// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/linkmarks.h"

#include "app/pages/workspace.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kNamed = 3;  // values that one mark spells out

}  // namespace

LinkMarks::LinkMarks(Workspace &workspace)
    : m_workspace(workspace)
{
    DeviceClient &client = workspace.client();
    connect(&client, &DeviceClient::connectionLost, this,
            [this] { add(PlotMark::Kind::Fault, tr("Connection lost")); });
    connect(&client, &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state != DeviceClient::State::Connected)
            return;
        if (const void *store = m_workspace.client().telemetry().get();
            store != std::exchange(m_store, store)) {
            m_workspace.marks().clear();  // another board, another time line
            m_faults.clear();
            m_profile = -1;
            m_silences = 0;
            m_silentSeconds = 0;
        } else {
            add(PlotMark::Kind::Note, tr("Connected again"));
        }
    });
    connect(&client, &DeviceClient::statisticsChanged, this, &LinkMarks::look);
    connect(&client, &DeviceClient::telemetryPlanChanged, this,
            [this] { add(PlotMark::Kind::Note, tr("Streams arranged")); });
    connect(&client, &DeviceClient::motorsOffFinished, this, [this](bool confirmed) {
        add(confirmed ? PlotMark::Kind::Change : PlotMark::Kind::Fault,
            confirmed ? tr("Motors switched off") : tr("Motors off: not confirmed"));
    });
    connect(&workspace, &Workspace::writeFinished, this, [this] {
        const auto &report = m_workspace.lastReport();
        if (report)
            add(PlotMark::Kind::Change, tr("%n value(s) written", nullptr, int(report->lines.size())));
    });
    connect(&workspace.live(), &LiveModel::settled, this, &LinkMarks::onLive);
    connect(&workspace, &Workspace::worldChanged, this, [this](const QString &assignment) {
        add(PlotMark::Kind::Note, tr("Simulated: %1").arg(assignment));
    });
}

void LinkMarks::add(PlotMark::Kind kind, const QString &text)
{
    if (const auto store = m_workspace.client().telemetry())
        m_workspace.marks().add({store->now(), kind, text});
}

void LinkMarks::onLive(const QList<int> &parameters)
{
    const ParameterSet &set = std::as_const(m_workspace.configuration()).edited().parameters();
    QStringList texts;
    for (const int parameter : parameters.first(std::min<qsizetype>(parameters.size(), kNamed))) {
        if (const auto raw = m_workspace.live().value(parameter))
            texts.append(parameterLabel(set.at(parameter)) + u' ' + set.at(parameter).format(*raw));
    }
    if (parameters.size() > kNamed)
        texts.append(tr("and %n more", nullptr, int(parameters.size() - kNamed)));
    if (!texts.isEmpty())
        add(PlotMark::Kind::Change, texts.join(u", "_s));
}

// What telemetry itself tells, a few times a second.
void LinkMarks::look()
{
    const auto store = m_workspace.client().telemetry();
    if (!store || !m_workspace.client().isConnected())
        return;
    const double profile = m_workspace.latest(m_workspace.roles().activeProfile);
    if (!std::isnan(profile) && profile != m_profile) {
        if (m_profile >= 0)
            add(PlotMark::Kind::Change, tr("Profile %1 in use").arg(profile + 1));
        m_profile = profile;
    }
    QSet<QString> faults;
    for (const BoardFault &fault : m_workspace.faults()) {
        faults.insert(fault.key);
        if (!m_faults.contains(fault.key))
            add(PlotMark::Kind::Fault, fault.name);
    }
    m_faults = faults;
    if (store->silences() > m_silences) {
        add(PlotMark::Kind::Note,
            tr("The board was silent for %1 s").arg(store->silentSeconds() - m_silentSeconds, 0, 'f', 1));
        m_silences = store->silences();
        m_silentSeconds = store->silentSeconds();
    }
}
