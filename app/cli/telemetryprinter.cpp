// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/telemetryprinter.h"

#include "protocol/base/filefault.h"

#include <QJsonObject>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kDrainPeriod = 50ms;
constexpr auto kUnderWay = 500ms;  // what was sent in time is here by then

}  // namespace

Error outputError(int code)
{
    // A stream that has written before it was flushed kept no reason; one byte more is refused for the same.
    if (code == 0 && ::write(STDOUT_FILENO, "\n", 1) < 0)
        code = errno;
    return FileFault{.problem = code == ENOSPC ? FileProblem::DiskFull : FileProblem::System,
                     .kind = FileKind::Other,
                     .path = u"stdout"_s,
                     .writing = true,
                     .said = code ? QString::fromLocal8Bit(std::strerror(code)) : u"it takes no more"_s}
        .error();
}

QString valuelessNote(const TelemetryStore &store, ChannelTable table, const QList<int> &channels)
{
    QStringList keys;
    for (const int channel : channels) {
        if (store.latestAt(channel) != TimePoint{} && std::isnan(store.latest(channel)))
            keys.append(QLatin1String(table[std::size_t(channel)].key));
    }
    return keys.isEmpty()
        ? QString()
        : u", without a value (no number came, as where no sensor sends any): %1"_s.arg(keys.join(u' '));
}

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
    flush();
    // A board that sends less than it should does not make it longer.
    const bool isLive = !m_client.address().isReplay();
    if (m_failure
        || (isLive && m_firstTime && m_seconds > 0
            && Clock::now() - m_begunAt >= durationFromSeconds(m_seconds) + kUnderWay)) {
        const int holes = m_holes.count();
        const double rest = m_seconds - (m_lastTime - m_firstTime.value_or(m_lastTime));
        m_holes.take(rest, m_tracks[std::size_t(m_lead)]->period());
        m_silentAtEnd = m_holes.count() > holes ? rest : 0.0;
        finish();
    }
}

// A full disk, say: the rows are lost.
void TelemetryPrinter::flush()
{
    errno = 0;
    m_out.flush();
    if (m_out.status() != QTextStream::Ok && !m_failure)
        m_failure = outputError(errno);
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
        m_firstTime = m_lastTime = time;
        m_begunAt = Clock::now();
        printHeading();
    }
    const double elapsed = time - *m_firstTime;
    const TelemetryGroup *leadGroup = m_tracks[std::size_t(m_lead)]->group();
    m_holes.take(time - m_lastTime, m_tracks[std::size_t(m_lead)]->period());
    m_lastTime = time;
    if (m_seconds > 0 && elapsed >= m_seconds) {
        finish();
        return;
    }
    ++m_rows;
    QJsonArray values;
    if (!m_asJson)
        m_out << QString::number(elapsed, 'f', 4);
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
    flush();
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
    note += m_holes.words();
    if (store && m_client.device())
        note += valuelessNote(*store, m_client.device()->channels(), m_channels);
    emit finished(note);
}

QJsonValue TelemetryPrinter::json() const
{
    QJsonArray names{u"time_s"_s};
    for (const int channel : m_channels)
        names.append(QLatin1String(m_client.device()->channels()[std::size_t(channel)].key));
    const auto store = m_client.telemetry();
    QJsonObject object{{u"columns"_s, names},
                       {u"rows"_s, m_json},
                       {u"lost"_s, qint64(store ? store->lost() : 0)},
                       {u"rate"_s, m_client.telemetryPlan().rate}};
    if (m_holes.count() > 0)
        object.insert(u"holes"_s, m_holes.json());
    return object;
}
