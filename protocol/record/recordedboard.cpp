// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recordedboard.h"

#include "protocol/session/channel.h"

#include <algorithm>

namespace {

constexpr qint64 kLatestAnswer = 30'000'000'000;  // nanoseconds

/// What was heard unasked, from the beginning of the recording.
class RecordedMailbox final : public Mailbox
{
public:
    RecordedMailbox(const Recording &recording, std::unique_ptr<Framer> framer,
                    std::function<bool(const FrameView &)> filter)
        : m_recording(recording)
        , m_framer(std::move(framer))
        , m_filter(std::move(filter))
    {
    }

    Result<Frame> next(milliseconds) override
    {
        std::optional<Frame> found;
        while (!found && m_next < m_recording.pieces.size()) {
            const RecordedPiece &piece = m_recording.pieces[m_next++];
            if (piece.kind != RecordedPiece::Kind::Received)
                continue;
            const FrameSink sink = [&](const FrameView &frame) {
                if (!found && m_filter(frame))
                    found = Frame(frame);
            };
            m_framer->feed(asBytes(piece.bytes), sink);
            if (m_recording.isPacketBased())
                m_framer->packetEnded(sink);
        }
        if (!found)
            return failure(ErrorCode::Timeout);
        return *found;
    }

private:
    const Recording &m_recording;
    std::unique_ptr<Framer> m_framer;
    std::function<bool(const FrameView &)> m_filter;
    std::size_t m_next = 0;
};

/// A channel whose board is a recording: it answers what it was asked then and never waits.
class RecordedChannel final : public Channel
{
public:
    RecordedChannel(const Recording &recording, const Family &family)
        : m_recording(recording)
        , m_family(family)
        , m_answers(recording)
    {
        for (const RecordedPiece &piece : recording.pieces)
            m_observation.bytesIn += piece.kind == RecordedPiece::Kind::Received ? piece.bytes.size() : 0;
        m_observation.isReplayed = true;
    }

    Result<Frame> transact(const Request &request) override
    {
        if (!request.answer)
            return Frame{};
        const auto framer = m_family.makeFramer();
        framer->sent(asBytes(request.bytes));
        std::optional<Result<Frame>> answer;
        const FrameSink sink = [&](const FrameView &frame) {
            if (!answer)
                answer = request.answer(frame);
        };
        for (const QByteArray &bytes : m_answers.find(request.bytes, m_recording.begin())) {
            framer->feed(asBytes(bytes), sink);
            framer->packetEnded(sink);
        }
        framer->flush(sink);
        return answer.value_or(failure(ErrorCode::Timeout, request.name));
    }
    void post(const Request &) override { }
    Result<void> sleep(milliseconds duration) override
    {
        m_now += duration;
        return {};
    }
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) override
    {
        return std::make_unique<RecordedMailbox>(m_recording, m_family.makeFramer(), std::move(filter));
    }
    Result<void> setLine(const LineSettings &) override { return {}; }
    void steer(const ControlFrames &) override { }
    void releaseControl() override { }
    void stopMotors(const StopPlan &) override { }
    void expectSilence(milliseconds) override { }
    [[nodiscard]] bool cancelled() const override { return false; }
    void progress(const Progress &) override { }
    [[nodiscard]] TimePoint now() const override { return m_now; }
    [[nodiscard]] LinkObservation observation() const override { return m_observation; }

private:
    const Recording &m_recording;
    const Family &m_family;
    RecordedAnswers m_answers;
    LinkObservation m_observation;
    TimePoint m_now{};
};

}  // namespace

RecordedAnswers::RecordedAnswers(const Recording &recording)
    : m_recording(recording)
{
    for (std::size_t i = 0; i < recording.pieces.size(); ++i) {
        const RecordedPiece &piece = recording.pieces[i];
        if (piece.kind == RecordedPiece::Kind::Sent)
            m_requests[piece.bytes].push_back(i);
    }
    for (const RecordedPiece &piece : recording.opening) {
        if (piece.kind == RecordedPiece::Kind::Sent)
            m_asked.insert(piece.bytes);
    }
}

QList<QByteArray> RecordedAnswers::find(const QByteArray &request, qint64 at) const
{
    const auto found = m_requests.constFind(request);
    if (found != m_requests.constEnd()) {
        const auto isBefore = [&](std::size_t piece) { return m_recording.pieces[piece].at <= at; };
        const auto later = std::partition_point(found->begin(), found->end(), isBefore);
        for (auto each = later; each != found->begin();) {
            if (const QList<QByteArray> answer = answerBehind(m_recording.pieces, *--each); !answer.isEmpty())
                return answer;
        }
        for (auto each = later; each != found->end(); ++each) {
            if (const QList<QByteArray> answer = answerBehind(m_recording.pieces, *each); !answer.isEmpty())
                return answer;
        }
    }
    const auto &opening = m_recording.opening;
    for (std::size_t i = 0; i < opening.size(); ++i) {
        if (opening[i].kind != RecordedPiece::Kind::Sent || opening[i].bytes != request)
            continue;
        if (const QList<QByteArray> answer = answerBehind(opening, i); !answer.isEmpty())
            return answer;
    }
    return {};
}

// In a network heartbeats are sent between a request and its answer, and their answers, which repeat them,
// come between as well; elsewhere what follows another request is the answer to that one.
QList<QByteArray> RecordedAnswers::answerBehind(const std::vector<RecordedPiece> &pieces,
                                                std::size_t request) const
{
    const bool isPacketBased = m_recording.isPacketBased();
    QList<QByteArray> answer;
    const RecordedPiece *packet = nullptr;
    for (std::size_t i = request + 1; i < pieces.size(); ++i) {
        const RecordedPiece &piece = pieces[i];
        const bool isNext = piece.kind == RecordedPiece::Kind::Sent && !(isPacketBased && answer.isEmpty());
        const bool isLate = isPacketBased && piece.at - pieces[request].at > kLatestAnswer;
        // Behind a gap stand the answers to other requests.
        if (isNext || isLate || (&pieces == &m_recording.pieces && m_recording.hasGapBefore(i)))
            break;
        if (piece.kind == RecordedPiece::Kind::Received)
            packet = &piece;
        const bool isOthers = isPacketBased && piece.bytes != pieces[request].bytes
            && (m_requests.contains(piece.bytes) || m_asked.contains(piece.bytes));
        if (piece.kind != RecordedPiece::Kind::Reply || isOthers)
            continue;
        const bool isWhole = isPacketBased && packet && packet->bytes.contains(piece.bytes);
        const QByteArray &bytes = isWhole ? packet->bytes : piece.bytes;
        if (!isWhole || answer.isEmpty() || answer.last() != bytes)  // a packet may hold two of them
            answer.append(bytes);
    }
    return answer;
}

Result<BoardIdentity> identifyRecorded(const Recording &recording, const Family &family, Device &device)
{
    RecordedChannel channel(recording, family);
    const auto found = device.probe(channel);
    if (!found)
        return tl::unexpected(found.error());
    return device.identify(channel);
}
