// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/telemetryprinter.h"

#include <QJsonObject>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kDrainPeriod = 50ms;

}  // namespace

TelemetryPrinter::TelemetryPrinter(DeviceClient &client, QList<int> channels, Subscription subscription,
                                   double seconds, bool asJson)
    : m_client(client)
    , m_channels(std::move(channels))
    , m_subscription(std::move(subscription))
    , m_seconds(seconds)
    , m_asJson(asJson)
    , m_tracks(std::size_t(m_channels.size()))
{
    m_timer.setInterval(kDrainPeriod);
    connect(&m_timer, &QTimer::timeout, this, &TelemetryPrinter::drain);
}

void TelemetryPrinter::start()
{
    m_client.subscribe(m_subscription);
    m_timer.start();
}

void TelemetryPrinter::drain()
{
    const auto store = m_client.telemetry();
    // Rows count only once the stream we asked for is the one that runs.
    if (!store || !m_client.telemetryPlan().decoder)
        return;
    if (store->generation() != m_generation) {
        m_generation = store->generation();
        const int lead = m_lead;
        std::size_t maxRows = 0;
        for (std::size_t i = 0; i < m_tracks.size(); ++i) {
            auto tracks = store->tracks(m_channels[qsizetype(i)]);
            m_tracks[i].reset();
            if (tracks.empty())
                continue;
            m_tracks[i] = tracks.back();
            // The fastest stream sets the pace: the one with the shortest period, else the fuller one.
            const double period = m_tracks[i]->period();
            if (m_lead < 0 || (period > 0 && m_tracks[std::size_t(m_lead)]->period() <= 0)
                || (period <= 0 && m_tracks[i]->end() > maxRows
                    && m_tracks[std::size_t(m_lead)]->period() <= 0))
                m_lead = int(i);
            maxRows = std::max(maxRows, m_tracks[i]->end());
        }
        if (m_lead != lead && m_lead >= 0)
            m_next = m_tracks[std::size_t(m_lead)]->begin();
    }
    if (m_lead < 0)
        return;
    for (auto &track : m_tracks) {
        if (track)
            track->refresh();
    }
    const TrackView &lead = *m_tracks[std::size_t(m_lead)];
    for (m_next = std::max(m_next, lead.begin()); m_next < lead.end() && !m_done; ++m_next)
        printRow(lead.time(m_next), m_next);
    m_out.flush();
}

void TelemetryPrinter::printHeading()
{
    if (m_asJson)
        return;
    m_out << "time_s";
    for (const int channel : m_channels)
        m_out << ',' << m_client.device()->channels()[std::size_t(channel)].key;
    m_out << '\n';
}

void TelemetryPrinter::printRow(double time, std::size_t row)
{
    if (!m_firstTime) {
        m_firstTime = time;
        printHeading();
    }
    const double elapsed = time - *m_firstTime;
    if (m_seconds > 0 && elapsed >= m_seconds) {
        finish();
        return;
    }
    ++m_rows;
    QJsonArray values;
    if (!m_asJson)
        m_out << QString::number(elapsed, 'f', 4);
    const TelemetryGroup *leadGroup = m_tracks[std::size_t(m_lead)]->group();
    for (const auto &track : m_tracks) {
        float value = std::numeric_limits<float>::quiet_NaN();
        if (track && track->group() == leadGroup)
            value = track->value(row);
        else if (track && track->end() > track->begin())
            value = track->value(track->end() - 1);
        if (m_asJson)
            values.append(std::isnan(value) ? QJsonValue() : QJsonValue(double(value)));
        else
            m_out << ',' << (std::isnan(value) ? QString() : QString::number(double(value), 'g', 7));
    }
    if (m_asJson) {
        values.prepend(elapsed);
        m_json.append(values);
    } else {
        m_out << '\n';
    }
}

void TelemetryPrinter::finish()
{
    if (m_done)
        return;
    m_done = true;
    m_timer.stop();
    m_out.flush();
    const auto store = m_client.telemetry();
    QString note = u"%1 rows, %2 lost"_s.arg(m_rows).arg(store ? store->lost() : 0);
    if (const double rate = m_client.telemetryPlan().rate;
        rate > 0)  // the rate of a recording cannot be chosen
        note += u", %1 rows/s arranged"_s.arg(rate, 0, 'f', 0);
    const StreamBudget &budget = m_client.telemetryPlan().budget;
    if (budget.capacity > 0) {
        note += u", %1 of %2 bytes/s"_s.arg(budget.bytesPerSecond(), 0, 'f', 0)
                    .arg(budget.capacity, 0, 'f', 0);
    }
    if (store && store->silences() > 0)
        note += u", silent %1 times, %2 s"_s.arg(store->silences()).arg(store->silentSeconds(), 0, 'f', 1);
    emit finished(note);
}

QJsonValue TelemetryPrinter::json() const
{
    QJsonArray names{u"time_s"_s};
    for (const int channel : m_channels)
        names.append(QLatin1String(m_client.device()->channels()[std::size_t(channel)].key));
    const auto store = m_client.telemetry();
    return QJsonObject{{u"columns"_s, names},
                       {u"rows"_s, m_json},
                       {u"lost"_s, qint64(store ? store->lost() : 0)},
                       {u"rate"_s, m_client.telemetryPlan().rate}};
}
