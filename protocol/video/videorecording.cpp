// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videorecording.h"

#include "protocol/base/filefault.h"

#include <QFile>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// A disk that stands still for longer than that costs frames, not memory.
constexpr qsizetype kMostQueued = 64 * 1024 * 1024;

}  // namespace

Result<std::unique_ptr<VideoRecording>>
VideoRecording::start(const VideoCodecs &codecs, const QString &path,
                      std::function<void(const VideoRecordingState &)> ended)
{
    // What is wrong with the place is told now, not with the first frame.
    if (const auto possible = checkTarget(path, FileKind::Other); !possible)
        return tl::unexpected(possible.error());
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(systemError(file, FileKind::Other, true));
    file.close();
    return std::unique_ptr<VideoRecording>(new VideoRecording(codecs, path, std::move(ended)));
}

VideoRecording::VideoRecording(const VideoCodecs &codecs, const QString &path,
                               std::function<void(const VideoRecordingState &)> ended)
    : m_codecs(codecs)
    , m_ended(std::move(ended))
{
    m_state.path = path;
    m_thread = std::thread([this] { run(); });
}

VideoRecording::~VideoRecording()
{
    finish();
    m_thread.join();
}

void VideoRecording::take(const EncodedFrame &frame, const FrameFacts &facts, const VideoInspector &inspector)
{
    if (facts.format == VideoFormat::Unknown)
        return;
    const std::lock_guard lock(m_mutex);
    if (m_isFinishing)
        return;
    if (m_queued > kMostQueued) {
        ++m_state.lost;
        return;
    }
    Item item{frame, facts, {}};
    if (facts.isKey)
        item.track = {facts.format, inspector.size(), inspector.parameterSets()};
    m_queued += frame.bytes.size();
    m_queue.push_back(std::move(item));
    m_wake.notify_one();
}

void VideoRecording::finish()
{
    const std::lock_guard lock(m_mutex);
    m_isFinishing = true;
    m_wake.notify_one();
}

VideoRecordingState VideoRecording::state() const
{
    const std::lock_guard lock(m_mutex);
    return m_state;
}

void VideoRecording::run()
{
    Result<void> written;
    std::unique_lock lock(m_mutex);
    while (written) {
        m_wake.wait(lock, [this] { return m_isFinishing || !m_queue.empty(); });
        if (m_queue.empty())
            break;
        const Item item = std::move(m_queue.front());
        m_queue.pop_front();
        m_queued -= item.frame.bytes.size();
        lock.unlock();
        written = write(item);
        lock.lock();
        if (m_writer && written) {
            m_state.isWaiting = false;
            m_state.length = std::max(m_last, 0ms);
            m_state.bytes = m_writer->bytesWritten();
            ++m_state.frames;
            m_state.lost += m_state.frames > 1 ? quint64(item.facts.lost) : 0;
        }
    }
    m_isFinishing = true;
    lock.unlock();
    if (m_writer) {
        const auto finished = m_writer->finish();
        if (written)
            written = finished;
    }
    lock.lock();
    if (m_writer)
        m_state.bytes = m_writer->bytesWritten();
    if (!written)
        m_state.error = written.error();
    const VideoRecordingState last = m_state;
    lock.unlock();
    m_ended(last);
}

Result<void> VideoRecording::write(const Item &item)
{
    if (!m_writer) {
        if (!item.facts.isKey || item.track.size.isEmpty())
            return {};
        auto writer = m_codecs.createFile(m_state.path, item.track);
        if (!writer)
            return tl::unexpected(writer.error());
        m_writer = std::move(*writer);
        m_track = item.track;
        m_begin = item.frame.at;
    }
    if (item.facts.isKey && (item.track.size != m_track.size || item.track.format != m_track.format))
        return failure(ErrorCode::Conflict, u"the size of the pictures has changed"_s);
    // No two frames have the same time, as many players want it.
    const auto since = std::chrono::duration_cast<milliseconds>(item.frame.at - m_begin);
    m_last = std::max(since, m_last + 1ms);
    return m_writer->write({item.frame.bytes, m_last, item.facts.isKey});
}
