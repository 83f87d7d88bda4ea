// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/orientations.h"

#include <algorithm>

namespace storm32 {

namespace {

// clang-format off
constexpr Orientation kOrientationTable[] = {
    {"z0°", 0, {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}},
    {"z90°", 1, {{{{0, -1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}}}},
    {"z180°", 2, {{{{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}}}},
    {"z270°", 3, {{{{0, 1, 0}}, {{-1, 0, 0}}, {{0, 0, 1}}}}},
    {"x0°", 4, {{{{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}}}},
    {"x90°", 5, {{{{0, 0, -1}}, {{0, 1, 0}}, {{1, 0, 0}}}}},
    {"x180°", 6, {{{{0, -1, 0}}, {{0, 0, -1}}, {{1, 0, 0}}}}},
    {"x270°", 7, {{{{0, 0, 1}}, {{0, -1, 0}}, {{1, 0, 0}}}}},
    {"y0°", 8, {{{{0, 0, 1}}, {{1, 0, 0}}, {{0, 1, 0}}}}},
    {"y90°", 9, {{{{-1, 0, 0}}, {{0, 0, 1}}, {{0, 1, 0}}}}},
    {"y180°", 10, {{{{0, 0, -1}}, {{-1, 0, 0}}, {{0, 1, 0}}}}},
    {"y270°", 11, {{{{1, 0, 0}}, {{0, 0, -1}}, {{0, 1, 0}}}}},
    {"-z0°", 16, {{{{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, -1}}}}},
    {"-z90°", 17, {{{{-1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -1}}}}},
    {"-z180°", 18, {{{{0, -1, 0}}, {{-1, 0, 0}}, {{0, 0, -1}}}}},
    {"-z270°", 19, {{{{1, 0, 0}}, {{0, -1, 0}}, {{0, 0, -1}}}}},
    {"-x0°", 20, {{{{0, 0, 1}}, {{0, 1, 0}}, {{-1, 0, 0}}}}},
    {"-x90°", 21, {{{{0, -1, 0}}, {{0, 0, 1}}, {{-1, 0, 0}}}}},
    {"-x180°", 22, {{{{0, 0, -1}}, {{0, -1, 0}}, {{-1, 0, 0}}}}},
    {"-x270°", 23, {{{{0, 1, 0}}, {{0, 0, -1}}, {{-1, 0, 0}}}}},
    {"-y0°", 24, {{{{1, 0, 0}}, {{0, 0, 1}}, {{0, -1, 0}}}}},
    {"-y90°", 25, {{{{0, 0, -1}}, {{1, 0, 0}}, {{0, -1, 0}}}}},
    {"-y180°", 26, {{{{-1, 0, 0}}, {{0, 0, -1}}, {{0, -1, 0}}}}},
    {"-y270°", 27, {{{{0, 0, 1}}, {{-1, 0, 0}}, {{0, -1, 0}}}}},
};
// clang-format on

}  // namespace

std::span<const Orientation> orientations()
{
    return kOrientationTable;
}

int findOrientation(const std::array<int, 3> &up, const std::array<int, 3> &forward)
{
    const auto it = std::find_if(
        std::begin(kOrientationTable), std::end(kOrientationTable),
        [&](const Orientation &each) { return each.axes[2] == up && each.axes[0] == forward; });
    return it == std::end(kOrientationTable) ? -1 : int(it - std::begin(kOrientationTable));
}

}  // namespace storm32
