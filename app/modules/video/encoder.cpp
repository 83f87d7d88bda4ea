// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/modules/video/handles.h"

namespace libav {

namespace {

void copyPlane(AVFrame &frame, int plane, const std::vector<std::uint8_t> &from, int width, int height)
{
    av_image_copy_plane(frame.data[plane], frame.linesize[plane], from.data(), width, width, height);
}

class Encoder final : public VideoEncoder
{
public:
    Encoder(CodecHandle context, FrameHandle frame, VideoFormat format)
        : m_context(std::move(context))
        , m_frame(std::move(frame))
        , m_packet(av_packet_alloc())
        , m_format(format)
    {
    }

    [[nodiscard]] VideoFormat format() const override { return m_format; }

    Result<QByteArray> encode(const VideoPlanes &picture) override
    {
        if (picture.width != m_frame->width || picture.height != m_frame->height)
            return failure(ErrorCode::InvalidArgument, QStringLiteral("a picture of another size"));
        if (const int code = av_frame_make_writable(m_frame.get()); code < 0)
            return failure(ErrorCode::Unsupported, errorWords(code));
        copyPlane(*m_frame, 0, picture.y, picture.width, picture.height);
        copyPlane(*m_frame, 1, picture.u, picture.width / 2, picture.height / 2);
        copyPlane(*m_frame, 2, picture.v, picture.width / 2, picture.height / 2);
        m_frame->pts = m_count++;
        if (const int code = avcodec_send_frame(m_context.get(), m_frame.get()); code < 0)
            return failure(ErrorCode::Unsupported, errorWords(code));
        QByteArray bytes;
        while (avcodec_receive_packet(m_context.get(), m_packet.get()) >= 0) {
            bytes.append(reinterpret_cast<const char *>(m_packet->data), m_packet->size);
            av_packet_unref(m_packet.get());
        }
        return bytes;
    }

private:
    CodecHandle m_context;
    FrameHandle m_frame;
    PacketHandle m_packet;
    VideoFormat m_format;
    std::int64_t m_count = 0;
};

Result<CodecHandle> openEncoder(const AVCodec &codec, const EncoderSettings &settings, bool isH264)
{
    CodecHandle context(avcodec_alloc_context3(&codec));
    context->width = settings.size.width();
    context->height = settings.size.height();
    context->time_base = {1, settings.frameRate};
    context->framerate = {settings.frameRate, 1};
    context->pix_fmt = isH264 ? AV_PIX_FMT_YUV420P : AV_PIX_FMT_YUVJ420P;
    context->thread_count = 1;
    AVDictionary *options = nullptr;
    if (isH264) {
        context->gop_size = settings.keyInterval;
        context->keyint_min = settings.keyInterval;
        context->max_b_frames = 0;
        context->bit_rate = settings.bitRate;
        context->rc_max_rate = settings.bitRate;
        context->rc_buffer_size = settings.bitRate / 2;
        av_dict_set(&options, "preset", "ultrafast", 0);
        av_dict_set(&options, "tune", "zerolatency", 0);
        av_dict_set(&options, "forced-idr", "1", 0);
        av_dict_set(&options, "x264-params", "scenecut=0:sliced-threads=0:repeat-headers=1:annexb=1", 0);
    } else {
        context->flags |= AV_CODEC_FLAG_QSCALE;
        context->global_quality = 5 * FF_QP2LAMBDA;
    }
    const int code = avcodec_open2(context.get(), &codec, &options);
    av_dict_free(&options);
    if (code < 0)
        return failure(ErrorCode::Unsupported, errorWords(code));
    return context;
}

}  // namespace

Result<std::unique_ptr<VideoEncoder>> makeEncoder(const EncoderSettings &settings)
{
    const AVCodec *h264
        = settings.format == VideoFormat::H264 ? avcodec_find_encoder_by_name("libx264") : nullptr;
    const AVCodec *codec = h264 ? h264 : avcodec_find_encoder(AV_CODEC_ID_MJPEG);
    if (!codec)
        return failure(ErrorCode::Unsupported, QStringLiteral("libav has no encoder for H.264 or JPEG"));
    auto context = openEncoder(*codec, settings, h264 != nullptr);
    if (!context)
        return tl::unexpected(context.error());
    FrameHandle frame(av_frame_alloc());
    frame->width = settings.size.width();
    frame->height = settings.size.height();
    frame->format = (*context)->pix_fmt;
    frame->quality = (*context)->global_quality;
    if (const int code = av_frame_get_buffer(frame.get(), 0); code < 0)
        return failure(ErrorCode::Unsupported, errorWords(code));
    return std::make_unique<Encoder>(std::move(*context), std::move(frame),
                                     h264 ? VideoFormat::H264 : VideoFormat::Mjpeg);
}

}  // namespace libav
