// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <vector>

/// A line of the comparison of two texts.
struct DiffLine
{
    enum class Kind : std::uint8_t { Same, Removed, Added, Gap };

    Kind kind = Kind::Same;
    int before = 0;  ///< its number in the first text, from 1; 0: it is not there
    int after = 0;  ///< the same in the second one
    QString text = {};  ///< without its end; a changed line tells of its end what is unusual
    int left = 0;  ///< of a gap: how many lines that are the same were left out

    friend bool operator==(const DiffLine &, const DiffLine &) = default;
};

/// Two texts line by line: as few changed lines as possible, but for texts that have hardly anything in
/// common. Lines that differ in nothing but their end differ.
[[nodiscard]] std::vector<DiffLine> lineDiff(const QByteArray &before, const QByteArray &after);

/// The same with only so many lines around each change; a gap stands for the others. Empty: no difference.
[[nodiscard]] std::vector<DiffLine> aroundChanges(const std::vector<DiffLine> &lines, int context);

/// How many lines were added, and how many removed.
[[nodiscard]] std::pair<int, int> countChanges(const std::vector<DiffLine> &lines);
