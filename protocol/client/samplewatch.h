// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/telemetry/changewatch.h"

#include <QTimer>

/// Notices when the samples of some channels stop coming. Only what was decoded counts, not bytes: a board
/// may talk all the time without telling anything, or tell the same again and again.
class SampleWatch final : public QObject
{
    Q_OBJECT
public:
    /// @param slowest rows per second of the slowest stream that was asked for; 0 = not chosen
    SampleWatch(DeviceClient &client, QList<int> channels, double slowest);

    void start();
    /// Whether any sample has come since start().
    [[nodiscard]] bool hasHeard() const { return m_hasHeard; }
    /// Why it ended; empty as long as samples come.
    [[nodiscard]] const QString &finding() const { return m_finding; }
    /// The link was a recording, and it is over.
    [[nodiscard]] bool isReplayed() const { return m_isReplayed; }

signals:
    /// Once: no sample for the silence limit, nothing but the same, or the recording that is played is over.
    void ended();

private:
    void look();
    [[nodiscard]] Duration limit() const;
    [[nodiscard]] TimePoint newest() const;
    /// The board measures motion, and has sent the same values for this long; zero: they change.
    [[nodiscard]] Duration sameFor(TimePoint now);
    void end(const QString &finding);

    DeviceClient &m_client;
    QList<int> m_channels;
    double m_slowest;
    QTimer m_timer;
    ChangeWatch m_change;
    TimePoint m_newest{};  // time of the newest sample, by the store
    TimePoint m_heardAt{};  // when it came
    TimePoint m_startedAt{};
    bool m_hasHeard = false;
    bool m_isReplayed = false;
    QString m_finding;
};
