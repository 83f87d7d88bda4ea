// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/samplewatch.h"

#include "protocol/client/replaycontrol.h"
#include "protocol/device/family.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"
#include "protocol/transport/replay.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLookPeriod = 100ms;
constexpr Duration kSilenceLimit = 3s;
constexpr Duration kArranging = 10s;
constexpr Duration kFresh = 1s;
constexpr double kRowsMissed = 3;  // a slow stream may be late, too
constexpr Duration kReplayRest = 500ms;  // what is delivered last is decoded by then

}  // namespace

SampleWatch::SampleWatch(DeviceClient &client, QList<int> channels, double slowest)
    : m_client(client)
    , m_channels(std::move(channels))
    , m_slowest(slowest)
{
    m_timer.setInterval(kLookPeriod);
    connect(&m_timer, &QTimer::timeout, this, &SampleWatch::look);
    // What was asked for is only on its way from now on. A board whose streams end is asked again and again.
    connect(&m_client, &DeviceClient::telemetryPlanChanged, this, [this] {
        if (const TimePoint now = Clock::now(); now - m_startedAt < kArranging)
            m_heardAt = now;
    });
}

void SampleWatch::start()
{
    m_newest = newest();
    m_heardAt = m_startedAt = Clock::now();
    m_timer.start();
}

void SampleWatch::look()
{
    const TimePoint now = Clock::now();
    if (const Duration same = sameFor(now); same > 0s) {
        end(u"the same again and again for %1 s"_s.arg(seconds(same), 0, 'f', 1));
        return;
    }
    if (const TimePoint latest = newest(); latest != m_newest) {
        m_newest = latest;
        m_heardAt = now;
        m_hasHeard = true;
        return;
    }
    const Duration silence = now - m_heardAt;
    if (m_client.address().isReplay()) {
        // A gap in a recording is what it is; only its end is one.
        const auto &state = m_client.replay().state();
        if (!state || !state->hasEnded() || silence < kReplayRest)
            return;
        m_isReplayed = true;
        end(u"the recording ends after %1 s"_s.arg(state->length, 0, 'f', 1));
    } else if (silence >= limit()) {
        end((m_hasHeard ? u"nothing more for %1 s"_s : u"nothing within %1 s"_s)
                .arg(seconds(silence), 0, 'f', 1));
    }
}

// Only rates of turn are never the same for long: they have noise.
Duration SampleWatch::sameFor(TimePoint now)
{
    const auto store = m_client.telemetry();
    m_change.look(store.get(), now);
    const QList<int> rates = ChannelRoles::present({m_client.roles().gyro});
    const bool isMeasured = store && !m_client.address().isReplay()
        && std::any_of(rates.begin(), rates.end(),
                       [&](int rate) { return now - store->latestAt(rate) < kFresh; });
    const auto since = isMeasured ? m_change.unchangedSince(*store, now) : std::nullopt;
    return since ? now - *since : Duration::zero();
}

void SampleWatch::end(const QString &finding)
{
    m_timer.stop();
    m_finding = finding;
    emit ended();
}

Duration SampleWatch::limit() const
{
    Duration limit = kSilenceLimit;
    for (const Family &family : m_client.families()) {
        if (family.key == m_client.identity().family)
            limit = std::max<Duration>(limit, family.timing.silenceLimit);
    }
    for (const double rate : {m_slowest, m_client.telemetryPlan().rate}) {
        if (rate > 0)
            limit = std::max(limit, durationFromSeconds(kRowsMissed / rate));
    }
    return limit;
}

TimePoint SampleWatch::newest() const
{
    const auto store = m_client.telemetry();
    TimePoint newest{};
    for (const int channel : m_channels) {
        if (store)
            newest = std::max(newest, store->latestAt(channel));
    }
    return newest;
}
