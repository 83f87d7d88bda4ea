// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/simulatedport.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kCycle = 800us;
constexpr qsizetype kUsbChunk = 4096;  // per cycle: more than the firmware can produce
constexpr qsizetype kLargestPacket = 65507;  // payload of a UDP datagram over IPv4

}  // namespace

SimulatedPort::SimulatedPort(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options,
                             std::optional<LineSettings> line)
    : m_board(std::move(board))
    , m_faults(options.faults)
    , m_line(line)
    , m_strictParity(m_board->onlyParity().has_value())
    , m_packetBased(m_board->isPacketBased())
    , m_noise(options.seed + 77)
{
    if (m_line)
        m_line->parity = m_board->onlyParity().value_or(m_line->parity);
}

bool SimulatedPort::isPlugged() const
{
    const double time = seconds(m_now);
    if (m_faults.unplugAfter >= 0 && time >= m_faults.unplugAfter
        && (m_faults.replugAfter < 0 || time < m_faults.unplugAfter + m_faults.replugAfter))
        return false;
    return m_line || m_board->isRunning();
}

// Whether both ends use the same line settings.
bool SimulatedPort::hears() const
{
    if (!m_line || !m_hostLine)
        return true;
    return m_line->baud == m_hostLine->baud && (!m_strictParity || m_line->parity == m_hostLine->parity);
}

QByteArray SimulatedPort::damaged(Bytes bytes)
{
    QByteArray out;
    out.reserve(qsizetype(bytes.size()));
    const bool garbled = !hears();
    for (std::byte byte : bytes) {
        if (m_noise.chance(m_faults.loseByte))
            continue;
        if (m_noise.chance(m_faults.flipByte))
            byte ^= static_cast<std::byte>(1U << unsigned(m_noise.uniform() * 8));
        // At the wrong rate, the bits are sampled at random places.
        if (garbled)
            byte = static_cast<std::byte>(unsigned(m_noise.uniform() * 256));
        out.append(static_cast<char>(byte));
        if (m_noise.chance(m_faults.doubleByte))
            out.append(static_cast<char>(byte));
    }
    return out;
}

void SimulatedPort::hostWrites(Bytes bytes)
{
    if (!isPlugged())
        return;
    if (m_packetBased)
        m_packetsToBoard.push(toByteArray(bytes), m_now, m_faults, 0, m_noise);
    else
        m_toBoard += damaged(bytes);
}

QList<QByteArray> SimulatedPort::hostReads()
{
    if (m_packetBased)
        return m_packetsToHost.take(m_now);
    QByteArray out;
    while (!m_toHost.empty() && m_toHost.front().at <= m_now) {
        out += m_toHost.front().bytes;
        m_toHost.pop_front();
    }
    return out.isEmpty() ? QList<QByteArray>() : QList<QByteArray>{out};
}

void SimulatedPort::advance(Duration time)
{
    m_rest += time;
    while (m_rest >= kCycle) {
        m_rest -= kCycle;
        cycle();
    }
}

void SimulatedPort::cycle()
{
    m_now += kCycle;
    if (m_packetBased)
        exchangePackets();
    else
        exchangeBytes();
}

// A board on a network answers whoever wrote last.
void SimulatedPort::letOthersAsk()
{
    if (m_faults.otherGround <= 0) {
        m_othersAskedLast = false;
        return;
    }
    if (m_now < m_othersAskAt)
        return;
    m_othersAskAt = m_now + durationFromSeconds(1 / m_faults.otherGround);
    const QByteArray asked = m_board->askedByOthers();
    if (asked.isEmpty())
        return;
    m_board->receive(asBytes(asked));
    m_othersAskedLast = true;
}

void SimulatedPort::exchangePackets()
{
    for (const QByteArray &packet : m_packetsToBoard.take(m_now)) {
        m_board->receive(asBytes(packet));
        m_othersAskedLast = false;
    }
    letOthersAsk();
    m_board->cycle();
    for (QByteArray sent = m_board->takeOutput(kLargestPacket); !sent.isEmpty();
         sent = m_board->takeOutput(kLargestPacket)) {
        if (m_othersAskedLast)
            continue;
        m_packetsToHost.push(sent, m_now + milliseconds(m_faults.lateMs), m_faults, m_faults.delayMs,
                             m_noise);
    }
    if (isPlugged())
        return;
    m_packetsToBoard.clear();
    m_packetsToHost.clear();
}

void SimulatedPort::exchangeBytes()
{
    // A UART carries a limited number of bytes per cycle in each direction.
    qsizetype in = m_toBoard.size();
    qsizetype out = m_hostReady ? kUsbChunk : 0;
    if (m_line) {
        const double perCycle = seconds(kCycle) / m_line->secondsFor(1);
        m_inCredit = m_toBoard.isEmpty() ? 0.0 : m_inCredit + perCycle;
        m_outCredit = std::min(m_outCredit + perCycle, std::max(perCycle, 2.0));
        in = std::min<qsizetype>(in, qsizetype(m_inCredit));
        out = qsizetype(m_outCredit);
        m_inCredit -= double(in);
    }
    if (in > 0) {
        m_board->receive(asBytes(QByteArrayView(m_toBoard).first(in)));
        m_toBoard.remove(0, in);
    }
    m_board->cycle();
    const QByteArray sent = m_board->takeOutput(out);
    if (m_line)
        m_outCredit -= double(sent.size());
    if (!isPlugged()) {
        m_toBoard.clear();
        m_toHost.clear();
        return;
    }
    if (sent.isEmpty())
        return;
    Duration at = m_now + milliseconds(m_faults.lateMs);
    if (m_faults.delayMs > 0)
        at += durationFromSeconds(m_noise.uniform() * m_faults.delayMs * 0.001);
    // Bytes never overtake each other.
    if (!m_toHost.empty())
        at = std::max(at, m_toHost.back().at);
    m_toHost.push_back({at, damaged(asBytes(sent))});
}

Result<void> SimulatedPort::change(const QString &assignment)
{
    Faults changed = m_faults;
    if (const auto set = changed.set(assignment); !set)
        return set;
    if (assignment.startsWith(u"unplug="_s))
        changed.unplugAfter += seconds(m_now);
    if (assignment.startsWith(u"reset="_s))
        changed.resetAfter += seconds(m_now);
    if (assignment.startsWith(u"other-client="_s))
        changed.otherClient += seconds(m_now);
    m_faults = changed;
    m_board->setFaults(changed);
    return {};
}
