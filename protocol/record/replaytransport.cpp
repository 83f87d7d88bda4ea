// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/replaytransport.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTick = 4ms;
constexpr double kSlowest = 0.05;
constexpr double kFastest = 100.0;

Result<double> numberOption(const LinkAddress &address, const QString &name, double fallback, double low,
                            double high)
{
    const QString text = address.option(name);
    if (text.isEmpty())
        return fallback;
    bool ok = false;
    const double value = text.toDouble(&ok);
    if (!ok || !(value >= low && value <= high))
        return failure(ErrorCode::InvalidArgument,
                       u"%1=%2 is not a number from %3 to %4"_s.arg(name, text).arg(low).arg(high));
    return value;
}

}  // namespace

ReplayTransport::ReplayTransport(Recording recording, double speed, double from)
    : m_recording(std::move(recording))
    , m_answers(m_recording)
    , m_speed(speed)
    , m_position(m_recording.begin() + qint64(from * 1e9))
    , m_gaps(m_recording.leftOut())
    , m_timer(this)
{
    m_timer.setInterval(kTick);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &ReplayTransport::advance);
}

void ReplayTransport::open()
{
    m_open = true;
    emit opened();
}

void ReplayTransport::close()
{
    m_open = m_played = false;
    m_timer.stop();
}

void ReplayTransport::write(QByteArrayView bytes)
{
    // As on a real link, the answer does not arrive before the caller has returned. Until then nothing is
    // played: a reader of letters and bare data would take what is recorded for the answer, or the answer,
    // after enough of it, for noise.
    ++m_unanswered;
    QTimer::singleShot(0, this, [this, request = bytes.toByteArray()] {
        --m_unanswered;
        if (!m_open)
            return;
        emit bytesWritten(request.size());
        for (const QByteArray &answer : m_answers.find(request, m_position))
            emit received(answer, Clock::now());
    });
}

void ReplayTransport::play()
{
    if (!m_open || m_played)
        return;
    m_played = true;
    m_begin = m_position;
    m_started = Clock::now();
    // What was requested before this place still applies.
    for (; m_next < m_recording.pieces.size() && m_recording.pieces[m_next].at < m_begin; ++m_next) {
        const RecordedPiece &piece = m_recording.pieces[m_next];
        if (piece.kind == RecordedPiece::Kind::Sent)
            emit replayed(piece.bytes, m_started);
    }
    runFromHere();
}

void ReplayTransport::runFromHere()
{
    m_runningSince = Clock::now();
    m_runningFrom = m_position;
    if (m_open && !m_paused)
        m_timer.start();
}

void ReplayTransport::advance()
{
    const auto passed
        = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - m_runningSince).count();
    m_position = m_runningFrom + qint64(double(passed) * m_speed);
    deliver();
}

void ReplayTransport::setPaused(bool paused)
{
    if (m_paused == paused)
        return;
    if (paused && m_timer.isActive())
        advance();
    m_paused = paused;
    m_timer.stop();
    if (m_played)
        runFromHere();
}

void ReplayTransport::setSpeed(double speed)
{
    if (m_timer.isActive())
        advance();
    m_speed = std::clamp(speed, kSlowest, kFastest);
    if (m_timer.isActive())
        runFromHere();
}

void ReplayTransport::forwardTo(double seconds)
{
    const qint64 wanted = std::min(m_recording.begin() + qint64(seconds * 1e9), m_recording.end());
    if (!m_open || wanted <= m_position)
        return;
    m_position = wanted;
    deliver();
    runFromHere();
}

ReplayState ReplayTransport::state() const
{
    const qint64 begin = m_recording.begin();
    const qint64 end = m_recording.end();
    return {double(std::clamp(m_position, begin, end) - begin) * 1e-9, double(end - begin) * 1e-9, m_speed,
            m_paused, m_gaps};
}

void ReplayTransport::deliver()
{
    for (; m_open && m_next < m_recording.pieces.size(); ++m_next) {
        const RecordedPiece &piece = m_recording.pieces[m_next];
        if (piece.at > m_position || m_unanswered > 0)
            return;
        const TimePoint at = m_started + std::chrono::nanoseconds(piece.at - m_begin);
        if (piece.kind == RecordedPiece::Kind::Received)
            emit received(piece.bytes, at);
        else if (piece.kind == RecordedPiece::Kind::Sent)
            emit replayed(piece.bytes, at);
    }
    m_timer.stop();  // the end: the link stays open, so that earlier data can be looked at
}

Result<std::unique_ptr<Transport>> makeReplayTransport(const LinkAddress &address)
{
    const auto speed = numberOption(address, u"speed"_s, 1.0, kSlowest, kFastest);
    const auto from = numberOption(address, u"from"_s, 0.0, 0.0, 1e6);
    if (!speed || !from)
        return tl::unexpected(speed ? from.error() : speed.error());
    auto recording = Recording::load(address.target());
    if (!recording)
        return tl::unexpected(recording.error());
    return std::make_unique<ReplayTransport>(std::move(*recording), *speed, *from);
}
