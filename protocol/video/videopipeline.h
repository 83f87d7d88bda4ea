// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/videoreceiver.h"
#include "protocol/video/videorecording.h"
#include "protocol/video/videostatistics.h"

#include <QThread>

#include <memory>

/// The way from a drone's video port to pictures, and to a file. Receiving has a thread, decoding has
/// another: it decodes every frame, because later ones refer to it, and hands out only the newest picture.
class VideoPipeline final : public QObject
{
    Q_OBJECT
public:
    enum class Use : std::uint8_t { Show, RecordOnly };

    explicit VideoPipeline(QObject *parent = nullptr);
    ~VideoPipeline() override;

    /// Begins anew with this address. Errors: Unsupported (the module is missing).
    Result<void> start(const VideoAddress &address, Use use = Use::Show);
    /// A recording ends as well.
    void stop();
    [[nodiscard]] bool isRunning() const { return m_thread.isRunning(); }
    [[nodiscard]] const VideoAddress &address() const { return m_address; }

    /// In which size pictures are wanted; empty: as they are.
    void setPictureSize(QSize size);
    /// Nobody looks: frames are decoded, and not made pictures.
    void setPaused(bool paused);
    /// The newest one; null before the first.
    [[nodiscard]] std::shared_ptr<const VideoPicture> picture();
    /// It is on the screen now.
    void painted(const VideoPicture &picture);
    /// Asks for the newest picture as large as it came; stillTaken() follows.
    void takeStill();

    /// Frames from now on go into this file. Errors: BadFile, NotConnected, Busy, Unsupported.
    Result<void> startRecording(const QString &path);
    /// recordingEnded() follows.
    void endRecording();
    [[nodiscard]] bool isRecording() const { return m_isRecording; }
    [[nodiscard]] VideoRecordingState recordingState() const;
    [[nodiscard]] VideoStatistics statistics() const;

signals:
    /// There is a newer picture.
    void pictureReady();
    /// @param picture null: there is none yet
    void stillTaken(const std::shared_ptr<const VideoPicture> &picture);
    void recordingEnded(const VideoRecordingState &state);
    /// The address cannot be used.
    void failed(const Error &error);

private:
    struct Queued
    {
        EncodedFrame frame;
        FrameFacts facts;
    };
    // On the receiver's thread.
    void onDatagram(qsizetype size);
    void onFrame(const EncodedFrame &frame);
    // On the decoder's.
    void decodeAll();
    void dropLate(TimePoint now);
    void decode(const Queued &item);
    void publish(const EncodedFrame &frame);
    void publishStill();
    [[nodiscard]] std::shared_ptr<VideoPicture> freePicture();

    void onRecordingEnded(int number, const VideoRecordingState &state);

    VideoAddress m_address;
    const VideoCodecs *m_codecs = nullptr;
    QThread m_thread;
    VideoReceiver *m_receiver = nullptr;
    std::thread m_decoding;

    // Of the decoder's thread.
    std::unique_ptr<VideoDecoder> m_decoder;
    VideoFormat m_decodes = VideoFormat::Unknown;
    std::vector<std::shared_ptr<VideoPicture>> m_pool;
    TimePoint m_publishedAt{};
    bool m_hasPicture = false;
    bool m_needsKey = false;
    bool m_isDamaged = false;
    bool m_isShowing = false;  // set before both threads start

    // Of the receiver's.
    VideoInspector m_inspector;

    mutable std::mutex m_mutex;  // guards what follows
    std::condition_variable m_wake;
    std::deque<Queued> m_queue;
    bool m_isEnding = false;
    bool m_isPaused = false;
    bool m_isStillWanted = false;
    bool m_isAnnounced = false;
    QSize m_size;
    std::shared_ptr<const VideoPicture> m_newest;
    VideoStatistics m_counts;
    RateMeter m_frames{2s};
    RateMeter m_losses{10s};
    DelayMeter m_delays;
    std::optional<TimePoint> m_lastFrame;

    mutable std::mutex m_recordingMutex;
    std::unique_ptr<VideoRecording> m_recording;
    bool m_isRecording = false;  // of the object's own thread, as is the next
    int m_recordings = 0;
};
