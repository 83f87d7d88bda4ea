// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/signalwatcher.h"
#include "protocol/video/videopipeline.h"

#include <QFile>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLongestVideo = 1e6;  // seconds
constexpr auto kLookPeriod = 100ms;
constexpr auto kFirstFrame = 5s;  // a drone repeats what decoding begins with more often than that
constexpr auto kLongestSilence = 10s;

/// Video into a file, as it comes.
class VideoCommand final : public Command
{
public:
    using Command::Command;
    const char *name() const override { return "video"; }
    const char *words() const override { return "FILE"; }
    QString help() const override { return u"the video of a drone into a Matroska file, as it comes"_s; }
    const char *example() const override
    {
        return "--link udp://192.168.32.1:2020 video flight.mkv --seconds 60";
    }
    QList<CommandOption> options() override
    {
        return {{u"from"_s, u"HOST:PORT"_s,
                 u"where it is sent from; without it, port 2021 of the board's host, or a simulated board's "
                 "camera"_s,
                 [this](const QString &text) { return takeFrom(text); }},
                {u"seconds"_s, u"N"_s, u"end after so long; without it, at Ctrl-C"_s,
                 [this](const QString &text) { return takeLength(text); }}};
    }
    QString check() const override
    {
        return arguments().size() == 1 ? QString() : u"video needs one file name"_s;
    }
    bool needsBoard() const override { return m_from.isEmpty() || m_from.startsWith(u':'); }
    bool reportsLoss() const override { return true; }

    void start(DeviceClient &client) override
    {
        const LinkAddress &link = client.address();
        if (link.kind() == LinkAddress::Kind::Simulator && m_from.isEmpty() && context().offerVideo) {
            const auto port = context().offerVideo(link);
            begin(port ? Result<VideoAddress>(VideoAddress{u"127.0.0.1"_s, *port})
                       : tl::unexpected(port.error()));
            return;
        }
        const bool hasHost = link.kind() == LinkAddress::Kind::Udp || link.kind() == LinkAddress::Kind::Tcp;
        begin(VideoAddress::parse(m_from, {hasHost ? link.target() : QString()}));
    }
    void startWithoutBoard() override
    {
        connect(new SignalWatcher(this), &SignalWatcher::stopRequested, this, &VideoCommand::stop);
        begin(VideoAddress::parse(m_from, {}));
    }
    void stop() override { m_video.endRecording(); }

private:
    Result<void> takeFrom(const QString &text)
    {
        m_from = text;
        return VideoAddress::parse(text, {u"host"_s}).map([](const VideoAddress &) {});
    }

    Result<void> takeLength(const QString &text)
    {
        bool ok = false;
        m_seconds = text.toDouble(&ok);
        if (ok && m_seconds > 0 && m_seconds <= kLongestVideo)
            return {};
        return failure(ErrorCode::InvalidArgument, u"--seconds needs a number above 0, not '%1'"_s.arg(text));
    }

    void begin(const Result<VideoAddress> &address)
    {
        if (!address) {
            if (address.error().code == ErrorCode::Unsupported)
                emit finished(tl::unexpected(address.error()));
            else
                emit failed({ErrorCode::InvalidArgument, u"this link has no host: say --from HOST:PORT"_s, 0},
                            WrongArguments);
            return;
        }
        connect(&m_video, &VideoPipeline::failed, this, [this](const Error &error) { giveUp(error); });
        connect(&m_video, &VideoPipeline::recordingEnded, this, &VideoCommand::conclude);
        auto begun = m_video.start(*address, VideoPipeline::Use::RecordOnly);
        if (begun)
            begun = m_video.startRecording(arguments().first());
        if (!begun) {
            emit finished(tl::unexpected(begun.error()));
            return;
        }
        m_began = Clock::now();
        auto *look = new QTimer(this);
        connect(look, &QTimer::timeout, this, &VideoCommand::look);
        look->start(kLookPeriod);
    }

    // A recording begins with a key frame: what was asked for is counted from there.
    void look()
    {
        const VideoRecordingState recording = m_video.recordingState();
        const auto silence = m_video.statistics().silence;
        if (recording.isWaiting && Clock::now() - m_began > kFirstFrame)
            giveUp({ErrorCode::NoSamples,
                    silence ? u"no frame that decoding could begin with came from %1"_s.arg(
                        m_video.address().toString())
                            : u"not one frame of video came from %1"_s.arg(m_video.address().toString()),
                    0});
        else if (silence && *silence > kLongestSilence)
            giveUp({ErrorCode::NoSamples,
                    u"nothing more for %1 s"_s.arg(seconds(Duration(kLongestSilence)), 0, 'f', 0), 0});
        else if (m_seconds > 0 && seconds(recording.length) >= m_seconds)
            stop();
    }

    void giveUp(const Error &error)
    {
        if (!m_error)
            m_error = error;
        stop();
    }

    void conclude(const VideoRecordingState &recording)
    {
        const QString path = arguments().first();
        if (recording.error || recording.frames == 0) {
            if (recording.frames == 0)
                QFile::remove(path);
            const Error nothing{ErrorCode::Cancelled, {}, 0};
            emit finished(tl::unexpected(recording.error ? *recording.error : m_error.value_or(nothing)));
            return;
        }
        const VideoStatistics statistics = m_video.statistics();
        const QString format = statistics.format == VideoFormat::Mjpeg ? u"mjpeg"_s : u"h264"_s;
        const double length = seconds(recording.length);
        CommandOutcome outcome;
        outcome.text = u"%1 frames in %2\n"_s.arg(recording.frames).arg(path);
        outcome.note = u"%1 s, %2 x %3 %4, %5 bytes, %6"_s.arg(length, 0, 'f', 1)
                           .arg(statistics.size.width())
                           .arg(statistics.size.height())
                           .arg(format)
                           .arg(recording.bytes)
                           .arg(statistics.countsLoss() ? u"%1 frames lost"_s.arg(recording.lost)
                                                        : u"loss cannot be counted"_s);
        outcome.json = QJsonObject{
            {u"file"_s, path},
            {u"from"_s, m_video.address().toString()},
            {u"format"_s, format},
            {u"width"_s, statistics.size.width()},
            {u"height"_s, statistics.size.height()},
            {u"seconds"_s, length},
            {u"bytes"_s, recording.bytes},
            {u"frames"_s, qint64(recording.frames)},
            {u"lost"_s, statistics.countsLoss() ? QJsonValue(qint64(recording.lost)) : QJsonValue()}};
        if (m_error)
            reportError(outcome, *m_error);
        emit finished(outcome);
    }

    QString m_from;
    double m_seconds = 0;  // 0 = until interrupted
    VideoPipeline m_video;
    TimePoint m_began{};
    std::optional<Error> m_error;  // why it ends
};

}  // namespace

Commands videoCommands(const CommandContext &context)
{
    return makeCommands<VideoCommand>(context);
}
