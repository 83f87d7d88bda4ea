// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/ctl.h"

#include "app/cli/signalwatcher.h"
#include "app/cli/telemetryprinter.h"
#include "app/composition/composition.h"
#include "protocol/record/responsecsv.h"
#include "widgets/models/errortext.h"

#include <QCommandLineParser>
#include <QJsonDocument>
#include <QSaveFile>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

/// A place in the list for "monitor", which the program runs itself.
class MonitorCommand final : public Command
{
public:
    const char *name() const override { return "monitor"; }
    const char *usage() const override
    {
        return "monitor [--channels a,b] [--stream KIND@RATE] [--seconds N]";
    }
    const char *help() const override
    {
        return "live telemetry as CSV on stdout; without channels, all fast ones";
    }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.isEmpty() ? QString() : u"monitor takes options only"_s;
    }
};

/// The same for "record".
class RecordCommand final : public Command
{
public:
    const char *name() const override { return "record"; }
    const char *usage() const override
    {
        return "record FILE [--channels a,b] [--stream KIND@RATE] [--seconds N]";
    }
    const char *help() const override { return "everything on the link into a file, until Ctrl-C"; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.size() == 1 ? QString() : u"record needs one file name"_s;
    }
};

/// The same for "publish".
class PublishCommand final : public Command
{
public:
    const char *name() const override { return "publish"; }
    const char *usage() const override { return "publish HOST:PORT [--channels a,b] [--seconds N]"; }
    const char *help() const override { return "telemetry as JSON over UDP, for PlotJuggler (port 9870)"; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.size() == 1 ? QString() : u"publish needs one HOST:PORT"_s;
    }
};

/// "steps pitch degrees=3": how an axis follows, measured by moving it a little.
Result<MotionTestPlan> motionPlan(const QStringList &words)
{
    MotionTestPlan plan;
    if (words.size() < 2 || (words[0] != u"steps"_s && words[0] != u"sweep"_s))
        return failure(ErrorCode::InvalidArgument, u"measure needs steps or sweep, and an axis"_s);
    plan.kind = words[0] == u"steps"_s ? MotionTestPlan::Kind::Steps : MotionTestPlan::Kind::Sweep;
    const auto axis = std::find_if(kAxes.begin(), kAxes.end(),
                                   [&](Axis each) { return words[1] == QLatin1String(axisKey(each)); });
    if (axis == kAxes.end())
        return failure(ErrorCode::InvalidArgument,
                       u"'%1' is no axis; there are roll, pitch, yaw"_s.arg(words[1]));
    plan.axis = *axis;
    double steps = plan.steps;
    const QMap<QString, double *> values{{u"degrees"_s, &plan.degrees}, {u"steps"_s, &steps},
                                         {u"rest"_s, &plan.rest},       {u"from"_s, &plan.fromHz},
                                         {u"to"_s, &plan.toHz},         {u"seconds"_s, &plan.sweepSeconds},
                                         {u"limit"_s, &plan.limit}};
    for (const QString &word : words.sliced(2)) {
        const QString name = word.section(u'=', 0, 0);
        bool ok = false;
        const double value = word.section(u'=', 1).toDouble(&ok);
        if (!ok || !values.contains(name)) {
            return failure(ErrorCode::InvalidArgument,
                           u"'%1' is not NAME=NUMBER with one of %2"_s.arg(
                               word, QStringList(values.keys()).join(u", "_s)));
        }
        *values.value(name) = value;
    }
    plan.steps = int(steps);
    if (const auto checked = plan.check(); !checked)
        return tl::unexpected(checked.error());
    return plan;
}

/// The same for "measure".
class MeasureCommand final : public Command
{
public:
    const char *name() const override { return "measure"; }
    const char *usage() const override
    {
        return "measure steps|sweep AXIS [degrees=N] [to=HZ] ... [--csv FILE]";
    }
    const char *help() const override
    {
        return "moves an axis a little and tells how it follows; motors must run";
    }
    QString check(const CommandOptions &options) const override
    {
        const auto plan = motionPlan(options.arguments);
        return plan ? QString() : plan.error().detail;
    }
};

QByteArray toJsonText(const QJsonValue &value)
{
    if (value.isArray())
        return QJsonDocument(value.toArray()).toJson();
    return QJsonDocument(value.toObject()).toJson();
}

TelemetryWish wishFor(const QList<int> &channels, const QStringList &streams)
{
    TelemetryWish wish{channels, 0, {}};
    for (const QString &text : streams) {
        StreamWish stream = *parseStreamWish(text);  // checked with the arguments
        stream.channels = channels;
        wish.streams.append(stream);
    }
    return wish;
}

}  // namespace

Ctl::Ctl(QObject *parent)
    : QObject(parent)
    , m_commands(allCommands())
{
    m_commands.push_back(std::make_unique<MonitorCommand>());
    m_commands.push_back(std::make_unique<RecordCommand>());
    m_commands.push_back(std::make_unique<PublishCommand>());
    m_commands.push_back(std::make_unique<MeasureCommand>());
}

Ctl::~Ctl() = default;

QString Ctl::helpText() const
{
    QString text
        = u"gimbalctl --link ADDRESS [--family F] [--json] COMMAND\n\n"
          u"ADDRESS: serial:/dev/ttyUSB0?baud=115200&parity=none, tcp://host:port, sim:simplebgc?seed=1,\n"
          u"         sim:storm32?firmware=0.90, replay:FILE?speed=4\n"
          u"F: simplebgc or storm32; without it gimbalctl finds out who answers\n\n"_s;
    for (const auto &command : m_commands) {
        text += u"  %1 %2\n"_s.arg(QString::fromUtf8(command->usage()).leftJustified(64),
                                   QString::fromUtf8(command->help()));
    }
    text += u"\nOptions: --profile N, --no-save, --dry-run, --channels LIST, --stream KIND@RATE (again for\n "
            u"        more), --seconds N, --csv FILE, --history DIR, --version\n"
            u"Exit codes: 0 done, 1 the board or the link said no, 2 wrong arguments.\n"_s;
    return text;
}

int Ctl::wrong(const QString &message)
{
    m_err << "gimbalctl: " << message << "\n(gimbalctl --help lists commands and options)\n";
    m_err.flush();
    return WrongArguments;
}

std::optional<int> Ctl::start(const QStringList &arguments)
{
    QCommandLineParser parser;
    const QCommandLineOption link(u"link"_s, {}, u"address"_s);
    const QCommandLineOption family(u"family"_s, {}, u"family"_s);
    const QCommandLineOption json(u"json"_s);
    const QCommandLineOption profile(u"profile"_s, {}, u"n"_s);
    const QCommandLineOption noSave(u"no-save"_s);
    const QCommandLineOption dryRun(u"dry-run"_s);
    const QCommandLineOption channels(u"channels"_s, {}, u"list"_s);
    const QCommandLineOption stream(u"stream"_s, {}, u"kind@rate"_s);
    const QCommandLineOption seconds(u"seconds"_s, {}, u"n"_s);
    const QCommandLineOption csv(u"csv"_s, {}, u"file"_s);
    const QCommandLineOption history(u"history"_s, {}, u"dir"_s);
    const QCommandLineOption help(QStringList{u"h"_s, u"help"_s});
    const QCommandLineOption version(u"version"_s);
    parser.addOptions({link, family, json, profile, noSave, dryRun, channels, stream, seconds, csv, history,
                       help, version});
    if (!parser.parse(arguments))
        return wrong(parser.errorText());
    if (parser.isSet(help)) {
        m_out << helpText();
        m_out.flush();
        return Done;
    }
    if (parser.isSet(version)) {
        m_out << "gimbalctl " GIMBAL_VERSION "\n";
        m_out.flush();
        return Done;
    }

    m_json = parser.isSet(json);
    m_options.noSave = parser.isSet(noSave);
    m_options.dryRun = parser.isSet(dryRun);
    m_options.csv = parser.value(csv);
    m_options.channels = parser.value(channels).split(u',', Qt::SkipEmptyParts);
    m_options.streams = parser.values(stream);
    for (const QString &text : std::as_const(m_options.streams)) {
        if (const auto parsed = parseStreamWish(text); !parsed)
            return wrong(parsed.error().detail);
    }
    bool ok = true;
    if (parser.isSet(profile)) {
        m_options.profile = parser.value(profile).toInt(&ok);
        if (!ok || m_options.profile < 1)
            return wrong(u"--profile needs a number from 1, not '%1'"_s.arg(parser.value(profile)));
    }
    if (parser.isSet(seconds)) {
        m_options.seconds = parser.value(seconds).toDouble(&ok);
        if (!ok || !(m_options.seconds > 0) || m_options.seconds > 1e6)
            return wrong(u"--seconds needs a number above 0, not '%1'"_s.arg(parser.value(seconds)));
    }
    if (parser.isSet(history))
        m_options.history = BoardHistory(parser.value(history));

    QStringList words = parser.positionalArguments();
    if (words.isEmpty())
        return wrong(u"no command"_s);
    const QString name = words.takeFirst();
    const auto it = std::find_if(m_commands.begin(), m_commands.end(), [&name](const auto &command) {
        return name == QLatin1String(command->name());
    });
    if (it == m_commands.end())
        return wrong(u"there is no command '%1'"_s.arg(name));
    m_command = it->get();
    m_options.arguments = words;
    if (const QString problem = m_command->check(m_options); !problem.isEmpty())
        return wrong(problem + u"\nusage: gimbalctl "_s + QString::fromUtf8(m_command->usage()));

    if (!m_command->needsBoard(m_options)) {
        QMetaObject::invokeMethod(
            this, [this] { finish(m_command->runWithoutBoard(m_options)); }, Qt::QueuedConnection);
        return {};
    }
    if (!parser.isSet(link))
        return wrong(u"%1 needs --link ADDRESS"_s.arg(name));
    const auto address = LinkAddress::parse(parser.value(link));
    if (!address)
        return wrong(address.error().detail);
    const QList<Family> families = allFamilies();
    const QString familyKey = parser.value(family);
    // Without one it is found out who answers.
    if (parser.isSet(family) && std::none_of(families.begin(), families.end(), [&](const Family &f) {
            return f.key == familyKey;
        })) {
        QStringList keys;
        for (const Family &known : families)
            keys.append(known.key);
        return wrong(u"there is no family '%1'; there are: %2"_s.arg(familyKey, keys.join(u", "_s)));
    }
    // A simulator or recording is checked in full before anything starts.
    if (address->kind() == LinkAddress::Kind::Simulator || address->isReplay()) {
        if (const auto transport = allLinks().transports(*address); !transport) {
            if (transport.error().code != ErrorCode::BadFile)
                return wrong(transport.error().detail);
            QMetaObject::invokeMethod(
                this, [this, error = transport.error()] { onError(error, Refused); }, Qt::QueuedConnection);
            return {};
        }
    }
    m_client = std::make_unique<DeviceClient>(allLinks().transports, families);
    connect(m_client.get(), &DeviceClient::stateChanged, this, &Ctl::onState);
    connect(m_client.get(), &DeviceClient::connectionFailed, this,
            [this](const Error &error) { onError(error, Refused); });
    connect(m_client.get(), &DeviceClient::connectionLost, this,
            [this](const Error &error) { onError(error, Refused); });
    connect(m_client.get(), &DeviceClient::progressChanged, this, &Ctl::onProgress);
    connect(m_client.get(), &DeviceClient::boardSpoke, this, [this](const QString &text) {
        m_err << "the board says: " << text << "\n";
        m_err.flush();
    });
    auto *watcher = new SignalWatcher(this);
    connect(watcher, &SignalWatcher::stopRequested, this, &Ctl::stop);
    if (isRecording())
        m_client->addListener(m_recorder);
    m_client->connectTo(*address, familyKey);
    return {};
}

// Ctrl-C: whatever moves is stopped before the program goes.
void Ctl::stop()
{
    if (m_printer) {
        m_printer->finish();
        return;
    }
    if (m_recording) {
        finishRecording();
        return;
    }
    if (m_publish) {
        finishPublish();
        return;
    }
    if (m_test && m_test->isRunning()) {
        m_test->stop();
        return;
    }
    if (m_started)
        m_client->cancelJobs();
    else
        onError({ErrorCode::Cancelled, {}, 0}, Refused);
}

void Ctl::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected || m_started)
        return;
    m_started = true;
    if (qstrcmp(m_command->name(), "monitor") == 0)
        runMonitor();
    else if (isRecording())
        runRecording();
    else if (qstrcmp(m_command->name(), "publish") == 0)
        runPublish();
    else if (qstrcmp(m_command->name(), "measure") == 0)
        runMeasure();
    else
        runCommand();
}

bool Ctl::isRecording() const
{
    return qstrcmp(m_command->name(), "record") == 0;
}

void Ctl::runCommand()
{
    const auto kind = m_command->moves() ? DeviceClient::JobKind::Moving : DeviceClient::JobKind::Quiet;
    m_client
        ->submit<CommandOutcome>(
            [command = m_command, options = m_options](Channel &channel, Device &device) {
                return command->run(channel, device, options);
            },
            kind)
        .then(this, [this](const Result<CommandOutcome> &outcome) {
            // A moving job posts its "stop" as the last thing; the link stays open until it is out.
            QTimer::singleShot(outcome ? 0 : 100, this, [this, outcome] { finish(outcome); });
        });
}

// The channels asked for, or what an operator looks at first. Empty after an error, which has been told.
QList<int> Ctl::wantedChannels()
{
    const Device *device = m_client->device();
    QList<int> channels;
    for (const QString &key : m_options.channels) {
        const int channel = findChannel(device->channels(), key.trimmed());
        if (channel < 0) {
            QStringList keys;
            for (const ChannelSpec &spec : device->channels())
                keys.append(QLatin1String(spec.key));
            onError({ErrorCode::InvalidArgument,
                     u"no channel '%1'; there are: %2"_s.arg(key, keys.join(u", "_s)), 0},
                    WrongArguments);
            return {};
        }
        channels.append(channel);
    }
    return channels.isEmpty() ? usualChannels(*device) : channels;
}

// First everything is read, so that the recording can be opened like the board itself; then the streams run.
void Ctl::runRecording()
{
    const QList<int> channels = wantedChannels();
    if (channels.isEmpty())
        return;
    auto task = RecordingTask::start(m_recorder, m_options.arguments.first(),
                                     recordingDescription(m_client->identity(), m_client->address()), true);
    if (!task) {
        finish(tl::unexpected(task.error()));
        return;
    }
    m_recording = std::move(*task);
    connect(m_client.get(), &DeviceClient::telemetryFailed, this,
            [this](const Error &error) { finish(tl::unexpected(error)); });
    m_client
        ->submit<Configuration>(
            [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
        .then(this, [this, channels](const Result<Configuration> &) {
            m_client->setTelemetry(wishFor(channels, m_options.streams));
            if (m_options.seconds > 0)
                QTimer::singleShot(milliseconds(qint64(m_options.seconds * 1000)), this,
                                   &Ctl::finishRecording);
        });
    // A full disk ends it at once, not at the end of the hour.
    auto *watch = new QTimer(this);
    connect(watch, &QTimer::timeout, this, [this] {
        if (m_recording && m_recording->hasFailed())
            finishRecording();
    });
    watch->start(250);
}

void Ctl::finishRecording()
{
    if (!m_recording)
        return;
    const auto result = m_recording->finish();
    const qint64 bytes = m_recording->bytesWritten();
    m_recording.reset();
    if (!result) {
        finish(tl::unexpected(result.error()));
        return;
    }
    CommandOutcome outcome;
    const QString path = m_options.arguments.first();
    const auto store = m_client->telemetry();
    outcome.text = u"%1 bytes in %2\n"_s.arg(bytes).arg(path);
    outcome.note = u"%1 rows, %2 lost"_s.arg(store->rows()).arg(store->lost());
    outcome.json = QJsonObject{{u"file"_s, path},
                               {u"bytes"_s, bytes},
                               {u"rows"_s, qint64(store->rows())},
                               {u"lost"_s, qint64(store->lost())}};
    finish(outcome);
}

// Telemetry first: a test begins only when the axis can be seen.
void Ctl::runMeasure()
{
    m_test = std::make_unique<MotionTest>(*m_client);
    const MotionTestPlan plan = *motionPlan(m_options.arguments);
    connect(m_client.get(), &DeviceClient::telemetryFailed, this,
            [this](const Error &error) { finish(tl::unexpected(error)); });
    connect(m_test.get(), &MotionTest::measured, this, &Ctl::finishMeasure);
    connect(m_test.get(), &MotionTest::failed, this, [this](const Error &error) {
        // "stop" and "release" go out before the link is closed.
        QTimer::singleShot(300, this, [this, error] { onError(error, Refused); });
    });
    m_client->setTelemetry({MotionTest::channels(*m_client->device(), plan.axis), 0});
    QTimer::singleShot(1500, this, [this, plan] {
        m_err << (MotionTest::tellsTargets(*m_client->device())
                      ? "moving "
                      : "bringing the camera to its middle, then moving ")
              << axisKey(plan.axis) << " by " << plan.degrees << " degrees\n";
        m_err.flush();
        if (const auto started = m_test->start(plan); !started)
            onError(started.error(), Refused);
    });
}

void Ctl::finishMeasure(const MotionTestResult &result)
{
    auto outcome = describeMotion(result);
    if (outcome && !m_options.csv.isEmpty()) {
        QSaveFile file(m_options.csv);
        const bool written = file.open(QIODevice::WriteOnly)
            && writeResponseCsv(file, result.target.values, result.angle.values, result.angle.rate)
            && file.commit();
        if (!written)
            outcome = failure(ErrorCode::BadFile, u"%1: %2"_s.arg(m_options.csv, file.errorString()));
        else
            outcome->note = u"both sides are in "_s + m_options.csv;
    }
    QTimer::singleShot(300, this, [this, outcome] { finish(outcome); });
}

void Ctl::runPublish()
{
    const QList<int> channels = wantedChannels();
    if (channels.isEmpty())
        return;
    m_publish = std::make_unique<UdpExport>(m_client->device()->channels(), m_client->telemetry(), channels);
    connect(m_publish.get(), &UdpExport::failed, this,
            [this](const Error &error) { onError(error, Refused); });
    connect(m_client.get(), &DeviceClient::telemetryFailed, this,
            [this](const Error &error) { finish(tl::unexpected(error)); });
    if (const auto started = m_publish->start(m_options.arguments.first()); !started) {
        onError(started.error(), WrongArguments);
        return;
    }
    m_client->setTelemetry(wishFor(channels, m_options.streams));
    if (m_options.seconds > 0)
        QTimer::singleShot(milliseconds(qint64(m_options.seconds * 1000)), this, &Ctl::finishPublish);
}

void Ctl::finishPublish()
{
    m_publish->flush();
    CommandOutcome outcome;
    outcome.text = u"%1 samples sent to %2\n"_s.arg(m_publish->sent()).arg(m_options.arguments.first());
    outcome.note = u"%1 lost"_s.arg(m_client->telemetry()->lost());
    outcome.json = QJsonObject{{u"sent"_s, qint64(m_publish->sent())},
                               {u"lost"_s, qint64(m_client->telemetry()->lost())}};
    finish(outcome);
}

void Ctl::runMonitor()
{
    const QList<int> channels = wantedChannels();
    if (channels.isEmpty())
        return;
    connect(m_client.get(), &DeviceClient::telemetryFailed, this,
            [this](const Error &error) { finish(tl::unexpected(error)); });
    m_printer = std::make_unique<TelemetryPrinter>(*m_client, channels, wishFor(channels, m_options.streams),
                                                   m_options.seconds, m_json);
    connect(m_printer.get(), &TelemetryPrinter::finished, this, [this](const QString &note) {
        CommandOutcome outcome;
        outcome.json = m_printer->json();
        outcome.note = note;
        outcome.exitCode = m_printer->rows() > 0 ? Done : Refused;
        finish(outcome);
    });
    m_printer->start();
}

void Ctl::onError(const Error &error, int exitCode)
{
    if (m_finished)
        return;
    m_finished = true;
    const ErrorText text = describe(error);
    m_err << "gimbalctl: " << text.oneLine() << "\n";
    m_err.flush();
    if (m_json) {
        m_out << toJsonText(QJsonObject{{u"error"_s, text.what},
                                        {u"meaning"_s, text.meaning},
                                        {u"cure"_s, text.cure},
                                        {u"detail"_s, text.detail}});
        m_out.flush();
    }
    emit finished(exitCode);
}

void Ctl::onProgress(const Progress &progress)
{
    QString text = describe(progress);
    if (progress.step == u"autotune"_s) {
        text = u"iteration %1: "_s.arg(progress.done);
        for (const Axis axis : kAxes) {
            const QString name = QLatin1String(axisKey(axis));
            text += u" %1 P %2 I %3 D %4 error %5°"_s.arg(name)
                        .arg(progress.values.value(u"p."_s + name))
                        .arg(progress.values.value(u"i."_s + name))
                        .arg(progress.values.value(u"d."_s + name))
                        .arg(progress.values.value(u"error."_s + name), 0, 'f', 2);
        }
    }
    if (text == m_lastProgress || progress.step == u"read-block"_s)
        return;
    m_lastProgress = text;
    m_err << text << "\n";
    m_err.flush();
}

void Ctl::finish(const Result<CommandOutcome> &outcome)
{
    if (m_finished)
        return;
    if (!outcome) {
        const ErrorCode code = outcome.error().code;
        onError(outcome.error(),
                code == ErrorCode::InvalidArgument || code == ErrorCode::OutOfRange ? WrongArguments
                                                                                    : Refused);
        return;
    }
    m_finished = true;
    if (!outcome->note.isEmpty()) {
        m_err << outcome->note << "\n";
        m_err.flush();
    }
    if (m_json)
        m_out << toJsonText(outcome->json);
    else
        m_out << outcome->text;
    m_out.flush();
    emit finished(outcome->exitCode);
}
