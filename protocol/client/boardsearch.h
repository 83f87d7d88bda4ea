// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/connector.h"
#include "protocol/session/sessionchannel.h"

/// One series of attempts to reach a board, on the worker thread: the first connection, or reconnecting until
/// it succeeds.
class BoardSearch
{
public:
    struct Candidate
    {
        Family family;
        std::shared_ptr<Device> device;
    };
    struct Found
    {
        Candidate candidate;
        FoundBoard board;
    };
    struct Order
    {
        LinkAddress address;
        QList<Family> families;  ///< to probe, see familiesFor()
        QList<Family> known;  ///< for recognising foreign bytes
        std::optional<LineSettings> knownLine;  ///< where the board was last found
        bool repeat = false;  ///< until it succeeds
        milliseconds delay{};  ///< before the first attempt
    };

    explicit BoardSearch(Order order);

    /// Errors: those of opening the link and of findBoard(), Cancelled.
    Result<Found> run(SessionChannel &channel);

private:
    Result<Found> ask(const Candidate &candidate, SessionChannel &channel, bool useKnownLine,
                      Search search = Search::AllRates);
    Result<Found> once(SessionChannel &channel, bool useKnownLine);
    Result<Found> askAtDefaultRates(SessionChannel &channel);

    Order m_order;
    std::vector<Candidate> m_candidates;
};
