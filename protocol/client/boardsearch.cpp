// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/boardsearch.h"

#include <algorithm>

namespace {

constexpr auto kRetryPause = 500ms;

// The board may belong to another family or use another baud rate.
bool isNotHere(ErrorCode code)
{
    return code == ErrorCode::Silent || code == ErrorCode::SilentPeer || code == ErrorCode::Garbage
        || code == ErrorCode::WrongProtocol;
}

bool hasHeard(ErrorCode code)
{
    return code == ErrorCode::Garbage || code == ErrorCode::WrongProtocol;
}

}  // namespace

BoardSearch::BoardSearch(Order order)
    : m_order(std::move(order))
{
    for (const Family &family : std::as_const(m_order.families))
        m_candidates.push_back({family, family.makeDevice()});
}

Result<BoardSearch::Found> BoardSearch::ask(const Candidate &candidate, SessionChannel &channel,
                                            bool useKnownLine, Search search)
{
    LinkAddress target = m_order.address;
    if (useKnownLine && m_order.knownLine && target.kind() == LinkAddress::Kind::Serial)
        target = LinkAddress::serial(target.target(), m_order.knownLine->baud, m_order.knownLine->parity);
    if (auto opened = channel.open(target, candidate.family.makeFramer(), candidate.family.timing); !opened)
        return tl::unexpected(opened.error());
    auto found = findBoard(channel, candidate.family, *candidate.device, m_order.known, target, search);
    if (!found)
        return tl::unexpected(found.error());
    return Found{candidate, std::move(*found)};
}

// In a network it is each family's first question, before any of them is waited for.
// On a serial line each family is probed at its usual rate before any other rate is tried: a board that
// cannot answer the first family's probe is found in two seconds instead of after all of that family's rates.
Result<BoardSearch::Found> BoardSearch::askAtDefaultRates(SessionChannel &channel)
{
    Result<Found> found = failure(ErrorCode::Silent);
    for (const Candidate &candidate : m_candidates) {
        found = ask(candidate, channel, false, Search::DefaultRate);
        if (found || !isNotHere(found.error().code))
            return found;
        if (!hasHeard(found.error().code))
            continue;
        if (const auto quiet = awaitQuiet(channel); !quiet)
            return tl::unexpected(quiet.error());
    }
    return found;
}

// Probes one family after the other. A family whose protocol is recognised in the received bytes is probed
// next. If nothing at all arrives, the rest are skipped, except on a recording, which answers only its own
// family.
Result<BoardSearch::Found> BoardSearch::once(SessionChannel &channel, bool useKnownLine)
{
    const LinkAddress &address = m_order.address;
    const bool isNetwork
        = address.kind() == LinkAddress::Kind::Tcp || address.kind() == LinkAddress::Kind::Udp;
    const bool hasRates = address.kind() == LinkAddress::Kind::Serial && !(useKnownLine && m_order.knownLine);
    const bool searches = m_candidates.size() > 1 && (hasRates || isNetwork);
    if (searches) {
        auto found = askAtDefaultRates(channel);
        if (found || !isNotHere(found.error().code))
            return found;
    }
    std::optional<Error> first;
    for (const Candidate &candidate : m_candidates) {
        auto found = ask(candidate, channel, useKnownLine);
        if (found || found.error().code == ErrorCode::Cancelled)
            return found;
        const Error error = found.error();
        if (!first || first->code == ErrorCode::Garbage)
            first = error;
        const QByteArray heard = channel.observation().lastBytes;
        const auto named = std::find_if(m_candidates.begin(), m_candidates.end(), [&](const Candidate &each) {
            return error.code == ErrorCode::WrongProtocol && each.family.recognise
                && each.family.recognise(heard) == error.detail;
        });
        if (named != m_candidates.end() && &*named != &candidate)
            return ask(*named, channel, useKnownLine);
        const bool nobody = error.code != ErrorCode::Garbage && error.code != ErrorCode::Timeout;
        if (nobody && !address.isReplay())
            break;
    }
    return tl::unexpected(first.value_or(Error{ErrorCode::InvalidArgument, {}}));
}

Result<BoardSearch::Found> BoardSearch::run(SessionChannel &channel)
{
    if (const auto slept = channel.sleep(m_order.delay); !slept)
        return tl::unexpected(slept.error());
    for (int round = 0;; ++round) {
        // Every third round tries all rates again: a changed serial speed takes effect with a restart.
        auto found = once(channel, m_order.repeat && round % 3 != 2);
        if (found || !m_order.repeat || found.error().code == ErrorCode::Cancelled)
            return found;
        // A link that opened and broke again neither ends the search nor hastens it.
        if (const auto paused = channel.pause(kRetryPause); !paused)
            return tl::unexpected(paused.error());
    }
}
