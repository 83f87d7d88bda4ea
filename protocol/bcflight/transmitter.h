// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace bcflight {

/// A band of analog video transmitters, with the frequencies of its channels.
struct TransmitterBand
{
    const char *name;
    std::array<int, 8> mhz;
};

// clang-format off
/// In the order in which the channels are counted, from 1 through all bands (errata 6.6).
inline constexpr std::array<TransmitterBand, 5> kTransmitterBands{{
    {"Boscam A", {5865, 5845, 5825, 5805, 5785, 5765, 5745, 5725}},
    {"Boscam B", {5733, 5752, 5771, 5790, 5809, 5828, 5847, 5866}},
    {"Boscam E", {5705, 5685, 5665, 5645, 5885, 5905, 5925, 5945}},
    {"FatShark", {5740, 5760, 5780, 5800, 5820, 5840, 5860, 5880}},
    {"RaceBand", {5658, 5695, 5732, 5769, 5806, 5843, 5880, 5917}},
}};
// clang-format on
inline constexpr int kBandChannels = int(std::tuple_size_v<decltype(TransmitterBand::mhz)>);

}  // namespace bcflight
