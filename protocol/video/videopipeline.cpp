// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videopipeline.h"

#include "protocol/video/videomodule.h"

#include <algorithm>
#include <atomic>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

// Frames that wait for longer are given up for the next one that decoding can begin with.
constexpr auto kLate = 400ms;
// However many newer frames have come, a picture is shown after that time.
constexpr auto kShowsAgain = 100ms;
constexpr std::size_t kPictures = 4;

}  // namespace

VideoPipeline::VideoPipeline(QObject *parent)
    : QObject(parent)
{
    m_thread.setObjectName(u"gimbal-video"_s);
}

VideoPipeline::~VideoPipeline()
{
    stop();
}

Result<void> VideoPipeline::start(const VideoAddress &address, Use use)
{
    stop();
    const auto codecs = loadVideoCodecs();
    if (!codecs)
        return tl::unexpected(codecs.error());
    m_codecs = *codecs;
    m_address = address;
    m_inspector = {};
    m_decoder.reset();
    m_decodes = VideoFormat::Unknown;
    m_hasPicture = m_needsKey = m_isDamaged = m_isEnding = m_isStillWanted = m_isAnnounced = false;
    m_queue.clear();
    m_newest.reset();
    m_counts = {};
    m_frames = RateMeter(2s);
    m_losses = RateMeter(10s);
    m_delays = {};
    m_lastFrame.reset();
    m_isShowing = use == Use::Show;
    m_receiver = new VideoReceiver(
        address, [this](const EncodedFrame &frame) { onFrame(frame); },
        [this](qsizetype size) { onDatagram(size); });
    m_receiver->moveToThread(&m_thread);
    connect(&m_thread, &QThread::started, m_receiver, &VideoReceiver::start);
    connect(&m_thread, &QThread::finished, m_receiver, &QObject::deleteLater);
    connect(m_receiver, &VideoReceiver::failed, this, &VideoPipeline::failed);
    m_thread.start();
    if (m_isShowing)
        m_decoding = std::thread([this] { decodeAll(); });
    return {};
}

void VideoPipeline::stop()
{
    if (!m_thread.isRunning())
        return;
    m_thread.quit();
    m_thread.wait();
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
        m_wake.notify_one();
    }
    if (m_decoding.joinable())
        m_decoding.join();
    std::unique_ptr<VideoRecording> recording;
    {
        const std::lock_guard lock(m_recordingMutex);
        recording = std::move(m_recording);
    }
    recording.reset();  // tells of its end
}

void VideoPipeline::setPictureSize(QSize size)
{
    const std::lock_guard lock(m_mutex);
    m_size = size;
}

void VideoPipeline::setPaused(bool paused)
{
    const std::lock_guard lock(m_mutex);
    m_isPaused = paused;
}

std::shared_ptr<const VideoPicture> VideoPipeline::picture()
{
    const std::lock_guard lock(m_mutex);
    m_isAnnounced = false;
    return m_newest;
}

void VideoPipeline::painted(const VideoPicture &picture)
{
    const TimePoint now = Clock::now();
    const std::lock_guard lock(m_mutex);
    m_delays.add(now - picture.at);
    ++m_counts.shown;
}

void VideoPipeline::takeStill()
{
    const std::lock_guard lock(m_mutex);
    m_isStillWanted = true;
    m_wake.notify_one();
}

Result<void> VideoPipeline::startRecording(const QString &path)
{
    if (!isRunning())
        return failure(ErrorCode::NotConnected, u"no video is received"_s);
    if (m_isRecording)
        return failure(ErrorCode::Busy, u"a recording runs"_s);
    const int number = ++m_recordings;
    auto recording = VideoRecording::start(*m_codecs, path, [this, number](const VideoRecordingState &state) {
        QMetaObject::invokeMethod(
            this, [this, number, state] { onRecordingEnded(number, state); }, Qt::QueuedConnection);
    });
    if (!recording)
        return tl::unexpected(recording.error());
    std::unique_ptr<VideoRecording> before;
    {
        const std::lock_guard lock(m_recordingMutex);
        before = std::exchange(m_recording, std::move(*recording));
    }
    m_isRecording = true;
    return {};
}

void VideoPipeline::endRecording()
{
    const std::lock_guard lock(m_recordingMutex);
    if (m_recording)
        m_recording->finish();
}

void VideoPipeline::onRecordingEnded(int number, const VideoRecordingState &state)
{
    if (number == m_recordings)
        m_isRecording = false;
    emit recordingEnded(state);
}

VideoRecordingState VideoPipeline::recordingState() const
{
    const std::lock_guard lock(m_recordingMutex);
    return m_recording ? m_recording->state() : VideoRecordingState{};
}

VideoStatistics VideoPipeline::statistics() const
{
    const TimePoint now = Clock::now();
    const std::lock_guard lock(m_mutex);
    VideoStatistics statistics = m_counts;
    statistics.frameRate = m_frames.rate(now);
    statistics.bitRate = m_frames.amountRate(now) * 8;
    const double missing = m_losses.mean(now);  // for each frame that came
    statistics.lossPercent = 100 * missing / (1 + missing);
    if (m_lastFrame)
        statistics.silence = now - *m_lastFrame;
    statistics.latency = m_delays.median();
    statistics.worstLatency = m_delays.worst();
    return statistics;
}

void VideoPipeline::onDatagram(qsizetype size)
{
    const std::lock_guard lock(m_mutex);
    ++m_counts.datagrams;
    m_counts.bytes += quint64(size);
}

void VideoPipeline::onFrame(const EncodedFrame &frame)
{
    const FrameFacts facts = m_inspector.inspect(asBytes(frame.bytes));
    {
        const std::lock_guard lock(m_recordingMutex);
        if (m_recording)
            m_recording->take(frame, facts, m_inspector);
    }
    const std::lock_guard lock(m_mutex);
    if (facts.format == VideoFormat::Unknown) {
        ++m_counts.foreign;
        return;
    }
    m_counts.format = facts.format;
    m_counts.size = m_inspector.size();
    ++m_counts.frames;
    m_counts.lost += quint64(facts.lost);
    m_frames.add(frame.at, double(frame.bytes.size()));
    m_losses.add(frame.at, facts.lost);
    m_lastFrame = frame.at;
    if (!m_isShowing)
        return;
    m_queue.push_back({frame, facts});
    m_wake.notify_one();
}

void VideoPipeline::decodeAll()
{
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_isEnding || m_isStillWanted || !m_queue.empty(); });
        if (m_isEnding)
            return;
        if (std::exchange(m_isStillWanted, false)) {
            lock.unlock();
            publishStill();
            lock.lock();
            continue;
        }
        dropLate(Clock::now());
        if (m_queue.empty())
            continue;
        const Queued item = std::move(m_queue.front());
        m_queue.pop_front();
        lock.unlock();
        decode(item);
        lock.lock();
    }
}

// With the lock held.
void VideoPipeline::dropLate(TimePoint now)
{
    if (m_queue.empty() || now - m_queue.front().frame.at < kLate)
        return;
    const auto key
        = std::find_if(m_queue.rbegin(), m_queue.rend(), [](const Queued &item) { return item.facts.isKey; });
    const auto first = key == m_queue.rend() ? m_queue.end() : std::prev(key.base());
    m_needsKey = key == m_queue.rend();
    m_counts.skipped += quint64(first - m_queue.begin());
    m_queue.erase(m_queue.begin(), first);
}

void VideoPipeline::decode(const Queued &item)
{
    if (m_needsKey && !item.facts.isKey) {
        const std::lock_guard lock(m_mutex);
        ++m_counts.skipped;
        return;
    }
    m_needsKey = false;
    if (!m_decoder || m_decodes != item.facts.format) {
        auto decoder = m_codecs->makeDecoder(item.facts.format);
        m_decoder = decoder ? std::move(*decoder) : nullptr;
        m_decodes = item.facts.format;
    }
    const auto outcome = m_decoder ? m_decoder->decode(asBytes(item.frame.bytes), item.facts.isKey)
                                   : VideoDecoder::Outcome::Nothing;
    // What was lost shows in all pictures that refer to it.
    m_isDamaged = outcome == VideoDecoder::Outcome::Damaged
        || (!item.facts.isKey && (m_isDamaged || item.facts.lost > 0));
    bool isShown = false;
    {
        const std::lock_guard lock(m_mutex);
        if (outcome == VideoDecoder::Outcome::Nothing) {
            m_counts.undecoded += m_hasPicture ? 1 : 0;
            return;
        }
        m_counts.damaged += m_isDamaged ? 1 : 0;
        isShown = !m_isPaused && (m_queue.empty() || Clock::now() - m_publishedAt > kShowsAgain);
        m_counts.skipped += isShown || m_isPaused ? 0 : 1;
    }
    m_hasPicture = true;
    if (isShown)
        publish(item.frame);
}

void VideoPipeline::publish(const EncodedFrame &frame)
{
    QSize size;
    {
        const std::lock_guard lock(m_mutex);
        size = m_size;
    }
    const std::shared_ptr<VideoPicture> picture = freePicture();
    const QSize own = m_decoder->size();
    const QSize fitting = size.isEmpty() ? own : own.scaled(size, Qt::KeepAspectRatio);
    if (!m_decoder->convert(*picture, fitting.expandedTo({2, 2})))
        return;
    picture->at = frame.at;
    picture->waited = frame.waited;
    picture->isDamaged = m_isDamaged;
    m_publishedAt = Clock::now();
    bool isNews = false;
    {
        const std::lock_guard lock(m_mutex);
        m_newest = picture;
        isNews = !std::exchange(m_isAnnounced, true);
    }
    // On the object's own thread, so that nothing comes after its end.
    if (isNews)
        QMetaObject::invokeMethod(this, &VideoPipeline::pictureReady, Qt::QueuedConnection);
}

void VideoPipeline::publishStill()
{
    const auto picture = std::make_shared<VideoPicture>();
    const bool isThere = m_decoder && m_hasPicture && m_decoder->convert(*picture, m_decoder->size());
    const std::shared_ptr<const VideoPicture> taken = isThere ? picture : nullptr;
    QMetaObject::invokeMethod(
        this, [this, taken] { emit stillTaken(taken); }, Qt::QueuedConnection);
}

// One that nobody holds any more: a new one for each frame would cost more than its colours.
std::shared_ptr<VideoPicture> VideoPipeline::freePicture()
{
    for (const auto &picture : m_pool) {
        if (picture.use_count() == 1) {
            std::atomic_thread_fence(std::memory_order_acquire);
            return picture;
        }
    }
    auto picture = std::make_shared<VideoPicture>();
    if (m_pool.size() < kPictures)
        m_pool.push_back(picture);
    return picture;
}
