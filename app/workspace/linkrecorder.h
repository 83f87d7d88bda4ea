// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/client/samplewatch.h"
#include "protocol/record/recorder.h"

#include <QThreadPool>
#include <QTimer>

/// Keeps the last minutes of the link in memory at all times, and writes recordings.
class LinkRecorder final : public QObject
{
    Q_OBJECT
public:
    explicit LinkRecorder(DeviceClient &client, QObject *parent = nullptr);
    ~LinkRecorder() override;

    [[nodiscard]] bool isRecording() const { return m_task != nullptr; }
    [[nodiscard]] const QString &path() const { return m_path; }
    /// Size of the running recording in bytes.
    [[nodiscard]] qint64 size() const { return m_task ? m_task->bytesWritten() : 0; }
    /// Seconds that savePast() would save.
    [[nodiscard]] double heldSeconds() const { return m_recorder.heldSeconds(); }

    /// Records from now on. Errors: BadFile, NotConnected, Busy.
    Result<void> start(const QString &path);
    void stop();
    /// Saves the minutes that are held; finished() or failed() tells when it is done. Errors: BadFile,
    /// NotConnected.
    Result<void> savePast(const QString &path);

signals:
    void recordingChanged(bool recording);
    /// A recording is complete. @param hasSamples live data came while it was made
    void finished(const QString &path, qint64 bytes, bool hasSamples);
    /// A recording was ended because another board answers on the link.
    void replaced();
    /// While recording over a link that stands: live data have stopped, or come again.
    void silenceChanged(bool silent);
    /// Writing failed; what was written before remains valid.
    void failed(const Error &error);

private:
    void onState(DeviceClient::State state);
    void finish(quint64 forgetUntil);
    void end(std::shared_ptr<RecordingTask> task, const QString &path, bool hasSamples,
             quint64 forgetUntil = 0);
    void watchSamples();
    void lookForSamples();

    DeviceClient &m_client;
    Recorder m_recorder;
    std::unique_ptr<RecordingTask> m_task;
    QString m_path;
    QTimer m_watch;
    std::unique_ptr<SampleWatch> m_samples;  // of the running recording
    std::shared_ptr<const TelemetryStore> m_lost;  // whose link is being set up again
    quint64 m_lostAt = 0;
    bool m_hasSamples = false;
    bool m_isSilent = false;
    QThreadPool m_writers;  // writes the last bytes without blocking
};
