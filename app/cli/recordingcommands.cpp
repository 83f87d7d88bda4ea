// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/holes.h"
#include "app/cli/telemetryprinter.h"
#include "protocol/analysis/frequencyresponse.h"
#include "protocol/analysis/holdingquality.h"
#include "protocol/analysis/stepresponse.h"
#include "protocol/base/filefault.h"
#include "protocol/base/responsecsv.h"
#include "protocol/record/replaystore.h"
#include "protocol/record/telemetrycsv.h"
#include "protocol/telemetry/uniformsamples.h"

#include <QSaveFile>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace {

constexpr double kAllTime = 1e12;
constexpr qint64 kLargestText = 512 * 1024 * 1024;
constexpr double kStepSize = 0.5;  // degrees: a smaller jump of a target is no step
constexpr double kStepRest = 0.5;  // seconds a target must rest before and after
constexpr std::array kAxisNames{"roll", "pitch", "yaw"};

/// A recording with its telemetry decoded.
struct Opened
{
    Recording recording;
    std::unique_ptr<Device> device;
    std::shared_ptr<TelemetryStore> store;

    static Result<Opened> open(const QString &path, const QList<Family> &families)
    {
        auto recording = Recording::load(path);
        if (!recording)
            return tl::unexpected(recording.error());
        const QString key = recording->description.value(u"family"_s).toString();
        for (const Family &family : families) {
            if (family.key != key)
                continue;
            Opened opened{std::move(*recording), family.makeDevice(), nullptr};
            auto store = readTelemetry(opened.recording, family, *opened.device);
            if (!store)
                return tl::unexpected(inFile(store.error(), path));
            opened.store = std::move(*store);
            return opened;
        }
        return fileFailure(
            {.problem = FileProblem::OtherFamily, .kind = FileKind::Recording, .path = path, .value = key});
    }

    [[nodiscard]] QString note() const
    {
        return u"%1 s recorded, %2 rows, %3 lost"_s
                   .arg(double(recording.end() - recording.begin()) * 1e-9, 0, 'f', 1)
                   .arg(store->rows())
                   .arg(store->lost())
            + holes().words();
    }
    /// For scripts, where there are any.
    void tellHoles(CommandOutcome &outcome) const
    {
        const Holes found = holes();
        if (found.count() == 0)
            return;
        QJsonObject object = outcome.json.toObject();
        object.insert(u"holes"_s, found.json());
        outcome.json = object;
    }

private:
    [[nodiscard]] Holes holes() const
    {
        std::vector<TrackView> fullest;
        std::size_t maxRows = 0;
        for (int channel = 0; channel < store->channelCount(); ++channel) {
            std::vector<TrackView> tracks = store->tracks(channel);
            std::size_t rows = 0;
            for (const TrackView &track : tracks)
                rows += track.end() - track.begin();
            if (rows > maxRows) {
                maxRows = rows;
                fullest = std::move(tracks);
            }
        }
        Holes found;
        std::optional<double> last;
        for (const TrackView &track : fullest) {
            for (std::size_t row = track.begin(); row < track.end(); ++row) {
                found.take(track.time(row) - last.value_or(track.time(row)), track.period());
                last = track.time(row);
            }
        }
        return found;
    }
};

/// The channels with these keys, or all that were recorded.
Result<QList<int>> channelsOf(const Opened &opened, const QStringList &keys)
{
    const ChannelTable table = opened.device->channels();
    auto channels = findChannels(table, keys);
    for (int channel = 0; keys.isEmpty() && channel < int(table.size()); ++channel) {
        if (!opened.store->tracks(channel).empty())
            channels->append(channel);
    }
    return channels;
}

// As fine a resolution as the samples allow, but no finer than half a hertz.
SpectrumOptions averaging(std::size_t samples, double rate)
{
    int length = 64;
    while (length * 4 <= int(samples) && rate / length > 0.5)
        length *= 2;
    return {length, 0.5, WindowShape::Hann};
}

QJsonObject describeResponse(const FrequencyResponse &closed, const Margins &m, QString &text)
{
    QJsonArray bins;
    for (std::size_t bin = 0; bin < closed.gain.size(); ++bin)
        bins.append(QJsonArray{closed.frequency(bin), closed.gainDb(bin), closed.phaseDeg(bin),
                               closed.coherence[bin]});
    QJsonObject object{{u"bins"_s, bins}, {u"usableBins"_s, m.bins}};
    text += u"  %1 of %2 frequencies have enough motion in them\n"_s.arg(m.bins).arg(closed.gain.size());
    if (m.gainDb) {
        text += u"  gain margin %1 dB at %2 Hz\n"_s.arg(*m.gainDb, 0, 'f', 1).arg(*m.gainHz, 0, 'f', 1);
        object.insert(u"gainMarginDb"_s, *m.gainDb);
    }
    if (m.phaseDeg) {
        text += u"  phase margin %1° at %2 Hz\n"_s.arg(*m.phaseDeg, 0, 'f', 0).arg(*m.phaseHz, 0, 'f', 1);
        object.insert(u"phaseMarginDeg"_s, *m.phaseDeg);
    }
    if (m.bins > 0) {
        text += u"  greatest sensitivity %1 dB at %2 Hz\n"_s.arg(m.sensitivityDb, 0, 'f', 1)
                    .arg(m.sensitivityHz, 0, 'f', 1);
        object.insert(u"sensitivityDb"_s, m.sensitivityDb);
    }
    return object;
}

Result<CommandOutcome> responseOfText(const QString &path, double assumedRate)
{
    const auto text = readWhole(path, FileKind::Measurement, kLargestText);
    if (!text)
        return tl::unexpected(text.error());
    const auto samples = readResponseCsv(*text, assumedRate);
    if (!samples)
        return tl::unexpected(inFile(samples.error(), path));
    const auto closed = frequencyResponse(samples->in, samples->out, samples->rate,
                                          averaging(samples->in.size(), samples->rate));
    if (!closed)
        return tl::unexpected(closed.error());
    CommandOutcome outcome;
    outcome.json = describeResponse(*closed, margins(openLoop(*closed)), outcome.text);
    if (samples->rateAssumed)
        outcome.note = u"the file does not state its rate; %1 samples/s are assumed"_s.arg(samples->rate);
    return outcome;
}

QString timeText(std::optional<double> value)
{
    return value ? u"%1 ms"_s.arg(*value * 1000, 0, 'f', 0) : u"-"_s;
}

class ExportCommand final : public LocalCommand
{
public:
    using LocalCommand::LocalCommand;
    const char *name() const override { return "export"; }
    const char *words() const override { return "FILE"; }
    QString help() const override { return u"samples of a recording as CSV; - or nothing = stdout"_s; }
    const char *example() const override { return "export flight.rec --csv flight.csv"; }
    QList<CommandOption> options() override
    {
        return {textOption(u"csv"_s, u"FILE|-"_s, u"where the samples go, - = stdout"_s, m_csv),
                channelsOption(m_channels), partialOption(m_partial)};
    }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"export needs one recording"_s;
    }
    Result<CommandOutcome> run() override
    {
        const auto opened = Opened::open(arguments().first(), families());
        if (!opened)
            return tl::unexpected(opened.error());
        const auto channels = channelsOf(*opened, m_channels);
        if (!channels)
            return tl::unexpected(channels.error());
        const bool toScreen = m_csv.isEmpty() || m_csv == u"-"_s;
        if (const auto checked = toScreen ? Result<void>() : checkTarget(m_csv, FileKind::Other); !checked)
            return tl::unexpected(checked.error());
        std::unique_ptr<QFileDevice> file;
        if (toScreen)
            file = std::make_unique<QFile>();
        else
            file = std::make_unique<QSaveFile>(m_csv);
        const bool open = toScreen ? static_cast<QFile &>(*file).open(stdout, QIODevice::WriteOnly)
                                   : file->open(QIODevice::WriteOnly);
        if (!open)
            return tl::unexpected(systemError(*file, FileKind::Other, true));
        const auto lines = writeTelemetryCsv(*file, *opened->store, opened->device->channels(), *channels,
                                             -kAllTime, kAllTime);
        if (!lines)
            return tl::unexpected(lines.error());
        if (!toScreen && !static_cast<QSaveFile &>(*file).commit())
            return tl::unexpected(systemError(*file, FileKind::Other, true));
        CommandOutcome outcome;
        outcome.note = opened->note() + valuelessNote(*opened->store, opened->device->channels(), *channels);
        if (!toScreen)
            outcome.text = u"%1 lines saved to %2\n"_s.arg(*lines).arg(m_csv);
        outcome.json = QJsonObject{{u"lines"_s, *lines}, {u"file"_s, m_csv}};
        opened->tellHoles(outcome);
        reportLeftOut(outcome, opened->recording.leftOut(), m_partial);
        return outcome;
    }

private:
    QString m_csv;
    QStringList m_channels;
    bool m_partial = false;
};

class AnalyzeCommand final : public LocalCommand
{
public:
    using LocalCommand::LocalCommand;
    const char *name() const override { return "analyze"; }
    const char *words() const override { return "spectrum|holding|steps|response FILE"; }
    QString help() const override
    {
        return u"measure a recording, or the response in an in;out file (.csv)"_s;
    }
    const char *example() const override { return "analyze spectrum flight.rec"; }
    QList<CommandOption> options() override { return {channelsOption(m_channels), partialOption(m_partial)}; }
    QString check() const override
    {
        static const QStringList kinds{u"spectrum"_s, u"holding"_s, u"steps"_s, u"response"_s};
        if (arguments().size() != 2 || !kinds.contains(arguments().first()))
            return u"analyze needs spectrum, holding, steps or response, and a recording"_s;
        if (arguments().first() == u"response"_s && m_channels.size() != 2 && !m_channels.isEmpty())
            return u"response needs two channels: input,output"_s;
        return {};
    }
    Result<CommandOutcome> run() override
    {
        if (arguments().first() == u"response"_s && arguments()[1].endsWith(u".csv"_s))
            return responseOfText(arguments()[1], fullRate(families()));
        const auto opened = Opened::open(arguments()[1], families());
        if (!opened)
            return tl::unexpected(opened.error());
        Result<CommandOutcome> outcome = measure(arguments().first(), *opened);
        const QList<ReplayGap> gaps = opened->recording.leftOut();
        if (outcome) {
            outcome->note = opened->note();
            opened->tellHoles(*outcome);
            reportLeftOut(*outcome, gaps, m_partial);
        } else {
            emit told(opened->note());  // it may be why
            if (!gaps.isEmpty())
                emit told(leftOutText(gaps));
        }
        return outcome;
    }

private:
    [[nodiscard]] Result<CommandOutcome> measure(const QString &kind, const Opened &opened) const
    {
        if (kind == u"spectrum"_s)
            return spectra(opened);
        if (kind == u"holding"_s)
            return holding(opened);
        return kind == u"steps"_s ? steps(opened) : response(opened);
    }

    static Result<UniformSamples> samplesOf(const Opened &opened, int channel, int minus = -1)
    {
        return uniformSamples(*opened.store, channel, minus, -kAllTime, kAllTime);
    }

    static SpectrumOptions optionsFor(const UniformSamples &samples)
    {
        return averaging(samples.values.size(), samples.rate);
    }

    [[nodiscard]] Result<CommandOutcome> spectra(const Opened &opened) const
    {
        QList<int> channels;
        if (m_channels.isEmpty()) {
            const ChannelRoles roles = rolesOf(*opened.device);
            channels = QList<int>(roles.gyro.begin(), roles.gyro.end());
        } else {
            const auto named = channelsOf(opened, m_channels);
            if (!named)
                return tl::unexpected(named.error());
            channels = *named;
        }
        CommandOutcome outcome;
        QJsonObject json;
        for (const int channel : channels) {
            const ChannelSpec &spec = opened.device->channels()[std::size_t(channel)];
            const auto samples = samplesOf(opened, channel);
            if (!samples)
                return tl::unexpected(samples.error());
            const auto result = spectrum(samples->values, samples->rate, optionsFor(*samples));
            if (!result)
                return tl::unexpected(result.error());
            QJsonArray peaks;
            outcome.text += u"%1: %2 %3 RMS, %4 Hz steps up to %5 Hz\n"_s.arg(QString::fromUtf8(spec.key))
                                .arg(result->bandRms(0, result->rate / 2), 0, 'g', 4)
                                .arg(QString::fromUtf8(spec.unit))
                                .arg(result->resolution, 0, 'f', 2)
                                .arg(result->rate / 2, 0, 'f', 0);
            for (const SpectrumPeak &peak : findPeaks(*result)) {
                outcome.text += u"  %1 Hz  %2 %3 RMS  width %4 Hz  %5 dB above its surroundings\n"_s
                                    .arg(peak.frequency, 7, 'f', 2)
                                    .arg(peak.rms, 0, 'g', 4)
                                    .arg(QString::fromUtf8(spec.unit))
                                    .arg(peak.width, 0, 'f', 1)
                                    .arg(peak.height, 0, 'f', 0);
                peaks.append(QJsonObject{{u"hz"_s, peak.frequency},
                                         {u"rms"_s, peak.rms},
                                         {u"widthHz"_s, peak.width},
                                         {u"aboveDb"_s, peak.height}});
            }
            QJsonArray density;
            for (const double value : result->density)
                density.append(value);
            json.insert(QString::fromUtf8(spec.key),
                        QJsonObject{{u"resolutionHz"_s, result->resolution},
                                    {u"density"_s, density},
                                    {u"peaks"_s, peaks}});
        }
        outcome.json = json;
        return outcome;
    }

    static Result<CommandOutcome> holding(const Opened &opened)
    {
        const ChannelRoles roles = rolesOf(*opened.device);
        CommandOutcome outcome;
        QJsonObject json;
        bool anyKnown = false;
        bool anyChanges = false;
        for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
            const auto samples = samplesOf(opened, roles.angle[axis], roles.target[axis]);
            if (!samples)
                return tl::unexpected(samples.error());
            QJsonArray bands;
            const QString name = QString::fromLatin1(kAxisNames[axis]);
            outcome.text += name + u":\n"_s;
            if (std::adjacent_find(samples->values.begin(), samples->values.end(), std::not_equal_to<>())
                == samples->values.end()) {
                outcome.text += u"  does not change: that is no measurement\n"_s;
                json.insert(name, QJsonValue());
                continue;
            }
            anyChanges = true;
            for (const BandQuality &quality : holdingQuality(samples->values, samples->rate)) {
                if (!quality.known)
                    continue;
                anyKnown = true;
                outcome.text += u"  %1 to %2 Hz  %3° RMS  %4° peak\n"_s.arg(quality.band.from)
                                    .arg(quality.band.to, 0, 'g', 3)
                                    .arg(quality.rms, 0, 'f', 4)
                                    .arg(quality.peak, 0, 'f', 4);
                bands.append(QJsonObject{{u"fromHz"_s, quality.band.from},
                                         {u"toHz"_s, quality.band.to},
                                         {u"rms"_s, quality.rms},
                                         {u"peak"_s, quality.peak}});
            }
            json.insert(name, bands);
        }
        if (!anyChanges)
            return failure(ErrorCode::NoMotion, u"angles of all axes"_s);
        if (!anyKnown)
            return failure(ErrorCode::TooFewSamples, u"not enough for any band of frequencies"_s);
        outcome.json = json;
        return outcome;
    }

    static Error untold()
    {
        return {ErrorCode::Unsupported,
                u"this board does not tell its targets; 'measure steps' knows what it asked for"_s, 0};
    }

    static Result<CommandOutcome> steps(const Opened &opened)
    {
        const ChannelRoles roles = rolesOf(*opened.device);
        if (!tellsTargets(*opened.device))
            return tl::unexpected(untold());
        CommandOutcome outcome;
        QJsonArray list;
        for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
            const auto target = samplesOf(opened, roles.target[axis]);
            const auto angle = samplesOf(opened, roles.angle[axis]);
            if (!target || !angle)
                return tl::unexpected(target ? angle.error() : target.error());
            if (const double told = double(target->values.size()) / target->rate; told < 2 * kStepRest) {
                return failure(
                    ErrorCode::TooFewSamples,
                    u"%1 s; a target has to rest for %2 s before and after a step"_s.arg(told, 0, 'f', 1)
                        .arg(kStepRest));
            }
            const std::vector<StepEvent> events
                = findSteps(target->values, target->rate, kStepSize, kStepRest);
            for (std::size_t i = 0; i < events.size(); ++i) {
                const StepEvent &event = events[i];
                const std::size_t end = i + 1 < events.size() ? events[i + 1].index : angle->values.size();
                if (event.index == 0 || event.index >= std::min(end, angle->values.size()))
                    continue;
                const auto piece
                    = std::span(angle->values)
                          .subspan(event.index, std::min(end, angle->values.size()) - event.index);
                const auto metrics
                    = stepMetrics(piece, angle->rate, double(angle->values[event.index - 1]), event.to);
                if (!metrics)
                    continue;
                const double at = angle->start + double(event.index) / angle->rate;
                QJsonObject json{{u"axis"_s, QString::fromLatin1(kAxisNames[axis])},
                                 {u"at"_s, at},
                                 {u"from"_s, event.from},
                                 {u"to"_s, event.to},
                                 {u"overshootPercent"_s, metrics->overshoot},
                                 {u"error"_s, metrics->error}};
                if (metrics->riseSeconds)
                    json.insert(u"riseSeconds"_s, *metrics->riseSeconds);
                if (metrics->settlingSeconds)
                    json.insert(u"settlingSeconds"_s, *metrics->settlingSeconds);
                list.append(json);
                outcome.text += u"%1 at %2 s: %3° to %4°  rise %5  overshoot %6 %  settled %7\n"_s
                                    .arg(QString::fromLatin1(kAxisNames[axis]))
                                    .arg(at, 0, 'f', 2)
                                    .arg(event.from, 0, 'f', 2)
                                    .arg(event.to, 0, 'f', 2)
                                    .arg(timeText(metrics->riseSeconds))
                                    .arg(metrics->overshoot, 0, 'f', 0)
                                    .arg(timeText(metrics->settlingSeconds));
            }
        }
        if (list.isEmpty())
            outcome.text = u"no target jumps by %1° or more and rests\n"_s.arg(kStepSize);
        outcome.json = list;
        return outcome;
    }

    [[nodiscard]] Result<CommandOutcome> response(const Opened &opened) const
    {
        const ChannelRoles roles = rolesOf(*opened.device);
        QList<std::pair<int, int>> pairs;
        if (m_channels.isEmpty()) {
            if (!tellsTargets(*opened.device))
                return tl::unexpected(untold());
            for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis)
                pairs.append({roles.target[axis], roles.angle[axis]});
        } else {
            const auto named = channelsOf(opened, m_channels);
            if (!named)
                return tl::unexpected(named.error());
            pairs.append({named->at(0), named->at(1)});
        }
        CommandOutcome outcome;
        QJsonObject json;
        for (const auto &[from, to] : pairs) {
            const QString name = QString::fromUtf8(opened.device->channels()[std::size_t(to)].key);
            const auto input = samplesOf(opened, from);
            const auto output = samplesOf(opened, to);
            if (!input || !output)
                return tl::unexpected(input ? output.error() : input.error());
            const auto closed
                = frequencyResponse(input->values, output->values, input->rate, optionsFor(*input));
            if (!closed)
                return tl::unexpected(closed.error());
            outcome.text += name + u":\n"_s;
            const QJsonObject object = describeResponse(*closed, margins(openLoop(*closed)), outcome.text);
            json.insert(name, object);
        }
        outcome.json = json;
        return outcome;
    }

    QStringList m_channels;
    bool m_partial = false;
};

}  // namespace

Result<CommandOutcome> describeMotion(const MotionTestResult &result)
{
    const double rate = result.angle.rate;
    CommandOutcome outcome;
    if (result.plan.kind == MotionTestPlan::Kind::Sweep) {
        const auto closed = frequencyResponse(result.target.values, result.angle.values, rate,
                                              averaging(result.angle.values.size(), rate));
        if (!closed)
            return tl::unexpected(closed.error());
        outcome.json = describeResponse(
            *closed, margins(openLoop(*closed), 0.7, result.plan.fromHz, result.plan.toHz), outcome.text);
        return outcome;
    }
    const auto steps = measureSteps(result.target.values, result.angle.values, rate, 0.95 * result.plan.rest);
    if (!steps)
        return tl::unexpected(steps.error());
    const StepMetrics &m = steps->metrics;
    outcome.text = u"%1 steps: rise %2  overshoot %3 %  settled %4  left over %5 %\n"_s
                       .arg(steps->runs.response.size())
                       .arg(timeText(m.riseSeconds))
                       .arg(m.overshoot, 0, 'f', 1)
                       .arg(timeText(m.settlingSeconds))
                       .arg(100 * m.error, 0, 'f', 1);
    QJsonObject json{{u"steps"_s, int(steps->runs.response.size())},
                     {u"overshootPercent"_s, m.overshoot},
                     {u"error"_s, m.error}};
    if (m.riseSeconds)
        json.insert(u"riseSeconds"_s, *m.riseSeconds);
    if (m.settlingSeconds)
        json.insert(u"settlingSeconds"_s, *m.settlingSeconds);
    outcome.json = json;
    return outcome;
}

Commands recordingCommands(const CommandContext &context)
{
    return makeCommands<ExportCommand, AnalyzeCommand>(context);
}
