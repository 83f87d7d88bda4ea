// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/linkrecorder.h"

#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"

#include <algorithm>
#include <numeric>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kWatchPeriod = 500ms;

QList<int> everyChannel(const Device &device)
{
    QList<int> channels(qsizetype(device.channels().size()));
    std::iota(channels.begin(), channels.end(), 0);
    return channels;
}

}  // namespace

LinkRecorder::LinkRecorder(DeviceClient &client, QObject *parent)
    : QObject(parent)
    , m_client(client)
{
    m_client.addListener(m_recorder);
    connect(&m_client, &DeviceClient::stateChanged, this, &LinkRecorder::onState);
    m_watch.setInterval(kWatchPeriod);
    connect(&m_watch, &QTimer::timeout, this, [this] {
        if (m_task && m_task->hasFailed())
            stop();
        else
            lookForSamples();
    });
}

LinkRecorder::~LinkRecorder()
{
    m_client.removeListener(m_recorder);
    m_task.reset();
    m_writers.waitForDone();
}

// If the same board returns, the recording continues; it is never continued with another.
void LinkRecorder::onState(DeviceClient::State state)
{
    switch (state) {
    case DeviceClient::State::Disconnected: stop(); break;
    case DeviceClient::State::Connecting: m_recorder.clear(); break;
    case DeviceClient::State::Reconnecting:
        m_lost = m_client.telemetry();
        m_lostAt = m_recorder.newest();
        if (m_task)
            m_task->hold();
        return;
    case DeviceClient::State::Connected:
        if (!m_lost)
            break;
        if (m_lost == m_client.telemetry()) {
            if (m_task)
                m_task->goOn();
            break;
        }
        if (m_task) {
            emit replaced();
            finish(m_lostAt);
        } else {
            m_recorder.clearUntil(m_lostAt);
        }
        break;
    }
    m_lost.reset();
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
    m_hasSamples = m_client.address().isReplay();  // where a gap is what it is
    m_isSilent = false;
    if (!m_hasSamples)
        watchSamples();
    emit recordingChanged(true);
    return {};
}

void LinkRecorder::stop()
{
    if (!m_task)
        return;
    lookForSamples();
    finish(0);
}

void LinkRecorder::finish(quint64 forgetUntil)
{
    m_watch.stop();
    m_samples.reset();
    end(std::move(m_task), m_path, m_hasSamples, forgetUntil);
    if (std::exchange(m_isSilent, false))
        emit silenceChanged(false);
    emit recordingChanged(false);
}

void LinkRecorder::watchSamples()
{
    m_samples = std::make_unique<SampleWatch>(m_client, everyChannel(*m_client.device()), 0);
    connect(m_samples.get(), &SampleWatch::ended, this, [this] {
        // A link that broke is told by itself.
        if (m_client.isConnected() && !std::exchange(m_isSilent, true))
            emit silenceChanged(true);
        QTimer::singleShot(0, this, [this] {
            if (m_task)
                watchSamples();
        });
    });
    m_samples->start();
}

void LinkRecorder::lookForSamples()
{
    if (!m_samples || !m_samples->hasHeard())
        return;
    m_hasSamples = true;
    if (std::exchange(m_isSilent, false))
        emit silenceChanged(false);
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
    const auto store = m_client.telemetry();
    const QList<int> channels = everyChannel(*m_client.device());
    end(std::move(*task), path, store && std::any_of(channels.begin(), channels.end(), [&store](int channel) {
                                    return store->latestAt(channel) != TimePoint{};
                                }));
    return {};
}

void LinkRecorder::end(std::shared_ptr<RecordingTask> task, const QString &path, bool hasSamples,
                       quint64 forgetUntil)
{
    m_writers.start([this, task = std::move(task), path, hasSamples, forgetUntil] {
        const Result<void> result = task->finish();
        if (forgetUntil > 0)
            m_recorder.clearUntil(forgetUntil);
        const qint64 bytes = task->bytesWritten();
        QMetaObject::invokeMethod(
            this,
            [this, result, bytes, path, hasSamples] {
                if (result)
                    emit finished(path, bytes, hasSamples);
                else
                    emit failed(result.error());
            },
            Qt::QueuedConnection);
    });
}
