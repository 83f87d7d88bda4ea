// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"
#include "protocol/device/deviceclient.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/record/recorder.h"
#include "protocol/record/udpexport.h"

#include <QTextStream>

class TelemetryPrinter;

/// gimbalctl: finds the command, connects, runs it on the worker thread, prints, ends with an honest exit
/// code.
class Ctl final : public QObject
{
    Q_OBJECT
public:
    explicit Ctl(QObject *parent = nullptr);
    ~Ctl() override;

    /// Understands the arguments and starts. Empty: running, finished() follows; otherwise the exit code.
    std::optional<int> start(const QStringList &arguments);

signals:
    void finished(int exitCode);

private:
    void stop();
    void onState(DeviceClient::State state);
    void onError(const Error &error, int exitCode);
    void onProgress(const Progress &progress);
    void runCommand();
    void runMonitor();
    void runMeasure();
    void finishMeasure(const MotionTestResult &result);
    void runPublish();
    void finishPublish();
    [[nodiscard]] bool isRecording() const;
    void runRecording();
    void finishRecording();
    [[nodiscard]] QList<int> wantedChannels();
    void finish(const Result<CommandOutcome> &outcome);
    int wrong(const QString &message);
    [[nodiscard]] QString helpText() const;

    QTextStream m_out{stdout};
    QTextStream m_err{stderr};
    std::vector<std::unique_ptr<Command>> m_commands;
    Command *m_command = nullptr;
    CommandOptions m_options;
    bool m_json = false;
    QString m_lastProgress;
    Recorder m_recorder;  // the client's threads feed it, so it outlives them
    std::unique_ptr<RecordingTask> m_recording;
    std::unique_ptr<DeviceClient> m_client;
    std::unique_ptr<TelemetryPrinter> m_printer;
    std::unique_ptr<UdpExport> m_publish;
    std::unique_ptr<MotionTest> m_test;
    bool m_started = false;
    bool m_finished = false;
};
