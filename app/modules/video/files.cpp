// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/modules/video/handles.h"

extern "C" {
#include <libavcodec/bsf.h>
}

#include <tuple>

namespace libav {

namespace {

// How long a part of the file may be that is lost when the program ends without a word.
constexpr int kClusterMs = 500;

QByteArray urlOf(const QString &path)
{
    return "file:" + path.toUtf8();
}

tl::unexpected<Error> fileError(int code, const QString &path, bool writing)
{
    FileProblem problem = FileProblem::System;
    if (code == AVERROR(ENOSPC))
        problem = FileProblem::DiskFull;
    else if (code == AVERROR(EACCES) || code == AVERROR(EROFS) || code == AVERROR(EPERM))
        problem = writing ? FileProblem::NotWritable : FileProblem::NotReadable;
    else if (code == AVERROR(ENOENT))
        problem = FileProblem::Missing;
    else if (code == AVERROR_INVALIDDATA)
        problem = FileProblem::OtherKind;
    const FileFault fault{.problem = problem, .path = path, .writing = writing, .said = errorWords(code)};
    // This module does not link the sources of the floors beneath it.
    return tl::unexpected<Error>(Error{ErrorCode::BadFile, path + QStringLiteral(": ") + fault.said, 0,
                                       std::make_shared<const FileFault>(fault)});
}

class Writer final : public VideoFileWriter
{
public:
    explicit Writer(QString path)
        : m_path(std::move(path))
        , m_packet(av_packet_alloc())
    {
    }
    ~Writer() override { std::ignore = finish(); }
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;

    Result<void> open(const VideoTrack &track)
    {
        const QByteArray url = urlOf(m_path);
        int code = avformat_alloc_output_context2(&m_format, nullptr, "matroska", url.constData());
        if (code < 0)
            return fileError(code, m_path, true);
        AVStream *stream = avformat_new_stream(m_format, nullptr);
        AVCodecParameters &codec = *stream->codecpar;
        codec.codec_type = AVMEDIA_TYPE_VIDEO;
        codec.codec_id = codecFor(track.format);
        codec.width = track.size.width();
        codec.height = track.size.height();
        if (!track.parameterSets.isEmpty()) {
            const auto size = std::size_t(track.parameterSets.size());
            codec.extradata = static_cast<std::uint8_t *>(av_mallocz(size + AV_INPUT_BUFFER_PADDING_SIZE));
            std::memcpy(codec.extradata, track.parameterSets.constData(), size);
            codec.extradata_size = int(size);
        }
        stream->time_base = {1, 1000};
        code = avio_open(&m_format->pb, url.constData(), AVIO_FLAG_WRITE);
        if (code < 0)
            return fileError(code, m_path, true);
        m_format->flags |= AVFMT_FLAG_FLUSH_PACKETS;
        AVDictionary *options = nullptr;
        av_dict_set_int(&options, "cluster_time_limit", kClusterMs, 0);
        code = avformat_write_header(m_format, &options);
        av_dict_free(&options);
        m_hasHeader = code >= 0;
        return m_hasHeader ? Result<void>() : fileError(code, m_path, true);
    }

    Result<void> write(const VideoPacket &packet) override
    {
        if (!m_hasHeader || av_new_packet(m_packet.get(), int(packet.bytes.size())) < 0)
            return fileError(AVERROR(EINVAL), m_path, true);
        std::memcpy(m_packet->data, packet.bytes.constData(), std::size_t(packet.bytes.size()));
        m_packet->pts = m_packet->dts = packet.time.count();
        m_packet->flags = packet.isKey ? AV_PKT_FLAG_KEY : 0;
        av_packet_rescale_ts(m_packet.get(), {1, 1000}, m_format->streams[0]->time_base);
        int code = av_write_frame(m_format, m_packet.get());
        av_packet_unref(m_packet.get());
        avio_flush(m_format->pb);
        if (code >= 0)
            code = m_format->pb->error;
        return code >= 0 ? Result<void>() : fileError(code, m_path, true);
    }

    Result<void> finish() override
    {
        if (!m_format)
            return {};
        int code = m_hasHeader ? av_write_trailer(m_format) : 0;
        if (m_format->pb) {
            m_bytes = avio_tell(m_format->pb);
            const int closed = avio_closep(&m_format->pb);
            code = code < 0 ? code : closed;
        }
        avformat_free_context(m_format);
        m_format = nullptr;
        m_hasHeader = false;
        return code >= 0 ? Result<void>() : fileError(code, m_path, true);
    }

    [[nodiscard]] qint64 bytesWritten() const override
    {
        return m_format && m_format->pb ? avio_tell(m_format->pb) : m_bytes;
    }

private:
    QString m_path;
    PacketHandle m_packet;
    AVFormatContext *m_format = nullptr;
    bool m_hasHeader = false;
    qint64 m_bytes = 0;
};

class Reader final : public VideoFileReader
{
public:
    Reader(AVFormatContext *format, int stream)
        : m_format(format)
        , m_stream(stream)
        , m_packet(av_packet_alloc())
    {
        // In the file, sizes stand in front of the units; decoders of streams want start codes.
        if (codec().codec_id != AV_CODEC_ID_H264)
            return;
        if (av_bsf_alloc(av_bsf_get_by_name("h264_mp4toannexb"), &m_filter) < 0)
            return;
        avcodec_parameters_copy(m_filter->par_in, &codec());
        m_filter->time_base_in = format->streams[stream]->time_base;
        if (av_bsf_init(m_filter) < 0)
            av_bsf_free(&m_filter);
    }
    ~Reader() override
    {
        av_bsf_free(&m_filter);
        avformat_close_input(&m_format);
    }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    [[nodiscard]] VideoTrack track() const override
    {
        VideoTrack track;
        track.format = codec().codec_id == AV_CODEC_ID_H264 ? VideoFormat::H264
            : codec().codec_id == AV_CODEC_ID_MJPEG         ? VideoFormat::Mjpeg
                                                            : VideoFormat::Unknown;
        track.size = {codec().width, codec().height};
        const AVCodecParameters &own = m_filter ? *m_filter->par_out : codec();
        track.parameterSets = QByteArray(reinterpret_cast<const char *>(own.extradata), own.extradata_size);
        return track;
    }

    std::optional<VideoPacket> next() override
    {
        while (av_read_frame(m_format, m_packet.get()) >= 0) {
            if (m_packet->stream_index != m_stream) {
                av_packet_unref(m_packet.get());
                continue;
            }
            if (m_filter
                && (av_bsf_send_packet(m_filter, m_packet.get()) < 0
                    || av_bsf_receive_packet(m_filter, m_packet.get()) < 0)) {
                av_packet_unref(m_packet.get());
                continue;
            }
            av_packet_rescale_ts(m_packet.get(), m_format->streams[m_stream]->time_base, {1, 1000});
            const VideoPacket packet{
                QByteArray(reinterpret_cast<const char *>(m_packet->data), m_packet->size),
                milliseconds(m_packet->pts), (m_packet->flags & AV_PKT_FLAG_KEY) != 0};
            av_packet_unref(m_packet.get());
            return packet;
        }
        return {};
    }

private:
    [[nodiscard]] const AVCodecParameters &codec() const { return *m_format->streams[m_stream]->codecpar; }

    AVFormatContext *m_format;
    int m_stream;
    PacketHandle m_packet;
    AVBSFContext *m_filter = nullptr;
};

}  // namespace

Result<std::unique_ptr<VideoFileWriter>> createFile(const QString &path, const VideoTrack &track)
{
    auto writer = std::make_unique<Writer>(path);
    if (const auto opened = writer->open(track); !opened)
        return tl::unexpected(opened.error());
    return writer;
}

Result<std::unique_ptr<VideoFileReader>> openFile(const QString &path)
{
    AVFormatContext *format = nullptr;
    int code = avformat_open_input(&format, urlOf(path).constData(), nullptr, nullptr);
    if (code < 0)
        return fileError(code, path, false);
    code = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (code < 0) {
        avformat_close_input(&format);
        return fileError(AVERROR_INVALIDDATA, path, false);
    }
    return std::make_unique<Reader>(format, code);
}

}  // namespace libav
