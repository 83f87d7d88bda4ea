// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/measurecommand.h"
#include "app/cli/telemetryprinter.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/samplewatch.h"
#include "protocol/record/recorder.h"
#include "protocol/record/udpexport.h"
#include "protocol/supervisor/boardlimits.h"
#include "protocol/telemetry/telemetryplan.h"
#include "widgets/models/errortext.h"
#include "widgets/models/thinningtext.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLongest = 1e6;  // seconds
constexpr auto kWatchPeriod = 250ms;
constexpr qint64 kConfigurationBytes = 4000;  // about, of any board
constexpr double kLongestReading = 1;  // seconds

/// A command that runs telemetry for some time, until it stops coming, or until interrupted.
class StreamingCommand : public Command
{
public:
    using Command::Command;

    QList<CommandOption> options() override
    {
        return {channelsOption(m_channels),
                {u"stream"_s, u"KIND@RATE"_s, u"which streams to ask for (again for more)"_s,
                 [this](const QString &text) { return takeStream(text); }, true},
                {u"seconds"_s, u"N"_s, u"end after so long; without it, at Ctrl-C"_s,
                 [this](const QString &text) { return takeSeconds(text); }}};
    }

    void start(DeviceClient &client) final
    {
        m_client = &client;
        const Device *device = client.device();
        const auto named = findChannels(device->channels(), m_channels);
        if (!named) {
            emit finished(tl::unexpected(named.error()));
            return;
        }
        connect(&client, &DeviceClient::telemetryFailed, this,
                [this](const Error &error) { emit finished(tl::unexpected(error)); });
        if (!client.address().isReplay())
            supervise();
        begin(named->isEmpty() ? defaultChannels(*device) : *named);
    }

    bool endsWith(const Error &error) final
    {
        if (!hasBegun())
            return false;
        m_lost = error;
        stop();
        return true;
    }

protected:
    virtual void begin(const QList<int> &channels) = 0;
    /// It has something to end with.
    [[nodiscard]] virtual bool hasBegun() const = 0;
    [[nodiscard]] DeviceClient &client() const { return *m_client; }
    [[nodiscard]] double duration() const { return m_seconds; }
    [[nodiscard]] Subscription subscriptionFor(const QList<int> &channels) const
    {
        Subscription subscription{channels, 0, m_streams};
        for (StreamChoice &stream : subscription.streams)
            stream.channels = channels;
        return subscription;
    }
    /// Asks for telemetry, and for stop() after the time that was given.
    void stream(const QList<int> &channels)
    {
        client().subscribe(subscriptionFor(channels));
        if (m_seconds > 0)
            QTimer::singleShot(milliseconds(qint64(m_seconds * 1000)), this, [this] { stop(); });
        watch(channels);
    }
    /// Asks for stop() once these channels have no more samples.
    void watch(const QList<int> &channels)
    {
        double slowest = 0;
        for (const StreamChoice &stream : m_streams) {
            if (stream.rate > 0)
                slowest = slowest > 0 ? std::min(slowest, stream.rate) : stream.rate;
        }
        m_watch = std::make_unique<SampleWatch>(client(), channels, slowest);
        connect(m_watch.get(), &SampleWatch::ended, this, [this] { stop(); });
        m_watch->start();
    }
    /// Ends with this, and with what is to be said about the samples.
    void conclude(CommandOutcome outcome)
    {
        const QString finding = m_watch ? m_watch->finding() : QString();
        const bool wholeRecording = m_watch && m_watch->isReplayed() && m_seconds <= 0;
        const TelemetryPlan &plan = m_client->telemetryPlan();
        if (const QString thinned = thinningText(plan.rate, plan.fullRate, plan.budget); !thinned.isEmpty()) {
            outcome.note += u'\n' + thinned;
            if (outcome.json.isObject()) {
                QJsonObject object = outcome.json.toObject();
                object.insert(u"thinned"_s, thinned);
                outcome.json = object;
            }
        }
        if (m_lost)
            reportError(outcome, *m_lost);
        else if (!m_watch || !m_watch->hasHeard())
            reportError(outcome,
                        {ErrorCode::NoSamples, finding.isEmpty() ? u"not one sample"_s : finding, 0});
        else if (!finding.isEmpty() && !wholeRecording)
            reportError(outcome, {ErrorCode::NoSamples, finding, 0});
        emit finished(outcome);
    }

private:
    // The supervisor knows the board's limits from its configuration, and says what it cannot see.
    void supervise()
    {
        tellCondition(*m_client);
        // Beside live data a slow line would carry nothing else for seconds.
        if (const auto &line = m_client->line();
            line && line->secondsFor(kConfigurationBytes) > kLongestReading) {
            emit told(u"not watched: the board's own limits of angles and voltage: this line is too slow to "
                      u"read them beside "
                      "live data"_s);
            return;
        }
        m_client
            ->submit<SupervisorRules>(
                [rules = rules()](Channel &channel, Device &device) -> Result<SupervisorRules> {
                    const auto board = device.readConfiguration(channel);
                    if (!board)
                        return tl::unexpected(board.error());
                    SupervisorRules known = rules;
                    setBoardLimits(known, device, *board);
                    return known;
                })
            .then(this, [this](const Result<SupervisorRules> &rules) {
                if (rules)
                    m_client->setSupervisorRules(*rules);
                else if (rules.error().code != ErrorCode::Cancelled && !isLinkLoss(rules.error()))
                    emit told(u"not watched: the board's own limits of angles and voltage: %1"_s.arg(
                        describe(rules.error()).oneLine()));
            });
    }

    Result<void> takeStream(const QString &text)
    {
        const auto stream = parseStreamChoice(text);
        if (!stream)
            return tl::unexpected(stream.error());
        m_streams.append(*stream);
        return {};
    }

    Result<void> takeSeconds(const QString &text)
    {
        bool ok = false;
        m_seconds = text.toDouble(&ok);
        if (ok && m_seconds > 0 && m_seconds <= kLongest)
            return {};
        return failure(ErrorCode::InvalidArgument, u"--seconds needs a number above 0, not '%1'"_s.arg(text));
    }

    DeviceClient *m_client = nullptr;
    QStringList m_channels;
    QList<StreamChoice> m_streams;
    double m_seconds = 0;  // 0 = until interrupted
    std::optional<Error> m_lost;  // the link, meanwhile
    std::unique_ptr<SampleWatch> m_watch;
};

class MonitorCommand final : public StreamingCommand
{
public:
    using StreamingCommand::StreamingCommand;
    const char *name() const override { return "monitor"; }
    QString help() const override
    {
        return u"live telemetry as CSV on stdout; without channels, all fast ones"_s;
    }
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 monitor --channels imu.angle.roll,gyro.roll --seconds 10";
    }
    void stop() override { m_printer->finish(); }

protected:
    [[nodiscard]] bool hasBegun() const override { return m_printer != nullptr; }
    void begin(const QList<int> &channels) override
    {
        m_printer = std::make_unique<TelemetryPrinter>(client(), channels, subscriptionFor(channels),
                                                       duration(), speaksJson());
        connect(m_printer.get(), &TelemetryPrinter::finished, this, [this](const QString &note) {
            CommandOutcome outcome;
            outcome.json = m_printer->json();
            outcome.note = note;
            if (m_printer->failure())
                reportError(outcome, *m_printer->failure());
            else if (const double silent = m_printer->silentAtEnd(); silent > 0)
                reportError(outcome,
                            {ErrorCode::NoSamples, u"nothing more for %1 s"_s.arg(silent, 0, 'f', 1), 0});
            conclude(outcome);
        });
        m_printer->start();
        watch(channels);
    }

private:
    std::unique_ptr<TelemetryPrinter> m_printer;
};

class RecordCommand final : public StreamingCommand
{
public:
    using StreamingCommand::StreamingCommand;
    const char *name() const override { return "record"; }
    const char *words() const override { return "FILE"; }
    QString help() const override { return u"everything on the link into a file, until Ctrl-C"_s; }
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 record flight.rec --seconds 60";
    }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"record needs one file name"_s;
    }
    void prepare(DeviceClient &client) override { client.addListener(m_recorder); }

    void stop() override
    {
        if (!m_task)
            return;
        const auto result = m_task->finish();
        const qint64 bytes = m_task->bytesWritten();
        m_task.reset();
        if (!result) {
            emit finished(tl::unexpected(result.error()));
            return;
        }
        CommandOutcome outcome;
        const QString path = arguments().first();
        const auto store = client().telemetry();
        outcome.text = u"%1 bytes in %2\n"_s.arg(bytes).arg(path);
        outcome.note = u"%1 rows, %2 lost"_s.arg(store->rows()).arg(store->lost());
        outcome.json = QJsonObject{{u"file"_s, path},
                                   {u"bytes"_s, bytes},
                                   {u"rows"_s, qint64(store->rows())},
                                   {u"lost"_s, qint64(store->lost())}};
        conclude(outcome);
    }

protected:
    [[nodiscard]] bool hasBegun() const override { return m_task != nullptr; }
    // Everything is read first, so that the recording can be opened like the board itself; then the streams
    // start.
    void begin(const QList<int> &channels) override
    {
        auto task = RecordingTask::start(m_recorder, arguments().first(),
                                         recordingDescription(client().identity(), client().address()), true);
        if (!task) {
            emit finished(tl::unexpected(task.error()));
            return;
        }
        m_task = std::move(*task);
        client()
            .submit<Configuration>(
                [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
            .then(this, [this, channels](const Result<Configuration> &) { stream(channels); });
        // A full disk ends it at once, not at the end of the hour.
        auto *watch = new QTimer(this);
        connect(watch, &QTimer::timeout, this, [this] {
            if (m_task && m_task->hasFailed())
                stop();
        });
        watch->start(kWatchPeriod);
    }

private:
    Recorder m_recorder;  // the client's threads feed it, and commands outlive the client
    std::unique_ptr<RecordingTask> m_task;
};

class PublishCommand final : public StreamingCommand
{
public:
    using StreamingCommand::StreamingCommand;
    const char *name() const override { return "publish"; }
    const char *words() const override { return "HOST:PORT"; }
    QString help() const override { return u"telemetry as JSON over UDP, for PlotJuggler (port 9870)"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 publish 127.0.0.1:9870"; }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"publish needs one HOST:PORT"_s;
    }

    void stop() override
    {
        m_export->flush();
        CommandOutcome outcome;
        const quint64 lost = client().telemetry()->lost();
        outcome.text = u"%1 samples sent to %2\n"_s.arg(m_export->sent()).arg(arguments().first());
        outcome.note = u"%1 lost"_s.arg(lost);
        outcome.json = QJsonObject{{u"sent"_s, qint64(m_export->sent())}, {u"lost"_s, qint64(lost)}};
        conclude(outcome);
    }

protected:
    [[nodiscard]] bool hasBegun() const override { return m_export != nullptr; }
    void begin(const QList<int> &channels) override
    {
        m_export = std::make_unique<UdpExport>(client().device()->channels(), client().telemetry(), channels);
        connect(m_export.get(), &UdpExport::failed, this,
                [this](const Error &error) { emit failed(error, Refused); });
        if (const auto started = m_export->start(arguments().first()); !started) {
            emit failed(started.error(), WrongArguments);
            return;
        }
        stream(channels);
    }

private:
    std::unique_ptr<UdpExport> m_export;
};

}  // namespace

Commands linkCommands(const CommandContext &context)
{
    return makeCommands<MonitorCommand, RecordCommand, PublishCommand, MeasureCommand>(context);
}
