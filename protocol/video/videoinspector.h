// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"
#include "protocol/video/videotypes.h"

#include <QList>
#include <QSize>

#include <optional>

/// A unit of an H.264 stream with start codes.
struct NalUnit
{
    enum Type { Slice = 1, KeySlice = 5, Sei = 6, Sps = 7, Pps = 8, Delimiter = 9 };

    std::size_t start = 0;  ///< where its start code begins
    Bytes bytes;  ///< without it; never empty

    [[nodiscard]] int type() const { return std::to_integer<int>(bytes[0]) & 0x1F; }
    /// Later pictures refer to it.
    [[nodiscard]] bool isReference() const { return (std::to_integer<int>(bytes[0]) & 0x60) != 0; }
};

/// The units in these bytes. @param most stops after so many
[[nodiscard]] QList<NalUnit> nalUnits(Bytes bytes, qsizetype most = 1024);

/// They begin like a JPEG.
[[nodiscard]] bool isJpeg(Bytes bytes);

/// What is known of one encoded frame.
struct FrameFacts
{
    VideoFormat format = VideoFormat::Unknown;
    bool isKey = false;  ///< decoding can begin with it
    int lost = 0;  ///< frames that are missing before it, by its number
};

/// Reads what frames say of themselves, in the order in which they come. H.264 numbers the frames that others
/// refer to (ITU-T H.264, 7.4.3), so losses can be counted up to half of the numbers' range; a key frame
/// begins anew, and JPEGs have no numbers. Any bytes may come.
class VideoInspector
{
public:
    FrameFacts inspect(Bytes frame);

    [[nodiscard]] VideoFormat format() const { return m_format; }
    /// Of the pictures; empty while unknown.
    [[nodiscard]] QSize size() const { return m_size; }
    /// The parameter sets that came last, with start codes; empty for JPEGs.
    [[nodiscard]] QByteArray parameterSets() const;

private:
    FrameFacts inspectH264(const QList<NalUnit> &units);
    void takeSps(Bytes unit);
    [[nodiscard]] int lostBefore(const NalUnit &slice);

    VideoFormat m_format = VideoFormat::Unknown;
    QSize m_size;
    QByteArray m_sps;
    QByteArray m_pps;
    int m_numberBits = 0;  // of a frame's number; 0: unknown
    bool m_hasPlanes = false;
    std::optional<unsigned> m_lastNumber;  // of the last reference
};
