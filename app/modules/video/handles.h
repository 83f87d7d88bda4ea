// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// libav's headers are in C.
extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include "protocol/base/filefault.h"
#include "protocol/video/codecs.h"

#include <QString>

#include <memory>

namespace libav {

struct Free
{
    void operator()(AVCodecContext *context) const { avcodec_free_context(&context); }
    void operator()(AVFrame *frame) const { av_frame_free(&frame); }
    void operator()(AVPacket *packet) const { av_packet_free(&packet); }
    void operator()(SwsContext *scaler) const { sws_freeContext(scaler); }
};
using CodecHandle = std::unique_ptr<AVCodecContext, Free>;
using FrameHandle = std::unique_ptr<AVFrame, Free>;
using PacketHandle = std::unique_ptr<AVPacket, Free>;
using ScalerHandle = std::unique_ptr<SwsContext, Free>;

/// What libav says of one of its error numbers.
[[nodiscard]] QString errorWords(int code);
[[nodiscard]] AVCodecID codecFor(VideoFormat format);

[[nodiscard]] Result<std::unique_ptr<VideoDecoder>> makeDecoder(VideoFormat format);
[[nodiscard]] Result<std::unique_ptr<VideoEncoder>> makeEncoder(const EncoderSettings &settings);
[[nodiscard]] Result<std::unique_ptr<VideoFileWriter>> createFile(const QString &path,
                                                                  const VideoTrack &track);
[[nodiscard]] Result<std::unique_ptr<VideoFileReader>> openFile(const QString &path);

}  // namespace libav
