// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QByteArray>

#include <cstdint>
#include <vector>

/// How the pictures are encoded.
enum class VideoFormat : std::uint8_t { Unknown, H264, Mjpeg };

/// One encoded picture as it came: H.264 with start codes (Annex B), or a JPEG.
struct EncodedFrame
{
    QByteArray bytes;
    TimePoint at{};  ///< when its first datagram came
    Duration waited{};  ///< so long that lay in the kernel until it was read
};

/// One decoded picture: 4 bytes for each pixel (blue, green, red, 255), rows from the top.
struct VideoPicture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
    TimePoint at{};  ///< when its first datagram came
    Duration waited{};  ///< so long that lay in the kernel until it was read
    bool isDamaged = false;  ///< parts of it were lost and are made up

    [[nodiscard]] qsizetype stride() const { return qsizetype(width) * 4; }
};

/// A picture before it is encoded: brightness for each pixel, the two colour differences for each square of
/// four (I420). Width and height are even.
struct VideoPlanes
{
    VideoPlanes(int pictureWidth, int pictureHeight)
        : width(pictureWidth)
        , height(pictureHeight)
        , y(std::size_t(width) * std::size_t(height), 16)
        , u(y.size() / 4, 128)
        , v(y.size() / 4, 128)
    {
    }

    int width;
    int height;
    std::vector<std::uint8_t> y;
    std::vector<std::uint8_t> u;
    std::vector<std::uint8_t> v;
};
