// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/recordedboard.h"
#include "protocol/transport/transport.h"

#include <QTimer>

/// A recording as a link. Requests get the answer they got then (the last one before the playback position,
/// otherwise the first one); a request that was never made gets no answer. Received bytes play in their own
/// time once play() was called, and keep their distances in time at any speed.
class ReplayTransport final : public Transport, public Replay
{
    Q_OBJECT
public:
    /// @param speed multiple of real time, 0.05 to 100; @param from position in the recording to start at,
    /// seconds
    ReplayTransport(Recording recording, double speed, double from);

    void open() override;
    void close() override;
    void write(QByteArrayView bytes) override;
    void play() override;
    void setPaused(bool paused) override;
    void setSpeed(double speed) override;
    void forwardTo(double seconds) override;
    [[nodiscard]] ReplayState state() const override;
    [[nodiscard]] bool isPacketBased() const override { return m_recording.isPacketBased(); }
    [[nodiscard]] Replay *replay() override { return this; }

private:
    void advance();
    void deliver();
    void runFromHere();

    Recording m_recording;
    RecordedAnswers m_answers;
    double m_speed;
    qint64 m_position;  // nanoseconds of the recording
    QList<ReplayGap> m_gaps;
    std::size_t m_next = 0;  // piece that is due next
    int m_unanswered = 0;  // writes whose answer comes when the caller has returned
    QTimer m_timer;
    TimePoint m_started{};  // the time assigned to m_begin; all other times keep their distance from it
    qint64 m_begin = 0;
    TimePoint m_runningSince{};  // when m_runningFrom was played
    qint64 m_runningFrom = 0;
    bool m_played = false;
    bool m_paused = false;
    bool m_open = false;
};

/// `replay:FILE?speed=4&from=30`. Errors: BadFile, InvalidArgument.
Result<std::unique_ptr<Transport>> makeReplayTransport(const LinkAddress &address);
