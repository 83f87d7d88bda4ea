// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"

/// Sum of all bytes modulo 256 (SimpleBGC frame version 1; document "Message format").
[[nodiscard]] std::uint8_t sum8(Bytes bytes);

/// CRC-16/ARC (polynomial 0x8005 reflected, initial value 0). Pass the previous value to continue over
/// several spans.
[[nodiscard]] std::uint16_t crc16Arc(Bytes bytes, std::uint16_t crc = 0);

/// The CRC of SimpleBGC frame version 2: CRC-16/ARC with its 16 bits reversed (errata 1.2).
/// "123456789" gives 0xBCDD.
[[nodiscard]] std::uint16_t crc16ArcReversed(Bytes bytes);

/// CRC-16/MCRF4XX (polynomial 0x1021 reflected, initial value 0xFFFF, no final XOR), which MAVLink calls X.25
/// and STorM32 uses everywhere (STorM32 errata 2). "123456789" gives 0x6F91; over data followed by its own
/// CRC, low byte first, it gives 0.
[[nodiscard]] std::uint16_t crc16Mcrf4xx(Bytes bytes, std::uint16_t crc = 0xFFFF);

/// CRC-32C (Castagnoli; reflected polynomial 0x82F63B78, initial value and final XOR 0xFFFFFFFF), of
/// BCFlight's texts and uploads (BCFlight errata 2.3). "123456789" gives 0xE3069283. Pass the previous result
/// to continue over several spans.
[[nodiscard]] std::uint32_t crc32c(Bytes bytes, std::uint32_t crc = 0);
