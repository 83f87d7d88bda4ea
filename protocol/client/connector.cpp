// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/connector.h"

#include "protocol/base/linkloss.h"
#include "protocol/client/patientchannel.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

// USB adapters and boards that reset on opening need a moment before they listen.
constexpr auto kSettle = 20ms;
constexpr auto kPatience = 5s;  // for a board that starts
constexpr auto kStray = 1s;  // between answers that come late: questions are not further apart
constexpr auto kQuiet = 700ms;  // a question is repeated sooner, a heartbeat comes later
constexpr auto kQuietStep = 50ms;
constexpr auto kLatest = 4s;  // a board that answers later than that is of no use

QString lineText(const LineSettings &line)
{
    return (line.parity == Parity::Even ? u"%1 8E1"_s : u"%1 8N1"_s).arg(line.baud);
}

Progress tryingProgress(int done, int total, const std::optional<LineSettings> &line)
{
    Progress progress;
    progress.done = done;
    progress.total = total;
    progress.step = u"probe"_s;
    if (line)
        progress.subject = lineText(*line);
    return progress;
}

// Rates and parities to try; one empty entry if the link has none.
QList<std::optional<LineSettings>> linesToTry(const Family &family, const LinkAddress &address, Search search)
{
    const bool hasLine
        = address.kind() == LinkAddress::Kind::Serial || address.kind() == LinkAddress::Kind::Simulator;
    if (!hasLine || family.lines.isEmpty())
        return {std::nullopt};
    QList<std::optional<LineSettings>> lines;
    for (const LineSettings &line : family.lines) {
        if (address.baud().value_or(line.baud) == line.baud
            && address.parity().value_or(line.parity) == line.parity)
            lines.append(line);
    }
    // A rate outside the documented list was chosen by the operator.
    if (lines.isEmpty()) {
        const LineSettings &preferred = family.lines.first();
        lines.append(LineSettings{address.baud().value_or(preferred.baud),
                                  address.parity().value_or(preferred.parity)});
    }
    QList<std::optional<LineSettings>> usual = lines;
    usual.removeIf([preferred = lines.first()->baud](const auto &line) { return line->baud != preferred; });
    if (search == Search::DefaultRate)
        return usual;
    // A board that was starting when it was asked hears now.
    return lines.size() > usual.size() ? lines + usual : lines;
}

// A pseudo-terminal, USB or a network bridge does not check the rate: there an answer to an earlier question
// arrives at another rate, and more of them follow. A board that answers at the usual rate as well is
// believed to be there.
Result<bool> answersLateAt(Channel &channel, Device &device, const LineSettings &usual,
                           const LineSettings &found)
{
    const quint64 bytes = channel.observation().bytesIn;
    if (const auto slept = channel.sleep(kStray); !slept)
        return tl::unexpected(slept.error());
    if (channel.observation().bytesIn == bytes || !channel.setLine(usual))
        return false;
    channel.progress(tryingProgress(0, 1, usual));
    for (const TimePoint until = channel.now() + kLatest; channel.now() < until;) {
        if (const auto answered = device.probe(channel); !answered || *answered)
            return answered;
    }
    if (const auto back = channel.setLine(found); !back)
        return tl::unexpected(back.error());
    // Its own state is that of the last question.
    if (const auto again = device.probe(channel); !again)
        return again;
    return false;
}

// Something speaks as this family does, but not in time: it is asked once more, alone, with all the time that
// it needs. Errors: Timeout, what identifying it ends with, those of the link.
Result<FoundBoard> askPatiently(Channel &channel, Device &device, const std::optional<LineSettings> &line)
{
    if (const auto set = line ? channel.setLine(*line) : Result<void>(); !set)
        return tl::unexpected(set.error());
    channel.progress(tryingProgress(0, 1, line));
    if (const auto quiet = awaitQuiet(channel); !quiet)
        return tl::unexpected(quiet.error());
    PatientChannel patient(channel, kLatest);
    const auto answered = device.probe(patient);
    if (!answered)
        return tl::unexpected(answered.error());
    if (!*answered)
        return failure(ErrorCode::Timeout);
    auto identity = device.identify(patient);
    if (!identity)
        return tl::unexpected(identity.error());
    return FoundBoard{std::move(*identity), line};
}

}  // namespace

Result<void> awaitQuiet(Channel &channel)
{
    const TimePoint until = channel.now() + kLatest;
    TimePoint quietSince = channel.now();
    quint64 bytes = channel.observation().bytesIn;
    while (channel.now() < std::min<TimePoint>(until, quietSince + kQuiet)) {
        if (const auto slept = channel.sleep(kQuietStep); !slept)
            return slept;
        if (std::exchange(bytes, channel.observation().bytesIn) != bytes)
            quietSince = channel.now();
    }
    return {};
}

QString recogniseProtocol(std::span<const Family> known, const QByteArray &heard)
{
    for (const Family &family : known) {
        if (!family.recognise)
            continue;
        if (const QString name = family.recognise(heard); !name.isEmpty())
            return name;
    }
    return {};
}

namespace {

QString notAskedText(const QList<Family> &known, const LinkAddress &address)
{
    QString text;
    for (const Family &family : familiesNotAsked(known, address))
        text += u"; for %1 add ?family=%2 to the address"_s.arg(family.name, family.key);
    return text;
}

}  // namespace

Result<FoundBoard> findBoard(Channel &channel, const Family &family, Device &device,
                             std::span<const Family> known, const LinkAddress &address, Search search)
{
    auto lines = linesToTry(family, address, search);
    // With rate and parity given, or none to choose, a board may take its time to start.
    const bool isNetwork
        = address.kind() == LinkAddress::Kind::Tcp || address.kind() == LinkAddress::Kind::Udp;
    const bool isGiven
        = search == Search::AllRates && (isNetwork || (lines.first() && address.baud() && address.parity()));
    const TimePoint until = channel.now() + (isGiven ? kPatience : 0s);
    QStringList tried;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const auto line = lines[i];
        channel.progress(tryingProgress(int(i), int(lines.size()), line));
        if (line) {
            if (const auto set = channel.setLine(*line); !set)
                continue;  // this port cannot do that rate; the others may still work
        }
        if (line && !tried.contains(lineText(*line)))
            tried.append(lineText(*line));
        if (const auto slept = channel.sleep(kSettle); !slept)
            return tl::unexpected(slept.error());
        const auto answered = device.probe(channel);
        if (!answered)
            return tl::unexpected(answered.error());
        if (!*answered) {
            // Checked now, before bytes received at the next rates bury it. A peer that speaks at this rate
            // will not speak at another.
            const QByteArray heard = channel.observation().lastBytes;
            const QString other = recogniseProtocol(known, heard);
            const bool isOwn = !other.isEmpty() && other == recogniseProtocol({&family, 1}, heard);
            const bool goesOn = isGiven && i + 1 == lines.size() && channel.now() < until;
            if (!other.isEmpty() && !isOwn)
                return failure(ErrorCode::WrongProtocol, other);
            if (isOwn && !goesOn)
                break;
            if (goesOn)
                lines.append(line);
            continue;
        }
        if (line && *line != *lines.first()) {
            const auto late = answersLateAt(channel, device, *lines.first(), *line);
            if (!late)
                return tl::unexpected(late.error());
            if (*late)
                return askPatiently(channel, device, lines.first());
        }
        auto identity = device.identify(channel);
        if (!identity && identity.error().code == ErrorCode::Timeout)
            return askPatiently(channel, device, line);
        if (!identity) {
            // The answer to the question before may have been a byte of another family's late one.
            const QString other = recogniseProtocol(known, channel.observation().lastBytes);
            if (!other.isEmpty()
                && recogniseProtocol({&family, 1}, channel.observation().lastBytes).isEmpty())
                return failure(ErrorCode::WrongProtocol, other);
            return tl::unexpected(identity.error());
        }
        return FoundBoard{std::move(*identity), line};
    }

    const LinkObservation seen = channel.observation();
    if (seen.framing.frames > 0) {
        auto late = askPatiently(channel, device, lines.first());
        if (late || isLinkLoss(late.error()) || late.error().code == ErrorCode::Cancelled)
            return late;
    }
    if (seen.bytesIn > 0)
        return failure(
            ErrorCode::Garbage,
            u"%1 bytes: %2"_s.arg(seen.bytesIn).arg(QString::fromLatin1(seen.lastBytes.left(16).toHex(' '))));
    if (isNetwork)
        return failure(ErrorCode::SilentPeer,
                       address.toString() + notAskedText({known.begin(), known.end()}, address));
    return failure(ErrorCode::Silent,
                   tried.isEmpty() ? address.toString()
                                   : u"%1; tried: %2"_s.arg(address.toString(), tried.join(u", "_s)));
}

QList<Family> familiesNotAsked(const QList<Family> &known, const LinkAddress &address)
{
    QList<Family> families = known;
    families.removeIf([&address](const Family &family) {
        return !family.livesOn(address.kind()) || family.mayAskAnybody(address.kind())
            || !address.option(u"family"_s).isEmpty();
    });
    return families;
}

Result<QList<Family>> familiesFor(const QList<Family> &known, const LinkAddress &address,
                                  const QString &wanted)
{
    const LinkAddress::Kind kind = address.kind();
    QString named = wanted.isEmpty() ? address.option(u"family"_s) : wanted;
    if (named.isEmpty() && kind == LinkAddress::Kind::Simulator)
        named = address.target();
    QList<Family> living;
    for (const Family &family : known) {
        if (family.livesOn(kind) && (named.isEmpty() || family.key == named))
            living.append(family);
    }
    if (living.isEmpty()) {
        const auto meant = std::find_if(known.begin(), known.end(),
                                        [&named](const Family &family) { return family.key == named; });
        return failure(ErrorCode::InvalidArgument,
                       meant == known.end() ? u"family %1"_s.arg(named)
                                            : u"%1 is not reached that way"_s.arg(meant->name));
    }
    if (!named.isEmpty() || living.size() == 1)
        return living;
    QList<Family> asked = living;
    asked.removeIf([kind](const Family &family) { return !family.mayAskAnybody(kind); });
    if (!asked.isEmpty())
        return asked;
    QStringList keys;
    for (const Family &family : living)
        keys.append(family.key);
    return failure(ErrorCode::InvalidArgument,
                   u"say which family it is with ?family= and one of %1"_s.arg(keys.join(u", "_s)));
}
