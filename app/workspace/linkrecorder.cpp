// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/linkrecorder.h"

using namespace Qt::StringLiterals;

namespace {

constexpr auto kWatchPeriod = 500ms;

}  // namespace

LinkRecorder::LinkRecorder(DeviceClient &client, QObject *parent)
    : QObject(parent)
    , m_client(client)
{
    m_client.addListener(m_recorder);
    connect(&m_client, &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        // If the same board returns, the recording continues; it is never continued with another.
        if (state == DeviceClient::State::Disconnected)
            stop();
        if (state == DeviceClient::State::Connecting)
            m_recorder.clear();
    });
    m_watch.setInterval(kWatchPeriod);
    connect(&m_watch, &QTimer::timeout, this, [this] {
        if (m_task && m_task->hasFailed())
            stop();
    });
}

LinkRecorder::~LinkRecorder()
{
    m_client.removeListener(m_recorder);
    m_task.reset();
    m_writers.waitForDone();
}

Result<void> LinkRecorder::start(const QString &path)
{
    if (m_task)
        return failure(ErrorCode::Busy, m_path);
    if (!m_client.isConnected())
        return failure(ErrorCode::NotConnected);
    auto task = RecordingTask::start(m_recorder, path,
                                     recordingDescription(m_client.identity(), m_client.address()), false);
    if (!task)
        return tl::unexpected(task.error());
    m_task = std::move(*task);
    m_path = path;
    m_watch.start();
    emit recordingChanged(true);
    return {};
}

void LinkRecorder::stop()
{
    if (!m_task)
        return;
    m_watch.stop();
    end(std::move(m_task), m_path);
    emit recordingChanged(false);
}

Result<void> LinkRecorder::savePast(const QString &path)
{
    if (!m_client.device())
        return failure(ErrorCode::NotConnected);
    if (m_task && path == m_path)
        return failure(ErrorCode::Busy, path);
    auto task = RecordingTask::start(m_recorder, path,
                                     recordingDescription(m_client.identity(), m_client.address()), true);
    if (!task)
        return tl::unexpected(task.error());
    end(std::move(*task), path);
    return {};
}

void LinkRecorder::end(std::shared_ptr<RecordingTask> task, const QString &path)
{
    m_writers.start([this, task = std::move(task), path] {
        const Result<void> result = task->finish();
        const qint64 bytes = task->bytesWritten();
        QMetaObject::invokeMethod(
            this,
            [this, result, bytes, path] {
                if (result)
                    emit finished(path, bytes);
                else
                    emit failed(result.error());
            },
            Qt::QueuedConnection);
    });
}
