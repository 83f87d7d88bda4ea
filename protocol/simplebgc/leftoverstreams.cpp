// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/leftoverstreams.h"

#include "protocol/session/channel.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/telemetrytables.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kListen = 120ms;  // the status of this program comes every 100 ms
constexpr auto kLook = 30ms;
constexpr auto kStill = 480ms;  // several frames of the slowest that a slow line carries
constexpr auto kPatience = 6s;
constexpr Duration kDrain = 4s;  // a busy computer has a backlog of its own
constexpr std::size_t kMaxTries = 600;  // configurations of one size
constexpr std::size_t kTriesPerLook = 8;
constexpr int kFrames = 4;  // that a look would have seen
constexpr int kMostLaterFields = 5;

// What can be streamed (errata 3.10), with those of later firmware.
constexpr std::array kStreamed{23, 25, 56, 88, 102, 127, 131, 139};

using SentKind = std::pair<int, int>;  // command, size of the payload

/// Hears what the board sends without being asked.
class Listener
{
public:
    explicit Listener(Channel &channel)
        : m_channel(channel)
        , m_heard(channel.listen([](const FrameView &frame) {
            return std::find(kStreamed.begin(), kStreamed.end(), frame.id) != kStreamed.end();
        }))
    {
    }

    /// What arrives from now on, for this long.
    Result<std::map<SentKind, int>> hear(milliseconds duration)
    {
        while (m_heard->next(0ms)) { }
        if (const auto slept = m_channel.sleep(duration); !slept)
            return tl::unexpected(slept.error());
        std::map<SentKind, int> kinds;
        while (const auto frame = m_heard->next(0ms))
            ++kinds[{frame->id, int(frame->payload.size())}];
        return kinds;
    }

private:
    Channel &m_channel;
    std::unique_ptr<Mailbox> m_heard;
};

// Configurations that a stream of this kind may have been ordered with.
std::vector<QByteArray> configurations(const SentKind &kind, int firmware)
{
    std::vector<QByteArray> all;
    if (kind.first == number(CommandId::RealtimeDataCustom)) {
        for (const quint32 flags : customFlagsOfSize(kind.second, firmware, kMaxTries))
            all.push_back(ByteWriter().u32(flags).zeros(4).take());
        return all;
    }
    all.push_back(QByteArray(8, '\0'));
    if (kind.first == number(CommandId::AhrsHelper))
        all.push_back(ByteWriter().u8(1).zeros(7).take());  // of the frame's sensor
    return all;
}

Result<bool> stop(Channel &channel, Listener &listener, const SentKind &kind, double rate,
                  const Speech &speech, TimePoint until)
{
    const auto look = std::max(kLook, milliseconds(int(kFrames * 1000.0 / std::max(1.0, rate))));
    const std::vector<QByteArray> all = configurations(kind, speech.firmware);
    int silent = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Request request = confirmRequest(CommandId::DataStreamInterval,
                                         DataStream{kind.first, 0, all[i]}.encode(), speech.frameVersion);
        request.idempotent = true;
        request.retries = 1;
        const auto confirmed = channel.transact(request);
        const ErrorCode code = confirmed ? ErrorCode::BoardError : confirmed.error().code;
        if (code == ErrorCode::Cancelled || code == ErrorCode::LinkClosed)
            return tl::unexpected(confirmed.error());
        silent = code == ErrorCode::Timeout ? silent + 1 : 0;
        const bool last = i + 1 == all.size() || silent > 1 || channel.now() > until;
        if (!last && (i + 1) % kTriesPerLook != 0)
            continue;
        // A slow line goes on for a while with what the board had queued before it obeyed.
        const TimePoint drained = channel.now() + (last ? kDrain : Duration(0));
        do {
            const auto heard = listener.hear(look);
            if (!heard)
                return tl::unexpected(heard.error());
            if (!heard->contains(kind))
                return true;
        } while (channel.now() < drained);
        if (last)
            break;
    }
    return false;
}

double rateHeard(int frames)
{
    return frames * 1000.0 / double(kStill.count());
}

}  // namespace

std::vector<quint32> customFlagsOfSize(int size, int firmware, std::size_t limit)
{
    std::vector<CustomField> first;
    std::vector<CustomField> later;
    for (const CustomField &field : customFields())
        (1U << field.bit & kFirstCustomFlags ? first : later).push_back(field);
    std::vector<quint32> found;
    // Adds fields of a list from this place on, so many of them, or any number below 0.
    const std::function<void(const std::vector<CustomField> &, std::size_t, int, int, quint32,
                             const std::function<void(int, quint32)> &)>
        choose
        = [&](const auto &fields, std::size_t from, int count, int left, quint32 flags, const auto &then) {
              if (found.size() >= limit)
                  return;
              if (count <= 0)
                  then(left, flags);
              if (count == 0)
                  return;
              for (std::size_t i = from; i < fields.size(); ++i) {
                  if (fields[i].bytes <= left)
                      choose(fields, i + 1, count - 1, left - fields[i].bytes, flags | 1U << fields[i].bit,
                             then);
              }
          };
    const int most = firmware < kLaterCustomFirmware ? 0 : kMostLaterFields;
    for (int count = 0; count <= most; ++count) {
        choose(later, 0, count, size - 2, 0, [&](int left, quint32 flags) {
            choose(first, 0, -1, left, flags, [&](int rest, quint32 whole) {
                if (rest == 0 && whole != 0 && found.size() < limit)
                    found.push_back(whole);
            });
        });
    }
    return found;
}

Result<std::vector<LeftoverStream>> stopLeftoverStreams(Channel &channel, const Speech &speech)
{
    Listener listener(channel);
    auto heard = listener.hear(kListen);
    if (!heard)
        return tl::unexpected(heard.error());
    if (heard->empty())
        return std::vector<LeftoverStream>{};
    const TimePoint until = channel.now() + kPatience;
    TimePoint drained;
    std::set<SentKind> tried;
    do {
        // What had gathered while nobody read came at once: kinds and rates are seen behind it.
        const auto next = listener.hear(kStill);
        if (!next)
            return tl::unexpected(next.error());
        for (const auto &[kind, frames] : *next)
            heard->insert({kind, frames});
        for (const auto &[kind, frames] : *heard) {
            if (!tried.insert(kind).second)
                continue;
            const auto again = next->find(kind);
            const auto stopped = stop(channel, listener, kind,
                                      rateHeard(again == next->end() ? 1 : again->second), speech, until);
            if (!stopped)
                return tl::unexpected(stopped.error());
            drained = channel.now() + kDrain;
        }
        heard = listener.hear(kStill);
        if (!heard)
            return tl::unexpected(heard.error());
    } while (!heard->empty() && channel.now() < drained);
    std::vector<LeftoverStream> left;
    for (const auto &[kind, frames] : *heard)
        left.push_back({kind.first, kind.second, rateHeard(frames)});
    return left;
}

}  // namespace simplebgc
