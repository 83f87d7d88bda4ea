// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/codecs.h"
#include "protocol/video/videoinspector.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

/// How a recording goes.
struct VideoRecordingState
{
    QString path;
    bool isWaiting = true;  ///< for a frame that decoding can begin with
    milliseconds length{0};
    qint64 bytes = 0;  ///< of the file
    quint64 frames = 0;
    quint64 lost = 0;  ///< frames that are missing in it
    std::optional<Error> error;  ///< it ended by itself
};

/// Writes frames into a file as they come, on a thread of its own. It begins with a key frame and ends where
/// the size or kind of the pictures changes.
class VideoRecording
{
public:
    /// Errors: BadFile.
    static Result<std::unique_ptr<VideoRecording>>
    start(const VideoCodecs &codecs, const QString &path,
          std::function<void(const VideoRecordingState &)> ended);
    /// Waits until what came is written.
    ~VideoRecording();
    VideoRecording(const VideoRecording &) = delete;
    VideoRecording &operator=(const VideoRecording &) = delete;

    /// @param inspector has just inspected it
    void take(const EncodedFrame &frame, const FrameFacts &facts, const VideoInspector &inspector);
    /// Ends it; `ended` is called on the recording's thread once the file is complete.
    void finish();
    [[nodiscard]] VideoRecordingState state() const;

private:
    VideoRecording(const VideoCodecs &codecs, const QString &path,
                   std::function<void(const VideoRecordingState &)> ended);
    struct Item
    {
        EncodedFrame frame;
        FrameFacts facts;
        VideoTrack track;  // of key frames
    };
    void run();
    [[nodiscard]] Result<void> write(const Item &item);

    const VideoCodecs &m_codecs;
    std::function<void(const VideoRecordingState &)> m_ended;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Item> m_queue;
    qsizetype m_queued = 0;  // bytes
    VideoRecordingState m_state;
    bool m_isFinishing = false;
    // Of its thread:
    std::unique_ptr<VideoFileWriter> m_writer;
    VideoTrack m_track;
    TimePoint m_begin{};
    milliseconds m_last{-1};
    std::thread m_thread;
};
