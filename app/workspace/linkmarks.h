// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/livemodel.h"
#include "widgets/plot/plotmarks.h"

#include <QSet>

struct WriteReport;

/// Marks events on the link in the plots: connection lost and restored, profile switched, values written,
/// faults of the board, gaps in the data.
class LinkMarks final : public QObject
{
    Q_OBJECT
public:
    LinkMarks(DeviceClient &client, const ConfigurationModel &configuration, LiveModel &live,
              PlotMarks &marks);

    /// Adds a mark at this moment.
    void add(PlotMark::Kind kind, const QString &text);
    void addWritten(const WriteReport &report);
    void addWorld(const QString &assignment);
    /// Looks for events in the telemetry itself; called a few times a second.
    /// @param profile the active one, NaN while it is not known
    void look(double profile, const std::vector<BoardFault> &faults);

private:
    void onState(DeviceClient::State state);
    void onLive(const QList<int> &parameters);

    DeviceClient &m_client;
    const ConfigurationModel &m_configuration;
    LiveModel &m_live;
    PlotMarks &m_marks;
    const void *m_store = nullptr;
    QSet<QString> m_faults;
    double m_profile = -1;
    quint64 m_silences = 0;
    double m_silentSeconds = 0;
};
