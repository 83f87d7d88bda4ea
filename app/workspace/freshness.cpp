// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/freshness.h"

#include "protocol/client/replaycontrol.h"
#include "protocol/device/device.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"
#include "protocol/transport/replay.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kLookEvery = 100ms;
constexpr double kStaleSeconds = 0.5;
constexpr double kStalePeriods = 3.0;
constexpr double kRepeatedSeconds = 2.0;
const QString kTimeFormat = u"HH:mm:ss"_s;
constexpr auto kSilent = 3s;
constexpr auto kBetweenJobs = 1s;
constexpr auto kLongestExcuse = 6s;  // a calibration of the gyroscope takes about four
constexpr double kFirstSeconds = 3.0;  // from the connection until the first sample

// How often one of these channels comes: a slow line thins out some streams more than others.
double rateOf(const TelemetryPlan &plan, const QList<int> &channels)
{
    double rate = 0;
    for (const StreamUse &use : plan.budget.streams) {
        const bool carries = std::any_of(channels.begin(), channels.end(),
                                         [&use](int channel) { return use.channels.contains(channel); });
        if (carries)
            rate = std::max(rate, use.rate);
    }
    return rate > 0 ? rate : plan.rate;
}

}  // namespace

Freshness::Freshness(DeviceClient &client)
    : m_client(client)
{
    m_timer.setInterval(kLookEvery);
    connect(&m_timer, &QTimer::timeout, this, &Freshness::look);
    m_timer.start();
}

std::optional<QDateTime> Freshness::staleSince(const QList<int> &channels) const
{
    const auto store = m_client.telemetry();
    if (!store || m_client.address().isReplay())
        return {};
    TimePoint newest{};
    if (channels.isEmpty()) {
        for (int channel = 0; channel < store->channelCount(); ++channel)
            newest = std::max(newest, store->latestAt(channel));
    }
    for (const int channel : channels)
        newest = std::max(newest, store->latestAt(channel));
    if (newest == TimePoint{}) {
        // Some boards never send one of the channels; a board that sends none at all is noticed.
        const bool isAsked = m_client.isConnected() && store->rows() == 0;
        const double waited = seconds(Clock::now() - store->origin());
        if (!isAsked || waited < kFirstSeconds)
            return {};
        return QDateTime::currentDateTime().addMSecs(-qint64(waited * 1000.0));
    }
    // What still trickles in from a link that is lost is not what is so now.
    if (!m_client.isConnected() && m_connectedAt != TimePoint{})
        newest = std::min(newest, m_connectedAt);
    const double rate = rateOf(m_client.telemetryPlan(), channels);
    const double age = seconds(Clock::now() - newest);
    if (age < std::max(kStaleSeconds, rate > 0 ? kStalePeriods / rate : 0.0))
        return {};
    return QDateTime::currentDateTime().addMSecs(-qint64(age * 1000.0));
}

bool Freshness::isWithoutSensor(const QList<int> &channels) const
{
    const auto store = m_client.telemetry();
    return store && m_client.isConnected() && !channels.isEmpty()
        && std::all_of(channels.begin(), channels.end(), [&store](int channel) {
               return store->latestAt(channel) != TimePoint{} && std::isnan(store->latest(channel));
           });
}

std::optional<QDateTime> Freshness::unchangedSince() const
{
    const auto store = m_client.telemetry();
    if (!store || !m_client.isConnected() || m_client.address().isReplay())
        return {};
    const TimePoint now = Clock::now();
    const auto since = m_change.unchangedSince(*store, now);
    return since
        ? std::optional(QDateTime::currentDateTime().addMSecs(-qint64(seconds(now - *since) * 1000.0)))
        : std::nullopt;
}

// Frames come, and their samples do not: those whose time stamp stands still are none.
bool Freshness::isRepeating() const
{
    const auto store = m_client.telemetry();
    if (!store || !m_client.isConnected() || store->repeatedAt() == TimePoint{})
        return false;
    const double rate = m_client.telemetryPlan().rate;
    return seconds(Clock::now() - store->repeatedAt())
        < std::max(kRepeatedSeconds, rate > 0 ? kStalePeriods / rate : 0.0);
}

std::optional<QDateTime> Freshness::frozenSince() const
{
    const QList<int> angles = ChannelRoles::present({m_client.roles().angle});
    const auto since = staleSince(angles);
    if (since && isRepeating()
        && since->msecsTo(QDateTime::currentDateTime()) >= qint64(kRepeatedSeconds * 1000.0))
        return since;
    return unchangedSince();
}

std::optional<Duration> Freshness::answerTime() const
{
    return staleSince() ? std::nullopt : m_client.statistics().roundTrip;
}

std::optional<QDateTime> Freshness::silentSince() const
{
    const bool isSilent = m_client.isConnected() && !isRepeating() && Clock::now() - m_heardAt >= kSilent;
    return isSilent ? staleSince() : std::nullopt;
}

// A write, a reading or a calibration may keep the board from sending; one that was begun in silence is no
// reason for it.
void Freshness::listen()
{
    const TimePoint now = Clock::now();
    const bool hears = !m_client.isConnected() || !staleSince();
    if (hears)
        m_dataAt = now;
    m_isExcused = m_client.isBusy() && (m_isExcused || hears || now - m_heardAt < kBetweenJobs)
        && now - m_dataAt < kLongestExcuse;
    if (hears || m_isExcused)
        m_heardAt = now;
    if (const bool isSilent = silentSince().has_value(); std::exchange(m_isSilent, isSilent) != isSilent)
        emit silentChanged(isSilent);
}

bool Freshness::hasPlayed() const
{
    const auto &state = m_client.replay().state();
    return m_client.address().isReplay() && state && state->hasEnded();
}

QString Freshness::troubleText(const QList<int> &channels) const
{
    if (const auto since = staleSince(channels))
        return (isRepeating() ? tr("Unchanged since %1") : tr("No data since %1"))
            .arg(since->toString(kTimeFormat));
    if (isWithoutSensor(channels)) {
        const Device *device = m_client.device();
        return device && device->flight() ? tr("Not told before a calibration")
                                          : tr("The board sees no sensor");
    }
    const auto since = unchangedSince();
    return since ? tr("Unchanged since %1").arg(since->toString(kTimeFormat)) : QString();
}

void Freshness::watch(StaleCover &cover, const Channels &channels)
{
    m_covers[&cover] = channels;
    connect(&cover, &QObject::destroyed, this, [this, gone = &cover] { m_covers.erase(gone); });
}

void Freshness::look()
{
    if (m_client.isConnected())
        m_connectedAt = Clock::now();
    m_change.look(m_client.telemetry().get(), Clock::now());
    if (const bool isFrozen = frozenSince().has_value(); std::exchange(m_isFrozen, isFrozen) != isFrozen)
        emit frozenChanged(isFrozen);
    listen();
    for (const auto &[cover, channels] : m_covers) {
        if (cover->parentWidget()->isVisible())
            cover->setText(troubleText(channels ? channels() : QList<int>()));
    }
}
