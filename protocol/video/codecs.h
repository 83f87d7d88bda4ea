// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/base/result.h"
#include "protocol/video/videotypes.h"

#include <QSize>

#include <optional>

/// Decodes frames one after the other. Any bytes may come.
class VideoDecoder
{
public:
    enum class Outcome : std::uint8_t { Picture, Damaged, Nothing };

    virtual ~VideoDecoder() = default;
    /// Damaged: a picture, parts of which are made up. Nothing: these bytes gave none.
    /// @param isKey decoding can begin with it
    virtual Outcome decode(Bytes frame, bool isKey) = 0;
    /// Size of the newest picture; empty before the first.
    [[nodiscard]] virtual QSize size() const = 0;
    /// The newest picture in this size; its time and damage are left as they are. False: there is none.
    virtual bool convert(VideoPicture &into, QSize size) = 0;
};

struct EncoderSettings
{
    QSize size{1280, 720};
    int frameRate = 30;
    int keyInterval = 15;  ///< frames from one that decoding can begin with to the next
    int bitRate = 4'000'000;  ///< per second
    VideoFormat format = VideoFormat::H264;
};

/// Encodes pictures at once: no frame waits for a later one.
class VideoEncoder
{
public:
    virtual ~VideoEncoder() = default;
    /// What it makes: JPEGs where no encoder for H.264 is there.
    [[nodiscard]] virtual VideoFormat format() const = 0;
    virtual Result<QByteArray> encode(const VideoPlanes &picture) = 0;
};

/// What a file of video holds.
struct VideoTrack
{
    VideoFormat format = VideoFormat::H264;
    QSize size;
    QByteArray parameterSets;  ///< with start codes; empty for JPEGs
};

/// A packet of a file.
struct VideoPacket
{
    QByteArray bytes;
    milliseconds time{0};  ///< since the beginning
    bool isKey = false;
};

/// Writes encoded frames into a Matroska file as they are. What was written stays readable, however it ends.
class VideoFileWriter
{
public:
    virtual ~VideoFileWriter() = default;
    /// Times rise. Errors: BadFile.
    virtual Result<void> write(const VideoPacket &packet) = 0;
    virtual Result<void> finish() = 0;
    [[nodiscard]] virtual qint64 bytesWritten() const = 0;
};

class VideoFileReader
{
public:
    virtual ~VideoFileReader() = default;
    [[nodiscard]] virtual VideoTrack track() const = 0;
    /// The next one, with start codes; nothing at the end, or where the file breaks off.
    virtual std::optional<VideoPacket> next() = 0;
};

/// What the module with libav offers. It is loaded when it is first used (videomodule.h).
class VideoCodecs
{
public:
    virtual ~VideoCodecs() = default;
    /// Errors: Unsupported.
    [[nodiscard]] virtual Result<std::unique_ptr<VideoDecoder>> makeDecoder(VideoFormat format) const = 0;
    /// Errors: Unsupported.
    [[nodiscard]] virtual Result<std::unique_ptr<VideoEncoder>>
    makeEncoder(const EncoderSettings &settings) const = 0;
    /// Replaces the file. Errors: BadFile, Unsupported.
    [[nodiscard]] virtual Result<std::unique_ptr<VideoFileWriter>>
    createFile(const QString &path, const VideoTrack &track) const = 0;
    /// Errors: BadFile.
    [[nodiscard]] virtual Result<std::unique_ptr<VideoFileReader>> openFile(const QString &path) const = 0;
};
