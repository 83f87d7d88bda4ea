// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videoinspector.h"

#include <algorithm>

namespace {

constexpr int kLongestHeader = 512;  // bytes of a unit that are looked at
const QByteArray kStartCode("\0\0\0\1", 4);

/// Bits of a unit, most significant first, without the bytes that only keep start codes out of it (H.264,
/// 7.4.1). Past the end all are 0 and isOk() is false.
class BitReader
{
public:
    explicit BitReader(Bytes unit)
    {
        int zeros = 0;
        for (const std::byte byte : unit.first(std::min<std::size_t>(unit.size(), kLongestHeader))) {
            const int value = std::to_integer<int>(byte);
            if (zeros >= 2 && value == 3) {
                zeros = 0;
                continue;
            }
            zeros = value == 0 ? zeros + 1 : 0;
            m_bytes.append(char(value));
        }
    }

    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i)
            value = value << 1 | bit();
        return value;
    }
    /// An exponential Golomb code (H.264, 9.1).
    unsigned ue()
    {
        int zeros = 0;
        while (isOk() && bit() == 0) {
            if (++zeros > 31)
                m_isOk = false;
        }
        return isOk() ? (1U << zeros) - 1 + bits(zeros) : 0;
    }
    int se()
    {
        const unsigned code = ue();
        return code % 2 ? int(code / 2 + 1) : -int(code / 2);
    }
    [[nodiscard]] bool isOk() const { return m_isOk; }

private:
    unsigned bit()
    {
        const qsizetype at = m_position / 8;
        if (at >= m_bytes.size()) {
            m_isOk = false;
            return 0;
        }
        return unsigned(quint8(m_bytes[at])) >> (7 - m_position++ % 8) & 1;
    }

    QByteArray m_bytes;
    qsizetype m_position = 0;
    bool m_isOk = true;
};

void skipScalingList(BitReader &reader, int size)
{
    int last = 8;
    int next = 8;
    for (int i = 0; i < size && reader.isOk(); ++i) {
        if (next != 0)
            next = (last + reader.se() + 256) % 256;
        last = next == 0 ? last : next;
    }
}

/// What a sequence parameter set says (H.264, 7.3.2.1.1).
struct Sequence
{
    bool hasPlanes = false;
    int numberBits = 0;
    QSize size;
};

std::optional<Sequence> readSequence(Bytes unit)
{
    BitReader reader(unit.subspan(1));
    const unsigned profile = reader.bits(8);
    reader.bits(16);
    reader.ue();
    Sequence sequence;
    unsigned chroma = 1;
    static constexpr unsigned kHigh[] = {100, 110, 122, 244, 44, 83, 86, 118, 128, 138, 139, 134, 135};
    if (std::find(std::begin(kHigh), std::end(kHigh), profile) != std::end(kHigh)) {
        chroma = reader.ue();
        sequence.hasPlanes = chroma == 3 && reader.bits(1);
        reader.ue();
        reader.ue();
        reader.bits(1);
        if (reader.bits(1)) {
            for (int list = 0; list < (chroma == 3 ? 12 : 8); ++list) {
                if (reader.bits(1))
                    skipScalingList(reader, list < 6 ? 16 : 64);
            }
        }
    }
    sequence.numberBits = int(reader.ue()) + 4;
    const unsigned order = reader.ue();
    if (order == 0) {
        reader.ue();
    } else if (order == 1) {
        reader.bits(1);
        reader.se();
        reader.se();
        for (unsigned left = reader.ue(); left > 0 && reader.isOk(); --left)
            reader.se();
    }
    reader.ue();
    reader.bits(1);
    const unsigned columns = reader.ue() + 1;
    const unsigned rows = reader.ue() + 1;
    const bool hasFrames = reader.bits(1);
    if (!hasFrames)
        reader.bits(1);
    reader.bits(1);
    unsigned across = 0;
    unsigned down = 0;
    if (reader.bits(1)) {
        const unsigned left = reader.ue();
        across = (left + reader.ue()) * (chroma == 1 || chroma == 2 ? 2 : 1);
        const unsigned top = reader.ue();
        down = (top + reader.ue()) * (chroma == 1 ? 2 : 1) * (hasFrames ? 1 : 2);
    }
    constexpr unsigned kMost = 1024;  // macro blocks
    if (!reader.isOk() || sequence.numberBits > 16 || columns > kMost || rows > kMost)
        return {};
    const qint64 width = qint64(columns) * 16 - across;
    const qint64 height = qint64(rows) * 16 * (hasFrames ? 1 : 2) - down;
    if (width <= 0 || height <= 0)
        return {};
    sequence.size = QSize(int(width), int(height));
    return sequence;
}

// The first frame header says how large it is (ITU-T T.81, B.2.2).
QSize jpegSize(Bytes bytes)
{
    const auto byteAt = [&bytes](std::size_t at) { return std::to_integer<int>(bytes[at]); };
    for (std::size_t at = 2; at + 9 < bytes.size() && byteAt(at) == 0xFF;) {
        const int marker = byteAt(at + 1);
        const bool isFrame
            = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (isFrame)
            return {byteAt(at + 7) << 8 | byteAt(at + 8), byteAt(at + 5) << 8 | byteAt(at + 6)};
        at += 2 + std::size_t(byteAt(at + 2) << 8 | byteAt(at + 3));
    }
    return {};
}

}  // namespace

QList<NalUnit> nalUnits(Bytes bytes, qsizetype most)
{
    QList<NalUnit> units;
    const auto *data = reinterpret_cast<const char *>(bytes.data());
    const QByteArrayView view(data, qsizetype(bytes.size()));
    constexpr QByteArrayView kShort("\0\0\1", 3);
    qsizetype code = view.indexOf(kShort);
    while (code >= 0 && units.size() < most) {
        const qsizetype begin = code + kShort.size();
        const qsizetype next = units.size() + 1 < most ? view.indexOf(kShort, begin) : -1;
        qsizetype end = next < 0 ? view.size() : next;
        while (next >= 0 && end > begin && view[end - 1] == '\0')
            --end;
        const bool isLong = code > 0 && view[code - 1] == '\0';
        if (end > begin)
            units.append({std::size_t(isLong ? code - 1 : code),
                          bytes.subspan(std::size_t(begin), std::size_t(end - begin))});
        code = next;
    }
    return units;
}

bool isJpeg(Bytes bytes)
{
    return bytes.size() > 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8}
    && bytes[2] == std::byte{0xFF};
}

FrameFacts VideoInspector::inspect(Bytes frame)
{
    if (isJpeg(frame)) {
        m_format = VideoFormat::Mjpeg;
        m_size = jpegSize(frame);
        return {m_format, true, 0};
    }
    const QList<NalUnit> units = nalUnits(frame);
    const bool isH264 = std::any_of(units.begin(), units.end(), [](const NalUnit &unit) {
        return unit.type() >= NalUnit::Slice && unit.type() <= NalUnit::Delimiter;
    });
    if (!isH264)
        return {};
    m_format = VideoFormat::H264;
    return inspectH264(units);
}

FrameFacts VideoInspector::inspectH264(const QList<NalUnit> &units)
{
    FrameFacts facts{m_format, false, 0};
    for (const NalUnit &unit : units) {
        switch (unit.type()) {
        case NalUnit::Sps: takeSps(unit.bytes); break;
        case NalUnit::Pps: m_pps = toByteArray(unit.bytes); break;
        case NalUnit::KeySlice: facts.isKey = true; [[fallthrough]];
        case NalUnit::Slice: facts.lost += lostBefore(unit); break;
        default: break;
        }
    }
    facts.isKey = facts.isKey && !m_sps.isEmpty() && !m_pps.isEmpty();
    return facts;
}

void VideoInspector::takeSps(Bytes unit)
{
    const auto sequence = readSequence(unit);
    if (!sequence)
        return;
    m_sps = toByteArray(unit);
    m_size = sequence->size;
    m_numberBits = sequence->numberBits;
    m_hasPlanes = sequence->hasPlanes;
}

int VideoInspector::lostBefore(const NalUnit &slice)
{
    if (m_numberBits == 0)
        return 0;
    BitReader reader(slice.bytes.subspan(1));
    const bool isFirst = reader.ue() == 0;
    reader.ue();
    reader.ue();
    if (m_hasPlanes)
        reader.bits(2);
    const unsigned number = reader.bits(m_numberBits);
    if (!reader.isOk() || !isFirst)
        return 0;
    if (slice.type() == NalUnit::KeySlice) {
        m_lastNumber = number;
        return 0;
    }
    const unsigned range = 1U << m_numberBits;
    const auto before = m_lastNumber;
    if (slice.isReference() || !before)
        m_lastNumber = number;
    const unsigned steps = before ? (number - *before) % range : 1;
    // Backwards: it was overtaken, or the numbers began anew.
    return steps > 1 && steps < range / 2 ? int(steps - 1) : 0;
}

QByteArray VideoInspector::parameterSets() const
{
    if (m_format != VideoFormat::H264 || m_sps.isEmpty() || m_pps.isEmpty())
        return {};
    return kStartCode + m_sps + kStartCode + m_pps;
}
