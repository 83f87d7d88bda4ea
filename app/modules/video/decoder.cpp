// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/modules/video/handles.h"

namespace libav {

namespace {

constexpr int kLargestSide = 8192;

class Decoder final : public VideoDecoder
{
public:
    explicit Decoder(CodecHandle context)
        : m_context(std::move(context))
        , m_packet(av_packet_alloc())
        , m_frame(av_frame_alloc())
        , m_newest(av_frame_alloc())
    {
    }

    Outcome decode(Bytes frame, bool isKey) override
    {
        // Damaged bytes may have said that pictures come out of order, which is remembered: each would wait
        // for the next ones from then on.
        if (isKey && m_isBehind) {
            avcodec_flush_buffers(m_context.get());
            m_context->has_b_frames = 0;
        }
        // libav reads some bytes past the end, so it gets its own copy.
        if (frame.empty() || av_new_packet(m_packet.get(), int(frame.size())) < 0)
            return Outcome::Nothing;
        std::memcpy(m_packet->data, frame.data(), frame.size());
        m_packet->pts = ++m_count;
        const int sent = avcodec_send_packet(m_context.get(), m_packet.get());
        av_packet_unref(m_packet.get());
        bool hasPicture = false;
        while (avcodec_receive_frame(m_context.get(), m_frame.get()) >= 0) {
            hasPicture = true;
            av_frame_unref(m_newest.get());
            av_frame_move_ref(m_newest.get(), m_frame.get());
        }
        if (!hasPicture)
            return Outcome::Nothing;
        m_isBehind = m_newest->pts != m_count;
        const bool isDamaged
            = sent < 0 || m_newest->decode_error_flags != 0 || (m_newest->flags & AV_FRAME_FLAG_CORRUPT) != 0;
        return isDamaged ? Outcome::Damaged : Outcome::Picture;
    }

    [[nodiscard]] QSize size() const override { return {m_newest->width, m_newest->height}; }

    bool convert(VideoPicture &into, QSize size) override
    {
        const bool isPossible = m_newest->width > 0 && m_newest->height > 0 && m_newest->width <= kLargestSide
            && m_newest->height <= kLargestSide && size.width() > 0 && size.height() > 0
            && size.width() <= kLargestSide && size.height() <= kLargestSide;
        if (!isPossible)
            return false;
        // Unscaled it is a conversion of colours alone, which is written for the processor.
        const int way = size == this->size() ? SWS_POINT : SWS_FAST_BILINEAR;
        m_scaler.reset(sws_getCachedContext(m_scaler.release(), m_newest->width, m_newest->height,
                                            AVPixelFormat(m_newest->format), size.width(), size.height(),
                                            AV_PIX_FMT_BGRA, way, nullptr, nullptr, nullptr));
        if (!m_scaler)
            return false;
        into.width = size.width();
        into.height = size.height();
        into.pixels.resize(std::size_t(into.stride()) * std::size_t(into.height));
        std::uint8_t *rows[] = {into.pixels.data(), nullptr, nullptr, nullptr};
        const int strides[] = {int(into.stride()), 0, 0, 0};
        return sws_scale(m_scaler.get(), m_newest->data, m_newest->linesize, 0, m_newest->height, rows,
                         strides)
            == size.height();
    }

private:
    CodecHandle m_context;
    PacketHandle m_packet;
    FrameHandle m_frame;
    FrameHandle m_newest;
    ScalerHandle m_scaler;
    std::int64_t m_count = 0;
    bool m_isBehind = false;  // the picture is not of the last frame
};

}  // namespace

Result<std::unique_ptr<VideoDecoder>> makeDecoder(VideoFormat format)
{
    const AVCodec *codec = avcodec_find_decoder(codecFor(format));
    CodecHandle context(codec ? avcodec_alloc_context3(codec) : nullptr);
    if (!context)
        return failure(ErrorCode::Unsupported, QStringLiteral("libav has no decoder for this video"));
    // Threads that work on several frames hold pictures back.
    context->thread_type = FF_THREAD_SLICE;
    context->thread_count = 2;
    context->flags |= AV_CODEC_FLAG_LOW_DELAY | AV_CODEC_FLAG_OUTPUT_CORRUPT;
    context->flags2 |= AV_CODEC_FLAG2_FAST;
    context->max_pixels = std::int64_t(kLargestSide) * kLargestSide / 2;
    if (const int code = avcodec_open2(context.get(), codec, nullptr); code < 0)
        return failure(ErrorCode::Unsupported, errorWords(code));
    return std::make_unique<Decoder>(std::move(context));
}

}  // namespace libav
