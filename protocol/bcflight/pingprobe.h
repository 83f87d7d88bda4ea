// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/messages.h"
#include "protocol/session/linkprobe.h"

#include <deque>
#include <map>

namespace bcflight {

/// The truth of a link to a drone, from its PING (errata 3) and from what it answers.
///
/// The drone sends answers and stream to whoever sent last (errata 2.1). So a second ground shows itself
/// here: by answers to PINGs with ticks that are not ours, by answers to what was not asked, by a stream that
/// thins out although our own PINGs are answered, and, whoever was there first, by a stream that stops again
/// and again and comes back with the answer to what we have sent.
class PingProbe final : public LinkProbe
{
public:
    static constexpr std::size_t kRemembered = 20;  ///< PINGs
    static constexpr auto kDue = 1s;  ///< later, a PING counts as unanswered
    static constexpr auto kShareMemory = 5s;  ///< so long a second ground is told of after its last sign
    static constexpr auto kAnswerable = 60s;  ///< longest time between a question and its answer
    static constexpr auto kWindow = 1s;  ///< in which the stream is counted
    static constexpr double kThin = 0.6;  ///< share of the stream's rate below which it is thinned out
    static constexpr auto kTaken = 50ms;  ///< without a word: the stream may have gone to somebody else
    static constexpr auto kPause = 600ms;  ///< without a word: then the link paused, and nobody took anything

    /// The clock in ms, low 16 bits.
    [[nodiscard]] static std::uint16_t tickAt(TimePoint time);

    [[nodiscard]] QByteArray beat(TimePoint now) override;
    void sent(Bytes bytes, TimePoint now) override;
    void frameArrived(const FrameView &frame, TimePoint at) override;
    void expectSilence(TimePoint until) override { m_silentUntil = until; }
    [[nodiscard]] ProbedLink quality(TimePoint now) const override;

private:
    struct Ping
    {
        std::uint16_t tick = 0;
        TimePoint at{};
        bool isAnswered = false;
    };
    void pingSent(std::uint16_t tick, TimePoint now);
    void pingArrived(Bytes payload, TimePoint at);
    void noteAsked(Message id, TimePoint now);
    void forgetAbsence(std::deque<Ping>::iterator back);
    void noteForeign(TimePoint at);
    void countStream(Message id);
    void noteGap(Message id, bool isStreamed, Duration gap);
    void closeWindows(TimePoint now);
    [[nodiscard]] std::optional<double> answered(TimePoint now) const;

    std::deque<Ping> m_pings;  // the newest last
    std::deque<Ping> m_older;  // their answers may come yet
    std::optional<TimePoint> m_begun;  // with the first of them
    std::optional<Duration> m_roundTrip;
    std::map<Message, TimePoint> m_asked;
    quint64 m_foreign = 0;
    std::optional<TimePoint> m_sharedAt;
    TimePoint m_silentUntil{};  // it may be away

    // Packets of the stream.
    TimePoint m_windowEnd{};
    TimePoint m_heardAt{};  // of anything
    Duration m_gap{};  // the longest between two words that ended in this window
    std::map<Message, int> m_streamed;  // in this window; no packet has one of them twice
    int m_packets = 0;
    int m_before = 0;  // in the window before
    int m_usual = 0;  // in two windows in a row, at best
    int m_thinWindows = 0;
    int m_gaps = 0;  // of kTaken in this window
    int m_regained = 0;  // of them, those that an answer has ended
    bool m_isRegaining = false;  // since a gap no more than one packet of the stream has come
    std::optional<Message> m_sinceGap;  // with which that one begins
    int m_takenWindows = 0;
};

}  // namespace bcflight
