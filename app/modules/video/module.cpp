// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/modules/video/handles.h"

#include <QtGlobal>

namespace libav {

QString errorWords(int code)
{
    char words[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(code, words, sizeof(words));
    return QString::fromUtf8(words);
}

AVCodecID codecFor(VideoFormat format)
{
    switch (format) {
    case VideoFormat::H264: return AV_CODEC_ID_H264;
    case VideoFormat::Mjpeg: return AV_CODEC_ID_MJPEG;
    case VideoFormat::Unknown: break;
    }
    return AV_CODEC_ID_NONE;
}

namespace {

class Codecs final : public VideoCodecs
{
public:
    Codecs()
    {
        // What it would print is counted and told by its caller.
        av_log_set_level(AV_LOG_QUIET);
    }

    [[nodiscard]] Result<std::unique_ptr<VideoDecoder>> makeDecoder(VideoFormat format) const override
    {
        return libav::makeDecoder(format);
    }
    [[nodiscard]] Result<std::unique_ptr<VideoEncoder>>
    makeEncoder(const EncoderSettings &settings) const override
    {
        return libav::makeEncoder(settings);
    }
    [[nodiscard]] Result<std::unique_ptr<VideoFileWriter>> createFile(const QString &path,
                                                                      const VideoTrack &track) const override
    {
        return libav::createFile(path, track);
    }
    [[nodiscard]] Result<std::unique_ptr<VideoFileReader>> openFile(const QString &path) const override
    {
        return libav::openFile(path);
    }
};

}  // namespace

}  // namespace libav

extern "C" Q_DECL_EXPORT const VideoCodecs *gimbalVideoCodecs1()
{
    static const libav::Codecs codecs;
    return &codecs;
}
