// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/linkmarks.h"

#include "protocol/configuration/writereport.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kNamed = 3;  // values that one mark spells out

}  // namespace

LinkMarks::LinkMarks(DeviceClient &client, const ConfigurationModel &configuration, LiveModel &live,
                     PlotMarks &marks)
    : m_client(client)
    , m_configuration(configuration)
    , m_live(live)
    , m_marks(marks)
{
    connect(&client, &DeviceClient::connectionLost, this, [this, &client] {
        if (client.loss() == DeviceClient::Loss::Link)
            add(PlotMark::Kind::Fault, tr("Connection lost"));
        else
            add(PlotMark::Kind::Fault, tr("Board restarted"));
    });
    connect(&client, &DeviceClient::stateChanged, this, &LinkMarks::onState);
    connect(&client, &DeviceClient::telemetryPlanChanged, this,
            [this] { add(PlotMark::Kind::Note, tr("Streams arranged")); });
    connect(&client, &DeviceClient::motorsOffFinished, this, [this](bool confirmed) {
        add(confirmed ? PlotMark::Kind::Change : PlotMark::Kind::Fault,
            confirmed ? tr("Motors switched off") : tr("Motors off: not confirmed"));
    });
    connect(&live, &LiveModel::settled, this, &LinkMarks::onLive);
}

void LinkMarks::add(PlotMark::Kind kind, const QString &text)
{
    if (const auto store = m_client.telemetry())
        m_marks.add({store->now(), kind, text});
}

void LinkMarks::addWritten(const WriteReport &report)
{
    add(PlotMark::Kind::Change, tr("%n value(s) written", nullptr, int(report.lines.size())));
}

void LinkMarks::addWorld(const QString &assignment)
{
    add(PlotMark::Kind::Note, tr("Simulated: %1").arg(assignment));
}

void LinkMarks::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected)
        return;
    if (const void *store = m_client.telemetry().get(); store != std::exchange(m_store, store)) {
        m_marks.clear();  // another board: times start anew
        m_faults.clear();
        m_profile = -1;
        m_silences = 0;
        m_silentSeconds = 0;
    } else {
        add(PlotMark::Kind::Note, tr("Connected again"));
    }
}

void LinkMarks::onLive(const QList<int> &parameters)
{
    const ParameterSet &set = m_configuration.edited().parameters();
    QStringList texts;
    for (const int parameter : parameters.first(std::min<qsizetype>(parameters.size(), kNamed))) {
        if (const auto raw = m_live.value(parameter))
            texts.append(parameterLabel(set.at(parameter)) + u' '
                         + parameterValueText(set.at(parameter), *raw));
    }
    if (parameters.size() > kNamed)
        texts.append(tr("and %n more", nullptr, int(parameters.size() - kNamed)));
    if (!texts.isEmpty())
        add(PlotMark::Kind::Change, texts.join(u", "_s));
}

void LinkMarks::look(double profile, const std::vector<BoardFault> &faults)
{
    const auto store = m_client.telemetry();
    if (!store || !m_client.isConnected())
        return;
    if (!std::isnan(profile) && profile != m_profile) {
        if (m_profile >= 0)
            add(PlotMark::Kind::Change, tr("Profile %1 in use").arg(profile + 1));
        m_profile = profile;
    }
    QSet<QString> keys;
    for (const BoardFault &fault : faults) {
        keys.insert(fault.key);
        if (!m_faults.contains(fault.key))
            add(PlotMark::Kind::Fault, fault.name);
    }
    m_faults = keys;
    if (store->silences() > m_silences) {
        add(PlotMark::Kind::Note,
            tr("The board was silent for %1 s").arg(numberText(store->silentSeconds() - m_silentSeconds, 1)));
        m_silences = store->silences();
        m_silentSeconds = store->silentSeconds();
    }
}
