// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/record/boardhistory.h"

#include <QJsonArray>
#include <QJsonObject>

#include <memory>

/// The options that commands share.
struct CommandOptions
{
    QStringList arguments;
    int profile = 0;  ///< from 1; 0 = the active one
    bool noSave = false;
    bool dryRun = false;
    QStringList channels;
    QStringList streams;  ///< "realtime4@100": which streams to ask for; empty = arranged for the channels
    double seconds = 0;  ///< 0 = until interrupted
    QString csv;  ///< where to write samples; - = stdout
    BoardHistory history;
};

/// What a command produced: one JSON document and the same as text.
struct CommandOutcome
{
    QJsonValue json;
    QString text;
    QString note;  ///< for people only, on stderr: where the snapshot went, how it went
    int exitCode = 0;
};

/// Exit codes of gimbalctl.
enum ExitCode { Done = 0, Refused = 1, WrongArguments = 2 };

/// One command of gimbalctl: sequential code on the worker thread, or without any board.
class Command
{
public:
    virtual ~Command() = default;

    [[nodiscard]] virtual const char *name() const = 0;
    [[nodiscard]] virtual const char *usage() const = 0;
    [[nodiscard]] virtual const char *help() const = 0;
    /// What is wrong with the arguments, empty if nothing.
    [[nodiscard]] virtual QString check(const CommandOptions &options) const = 0;
    [[nodiscard]] virtual bool needsBoard(const CommandOptions &) const { return true; }
    [[nodiscard]] virtual bool moves() const { return false; }
    virtual Result<CommandOutcome> run(Channel &, Device &, const CommandOptions &)
    {
        return failure(ErrorCode::Unsupported);
    }
    virtual Result<CommandOutcome> runWithoutBoard(const CommandOptions &)
    {
        return failure(ErrorCode::NotConnected);
    }
};

/// All commands in the order of the help text; "monitor" and "record" are built into the program, as they
/// live on the running link.
[[nodiscard]] std::vector<std::unique_ptr<Command>> allCommands();

[[nodiscard]] std::vector<std::unique_ptr<Command>> parameterCommands();
[[nodiscard]] std::vector<std::unique_ptr<Command>> fileCommands();
[[nodiscard]] std::vector<std::unique_ptr<Command>> actionCommands();
[[nodiscard]] std::vector<std::unique_ptr<Command>> recordingCommands();

/// What a person looks at first: angles, targets and gyros.
[[nodiscard]] QList<int> usualChannels(const Device &device);
/// What a motion test found. Errors: InvalidArgument (the samples tell nothing).
[[nodiscard]] Result<CommandOutcome> describeMotion(const MotionTestResult &result);
/// A value with its unit as a person reads it.
[[nodiscard]] QString valueText(const ParameterSpec &spec, int raw);
[[nodiscard]] QJsonObject changeJson(const ParameterChange &change);
/// Lines "profile  key  old -> new".
[[nodiscard]] QString changeText(const Configuration &configuration,
                                 const std::vector<ParameterChange> &changes);
/// Lines for the blocks that differ as a whole.
[[nodiscard]] QString dataText(const std::vector<DataChange> &changes);
/// Writes and tells how it went. The exit code is 1 unless everything was verified.
Result<CommandOutcome> writeAndReport(Channel &channel, Device &device, const Configuration &base,
                                      const Configuration &edited, const CommandOptions &options);
