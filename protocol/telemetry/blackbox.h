// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>
#include <QList>

#include <vector>

/// What the black box of a drone holds (errata 10): lines "time_µs,name,value"; a value may be a list in
/// quotes. Numbers become samples; other values are texts.
class BlackBox
{
public:
    struct Line
    {
        qint64 at = 0;  ///< microseconds since the drone's start
        int name = 0;  ///< position in names()
        qsizetype from = 0;  ///< of the value in the file, without quotes
        int size = 0;
    };
    /// Lines that follow each other and are no such lines.
    struct Damage
    {
        qint64 offset = 0;
        qint64 bytes = 0;
        std::size_t line = 0;  ///< how many lines come before it
        bool isEnd = false;  ///< the file ends in the middle of a line
    };

    static constexpr int kMostNames = 500;
    static constexpr int kMostNumbers = 32;  ///< of one value
    static constexpr qsizetype kLongestName = 64;  ///< bytes

    /// Whether it begins like one, after what may be damage: the first lines decide.
    [[nodiscard]] static bool isBegunBy(QByteArrayView bytes);
    /// Lines that cannot be read are left out. Errors: BadFile if none can be read.
    static Result<BlackBox> read(const QByteArray &bytes);
    /// The numbers of a value, as it stands in the file; true and false are 1 and 0. Empty: it is a text.
    [[nodiscard]] static std::vector<float> numbers(QByteArrayView value);

    /// In the order in which they first occur.
    [[nodiscard]] const QList<QByteArray> &names() const { return m_names; }
    /// In order of time.
    [[nodiscard]] const std::vector<Line> &lines() const { return m_lines; }
    [[nodiscard]] const std::vector<Damage> &damage() const { return m_damage; }
    [[nodiscard]] QByteArrayView value(const Line &line) const
    {
        return QByteArrayView(m_bytes).sliced(line.from, line.size);
    }
    /// How many numbers a name has at most; 0: it only has texts.
    [[nodiscard]] int elements(int name) const { return m_elements[std::size_t(name)]; }

private:
    class Reader;

    QByteArray m_bytes;
    QList<QByteArray> m_names;
    std::vector<int> m_elements;
    std::vector<Line> m_lines;
    std::vector<Damage> m_damage;
};
