// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// A black box as if it came over a link, line by line: "name,value". Asked for its names, it answers in one
// line.
#pragma once

#include "protocol/telemetry/blackbox.h"

#include <optional>

namespace blackboxwire {

inline constexpr const char *kFamily = "blackbox";
inline constexpr const char *kQuestion = "?names\n";

/// A name and how many numbers its values have at most; 0: texts.
struct Name
{
    QByteArray name;
    int elements = 0;

    friend bool operator==(const Name &, const Name &) = default;
};

/// "#name\t3\tname\t1\n".
[[nodiscard]] QByteArray namesLine(const BlackBox &box);
/// Empty: it is no such line.
[[nodiscard]] std::optional<std::vector<Name>> readNames(QByteArrayView line);

}  // namespace blackboxwire
