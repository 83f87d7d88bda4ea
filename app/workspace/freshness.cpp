// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/freshness.h"

#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"

#include <algorithm>

using namespace std::chrono_literals;

namespace {

constexpr auto kLookEvery = 100ms;
constexpr double kStaleSeconds = 0.5;
constexpr double kStalePeriods = 3.0;
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
    const double rate = rateOf(m_client.telemetryPlan(), channels);
    const double age = seconds(Clock::now() - newest);
    if (age < std::max(kStaleSeconds, rate > 0 ? kStalePeriods / rate : 0.0))
        return {};
    return QDateTime::currentDateTime().addMSecs(-qint64(age * 1000.0));
}

void Freshness::watch(StaleCover &cover, const Channels &channels)
{
    m_covers[&cover] = channels;
    connect(&cover, &QObject::destroyed, this, [this, gone = &cover] { m_covers.erase(gone); });
}

void Freshness::look()
{
    for (const auto &[cover, channels] : m_covers) {
        if (cover->parentWidget()->isVisible())
            cover->setSince(staleSince(channels ? channels() : QList<int>()));
    }
}
