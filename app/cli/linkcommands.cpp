// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/measurecommand.h"
#include "app/cli/telemetryprinter.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/samplewatch.h"
#include "protocol/record/recorder.h"
#include "protocol/record/udpexport.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/supervisor/boardlimits.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/errortext.h"
#include "widgets/models/thinningtext.h"

#include <algorithm>
#include <cmath>

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

/// How good the link is, after some seconds of it.
class LinkCommand final : public Command
{
public:
    using Command::Command;
    const char *name() const override { return "link"; }
    QString help() const override { return u"round trip, answers, and what was lost, over some seconds"_s; }
    const char *example() const override { return "--link udp://192.168.32.1:2020 link --seconds 5"; }
    QString check() const override { return arguments().isEmpty() ? QString() : u"link takes no words"_s; }
    QList<CommandOption> options() override
    {
        return {{u"seconds"_s, u"N"_s, u"how long it is measured, 5 without it"_s,
                 [this](const QString &text) -> Result<void> {
                     bool ok = false;
                     m_seconds = text.toDouble(&ok);
                     if (ok && m_seconds >= kShortest && m_seconds <= kLongest)
                         return {};
                     return failure(ErrorCode::InvalidArgument,
                                    u"--seconds needs a number from %1, not '%2'"_s.arg(kShortest).arg(text));
                 }}};
    }
    void start(DeviceClient &client) override
    {
        m_client = &client;
        client.subscribe({});
        QTimer::singleShot(milliseconds(qint64(m_seconds * 1000)), this, [this] { stop(); });
    }

    void stop() override
    {
        if (!m_client)
            return;
        const LinkStatistics &link = m_client->statistics();
        const std::optional<Duration> time
            = link.quality && link.quality->roundTrip ? link.quality->roundTrip : link.roundTrip;
        const auto store = m_client->telemetry();
        CommandOutcome outcome;
        QJsonObject json{{u"bytesIn"_s, qint64(link.bytesIn)},
                         {u"bytesOut"_s, qint64(link.bytesOut)},
                         {u"framesPerSecond"_s, link.framesPerSecond},
                         {u"damaged"_s, qint64(link.framing.headerErrors + link.framing.bodyErrors)},
                         {u"unanswered"_s, qint64(link.timeouts)}};
        outcome.text = u"received          %1 bytes, %2 frames/s, %3 damaged\n"
                       u"sent              %4 bytes, %5 without an answer\n"_s.arg(link.bytesIn)
                           .arg(link.framesPerSecond, 0, 'f', 0)
                           .arg(link.framing.headerErrors + link.framing.bodyErrors)
                           .arg(link.bytesOut)
                           .arg(link.timeouts);
        const auto add
            = [&](const QString &key, const QString &label, double value, const QString &unit, int digits) {
                  json.insert(key, value);
                  outcome.text += u"%1 %2 %3\n"_s.arg(label.leftJustified(18),
                                                      QString::number(value, 'f', digits), unit);
              };
        if (time)
            add(u"roundTripMs"_s, u"round trip"_s, seconds(*time) * 1000, u"ms"_s, 1);
        if (link.quality && link.quality->answered)
            add(u"answeredPercent"_s, u"answered"_s, *link.quality->answered * 100, u"%"_s, 0);
        if (const int there = m_client->roles().receiveQuality;
            store && there >= 0 && !std::isnan(store->latest(there)))
            add(u"boardReceivesPercent"_s, u"the board receives"_s, double(store->latest(there)), u"%"_s, 0);
        if (store)
            addInvalid(outcome, json, *store);
        if (link.quality) {
            json.insert(u"otherStation"_s, link.quality->isShared);
            json.insert(u"foreignAnswers"_s, qint64(link.quality->foreign));
            if (link.quality->isShared)
                outcome.text += u"another ground station talks to the same board: answers and live data "
                                u"are missing\n"_s;
        }
        outcome.json = json;
        m_client = nullptr;
        emit finished(outcome);
    }

private:
    // Values that were none, by channel.
    void addInvalid(CommandOutcome &outcome, QJsonObject &json, const TelemetryStore &store) const
    {
        QJsonObject counts;
        const ChannelTable table = m_client->device()->channels();
        for (int channel = 0; channel < store.channelCount(); ++channel) {
            const quint64 invalid = store.invalid(channel);
            if (invalid == 0)
                continue;
            const QString key = QString::fromLatin1(table[std::size_t(channel)].key);
            counts.insert(key, qint64(invalid));
            outcome.text += u"no numbers        %1 of %2\n"_s.arg(invalid).arg(key);
        }
        json.insert(u"invalid"_s, counts);
    }

    static constexpr double kShortest = 0.5;
    DeviceClient *m_client = nullptr;
    double m_seconds = 5;
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
    return makeCommands<MonitorCommand, RecordCommand, LinkCommand, PublishCommand, MeasureCommand>(context);
}
