// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/holes.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/device/family.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QJsonArray>
#include <QTextStream>
#include <QTimer>

/// What the system said when standard output took no more.
[[nodiscard]] Error outputError(int code);

/// Names the channels that came without a value, because there is no sensor behind them; empty if all have
/// one. Starts with a comma.
[[nodiscard]] QString valuelessNote(const TelemetryStore &store, ChannelTable table,
                                    const QList<int> &channels);

/// Prints telemetry as CSV, one line per sample of the fastest group; slower channels repeat their latest
/// value.
class TelemetryPrinter final : public QObject
{
    Q_OBJECT
public:
    /// @param channels columns; @param wish what to ask the board for
    TelemetryPrinter(DeviceClient &client, QList<int> channels, Subscription subscription, double seconds,
                     bool asJson);

    void start();
    void finish();
    [[nodiscard]] QJsonValue json() const;
    [[nodiscard]] qint64 rows() const { return m_rows; }

    /// Seconds without a sample at the end of the time that was given; 0 if they came to the end.
    [[nodiscard]] double silentAtEnd() const { return m_silentAtEnd; }
    /// Why rows were lost on their way out.
    [[nodiscard]] const std::optional<Error> &failure() const { return m_failure; }

signals:
    void finished(const QString &note);

private:
    void drain();
    void flush();
    void printHeading();
    void printRow(double time, std::size_t row);

    DeviceClient &m_client;
    QList<int> m_channels;
    Subscription m_subscription;
    double m_seconds;
    bool m_asJson;
    QTextStream m_out{stdout};
    QTimer m_timer;
    int m_generation = -1;
    std::vector<std::optional<TrackView>> m_tracks;
    int m_lead = -1;  // the channel whose rows are printed
    std::size_t m_next = 0;
    std::optional<double> m_firstTime;
    double m_lastTime = 0;
    TimePoint m_begunAt{};  // when the first row was printed
    Holes m_holes;
    double m_silentAtEnd = 0;
    QJsonArray m_json;
    qint64 m_rows = 0;
    std::optional<Error> m_failure;
    bool m_done = false;
};
