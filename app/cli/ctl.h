// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"
#include "app/cli/liveline.h"
#include "app/composition/links.h"

#include <QJsonArray>
#include <QSet>
#include <QTextStream>

class QCommandLineParser;

/// gimbalctl: finds the command, connects, runs it, prints the result and ends with an exit code that
/// reflects it.
class Ctl final : public QObject
{
    Q_OBJECT
public:
    /// @param families the boards it knows; @param links how it reaches them
    Ctl(QList<Family> families, Links links, QObject *parent = nullptr);
    ~Ctl() override;

    /// Understands the arguments and starts. Empty: running, finished() follows; otherwise the exit code.
    std::optional<int> start(const QStringList &arguments);

signals:
    void finished(int exitCode);

private:
    [[nodiscard]] QString helpText() const;
    [[nodiscard]] QString familyKeys(const QString &separator) const;
    [[nodiscard]] Command *findCommand(const QString &name) const;
    void addOptions(QCommandLineParser &parser) const;
    std::optional<int> takeCommand(const QCommandLineParser &parser);
    Result<void> takeOptions(const QCommandLineParser &parser);
    std::optional<int> connectToBoard(const QString &link, const QString &family);
    int say(const QString &text);
    int wrong(const QString &message);

    void stop();
    void onState(DeviceClient::State state);
    Result<void> knowBoard();
    void onError(const Error &error, int exitCode);
    void onProgress(const Progress &progress);
    bool flushed();
    [[nodiscard]] QJsonValue withAlarms(const QJsonValue &json) const;
    void onTold(const QString &line);
    void finish(const Result<CommandOutcome> &outcome);

    QTextStream m_out{stdout};
    QTextStream m_err{stderr};
    LiveLine m_live{m_err};
    Links m_links;
    CommandContext m_context;
    Commands m_commands;  // the client's threads may use one, so they outlive it
    Command *m_command = nullptr;
    QString m_board;  // what the operator calls it
    QString m_lastProgress;
    std::unique_ptr<DeviceClient> m_client;
    bool m_isNameless = false;  // shares its history with boards that look the same
    QJsonArray m_alarms;  // that were told
    QSet<int> m_unprovenStops;  // numbers of alarms
    bool m_wasMovedUnwanted = false;  // one of them says so
    bool m_flies = false;  // the board is a drone's
    QList<ReplayGap> m_leftOut;  // of the recording that is replayed
    bool m_partial = false;
    bool m_started = false;
    bool m_finished = false;
};
