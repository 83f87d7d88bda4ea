// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"

#include <array>

namespace {

constexpr std::uint16_t kArc = 0xA001;  // 0x8005 reflected
constexpr std::uint16_t kCcitt = 0x8408;  // 0x1021 reflected
constexpr std::uint32_t kCastagnoli = 0x82F63B78;
constexpr int kSlices = 8;

using SliceTables = std::array<std::array<std::uint16_t, 256>, kSlices>;

// Slice-by-8: table[k][b] is the effect of byte b followed by k zero bytes.
constexpr SliceTables makeTables(std::uint16_t polynomial)
{
    SliceTables tables{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        auto crc = static_cast<std::uint16_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1) ? (crc >> 1) ^ polynomial : crc >> 1);
        tables[0][byte] = crc;
    }
    for (unsigned byte = 0; byte < 256; ++byte) {
        for (int slice = 1; slice < kSlices; ++slice) {
            const std::uint16_t previous = tables[slice - 1][byte];
            tables[slice][byte] = static_cast<std::uint16_t>((previous >> 8) ^ tables[0][previous & 0xFF]);
        }
    }
    return tables;
}

constexpr SliceTables kArcTables = makeTables(kArc);
constexpr SliceTables kCcittTables = makeTables(kCcitt);

std::uint16_t reflectedCrc(const SliceTables &tables, Bytes bytes, std::uint16_t crc)
{
    const auto at = [&](std::size_t i) { return std::to_integer<unsigned>(bytes[i]); };
    std::size_t i = 0;
    for (; i + kSlices <= bytes.size(); i += kSlices) {
        crc = static_cast<std::uint16_t>(tables[7][at(i) ^ (crc & 0xFF)] ^ tables[6][at(i + 1) ^ (crc >> 8)]
                                         ^ tables[5][at(i + 2)] ^ tables[4][at(i + 3)] ^ tables[3][at(i + 4)]
                                         ^ tables[2][at(i + 5)] ^ tables[1][at(i + 6)]
                                         ^ tables[0][at(i + 7)]);
    }
    for (; i < bytes.size(); ++i)
        crc = static_cast<std::uint16_t>((crc >> 8) ^ tables[0][(crc ^ at(i)) & 0xFF]);
    return crc;
}

}  // namespace

std::uint8_t sum8(Bytes bytes)
{
    unsigned sum = 0;
    for (const std::byte byte : bytes)
        sum += std::to_integer<unsigned>(byte);
    return static_cast<std::uint8_t>(sum);
}

std::uint16_t crc16Arc(Bytes bytes, std::uint16_t crc)
{
    return reflectedCrc(kArcTables, bytes, crc);
}

std::uint16_t crc16Mcrf4xx(Bytes bytes, std::uint16_t crc)
{
    return reflectedCrc(kCcittTables, bytes, crc);
}

std::uint16_t crc16ArcReversed(Bytes bytes)
{
    unsigned crc = crc16Arc(bytes);
    crc = ((crc & 0x5555) << 1) | ((crc >> 1) & 0x5555);
    crc = ((crc & 0x3333) << 2) | ((crc >> 2) & 0x3333);
    crc = ((crc & 0x0F0F) << 4) | ((crc >> 4) & 0x0F0F);
    return static_cast<std::uint16_t>((crc << 8) | (crc >> 8));
}

std::uint32_t crc32c(Bytes bytes, std::uint32_t crc)
{
    static constexpr auto kTable = [] {
        std::array<std::uint32_t, 256> table{};
        for (std::uint32_t byte = 0; byte < 256; ++byte) {
            std::uint32_t value = byte;
            for (int bit = 0; bit < 8; ++bit)
                value = (value & 1) ? (value >> 1) ^ kCastagnoli : value >> 1;
            table[byte] = value;
        }
        return table;
    }();
    crc = ~crc;
    for (const std::byte byte : bytes)
        crc = (crc >> 8) ^ kTable[(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xFF];
    return ~crc;
}
