// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/pingprobe.h"

#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/payloads.h"

#include <algorithm>

namespace bcflight {

namespace {

constexpr std::size_t kFewestPings = 4;
constexpr int kFewestPackets = 20;  // per window: fewer are no measure
constexpr double kWellAnswered = 0.7;
constexpr int kThinInARow = 3;
constexpr int kFewestGaps = 3;  // per window
constexpr double kMostRegained = 0.8;
constexpr auto kFoundBy = 10s;  // longest time for which an answer to what has found the drone is under way
constexpr std::size_t kSilentPings
    = 3;  // in a row: the drone is away or deaf, and its stream may be another then

std::uint16_t wordAt(Bytes bytes)
{
    return std::uint16_t(std::to_integer<unsigned>(bytes[0]) << 8 | std::to_integer<unsigned>(bytes[1]));
}

// What the ground means by this id, in the newest generation that knows it.
std::optional<Message> askedMessage(int wire)
{
    for (int generation = int(Generation::G); generation >= int(Generation::A); --generation) {
        if (const auto id = groundMessage(wire, Generation(generation)))
            return id;
    }
    return {};
}

// What changes or ends the stream on purpose.
bool changesStream(Message id)
{
    return id == Message::SetFullTelemetry || id == Message::UploadInit || id == Message::SetConfigFile
        || id == Message::UploadProcess || id == Message::MotorTest || id == Message::CalibrateEscs;
}

}  // namespace

std::uint16_t PingProbe::tickAt(TimePoint time)
{
    return std::uint16_t(std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count());
}

QByteArray PingProbe::beat(TimePoint now)
{
    const auto last = std::chrono::round<milliseconds>(m_roundTrip.value_or(Duration{})).count();
    return encode(Message::Ping,
                  bigU16(tickAt(now)) + bigU16(std::uint16_t(std::clamp<qint64>(last, 0, 0xFFFF))));
}

void PingProbe::sent(Bytes bytes, TimePoint now)
{
    while (bytes.size() >= 2) {
        int wire = std::to_integer<int>(bytes[0]);
        const std::size_t idSize = wire & 0x80 ? 1 : 2;
        if (idSize == 2)
            wire = wordAt(bytes);
        const Bytes payload = bytes.subspan(idSize);
        const auto id = askedMessage(wire);
        const MessageSpec *message = id ? findMessage(*id) : nullptr;
        if (!message || !message->fromGround)
            return;
        noteAsked(*id, now);
        if (*id == Message::Ping && payload.size() >= 2)
            pingSent(wordAt(payload), now);
        const auto size = payloadSize(*message->fromGround, payload);
        if (!size || *size > payload.size())
            return;
        bytes = payload.subspan(*size);
    }
    if (bytes.size() == 1 && (std::to_integer<int>(bytes[0]) & 0x80)) {
        if (const auto id = askedMessage(std::to_integer<int>(bytes[0])))
            noteAsked(*id, now);
    }
}

// STATUS and TELEMETRY come along with other answers in the older generations (errata 1), and the text of the
// configuration answers another id in the first.
void PingProbe::noteAsked(Message id, TimePoint now)
{
    m_asked[id] = now;
    if (id == Message::Ping || id == Message::Telemetry) {
        m_asked[Message::Status] = now;
        m_asked[Message::Telemetry] = now;
    }
    if (id == Message::GetCamerasInfos)
        m_asked[Message::GetConfigFile] = now;
    if (changesStream(id))
        m_usual = m_before = m_thinWindows = 0;
}

void PingProbe::pingSent(std::uint16_t tick, TimePoint now)
{
    m_pings.push_back({tick, now});
    m_begun = m_begun.value_or(now);
    if (m_pings.size() > kRemembered) {
        m_older.push_back(m_pings.front());
        m_pings.pop_front();
    }
    while (!m_older.empty() && now - m_older.front().at > kAnswerable)
        m_older.pop_front();
    closeWindows(now);
}

void PingProbe::frameArrived(const FrameView &frame, TimePoint at)
{
    closeWindows(at);
    const auto id = Message(frame.id);
    const MessageSpec *message = frame.id == kDiscarded ? nullptr : findMessage(id);
    const Duration gap = at - std::exchange(m_heardAt, at);
    m_gap = std::max(m_gap, gap);
    if (message)
        noteGap(id, message->isStreamed, gap);
    if (id == Message::Ping) {
        pingArrived(frame.payload, at);
        return;
    }
    if (!message)
        return;
    if (message->isStreamed) {
        countStream(id);
        return;
    }
    if (!message->fromGround || id == Message::Unknown)
        return;
    const auto asked = m_asked.find(id);
    if (asked == m_asked.end() || at - asked->second > kAnswerable)
        noteForeign(at);
}

// The tick counts modulo 65536 and wraps every 65.5 s; the PINGs of the last seconds are told apart by it all
// the same.
void PingProbe::pingArrived(Bytes payload, TimePoint at)
{
    if (payload.size() < 2)
        return;
    const std::uint16_t tick = wordAt(payload);
    const auto ours = std::find_if(m_pings.rbegin(), m_pings.rend(),
                                   [tick](const Ping &ping) { return ping.tick == tick; });
    if (ours == m_pings.rend()) {
        // Whoever was deaf or held up answers what was long ago.
        if (std::ranges::any_of(m_older, [tick](const Ping &ping) { return ping.tick == tick; }))
            return;
        // The link was found by PINGs, of which this probe has not heard; their answers may be late.
        const auto age = milliseconds(std::uint16_t(tickAt(at) - tick));
        if (age > kFoundBy || (m_begun && at - age >= *m_begun))
            noteForeign(at);
        return;
    }
    if (ours->isAnswered)
        return;  // a datagram that came twice
    ours->isAnswered = true;
    m_roundTrip = at - ours->at;
    if (at < m_silentUntil)
        forgetAbsence(ours.base() - 1);
}

// What a restart on purpose left unanswered says nothing about the link.
void PingProbe::forgetAbsence(std::deque<Ping>::iterator back)
{
    auto first = back;
    while (first != m_pings.begin() && !std::prev(first)->isAnswered)
        --first;
    if (std::size_t(back - first) >= kSilentPings)
        m_pings.erase(first, back);
}

void PingProbe::noteForeign(TimePoint at)
{
    ++m_foreign;
    m_sharedAt = at;
}

// Packets that were late come at once: their time does not tell them apart.
void PingProbe::countStream(Message id)
{
    m_packets = std::max(m_packets, ++m_streamed[id]);
}

// Answer and stream come back together, either of them first.
void PingProbe::noteGap(Message id, bool isStreamed, Duration gap)
{
    if (gap >= kTaken) {
        ++m_gaps;
        m_isRegaining = true;
        m_sinceGap.reset();
    }
    if (!m_isRegaining)
        return;
    if (!isStreamed) {
        ++m_regained;
        m_isRegaining = false;
    } else if (m_sinceGap == id)
        m_isRegaining = false;
    else
        m_sinceGap = m_sinceGap.value_or(id);
}

void PingProbe::closeWindows(TimePoint now)
{
    if (m_windowEnd == TimePoint{} || now - m_windowEnd > 3 * kWindow) {
        m_windowEnd = now + kWindow;
        m_packets = m_before = m_thinWindows = 0;
        m_gaps = m_regained = m_takenWindows = 0;
        m_streamed.clear();
        return;
    }
    while (now >= m_windowEnd) {
        m_windowEnd += kWindow;
        const bool isAway = m_pings.size() >= kSilentPings
            && std::none_of(m_pings.end() - kSilentPings, m_pings.end(),
                            [](const Ping &ping) { return ping.isAnswered; });
        if (isAway)
            m_usual = 0;
        // What was late may have come at once: only two windows in a row tell what is usual.
        m_usual = std::max(m_usual, std::min(m_packets, m_before));
        const bool hasPaused = std::max(m_gap, now - m_heardAt) >= kPause;
        m_gap = {};
        const bool isThin = !isAway && !hasPaused && m_usual >= kFewestPackets && m_packets < kThin * m_usual
            && answered(now).value_or(0) >= kWellAnswered;
        m_thinWindows = isThin ? m_thinWindows + 1 : 0;
        // A network that stalls goes on with the stream: what we ask is the smaller part of what comes.
        const bool isTaken = !isAway && m_packets >= kFewestPackets && m_gaps >= kFewestGaps
            && m_regained >= kMostRegained * m_gaps;
        m_takenWindows = isTaken ? m_takenWindows + 1 : 0;
        m_gaps = m_regained = 0;
        if (m_thinWindows >= kThinInARow || m_takenWindows >= kThinInARow)
            m_sharedAt = now;
        m_before = std::exchange(m_packets, 0);
        m_streamed.clear();
    }
}

std::optional<double> PingProbe::answered(TimePoint now) const
{
    std::size_t due = 0;
    std::size_t known = 0;
    for (const Ping &ping : m_pings) {
        if (!ping.isAnswered && now - ping.at < kDue)
            continue;
        ++due;
        known += ping.isAnswered ? 1 : 0;
    }
    return due < kFewestPings ? std::nullopt : std::optional(double(known) / double(due));
}

ProbedLink PingProbe::quality(TimePoint now) const
{
    return {m_roundTrip, answered(now), m_foreign, m_sharedAt && now - *m_sharedAt < kShareMemory};
}

}  // namespace bcflight
