// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/framer.h"

#include "protocol/base/checksum.h"

#include <algorithm>
#include <utility>

namespace storm32 {

namespace {

using mavlink::Look;

constexpr std::byte kRcQuestion{0xFA};
constexpr std::byte kRcAnswer{0xFB};
constexpr std::size_t kRcOverhead = 5;
constexpr int kEmbeddedAnswer = FrameId::kMavlink + mavlink::number(mavlink::MessageId::TargetSpecificAck);
// Longer than any answer: anything beyond is noise.
constexpr qsizetype kMaxKept = 1024;
// Answers come in the order of their questions. More than these are never open: a board that answers 1.5 s
// late while its motors are being stopped has fifteen.
constexpr int kOpenQuestions = 64;

bool isLetter(std::byte byte)
{
    const auto c = std::to_integer<char>(byte);
    return c == 'o' || c == 'e' || c == 't' || c == 'c';
}

}  // namespace

void Framer::sent(Bytes bytes)
{
    const SimpleCommand *command = findSimple(bytes);
    m_rcAsked = !command && !bytes.empty() && bytes[0] == kRcQuestion;
    if (!command)
        return;
    // One command at a time: the rest of an earlier answer will not arrive. That of a message does: the board
    // sends it unasked, and the letters in it are no answers.
    const Bytes all = asBytes(m_buffer);
    std::size_t kept = 0;
    while (kept < all.size() && mavlink::sight(all.subspan(kept)).look != mavlink::Look::Incomplete)
        ++kept;
    skip(kept);
    if (m_asked != command)
        remember(m_asked);
    m_asked = command->replyWords[0] ? command : nullptr;
    if (m_asked)
        forget(FrameId::kSimple + int(m_asked->id));
}

// The latest first.
void Framer::remember(const SimpleCommand *command)
{
    if (!command)
        return;
    forget(FrameId::kSimple + int(command->id));
    std::rotate(m_earlier.begin(), m_earlier.end() - 1, m_earlier.end());
    m_earlier.front() = {command, 0};
}

bool Framer::awaitsData() const
{
    return m_asked || std::any_of(m_earlier.begin(), m_earlier.end(), [](const Earlier &each) {
               return each.command != nullptr;
           });
}

// A board that ignored a question answers those after it.
void Framer::answered()
{
    for (Earlier &each : m_earlier) {
        if (++each.answersSince == kOpenQuestions)
            each.command = nullptr;
    }
}

// Its data are here, or asked for anew.
void Framer::forget(int frame)
{
    for (Earlier &each : m_earlier) {
        if (each.command && FrameId::kSimple + int(each.command->id) == frame)
            each.command = nullptr;
    }
}

void Framer::feed(Bytes bytes, const FrameSink &sink)
{
    m_buffer.append(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()));
    scan(false, sink);
    if (m_buffer.size() > kMaxKept)
        skip(std::size_t(m_buffer.size() - kMaxKept));
}

void Framer::flush(const FrameSink &sink)
{
    scan(true, sink);
    skip(std::size_t(m_buffer.size()));
}

void Framer::skip(std::size_t count)
{
    m_statistics.skippedBytes += count;
    m_buffer.remove(0, qsizetype(count));
}

// Delivers everything complete. @param last nothing more will come
void Framer::scan(bool last, const FrameSink &sink)
{
    while (!m_buffer.isEmpty()) {
        const Bytes all = asBytes(m_buffer);
        bool open = false;
        std::size_t at = 0;
        Sighting seen;
        for (; at < all.size(); ++at) {
            seen = sight(all.subspan(at));
            // A letter may be one byte of something longer; silence after it, or something whole that is
            // checked, shows that it is not.
            const bool letter = seen.look == Look::Complete && seen.size == 1;
            const bool doubtful = letter && (awaitsData() || open) && !(last && all.size() == 1);
            if (seen.look == Look::Complete && !doubtful) {
                if (at == 1 && !letter && isLetter(all[0]))
                    seen = sightLetter(all.subspan(--at));
                break;
            }
            open |= doubtful || seen.look == Look::Incomplete;
        }
        if (at == all.size()) {
            if (last || !open)
                skip(all.size());
            return;
        }
        skip(at);
        ++m_statistics.frames;
        if (seen.frame.id < FrameId::kMavlink || seen.frame.id == kEmbeddedAnswer)
            answered();
        if (seen.frame.id < FrameId::kMavlink) {
            forget(seen.frame.id);
            const bool isAnswer = seen.frame.id < FrameId::kSimple
                || (m_asked && seen.frame.id == FrameId::kSimple + int(m_asked->id));
            if (!isAnswer)
                remember(m_asked);
            m_asked = nullptr;
        }
        // Out of the buffer first: the receiver of the frame may send, and then the rest is discarded.
        const QByteArray kept
            = std::exchange(m_buffer, m_buffer.mid(qsizetype(seen.size))).left(qsizetype(seen.size));
        const auto moved = [&](Bytes part) {
            return part.empty()
                ? Bytes()
                : asBytes(kept).subspan(std::size_t(part.data() - seen.frame.raw.data()), part.size());
        };
        sink({seen.frame.id, moved(seen.frame.payload), 1, asBytes(kept)});
    }
}

Framer::Sighting Framer::sight(Bytes bytes) const
{
    const Sighting data = sightData(bytes);
    if (data.look == Look::Complete)
        return data;
    if (isLetter(bytes[0]))
        return sightLetter(bytes);
    if (bytes[0] == kRcAnswer && (m_rcAsked || !m_asked)) {  // otherwise it may be data that looks alike
        if (bytes.size() < 2)
            return {Look::Incomplete};
        const std::size_t length = std::to_integer<std::size_t>(bytes[1]);
        if (bytes.size() < length + kRcOverhead)
            return {Look::Incomplete};
        if (crc16Mcrf4xx(bytes.subspan(1, length + 4)) != 0)  // data and its own checksum
            return {Look::Damaged};
        return {Look::Complete,
                length + kRcOverhead,
                {FrameId::kRc + std::to_integer<int>(bytes[2]), bytes.subspan(3, length), 1,
                 bytes.first(length + kRcOverhead)}};
    }
    const mavlink::Sighting message = mavlink::sight(bytes);
    if (message.look != Look::No) {
        return {
            message.look,
            message.size,
            {FrameId::kMavlink + message.packet.id, message.packet.payload, 1, bytes.first(message.size)}};
    }
    // Data may start with any byte.
    return data;
}

Framer::Sighting Framer::sightLetter(Bytes bytes)
{
    return {Look::Complete, 1, {FrameId::kLetter + std::to_integer<int>(bytes[0]), {}, 1, bytes.first(1)}};
}

// The data of the requested command, or of one that was given up.
Framer::Sighting Framer::sightData(Bytes bytes) const
{
    Sighting result = m_asked ? sightDataOf(*m_asked, bytes) : Sighting{};
    for (const Earlier &each : m_earlier) {
        if (result.look == Look::Complete || !each.command)
            continue;
        const Sighting late = sightDataOf(*each.command, bytes);
        if (late.look != Look::No)
            result = late;
    }
    return result;
}

// In each length that any firmware sends.
Framer::Sighting Framer::sightDataOf(const SimpleCommand &command, Bytes bytes)
{
    Sighting result;
    for (const int words : command.replyWords) {
        if (words == 0)
            continue;
        const std::size_t data = 2 * std::size_t(words);
        if (bytes.size() < data + 3) {
            result.look = Look::Incomplete;
            continue;
        }
        if (bytes[data + 2] == std::byte{'o'} && crc16Mcrf4xx(bytes.first(data + 2)) == 0)
            return {Look::Complete,
                    data + 3,
                    {FrameId::kSimple + int(command.id), bytes.first(data), 1, bytes.first(data + 3)}};
    }
    return result;
}

}  // namespace storm32
