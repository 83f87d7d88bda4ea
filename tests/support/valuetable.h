// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// Parameters of a board that nobody makes: each wire type in both byte orders, gains that are floats, and a
/// text of any length.
namespace valuetable {

enum Block : std::uint8_t { Numbers, Document };

// clang-format off
inline constexpr ParameterRow kRows[] = {
    {.key = "u8", .label = "U8", .group = "Little", .help = "U8", .block = Numbers, .offset = 0, .wire = WireType::U8, .max = 255},
    {.key = "i8", .label = "I8", .group = "Little", .help = "I8", .block = Numbers, .offset = 1, .wire = WireType::I8, .min = -128, .max = 127},
    {.key = "u16", .label = "U16", .group = "Little", .help = "U16", .block = Numbers, .offset = 2, .wire = WireType::U16, .max = 65535},
    {.key = "i16", .label = "I16", .group = "Little", .help = "I16", .block = Numbers, .offset = 4, .wire = WireType::I16, .min = -32768, .max = 32767},
    {.key = "u32", .label = "U32", .group = "Little", .help = "U32", .block = Numbers, .offset = 6, .wire = WireType::U32, .max = 4294967295},
    {.key = "i32", .label = "I32", .group = "Little", .help = "I32", .block = Numbers, .offset = 10, .wire = WireType::I32, .min = -2147483648.0, .max = 2147483647},
    {.key = "f32", .label = "F32", .group = "Little", .help = "F32", .block = Numbers, .offset = 14, .wire = WireType::F32,
     .min = std::numeric_limits<float>::lowest(), .max = std::numeric_limits<float>::max(), .decimals = 3},
    {.key = "be.u16", .label = "U16", .group = "Big", .help = "U16", .block = Numbers, .offset = 18, .wire = WireType::U16, .order = ByteOrder::Big, .max = 65535},
    {.key = "be.i16", .label = "I16", .group = "Big", .help = "I16", .block = Numbers, .offset = 20, .wire = WireType::I16, .order = ByteOrder::Big, .min = -32768, .max = 32767},
    {.key = "be.u32", .label = "U32", .group = "Big", .help = "U32", .block = Numbers, .offset = 22, .wire = WireType::U32, .order = ByteOrder::Big, .max = 4294967295},
    {.key = "be.i32", .label = "I32", .group = "Big", .help = "I32", .block = Numbers, .offset = 26, .wire = WireType::I32, .order = ByteOrder::Big, .min = -2147483648.0, .max = 2147483647},
    {.key = "be.f32", .label = "F32", .group = "Big", .help = "F32", .block = Numbers, .offset = 30, .wire = WireType::F32, .order = ByteOrder::Big,
     .min = std::numeric_limits<float>::lowest(), .max = std::numeric_limits<float>::max(), .decimals = 3},
    {.key = "gain.%n", .label = "Gain %1", .group = "Gains", .help = "A gain as small as 2e-6.", .block = Numbers, .offset = 34, .wire = WireType::F32,
     .count = 5, .countStride = 4, .min = 0, .max = 0.1, .decimals = 4, .defaults = {2e-6}},
    {.key = "scaled", .label = "Scaled", .group = "Gains", .help = "Counts of 2e-6.", .block = Numbers, .offset = 54, .wire = WireType::U32, .scale = 2e-6,
     .max = 4294967295, .decimals = 2},
    {.key = "field.low", .label = "Low", .group = "Bits", .help = "Bits 0 to 4.", .block = Numbers, .offset = 58, .wire = WireType::U32, .order = ByteOrder::Big,
     .bitShift = 0, .bitCount = 5, .max = 31},
    {.key = "field.high", .label = "High", .group = "Bits", .help = "Bits 28 to 31.", .block = Numbers, .offset = 58, .wire = WireType::U32, .order = ByteOrder::Big,
     .bitShift = 28, .bitCount = 4, .max = 15},
};
inline constexpr int kNumbersSize = 62;
inline constexpr BlockSpec kBlocks[] = {
    {.id = Numbers, .name = "NUMBERS", .size = kNumbersSize},
    {.id = Document, .name = "DOCUMENT", .data = "Settings text", .maxSize = 4096, .kind = DataKind::Text, .language = "lua", .effect = WriteEffect::Restarts},
};
// clang-format on
static_assert(rangesFit(kRows));
static_assert(coversBlock<kNumbersSize>(kRows, Numbers, {}));

inline BoardIdentity identity()
{
    BoardIdentity identity;
    identity.family = QStringLiteral("valuetable");
    identity.model = QStringLiteral("Values");
    identity.serial = QStringLiteral("01");
    identity.firmwareNumber = 1;
    return identity;
}

inline std::shared_ptr<const ParameterSet> parameters()
{
    return std::make_shared<ParameterSet>(kRows, kBlocks, 1, Capabilities{});
}

/// All zero, with a text of one line.
inline Configuration configuration()
{
    Configuration configuration(identity(), parameters());
    configuration.setBlock({0, Numbers}, QByteArray(kNumbersSize, '\0'));
    configuration.setBlock({0, Document}, "a = 1\n");
    return configuration;
}

inline const ParameterSpec &spec(const Configuration &configuration, const char *key)
{
    return *configuration.parameters().find(QString::fromLatin1(key));
}

}  // namespace valuetable
