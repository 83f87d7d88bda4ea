// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/framelistener.h"
#include "protocol/configuration/identity.h"
#include "protocol/record/recording.h"
#include "protocol/transport/linkaddress.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

/// Listens to a link and always holds its last minutes, so that they can be saved after the fact. What was
/// said while the link was set up is kept as long as the link lasts, because the rest cannot be decoded
/// without it. Fed on the I/O thread, readable from any.
class Recorder final : public FrameListener
{
public:
    static constexpr qsizetype kMaxBytes = 192'000'000;

    /// @param seconds how much is held; @param bytes upper limit of the memory for it
    explicit Recorder(double seconds = 600, qsizetype bytes = kMaxBytes);

    void bytesReceived(QByteArrayView bytes, TimePoint at) override;
    void bytesSent(QByteArrayView bytes, TimePoint at) override;
    void frameReceived(const FrameView &frame, TimePoint at, bool claimed) override;

    /// Forgets everything, before another board is connected.
    void clear();
    /// Forgets everything up to the piece with this number: another board has been connected since.
    void clearUntil(quint64 number);
    /// Pieces after this number, oldest first, and the number of the last of them; a few thousand at a time,
    /// so that nobody has to wait long. 0 = from the oldest that is held, beginning with how the link was set
    /// up.
    [[nodiscard]] std::pair<std::vector<RecordedPiece>, quint64> after(quint64 number) const;
    /// Number of the newest piece, 0 before the first.
    [[nodiscard]] quint64 newest() const;
    /// What was asked and answered first: who the board is.
    [[nodiscard]] std::vector<RecordedPiece> opening() const;
    /// Seconds of received bytes that are held.
    [[nodiscard]] double heldSeconds() const;
    [[nodiscard]] qsizetype heldBytes() const;

private:
    void add(RecordedPiece::Kind kind, QByteArrayView bytes, TimePoint at);

    double m_seconds;
    qsizetype m_limit;
    mutable std::mutex m_mutex;
    std::deque<RecordedPiece> m_pieces;  // the last minutes
    quint64 m_newest = 0;  // number of the last of them
    std::vector<RecordedPiece> m_setup;  // what was said first
    std::deque<RecordedPiece> m_said;  // what was said between setup and the last minutes
    qsizetype m_bytes = 0;
    std::optional<TimePoint> m_origin;
};

/// What a recording says about itself: which board, where, when, recorded by which program.
[[nodiscard]] QJsonObject recordingDescription(const BoardIdentity &identity, const LinkAddress &address);

/// Writes what a recorder hears to a file, on its own thread: a slow disk slows nothing else down.
class RecordingTask
{
public:
    /// Writes everything the recorder holds, or only how the link was set up, and then everything that
    /// follows. Errors: BadFile.
    static Result<std::unique_ptr<RecordingTask>> start(const Recorder &recorder, const QString &path,
                                                        const QJsonObject &description, bool withPast);
    ~RecordingTask();

    /// Writes nothing that comes from now on, until it goes on with all of it, or is finished without.
    void hold() { m_last = m_recorder.newest(); }
    void goOn() { m_last = kNoEnd; }
    /// Writes what is left and ends. Returns the error if writing failed at any time.
    Result<void> finish();
    [[nodiscard]] qint64 bytesWritten() const { return m_bytes.load(); }
    /// True after writing failed; finish() returns the reason.
    [[nodiscard]] bool hasFailed() const { return m_failed.load(); }

private:
    static constexpr quint64 kNoEnd = ~quint64(0);

    RecordingTask(const Recorder &recorder, RecordingWriter writer, bool withPast);
    void run();
    void drain();

    const Recorder &m_recorder;
    RecordingWriter m_writer;
    quint64 m_start;  // received bytes up to this piece are left out
    quint64 m_number = 0;
    std::atomic<quint64> m_last = kNoEnd;
    std::atomic<qint64> m_bytes = 0;
    std::atomic<bool> m_failed = false;
    Result<void> m_result;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_stop = false;
    std::thread m_thread;
};
