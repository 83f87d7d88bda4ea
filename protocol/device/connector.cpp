// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/connector.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// USB adapters and boards that reset on opening need a moment before they listen.
constexpr auto kSettle = 20ms;

Progress tryingProgress(int done, int total, const std::optional<LineSettings> &line)
{
    Progress progress;
    progress.done = done;
    progress.total = total;
    progress.step = u"probe"_s;
    if (line) {
        progress.subject = (line->parity == Parity::Even ? u"%1 8E1"_s : u"%1 8N1"_s).arg(line->baud);
    }
    return progress;
}

// A MAVLink frame is trusted by its shape: two of them, one behind the other.
bool looksLikeMavlink(const QByteArray &bytes)
{
    for (qsizetype i = 0; i + 8 < bytes.size(); ++i) {
        const auto at = [&](qsizetype k) { return static_cast<unsigned char>(bytes[k]); };
        if (at(i) != 0xFE && at(i) != 0xFD)
            continue;
        const qsizetype next = i + (at(i) == 0xFE ? 8 : 12) + at(i + 1);
        if (next < bytes.size() && at(next) == at(i))
            return true;
    }
    return false;
}

}  // namespace

QString recognizeProtocol(const QByteArray &bytes)
{
    if (looksLikeMavlink(bytes))
        return u"MAVLink"_s;
    // A STorM32 board answers each byte it does not know with the letter e, and half commands with t
    // (errata 3.1). Among what came at wrong rates a run of them is enough.
    constexpr int kRun = 5;
    const auto isAnswer
        = [](char letter) { return letter == 'e' || letter == 't' || letter == 'o' || letter == 'c'; };
    int run = 0;
    int longest = 0;
    for (const char letter : bytes) {
        run = isAnswer(letter) ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    if (longest >= kRun || (longest >= 3 && longest == bytes.size()))
        return u"STorM32"_s;
    return {};
}

Result<FoundBoard> findBoard(Channel &channel, Device &device, const LinkAddress &address, Search search)
{
    QList<std::optional<LineSettings>> candidates;
    if (address.kind() == LinkAddress::Kind::Serial || address.kind() == LinkAddress::Kind::Simulator) {
        for (const LineSettings &line : device.lineCandidates()) {
            if (address.baud().value_or(line.baud) == line.baud
                && address.parity().value_or(line.parity) == line.parity)
                candidates.append(line);
        }
        // A rate outside the document's list is the operator's own wish.
        if (candidates.isEmpty())
            candidates.append(
                LineSettings{address.baud().value_or(115200), address.parity().value_or(Parity::None)});
        if (search == Search::UsualRate)
            candidates.removeIf(
                [usual = candidates.first()->baud](const auto &line) { return line->baud != usual; });
    } else {
        candidates.append(std::nullopt);
    }

    for (qsizetype i = 0; i < candidates.size(); ++i) {
        const auto &line = candidates[i];
        channel.progress(tryingProgress(int(i), int(candidates.size()), line));
        if (line) {
            if (const auto set = channel.setLine(*line); !set)
                continue;  // this port cannot do that rate; the others may still work
        }
        if (const auto slept = channel.sleep(kSettle); !slept)
            return tl::unexpected(slept.error());
        const auto answered = device.probe(channel);
        if (!answered)
            return tl::unexpected(answered.error());
        if (!*answered) {
            // Looked at now: what comes at the next rates would bury it. Whoever speaks at this rate will not
            // at another.
            if (const QString other = recognizeProtocol(channel.observation().lastBytes); !other.isEmpty())
                return failure(ErrorCode::WrongProtocol, other);
            continue;
        }
        auto identity = device.identify(channel);
        if (!identity)
            return tl::unexpected(identity.error());
        return FoundBoard{std::move(*identity), line};
    }

    const LinkObservation seen = channel.observation();
    if (seen.bytesIn > 0)
        return failure(
            ErrorCode::Garbage,
            u"%1 bytes: %2"_s.arg(seen.bytesIn).arg(QString::fromLatin1(seen.lastBytes.left(16).toHex(' '))));
    return failure(ErrorCode::Silent, address.toString());
}
